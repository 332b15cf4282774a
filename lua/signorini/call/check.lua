-- Checks the arguments of a call against the function's table (signorini.pages) and fills in the defaults.

local core = require "signorini.core"
local describe = require "signorini.call.describe"
local fits = require "signorini.call.fits"
local lists = require "signorini.call.lists"
local pages = require "signorini.pages"
local reject = require "signorini.call.reject"
local types = require "signorini.call.types"

local check = { reject = reject.value }

local function mismatch(of, value, where, name, row, cure)
  reject.value(where, name, describe.one(of), value, cure, row)
end

-- ── Tables: read entry by entry ──────────────────────────────────────────────────────────────────────────────────────

local read
local length = lists.length

local reads = {}

local function list_cure(of, value)
  if of.cure then return of.cure(value) end
  if type(value) == "number" then return "put it into braces, as in {1, 2}" end
  if of.kind == "point" and type(value) ~= "table" then return "write its coordinates, as in {1, 2}" end
  if pages.kind(value) == "table" and not length(value) then
    return "write its values one after the other, as in {1, 2}, without names or gaps"
  end
end

--- True if a value has the shape of a type, so that messages about it should be those of the type.
local function resembles(of, value)
  if of.single and resembles(of.of, value) then return true end
  if of.kind == "either" and lists.any(of, function(one) return resembles(one, value) end) then return true end
  if fits[of.kind] then return (fits[of.kind](of, value)) end
  if type(value) ~= "table" or not ({ table = 1, ["list of patches"] = 1 })[pages.kind(value)] then return false end
  local list = rawlen(value) > 0
  if of.kind == "named" or of.kind == "map" then return not list or (of.rest ~= nil) end
  local entry = of.kind == "list" and of.of
  if list and entry and not fits[entry.kind] then return resembles(entry, value[1]) end
  return list or next(value) == nil
end

--- Checks an entry of a list; its name is built only for error messages.
local function read_entry(of, list, i, where, name)
  local single = fits[of.kind]
  if single and single(of, list[i]) then return list[i] end
  return read(of, list[i], where, ("%s[%d]"):format(name, i))
end

--- Checks a value that is not a table of others; `whole`: the type that messages name.
local function read_alone(of, value, whole, where, name, row)
  local ok, cure, expected = (fits[of.kind] or fits.table)(of, value)
  if not ok then
    local hint = cure or of ~= whole and list_cure(whole, value)
    reject.value(where, name, expected or describe.one(whole), value, hint, row)
  end
  return value
end

--- Products of large integers overflow in Lua.
function reads.number(of, value, where, name, row)
  value = read_alone(of, value, of, where, name, row)
  local large = math.type(value) == "integer" and (value > 1 << 53 or value < -(1 << 53))
  return large and value + 0.0 or value
end

--- The list of a single entry that was given without braces.
local function read_single(of, value, where, name, row)
  if fits[of.of.kind] then return { read_alone(of.of, value, of, where, name, row) } end
  if type(value) == "table" and of.of.kind ~= "either" or resembles(of.of, value) then
    return { read(of.of, value, where, name, row) }
  end
  mismatch(of, value, where, name, row, list_cure(of, value))
end

local read_named

function reads.list(of, value, where, name, row)
  local count = length(value, of.fields)
  if of.single and not count then return read_single(of, value, where, name, row) end
  if of.flat and count then
    value = lists.flattened(value)
    count = #value
  end
  local wrong = not count or of.size and count ~= of.size or of.least and count < of.least
  if wrong then mismatch(of, value, where, name, row, list_cure(of, value)) end
  if of.fields then return read_named(of.fields, value, where, name, nil, nil, { nil, of.of }) end
  local copy
  for i = 1, count do
    local entry = read_entry(of.of, value, i, where, name)
    if entry ~= value[i] then
      copy = copy or table.move(value, 1, count, 1, {})
      copy[i] = entry
    end
  end
  return copy or value
end

local in_cell = { number = true, string = true, boolean = true }

--- The key and value of an entry that cannot be a cell of a table, or nil.
local function wrong_cell(cells)
  for key, cell in next, cells do
    if not in_cell[type(cell)] then return key, cell end
  end
end

function reads.cells(of, value, where, name, row)
  if type(value) ~= "table" then mismatch(of, value, where, name, row) end
  local key, cell = wrong_cell(value)
  if key then reject.value(where, ("%s[%s]"):format(name, key), "a number, a string, true or false", cell) end
  return value
end

function reads.rows(of, value, where, name, row)
  local count = type(value) == "table" and rawlen(value) -- strict tables raise errors of their own on value[1]
  if not count or count == 0 and next(value) ~= nil then mismatch(of, value, where, name, row) end
  for i = 1, count do
    local cells = value[i]
    if type(cells) ~= "table" or wrong_cell(cells) then
      reads.cells(types.cells, cells, where, ("%s[%d]"):format(name, i))
    end
  end
  return value
end

--- True if a value is a point of a type; without a message.
local function is_point(of, value)
  if length(value) ~= of.low then return false end
  for i = 1, of.low do
    if not fits.number(types.number, value[i]) then return false end
  end
  return true
