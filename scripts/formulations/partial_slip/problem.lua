-- Two equal blocks with parabolic faces, pressed together and sheared: scene, path, the solution of Cattaneo and
-- Mindlin.

local sg = require "signorini"
local formulations = require "formulations.rows"

local problem = { young = 1, poisson = 0.3, radius = 1, mu = 0.3, width = 0.3, height = 0.3, half_width = 0.01 }
local approach = 4e-4 -- presses the half-width to 0.98 of `half_width`

--- Distances from 0 to `last`: elements of length h up to `even`, then each `growth` times as long as the one before,
--- slightly stretched to end at `last`.
local function elements(h, even, last, growth)
  local places, length = { 0 }, h
  local count = math.ceil(even / h)
  for i = 1, count do places[i + 1] = i * h end
  while places[#places] < last do
    length = length * growth
    places[#places + 1] = places[#places] + length
  end
  local from = places[count + 1]
  local stretch = (last - from) / (places[#places] - from)
  for i = count + 2, #places do places[i] = from + stretch * (places[i] - from) end
  return places
end

--- A block with the face y = ± x²/(2 R), elements of length h at the contact.
local function block(o, h, sign)
  local w, height = problem.width, problem.height
  -- The parabola as a Bézier curve of x = −w … w: its middle control point is at −w²/(2 R).
  local sag = sign * w ^ 2 / (2 * problem.radius)
  local far = sign * height
  local face, back = { { -w, sag }, { 0, -sag }, { w, sag } }, { { -w, far }, { 0, far }, { w, far } }
  local points = table.move(sign > 0 and back or face, 1, 3, 4, table.move(sign > 0 and face or back, 1, 3, 1, {}))
  local patch = sg.nurbs.surface{ degrees = { 2, 1 }, knots = { { 0, 0, 0, 1, 1, 1 }, { 0, 0, 1, 1 } },
                                  points = points }
  local along, through = {}, {}
  local sides = elements(h, 1.4 * problem.half_width, w, 1.3)
  for i = #sides - 1, 2, -1 do along[#along + 1] = 0.5 - sides[i] / (2 * w) end
  for i = 1, #sides - 1 do along[#along + 1] = 0.5 + sides[i] / (2 * w) end
  local depths = elements(h, h, height, 1.3)
  for i = 2, #depths - 1 do
    local at = depths[i] / height
    through[i - 1] = sign > 0 and at or 1 - at
  end
  table.sort(through)
  patch = patch:insert(1, along):insert(2, through)
  return sg.body{ patch = patch, elements = patch:elements(), order = o.order,
                  contact = sign > 0 and "south" or "north",
                  material = sg.linear_elastic{ E = problem.young, nu = problem.poisson } }
end

--- The scene. `o`: order, count (elements per half-width of the upper face; the lower one has 0.77 times as many),
--- penalty (both, in multiples of E over the length of an element), friction_penalty (the tangential one, if it
--- differs), formulation (a row of formulations/rows.lua), swap (the lower face is the slave).
function problem.scene(o)
  local h = problem.half_width / o.count
  local upper, lower = block(o, h, 1), block(o, 1.3 * h, -1)
  local slave, master = upper:face "south", lower:face "north"
  if o.swap then slave, master = master, slave end
  local penalty = o.penalty * problem.young / h
  return sg.model{
    bodies   = { upper = upper, lower = lower },
    supports = { bed  = { on = lower:face "south", fix = "xy" }, grip = { on = upper:face "north", drive = "xy" } },
    contacts = { joint = formulations.contact(o.formulation, {
      slave = slave, master = master, penalty = penalty,
      friction = { mu = problem.mu, penalty = (o.friction_penalty or o.penalty) * problem.young / h } }) },
  }
end

--- The stages that press the blocks together, and the one that shears them by moving the upper one by `along`.
function problem.pressed(steps) return { name = "press", steps = steps, grip = { 0, -approach } } end
problem.press = problem.pressed(16)
function problem.shear(steps, along)
  return { name = "shear", steps = steps, grip = { along, -approach } }
end

--- Hertz's half-width and peak pressure under the force P per depth (K. L. Johnson, 4.2(c)): for equal bodies
--- a² = 4 P R* (1 − nu²) 2/(pi E) with R* = R/2.
function problem.hertz(force)
  local a = math.sqrt(4 * force * problem.radius * (1 - problem.poisson ^ 2) / (math.pi * problem.young))
  return a, 2 * force / (math.pi * a)
end

--- Share of the half-width that sticks, c/a = √(1 − Q/(mu P)), and the traction over s = x/a in units of mu p0:
--- √(1 − s²) − (c/a) √(1 − (s a/c)²), the second term where |s| < c/a (Johnson, 7.2(d)).
function problem.mindlin(ratio)
  local c = math.sqrt(1 - ratio)
  return c, function(s)
    if math.abs(s) >= 1 then return 0 end
    return math.sqrt(1 - s ^ 2) - (math.abs(s) < c and math.sqrt(c ^ 2 - s ^ 2) or 0)
  end
end

return problem
