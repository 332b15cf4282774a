-- Peeling of an adhesive strip by rotating its end: effect of varying-order layers on the moment's oscillation.
--
-- Problem: a strip adheres to a rigid substrate by van der Waals forces; its free end is rotated by an angle θ, so it
--          bends and then peels. The moment should be constant, but oscillates with the element pitch.
--
--                                                     θ
--           ____________________________________________↶   right edge: rotated as a rigid line by 0.1° per step,
--          |        strip 200 × 10 nm                   |    both translations free, so only a moment acts
--          |____________________________________________|
--           0  : adhesion :  :  :  :  : 150          200     u_x of the left bottom corner fixed
--          =============================================
--             rigid substrate, at r_eq = 15^(−1/6) r0, where the adhesive traction is zero
--
--          Plane strain, neo-Hooke, E = E0 = 2 nN/nm², nu = 0.2; Hamaker's constant 0.1 nN nm, r0 = 0.4 nm.
--          Meshes: 160 × 8 (m1), 200 × 10 (m2), 240 × 12 elements (m3); not published: 80 × 4 (m0), for quick tests.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, section 7.4 and appendix B, Tables 7.7, 7.8 and B.2,
--         Figures 7.22 to 7.27, after R. A. Sauer, Int. J. Numer. Meth. Engng 87 (2011). Plain Newton, as published.
-- Units: nm, nN; moments in E0 L0³ = 2 nN nm per nm of depth (L0 = 1 nm), slopes in E0 L0³ per degree.
-- Expected: degrees of freedom as in Tables 7.8 and B.2. Mean moment from the energy balance of steady peeling, M k =
--           U(k) + W (work of the moment on the curvature k = bending energy + work of adhesion W = 15^(1/3) A/(16 pi
--           r0²), the integral of |T| from r_eq to infinity): M = √(2 E I W/(1 − nu²)) = 1.6315 for a thin strip at
--           small strains, 1.6289 with the neo-Hookean U(k); both neglect end effects and discretization error (derived
--           in peeling2d/steady.lua). Oscillations and slopes in 120° to 140° at m2 near Table 7.8: dM N2 4.28, N4
--           2.88, N2-N4 2.85, N2-N2.1 0.336, N2-N2.2 0.250 (1e-3). Under rotation control, N2 at m1 stops at a turning
--           point of its path, as do other coarse discretizations at larger angles; arc-length continuation passes it.
-- Run: signorini peeling2d.lua [mesh=m2] [orders=N2,N4,N2-N4,N2-N2.1,N2-N2.2] [steps=1500] [control=arc]
--      [repeat=1] [window=120,140] [length=200] [bonded=150] [iterations=30] [linear=auto] [out=out/peeling2d];
--      mesh can be several (m1,m2,m3: adds a chart over the mesh); control=rotation ends a run at the first failed
--      step, control=arc continues from there by arc length; window: degrees; length, bonded: lengths of the strip and
--      of the bonded part in nm, element length unchanged; times are medians of `repeat` runs.

local sg = require "signorini"
local measure = require "problems.peeling2d.measure"
local output = require "problems.peeling2d.output"
local problem = require "problems.peeling2d.problem"
local steady = require "problems.peeling2d.steady"

local picture_angles = { 60, 90, 120, 150 }

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

local function is_window(_, options)
  local window = options.window
  return #window == 2 and window[1] < window[2]
end
local options = sg.arguments{
  mesh = { { "m2" }, choices = { "m0", "m1", "m2", "m3" } }, orders = { "N2", "N4", "N2-N4", "N2-N2.1", "N2-N2.2" },
  steps = 1500, control = { "arc", choices = { "rotation", "arc" } }, ["repeat"] = 1,
  window = { { 120.0, 140.0 }, check = is_window, expected = "two increasing angles in degrees such as 120,140" },
  length = { problem.length, above = 0 },
  bonded = { problem.bonded, above = 0, check = function(bonded, all) return bonded < all.length end,
             expected = "a number of nm above 0 and below the strip's length" },
  iterations = 30, linear = "auto", out = "out/peeling2d",
}
local files, cases = sg.files(options.out), {}

