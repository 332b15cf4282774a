-- The load path on a model of one spring: targets, records, the ends a run can come to, wrong stages and options.

local sg = require "signorini"
local check = require "check"
local spring = require "spring"
local run_path = require "signorini.run"

local function model_of(fails)
  local model = spring(fails)
  model.run = run_path
  return model
end

local two_stages = { { name = "press", steps = 4, grip = { 0, -0.4 } }, { name = "slide", steps = 2, grip = { 1, -0.4 } } }

check.case("each stage goes linearly from where the support is to its target", function()
  local model = model_of()
  local run = model:run(two_stages)
  check.near(run:column "grip.fy", { -0.3, -0.6, -0.9, -1.2, -1.2, -1.2 }, 1e-15)
  check.equal(run:column "grip.fx", { 0, 0, 0, 0, 1, 2 })
  check.equal(run:column "bed.fx", { 0, 0, 0, 0, -1, -2 })
  check.near(run:column "interface.area", { 0.1, 0.2, 0.3, 0.4, 0.4, 0.4 }, 1e-15)
  check.equal(run:column "step", { 1, 2, 3, 4, 5, 6 })
  check.equal(run:column "iterations", { 3, 3, 3, 3, 3, 3 })
  check.equal(model.accepted, { 1, -0.4 }) -- met exactly, not to rounding
  check.equal({ run.failed, run.reason, run.steps, run.iterations }, { false, "completed", 6, 18 })
  check.equal(run:residuals(6), { 1, 1e-3, 1e-12 })
  check.equal(#run:column "wall", 6)
end)

check.case("a second run goes on from the accepted state; a support that is not named stays", function()
  local model = model_of()
  model:run(two_stages)
  local run = model:run{ { steps = 3 }, { steps = 2, grip = { 2, 0 } } }
  check.near(run:column "grip.fx", { 2, 2, 2, 3, 4 })
  check.near(run:column "grip.fy", { -1.2, -1.2, -1.2, -0.6, 0 })
  check.equal(run:column "step", { 1, 2, 3, 4, 5 })
end)

check.case("a failed step is rolled back and reported", function()
  local model = model_of(function(x) return x > 0.5 and "diverged" or nil end)
  local run = model:run(two_stages)
  check.equal({ run.failed, run.reason, run.steps }, { true, "diverged", 5 })
  check.equal(model.accepted, { 0.5, -0.4 })
  check.equal(model.calls[#model.calls], "rollback")
  check.holds(run.report, "step 6 (stage 'slide', 2 of 2)", "no luck", "1, 0.001, 0.01", "last accepted step, 5")
  check.equal(run:residuals(6), { 1, 1e-3, 1e-2 })
  check.equal(#run:column "grip.fx", 5)
  check.holds(tostring(run), "diverged: step 6", "press", "slide", "total")
end)

check.case("a run that fails at once has columns, all empty", function()
  local run = model_of(function() return "interrupted" end):run(two_stages)
  check.equal({ run.reason, run.steps }, { "interrupted", 0 })
  check.equal(run:column "grip.fx", {})
  check.holds(run.report, "its start")
  check.holds(tostring(run), "interrupted")
end)

check.case("on_step sees every accepted step and may end the run", function()
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
  local function dawdle()
    local start = os.clock()
    while os.clock() - start < 0.02 do end
  end
  local run = model_of():run({ { steps = 3, grip = { 1, 1 } } }, { on_step = dawdle })
  check.equal(run.wall < 0.02, true)
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
  check.equal(run:columns(), { "step", "iterations", "wall", "bed.fx", "bed.fy", "grip.fx", "grip.fy", "interface.fx",
    "interface.fy", "interface.area", "interface.max_pressure", "interface.max_penetration" })
  check.fails(function() run:column "grip.fz" end, "run_test.lua:", "'grip.fz'", "grip.fy")
  check.fails(function() run:residuals(7) end, "there is no step 7; the run has steps 1 to 6")
  run:column("step")[1] = 99 -- a copy
  check.equal(run:column("step")[1], 1)
end)

check.case("the table and the file tell the same", function()
  local run = model_of():run(two_stages)
  check.holds(tostring(run), "press      4          12      3.00", "total      6          18      3.00",
    "factorisation and solve")
  local name = os.tmpname()
  run:csv(name)
  local read = sg.csv.read(name)
  os.remove(name)
  check.equal(read.columns, run:columns())
  for _, column in ipairs(read.columns) do check.equal(read:column(column), run:column(column)) end
end)

check.case("wrong stages and options are refused before the first step", function()
  local model = model_of()
  local wrong = {
    { nil, "stages is missing" },
    { {}, "stages must be a list of stages", "write model:run{ {" },
    { { steps = 2, grip = { 0, 1 } }, "stages must be a list of stages" },
    { { { grip = { 0, 1 } } }, "stage 1.steps is missing" },
    { { { name = "press", steps = 0 } }, "press.steps must be a whole number of at least 1, got the number 0" },
    { { { steps = 1.5 } }, "got the number 1.5" },
    { { { steps = "2" } }, "got the string '2'" },
    { { { steps = 2, gripp = { 0, 1 } } }, "unknown argument 'gripp'", "did you mean 'grip'?", "name, steps, bed, grip" },
    { { { steps = 2, { 0, 1 } } }, "unknown argument '1'" },
    { { { steps = 2, bed = { 0, 1 } } }, "'bed'", "not driven", 'drive = "x"' },
    { { { steps = 2, grip = { 0 } } }, "grip must be a list of 2 displacements (x, y), got a list of 1 value" },
    { { { steps = 2, grip = 1 } }, "grip must be a list of 2 displacements (x, y), got the number 1" },
    { { { steps = 2, grip = { 0, "1" } } }, "grip[2]", "got the string '1': remove the quotes" },
    { { { steps = 2, grip = { 0, 0 / 0 } } }, "grip[2]", "nan" },
    { { { steps = 2 }, 7 }, "stage 2 must be a table" },
  }
  for _, case in ipairs(wrong) do
    check.fails(function() model:run(case[1]) end, "run_test.lua:", "model:run: ", table.unpack(case, 2))
  end
  local wrong_options = {
    { { newtn = {} }, "unknown argument 'newtn'", "did you mean 'newton'?" },
    { { newton = { tolerence = 1 } }, "unknown argument 'tolerence' in options.newton", "did you mean 'tolerance'?" },
    { { newton = { tolerance = -1 } }, "newton.tolerance must be a positive number, got the number -1" },
    { { newton = { iterations = 0 } }, "newton.iterations must be a whole number" },
    { { linear = 3 }, "linear must be a string" },
    { { on_step = 3 }, "on_step must be a function" },
  }
  for _, case in ipairs(wrong_options) do
    check.fails(function() model:run({ { steps = 1 } }, case[1]) end, "run_test.lua:", table.unpack(case, 2))
  end
  check.equal(model.calls, {})
end)

check.done()
