-- What is possible at a position in a call, according to the function's table (signorini.pages): names of arguments,
-- and strings of choices.

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local pages = require "signorini.pages"

local rows = {}

local function choices(type)
  if type.kind == "switch" then return choices(type.of) end
  return type.kind == "either" and lists.flat(lists.map(type, choices)) or { type }
end

--- The types behind a key of a type, a list; false: of the entries of a list.
local function step(type, key)
  if type.kind == "named" and key then
    local row = pages.row(type.rows, key)
    return { row and row[2] or type.rest }
  end
  if type.kind == "named" then return { type.entries and type.entries[2] } end
  return { (type.kind == "map" and key or type.kind == "list" and not key) and type.of or nil }
end

--- The lists that f returns for types and their alternatives, joined.
local function all(types, f)
  local found = {}
  for _, type in ipairs(types) do
    for _, one in ipairs(choices(type)) do found = lists.joined(found, f(one)) end
  end
  return found
end

--- The types at a position: of the argument of this number of a page's function, below these keys.
local function types_at(name, argument, keys)
  local page = pages.find(name)
  if not page then return {} end
  local row = page.arguments and page.arguments[argument]
  local types = page.named and argument == 1 and { { kind = "named", rows = page.named, rest = page.rest,
    entries = page.entries, names = page.names } } or { row and row[2] }
  for _, key in ipairs(keys) do types = all(types, function(type) return step(type, key) end) end
  return types
end

--- The names of arguments that the table at a position takes. `owner`: the object of the call.
function rows.names(name, argument, keys, owner)
  return all(types_at(name, argument, keys), function(type)
    local own = type.kind == "named" and pages.keys(type.rows) or {}
    return lists.joined(own, type.names and owner and type.names(owner) or {})
  end)
end

local function texts_of(type, owner, key)
  if type.kind == "list" then return all({ type.of }, function(one) return texts_of(one, owner, key) end) end
  if type.kind ~= "choice" and type.kind ~= "text" and type.kind ~= "any" then return {} end
  return core.kind(type.of) == "function" and type.of(owner, key) or core.kind(type.of) == "table" and type.of or {}
end

--- The strings that are possible at a position.
function rows.texts(name, argument, keys, owner)
  return all(types_at(name, argument, keys), function(type) return texts_of(type, owner, keys[#keys]) end)
end

return rows
