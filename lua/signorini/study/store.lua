-- A study's folder: one JSON file for each case that is done, and study.json, which says whose folder it is. Files are
-- written whole or not at all and are on the disk before the next case begins, so that whoever reads them, or goes on
-- after a power cut, finds results and nothing else.

local in_name_of = require "signorini.in_name_of"
local core = require "signorini.core"

local store = {}

-- On a disk that fills up this file goes, and leaves room for the results of the cases that are under way.
local reserve_name, reserve_size = "reserve", 1 << 20

--- Calls a function of the core; its error becomes one of study:execute at the user's line.
local function call(where, name, ...) return in_name_of(where, "core." .. name, core[name], ...) end

local function read(file)
  if not core.exists(file) then return nil end
  local ok, value = pcall(function() return core.read_json(core.read_file(file)) end)
  return ok and type(value) == "table" and value or nil, not ok
end

local function case_file(study, entry) return ("%s/cases/%s.json"):format(study.folder, entry.id) end

--- Whether a folder holds this study already. That it holds another one is an error.
local function check_owner(where, study)
  local owner = read(study.folder .. "/study.json")
  if owner and owner.study ~= study.name then
    core.fail(("%s: the folder '%s' holds the study '%s', not '%s': give this one a folder of its own, or remove the "
      .. "old one"):format(where, study.folder, tostring(owner.study), study.name))
  end
  return owner ~= nil
end

--- What is known of a case: its record, or nil; and whether its file is there but cannot be understood.
function store.read(study, entry)
  if not study.folder then return nil end
  local record, damaged = read(case_file(study, entry))
  if record and type(record.case) == "table" and type(record.figures) == "table"
    and type(record.outcome) == "string" then
    return record, false
  end
  return nil, damaged or record ~= nil
end

--- Removes what a folder holds of any study.
local function clear(folder)
  for _, name in ipairs(core.list_folder(folder .. "/cases")) do
    if name:find "%.json$" then os.remove(("%s/cases/%s"):format(folder, name)) end
  end
  os.remove(folder .. "/study.json")
end

--- Makes the folder and holds it, as long as the returned keeper is not released. A study without one keeps nothing.
function store.open(where, study)
  if not study.folder then return { study = study, where = where } end
  call(where, "mkdir", study.folder .. "/cases")
  local lock = call(where, "lock", study.folder .. "/lock")
  local keeper = { lock = lock, study = study, where = where, reserve = study.folder .. "/" .. reserve_name }
  local ok, message = pcall(function()
    if study.fresh then clear(study.folder) end
    local file = study.folder .. "/study.json"
    if not check_owner(where, study) then call(where, "write_file", file, core.write_json { study = study.name }) end
  end)
  if ok then return setmetatable(keeper, { __index = store }) end
  lock:release()
  error(message, 0)
end

--- Checks whose folder it is, for those who only read.
function store.check(where, study) check_owner(where, study) end

--- Takes the room that the last results will need, before any case runs.
function store.take_reserve(keeper)
  if not keeper.lock then return end
  core.remove_leftovers(keeper.reserve)
  call(keeper.where, "write_file", keeper.reserve, (" "):rep(reserve_size))
end

--- Writes a case's record. When the disk is full the reserve makes room for it.
function store.write(keeper, entry, record)
  if not keeper.lock then return end
  local file, text = case_file(keeper.study, entry), core.write_json(record, "the case's record")
  core.remove_leftovers(file)
  if pcall(core.write_file, file, text, true) then return end
  os.remove(keeper.reserve)
  call(keeper.where, "write_file", file, text, true)
  keeper.full = true
end

--- Lets go of the folder.
function store.close(keeper)
  if not keeper.lock then return end
  os.remove(keeper.reserve)
  keeper.lock:release()
end

return store
