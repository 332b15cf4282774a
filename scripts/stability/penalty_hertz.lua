-- Hertz line contact, penalty against discretization: convergence, and oscillation of the pressure.
--
-- Problem: a quarter of a hollow elastic cylinder is pressed onto a rigid plane in 10 steps, without friction.
--
--         x = 0   ______   u_y = −0.00463 of the cut y = 0, or the half load P0 Ro uniformly distributed over it
--        u_x = 0 |  cut |
--                 \    /   quarter ring, radii 0.1 and 1, linear elastic, E = 1, nu = 0.3, plane strain
--          _______|\__/____   rigid plane, normal penalty 1 to 10⁶
--
--          The penalty constrains the gap at every contact point (Gauss-point-to-surface), 3(p + 1) of them per
--          element: more constraints than the face has functions (over-constraint). With a high penalty the pressure
--          follows the remaining gap.
--          Oscillation: root mean square of p(x) − f(x) over the contact points within 0.8 of the half-width a, over
--          Hertz's peak pressure for the computed force. f is the best fit by the sum of an ellipse √(1 − (x/a)²),
--          Hertz's pressure, and a parabola 1 − (x/a)², the pressure on an elastic (Winkler) foundation; a is the
--          larger of Hertz's and the computed half-width.
-- Source: the problem of V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for
--         Isogeometric Analysis of Contact Problems, PhD thesis, IIT Guwahati, 2020, section 7.2, where the penalty is
--         2000; on over-constraint: L. De Lorenzis, P. Wriggers, T. J. R. Hughes, GAMM-Mitteilungen 37 (2014) 85.
-- Units: any consistent units; lengths relative to the outer radius, pressures to Young's modulus; penalties in
--        pressure per length.
-- Expected: plain Newton converges in 33 of 35 cells: all discretizations up to 10⁵, and at 10⁶ all but N4 and N2-N4,
--           whose contact points open and close in turn (cycling active set). All controls converge in all cells.
--           Oscillation at 10³, 10⁴, 10⁵, 10⁶: N2 0.003, 0.016, 0.037, 0.055; N4 0.005, 0.032, 0.11, 0.35;
--           N2-N2.2 0.001, 0.001, 0.002, 0.003. Up to 10² the value of 0.003 is the misfit of f itself. The penetration
--           decreases with the penalty.
-- Run: signorini stability/penalty_hertz.lua [orders=N2,N4,N2-N4,N2-N2.1,N2-N2.2]
--      [penalties=1,10,1e2,1e3,1e4,1e5,1e6] [mesh=m3] [load=displacement] [steps=10] [jobs=2] [limit=600] [keep=no]
--      [with=robust] [formulation=gpts] [out=out/stability/penalty_hertz]; mesh: m1 to m6 as in hertz2d.lua; load:
--      displacement or force; keep=yes reuses the cells that an earlier call left in the folder; with=cutting, fallback
--      or prediction turns on only one of the controls; formulation: a row of formulations/rows.lua, such as equal or
--      reduced.

local sg = require "signorini"
local formulations = require "formulations.rows"
local hertz = require "problems.hertz2d.problem"
local smooth = require "stability.smooth"
local study = require "stability.study"

local options = study.arguments{
  orders = { "N2", "N4", "N2-N4", "N2-N2.1", "N2-N2.2" },
  penalties = { { 1.0, 10.0, 1e2, 1e3, 1e4, 1e5, 1e6 }, above = 0 },
  mesh = { "m3", choices = { "m1", "m2", "m3", "m4", "m5", "m6" } },
  load = { "displacement", choices = { "displacement", "force" } }, steps = 10,
  formulation = { "gpts", choices = formulations.where(function(row) return not row.two_faces end) },
  out = "out/stability/penalty_hertz",
}
local formulation = formulations[options.formulation]
local mesh, load, steps = options.mesh, options.load, options.steps
local part = 0.8 -- of the half-width; excludes the edge, where the number of active points changes

--- Oscillation of the pressure, half-width and largest penetration.
local function pressure_results(model, run)
  local profile = model:profile "ground"
  local a, peak = hertz.hertz(2 * run:column "ground.fy"[run.steps])
  local half_width = sg.profile_edges{ profile = profile }.to
  a = math.max(a, half_width)
  local x, pressure = {}, {}
  for i, place in ipairs(profile.x) do
    if place <= part * a then x[#x + 1], pressure[#pressure + 1] = place / a, profile.pressure[i] / peak end
  end
  return { oscillation = smooth.rest_of_hump(x, pressure), half_width = half_width,
           penetration = run:column "ground.max_penetration"[run.steps] }
end

local files = sg.files(options.out)
local maps = study.solve({
  name = ("Hertz at %s, load by %s"):format(mesh, load),
  x = { name = "order", values = options.orders },
  y = { name = "penalty (E / R)", values = options.penalties },
  scene = function(order, penalty)
    return (hertz.scene{ order = order, mesh = mesh, load = load, penalty = penalty, formulation = formulation })
  end,
  path = function(_, order, penalty)
    local _, stage = hertz.scene{ order = order, mesh = mesh, load = load, penalty = penalty,
                                  formulation = formulation }
    stage.steps = steps
    return { stage }
  end,
  results = pressure_results, formulation = formulation,
  charts = {
    { key = "oscillation", name = "oscillation", log = true, label = "oscillation of the pressure / peak" },
    { key = "penetration", name = "penetration", log = true, label = "largest penetration" },
  },
}, options, files)
files:report()
return { maps = maps, files = files }
