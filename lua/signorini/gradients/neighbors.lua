-- The neighbors of a run: for each parameter two models of its scene, with a value a little above and below, which
-- follow the run increment by increment. Differences of their results are derivatives of those of the run.

local check = require "signorini.call.check"
local core = require "signorini.core"
local lists = require "signorini.call.lists"
local on_behalf_of = require "signorini.call.on_behalf_of"
local recorders = require "signorini.run.recorders"
local Step = require "signorini.run.step"

local Neighbors = {}
Neighbors.__index = Neighbors

--- Columns of results of a model: names, and lists of values by name.
local function record_of(model, path)
  local record = { names = {}, values = {}, recorders = {}, unsettled = {}, flawed = {}, rows = 0 }
  recorders.start(record, model, path)
  return record
end

--- Records the present state as a row; `measure`: of model:run.
local function record_state(record, row, model, measure)
  for _, append in ipairs(record.recorders) do append(row) end
  local results = measure and measure(model) or {}
  if type(results) ~= "table" then
    check.reject("measure", "its result", "a table of numbers by name", results)
  end
  for name, value in pairs(results) do
    record.values[name] = record.values[name] or recorders.add_column(record, name)
    record.values[name][row] = value
  end
end

--- The values of a model before its run, as row 0 of its columns.
function Neighbors.start_of(model, path, measure)
  local record = record_of(model, path)
  record_state(record, 0, model, measure)
  return record.values
end

--- `pairs`: by parameter { name, at, size, step, plus, minus }, the last two { model, path (stages that have been
--- read), options }. `fail(pair, text)`: reports what is wrong with a neighbor.
function Neighbors.new(pairs, fail)
  local self = setmetatable({ pairs = pairs, fail = fail, passes = 0, kinks = {} }, Neighbors)
  self:each(function(side) side.record = record_of(side.model, side.path) end)
  return self
end

--- Calls visit(neighbor, pair).
function Neighbors:each(visit)
  for _, pair in ipairs(self.pairs) do
    visit(pair.plus, pair)
    visit(pair.minus, pair)
  end
end

function Neighbors:begin_stage(index)
  self.stage = index
  self:each(function(side) Step.begin_stage(side.model, side.path[index]) end)
end

--- Gives neighbors the layers of the run, a list of core.follow.
function Neighbors:move_layers(raised)
  self:each(function(side, pair)
    if not core.follow(side.model, raised) then self.fail(pair, "its layers cannot follow those of the run") end
  end)
end

--- Follows the run, which has converged at the fraction `to` of its step `step` and not accepted that state yet.
function Neighbors:follow(step, to, solver)
  local factored, begun
  for _, pair in ipairs(self.pairs) do
    for _, side in ipairs { pair.plus, pair.minus } do
      local own = step:of_neighbor(side.model, side.path[self.stage], side.options)
      own:set_targets(to)
      own:set_penalty(to)
    end
    local found = core.follow_run(step.model, lists.merged(solver, { plus = pair.plus.model, minus = pair.minus.model,
                                                                 step = pair.step, size = pair.size,
                                                                 factored = factored, begun = begun }))
    if found.renewed then factored = pair.plus.model end
    if found.begun then begun = pair.minus.model end
    if found.failure then
      self.fail(pair, ("step %d is not reached: %s"):format(step.run.steps + 1, found.failure))
    end
    self.passes = self.passes + found.passes
    pair.defect, pair.forces = math.max(pair.defect or 0, found.defect), math.max(pair.forces or 0, found.forces)
    pair.reach = math.min(pair.reach or math.huge, found.reach)
    if found.kinks > 0 then
      self.kinks[#self.kinks + 1] = { step = step.run.steps + 1, parameter = pair.name, points = found.kinks,
                                      share = found.share, contact = found.contact, X = found.place }
    end
  end
end

--- The residual of the equations of the derivatives, relative to the largest forces of the run.
function Neighbors:residual()
  local most = 0
  for _, pair in ipairs(self.pairs) do
    if pair.defect then most = math.max(most, pair.defect / pair.forces) end
  end
  return most
end

--- Records the accepted state, the last of a step; `measure`: of model:run.
function Neighbors:record(measure)
  self:each(function(side)
    side.record.rows = side.record.rows + 1
    record_state(side.record, side.record.rows, side.model, measure)
  end)
end

--- Records the state before the run as row 0.
function Neighbors:record_start(measure)
  self:each(function(side) record_state(side.record, 0, side.model, measure) end)
end

--- Removes the last record.
function Neighbors:drop()
  self:each(function(side)
    for _, values in pairs(side.record.values) do values[side.record.rows] = nil end
    side.record.rows = side.record.rows - 1
  end)
end

-- ── Checkpoints ──────────────────────────────────────────────────────────────────────────────────────────────────────

--- Calls a file function of the core; its errors become errors of model:run.
local function call(name, ...) return on_behalf_of("model:run", "core." .. name, core[name], ...) end

--- Names of the files of the neighbors: those of the last save stay until the run's file, which names the set "a" or
--- "b", is written.
local function file_of(file, set, pair, side)
  return ("%s.%s.%s.%s"):format(file, set, pair.name, side == pair.plus and "plus" or "minus")
end

--- Saves the neighbors next to the file of the run. Returns the name of the set.
function Neighbors:save(file, durable)
  self.set = self.set == "a" and "b" or "a"
  self:each(function(side, pair)
    local stage = side.path[self.stage or 1]
    call("save", side.model, file_of(file, self.set, pair, side), core.pack {
      rows = side.record.rows, values = side.record.values, names = side.record.names, starts = stage.starts or {},
      fits = stage.fits or {}, pair = { defect = pair.defect, forces = pair.forces, reach = pair.reach },
      shared = { passes = self.passes, kinks = self.kinks, stage = self.stage } }, durable)
  end)
  return self.set
end

--- Restores the neighbors from the set that the file of the run names.
function Neighbors:restore_from(file, set)
  self.set = set
  self:each(function(side, pair)
    local name = file_of(file, set, pair, side)
    local state = core.unpack(call("checkpoint_text", name))
    call("restore", side.model, name)
    side.record.rows, side.record.names = state.rows, state.names
    for column, values in pairs(state.values) do
      local own = side.record.values[column] or {}
      side.record.values[column] = own
      for row, value in pairs(values) do own[row] = value end
    end
    for key, value in pairs(state.pair) do pair[key] = value end
    for key, value in pairs(state.shared) do self[key] = value end
    local stage = side.path[self.stage or 1]
    stage.starts, stage.fits = state.starts, state.fits
  end)
end

-- ── Steps that are taken back ────────────────────────────────────────────────────────────────────────────────────────

function Neighbors:snapshot()
  local saved = {}
  self:each(function(side) saved[#saved + 1] = side.model:snapshot() end)
  return saved
end

function Neighbors:restore(saved)
  local k = 0
  self:each(function(side)
    k = k + 1
    side.model:restore(saved[k])
  end)
end

return Neighbors
