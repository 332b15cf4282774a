-- Two elastic half rings that are pressed together: meshes, scene, path. Lengths in m, forces in N.

local sg = require "signorini"

local problem = { mu = 0.1, steps = 40, push = -4 }

--- Model and degrees of freedom of an order on a mesh, m1 to m5.
function problem.scene(order, mesh)
  local refined = 1 << (math.tointeger(mesh:sub(2)) - 1)
  local upper = sg.body{
    patch    = sg.shapes.quarter_annulus{ inner = 8, outer = 10, center = {0, 22}, start = 270 },
    elements = { 12 * refined, 3 }, order = order, contact = "south", thickness_degree = 1,
    material = sg.neo_hookean{ E = 100, nu = 0.3 },
  }
  local lower = sg.body{
    patch    = sg.shapes.quarter_annulus{ inner = 10, outer = 12, start = 0 },
    elements = { 20 * refined, 3 }, order = order, contact = "south", thickness_degree = 1,
    material = sg.neo_hookean{ E = 300, nu = 0.3 },
  }
  local model = sg.model{
    bodies   = { upper = upper, lower = lower },
    supports = { bed      = { on = lower:face "west", fix = "xy" },
                 symmetry = { on = {upper:face "west", lower:face "east"}, fix = "x" },
                 grip     = { on = upper:face "east", fix = "x", drive = "y" } },
    contacts = { interface = { slave = upper:face "south", master = lower:face "south",
                               penalty = 100, friction = { mu = problem.mu, penalty = 10 } } },
  }
  return model, upper:dofs().total + lower:dofs().total
end

--- Solves the path on a mesh. `on_state` is called with the model at the start and after every step. Returns
--- { order, mesh, run, dofs, profile }.
function problem.solve(order, mesh, linear, on_state)
  local model, dofs = problem.scene(order, mesh)
  if on_state then on_state(model, 0) end
  local run = model:run({ { name = "press", steps = problem.steps, grip = { problem.push } } },
    sg.plain{ linear = linear, on_step = on_state and function(info) on_state(model, info.step) end or nil })
  if run.failed then error(("%s at %s: %s"):format(order, mesh, run.failure), 0) end
  return { order = order, mesh = mesh, run = run, dofs = dofs, profile = model:profile "interface" }
end

return problem
