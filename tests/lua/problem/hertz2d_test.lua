-- hertz2d.lua, coarse: Hertz's closed form, the published degrees of freedom and orders, the files it leaves.

require "check"

local function run(...)
  return check.study("problems/hertz2d", "repeats=1", "steps=5", "orders=L1,N2,N2-N2.1,N2-N2.2", "reference=m5", ...)
end
local force = run("load=force", "meshes=m1,m3", "sizes=1,2")
local pushed, folder = run("meshes=m1,m2,m3", "sizes=1")

check.case("Table 7.4: degrees of freedom", function()
  local printed, seen = {}, 0
  for _, row in ipairs(sg.reference "hertz2d_dofs_table7_4".rows) do printed[row[2] .. " " .. row[1]] = row end
  for _, case in ipairs(pushed.cases) do
    local row = printed[case.order .. " " .. case.mesh]
    check.equal({ case.dofs.interface, case.dofs.bulk, case.dofs.total }, { row[3], row[4], row[5] })
    seen = seen + 1
  end
  check.equal(seen, 12)
end)

check.case("load P0 at m3 and on the reference: peak pressure and half-width within 1.5 % of Hertz's", function()
  for _, case in ipairs { force.reference, table.unpack(force.cases) } do
    check.near(case.force, 1e-3, 1e-12)
    if case.mesh ~= "m1" then
      check.at_most(case.order .. " peak in %", case.peak_percent, 1.5)
      check.at_most(case.order .. " half-width in %", case.width_percent, 1.5)
    end
  end
end)

check.case("the results are unchanged", function()
  check.near(force.cases["N2 m3"].peak_percent, 0.696, 2e-3)
  check.near(force.cases["N2 m3"].width_percent, -0.520, 2e-3)
  check.near(force.cases["N2-N2.2 m3"].width_percent, 0.557, 2e-3)
  check.near(pushed.reference.force, 0.99862e-3, 1e-8)
end)

check.case("the layer's error at m3 is at most a third of N2's, and that of N2 one mesh finer", function()
  for _, study in ipairs { force, pushed } do
    for _, order in ipairs { "N2-N2.1", "N2-N2.2" } do
      check.at_most(order, study.cases[order .. " m3"].error, study.cases["N2 m3"].error / 3)
    end
  end
  for level = 1, 2 do
    check.at_most("N2-N2.2 m" .. level, pushed.cases["N2-N2.2 m" .. level].error,
      pushed.cases["N2 m" .. level + 1].error)
  end
end)

check.case("under a stiff penalty twice R/a halves the differences from Hertz", function()
  local once, twice = force.sizes[3], force.sizes[4]
  check.equal({ once.size, twice.size, once.stiffer, twice.stiffer }, { 1, 2, 10, 10 })
  check.near(twice.peak_percent / once.peak_percent, 0.5, 0.03)
  check.near(twice.width_percent / once.width_percent, 0.5, 0.1)
end)

check.case("charts, a picture and a profile per run", function()
  check.pictures(folder, { "pressure_m1", "pressure_m3", "error", "error_smooth", "error_time", "syy" })
  check.equal(sg.csv.read(folder .. "/N2_m2.csv"):column "pressure", pushed.cases["N2 m2"].profile.pressure)
end)

check.case("wrong arguments", function()
  check.refused("problems/hertz2d", {
    ["mesh=m1"] = "unknown argument 'mesh=m1'; did you mean 'meshes'? known: linear=auto, ",
    ["meshes=m9"] = "got 'm9'",
    ["load=weight"] = "load must be 'force' or 'displacement', got 'weight'",
    ["sizes=1,0.5"] = "sizes must be numbers, 1 or more, got '0.5'",
    ["steps=x"] = "steps must be", ["orders=Q7"] = "Q7" }, "reference=m1")
end)
