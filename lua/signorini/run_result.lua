-- What a load path leaves behind: one row per accepted step, how much work it was, and why it ended.

local core = require "signorini.core"
local csv = require "signorini.csv"
local format_table = require "signorini.table"

local Run = {}
Run.__index = Run
Run.__name = "run"

local axes = { "x", "y", "z" }
local contact_columns = { "fx", "fy", "fz", "area", "max_pressure", "max_penetration" }

-- ── Recording (by model:run) ─────────────────────────────────────────────────────────────────────────────────────────

--- Registers a column and returns its list of values.
local function add_column(run, name)
  local values = {}
  run.names[#run.names + 1], run.values[name] = name, values
  return values
end

--- A run without steps. Columns are set up once, so that a step only appends numbers.
function Run.new(model)
  local run = setmetatable({
    failed = false, reason = "completed", steps = 0, iterations = 0, wall = 0, stages = {},
    names = {}, values = {}, histories = {}, recorders = {}, before = model:timings(),
  }, Run)
  run.step_column, run.iteration_column = add_column(run, "step"), add_column(run, "iterations")
  run.wall_column = add_column(run, "wall")
  for _, support in ipairs(model:support_names()) do
    local columns = {}
    for i = 1, #model:reaction(support) do columns[i] = add_column(run, support .. ".f" .. axes[i]) end
    run.recorders[#run.recorders + 1] = function(step)
      local reaction = model:reaction(support)
      for i, values in ipairs(columns) do values[step] = reaction[i] end
    end
  end
  for _, contact in ipairs(model:contact_names()) do
    local columns, resultant = {}, model:contact_resultant(contact)
    for _, key in ipairs(contact_columns) do
      if resultant[key] then columns[key] = add_column(run, contact .. "." .. key) end
    end
    run.recorders[#run.recorders + 1] = function(step)
      local now = model:contact_resultant(contact)
      for key, values in pairs(columns) do values[step] = now[key] end
    end
  end
  return run
end

function Run:begin_stage(stage)
  self.stages[#self.stages + 1] = { name = stage.name, steps = 0, iterations = 0, wall = 0 }
end

local function add_work(run, result, seconds)
  local stage = run.stages[#run.stages]
  stage.iterations, stage.wall = stage.iterations + result.iterations, stage.wall + seconds
  run.iterations, run.wall = run.iterations + result.iterations, run.wall + seconds
  run.histories[#run.histories + 1] = result.residuals
end

--- Appends the row of an accepted step; `seconds` is what solving it took.
function Run:record(stage, result, seconds)
  add_work(self, result, seconds)
  local step = self.steps + 1
  self.steps = step
  self.stages[#self.stages].steps = self.stages[#self.stages].steps + 1
  self.step_column[step], self.iteration_column[step], self.wall_column[step] = step, result.iterations, seconds
  for _, record in ipairs(self.recorders) do record(step) end
end

--- Notes why a step was not accepted.
function Run:record_failure(stage, k, result, seconds)
  add_work(self, result, seconds)
  local residuals = {}
  for i, residual in ipairs(result.residuals) do residuals[i] = ("%.3g"):format(residual) end
  self.failed, self.reason = true, result.reason
  self.report = ("step %d (stage '%s', %d of %d) was not reached: %s. Residuals: %s. The model is at its last accepted step, %s.")
    :format(self.steps + 1, stage.name, k, stage.steps, result.message ~= "" and result.message or result.reason,
      #residuals > 0 and table.concat(residuals, ", ") or "none", self.steps > 0 and self.steps or "its start")
end

--- What on_step sees after an accepted step: step, stage, iterations, residual, and every column's value by name.
function Run:info(stage, result)
  local info = {}
  for name, values in pairs(self.values) do info[name] = values[self.steps] end
  info.stage, info.residual = stage.name, result.residuals[#result.residuals]
  return info
end

--- Closes the accounts: seconds in the bodies, in contact, in factorisation and solve, and in all the rest.
function Run:finish(model)
  local now, spent = model:timings(), {}
  local rest = self.wall
  for _, account in ipairs { "bulk", "contact", "linear" } do
    spent[account] = now[account] - self.before[account]
    rest = rest - spent[account]
  end
  spent.rest = math.max(0, rest)
  self.timings, self.recorders, self.before = spent, nil, nil
  return self
end

-- ── Reading (by the user) ────────────────────────────────────────────────────────────────────────────────────────────

--- The names of all columns, in order.
function Run:columns()
  return table.move(self.names, 1, #self.names, 1, {})
end

--- The values of a column, one per accepted step: "step", "iterations", "wall" (seconds of that step), "<support>.fx"
--- (reaction), "<contact>.area" and so on.
function Run:column(name)
  local values = self.values[name]
  if not values then
    core.fail(("run:column: there is no column '%s'; known: %s"):format(tostring(name), table.concat(self.names, ", ")))
  end
  return table.move(values, 1, #values, 1, {})
end

--- The residual norms of a step's iterations; a failed step is the one after the last accepted.
function Run:residuals(step)
  local history = self.histories[step]
  if not history then
    core.fail(("run:residuals: there is no step %s; the run has steps 1 to %d"):format(tostring(step), #self.histories))
  end
  return table.move(history, 1, #history, 1, {})
end

--- Writes all columns to a CSV file.
function Run:csv(file)
  local data = { columns = self.names, comments = { self.report } }
  for name, values in pairs(self.values) do data[name] = values end
  csv.write(file, data)
end

local function work_row(name, work)
  local mean = work.steps > 0 and work.iterations / work.steps or nil
  return { name, work.steps, work.iterations, mean, work.wall }
end

--- A short table: steps, iterations and wall time by stage, and where the time went.
function Run:__tostring()
  local rows = {}
  for i, stage in ipairs(self.stages) do rows[i] = work_row(stage.name, stage) end
  rows[#rows + 1] = work_row("total", self)
  local text = format_table {
    columns = { "stage", "steps", "iterations", "per step", "wall" }, units = { "", "", "", "", "s" }, rows = rows,
    formats = { ["per step"] = "%.2f", wall = "%.3f" },
  }
  local spent = self.timings
  text = ("%s\ntime: bulk %.3f s, contact %.3f s, factorisation and solve %.3f s, rest %.3f s")
    :format(text, spent.bulk, spent.contact, spent.linear, spent.rest)
  if self.reason == "completed" then return text end
  return ("%s\n%s: %s"):format(text, self.reason, self.report or "on_step ended the run")
end

return Run
