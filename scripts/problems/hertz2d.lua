-- Hertz line contact: effect of varying-order layers on the pressure of a cylinder on a rigid plane.
--
-- Problem: a quarter of a hollow elastic cylinder rests on a rigid plane and is pressed onto it.
--
--         x = 0   ______   load=displacement: u_y = −0.00463 of the cut y = 0
--        u_x = 0 |  cut |  load=force: the half load P0 Ro, uniformly distributed over the cut
--                |      |
--                 \    /   quarter ring, radii 0.1 and 1, linear elastic, E = 1, nu = 0.3, plane strain
--          _______|\__/____   rigid plane, no friction; normal penalty 2000 (displacement) or 1000 (force)
--
--          Meshes: 9n × 48 elements, along the arc and in the thickness direction, n = 1, 2, 4, 8, 16, 32 (m1 to m6);
--          80 % of the elements in each direction lie in the 10 % of the knot length next to the apex. Reference: N2 at
--          m6.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, sections 6.1 and 7.2, Tables 6.1 and 7.4, Figures 6.2 and
--         7.12 to 7.17; K. L. Johnson, Contact Mechanics, Cambridge, 1985, section 4.2(c), for the closed form.
--         Plain Newton, as published.
-- Units: any consistent units; lengths relative to the outer radius, pressures to Young's modulus, forces per depth.
-- Expected: half-width a = √(4 p R (1 − nu²)/(pi E)) = 0.04814 and peak pressure 2 p/(pi a) = 0.02645 under the load
--           p = 2 P0 Ro, P0 = 0.001, both to 1.5 % on m3 and finer; degrees of freedom as in Table 7.4; errors of
--           N2-N2.1 and N2-N2.2 at m3 at most a third of N2's; N2-N2.2 at m3, m4 as accurate as N2 at m4, m5, with
--           42.5 % and 43.7 % less time in print. The difference from the Hertz solution decreases with increasing R/a:
--           half of it at twice R/a.
-- Run: signorini hertz2d.lua [load=displacement] [meshes=m1,m2,m3,m4,m5]
--      [orders=L1,N2,N4,N2-N4,N2-N2.1,N2-N2.2,N2-N3.2] [reference=m6] [sizes=1,2,4] [steps=10] [repeats=3]
--      [linear=auto] [out=out/hertz2d] [page=none]; sizes: multiples of R/a for the study of the finite size (sizes=1:
--      none); repeats: number of runs, of which the time is the median; page: folder of hertz.md, whose tables of this
--      load are filled.

local sg = require "signorini"
local page = require "page.tables"
local problem = require "problems.hertz2d.problem"
local in_turns = require "studies.in_turns"

--- Published saving of time of N2-N2.2 on a mesh against N2 on the next one, in %.
local savings = { m3 = 42.48, m4 = 43.74 }
local figures = { error = { "L1", "N2", "N2-N2.1", "N2-N2.2" },
                  error_smooth = { "N2-N4", "N4", "N2-N3.2", "N2-N2.2", "N2", "L1" } }

-- ── Solving ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Solves a scene and measures its contact, all compared with Hertz's solution for the computed force.
local function solve(o, steps, linear)
  local began = sg.wall_time()
  local model, stage, ring = problem.scene(o)
  stage.steps = steps
  local run = model:run({ stage }, sg.plain{ linear = linear })
  if run.failed then error(("%s at %s: %s"):format(o.order, o.mesh, run.failure), 0) end
  local wall = sg.wall_time() - began
  local case = { order = o.order, mesh = o.mesh, run = run, wall = wall, dofs = ring:dofs(), model = model }
  case.profile, case.edges = model:profile "ground", sg.profile_edges{ profile = model:profile "ground" }
  case.force, case.peak = run:column "ground.fy"[steps], run:column "ground.max_pressure"[steps]
  case.a, case.p0 = problem.hertz(2 * case.force)
  case.peak_percent, case.width_percent = 100 * (case.peak / case.p0 - 1), 100 * (case.edges.to / case.a - 1)
  case.spacing_percent = 100 * case.edges.to_spacing / case.a
  return case
end

--- Solves all pairs of order and mesh. Only the first one keeps its model.
local function solve_all(list, options)
  return in_turns(list, options.repeats, function(pair, k)
    local case = solve({ order = pair[1], mesh = pair[2], load = options.load }, options.steps, options.linear)
    if k > 1 then case.model = nil end
    return case
  end)
end

-- ── Tables ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local function printed_dofs()
  local rows, data = {}, sg.reference "hertz2d_dofs_table7_4"
  for _, row in ipairs(data.rows) do rows[row[1] .. row[2]] = row[5] end
  return rows
