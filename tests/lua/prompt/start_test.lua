-- How long the program takes to start: printed, not judged beyond what any machine keeps, for others may use it as
-- well.

require "check"

local function median_of_20(command)
  local times = {}
  for i = 1, 20 do
    local output, status = check.shell(("bash -c 'TIMEFORMAT=%%R; time %s'"):format(command))
    check.equal(status, 0)
    times[i] = tonumber(output:match "([%d.]+)%s*$")
  end
  return sg.median(times)
end

check.case("start-up", function()
  for name, arguments in pairs { ["-e 'return 1'"] = "-e \"return 1\"", ["to the prompt"] = "</dev/null" } do
    local time = median_of_20(arg[-1] .. " " .. arguments)
    print(("start-up, %s: %.3f s (median of 20; asked for: below 0.1 s)"):format(name, time))
    check.equal(time < 5, true)
  end
end)

check.case("a run loads what it needs: neither studies nor pages of other functions", function()
  local output, status = check.program{ "-q", "-e", [[
local model, stages = sg.scenes.block{}
model:run(stages, sg.plain{})
for _, name in ipairs{ "study", "recommend", "convergence_map", "pages.studies", "pages.pictures", "help" } do
  if package.loaded["signorini." .. name] then print(name) end
end
for _, name in ipairs{ "study", "comparison", "map", "series" } do -- types are there when asked for
  if not require("signorini.core").types[name] then print("no type " .. name) end
end
print "end"]] }
  check.equal({ output, status }, { "end\n", 0 })
end)
