-- Timings: Newton iterations of ironing in 2D and 3D, files of a state, an element's tangent.

local sg = require "signorini"
local plane = require "problems.ironing2d.problem"
local solid = require "problems.ironing3d.problem"

local measure = {}

--- By dimension: the meshes in increasing order, the field that is drawn, and begin(order, mesh, steps), which returns
--- a model, its bodies, the stage that is not timed and the one that is.
measure.problems = {
  plane = {
    name = "2D ironing", meshes = { "m1", "m2", "m3", "m4", "m5", "m6" }, field = "uy",
    begin = function(order, mesh, steps)
      local set_up = plane.variants.standard
      local model, die, slab = plane.scene(set_up, order, plane.elements(mesh))
      return model, { die, slab }, { name = "press", steps = 10, grip = { 0, -0.05 } },
        { name = "slide", steps = steps, grip = { 0.006 * steps, -0.05 } }
    end,
  },
  solid = {
    name = "3D ironing", meshes = { "sparse", "coarse", "middle", "fine", "finest" }, field = "uz",
    begin = function(order, mesh, steps)
      local finest = mesh == "finest" -- 62,058 unknowns with N2
      local model, indenter, slab = solid.scene({ order = order, mesh = finest and "coarse" or mesh,
                                                  fineness = finest and 3.25 or 1, radius = 7.5 }, 50)
      return model, { indenter, slab }, { name = "press", steps = 4, grip = { 0, 0, -1 } },
        { name = "slide", steps = steps, grip = { 0.3 * steps, 0, -1 } }
    end,
  },
}

--- Parts of an iteration's time; search is part of contact, factorization and solution make up linear.
measure.accounts = { "bulk", "contact", "search", "linear", "factorization", "solution", "rest", "iteration" }
--- Megabytes: all of the model and the factors.
measure.sizes = { "memory" }
--- Files that a state is written to.
measure.outputs = { "picture", "csv", "checkpoint" }

--- Milliseconds that body() takes, and its result.
local function milliseconds(body)
  local began = sg.wall_time()
  local result = body()
  return 1e3 * (sg.wall_time() - began), result
end

local function finished(run)
  if run.failed then error(run.failure, 0) end
  return run
end

--- Milliseconds to write a state's picture, contact profile and checkpoint, by name.
local function write(model, field, folder)
  return {
    picture = milliseconds(function()
      sg.picture{ model = model, field = field, file = folder .. "/state.png", size = { 800, 500 } }
    end),
    csv = milliseconds(function() sg.csv.write(folder .. "/state.csv", model:profile "interface") end),
    checkpoint = milliseconds(function() model:save(folder .. "/state.sgn") end),
  }
end

--- One pass over a case: milliseconds per iteration by account, and per file, with the sizes.
local function pass(problem, case, options)
  collectgarbage() -- Lua does not count the memory of models
  local model, bodies, press, slide = problem.begin(case.order, case.mesh, options.steps)
  local how = sg.plain{ linear = options.linear, step = { adaptive = true } }
  finished(model:run({ press }, how))
  model:time_search(true)
  local before = model:timings()
  local wall, run = milliseconds(function() return finished(model:run({ slide }, how)) end)
  local spent, after = {}, model:timings()
  for account, seconds in pairs(after) do spent[account] = 1e3 * (seconds - before[account]) / run.iterations end
  spent.iteration = wall / run.iterations
  spent.rest = spent.iteration - spent.bulk - spent.contact - spent.linear
  for name, time in pairs(write(model, problem.field, options.out)) do spent[name] = time end
  local solver = model:solver()
  case.dofs, case.unknowns, case.iterations = 0, solver.unknowns, run.iterations
  case.memory = (solver.memory + solver.factor_memory) / 1e6
  for _, body in ipairs(bodies) do case.dofs = case.dofs + body:dofs().total end
  return spent
end

