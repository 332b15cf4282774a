-- A pin that wears as a disc slides below it: a cylinder in the plane, and a sphere.
--
-- Problem: an elastic pin with a round end, E = 1e5 MPa, nu = 0.3, R = 10 mm, 2 mm wide, is pressed by a constant force
--          onto a rigid disc, here a plane, that slides below it without friction. Half of the cylinder and a quarter
--          of the sphere are modeled, since nothing distinguishes the direction of sliding. Parabolas replace circles.
-- Source: J. F. Archard, J. Appl. Phys. 24 (1953): the volume worn off is k F s. The flat scar of half width a that
--         takes it from a parabola is a^3 = 3 R k F s/2 per thickness of a cylinder, a^4 = 4 R k F s/pi of a sphere,
--         once a is large compared with that of Hertz's contact.
-- Units: mm, N, MPa.
-- Expected: a within 0.5 % of the closed forms at the end, by the depth w = a^2/(2 R) of the scar. By the contact area
--           it is up to half a distance of contact points less, since the gap is zero all over the scar. The volume is
--           a percent below k F s, the less the more steps: points that touch during a step wear for its rest.
-- Run: signorini objects/worn_pin.lua [elements=32] [solid=12] [order=N2] [force=2] [scar=1.2] [steps=40]
--      [out=out/worn_pin]

local sg = require "signorini"

local options = sg.arguments{ elements = { 32, at_least = 8 }, solid = { 12, at_least = 4 }, order = "N2",
                              force = { 2, above = 0 }, scar = { 1.2, above = 0.5, at_most = 1.8 },
                              steps = { 40, at_least = 4 }, out = "out/worn_pin" }
local files = sg.files(options.out)
local R, width, E, travel = 10, 2, 1e5, 1000

-- The square of a coordinate from 0 to `width`, as coefficients of a quadratic Bézier curve.
local square = { 0, 0, width ^ 2 }

--- A block whose bottom is z = (x² + y²)/(2 R), in the plane without y.
local function pin(solid)
  local bottom, top = {}, {}
  for j = 1, solid and 3 or 1 do
    for i = 1, 3 do
      local z = (square[i] + (solid and square[j] or 0)) / (2 * R)
      local x, y = (i - 1) * width / 2, (j - 1) * width / 2
      table.insert(bottom, solid and { x, y, z } or { x, z })
      table.insert(top, solid and { x, y, width } or { x, width })
    end
  end
  local one = { 0, 0, 0, 1, 1, 1 }
  local function face(points)
    if solid then return sg.nurbs.surface{ degrees = {2, 2}, knots = { one, one }, points = points } end
    return sg.nurbs.curve{ degree = 2, knots = one, points = points }
  end
  return sg.nurbs.ruled{ a = face(bottom), b = face(top) }
end

--- The half width of a scar from its depth where it is deepest.
local function half_width(model, solid)
  local profile = model:profile "scar"
  local w, r2 = 0, 0
  for i, depth in ipairs(profile.worn) do
    if depth > w then w, r2 = depth, profile.X[i] ^ 2 + (solid and profile.Y[i] ^ 2 or 0) end
  end
  return math.sqrt(2 * R * w + r2)
end

--- Slides the disc below a pin until the scar should have the given half width.
local function worn(solid, elements, scar)
  local area = solid and width ^ 2 or width -- of the half or quarter that is modeled
  local force = options.force * (solid and 1 / 4 or 1 / 2)
  local volume = solid and math.pi * scar ^ 4 / (4 * R) or 2 * scar ^ 3 / (3 * R)
  local rate = volume / (options.force * travel)
  local across = elements // 2
  local body = sg.body{ patch = pin(solid), order = options.order, contact = solid and "front" or "south",
                        elements = solid and { elements, elements, across } or { elements, across },
                        material = sg.linear_elastic{ E = E, nu = 0.3 } }
  local disc = sg.rigid.plane{ point = solid and {0, 0, 0} or {0, 0}, normal = solid and {0, 0, 1} or {0, 1} }
  local top = body:face(solid and "back" or "north")
  local model = sg.model{
    bodies = { pin = body },
    supports = { middle = { on = body:face "west", symmetry = true },
                 across = solid and { on = body:face "south", symmetry = true } or nil,
                 disc = { on = disc, drive = "x" } },
    loads = { weight = { on = top, traction = solid and {0, 0, 0} or {0, 0} } },
    contacts = { scar = { slave = body:face(solid and "front" or "south"), master = disc, wear = { rate = rate } } },
  }
  local widths = {}
  local run = model:run({ { name = "press", steps = 1, weight = solid and {0, 0, -force / area} or {0, -force / area} },
                          { name = "slide", steps = options.steps, disc = travel } },
                        { on_step = function() widths[#widths + 1] = half_width(model, solid) end })
  if run.failed then error(run.failure, 0) end
  return model, run, rate, widths
end

local curves, rows, pictures = {}, {}, {}
for i, solid in ipairs{ false, true } do
  local model, run, rate, a = worn(solid, solid and options.solid or options.elements, options.scar)
  local s, area, volume, exact = run:column "disc.ux", run:column "scar.area", run:column "scar.worn_volume", {}
  local share = solid and 4 or 2
  for row = 1, #s do
    local lost = rate * options.force * s[row]
    exact[row] = solid and (4 * R * lost / math.pi) ^ (1 / 4) or (3 * R * lost / 2) ^ (1 / 3)
  end
  local name, last = solid and "sphere" or "cylinder", #s
  rows[i] = { name, exact[last], a[last], 100 * (a[last] / exact[last] - 1),
              solid and math.sqrt(share * area[last] / math.pi) or area[last],
              100 * (share * volume[last] / (rate * options.force * s[last]) - 1) }
  curves[2 * i - 1] = { x = s, y = exact, label = name .. ", closed form", markers = false, color = i }
  curves[2 * i] = { x = s, y = a, label = name, markers = true, line = false, color = i }
  pictures[i] = sg.picture{ model = model, field = "von_mises", label = "von Mises stress (MPa)",
                            axes = { "x (mm)", solid and "y (mm)" or "z (mm)", solid and "z (mm)" or nil },
                            title = ("Worn %s"):format(name) }
end
print(sg.table{ columns = { "pin", "half width, closed form", "by depth", "difference", "by area", "volume - k F s" },
                units = { "", "mm", "mm", "%", "mm", "%" },
                formats = { "%s", "%.4f", "%.4f", "%+.2f", "%.4f", "%+.2f" }, rows = rows })
curves.file, curves.title = files "scar.png", "Wear of a pin on a sliding disc"
curves.xlabel, curves.ylabel = "way of sliding (mm)", "half width of the scar (mm)"
sg.chart(curves)
sg.sheet{ pictures, file = files "states.png" }
files:report()

return { rows = rows }
