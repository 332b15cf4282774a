-- scripts/problems/hertz3d.lua, coarse: Hertz's point contact in 3D compared with the axisymmetric model, files.

require "check"

local study, folder = check.study("problems/hertz3d", "meshes=m1,m2", "around=1,3", "steps=3")

check.case("Hertz's values as printed in the thesis, and a quarter of the load on the ground", function()
  check.near({ study.cases[1].a, study.cases[1].p0 }, { 0.05985, 0.04187 }, 5e-6)
  for _, case in ipairs(study.cases) do check.at_most("force in %", case.force_percent, 1e-6) end
end)

check.case("peak and radius converge to Hertz's; the layer is more accurate than N2", function()
  for _, order in ipairs { "N2", "N2-N2.2" } do
    local coarse, fine = study.cases[order .. " m1"], study.cases[order .. " m2"]
    check.at_most(order .. " peak in %", fine.peak_percent, 3.5)
    check.at_most(order .. " radius in %", fine.width_percent, 3)
    check.at_most(order .. " peak in %", fine.peak_percent, 0.3 * coarse.peak_percent)
    check.at_most(order .. " error", fine.error, 0.5 * coarse.error)
  end
  for _, mesh in ipairs { "m1", "m2" } do
    check.at_most("error of the layer at " .. mesh, study.cases["N2-N2.2 " .. mesh].error,
      study.cases["N2 " .. mesh].error)
  end
end)

check.case("3D agrees with the axisymmetric model except for quadrature, for any elements around the axis", function()
  for _, case in ipairs(study.cases) do
    check.at_most("peak apart in %", case.peak_apart, 0.05)
    check.at_most("radius apart in %", case.width_apart, 0.05)
    check.at_most("spread on a ring in % of p0", case.spread_percent, 0.05)
  end
  -- One element for a quarter turn has the fewest Gauss points.
  local twin = study.cases["N2 m1"].twin
  for i, bound in ipairs { 0.5, 0.01 } do
    check.at_most("peak relative to the twin in %", study.turns[i].peak_percent - twin.peak_percent, bound)
    check.at_most("radius relative to the twin in %", study.turns[i].width_percent - twin.width_percent, bound)
  end
end)

check.case("charts, pictures and a profile per run", function()
  check.pictures(folder, { "pressure_N2", "pressure_N2-N2.2", "szz", "szz_near", "pressure_below" })
  check.equal(sg.csv.read(folder .. "/N2_m2.csv"):column "pressure", study.cases["N2 m2"].profile.pressure)
  check.equal(#study.files, 4 + 2 + 3)
end)

check.case("wrong arguments", function()
  check.refused("problems/hertz3d", { ["mesh=m1"] = "unknown argument 'mesh=m1'; did you mean 'meshes'? known: around=",
    ["meshes=m9"] = "got 'm9'",
                               ["around=0"] = "around must be whole numbers, 1 or more, got '0'",
                               ["steps=0"] = "steps must be", ["orders=Q7"] = "Q7" })
end)
