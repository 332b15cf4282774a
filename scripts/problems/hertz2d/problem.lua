-- A hollow cylinder on a rigid plane: scene, path, and Hertz's closed form.

local sg = require "signorini"
local formulations = require "formulations.rows"

local problem = {
  inner = 0.1, outer = 1, young = 1, poisson = 0.3,
  half_load = 1e-3, push_down = 0.00463,
  penalties = { force = 1000, displacement = 2000 },
}

--- The ring on its plane. `o`: order, mesh, load; for the study of the size also size, the multiple of R/a (the load
--- falls with its square; there are as many elements per half-width near the contact and beyond), stiffer, the
--- multiple of the penalty, and thickness_degree; penalty and poisson (Poisson's ratio), if not the published ones;
--- volumetric, layer and layer_knots as in sg.body; formulation, a row of formulations/rows.lua. Returns the model,
--- the stage (without steps) that presses it, and the ring.
function problem.scene(o)
  local refined, size = 1 << (math.tointeger(o.mesh:sub(2)) - 1), o.size or 1
  -- 0.8 N elements in the part 0.1/size of the length, 0.2 N size in the rest: twice the size, twice the elements there
  local growth = 0.8 + 0.2 * size
  local graded = { elements = 0.8 / growth, length = 0.1 / size, at = "start" }
  local ring = sg.body{
    patch    = sg.shapes.quarter_annulus{ inner = problem.inner, outer = problem.outer, start = 270 },
    elements = { math.floor(9 * refined * growth + 0.5), math.floor(48 * growth + 0.5) }, grading = { graded, graded },
    order = o.order, contact = "south", thickness_degree = o.thickness_degree or 1,
    volumetric = o.volumetric, layer = o.layer, layer_knots = o.layer_knots,
    material = sg.linear_elastic{ E = problem.young, nu = o.poisson or problem.poisson },
  }
  local force, cut = o.load == "force", ring:face "east"
  -- Under a given force the ring is unconstrained until it is in contact. The height of the plane does not affect the
  -- result, so the plane is slightly higher and the first iteration finds points in contact.
  local height = force and -problem.outer + 1e-4 / size ^ 2 or -problem.outer
  local model = sg.model{
    bodies   = { ring = ring },
    supports = { symmetry = { on = ring:face "west", fix = "x" },
                 grip     = not force and { on = cut, drive = "y" } or nil },
    loads    = { push = force and { on = cut, traction = {0, 0} } or nil },
    contacts = { ground = formulations.contact(o.formulation, {
      slave = ring:face "south", master = sg.rigid.plane{ point = {0, height}, normal = {0, 1} },
      penalty = (o.penalty or problem.penalties[o.load]) * size * (o.stiffer or 1) }, o.penalty) },
  }
  local stage = { name = "press" }
  if force then
    stage.push = { 0, -problem.half_load / (problem.outer - problem.inner) / size ^ 2 }
  else
    stage.grip = { -problem.push_down / size ^ 2 }
  end
  return model, stage, ring
end

--- Half-width and peak pressure of Hertz's line contact under a load p per depth on the whole cylinder; Poisson's
--- ratio, if not the published one.
function problem.hertz(p, poisson)
  local a = math.sqrt(4 * p * problem.outer * (1 - (poisson or problem.poisson) ^ 2) / (math.pi * problem.young))
  return a, 2 * p / (math.pi * a)
end

return problem
