-- Tables as CSV files: columns have names, lines that begin with # are comments.
--
-- A table in memory is { columns = {"step", "fx"}, rows = {{1, 0.5}, …}, comments = {"source: …"} }; a missing value is
-- nil in a row and an empty field in the file.

local core = require "signorini.core"
local arguments = require "signorini.arguments"
local counted = require "signorini.counted"
local in_name_of = require "signorini.in_name_of"
local format_table = require "signorini.table"
local number_text = require "signorini.number_text"

local csv = {}

-- ── Writing ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- What an unquoted field stands for.
local function field_value(text)
  if text == "" then return nil end
  if text == "true" or text == "false" then return text == "true" end
  return tonumber(text) or text
end

local function string_text(value)
  local plain = field_value(value) == value and not value:find '[",\r\n]' and not value:find "^[#%s]"
    and not value:find "%s$"
  return plain and value or '"' .. value:gsub('"', '""') .. '"'
end

local function place(i, name) return ("row %d, column '%s'"):format(i, name) end

--- The text of a field in row i; `texts` keeps those of strings, as few of them come many times.
local function field_text(value, texts, i, name)
  if value == nil then return "" end
  if type(value) == "number" then
    if value ~= value or math.abs(value) == math.huge then
      core.fail(("sg.csv.write: %s is %s, not a finite number: leave the value out (nil) where there is none")
        :format(place(i, name), core.describe(value)))
    end
    return number_text(value)
  end
  if type(value) == "boolean" then return tostring(value) end
  if type(value) ~= "string" then
    core.fail(("sg.csv.write: %s must be a number, a string, true or false, got a %s")
      :format(place(i, name), type(value)))
  end
  local text = texts[value]
  if not text then
    text = string_text(value)
    texts[value] = text
  end
  return text
end