end

local function case_table(cases, finest)
  local rows, printed = {}, printed_dofs()
  local function add(case)
    local t = case.times
    rows[#rows + 1] = { case.order, case.mesh, case.dofs.total, printed[case.mesh .. case.order], case.peak_percent,
                        case.width_percent, case.spacing_percent, case.error, case.run.iterations, t.wall, t.bulk,
                        t.contact, t.linear }
  end
  for _, case in ipairs(cases) do add(case) end
  add(finest)
  return {
    columns = { "order", "mesh", "DOFs", "published", "peak", "a", "points", "L2 error", "iterations", "wall", "bulk",
                "contact", "linear" },
    units = { "", "", "", "", "% off", "% off", "% of a", "", "", "s", "s", "s", "s" }, rows = rows,
    formats = { "%s", "%s", "%d", "%d", "%.2f", "%.2f", "%.2f", "%.3g", "%d", "%.3f", "%.3f", "%.3f", "%.3f" },
  }
end

--- N2-N2.2 on each mesh, compared with N2 on the next one.
local function saving_table(cases)
  local rows = {}
  for level = 1, 5 do
    local layer, plain = cases["N2-N2.2 m" .. level], cases["N2 m" .. level + 1]
    if layer and plain then
      rows[#rows + 1] = { layer.mesh, layer.error, layer.times.wall, plain.mesh, plain.error, plain.times.wall,
                          100 * (1 - layer.times.wall / plain.times.wall), savings[layer.mesh] }
    end
  end
  return sg.table{
    columns = { "N2-N2.2", "error", "wall", "N2", "error", "wall", "time saved", "published" },
    units = { "", "", "s", "", "", "s", "%", "%" }, rows = rows,
    formats = { "%s", "%.2e", "%.3f", "%s", "%.2e", "%.3f", "%.1f", "%.1f" },
  }
end

