-- The path in 60 steps, 10 for pressing and 50 for sliding: cost and pressing force by discretization and mesh.

local sg = require "signorini"
local page = require "page.tables"
local meshes = require "problems.solid_ironing.mesh"
local output = require "problems.solid_ironing.output"
local study = require "problems.solid_ironing.study"

local sixty = {}

local press, slide = 10, 50

local function result_table(cases)
  local rows = {}
  for i, case in ipairs(cases) do
    local run, drag = case.run, case.drag or {}
    rows[i] = { case.order, case.block_order or case.order, case.layer, case.mesh.name, case.part,
                case.thickness_degree, case.points or "3(p+1)", case.tolerance, case.dofs.total,
                run.iterations, run.cutbacks, run.failed and run.reason or "complete", case.user, case.pressed,
                drag.mean, drag.low, drag.high }
  end
  return {
    columns = { "order", "block", "layer", "mesh", "part", "thickness_degree", "points", "tolerance", "DOFs",
                "iterations", "cut-backs", "end", "user", "Pz", "Pz", "Pz", "Pz" },
    units = { "", "", "", "", "", "degree", "", "", "", "", "", "", "s", "pressed", "mean", "least", "greatest" },
    rows = rows,
    formats = { "%s", "%s", "%s", "%s", "%s", "%d", "%s", "%g", "%d", "%d", "%d", "%s", "%.2f", "%.3f", "%.3f", "%.3f",
                "%.3f" },
  }
end

local function csv(file, cases)
  local data = { columns = { "order", "block_order", "layer", "mesh", "part", "thickness_degree", "points", "tolerance",
                             "dofs", "iterations", "cutbacks", "user",
                             "pressed", "drag_mean", "drag_low", "drag_high" },
                 comments = { "user time in s" }, rows = {} }
  for i, case in ipairs(cases) do
    local drag = case.drag or {}
    data.rows[i] = { case.order, case.block_order or case.order, case.layer, case.mesh.name, case.part,
                     case.thickness_degree, case.points, case.tolerance, case.dofs.total, case.run.iterations,
                     case.run.cutbacks, case.user, case.pressed, drag.mean, drag.low, drag.high }
  end
  sg.csv.write(file, data)
end

--- Runs all combinations of the lists orders, block_order ("same" as the slab's, or one), layer ("whole" or "below" the
--- block's path), mesh, part ("half" or "whole"), thickness_degree, points (texts: a number or "auto", 3(p + 1)),
--- tolerance. Returns { cases }.
function sixty.run(problem, options, files)
  local cases = sg.grid({ mesh = options.mesh }, { part = options.part },
                        { thickness_degree = options.thickness_degree },
                        { points = options.points }, { tolerance = options.tolerance }, { layer = options.layer },
                        { block_order = options.block_order }, { order = options.orders })
  for i, case in ipairs(cases) do
    local name, points = case.mesh, case.points
    case.mesh, case.points = meshes.read(name), math.tointeger(tonumber(points))
    if case.block_order == "same" then case.block_order = nil end
    if case.layer == "below" and not case.order:find "-" then
      error(("layer=below: order '%s' has no layer. Hint: layer=whole, or an order such as N2-N2.1")
        :format(case.order), 0)
    end
    case.half = case.part == "half"
    if case.half and (case.mesh.die[2] % 2 == 1 or case.mesh.slab[2] % 2 == 1) then
      error(("mesh=%s: a half model has half of the elements across, so both numbers (%d and %d) must be "
        .. "even. Hint: part=whole"):format(name, case.mesh.die[2], case.mesh.slab[2]), 0)
    end
    case.press, case.slide, case.line_search, case.linear = press, slide, options.line_search, options.linear
    cases[i] = study.solve(problem, case)
    print(("%s at %s (%s), block %s, layer %s, thickness degree %d, points %s: %.2f s of user time")
      :format(case.order, name, case.part, case.block_order or case.order, case.layer, case.thickness_degree, points,
        case.user))
    print(case.run)
  end
  print(("\n%d + %d steps; pressing force at full depth and during sliding"):format(press, slide))
  local results = result_table(cases)
  print(sg.table(results))
  page.fill(options, "block_ironing3d", "block_ironing3d_sixty", { sixty = page.pick(results,
    { 1, 4, 5, 9, 10, 11, 14, 15, 13 }, { "discretization", "mesh", "model", "DOFs", "iterations", "cuts", "Pz pressed",
      "Pz mean", "user time (s)" }) })
  csv(files "sixty.csv", cases)
  files:draw("sixty.png", "a step of the sliding", function(file)
    local named = {}
    for i, case in ipairs(cases) do
      local orders = case.block_order and ("%s, block %s"):format(case.order, case.block_order) or case.order
      if case.layer == "below" then orders = orders .. ", local" end
      named[i] = setmetatable({ order = ("%s %s %s q=%d %s"):format(orders, case.mesh.name, case.part,
        case.thickness_degree, case.points or "3(p+1)") }, { __index = case })
    end
    return output.draw_force(file, named, "Pz", {
      title = "Block ironing in 60 steps: pressing force", ylabel = "Pz",
    })
  end)
  return { cases = cases }
end

return sixty
