-- 2D frictional ironing: effect of varying-order layers on the oscillation of the contact forces.
--
-- Problem: a half ring (the die) is pressed into the top of a rectangle (the slab) and dragged along it, with friction.
--          The reactions oscillate with the element pitch, the more so the coarser and less smooth the two faces are.
--
--                      die: half annulus, radii 0.3 and 0.5, both flat ends driven,
--              (   )        apex touches the slab at x = 0.75; pressed by 0.23 in 46 steps,
--        _______\_/____________________   then dragged by 1.5 in 250 steps
--       |                              |
--       |  slab: 3 × 1, bottom clamped |
--       |______________________________|
--
--          Plane strain, neo-Hooke, E = 1000 (die) and 1 (slab), nu = 0.3, mu = 0.2, both penalties 100, slave: die.
--          Meshes: die 6 × 2 and slab 8 × 3 elements (m1); each further mesh halves the elements.
--          variant=deep: E = 10000 (die), mu = 0.1, pressed by 0.5: which discretizations converge with p + 1, 2(p + 1)
--          and 3(p + 1) contact points, with and without halving of failed steps.
--          variant=validation: mu = 0.3, die from x = 0.5, pressed by 0.075 in 10 steps, dragged by 2 in 200 steps,
--          meshes 48 × 8 and 48 × 24: forces of N2 and N4.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, sections 6.2 and 7.1, Tables 7.2 and 7.3, Figures 6.5, 7.3
--         to 7.11. Plain Newton, as published.
-- Units: mm, N, N/mm²; forces per mm of depth.
-- Expected: the oscillations of Table 7.3 at m1 (in % of N2, dPy and dPx): N4 49.88 and 23.31, N6 24.57 and 11.81,
--           N2-N6 23.83 and 12.09, N2-N2.1 5.98 and 30.84, N2-N2.2 4.31 and 7.51; N2-N4 and N2-N2.3 a few percentage
--           points higher than printed. The oscillation is max − min over steps 110 to 165, about one element pitch in
--           the middle of the slab. Deep: all discretizations converge with p + 1 and 3(p + 1) contact points, N2 does
--           not with 2(p + 1); with halved steps all converge (thesis: N2 fails at m1). Validation: Py = 0.054, Px =
--           0.29 Py in the middle of the sliding, for both N2 and N4.
-- Run: signorini ironing2d.lua [mesh=m1] [orders=N2,N4,N6,N2-N4,N2-N6,N2-N2.1,N2-N2.2,N2-N2.3] [repeat=1]
--      [linear=auto] [out=out/ironing2d] [page=none]; several meshes (mesh=m1,m2,m3,m4) add charts over the mesh and
--      times at equal accuracy; times are medians of `repeat` runs; linear: sparse solver, as for model:run; page:
--      folder of ironing2d.md, whose tables of this variant are filled (standard: needs several meshes).
--      signorini ironing2d.lua variant=deep [mesh=m1] [orders=…] [points=1,2,3] [coarser=1,2]; points:
--      multiples of p + 1; coarser: factors on the step size.
--      signorini ironing2d.lua variant=validation [mesh=48] [orders=N2,N4]; mesh: elements along both faces.

local sg = require "signorini"
local page = require "page.tables"
local measure = require "problems.ironing2d.measure"
local convergence = require "problems.ironing2d.convergence"
local deep = require "problems.ironing2d.deep"
local output = require "problems.ironing2d.output"
local problem = require "problems.ironing2d.problem"
local validation = require "problems.ironing2d.validation"

local picture_steps = { [4] = true, [23] = true, [46] = true, [80] = true, [160] = true, [250] = true }
local reference_order = "N2"

-- ── The standard variant ─────────────────────────────────────────────────────────────────────────────────────────────

