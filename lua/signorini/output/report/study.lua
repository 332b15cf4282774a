-- study:report: the page of a study.

local cells = require "signorini.study.cells"
local charts = require "signorini.output.report.study_charts"
local counted = require("signorini.call.text").counted
local html = require "signorini.output.report.html"
local html_table = require "signorini.output.report.table"
local lists = require "signorini.call.lists"
local origin = require "signorini.output.report.origin"
local outcomes = require "signorini.study.outcomes"
local page = require "signorini.output.report.page"
local quantity = require "signorini.study.quantity"
local values = require "signorini.study.values"

local where = "study:report"
local most_values, most_failures = 12, 50 -- listed values of a parameter, and failed cases in full

local function failed_rows(study)
  return lists.filter(study.rows, function(row) return row.failed end)
end

local function summary(study)
  local all, failed, wall = study.cases and #study.cases or #study.rows, failed_rows(study), 0
  for _, row in ipairs(study.rows) do wall = wall + (type(row.wall) == "number" and row.wall or 0) end
  local facts = { { "Cases", tostring(all) }, { "Solved", tostring(#study.rows - #failed) },
                  { "Failed", tostring(#failed) } }
  if all > #study.rows then facts[#facts + 1] = { "Not done yet", tostring(all - #study.rows) } end
  facts[#facts + 1] = { "Sum of wall times", html.duration(wall) }
  return facts
end

local function parameters(study)
  if #study.parameters == 0 then return "" end
  local facts = lists.map(study.parameters, function(name)
    local having = lists.filter(study.rows, function(row) return row[name] ~= nil end)
    local texts = lists.unique(lists.map(having, function(row) return values.text(row[name]) end))
    local unit, more = study.units[name], #texts - most_values
    return { unit and ("%s (%s)"):format(name, unit) or name,
             table.concat(texts, ", ", 1, math.min(#texts, most_values))
               .. (more > 0 and (" and %d more"):format(more) or "") }
  end)
  return "<h3>Parameters</h3>\n" .. html.facts(facts) .. "\n"
end

local function case_table(study)
  local columns, units, rows = cells(where, study, {})
  for i, row in ipairs(rows) do row.failed = study.rows[i].failed end
  return html_table{ title = study.name, columns = columns, units = units, rows = rows }
end

local function failures(study)
  local failed = failed_rows(study)
  local items = lists.map({ table.unpack(failed, 1, most_failures) }, function(row)
    return ("%s\n%s: %s"):format(quantity.case(study, row), row.outcome or "failed", row.reason or "no reason given")
  end)
  if #failed > most_failures then items[#items + 1] = ("and %d more, see the table"):format(#failed - most_failures) end
  return #items > 0 and html.list(items) or ""
end

--- "2 of 9 cases are not done yet", or nil.
local function missing(study)
  local open = study.cases and #study.cases - #study.rows or 0
  return open > 0 and ("%d of %s are not done yet"):format(open, counted(#study.cases, "case")) or nil
end

local function warnings(study, records)
  local texts = lists.joined({ missing(study) }, origin.warnings(records))
  return #texts > 0 and html.list(texts) or ""
end

return function(study, options)
  local given, films = page.given_figures(where, options)
  local open = missing(study)
  if open then io.stderr:write(("signorini: warning: %s: %s. Hint: study:execute() first\n"):format(where, open)) end
  local counts, records = outcomes.counts(study.rows), (study.whole or study).records
  page.write(where, options, {
    title = study.name, records = records, summary = summary(study),
    subtitle = ("Study “%s”: %s%s"):format(study.name, counted(study.cases and #study.cases or #study.rows, "case"),
      #counts > 0 and ", " .. table.concat(counts, ", ") or ""),
    asked = parameters(study),
    sections = {
      { title = "Warnings", html = warnings(study, records) },
      charts.section(study, options.charts),
      charts.maps(study, options.maps),
      given, films,
      { title = "Cases", html = #study.rows > 0 and case_table(study) or html.element("p", "No case is done yet.") },
      { title = "Failed cases", html = failures(study) },
    },
  })
end
