-- Cost of sg.recommend compared with a uniform run one mesh finer than all those it has tried.
--
-- Problem: a hollow cylinder is pressed onto a rigid plane (hertz2d.lua) by a load in 5 steps; sg.recommend
--          searches for the smallest discretization and mesh whose peak pressure is within a tolerance. The alternative
--          to this search is one run that is certainly fine enough: the simplest discretization on the mesh after the
--          finest one of the search.
-- Source: H. Hertz, J. reine angew. Math. 92, 1882, for the problem.
-- Units: seconds of wall time.
-- Expected: the search takes about 0.75 times as long as the uniform run, for all three tolerances.
-- Run: signorini tests/measure/recommend_cost.lua [at_most=0.05,0.02,0.005] [local_layers=yes] [repeats=5]
--      [out=out/recommend_cost]; local_layers: also tries a layer where the cylinder touches only; times are medians of
--      repeats, with search and uniform run in turn.

local sg = require "signorini"
local hertz = require "problems.hertz2d.problem"

local options = sg.arguments{
  at_most = { { 0.05, 0.02, 0.005 }, above = 0 }, local_layers = true, repeats = 5, out = "out/recommend_cost",
}
local meshes = { "m1", "m2", "m3", "m4", "m5", "m6", "m7" }

local function scene(order, mesh, _, layers)
  local model, stage = hertz.scene{ order = order, mesh = mesh, load = "force", layer = layers and layers.ground }
  stage.steps = 5
  return model, { stage }
end

--- Wall time of a function, and its result.
local function timed(body)
  local began = sg.wall_time()
  local result = body()
  return sg.wall_time() - began, result
end

local costs, rows, results = {}, {}, {}
for i, at_most in ipairs(options.at_most) do
  local searches, runs, found, finest = {}, {}, nil, 0
  for k = 1, options.repeats do
    searches[k], found = timed(function()
      return sg.recommend{ scene = scene, quantity = "ground.max_pressure", at_most = at_most, meshes = meshes,
                           local_layers = options.local_layers }
    end)
    for _, case in ipairs(found.tries) do finest = math.max(finest, case.level) end
    if not meshes[finest + 1] then
      error(("at_most = %g needs the finest mesh, so no finer one is left"):format(at_most), 0)
    end
    runs[k] = timed(function()
      local model, stages = scene("N2", meshes[finest + 1])
      return model:run(stages)
    end)
  end
  local search, run = sg.median(searches), sg.median(runs)
  costs[i] = { at_most = at_most, tries = #found.tries, search = search, uniform = run, ratio = search / run }
  results[i] = { at_most, search, run, search / run }
  rows[i] = { 100 * at_most, ("%s, %s"):format(found.order, found.mesh), #found.tries, search,
              "N2, " .. meshes[finest + 1], run, search / run }
end
print(sg.table{
  columns = { "at most", "chosen", "runs", "search", "uniform run", "wall", "search / run" },
  units = { "%", "", "", "s", "", "s", "" }, rows = rows,
  formats = { search = "%.3f", wall = "%.3f", ["search / run"] = "%.2f" },
})
sg.mkdir(options.out)
sg.csv.write(options.out .. "/recommend_cost.csv", { columns = { "at_most", "search", "uniform", "ratio" },
                                                     rows = results })

return costs
