-- The load path: model:run(stages, options). Each stage moves the driven supports and the loads in equal steps from
-- their present values to their targets; each step is solved, then accepted. A run is the record of this.

local core = require "signorini.core"
local adapt = require "signorini.run.adapt"
local arc_length = require "signorini.run.arc_length"
local check = require "signorini.call.check"
local checkpoint = require "signorini.run.checkpoint"
local contact_changes = require "signorini.run.contact_changes"
local controls = require "signorini.run.controls"
local jumps = require "signorini.run.jumps"
local lists = require "signorini.call.lists"
local on_behalf_of = require "signorini.call.on_behalf_of"
local progress = require "signorini.run.progress"
local run_warnings = require "signorini.run.run_warnings"
local stages = require "signorini.run.stages"
local states = require "signorini.run.states"
local steps = require "signorini.run.steps"
local Run = require "signorini.run.run_result"

local where = "model:run"
-- Attempts without a predictor that failed; 3D block ironing took 846, 743, 706 iterations with 2, 4, 8.
local predictor_pause = 8
-- Iterations of failed attempts from one state, in units of newton.iterations, after which a step is given up; and
-- limit of those of an attempt in pseudo-time in the same units.
local most_failing, moves_per_iteration = 16, 40
local longest_chord = 1.25 -- of an increment, in units of its length along the tangent: at most 37° between the two

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

-- ── One step ─────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The object that a policy works on: step `number` of a stage; the fraction `done` of it is accepted.
local Step = {}
Step.__index = Step

local function begin_step(model, run, stage, number, options, display)
  run:begin_step()
  return setmetatable({
    model = model, run = run, stage = stage, number = number, options = options, solver = options.solver, done = 0,
    start = options.on_step and model:snapshot(), display = display,
  }, Step)
end

--- Prescribes the targets at the fraction `to` of the step.
function Step:set_targets(to)
  local stage = self.stage
  for name in pairs(stage.targets) do
    self.model:set_target(name, stages.at(stage, name, self.number, to, stage.now[name]))
  end
  contact_changes.set(self.model, stage, (self.number - 1 + to) / stage.steps)
end

--- Sets the factor of the penalties at the fraction `to` of the step, if they grow along the path.
function Step:set_penalty(to)
  local penalty = self.options.penalty
  if not penalty then return end
  local part = math.min(1, (self.run.steps + to) / penalty.steps)
  self.model:set_penalty_factor(part == 1 and 1 or penalty.start ^ (1 - part))
end

--- The result of a low-level method, whose errors are those of model:run.
local function call(model, method, solver)
  return on_behalf_of("model:run", "model:" .. method, model[method], model, solver)
end

