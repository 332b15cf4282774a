-- A table of a report, which the page's script sorts, filters and writes as CSV.

local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local html = require "signorini.output.report.html"
local lists = require "signorini.call.lists"

local most_upright = 10 -- columns that fit on a page in portrait format
local longest = 32 -- characters of a text that is not wrapped

--- A cell: numbers with six digits, all digits for sorting and CSV; a dash for nil. `numeric`: of a column with
--- numbers.
local function cell(value, numeric)
  if value == nil then return ('<td class="missing%s">–</td>'):format(numeric and " number" or "") end
  if type(value) ~= "number" then
    local text = tostring(value)
    return html.element("td", text, (#text > longest or text:find "\n") and "lines" or nil)
  end
  local all = core.number_text(value)
  local short = math.type(value) == "integer" and all or ("%.6g"):format(value)
  return short == all and ('<td class="number">%s</td>'):format(short)
    or ('<td class="number" data-value="%s">%s</td>'):format(all, short)
end

local function head(name, unit, numeric)
  local of = unit and unit ~= "" and ' <span class="unit">' .. html.escape(unit) .. "</span>" or ""
  return ('<th scope="col"%s data-name="%s" data-unit="%s"><button type="button">%s%s</button></th>'):format(
    numeric and ' class="number"' or "", html.escape(name), html.escape(unit or ""), html.escape(name), of)
end

--- The table of { title, columns, units, rows }; a row has its cells by number, and `failed`.
return function(content)
  local columns = content.columns
  local numeric = lists.map(columns, function(_, j)
    return lists.any(content.rows, function(row) return type(row[j]) == "number" end)
  end)
  local heads = lists.map(columns, function(name, j)
    return head(name, content.units and content.units[j], numeric[j])
  end)
  local rows = lists.map(content.rows, function(row)
    local cells = {}
    for j = 1, #columns do cells[j] = cell(row[j], numeric[j]) end
    return ("<tr%s>%s</tr>"):format(row.failed and ' class="failed"' or "", table.concat(cells))
  end)
  return ([[<div class="table%s" style="--columns: %d" data-title="%s">
<div class="tools" hidden>
<label>Filter <input type="search" placeholder="words, or %s=…" autocomplete="off" spellcheck="false"></label>
<button type="button" class="download">Download CSV</button>
<span class="count" role="status">%s</span>
</div>
<div class="frame" tabindex="0" role="region" aria-label="%s">
<table>
<thead><tr>%s</tr></thead>
<tbody>
%s
</tbody>
</table>
</div>
</div>]]):format(#columns > most_upright and " wide" or "", #columns, html.escape(content.title),
    html.escape(columns[1]), counted(#rows, "row"), html.escape(content.title), table.concat(heads),
    table.concat(rows, "\n"))
end
