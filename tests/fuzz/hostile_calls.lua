-- Calls every public function with right arguments of which some are replaced by hostile ones (hostile.lua), and checks
-- how the calls end: with results without nan, or with an error at the line of the call that names the function.
-- A crash or a hang is seen by tests/fuzz/run, which starts this script. Arguments: the first and the last seed, a file
-- that tells the seed of the present call, and the name of a function, if only that is to be called.

local first, last, progress, only = tonumber(arg[1]), tonumber(arg[2]), arg[3], arg[4]

io.stdout:setvbuf "line"
local core = require "signorini.core"
package.path = ("%s;%s/tests/lua/?.lua;%s/tests/fuzz/?.lua"):format(package.path, core.home, core.home)
package.loaded.check = { folder = function() return "objects" end } -- that of the tests runs commands
require("signorini").mkdir "objects"
core.quiet = true
local calls = require "calls"
local hostile = require "hostile"
local names = require "signorini.prompt.help.names"
local pages = require "signorini.pages"

--- Functions whose calls take long, or whose results are files and processes: called less often.
local function is_slow(name)
  return name:find "^sg%.scenes" or name:find "picture" or name:find "film" or name:find "convergence_map"
    or name:find "^sg%.study" or name:find "^study:" or name:find "show" or name:find "^map:" or name:find "report"
    or name:find "vtu" or name:find "chart" or name:find "heatmap" or name:find "work_precision"
    or name:find "recommend" or name:find "cheapest" or name:find "^comparison" or name:find "pvd"
end

--- Functions that wait for others: processes that do not exist, or keys.
local waits = { ["study:watch"] = true }

