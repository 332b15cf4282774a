-- Reads the definitions for editors: annotations of the Lua language server, in the form in which
-- lua/signorini/prompt/editor makes them. A line that is not of this form, a name that is used and not defined, or
-- defined twice, is an error.

local core = require "signorini.core"

local annotations = {}

-- ── Types ────────────────────────────────────────────────────────────────────────────────────────────────────────────

-- A type is { kind = "name", name }, { kind = "literal", value }, or "list", "union", "tuple", "map", "function" with
-- the types that it is made of.

local parse_union

--- A reader of a text: next(pattern) returns what matches there and goes on behind it, or nil.
local function reader(text)
  local self, at = {}, 1
  function self.next(pattern)
    local found, after = text:match("^(" .. pattern .. ")()", at)
    if found then at = after end
    return found
  end
  function self.need(pattern, what)
    return self.next(pattern) or error(("%s expected at: %s"):format(what, text:sub(at)), 0)
  end
  function self.rest() return text:sub(at) end
  return self
end

--- Types separated by commas.
local function parse_list(from)
  local list = {}
  repeat list[#list + 1] = parse_union(from) until not from.next ", "
  return list
end

local function parse_function(from)
  local takes = {}
  from.need("%(", "(")
  while not from.next "%)" do
    from.need("[%a_][%w_]*", "the name of a parameter")
    from.need(": ", "a colon")
    takes[#takes + 1] = parse_union(from)
    if not from.next ", " then
      from.need("%)", ")")
      break
    end
  end
  return { kind = "function", takes = takes, gives = from.next ": " and parse_list(from) or {} }
end

local function parse_one(from)
  local quoted = from.next '"[^"\\]*"'
  if quoted then return { kind = "literal", quoted:sub(2, -2) } end
  local number = from.next "%-?%d+%.?%d*"
  if number then return { kind = "literal", tonumber(number) } end
  if from.next "%[" then
    local tuple = { kind = "tuple", of = parse_list(from) }
    from.need("%]", "]")
    return tuple
  end
  if from.next "%(" then
    local inside = parse_union(from)
    from.need("%)", ")")
    return inside
  end
  if from.next "fun%f[(]" then return parse_function(from) end
  if from.next "table<" then
    local map = { kind = "map", key = parse_union(from) }
    from.need(", ", "a comma")
    map.of = parse_union(from)
    from.need(">", ">")
    return map
  end
  local name = from.need("[%a_][%w_.]*", "a type")
  if name == "true" or name == "false" then return { kind = "literal", name == "true" } end
  return { kind = "name", name }
end

function parse_union(from)
  local union = { kind = "union" }
  repeat
    local one = parse_one(from)
    while from.next "%[%]" do one = { kind = "list", of = one } end
    union[#union + 1] = one
  until not from.next "|"
  return #union == 1 and union[1] or union
end

-- ── Lines ────────────────────────────────────────────────────────────────────────────────────────────────────────────

local tags = {} -- read(database, rest of the line), by tag

--- The type at a place that ends the line, except for a description.
local function last_type(from)
  local of = parse_union(from)
  if not from.next " # .+" and from.rest() ~= "" then error("not the end of the line: " .. from.rest(), 0) end
  return of
end

--- Whether a name is followed by the question mark of what may be missing.
local function optional(from) return from.next "%?" ~= nil end

--- Adds a class, an alias or a function. Names of types and of functions are different things.
local function define(db, kind, name, value)
  local is_twice = db[kind][name] or kind ~= "functions" and (db.classes[name] or db.aliases[name])
  if is_twice then error(name .. " is defined twice", 0) end
  db[kind][name] = value
end

function tags.meta(_, from) from.need("[%w_]+", "a name") end

function tags.class(db, from)
  local exact = from.next "%(exact%) " ~= nil
  local name = from.need("[%a_][%w_.]*", "a name")
  db.class = db.classes[name]
  if db.class and not exact then return end -- a table to which another file adds functions
  db.class = { name = name, exact = exact, fields = {}, indices = {} }
  define(db, "classes", name, db.class)
end

function tags.field(db, from)
  if not db.class then error("a field without a class", 0) end
  if from.next "%[" then
    local key = parse_union(from)
    from.need("%] ", "]")
    table.insert(db.class.indices, { key = key, of = last_type(from) })
    return
  end
  local key = from.need("[%a_][%w_]*", "a name")
  if db.class.fields[key] then error(("%s.%s is defined twice"):format(db.class.name, key), 0) end
  local may_be_missing = optional(from)
  from.need(" ", "a blank")
  db.class.fields[key] = { of = last_type(from), optional = may_be_missing }
end

function tags.alias(db, from)
  local name = from.need("[%a_][%w_.]*", "a name")
  from.need(" ", "a blank")
  define(db, "aliases", name, last_type(from))
end

function tags.param(db, from)
  local name = from.next "%.%.%." or from.need("[%a_][%w_]*", "a name")
  local may_be_missing = optional(from)
  from.need(" ", "a blank")
  table.insert(db.takes, { name = name, of = last_type(from), optional = may_be_missing })
end

tags["return"] = function(db, from) table.insert(db.gives, last_type(from)) end
function tags.overload(db, from) db.class.call = last_type(from) end

--- Ends what the lines before have told about a function.
local function finish_function(db, name, heads)
  local names = {}
  for i, one in ipairs(db.takes) do names[i] = one.name end
  if table.concat(names, ", ") ~= heads then error("the parameters differ from those of the annotations", 0) end
  define(db, "functions", name, { takes = db.takes, gives = db.gives })
  db.takes, db.gives = {}, {}
end

local function read_line(db, line)
  local tag, rest = line:match "^%-%-%-@(%a+) (.+)$"
  if tag then
    local from = reader(rest)
    if not tags[tag] then error("unknown tag " .. tag, 0) end
    tags[tag](db, from)
    if from.rest() ~= "" then error("not the end of the line: " .. from.rest(), 0) end
  elseif line:find "^%-%-%-" then
    if line:find "^%-%-%-%s*[@|]" then error("a text that begins like an annotation", 0) end
  elseif line:find "^function " then
    finish_function(db, line:match "^function ([%a_][%w_.:]*)%((.*)%) end$")
  else
    local is_known = line == "" or line == "return sg" or line:find "^%-%- " or line:find "^[%a_][%w_. ]* = %S"
    if not is_known then error("not part of the form", 0) end
    if line ~= "" then db.class = nil end
  end
end

--- Calls f for each name in a type.
local function each_name(of, f)
  if of.kind == "name" then return f(of[1]) end
  for _, part in pairs(of) do
    if type(part) == "table" then each_name(part, f) end
  end
end

local own = { any = true, ["nil"] = true, boolean = true, number = true, integer = true, string = true, table = true,
              ["function"] = true }

--- An error if a name is used and not defined.
local function check_names(db)
  local function known(name)
    local is_known = own[name] or db.classes[name] or db.aliases[name]
    if not is_known then error(name .. " is used and not defined", 0) end
  end
  for _, kind in ipairs { "classes", "aliases", "functions" } do each_name(db[kind], known) end
end

--- All definitions: { classes, aliases, functions } by name. texts: the texts of the files, by name.
function annotations.read(texts)
  local db = { classes = {}, aliases = {}, functions = {}, takes = {}, gives = {} }
  for name, text in pairs(texts) do
    local number = 0
    for line in text:gmatch "([^\n]*)\n" do
      number = number + 1
      local ok, message = pcall(read_line, db, line)
      if not ok then error(("%s:%d: %s"):format(name, number, message), 0) end
    end
  end
  check_names(db)
  return db
end

--- The type of a text, for tests.
function annotations.type(text) return last_type(reader(text)) end

return annotations
