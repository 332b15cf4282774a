-- The load path on a model of one spring: targets, records, the ends a run can come to, wrong stages and options.

require "check"
local spring = require "spring"
local run_path = require "spring_run"

local function model_of(fails)
  local model = spring(fails)
  model.run = run_path
  return model
end

local two_stages = {
  { name = "press", steps = 4, grip = { 0, -0.4 } }, { name = "slide", steps = 2, grip = { 1, -0.4 } },
}

check.case("each stage moves linearly from the present position of the support to its target", function()
  local model = model_of()
  local run = model:run(two_stages)
  check.near(run:column "grip.fy", { -0.3, -0.6, -0.9, -1.2, -1.2, -1.2 }, 1e-15)
  check.equal(run:column "grip.fx", { 0, 0, 0, 0, 1, 2 })
  check.near(run:column "grip.uy", { -0.1, -0.2, -0.3, -0.4, -0.4, -0.4 }, 1e-15)
  check.equal(run:column "bed.fx", { 0, 0, 0, 0, -1, -2 })
  check.near(run:column "interface.area", { 0.1, 0.2, 0.3, 0.4, 0.4, 0.4 }, 1e-15)
  check.equal(run:column "step", { 1, 2, 3, 4, 5, 6 })
  check.equal(run:column "iterations", { 3, 3, 3, 3, 3, 3 })
  check.equal(run:column "increments", { 1, 1, 1, 1, 1, 1 })
  check.equal(model.accepted, { 1, -0.4 }) -- met exactly, not to rounding
  check.equal({ run.failed, run.reason, run.steps, run.iterations }, { false, "completed", 6, 18 })
  check.equal(run:residuals(6), { 1, 1e-3, 1e-12 })
  check.equal(#run:column "wall", 6)
end)

check.case("a second run continues from the accepted state; an unlisted support stays", function()
  local model = model_of()
  model:run(two_stages)
  local run = model:run{ { steps = 3 }, { steps = 2, grip = { 2, 0 } } }
  check.near(run:column "grip.fx", { 2, 2, 2, 3, 4 })
  check.near(run:column "grip.fy", { -1.2, -1.2, -1.2, -0.6, 0 })
  check.equal(run:column "step", { 1, 2, 3, 4, 5 })
end)

check.case("angles and loads are targets like displacements, alone without braces", function()
  local run = model_of():run{ { steps = 4, edge = 90, gas = { -2 } }, { steps = 2, gas = 0 } }
  check.equal(run:column "edge.angle", { 22.5, 45, 67.5, 90, 90, 90 })
  check.equal(run:column "edge.moment", { 112.5, 225, 337.5, 450, 450, 450 })
  check.equal(run:column "gas.pressure", { -0.5, -1, -1.5, -2, -1, 0 })
  check.equal(run:column "gas.fy", { 3.5, 7, 10.5, 14, 7, 0 })
end)

check.case("a failed step is rolled back and reported", function()
  local model = model_of(function(x) return x > 0.5 and "diverged" or nil end)
  local run = model:run(two_stages, sg.plain{})
  check.equal({ run.failed, run.reason, run.steps }, { true, "diverged", 5 })
  check.equal(model.accepted, { 0.5, -0.4 })
  check.equal(model.calls[#model.calls], "rollback")
  check.holds(run.failure, "step 6 (stage 'slide', 2 of 2)", "no luck", "1, 0.001, 0.01", "last accepted step, 5")
  check.equal(run:residuals(6), { 1, 1e-3, 1e-2 })
  check.equal(#run:column "grip.fx", 5)
  check.holds(tostring(run), "diverged: step 6", "press", "slide", "total")
end)

check.case("a run that fails at once has columns, all empty", function()
  local run = model_of(function() return "interrupted" end):run(two_stages)
  check.equal({ run.reason, run.steps }, { "interrupted", 0 })
  check.equal(run:column "grip.fx", {})
  check.holds(run.failure, "its start")
  check.holds(tostring(run), "interrupted")
end)

check.case("on_step is called after every accepted step and may end the run", function()
  local model, seen = model_of(), {}
  local run = model:run(two_stages, { on_step = function(info)
    seen[#seen + 1] = ("%s %d %g"):format(info.stage, info.step, info["grip.fx"])
    check.equal({ info.iterations, info.residual }, { 3, 1e-12 })
    return info.step == 5 and "stop" or nil
  end })
  check.equal(seen, { "press 1 0", "press 2 0", "press 3 0", "press 4 0", "slide 5 1" })
  check.equal({ run.failed, run.reason, run.steps }, { false, "stopped", 5 })
  check.equal(model.accepted, { 0.5, -0.4 })
end)

check.case("on_step's own time is not the run's", function()
  local now, clock = core.now, 0
  core.now = function() return clock end
  local ok, run = pcall(function()
    return model_of():run({ { steps = 3, grip = { 1, 1 } } }, { on_step = function() clock = clock + 1000 end })
  end)
  core.now = now
  if not ok then error(run) end
  check.equal(run.wall, 0)
end)

check.case("times of long runs are in minutes", function()
  local now, clock = core.now, 0
  core.now = function()
    clock = clock + 40.3
    return clock
  end
  local ok, run = pcall(function() return model_of():run{ { steps = 3, grip = { 1, 1 } } } end)
  core.now = now
  if not ok then error(run) end
  check.near(run.wall, 4 * 40.3, 1e-9) -- three steps, and the examination of the last state
end)

check.case("options reach the solver", function()
  local model = model_of()
  model:run({ { steps = 1 } }, { newton = { tolerance = 1e-8, iterations = 7 }, linear = "klu" })
  check.equal({ model.options.tolerance, model.options.iterations, model.options.linear }, { 1e-8, 7, "klu" })
  model:run{ { steps = 1 } }
  check.equal({ model.options.tolerance, model.options.iterations, model.options.linear }, { 1e-10, 25, "auto" })
end)

check.case("columns: their names, and what is not one", function()
  local run = model_of():run(two_stages)
  check.equal(run:columns(), { "step", "increments", "iterations", "wall", "bed.fx", "bed.fy", "edge.fx", "edge.fy",
    "edge.moment", "grip.fx", "grip.fy", "gas.fx", "gas.fy", "edge.angle", "grip.ux", "grip.uy", "gas.pressure",
    "interface.fx", "interface.fy", "interface.area", "interface.max_pressure", "interface.max_penetration" })
  check.fails(function() run:column "grip.fz" end, "run_test.lua:", "'grip.fz'; did you mean 'grip.f", "grip.fy")
  check.fails(function() run:residuals(7) end, "run:residuals: there is no step 7; the run has steps 1 to 6")
  run:column("step")[1] = 99 -- a copy
  check.equal(run:column("step")[1], 1)
end)

check.case("the table and the file agree", function()
  local run = model_of():run(two_stages)
  check.holds(tostring(run), "press      4          12      3.00", "total      6          18      3.00",
    "factorization and solve")
  local name = check.file()
  run:csv(name)
  check.fails(function() run:csv "nowhere/at.csv" end, "run_test.lua:", "run:csv: cannot write 'nowhere/at.csv'",
    'sg.mkdir "nowhere"')
  local read = sg.csv.read(name)
  check.equal(read.columns, run:columns())
  for _, column in ipairs(read.columns) do check.equal(read:column(column), run:column(column)) end
end)

check.case("invalid stages and options are rejected before the first step", function()
  local model = model_of()
  local wrong = {
    { {}, "stages must be a list of stages", "write model:run{ {" },
    { { { steps = 2, gripp = { 0, 1 } } }, "unknown argument 'gripp'", "did you mean 'grip'?",
      "name, steps, duration, growth, contacts, edge, grip, gas" },
    { { { steps = 2, { 0, 1 } } }, "stages[1] takes named arguments, got a list of 2 values without a name" },
    { { { steps = 2, bed = { 0, 1 } } }, "'bed'", "not driven", 'drive = "x"' },
    { { { steps = 2, grip = { 0 } } }, "grip must be a list of 2 numbers (ux, uy), got a list of 1 value" },
    { { { steps = 2, grip = 1 } }, "grip must be a list of 2 numbers (ux, uy), got the number 1" },
    { { { steps = 2, edge = { 1, 2 } } }, "edge must be a list of 1 number (angle), got a list of 2 values" },
    { { { steps = 2, gas = "1" } }, "gas must be a number or a list of 1 number (pressure), got the string '1'" },
    { { { steps = 2, grip = { 0, "1" } } }, "grip[2]", "got the string '1'. Hint: remove the quotes" },
    { { { steps = 2, grip = { 0, 0 / 0 } } }, "grip[2]", "nan" },
  }
  for _, case in ipairs(wrong) do
    check.fails(function() model:run(case[1]) end, "run_test.lua:", "model:run: ", table.unpack(case, 2))
  end
  local wrong_options = {
    { { newton = { tolerance = -1 } }, "options.newton.tolerance must be a positive number", "got the number -1" },
    { { step = { max = 0.25, min = 0.5 } }, "options.step: min must be at most max, got 0.5 with max = 0.25" },
  }
  for _, case in ipairs(wrong_options) do
    check.fails(function() model:run({ { steps = 1 } }, case[1]) end, "run_test.lua:", table.unpack(case, 2))
  end
  check.equal(model.calls, {})
end)

-- ── Increments ───────────────────────────────────────────────────────────────────────────────────────────────────────

--- A path from 0 to `steps` in steps of 1, on a spring on which an attempt of more than limit(x) from x fails, with
--- plain Newton but for `step` and `more`. Returns the run, the model, and what was accepted of the path, point by
--- point.
local function climb(steps, limit, step, more)
  local model
  model = model_of(function(x)
    local from = model.accepted[1]
    return x - from > limit(from) + 1e-12 and "diverged" or nil
  end)
  local accept, points = model.accept, {}
  function model:accept()
    accept(self)
    points[#points + 1] = self.accepted[1]
  end
  local options = sg.plain(more)
  options.step = step
  return model:run({ { name = "climb", steps = steps, grip = { steps, 0 } } }, options), model, points
end

local function rough(low, high, limit)
  return function(x) return x > low - 1e-12 and x < high - 1e-12 and limit or 1 end
end

check.case("a failed step is halved; rows are the steps, work is all attempts", function()
  local run, model, points = climb(4, rough(1, 2, 0.25), { adaptive = true, growth = 1 })
  check.near(points, { 1, 1.25, 1.5, 1.75, 2, 2.25, 2.5, 2.75, 3, 3.25, 3.5, 3.75, 4 })
  check.equal({ run.failed, run.steps, run.cutbacks, run.stages[1].cutbacks }, { false, 4, 2, 2 })
  check.equal(run:column "grip.ux", { 1, 2, 3, 4 })
  check.equal(run:column "increments", { 1, 4, 4, 4 })
  check.equal(run:column "iterations", { 3, 2 * 25 + 4 * 3, 4 * 3, 4 * 3 })
  check.equal(run.iterations, 3 + 62 + 12 + 12)
  check.equal(model.accepted, { 4, 0 }) -- met exactly
  check.holds(tostring(run), "cut-backs", "climb      4          2          89")
  check.holds(tostring(run), "2 failed attempts took 50 of the 89 iterations")
  local attempts = run:attempts(2)
  check.equal({ #attempts, attempts[1].from, attempts[1].to, attempts[1].converged, attempts[1].reason,
                attempts[1].iterations, attempts[3].to }, { 6, 0, 1, false, "diverged", 25, 0.25 })
  check.equal(attempts[6].residuals, run:residuals(2))
end)

check.case("easy increments grow again, hard ones do not", function()
  local _, _, points = climb(4, rough(1, 1.2, 0.125), { adaptive = true })
  check.near(points, { 1, 1.125, 1.25, 1.5, 2, 3, 4 })
  local growth = { adaptive = true, growth = 4 }
  _, _, points = climb(3, rough(1, 1.05, 1 / 16), growth)
  check.near(points, { 1, 1.0625, 1.3125, 2, 3 })
  -- Three iterations of five are not easy.
  _, _, points = climb(3, rough(1, 1.2, 0.5), { adaptive = true }, { newton = { iterations = 5 } })
  check.near(points, { 1, 1.5, 2, 2.5, 3 })
end)

check.case("max is the longest increment, and the last of a step is what is left of it", function()
  local run, _, points = climb(2, function() return 1 end, { max = 0.3 })
  check.near(points, { 0.3, 0.6, 0.9, 1, 1.3, 1.6, 1.9, 2 })
  check.equal({ run.cutbacks, run:column("increments")[1] }, { 0, 4 })
  check.equal(climb(2, function() return 1 end, { max = 1 / 3 }):column "increments", { 3, 3 })
end)

check.case("step = { adaptive = false } takes each step as a whole", function()
  local run, _, points = climb(4, rough(1, 2, 0.25), { adaptive = false })
  check.equal({ run.failed, run.steps, run.cutbacks, #points }, { true, 1, 0, 1 })
  check.equal(run.failure, "step 2 (stage 'climb', 2 of 4) was not reached: no luck. Residuals: 1, 0.001, 0.01. "
    .. "The model is at its last accepted step, 1. Hint: be lucky.")
end)

check.case("steps are cut unless options say otherwise", function()
  for _, options in ipairs { {}, { step = {} }, { step = { adaptive = true } }, sg.robust{} } do
    local model
    model = model_of(function(x) return x - model.accepted[1] > 0.5 and "diverged" or nil end)
    local run = model:run({ { steps = 1, grip = { 1, 0 } } }, options)
    check.equal({ run.failed, run.cutbacks, run:column("increments")[1] }, { false, 1, 2 })
  end
end)

check.case("a failed step leaves the model at its last increment, and the report lists the attempts", function()
  -- The end of the road is at 1.7; increments of 1/8 are allowed.
  local run, model = climb(4, function(x) return x < 1.5 and 0.25 or 1.7 - x end, { min = 1 / 8 })
  check.equal({ run.failed, run.reason, run.cause, run.steps }, { true, "minimum_step", "diverged", 1 })
  check.near(model.accepted, { 1.625, 0 })
  check.equal(model.calls[#model.calls], "rollback")
  check.holds(run.failure, "step 2 (stage 'climb', 2 of 4) was not reached: no luck.",
    "The smallest increment allowed, 0.125 of the step, failed.",
    "last accepted increment, 0.625 of the way from step 1 to step 2")
  check.equal(#run:column "grip.fx", 1)
  local last = run:attempts(2)
  check.near({ last[#last].from, last[#last].to }, { 0.625, 0.75 })
  -- A later stage begins at the model's targets.
  check.near(model:run{ { steps = 1, grip = { 1.7, 0 } } }:column "grip.ux", { 1.7 })
  run = climb(4, rough(1, 2, 0), { min = 1 / 4 })
  check.holds(run.failure, "Attempts, by fraction of the step: 1 (diverged), 0.5 (diverged), 0.25 (diverged).",
    "The model is at its last accepted step, 1.")
  check.equal(run.cutbacks, 2)
end)

check.case("a step in which nothing moves is not cut: shorter ones would be the same", function()
  local model = model_of(function() return "cycling" end)
  local run = model:run{ { steps = 2, grip = { 0, 0 } } }
  check.equal({ run.reason, run.cause, run.cutbacks, #run:attempts(1) }, { "cycling", "cycling", 0, 5 })
end)

check.case("an interrupted step is not repeated", function()
  local model = model_of(function() return "interrupted" end)
  local run = model:run({ { steps = 2, grip = { 1, 0 } } }, { step = { adaptive = true } })
  check.equal({ run.reason, run.cutbacks, model.spent }, { "interrupted", 0, 1 })
end)

check.case("arc-length increments that all leave the path end the run with 'left_path'", function()
  local model = model_of(function() return "iterations" end)
  local last = 1
  function model:last_length() return last end
  function model:solve_arc(options)
    last = 2 * options.length -- along the tangent: more than any bend of one path
    return { converged = true, reason = "converged", message = "", fraction = 0.5, iterations = 2,
      residuals = { 1, 0 } }
  end
  function model:restore(saved) self.accepted, self.next, last = saved, saved, 1 end
  local run = model:run({ { steps = 2, grip = { 1, 0 } } }, { arc_length = true })
  check.equal({ run.failed, run.reason, run.steps, run.controls[1].to },
    { true, "left_path", 0, "arc length" })
  check.equal(model.accepted, { 0, 0 })
end)

check.case("with on_iteration steps are taken iteration by iteration", function()
  local plain, seen = model_of():run(two_stages), {}
  local run = model_of():run(two_stages, { on_iteration = function(info)
    seen[#seen + 1] = ("%d %d %s"):format(info.step, info.iteration, info.reason)
  end })
  check.equal(run:column "grip.fx", plain:column "grip.fx")
  check.equal({ #seen, seen[1], seen[3], seen[18] }, { 18, "1 1 iterating", "1 3 converged", "6 3 converged" })
end)

check.case("a single step is not plural", function()
  local output = check.script [[
local sg = require "signorini"
local block = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = {1, 1}, order = "N2",
                       material = sg.linear_elastic{ E = 1, nu = 0.3 } }
local model = sg.model{ bodies = { block = block },
                        supports = { lid = { on = block:face "north", drive = "y", fix = "x" } } }
model:run{ { steps = 1, lid = {1} } }
print(model)
]]
  check.holds(output, "stage 1: 1 step, ", "12 of them free, 1 support, 0 contacts")
end)

check.case("keys among the stages that would have no effect", function()
  local stage = { steps = 2, grip = { 0, -0.1 } }
  for key, message in pairs {
    newton = "options are the second argument, model:run({ … }, { newton = … })",
    grip = "put 'grip' into a stage, model:run({ { steps = 10, grip = … }, … }", x1 = "a list, then the options",
    [7] = "stages are counted from 1 without gaps", [true] = "counted from 1 without gaps",
  } do
    check.fails(function() model_of():run{ stage, [key] = { 1 } } end,
      "model:run: stages must be a list of stages (parts of the load path), got ", message)
  end
  check.fails(function() model_of():run({ stage }, { step = { adaptive = false, min = 0.1 } }) end,
    "model:run: options.step: min has no effect with adaptive = false")
end)

check.case("a run and the argument of on_step are strict about names", function()
  local seen
  local run = model_of():run(two_stages, { on_step = function(info) seen = info end })
  check.fails(function() return run.faild end, "a run has no 'faild'; did you mean 'failed'?")
  check.fails(function() return run.bogus end, "a run has no 'bogus': it has adaptations, attempts", "timings")
  check.fails(function() run.x = 1 end, "a run cannot store 'x'")
  check.equal({ run.failure == nil, run.cause == nil, type(run.timings) }, { true, true, "table" })
  check.fails(function() return seen["grip.fu"] end, "has no 'grip.fu'; did you mean 'grip.f")
end)