--- Effect of the ring's finite size: R/a grows, all other lengths in units of a are fixed. Degree 2 in the thickness
--- direction, so that the discretization error is negligible; with the problem's penalty and a tenfold one.
local function size_study(options)
  local cases, rows = {}, {}
  for _, stiffer in ipairs { 1, 10 } do
    for _, size in ipairs(options.sizes) do
      local o = { order = "N2-N2.2", mesh = "m4", load = "force", size = size, stiffer = stiffer, thickness_degree = 2 }
      local case = solve(o, options.steps, options.linear)
      case.size, case.stiffer = size, stiffer
      cases[#cases + 1] = case
      rows[#rows + 1] = { stiffer, size, problem.outer / case.a, case.dofs.total, case.peak_percent, case.width_percent,
                          case.spacing_percent }
    end
  end
  return cases, {
    columns = { "penalty", "size", "R/a", "DOFs", "peak", "a", "points" },
    units = { "times", "times", "", "", "% off", "% off", "% of a" }, rows = rows,
    formats = { "%d", "%g", "%.1f", "%d", "%.2f", "%.2f", "%.2f" },
  }
end

-- ── Charts ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Figures 6.2 and 7.14: pressure over the contact coordinate, in units of Hertz's values, with his ellipse.
local function draw_pressure(cases, finest, mesh, file)
  local chart = { file = file, title = ("Hertz, mesh %s: contact pressure"):format(mesh), xlabel = "x / a",
                  ylabel = "p / p_0", xrange = { 0, 1.2 }, inset = { xrange = { 0.8, 1.02 } } }
  local function curve(case, label, dashed)
    local line, pressure = { x = {}, y = {}, label = label, marker = "none", dashed = dashed }, case.profile.pressure
    for i, x in ipairs(case.profile.x) do
      if x < 1.25 * case.a then line.x[#line.x + 1], line.y[#line.y + 1] = x / case.a, pressure[i] / case.p0 end
    end
    chart[#chart + 1] = line
  end
  for _, order in ipairs(figures.error) do
    if cases[order .. " " .. mesh] then curve(cases[order .. " " .. mesh], order, false) end
  end
  curve(finest, ("N2 at %s"):format(finest.mesh), true)
  local ellipse = { x = {}, y = {}, label = "Hertz", dashed = true, marker = "none", width = 2 }
  for i = 0, 400 do ellipse.x[i + 1], ellipse.y[i + 1] = i / 400, math.sqrt(1 - (i / 400) ^ 2) end
  chart[#chart + 1] = ellipse
  sg.chart(chart)
end

--- Figures 7.15 to 7.17: errors over the mesh or the time. Curves drawn first are on top.
local function draw_errors(chart, cases, orders, meshes, abscissa)
  chart.ylabel = "L2 error of p / p_ref"
  for _, order in ipairs(orders) do
    local line = { x = {}, y = {}, label = order, markers = true, marker = order == "N2-N4" and "open circle" or nil }
    for i, mesh in ipairs(meshes) do
      local case = cases[order .. " " .. mesh]
      if case then line.x[#line.x + 1], line.y[#line.y + 1] = abscissa(case, i), case.error end
    end
    if #line.x > 0 then chart[#chart + 1] = line end
  end
  if #chart > 0 then sg.chart(chart) end
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

local levels = { "m1", "m2", "m3", "m4", "m5", "m6" }
local options = sg.arguments{
  load = { "displacement", choices = { "force", "displacement" } },
  meshes = { { "m1", "m2", "m3", "m4", "m5" }, choices = levels },
  orders = { "L1", "N2", "N4", "N2-N4", "N2-N2.1", "N2-N2.2", "N2-N3.2" },
  reference = { "m6", choices = levels }, sizes = { { 1.0, 2.0, 4.0 }, at_least = 1 },
  steps = 10, repeats = 3, linear = "auto", out = "out/hertz2d", page = "none",
}
local files, cases = sg.files(options.out), {}

local function write_profile(case)
  local data = { columns = { "x", "y", "pressure", "gap" }, comments = { ("%s at %s"):format(case.order, case.mesh) } }
  for _, name in ipairs(data.columns) do data[name] = case.profile[name] end
  sg.csv.write(files(("%s_%s.csv"):format(case.order, case.mesh)), data)
end

local list = { { "N2", options.reference } }
for _, mesh in ipairs(options.meshes) do
  for _, order in ipairs(options.orders) do list[#list + 1] = { order, mesh } end
end
local solved = solve_all(list, options)
local finest = solved[1]
write_profile(finest)
for i = 2, #solved do
  local case = solved[i]
  case.error = sg.profile_error{ profile = case.profile, reference = finest.profile, normalize = "max",
                                 coordinate = function(point) return point.x / finest.edges.to end }
  write_profile(case)
  cases[i - 1], cases[case.order .. " " .. case.mesh] = case, case
end

print(("\nLoad by %s: peak pressure and half-width against Hertz's, L2 error of p/p_ref over x/a_ref against N2 at %s,")
  :format(options.load, finest.mesh))
print(("times as medians of %d (wall with setup; linear: factorization and solve), DOFs of Table 7.4")
  :format(options.repeats))
local compared = case_table(cases, finest)
print(sg.table(compared))
print "\nN2-N2.2 compared with N2 on the next mesh"
print(saving_table(cases))
local sizes, of_sizes
if #options.sizes > 1 then
  sizes, of_sizes = size_study(options)
  print "\nFinite size: N2-N2.2 at m4, degree 2 in the thickness direction, load by force"
  print(sg.table(of_sizes))
end
if options.load == "force" then
  page.fill(options, "hertz", "hertz2d_force", {
    line = page.across(compared, { 2 }, 1, { 5, 6 }, { "line", "peak, %s (%%)", "a, %s (%%)" }),
    line_size = of_sizes and page.across(of_sizes, { 3 }, 1, { 5, 6 },
      { "R/a", "peak, %s ε_N (%%)", "a, %s ε_N (%%)" }),
  })
else
  table.remove(compared.rows) -- the reference
  page.fill(options, "hertz", "hertz2d", { line_error = page.across(compared, { 2 }, 1, { 8 }, { "line", "%s" }) })
end

for _, mesh in ipairs(options.meshes) do draw_pressure(cases, finest, mesh, files(("pressure_%s.png"):format(mesh))) end
local ticks = {}
for i, mesh in ipairs(options.meshes) do ticks[i] = { i, mesh } end
for _, name in ipairs { "error", "error_smooth" } do
  local chart = { file = files(name .. ".png"), title = "Hertz: error of the contact pressure", xlabel = "mesh",
                  log = "y", xticks = ticks }
  draw_errors(chart, cases, figures[name], options.meshes, function(_, i) return i end)
end
draw_errors({ file = files "error_time.png", title = "Hertz: error over time", log = "xy",
              xlabel = ("time in %% of N2 at %s"):format(finest.mesh) },
  cases, figures.error, options.meshes, function(case) return 100 * case.times.wall / finest.times.wall end)
sg.picture{ model = finest.model, field = "syy", file = files "syy.png", mesh = false,
            crop = { 0, 0.12, -1.002, -0.915 },
            title = ("Hertz, N2 at %s: stress near the contact"):format(finest.mesh) }
files:report()

return { cases = cases, reference = finest, sizes = sizes, files = files }
