-- Runs as files of HDF5, for other programs: run:hdf5(file) after a run, or the option hdf5 of model:run, which writes
-- the file as the run goes. HDF5's own files are damaged if a process is killed while it writes; here the file is made
-- in memory, and each write replaces that on the disk as a whole.

local core = require "signorini.core"
local has_moved_since = require("signorini.run.adapt").has_moved_since
local lists = require "signorini.call.lists"
local on_behalf_of = require "signorini.call.on_behalf_of"
local quantities = require "signorini.output.hdf5.quantities"
local release = require "signorini.call.release"
local scene = require "signorini.output.hdf5.scene"
local stages = require "signorini.run.stages"

local form, schema = "signorini run", 1
local most_share = 0.02 -- of a run's time for replacing the file on the disk, unless `every` is given
local most_pending = 20 -- entries

local Record = {}
Record.__index = Record

local function call(record, inner, f, ...) return on_behalf_of(record.where, inner, f, ...) end

-- ── What is known before the first step ──────────────────────────────────────────────────────────────────────────────

--- Where results come from, as JSON text: program, processor kernel, date, script with arguments and text.
local function origin()
  local script, arguments = arg and arg[0], {}
  for i, word in ipairs(arg or {}) do arguments[i] = word end
  if script == "" or script == "-" then script = nil end
  return core.write_json({
    program = "signorini", version = release, kernel = core.versions.kernel, host = core.host,
    date = os.date "!%Y-%m-%dT%H:%M:%SZ", script = script, arguments = arguments,
    text = script and core.exists(script) and core.read_file(script) or nil,
  }, "origin")
end

function Record:set_about(path, quantity, text, name)
  if quantity then self.file:set(path, "quantity", "text", quantity) end
  if quantity or name then self.file:set(path, "unit", "text", quantities.unit(self.units, quantity, name)) end
  if text then self.file:set(path, "description", "text", text) end
end

local function set_root(record, run)
  for name, value in pairs { format = form, origin = origin(), path = core.write_json(run.outline, "path"),
                             units = "units of the script, unless an array has the attribute unit" } do
    record.file:set("/", name, "text", value)
  end
  record.file:set("/", "schema", "integer", schema)
end

--- A file in memory with the parts that do not change.
local function make(where, model, run, options)
  local record = setmetatable({ where = where, model = model, units = options.units or {}, rows = 0, states = 0,
                                profiles = 0, pending = { states = {}, profiles = {} }, described = {},
                                spent = 0 }, Record)
  record.file = call(record, "core.make_result_file", core.make_result_file)
  set_root(record, run)
  scene.write(record.file, model, function(...) record:set_about(...) end)
  return record
end

-- ── Arrays that grow ─────────────────────────────────────────────────────────────────────────────────────────────────

function Record:append(field, first)
  local path, values = field[1], field[2]
  self.file:append(path, field.kind, field.entry, values, first)
  if self.described[path] then return end
  self.described[path] = true
  self:set_about(path, field.quantity, field.text, field.name)
  for name, list in pairs(field.more or {}) do self.file:set(path, name, "text", list) end
end