--- Runs an order on a mesh `repeat` times; `work` is the run of median wall time, the earlier one of two in the middle.
local function solve(order, mesh, on_step)
  local rounds = {}
  for round = 1, options["repeat"] do
    rounds[round] = problem.solve(order, mesh, options, round == 1 and on_step or nil)
  end
  local case = rounds[1]
  table.sort(rounds, function(a, b) return a.wall < b.wall end)
  case.work = rounds[(#rounds + 1) // 2]
  case.window, case.snap_backs = measure.window(case, options.window), measure.snap_backs(case)
  local published = options.length == problem.length and options.bonded == problem.bonded
  case.printed = published and output.printed(order, mesh) or {}
  return case
end

--- Figure 7.22: collects the states of a case at the angles of the pictures.
local pictures = {}
local function keep_state(model, angle)
  for _, wanted in ipairs(picture_angles) do -- or the end of a shorter path
    if math.abs(angle - math.min(wanted, options.steps * problem.pitch)) < 1e-6 then
      pictures[#pictures + 1] = sg.picture{ model = model, field = "I1", factor = 1 / problem.modulus, label = "I1 / E",
                                            mesh = false, unit = "nm", title = ("θ = %.0f°"):format(angle) }
      break
    end
  end
end

--- Prints the results of a case as soon as they are known.
local function tell(case)
  print(("%s at %s, %d degrees of freedom"):format(case.order, case.mesh, case.dofs))
  print(case.rotation)
  if case.arc then print(("From %.1f° on, arc length where rotation control fails:\n%s")
    :format(case.rotation.steps * problem.pitch, case.arc)) end
end

local function write(case)
  sg.csv.write(files(("%s_%s.csv"):format(case.order, case.mesh)), {
    columns = { "step", "angle", "moment" }, step = case.step, angle = case.angle, moment = case.moment,
    comments = { ("%s at %s: angle in degrees, moment in E0 L0³; fractional steps are arc-length increments")
      :format(case.order, case.mesh), case.rotation.failure },
  })
end

for _, mesh in ipairs(options.mesh) do
  for _, order in ipairs(options.orders) do
    local case = solve(order, mesh, #cases == 0 and keep_state or nil)
    tell(case)
    write(case)
    cases[#cases + 1], cases[order .. " " .. mesh] = case, case
  end
end
local function case_of(order, mesh) return cases[order .. " " .. mesh] end

local thin, finite = steady.thin_moment(), steady.finite_moment()
print(("\nOscillation and steepest slopes of the moment in %g° to %g°, with Table 7.8 (whole steps; path: all states)")
  :format(table.unpack(options.window)))
print(output.oscillation_table(cases))
print(("\nMean moment of the window, and from the energy balance: thin strip %.4f, finite strain %.4f E0 L0³")
  :format(thin, finite))
print(output.plateau_table(cases, thin, finite))
print(("\nEnd of rotation control (at most %d iterations per step), and of arc-length control after it")
  :format(options.iterations))
print(output.path_table(cases))
local times, medians = output.time_table(cases, options["repeat"])
print(("\nTime (linear: factorization and solve)%s"):format(medians))
print(times)

-- ── Charts and pictures ──────────────────────────────────────────────────────────────────────────────────────────────

--- Adds a chart to the files if it was drawn.
local function draw(name, drawing, ...)
  if drawing(files.folder .. "/" .. name, ...) then files(name) end
end

for _, mesh in ipairs(options.mesh) do
  local shown = {}
  for i, order in ipairs(options.orders) do shown[i] = case_of(order, mesh) end
  output.draw_moment(files(("moment_%s.png"):format(mesh)), case_of("N2", mesh) or shown[1], finite, options.window)
  for name, wanted in pairs { standard = function(order) return not order:find "-" end,
                              layer = function(order) return order:find "-" ~= nil end } do
    draw(("plateau_%s_%s.png"):format(name, mesh), output.draw_plateau, shown,
      ("Peeling, mesh %s: moment on the plateau, %s"):format(mesh, name == "layer" and "layers on N2" or "standard"),
      options.window, wanted)
  end
  for _, case in ipairs(shown) do
    draw(("snap_back_%s_%s.png"):format(case.order, mesh), output.draw_snap_back, case)
  end
end
if #options.mesh > 1 then
  draw("oscillation_over_mesh.png", output.draw_over_mesh, options.orders, options.mesh, case_of)
end
if #pictures > 0 then
  sg.sheet{ pictures, file = files "states.png", columns = math.min(2, #pictures),
            title = ("Peeling, %s at %s"):format(cases[1].order, cases[1].mesh) }
end
files:report()

return { cases = cases, thin = thin, finite = finite, files = files }
