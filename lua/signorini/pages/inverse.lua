-- Pages: values of parameters from data, and for least results.

local chart_rows = require "signorini.pages.chart_rows"
local lists = require "signorini.call.lists"
local report_rows = require "signorini.pages.report_rows"
local t = require "signorini.call.types"

local scene = { "scene", t.callback_of({ { "q", t.map(t.number) } }, t.object "model", t.any, t.or_nil(t.any)),
  "function of the parameters that returns a model, its stages, and options of model:run, as for sg.gradients" }
local start = { "start", t.map(t.number, 1), "values of the parameters to begin with, by name" }
local pair = t.tuple({ { kind = "number", gaps = true }, { kind = "number", gaps = true } }, 2)
local bounds = { "bounds", t.map(t.worded(pair, "a list {low, high}", "lists {low, high}")),
  "limits of parameters by name, also infinite ones; equal ones fix a parameter", otherwise = "none" }
local scale = { "scale", t.map(t.positive), "typical sizes of parameters by name, needed where a start is 0",
  otherwise = "the values" }
local measure = { "measure", t.callback_of({ { "model", t.object "model" } }, t.map(t.number)),
  "function as the option of model:run, whose results become columns", otherwise = "that which scene returns" }
local runs = { "runs", t.count, "most runs with derivatives", default = 40 }
local checkpoint = { "checkpoint", t.text, "JSON file for the best values so far, written after each move",
  otherwise = "none" }
local resume = { "resume", t.flag, "whether to go on from that file, if it exists", default = false }

local data = t.named {
  { "x", t.text, "column of the run that is the abscissa, such as a motion", default = "step" },
  { "y", t.text, "column of the run that was measured" },
  { "points", t.list(t.worded(t.tuple({ t.number, t.number }, 2), "a pair {x, y}", "pairs {x, y}"), nil, 1),
    "the data", optional = true },
  { "file", t.text, "CSV file with the data", optional = true },
  { "columns", t.list(t.text, 2), "its columns of x and y", otherwise = "those named as x and y, or the only two" },
  { "stage", t.text, "stage to compare with", otherwise = "the whole run" },
  { "sigma", t.either(t.positive, t.list(t.positive, nil, 1), t.text),
    "standard deviation of the points: of all, of each, or the name of its column in the file",
    otherwise = "equal ones, estimated from the scatter" },
}

local reason = { "reason", t.text, [["converged", "stalled" (where derivatives do not describe the results: at kinks),
"runs", "interrupted" or, of an optimum, "infeasible" (limits are exceeded)]] }
local tries = { "tries", t.list(t.any), [[{ values, merit, outcome, taken, failed } of all runs with derivatives;
failed: why, if it did]] }
local gradients = { "gradients", t.object "gradients", "derivatives there" }
local run = { "run", t.object "run", "the run at these values" }
local warnings = { "warnings", t.list(t.text), "sentences about what is doubtful" }

