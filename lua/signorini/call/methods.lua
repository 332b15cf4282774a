-- Argument checks of methods written in Lua, of types that are written in Lua or in C++; a call on a wrong object is
-- reported. Methods bound in C++ are checked there.

local core = require "signorini.core"

local function is_own(type_name)
  local methods = core.types[type_name]
  if not rawget(methods, "__name") then return function(value) return core.kind(value) == type_name end end -- of C++
  return function(value) return type(value) == "table" and getmetatable(value) == methods end
end

--- The function with its arguments checked against its table; the checking module is loaded at the first call.
local function checked(name, f)
  return function(...) return f(require("signorini.call.check").call(name, nil, ...)) end
end

local function guarded(type_name, key, method, owns)
  local name = ("%s:%s"):format(type_name, key)
  return function(self, ...)
    if not owns(self) then
      local with_article = require("signorini.call.describe").with_article
      local noun = rawget(core.types[type_name], "__name") or type_name
      core.fail(("%s must be called on %s, got %s. Hint: write it with a colon after the %s, %s(…)")
        :format(name, with_article(noun), core.describe(self), noun, name))
    end
    return method(self, require("signorini.call.check").call(name, self, ...))
  end
end

local methods = {}

--- Makes the functions of a table and of its subtables public: errors are raised at the line of the call. `path`: the
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

--- Adds the checks to the public methods of a type, a string of names, and makes them public.
function methods.guard(type_name, keys)
  local entries, owns = core.types[type_name], is_own(type_name)
  core.names[entries] = type_name
  for key in keys:gmatch "%S+" do
    entries[key] = core.offered(guarded(type_name, key, entries[key], owns))
    core.names[entries[key]] = ("%s:%s"):format(type_name, key)
  end
end

return methods
