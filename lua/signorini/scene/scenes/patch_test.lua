-- The contact patch test: two blocks with meshes that do not match, under a uniform pressure, which the contact has to
-- transmit. R. L. Taylor, P. Papadopoulos, in Nonlinear Computational Mechanics, Springer, 1991.

local sg = require("signorini.core").sg

local overlap = 5e-4 -- The upper block is unconstrained until it is in contact, so it begins slightly lower.
local load, penalty = 0.05, 100

return function(o)
  local flat, n = o.dimension == 2, o.refinement
  local bottom, top = flat and "south" or "front", flat and "north" or "back"
  local function block(count, height, young, contact)
    return sg.body {
      patch = flat and sg.shapes.rectangle { width = 2, height = 1, corner = { 0, height } }
        or sg.shapes.block { size = { 2, 2, 1 }, corner = { 0, 0, height } },
      elements = flat and { count * n, 2 * n } or { count * n, count * n, 2 * n }, order = o.order, contact = contact,
      material = sg.linear_elastic { E = young, nu = 0.3 } }
  end
  local lower, upper = block(3, -1, 1, top), block(4, -overlap, 2, bottom)
  local function both(first, second)
    return { lower:face(first), upper:face(first), lower:face(second), upper:face(second) }
  end
  local model = sg.model {
    bodies = { lower = lower, upper = upper },
    supports = { bed = { on = lower:face(bottom), fix = flat and "y" or "z" },
                 ends = { on = both("west", "east"), fix = "x" },
                 sides = not flat and { on = both("south", "north"), fix = "y" } or nil },
    loads = { push = { on = upper:face(top), pressure = 0 } },
    contacts = { joint = { slave = upper:face(bottom), master = lower:face(top), method = o.method,
                           penalty = penalty } } }
  return model, { { name = "press", steps = 1, push = load } }, { pressure = load }
end
