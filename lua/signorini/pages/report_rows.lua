-- Rows of reports, which those of runs, fits and optima share.

local chart_rows = require "signorini.pages.chart_rows"
local core = require "signorini.core"
local lists = require "signorini.call.lists"
local t = require "signorini.call.types"

local joined, merged = lists.joined, lists.merged
local picture = t.object "picture"

local report_rows = {}

--- A list of figures, each alone or with a caption.
local function captioned(row, words)
  return t.worded(t.list(t.short({ row, { "caption", t.text, "text below it", optional = true } }, row)), words)
end

--- The arguments of a report, or the name of its file. `own`: rows after the first ones.
function report_rows.arguments(title, own)
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

--- The arguments of a report of a run.
function report_rows.run(title)
  return report_rows.arguments(title, {
      { "charts", t.list(t.worded(t.either(picture, t.named(run_chart)), "a chart or a table { y = <columns> }",
        "charts or tables { y = <columns> }")), "charts to draw",
        otherwise = "forces, displacements, contact and iterations over the steps" },
      { "field", t.either(t.only(false), t.name(core.fields)),
        "field that colors the stored states; false: states are not drawn",
        otherwise = "von_mises, if no pictures are given" },
  })
end

return report_rows
