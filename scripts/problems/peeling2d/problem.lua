-- The strip of the peeling problem: meshes, scene, path. Lengths in nm, forces in nN (per nm of depth).

local sg = require "signorini"

local problem = {
  length = 200.0, bonded = 150.0, -- as published; bonded is the part with adhesion
  height = 10, modulus = 2, poisson = 0.2,
  hamaker = 0.1, r0 = 0.4,      -- nN nm, nm
  moment_unit = 2,              -- E0 L0³ per nm of depth, in nN
  pitch = 0.1,                  -- degrees per step
}

--- Elements per nm by mesh: Table 7.7's 160 × 8, 200 × 10 and 240 × 12 on the published strip, and one half as fine as
--- m1.
local densities = { m0 = 0.4, m1 = 0.8, m2 = 1, m3 = 1.2 }

--- Elements along and across the strip.
function problem.elements(mesh, length)
  local density = densities[mesh]
  if not density then error(("mesh must be one of m0 to m3, got '%s'"):format(mesh), 0) end
  return { math.floor(density * length + 0.5), math.floor(density * problem.height + 0.5) }
end

--- Distance of zero traction between strip and substrate: T(r) = 0 at r = 15^(−1/6) r₀.
function problem.equilibrium_distance() return 15 ^ (-1 / 6) * problem.r0 end

--- Model and strip. `length` of the strip, adhesion acts on the part x ≤ `bonded`; thickness_degree: as in sg.body, 1
--- by default.
function problem.scene(order, mesh, length, bonded, thickness_degree)
  local strip = sg.body{
    patch    = sg.shapes.rectangle{ width = length, height = problem.height },
    elements = problem.elements(mesh, length), order = order, contact = "south",
    thickness_degree = thickness_degree or 1, material = sg.neo_hookean{ E = problem.modulus, nu = problem.poisson },
  }
  -- The substrate transmits no shear, and the edge is free to move, so one point of the strip is fixed in x.
  local model = sg.model{
    bodies   = { strip = strip },
    supports = { edge = { on = strip:face "east", rotate = true },
                 pin  = { on = strip:corner "south-west", fix = "x" } },
    contacts = { film = { slave = strip:face "south",
                          master = sg.rigid.plane{ point = { 0, -problem.equilibrium_distance() }, normal = { 0, 1 } },
                          adhesion = { hamaker = problem.hamaker, r0 = problem.r0 },
                          where = function(X) return X[1] <= bonded end } },
  }
  return model, strip
end

--- Appends the rows of a run that began after `before` steps.
local function append(case, run, before)
  local step, angle, moment = run:column "step", run:column "edge.angle", run:column "edge.moment"
  for i = 1, run.rows do
    local row = #case.angle + 1
    case.step[row], case.angle[row], case.moment[row] = before + step[i], angle[i], moment[i] / problem.moment_unit
  end
  case.reached = before + run.steps
  case.iterations, case.wall = case.iterations + run.iterations, case.wall + run.wall
  for account, seconds in pairs(run.timings) do case.timings[account] = (case.timings[account] or 0) + seconds end
end

--- Peels one strip by prescribed rotation; where that ends before the last step, with control = "arc", by arc length
--- from there on. `options`: length, bonded, steps, control, iterations, linear, and adapt as model:run takes it;
--- on_step(model, angle) sees every whole step. Returns a case: order, mesh, dofs, model, rotation (the run under
--- rotation control alone), arc (what followed, if anything), and of both together the lists step (with parts of a step
--- where arc length was used), angle (degrees) and moment (E0 L0³), reached (whole steps), iterations, wall and timings
--- (s).
function problem.solve(order, mesh, options, on_step)
  local model, strip = problem.scene(order, mesh, options.length, options.bonded)
  local case = { order = order, mesh = mesh, dofs = strip:dofs().total, model = model,
                 step = {}, angle = {}, moment = {}, iterations = 0, wall = 0, timings = {} }
  local solver = sg.plain{ newton = { iterations = options.iterations }, linear = options.linear,
                           adapt = options.adapt,
                           on_step = on_step and function(info) return on_step(model, info["edge.angle"]) end }
  local goal = options.steps * problem.pitch
  case.rotation = model:run({ { name = "rotate", steps = options.steps, edge = goal } }, solver)
  append(case, case.rotation, 0)
  local before = case.reached
  if case.rotation.failed and before > 0 and options.control == "arc" then
    solver.arc_length = true
    case.arc = model:run({ { name = "go on", steps = options.steps - before, edge = goal } }, solver)
    append(case, case.arc, before)
  end
  return case
end

return problem