--- A case { problem (name), order, mesh }, to which milliseconds are added by name: per iteration those of the pass
--- with the median iteration of `options.repeats`, so that accounts add up, and per file medians of all passes. Options
--- also have linear, steps (timed) and out (folder). If the first pass takes more than a minute, it is the only one.
function measure.case(case, options)
  local problem, passes, began = measure.problems[case.problem], {}, sg.wall_time()
  for i = 1, options.repeats do
    passes[i] = pass(problem, case, options)
    if sg.wall_time() - began > 60 and i == 1 then break end
  end
  table.sort(passes, function(a, b) return a.iteration < b.iteration end)
  for name, time in pairs(passes[(#passes + 1) // 2]) do case[name] = time end
  for _, name in ipairs(measure.outputs) do
    local times = {}
    for i, spent in ipairs(passes) do times[i] = spent[name] end
    case[name] = sg.median(times)
  end
  case.around = (case.iteration - case.linear) / case.linear
  return case
end

--- Neo-Hooke as a formula, which is compiled.
local function neo_hooke_as_formula(E, nu)
  local mu = E / (2 * (1 + nu))
  local lambda = 2 * mu * nu / (1 - 2 * nu)
  return sg.hyperelastic{ energy = function(I1, _, J)
    return lambda / 2 * sg.log(J)^2 + mu / 2 * (I1 - 3) - mu * sg.log(J)
  end }
end

--- Kinds of elements for the comparison of a formula with the kernels of neo-Hooke: orders, and elements per direction.
measure.elements = {
  { name = "plane, N2", order = "N2", elements = { 40, 40 } },
  { name = "plane, N2-N2.1", order = "N2-N2.1", elements = { 40, 40 }, thickness_degree = 1 },
  { name = "axisymmetric, N2", order = "N2", elements = { 40, 40 }, kind = "axisymmetric" },
  { name = "solid, N2", order = "N2", elements = { 6, 6, 6 } },
}

--- The ratio of the times of assembly, residual and tangent, with neo-Hooke as a formula and with its kernels: median
--- of pairs.
function measure.formula_ratio(case, pairs_of_runs)
  local space = #case.elements == 3
  local function scene(material)
    local body = sg.body{
      patch = space and sg.shapes.block{ size = { 1, 1, 1 } } or sg.shapes.rectangle{ width = 1, height = 1 },
      elements = case.elements, order = case.order, contact = space and "back" or "north",
      thickness_degree = case.thickness_degree or 2, material = material }
    return sg.model{ bodies = { body = body }, kind = case.kind,
      supports = { bed = { on = body:face(space and "front" or "south"), fix = space and "xyz" or "xy" } } }
  end
  local scenes, ratios = { scene(neo_hooke_as_formula(1, 0.3)), scene(sg.neo_hookean{ E = 1, nu = 0.3 }) }, {}
  for i = 1, pairs_of_runs do
    local times = {}
    for k, model in ipairs(scenes) do
      local before = model:timings().bulk
      model:residual()
      times[k] = model:timings().bulk - before
    end
    ratios[i] = times[1] / times[2]
  end
  return sg.median(ratios)
end

--- Milliseconds that residual and tangent of a solid element with 27 functions and 27 Gauss points take, in a
--- neo-Hookean block of n³ elements that is sheared: median of repeats.
function measure.element(n, repeats)
  local block = sg.body{
    patch = sg.shapes.block{ size = { 1, 1, 1 } }, elements = { n, n, n }, order = "N2", contact = "back",
    thickness_degree = 2,
    material = sg.neo_hookean{ E = 1, nu = 0.3 },
  }
  local model = sg.model{ bodies = { block = block }, supports = {
    bed = { on = block:face "front", fix = "xyz" }, lid = { on = block:face "back", drive = "xyz" } } }
  finished(model:run({ { name = "shear", steps = 1, lid = { 0.05, 0, -0.05 } } }, sg.plain{}))
  local times = {}
  for i = 1, repeats do
    local before = model:timings().bulk
    model:residual()
    times[i] = 1e3 * (model:timings().bulk - before) / n ^ 3
  end
  return sg.median(times)
end

return measure
