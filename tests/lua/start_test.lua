-- How long the program takes to start: printed, not judged beyond what any machine keeps, for others may use it as
-- well.

local check = require "check"
local sg = require "signorini"

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

check.done()
