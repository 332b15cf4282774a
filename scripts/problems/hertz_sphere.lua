-- Hertz point contact: a hollow sphere on a rigid plane as an axisymmetric model.
--
-- Problem: the lower half of a hollow elastic sphere rests on a rigid plane and is pressed onto it at its equator.
--
--          r = 0   ______   the load pi Ro² P0 is uniformly distributed over the cut at the equator
--        u_r = 0 |  cut |
--                |      |
--                 \    /   meridian: quarter ring, radii 0.2 and 1, linear elastic, E = 1, nu = 0.3, axisymmetric
--          _______|\__/____   rigid plane, no friction; normal penalty 1000
--
--          The thesis computes an eighth of the sphere in 3D; this is a model in the (r, z) plane.
--          Meshes: n × n elements along the meridian and in the thickness direction, n = 8, 16, 32, 64 (m1 to m4); 75 %
--          of the elements in each direction lie in the 10 % of the knot length next to the pole.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, section 6.3, Table 6.2, Figures 6.6 and 6.7; K. L. Johnson,
--         Contact Mechanics, Cambridge, 1985, section 4.2(a), for the closed form. Plain Newton, as published.
-- Units: any consistent units; lengths relative to the outer radius, pressures to Young's modulus, forces over the full
--        circle.
-- Expected: radius of contact a = (3 p R (1 − nu²)/(4 E))^(1/3) = 0.05985 and peak pressure 3 p/(2 pi a²) = 0.04187
--           under the load p = pi Ro² P0, P0 = 1e-4, both to 1.5 % on m3 and m4. The remaining difference in the peak
--           is due to the finite size: half of it at twice R/a.
-- Run: signorini hertz_sphere.lua [meshes=m1,m2,m3,m4] [orders=N2,N2-N2.2] [sizes=1,2,4] [steps=10]
--      [linear=auto] [out=out/hertz_sphere] [page=none]; sizes: multiples of R/a for the study of the finite size (1:
--      none); page: folder of hertz.md, whose tables of the sphere are filled.

local sg = require "signorini"
local page = require "page.tables"
local problem = require "problems.hertz_sphere.problem"

-- ── Solving ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Solves a scene and compares its contact with Hertz's.
local function solve(o, steps, linear)
  local model, stage, ball = problem.scene(o)
  stage.steps = steps
  local run = model:run({ stage }, sg.plain{ linear = linear })
  if run.failed then error(("%s at %s: %s"):format(o.order, o.mesh, run.failure), 0) end
  local case = { order = o.order, mesh = o.mesh, size = o.size or 1, stiffer = o.stiffer or 1, run = run,
                 dofs = ball:dofs(), model = model, profile = model:profile "ground" }
  local expected = problem.load / case.size ^ 3
  case.a, case.p0 = problem.hertz(expected)
  case.edges = sg.profile_edges{ profile = case.profile }
  case.force_percent = 100 * (run:column "ground.fy"[steps] / expected - 1)
  case.peak_percent = 100 * (run:column "ground.max_pressure"[steps] / case.p0 - 1)
  case.width_percent, case.spacing_percent = 100 * (case.edges.to / case.a - 1), 100 * case.edges.to_spacing / case.a
  case.error = sg.profile_error{
    profile = case.profile, coordinate = function(point) return point.x / case.a end, normalize = case.p0,
    reference = function(s) return s < 1 and case.p0 * math.sqrt(1 - s ^ 2) or 0 end,
  }
  return case
end

-- ── Output ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local function case_table(cases)
  local rows = {}
  for i, case in ipairs(cases) do
    rows[i] = { case.order, case.mesh, case.stiffer, case.size, problem.outer / case.a, case.dofs.total,
                case.peak_percent, case.width_percent, case.spacing_percent, case.force_percent, case.error,
                case.run.iterations, case.run.wall }
  end
  return {
    columns = { "order", "mesh", "penalty", "size", "R/a", "DOFs", "peak", "a", "points", "force", "L2 error",
                "iterations", "wall" },
    units = { "", "", "times", "times", "", "", "% off", "% off", "% of a", "% off", "", "", "s" }, rows = rows,
    formats = { "%s", "%s", "%d", "%g", "%.1f", "%d", "%.2f", "%.2f", "%.2f", "%.0e", "%.2e", "%d", "%.3f" },
  }
