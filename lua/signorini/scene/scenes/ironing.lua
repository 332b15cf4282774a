-- A half ring that is pressed into a soft slab and dragged along it: V. Agrawal, thesis, IIT Guwahati, 2020, 7.1.

local friction = require "signorini.scene.scenes.friction"
local sg = require("signorini.core").sg
local steps = require "signorini.scene.scenes.steps"

local down, along = 0.005, 0.006 -- lengths of the steps

return function(o)
  local n = o.refinement
  local die = sg.body {
    patch = sg.shapes.half_annulus { inner = 0.3, outer = 0.5, center = { 0.75, 1.5 } }, elements = { 6 * n, 2 * n },
    order = o.order, contact = "south", material = sg.neo_hookean { E = 1000, nu = 0.3 } }
  local slab = sg.body {
    patch = sg.shapes.rectangle { width = 3, height = 1 }, elements = { 8 * n, 3 * n },
    order = o.order, contact = "north", material = sg.neo_hookean { E = 1, nu = 0.3 } }
  local model = sg.model {
    bodies = { die = die, slab = slab },
    supports = { bed = { on = slab:face "south", fix = "xy" },
                 grip = { on = { die:face "west", die:face "east" }, drive = "xy" } },
    contacts = { interface = { slave = die:face "south", master = slab:face "north", penalty = 100,
                               friction = friction(o.mu, 100) } } }
  return model, {
    { name = "press", steps = steps(o.depth, down), grip = { 0, -o.depth } },
    { name = "slide", steps = steps(o.distance, along), grip = { o.distance, -o.depth } },
  }
end
