-- A block that is pressed into a slab and dragged along it in 3D, the half on one side of the plane of symmetry:
-- L. De Lorenzis, P. Wriggers, G. Zavarise, Comput. Mech. 49 (2012), on a coarse mesh.

local friction = require "signorini.scene.scenes.friction"
local sg = require("signorini.core").sg
local steps = require "signorini.scene.scenes.steps"

local down, along = 0.1, 0.25 -- lengths of the steps

return function(o)
  local n = o.refinement
  local function solid(size, corner, elements, contact, young)
    return sg.body {
      patch = sg.shapes.block { size = size, corner = corner }, elements = elements, order = o.order, contact = contact,
      material = sg.neo_hookean { E = young, nu = 0.3 } }
  end
  local slab = solid({ 20, 5, 10 }, { 0, 0, 0 }, { 8 * n, 2 * n, 2 * n }, "back", 1)
  local block = solid({ 4, 2, 4 }, { 1.75, 3, 10 }, { 2 * n, n, n }, "front", 10)
  local model = sg.model {
    bodies = { block = block, slab = slab },
    supports = { bed = { on = slab:face "front", fix = "xyz" },
                 grip = { on = block:face "back", drive = "xz", fix = "y" },
                 mirror = { on = { slab:face "north", block:face "north" }, symmetry = true } },
    contacts = { interface = { slave = block:face "front", master = slab:face "back", penalty = 100,
                               friction = friction(o.mu, 100) } } }
  return model, {
    { name = "press", steps = steps(o.depth, down), grip = { 0, -o.depth } },
    { name = "slide", steps = steps(o.distance, along), grip = { o.distance, -o.depth } },
  }
end