end

--- Effect of the sphere's finite size: R/a grows, all other lengths in units of a are fixed. Degree 2 in the thickness
--- direction, so that the discretization error is negligible; with the problem's penalty and a tenfold one.
local function size_study(options)
  local cases = {}
  for _, stiffer in ipairs { 1, 10 } do
    for _, size in ipairs(options.sizes) do
      cases[#cases + 1] = solve({ order = "N2-N2.2", mesh = "m3", size = size, stiffer = stiffer,
                                  thickness_degree = 2 },
        options.steps, options.linear)
    end
  end
  return cases
end

--- Figure 6.7: the pressure of one order on all meshes over the contact coordinate, with Hertz's.
local function draw_pressure(cases, order, file)
  local chart = { file = file, title = ("Hertz, sphere, %s: contact pressure"):format(order), xlabel = "r / a",
                  ylabel = "p / p_0", xrange = { 0, 1.2 }, inset = { xrange = { 0.85, 1.05 }, yrange = { 0, 0.6 } } }
  for _, case in ipairs(cases) do
    if case.order == order then
      local line, pressure = { x = {}, y = {}, label = case.mesh, marker = "none" }, case.profile.pressure
      for i, r in ipairs(case.profile.x) do
        if r < 1.25 * case.a then line.x[#line.x + 1], line.y[#line.y + 1] = r / case.a, pressure[i] / case.p0 end
      end
      chart[#chart + 1] = line
    end
  end
  local exact = { x = {}, y = {}, label = "Hertz", dashed = true, marker = "none" }
  for i = 0, 400 do exact.x[i + 1], exact.y[i + 1] = i / 400, math.sqrt(1 - (i / 400) ^ 2) end
  chart[#chart + 1] = exact
  sg.chart(chart)
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

local options = sg.arguments{
  meshes = { { "m1", "m2", "m3", "m4" }, choices = { "m1", "m2", "m3", "m4", "m5", "m6" } },
  orders = { "N2", "N2-N2.2" }, sizes = { { 1.0, 2.0, 4.0 }, at_least = 1 }, steps = 10, linear = "auto",
  out = "out/hertz_sphere", page = "none",
}
local files, cases = sg.files(options.out), {}

for _, mesh in ipairs(options.meshes) do
  for _, order in ipairs(options.orders) do
    local case = solve({ order = order, mesh = mesh }, options.steps, options.linear)
    local data = { columns = { "x", "y", "pressure", "gap" } }
    for _, name in ipairs(data.columns) do data[name] = case.profile[name] end
    sg.csv.write(files(("%s_%s.csv"):format(order, mesh)), data)
    cases[#cases + 1], cases[order .. " " .. mesh] = case, case
  end
end

print "\nPeak pressure and radius of contact compared with Hertz's, L2 error of p/p_0 over r/a against Hertz's"
local compared, sizes = case_table(cases), nil
print(sg.table(compared))
if #options.sizes > 1 then
  sizes = size_study(options)
  print "\nFinite size: degree 2 in the thickness direction"
  print(sg.table(case_table(sizes)))
end
page.fill(options, "hertz", "hertz_sphere", {
  sphere = page.across(compared, { 2 }, 1, { 7, 8 }, { "sphere", "peak, %s (%%)", "a, %s (%%)" }),
  sphere_size = sizes and page.across(case_table(sizes), { 5 }, 3, { 7, 8 },
    { "R/a", "peak, %s ε_N (%%)", "a, %s ε_N (%%)" }),
})
for _, order in ipairs(options.orders) do draw_pressure(cases, order, files(("pressure_%s.png"):format(order))) end
local last = cases[#cases]
sg.picture{ model = last.model, field = "syy", label = "axial stress", axes = { "r", "z" },
            file = files "syy.png", crop = { 0, 0.15, -1.003, -0.9 },
            title = ("Hertz, sphere, %s at %s: stress near the contact"):format(last.order, last.mesh) }
files:report()

return { cases = cases, sizes = sizes, files = files }
