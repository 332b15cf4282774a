-- Ironing in the plane (ironing2d.lua) up to the end of the window in which forces are measured: one element of m1 in
-- the middle of the slab.

local sg = require "signorini"
local force = require "studies.accuracy.force"
local problem = require "problems.ironing2d.problem"
local settings = require "studies.accuracy.settings"

local press, slide, window = 46, 119, 64 / 119 -- steps; the window begins at this part of the slide

local ironing = {
  name = "ironing", title = "Ironing with friction", unit = "N/mm",
  force = "drag", second = { "oscillation", "oscillation of the drag (% of its mean)" },
}

function ironing.scene(o)
  local elements, set_up = problem.elements(o.mesh), problem.variants.standard
  local slab = sg.body{
    patch = sg.shapes.rectangle{ width = 3, height = 1 }, elements = elements.slab, order = o.order, contact = "north",
    thickness_degree = o.thickness_degree, material = sg.neo_hookean{ E = 1, nu = 0.3 },
    -- where the die touches from the first step to the last
    layer = o.place and { 0.12, 0.62 }, layer_knots = o.knots,
  }
  local bodies, grip, slave, master = { slab = slab }
  if o.rigid then
    slave, master = slab:face "north", sg.rigid.cylinder{ center = { set_up.start, 1.5 }, radius = 0.5 }
    grip = { on = master, drive = "xy" }
  else
    bodies.die = sg.body{
      patch = sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = { set_up.start, 1.5 } },
      elements = elements.die, order = o.order, contact = "south", thickness_degree = o.thickness_degree,
      layer = o.place and { 0.2, 0.8 }, layer_knots = o.knots,
      material = sg.neo_hookean{ E = set_up.die_modulus, nu = 0.3 },
    }
    slave, master = bodies.die:face "south", slab:face "north"
    grip = { on = { bodies.die:face "west", bodies.die:face "east" }, drive = "xy" }
  end
  local model = sg.model{
    bodies = bodies, supports = { bed = { on = slab:face "south", fix = "xy" }, grip = grip },
    contacts = { interface = settings.contact(o, { slave = slave, master = master, mu = set_up.mu }, 100) },
  }
  local path = {
    { name = "press", steps = settings.steps(o, press), grip = { 0, -set_up.depth } },
    { name = "slide", steps = settings.steps(o, slide),
      grip = { set_up.distance / set_up.slide_steps * slide, -set_up.depth } },
  }
  return model, path, function(run)
    local drag, oscillation = force.mean_and_oscillation(force.window(run, "grip.fx", window))
    local down, shaking = force.mean_and_oscillation(force.window(run, "grip.fy", window))
    return { force = drag, oscillation = 100 * oscillation / math.abs(drag), pressing = -down,
             pressing_oscillation = 100 * shaking / math.abs(down) }
  end
end

ironing.meshes = { "m1", "m2", "m3" }
ironing.series = {
  { "default", "L1", "L2", "N2", "N3", "N2-N2.1", "N2-N2.2" }, { "published", "N2", "N2-N2.2" },
  { "thickness degree 1", "N2-N2.2" }, { "mortar equal", "N2-N2.2" }, { "mortar reduced", "N2-N2.1" },
  { "multipliers", "N2", "N2-N2.2" }, { "penalty × 10", "N2" }, { "local layer", "N2-N2.1" }, { "layer knots", "N2" },
}
ironing.reference = { order = "N2-N2.2", setting = "multipliers", mesh = "m4" }
ironing.checks = { { order = "N2-N2.2", setting = "multipliers", mesh = "m3" },
                   { order = "N2-N2.2", setting = "penalty × 100", mesh = "m4" } }
ironing.base = { order = "N2-N2.2", setting = "default", mesh = "m2" }
ironing.levers = { "rigid body", "m1", "m3", "N2", "N3", "N2-N2.1", "local layer", "thickness degree 1", "mortar equal",
                   "multipliers", "penalty / 10", "penalty × 10", "half the steps" }

return ironing
