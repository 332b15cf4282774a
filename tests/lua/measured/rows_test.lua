-- Scripts without a test of their own, or with rows that do more, with the words of their rows in coarse.txt; and the
-- words of all rows.

require "check"

local lists = require "signorini.call.lists"

local tests = {}
for _, folder in ipairs { "problem", "measured" } do
  local place = ("%s/tests/lua/%s/"):format(core.home, folder)
  for _, file in ipairs(core.list_folder(place)) do tests[#tests + 1] = core.read_file(place .. file) end
end
tests = table.concat(tests)

--- True if a test runs the script.
local function is_tested(script)
  local folder, name = script:match "^(.*)/([^/]*)$"
  return tests:find(('check%%.study[( ]*"%s"'):format(script))
    or folder == "stability" and tests:find(('study%%("%s"'):format(name))
    or folder == "objects" and tests:find(('results[( ]*"%s"'):format(name))
end

local scripts = lists.sorted_names(check.rows)
check.case("there are rows", function() check.equal(#scripts > 60, true) end)

check.case("every measurement has a row", function()
  for _, file in ipairs(core.list_folder(core.home .. "/tests/measure")) do
    local name = file:match "^(.*)%.lua$"
    if name and name ~= "slurm_overhead" then -- which needs a cluster
      check.equal({ name, check.rows["tests/measure/" .. name] ~= nil }, { name, true })
    end
  end
end)

--- Scripts whose rows do what their tests leave out: growth in 3D, all maps, half passes, charts over several meshes.
local further = { ["tests/measure/benchmark"] = true, ["formulations/recovered_cells"] = true,
                  ["formulations/load_and_hold"] = true, ["problems/cook"] = true }

for _, script in ipairs(scripts) do
  if further[script] or not is_tested(script) then check.case(script, function() check.study(script) end) end
end

--- Ends the script that calls sg.arguments once its words have been read.
local read, arguments = {}, sg.arguments
check.case("scripts accept the words of their rows", function()
  rawset(sg, "arguments", function(...)
    arguments(...)
    error(read, 0)
  end)
  for _, script in ipairs(scripts) do
    local ok, message = pcall(check.load(script), table.unpack(check.rows[script]))
    if ok or message ~= read then error(("%s: %s"):format(script, message), 0) end
  end
  rawset(sg, "arguments", arguments)
end)
