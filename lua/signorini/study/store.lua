-- A study's folder: one JSON file for each case that is done, and study.json, which names the study. Files are written
-- atomically and are on the disk before the next case begins, so that readers, and studies resumed after a power
-- failure, find only complete results.

local on_behalf_of = require "signorini.call.on_behalf_of"
local check = require "signorini.call.check"
local core = require "signorini.core"
local outcomes = require "signorini.study.outcomes"
local release = require "signorini.call.release"
local types = require "signorini.call.types"

local store = {}

-- The format of study.json and of the records of cases, which is in each of them; files of the first versions have
-- none, which is format 0. Files of all formats up to this one are read.
store.format = 1

-- When the disk is full this file is removed, which leaves space for the results of the running cases.
local reserve_size = 1 << 20

--- Calls a function of the core; its error becomes one of study:execute at the user's line.
local function call(where, name, ...) return on_behalf_of(where, "core." .. name, core[name], ...) end

local function read_text(file) return core.exists(file) and core.read_file(file) end

local function read(file)
  if not core.exists(file) then return nil end
  local ok, value = pcall(function() return core.read_json(core.read_file(file)) end)
  return ok and type(value) == "table" and value or nil, not ok
end

--- Raises an error if a file was written in a format that this program does not know.
local function check_format(where, file, value)
  local format = value and value.format or 0
  if math.type(format) ~= "integer" or format > store.format then
    core.fail(("%s: '%s' was written by a newer version of the program, in format %s; this one, %s, reads formats up "
      .. "to %d. Hint: install that version, or choose another folder"):format(where, file, tostring(format),
      release, store.format))
  end
end

local function case_file(study, entry) return ("%s/cases/%s.json"):format(study.folder, entry.id) end

--- True if a folder already holds this study, in this format. If it holds another one, this is an error.
function store.check(where, study)
  local file = study.folder .. "/study.json"
  local owner = read(file)
  check_format(where, file, owner)
  if owner and owner.study ~= study.name then
    core.fail(("%s: the folder '%s' holds the study '%s', not '%s': give this one another folder, or remove the "
      .. "old one"):format(where, study.folder, tostring(owner.study), study.name))
  end
  return owner ~= nil and owner.format == store.format
end

local data = types.map(types.any)
local shape = types.with_fields("case results", data, "outcome", types.text, "inputs? made?", data, "reason?",
  types.text, "wall?", { kind = "number", gaps = true })

--- The record of a case, or nil; and whether its file exists but cannot be read.
function store.read(study, entry)
  if not study.folder then return nil end
  local record, damaged = read(case_file(study, entry))
  check_format("sg.study", case_file(study, entry), record)
  if record and pcall(check.value, shape, record, "sg.study", "record") then return record, false end
  return nil, damaged or record ~= nil
end

--- The file for checkpoints of a case, which the function of the study gets. It exists while the case is unfinished.
--- Its name changes with what the result depends on, so that no case continues from the states of another one.
function store.checkpoint(study, entry, now)
  if not study.folder then return nil end
  local key = core.hash(core.write_json { case = entry.case, inputs = now })
  local file = ("%s/cases/%s.%s.sgn"):format(study.folder, entry.id, key:sub(1, 8))
  if core.is_link(file) then os.remove(file) end -- what it refers to is not this study's
  return file
end

local case_files = { json = "result", sgn = "checkpoint", claim = "claim" }

local function clear(folder)
  for _, name in ipairs(core.list_folder(folder .. "/cases")) do
    if case_files[name:match "%.(%a+)$"] then os.remove(("%s/cases/%s"):format(folder, name)) end
  end
  os.remove(folder .. "/study.json")
end

--- Makes and locks the folder until the returned handle is closed. A study without a folder saves nothing.
function store.open(where, study)
  if not study.folder then return { study = study, where = where } end
  call(where, "mkdir", study.folder .. "/cases")
  local lock = call(where, "lock", study.folder .. "/lock")
  local handle = { lock = lock, study = study, where = where, reserve = study.folder .. "/reserve" }
  local ok, message = pcall(function()
    if study.fresh then clear(study.folder) end
    local file = study.folder .. "/study.json"
    if not store.check(where, study) then
      call(where, "write_file", file, core.write_json { study = study.name, format = store.format })
    end
  end)
  if ok then return handle end
  lock:release()
  error(message, 0)
end

--- A handle for one of several processes that write cases at the same time, each into files of its own.
function store.share(where, study, reserve)
  store.check(where, study)
  return { study = study, where = where, reserve = ("%s/%s"):format(study.folder, reserve) }
end

--- Reserves the space that the last results will need, before any case runs.
function store.take_reserve(handle)
  if not handle.study.folder then return end
  if not core.is_link(handle.reserve) and (read_text(handle.reserve) or ""):find "[^ ]" then
    core.fail(("%s: '%s' is not a reserve of this study, so it is not replaced. Hint: choose another folder, or remove "
      .. "it"):format(handle.where, handle.reserve))
  end
  call(handle.where, "write_file", handle.reserve, (" "):rep(reserve_size))
  handle.reserved = true
end

--- Writes a case's record. If the disk is full, the reserve is released. A checkpoint is of no further use.
function store.write(handle, entry, record)
  if not handle.study.folder then return end
  record.format = store.format
  local file, text = case_file(handle.study, entry), core.write_json(record, "the case's record")
  if not pcall(core.write_file, file, text, true) then
    os.remove(handle.reserve)
    call(handle.where, "write_file", file, text, true)
    handle.full = true
  end
  if not outcomes.is_error(record.outcome) and record.outcome ~= "time" then
    os.remove(store.checkpoint(handle.study, entry, record.inputs))
  end
end

--- Unlocks the folder.
function store.close(handle)
  if handle.reserved then os.remove(handle.reserve) end
  if handle.lock then handle.lock:release() end
end

return store