end

function reads.point(of, value, where, name, row)
  local count = length(value)
  local wrong = not count or count < of.low or count > of.high
  if wrong then mismatch(of, value, where, name, row, list_cure(of, value)) end
  for i = 1, count do read_entry(types.number, value, i, where, name) end
  return value
end

function reads.tuple(of, value, where, name, row)
  local count = length(value) or -1
  if count < of.least or count > #of.of then mismatch(of, value, where, name, row, list_cure(of, value)) end
  for i = 1, count do read_entry(of.of[i], value, i, where, name) end
  if of.rising and value[1] >= value[2] then
    core.fail(("%s: %s must be increasing, got %s. Hint: put the lower value first"):format(where, name,
      describe.literal(value)))
  end
  return value
end

function reads.points(of, value, where, name, row)
  local count = length(value)
  if not count then mismatch(of, value, where, name, row, list_cure(of, value)) end
  if count == 0 then reject.value(where, name, "a list of at least one point {{x, y}, …}", value, nil, row) end
  local point = type(value[1]) == "table" and rawlen(value[1]) == 3 and types.space_point or types.plane_point
  for i = 1, count do
    if not is_point(point, value[i]) then reads.point(point, value[i], where, ("%s[%d]"):format(name, i)) end
  end
  return value
end

--- By rows of a page: the set of their keys.
local keys_of = setmetatable({}, { __mode = "k", __index = function(all, rows)
  local keys = {}
  for _, row in ipairs(rows) do keys[type(row) == "table" and row[1] or 0] = true end
  all[rows] = keys
  return keys
end })

--- Raises an error unless all keys of a table are those of rows. `count`: number of entries without a name.
local function check_keys(rows, value, where, name, count)
  local known, unknown = keys_of[rows], {}
  for key, entry in next, value do
    if not known[key] and not (math.type(key) == "integer" and key >= 1 and key <= (count or 0)) then
      if type(key) ~= "string" then
        core.fail(("%s%s takes named arguments, got %s without a name; known: %s"):format(where,
          name == "" and "" or ": " .. name, core.describe(entry), reject.known(rows)))
      end
      unknown[#unknown + 1] = key
    end
  end
  if #unknown > 0 then reject.unknown(where, name, value, unknown, rows) end
end

--- The type of a row in one call; see types.by.
local function type_in_call(row, owner, given, raw)
  local of = row[2]
  return of.special and of.special(owner, given, raw) or of
end
check.type_in_call = type_in_call

--- The value of an argument that is not given. `values`: those read before; `of`: its type. Defaults of tables and
--- switches are read as if they had been given.
local function left_out(row, of, values, where, name)
  local value = row.default
  if row.derived then value = row.derived(values) end
  if value == nil and pages.is_needed(row) then reject.value(where, name, describe.one(of), nil, nil, row) end
  if value ~= nil and (row.derived or of.kind == "named" or of.kind == "switch") then
    return read(of, value, where, name, row)
  end
  return value
end

--- Reads named arguments: those of the rows, checked, with defaults where they are not given, and others of the type
--- `rest`. `owner`: of a method; `entries`: of a page. The rows' `conflict` checks the values against each other.
function read_named(rows, value, where, name, rest, owner, entries)
  local count = entries and rawlen(value) or 0
  if not rest then check_keys(rows, value, where, name, count) end
  local whole, prefix = {}, name == "" and "" or name .. "."
  for i = 1, count do whole[i] = read_entry(entries[2], value, i, where, name) end
  for _, row in ipairs(rows) do
    if type(row) == "table" then
      local key, given = row[1], nil
      if rest then given = rawget(value, key) else given = value[key] end -- contact profiles refuse other names
      if given ~= nil then
        whole[key] = read(type_in_call(row, owner, whole, value), given, where, prefix .. key, row)
      else
        whole[key] = left_out(row, type_in_call(row, owner, whole, value), whole, where, prefix .. key)
      end
    end
  end
  for _, row in ipairs(rows) do reject.dependencies(row, value, where, prefix) end
  for key, entry in next, rest and value or {} do
    if whole[key] == nil then whole[key] = read(rest, entry, where, prefix .. tostring(key)) end
  end
  local wrong = rows.conflict and rows.conflict(whole, value)
  if wrong then core.fail(("%s: %s%s"):format(where, name == "" and "" or name .. ": ", wrong)) end
  return whole
end

function reads.named(of, value, where, name, row)
  if of.short and type(value) ~= "table" then
    if not resembles(of.short[2], value) then mismatch(of, value, where, name, row) end
    value = { [of.short[1]] = value }
  end
  local rows = pages.rows(of.rows)
  local cure = of.cures and of.cures[pages.kind(value)]
  if type(cure) == "function" then cure = cure(value) end
  if type(value) ~= "table" or getmetatable(value) == false or cure then
    local first = rows[1] and type(rows[1]) == "table" and rows[1][1] .. " = …" or ""
    mismatch(of, value, where, name, row, cure or ("write %s = { %s }"):format(name, first))
  end
  return read_named(rows, value, where, of.last and "" or name, of.rest)
end

--- true means the value `on` of the type, false none.
function reads.switch(of, value, where, name, row)
  if value == false then return nil end
  if value == true then value = of.on end
  if not fits[of.of.kind] and type(value) == "table" then return read(of.of, value, where, name, row) end
  local ok, cure = (fits[of.of.kind] or fits.table)(of.of, value)
  if not ok then mismatch(of, value, where, name, row, cure) end
  return value
end

--- Raises an error where a table of names is given one entry without a name.
local function reject_nameless(of, value, where, name)
  if of.kind == "either" then of = of[1] end
  for _, row in ipairs(of.kind == "named" and pages.rows(of.rows) or {}) do
    local entry = rawget(value, row[1])
    if entry ~= nil and type(entry) ~= "table" then
      core.fail(("%s: %s contains an entry without a name. Hint: write %s = { name = { %s = …, … } }"):format(where,
        name, name, row[1]))
    end
  end
end

function reads.map(of, value, where, name, row)
  local wrong = type(value) ~= "table" or of.least and next(value) == nil
  if wrong then mismatch(of, value, where, name, row, "write { name = … }") end
  reject_nameless(of.of, value, where, name)
  local whole = {}
  for key, entry in next, value do
    if type(key) ~= "string" then
      core.fail(("%s: every entry of %s needs a name, got %s without one. Hint: write name = …"):format(where, name,
        core.describe(entry)))
    end
    whole[key] = read(of.of, entry, where, ("%s.%s"):format(name, key))
  end
  return whole
end

--- How many of a table's keys a type knows.
local function known_keys(of, value)
  return #lists.filter(of.kind == "named" and pages.rows(of.rows) or {}, function(row)
    return rawget(value, row[1]) ~= nil
  end)
