-- Resumable runs: model:run{ …, checkpoint = "x.sgn", resume = true }. After accepted steps the model is saved with the
-- state of the run: the path, the position on it, the memory of the step policy, and the record of the run. A resumed
-- run ends with bitwise identical results.

local check = require "signorini.call.check"
local on_behalf_of = require "signorini.call.on_behalf_of"
local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local describe = require "signorini.call.describe"
local lists = require "signorini.call.lists"
local types = require "signorini.call.types"

local where = "model:run"

--- The format of the record of a run; the first versions wrote none, which is format 0.
local format = 1

--- Fields of a run that are rebuilt or written in another form; all others are saved as they are.
local apart = { "failed", "reason", "cause", "failure", "recorders", "before", "step", "names", "values", "histories",
                "extra", "stored_states", "step_column", "increment_column", "iteration_column", "wall_column", "model",
                "outline", "unexamined", "companions", "neighbors" }

--- Calls a file function of the core; its errors become errors of model:run.
local function call(name, ...) return on_behalf_of(where, "core." .. name, core[name], ...) end

-- ── The path ─────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The difference between two paths, in words; nil if they are equal.
local function difference(path, saved)
  if core.pack(path) == core.pack(saved) then return nil end
  if #path ~= #saved then return ("it has %s, the file's has %d"):format(counted(#path, "stage"), #saved) end
  for i, stage in ipairs(path) do
    local label = ("stage %d ('%s')"):format(i, stage.name)
    for _, key in ipairs { "name", "steps", "targets", "paths", "contacts" } do
      local here, there = stage[key], saved[i][key]
      if core.pack(here) ~= core.pack(there) then
        if type(here) == "table" then
          return ("%s has different %s"):format(label, key == "paths" and "targets" or key)
        end
        return ("%s.%s is %s, in the file %s"):format(label, key, describe.literal(here), describe.literal(there))
      end
    end
  end
end

-- ── Saving ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local Checkpoint = {}
Checkpoint.__index = Checkpoint

