-- What may stand at a place in a call, read off the table of the function (signorini.pages): names of arguments, and
-- texts of closed sets.

local core = require "signorini.core"
local pages = require "signorini.pages"

local rows = {}

--- The types behind a key of one of some types; false: of the entries of a list.
local function step(types, key)
  local found = {}
  local function add(type)
    if type.kind == "either" then
      for _, one in ipairs(type) do add(one) end
    elseif type.kind == "switch" then
      add(type.of)
    elseif type.kind == "named" and key then
      local row = pages.row(type.rows, key)
      if row then found[#found + 1] = row[2] elseif type.rest then found[#found + 1] = type.rest end
    elseif type.kind == "named" and type.entries then
      found[#found + 1] = type.entries[2]
    elseif type.kind == "map" and key or type.kind == "list" and not key then
      found[#found + 1] = type.of
    end
  end
  for _, type in ipairs(types) do add(type) end
  return found
end

--- The types at a place: of the argument of this number of a page's function, behind these keys.
local function types_at(name, argument, keys)
  local page = pages.find(name)
  if not page then return {} end
  local row = page.arguments and page.arguments[argument]
  local types = page.named and argument == 1 and { { kind = "named", rows = page.named, rest = page.rest,
    entries = page.entries, names = page.names } } or { row and row[2] }
  for _, key in ipairs(keys) do types = step(types, key) end
  return types
end

--- The names of arguments that the table at a place takes. `owner`: the object that the call is about.
function rows.names(name, argument, keys, owner)
  local found = {}
  local function add(type)
    if type.kind == "named" then
      for _, key in ipairs(pages.keys(type.rows)) do found[#found + 1] = key end
    end
    for _, key in ipairs(type.names and owner and type.names(owner) or {}) do found[#found + 1] = key end
    for _, one in ipairs(type.kind == "either" and type or type.kind == "switch" and { type.of } or {}) do add(one) end
  end
  for _, type in ipairs(types_at(name, argument, keys)) do add(type) end
  return found
end

--- The texts that may stand at a place.
function rows.texts(name, argument, keys, owner)
  local found = {}
  local function add(type)
    local of = type.of
    if type.kind == "choice" or type.kind == "text" or type.kind == "any" then
      if core.kind(of) == "function" then of = of(owner, keys[#keys]) end
      for _, text in ipairs(of or {}) do found[#found + 1] = text end
    elseif type.kind == "list" then
      add(of)
    end
    for _, one in ipairs(type.kind == "either" and type or {}) do add(one) end
  end
  for _, type in ipairs(types_at(name, argument, keys)) do add(type) end
  return found
end

return rows
