-- Pages: reports.

local report_rows = require "signorini.pages.report_rows"
local t = require "signorini.call.types"

local arguments, picture = report_rows.arguments, t.object "picture"

return {
  title = "Reports", word = "reports",
  { "study:report", [[Writes a report: one HTML page to send to a colleague, which needs no other file and no network.
It has the number of cases and failures, charts that show the values of a point, the table of all cases, which can be
sorted, filtered and downloaded as CSV, the failed cases with their reasons, the script with its arguments, and program,
machine and time of the solution.]],
    head = 'study:report "x.html" or { file, … }',
    arguments = arguments("the study's name", {
      { "charts", t.list(t.worded(t.either(picture, t.named "study:chart"), "a chart or the arguments of study:chart",
        "charts, or arguments of study:chart without file")), "charts to draw",
        otherwise = "each result over the first parameter with numbers, one curve per value of the others" },
      { "maps", t.list(t.worded(t.either(picture, t.object "convergence map", t.named "study:heatmap"),
        "a heat map, a convergence map or the arguments of study:heatmap",
        "heat maps, convergence maps, or arguments of study:heatmap without file")), "maps to draw",
        optional = true },
    }),
    more = [[
Equal studies give equal pages, except for the section on program, machine and time. The script is shown as it is when
the report is written.]],
    example = { [[study:report "study.html"]],
      [[study:report{ file = "errors.html", title = "Errors of both discretizations",
  charts = { { x = "mesh", y = "error", series = "order", log = "y" } } }]] } },
  { "run:report", [[Writes a report of a run, one HTML page like that of study:report: outcome, warnings, charts of
forces, contact and iterations, stored states, tables of stages, energies, attempts and steps. (run.failure is the
failure in words.)]],
    head = 'run:report "x.html" or { file, … }',
    arguments = report_rows.run "the names of the stages",
    example = { [[run:report "run.html"]],
      [[run:report{ file = "press.html", field = "uy", charts = { { y = {"grip.fx", "grip.fy"}, ylabel = "force" } } }]]
    }
  },
  { "map:report", [[Writes a report of a convergence map, one HTML page like that of study:report: the map of outcomes,
heat maps of the results, the table of cells, and the reports of those that failed.]],
    head = 'map:report "x.html" or { file, … }',
    arguments = arguments("the map's name", {}),
    example = [[map:report "map.html"]] },
}
