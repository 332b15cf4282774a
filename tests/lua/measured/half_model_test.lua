-- tests/measure/half_model.lua, coarse: unknowns and forces of partial models. Its times depend on the machine.

local core = require "signorini.core"
local check = require "check"

core.quiet = true

check.case("halves and a quarter", function()
  local print_to_terminal = print
  print = function() end
  local ok, scenes = pcall(assert(loadfile(core.home .. "/tests/measure/half_model.lua")), "mesh=1", "solid=1",
    "repeats=1")
  print = print_to_terminal
  if not ok then error(scenes, 0) end
  check.equal(#scenes, 5)
  for i, whole in pairs { 1, 1, 3, 3, 3 } do
    local part, all = scenes[i], scenes[whole]
    check.equal({ part.ratio, part.wall > 0 }, { part.wall / all.wall, true })
    check.within_share(part.name, part.force, all.force, 0.1)
    check.at_most(part.name, part.unknowns * part.parts, 1.6 * all.unknowns)
  end
end)

check.done()
