-- The supplied scripts with their headers, for help.

local core = require "signorini.core"

local filter = require("signorini.call.lists").filter

local scripts = {}

local function header(text)
  local lines = {}
  for line in text:gmatch "([^\n]*)\n" do
    if not line:find "^%-%-" then break end
    lines[#lines + 1] = line:gsub("^%-%- ?", "", 1)
  end
  return table.concat(lines, "\n")
end

--- All scripts, in order: { name, path, header, title }; signorini <name> runs one (core.find_script).
function scripts.all()
  local list = {}
  if not core.exists(core.home .. "/scripts") then return list end
  for _, folder in ipairs { "problems/", "studies/", "stability/", "formulations/", "objects/" } do
    for _, file in ipairs(core.list_folder(core.home .. "/scripts/" .. folder)) do
      local path = ("%s/scripts/%s%s"):format(core.home, folder, file)
      local page = file:find "%.lua$" and header(core.read_file(path)) or ""
      if page:find "\nRun: " then
        local short = folder == "problems/" or folder == "studies/"
        local name = short and file or folder .. file
        list[#list + 1] = { name = name, path = path, header = page, title = page:match "^[^\n]*" }
      end
    end
  end
  return list
end

--- The script with a name, with or without folder and ending, or nil.
function scripts.of(name)
  local file = "/" .. name:gsub("%.lua$", "") .. ".lua"
  return filter(scripts.all(), function(script) return script.path:sub(-#file) == file end)[1]
end

--- The scripts whose headers contain a word.
function scripts.with(word)
  return filter(scripts.all(), function(script)
    return (script.name .. "\n" .. script.header):lower():find(word:lower(), 1, true)
  end)
end

return scripts