--- A list as core.pack writes it, from the bytes of its entries: MessagePack's "array 32".
local function list(parts) return (">BI4"):pack(0xdd, #parts) .. table.concat(parts) end

--- A list whose entries that were packed before are used unchanged.
local function grow(parts, count, entry)
  for i = #parts + 1, count do parts[i] = core.pack(entry(i)) end
  return list(parts)
end

local function row_of(run, i)
  return lists.map(run.names, function(name) return run.values[name][i] or false end) -- false: on_step gave none
end

local function seconds_spent(model, before)
  local spent = {}
  for account, now in pairs(model:timings()) do spent[account] = now - before[account] end
  return spent
end

--- The state of the run, as bytes.
function Checkpoint:text(model, run, path, place, policy)
  local record = {}
  for key, value in pairs(run) do
    if not lists.holds(apart, key) then record[key] = value end
  end
  local stage = path[place.stage]
  local rest = core.pack { format = format, path = run.outline, place = place, starts = stage.starts or {},
                           fits = stage.fits or {}, memory = policy.memory or {}, names = run.names, record = record,
                           spent = seconds_spent(model, run.before) }
  if run.companions and not self.companions then self.companions = core.pack(run.companions) end -- they do not change
  return list { rest, grow(self.rows, run.rows, function(i) return row_of(run, i) end),
                grow(self.histories, #run.histories, function(i) return run.histories[i] end), self.companions }
end

--- A written file survives the process, but only a file on the disk survives a power failure. Waiting for the disk
--- takes time, so it is done at each save only on request, otherwise at most once a second.
function Checkpoint:save(model, run, path, place, policy, ended)
  local now, patience = core.now(), 1 -- seconds
  local durable = self.durable or ended or core.notice_given() or not self.synced or now - self.synced > patience
  if durable then self.synced = now end
  if run.neighbors then run.neighbor_set = run.neighbors:save(self.file, durable) end
  call("save", model, self.file, self:text(model, run, path, place, policy), durable)
  if core.notice_given() then os.exit(core.to_be_continued) end
end

--- After an accepted step: saves the run if it is due, or if the path has ended.
function Checkpoint:step(model, run, path, place, policy)
  local ended = place.stage == #path and place.number == path[#path].steps
  if ended or run.steps % self.every == 0 then self:save(model, run, path, place, policy, ended) end
end

-- ── Shape of the saved record ────────────────────────────────────────────────────────────────────────────────────────

local number, count, data = { kind = "number", gaps = true }, types.integer(0), types.table()
local list_of, record = types.list, types.with_fields
local flag_or_number = types.either(types.flag, number)
local stage = record("name", types.text, "steps iterations cutbacks", count, "wall", number)
local attempt = record("from to", number, "converged", types.flag, "reason", types.text, "iterations", count,
  "residuals", list_of(number), "fallback?", types.text)
local shape = types.tuple({ record("path", list_of(record("name", types.text, "steps", count,
    "duration?", types.either(number, types.text), "growth?", number, "targets", data)),
  "place", record("stage number", count), "starts fits", types.map(data), "memory", types.map(flag_or_number),
  "names", list_of(types.text), "spent", types.map(number), "format?", count, "record", record(
    "rows steps iterations cutbacks fallback_steps wary", count, "wall", number, "stages", list_of(stage),
    "energies", list_of(types.map(flag_or_number)),
    "jumps", record("energy?", types.map(number), "found", list_of(data), "steps", list_of(types.map(number))),
    "unstable_law", types.either(types.flag, data), "used?", data, "warnings", list_of(types.text),
    "adaptations", list_of(data), "contact_zones controls fallbacks overlaps places unsettled flawed", data,
    "state_findings?", list_of(record("subject place text", types.text, "from to", count)))),
  list_of(data), list_of(list_of(attempt)), data }, 3)

--- True if unpacked data, state, rows, histories and companions if any, can be those of a run. The checksum of a file
--- protects against damage alone.
local function is_record(saved)
  if not pcall(check.value, shape, saved, where, "checkpoint") then return false end
  local run, place, path = saved[1].record, saved[1].place, saved[1].path
  for _, row in ipairs(saved[2]) do
    local wrong = lists.any(row, function(cell) return cell and type(cell) ~= "number" end)
    if wrong or #row ~= #saved[1].names then return false end
  end
  return path[place.stage] ~= nil and place.number <= path[place.stage].steps and run.rows == #saved[2]
    and #saved[3] >= run.steps and (run.rows == 0 or #run.stages == place.stage)
end

-- ── Resuming ─────────────────────────────────────────────────────────────────────────────────────────────────────────

local function format_of(saved)
  local state = type(saved) == "table" and saved[1]
  return type(state) == "table" and math.type(state.format) == "integer" and state.format
end

--- The state of the run in a file, checked against the present path.
function Checkpoint:read(run)
  local text = call("checkpoint_text", self.file)
  if text == "" then
    core.fail(("%s: '%s' was saved by model:save, not by a run. Hint: load it with sg.load, and run without resume")
      :format(where, self.file))
  end
  local ok, saved = pcall(core.unpack, text)
  local written = ok and format_of(saved)
  if written and written > format then
    core.fail(("%s: '%s' was written by a newer version of the program, in format %d of runs; this one reads formats "
      .. "up to %d. Hint: install that version"):format(where, self.file, written, format))
  end
  if not ok or not is_record(saved) then
    core.fail(("%s: '%s' cannot be read as a run: it is damaged, or another version of " ..
      "the program saved it. Hint: name another file, or remove this one to start again"):format(where, self.file))
  end
  local state, rows, histories, companions = table.unpack(saved)
  local differs = difference(run.outline, state.path)
  if differs then
    core.fail(("%s: '%s' was saved on another path: %s. Hint: name another file, or remove this one to start again")
      :format(where, self.file, differs))
  end
  for i = #run.names + 1, #state.names do run:add_extra(state.names[i]) end
  if core.pack(state.names) ~= core.pack(run.names) then
    core.fail(("%s: '%s' holds a run with other columns: it was saved by another version of the program")
      :format(where, self.file))
  end
  return state, rows, histories, companions
end

--- Restores model, run and policy from the file. Returns the position on the path.
function Checkpoint:resume_from_file(model, run, path, policy)
  local state, rows, histories, companions = self:read(run)
  call("restore", model, self.file)
  for key, value in pairs(state.record) do run[key] = value end
  if (run.neighbors ~= nil) ~= (run.neighbor_set ~= nil) then
    core.fail(("%s: '%s' was saved %s. Hint: name another file, or remove this one to start again"):format(where,
      self.file, run.neighbors and "by model:run, without derivatives" or "by sg.gradients"))
  end
  if run.neighbors then run.neighbors:restore_from(self.file, run.neighbor_set) end
  for i, row in ipairs(rows) do
    for j, name in ipairs(run.names) do run.values[name][i] = row[j] or nil end
  end
  run.histories, run.companions, run.before = histories, companions, model:timings()
  for account, seconds in pairs(state.spent) do run.before[account] = run.before[account] - seconds end
  for key in pairs(policy.memory or {}) do
    if state.memory[key] ~= nil then policy.memory[key] = state.memory[key] end
  end
  if state.place.number > 0 then
    path[state.place.stage].starts, path[state.place.stage].fits = state.starts, state.fits
  end
  return state.place
end

--- The position at which the run begins: the start of the path, or that of the file: { stage, number } of the last
--- accepted step.
function Checkpoint:begin(model, run, path, policy)
  if self.resume and core.exists(self.file) then return self:resume_from_file(model, run, path, policy) end
  local place = { stage = 1, number = 0 }
  self:save(model, run, path, place, policy) -- a file that cannot be written is reported now, not after a step
  return place
end

-- ── Options ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- For runs without a checkpoint.
local none = {}
function none:begin() return { stage = 1, number = 0 } end
function none:step() end

--- What the options `checkpoint` and `resume` request: an object with begin() and step().
return function(options)
  local wanted = options.checkpoint
  return wanted and setmetatable({ file = wanted.file, every = wanted.every, durable = wanted.durable,
                                   resume = options.resume, rows = {}, histories = {} }, Checkpoint) or none
end
