-- Ironing in the plane, coarse: a stiff half annulus that is pressed into a soft slab and drawn along it.

local sg = require "signorini"

--- `o`, all with defaults: E of the die, slab_E, mu (0: no friction), order, penalty, points (Gauss points of contact),
--- enforcement, elements = { die = {…}, slab = {…} }.
return function(o)
  o = o or {}
  local elements, mu = o.elements or { die = {6, 2}, slab = {8, 3} }, o.mu or 0.2
  local die = sg.body{ patch = sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = {0.75, 1.5} },
                       elements = elements.die, order = o.order or "N2", contact = "south", thickness_degree = 1,
                       material = sg.neo_hookean{ E = o.E or 1000, nu = 0.3 } }
  local slab = sg.body{ patch = sg.shapes.rectangle{ width = 3, height = 1 }, elements = elements.slab,
                        order = o.order or "N2", contact = "north", thickness_degree = 1,
                        material = sg.neo_hookean{ E = o.slab_E or 1, nu = 0.3 } }
  return sg.model{
    bodies   = { die = die, slab = slab },
    supports = { bed = { on = slab:face "south", fix = "xy" },
                 grip = { on = { die:face "west", die:face "east" }, drive = "xy" } },
    contacts = { interface = { slave = die:face "south", master = slab:face "north", penalty = o.penalty or 100,
                               points = o.points, enforcement = o.enforcement,
                               friction = mu > 0 and { mu = mu, penalty = 100 } or nil } },
  }
end
