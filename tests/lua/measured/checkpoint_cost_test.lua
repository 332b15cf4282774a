-- tests/measure/checkpoint_cost.lua, coarse: its rows, and that it leaves no file.

local core = require "signorini.core"
local check = require "check"

core.quiet = true
local folder = check.folder()

check.case("both problems with and without checkpoints", function()
  local print_to_terminal = print
  print = function() end
  local ok, costs = pcall(assert(loadfile(core.home .. "/tests/measure/checkpoint_cost.lua")),
    "every=0,10", "mesh=sparse", "slides=2", "repeats=1", "out=" .. folder)
  print = print_to_terminal
  if not ok then error(costs, 0) end
  check.equal(#costs, 4)
  for i, cost in ipairs(costs) do
    check.equal(cost.every, i % 2 == 1 and 0 or 10)
    check.equal({ cost.wall > 0, cost.size ~= nil and cost.size > 10 }, { true, i % 2 == 0 })
  end
  check.equal(io.open(folder .. "/run.sgn"), nil)
end)

check.case("wrong arguments", function()
  local script = assert(loadfile(core.home .. "/tests/measure/checkpoint_cost.lua"))
  local function run(word) script(word, "out=" .. folder) end
  check.fails(function() run "every=-1" end, "every must be whole numbers, 0 or more, got '-1'")
  check.fails(function() run "evry=1" end, "unknown argument 'evry=1'")
end)

check.done()
