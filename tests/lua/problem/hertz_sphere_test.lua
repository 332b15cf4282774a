-- scripts/problems/hertz_sphere.lua, coarse: Hertz's point contact as an axisymmetric scene, the files it leaves.

require "check"

local study, folder = check.study("problems/hertz_sphere", "meshes=m1,m2,m3", "sizes=1,2", "steps=5")

check.case("Hertz's values as printed in the thesis, and the load over the full circle", function()
  check.near({ study.cases[1].a, study.cases[1].p0 }, { 0.05985, 0.04187 }, 5e-6)
  for _, case in ipairs(study.cases) do check.at_most("force in %", case.force_percent, 1e-6) end
end)

check.case("peak pressure and radius of contact within 1.5 % of Hertz's at m3", function()
  for _, order in ipairs { "N2", "N2-N2.2" } do
    local case = study.cases[order .. " m3"]
    check.at_most(order .. " peak in %", case.peak_percent, 1.5)
    check.at_most(order .. " radius in %", case.width_percent, 1.5)
  end
end)

check.case("the error falls from mesh to mesh, and the layer's is below that of N2", function()
  for level = 1, 3 do
    local plain, layer = study.cases["N2 m" .. level].error, study.cases["N2-N2.2 m" .. level].error
    check.at_most("N2-N2.2 m" .. level, layer, plain)
    if level > 1 then check.at_most("N2 m" .. level, plain, 0.3 * study.cases["N2 m" .. level - 1].error) end
  end
end)

check.case("under a stiff penalty twice R/a halves the difference of the peak from Hertz's", function()
  local once, twice = study.sizes[3], study.sizes[4]
  check.equal({ once.size, twice.size, once.stiffer, twice.stiffer }, { 1, 2, 10, 10 })
  check.near(twice.peak_percent / once.peak_percent, 0.5, 0.03)
end)

check.case("charts, a picture and a profile per run", function()
  check.pictures(folder, { "pressure_N2", "pressure_N2-N2.2", "syy" })
  check.equal(sg.csv.read(folder .. "/N2_m2.csv"):column "pressure", study.cases["N2 m2"].profile.pressure)
  check.equal(#study.files, 6 + 2 + 1)
end)

check.case("wrong arguments", function()
  check.refused("problems/hertz_sphere", {
    ["mesh=m1"] = "unknown argument 'mesh=m1'; did you mean 'meshes'? known: linear=auto, ",
    ["meshes=m9"] = "got 'm9'",
    ["sizes=0"] = "sizes must be numbers, 1 or more, got '0'",
    ["steps=0"] = "steps must be", ["orders=Q7"] = "Q7" })
end)
