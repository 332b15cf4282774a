-- The gallery names every script; its pictures are there, small, and drawn as scripts/coarse.txt says.

require "check"

local function lines(command)
  local list = {}
  for line in check.shell(("cd '%s' && %s"):format(core.home, command)):gmatch "[^\n]+" do list[#list + 1] = line end
  return list
end

local page = core.read_file(core.home .. "/share/doc/examples/gallery.md")
local coarse = core.read_file(core.home .. "/scripts/coarse.txt")

check.case("every script", function()
  local scripts = lines "cd scripts && grep -l '^-- Run: ' */*.lua"
  check.equal(#scripts > 20, true)
  for _, script in ipairs(scripts) do
    check.holds(page, "\n| `" .. script .. "` | ")
    check.holds(coarse, "\n" .. script:gsub("%.lua$", "") .. " ")
  end
end)

check.case("every picture", function()
  local total, shown = 0, 0
  for name in page:gmatch "%(gallery/([%w_/]+)%.png%)" do
    local size = #core.read_file(("%s/share/doc/examples/gallery/%s.png"):format(core.home, name))
    check.equal(size <= 150000 or name .. " is too large", true)
    total, shown = total + size, shown + 1
    check.equal(coarse:find("\n" .. name .. " +| [%w_]") ~= nil, true)
  end
  check.equal(total <= 3000000, true)
  check.equal(#lines "ls share/doc/examples/gallery/*/*", shown)
end)
