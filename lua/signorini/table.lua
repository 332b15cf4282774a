-- Tables as aligned text.

local check_rows = require "signorini.table_rows"
local check = require "signorini.check"

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

--- Formats must be patterns for one number.
local function check_formats(formats)
  for key, format in pairs(formats) do
    local fits, text = pcall(string.format, format, 1)
    if not fits or text == format then
      check.reject("sg.table", ("formats.%s"):format(key), "a pattern of string.format for a number", format,
        "such as \"%.3g\"")
    end
  end
end

return function(options)
  local columns, formats = options.columns, options.formats or {}
  check_formats(formats)
  check_rows("sg.table", options.rows, columns)
  local heads = options.units and { columns, options.units } or { columns }
  local lines = {}
  for i = 1, #heads + #options.rows do lines[i] = {} end
  for j, name in ipairs(columns) do
    local texts, width, right = {}, 0, false
    for i, head in ipairs(heads) do texts[i] = head[j] or "" end
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
