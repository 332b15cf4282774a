-- What the results of a study depend on besides the parameters of a case: the text of its function `run`, all that this
-- refers to, and the program's version. When one of these changes, what was computed before no longer counts.

local core = require "signorini.core"
local arguments = require "signorini.arguments"

local inputs = {}

-- ── What is no input ─────────────────────────────────────────────────────────────────────────────────────────────────

-- Lua's own globals and modules and those of the library are the program, of which the version counts.
local globals, program = {}, {}
for name in next, _G do globals[name] = true end
globals.sg, globals.help, globals.arg = true, true, true
for _, module in pairs(package.loaded) do program[module] = true end

--- Adds the library's modules that were loaded later.
local function find_program()
  for name, module in pairs(package.loaded) do program[module] = program[module] or name:find "^signorini" ~= nil end
end

-- ── The text of a function and of what it refers to ──────────────────────────────────────────────────────────────────

local files = {} -- the lines of each script that was read

local function lines_of(file)
  local lines = files[file] or {}
  if not files[file] and core.exists(file) then
    for line in io.lines(file) do lines[#lines + 1] = line end
  end
  files[file] = lines
  return lines
end

--- The source text of a function; of one that was typed, its bytes.
local function source_of(f)
  local about = debug.getinfo(f, "S")
  local file = about.source:match "^@(.*)"
  local lines = file and lines_of(file) or {}
  if about.what == "C" then return "C" end
  if not lines[about.lastlinedefined] then return string.dump(f, true) end
  return table.concat(lines, "\n", about.linedefined, about.lastlinedefined)
end

local write

--- The user's own globals that a function's text names: it finds them through _ENV, not among its upvalues.
local function named_globals(source)
  local names = {}
  for name in next, _G do
    if type(name) == "string" and not globals[name] and source:find("%f[%w_]" .. name .. "%f[^%w_]") then
      names[#names + 1] = name
    end
  end
  table.sort(names)
  return names
end

--- Calls visit(name, value) for all that a function refers to: its upvalues, and the user's globals.
local function references(f, visit)
  for i = 1, math.huge do
    local name, value = debug.getupvalue(f, i)
    if not name then break end
    if name == "_ENV" then
      for _, global in ipairs(named_globals(source_of(f))) do visit(global, rawget(_G, global)) end
    else
      visit(name, value)
    end
  end
end

local function write_function(f, out, seen)
  out[#out + 1] = source_of(f)
  references(f, function(name, value)
    out[#out + 1] = name
    write(value, out, seen)
  end)
end

local function write_table(value, out, seen)
  local keys = {}
  for key in next, value do
    if type(key) == "string" or type(key) == "number" then keys[#keys + 1] = key end
  end
  table.sort(keys, function(a, b)
    if type(a) ~= type(b) then return type(a) == "number" end
    return a < b
  end)
  for _, key in ipairs(keys) do
    out[#out + 1] = tostring(key)
    write(rawget(value, key), out, seen)
  end
end

--- What the results of a study depend on, by name: the text of `run` and each thing that this refers to, or what was
--- given in place of these.
local function parts_of(study)
  if study.inputs ~= nil then return { inputs = study.inputs } end
  if study.parts then return study.parts end
  local parts = { run = source_of(study.run) }
  references(study.run, function(name, value) parts[name] = value end)
  return parts
end

--- What counts of a table: of a study, or of a stability map, what its results depend on, not how long they took.
local function essence(value)
  local own = getmetatable(value)
  local kind = type(own) == "table" and rawget(own, "__name")
  local study = kind == "study" and (value.whole or value) or kind == "stability map" and value.study
  return study and { cases = study.cases, parts = parts_of(study) } or value
end

--- What an object holds; of one without content, such as an open file, its kind.
local function write_object(value, out)
  out[#out + 1] = core.kind(value)
  out[#out + 1] = core.content(value)
end

function write(value, out, seen)
  local kind = type(value)
  if kind == "table" or kind == "function" then
    if seen[value] or program[value] or core.names[value] then
      out[#out + 1] = core.names[value] or "seen"
      return
    end
    seen[value] = true
    out[#out + 1] = kind
    if kind == "function" then return write_function(value, out, seen) end
    return write_table(essence(value), out, seen)
  end
  if kind == "userdata" then return write_object(value, out) end
  out[#out + 1] = kind == "number" and ("%a"):format(value) or tostring(value)
end

local function hash_of(value)
  local out = {}
  write(value, out, {})
  return core.hash(table.concat(out, "\0"))
end

-- ── The inputs ───────────────────────────────────────────────────────────────────────────────────────────────────────

--- The inputs of a study by name: hashes of what its results depend on, and the program's version, unless the user said
--- what counts.
function inputs.of(study)
  files = {}
  find_program()
  local result = { ["the program's version"] = core.versions.signorini }
  if study.inputs ~= nil then
    local plain = pcall(core.write_json, study.inputs, "inputs")
    if not plain then
      arguments.reject("sg.study", "inputs", "plain data: numbers, strings, tables of these", study.inputs)
    end
    result = {}
  end
  for name, part in pairs(parts_of(study)) do result[name] = hash_of(part) end
  return result
end

--- The names of what differs between two sets of inputs, sorted; empty when nothing does.
function inputs.difference(before, now)
  local names = {}
  for name, hash in pairs(now) do
    if before[name] ~= hash then names[#names + 1] = name end
  end
  for name in pairs(before) do
    if now[name] == nil then names[#names + 1] = name end
  end
  table.sort(names)
  return names
end

return inputs
