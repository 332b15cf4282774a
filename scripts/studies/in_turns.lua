-- Times of runs for comparison.

local sg = require "signorini"

--- Solves every entry of a list several times: solve(entry, number) returns a case with its run. The runs alternate,
--- so that disturbances affect all of them. Returns the cases of the last round; case.times contains the medians of
--- run.timings, of wall, which is that of the case if it has one, and of processor, the time of all threads in solve.
return function(list, rounds, solve)
  local cases, seconds = {}, {}
  for round = 1, rounds do
    for k, entry in ipairs(list) do
      local began = os.clock()
      local case = solve(entry, k)
      cases[k], seconds[k] = case, seconds[k] or { wall = {}, processor = {} }
      seconds[k].processor[round] = os.clock() - began
      seconds[k].wall[round] = case.wall or case.run.wall
      for account, value in pairs(case.run.timings) do
        seconds[k][account] = seconds[k][account] or {}
        seconds[k][account][round] = value
      end
    end
  end
  for k, case in ipairs(cases) do
    case.times = {}
    for account, values in pairs(seconds[k]) do case.times[account] = sg.median(values) end
  end
  return cases
end
