-- Maximum depth: the indenter is pressed down by the published 10.4, in the slab's middle, where two planes of symmetry
-- keep it upright, and off it. Failed steps are halved; then arc length distinguishes a turning point from a failure.

local sg = require "signorini"
local output = require "problems.ironing3d.output"
local problem = require "problems.ironing3d.problem"

local depth = {}

--- Presses a case and adds the list of `states`, one per step: depth, Pz, area, max_pressure, max_penetration; and
--- `fullest`, the state with the largest contact area: area, snapshot.
function depth.solve(case)
  case.mesh, case.depth, case.distance, case.states = case.mesh or "coarse", problem.published_depth, 0, {}
  case.on_step = function(model, info)
    local state = { depth = -info["grip.uz"], Pz = -info["grip.fz"], area = info["interface.area"],
                    max_pressure = info["interface.max_pressure"], max_penetration = info["interface.max_penetration"] }
    table.insert(case.states, state)
    if not case.fullest or state.area > case.fullest.area then
      case.fullest = { area = state.area, snapshot = model:snapshot() }
    end
  end
  return problem.solve(case)
end

--- The turning point in the run's failure, or nil.
local function turning_point(run)
  return run.failed and tonumber(run.failure:match "turning point at grip%.uz = (%-?[%d.]+)") or nil
end

local function result_table(cases)
  local rows = {}
  for i, case in ipairs(cases) do
    local last, largest = case.states[#case.states] or {}, case.fullest and case.fullest.area
    rows[i] = { case.order, case.radius, case.from, last.depth, case.run.reason, case.turn and -case.turn,
                case.run.iterations, case.run.cutbacks, last.Pz, largest, last.area, last.max_pressure,
                last.max_penetration }
  end
  return sg.table{
    columns = { "order", "R", "x", "depth", "end", "turns at", "iterations", "cut-backs", "Pz", "largest area", "area",
                "max p", "max penetration" },
    units = { "", "", "", "", "", "", "", "", "last", "", "last", "last", "last" }, rows = rows,
    formats = { "%s", "%g", "%g", "%.2f", "%s", "%.3f", "%d", "%d", "%.3f", "%.2f", "%.2f", "%.3f", "%.4f" },
  }
end

local function draw(file, cases, key, ylabel)
  local chart = { file = file, xlabel = "depth", ylabel = ylabel, title = "3D ironing: pressing to 10.4" }
  local colors, known = {}, 0 -- one per discretization and radius
  for _, case in ipairs(cases) do
    local name = ("%s, R = %g"):format(case.order, case.radius)
    if not colors[name] then known, colors[name] = known + 1, known + 1 end
    local line = { x = {}, y = {}, label = ("%s, x = %g"):format(name, case.from), color = colors[name],
                   dashed = case.from ~= cases[1].from }
    for i, state in ipairs(case.states) do line.x[i], line.y[i] = state.depth, state[key] end
    if #line.x > 0 then chart[#chart + 1] = line end
  end
  if #chart > 0 then sg.chart(chart) end
  return #chart > 0
end

--- Draws the underside of the indenter at its largest contact area and at its deepest state, which the model has. The
--- range of colors is that of the pressure away from the corners.
local function draw_fold(file, case, name)
  local function below()
    return sg.picture{ model = case.model, bodies = { "indenter" }, field = "contact_pressure", range = { 0, 1 },
                       label = "contact pressure / E", camera = { from = { 0.4, -1.6, -1.2 } },
                       title = ("depth %.2f, contact area %.0f"):format(-case.model:target "grip"[3],
                       case.model:contact_resultant "interface".area) }
  end
  local last = below()
  case.model:restore(case.fullest.snapshot)
  sg.sheet{ below(), last, columns = 2, file = file,
            title = ("The indenter from below, %s"):format(name) }
end

--- The study. Returns { cases }.
function depth.run(options, files)
  local cases, pictures = {}, {}
  for _, radius in ipairs(options.radius) do
    for _, order in ipairs(options.orders) do
      for _, from in ipairs(options.from) do
        local case = depth.solve{ order = order, radius = radius, from = from, cap = options.cap, down = options.down,
                                  linear = options.linear }
        local name = ("%s, R = %g, x = %g"):format(order, radius, from)
        if #case.states > 0 then
          local deepest = case.states[#case.states].depth
          pictures[#pictures + 1] = output.picture(case.model, ("%s, depth %.2f"):format(name, deepest))
          draw_fold(files(("fold_%s_R%g_x%g.png"):format(order, radius, from)), case, name)
          case.fullest.snapshot = nil
        end
        case.model = nil
        print(name)
        print(case.run)
        case.run:csv(files(("%s_R%g_x%g.csv"):format(order, radius, from)))
        case.turn = turning_point(case.run)
        cases[#cases + 1] = case
      end
    end
  end
  print(("\nPressed to 10.4 in steps of %g; failed steps are halved"):format(options.down))
  print(result_table(cases))
  files:draw("states.png", "an accepted step", function(file)
    if #pictures > 0 then output.draw_sheet(file, pictures, "3D ironing: deepest states") end
    return #pictures > 0
  end)
  files:draw("pressing.png", "an accepted step", function(file) return draw(file, cases, "Pz", "pressing force Pz") end)
  files:draw("area.png", "an accepted step", function(file) return draw(file, cases, "area", "contact area") end)
  return { cases = cases }
end

return depth