local right, slow = {}, {}
for _, call in ipairs(calls.right()) do
  local name = call.page.name
  if not waits[name] and (not only or name == only) then
    local list = is_slow(name) and slow or right
    list[#list + 1] = call
  end
end
if #right == 0 then right = slow end

-- ── Arguments ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Tables without a metatable are copied; others are objects.
local function copied(value)
  if type(value) ~= "table" or getmetatable(value) then return value end
  local copy = {}
  for key, entry in next, value do copy[key] = copied(entry) end
  return copy
end

--- Adds a few arguments that may be left out, right ones.
local function add_optional(page, arguments, owner)
  local rows = page.named and pages.rows(page.named)
  if not rows or #rows == 0 or type(arguments[1]) ~= "table" then return end
  for _ = 1, math.random(0, 3) do
    local row = rows[math.random(#rows)]
    if type(row) == "table" and arguments[1][row[1]] == nil then
      local ok, value = pcall(function()
        return calls.value(calls.type_of(row, owner, arguments[1], arguments[1]))
      end)
      if ok then arguments[1][row[1]] = value end
    end
  end
end

--- All places { table, key, path } of nested tables, as deep as arguments are, in the order of their paths.
local function places_of(value, list, path, depth)
  for key, entry in next, value do
    local place = ("%s/%s"):format(path, type(key) == "table" and "table" or tostring(key))
    list[#list + 1] = { value, key, place }
    if depth < 5 and type(entry) == "table" and not getmetatable(entry) then
      places_of(entry, list, place, depth + 1)
    end
  end
  table.sort(list, function(a, b) return a[3] < b[3] end)
  return list
end

local objects = {}
for i, call in ipairs(calls.right()) do
  objects[i] = function() return copied(call.arguments[math.random(math.max(1, calls.count(call.arguments)))]) end
end
local kinds = { "patch", "body", "model", "run", "study", "material", "face", "snapshot", "picture", "obstacle" }
for _, name in ipairs(kinds) do
  objects[#objects + 1] = function() return calls.value{ kind = "object", name = name } end
end

--- Replaces, removes, adds or exchanges entries.
local function spoil(arguments, page)
  for _ = 1, math.random(4) == 1 and 2 or 1 do
    local places = places_of(arguments, {}, "", 1)
    local roll = math.random(10)
    if #places == 0 or roll == 1 then
      arguments[math.random(calls.count(arguments) + 1)] = hostile.value(objects)
    elseif roll == 2 then
      local place = places[math.random(#places)]
      place[1][place[2]] = nil
    elseif roll == 3 then
      local one, other = places[math.random(#places)], places[math.random(#places)]
      one[1][one[2]], other[1][other[2]] = other[1][other[2]], one[1][one[2]]
    elseif roll <= 5 and page.named and type(arguments[1]) == "table" and not getmetatable(arguments[1]) then
      local rows = pages.rows(page.named)
      local row = #rows > 0 and rows[math.random(#rows)]
      if type(row) == "table" then arguments[1][row[1]] = hostile.value(objects) end
    else
      local place = places[math.random(#places)]
      place[1][place[2]] = hostile.value(objects, place[1][place[2]])
    end
  end
end

--- Replaces one or two arguments by others that are right in form.
local function exaggerate(arguments, page, owner)
  local rows = pages.rows(page.named or page.arguments or {})
  local given = page.named and arguments[1] or arguments
  if #rows == 0 or type(given) ~= "table" or getmetatable(given) then return end
  for _ = 1, math.random(3) do
    local i = math.random(#rows)
    if type(rows[i]) == "table" then
      local ok, type = pcall(calls.type_of, rows[i], owner, given, given)
      if ok then given[page.named and rows[i][1] or i] = hostile.absurd(type, calls.value) end
    end
  end
end

-- ── Checks ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The path to a nan in the results, or nil.
local function nan_in(value, path, seen, depth)
  if value ~= value then return path end
  if type(value) ~= "table" or seen[value] or depth > 6 then return nil end
  seen[value] = true
  for key, entry in next, value do
    local found = nan_in(entry, ("%s[%s]"):format(path, tostring(key)), seen, depth + 1)
    if found then return found end
  end
end

local line = debug.getinfo(1, "l").currentline + 2
local function run(f, arguments)
  return table.pack(pcall(function() return f(table.unpack(arguments, 1, arguments.n)) end))
end

--- Ends calls that ask for too much, such as a run of a million steps, after so many instructions of Lua.
local function limited(f, arguments)
  local most = 300000
  debug.sethook(function() error(hostile.raised, 0) end, "", most)
  local result = run(f, arguments)
  debug.sethook()
  return result
end

local here = ("%s:%d: "):format(debug.getinfo(1, "S").short_src:match "[^/]*$", line)

--- Functions of numbers alone, which are those of Lua: the logarithm of -1 is nan.
local is_formula = {}
for _, page in ipairs(require "signorini.pages.formulas") do is_formula[page[1]] = true end

--- What is wrong with the end of a call, or nil. `clean`: its arguments have no nan.
local function fault(page, result, clean)
  if result[1] then
    local where = clean and not is_formula[page.name] and nan_in(result, "result", {}, 0)
    return where and "nan in " .. where
  end
  local message = result[2]
  if type(message) == "table" and message.table or message == nil then return nil end -- raised by an argument
  if page.name == "sg.arguments" and type(message) == "table" then return nil end -- the end of a script
  if type(message) ~= "string" then return "the error is not a string but " .. type(message) end
  -- Errors of functions that the caller has given pass through.
  if message:find(hostile.raised, 1, true) or message:find "hostile.lua:" or message:find "attempt to yield" then
    return nil
  end
  if #message > 5000 then return ("a message of %d bytes"):format(#message) end
  if message:find "[%z\1-\8\11-\31\127]" then return "a message with a control character" end
  if not message:find(here, 1, true) then return "not at the line of the call: " .. message end
  local rest = message:sub(message:find(here, 1, true) + #here) -- a function, or one that it calls
  if not rest:find "^%l[%w_.]*[.:][%w_]+" and not rest:find "^on_%l+: " then
    return "does not name a function: " .. message
  end
end

-- ── The calls ────────────────────────────────────────────────────────────────────────────────────────────────────────

local function note(seed, name)
  local file <close> = assert(io.open(progress, "w"))
  file:write(("%d %s\n"):format(seed, name))
end

local ended, failed = 0, 0
for seed = first, last do
  math.randomseed(seed)
  local list = #slow > 0 and math.random(12) == 1 and slow or right
  local call = list[math.random(#list)]
  local page, arguments = call.page, copied(call.arguments)
  local owner = calls.owner_of(page)
  add_optional(page, arguments, owner)
  if math.random(3) == 1 then spoil(arguments, page) else exaggerate(arguments, page, owner) end
  local clean = not nan_in(arguments, "", {}, 0)
  arguments.n = calls.count(arguments)
  if owner then arguments = table.move(arguments, 1, arguments.n, 2, { owner, n = arguments.n + 1 }) end
  note(seed, page.name)
  local result = limited(names.value(page.name), arguments)
  if result[1] then ended = ended + 1 else failed = failed + 1 end
  local found = fault(page, result, clean)
  if found then print(("FINDING %d %s: %s"):format(seed, page.name, found)) end
  if not result[1] and only and first == last then print(result[2]) end
end
note(last, "done")
print(("calls %d to %d: %d returned, %d ended with an error"):format(first, last, ended, failed))
