-- Pages: studies and their evaluation.

local chart_rows = require "signorini.pages.chart_rows"
local cluster_rows = require "signorini.pages.cluster_rows"
local lists = require "signorini.call.lists"
local filter, joined = lists.filter, lists.joined
local t = require "signorini.call.types"

--- Parameters of callbacks.
local model_and_run = { { "model", t.object "model" }, { "run", t.object "run" } }
local x_and_y = { { "x", t.any }, { "y", t.any } }

local column_or_function = t.either(t.column, t.of_row(t.any))
local parameter = t.name(function(study) return study.parameters end)
local file = chart_rows.file

--- Rows of sg.chart and sg.heatmap, to which these functions pass them on.
local function of_chart(keys, otherwise) return chart_rows.pick(chart_rows.chart, keys, otherwise) end
local function of_heatmap(keys, otherwise) return chart_rows.pick(chart_rows.heatmap, keys, otherwise) end

local at_once = { "jobs", t.count, "cases solved in parallel, with one thread each",
                  otherwise = "the value of --jobs, or the number of processors" }
local limit = { "limit", t.positive, "time limit of a case", unit = "wall-clock seconds", otherwise = "none" }
local only_rows = { "where", t.of_row(t.any), "function of a row that returns true for the rows to use",
                    otherwise = "all" }
local columns = { "columns", t.list(t.column), "columns in this order", otherwise = "all parameters and results" }
local sort = { "sort", t.either(t.column, t.list(t.column)), "columns to sort the rows by, in increasing order",
               otherwise = "the order of the cases" }

local execution = joined({
  at_once, limit,
  { "rerun", t.either(t.flag, t.choice { "failed" }, t.of_row(t.any)),
    "finished cases to run again: all (true), those that failed, or a function of a row", default = false },
}, cluster_rows)
execution.conflict = cluster_rows.conflict

local function axis(key)
  return { key, t.named { { "name", t.text, "name of the parameter" },
                          { "values", t.list(t.either(t.number, t.text), nil, 1), "its values, each once" } },
           "parameter along " .. key }
end

local error_column = { "error", t.either(t.column, t.of_row(t.number), t.named {
  { "of", t.text, "a column, the error of which is taken in % of its value in the row of the reference" },
  { "reference", t.map(t.any), "values of parameters that only this row has, as in study:row" },
}), [[errors: a column or a function of a row, of which signs are ignored, or { of = "P", reference = { order =
"N4" } }. If the cases also return the error bar of P as ["P.error"], that of the reference tells how uncertain all
errors are]] }

local other = { "other", t.object "convergence map", "map of the same values, drawn next to this one", optional = true }
local titles = { "titles", t.list(t.text, 2), "titles of the two maps", otherwise = "their names" }

