-- The problems of following.lua: functions of an order and a mesh (nil: the first of the script's header) that
-- return { model, stages, force (a column), title, label and energy_unit for charts, first, last (steps between which
-- the force oscillates), kind ("raw": max − min, "detrended": after subtraction of a parabola) }.

local ironing2d = require "problems.ironing2d.problem"
local ironing3d = require "problems.ironing3d.problem"
local measure3d = require "problems.ironing3d.measure"
local peeling = require "problems.peeling2d.problem"

local problems = {}

--- Ironing in the plane (section 7.1), with steps three times as long as published, until one pitch of the slab after
--- its middle; the window is that of ironing2d/measure.lua.
function problems.ironing2d(order, mesh)
  local set_up, coarser = ironing2d.variants.standard, 3
  local stages = ironing2d.path(set_up, coarser)
  return { model = (ironing2d.scene(set_up, order, ironing2d.elements(mesh or "m2"))), stages = stages,
           title = "Ironing in the plane", force = "grip.fx", label = "drag (N/mm)",
           energy_unit = " (N)", first = math.ceil(110 / coarser), last = math.floor(165 / coarser), kind = "raw" }
end

--- Ironing in space (section 7.5): R = 7.5, depth 5.4, mu = 0.3. The indenter slides for `before`, then through the
--- window of ironing3d/measure.lua. The drag still rises there, so the oscillation is that of the pressing force.
function problems.ironing3d(order, mesh)
  local before = 3.0
  local case = { order = order, mesh = mesh or "coarse", radius = 7.5, mu = 0.3 }
  local stages = ironing3d.stages{ depth = 5.4, distance = before + measure3d.to - measure3d.from, down = 0.4 }
  local first = stages[1].steps + math.floor(before / ironing3d.along + 0.5)
  return { model = (ironing3d.scene(case, measure3d.from - before)), stages = stages, title = "Ironing in space",
           force = "grip.fz", label = "pressing force", energy_unit = "", first = first,
           last = first + measure3d.steps, kind = "detrended" }
end

--- Peeling (section 7.4) of a shorter strip, in 40° to 47°.
function problems.peeling2d(order, mesh)
  local length, bonded, from, to = 60, 50, 40, 47
  local steps = math.floor(to / peeling.pitch + 0.5)
  return { model = (peeling.scene(order, mesh or "m1", length, bonded)), force = "edge.moment", title = "Peeling",
           label = "moment (nN nm per nm)", energy_unit = " (nN nm per nm)",
           stages = { { name = "rotate", steps = steps, edge = steps * peeling.pitch } },
           first = math.floor(from / peeling.pitch + 0.5), last = steps, kind = "raw" }
end

return problems
