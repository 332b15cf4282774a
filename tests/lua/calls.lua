-- Right and wrong calls of every public function, made from the functions' tables (signorini.pages). In wrong ones an
-- argument, also of tables in tables, has a value of another type or out of its range, a misspelt key, or is left out.

local sg = require "signorini"
local check = require "check"
local core = require "signorini.core"
local describe = require "signorini.call.describe"
local names = require "signorini.prompt.help.names"
local pages = require "signorini.pages"
local type_in_call = require("signorini.call.check").type_in_call

local folder = check.folder()

-- ── Right values ─────────────────────────────────────────────────────────────────────────────────────────────────────

local make = {} -- an object of each type of the language

function make.patch() return sg.shapes.rectangle { width = 3, height = 1 } end
function make.material() return sg.neo_hookean { E = 1, nu = 0.3 } end
function make.symbol()
  local symbol
  sg.hyperelastic { energy = function(I1, _, J)
    symbol = I1
    return I1 - 3 - 2 * sg.log(J) + sg.log(J) ^ 2
  end }
  return symbol
end
function make.body()
  return sg.body { patch = make.patch(), elements = { 2, 2 }, order = "N2", contact = "north",
                   material = make.material() }
end
function make.face() return make.body():face "south" end
make["contact profile"] = function()
  local body = make.body()
  return sg.model { bodies = { slab = body }, contacts = { c = { slave = body:face "north", penalty = 1,
    master = make.obstacle() } } }:profile "c"
end
function make.obstacle() return sg.rigid.plane { point = { 0, 3 }, normal = { 0, -1 } } end
function make.model()
  local body = make.body()
  return sg.model { bodies = { slab = body }, supports = { bed = { on = body:face "south", fix = "x", drive = "y" } } }
end
--- With one part, whose faces, edges and corners have the names of a plane body's after "1.".
function make.patch_list() return sg.shapes.disc{ radius = 1 } end
function make.compound()
  return sg.body { patch = { make.patch() }, elements = { 2, 2 }, order = "N2", material = make.material() }
end
function make.modes() return make.model():modes { count = 1 } end
function make.mode() return make.modes()[1] end
function make.snapshot() return make.model():snapshot() end
function make.run() return make.model():run { { steps = 1, bed = 0.01 } } end
function make.gradients()
  return sg.gradients { at = { depth = 0.01 }, scene = function(q)
    return make.model(), { { steps = 1, bed = q.depth } }
  end }
end
--- A scene whose force grows with depth, and what changes it.
local function pushed(q) return make.model(), { { name = "push", steps = 2, bed = q.depth } } end
function make.fit()
  return sg.fit { scene = pushed, start = { depth = 0.02 }, check = false,
                  data = { { y = "bed.fy", points = { { 1, 0.004 }, { 2, 0.009 } } } } }
end
function make.optimum()
  return sg.optimize { scene = pushed, start = { depth = 0.01 }, bounds = { depth = { 0.01, 0.011 } },
                       least = "bed.fy" }
end
function make.state() return make.run():states()[1] end
function make.study()
  local study = sg.study { name = "calls", folder = folder .. "/study", cases = sg.grid { mesh = { 1, 2 } },
                           run = function(case) return { error = 1 / case.mesh, time = case.mesh } end }
  return study:execute { jobs = 1 }
end
function make.comparison() return sg.work_precision(make.study(), { error = "error", series = "mesh" }) end
make["convergence map"] = function()
  return sg.convergence_map { x = { name = "a", values = { 1, 2 } }, y = { name = "b", values = { 1, 2 } }, jobs = 1,
    scene = make.model, path = function() return { { steps = 1, bed = 0.01 } } end }
end
make.map = make["convergence map"] -- the owner of map:cell and others
function make.data()
  sg.csv.write(folder .. "/data.csv", { columns = { "step" }, rows = { { 1 } } })
  return sg.csv.read(folder .. "/data.csv")
end
function make.files() return sg.files(folder) end
function make.series() return sg.pvd(folder .. "/first.pvd") end
function make.picture() return sg.picture { model = make.model(), field = "uy" } end

local made = {}

local function object(name)
  if made[name] == nil then made[name] = assert(make[name], "no example of the type " .. name)() end
  return made[name]
end

local right = {}

local function right_value(type) return right[type.kind](type) end

--- A number within limits.
local function number_within(type, step)
  if type.low then return type.low end
  local top = type.high or type.below
  if type.above then return top and (type.above + top) / 2 or type.above + step end
  return type.high or type.below and type.below - step or step
end

--- The object that a method is called on, by the name of its page; nil of functions.
local function owner_of(page)
  local owner = page.name:match "^([%w_]+):"
  return owner and object(owner)
end