--- Selects rows: values by column (Tab completes strings), or a function of a row.
local function strings(study, column)
  local list, seen = {}, {}
  for _, row in ipairs(study.rows) do
    local text = row[column]
    if type(text) == "string" and not seen[text] then seen[text], list[#list + 1] = true, text end
  end
  return list
end
local wanted = t.either({ kind = "map", of = { kind = "any", of = strings }, names = t.column.of }, t.of_row(t.any))

local chart_arguments = joined({
  { "x", column_or_function, "column, or function of a row" },
  { "y", column_or_function, "column, or function of a row" },
  { "series", column_or_function, "column, or function of a row, with one curve per value", optional = true },
  file,
  "For all curves, as in sg.chart:",
  { "markers", t.flag, "marker at each point", default = true },
}, chart_rows.pick(chart_rows.curve, "dashed line width", {}), { "As in sg.chart:" },
  of_chart("xlabel ylabel log title legend legend_title xrange yrange xticks hlines vlines inset size",
    { xlabel = "the column and its unit", ylabel = "the column and its unit", title = "the study's name",
      legend_title = "the column of series" }))

local heatmap_arguments = joined({
  { "x", parameter, "parameter" }, { "y", parameter, "parameter" },
  { "value", column_or_function, "column, or function of a row" }, file,
  { "texts", t.flag, [[numbers in the cells; "failed" or "error" for cases without results]], default = true },
  "As in sg.heatmap:",
}, of_heatmap("xlabel ylabel title label range log colormap size",
  { xlabel = "the parameter and its unit", ylabel = "the parameter and its unit", title = "the study's name",
    label = "the column and its unit" }))

--- The rows of a picture in a report, which has no file of its own.
local function of_reports(rows) return filter(rows, function(row) return row ~= file end) end

return {
  title = "Studies", word = "studies",
  { "sg.study", [[Returns a study: a function evaluated for many cases, whose results are saved. study:execute{} runs
each case in a separate process, so variables that the function changes do not affect other cases.]],
    named = {
      { "name", t.text, "name in tables, charts and of the folder" },
      { "cases", t.list(t.any, nil, 1), [[tables of parameters, or lists of such tables, as sg.grid makes them]] },
      { "run", t.callback_of({ { "case", t.map(t.any) }, { "checkpoint", t.text } }, t.map(t.any)),
        [[function of a case, and of the name of a file for its checkpoints (model:run{ …,
checkpoint = file, resume = true }), that returns results by name: numbers, strings, true or false, and lists of these,
which tables omit. A failed case returns failed = true and a reason; this is a result, too. A result that is nan or
infinite makes the case an error]] },
      { "folder", t.text, "folder to which each finished case is written at once as a JSON file",
        otherwise = "out/<name>" },
      { "units", t.map(t.text), "units by the name of a result or parameter, for tables and axes", optional = true },
      { "sequential", t.either(t.flag, t.of_row(t.any)),
        [[true, or a function of a case that returns true, for cases with
time measurements: they run last, one at a time]], default = false },
      { "inputs", t.data, "values on which the results depend besides the parameters",
        otherwise = "everything that run refers to" } },
    more = [[
A case remains valid as long as its parameters, everything that run refers to and the program's source are unchanged.
run refers to its own text, to that of the script's functions that it calls, and to the values that these use: numbers,
tables, and the contents of bodies and models. With inputs, only the parameters and the inputs are compared. The file
for checkpoints lasts until the case is done, so that a case that was killed continues where it was; it is another one
if what the result depends on changes. Besides its results each row has wall, the seconds that run took, unless run
returned a result of that name. A case without results has failed = true, outcome ("failed", "error", "crashed", or
"time" if it exceeded the limit of study:execute) and reason. Methods of the study: study:execute, study:row,
study:where, study:with, study:table, study:chart and others, help "studies".]],
    returns = t.object "study", example = [[study = sg.study{ name = "steps", cases = sg.grid{ steps = {5, 10} },
  run = function(case)
    local run = press("N2", 1):run{ { name = "press", steps = case.steps, grip = {0, -0.1} } }
    return { force = run:column "grip.fy"[run.steps] }
  end }]] },
  { "sg.grid", [[Returns all combinations of the parameters' values, as a list of cases for sg.study. The parameters are
sorted by name, and the last one changes fastest; several tables, sg.grid({ order = … }, { mesh = … }), set the order. A
value that is a table is shown by its field `name`, or as 6×2. print shows the cases as a table.]],
    head = "sg.grid{ <parameter> = {…}, … }", repeats = true,
    arguments = { { "parameters", t.map(t.list(t.data, nil, 1), 1), "values by the name of the parameter" } },
    returns = t.list(t.any), example = [[#sg.grid{ order = {"N2", "N4"}, mesh = {1, 2, 3} }  --> 6]] },
  { "study", [[The result of sg.study; #study is the number of rows, print(study) shows how many cases are done, and the
table. Methods that select, group or add return a new study that has rows only.]],
    fields = {
      { "rows", t.list(t.any), "tables of parameters and results by name" },
      { "parameters", t.list(t.text), "their names" },
      { "results", t.list(t.text), "their names" },
      { "units", t.map(t.text), "as given" },
      { "name", t.text, "as given" },
      { "folder", t.text, "as given" },
      { "records", t.list(t.any), "of the cases; records[i].made: host, processor, versions of libraries, time" } } },
  { "study:by", "Iterates over the parts of a study with equal values in a column, in the order of the rows.",
    arguments = { { "name", t.column, "parameter or result" } },
    returns = t.callback_of({}, t.or_nil(t.any), t.or_nil(t.object "study")),
    example = [[for order, part in study:by "order" do print(order, #part) end]] },
  { "study:chart", [[Draws the rows as curves, one per value of series, by increasing x. Failed rows and rows without x,
y or series have no point. Strings and tables along x are in the order of first occurrence; a parameter with few integer
values has ticks at these. Several rows of one curve at the same value of a parameter along x are an error unless line =
false: select rows with study:where, or give series.]],
    named = chart_arguments, rows = of_reports(chart_arguments),
    returns = t.object "picture",
    example = [[study:chart{ x = "mesh", y = "error", series = "order", file = "error.png" }]] },
  { "study:cancel", [[Ends the jobs of Slurm and on hosts that solve cases of this study, and returns their number.
Finished cases remain.]],
    returns = t.integer(0), example = "study:cancel()" },
  { "study:column", "Returns a parameter or result as a list over the rows, nan where it is missing.",
    arguments = { { "name", t.column, "parameter or result" } },
    returns = t.list(t.any), example = [[study:column "force"]] },
  { "study:csv", "Writes the table of study:table to a CSV file, units in comments, long texts in full.",
    arguments = { { "file", t.text, "name of the file" }, { "options", t.options { columns, sort }, "" } },
    example = [[study:csv "press.csv"]] },
  { "study:execute", [[Runs the cases that are missing in the study's folder or whose inputs have changed, prints how
many are reused and how many are to be solved, and returns the study. Each finished case is written to disk at once: if
the program is stopped by Ctrl-C or killed, the same call continues with the missing cases. A failed case is a result
and is saved. A case that ended with an error, or whose process crashed, is reported on standard error at the end, runs
again at the next call, and makes the exit status of the program 1, unless the script ends with os.exit.]],
    may_be_empty = true,
    named = execution,
    more = [[
Two processes cannot execute the same study at the same time. study:read() reads the finished cases without running
any. With on = "slurm", or signorini study.lua --on slurm, the missing cases become tasks of a job array, each of which
runs the script up to this call and solves its cases; the results are the same files. With on = { "ssh:host1",
"ssh:host2" }, or --on ssh:host1,ssh:host2, a process on each host does so until no case is left. The folder, the
script and the program must have the same names on all machines. Cases that a job is still going to solve are not solved
by other calls. study:watch() shows their state, study:cancel() ends the jobs.]],
    returns = t.object "study", example = [[study:execute{ jobs = 2, rerun = "failed" }]] },
  { "study:heatmap", [[Draws a number over two parameters x and y, in the order of their values in the cases. More than
one case in a cell is an error; select cases with study:where.]],
    named = heatmap_arguments, rows = of_reports(heatmap_arguments),
    returns = t.object "picture",
    example = [[study:heatmap{ x = "order", y = "mesh", value = "wall", log = true, file = "wall.png" }]] },
  { "study:median", [[Returns the study without one parameter: rows that differ only in it are replaced by one, with the
medians of their numbers, each over the rows that have it. Use it for results that vary between repetitions, such as
times: cases = sg.grid{ …, round = {1, 2, 3} }.]],
    arguments = { { "name", parameter, "parameter" } },
    returns = t.object "study", example = [[study:median "mesh"]] },
  { "study:read", [[Reads the finished cases from the study's folder, without running any, and returns the study. It may
be called while another process executes the study; inputs are not compared.]],
    returns = t.object "study", example = "print(study:read())" },
  { "study:row", [[Returns the row with these values, a table of parameters and results by name; it is an error if no
row or several rows match.]],
    head = [[study:row{ <column> = value, … }]],
    arguments = { { "wanted", wanted, "as in study:where" } },
    returns = t.map(t.any), example = [[study:row{ order = "N2", mesh = 1 }.force]] },
  { "study:table", [[Returns the text of an aligned table, with units. For cases without results, the columns outcome
(failed, error, crashed or time) and reason are added. Texts of more than 60 characters are shortened; study.rows and
study:csv contain them in full.]], may_be_empty = true,
    named = { columns, sort, { "formats", t.map(t.text), "patterns of string.format by the name of a column",
                               default = { wall = "%.3g" } } },
    returns = t.text, example = [[print(study:table{ columns = {"order", "mesh", "error"}, sort = "error" })]] },
  { "study:watch", [[Shows how many cases are waiting, begun by a task or a host, done and failed, until all jobs of the
study have ended or Ctrl-C is pressed, and returns the study with the cases done so far.]],
    returns = t.object "study", example = "print(study:watch())" },
  { "study:where", [[Returns the part of a study with these values, as a study that has rows only. A value that no case
has is an error, except with a function.]],
    head = [[study:where{ <column> = value, … } or study:where(function(row) … end)]],
    arguments = { { "wanted", wanted,
                    "values, or lists of values, by column, or a function of a row that returns true" } },
    returns = t.object "study", example = [[study:where{ order = "N2", mesh = {1, 2} }]] },
  { "study:with", "Returns the study with an additional result, computed from each row.",
    arguments = { { "name", t.text, "name of the result" },
                  { "make", t.of_row(t.any), "function of a row that returns the value, nil where it is unknown" },
                  { "unit", t.text, "unit of the result", optional = true } },
    returns = t.object "study",
    example = [[study:with("deviation", function(row) return math.abs(row.force / 0.08 - 1) end)]] },
  { "sg.work_precision", [[Draws a work-precision diagram, error over time: one curve per series through its cases by
increasing time, one marker per kind of case, both axes logarithmic, the Pareto front as gray steps. Returns the
comparison; print shows time ratios, the front and omitted cases.]],
    arguments = {
      { "study", t.object "study", "" },
      { "options", t.options(joined({
        error_column,
        { "time", column_or_function, "times, a column or a function of a row", default = "wall" },
        { "series", column_or_function, "column or function of a row, with one curve per value",
          otherwise = "\"order\", or the first parameter" },
        { "marker", t.either(t.only(false), t.column, t.of_row(t.any)),
          "the same for markers; false: one marker for all", otherwise = "all other parameters together" },
        only_rows,
        { "at", t.list(t.positive, nil, 1), "errors at which times are compared",
          otherwise = "for each pair of curves the smallest, the middle and the largest one that both reach" },
        { "file", t.text, "name that ends with .png, .svg or .pdf", optional = true },
        { "files", t.list(t.text), "several such names", optional = true, excludes = { "file" } },
      }, of_chart("title xlabel ylabel size",
        { title = "the study's name", xlabel = "time and its unit", ylabel = "error and its unit" }))), "" } },
    more = [[
Failed cases, and those without time or error or with a zero in them, are omitted and listed with the reason. Times at
equal error are interpolated on the lines between cases; if a curve reaches an error more than once, the smallest time
is used. There is no extrapolation below a curve's smallest error or above that of its cheapest case.]],
    returns = t.object "comparison",
    example = [[print(sg.work_precision(study, { error = "error", at = {0.1}, file = "speed.png" }))]] },
  { "comparison", "The result of sg.work_precision.",
    fields = {
      { "ratios", t.list(t.any), [[{ a, b, from, to, at = {…}, ratio = {…} } for each pair: at the error at[i], a takes
ratio[i] times b's time, nil beyond from … to; why: the reason if no error is reached by both]] },
      { "pareto", t.list(t.any), "rows of the front" },
      { "left_out", t.list(t.any), "{ row, why } of omitted cases" } } },
  { "comparison:front", [[Returns the text of a table of the Pareto front of time and error: the cases that no other
case beats in both.]],
    returns = t.text, example = "print(comparison:front())" },
  { "comparison:table", "Returns the text of a table of cost ratios: A's time divided by B's at equal errors.",
    returns = t.text, example = "print(comparison:table())" },
  { "sg.cheapest", [[Returns the cheapest row of a study whose error is within a tolerance, and the second cheapest; if
there is none, nil and a text about the closest case. Failed rows and rows without error or cost are ignored.]],
    arguments = {
      { "study", t.object "study", "" },
      { "options", t.options {
        error_column, { "at_most", t.positive, "tolerance of the error" },
        { "cost", column_or_function, "cost, a column or a function of a row", default = "wall" }, only_rows }, "" } },
    returns = { t.or_nil(t.map(t.any)), t.or_nil(t.either(t.map(t.any), t.text)) },
    example = [[best, next_best = sg.cheapest(study, { error = "error", at_most = 0.1 })]] },
  { "sg.recommend", [[Returns the cheapest discretization, and if wanted contact formulation and thickness degree, that
meet a tolerance: with each candidate the path is solved on finer meshes, with other penalties, steps and points as by
model:run(path, { tolerance = … }), until its error bars hold or another candidate is cheaper. Prints all levels.]],
    named = {
      { "scene", t.callback_of({ { "q", t.map(t.any) } }, t.object "model", t.any, t.or_nil(t.any)),
        [[function of q = { order, formulation, thickness_degree, mesh } that returns a model, its stages, and options
of model:run. If it reads q.mesh, it is called again for finer and coarser meshes, with so many times as many elements
per direction (1 at first); otherwise these are made from the tables of sg.body and sg.model]] },
      { "tolerance", t.worded(t.one_or_more(t.text), 'a text such as "1 % of grip.fx", or a list of these'),
        "largest error bars of results, in all steps, in parts of their largest values" },
      { "orders", t.list(t.text, nil, 1), "order labels, cheapest first", default = { "N2", "N2-N2.2" } },
      { "formulations", t.list(t.data, nil, 1), [[contact formulations to compare: tables of keys that
scene gives to its contacts, such as { { penalty = 100 }, { method = "mortar", enforcement = "multipliers" } }]],
        otherwise = "that of the scene" },
      { "thickness_degrees", t.list(t.count, nil, 1), "values of thickness_degree of bodies to compare",
        otherwise = "that of the scene" },
      { "limit", t.positive, "time after which no further level is started", unit = "seconds", otherwise = "none" } },
    more = [[
The result has order, formulation (its keys), thickness_degree, settings (as run.settings), model and run of the
candidate of least work within the tolerance (nil if there is none), tries, spent (s) and report. Work is unknowns times
iterations, which is reproducible. Results of your own are measured by the option measure that scene returns.]],
    returns = t.record("order?", t.text, "formulation? settings? model? run? best?", t.any, "thickness_degree?",
      t.number, "tries", t.list(t.any), "spent", t.number, "report", t.text),
    example = [[sg.recommend{ scene = function(q) return press(q.order, 1) end, tolerance = "20 % of grip.fy" }]] },
  { "sg.convergence_map", [[Returns a convergence map: where the solve converges over two parameters, and where and why
it fails. It is a study with a case for each pair of values: a separate process calls scene and path. Errors, crashes
and the exit status are handled as in study:execute; Ctrl-C ends it with the cells done so far.]],
    named = {
      { "name", t.text, "name of the map", default = "convergence map" }, axis "x", axis "y",
      { "scene", t.callback_of(x_and_y, t.object "model"), "function of x and y that returns a model" },
      { "path", t.callback_of(joined({ { "model", t.object "model" } }, x_and_y), t.any, t.or_nil(t.any)),
        "function of model, x and y that returns stages and options, as model:run takes them" },
      { "results", t.callback_of(joined(model_and_run, x_and_y), t.map(t.number)),
        [[function of model, run, x and y that returns numbers by name, called for cells that
reach the end of their path; numbers that are not finite are omitted]], optional = true },
      at_once, limit,
      { "file", t.text, [[CSV file to which each finished cell is written at once; the folder next to it, map.cells for
map.csv, stores the cells like that of a study, so that a later call reuses them. Remove the file to solve all cells
again]], otherwise = "not stored" } },
    more = [[
A cell: x, y, outcome, reached (fraction of the path, 0 to 1), steps, increments, iterations, cutbacks, fallback_steps,
wall (s), report and place of a failure, results. outcome is run.reason ("completed" for converged cells), or "error"
(in one of the functions), "crashed", "time". map:picture draws the outcomes, map:heatmap a number; help "map".]],
    returns = t.object "convergence map",
    example = [[-- press(order, mesh), a function of your own, returns a model and its stages
map = sg.convergence_map{ x = { name = "order", values = {"N2", "N4"} },
  y = { name = "steps", values = {5, 10} }, scene = function(order) return (press(order, 1)) end,
  path = function(model, order, steps) return { { steps = steps, grip = {0, -0.1} } } end }]] },
  { "map", "The result of sg.convergence_map; print(map) shows how many cells converged, and the table.",
    fields = { { "cells", t.list(t.any), [[{ x, y, outcome, reached, steps, increments, iterations, cutbacks,
fallback_steps, wall, report, place, results } each]] } } },
  { "map:cell", "Returns the cell at given values of the two parameters; nil if it was not solved.",
    arguments = { { "x", t.either(t.number, t.text), "value of the first parameter" },
                  { "y", t.either(t.number, t.text), "value of the second parameter" } },
    returns = t.or_nil(t.map(t.any)), example = [[map:cell("N2", 4).outcome]] },
  { "map:compare", [[Compares another map of the same parameters with this one and returns { recovered, lost, both,
neither }: recovered and lost are lists of the {x, y} that converged only in the other map or only in this one, both and
neither are numbers of cells.]],
    arguments = { { "other", t.object "convergence map", "" } },
    returns = t.record("recovered lost", t.list(t.any), "both neither", t.integer(0)),
    example = "#map:compare(map).recovered" },
  { "map:csv", "Writes all cells to a CSV file, with the reports of failures.",
    arguments = { { "file", t.text, "name of the file" } },
    example = [[map:csv "map.csv"]] },
  { "map:heatmap", "Draws a number of the cells, of the run or a result, as a heat map.",
    named = joined({ { "name", t.text, "such as \"iterations\"" }, file, other, titles },
      of_heatmap("label title range log colormap size",
        { label = "the name", title = "the map's name and the label" })),
    returns = t.object "picture", example = [[map:heatmap{ name = "iterations", file = "iterations.png" }]] },
  { "map:converged", [[Returns the number of cells that converged to the end of their path, and the number of
all cells.]],
    returns = { t.integer(0), t.integer(0) }, example = "converged, cells = map:converged()" },
  { "map:picture", "Draws the outcomes as a heat map.",
    named = joined({ file, { "text", t.text, "number shown in the cells: of the run, such as \"reached\", or a result",
                             default = "iterations" }, other, titles },
      of_heatmap("title size", { title = "the map's name" })),
    returns = t.object "picture", example = [[map:picture{ file = "map.png", text = "reached" }]] },
  { "map:table", "Returns the text of a table with one row per cell.",
    returns = t.text, example = "print(map:table())" },
}
