-- Methods of the types that are written in Lua, and of models, called on something else: an error like any other. The
-- bindings in C++ check theirs themselves.

local core = require "signorini.core"

local function is_own(type_name)
  local methods = core.types[type_name]
  if type_name == "model" then return function(value) return core.kind(value) == "model" end end
  return function(value) return type(value) == "table" and getmetatable(value) == methods end
end

local function guarded(type_name, key, method, owns)
  return function(self, ...)
    if not owns(self) then
      local name, noun = type_name .. ":" .. key, type_name == "model" and "model" or core.types[type_name].__name
      core.fail(("%s must be called on a %s, got %s: write it with a colon behind the %s, %s(…)")
        :format(name, noun, core.describe(self), noun, name))
    end
    return method(self, ...)
  end
end

local methods = {}

--- Offers what a table of the language holds, and the tables in it: errors stand at the line of the call.
function methods.offer(entries)
  for key, entry in next, entries do
    if type(entry) == "table" then methods.offer(entry) end
    if type(entry) == "function" and not core.names[entry] then entries[key] = core.offered(entry) end
  end
end

--- Puts the check in front of these methods, or of all of a type that have a page, and offers them.
function methods.guard(type_name, keys)
  local entries, owns = core.types[type_name], is_own(type_name)
  if not keys then
    keys = {}
    for key, entry in pairs(entries) do
      if type(entry) == "function" and core.docs[type_name .. ":" .. key] then keys[#keys + 1] = key end
    end
  end
  for _, key in ipairs(keys) do
    local parameters = debug.getinfo(entries[key], "u")
    entries[key] = core.offered(guarded(type_name, key, entries[key], owns),
      not parameters.isvararg and parameters.nparams or nil)
  end
end

return methods
