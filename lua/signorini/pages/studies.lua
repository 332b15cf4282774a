-- Pages: studies, and what is read from them.

local chart_rows = require "signorini.pages.chart_rows"
local joined = require("signorini.lists").joined
local t = require "signorini.types"

local column_or_function = t.either(t.column, t.callback)
local parameter = t.name(function(study) return study.parameters end)
local file = { "file", t.text, "name that ends with .png, .svg or .pdf" }

--- Rows of sg.chart and sg.heatmap, to which these functions pass them on.
local function of_chart(keys, otherwise) return chart_rows.pick(chart_rows.chart, keys, otherwise) end
local function of_heatmap(keys, otherwise) return chart_rows.pick(chart_rows.heatmap, keys, otherwise) end

local at_once = { "jobs", t.count, "cases that run side by side, with one thread each",
                  otherwise = "what --jobs says, otherwise the number of processors" }
local limit = { "limit", t.positive, "time after which a case is given up", unit = "wall-clock seconds",
                otherwise = "none" }
local only_rows = { "where", t.callback, "function of a row that returns true for the rows that count",
                    otherwise = "all" }
local columns = { "columns", t.list(t.column), "columns in this order", otherwise = "all parameters and figures" }
local sort = { "sort", t.either(t.column, t.list(t.column)), "columns to sort the rows by, in rising order",
               otherwise = "the order of the cases" }

--- Rows of a parameter of a stability map.
local function axis(key)
  return { key, t.named { { "name", t.text, "name of the parameter" },
                          { "values", t.list(t.either(t.number, t.text), nil, 1), "each once" } },
           "parameter along " .. key }
end

local error_column = { "error", column_or_function, "errors, a column or a function of a row; signs do not count" }

local beside = { "beside", t.object "stability map", "map of the same values, drawn next to this one", optional = true }
local titles = { "titles", t.list(t.text, 2), "titles of the two maps", otherwise = "their names" }

