-- 3D ironing with a spherical indenter: meshes, bodies, scene, path.

local sg = require "signorini"
local formulations = require "formulations.rows"

local problem = {}

problem.published_depth = 10.4 -- displacement of the indenter, including the gap before contact
problem.down, problem.along = 0.2, 0.3 -- steps of the published path: 52 down, 250 along
local start, finish = 12.5, 87.5 -- x of the indenter's center on the published path

--- Elements of indenter and slab by mesh; fine halves every element of coarse.
problem.meshes = {
  sparse = { indenter = { 3, 3, 2 }, slab = { 9, 3, 2 } },
  coarse = { indenter = { 5, 5, 3 }, slab = { 18, 6, 4 } },
  middle = { indenter = { 8, 8, 5 }, slab = { 27, 9, 6 } },
  fine   = { indenter = { 10, 10, 6 }, slab = { 36, 12, 8 } },
}
problem.mesh_names = { "sparse", "coarse", "middle", "fine" }

--- A mesh with `fineness` times as many elements in each direction.
local function finer(mesh, fineness)
  local elements = {}
  for body, counts in pairs(mesh) do
    elements[body] = {}
    for i, count in ipairs(counts) do elements[body][i] = math.floor(fineness * count + 0.5) end
  end
  return elements
end

--- Indenter and slab of a case { order, mesh, radius }, the indenter's lowest point touching the slab at x = `center`,
--- y = 15. `fineness` multiplies the elements of the mesh in each direction (1); `layer`: by body, as in sg.body.
--- `cap` is the number of biquadratic elements per direction of which the sphere consists: one, as published, has no
--- inner knots, so that DOFs are those of a block; with more, their knots remain C¹ for any order.
function problem.bodies(case, center)
  local elements = finer(problem.meshes[case.mesh], case.fineness or 1)
  local material = sg.neo_hookean{ E = 1, nu = 0.3 }
  local indenter = sg.body{
    patch    = sg.shapes.spherical_indenter{ width = 10, depth = 10, height = 11, radius = case.radius,
                                             elements = case.cap or 1, corner = { center - 5, 10, 22 } },
    elements = elements.indenter, order = case.order, contact = "front", thickness_degree = 1, material = material,
    layer    = case.layer and case.layer.indenter,
  }
  local slab = sg.body{
    patch    = sg.shapes.block{ size = { 100, 30, 22 } },
    elements = elements.slab, order = case.order, contact = "back", thickness_degree = 1, material = material,
    layer    = case.layer and case.layer.slab,
  }
  return indenter, slab
end

--- Model of a case { order, mesh, radius }, also with `mu`, `penalty` (both penalties, 100), `points` (per direction of
--- a contact element, 3(p + 1)) and `formulation` (a row of formulations/rows.lua), and its two bodies.
function problem.scene(case, center)
  local indenter, slab = problem.bodies(case, center)
  local penalty = case.penalty or 100
  local friction = case.mu and case.mu > 0 and { mu = case.mu, penalty = penalty } or nil
  local model = sg.model{
    bodies   = { indenter = indenter, slab = slab },
    supports = { bed  = { on = slab:face "front", fix = "xyz" },
                 grip = { on = indenter:face "back", drive = "xyz" } },
    contacts = { interface = formulations.contact(case.formulation, {
      slave = indenter:face "front", master = slab:face "back", penalty = penalty, friction = friction,
      points = case.points }) },
  }
  return model, indenter, slab
end

--- The stages of a case: pressed by `depth` in steps of `down`, dragged by `distance` in steps of `along`; both as
--- published unless given.
function problem.stages(case)
  local depth, distance = case.depth, case.distance
  local function count(length, step) return math.max(1, math.floor(length / step + 0.5)) end
  local stages = { { name = "press", steps = count(depth, case.down or problem.down), grip = { 0, 0, -depth } } }
  if distance > 0 then
    stages[2] = { name = "slide", steps = count(distance, case.along or problem.along), grip = { distance, 0, -depth } }
  end
  return stages
end

--- Runs a case { order, mesh, radius, depth, from, distance }, also with what problem.scene takes, `down`, `along`,
--- `controls` (sg.plain), and `step`, `linear`, `adapt` and `on_step(model, info)` as model:run takes them. `from` is
--- the x of the indenter's center while it is pressed. Adds to the case: model, run, dofs of indenter and slab, x (the
--- center's x after every step of the sliding), Px and Pz there (forces of the indenter on the slab), pressed (Pz at
--- full depth).
function problem.solve(case)
  local model, indenter, slab = problem.scene(case, case.from)
  local stages = problem.stages(case)
  local run = model:run(stages, (case.controls or sg.plain){
    linear = case.linear, step = case.step or { adaptive = true }, adapt = case.adapt,
    on_step = case.on_step and function(info) return case.on_step(model, info) end,
  })
  case.model, case.run = model, run
  case.dofs = { indenter = indenter:dofs(), slab = slab:dofs() }
  local fx, fz, ux = run:column "grip.fx", run:column "grip.fz", run:column "grip.ux"
  case.x, case.Px, case.Pz = {}, {}, {}
  for i = stages[1].steps + 1, run.steps do
    table.insert(case.x, case.from + ux[i])
    table.insert(case.Px, fx[i])
    table.insert(case.Pz, -fz[i])
  end
  case.pressed = fz[stages[1].steps] and -fz[stages[1].steps]
  return case
end

--- Where the published path begins, and how long it is.
problem.start, problem.distance = start, finish - start

return problem
