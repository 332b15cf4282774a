-- Whether values conform to the definitions for editors (annotations.lua): what a language server would accept of a
-- call. It knows types, not limits: -1 is a number, also where the program takes positive ones.

local annotations = require "annotations"
local core = require "signorini.core"
local library = require "signorini.prompt.editor.library"
local lists = require "signorini.call.lists"
local page_text = require "signorini.prompt.help.page_text"
local prose = require "signorini.prompt.editor.prose"

local conformity = {}

local database

--- Without descriptions, whose layout takes most of the time.
local function types_of_library()
  local row, add_text = page_text.row, prose.add_text
  page_text.row, prose.add_text = function() return "text" end, function() end
  local files = library()
  page_text.row, prose.add_text = row, add_text
  return files
end

local function definitions()
  database = database or annotations.read(types_of_library())
  return database
end
conformity.definitions = definitions

--- The class of an object, "sg.patch"; nil of other values. A list of patches is a list, which has methods.
local function class_of(value)
  local own = type(value) == "table" and getmetatable(value)
  if own == core.types.patch_list then return nil end
  for name, methods in pairs(core.types) do
    if own == methods or core.kind(value) == name then return "sg." .. name end
  end
end

local kinds = {}

local function conforms(of, value) return kinds[of.kind](of, value) end

local function is(kind) return function(value) return type(value) == kind end end

local own = { any = function() return true end, ["nil"] = is "nil", boolean = is "boolean", number = is "number",
              string = is "string", table = is "table", ["function"] = is "function" }
function own.integer(value) return type(value) == "number" and math.tointeger(value) ~= nil end

--- Whether a plain table has the fields of a class, and no others unless it has types for them.
local function has_fields(class, value)
  for key, field in pairs(class.fields) do
    local entry = rawget(value, key)
    if entry ~= nil or not field.optional then
      local fits, place = conforms(field.of, entry)
      if not fits then return false, ("." .. key) .. (place or "") end
    end
  end
  for key, entry in next, value do
    local fits = class.fields[key] ~= nil
    for _, index in ipairs(class.indices) do fits = fits or conforms(index.key, key) and conforms(index.of, entry) end
    if not fits and class.exact then return false, ("[%s]"):format(key) end
  end
  return true
end

function kinds.name(of, value)
  local name = of[1]
  if own[name] then return own[name](value) end
  local db = definitions()
  if db.aliases[name] then return conforms(db.aliases[name], value) end
  local class = class_of(value)
  if class then return class == name end
  local is_object = core.types[name:match "^sg%.([%w_]+)$"] ~= nil
  if is_object or type(value) ~= "table" or name == "sg.unknown_argument" then return false end
  return has_fields(db.classes[name], value)
end

function kinds.literal(of, value) return value == of[1] end
kinds["function"] = function(_, value) return type(value) == "function" end

function kinds.union(of, value)
  local place
  for _, one in ipairs(of) do
    local fits, where = conforms(one, value)
    if fits then return true end
    place = place or where
  end
  return false, place
end

--- Whether all keys and entries of a table are of these types.
local function has_entries(key_type, of, value)
  if type(value) ~= "table" or class_of(value) then return false end
  for key, entry in next, value do
    local fits, place = conforms(of, entry)
    if not fits or not conforms(key_type, key) then return false, ("[%s]%s"):format(key, place or "") end
  end
  return true
end

local integer = { kind = "name", "integer" }
function kinds.list(of, value) return has_entries(integer, of.of, value) end
function kinds.map(of, value) return has_entries(of.key, of.of, value) end

function kinds.tuple(of, value)
  if type(value) ~= "table" or #value ~= #of.of then return false end
  for i, one in ipairs(of.of) do
    if not conforms(one, value[i]) then return false, ("[%d]"):format(i) end
  end
  return has_entries(integer, { kind = "name", "any" }, value)
end

--- Whether a value is of the type with this text, for tests.
function conformity.is(text, value) return conforms(annotations.type(text), value) end

--- The definition of a function, or of the call of an object such as a patch.
local function definition(name)
  local db = definitions()
  local class = db.classes["sg." .. name]
  local call = class and class.call
  return db.functions[name] or call and { takes = lists.map(call.takes, function(of) return { of = of } end),
                                          gives = call.gives }
end

--- Whether the arguments of a call of a function conform to its definition, otherwise also the place that does not,
--- such as "argument 1.inset". arguments.n: their number.
function conformity.of_call(name, arguments)
  local one = definition(name)
  if not one then return false, "name" end
  local takes, count = one.takes, arguments.n
  while count > 0 and arguments[count] == nil do count = count - 1 end
  for i = 1, math.max(count, #takes) do
    local takes_more = #takes > 0 and takes[#takes].name == "..."
    local argument, value = takes[i] or takes_more and takes[#takes], arguments[i]
    if not argument then return false, "number of arguments" end
    if value ~= nil or not (argument.optional or argument.name == "...") then
      local fits, place = conforms(argument.of, value)
      if not fits then return false, ("argument %d%s"):format(i, place or "") end
    end
  end
  return true
end

--- sg.picture draws a film and returns nothing if the name of the file asks for it.
local may_return_nothing = { ["sg.picture"] = true }

--- Whether the results of a function conform to its definition, otherwise also the place that does not.
function conformity.of_results(name, results)
  local gives = definition(name).gives
  if results.n == 0 and may_return_nothing[name] then return true end
  for i = 1, math.max(results.n, #gives) do
    if not gives[i] then return false, "number of results" end
    local fits, place = conforms(gives[i], results[i])
    if not fits then return false, ("result %d%s"):format(i, place or "") end
  end
  return true
end

--- sg.csv.write itself refuses some of what these types mark, such as rows with names.
local refuses_more = { ["sg.csv.write"] = true }

--- From here on every valid call of a function of the library must conform to its definition.
function conformity.watch_calls()
  local checker, pages = require "signorini.call.check", require "signorini.pages"
  local check_call = checker.call
  function checker.call(name, owner, ...)
    local page = pages.find(name)
    if page and not page.unchecked then
      local fits, place = conformity.of_call(name, table.pack(...))
      if not fits and not refuses_more[name] and pcall(check_call, name, owner, ...) then
        error(("%s is called as the program allows, but %s does not conform to the definitions for editors: "
          .. "correct the types"):format(name, place), 0)
      end
    end
    return check_call(name, owner, ...) -- no frame between it and the caller, whose line messages give
  end
end

--- From here on the results of the library's functions must conform to their definitions, too.
function conformity.watch_results()
  local names, pages = require "signorini.prompt.help.names", require "signorini.pages"
  for _, name in ipairs(pages.names()) do
    local call = names.value(name)
    if type(call) == "function" then
      local path, key = name:match "^(.*)[.:]([%w_]+)$"
      local function watched(...)
        local results = table.pack(call(...))
        local fits, place = conformity.of_results(name, results)
        if not fits then
          error(("%s: its %s does not conform to the definitions for editors"):format(name, place), 0)
        end
        return table.unpack(results, 1, results.n)
      end
      core.names[watched] = name
      rawset(path == "sg" and core.sg or names.value(path), key, watched)
    end
  end
end

return conformity
