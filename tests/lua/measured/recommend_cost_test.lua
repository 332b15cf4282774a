-- tests/measure/recommend_cost.lua, coarse: its rows and its table. Its results depend on the machine.

require "check"

check.case("one tolerance", function()
  local costs, folder = check.study "tests/measure/recommend_cost"
  check.equal({ #costs, costs[1].at_most, costs[1].tries >= 3 }, { 1, 0.05, true })
  check.equal({ costs[1].search > 0, costs[1].uniform > 0 }, { true, true })
  check.holds(core.read_file(folder .. "/recommend_cost.csv"), "at_most,search,uniform,ratio\n0.05,")
end)
