-- A pin that is pressed into a bore, which is wider by 1 %: the force. By symmetry half of both.

local sg = require "signorini"
local settings = require "studies.accuracy.settings"

local pin = { name = "pin", title = "Pin in a bore", unit = "N/mm", force = "force" }

function pin.scene(o)
  local n = 1 << (math.tointeger(o.mesh:sub(2)) - 1)
  local function ring(inner, outer, elements, contact, E)
    return sg.body{
      patch = (o.whole and sg.shapes.half_annulus or sg.shapes.quarter_annulus){ inner = inner, outer = outer,
        start = not o.whole and 270 or nil },
      elements = { (o.whole and 2 or 1) * elements * n, 2 * n }, order = o.order, contact = contact,
      thickness_degree = o.thickness_degree, material = sg.neo_hookean{ E = E, nu = 0.3 },
    }
  end
  local plate = ring(1.01, 2, 10, "north", 1)
  local bodies, cut, contact, grip = { plate = plate }, { plate:face "west" }
  if o.rigid then
    contact = { slave = plate:face "north", master = sg.rigid.cylinder{ center = { 0, 0 }, radius = 1 } }
    grip = { on = contact.master, drive = "y" }
  else
    bodies.pin = ring(0.3, 1, 12, "south", 3)
    contact = { slave = bodies.pin:face "south", master = plate:face "north" }
    grip = { on = o.whole and { bodies.pin:face "west", bodies.pin:face "east" } or bodies.pin:face "east", fix = "x",
             drive = "y" }
    cut[2] = bodies.pin:face "west"
  end
  local model = sg.model{
    bodies = bodies, supports = { symmetry = not o.whole and { on = cut, fix = "x" } or nil, grip = grip,
                                  bed = { on = plate:face "south", fix = "xy" } },
    contacts = { joint = settings.contact(o, contact, 100) },
  }
  return model, { { name = "press", steps = settings.steps(o, 8), grip = -0.04 } }, function(run)
    return { force = (o.whole and 1 or 2) * math.abs(run:column "grip.fy"[run.steps]) }
  end
end

pin.reference = { order = "N2-N2.2", setting = "multipliers", mesh = "m4" }
pin.checks = { { order = "N2-N2.2", setting = "multipliers", mesh = "m3" },
               { order = "N2-N2.2", setting = "penalty × 100", mesh = "m4" } }
pin.base = { order = "N2-N2.2", setting = "default", mesh = "m2" }
pin.levers = { "rigid body", "whole model", "m1", "m3", "N2", "N3", "thickness degree 1", "mortar equal", "multipliers",
               "penalty / 10", "penalty × 10", "half the steps" }

return pin
