-- A cylinder (plane strain) or a ball (axisymmetric) on a rigid plane under a given force, and Hertz's closed forms:
-- K. L. Johnson, Contact Mechanics, Cambridge, 1985, sections 4.2(c) and 4.2(a).

local sg = require("signorini.core").sg

local outer, young, poisson = 1, 1, 0.3
local above = 1e-4 -- The unconstrained body begins in contact: the plane is so much higher than the lowest point.

--- Half-width (radius) a and peak pressure p0 of a cylinder under a force per depth, and of a ball.
local closed_forms = {
  cylinder = function(load)
    local a = math.sqrt(load) * math.sqrt(4 * outer * (1 - poisson ^ 2) / (math.pi * young)) -- of any finite load
    return { a = a, p0 = 2 / math.pi * (load / a), load = load }
  end,
  ball = function(load)
    local a = load ^ (1 / 3) * (3 * outer * (1 - poisson ^ 2) / (4 * young)) ^ (1 / 3)
    return { a = a, p0 = 3 / (2 * math.pi) * (load / a / a), load = load }
  end,
}

return function(o)
  local is_ball, n = o.body == "ball", o.refinement
  local inner = is_ball and 0.2 or 0.1
  -- four fifths of the elements lie in the tenth of the length next to the contact, of the ball three quarters
  local graded = { elements = is_ball and 0.75 or 0.8, length = 0.1, at = "start" }
  local body = sg.body {
    patch = sg.shapes.quarter_annulus { inner = inner, outer = outer, start = 270 },
    elements = is_ball and { 16 * n, 16 * n } or { 18 * n, 48 }, grading = { graded, graded },
    order = o.order, contact = "south", material = sg.linear_elastic { E = young, nu = poisson } }
  local model = sg.model {
    kind = is_ball and "axisymmetric" or "plane_strain",
    bodies = { [o.body] = body },
    supports = { symmetry = { on = body:face "west", fix = "x" } },
    loads = { push = { on = body:face "east", traction = { 0, 0 } } },
    contacts = { ground = { slave = body:face "south", penalty = 1000,
                            master = sg.rigid.plane { point = { 0, above - outer }, normal = { 0, 1 } } } } }
  local area = is_ball and math.pi * (outer ^ 2 - inner ^ 2) or 2 * (outer - inner) -- of the whole cut
  return model, { { name = "press", steps = 2, push = { 0, -o.load / area } } }, closed_forms[o.body](o.load)
end