--- The run of median wall time; of an even number, the faster of the two in the middle.
local function median_run(runs)
  local sorted = table.move(runs, 1, #runs, 1, {})
  table.sort(sorted, function(a, b) return a.wall < b.wall end)
  return sorted[(#sorted + 1) // 2]
end

--- Runs all orders on all meshes, `repeat` times over, so that a disturbance affects all orders alike. Returns one
--- { mesh, cases } per mesh, also by its name.
local function solve_all(options, suffix, files)
  local studies = {}
  local keep, draw_states = output.record_states(picture_steps)
  for round = 1, options["repeat"] do
    for m, mesh in ipairs(options.mesh) do
      local study = studies[m] or { mesh = mesh, cases = {} }
      studies[m], studies[mesh] = study, study
      for i, order in ipairs(options.orders) do
        local case = problem.solve{ set_up = problem.variants.standard, order = order, mesh = mesh,
                                    linear = options.linear, on_step = round * m * i == 1 and keep or nil }
        case.model = nil
        if round == 1 then
          print(("%s at %s"):format(order, mesh))
          print(case.run)
          case.run:csv(files(order .. suffix(mesh) .. ".csv"))
          case.runs = { case.run }
          study.cases[i], study.cases[order] = case, case
        else
          table.insert(study.cases[i].runs, case.run)
        end
      end
    end
  end
  files:draw("states.png", "an accepted step", function(file)
    return draw_states(file, ("Ironing, %s at %s"):format(options.orders[1], options.mesh[1]), 2)
  end)
  for _, study in ipairs(studies) do
    for _, case in ipairs(study.cases) do case.work = median_run(case.runs) end
    measure.compare(study.cases, study.cases[reference_order])
  end
  return studies
end

local function report_mesh(options, study, suffix, files)
  local mesh, cases = study.mesh, study.cases
  local published = mesh == "m1" and sg.reference "ironing2d_oscillation_table7_3":by "discretization" or nil
  print(("\nDegrees of freedom and work at %s, %d steps (linear: factorization and solve)%s")
    :format(mesh, problem.variants.standard.press_steps + problem.variants.standard.slide_steps,
      options["repeat"] > 1 and (", medians of %d runs"):format(options["repeat"]) or ""))
  print(output.work_table(cases))
  print(("\nOscillation of the contact forces at %s, max − min over steps %d to %d%s"):format(mesh, measure.first,
    measure.last, published and ", compared with Table 7.3" or ", raw and detrended by a parabola"))
  print(sg.table(output.oscillation_table(cases, published)))
  files:draw("forces" .. suffix(mesh) .. ".png", "an accepted step", function(file)
    return output.draw_forces(file, cases, "Ironing, mesh " .. mesh)
  end)
  local need = "N2 among the orders, and runs that complete the window"
  files:draw("oscillations" .. suffix(mesh) .. ".png", need, function(file)
    return output.draw_oscillations(file, cases, "Ironing, mesh " .. mesh, published)
  end)
end

--- The page's tables: m1 against print, raw oscillations over the mesh, cases that the thesis calls equally accurate.
local function fill_page(options, studies, savings)
  local rows, heads = {}, { "case", "N2", "ΔPy", "of N2", "ΔPx", "of N2", "detrended ΔPy", "of N2", "detrended ΔPx",
                            "of N2" }
  for _, study in ipairs(studies) do
    for _, case in ipairs(study.cases) do rows[#rows + 1] = { case.order, study.mesh, case.dPy.raw, case.dPx.raw } end
  end
  local against_N2 = {}
  for _, pair in ipairs(savings) do
    if pair.plain.order == reference_order then against_N2[#against_N2 + 1] = pair end
  end
  page.fill(options, "ironing2d", "ironing2d", {
    oscillation = page.pick(output.oscillation_table(studies[1].cases,
      sg.reference "ironing2d_oscillation_table7_3":by "discretization"), { 1, 2, 4, 5, 7, 8 },
      { "discretization", "DOFs", "ΔPy", "Table 7.3", "ΔPx", "Table 7.3" }),
    refinement = page.across({ columns = { "", "", "", "" }, rows = rows, formats = { "%s", "%s", "%.2e", "%.2e" } },
      { 1 }, 2, { 3, 4 }, { "discretization", "ΔPy %s", "ΔPx %s" }),
    equal = page.pick(convergence.saving_table(against_N2), { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 }, heads),
  })
end

local function standard(options, files)
  local several = #options.mesh > 1
  local function suffix(mesh) return several and "_" .. mesh or "" end
  local studies = solve_all(options, suffix, files)
  for _, study in ipairs(studies) do report_mesh(options, study, suffix, files) end
  if not several then return { mesh = studies[1].mesh, cases = studies[1].cases, studies = studies } end
  local savings, cheapest = convergence.report(studies, options.orders, files)
  fill_page(options, studies, savings)
  return { studies = studies, savings = savings, cheapest = cheapest }
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

local options = sg.arguments{
  mesh = problem.meshes{ "m1" }, orders = { "N2", "N4", "N6", "N2-N4", "N2-N6", "N2-N2.1", "N2-N2.2", "N2-N2.3" },
  linear = "auto", page = "none", variant = { "standard", variants = {
    standard = { ["repeat"] = 1, out = "out/ironing2d" },
    deep = { points = { 1, 2, 3 }, coarser = { 1, 2 }, out = "out/ironing2d_deep" },
    validation = { mesh = problem.meshes "48", orders = { "N2", "N4" }, out = "out/ironing2d_validation" },
  } },
}
local files = sg.files(options.out)
local variants = { standard = standard, deep = deep.run, validation = validation.run }
local result = variants[options.variant](options, files)
files:report()
result.files = files
return result
