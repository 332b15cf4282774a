-- Wrong calls of every public function: from valid ones (valid_calls.lua) one argument each is given another type, a
-- value out of its range, nan or infinity, a misspelt key, or is left out. Each must be an error at the line of the
-- call that names the argument: no crash, and nothing that passes in silence. They are a few thousand; with the word
-- `trace` behind the script's name each is told before it runs.

local sg = require "signorini"
local check = require "check"
local core = require "signorini.core"
local names = require "signorini.help.names"
local subjects = require "signorini.help.subjects"
local valid_calls = require "valid_calls"

local folder = check.folder()
local rows = valid_calls(folder)

local function words(text)
  local set = {}
  for word in (text or ""):gmatch "%S+" do set[#set + 1], set[word] = word, true end
  return set
end

-- What a number must be, and which texts are free, by the name of the argument.
local positive = words("size width height inner outer radius elements E penalty r0 steps growth tolerance at_most "
  .. "depth every loops limit penetration")
local whole = words("elements degree degrees dir times steps iterations threads every loops jobs n step")
local free_text = words("title label xlabel ylabel text file name folder path unit units comments values words choices "
  .. "rows cases inputs x y xticks hlines vlines texts")

-- ── Wrong values ─────────────────────────────────────────────────────────────────────────────────────────────────────

local function wrong_numbers(name)
  local wrong = { true, "x", 0 / 0, 1 / 0, function() end }
  if positive[name] then wrong[#wrong + 1], wrong[#wrong + 2] = -1, 0 end
  if whole[name] then wrong[#wrong + 1] = 1.5 end
  return wrong
end

local function wrong_values(value, name)
  local kind = type(value)
  if kind == "number" then return wrong_numbers(name) end
  if kind == "string" then
    local wrong = { 3, true, function() end }
    if not free_text[name] then wrong[#wrong + 1] = "nonsense" end
    return wrong
  end
  if kind == "boolean" then return { 3, "yes", function() end } end
  if kind == "function" then return { 3, true, {} } end
  return { 3, "x", true, function() end }
end

-- ── Wrong calls ──────────────────────────────────────────────────────────────────────────────────────────────────────

local function is_plain(value) return type(value) == "table" and getmetatable(value) == nil end

--- Arguments with another value at the end of a path of keys, the tables on the way copied.
local function replaced(arguments, path, value, depth)
  depth = depth or 1
  local copy = {}
  for key, entry in pairs(arguments) do copy[key] = entry end
  if depth == #path then
    copy[path[depth]] = value else copy[path[depth]] = replaced(arguments[path[depth]], path, value, depth + 1)
  end
  return copy
end

local function joined(path, key)
  local longer = table.move(path, 1, #path, 1, {})
  longer[#longer + 1] = key
  return longer
end

local function place(call)
  local keys = {}
  for i, key in ipairs(call.path) do keys[i] = tostring(key) end
  return table.concat(keys, ".")
end

--- Whether the row says that such a change leaves the call right.
local function is_right(call)
  for _, pattern in ipairs(call.row.right or {}) do
    if ("%s: %s"):format(place(call), call.what):find("^" .. pattern) then return true end
  end
  return false
end

local function sorted_keys(entries)
  local keys = {}
  for key in pairs(entries) do keys[#keys + 1] = key end
  table.sort(keys, function(a, b)
    if math.type(a) == math.type(b) then return a < b end
    return math.type(a) == "integer"
  end)
  return keys
end

--- Adds { row, arguments, name (that the message must hold), what } for everything in a table of arguments.
local function add_wrong(calls, row, inside, path, name, is_free)
  local needs, free = words(row.needs), words(row.free)
  local function add(longer, value, named, what)
    calls[#calls + 1] = { row = row, path = longer, value = value, name = named, what = what }
    if is_right(calls[#calls]) then calls[#calls] = nil end
  end
  for _, key in ipairs(sorted_keys(inside)) do
    -- In lists the first and the last entry stand for all.
    if math.type(key) == "integer" and #path > 0 and key > 1 and key < #inside then goto continue end
    local value, longer = inside[key], joined(path, key)
    local own = type(key) == "string" and key or name
    if #path == 0 then own = assert(words(row.names or row[1])[key], row[1]) end
    for _, wrong in ipairs(wrong_values(value, own)) do
      add(longer, wrong, own, ("%s instead of %s"):format(core.describe(wrong), core.describe(value)))
    end
    if type(key) == "string" and not is_free then
      calls[#calls + 1] = { row = row, path = longer, misspelt = true, name = key .. "q", what = "a misspelt key" }
      if is_right(calls[#calls]) then calls[#calls] = nil end
    end
    if #path == 1 and needs[key] then add(longer, nil, key, "a missing argument") end
    if is_plain(value) then
      add_wrong(calls, row, value, longer, own, type(key) == "string" and free[key] or #path == 0 and row.free_first)
    end
    ::continue::
  end
end

local function wrong_arguments(call)
  if not call.misspelt then return replaced(call.row[2], call.path, call.value) end
  local value = call.row[2]
  for _, key in ipairs(call.path) do value = value[key] end
  local path = table.move(call.path, 1, #call.path, 1, {})
  path[#path] = call.name
  return replaced(replaced(call.row[2], call.path, nil), path, value)
end

local function title(call) return ("%s, argument %s: %s"):format(call.row[1], place(call), call.what) end

local line = debug.getinfo(1, "l").currentline + 2
local function run(row, arguments)
  return pcall(function() return table.pack(names.value(row[1])(table.unpack(arguments, 1, #row[2]))) end)
end

--- What is wrong with how a wrong call ends, or nil.
local function fault(call)
  if call.row.before then call.row.before(call.row[2]) end
  local arguments = wrong_arguments(call)
  local ok, message = run(call.row, arguments)
  if ok then return "passes in silence" end
  message = tostring(message)
  if not message:find(("wrong_calls_test.lua:%d: "):format(line), 1, true) then
    return "not at the line of the call: " .. message
  end
  local called = call.row.called and call.row.called[call.name] or call.name
  if not message:find(call.name, 1, true) and not message:find(called, 1, true) then
    return ("does not name %s: %s"):format(call.name, message)
  end
end

-- ── The test ─────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("the calls that the wrong ones are made from are right, and none is missing", function()
  local seen, errors = {}, {}
  for _, row in ipairs(rows) do
    seen[row[1]] = true
    if row.before then row.before(row[2]) end
    local ok, message = run(row, row[2])
    if not ok then errors[#errors + 1] = row[1] .. ": " .. tostring(message) end
  end
  for name, page in pairs(core.docs) do
    local takes = page:match "^[%w_.:]+[%({]%s*[^%s%)]" or page:match '^[%w_.:]+ "'
    if takes and name ~= "help" and subjects.is_public(name) and not seen[name] then
      errors[#errors + 1] = name .. " is missing"
    end
  end
  if #errors > 0 then error(table.concat(errors, "\n")) end
end)

check.case("wrong calls are errors at their line that name the argument", function()
  local calls = {}
  for _, row in ipairs(rows) do add_wrong(calls, row, row[2], {}, row[1], true) end
  local faults = {}
  for _, call in ipairs(calls) do
    if arg[1] == "trace" then io.stderr:write(title(call), "\n") end
    local found = fault(call)
    if found then faults[#faults + 1] = ("%s: %s"):format(title(call), found) end
  end
  check.equal(#calls > 4000, true)
  if #faults > 0 then error(("%d faults\n%s"):format(#faults, table.concat(faults, "\n"))) end
end)

check.case("functions take no more arguments than their pages show", function()
  local checked, faults = 0, {}
  for _, row in ipairs(rows) do
    local value = names.value(row[1])
    if debug.getinfo(value, "S").what == "C" and row[1] ~= "sg.grid" then -- takes any number of tables
      if row.before then row.before(row[2]) end
      local arguments = table.move(row[2], 1, #row[2], 1, {})
      for i = 1, 2 do arguments[#row[2] + i] = true end -- the first may be in the place of one that was left out
      local ok, message = pcall(function() return table.pack(value(table.unpack(arguments))) end)
      if ok or not message:find(row[1] .. ": too many arguments: it is called as ", 1, true) then
        faults[#faults + 1] = row[1] .. ": " .. tostring(message)
      end
      checked = checked + 1
    end
  end
  check.equal(checked > 60, true)
  check.equal(faults, {})
end)

check.done()
