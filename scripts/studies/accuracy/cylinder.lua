-- Ironing in space with friction: a stiff half pipe across a slab of the same width, with free sides, is pressed into
-- it and slides over the length of two elements of m1. By symmetry half of both; the plane model has the same width.

local sg = require "signorini"
local force = require "studies.accuracy.force"
local settings = require "studies.accuracy.settings"

local slide = 1.5 / 4

local cylinder = {
  name = "cylinder", title = "Ironing in 3D", unit = "N", force = "drag",
  second = { "oscillation", "oscillation of the drag (% of its mean)" },
}

function cylinder.scene(o)
  local n = math.tointeger(o.mesh:sub(2))
  local soft, stiff = sg.neo_hookean{ E = 1, nu = 0.3 }, sg.neo_hookean{ E = 100, nu = 0.3 }
  local half = o.whole and 1 or 2 -- elements and sizes across are divided by it
  local function body(plane, solid, elements, across, contact, material)
    local counts = { elements[1] * n, across * 2 // half * n, elements[2] * n }
    return sg.body{ patch = o.plane and plane or solid, elements = o.plane and { counts[1], counts[3] } or counts,
                    order = o.order, contact = contact, thickness_degree = o.thickness_degree, material = material }
  end
  local below, above = o.plane and "south" or "front", o.plane and "north" or "back"
  local slab = body(sg.shapes.rectangle{ width = 1.5, height = 0.6 },
    sg.shapes.block{ size = { 1.5, 1 / half, 0.6 } }, { 8, 3 }, 2, above, soft)
  local contact, bodies = { master = slab:face(above), mu = 0.2 }, { slab = slab }
  local mirror, grip = { slab:face "north" }
  if o.rigid then
    contact.slave, contact.master = slab:face(above), sg.rigid.cylinder{
      center = o.plane and { 0.56, 1.1 } or { 0.56, 0, 1.1 }, axis = not o.plane and { 0, 1, 0 } or nil, radius = 0.5 }
    grip = { on = contact.master, drive = o.plane and "xy" or "xz" }
  else
    bodies.die = body(sg.shapes.half_annulus{ inner = 0.4, outer = 0.5, center = { 0.56, 1.1 } },
      sg.shapes.half_cylinder_shell{ inner = 0.4, outer = 0.5, width = 1 / half, center = { 0.56, 0, 1.1 } },
      { 6, 1 }, 2, below, stiff)
    contact.slave = bodies.die:face(below)
    mirror[2] = bodies.die:face "north"
    grip = { on = { bodies.die:face "west", bodies.die:face "east" }, drive = o.plane and "xy" or "xz",
             fix = not o.plane and "y" or nil }
  end
  local model = sg.model{
    bodies   = bodies,
    supports = { bed = { on = slab:face(o.plane and "south" or "front"), fix = o.plane and "xy" or "xyz" }, grip = grip,
                 mirror = half == 2 and not o.plane and { on = mirror, symmetry = true } or nil },
    contacts = { interface = settings.contact(o, contact, 60) },
  }
  local path = { { name = "press", steps = settings.steps(o, 4), grip = { 0, -0.1 } },
                 { name = "slide", steps = settings.steps(o, 24), grip = { slide, -0.1 } } }
  local scale = o.plane and 1 or half -- force of the whole width
  return model, path, function(run)
    local drag, oscillation = force.mean_and_oscillation(force.window(run, "grip.fx", 0.5))
    return { force = scale * drag, oscillation = 100 * oscillation / math.abs(drag) }
  end
end

cylinder.reference = { order = "N2-N2.1", setting = "multipliers", mesh = "m2" }
cylinder.checks = { { order = "N2", setting = "multipliers", mesh = "m2" },
                    { order = "N2-N2.1", setting = "multipliers", mesh = "m1" } }
cylinder.base = { order = "N2-N2.1", setting = "default", mesh = "m1" }
cylinder.levers = { "plane model", "whole model", "rigid body", "N2", "N3", "N2-N2.2", "thickness degree 1",
                    "mortar equal", "multipliers", "penalty / 10", "penalty × 10", "half the steps" }

return cylinder
