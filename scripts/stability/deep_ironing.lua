-- Convergence map of deep ironing: discretization against step size, for several numbers of contact points.
--
-- Problem: a stiff half ring is pressed into a slab by half of its height and dragged along it, with friction.
--
--              (   )        die: half annulus, radii 0.3 and 0.5, E = 10000, both flat ends driven,
--               \_/         pressed by 0.5 in 46 steps, then dragged by 1.5 in 250 steps, or in fewer
--        ______/   \___________________
--       |                              |
--       |  slab: 3 × 1, E = 1, clamped |
--       |______________________________|
--
--          Plane strain, neo-Hooke, nu = 0.3, mu = 0.1, both penalties 100, slave: die; mesh m1: die 6 × 2 and slab
--          8 × 3 elements. Each map: discretizations against the step size as a multiple of the published one.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, section 7.1.4, where N2 at m1 does not converge.
-- Units: mm, N, N/mm².
-- Expected: plain Newton converges in 15, 17 and 23 of 40 cells with p + 1, 2(p + 1) and 3(p + 1) contact points, all
--           controls in all 120. With the published steps plain Newton converges with all discretizations, except N2
--           with 2(p + 1); with steps 16 times as large it always fails immediately. Where both converge, all controls
--           take 0.69 to 0.71 times as many iterations and give the same forces to 2e-6.
-- Run: signorini stability/deep_ironing.lua [points=p+1,2(p+1),3(p+1)]
--      [orders=N2,N4,N6,N2-N4,N2-N6,N2-N2.1,N2-N2.2,N2-N2.3] [coarser=1,2,4,8,16] [mesh=m1] [places=N6] [jobs=2]
--      [limit=600] [keep=no] [with=robust] [formulation=gpts] [out=out/stability/deep_ironing]; points: contact points
--      per element, p the degree on the contact face, also auto, one map for each; coarser: factors on the step size;
--      places: a discretization whose failures of plain Newton are shown in a picture, at the first of points and of
--      coarser, or none; keep=yes reuses the cells that an earlier call left in the folder; with=cutting, fallback or
--      prediction turns on only one of the controls; formulation: a row of formulations/rows.lua, such as equal,
--      reduced or half-passes.

local sg = require "signorini"
local formulations = require "formulations.rows"
local ironing = require "problems.ironing2d.problem"
local study = require "stability.study"

local multiples = { ["p+1"] = 1, ["2(p+1)"] = 2, ["3(p+1)"] = 3 }
local all_points = { "p+1", "2(p+1)", "3(p+1)" }
local options = study.arguments{
  points = { all_points, choices = { "p+1", "2(p+1)", "3(p+1)", "auto" } },
  orders = { "N2", "N4", "N6", "N2-N4", "N2-N6", "N2-N2.1", "N2-N2.2", "N2-N2.3" },
  coarser = { { 1.0, 2.0, 4.0, 8.0, 16.0 }, above = 0 }, mesh = ironing.meshes "m1", places = "N6",
  formulation = formulations.argument "gpts",
  out = "out/stability/deep_ironing",
}
local set_up, elements = ironing.variants.deep, ironing.elements(options.mesh)
local formulation = formulations[options.formulation]

--- `multiple` of p + 1 points per element; nil: "auto".
local function scene(order, multiple)
  local points = multiple and multiple * (ironing.layer_degree(order) + 1) or "auto"
  return (ironing.scene(set_up, order, elements, points, nil, { formulation = formulation }))
end

--- The forces on the die at the end of the path.
local function forces(_, run)
  return { drag = run:column "grip.fx"[run.steps], press = -run:column "grip.fy"[run.steps] }
end

local points, coarser = options.points, options.coarser
local files, results = sg.files(options.out), {}
for _, name in ipairs(points) do
  local multiple = multiples[name]
  results[name] = study.solve({
    name = ("Deep ironing with %s contact points"):format(name), key = ("points%s"):format(multiple or "_auto"),
    x = { name = "order", values = options.orders },
    y = { name = "length of a step (published: 1)", values = coarser },
    scene = function(order) return scene(order, multiple) end,
    path = function(_, _, times) return ironing.path(set_up, times) end,
    results = forces, formulation = formulation,
  }, options, files)
end

-- ── Where it fails ───────────────────────────────────────────────────────────────────────────────────────────────────

--- Draws the last state of plain Newton with an order, and the places in its report. Returns the run.
local function draw_places(order)
  local model = scene(order, multiples[points[1]])
  local run = model:run(ironing.path(set_up, coarser[1]), sg.plain({}))
  if not run.failed then
    print(("\n%s with %s contact points completes the path: nothing to mark"):format(order, points[1]))
    return run
  end
  print(("\n%s with %s contact points: %s: %s"):format(order, points[1], run.reason, run.failure))
  local x, y = run.places[1].x[1], run.places[1].x[2]
  sg.picture{ model = model, field = "syy", marks = run.places, file = files "places.png",
              crop = { x - 0.45, x + 0.45, y - 0.25, y + 0.25 }, size = 960, unit = "mm",
              title = ("%s, %s contact points: %s in step %d"):format(order, points[1], run.reason, run.steps + 1) }
  return run
end

local failed = options.places ~= "none" and draw_places(options.places) or nil
files:report()
return { maps = results, failed = failed, files = files }
