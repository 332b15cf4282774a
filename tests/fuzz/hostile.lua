-- Values that no caller would mean, for tests/fuzz/hostile_calls.lua.

local hostile = {}

--- The error of functions and tables that raise one: it passes through the library unchanged.
hostile.raised = "raised by the argument"

local function raise() error(hostile.raised, 0) end

local numbers = { 0, -0.0, 1, -1, 2, 3, 0.5, 1.5, 100, 1e6, 1e9, 1e308, -1e308, 5e-324, 1e-300, 0 / 0, 1 / 0, -1 / 0,
                  1 << 31, (1 << 31) - 1, -(1 << 31) - 1, math.maxinteger, math.mininteger, 2.0 ^ 53 }
local strings = { "", " ", "a", "x", "xy", "nan", "-1", "1e999", "\0", "a\0b", "\xff\xfe\x80", "two\nlines", "%s%n%d",
                  "../../escaped", "no/such/folder/file", ("x"):rep(5000), "é", "'\"\\", "N99", "N2-N2.2x9999", "auto",
                  "~/file", ".", "a.png", "a.csv", "a.html", "a.sgn", "$(false)", "\27[2J" }

local function cyclic()
  local one = { 1 }
  one.self, one[2] = one, one
  return one
end

local function nested()
  local value = 1
  for _ = 1, 250 do value = { value } end
  return value
end

local function many(n)
  local list = {}
  for i = 1, n do list[i] = i end
  return list
end

local tables = {
  function() return {} end,
  function() return { {} } end,
  function() return { 1, 2 } end,
  function() return { 1, nil, 3 } end,
  function() return { 0 / 0, 1 } end,
  function() return { [0] = 1, [-1] = 2, [1.5] = 3 } end,
  function() return { [print] = 1, [true] = 2 } end,
  function() return { name = 1 } end,
  function() return { "a", b = "c" } end,
  cyclic, nested,
  function() return many(3000) end,
  function() return setmetatable({}, { __index = raise, __newindex = raise, __len = raise, __pairs = raise,
                                       __tostring = raise, __name = "hostile", __call = raise, __eq = raise,
                                       __lt = raise, __concat = raise }) end,
  function() return setmetatable({}, { __index = function() return 1 end }) end,
  function()
    return setmetatable({}, { __index = function(_, key) return key end, __len = function() return 1e9 end })
  end,
  function() return setmetatable({ 1, 2 }, { __metatable = false }) end,
  function() return setmetatable({}, { __name = "" }) end,
  function()
    return setmetatable({}, { __name = 3, __len = function() return "x" end, __tostring = function() end })
  end,
}

local functions = {
  raise, print, function() end, function() return 0 / 0 end, function() return "text" end, function() return {} end,
  function(...) return ... end, function() return 1e308, 1e308 end, function() coroutine.yield(1) end,
  function(X) return X[1] end, function(X) return X * X end, function() return true end, function() error(nil) end,
  function() error({ table = true }) end,
}

local others = {
  function() return true end, function() return false end, function() return nil end,
  function() return coroutine.create(print) end, function() return coroutine.running() end,
  function() return io.stdout end,
  function()
    local file = io.tmpfile()
    file:close()
    return file
  end,
}

local function pick(list) return list[math.random(#list)] end

--- A hostile value; `objects`: functions that return objects of the library; `like`: the value that it replaces.
function hostile.value(objects, like)
  if type(like) == "number" and math.random(2) == 1 then return pick(numbers) end
  if type(like) == "string" and math.random(2) == 1 then return pick(strings) end
  local roll = math.random(12)
  if roll <= 4 then return pick(numbers) end
  if roll <= 6 then return pick(strings) end
  if roll <= 8 then return pick(tables)() end
  if roll == 9 then return pick(functions) end
  if roll == 10 then return pick(others)() end
  return pick(objects)()
end

-- ── Values that are right in form ────────────────────────────────────────────────────────────────────────────────────

local check = require "signorini.call.check"
local pages = require "signorini.pages"

local absurd = {}

--- A value of a type, right in form and absurd in content; `right`: a usual value of a type.
function hostile.absurd(type, right, depth)
  depth = depth or 1
  if depth < 5 and absurd[type.kind] and math.random(8) > 1 then return absurd[type.kind](type, right, depth + 1) end
  return right(type)
end

local function number(type, right)
  for _ = 1, 20 do
    local value = pick(numbers)
    if type.kind == "integer" and math.random(2) == 1 then value = math.random(-3, 6) end
    if check.fits(type, value) then return value end
  end
  return right(type)
end
absurd.number, absurd.integer = number, number

function absurd.text() return pick(strings) end
function absurd.data() return math.random(2) == 1 and pick(strings) or math.random(-3, 3) end
function absurd.choice(type) return pick(type.of) end
absurd["function"] = function() return pick(functions) end
function absurd.either(type, right, depth) return hostile.absurd(type[math.random(#type)], right, depth) end

function absurd.point(type)
  local point = {}
  for i = 1, math.random(type.low, type.high) do point[i] = number({ kind = "number" }) end
  return point
end

function absurd.points()
  local list = {}
  for i = 1, math.random(4) do list[i] = absurd.point{ low = 2, high = 2 } end
  return list
end

function absurd.list(type, right, depth)
  local list = {}
  for i = 1, type.size or math.max(type.least or 0, math.random(0, 3)) do
    list[i] = hostile.absurd(type.of, right, depth)
  end
  return list
end

function absurd.tuple(type, right, depth)
  local list = {}
  for i = 1, #type.of do list[i] = hostile.absurd(type.of[i], right, depth) end
  return list
end

function absurd.map(type, right, depth)
  local map = {}
  for _ = 1, math.random(2) do map[pick(strings)] = hostile.absurd(type.of, right, depth) end
  return map
end

--- Needed arguments, and a few others.
function absurd.named(type, right, depth)
  local value = {}
  for _, row in ipairs(pages.rows(type.rows)) do
    if _G.type(row) == "table" and (pages.is_needed(row) or math.random(4) == 1) then
      value[row[1]] = hostile.absurd(row[2], right, depth)
    end
  end
  return value
end

return hostile
