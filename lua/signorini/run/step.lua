-- One step of a load path: attempts with the controls and their fallbacks, of the whole step or of a part of it.

local check = require "signorini.call.check"
local contact_changes = require "signorini.run.contact_changes"
local controls = require "signorini.run.controls"
local core = require "signorini.core"
local lists = require "signorini.call.lists"
local on_behalf_of = require "signorini.call.on_behalf_of"
local stages = require "signorini.run.stages"
local steps = require "signorini.run.steps"

-- Attempts without a predictor that failed; 3D block ironing took 846, 743, 706 iterations with 2, 4, 8.
local predictor_pause = 8
-- Iterations of failed attempts from one state, in units of newton.iterations, after which a step is given up; and
-- limit of those of an attempt in pseudo-time in the same units.
local most_failing, moves_per_iteration = 16, 40
local longest_chord = 1.25 -- of an increment, in units of its length along the tangent: at most 37° between the two

--- The object that a policy works on: step `number` of a stage; the fraction `done` of it is accepted.
local Step = {}
Step.__index = Step

--- Notes where a stage begins.
function Step.begin_stage(model, stage)
  local starts = stage.starts or {} -- those of a resumed stage
  stage.fits = stage.fits or contact_changes.starts(model, stage)
  stage.starts, stage.now = starts, {}
  for name in pairs(stage.targets) do
    starts[name], stage.now[name] = starts[name] or model:target(name), {}
  end
  if stage.duration then starts[stages.clock] = starts[stages.clock] or { model:time() } end
end

--- Begins step `number` of a stage.
function Step.begin(model, run, stage, number, options, display)
  run:begin_step()
  local step = setmetatable({
    model = model, run = run, stage = stage, number = number, options = options, solver = options.solver, done = 0,
    display = display,
  }, Step)
  step.start = options.on_step and step:snapshot()
  return step
end

--- The same step of another model, which follows this one.
function Step:of_neighbor(model, stage, options)
  return setmetatable({ model = model, run = self.run, stage = stage, number = self.number, options = options }, Step)
end

--- The accepted state, with those of the run's neighbors.
function Step:snapshot()
  local neighbors = self.run.neighbors
  return { model = self.model:snapshot(), neighbors = neighbors and neighbors:snapshot() }
end

function Step:restore(saved)
  self.model:restore(saved.model)
  if saved.neighbors then self.run.neighbors:restore(saved.neighbors) end
end

--- Prescribes the targets at the fraction `to` of the step.
function Step:set_targets(to)
  local stage = self.stage
  for name in pairs(stage.targets) do
    self.model:set_target(name, stages.at(stage, name, self.number, to, stage.now[name]))
  end
  local time = stages.time(stage, self.number, to)
  if time then self.model:set_time(time) end
  contact_changes.set(self.model, stage, stages.fraction(stage, self.number, to))
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
    if self.run.neighbors then self.run.neighbors:follow(self, to, solver) end
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
  if self.done == 0 and to < 1 then self.start = self.start or self:snapshot() end
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
  local saved, done, account = self:snapshot(), self.done, self.run.step
  local increments, length = account.increments, account.length
  self:restore(self.start)
  self.done, self.again, account.increments, account.length = 0, true, 0, length and 0
  local result = self:attempt(1)
  self.again = nil
  if not result.converged then
    self:restore(saved)
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

--- True if the step changes a target, the penalties or an offset, or if something flows in it.
function Step:moves()
  local penalty = self.options.penalty
  if type(self.stage.duration) == "number" and core.flows(self.model) then return true end
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
  local there = stages.fraction(self.stage, self.number, part)
  return table.concat(lists.joined(stages.places(self.model, self.stage, self.number, part),
    contact_changes.places(self.stage, there)), ", ")
end

--- Records a change of what drives the path.
function Step:switch_control(to, reason)
  self.run:record_control(to, self:place(self.done), reason)
end

--- Counts a failed attempt that will be repeated with a shorter one.
function Step:cut_back() self.run:account("cutbacks", 1) end

return Step
