-- How the results of searches are shown: a table, a summary and warnings, as text or above the page of the run.

local format_table = require("signorini.output.table").text
local html = require "signorini.output.report.html"
local html_table = require "signorini.output.report.table"
local lists = require "signorini.call.lists"
local on_behalf_of = require "signorini.call.on_behalf_of"
local run_report = require "signorini.output.report.run"

local shown = {}

--- The text of print. `content`: columns, rows, formats of a table.
function shown.text(content, summary, warnings)
  return table.concat(lists.joined({ format_table(content), summary }, warnings), "\n")
end

--- Writes the page of a run with the table above it, for the method `where`; `title`: of that section.
function shown.report(where, run, options, title, content, summary, warnings)
  local table_text = html_table { title = title:lower(), columns = content.columns, rows = content.rows }
  local section = { title = title, html = table_text .. html.list(lists.joined({ summary }, warnings)) }
  on_behalf_of(where, "run:report", run_report, run, options, { section })
end

return shown
