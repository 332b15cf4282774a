-- scripts/problems/ironing2d.lua as a user runs it: published results, iterations, files.

require "check"

local study, folder = check.study("problems/ironing2d", "mesh=m1")

check.case("Table 7.2: degrees of freedom", function()
  local printed = sg.reference "ironing2d_dofs_table7_2"
  check.equal(#study.cases, #printed.rows)
  for order, row in pairs(printed:by "discretization") do
    for _, part in ipairs { "interface", "bulk", "total" } do
      check.equal(study.cases[order].die_dofs[part], row["die_" .. part])
      check.equal(study.cases[order].slab_dofs[part], row["slab_" .. part])
    end
  end
end)

check.case("Table 7.3: oscillations within 1.5 percentage points", function()
  local printed = sg.reference "ironing2d_oscillation_table7_3":by "discretization"
  for _, order in ipairs { "N4", "N6", "N2-N6", "N2-N2.1", "N2-N2.2" } do
    local case, row = study.cases[order], printed[order]
    check.within(order .. " dPy", case.dPy.raw_percent, row.dPy_percent_of_N2, 1.5)
    check.within(order .. " dPx", case.dPx.raw_percent, row.dPx_percent_of_N2, 1.5)
  end
end)

check.case("oscillations that differ from print, and those of N2, are unchanged", function()
  check.within("N2 dPy", study.cases.N2.dPy.raw, 1.742e-2, 1e-5)
  check.within("N2 dPx", study.cases.N2.dPx.raw, 1.300e-2, 1e-5)
  check.within("N2-N4 dPy", study.cases["N2-N4"].dPy.raw_percent, 47.69, 0.05)
  check.within("N2-N4 dPx", study.cases["N2-N4"].dPx.raw_percent, 31.38, 0.05)
  check.within("N2-N2.3 dPy", study.cases["N2-N2.3"].dPy.raw_percent, 3.45, 0.05)
  check.within("N2-N2.3 dPx", study.cases["N2-N2.3"].dPx.raw_percent, 5.94, 0.05)
end)

check.case("three steps lie on a parabola: only the raw oscillation exists", function()
  local oscillation = require("problems.ironing2d.measure").oscillation
  for _, values in ipairs { { 5 }, { 5, 7 }, { 5, 7, 4 } } do
    local found = oscillation(values, 1, #values)
    check.equal(found.raw, math.max(table.unpack(values)) - math.min(table.unpack(values)))
    check.equal(found.detrended, nil)
  end
  -- x³ on −3 … 3 minus its projection 7 x: −6, 6, 6, 0, −6, −6, 6.
  check.near({ oscillation({ -27, -8, -1, 0, 1, 8, 27 }, 1, 7).detrended }, { 12 }, 1e-13)
end)

check.case("every run is complete, in at most 4.5 plain Newton iterations a step", function()
  for _, case in ipairs(study.cases) do
    check.equal({ case.run.failed, case.run.steps }, { false, 296 })
    if case.run.iterations > 4.5 * 296 then error(case.order .. " took " .. case.run.iterations .. " iterations") end
  end
end)

check.case("the pressing force is as large as the slab's reaction, step by step", function()
  local run = study.cases["N2-N2.2"].run
  for _, axis in ipairs { ".fx", ".fy" } do
    local bed, grip = run:column("bed" .. axis), run:column("grip" .. axis)
    for step = 1, run.steps do check.within("balance in step " .. step, bed[step] + grip[step], 0, 1e-9) end
  end
end)

--- The files are there and are pictures.
check.case("a sheet of states, two charts, and a file per order that tells what the run does", function()
  check.pictures(folder, { "states", "forces", "oscillations" })
  for _, case in ipairs(study.cases) do
    local read = sg.csv.read(("%s/%s.csv"):format(folder, case.order))
    check.equal(read:column "grip.fx", case.run:column "grip.fx")
  end
  check.equal(#study.files, 3 + 8)
end)

check.case("two meshes: oscillations at m2, times of pairs, charts over the mesh", function()
  local both, folder = check.study("problems/ironing2d", "mesh=m1,m2", "orders=N4,N2-N4", "repeat=2")
  local m2 = both.studies.m2.cases
  check.equal({ m2.N4.die_dofs.total + m2.N4.slab_dofs.total, #m2.N4.runs }, { 470, 2 })
  check.within("N4 dPy at m2", m2.N4.dPy.raw, 1.732e-3, 2e-6)
  check.within("N4 dPx at m2", m2.N4.dPx.raw, 1.957e-3, 2e-6)
  check.within("N4 dPx at m2 without trend", m2.N4.dPx.detrended, 1.886e-3, 2e-6)
  check.equal(both.studies.m1.cases.N4.dPy.raw, study.cases.N4.dPy.raw)
  check.equal(#both.savings, 2)
  for i, pair in ipairs(both.savings) do
    local mesh = "m" .. i
    check.equal({ pair.ours.order, pair.ours.mesh, pair.plain.order, pair.plain.mesh }, { "N2-N4", mesh, "N4", mesh })
    check.within("saving at " .. mesh, pair.saved, 100 * (1 - pair.ours.work.wall / pair.plain.work.wall), 1e-9)
    check.equal(pair.ours.work.wall, math.min(pair.ours.runs[1].wall, pair.ours.runs[2].wall))
  end
  check.equal(both.cheapest, {}) -- N2 was not run
  check.pictures(folder, { "Py_over_mesh_raw", "Px_over_mesh_detrended", "time_over_mesh", "accuracy_over_time",
    "forces_m2" })
end)

check.case("the cheapest case as accurate as N2 on a mesh: both oscillations count, then time", function()
  local function case(order, dPy, dPx, wall)
    return { order = order, dPy = { detrended = dPy }, dPx = { detrended = dPx }, work = { wall = wall } }
  end
  local function mesh(name, N2, layer) return { mesh = name, cases = { N2, layer, N2 = N2 } } end
  local cheapest = require "problems.ironing2d.convergence".cheapest{
    mesh("m1", case("N2", 9, 9, 1), case("layer", 3, 3, 2)),
    mesh("m2", case("N2", 4, 4, 4), case("layer", 0.5, 2, 5)),
    mesh("m3", case("N2", 1, 1, 20), case("layer", 0.1, 0.1, 25)),
  }
  check.equal({ cheapest[1].plain.work.wall, cheapest[1].ours.work.wall, cheapest[1].saved }, { 4, 2, 50 })
  check.equal({ cheapest[2].plain.work.wall, cheapest[2].ours.work.wall, cheapest[2].saved }, { 20, 20, 0 })
end)

check.case("wrong arguments", function()
  check.refused("problems/ironing2d", {
    ["msh=m1"] = "unknown argument 'msh=m1'; did you mean 'mesh'? known with variant=standard: linear=auto, ",
    ["orders=N2,Q7"] = "Q7", ["deep"] = "unknown argument 'deep'", ["repeat=0"] = "repeat must be a whole number",
    ["mesh=m1,m9"] = "mesh must be m1 to m6, or a multiple of 6 as the elements along both faces, got 'm9' in 'm1,m9'",
    ["variant=steep"] = "variant must be 'standard', 'deep' or 'validation', got 'steep'",
    ["variant=deep repeat=3"] = "'repeat=3', which belongs to variant=standard; "
      .. "known with variant=deep: coarser=1,2",
    ["variant=validation mesh=24,48"] = "got '24,48'", ["mesh=20"] = "a multiple of 6",
  })
end)
