-- map:report: the page of a convergence map.

local figure = require "signorini.output.report.figure"
local html = require "signorini.output.report.html"
local html_table = require "signorini.output.report.table"
local lists = require "signorini.call.lists"
local origin = require "signorini.output.report.origin"
local page = require "signorini.output.report.page"
local pictures = require "signorini.study.convergence_map.pictures"
local values = require "signorini.study.values"

local where = "map:report"

local accounts = { "reached", "increments", "iterations", "cutbacks", "fallback_steps", "wall" }

local function cells(map)
  local results = values.result_names(map.cells)
  local rows = lists.map(map.cells, function(cell)
    local row = { cell.x, cell.y, cell.outcome, failed = cell.outcome ~= "completed" }
    for j, name in ipairs(accounts) do row[3 + j] = cell[name] end
    row[4] = cell.reached and 100 * cell.reached
    for j, name in ipairs(results) do row[3 + #accounts + j] = cell.results[name] end
    return row
  end)
  local columns = lists.joined({ map.x.name, map.y.name, "outcome" }, accounts, results)
  local units = { [4] = "%", [3 + #accounts] = "s" }
  return html_table{ title = map.name, columns = columns, units = units, rows = rows }
end

local function figures(map)
  local list = { figure.of_picture(where .. ": map1", pictures.outcomes(map, { text = "iterations", title = "" }),
    "Outcomes, with the number of iterations") }
  for _, name in ipairs(values.result_names(map.cells)) do
    list[#list + 1] = figure.of_picture(("%s: map%d"):format(where, #list + 1),
      pictures.heatmap(map, { name = name, title = "" }), name)
  end
  return list
end

local function failures(map)
  local failed = lists.filter(map.cells, function(cell) return cell.outcome ~= "completed" end)
  if #failed == 0 then return "" end
  return html.list(lists.map(failed, function(cell)
    return ("%s = %s, %s = %s\n%s: %s"):format(map.x.name, values.text(cell.x), map.y.name, values.text(cell.y),
      cell.outcome, cell.report or "no reason given")
  end))
end

return function(map, options)
  local given, films = page.given_figures(where, options)
  local converged, all = map:converged()
  local wall = 0
  for _, cell in ipairs(map.cells) do wall = wall + (cell.wall or 0) end
  local warnings = origin.warnings(map.study.records)
  page.write(where, options, {
    title = map.name, records = map.study.records,
    subtitle = ("Convergence map over %s and %s"):format(map.x.name, map.y.name),
    summary = { { "Cells", tostring(all) }, { "Converged", tostring(converged) },
                { "Not converged", tostring(#map.cells - converged) }, { "Sum of wall times", html.duration(wall) } },
    sections = {
      { title = "Warnings", html = #warnings > 0 and html.list(warnings) or "" },
      { title = "Maps", figures = #map.cells > 0 and figures(map) or {} },
      given, films,
      { title = "Cells", html = #map.cells > 0 and cells(map) or html.element("p", "No cell is done yet.") },
      { title = "Failed cells", html = failures(map) },
    },
  })
end
