-- A hollow sphere on a rigid plane as an axisymmetric model: scene, path, and Hertz's closed form.

local sg = require "signorini"
local formulations = require "formulations.rows"

local problem = { inner = 0.2, outer = 1, young = 1, poisson = 0.3, load = math.pi * 1e-4, penalty = 1000 }

--- The sphere on its plane. `o`: order, mesh; for the study of the size also size, the multiple of R/a (the load falls
--- with its cube; there are as many elements per half-width near the contact and beyond), stiffer, the multiple of the
--- penalty, and thickness_degree; layer and layer_knots as in sg.body; penalty, if not the usual one; formulation, a
--- row of formulations/rows.lua. Returns the model, the stage (without steps) that presses it, and the sphere.
function problem.scene(o)
  local size = o.size or 1
  -- 0.75 n elements in the part 0.1/size of the length, 0.25 n size in the rest: twice the size, twice as many there
  local growth = 0.75 + 0.25 * size
  local count = math.floor(8 * (1 << (math.tointeger(o.mesh:sub(2)) - 1)) * growth + 0.5)
  local graded = { elements = 0.75 / growth, length = 0.1 / size, at = "start" }
  local ball = sg.body{
    patch    = sg.shapes.quarter_annulus{ inner = problem.inner, outer = problem.outer, start = 270 },
    elements = { count, count }, grading = { graded, graded }, order = o.order, contact = "south",
    thickness_degree = o.thickness_degree or 1, layer = o.layer, layer_knots = o.layer_knots,
    material = sg.linear_elastic{ E = problem.young, nu = problem.poisson },
  }
  -- Under a given force the body is unconstrained until it is in contact. The height of the plane does not affect the
  -- result, so the plane is slightly higher and the first iteration finds points in contact.
  local height = -problem.outer + 1e-4 / size ^ 2
  local model = sg.model{
    kind     = "axisymmetric",
    bodies   = { ball = ball },
    supports = { axis = { on = ball:face "west", fix = "x" } },
    loads    = { push = { on = ball:face "east", traction = {0, 0} } },
    contacts = { ground = formulations.contact(o.formulation, {
      slave = ball:face "south", master = sg.rigid.plane{ point = {0, height}, normal = {0, 1} },
      penalty = (o.penalty or problem.penalty) * size * (o.stiffer or 1) }, o.penalty) },
  }
  local traction = -problem.load / (math.pi * (problem.outer ^ 2 - problem.inner ^ 2)) / size ^ 3
  return model, { name = "press", push = { 0, traction } }, ball
end

--- Radius of contact and peak pressure of Hertz's point contact under a load p.
function problem.hertz(p)
  local a = (3 * p * problem.outer * (1 - problem.poisson ^ 2) / (4 * problem.young)) ^ (1 / 3)
  return a, 3 * p / (2 * math.pi * a ^ 2)
end

return problem