--- Right values of the needed rows. `owner`: the object of a method.
local function right_named(rows, owner)
  local value = {}
  for _, row in ipairs(pages.rows(rows)) do
    if type(row) == "table" and pages.is_needed(row) then
      value[row[1]] = right_value(type_in_call(row, owner, value, value))
    end
  end
  return value
end

local function right_list(type)
  local value = {}
  for i = 1, type.size or math.max(type.least or 1, 1) do value[i] = right_value(type.of) end
  return value
end

function right.any() return 1 end
function right.flag() return true end
function right.text() return "text" end
right["function"] = function() return print end
function right.number(type) return number_within(type, 1) end
function right.integer(type) return number_within(type, 1) end
function right.only(type) return type.value end
function right.object(type) return object(type.name) end
function right.choice(type) return type.of[1] end
function right.point(type) return type.high == 1 and { 1 } or type.low == 3 and { 1, 2, 3 } or { 1, 2 } end
function right.points() return { { 0, 0 }, { 1, 0 } } end
function right.list(type) return type.single and right_value(type.of) or right_list(type) end
function right.tuple(type)
  local value = {}
  for i, one in ipairs(type.of) do value[i] = type.rising and i or right_value(one) end
  return value
end
function right.named(type) return right_named(type.rows) end
function right.map(type) return { name = right_value(type.of) } end
function right.either(type) return right_value(type[1]) end
function right.switch() return true end
right["table"] = function() return object "contact profile" end
function right.data() return 1 end
function right.cells() return { 1 } end
function right.rows() return { { 1 } } end

-- ── Wrong values ─────────────────────────────────────────────────────────────────────────────────────────────────────

--- The types of Lua that values of a type may have.
local function lua_types(of)
  if of.kind == "either" then
    local found = {}
    for _, one in ipairs(of) do
      for name in pairs(lua_types(one)) do found[name] = true end
    end
    return found
  end
  if of.single or of.short then
    local found = lua_types(of.single and of.of or of.short[2])
    found.table = true
    return found
  end
  local names_of = { number = "number", integer = "number", flag = "boolean", text = "string", choice = "string",
                     ["function"] = "function" }
  if of.kind == "data" then return { number = true, string = true, boolean = true } end
  if of.kind == "switch" then
    local found = lua_types(of.of)
    found.boolean = true
    return found
  end
  if of.kind == "only" then return { [type(of.value)] = true } end
  if of.kind == "object" then return { [type(object(of.name))] = true } end
  return { [names_of[of.kind] or "table"] = true }
end

