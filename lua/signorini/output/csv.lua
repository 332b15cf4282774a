-- Tables as CSV files: columns have names, lines that begin with # are comments.
--
-- A table in memory is { columns = {"step", "fx"}, rows = {{1, 0.5}, …}, comments = {"source: …"} }; a missing value is
-- nil in a row and an empty field in the file.
--
-- A text that spreadsheets would read as a formula, because it begins with = + - or @, gets an apostrophe before it, by
-- which they take it as text; reading removes it.

local check = require "signorini.call.check"
local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local on_behalf_of = require "signorini.call.on_behalf_of"
local lists = require "signorini.call.lists"
local no_column = require("signorini.call.text").no_column
local tables = require "signorini.output.table"

local csv = {}

-- ── Writing ──────────────────────────────────────────────────────────────────────────────────────────────────────────

local function field_value(text)
  if text == "" then return nil end
  if text == "true" or text == "false" then return text == "true" end
  return tonumber(text) or text
end

--- True for a text that spreadsheets take for a formula, perhaps after apostrophes.
local function is_formula(text) return text:find "^'*[=@\t]" or text:find "^'*[+-]." end

local function string_text(value)
  local formula = is_formula(value)
  if formula then value = "'" .. value end
  local plain = not formula and field_value(value) == value and not value:find '[",\r\n]' and not value:find "^[#%s]"
    and not value:find "%s$"
  return plain and value or '"' .. value:gsub('"', '""') .. '"'
end

--- The text of a field in row i; `texts` caches those of strings, because the same ones occur many times.
local function field_text(value, texts, i, name)
  if value == nil then return "" end
  if type(value) == "number" then
    if value ~= value or math.abs(value) == math.huge then
      core.fail(("sg.csv.write: row %d, column '%s' is %s, not a finite number. Hint: use nil for a value that "
        .. "is missing"):format(i, name, core.describe(value)))
    end
    return core.number_text(value)
  end
  if type(value) == "boolean" then return tostring(value) end
  if not texts[value] then texts[value] = string_text(value) end
  return texts[value]
end

