-- Methods of the types that are written in Lua, and of models, called on something else: an error like any other. The
-- bindings in C++ check theirs themselves.

local core = require "signorini.core"

local function is_own(type_name)
  local methods = core.types[type_name]
  if type_name == "model" then return function(value) return core.kind(value) == "model" end end
  return function(value) return type(value) == "table" and getmetatable(value) == methods end
end

--- The function with its arguments checked against its table; what checks is loaded with the first call.
local function checked(name, f)
  return function(...) return f(require("signorini.check").call(name, nil, ...)) end
end

local function guarded(type_name, key, method, owns)
  local name = ("%s:%s"):format(type_name, key)
  return function(self, ...)
    if not owns(self) then
      local noun = type_name == "model" and "model" or core.types[type_name].__name
      core.fail(("%s must be called on a %s, got %s: write it with a colon behind the %s, %s(…)")
        :format(name, noun, core.describe(self), noun, name))
    end
    return method(self, require("signorini.check").call(name, self, ...))
  end
end

local methods = {}

--- Offers what a table of the language holds, and the tables in it: errors stand at the line of the call. `path`: the
--- table's name.
function methods.offer(entries, path)
  for key, entry in next, entries do
    local name = ("%s.%s"):format(path, key)
    if type(entry) == "table" then methods.offer(entry, name) end
    if type(entry) == "function" and not core.names[entry] then
      entries[key] = core.offered(checked(name, entry))
      core.names[entries[key]] = name
    end
  end
end

--- Puts the checks in front of the public methods of a type, words of a text, and offers them.
function methods.guard(type_name, keys)
  local entries, owns = core.types[type_name], is_own(type_name)
  core.names[entries] = type_name
  for key in keys:gmatch "%S+" do
    entries[key] = core.offered(guarded(type_name, key, entries[key], owns))
    core.names[entries[key]] = ("%s:%s"):format(type_name, key)
  end
end

return methods
