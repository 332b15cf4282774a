-- The load path: model:run(stages, options). Each stage moves the driven supports and the loads in equal steps from
-- their present values to their targets; each step is solved, then accepted. A run is the record of this.

local core = require "signorini.core"
local adapt = require "signorini.run.adapt"
local arc_length = require "signorini.run.arc_length"
local checkpoint = require "signorini.run.checkpoint"
local contact_changes = require "signorini.run.contact_changes"
local controls = require "signorini.run.controls"
local history = require "signorini.errors.history"
local jumps = require "signorini.run.jumps"
local lists = require "signorini.call.lists"
local progress = require "signorini.run.progress"
local run_warnings = require "signorini.run.run_warnings"
local stages = require "signorini.run.stages"
local states = require "signorini.run.states"
local Step = require "signorini.run.step"
local steps = require "signorini.run.steps"
local Run = require "signorini.run.run_result"

local where = "model:run"

-- ── Reading the arguments ────────────────────────────────────────────────────────────────────────────────────────────

--- The controls that are on, named as in model:diagnose. Fallbacks include damping, a line search and pseudo-transient
--- continuation.
local function controls_on(options)
  local solver = options.solver
  local is_on = {
    step = options.step.adaptive, line_search = solver.line_search ~= "none" or options.fallback,
    damping = options.damping or options.fallback, pseudo_transient = options.pseudo_transient or options.fallback,
    active_set_changes = solver.active_set_changes > 0, arc_length = options.arc_length, penalty = options.penalty,
  }
  return lists.filter(lists.sorted_names(is_on), function(name) return is_on[name] end)
end

--- The options with { solver (arguments of model:solve_step), tries (see controls.lua), policy (see steps.lua), on
--- (controls that are on), checkpoints (see checkpoint.lua), states (to be stored) }.
local function read_options(model, options, path, total)
  options.solver = controls.solver(model, options)
  options.on, options.checkpoints = controls_on(options), checkpoint(options)
  options.following = adapt.options(model, options)
  options.policy = options.step.adaptive and steps.halving(options.step) or steps.plain()
  if options.arc_length then options.policy = arc_length.policy(options.policy) end
  options.tries = options.fallback and controls.fallbacks(model, options.solver) or {}
  options.states = states.read(where, options.states, path, total)
  if options.threads then core.set_threads(options.threads) end -- last, so that a rejected call does not set them
  return options
end

-- ── The path ─────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Records why a step failed; searches for a turning point, by arc length, unless the reason is known.
local function fail(run, step, result)
  local began, known = core.now(), steps.is_wanted(result) or steps.is_hopeless(result)
  known = known or contact_changes.ramps(step.stage) or not step:changes_targets()
  local turn = not known and arc_length.turning_point(step)
  run:account("wall", core.now() - began)
  run:record_failure(step, result, turn and step:place(turn))
end

--- Takes a step and calls on_step, which may request smaller increments. Returns the last result, and the result of
--- on_step.
local function take(step, run, options)
  while true do
    local result = options.policy:take(step)
    if not result.converged then return result end
    run:record_step()
    if options.measure then run:record_measured(options.measure(step.model)) end
    if run.neighbors then run.neighbors:record(options.measure) end
    step.display:step(step.stage.name)
    if not options.on_step then return result end
    step.display:clear()
    core.interrupted_run = run -- for the prompt, where Ctrl-C ends the function
    local answer = options.on_step(run:info(step.stage, result))
    core.interrupted_run = nil
    if answer and answer ~= "stop" and answer ~= "cut" then run:record_extra(answer) end
    if answer ~= "cut" then return result, answer end
    run:drop_step()
    if run.neighbors then run.neighbors:drop() end
    step:restore(step.start)
    step.done = 0
    if not options.policy:shorten(step) then
      return { converged = false, reason = "cut", message = "on_step requested shorter steps, but these are not "
        .. "allowed. Hint: set step = { adaptive = true, min = … }", residuals = {} }
    end
    step:cut_back()
  end
end

--- Ends a run and prints its warnings, unless it is a level of several. `early`: warnings about the path.
local function close(run, model, display, early, record, is_level)
  run:finish(model, early)
  if run.companions then require("signorini.errors.bars").attach(run, model) end
  if record then record:finish(run) end
  if not is_level then run_warnings.show(run, display) end
  return run
end

--- `given.neighbors`: models that follow the run, see gradients/neighbors.lua. `before`: the runs that have led to the
--- present state, as far as they are known.
local function follow(model, list, given, before)
  local path, total = stages.read(model, list, given)
  local options = read_options(model, lists.merged(given), path, total)
  local policy, checkpoints = options.policy, options.checkpoints
  local early = run_warnings.of_path(model, path, options.solver)
  local run = Run.new(model, path)
  run.neighbors = given.neighbors
  local place = checkpoints:begin(model, run, path, policy)
  run.used = { predictor = options.predictor, fallback = options.fallback, adaptive = options.step.adaptive,
               arc_length = options.arc_length, tolerance = options.solver.tolerance }
  run.companions = run.companions or given.companions
  if options.errors and not run.companions then
    run.companions = require "signorini.errors.companions".of_run(model, list, given, before)
  end
  local display = progress(total - run.steps, options.verbose)
  if options.states.wants(run.steps) then run:store_state(model, path[place.stage].name) end
  local record = options.hdf5
    and require("signorini.output.hdf5").start(where, model, run, options, path[place.stage].name)
  for index = place.stage, #path do
    local stage = path[index]
    Step.begin_stage(model, stage)
    if run.neighbors then run.neighbors:begin_stage(index) end
    if place.number == 0 then run:begin_stage(model, stage) end
    for number = place.number + 1, stage.steps do
      options.following:step(model, run)
      local step = Step.begin(model, run, stage, number, options, display)
      local result, answer = take(step, run, options)
      if answer == "stop" or result.reason == "stopped" then
        run.reason = "stopped"
      elseif not result.converged then
        fail(run, step, result)
      end
      if result.converged then
        jumps.note(run.jumps, model, run.steps, run.step.length)
        run_warnings.note_law(run, model)
        run_warnings.note_wear(run, model)
        place.stage, place.number = index, number
        if options.states.wants(run.steps, function() return run:info(stage, result) end) then
          run:store_state(model, stage.name)
        end
        if record then record:step(run, stage.name) end
        checkpoints:step(model, run, path, place, policy)
      end
      if run.reason == "interrupted" then core.interrupted_run = run end -- for the prompt
      if run.reason ~= "completed" then
        display:line(("%s: %s in step %d of %d"):format(stage.name, run.reason, number, stage.steps))
        if options.states.last then run:store_state(model, stage.name) end
        run_warnings.note_state(run, model, stage, true)
        return close(run, model, display, early, record, given.companions)
      end
    end
    place.number = 0
    run_warnings.note_state(run, model, stage, index == #path)
    display:stage_end(stage.name, stage.steps, run.stages[#run.stages].iterations, run.stages[#run.stages].wall)
  end
  display:clear()
  if options.states.last then run:store_state(model, path[#path].name) end
  return close(run, model, display, early, record, given.companions)
end

--- The run of a model along stages; both arguments have been checked against the table of model:run.
return function(model, list, options)
  if options.tolerance then return require "signorini.errors.ladder".run(model, list, options) end
  local before = history.of(model)
  local run = follow(model, list, options, before)
  history.note(model, before, list, options, run)
  return run
end
