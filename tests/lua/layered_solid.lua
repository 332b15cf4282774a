-- A solid with layers of different degrees, lifted against a rigid sphere: the solved model.

local sg = require "signorini"

return function()
  local lower = sg.body { patch = sg.shapes.block { size = { 2, 2, 1 } }, elements = { 2, 2, 2 },
                          order = { "N2-N2.2", "N3-N4" }, thickness_degree = 2, contact = "back",
                          material = sg.neo_hookean { E = 1, nu = 0.3 } }
  local ball = sg.rigid.sphere { center = { 1, 1, 3 }, radius = 2 }
  local model = sg.model {
    bodies = { lower = lower }, supports = { bed = { on = lower:face "front", fix = "xy", drive = "z" } },
    contacts = { touch = { slave = lower:face "back", master = ball, penalty = 50, points = 5 } },
  }
  assert(not model:run({ { name = "lift", steps = 1, bed = { 0.1 } } }).failed)
  return model
end
