-- Hertz point contact in 3D: an eighth of a hollow sphere on a rigid plane, compared with an axisymmetric model.
--
-- Problem: an eighth of a hollow elastic sphere rests on a rigid plane and is pressed onto it at its equator.
--
--                z
--                |  .-'   x, y >= 0, z <= 0: u_x = 0 on the plane x = 0, u_y = 0 on y = 0
--            ____|'____   a quarter of the load pi Ro² P0 is uniformly distributed over the cut at the equator
--           | cut|     |  radii 0.2 and 1, linear elastic, E = 1, nu = 0.3
--            \   |    /   xi1 around z, xi2 from the equator to the pole, xi3 from the outer to the inner radius
--       ______\__|__/____   rigid plane, no friction; normal penalty 1000
--
--          Meshes: n/4 × n × n elements around z, along the meridian and in the thickness direction, n = 8, 16, 32 (m1
--          to m3); 75 % of the elements along the meridian and in the thickness direction lie in the 10 % of the knot
--          length next to the pole. Each is also solved as an axisymmetric model with the same meridian mesh.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, section 6.3, Table 6.2, Figures 6.6 and 6.7; K. L. Johnson,
--         Contact Mechanics, Cambridge, 1985, section 4.2(a), for the closed form. Plain Newton, as published.
-- Units: any consistent units; lengths relative to the outer radius, pressures to Young's modulus, forces over the full
--        circle.
-- Expected: radius of contact a = (3 p R (1 − nu²)/(4 E))^(1/3) = 0.05985 and peak pressure 3 p/(2 pi a²) = 0.04187
--           under the load p = pi Ro² P0, P0 = 1e-4, both to 3 % on m3. The weights around z are those of a circle, so
--           the 3D function space contains every axisymmetric state of the meridian mesh, and 3D adds only quadrature
--           error: any number of elements around z gives the pressure of the axisymmetric model.
-- Run: signorini hertz3d.lua [meshes=m1,m2,m3] [orders=N2,N2-N2.2] [around=1,2,4] [steps=10] [linear=auto]
--      [out=out/hertz3d] [page=none]; around: numbers of elements around z to compare, at the first mesh; page: folder
--      of hertz.md, whose table of the solid is filled.

local sg = require "signorini"
local page = require "page.tables"
local problem = require "problems.hertz3d.problem"

-- ── Solving ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Solves a scene and compares its contact with Hertz's.
local function solve(o, scene, options)
  local began = os.clock()
  local run = scene.model:run({ { name = "press", steps = options.steps, push = scene.target } },
    sg.plain{ linear = options.linear })
  if run.failed then error(("%s at %s: %s"):format(o.order, o.mesh, run.failure), 0) end
  local case = { order = o.order, mesh = o.mesh, around = o.around or problem.elements_of(o.mesh) // 4,
                 dofs = scene.dofs, model = scene.model, run = run, spread = 0, seconds = os.clock() - began }
  case.a, case.p0 = problem.hertz(problem.load)
  case.profile = scene.model:profile "ground"
  if scene.parts > 1 then case.profile, case.spread = problem.ring_profile(case.profile) end
  case.edges = sg.profile_edges{ profile = case.profile }
  case.force_percent = 100 * (scene.parts * run:column(scene.force)[options.steps] / problem.load - 1)
  case.peak = run:column "ground.max_pressure"[options.steps]
  case.peak_percent, case.width_percent = 100 * (case.peak / case.p0 - 1), 100 * (case.edges.to / case.a - 1)
  case.spacing_percent, case.spread_percent = 100 * case.edges.to_spacing / case.a, 100 * case.spread / case.p0
  case.error = sg.profile_error{
    profile = case.profile, coordinate = function(point) return point.x / case.a end, normalize = case.p0,
    reference = function(s) return s < 1 and case.p0 * math.sqrt(1 - s ^ 2) or 0 end,
  }
  return case
end

--- A solid compared with its axisymmetric model: differences of peak and radius, ratio of processor times.
local function solve_both(o, options)
  local case = solve(o, problem.solid(o), options)
  case.twin = solve(o, problem.revolved(o), options)
  case.peak_apart = 100 * (case.peak / case.twin.peak - 1)
  case.width_apart = 100 * (case.edges.to / case.twin.edges.to - 1)
  case.time_ratio = case.seconds / case.twin.seconds
  return case
end

-- ── Output ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local function case_table(cases)
  local rows = {}
  for i, case in ipairs(cases) do
    rows[i] = { case.order, case.mesh, case.around, case.dofs.total, case.peak_percent, case.width_percent,
                case.spacing_percent, case.spread_percent, case.force_percent, case.error, case.run.iterations,
                case.run.wall }
  end
  return sg.table{
    columns = { "order", "mesh", "around", "DOFs", "peak", "a", "points", "spread", "force", "L2 error", "iterations",
                "wall" },
    units = { "", "", "", "", "% off", "% off", "% of a", "% of p0", "% off", "", "", "s" }, rows = rows,
    formats = { "%s", "%s", "%d", "%d", "%.2f", "%.2f", "%.2f", "%.0e", "%.0e", "%.2e", "%d", "%.2f" },
  }
