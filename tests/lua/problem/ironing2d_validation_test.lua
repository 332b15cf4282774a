-- scripts/problems/ironing2d.lua variant=validation on half of the published elements.

require "check"

local study, folder = check.study("problems/ironing2d", "variant=validation", "mesh=24")

check.case("both discretizations complete without cutting a step", function()
  for _, case in ipairs(study.cases) do
    check.equal({ case.run.failed, case.run.steps, case.run.cutbacks }, { false, 210, 0 })
  end
  check.equal(study.cases.N2.die_dofs.total, 2 * 5 * 27) -- 24 + 2 functions along the arc and one for its C0 line
  check.equal(study.cases.N4.slab_dofs.total, 2 * 13 * 28)
end)

check.case("during sliding the drag is slightly less than mu = 0.3 times the pressing force", function()
  for _, order in ipairs { "N2", "N4" } do
    local mean = study.cases[order].mean
    check.near(mean.Px / mean.Py, 0.2908, 2e-3)
    check.near(mean.Py, 0.05407, 6e-4) -- as on the full mesh
  end
  -- N4 is the smoother one.
  local coarse, smooth = study.cases.N2.oscillation, study.cases.N4.oscillation
  if not (smooth.Py < coarse.Py and smooth.Px < coarse.Px) then
    error "the oscillation of N4 is not smaller than that of N2"
  end
end)

check.case("a sheet, three charts and two files", function()
  for _, name in ipairs { "states.png", "forces.png", "Py.png", "Px.png", "N2.csv", "N4.csv" } do
    assert(io.open(folder .. "/" .. name)):close()
  end
  check.equal(#study.files, 6)
end)