end

--- The first type that fits; of several tables of named arguments, the one that has most of the keys.
function reads.either(of, value, where, name, row)
  local best, most = nil, -1
  for _, one in ipairs(of) do
    local count = resembles(one, value) and known_keys(one, value) or -1
    if count > most then best, most = one, count end
  end
  for _, one in ipairs(best and {} or of) do -- if the first entry of a list is wrong, the message names that entry
    if one.kind == "list" and length(value) and rawlen(value) > 0 then best = one end
  end
  if best then return read(best, value, where, name, row) end
  local finite = type(value) ~= "number" or math.abs(value) < math.huge
  local cure = type(value) == "string" and tonumber(value) and "remove the quotes" or nil
  for _, one in ipairs(of) do
    if not cure and (one.kind == "number" or one.kind == "integer") and type(value) == "number" then
      cure = select(2, fits[one.kind](one, value))
    end
  end
  cure = cure or of.cure
  for _, one in ipairs(of) do
    if not cure and one.kind == "choice" and type(value) == "string" then cure = select(2, fits.choice(one, value)) end
  end
  reject.value(where, name, finite and describe.one(of) or describe.one(of) .. ", finite", value, cure, row)
end

function read(of, value, where, name, row)
  if reads[of.kind] then return reads[of.kind](of, value, where, name, row) end
  return read_alone(of, value, of, where, name, row)
end

--- Checks a value against a type that depends on data outside the tables, such as the components that a support drives;
--- returns it with defaults.
check.value, check.keys = read, check_keys

--- True if a value is of a type that is not a table.
function check.fits(of, value) return (fits[of.kind](of, value)) end

-- ── Calls ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The arguments of a call as the function receives them: those given, checked, and defaults for the others.
--- `name`: of the function's page; the arguments of functions without a page are passed unchanged. `owner`: the object
--- on which a method is called.
function check.call(name, owner, ...)
  local page = pages.find(name)
  if not page or page.unchecked then return ... end
  local count = select("#", ...)
  while count > 0 and (select(count, ...)) == nil do count = count - 1 end
  if page.named then
    local value = ...
    if type(value) ~= "table" and not (value == nil and page.may_be_empty) then
      local first = pages.keys(page.named)[1]
      core.fail(("%s takes a table of named arguments, got %s. Hint: write %s{ %s }; known: %s"):format(name,
        core.describe(value), name, first and first .. " = …" or "", reject.known(page.named)))
    end
    if count > 1 then reject.excess(page, (select(2, ...))) end
    local whole = read_named(pages.rows(page.named), value or {}, name, "", page.rest, owner, page.entries)
    return page.as_given and (value or {}) or whole
  end
  local rows = page.arguments or {}
  if count > #rows and not page.repeats then reject.excess(page, (select(#rows + 1, ...))) end
  if count == 0 and #rows == 0 then return end
  if count == 1 and #rows == 1 then
    return (read(type_in_call(rows[1], owner), (...), name, rows[1][1], rows[1]))
  end
  local given, last = { ... }, math.max(count, #rows)
  for i = 1, last do
    local row = rows[math.min(i, #rows)]
    if given[i] == nil and row[2].last then given[i] = {} end
    if given[i] ~= nil then
      given[i] = read(type_in_call(row, owner), given[i], name, row[1], row)
    else
      given[i] = left_out(row, type_in_call(row, owner), given, name, row[1])
    end
  end
  return table.unpack(given, 1, last)
end

return check
