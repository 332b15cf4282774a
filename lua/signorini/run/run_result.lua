-- The record of a load path: one row per accepted step, its work, and why the path ended.

local adapt = require "signorini.run.adapt"
local check = require "signorini.call.check"
local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local csv = require "signorini.output.csv"
local controls = require "signorini.run.controls"
local energy_balance = require "signorini.run.energy_balance"
local on_behalf_of = require "signorini.call.on_behalf_of"
local jumps = require "signorini.run.jumps"
local lists = require "signorini.call.lists"
local format_table = require("signorini.output.table").text
local named = require "signorini.call.named"
local no_column = require("signorini.call.text").no_column
local recorders = require "signorini.run.recorders"
local run_warnings = require "signorini.run.run_warnings"
local stages = require "signorini.run.stages"
local states = require "signorini.run.states"
local t = require "signorini.call.types"

local Run = {}
Run.__index = Run
Run.__name = "run"
core.types.run = Run

-- Fields that some runs have, or only until they end. All other unknown names are misspelled.
local private = named.strict_type(Run, "run",
  "cause failure timings recorders before step model outline singular companions neighbors neighbor_set errors "
  .. "settings")

function Run:__newindex(name, value)
  if not (rawget(self, "recorders") or private[name]) then -- the run has ended
    core.fail(("a run cannot store '%s'. Hint: keep your own values in a variable, or return them from "
      .. "on_step as columns"):format(tostring(name)))
  end
  rawset(self, name, value)
end

-- ── Recording (by model:run) ─────────────────────────────────────────────────────────────────────────────────────────

--- The data of a path, without what a run adds to it.
local function outline(path)
  return lists.map(path, function(stage)
    return { name = stage.name, steps = stage.steps, duration = stage.duration, growth = stage.growth,
             targets = stage.targets, paths = stage.paths, contacts = stage.contacts }
  end)
end

--- A run without steps. Columns are created once, so that a step only appends numbers.
function Run.new(model, path)
  local run = setmetatable({
    model = model, outline = outline(path),
    failed = false, reason = "completed", steps = 0, rows = 0, iterations = 0, cutbacks = 0, fallback_steps = 0,
    wary = 0, places = {}, wall = 0, stages = {}, controls = {}, fallbacks = {}, energies = {},
    extra = {}, measured = {}, names = {}, values = {}, histories = {}, recorders = {}, stored_states = {},
    before = model:timings(),
    warnings = {}, unsettled = {}, flawed = {}, unstable_law = false, unstable_wear = {},
    jumps = jumps.record(), overlaps = {}, state_findings = {}, examined = 0,
    unexamined = { states = {}, before = {} }, adaptations = {}, contact_zones = {},
  }, Run)
  adapt.begin(run, model)
  recorders.start(run, model, path)
  return run
end

