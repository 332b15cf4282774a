-- tests/measure/half_model.lua, coarse: unknowns and forces of partial models. Its times depend on the machine.

require "check"

check.case("halves and a quarter", function()
  local scenes = check.study "tests/measure/half_model"
  check.equal(#scenes, 5)
  for i, whole in pairs { 1, 1, 3, 3, 3 } do
    local part, all = scenes[i], scenes[whole]
    check.equal({ part.ratio, part.wall > 0 }, { part.wall / all.wall, true })
    check.within_share(part.name, part.force, all.force, 0.1)
    check.at_most(part.name, part.unknowns * part.parts, 1.6 * all.unknowns)
  end
end)
