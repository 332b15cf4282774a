-- Convergence map of ironing back and forth: step size against coefficient of friction.
--
-- Problem: a half ring is pressed into a slab, dragged along it and back. At the reversal every contact point changes
--          from slip over stick to slip in the opposite direction; the larger the step and the friction, the more
--          points change at once.
--
--              (   )        die: half annulus, radii 0.3 and 0.5, E = 1000, both flat ends driven: pressed by 0.23
--        _______\_/_______   in 46 steps, dragged by 1.5 in 250 steps and back in 250 steps, or in fewer
--       |  <--------->   |
--       |  slab: 3 × 1, E = 1, bottom clamped
--
--          Plane strain, neo-Hooke, nu = 0.3, both penalties 100, slave: die; mesh m1: die 6 × 2 and slab 8 × 3
--          elements.
-- Source: the problem of V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for
--         Isogeometric Analysis of Contact Problems, PhD thesis, IIT Guwahati, 2020, section 7.1; the reversal, other
--         coefficients and larger steps are chosen here.
-- Units: mm, N, N/mm².
-- Expected: plain Newton converges in 23 (N2), 24 (N4) and 22 (N2-N2.2) of 30 cells, all controls in all 90, with 0.69
--           to 0.76 times as many iterations where both converge, and the same drag to 2e-5. Plain Newton converges
--           with steps up to 4 times as large for every friction but one, up to 8 times with N2 and N4; with steps 16
--           times as large all fail early. Drag over pressing force is 0.43 at mu = 0.4, in both directions.
-- Run: signorini stability/friction_steps.lua [orders=N2,N4,N2-N2.2] [friction=0,0.1,0.2,0.4,0.6,0.8]
--      [coarser=1,2,4,8,16] [mesh=m1] [points=3(p+1)] [jobs=2] [limit=600] [keep=no] [with=robust] [formulation=gpts]
--      [out=out/stability/friction_steps];
--      one map for each discretization; coarser: factors on the step size; points: contact points, also auto; keep=yes
--      reuses the cells that an earlier call left in the folder; with=cutting, fallback or prediction turns on only one
--      of the controls; formulation: a row of formulations/rows.lua, such as equal, reduced or half-passes.

local sg = require "signorini"
local formulations = require "formulations.rows"
local ironing = require "problems.ironing2d.problem"
local study = require "stability.study"

local options = study.arguments{
  orders = { "N2", "N4", "N2-N2.2" }, friction = { 0, 0.1, 0.2, 0.4, 0.6, 0.8 },
  coarser = { { 1.0, 2.0, 4.0, 8.0, 16.0 }, above = 0 }, mesh = ironing.meshes "m1",
  points = { "3(p+1)", choices = { "3(p+1)", "auto" } },
  formulation = formulations.argument "gpts", out = "out/stability/friction_steps",
}
local elements = ironing.elements(options.mesh)
local formulation = formulations[options.formulation]
local points = options.points == "auto" and "auto" or nil

--- The standard variant with another coefficient of friction.
local function with_friction(mu) return setmetatable({ mu = mu }, { __index = ironing.variants.standard }) end

--- Back and forth.
local function path(coarser)
  local set_up = ironing.variants.standard
  local stages = ironing.path(set_up, coarser)
  stages[3] = { name = "back", steps = stages[2].steps, grip = { 0, -set_up.depth } }
  return stages
end

--- Drag over pressing force in the middle of the forward and the backward slide.
local function forces(_, run)
  local function drag(stages)
    local step = run.stages[1].steps + math.floor((stages - 0.5) * run.stages[2].steps)
    return run:column "grip.fx"[step] / -run:column "grip.fy"[step]
  end
  return { ["drag forward"] = drag(1), ["drag back"] = drag(2) }
end

local files, results = sg.files(options.out), {}
for _, order in ipairs(options.orders) do
  results[order] = study.solve({
    name = ("Ironing back and forth, %s at %s"):format(order, options.mesh), key = order,
    x = { name = "length of a step (published: 1)", values = options.coarser },
    y = { name = "coefficient of friction", values = options.friction },
    scene = function(_, mu)
      return (ironing.scene(with_friction(mu), order, elements, points, nil, { formulation = formulation }))
    end,
    path = function(_, coarser) return path(coarser) end,
    results = forces, formulation = formulation,
  }, options, files)
end
files:report()
return { maps = results, files = files }
