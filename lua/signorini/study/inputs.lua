-- The inputs of a study besides the parameters of a case: the text of its function `run` and of the script's functions
-- that it calls, the values that these use, and the program's version. When one of these changes, earlier results are
-- out of date. The text of whole scripts would be a simpler key, but then a change of a chart would repeat all cases.

local core = require "signorini.core"
local sorted_names = require("signorini.call.lists").sorted_names
local release = require "signorini.call.release"

local inputs = {}

-- Lua's globals and modules and those of the library belong to the program, whose version is an input. This file is
-- loaded with the first study: the globals and modules of then may be the user's.
local globals, program = { sg = true, help = true, arg = true }, {}
for name, value in next, require("signorini.prompt.prompt").standard do
  globals[name] = true
  if type(value) == "table" then program[value] = true end
end

--- Adds modules of the library that were loaded later.
local function find_program()
  for name, module in pairs(package.loaded) do
    if name:find "^signorini" then program[module] = true end
  end
end

--- The source text of a function; its bytes if there is none, because it was typed at the prompt or read from a pipe.
local function source_of(f)
  local about = debug.getinfo(f, "S")
  local file, lines = about.source:match "^@(.*)", {}
  if about.what == "C" then return "C" end
  if not file or not core.exists(file) then return string.dump(f, true) end
  for line in io.lines(file) do lines[#lines + 1] = line end
  if #lines < about.lastlinedefined then return string.dump(f, true) end
  return table.concat(lines, "\n", about.linedefined, about.lastlinedefined)
end

--- The variables that a function refers to, as a list of { name, value }: its upvalues, and the user's globals that
--- occur in its text, which it reads through _ENV.
local function references(f)
  local list, source = {}, source_of(f)
  for i = 1, math.huge do
    local name, value = debug.getupvalue(f, i)
    if not name then return list end
    if name ~= "_ENV" then list[#list + 1] = { name, value } end
    for global, one in next, name == "_ENV" and _G or {} do
      if type(global) == "string" and not globals[global] and source:find("%f[%w_]" .. global .. "%f[^%w_]") then
        list[#list + 1] = { global, one }
      end
    end
  end
end

--- The inputs of a study by name: `run` and each value to which it refers, or the inputs that were given instead.
local function parts_of(study)
  if study.inputs ~= nil then return { inputs = study.inputs } end
  if study.parts then return study.parts end
  local parts = { run = source_of(study.run) }
  for _, reference in ipairs(references(study.run)) do parts[reference[1]] = reference[2] end
  return parts
end

--- The contents of a table or a function, as a list of { name, value }. For a study or a convergence map these are its
--- inputs, not its times.
local function contents(value)
  if type(value) == "function" then return references(value) end
  local own, list = getmetatable(value), {}
  local kind = type(own) == "table" and rawget(own, "__name")
  local study = kind == "study" and (value.whole or value) or kind == "convergence map" and value.study
  for name, entry in next, study and { cases = study.cases, parts = parts_of(study) } or value do
    if type(name) == "string" or type(name) == "number" then list[#list + 1] = { name, entry } end
  end
  return list
end

--- Adds the text of a value to `out`; values that occurred before, or belong to the program, are only named.
local function write(value, out, seen)
  local kind = type(value)
  if kind == "userdata" then
    out[#out + 1] = core.kind(value)
    out[#out + 1] = core.content(value) -- empty for objects without content, such as an open file
  elseif kind ~= "table" and kind ~= "function" then
    out[#out + 1] = kind == "number" and ("%a"):format(value) or tostring(value)
  elseif seen[value] or program[value] or core.names[value] then
    out[#out + 1] = core.names[value] or "seen"
  else
    seen[value], out[#out + 1] = true, kind == "function" and source_of(value) or kind
    local list = contents(value)
    table.sort(list, function(a, b)
      if type(a[1]) ~= type(b[1]) then return type(a[1]) == "number" end
      return a[1] < b[1]
    end)
    for _, entry in ipairs(list) do
      out[#out + 1] = tostring(entry[1])
      write(entry[2], out, seen)
    end
  end
end

--- The inputs of a study by name: hashes of what its results depend on, and the program's version, unless the user gave
--- the inputs.
function inputs.of(study)
  find_program()
  local result = { ["the program's version"] = study.inputs == nil and release or nil }
  for name, part in pairs(parts_of(study)) do
    local out = {}
    write(part, out, {})
    result[name] = core.hash(table.concat(out, "\0"))
  end
  return result
end

--- The sorted names of the inputs that differ; empty if none does.
function inputs.difference(before, now)
  local names = {}
  for _, each in ipairs { before, now } do
    for name in pairs(each) do names[name] = before[name] ~= now[name] or nil end
  end
  return sorted_names(names)
end

return inputs