--- Adds an entry to those that are to be written into a family of arrays, "states" or "profiles", whose steps and
--- stages are in /<family>. All entries have the same arrays.
function Record:add_entry(family, step, stage, fields)
  local entries = self.pending[family]
  table.insert(fields, { ("/%s/step"):format(family), { step }, kind = "number", entry = {} })
  table.insert(fields, { ("/%s/stage"):format(family), { stage }, kind = "text", entry = {} })
  entries[#entries + 1] = fields
  self[family .. "_step"] = step
  if #entries == most_pending then self:write_entries(family) end
end

--- Writes the entries that were added: many at once take hardly longer than one.
function Record:write_entries(family)
  local entries = self.pending[family]
  for i, field in ipairs(entries[1] or {}) do
    if #entries > 1 then field[2] = lists.flat(lists.map(entries, function(fields) return fields[i][2] end)) end
    self:append(field, self[family])
  end
  self[family], self.pending[family] = self[family] + #entries, {}
end

--- Drops the entries of a family that are beyond a step of an older file, whose run continues there.
function Record:continue_entries(family, step, fields)
  local steps, kept = self.file:numbers(("/%s/step"):format(family)), 0
  while kept < #steps and steps[kept + 1] <= step do kept = kept + 1 end
  self[family], self[family .. "_step"] = kept, steps[kept]
  local paths = lists.map(fields, function(field) return field[1] end)
  for _, path in ipairs(lists.joined(paths, { ("/%s/step"):format(family), ("/%s/stage"):format(family) })) do
    self.file:truncate(path, kept)
  end
end

--- Appends the rows that the run has added; error bars are known at its end only, and are written then as a whole.
function Record:append_rows(run)
  for _, name in ipairs(run.names) do
    local first = quantities.is_error(name) and 0 or self.rows
    local column, values = run.values[name], {}
    for row = first + 1, run.rows do values[row - first] = column[row] or 0 / 0 end
    local quantity, text = table.unpack(quantities.of_column(self.model, name) or { nil, "returned by on_step" })
    self:append({ "/columns/" .. scene.link(name), values, kind = "number", entry = {}, quantity = quantity,
                  text = text, name = name }, first)
  end
  self:append({ "/rows/stage", stages.names(run, self.rows + 1), kind = "text", entry = {},
                text = "stage of each row of the columns" }, self.rows)
  if self.written_names ~= #run.names then
    self.written_names = #run.names
    self.file:set("/columns", "names", "text", run.names)
  end
  self.rows = run.rows
end

--- Sets what is known of the run so far; `reason`: why it has ended.
function Record:set_outcome(run, reason)
  local file = self.file
  for _, name in ipairs { "steps", "iterations", "cutbacks" } do file:set("/", name, "integer", run[name]) end
  file:set("/", "wall", "number", run.wall)
  file:set("/", "reason", "text", reason)
  file:set("/", "failure", "text", run.failure or "")
  file:set("/", "cause", "text", run.cause or "")
  file:set("/", "warnings", "text", run.warnings)
end

--- Writes what the run has recorded so far. `reason`: why it has ended.
function Record:write(run, reason)
  self:write_entries "states"
  self:write_entries "profiles"
  local began = core.now()
  self:append_rows(run)
  self:set_outcome(run, reason)
  call(self, "HDF5 file:save", self.file.save, self.file, self.path)
  self.latest = core.now() - began
  self.spent = self.spent + self.latest
end

-- ── A file written as the run goes ───────────────────────────────────────────────────────────────────────────────────

--- Continues the file of a run that is resumed.
function Record:continue(run)
  local old = call(self, "core.open_result_file", core.open_result_file, self.path)
  local wrong = old:texts("/", "format")[1] ~= form and "was not written by a run"
    or old:texts("/", "path")[1] ~= core.write_json(run.outline, "path") and "holds a run on another path"
    or not scene.is_in(old, self.model) and "holds a run of another model"
  if wrong then
    core.fail(("%s: hdf5: '%s' %s. Hint: name another file, or remove this one"):format(self.where, self.path, wrong))
  end
  self.file = old
  self:continue_entries("states", run.steps, scene.displacements(self.model))
  self:continue_entries("profiles", run.steps, scene.profiles(self.model))
  for _, name in ipairs(old:texts("/columns", "names")) do old:truncate("/columns/" .. scene.link(name), run.rows) end
  old:truncate("/rows/stage", run.rows)
  set_root(self, run)
end

--- Appends the present state where options request it. `stored`: whether the run has stored it.
function Record:add_state(run, stage, stored)
  local model = self.model
  if (stored or self.wants.states == "all") and self.states_step ~= run.steps then
    self:add_entry("states", run.steps, stage, scene.displacements(model))
  end
  if (stored or self.wants.profiles == "all") and self.profiles_step ~= run.steps then
    self:add_entry("profiles", run.steps, stage, scene.profiles(model))
  end
end

--- True if the run has stored the state of its last step.
local function stored_last(run)
  local last = run.stored_states[#run.stored_states]
  return last ~= nil and last.step == run.steps
end

--- True if the file on the disk is to be replaced after a step.
function Record:is_due(step)
  if self.saves and step % self.saves == 0 then return true end
  if self.wants.every then return step % self.wants.every == 0 end
  return self.spent + self.latest <= most_share * (core.now() - self.began)
end

--- After an accepted step.
function Record:step(run, stage)
  self:add_state(run, stage, stored_last(run))
  if self:is_due(run.steps) then self:write(run, "running") end
end

--- After the end of the run, which has at least begun a stage.
function Record:finish(run)
  self:add_state(run, run.stages[#run.stages].name, stored_last(run))
  self:write(run, run.reason)
end

local hdf5 = {}

--- Starts the file of a run at `stage`. options: those of model:run.
function hdf5.start(where, model, run, options, stage)
  local wants = options.hdf5
  quantities.check(where .. ": hdf5", wants.units or {}, run.names, options.on_step)
  local record = make(where, model, run, wants)
  record.path, record.wants, record.saves = wants.file, wants, options.checkpoint and options.checkpoint.every
  record.began = core.now()
  if options.resume and core.exists(wants.file) then record:continue(run) end
  record:add_state(run, stage, stored_last(run))
  record:write(run, "running") -- a file that cannot be written is reported now, not after a step
  return record
end

--- Calls f(model) in a state that a run has stored; then the model is as before.
local function in_state(state, f)
  local model = core.model_of(state.snapshot)
  local now = model:snapshot()
  model:restore(state.snapshot)
  local ok, message = pcall(f, model)
  model:restore(now)
  if not ok then error(message, 0) end
end

--- Writes what a run has recorded and the states that it has stored.
function hdf5.write(run, file, options)
  local where = "run:hdf5"
  if #run.adaptations > 0 then
    core.fail(where .. ": a file of HDF5 holds control points once for all steps, and adapt has changed those of this "
      .. "run. Hint: export run:csv or pictures, or run without adapt")
  end
  if has_moved_since(run, run.model) then
    core.fail(where .. ": a later run with adapt has changed the control points since. Hint: write the file before "
      .. "that run, or use the option hdf5 of model:run")
  end
  quantities.check(where, options.units or {}, run.names)
  local record = make(where, run.model, run, options)
  record.path = file
  for _, state in ipairs(run.stored_states) do
    in_state(state, function(model)
      record:add_entry("states", state.step, state.stage, scene.displacements(model))
      record:add_entry("profiles", state.step, state.stage, scene.profiles(model))
    end)
  end
  record:write(run, run.reason)
end

return hdf5
