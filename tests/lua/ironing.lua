-- Ironing in the plane, coarse: a stiff half annulus that is pressed into a soft slab and drawn along it.

local sg = require "signorini"
local lists = require "signorini.call.lists"
local scenes = require "scenes"

--- `o`, all with defaults: E of the die, slab_E, mu (0: no friction), order, penalty, friction_penalty, points (Gauss
--- points of contact), enforcement, elements = { die = {…}, slab = {…} }, further keys of the contact.
return function(o)
  o = o or {}
  local elements, mu = o.elements or { die = {6, 2}, slab = {8, 3} }, o.mu or 0.2
  return scenes.model{
    bodies = { die = { patch = sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = {0.75, 1.5} },
        elements = elements.die, order = o.order or "N2", contact = "south", thickness_degree = 1, E = o.E or 1000 },
      slab = { size = {3, 1}, elements = elements.slab, order = o.order or "N2", contact = "north",
        thickness_degree = 1, E = o.slab_E or 1 } },
    supports = { bed = { on = "slab.south", fix = "xy" }, grip = { on = { "die.west", "die.east" }, drive = "xy" } },
    contacts = { interface = lists.merged({ slave = "die.south", master = "slab.north", penalty = o.penalty or 100,
        points = o.points, enforcement = o.enforcement,
        friction = mu > 0 and { mu = mu, penalty = o.friction_penalty or 100 } or nil }, o.keys) } }
end
