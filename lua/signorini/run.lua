-- The load path: model:run(stages, options). Each stage moves the driven supports in equal steps from where they are to
-- where they shall be; each step is solved, then accepted. What happened is kept in a run.

local core = require "signorini.core"
local arguments = require "signorini.arguments"
local progress = require "signorini.progress"
local Run = require "signorini.run_result"

local where = "model:run"

-- ── Reading the arguments ────────────────────────────────────────────────────────────────────────────────────────────

--- The target of a support at the end of a stage as a list by driven component.
local function read_target(model, stage, support, value)
  local driven = model:driven(support)
  local name = ("%s.%s"):format(stage, support)
  local components = table.concat(driven, ", ")
  if #driven == 0 then
    core.fail(("%s: the support '%s' of stage '%s' is not driven: give it drive = \"x\", \"y\" or \"xy\" in sg.model")
      :format(where, support, stage))
  end
  if type(value) == "number" and #driven == 1 then value = { value } end
  local expected = ("a list of %d displacement%s (%s)"):format(#driven, #driven == 1 and "" or "s", components)
  if type(value) ~= "table" then arguments.reject(where, name, expected, value) end
  if #value ~= #driven then
    arguments.reject(where, name, expected, value, "one for each component that the support drives")
  end
  for i, component in ipairs(driven) do
    arguments.number(where, ("%s[%d] (displacement in %s)"):format(name, i, component), value[i])
  end
  return table.move(value, 1, #driven, 1, {})
end

local function read_stage(model, index, stage, supports)
  local label = ("stage %d"):format(index)
  if type(stage) ~= "table" then arguments.reject(where, label, "a table { steps = …, <support> = {…} }", stage) end
  local name = arguments.string(where, label .. ".name", stage.name, label)
  local read = { name = name, steps = arguments.count(where, name .. ".steps", stage.steps), targets = {} }
  for key, value in pairs(stage) do
    if type(key) == "string" and supports[key] then
      read.targets[key] = read_target(model, name, key, value)
    elseif key ~= "name" and key ~= "steps" then
      arguments.unknown(where, key, ("stage '%s'"):format(name),
        table.move(supports, 1, #supports, 3, { "name", "steps" }))
    end
  end
  return read
end

local function read_stages(model, stages)
  if type(stages) ~= "table" or #stages == 0 or stages.steps then
    arguments.reject(where, "stages", "a list of stages", stages, "write model:run{ { steps = 10, grip = {0, -1} } }")
  end
  local supports = model:support_names()
  for _, name in ipairs(supports) do supports[name] = true end
  local read, total = {}, 0
  for i, stage in ipairs(stages) do
    read[i] = read_stage(model, i, stage, supports)
    total = total + read[i].steps
  end
  return read, total
end

--- What solve_step takes, and the callback after each step.
local function read_options(options)
  arguments.table(where, "options", options, { "newton", "linear", "on_step" })
  options = options or {}
  local newton = arguments.table(where, "options.newton", options.newton, { "tolerance", "iterations" })
  return {
    tolerance = arguments.positive(where, "newton.tolerance", newton.tolerance, 1e-10),
    iterations = arguments.count(where, "newton.iterations", newton.iterations, 25),
    linear = arguments.string(where, "linear", options.linear, "auto"),
  }, arguments.callback(where, "on_step", options.on_step)
end

-- ── The path ─────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Prescribes the displacements of step k of a stage: linear from the stage's start, its end met exactly.
local function set_targets(model, stage, k)
  local part = k / stage.steps
  for support, goal in pairs(stage.targets) do
    local start, now = stage.starts[support], stage.now[support]
    for i = 1, #goal do now[i] = k == stage.steps and goal[i] or start[i] + (goal[i] - start[i]) * part end
    model:set_target(support, now)
  end
end

local function begin_stage(model, stage)
  stage.starts, stage.now = {}, {}
  for support in pairs(stage.targets) do
    stage.starts[support] = model:target(support)
    stage.now[support] = {}
  end
end

--- Solves one step, then accepts it or rolls back. Returns the solver's result.
local function take_step(model, run, stage, k, solver)
  local began = core.now()
  set_targets(model, stage, k)
  local result = model:solve_step(solver)
  if not result.converged then
    model:rollback()
    run:record_failure(stage, k, result, core.now() - began)
  else
    model:accept()
    run:record(stage, result, core.now() - began)
  end
  return result
end

--- Takes the model along the stages and returns a run. A step that fails ends the run with the last accepted state intact;
--- that is a result (run.failed, run.reason, run.report), not an error.
return function(model, stages, options)
  local path, total = read_stages(model, stages)
  local solver, on_step = read_options(options)
  local run = Run.new(model)
  local display = progress(total)
  for _, stage in ipairs(path) do
    begin_stage(model, stage)
    run:begin_stage(stage)
    for k = 1, stage.steps do
      local result = take_step(model, run, stage, k, solver)
      display:step(stage.name)
      if result.converged and on_step then
        display:clear()
        if on_step(run:info(stage, result)) == "stop" then run.reason = "stopped" end
      end
      if run.reason ~= "completed" then
        display:line(("%s: %s in step %d of %d"):format(stage.name, run.reason, k, stage.steps))
        return run:finish(model)
      end
    end
    display:stage_end(stage.name, stage.steps, run.stages[#run.stages].iterations, run.stages[#run.stages].wall)
  end
  display:clear()
  return run:finish(model)
end
