-- Contact patch test: two blocks under uniform pressure, in 2D and 3D.

local sg = require "signorini"
local formulations = require "formulations.rows"

local problem = { load = 0.04, penalty = 100 } -- strains of Hooke's law of small strains: below 5 %

local overlap = 5e-4
problem.materials = { linear = sg.linear_elastic, neo_hooke = sg.neo_hookean }

--- A block as one patch whose inner lines of elements are slanted by up to about half of `skew`, from z (in the plane
--- y) = `from` to `to`; the contact face remains flat.
local function skewed_patch(flat, from, to, skew)
  local points, knots = {}, { 0, 0, 1, 2, 2 }
  for k = 0, 2 do
    local z = from + (to - from) * k / 2
    for j = 0, flat and 0 or 2 do
      for i = 0, 2 do
        local along = i == 1 and skew * (0.3 + k / 4 + j / 3) or 0
        local across = j == 1 and skew * (0.5 - i / 4 - k / 5) or 0
        points[#points + 1] = flat and { i + along, z } or { i + along, j + across, z }
      end
    end
  end
  if flat then return sg.nurbs.surface{ degrees = { 1, 1 }, knots = { knots, knots }, points = points } end
  return sg.nurbs.volume{ degrees = { 1, 1, 1 }, knots = { knots, knots, knots }, points = points }
end

--- A block whose contact face is at the height 0, or `overlap` below it.
local function block(o, side, young)
  local flat, count, lower = o.dimension == 2, o[side], side == "lower"
  local height = lower and -1 or -overlap
  local patch
  if o.skew and o.skew ~= 0 then
    patch = skewed_patch(flat, height, height + 1, lower and o.skew or -o.skew)
  else
    patch = flat and sg.shapes.rectangle{ width = 2, height = 1, corner = { 0, height } } or
            sg.shapes.block{ size = { 2, 2, 1 }, corner = { 0, 0, height } }
  end
  return sg.body{
    patch    = patch, elements = flat and { count, 2 } or { count, count, 2 }, order = o.order,
    contact  = flat and (lower and "north" or "south") or (lower and "back" or "front"), thickness_degree = 1,
    layer    = o.layer and o.layer[side], layer_knots = o.layer_knots and o.layer_knots[side],
    material = problem.materials[o.material or "linear"]{ E = young, nu = o.sides == "free" and 0 or 0.3 },
  }
end

--- The two blocks. `o`: dimension, order, lower and upper (elements along the face of each block), slave ("lower" or
--- "upper"); also layer and layer_knots (by block, as in sg.body), material ("linear"), sides ("guided" or "free"),
--- penalty, points, skew (0), formulation (a row of formulations/rows.lua). Under a given force the upper block is
--- unconstrained until it is in contact. Its initial height does not affect the result, so it is slightly lower and
--- the first iteration finds points in contact.
function problem.scene(o)
  local flat = o.dimension == 2
  local lower, upper = block(o, "lower", 1), block(o, "upper", 2)
  local bottom, top = flat and "south" or "front", flat and "north" or "back"
  local function sides(first, second)
    if o.sides == "free" then return { lower:face(first), upper:face(first) } end
    return { lower:face(first), upper:face(first), lower:face(second), upper:face(second) }
  end
  local slave, master = upper:face(bottom), lower:face(top)
  if o.slave == "lower" then slave, master = master, slave end
  return sg.model{
    bodies   = { lower = lower, upper = upper },
    supports = { bed   = { on = lower:face(bottom), fix = flat and "y" or "z" },
                 ends  = { on = sides("west", "east"), fix = "x" },
                 sides = not flat and { on = sides("south", "north"), fix = "y" } or nil },
    loads    = { push = { on = upper:face(top), pressure = 0 } },
    contacts = { joint = formulations.contact(o.formulation, {
      slave = slave, master = master, penalty = o.penalty or problem.penalty, points = o.points }) },
  }
end

--- The stage that loads the blocks, in two steps, so that linear elasticity meets its own tangent twice.
problem.stage = { name = "press", steps = 2, push = problem.load }

--- The largest difference of the contact pressures of a profile from the uniform one, relative to it.
function problem.pressure_error(profile)
  local largest = 0
  for _, pressure in ipairs(profile.pressure) do
    largest = math.max(largest, math.abs(pressure / problem.load - 1))
  end
  return largest
end

return problem
