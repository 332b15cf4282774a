-- A half disc, x >= 0, of six patches without singular points: two halves of a core, and four around them, whose first
-- direction runs along the circle from its lowest to its highest point and whose second one leads to the core.

local sg = require "signorini"

--- The patches, with `along` elements on each eighth of the circle, denser at its lowest point, and `depth` from the
--- circle to the core. Named by index: 1 to 4 from below, 5 and 6 the lower and the upper half of the core.
return function(radius, center, along, depth)
  local c, x0, y0 = 0.4 * radius, center[1], center[2]
  local corners = { { 0, -c }, { c, -c }, { c, 0 }, { c, c }, { 0, c } }
  local function knots(count, power, reversed)
    local list = {}
    for i = 1, count - 1 do list[i] = reversed and 1 - (1 - i / count) ^ power or (i / count) ^ power end
    return list
  end
  local patches = {}
  for i = 1, 4 do
    local function corner(k) return { x0 + corners[k][1], y0 + corners[k][2] } end
    local arc = sg.nurbs.arc{ radius = radius, center = center, from = 225 + 45 * i, to = 270 + 45 * i }
    patches[i] = sg.nurbs.ruled{ a = arc, b = sg.nurbs.line{ from = corner(i), to = corner(i + 1) } }
      :elevate(2):insert(1, knots(along, i == 1 and 1.5 or i == 4 and 1.5 or 1, i == 4)):insert(2, knots(depth, 1.5))
  end
  for i = 5, 6 do
    patches[i] = sg.shapes.rectangle{ width = c, height = c, corner = { x0, y0 + (i - 6) * c } }
      :elevate(1):elevate(2):insert(1, knots(along, 1.5)):insert(2, knots(along, 1))
  end
  local elements = {}
  for i, patch in ipairs(patches) do elements[i] = patch:elements() end
  return patches, elements
end
