-- Studies and tables of CSV files as HTML.

local cells = require "signorini.study.cells"
local counted = require("signorini.call.text").counted
local html = require "signorini.output.report.html"
local lists = require "signorini.call.lists"

local map = lists.map
local most = 100 -- rows

local function cell_text(value)
  if value == nil then return "–" end
  if math.type(value) == "float" then return ("%.6g"):format(value) end
  return tostring(value)
end

--- Numbers are aligned to the right, texts to the left.
local function cell(tag, value)
  local align = tag == "td" and type(value) ~= "number" and "left" or "right"
  return ('<%s style="text-align: %s">%s</%s>'):format(tag, align, html.escape(cell_text(value)), tag)
end

local function row_of(tag, count, row)
  local texts = {}
  for j = 1, count do texts[j] = cell(tag, row[j]) end
  return "<tr>" .. table.concat(texts) .. "</tr>"
end

--- Lines of text above a table: heads (names, units) and rows.
local function page(lines, heads, rows)
  local count = #heads[1]
  local parts = lists.joined(map(lines, function(line) return html.element("div", line) end),
    { "<table><thead>" }, map(heads, function(head) return row_of("th", count, head) end), { "</thead><tbody>" },
    map({ table.unpack(rows, 1, most) }, function(row) return row_of("td", count, row) end), { "</tbody></table>" })
  if #rows > most then parts[#parts + 1] = ("<div>… %s</div>"):format(counted(#rows - most, "more row")) end
  return table.concat(parts, "\n")
end

local pages = {}

function pages.study(study)
  if #study.rows == 0 then return nil end
  local columns, units, rows = cells("study:table", study, {})
  local has_units = lists.any(units, function(unit) return unit ~= "" end)
  return page({ tostring(study):match "^[^\n]*" }, has_units and { columns, units } or { columns }, rows)
end

function pages.data(data) return page(data.comments, { data.columns }, data.rows) end

--- The HTML of a value, or nil for other values.
return function(value)
  local own = type(value) == "table" and getmetatable(value)
  local make = type(own) == "table" and pages[rawget(own, "__name")]
  return make and make(value) or nil
end
