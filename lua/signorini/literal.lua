-- Plain data as text and back, for checkpoints and for what jobs in processes of their own hand over: numbers bit by
-- bit, strings, true, false, and tables of these. The text looks like Lua, yet it is read, never run.

local literal = {}

-- ── Writing ──────────────────────────────────────────────────────────────────────────────────────────────────────────

local function number_text(value)
  if math.type(value) == "integer" then return ("%d"):format(value) end
  if value ~= value then return "nan" end
  if math.abs(value) == math.huge then return value > 0 and "inf" or "-inf" end
  return ("%a"):format(value)
end

local function string_text(value)
  return '"' .. value:gsub('[%c"\\]', function(c) return ("\\%03d"):format(c:byte()) end) .. '"'
end

local function sorted_names(value)
  local names = {}
  for key in pairs(value) do
    if type(key) == "string" then
      names[#names + 1] = key
    elseif math.type(key) ~= "integer" or key < 1 or key > #value then
      error(("the key %s is neither a name nor part of a list"):format(tostring(key)))
    end
  end
  table.sort(names)
  return names
end

--- The text of a value. An error for what is no plain data.
function literal.write(value)
  local kind = type(value)
  if kind == "number" then return number_text(value) end
  if kind == "string" then return string_text(value) end
  if kind == "boolean" then return tostring(value) end
  if kind ~= "table" then error(("a %s cannot be written as text"):format(kind)) end
  local parts = {}
  for i = 1, #value do parts[i] = literal.write(value[i]) end
  for _, name in ipairs(sorted_names(value)) do
    parts[#parts + 1] = ("[%s]=%s"):format(string_text(name), literal.write(value[name]))
  end
  return literal.list(parts)
end

--- The text of a list from the texts of its entries.
function literal.list(texts) return "{" .. table.concat(texts, ",") .. "}" end

-- ── Reading ──────────────────────────────────────────────────────────────────────────────────────────────────────────

local words = { ["true"] = true, ["false"] = false, nan = 0 / 0, inf = math.huge, ["-inf"] = -math.huge }

local function fail(at, what) error(("the text is damaged at character %d: %s was expected"):format(at, what), 0) end

local function read_string(text, at)
  local inside, after = text:match('^"([^"%c]*)"()', at)
  if not inside then fail(at, "a string") end
  return inside:gsub("\\(%d%d%d)", function(code) return string.char(tonumber(code)) end), after
end

local read_value

local function read_table(text, at)
  local value = {}
  at = at + 1
  while text:sub(at, at) ~= "}" do
    local key = #value + 1
    if text:sub(at, at) == "[" then
      key, at = read_string(text, at + 1)
      if text:sub(at, at + 1) ~= "]=" then fail(at, "']='") end
      at = at + 2
    end
    value[key], at = read_value(text, at)
    local mark = text:sub(at, at)
    if mark == "," then at = at + 1 elseif mark ~= "}" then fail(at, "',' or '}'") end
  end
  return value, at + 1
end

function read_value(text, at)
  local first = text:sub(at, at)
  if first == "{" then return read_table(text, at) end
  if first == '"' then return read_string(text, at) end
  local word, after = text:match("^([%w.+-]+)()", at)
  if not word then fail(at, "a value") end
  if words[word] ~= nil then return words[word], after end
  return tonumber(word) or fail(at, "a number"), after
end

--- The value of a text that literal.write has made. An error for any other text.
function literal.read(text)
  local value, after = read_value(text, 1)
  if after <= #text then fail(after, "the end") end
  return value
end

return literal
