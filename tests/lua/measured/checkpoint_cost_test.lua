-- tests/measure/checkpoint_cost.lua, coarse: its rows, and that it leaves no file.

require "check"

check.case("both problems with and without checkpoints", function()
  local costs, folder = check.study("tests/measure/checkpoint_cost", "every=0,10", "mesh=sparse", "slides=2",
    "repeats=1")
  check.equal(#costs, 4)
  for i, cost in ipairs(costs) do
    check.equal(cost.every, i % 2 == 1 and 0 or 10)
    check.equal({ cost.wall > 0, cost.size ~= nil and cost.size > 10 }, { true, i % 2 == 0 })
  end
  check.equal(io.open(folder .. "/run.sgn"), nil)
end)

check.case("wrong arguments", function()
  local function run(word) check.study("tests/measure/checkpoint_cost", word) end
  check.fails(function() run "every=-1" end, "every must be whole numbers, 0 or more, got '-1'")
  check.fails(function() run "evry=1" end, "unknown argument 'evry=1'")
end)
