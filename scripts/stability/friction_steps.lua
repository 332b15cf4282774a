-- Where ironing back and forth holds: step size against friction.
--
-- Problem: a half ring is pressed into a slab, dragged along it and back again. Where it turns, every contact point
--          goes from slip over stick to slip the other way; the longer the step and the stronger the friction, the more
--          of them change at once.
--
--              (   )        die: half annulus, radii 0.3 and 0.5, E = 1000, its two flat ends driven: pressed by 0.23
--        _______\_/_______   in 46 steps, dragged by 1.5 in 250 steps and back in 250 steps, or in fewer
--       |  <--------->   |
--       |  slab: 3 × 1, E = 1, bottom clamped
--
--          Plane strain, neo-Hooke, nu = 0.3, both penalties 100, slave: die; mesh m1: die 6 × 2 and slab 8 × 3
--          elements.
-- Source: the problem of V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for
--         Isogeometric Analysis of Contact Problems, PhD thesis, IIT Guwahati, 2020, section 7.1; the way back, other
--         coefficients and longer steps are chosen here.
-- Units: mm, N, N/mm².
-- Expected: plain Newton holds 24 (N2), 24 (N4) and 21 (N2-N2.2) of 30 cells, the controls all 90, with 0.81 to 0.83
--           times as many iterations where both hold, and the same drag to 2e-8. Steps up to 4 times as long hold with
--           every friction, up to 8 times with N2 and N4; where they are 16 times as long all fail while the die is
--           pressed. Drag over pressing force is 0.43 at mu = 0.4, back and forth alike.
-- Run: signorini scripts/stability/friction_steps.lua [labels=N2,N4,N2-N2.2] [friction=0,0.1,0.2,0.4,0.6,0.8]
--      [coarser=1,2,4,8,16] [mesh=m1] [jobs=2] [limit=600] [keep=no] [with=robust] [out=out/stability/friction_steps];
--      one map for each label; coarser: steps that many times as long; keep=yes takes up the cells that an earlier call
--      left in the folder; with=cutting, rescue or prediction turns on one of the controls alone.

local sg = require "signorini"
local ironing = require "ironing2d.problem"
local study = require "stability.study"

local options = study.arguments{
  labels = { "N2", "N4", "N2-N2.2" }, friction = { 0, 0.1, 0.2, 0.4, 0.6, 0.8 },
  coarser = { { 1.0, 2.0, 4.0, 8.0, 16.0 }, above = 0 }, mesh = ironing.meshes "m1",
  out = "out/stability/friction_steps",
}
local elements = ironing.elements(options.mesh)

--- The standard set-up with another coefficient of friction.
local function with_friction(mu) return setmetatable({ mu = mu }, { __index = ironing.variants.standard }) end

--- Back and forth.
local function path(coarser)
  local set_up = ironing.variants.standard
  local stages = ironing.path(set_up, coarser)
  stages[3] = { name = "back", steps = stages[2].steps, grip = { 0, -set_up.depth } }
  return stages
end

--- Drag over pressing force in the middle of the way forward and of the way back.
local function figures(_, run)
  local function drag(stages)
    local step = run.stages[1].steps + math.floor((stages - 0.5) * run.stages[2].steps)
    return run:column "grip.fx"[step] / -run:column "grip.fy"[step]
  end
  return { ["drag forward"] = drag(1), ["drag back"] = drag(2) }
end

local files, results = sg.files(options.out), {}
for _, label in ipairs(options.labels) do
  results[label] = study.solve({
    name = ("Ironing back and forth, %s at %s"):format(label, options.mesh), key = label,
    x = { name = "length of a step (published: 1)", values = options.coarser },
    y = { name = "coefficient of friction", values = options.friction },
    scene = function(_, mu) return (ironing.scene(with_friction(mu), label, elements)) end,
    path = function(_, coarser) return path(coarser) end,
    figures = figures,
  }, options, files)
end
files:report()
return { maps = results, files = files }
