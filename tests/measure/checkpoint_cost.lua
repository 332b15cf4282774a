-- Cost of checkpoints: runs without checkpoints and with one every given number of steps.
--
-- Problem: 2D frictional ironing as published, N2 at mesh m1 (ironing2d.lua), whose short steps make the cost
--          of one file per step visible; and 3D ironing without friction, N2 on a separate mesh
--          (ironing3d.lua), where a checkpoint discards a factorization that would have been reused.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, sections 7.1 and 7.5, for the problems.
-- Units: seconds of wall time; kB.
-- Expected: on the 2D path with short steps, a file after every step makes the run six times as long, one after every
--           tenth step less than twice; in 3D, one after every step makes it less than twice as long.
-- Run: signorini tests/measure/checkpoint_cost.lua [every=0,10,1] [mesh=coarse] [slides=6] [repeats=3]
--      [out=out/checkpoint_cost]; every: steps between checkpoints, 0 for none; mesh, slides: of 3D ironing; times are
--      medians of repeats.

local sg = require "signorini"
local plane = require "problems.ironing2d.problem"
local solid = require "problems.ironing3d.problem"

local options = sg.arguments{
  every = { { 0, 10, 1 }, at_least = 0 }, mesh = { "coarse", choices = solid.mesh_names }, slides = 6, repeats = 3,
  out = "out/checkpoint_cost",
}
sg.mkdir(options.out)
local file = options.out .. "/run.sgn"

local problems = {
  { name = "2D ironing, N2 at m1", begin = function()
    local set_up = plane.variants.standard
    return plane.scene(set_up, "N2", plane.elements "m1"), plane.path(set_up, 1)
  end },
  { name = "3D ironing, N2, " .. options.mesh, begin = function()
    local case = { order = "N2", mesh = options.mesh, radius = 7.5, depth = 2,
                   distance = 0.3 * options.slides, down = 0.5 }
    return solid.scene(case, 50), solid.stages(case)
  end },
}

--- The wall time of a run with its checkpoints, and the size of the last file.
local function seconds(problem, every)
  local model, stages = problem.begin()
  local began = sg.wall_time()
  local run = model:run(stages, sg.plain{ checkpoint = every > 0 and { file = file, every = every } or nil })
  local spent = sg.wall_time() - began
  if run.failed then error(run.failure, 0) end
  local size = nil
  if every > 0 then
    local stream = assert(io.open(file, "rb"))
    size = stream:seek "end" / 1024
    stream:close()
    os.remove(file)
  end
  return spent, size, run.steps
end

local rows, costs = {}, {}
for _, problem in ipairs(problems) do
  local without
  for _, every in ipairs(options.every) do
    local times, size, steps = {}, nil, nil
    for i = 1, options.repeats do times[i], size, steps = seconds(problem, every) end
    local median = sg.median(times)
    without = without or every == 0 and median or nil
    costs[#costs + 1] = { problem = problem.name, every = every, wall = median, size = size }
    rows[#rows + 1] = { problem.name, steps, every == 0 and "none" or ("every %d"):format(every), median,
                        without and median / without or "", size or "" }
  end
end
print(sg.table{ columns = { "problem", "steps", "checkpoints", "wall", "times as long", "last file" },
                units = { "", "", "", "s", "", "kB" }, rows = rows,
                formats = { wall = "%.2f", ["times as long"] = "%.2f", ["last file"] = "%.0f" } })

return costs
