-- The variants of 2D frictional ironing: parameters, meshes, scene, path.

local sg = require "signorini"
local formulations = require "formulations.rows"

local problem = {}

--- Parameters of a variant: Young's modulus of the die, friction, where the die starts (x of its center), how deep it
--- is pressed in how many steps, how far it is dragged in how many steps.
problem.variants = {
  standard = {
    die_modulus = 1e3, mu = 0.2, start = 0.75, depth = 0.23, press_steps = 46, distance = 1.5, slide_steps = 250,
  },
  deep = {
    die_modulus = 1e4, mu = 0.1, start = 0.75, depth = 0.5, press_steps = 46, distance = 1.5, slide_steps = 250,
  },
  validation = {
    die_modulus = 1e3, mu = 0.3, start = 0.5, depth = 0.075, press_steps = 10, distance = 2, slide_steps = 200,
  },
}

--- Elements of die and slab by mesh: m1 to m6, each of which halves every element of the one before (Table 7.1), or the
--- number of elements along both faces in the proportions of section 6.2, where 48 means 48 × 8 and 48 × 24; nothing
--- if the name is not a mesh.
function problem.elements(mesh)
  local level = math.tointeger(mesh:match "^m([1-6])$")
  if level then
    local halvings = 1 << (level - 1)
    return { die = { 6 * halvings, 2 * halvings }, slab = { 8 * halvings, 3 * halvings } }
  end
  local number = math.tointeger(tonumber(mesh))
  if not number or number < 6 or number % 6 ~= 0 then return nil end
  return { die = { number, number // 6 }, slab = { number, number // 2 } }
end

--- A script's argument that names one mesh, or a list of them, as sg.arguments takes it.
function problem.meshes(default)
  return { default, check = problem.elements,
           expected = "m1 to m6, or a multiple of 6 as the elements along both faces" }
end

--- Degree of the functions on the contact face: that of the order's last part, N2-N2.1x2 has 2 + 1.
function problem.layer_degree(order)
  local degree, elevations = order:match "[^-]*$":match "^%a(%d+)%.?(%d*)"
  if not degree then error(("order '%s' has no degree on the contact face"):format(order), 0) end
  return math.tointeger(degree) + (math.tointeger(elevations) or 0)
end

--- The stages of a variant, with steps `coarser` times as long.
function problem.path(set_up, coarser)
  return {
    { name = "press", steps = math.ceil(set_up.press_steps / coarser), grip = { 0, -set_up.depth } },
    { name = "slide", steps = math.ceil(set_up.slide_steps / coarser), grip = { set_up.distance, -set_up.depth } },
  }
end

--- Model, die and slab of a variant; `elements`: { die, slab, grading (of the slab) }; `points`: Gauss points of a
--- contact element, 3(p + 1) by default; thickness_degree: 1 by default, as published; `details`: { formulation (a row
--- of formulations/rows.lua), swap (the slab is the slave), die_order, slab_degree (in the thickness direction) }.
function problem.scene(set_up, order, elements, points, thickness_degree, details)
  details = details or {}
  local die = sg.body{
    patch    = sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = { set_up.start, 1.5 } },
    elements = elements.die, order = details.die_order or order, contact = "south",
    thickness_degree = thickness_degree or 1,
    material = sg.neo_hookean{ E = set_up.die_modulus, nu = 0.3 },
  }
  local slab = sg.body{
    patch    = sg.shapes.rectangle{ width = 3, height = 1 },
    elements = elements.slab, grading = elements.grading, order = order, contact = "north",
    thickness_degree = details.slab_degree or thickness_degree or 1,
    material = sg.neo_hookean{ E = 1, nu = 0.3 },
  }
  local slave, master = die:face "south", slab:face "north"
  if details.swap then slave, master = master, slave end
  local model = sg.model{
    bodies   = { die = die, slab = slab },
    supports = { bed  = { on = slab:face "south", fix = "xy" },
                 grip = { on = {die:face "west", die:face "east"}, drive = "xy" } },
    contacts = { interface = formulations.contact(details.formulation, {
      slave = slave, master = master, penalty = 100, friction = { mu = set_up.mu, penalty = 100 },
      points = points }) },
  }
  return model, die, slab
end

--- Runs one case { set_up, order, mesh }, also with `points`, `thickness_degree`, `formulation`, `swap`, `coarser`
--- (steps that many times as long), `stages` (instead of the variant's), `controls` (sg.plain), and `step`, `linear`
--- and `on_step(model, info)` as model:run takes them. Returns { order, mesh, run, model, die_dofs, slab_dofs }.
function problem.solve(case)
  local set_up = case.set_up
  local model, die, slab = problem.scene(set_up, case.order, problem.elements(case.mesh), case.points,
    case.thickness_degree, case)
  local options = { linear = case.linear, step = case.step,
                    on_step = case.on_step and function(info) return case.on_step(model, info) end }
  local run = model:run(case.stages or problem.path(set_up, case.coarser or 1),
    (case.controls or sg.plain)(options))
  return { order = case.order, mesh = case.mesh, run = run, model = model,
           die_dofs = die:dofs(), slab_dofs = slab:dofs() }
end

return problem
