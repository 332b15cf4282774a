-- Tables as aligned text.

local core = require "signorini.core"
local arguments = require "signorini.arguments"
local counted = require "signorini.counted"

local shows = { number = true, string = true, boolean = true }

--- A cell as text: by the column's format, whole numbers as such, others with six digits, nothing as a dash.
local function cell_text(value, format)
  if value == nil then return "–" end
  if type(value) ~= "number" then return tostring(value) end
  if format then return format:format(value) end
  return math.type(value) == "integer" and ("%d"):format(value) or ("%.6g"):format(value)
end

local function pad(text, width, right)
  local blanks = (" "):rep(width - (utf8.len(text) or #text))
  return right and blanks .. text or text .. blanks
end

--- A row must hold what a cell can show, and no more than there are columns.
local function check_row(i, row, columns)
  if type(row) ~= "table" then arguments.reject("sg.table", ("rows[%d]"):format(i), "a list of values", row) end
  for key, value in pairs(row) do
    if math.type(key) ~= "integer" or key < 1 or key > #columns then
      core.fail(("sg.table: rows[%d] has an entry '%s', but there %s %s"):format(i, tostring(key),
        #columns == 1 and "is" or "are", counted(#columns, "column")))
    end
    if not shows[type(value)] then
      arguments.reject("sg.table", ("rows[%d][%d]"):format(i, key), "a number, a text, true or false", value,
        "write it as a text")
    end
  end
end

--- A list or a table by name of texts, or nothing.
local function check_texts(name, texts)
  if texts == nil then return end
  if type(texts) ~= "table" then arguments.reject("sg.table", name, "a list of texts", texts) end
  for key, text in pairs(texts) do arguments.string("sg.table", ("%s.%s"):format(name, tostring(key)), text) end
end

--- Formats must be patterns for one number.
local function check_formats(formats)
  check_texts("formats", formats)
  for key, format in pairs(formats) do
    local fits, text = pcall(string.format, format, 1)
    if not fits or text == format then
      arguments.reject("sg.table", ("formats.%s"):format(tostring(key)), "a pattern of string.format for a number",
        format, "such as \"%.3g\"")
    end
  end
end

core.docs["sg.table"] = [[
sg.table{ columns = {…}, rows = {{…}, …}, units = {…}, formats = {…} }
The text of an aligned table, numbers to the right; formats are patterns of string.format by position or column name;
a missing value is a dash, units make a second line of heads. Values are numbers, texts, true or false.
Example: print(sg.table{ columns = {"x", "y"}, rows = {{1, 0.5}, {2, 0.25}}, units = {"mm", "N"} })]]
return function(options)
  arguments.table("sg.table", "its argument", options, { "columns", "rows", "units", "formats" })
  local columns, formats = options.columns, options.formats or {}
  if type(columns) ~= "table" then arguments.reject("sg.table", "columns", "a list of names", columns) end
  if type(options.rows) ~= "table" then arguments.reject("sg.table", "rows", "a list of rows", options.rows) end
  check_texts("columns", columns)
  check_texts("units", options.units)
  check_formats(formats)
  for i, row in ipairs(options.rows) do check_row(i, row, columns) end

  local heads = options.units and { columns, options.units } or { columns }
  local lines = {}
  for i = 1, #heads + #options.rows do lines[i] = {} end
  for j, name in ipairs(columns) do
    local texts, width, right = {}, 0, false
    for i, head in ipairs(heads) do texts[i] = tostring(head[j] or "") end
    for i, row in ipairs(options.rows) do
      texts[#heads + i] = cell_text(row[j], formats[name] or formats[j])
      right = right or type(row[j]) == "number"
    end
    for _, text in ipairs(texts) do width = math.max(width, utf8.len(text) or #text) end
    for i, text in ipairs(texts) do lines[i][j] = pad(text, width, right) end
  end
  for i, line in ipairs(lines) do lines[i] = table.concat(line, "  "):gsub("%s+$", "") end
  return table.concat(lines, "\n")
end
