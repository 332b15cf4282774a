-- Two half rings that are pressed together, by symmetry a quarter of each: V. Agrawal, thesis, IIT Guwahati, 2020, 6.3.

local friction = require "signorini.scene.scenes.friction"
local sg = require("signorini.core").sg
local steps = require "signorini.scene.scenes.steps"

return function(o)
  local n = o.refinement
  local function ring(inner, outer, from, young, elements, center)
    return sg.body {
      patch = sg.shapes.quarter_annulus { inner = inner, outer = outer, center = center, start = from },
      elements = { elements * n, 3 }, order = o.order, contact = "south",
      material = sg.neo_hookean { E = young, nu = 0.3 } }
  end
  local upper, lower = ring(8, 10, 270, 100, 12, { 0, 22 }), ring(10, 12, 0, 300, 20, { 0, 0 })
  local model = sg.model {
    bodies = { upper = upper, lower = lower },
    supports = { bed = { on = lower:face "west", fix = "xy" },
                 symmetry = { on = { upper:face "west", lower:face "east" }, fix = "x" },
                 grip = { on = upper:face "east", fix = "x", drive = "y" } },
    contacts = { interface = { slave = upper:face "south", master = lower:face "south", penalty = 100,
                               friction = friction(o.mu, 10) } } }
  return model, { { name = "press", steps = steps(o.depth, 0.1), grip = { -o.depth } } }
end
