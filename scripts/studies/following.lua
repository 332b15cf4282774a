-- Layers that follow the contact: forces, energies, unknowns and time next to the layer of the whole face.
--
-- Problem: ironing in the plane and in space, where a tool slides over a slab, and a strip that is peeled off a rigid
--          plane. The layer of the contact faces is moved with the contact by adapt = { … } of model:run:
--
--               whole:  ═══════════════════════════    following:  ──────═══════───────────  → the tool slides
--                       slab                                       slab
--
--          All runs of a problem have the same elements, contact points, steps and controls (plain Newton; failed steps
--          are cut). The charts show the force and the elastic energy over the steps, and where the layer has moved.
-- Source: chosen here, after sections 7.1, 7.4 and 7.5 of V. Agrawal, An Accurate and Efficient Varying Order NURBS
--         Discretization Method for Isogeometric Analysis of Contact Problems, PhD thesis, IIT Guwahati, 2020.
-- Units: those of the problems; times in seconds.
-- Expected: oscillations within 5 % of the whole layer's, with fewer unknowns; where the layer moves, force and energy
--           jump by far less than they oscillate (see share/doc/decide/solver_control.md).
-- Run: signorini following.lua [problems=ironing2d,peeling2d] [orders=N2-N2.2] [mesh=] [margin=1] [tolerance=0]
--      [every=1] [out=out/following]; problems: ironing2d, ironing3d, peeling2d; mesh: one of the problem, by default
--      m2, coarse, m1; tolerance: 0 for none, otherwise only elements with this jump of tractions have the layer.

local sg = require "signorini"
local measure = require "problems.ironing2d.measure"
local problems = require "studies.following.problems"

local options = sg.arguments{
  problems = { { "ironing2d", "peeling2d" }, choices = { "ironing2d", "ironing3d", "peeling2d" } },
  orders = { "N2-N2.2" }, mesh = "", margin = { 1, at_least = 0 }, tolerance = { 0.0, at_least = 0 },
  every = { 1, at_least = 1 }, out = "out/following",
}
local files = sg.files(options.out)

-- ── Runs ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A run of a problem with or without adapt. Its columns unknowns and elastic are those of each step.
local function solve(name, order, adapt, label)
  local case = problems[name](order, options.mesh ~= "" and options.mesh or nil)
  local model = case.model
  case.name, case.order, case.way = name, order, label
  case.run = model:run(case.stages, sg.plain{
    adapt = adapt, step = { adaptive = true },
    on_step = function()
      return { unknowns = model:solver().unknowns, elastic = model:energy().stored }
    end,
  })
  case.values = case.run:column(case.force)
  case.oscillation = measure.oscillation(case.values, case.first, case.last)[case.kind]
  case.model = nil
  return case
end

local function mean(values)
  local sum = 0
  for _, value in ipairs(values) do sum = sum + value end
  return sum / #values
end

--- The largest relative jump of the energy of bodies and contacts at a move after the first stage.
local function jump(case)
  local most, first = nil, #case.stages > 1 and case.stages[1].steps or 0
  for _, move in ipairs(case.run.adaptations) do
    if move.step > first then
      most = math.max(most or 0, math.abs(move.energy_after / move.energy_before - 1))
    end
  end
  return most
end

local adapt = { margin = options.margin, every = options.every,
                tolerance = options.tolerance > 0 and options.tolerance or nil }
local sets = {}
for _, name in ipairs(options.problems) do
  for _, order in ipairs(options.orders) do
    local set = { name = name, order = order, solve(name, order:match "^[^-]*", nil, "no layer"),
                  solve(name, order, nil, "whole layer"), solve(name, order, adapt, "following") }
    for _, case in ipairs(set) do
      print(("%s, %s, %s: %s"):format(name, case.order, case.way, case.run.reason))
      collectgarbage()
    end
    sets[#sets + 1] = set
  end
end

-- ── Tables and charts ────────────────────────────────────────────────────────────────────────────────────────────────

local rows = {}
for _, set in ipairs(sets) do
  local whole = set[2]
  for _, case in ipairs(set) do
    local own, reference = case.oscillation, whole.oscillation
    rows[#rows + 1] = { set.name, case.order, case.way, mean(case.run:column "unknowns"), #case.run.adaptations,
                        case.run.iterations, case.run.wall, case.run.wall / whole.run.wall, own,
                        own and reference and 100 * (own / reference - 1), jump(case) }
  end
end
print(sg.table{
  columns = { "problem", "order", "layer", "unknowns", "moves", "iterations", "time", "time", "oscillation", "change",
              "energy jump" },
  units = { "", "", "", "mean", "", "", "s", "of whole", "", "%", "" }, rows = rows,
  formats = { "%s", "%s", "%s", "%.0f", "%d", "%d", "%.2f", "%.2f", "%.4g", "%+.1f", "%.1e" },
})

--- Values of the layer that follows less those of the layer of the whole face, over the steps of the last stage, with
--- marks at moves.
local function draw(set, key, ylabel, title)
  local chart = { file = files(("%s_%s_%s.png"):format(key, set.name, set.order)), xlabel = "step", ylabel = ylabel,
                  title = title }
  local first = #set[2].stages > 1 and set[2].stages[1].steps + 1 or 1
  local function values(case) return key == "force" and case.values or case.run:column "elastic" end
  local whole, follows = values(set[2]), values(set[3])
  local line = { x = {}, y = {}, label = ("%s, %s, less %s"):format(set[3].order, set[3].way, set[2].way),
                 markers = false }
  for step = first, math.min(#whole, #follows) do
    line.x[#line.x + 1], line.y[#line.y + 1] = step, follows[step] - whole[step]
  end
  local moves = { x = {}, y = {}, label = "the layer has moved", markers = true, line = false }
  for _, change in ipairs(set[3].run.adaptations) do
    local difference = line.y[change.step - first + 1]
    if difference then table.insert(moves.x, change.step) table.insert(moves.y, difference) end
  end
  chart[1], chart[2] = line, #moves.x > 0 and moves or nil
  sg.chart(chart)
end
for _, set in ipairs(sets) do
  draw(set, "force", set[2].label, set[2].title .. " with a layer that follows")
  draw(set, "energy", "elastic energy" .. set[2].energy_unit, set[2].title .. " with a layer that follows")
end
files:report()
return { sets = sets, files = files }