local function column_names(data)
  local columns, seen, known = rawget(data, "columns"), {}, { { "columns" }, { "comments" }, { "rows" } }
  if not columns and not rawget(data, "rows") then
    columns = lists.filter(lists.sorted_names(data), function(name) return name ~= "comments" end)
  end
  if not columns or #columns == 0 then
    core.fail "sg.csv.write: columns is missing: it must be a list of column names"
  end
  for i, name in ipairs(columns) do
    if name == "" then check.reject("sg.csv.write", ("columns[%d]"):format(i), "a name", name) end
    if seen[name] then core.fail(("sg.csv.write: the column '%s' occurs twice"):format(name)) end
    seen[name] = true
    if not rawget(data, "rows") then known[#known + 1] = { name } end
  end
  check.keys(known, data, "sg.csv.write", "")
  return columns
end

--- A function (row, column) → value and the number of rows, for both forms of a table.
local function cells(data, columns)
  if rawget(data, "rows") then
    tables.check_rows("sg.csv.write", data.rows, columns)
    return function(i, j) return data.rows[i][j] end, #data.rows
  end
  local count
  for _, name in ipairs(columns) do
    local list = data[name]
    if not list then core.fail(("sg.csv.write: the column '%s' has no list of values"):format(name)) end
    count = count or #list
    if #list ~= count then
      core.fail(("sg.csv.write: the column '%s' has %s, the column '%s' has %d")
        :format(name, counted(#list, "value"), columns[1], count))
    end
  end
  return function(i, j) return data[columns[j]][i] end, count
end

local function file_text(data)
  local columns = column_names(data)
  local cell, count = cells(data, columns)
  local fields, texts = lists.map(columns, string_text), {}
  local lines = lists.map(rawget(data, "comments") or {}, function(comment)
    return "# " .. comment:gsub("[\r\n]+", " ")
  end)
  lines[#lines + 1] = table.concat(fields, ",")
  for i = 1, count do
    for j, name in ipairs(columns) do fields[j] = field_text(cell(i, j), texts, i, name) end
    -- A line must not be empty, because it would not be read as a row; its one missing value is written as quotes.
    lines[#lines + 1] = #columns == 1 and fields[1] == "" and '""' or table.concat(fields, ",")
  end
  return table.concat(lines, "\n") .. "\n"
end

function csv.write(file, data)
  on_behalf_of("sg.csv.write", "core.write_output", core.write_output, file, file_text(data), "csv")
end

-- ── Reading ──────────────────────────────────────────────────────────────────────────────────────────────────────────

local Data = {}
Data.__index = Data
Data.__name = "data"
core.types.data = Data

--- Position of a column; an unknown name is an error that lists the known ones.
local function position(data, name, where)
  for j, known in ipairs(data.columns) do
    if known == name then return j end
  end
  no_column(where, name, data.columns)
end

function Data:column(name)
  local j = position(self, name, "data:column")
  return lists.map(self.rows, function(row) return row[j] end)
end

function Data:by(name)
  local key, rows = position(self, name, "data:by"), {}
  for _, row in ipairs(self.rows) do
    local named = {}
    for j, column in ipairs(self.columns) do named[column] = row[j] end
    if row[key] ~= nil then rows[row[key]] = named end
  end
  return rows
end

--- The comments and the first rows as an aligned table.
function Data:__tostring()
  local most, lines = 20, lists.map(self.comments, function(comment) return "# " .. comment end)
  lines[#lines + 1] = tables.text { columns = self.columns, rows = { table.unpack(self.rows, 1, most) } }
  if #self.rows > most then lines[#lines + 1] = ("… %s"):format(counted(#self.rows - most, "more row")) end
  return table.concat(lines, "\n")
end

--- A value without the apostrophe of string_text().
local function unescaped(value)
  return type(value) == "string" and value:find "^'" and is_formula(value) and value:sub(2) or value
end

--- Reads one record from a position: its fields, their number (missing values are nil), and the next position.
local function read_record(text, at, where)
  local fields, count = {}, 0
  while true do
    count = count + 1
    if text:sub(at, at) == '"' then
      local begin = at
      repeat -- a doubled quote ends a quoted text and begins another
        at = text:match('^%b""()', at) or core.fail(where() .. "a quoted field is not closed")
      until text:sub(at, at) ~= '"'
      local inside = text:sub(begin + 1, at - 2):gsub('""', '"')
      fields[count] = inside ~= "" and unescaped(inside) or nil
    else
      local finish = text:find("[,\n]", at) or #text + 1
      fields[count] = unescaped(field_value(text:sub(at, finish - 1):match "^%s*(.-)%s*$"))
      at = finish
    end
    local delimiter = text:sub(at, at)
    at = at + 1
    if delimiter == "\n" or delimiter == "" then return fields, count, at end
    if delimiter ~= "," then core.fail(where() .. "a comma must follow a quoted field, got '" .. delimiter .. "'") end
  end
end

local function head(fields, count, where)
  local seen = {}
  for j = 1, count do
    if fields[j] == nil then core.fail(where() .. ("column %d has no name"):format(j)) end
    fields[j] = tostring(fields[j])
    if seen[fields[j]] then core.fail(where() .. ("the column '%s' occurs twice"):format(fields[j])) end
    seen[fields[j]] = true
  end
  return fields
end

function csv.read(file)
  local text = on_behalf_of("sg.csv.read", "core.read_file", core.read_file, file)
  text = text:gsub("^\xEF\xBB\xBF", ""):gsub("\r\n?", "\n")

  local data = setmetatable({ rows = {}, comments = {} }, Data)
  local at = 1
  local function where()
    local _, line = text:sub(1, at - 1):gsub("\n", "")
    return ("sg.csv.read: %s:%d: "):format(file, line + 1)
  end
  while at <= #text do
    local comment, after_comment = text:match("^#[ \t]*([^\n]*)\n?()", at)
    local after_blank = text:match("^[ \t]*\n()", at)
    if comment then
      data.comments[#data.comments + 1], at = comment, after_comment
    elseif after_blank then
      at = after_blank
    else
      local fields, count, next_at = read_record(text, at, where)
      if not data.columns then
        data.columns = head(fields, count, where)
      elseif count ~= #data.columns then
        core.fail(where() .. ("%s, but there %s %s"):format(counted(count, "field"),
          #data.columns == 1 and "is" or "are", counted(#data.columns, "column")))
      else
        data.rows[#data.rows + 1] = fields
      end
      at = next_at
    end
  end
  if not data.columns then
    core.fail(("sg.csv.read: '%s' does not contain a table: a line of column names is missing"):format(file))
  end
  return data
end

return csv
