-- Tables as aligned text.

local check = require "signorini.call.check"
local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local lists = require "signorini.call.lists"

local tables = {}

--- A cell as text: by the column's format, whole numbers unchanged, others with six digits, a dash for nil.
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

--- Raises an error if a row of a table, also of a CSV file, has more cells than there are columns.
function tables.check_rows(where, rows, columns)
  for i, row in ipairs(rows) do
    for key in next, row do
      if math.type(key) ~= "integer" or key < 1 or key > #columns then
        core.fail(("%s: rows[%d] has an entry '%s', but there %s %s"):format(where, i, tostring(key),
          #columns == 1 and "is" or "are", counted(#columns, "column")))
      end
    end
  end
end

local function check_formats(formats)
  for key, format in pairs(formats) do
    local fits, text = pcall(string.format, format, 1)
    if type(format) ~= "string" or not fits or text == format then
      check.reject("sg.table", ("formats.%s"):format(key), "a pattern of string.format for a number", format,
        "such as \"%.3g\"")
    end
  end
end

function tables.text(options)
  local columns, formats = options.columns, options.formats or {}
  check_formats(formats)
  tables.check_rows("sg.table", options.rows, columns)
  local heads = options.units and { columns, options.units } or { columns }
  local lines = lists.map(lists.joined(heads, options.rows), function() return {} end)
  for j, name in ipairs(columns) do
    local texts = lists.joined(lists.map(heads, function(head) return head[j] or "" end),
      lists.map(options.rows, function(row) return cell_text(row[j], rawget(formats, name) or rawget(formats, j)) end))
    local right = lists.any(options.rows, function(row) return type(row[j]) == "number" end)
    local width = 0
    for _, text in ipairs(texts) do width = math.max(width, utf8.len(text) or #text) end
    for i, text in ipairs(texts) do lines[i][j] = pad(text, width, right) end
  end
  return table.concat(lists.map(lines, function(line) return (table.concat(line, "  "):gsub("%s+$", "")) end), "\n")
end

return tables
