-- scripts/formulations/ironing_cost.lua, coarse: iterations and oscillation of mortar next to Gauss points.

require "check"

local study, folder = check.study "formulations/ironing_cost"
local plane = study.studies.plane

local function row(formulation) return plane:row{ formulation = formulation } end

check.case("mortar with equal multipliers: iterations of Gauss points, half the oscillation", function()
  check.at_most("iterations", row("equal").per_step, 1.1 * row("gpts").per_step)
  for _, error in ipairs { "ddrag", "dpress" } do
    check.at_most(error, row("equal")[error], 0.6 * row("gpts")[error])
  end
  -- Gauss points take 2.09 iterations per step, of which 2 are the least, reduced multipliers 2.44.
  check.at_most("iterations, reduced", row("reduced").per_step, 1.25 * row("gpts").per_step)
end)

check.case("a second call reuses the finished cases", function()
  local before = row("gpts").cpu
  local words = { "out=" .. folder, table.unpack(check.rows["formulations/ironing_cost"]) }
  local again = check.study("formulations/ironing_cost", table.unpack(words)).studies.plane
  check.equal(again:row{ formulation = "gpts" }.cpu, before)
end)

check.case("files and wrong arguments", function()
  check.pictures(folder, { "plane_N2-N2.2_ddrag", "plane_N2-N2.2_dpress" })
  check.refused("formulations/ironing_cost", {
    ["solids=m1"] = "solids must be", ["mu=-1"] = "mu must be", ["rounds=0"] = "rounds must be" })
end)
