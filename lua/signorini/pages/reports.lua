-- Pages: reports.

local chart_rows = require "signorini.pages.chart_rows"
local core = require "signorini.core"
local lists = require "signorini.call.lists"
local t = require "signorini.call.types"

local joined, merged = lists.joined, lists.merged
local picture = t.object "picture"

--- A list of figures, each alone or with a caption.
local function captioned(row, words)
  return t.worded(t.list(t.short({ row, { "caption", t.text, "text below it", optional = true } }, row)), words)
end

--- The arguments of a report, or the name of its file. `own`: rows after the first ones.
local function arguments(title, own)
  local rows = joined({
    { "file", t.text, "name of the page, which ends with .html" },
    { "title", t.text, "title of the page", otherwise = title },
    { "text", t.text, "what the reader should know, above all else; empty lines separate paragraphs", optional = true },
  }, own, {
    { "pictures", captioned({ "picture", t.either(picture, t.text), "a picture, or a file that ends with .png, .jpg, "
      .. ".svg, .gif or .webp" }, "a list of pictures, names of files or tables { picture = …, caption = … }"),
      "pictures to show", optional = true },
    { "films", captioned({ "film", t.text, "a file of up to 32 MB that ends with .mp4, which every browser plays, "
      .. ".webm or .ogv" }, "a list of names of files or tables { film = …, caption = … }"), "films to show",
      optional = true },
  })
  return { { "options", merged(t.short(rows, rows[1]), { last = true }), "" } }
end

local column = t.name(function(run) return run:columns() end, "column")
local run_chart = joined({
  { "y", t.one_or_more(column), "columns, one curve each" },
  { "x", column, "column", default = "step" },
}, chart_rows.pick(chart_rows.chart, "xlabel ylabel title log xrange yrange hlines vlines legend legend_title",
  { xlabel = "the column", ylabel = "the column, if there is one", title = "the columns" }))

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
    arguments = arguments("the names of the stages", {
      { "charts", t.list(t.worded(t.either(picture, t.named(run_chart)), "a chart or a table { y = <columns> }",
        "charts or tables { y = <columns> }")), "charts to draw",
        otherwise = "forces, displacements, contact and iterations over the steps" },
      { "field", t.either(t.only(false), t.name(core.fields)),
        "field that colors the stored states; false: states are not drawn",
        otherwise = "von_mises, if no pictures are given" },
    }),
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