return {
  title = "Fits and optima", word = "calibration", also = "inverse",
  { "sg.fit", [[Finds the values of parameters with which a scene describes measured data, by least squares with the
derivatives of sg.gradients, and tells how well the data determine them: 95 % intervals, correlations, and parameters
about which the data say nothing. Each move counts only by the run at its end.]],
    named = { scene, start, bounds,
      { "data", t.list(t.worded(data, "a table { x, y, points or file }", "tables { x, y, points or file }"), nil, 1),
        [[measured curves. The run is interpolated between its steps, in each stage from the end of the one before; x
must rise or fall throughout]] },
      scale, measure,
      { "errors", t.flag, [[whether the error bars of the results, model:run{ errors = true }, count as well: points are
weighed by both, and intervals contain the error of the solution]], default = false },
      { "check", t.flag, "whether runs at the ends of the intervals check that the linear model holds there",
        default = true },
      runs, checkpoint, resume },
    more = [[
A parameter that begins above 0 and has no bounds, or bounds above 0, moves by factors and stays above 0; others move by
parts of half of their range, or of their scale. The intervals are those of the linear model at the values found, with
the scatter of the data around the run and Student's distribution, so that sigma matters for the weights alone. Several
sets need their sigma. scene may read the parameters in start alone: constants that are known are fixed by equal bounds.
Ctrl-C at the prompt returns the best values so far; a script ends, and goes on from its checkpoint.]],
    returns = t.object "fit", example = [[
fit = sg.fit{ scene = press_to, start = { depth = 0.1 },
  data = { { y = "grip.fy", points = { {2, -0.01}, {4, -0.02} } } } }
print(fit)]] },
  { "fit", "The result of sg.fit. print shows values, intervals and warnings.",
    fields = {
      { "at", t.map(t.number), "values of the parameters" },
      { "intervals", t.map(t.list(t.number)), "95 % intervals {from, to} by name, of parameters that are determined" },
      { "correlation", t.map(t.map(t.number)), "of parameters, by both names" },
      { "of_solution", t.map(t.number), [[with errors = true: the part of the half intervals, of ln q or in sizes,
that comes from error bars]] },
      { "undetermined", t.list(t.text), [[parameters that the data do not tell within a factor of e, or within their
scale; the other intervals hold while these change by no more than that]] },
      { "scatter", t.number, [[standard deviation of the differences of data and run, over sigma: the square root of
their sum of squares per datum in excess of the parameters]] },
      { "points", t.number, "number of data" }, run, gradients, tries, reason, warnings } },
  { "fit:data", "Returns a set of data with the values of the run, as a table for sg.csv.write.",
    arguments = { { "set", t.count, "number of the set", default = 1 } }, returns = t.table(),
    example = [[sg.csv.write("fit.csv", fit:data(1))]] },
  { "fit:chart", "Draws a set of data and the run.",
    arguments = { { "options", t.options(lists.joined({ { "set", t.count, "number of the set", default = 1 } },
      chart_rows.pick(chart_rows.chart, "xlabel ylabel title log xrange yrange legend size file",
        { xlabel = "the column x", ylabel = "the column y", title = "Fit of y" }))), "" } },
    returns = t.object "picture", example = [[fit:chart{ file = "fit.png" }]] },
  { "fit:report", "Writes a report of the fit: that of its run, with the parameters and charts of the data above it.",
    head = 'fit:report "x.html" or { file, … }', arguments = report_rows.run "Fit",
    example = [[fit:report "fit.html"]] },
  { "sg.optimize", [[Finds the values of parameters at which a result is least while others stay within limits, by
sequential quadratic programming with the derivatives of sg.gradients. Each move counts only by the run at its end.]],
    named = { scene, start, bounds,
      { "least", t.either(t.text, t.callback_of({ { "run", t.object "run" } }, t.number)),
        "what is made as small as possible: a column at the end of the run, or a function of the run" },
      { "where", t.map(t.worded(pair, "a list {from, to}", "lists {from, to}")),
        "limits of columns at the end of the run, by name, also infinite ones", otherwise = "none" },
      scale, measure, runs, checkpoint, resume },
    more = [[
The search is local: it finds a least value near the start. Results of several steps are those of `measure` or of a
function, such as the largest force of the path. Parameters move as those of sg.fit.]],
    returns = t.object "optimum",
    example = [[print(sg.optimize{ scene = press_to, start = { depth = 0.02 }, least = "grip.fy",
  bounds = { depth = {0.01, 0.03} } })]] },
  { "optimum", "The result of sg.optimize. print shows values, limits and warnings.",
    fields = {
      { "at", t.map(t.number), "values of the parameters" },
      { "least", t.text, "the column, or \"least\" for a function" },
      { "value", t.number, "its value" },
      { "began", t.number, "its value at the start" },
      { "limits", t.list(t.any), [[{ name, value, from, to, multiplier } of the argument where; multiplier: by how much
the least value falls per unit by which the limit gives way, 0 where it is not reached, nil where it is exceeded]] },
      { "at_bounds", t.list(t.text), "parameters at their bounds" }, run, gradients, tries, reason, warnings } },
  { "optimum:report", "Writes a report: that of the run, with the table of the optimum above it.",
    head = 'optimum:report "x.html" or { file, … }', arguments = report_rows.run "Optimum",
    example = [[optimum:report "optimum.html"]] },
}