--- Solves for the present targets; on_iteration is called after each iteration and may end the attempt.
function Step:solve(solver, to)
  local on_iteration = self.options.on_iteration
  if not on_iteration then return call(self.model, "solve_step", solver) end
  local result
  repeat
    result = call(self.model, "iterate", solver)
    if result.reason == "interrupted" then return result end
    local residuals, energies = result.residuals, result.energies
    local ok, answer = pcall(on_iteration, {
      stage = self.stage.name, step = self.run.steps + 1, from = self.done, to = to, iteration = result.iterations,
      residual = residuals[#residuals], energy = energies[#energies], reason = result.reason,
    })
    if not ok and core.answer_interrupt() then -- Ctrl-C or the end of --time reached it first
      if result.reason == "iterating" then result.reason, result.message = "interrupted", core.interruption() end
      return result
    end
    if not ok then
      self.model:rollback()
      error(answer, 0)
    end
    if answer and answer ~= "stop" and answer ~= "cut" then
      self.model:rollback()
      check.reject("on_iteration", "its result", "nothing, \"stop\" or \"cut\"", answer)
    end
    if result.reason == "iterating" and (answer == "stop" or answer == "cut") then
      result.reason = answer == "stop" and "stopped" or "cut"
      result.message = ("on_iteration requested it in iteration %d"):format(result.iterations)
    end
  until result.reason ~= "iterating"
  return result
end

--- Shows the accepted fraction of the step after an attempt.
function Step:show_progress(part) self.display:attempt(self.stage.name, part, self.run.histories) end

--- The solver's arguments with the iterations that are left to attempts from the present state; nil if none are.
function Step:limited(solver)
  local whole = most_failing * self.solver.iterations
  local left = whole
  for _, attempt in ipairs(self.run.histories[#self.run.histories]) do
    if not attempt.converged and attempt.from == self.done then left = left - attempt.iterations end
  end
  if left == whole then return solver end
  if left < 1 then return nil end
  if solver.pseudo_transient then left = math.max(1, left // moves_per_iteration) end
  return left < solver.iterations and lists.merged(solver, { iterations = left }) or solver
end

--- True if failed attempts have used up the iterations from the present state.
function Step:is_spent() return not self:limited(self.solver) end

--- One attempt with given controls: accepts or rolls back, diagnoses a failure. `fallback`: name of the fallback, if
--- another attempt has failed before.
function Step:try(solver, to, fallback)
  local began = core.now()
  self:set_targets(to)
  self:set_penalty(to)
  if solver.verbose then require("signorini.run.verbose").attempt(self, to, fallback) end
  local result = self:solve(solver, to)
  if result.converged then
    self.model:accept()
    local length = self.run.step.length
    self.run.step.length = length and length + self.model:last_length()
  else
    if not steps.is_wanted(result) then result.diagnosis = self.model:diagnose(self.options.on) end
    self.model:rollback()
  end
  self.run:record_attempt(self.done, to, result, core.now() - began, fallback, nil, self.again)
  self:show_progress(result.converged and to or self.done)
  return result
end

--- Solves for the targets at the fraction `to` of the step, with fallbacks where that fails (`shorter`: a shorter
--- attempt can follow); then accepts or rolls back. Returns the solver's result: that of the first attempt if all fail.
--- After failures of a predictor, the next attempts do without it. Under arc-length control no fallback is tried that
--- may leave the path.
function Step:attempt(to, shorter)
  local run, tries, last = self.run, self.options.tries, not shorter and not self.options.arc_length
  if self.done == 0 and to < 1 then self.start = self.start or self.model:snapshot() end
  local plain = run.wary > 0 and tries.tangent
  local first = self:try(self:limited(plain and plain.solver or self.solver) or self.solver, to)
  run.wary = math.max(0, run.wary - 1)
  local result = first
  for _, fallback in ipairs(tries) do
    if result.converged or steps.is_wanted(result) or steps.is_hopeless(result) then break end
    local now = fallback.early == true or fallback.early == result.reason or last
    local solver = now and fallback ~= plain and self:limited(fallback.solver)
    if solver then result = self:try(solver, to, fallback.name) end
  end
  if first ~= result and not plain then run.wary = predictor_pause end
  if not result.converged and not steps.is_wanted(result) then return first end
  if result.converged then self.done = to end
  return result
end

--- The whole step at once from the state before it, whatever fraction is accepted; after a failure this is restored.
function Step:attempt_from_start()
  local saved, done, account = self.model:snapshot(), self.done, self.run.step
  local increments, length = account.increments, account.length
  self.model:restore(self.start)
  self.done, self.again, account.increments, account.length = 0, true, 0, length and 0
  local result = self:attempt(1)
  self.again = nil
  if not result.converged then
    self.model:restore(saved)
    self.done, account.increments, account.length = done, increments, length
  end
  return result
end

--- Prescribes the targets one step ahead of the accepted ones.
function Step:set_next_targets()
  for name in pairs(self.stage.targets) do
    self.model:set_target(name, stages.ahead(self.model, self.stage, name, self.number))
  end
  contact_changes.set(self.model, self.stage, 1) -- without offsets and overlaps, which arc length cannot follow
end

--- Takes an arc-length increment, backward beyond a turning point, and accepts it, without recording it in the run. An
--- increment whose chord is much longer than its part along the tangent has left the path for another part of it and
--- counts as failed. Returns the result, the fraction of the step that was reached, and the state before the increment;
--- `diagnoses`: after a failure, also the diagnosis.
function Step:solve_arc(length, iterations, diagnoses)
  self:set_next_targets()
  local model, solver, saved = self.model, self.solver, self.model:snapshot()
  if solver.verbose then require("signorini.run.verbose").arc(self, length, diagnoses) end
  local result = model:solve_arc { length = length, iterations = iterations, tolerance = solver.tolerance,
                                   linear = solver.linear, verbose = solver.verbose }
  if not result.converged and diagnoses and not steps.is_wanted(result) then
    result.diagnosis = model:diagnose(self.options.on)
  end
  if result.converged then model:accept() else model:rollback() end
  if result.converged and model:last_length() > longest_chord * length then
    model:restore(saved)
    result.converged, result.reason = false, "left_path"
  end
  return result, self.done + result.fraction, saved
end

--- True if the step changes a target; without that there is no path that arc length could follow.
function Step:changes_targets() return stages.moves(self.model, self.stage, self.number) end

--- True if the step changes a target, the penalties or an offset.
function Step:moves()
  local penalty = self.options.penalty
  return contact_changes.ramps(self.stage) or penalty and self.run.steps < penalty.steps or self:changes_targets()
end

--- True if there are fallbacks for the rest of a step.
function Step:has_fallbacks() return #self.options.tries > 0 and not self.options.arc_length end

--- An arc-length increment, accepted unless it passes the end of the step.
function Step:attempt_arc(length, iterations)
  local began = core.now()
  local result, to, saved = self:solve_arc(length, iterations, true)
  local accepted = result.converged and to < 1
  if result.converged and not accepted then self.model:restore(saved) end
  self.run:record_attempt(self.done, to, result, core.now() - began, nil, true)
  self:show_progress(accepted and to or self.done)
  if accepted then
    self.done = to
    self.run:record_arc(to)
  end
  return result, to
end

--- Solves for the targets at a fraction of the step, with a line search if necessary, without recording it in the run.
function Step:probe(to)
  local searching, differs = controls.changed(self.solver, { line_search = "residual", pseudo_transient = false })
  local result
  for _, solver in ipairs { self.solver, differs and searching or nil } do
    self:set_targets(to)
    if solver.verbose then require("signorini.run.verbose").probe(self, to) end
    result = self.model:solve_step(solver)
    if result.converged then self.model:accept() else self.model:rollback() end
    if result.converged or steps.is_wanted(result) then break end
  end
  return result
end

--- What drives the path at a fraction of the step, in words: "edge.angle = 69.86".
function Step:place(part)
  local there = (self.number - 1 + part) / self.stage.steps
  return table.concat(lists.joined(stages.places(self.model, self.stage, self.number, part),
    contact_changes.places(self.stage, there)), ", ")
end

--- Records a change of what drives the path.
function Step:switch_control(to, reason)
  self.run:record_control(to, self:place(self.done), reason)
end

--- Counts a failed attempt that will be repeated with a shorter one.
function Step:cut_back() self.run:account("cutbacks", 1) end

-- ── The path ─────────────────────────────────────────────────────────────────────────────────────────────────────────

local function begin_stage(model, stage)
  local starts = stage.starts or {} -- those of a resumed stage
  stage.fits = stage.fits or contact_changes.starts(model, stage)
  stage.starts, stage.now = starts, {}
  for name in pairs(stage.targets) do
    starts[name], stage.now[name] = starts[name] or model:target(name), {}
  end
end

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
    step.display:step(step.stage.name)
    if not options.on_step then return result end
    step.display:clear()
    core.interrupted_run = run -- for the prompt, where Ctrl-C ends the function
    local answer = options.on_step(run:info(step.stage, result))
    core.interrupted_run = nil
    if answer and answer ~= "stop" and answer ~= "cut" then run:record_extra(answer) end
    if answer ~= "cut" then return result, answer end
    run:drop_step()
    step.model:restore(step.start)
    step.done = 0
    if not options.policy:shorten(step) then
      return { converged = false, reason = "cut", message = "on_step requested shorter steps, but these are not "
        .. "allowed. Hint: set step = { adaptive = true, min = … }", residuals = {} }
    end
    step:cut_back()
  end
end

--- Ends a run and prints its warnings except those of sg.model. `early`: warnings about the path.
local function close(run, model, display, early, record)
  run:finish(model, early)
  if record then record:finish(run) end
  for _, warning in ipairs(run.warnings) do
    if not lists.holds(model:warnings(), warning) then display:line(warning) end
  end
  return run
end

--- The run of a model along stages; both arguments have been checked against the table of model:run.
return function(model, list, options)
  local path, total = stages.read(model, list, options)
  options = read_options(model, options, path, total)
  local policy, checkpoints = options.policy, options.checkpoints
  local early = run_warnings.of_path(model, path, options.solver)
  local run = Run.new(model, path)
  local place = checkpoints:begin(model, run, path, policy)
  run.used = { predictor = options.predictor, fallback = options.fallback, adaptive = options.step.adaptive,
               arc_length = options.arc_length }
  local display = progress(total - run.steps, options.verbose)
  if options.states.wants(run.steps) then run:store_state(model, path[place.stage].name) end
  local record = options.hdf5
    and require("signorini.output.hdf5").start(where, model, run, options, path[place.stage].name)
  for index = place.stage, #path do
    local stage = path[index]
    begin_stage(model, stage)
    if place.number == 0 then run:begin_stage(model, stage) end
    for number = place.number + 1, stage.steps do
      options.following:step(model, run)
      local step = begin_step(model, run, stage, number, options, display)
      local result, answer = take(step, run, options)
      if answer == "stop" or result.reason == "stopped" then
        run.reason = "stopped"
      elseif not result.converged then
        fail(run, step, result)
      end
      if result.converged then
        jumps.note(run.jumps, model, run.steps, run.step.length)
        run_warnings.note_law(run, model)
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
        return close(run, model, display, early, record)
      end
    end
    place.number = 0
    run_warnings.note_state(run, model, stage, index == #path)
    display:stage_end(stage.name, stage.steps, run.stages[#run.stages].iterations, run.stages[#run.stages].wall)
  end
  display:clear()
  if options.states.last then run:store_state(model, path[#path].name) end
  return close(run, model, display, early, record)
end