--- What chooses rows: values by column, of which Tab offers those that are strings, or a function of a row.
local function strings(study, column)
  local list, seen = {}, {}
  for _, row in ipairs(study.rows) do
    local text = row[column]
    if type(text) == "string" and not seen[text] then seen[text], list[#list + 1] = true, text end
  end
  return list
end
local filter = t.either({ kind = "map", of = { kind = "any", of = strings }, names = t.column.of }, t.callback)

return {
  title = "Studies",
  word = "studies",
  { "sg.study", [[Returns a study: a function that is solved for many cases, whose results are kept. study:execute{}
solves them, each case in a process of its own, so that what the function changes is lost with the process.]],
    named = {
      { "name", t.text, "shown in tables and charts; names the folder" },
      { "cases", t.list(t.any, nil, 1), [[tables of parameters, or lists of such tables; sg.grid makes lists, and
several may stand side by side]] },
      { "run", t.callback, [[function of a case that returns figures by name: numbers, strings, true or false, and lists
of these, which tables leave out. A case that did not come out returns failed = true and a reason: that is a result,
too. A figure that is nan or infinite makes the case an error]] },
      { "folder", t.text, "folder where each finished case is written at once as a JSON file",
        otherwise = "out/<name>" },
      { "units", t.map(t.text), "units by the name of a figure or parameter, for tables and axes", optional = true },
      { "alone", t.either(t.flag, t.callback), [[true, or a function of a case that returns true, for cases that are
timed: they run last and one by one, with nothing else running]], default = false },
      { "inputs", t.data, "what the results depend on besides the parameters", otherwise = "what run refers to" } },
    more = [[
A case counts as done as long as its parameters, what run refers to and the program's version stay the same. What run
refers to is its own text, that of the script's functions that it calls, and the values that these use: numbers, tables,
and all that bodies and models hold. With inputs only the parameters and the inputs count.
Besides its figures each row has wall, the seconds that run took, unless it returned a figure of that name. A case that
did not come out has failed = true, outcome ("failed", "error", "crashed", or "time" beyond a limit) and reason.]],
    example = [[study = sg.study{ name = "steps", cases = sg.grid{ steps = {5, 10} },
  run = function(case)
    local run = press("N2", 1):run{ { name = "press", steps = case.steps, grip = {0, -0.1} } }
    return { force = run:column "grip.fy"[run.steps] }
  end }]] },
  { "sg.grid", [[Returns all combinations of the parameters' values, as a list of cases for sg.study. The parameters are
sorted by name, and the last one changes fastest; several tables, sg.grid({ order = … }, { mesh = … }), put them in this
order instead. A value that is a table shows by its field `name`, or as 6×2. print shows the cases as a table.]],
    head = "sg.grid{ <parameter> = {…}, … }", repeats = true,
    arguments = { { "parameters", t.map(t.list(t.data, nil, 1), 1), "values by the name of the parameter" } },
    example = [[#sg.grid{ order = {"N2", "N4"}, mesh = {1, 2, 3} }  --> 6]] },
  { "study", [[What sg.study returns; #study is the number of rows, print(study) shows how many cases are done, and the
table. Methods that choose, group or add return a study of their own that has rows only.]],
    fields = {
      { "rows", t.list(t.any), "tables of parameters and figures by name" },
      { "parameters", t.list(t.text), "their names" },
      { "figures", t.list(t.text), "their names" },
      { "units", t.map(t.text), "as given" },
      { "name", t.text, "as given" },
      { "folder", t.text, "as given" },
      { "records", t.list(t.any), "of the cases; records[i].made: host, processor, versions of libraries, time" } } },
  { "study:by", "Iterates over the parts of a study that share a value, in the order of the rows.",
    arguments = { { "name", t.column, "parameter or figure" } },
    example = [[for order, part in study:by "order" do print(order, #part) end]] },
  { "study:chart", [[Draws the rows as curves, one per value of series, by rising x. Rows that failed or lack x, y or
series have no point. Strings and tables along x stand in the order in which they first appear; a parameter with few
whole values has its ticks there. Where a parameter along x has several rows of one curve at a place, that is an error
unless line = false: choose with study:where, or give series.]],
    named = joined({
      { "x", column_or_function, "column, or function of a row" },
      { "y", column_or_function, "column, or function of a row" },
      { "series", column_or_function, "column, or function of a row, that tells curves apart", optional = true },
      file,
      "Of all curves, as in sg.chart:",
      { "markers", t.flag, "marker at each point", default = true },
    }, chart_rows.pick(chart_rows.curve, "dashed line width", {}), { "As in sg.chart:" },
      of_chart("xlabel ylabel log title legend legend_title xrange yrange xticks hlines vlines inset size",
        { xlabel = "the column and its unit", ylabel = "the column and its unit", title = "the study's name",
          legend_title = "the column of series" })),
    example = [[study:chart{ x = "mesh", y = "error", series = "order", file = "error.png" }]] },
  { "study:column", "Returns a parameter or figure as a list over the rows, nan where it is missing.",
    arguments = { { "name", t.column, "parameter or figure" } },
    example = [[study:column "force"]] },
  { "study:csv", "Writes the table of study:table to a CSV file, units in comments, long texts in full.",
    arguments = { { "file", t.text, "name of the file" }, { "options", t.options { columns, sort }, "" } },
    example = [[study:csv "press.csv"]] },
  { "study:execute", [[Runs the cases that are missing in the study's folder, or whose inputs have changed, prints how
many are taken from there and how many are to solve, and returns the study. Each finished case is on the disk at once:
when the program is stopped by Ctrl-C or killed, the same call goes on with what is missing. A case that fails is a
result and stays. One that ended by an error, or whose process died, is reported on standard error at the end, runs
again at the next call, and makes the exit status of the program 1, unless the script ends with os.exit.]],
    may_be_empty = true,
    named = { at_once, limit,
              { "again", t.either(t.flag, t.choice { "failed" }, t.callback),
                "cases that run again in any case: all (true), those that failed, or a function of a row",
                default = false } },
    more = [[
Two processes cannot execute the same study at a time. study:read() takes what there is without running anything.]],
    example = [[study:execute{ jobs = 2, again = "failed" }]] },
  { "study:heatmap", [[Draws a number over two parameters x and y, in the order of their values in the cases. More than
one case in a cell is an error that names what study:where has to choose.]],
    named = joined({
      { "x", parameter, "parameter" }, { "y", parameter, "parameter" },
      { "value", column_or_function, "column, or function of a row" }, file,
      { "texts", t.flag, [[numbers in the cells, "failed" or "error" where a case did not come out]], default = true },
      "As in sg.heatmap:",
    }, of_heatmap("xlabel ylabel title label range log colormap size",
      { xlabel = "the parameter and its unit", ylabel = "the parameter and its unit", title = "the study's name",
        label = "the column and its unit" })),
    example = [[study:heatmap{ x = "order", y = "mesh", value = "wall", log = true, file = "wall.png" }]] },
  { "study:median", [[Returns the study without one parameter: of rows that differ in nothing else one is left, with the
medians of their numbers, each over the rows that have it. It is for figures that come out differently each time, above
all times: cases = sg.grid{ …, round = {1, 2, 3} }.]],
    arguments = { { "name", parameter, "parameter" } },
    example = [[study:median "mesh"]] },
  { "study:read", [[Reads what the study's folder holds of its cases, without running any, and returns the study. It may
be called while another process executes the study; changed inputs are not looked for.]],
    example = "print(study:read())" },
  { "study:row", [[Returns the one row with these values, a table of parameters and figures by name; none or several are
an error.]],
    head = [[study:row{ <column> = value, … }]],
    arguments = { { "wanted", filter, "as in study:where" } },
    example = [[study:row{ order = "N2", mesh = 1 }.force]] },
  { "study:table", [[Returns the text of an aligned table, with units. Where a case did not come out, outcome says
failed, error, crashed or time, and reason why. Texts of more than 60 characters end with …; study.rows and study:csv
hold them in full.]], may_be_empty = true,
    named = { columns, sort, { "formats", t.map(t.text), "patterns of string.format by the name of a column",
                               default = { wall = "%.3g" } } },
    example = [[print(study:table{ columns = {"order", "mesh", "error"}, sort = "error" })]] },
  { "study:where", [[Returns the part of a study with these values, as a study that has rows only. A value that no case
has is an error; a function may ask for any.]],
    head = [[study:where{ <column> = value, … } or study:where(function(row) … end)]],
    arguments = { { "wanted", filter,
                    "values, or lists of values, by column, or a function of a row that returns true" } },
    example = [[study:where{ order = "N2", mesh = {1, 2} }]] },
  { "study:with", "Returns the study with one more figure, made from each row.",
    arguments = { { "name", t.text, "name of the figure" },
                  { "make", t.callback, "function of a row that returns the value, nil where it is not known" },
                  { "unit", t.text, "unit of the figure", optional = true } },
    example = [[study:with("deviation", function(row) return math.abs(row.force / 0.08 - 1) end)]] },
  { "sg.work_precision", [[Compares error and time: one curve per series through its cases by rising time, one marker
per kind of case, both axes logarithmic, the Pareto front as gray steps. Returns the comparison; print shows time
ratios, the front and what was left out.]],
    arguments = {
      { "study", t.object "study", "" },
      { "options", t.options(joined({
        error_column,
        { "time", column_or_function, "times, a column or a function of a row", default = "wall" },
        { "series", column_or_function, "what has a curve of its own",
          otherwise = "\"order\", or the first parameter" },
        { "marker", t.either(t.only(false), t.column, t.callback), "what has a marker of its own; false: nothing",
          otherwise = "all other parameters together" },
        only_rows,
        { "at", t.list(t.positive, nil, 1), "errors at which times are compared",
          otherwise = "the least, the middle and the largest one that both curves reach" },
        { "file", t.text, "name that ends with .png, .svg or .pdf", optional = true },
        { "files", t.list(t.text), "several such names", optional = true },
      }, of_chart("title xlabel ylabel size",
        { title = "the study's name", xlabel = "time and its unit", ylabel = "error and its unit" }))), "" } },
    more = [[
Cases that failed, and those without time or error or with a zero of them, are left out and listed with the reason.
Times at equal error are interpolated on the lines between cases; where a curve comes down to an error more than once,
the least time counts. Nothing is extrapolated: not below a curve's least error, and not above that of its cheapest
case.]],
    example = [[print(sg.work_precision(study, { error = "error", at = {0.1}, file = "speed.png" }))]] },
  { "comparison", "What sg.work_precision returns.",
    fields = {
      { "ratios", t.list(t.any), [[{ a, b, from, to, at = {…}, ratio = {…} } for each pair: at the error at[i] a takes
ratio[i] of b's time, nil beyond from … to; without errors that both reach, why]] },
      { "pareto", t.list(t.any), "rows of the front" },
      { "left_out", t.list(t.any), "{ row, why } of cases that are not compared" } } },
  { "comparison:front", [[Returns the text of a table of the cases that no other one beats: the Pareto front of time and
error.]],
    example = "print(comparison:front())" },
  { "comparison:table", "Returns the text of a table: what part of B's time A takes at equal errors.",
    example = "print(comparison:table())" },
  { "sg.cheapest", [[Returns the cheapest row of a study whose error is within a tolerance, and the runner-up; nil and a
text about the nearest case when there is none. Rows that failed, or lack error or cost, do not count.]],
    arguments = {
      { "study", t.object "study", "" },
      { "options", t.options {
        error_column, { "at_most", t.positive, "largest error that is allowed" },
        { "cost", column_or_function, "cost, a column or a function of a row", default = "wall" }, only_rows }, "" } },
    example = [[best, next_best = sg.cheapest(study, { error = "error", at_most = 0.1 })]] },
  { "sg.recommend", [[Returns the least model that meets a tolerance: solves labels and meshes from coarse to fine,
estimates the error of each from the next level, and stops as soon as one is estimated to be within the tolerance.
Prints what it tried and how long that took.]],
    named = {
      { "scene", t.callback, "function of label and mesh that returns a model, and what model:run takes" },
      { "error", t.either(t.text, t.callback), [[what is to be accurate: a column of the run such as
"ground.max_pressure" (its last value counts), or a function of model and run that returns a number, or a list of
numbers at places that do not change with the mesh]] },
      { "at_most", { kind = "number", above = 0, below = 1, cure = "write 0.02 for 2 %" }, "relative error" },
      { "labels", t.list(t.text, nil, 1), "labels from the plainest to the richest", default = { "N2", "N2-N2.2" } },
      { "meshes", t.list(t.data, nil, 1), [[from coarse to fine, each about half as wide as the one before, in
whatever way scene understands them]], default = { 1, 2, 4, 8, 16, 32 } },
      { "limit", t.positive, "time after which no further level is begun", unit = "seconds", otherwise = "none" } },
    more = [[
The result has label, mesh, error (the estimate), wall (s) and unknowns of the case of least work that is enough (nil
where none is), tries, spent (s) and report. Work is unknowns times iterations, the same each time. With d the relative
distance of the richest label's figures on two levels and r the share of the error that a level leaves (1/2; from three
levels on as observed, if it is more) the finer one is about d r/(1 - r) off, and coarser cases by their distance from
it more. The error is that of the discretization: what penalty, steps or the scene itself leave, no mesh can show.
Labels that take about the work of another one and have twice its error are not tried again.]],
    example = [[sg.recommend{ scene = press, error = "grip.fy", at_most = 0.1, meshes = {1, 2, 4} }]] },
  { "sg.stability_map", [[Returns a map of where over two parameters the solve converges, and where and why it fails. It
is a study with a case for each pair of values: a process of its own calls scene and path. Errors, crashes and the exit
status are those of study:execute; Ctrl-C ends it with the cells that are done.]],
    named = {
      { "name", t.text, "name of the map", default = "stability map" }, axis "x", axis "y",
      { "scene", t.callback, "function of x and y that returns a model" },
      { "path", t.callback, "function of model, x and y that returns stages and options, as model:run takes them" },
      { "figures", t.callback, [[function of model, run, x and y that returns numbers by name, of cells that reach the
end of their path; those that are not finite are left out]], optional = true },
      at_once, limit,
      { "file", t.text, [[CSV file that shows every finished cell at once; the folder next to it, map.cells for map.csv,
keeps the cells as that of a study does, so that a later call takes up what is there. Remove the file to solve all cells
again]], otherwise = "nothing is kept" } },
    more = [[
A cell: x, y, outcome, reached (part of the path, 0 to 1), steps, increments, iterations, cutbacks, rescues, wall (s),
report and place of a failure, figures. Outcomes are those of run.reason, with "completed" for cells that converged, and
"error" (in one of the functions), "crashed", "time".]],
    example = [[map = sg.stability_map{ x = { name = "order", values = {"N2", "N4"} },
  y = { name = "steps", values = {5, 10} }, scene = function(order) return (press(order, 1)) end,
  path = function(model, order, steps) return { { steps = steps, grip = {0, -0.1} } } end }]] },
  { "map", "What sg.stability_map returns; print(map) shows how many cells converged, and the table.",
    fields = { { "cells", t.list(t.any), [[{ x, y, outcome, reached, steps, increments, iterations, cutbacks, rescues,
wall, report, place, figures } each]] } } },
  { "map:cell", "Returns the cell at two of the parameters' values; nil when it was not solved.",
    arguments = { { "x", t.either(t.number, t.text), "value of the one parameter" },
                  { "y", t.either(t.number, t.text), "value of the other" } },
    example = [[map:cell("N2", 4).outcome]] },
  { "map:compare", [[Returns what another map of the same parameters holds compared with this one: { gained, lost, both,
neither }. gained and lost are lists of {x, y} that converged in the other one or in this one only, both and neither
numbers of cells.]],
    arguments = { { "other", t.object "stability map", "" } },
    example = "#map:compare(map).gained" },
  { "map:csv", "Writes all cells to a CSV file, with the reports of the failures.",
    arguments = { { "file", t.text, "name of the file" } },
    example = [[map:csv "map.csv"]] },
  { "map:figure", "Draws one number of the cells, of the run or a figure, as a heat map.",
    named = joined({ { "name", t.text, "such as \"iterations\"" }, file, beside, titles },
      of_heatmap("label title range log colormap size",
        { label = "the name", title = "the map's name and the label" })),
    example = [[map:figure{ name = "iterations", file = "iterations.png" }]] },
  { "map:held", "Returns how many cells converged to the end of their path, and how many there are.",
    example = "held, cells = map:held()" },
  { "map:picture", "Draws the outcomes as a heat map.",
    named = joined({ file, { "text", t.text, "number in the cells, of the run such as \"reached\" or a figure",
                             default = "iterations" }, beside, titles },
      of_heatmap("title size", { title = "the map's name" })),
    example = [[map:picture{ file = "map.png", text = "reached" }]] },
  { "map:table", "Returns the text of a table with one row per cell.",
    example = "print(map:table())" },
}
