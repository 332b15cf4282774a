-- Cost of a Newton iteration: assembly of bodies and contacts, factorization and solve, over the degrees of freedom.
-- The indenter is pressed by 1 in five steps; times are means over all iterations.

local sg = require "signorini"
local problem = require "problems.ironing3d.problem"

local cost = {}

local function solve(order, mesh, linear)
  local model, indenter, slab = problem.scene({ order = order, mesh = mesh, radius = 25.5 }, 50)
  local run = model:run({ { name = "press", steps = 5, grip = { 0, 0, -1 } } },
    sg.plain{ linear = linear, step = { adaptive = true } })
  local case = { order = order, mesh = mesh, run = run, solver = model:solver(),
                 dofs = indenter:dofs().total + slab:dofs().total }
  for _, part in ipairs { "bulk", "contact", "linear", "rest" } do case[part] = run.timings[part] / run.iterations end
  case.assembly = case.bulk + case.contact
  case.iteration = case.assembly + case.linear + case.rest
  return case
end

--- The largest resident memory of this process so far, MB, if the system reports it.
local function memory()
  local stream = io.open "/proc/self/status"
  if not stream then return nil end
  local text = stream:read "a"
  stream:close()
  local kilobytes = tonumber(text:match "VmHWM:%s*(%d+)")
  return kilobytes and kilobytes / 1024
end

local function result_table(cases)
  local rows = {}
  for i, case in ipairs(cases) do
    rows[i] = { case.order, case.mesh, case.dofs, case.solver.unknowns, case.solver.linear, case.run.iterations,
                1e3 * case.bulk, 1e3 * case.contact, 1e3 * case.linear, 1e3 * case.iteration,
                case.assembly / case.linear, case.memory }
  end
  return sg.table{
    columns = { "order", "mesh", "DOFs", "unknowns", "solver", "iterations", "bulk", "contact", "linear", "all",
                "assembly", "memory" },
    units = { "", "", "", "", "", "", "ms/it.", "ms/it.", "ms/it.", "ms/it.", "of linear", "MB" }, rows = rows,
    formats = { "%s", "%s", "%d", "%d", "%s", "%d", "%.1f", "%.1f", "%.1f", "%.1f", "%.2f", "%.0f" },
  }
end

local function draw(file, cases)
  local chart = { file = file, xlabel = "degrees of freedom", ylabel = "time of a Newton iteration (ms)", log = "xy",
                  title = "3D ironing: cost of a Newton iteration, N2" }
  for i, part in ipairs { "bulk", "contact", "linear" } do
    local line = { x = {}, y = {}, label = part, markers = true }
    for j, case in ipairs(cases) do line.x[j], line.y[j] = case.dofs, 1e3 * case[part] end
    chart[i] = line
  end
  if #cases > 0 then sg.chart(chart) end
  return #cases > 0
end

--- The study: every order on every mesh, then `layered` orders on the coarse one. Returns { cases, layered }. Memory is
--- the process' largest so far: meshes come in rising order.
function cost.run(options, files)
  local cases, layered, all = {}, {}, {}
  local function add(list, order, mesh)
    collectgarbage() -- Lua does not count the memory of models
    local case = solve(order, mesh, options.linear)
    case.memory = memory()
    table.insert(list, case)
    table.insert(all, case)
  end
  for _, order in ipairs(options.layered) do add(layered, order, "coarse") end
  for _, mesh in ipairs(options.mesh) do add(cases, options.orders[1], mesh) end
  print "Time of a Newton iteration (linear: factorization and solve), largest memory of the process so far"
  print(result_table(all))
  files:draw("cost.png", "a mesh", function(file) return draw(file, cases) end)
  return { cases = cases, layered = layered }
end

return cost
