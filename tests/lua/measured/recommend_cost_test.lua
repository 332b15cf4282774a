-- tests/measure/recommend_cost.lua, coarse: its rows and its table. Its results depend on the machine.

local core = require "signorini.core"
local check = require "check"

core.quiet = true
local folder = check.folder()

check.case("one tolerance", function()
  local print_to_terminal = print
  print = function() end
  local ok, costs = pcall(assert(loadfile(core.home .. "/tests/measure/recommend_cost.lua")), "at_most=0.05",
    "repeats=1", "out=" .. folder)
  print = print_to_terminal
  if not ok then error(costs, 0) end
  check.equal({ #costs, costs[1].at_most, costs[1].tries >= 3 }, { 1, 0.05, true })
  check.equal({ costs[1].search > 0, costs[1].uniform > 0 }, { true, true })
  check.holds(core.read_file(folder .. "/recommend_cost.csv"), "at_most,search,uniform,ratio\n0.05,")
end)

check.done()
