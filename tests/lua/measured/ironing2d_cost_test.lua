-- scripts/problems/ironing2d.lua variant=cost in few steps.

require "check"
local cost = require "problems.ironing2d.cost"

local study, folder = check.study("problems/ironing2d", "variant=cost", "steps=66", "repeat=1")

check.case("all discretizations complete, with the forces of the fine mesh", function()
  for _, case in ipairs(study.cases) do
    check.equal({ case.run.failed, case.run.steps, case.run.cutbacks }, { false, 66, 0 })
    -- of variant=validation on 48 × 24 elements; the coarse meshes are stiffer
    check.within_share("mean Py", case.mean.Py, 0.05407, 0.025)
    check.within_share("mean Px", case.mean.Px, 0.01573, 0.035)
  end
end)

check.case("the cheapest: half of the DOFs, no larger forces, smaller oscillations than GetFEM's", function()
  local first, cheapest = study.cases["N2-N2.2, 24 × 6, 66"], study.cases["N2-N2.1, 26 × 2, 66"]
  check.equal({ first.dofs, cheapest.dofs }, { 658, 320 })
  for force, value in pairs(cheapest.mean) do check.at_most(force, value, first.mean[force]) end
  for _, force in ipairs { "Px", "Py" } do
    check.at_most("oscillation of " .. force, cheapest.percent[force], cost.getfem[force])
  end
end)

check.case("a table and two charts", function()
  local table = sg.csv.read(folder .. "/cost.csv")
  check.equal(table:column "dofs", { 658, 658, 324, 320 })
  check.equal(table:column("relative_time")[1], 1)
  check.pictures(folder, { "Px_over_time", "Py_over_time" })
  check.equal(#study.files, 3)
end)

check.case("numbers of steps that cannot be divided into pressing and sliding", function()
  check.fails(function() check.study("problems/ironing2d", "variant=cost", "steps=50") end,
    "steps=50: not a multiple of 11")
end)