--- The column names of a table, checked; for named arrays without `columns` all names, sorted.
local function column_names(data)
  local columns = data.columns
  if columns ~= nil or data.rows ~= nil then
    local known = { "columns", "comments", "rows" }
    if data.rows == nil and type(columns) == "table" then table.move(columns, 1, #columns, 3, known) end
    arguments.table("sg.csv.write", "its argument", data, known)
  end
  if columns == nil and data.rows == nil then
    columns = {}
    for name in pairs(data) do
      if name ~= "comments" then columns[#columns + 1] = name end
    end
    table.sort(columns)
  end
  if type(columns) ~= "table" or #columns == 0 then
    core.fail "sg.csv.write: columns is missing: it must be a list of column names"
  end
  local seen = {}
  for i, name in ipairs(columns) do
    if type(name) ~= "string" then core.fail(("sg.csv.write: columns[%d] must be a string"):format(i)) end
    if name == "" then arguments.reject("sg.csv.write", ("columns[%d]"):format(i), "a name", name) end
    if seen[name] then core.fail(("sg.csv.write: the column '%s' is there twice"):format(name)) end
    seen[name] = true
  end
  return columns
end

--- A function (row, column) → value and the number of rows, for both forms of a table.
local function cells(data, columns)
  if data.rows then
    if type(data.rows) ~= "table" then arguments.reject("sg.csv.write", "rows", "a list of rows", data.rows) end
    for i, row in ipairs(data.rows) do
      if type(row) ~= "table" then arguments.reject("sg.csv.write", ("rows[%d]"):format(i), "a list of values", row) end
      for key in pairs(row) do
        if math.type(key) ~= "integer" or key < 1 or key > #columns then
          core.fail(("sg.csv.write: rows[%d] has an entry '%s', but there %s %s"):format(i, key,
            #columns == 1 and "is" or "are", counted(#columns, "column")))
        end
      end
    end
    return function(i, j) return data.rows[i][j] end, #data.rows
  end
  local count
  for _, name in ipairs(columns) do
    local array = data[name]
    if type(array) ~= "table" then core.fail(("sg.csv.write: the column '%s' has no list of values"):format(name)) end
    count = count or #array
    if #array ~= count then
      core.fail(("sg.csv.write: the column '%s' has %s, the column '%s' has %d")
        :format(name, counted(#array, "value"), columns[1], count))
    end
  end
  return function(i, j) return data[columns[j]][i] end, count
end

local function file_text(data)
  local columns = column_names(data)
  local cell, count = cells(data, columns)
  local lines, fields, texts = {}, {}, {}
  if data.comments ~= nil and type(data.comments) ~= "table" then
    arguments.reject("sg.csv.write", "comments", "a list of texts", data.comments)
  end
  for i, comment in ipairs(data.comments or {}) do
    arguments.string("sg.csv.write", ("comments[%d]"):format(i), comment)
    lines[#lines + 1] = "# " .. comment:gsub("[\r\n]+", " ")
  end
  for j, name in ipairs(columns) do fields[j] = string_text(name) end
  lines[#lines + 1] = table.concat(fields, ",")
  for i = 1, count do
    for j, name in ipairs(columns) do fields[j] = field_text(cell(i, j), texts, i, name) end
    -- A line that would be empty is no row when read back, so its one missing value is written as quotes.
    lines[#lines + 1] = #columns == 1 and fields[1] == "" and '""' or table.concat(fields, ",")
  end
  return table.concat(lines, "\n") .. "\n"
end

core.docs["sg.csv.write"] = [[
sg.csv.write(file, { columns = {…}, rows = {{…}, …}, comments = {…} })
Writes a table, whole or not at all. Instead of rows, equally long lists may stand under the columns' names.
Values are numbers, texts, true or false. A missing one, nil, is an empty field; so is what a row lacks at its end.
An empty text reads back as nil.
Example: sg.csv.write("a.csv", { columns = {"step", "fx"}, rows = {{1, 0.2}, {2, 0.3}} })]]
function csv.write(file, data)
  if type(file) ~= "string" then
    arguments.reject("sg.csv.write", "file, the first argument,", "the name of a file", file)
  end
  if type(data) ~= "table" then core.fail "sg.csv.write: the second argument must be a table with columns and rows" end
  local plain = {} -- a contact profile refuses names that it does not hold
  for name, value in next, data do plain[name] = value end
  local text = file_text(plain)
  in_name_of("sg.csv.write", "core.write_file", core.write_file, file, text)
end

-- ── Reading ──────────────────────────────────────────────────────────────────────────────────────────────────────────

local Data = {}
Data.__index = Data
Data.__name = "data"
core.types.data = Data

--- Position of a column; an unknown name is an error that lists the known ones.
local function position(data, name)
  for j, known in ipairs(data.columns) do
    if known == name then return j end
  end
  core.fail(("a CSV table: there is no column '%s'; known: %s"):format(tostring(name),
    table.concat(data.columns, ", ")))
end

core.docs["data"] = [[
data
What sg.csv.read and sg.reference return: columns, a list of names; rows, a list of lists; comments, a list of texts.]]

core.docs["data:column"] = [[
data:column(name)
The values of a column as a list; missing ones are nil.
Example: sg.reference "ironing2d_oscillation_table7_3":column "discretisation"]]
function Data:column(name)
  local j, values = position(self, name), {}
  for i, row in ipairs(self.rows) do values[i] = row[j] end
  return values
end

core.docs["data:by"] = [[
data:by(name)
The rows by the value that they have in one column, each as a table of named values; of equal values the last row stays.
Example: sg.reference "hertz2d_dofs_table7_4":by "mesh"]]
function Data:by(name)
  local key, rows = position(self, name), {}
  for _, row in ipairs(self.rows) do
    local named = {}
    for j, column in ipairs(self.columns) do named[column] = row[j] end
    if row[key] ~= nil then rows[row[key]] = named end
  end
  return rows
end

--- The comments and the first rows as an aligned table.
function Data:__tostring()
  local most, lines = 20, {}
  for i, comment in ipairs(self.comments) do lines[i] = "# " .. comment end
  lines[#lines + 1] = format_table { columns = self.columns,
    rows = table.move(self.rows, 1, math.min(most, #self.rows), 1, {}) }
  if #self.rows > most then
    local rest = #self.rows - most
    lines[#lines + 1] = ("… %d more row%s"):format(rest, rest > 1 and "s" or "")
  end
  return table.concat(lines, "\n")
end

--- One record from a position on: its fields, their number (missing values are nil), and where the next record begins.
local function read_record(text, at, where)
  local fields, count = {}, 0
  while true do
    count = count + 1
    if text:sub(at, at) == '"' then
      local parts, begin = {}, at + 1
      while true do
        local quote = text:find('"', begin, true)
        if not quote then core.fail(where() .. "a quoted field does not end") end
        parts[#parts + 1] = text:sub(begin, quote - 1)
        at = quote + 1
        if text:sub(at, at) ~= '"' then break end
        parts[#parts + 1] = '"'
        begin = at + 1
      end
      fields[count] = table.concat(parts)
      if fields[count] == "" then fields[count] = nil end
    else
      local finish = text:find("[,\n]", at) or #text + 1
      fields[count] = field_value(text:sub(at, finish - 1):match "^%s*(.-)%s*$")
      at = finish
    end
    local delimiter = text:sub(at, at)
    at = at + 1
    if delimiter == "\n" or delimiter == "" then return fields, count, at end
    if delimiter ~= "," then core.fail(where() .. "after a quoted field comes '" .. delimiter .. "', not a comma") end
  end
end

--- The fields of the first record as column names.
local function head(fields, count, where)
  local seen = {}
  for j = 1, count do
    if fields[j] == nil then core.fail(where() .. ("column %d has no name"):format(j)) end
    fields[j] = tostring(fields[j])
    if seen[fields[j]] then core.fail(where() .. ("the column '%s' is there twice"):format(fields[j])) end
    seen[fields[j]] = true
  end
  return fields
end

core.docs["sg.csv.read"] = [[
sg.csv.read(file)
Reads a table: { columns = {…}, rows = {{…}, …}, comments = {…} }; lines that begin with # are comments.
Example: run:csv "run.csv"
         fx = sg.csv.read("run.csv"):column "grip.fx"]]
function csv.read(file)
  if type(file) ~= "string" then arguments.reject("sg.csv.read", "file", "the name of a file", file) end
  local stream, reason = io.open(file, "rb")
  if not stream then core.fail("sg.csv.read: cannot read " .. reason) end
  local text = stream:read "a"
  stream:close()
  if not text then core.fail(("sg.csv.read: '%s' is not a file that can be read"):format(file)) end
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
    core.fail(("sg.csv.read: '%s' holds no table: a line of column names is missing"):format(file))
  end
  return data
end

return csv