function Run:begin_stage(model, stage)
  energy_balance.note(self.energies, model, energy_balance.is_sudden(model, stage, #self.stages == 0))
  self.overlaps = lists.joined(self.overlaps, run_warnings.overlaps(model, stage))
  jumps.begin(self.jumps, model)
  self.stages[#self.stages + 1] = { name = stage.name, steps = 0, iterations = 0, cutbacks = 0, wall = 0 }
end

--- Begins the attempts of a new step; its wall time and iterations include those of failed attempts.
function Run:begin_step()
  self.step = { increments = 0, iterations = 0, wall = 0, length = 0 }
  self.histories[#self.histories + 1] = {}
end

--- Records an attempt to get from one fraction of the step to another in `seconds`; `fallback`: the fallback that it
--- tried after a failure; `arc`: arc-length increment; `again`: it began at the start of the step although a fraction
--- of the step was accepted.
function Run:record_attempt(from, to, result, seconds, fallback, arc, again)
  for _, account in ipairs { self, self.stages[#self.stages], self.step } do
    account.iterations, account.wall = account.iterations + result.iterations, account.wall + seconds
  end
  if result.converged then self.step.increments = self.step.increments + 1 end
  local attempts = self.histories[#self.histories]
  attempts[#attempts + 1] = { from = from, to = to, converged = result.converged, reason = result.reason,
                              iterations = result.iterations, residuals = result.residuals, fallback = fallback,
                              arc = arc, restarted = again }
  if fallback and result.converged then self.fallback_steps = self.fallback_steps + 1 end
  if result.reason == "singular" then self.singular = result.diagnosis and result.diagnosis.message end
end

--- Adds to an account of the run and of the stage: "cutbacks", or the "wall" time of a diagnosis.
function Run:account(name, amount)
  for _, list in ipairs { self, self.stages[#self.stages] } do list[name] = list[name] + amount end
end

local function append_row(run, position, increments, iterations, wall)
  local row = run.rows + 1
  run.rows = row
  run.step_column[row], run.increment_column[row] = position, increments
  run.iteration_column[row], run.wall_column[row] = iterations, wall
  for _, record in ipairs(run.recorders) do record(row) end
end

--- Adds a column for values that a function of the user returns.
function Run:add_extra(name) self.extra[name] = recorders.add_column(self, name) end

--- Adds the result of a function of the user, `from`, to the last row: numbers by column name. A new name becomes a
--- column. `expected`: what else it may return, in words.
local function record_extra(run, from, expected, results)
  local function reject() check.reject(from, "its result", expected .. "a table of numbers by name", results) end
  if type(results) ~= "table" then reject() end
  for name, value in pairs(results) do
    if type(name) ~= "string" then reject() end
    check.value(t.number, value, from, name)
    if not run.extra[name] then
      if run.values[name] then
        core.fail(("%s: '%s' is already a column of the run. Hint: choose another name"):format(from, name))
      end
      run:add_extra(name)
    end
    run.extra[name][run.rows] = value
  end
end

function Run:record_extra(results) record_extra(self, "on_step", "nothing, \"stop\", \"cut\" or ", results) end

function Run:record_measured(results)
  record_extra(self, "measure", "", results) -- columns with error bars
  for name in pairs(results) do self.measured[name] = true end
end

--- Removes the last row.
function Run:drop_step()
  local stage = self.stages[#self.stages]
  for _, values in pairs(self.values) do values[self.rows] = nil end
  self.rows, self.steps, stage.steps, self.step.length = self.rows - 1, self.steps - 1, stage.steps - 1, 0
end

--- Appends the row of an accepted step.
function Run:record_step()
  local stage, step = self.stages[#self.stages], self.step
  self.steps, stage.steps = self.steps + 1, stage.steps + 1
  append_row(self, self.steps, step.increments, step.iterations, step.wall)
end

--- Appends the row of a state between steps, reached by an arc-length increment; its work is counted with the step's.
function Run:record_arc(done)
  self.step.length = nil
  append_row(self, self.steps + done, 0, 0, 0)
end

--- Records what drives the path from here on: "arc length" or "targets".
function Run:record_control(to, place, reason)
  self.controls[#self.controls + 1] = { step = self.steps + 1, to = to, place = place, reason = reason }
end

local function joined(values, format)
  if #values == 0 then return "none" end
  return table.concat(lists.map(values, function(value) return format:format(value) end), ", ")
end

--- The attempts since the last accepted one, in words; an empty string if there was only one.
local function tried_text(attempts, done)
  local tried = lists.filter(attempts, function(attempt) return not attempt.converged and attempt.from == done end)
  if #tried < 2 then return "" end
  local texts = lists.map(tried, function(attempt)
    local how = attempt.fallback and (" with %s"):format(attempt.fallback) or ""
    return ("%g%s (%s)"):format(attempt.to - done, how, attempt.reason)
  end)
  local again = attempts[#attempts].restarted and " The whole step was also tried from its start." or ""
  return (" Attempts, by fraction of the step: %s.%s"):format(table.concat(texts, ", "), again)
end

--- A place of the model, in words: "contact point in slave element 3 of contact 'c' at X = (1, 2): gap 0.1".
local function place_text(place)
  return ("%s %sof %s '%s' at X = (%s): %s"):format(place.kind,
    place.kind == "contact point" and ("in slave element %d "):format(place.element) or
    ("%d "):format(place.element or place.point),
    place.contact and "contact" or "body", place.contact or place.body, joined(place.X, "%.6g"), place.text)
end

local function places_text(places)
  local texts = lists.map({ table.unpack(places, 1, 3) }, place_text)
  return #texts > 0 and " Worst places: " .. table.concat(texts, "; ") .. "." or ""
end

--- Records why a step was not reached. `turn`: the turning point, in words, if there is one.
function Run:record_failure(step, result, turn)
  local diagnosis = result.diagnosis or { reason = result.reason, message = result.message, cure = "", places = {} }
  self.failed, self.cause, self.places = true, turn and "turning_point" or diagnosis.reason, diagnosis.places
  self.reason = not turn and result.shortest and "minimum_step" or self.cause
  local attempts = self.histories[#self.histories]
  local done = step.done
  local place = self.steps > 0 and ("step, %d"):format(self.steps) or "step, its start"
  if done ~= 0 then
    place = ("increment, %.4g of the way from step %d to step %d"):format(done, self.steps, self.steps + 1)
  end
  self.failure = ("step %d (stage '%s', %d of %d) was not reached: %s.%s%s%s Residuals: %s. The model is at its last "
    .. "accepted %s."):format(self.steps + 1, step.stage.name, step.number, step.stage.steps,
      diagnosis.message ~= "" and diagnosis.message or diagnosis.reason,
      result.shortest and (" The smallest increment allowed, %g of the step, failed."):format(result.shortest) or "",
      tried_text(attempts, done), places_text(diagnosis.places),
      joined(result.residuals, "%.3g"), place)
  if self.cause ~= "interrupted" then run_warnings.note_law(self, step.model) end
  if self.unstable_law then
    self.failure = ("%s The elastic law of body '%s' is unstable at the strains reached, which neither the mesh nor "
      .. "shorter steps change."):format(self.failure, self.unstable_law.body)
  end
  if turn then
    self.failure = ("%s The path has a turning point at %s; prescribed targets can pass it only by a jump to another "
      .. "branch. Hint: model:run(stages, { %s }) follows the path."):format(self.failure, turn,
      controls.arc_options(self.histories))
  elseif diagnosis.cure ~= "" then
    self.failure = ("%s Hint: %s."):format(self.failure, diagnosis.cure)
  end
end

--- Stores the model's present state, once.
function Run:store_state(model, stage)
  local last = self.stored_states[#self.stored_states]
  if last and last.step == self.steps then return end
  self.stored_states[#self.stored_states + 1] = states.store(model, self.steps, stage)
end

--- The argument of on_step: step, stage, iterations, residual, and every column's value by name.
function Run:info(stage, result)
  local info = {}
  for name, values in pairs(self.values) do info[name] = values[self.rows] end
  info.stage, info.residual = stage.name, result.residuals[#result.residuals]
  return named.strict("the argument of on_step", info)
end

--- Closes the accounts: seconds in the bodies, in contact, in factorization and solve, and the rest. `early`: warnings
--- about the path.
function Run:finish(model, early)
  local now, spent = model:timings(), {}
  local rest = self.wall
  for _, account in ipairs { "bulk", "contact", "linear" } do
    spent[account] = now[account] - self.before[account]
    rest = rest - spent[account]
  end
  spent.rest = math.max(0, rest)
  self.timings, self.recorders, self.before, self.step, self.neighbors = spent, nil, nil, nil, nil
  self.fallbacks = controls.counts(self.histories)
  energy_balance.note(self.energies, model)
  jumps.close(self.jumps)
  self.warnings = run_warnings.of_run(self, model, early)
  self.jumps, self.unexamined = nil, nil
  return self
end

-- ── Reading (by the user) ────────────────────────────────────────────────────────────────────────────────────────────

function Run:columns() return lists.joined(self.names) end

function Run:column(name)
  local values = self.values[name]
  if not values then no_column("run:column", name, self.names) end
  local list = {}
  for row = 1, self.rows do list[row] = values[row] or 0 / 0 end
  return list
end

local function history(run, what, step)
  local count = #run.histories
  if step > count then core.fail(("%s: there is no step %d; the run has steps 1 to %d"):format(what, step, count)) end
  return run.histories[step]
end

function Run:attempts(step) return lists.joined(history(self, "run:attempts", step)) end

function Run:residuals(step)
  local attempts = history(self, "run:residuals", step)
  return lists.joined(attempts[#attempts].residuals)
end

function Run:states() return lists.joined(self.stored_states) end

function Run:csv(file)
  local rows = {}
  for row = 1, self.rows do rows[row] = lists.map(self.names, function(name) return self.values[name][row] end) end
  on_behalf_of("run:csv", "sg.csv.write", csv.write, file,
    { columns = self.names, rows = rows, comments = { self.failure } })
end

function Run:error(name) return require("signorini.errors.bars").error(self, name) end
function Run:budget(name, step) return require("signorini.errors.bars").budget(self, name, step) end
function Run:report(options) return require "signorini.output.report.run"(self, options) end
function Run:hdf5(file, options) require("signorini.output.hdf5").write(self, file, options) end

local function work_row(name, work, cutbacks)
  local mean = work.steps > 0 and work.iterations / work.steps or nil
  local row = { name, work.steps, work.iterations, mean, work.wall }
  if cutbacks then table.insert(row, 3, work.cutbacks) end
  return row
end

--- A line on the attempts that were not accepted and their part of the iterations, if there were any.
local function failed_attempts(run)
  local failed = lists.filter(lists.flat(run.histories), function(attempt) return not attempt.converged end)
  if #failed == 0 then return {} end
  local spent = 0
  for _, attempt in ipairs(failed) do spent = spent + attempt.iterations end
  return { ("%s took %d of the %s"):format(counted(#failed, "failed attempt"), spent,
    counted(run.iterations, "iteration")) }
end

--- A short table: steps, iterations and wall time by stage, and shares of the time; cut-backs if there were any.
function Run:__tostring()
  local columns, cutbacks = { "stage", "steps", "iterations", "per step", "wall" }, self.cutbacks > 0
  if cutbacks then table.insert(columns, 3, "cut-backs") end
  local rows = lists.map(self.stages, function(stage) return work_row(stage.name, stage, cutbacks) end)
  rows[#rows + 1] = work_row("total", self, cutbacks)
  local text = format_table { columns = columns, units = { [#columns] = "s" }, rows = rows,
                              formats = { ["per step"] = "%.2f", wall = "%.3f" } }
  local spent = self.timings
  text = ("%s\ntime: bulk %.3f s, contact %.3f s, factorization and solve %.3f s, rest %.3f s")
    :format(text, spent.bulk, spent.contact, spent.linear, spent.rest)
  local errors = self.errors and require("signorini.errors.bars").lines(self) or {}
  local levels = self.settings and require("signorini.errors.ladder").lines(self) or {}
  for _, line in ipairs(lists.joined(failed_attempts(self), controls.lines(self), self.warnings, levels, errors)) do
    text = text .. "\n" .. line
  end
  if self.reason == "completed" then return text end
  return ("%s\n%s: %s"):format(text, self.reason, self.failure or "on_step ended the run")
end

return Run