end

local function twin_table(cases)
  local rows = {}
  for i, case in ipairs(cases) do
    local twin = case.twin
    rows[i] = { case.order, case.mesh, twin.dofs.total, twin.peak_percent, twin.width_percent, case.peak_apart,
                case.width_apart, twin.run.iterations, twin.run.wall, case.time_ratio }
  end
  return {
    columns = { "order", "mesh", "DOFs", "peak", "a", "3D peak", "3D a", "iterations", "wall", "3D time" },
    units = { "", "", "", "% off", "% off", "% apart", "% apart", "", "s", "times" }, rows = rows,
    formats = { "%s", "%s", "%d", "%.2f", "%.2f", "%.0e", "%.0e", "%d", "%.3f", "%.0f" },
  }
end

--- The part of a profile that a chart shows, in units of Hertz's.
local function curve(case, options)
  local line = { x = {}, y = {}, label = options.label, marker = options.marker or "none", dashed = options.dashed }
  for i, r in ipairs(case.profile.x) do
    if r < 1.25 * case.a then
      line.x[#line.x + 1], line.y[#line.y + 1] = r / case.a, case.profile.pressure[i] / case.p0
    end
  end
  return line
end

--- Figure 6.7: the pressure of one order on all meshes over the contact coordinate, with Hertz's.
local function draw_pressure(cases, order, file)
  local chart = { file = file, title = ("Hertz in 3D, %s: contact pressure"):format(order), xlabel = "r / a",
                  ylabel = "p / p_0", xrange = { 0, 1.2 }, inset = { xrange = { 0.85, 1.05 }, yrange = { 0, 0.6 } } }
  for _, case in ipairs(cases) do
    if case.order == order then chart[#chart + 1] = curve(case, { label = case.mesh }) end
  end
  local exact = { x = {}, y = {}, label = "Hertz", dashed = true, marker = "none" }
  for i = 0, 400 do exact.x[i + 1], exact.y[i + 1] = i / 400, math.sqrt(1 - (i / 400) ^ 2) end
  chart[#chart + 1] = exact
  sg.chart(chart)
end

--- The whole eighth, a cut through the contact of the completed half, and the contact of the whole from below.
local function draw_states(case, files)
  local function draw(name, what, options)
    options.model, options.file = case.model, files(name)
    options.title = ("Hertz in 3D, %s at %s: %s"):format(case.order, case.mesh, what)
    sg.picture(options)
  end
  draw("szz.png", "vertical stress", { field = "szz" })
  draw("szz_near.png", "vertical stress near the contact", { field = "szz", mirror = "x",
    camera = "front", crop = { -0.13, 0.13, 0, 0.13, -1.002, -0.87 } })
  draw("pressure_below.png", "contact pressure from below", { field = "contact_pressure", mirror = "xy",
    obstacles = false, camera = "bottom", crop = { -0.1, 0.1, -0.1, 0.1, -1.002, -0.95 } })
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

local options = sg.arguments{
  meshes = { { "m1", "m2", "m3" }, choices = { "m1", "m2", "m3", "m4", "m5" } }, orders = { "N2", "N2-N2.2" },
  around = { 1, 2, 4 }, steps = 10, linear = "auto", out = "out/hertz3d", page = "none",
}
local files, cases, turns = sg.files(options.out), {}, {}

for _, mesh in ipairs(options.meshes) do
  for _, order in ipairs(options.orders) do
    local case = solve_both({ order = order, mesh = mesh }, options)
    local data = { columns = { "r", "pressure", "gap" }, r = case.profile.x, pressure = case.profile.pressure,
                   gap = case.profile.gap }
    sg.csv.write(files(("%s_%s.csv"):format(order, mesh)), data)
    cases[#cases + 1], cases[order .. " " .. mesh] = case, case
  end
end
for _, around in ipairs(options.around) do
  local o = { order = options.orders[1], mesh = options.meshes[1], around = around }
  turns[#turns + 1] = solve(o, problem.solid(o), options)
end

print "\nPeak pressure and radius of contact compared with Hertz's, L2 error of p/p_0 over r/a against Hertz's"
print(case_table(cases))
print "\nThe axisymmetric model with the same meridian mesh, and the difference of 3D from it"
local twins = twin_table(cases)
print(sg.table(twins))
print "\nElements around the axis"
print(case_table(turns))
for _, order in ipairs(options.orders) do draw_pressure(cases, order, files(("pressure_%s.png"):format(order))) end
draw_states(cases[#cases], files)
page.fill(options, "hertz", "hertz3d", { solid = page.across(twins, { 2 }, 1, { 6, 7, 10 },
  { "solid", "peak, %s (%% apart)", "a, %s (%% apart)", "time ratio, %s" }) })
files:report()

return { cases = cases, turns = turns, files = files }
