-- A solid with layers of different degrees, lifted against a rigid sphere: the solved model.

local sg = require "signorini"
local scenes = require "scenes"

return function()
  local ball = sg.rigid.sphere { center = { 1, 1, 3 }, radius = 2 }
  local model = scenes.model{
    bodies = { lower = { size = { 2, 2, 1 }, order = { "N2-N2.2", "N3-N4" }, thickness_degree = 2, contact = "back" } },
    supports = { bed = { on = "front", fix = "xy", drive = "z" } },
    contacts = { touch = { slave = "back", master = ball, penalty = 50, points = 5 } } }
  assert(not model:run({ { name = "lift", steps = 1, bed = { 0.1 } } }).failed)
  return model
end
