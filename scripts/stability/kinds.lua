-- Kinds of changing contact states under penalties: iterations with the default controls and with single ones.
--
-- Problem: seven scenes, each in few steps.
--          conforming: a quarter tube, radii 5 and 7, E = 100, N2, 8 × 4 elements, on a mandrel that grows by 0.05 in
--            4 steps, penalty 400 E/h: nearly all points open and close in turn;
--          receding: an elastic layer on an elastic foundation under a narrow pressure, in one step, penalty
--            100 E/h: the closed set shrinks by one point per iteration;
--          draped: a strip on a table, E = 100 on 10⁴, bends over its edge by its weight in 10 steps: the same, with
--            finite rotations;
--          slipping: a plate on a rigid plane with friction of 1, pressed from above and three times as much from the
--            side, in one step, penalty 50 E/h: points reverse their slip;
--          pressed: a block 6 × 1, N2-N2.2, 30 × 5 elements, ν = 0.45, is pressed 0.1 by a rigid cylinder of radius 2
--            with friction of 0.3 in 4 steps and unloaded in 4: the same, in most points at once;
--          incompressible: a disk of radius 6 and height 1, ν = 0.4999, projected volume change, is pressed 0.1 by a
--            rigid ball of radius 4 in 5 steps, penalty 133 E/h: errors of ln J are multiplied by 5000;
--          ironing: 2D ironing with a die of 18 elements, N2-N2.2, E = 1000 on 1, friction of 0.3, pressed by 0.075 in
--            3 steps and dragged by 2 in 30, half an element each: points open, close and turn their slip.
-- Source: conforming: chosen here. Receding: J. Dundurs, M. Stippes, J. Appl. Mech. 37, 1970. Draped, pressed,
--         incompressible, ironing: chosen here. Slipping: the benchmark of GRECO in Code_Aster, test SSNV128.
-- Units: as in the scenes, without dimensions; slipping in m and Pa; Newton iterations.
-- Expected: with the default controls 12 to 83 iterations without cuts, ironing 280; with whole corrections draped,
--           slipping and pressed take 2 to 13 times as many, ironing 909 with 74 cuts, incompressible 57 instead of 67.
-- Run: signorini stability/kinds.lua [scenes=conforming,receding,draped,slipping,pressed,incompressible,ironing]
--      [controls=robust,whole,line,freeze,changes,long] [out=out/stability/kinds]; controls: robust has a line search
--      by energy, whole has none, line has one by residual; long allows 100 iterations.

local sg = require "signorini"

local ways = {
  robust = {}, whole = { newton = { line_search = "none" } }, line = { newton = { line_search = "residual" } },
  freeze = { newton = { freeze_active_set = true } }, changes = { newton = { active_set_changes = 3 } },
  long = { newton = { iterations = 100 } },
}
local names, controls = { "conforming", "receding", "draped", "slipping", "pressed", "incompressible", "ironing" },
  { "robust", "whole", "line", "freeze", "changes", "long" }
local options = sg.arguments{ scenes = { names, choices = names }, controls = { controls, choices = controls },
                              out = "out/stability/kinds" }

-- ── Scenes: each returns a model and its stages ──────────────────────────────────────────────────────────────────────

local scenes = {}

function scenes.conforming()
  local E, inner, outer = 100, 5, 7
  local tube = sg.body{ patch = sg.shapes.quarter_annulus{ inner = inner, outer = outer, start = 0 },
                        elements = { 8, 4 }, order = "N2", contact = "north",
                        material = sg.linear_elastic{ E = E, nu = 0.3 } }
  local mandrel = sg.rigid.cylinder{ center = { 0, 0 }, radius = inner }
  local model = sg.model{
    bodies = { tube = tube },
    contacts = { fit = { slave = tube:face "north", master = mandrel, penalty = 400 * E / (math.pi / 2 * inner / 8) } },
    supports = { hold = { on = mandrel, fix = "xy" },
                 west = { on = tube:face "west", symmetry = true },
                 east = { on = tube:face "east", symmetry = true } },
  }
  return model, { { name = "grow", steps = 4, contacts = { fit = { offset = 0.05 } } } }
end

