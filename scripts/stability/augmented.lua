-- Penalty and augmented Lagrangian methods compared: remaining penetration and error of the pressure.
--
-- Problem: Hertz line contact (hertz2d.lua): a quarter of a hollow cylinder, radii 0.1 and 1, E = 1, nu = 0.3,
--          is pressed onto a rigid plane, with penalties from far too soft to far too stiff; for each, once with the
--          penalty method alone and once with the augmented Lagrangian (Uzawa), until no contact point penetrates by
--          more than 1e-6 of the body's size.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, section 7.2, for the problem; J. C. Simo, T. A. Laursen, An
--         augmented Lagrangian treatment of contact problems involving friction, Comput. Struct. 42, 1992.
-- Units: lengths relative to the outer radius, pressures to Young's modulus.
-- Expected: augmentation reduces the penetration below 1e-6 of the size even for the softest penalty, and the force is
--           correct to 0.1 %. With N2 the pressure deteriorates as with a high penalty: every contact point becomes a
--           constraint, which over-constrains the problem. With N2-N2.2 it is not over-constrained: with the softest
--           penalty the error decreases from 0.099 to 0.010 of Hertz's peak pressure; the best penalty without
--           augmentation, 2000, has 0.008.
-- Run: signorini stability/augmented.lua [orders=N2,N2-N2.2] [mesh=m3] [penalties=1e2,5e2,2e3,1e4,1e5,1e6]
--      [penetration=1e-6] [loops=500] [steps=4] [reference=m5] [out=out/stability/augmented]

local sg = require "signorini"
local formulations = require "formulations.rows"
local hertz = require "problems.hertz2d.problem"

local levels = { "m1", "m2", "m3", "m4", "m5", "m6" }
local options = sg.arguments{
  orders = { "N2", "N2-N2.2" }, mesh = { "m3", choices = levels },
  penalties = { { 1e2, 5e2, 2e3, 1e4, 1e5, 1e6 }, above = 0 }, penetration = { 1e-6, above = 0 }, loops = 500,
  steps = 4, reference = { "m5", choices = levels }, out = "out/stability/augmented",
}
local orders, penalties, penetration, loops = options.orders, options.penalties, options.penetration, options.loops
local reference_penalty = 1e4

-- ── Runs ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

local function solve(order, mesh, penalty, enforcement)
  local model, stage = hertz.scene{ order = order, mesh = mesh, load = "displacement", penalty = penalty,
                                    formulation = enforcement == "augmented" and formulations["gpts-augmented"] or nil }
  stage.steps = options.steps
  local run = model:run({ stage },
    { augmentation = enforcement == "augmented" and { penetration = penetration, loops = loops } or nil })
  local case = { order = order, mesh = mesh, penalty = penalty, run = run, outcome = run.cause or run.reason }
  if run.failed then return case end
  case.profile = model:profile "ground"
  case.edge = sg.profile_edges{ profile = case.profile }.to
  case.penetration = run:column "ground.max_penetration"[run.steps]
  case.force, case.peak = run:column "ground.fy"[run.steps], run:column "ground.max_pressure"[run.steps]
  return case
end

local reference = solve("N2-N2.2", options.reference, reference_penalty, "penalty")
local _, p0 = hertz.hertz(2 * reference.force)

--- L2 error of the pressure in units of Hertz's peak, over x in units of the reference's half-width: over the whole
--- contact, and inside 0.8 of it.
local function errors(case)
  local function error_of(profile)
    return (sg.profile_error{ profile = profile, reference = reference.profile, normalize = p0,
                              coordinate = function(point) return point.x / reference.edge end })
  end
  local inside = {}
  for name, values in pairs(case.profile) do inside[name] = {} end
  for i, x in ipairs(case.profile.x) do
    if x <= 0.8 * reference.edge then
      for name, values in pairs(case.profile) do table.insert(inside[name], values[i]) end
    end
  end
  return error_of(case.profile), error_of(inside)
end

local cases, rows = {}, {}
for _, order in ipairs(orders) do
  for _, penalty in ipairs(penalties) do
    for _, method in ipairs { "penalty", "augmented" } do
      local case = solve(order, options.mesh, penalty, method)
      case.method = method
      if case.profile then
        case.error, case.inside = errors(case)
        case.force_percent, case.peak_percent = 100 * (case.force / reference.force - 1), 100 * (case.peak / p0 - 1)
      end
      cases[#cases + 1] = case
      cases[("%s %g %s"):format(order, penalty, method)] = case
      rows[#rows + 1] = { order, penalty, method, case.outcome, case.run.iterations, case.penetration, case.error,
                          case.inside, case.force_percent, case.peak_percent }
    end
  end
end

print(("Hertz at %s: penalty alone and augmented to a penetration of %g; errors against N2-N2.2 at %s, penalty %g")
  :format(options.mesh, penetration, options.reference, reference_penalty))
print(sg.table{
  columns = { "order", "penalty", "method", "outcome", "iterations", "penetration", "L2 error", "inside 0.8 a", "force",
              "peak" },
  units = { "", "", "", "", "", "", "of p_0", "of p_0", "% off", "% off" }, rows = rows,
  formats = { penalty = "%g", penetration = "%.2e", ["L2 error"] = "%.2e", ["inside 0.8 a"] = "%.2e", force = "%.3f",
              peak = "%.2f" },
})

-- ── Charts ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local files = sg.files(options.out)
local function chart(key, ylabel, title)
  local drawing = { file = files(key .. ".png"), title = title, xlabel = "penalty (E / R)", ylabel = ylabel,
                    log = "xy" }
  for i, order in ipairs(orders) do
    for _, method in ipairs { "penalty", "augmented" } do
      local line = { x = {}, y = {}, label = ("%s, %s"):format(order, method), dashed = method == "augmented",
                     color = i, markers = true }
      for _, penalty in ipairs(penalties) do
        local case = cases[("%s %g %s"):format(order, penalty, method)]
        if case[key] then line.x[#line.x + 1], line.y[#line.y + 1] = penalty, case[key] end
      end
      if #line.x > 0 then drawing[#drawing + 1] = line end
    end
  end
  sg.chart(drawing)
end
chart("error", "L2 error of p / p_0", "Hertz at " .. options.mesh .. ": error of the pressure")
chart("inside", "L2 error of p / p_0 inside 0.8 a",
  "Hertz at " .. options.mesh .. ": error of the pressure inside the contact")
chart("penetration", "largest penetration (R)", "Hertz at " .. options.mesh .. ": penetration")
files:report()

return { cases = cases, reference = reference, files = files }