--- Values that are not of a type, { value }: those of all other types of Lua, and of its own those beyond its limits,
--- { value, by_limit = true }.
local function wrong_values(of)
  if of.kind == "any" then return {} end
  local wrong, taken = {}, lua_types(of)
  for _, value in ipairs { 3, "nonsense", true, print, io.stdout } do
    if not taken[type(value)] then wrong[#wrong + 1] = { value } end
  end
  local function add(value) wrong[#wrong + 1] = { value } end
  local function add_limit(value) wrong[#wrong + 1] = { value, by_limit = true } end
  if of.kind == "number" and not of.gaps then add_limit(0 / 0) add_limit(1 / 0) end
  if of.kind == "integer" then add(1.5) end
  if of.kind == "number" or of.kind == "integer" then
    if of.low then add_limit(of.low - 1) end
    if of.above then add_limit(of.above) end
    if of.high then add_limit(of.high + 1) end
    if of.below then add_limit(of.below) end
  end
  if of.kind == "choice" then add "nonsense" end
  if of.kind == "list" then
    add { name = 1 }
    if of.size then add {} end
  end
  if of.kind == "tuple" then add {} end
  if of.kind == "point" then add {} add { 1, 2, 3, 4 } end
  return wrong
end

-- ── Wrong calls ──────────────────────────────────────────────────────────────────────────────────────────────────────

--- What one place of a call is replaced by: puts `set(value)` of the whole arguments together. `general`: the type of
--- the place without an object.
local function add_wrong(calls, page, of, name, set, general)
  for _, wrong in ipairs(wrong_values(of)) do
    local value = wrong[1]
    local finite = value == value and value ~= 1 / 0
    calls[#calls + 1] = { page = page, arguments = set(value), place = name, what = core.describe(value),
                          by_limit = wrong.by_limit, by_object = general ~= nil and general ~= of,
                          holds = { name, finite and describe.one(of) or "finite" } }
  end
  local function inside(type, known)
    if type.kind == "either" then
      known = {}
      for _, one in ipairs(type) do inside(one, known) end
    elseif type.kind == "switch" then
      inside(type.of)
    elseif type.kind == "named" then
      calls.add_rows(calls, page, type.rows, type.rest, type.last and "" or name, set, known)
    elseif type.kind == "point" then
      add_wrong(calls, page, { kind = "number" }, name .. "[1]", function(value)
        local point = right.point(type)
        point[1] = value
        return set(point)
      end)
    elseif type.kind == "map" then
      add_wrong(calls, page, type.of, name .. ".entry", function(value) return set { entry = value } end)
    elseif type.kind == "list" and type.of.kind ~= "any" then
      add_wrong(calls, page, type.of, name .. "[1]", function(value)
        local list = right_list(type)
        list[1] = value
        return set(list)
      end)
    end
  end
  inside(of)
end

--- Wrong values of each row, misspelt keys, and needed ones left out. A page may refer to itself. `known`: keys of the
--- alternatives before, which check values of tables that have no other keys.
local function add_rows(calls, page, rows, rest, name, set, known)
  local depth = select(2, name:gsub("[.%[]", ""))
  if depth > 4 then return end
  local owner = name == "" and owner_of(page) or nil
  for _, row in ipairs(pages.rows(rows)) do
    if type(row) == "table" and not (known and known[row[1]]) then
      local key = row[1]
      if known then known[key] = true end
      local place = name == "" and key or name .. "." .. key
      local function with(given)
        local value = right_named(rows, owner)
        given(value)
        return set(value)
      end
      local before = right_named(rows, owner)
      add_wrong(calls, page, type_in_call(row, owner, before, before), place, function(entry)
        return with(function(value) value[key] = entry end)
      end, row[2])
      if not rest then
        calls[#calls + 1] = { page = page, place = place, what = "a misspelt key", holds = { key .. "q", "unknown" },
          arguments = with(function(value) value[key .. "q"] = 1 end) }
      end
      if pages.is_needed(row) and not row[2].last then
        calls[#calls + 1] = { page = page, place = place, what = "nothing", holds = { place, "is missing" },
          arguments = with(function(value) value[key] = nil end) }
      end
    end
  end
end

--- Right arguments of a page's function: the needed ones of a table of named arguments, all positional ones.
local function right_arguments(page)
  local owner = owner_of(page)
  if page.named then return { right_named(page.named, owner) } end
  local values = {}
  for i, row in ipairs(page.arguments or {}) do values[i] = right_value(type_in_call(row, owner)) end
  return values
end

local function add_wrong_calls(calls, page)
  if page.named then
    add_rows(calls, page, page.named, page.rest, "", function(value) return { value } end)
    if page.entries then
      add_wrong(calls, page, page.entries[2], "[1]", function(value)
        local whole = right_named(page.named)
        whole[1] = value
        return { whole }
      end)
    end
    calls[#calls + 1] = { page = page, place = "the table", what = "a number", holds = { "named arguments" },
      arguments = { 3 } }
  end
  local rows = page.arguments or {}
  local owner = owner_of(page)
  local function whole() return right_arguments(page) end
  for i, row in ipairs(rows) do
    add_wrong(calls, page, type_in_call(row, owner), row[1], function(value)
      local values = whole()
      values[i] = value
      return values
    end, row[2])
    if pages.is_needed(row) and not row[2].last then
      calls[#calls + 1] = { page = page, place = row[1], what = "nothing", holds = { row[1], "is missing" },
        arguments = table.move(whole(), 1, i - 1, 1, {}) }
    end
  end
  local excess = whole()
  excess[page.named and 2 or #rows + 1] = 3
  if not page.repeats then
    calls[#calls + 1] = { page = page, place = "the end", what = "one more", holds = { "too many arguments" },
      arguments = excess }
  end
end

-- ── All of them ──────────────────────────────────────────────────────────────────────────────────────────────────────

local calls = { owner_of = owner_of, value = right_value, rows = right_named, type_of = type_in_call }

--- Calls f(page) of every function that has its arguments checked.
local function each_page(f)
  for _, group in ipairs(pages.groups()) do
    for _, page in ipairs(group) do
      if type(names.value(page.name)) == "function" and not page.unchecked then f(page) end
    end
  end
end

--- Wrong calls: { page, arguments, place, what, holds = what the message has, by_limit = whether the value is only out
--- of range, by_object = whether the type depends on the object of the call }.
function calls.wrong()
  local list = { add_rows = add_rows }
  each_page(function(page) add_wrong_calls(list, page) end)
  return list
end

--- A right call of each function: { page, arguments }.
function calls.right()
  local list = {}
  each_page(function(page) list[#list + 1] = { page = page, arguments = right_arguments(page) } end)
  return list
end

--- The number of arguments of a call, also if the last ones are nil.
function calls.count(arguments)
  local count = #arguments
  for i in pairs(arguments) do count = math.max(count, math.type(i) == "integer" and i or 0) end
  return count
end

return calls