function scenes.receding()
  local length, n, material = 6, 48, sg.linear_elastic{ E = 1000, nu = 0.3 }
  local layer = sg.body{ patch = sg.shapes.rectangle{ width = length, height = 1 }, elements = { n, n // 6 },
                         order = "N2", contact = "south", material = material }
  local base = sg.body{
    patch = sg.shapes.rectangle{ width = length + 2, height = 6, corner = { 0, -6 } }, elements = { n, n // 2 },
    order = "N2", contact = "north", material = material,
    grading = { { elements = 0.6, length = 0.4, at = "start" }, { elements = 0.6, length = 0.3, at = "end" } } }
  local model = sg.model{
    bodies = { layer = layer, base = base },
    supports = { axis = { on = { layer:face "west", base:face "west" }, symmetry = true },
                 bed = { on = base:face "south", fix = "xy" } },
    loads = { top = { on = layer:face "north", pressure = function(x) return x < 0.125 and 1 or 0 end, factor = 0 } },
    contacts = { seat = { slave = layer:face "south", master = base:face "north",
                          penalty = 100 * 1000 / (length / n) } },
  }
  return model, { { name = "load", steps = 1, top = 1 } }
end

function scenes.draped()
  local tab = sg.body{ patch = sg.shapes.rectangle{ width = 10, height = 6, corner = { -10, -6 } },
                       elements = { 20, 12 }, order = "N2", contact = "north",
                       material = sg.neo_hookean{ E = 1e4, nu = 0.3 } }
  local strip = sg.body{ patch = sg.shapes.rectangle{ width = 14, height = 0.5, corner = { -6, 0 } },
                         elements = { 56, 2 }, order = "N2", contact = "south",
                         material = sg.neo_hookean{ E = 100, nu = 0.3 } }
  local model = sg.model{
    bodies = { tab = tab, strip = strip },
    supports = { bed = { on = tab:face "south", fix = "xy" }, clamp = { on = strip:face "west", fix = "xy" } },
    loads = { weight = { on = strip, force = { 0, 0 } } },
    contacts = { edge = { slave = strip:face "south", master = { tab:face "east", tab:face "north" },
                          penalty = 2000 } },
  }
  return model, { { name = "gravity", steps = 10, weight = { 0, -0.5 } } }
end

function scenes.slipping()
  local side, n, E = 0.04, 32, 1.3e11
  local penalty = 50 * E * n / side
  local plate = sg.body{ patch = sg.shapes.rectangle{ width = side, height = side }, elements = { n, n }, order = "N2",
                         contact = "south", material = sg.linear_elastic{ E = E, nu = 0.2 } }
  local model = sg.model{
    bodies = { plate = plate }, supports = { axis = { on = plate:face "east", fix = "x" } },
    loads = { top = { on = plate:face "north", pressure = 0 }, side = { on = plate:face "west", pressure = 0 } },
    contacts = { floor = { slave = plate:face "south",
                           master = sg.rigid.plane{ point = { 0, 0 }, normal = { 0, 1 } },
                           penalty = penalty, friction = { mu = 1, penalty = penalty } } },
  }
  return model, { { name = "load", steps = 1, top = 5e7, side = 15e7 } }
end

function scenes.pressed()
  local block = sg.body{ patch = sg.shapes.rectangle{ width = 6, height = 1 }, elements = { 30, 5 },
                         order = "N2-N2.2", contact = "north", material = sg.neo_hookean{ E = 1, nu = 0.45 } }
  local tool = sg.rigid.cylinder{ center = { 3, 3 }, radius = 2 }
  local model = sg.model{
    bodies = { block = block },
    supports = { base = { on = block:face "south", fix = "xy" }, push = { on = tool, drive = "y" } },
    contacts = { touch = { slave = block:face "north", master = tool, friction = { mu = 0.3 } } },
  }
  return model, { { name = "press", steps = 4, push = { -0.1 } }, { name = "unload", steps = 4, push = { 0 } } }
end

function scenes.incompressible()
  local layer = sg.body{ patch = sg.shapes.rectangle{ width = 6, height = 1 }, elements = { 60, 10 },
                         order = "N2-N2.2", contact = "north", volumetric = "projected",
                         grading = { { elements = 0.7, length = 0.17, at = "start" },
                                     { elements = 0.5, length = 0.3, at = "end" } },
                         material = sg.neo_hookean{ E = 1.4999, nu = 0.4999 } }
  local ball = sg.rigid.sphere{ center = { 0, 5 }, radius = 4 }
  local model = sg.model{
    kind = "axisymmetric", bodies = { layer = layer },
    supports = { bed = { on = layer:face "south", fix = "xy" }, axis = { on = layer:face "west", symmetry = true },
                 push = { on = ball, drive = "y" } },
    contacts = { touch = { slave = layer:face "north", master = ball, penalty = 2000 } },
  }
  return model, { { name = "press", steps = 5, push = { -0.1 } } }
end

function scenes.ironing()
  local die = sg.body{ patch = sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = { 0.5, 1.5 } },
                       elements = { 18, 2 }, order = "N2-N2.2", contact = "south",
                       material = sg.neo_hookean{ E = 1000, nu = 0.3 } }
  local slab = sg.body{ patch = sg.shapes.rectangle{ width = 3, height = 1 }, elements = { 24, 6 },
                        order = "N2-N2.2", contact = "north", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  local model = sg.model{
    bodies = { die = die, slab = slab },
    supports = { bed = { on = slab:face "south", fix = "xy" },
                 grip = { on = { die:face "west", die:face "east" }, drive = "xy" } },
    contacts = { interface = { slave = die:face "south", master = slab:face "north", friction = { mu = 0.3 } } },
  }
  return model, { { name = "press", steps = 3, grip = { 0, -0.075 } },
                  { name = "slide", steps = 30, grip = { 2, -0.075 } } }
end

-- ── The table ────────────────────────────────────────────────────────────────────────────────────────────────────────

local columns = { "scene", "control", "iterations", "cuts", "fallbacks", "reason" }
local results = { columns = columns, rows = {} }
for _, scene in ipairs(options.scenes) do
  for _, control in ipairs(options.controls) do
    local model, stages = scenes[scene]()
    local run = model:run(stages, ways[control])
    results.rows[#results.rows + 1] = { scene, control, run.iterations, run.cutbacks, run.fallback_steps, run.reason }
  end
end
print("Iterations by kind and control (robust: the defaults)")
print(sg.table{ columns = columns, rows = results.rows })

local files = sg.files(options.out)
sg.csv.write(files "kinds.csv", results)
files:report()
return { results = results, files = files }
