-- Convergence map of ironing under a constant force: force against step size, for a rigid tool with free height.
--
-- Problem: a rigid cylinder starts above a slab, falls onto it under a force P per unit depth and is dragged along,
--          while its height follows from equilibrium. Driven tools fix the depth; here a step may push the tool off
--          or throw it through the slab.
--
--             ( R )     rigid, radius 0.5, P in one or more steps, then dragged by 1 at the force P
--          gap
--         _______________   slab 3 × 1, neo-Hooke, E = 1, nu = 0.3, 24 × 6 elements, plane strain, bottom clamped
--
--          Gaps below 0 are an initial overlap, with which plain Newton can start. Both penalties 100. Pressing takes
--          0.2 over the length of a step, the slide 1 over it.
-- Source: objects/pressed_tool.lua; the forces and steps are chosen here.
-- Units: any consistent units; lengths relative to twice the radius, forces to Young's modulus times that length.
-- Expected: plain Newton converges in 9 of 20 cells for both frictions, and with a gap of 0.05 in none, since
--           nothing holds the tool before it touches; all controls converge in all 80, and the contact carries P.
-- Run: signorini stability/pressed_tool.lua [friction=0.2,0.5] [order=N2] [gap=-1e-3]
--      [forces=0.02,0.05,0.1,0.2,0.4] [lengths=0.02,0.05,0.1,0.2] [jobs=2] [limit=600] [keep=no] [with=robust]
--      [formulation=gpts] [out=out/stability/pressed_tool]; one map for each friction; lengths: of a step of the slide;
--      keep=yes reuses the cells that an earlier call left in the folder; with=cutting, fallback or prediction turns on
--      only one of the controls; formulation: a row of formulations/rows.lua for one pass.

local sg = require "signorini"
local formulations = require "formulations.rows"
local study = require "stability.study"

local options = study.arguments{
  friction = { { 0.2, 0.5 }, at_least = 0 }, order = "N2", gap = -1e-3,
  forces = { { 0.02, 0.05, 0.1, 0.2, 0.4 }, above = 0 }, lengths = { { 0.02, 0.05, 0.1, 0.2 }, above = 0 },
  formulation = formulations.argument "gpts", out = "out/stability/pressed_tool",
}
local formulation = formulations[options.formulation]
if formulation.two_faces then
  error(("formulation=%s has two slave faces, but the tool is rigid"):format(formulation.name), 0)
end
local order, gap = options.order, options.gap
local distance, radius, penalty = 1, 0.5, 100

local function scene(mu)
  local slab = sg.body{ patch = sg.shapes.rectangle{ width = 3, height = 1 }, elements = { 24, 6 }, order = order,
                        contact = "north", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  local tool = sg.rigid.cylinder{ center = { 1, 1 + radius + gap }, radius = radius }
  return sg.model{
    bodies = { slab = slab },
    supports = { bed = { on = slab:face "south", fix = "xy" }, tool = { on = tool, free = "y", drive = "x" } },
    loads = { weight = { on = tool, force = { 0, 0 } } },
    contacts = { press = formulations.contact(formulation, {
      slave = slab:face "north", master = tool, penalty = penalty,
      friction = mu > 0 and { mu = mu, penalty = penalty } or nil }) },
  }
end

local function path(force, length)
  return { { name = "press", steps = math.max(1, math.ceil(0.2 / length)), weight = { 0, -force } },
           { name = "slide", steps = math.ceil(distance / length), tool = distance, weight = { 0, -force } } }
end

local files, results = sg.files(options.out), {}
for _, mu in ipairs(options.friction) do
  local key = ("mu%g"):format(mu)
  results[key] = study.solve({
    name = ("Ironing under a constant force, %s, μ = %g"):format(order, mu), key = key,
    x = { name = "force (2 E R)", values = options.forces },
    y = { name = "length of a step (2 R)", values = options.lengths },
    scene = function() return scene(mu) end,
    path = function(_, force, length) return path(force, length) end,
    formulation = formulation,
    results = function(_, run)
      return { carried = run:column "press.fy"[run.steps], drag = run:column "press.fx"[run.steps] }
    end,
  }, options, files)
end
files:report()
return { maps = results, files = files }
