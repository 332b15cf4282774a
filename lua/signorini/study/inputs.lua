-- What the results of a study depend on beside the parameters of a case: the text of its function `run`, and all that
-- this refers to. When that changes, what was computed before no longer counts.

local core = require "signorini.core"
local arguments = require "signorini.arguments"

local inputs = {}

-- ── What is no input ─────────────────────────────────────────────────────────────────────────────────────────────────

-- Lua's own globals and the library's modules are the program, whose version stands in every case's file.
local globals, program = {}, {}
for name in next, _G do globals[name] = true end
globals.sg, globals.help, globals.arg = true, true, true
for _, module in pairs(package.loaded) do program[module] = true end

--- Whether a table belongs to the program: one of its modules, also of those that were loaded later, or a study itself.
local function is_program(value)
  local own = getmetatable(value)
  if program[value] or (type(own) == "table" and own.__name == "study") then return true end
  for name, module in pairs(package.loaded) do
    if module == value then return name:find "^signorini" ~= nil end
  end
  return false
end

-- ── The text of a function and of what it refers to ──────────────────────────────────────────────────────────────────

local files = {} -- the lines of each script that was read

local function lines_of(file)
  if files[file] == nil then
    local lines, stream = {}, io.open(file)
    if stream then
      for line in stream:lines() do lines[#lines + 1] = line end
      stream:close()
    end
    files[file] = lines
  end
  return files[file]
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

--- What an object holds; of one without content, such as an open file, its kind.
local function write_object(value, out)
  out[#out + 1] = core.kind(value)
  out[#out + 1] = core.content(value)
end

function write(value, out, seen)
  local kind = type(value)
  if kind == "table" or kind == "function" then
    if seen[value] or is_program(value) or core.names[value] then
      out[#out + 1] = core.names[value] or "seen"
      return
    end
    seen[value] = true
    out[#out + 1] = kind
    return (kind == "table" and write_table or write_function)(value, out, seen)
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

--- Hashes by name: of the text of `run`, and of each thing that it refers to. `given`: plain data of the user's that
--- stands for all of that, or nil.
function inputs.of(run, given)
  files = {}
  if given ~= nil then
    local ok, text = pcall(core.write_json, given, "inputs")
    if not ok then arguments.reject("sg.study", "inputs", "plain data: numbers, strings, tables of these", given) end
    return { inputs = core.hash(text) }
  end
  local result = { run = core.hash(source_of(run)) }
  references(run, function(name, value) result[name] = hash_of(value) end)
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
