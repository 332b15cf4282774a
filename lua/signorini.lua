-- The language: what `require "signorini"` returns. The bindings in C++ have made most of it; this adds what is written
-- in Lua.

local core = require "signorini.core"
local sg = core.sg

sg.help = require "signorini.help"
sg.csv = require "signorini.csv"
sg.table = require "signorini.table"
sg.arguments = require "signorini.script_arguments"
sg.files = require "signorini.files"
sg.median = require "signorini.median"
sg.reference = require "signorini.reference"
sg.mkdir = core.mkdir
sg.grid = require "signorini.study.grid"
local study = require "signorini.study"
sg.study = study.new
sg.recommend = require "signorini.recommend"
sg.stability_map = require "signorini.stability_map"
sg.work_precision = require "signorini.work_precision"
sg.cheapest = require "signorini.cheapest"
local pvd = require "signorini.pvd"
sg.pvd = pvd.new
local profile = require "signorini.profile"
sg.profile_error, sg.profile_edges = profile.error, profile.edges
core.types.model.run = require "signorini.run"
core.types.model.cost = require "signorini.cost"
sg.robust = require("signorini.controls").robust

--- Gives functions written in Lua their help pages, like the rows of the bindings.
local function document(name, value, page)
  core.docs[name], core.names[value] = page, name
end

document("sg.csv.write", sg.csv.write, [[
sg.csv.write(file, { columns = {…}, rows = {{…}, …}, comments = {…} })
Writes a table, whole or not at all. Instead of rows, equally long lists may stand under the columns' names.
Example: sg.csv.write("a.csv", { columns = {"step", "fx"}, rows = {{1, 0.2}, {2, 0.3}} })]])
document("sg.csv.read", sg.csv.read, [[
sg.csv.read(file)
Reads a table: { columns = {…}, rows = {{…}, …}, comments = {…} }; lines that begin with # are comments.]])
document("sg.pvd", sg.pvd, [[
sg.pvd(file, { resume = false })
Begins a time series for ParaView: a .pvd file that lists the .vtu files of states, which stand beside it as
<name>_0001.vtu and so on. series:add{ model = model, time = 3 } adds the present state. The file can be opened while the
run goes on. A file of this name that was there begins anew; with resume = true its states stay, up to the time of the
first one that is added, as model:run{ …, resume = true } needs it.
Example: local series = sg.pvd "ironing.pvd"
         model:run(stages, { on_step = function(info) series:add{ model = model, time = info.step } end })]])
document("series:add", pvd.methods.add, [[
series:add{ model, time, deformed = true }
Writes the model's present state as sg.vtu does and adds it to a series made by sg.pvd; times must grow.]])
document("sg.table", sg.table, [[
sg.table{ columns = {…}, rows = {{…}, …}, units = {…}, formats = {…} }
The text of an aligned table, numbers to the right; formats are patterns of string.format by position or column name.]])
document("sg.reference", sg.reference, [[
sg.reference "ironing2d_oscillation_table7_3"
A published table that comes with the program, as sg.csv.read gives it; the first comment says where it was printed and
what was corrected. The names are those of the files in share/reference.]])
document("sg.mkdir", sg.mkdir, [[
sg.mkdir(path)
Makes a folder and those above it; an existing folder is fine.]])
document("sg.arguments", sg.arguments, [[
sg.arguments{ <name> = default, <name> = { default, <restriction> = … }, … }
The arguments name=value that stand behind a script's name on the command line, as a table of values by name. The
default gives the type: a whole number (10; of at least 1 unless it is told otherwise), a number (2.5, 100.0), a text,
true or false (yes or no on the command line), or a list of numbers or of texts (values with commas in between).
Restrictions, of a list's entries where the default is a list: { {"m1"}, choices = {"m1", "m2"} }
choices:  a list of what it may be
at_least, above, at_most, below: limits of a number
none:     true: the word none stands for the empty list
check:    a function of the value (or entry) and of all values, which returns whether it is good; with
expected: what check asks for, in words that follow "must be"
variants: further arguments by variant: variant = { "plain", variants = { plain = {…}, deep = { depth = 0.5 } } }; those
          of a variant go before those that all have
What cannot be understood ends the script with one line that says what came and what was expected; the word help or
--help prints all arguments with their defaults and ends the program. A script that is called as a function takes the
words of the call; sg.arguments(defaults, words) those of a list.
Example: options = sg.arguments{ labels = {"N2", "N4"}, steps = 10, penalty = { 100.0, above = 0 }, out = "out/study" }]])
document("sg.files", sg.files, [[
sg.files(folder)
Makes the folder and returns a list of the files that a script writes there: files "forces.png" is the path of a file and
adds it to the list. files:draw(name, need, body): body(path) draws the file, or returns false when there is nothing to
draw; then a line says what it would need. files:report() prints the list; files.folder is the folder.
Example: files = sg.files "out/study"; run:csv(files "N2.csv"); files:report()]])
document("sg.median", sg.median, [[
sg.median(numbers)
The median of a list of numbers: the one in the middle, or the mean of the two.]])
document("sg.profile_error", sg.profile_error, [[
sg.profile_error{ profile, reference, coordinate = "x", value = "pressure", normalise = 1, quadrature = "profile",
                  zone = "either", edge = "point" }
The L2 error sqrt(integral of ((p - p_ref)/N)^2 ds) of a contact profile (model:profile) against a reference: another
profile, or a function of the coordinate. Returns the error and { from, to, points, scale, covered }: the range and the
number of points of the integral, N, and the share of the zone where either one touches that the range covers.
coordinate: a column such as "x" (deformed) or "X" (reference), or a function of a point { x =, y =, pressure =, … }; it
            is s, so ds is its own length. It must grow along the contact zone; beyond, what turns back is left out.
value:      "pressure" or "traction". normalise: N, a number, or "max", the reference's largest value.
quadrature: whose points carry the integral: "profile" or "reference" (trapezoids between its points; the other one is
            interpolated linearly), or "union" (the points of both, exact for two polygons).
zone:       "either": open points count, with p = 0; "both": only where both touch, from edge point to edge point.
            Where the contact of one ends earlier than that of the other, "both" leaves out the largest differences.
edge:       how a profile falls to zero between its last point that touches and the next one: "point", linearly to that
            next one; "gap", to where the gap, linear between these two, is zero, which is a point of the integral, too.
Ranges that do not overlap are an error.
Example: sg.profile_error{ profile = coarse:profile "a", reference = fine:profile "a", normalise = "max" }
Source: V. Agrawal, thesis, IIT Guwahati 2020, eq. (7.2), which says nothing about the points of the integral.]])
document("sg.profile_edges", sg.profile_edges, [[
sg.profile_edges{ profile, coordinate = "x" }
Where the contact of a profile begins and ends: { from, to, from_spacing, to_spacing }. An edge lies where the gap,
linear between the last point that touches and the first one that does not, is zero; the spacing is the distance of
these two points, within which the profile knows no more. Without spacing the contact reaches the profile's end.
Example: half_width = sg.profile_edges{ profile = model:profile "ground" }.to]])
document("sg.grid", sg.grid, [[
sg.grid{ order = {"N2", "N4"}, mesh = {"m1", "m2"} }
All combinations of the parameters' values, as a list of cases for sg.study. Values are numbers, strings, true, false or
plain tables; a table shows by its field `name`, or as 6×2. The parameters stand in the order of their names, the last
one changes fastest; several tables, sg.grid({ order = … }, { mesh = … }), put them in this order instead.]])
document("sg.study", sg.study, [[
sg.study{ name, cases = sg.grid{ … }, run = function(case) … return { dPx = …, wall = run.wall } end, folder, units,
          alone = false, inputs }
A function that is solved for many cases, side by side, and whose results are kept. study:execute{ jobs = 2 } does it.
cases:  a list of tables of parameters, or of such lists: grids may stand side by side.
run:    returns figures by name: numbers, texts, true or false, and lists of these, which tables leave out. A case that
        did not come out returns failed = true and a reason: that is a result, too. A figure that is nan or infinite
        makes the case an error. Each case is a process of its own: what it changes is lost with it.
folder: where each finished case is written at once as a JSON file: out/<name> by default.
units:  of figures and parameters by name, for heads of tables and labels of axes.
alone:  true, or a function of a case: such cases run last and one by one, with nothing beside them, to be timed.
inputs: plain data. A case counts as done as long as its parameters, the text of run and all that run refers to
        (functions, numbers, tables; not the program itself) stay as they are; with inputs only these count.
Beside its figures each row has wall, the seconds that run took, unless it returned a figure of that name.
study.rows: a list of tables; #study; print(study); see help "study:where", "study:table", "study:chart".
Example: study = sg.study{ name = "steps", cases = sg.grid{ steps = {5, 10} },
           run = function(case) local run = press(case.steps); return { force = run:column "grip.fy"[run.steps] } end }]])
local methods = study.methods
document("study:execute", methods.execute, [[
study:execute{ jobs, limit, again }
Runs the cases that are missing in the study's folder, or whose inputs have changed, and returns the study. Each finished
case is on the disk at once; when the program is stopped or killed, the next call goes on with what is missing. A case
that fails is a result and stays; one that ended in an error or whose process died runs again at the next call.
jobs:  cases side by side; by default what --jobs says, else as many as there are processors. Each has one thread.
limit: seconds by the clock on the wall after which a case is given up; none by default.
again: true for all cases, "failed", or a function of a row: which cases run anew in any case.
Two processes cannot execute the same study at a time. study:read() takes what there is without running anything.]])
document("study:read", methods.read, [[
study:read()
Reads what the study's folder holds of its cases, without running any, and returns the study. It may be called while
another process executes it; changed inputs are not looked for.]])
document("study:where", methods.where, [[
study:where{ order = "N2", mesh = {"m1", "m2"}, failed = false } or study:where(function(row) return row.wall < 1 end)
The part of a study with these values, as a study that has results only: for a list any of its values.]])
document("study:by", methods.by, [[
study:by "order"
Goes over the parts of a study that share a value: for order, part in study:by "order" do print(order, #part) end]])
document("study:with", methods["with"], [[
study:with(name, function(row) … return value end, unit)
The study with one figure more, made from each row; nil where it is not known.
Example: study:with("error", function(row) return math.abs(row.peak / 0.0286 - 1) end)]])
document("study:median", methods.median, [[
study:median "round"
The study without this parameter: of rows that differ in nothing else one is left, with the medians of their numbers.
For figures that come out differently each time, above all times: cases = sg.grid{ …, round = {1, 2, 3} }.]])
document("study:row", methods.row, [[
study:row{ order = "N2", mesh = "m1" }
The one row with these values, a table of parameters and figures by name. None or several are an error.]])
document("study:column", methods.column, [[
study:column "dPx"
A parameter or figure as a list over the rows, nan where it is missing.]])
document("study:table", methods.table, [[
study:table{ columns, sort, formats }
The text of an aligned table, with units: all parameters and figures, or the columns named; sort is a column or a list of
columns, in rising order; formats are patterns of string.format by column name.]])
document("study:csv", methods.csv, [[
study:csv(file, { columns, sort })
Writes the table to a CSV file, units in comments.]])
document("study:chart", methods.chart, [[
study:chart{ x, y, series, file, … }
Draws the rows as curves to .png, .svg or .pdf: one per value of series, by rising x. x, y and series are columns, or
functions of a row; rows that failed or lack one of them have no point. Texts and tables along x stand in the order in
which they first appear. Where a parameter along x has several rows of one curve at a place, that is an error unless
line = false: choose with study:where, or give series. markers = true, dashed, line, width: of all curves; all else as in
sg.chart: xlabel, ylabel (the column and its unit), title (the study's name), log, legend, legend_title, xrange, yrange,
xticks, hlines, vlines, inset, size.
Example: study:chart{ x = "dofs", y = "dPx", series = "order", log = "xy", file = "dPx.png" }]])
document("study:heatmap", methods.heatmap, [[
study:heatmap{ x, y, value, file, texts = true, … }
Draws a number over two parameters x and y, in the order of their values in the cases; value is a column, or a function of
a row. texts: the numbers in the cells, "failed" where a case did. More than one case in a cell is an error that says what
study:where has to choose. All else as in sg.heatmap: xlabel, ylabel, title, label (the column and its unit), range, log,
colormap, size.
Example: study:heatmap{ x = "order", y = "mesh", value = "wall", log = true, file = "wall.png" }]])
document("sg.recommend", sg.recommend, [[
sg.recommend{ scene = function(label, mesh) … return model, stages, options end, error, at_most, labels, meshes, limit }
The least model that is enough: solves labels and meshes from coarse to fine, estimates the error of each from the next
level, and stops as soon as one is proven to be within the tolerance. Prints what it tried and what that cost.
scene:   returns the model of a label and a mesh, and what model:run takes.
error:   what shall be accurate: a column of the run such as "ground.max_pressure" (its last value counts), or a function
         of model and run that returns a number, or a list of numbers at places that do not change with the mesh.
at_most: the relative error, 0.02 for 2 %.
labels:  from the plainest to the richest; { "N2", "N2-N2.2" } by default.
meshes:  from coarse to fine, each about half as wide as the one before, in whatever way scene understands them;
         { 1, 2, 4, 8, 16, 32 } by default.
limit:   seconds after which no further level is begun; none by default.
Returns label, mesh, error (the estimate), wall (s), unknowns of the case of least work that is enough (nil where none
is), tries, spent (s), report. Work is unknowns times iterations, which is the same each time. With d the relative
distance of the richest label's figures on two levels and r the share of the error that a level leaves (1/2; from three
levels on as observed, if it is more) the finer one is about d r/(1 - r) off, and coarser cases by their distance from it
more. The error is that of the discretisation: what penalty, steps or the scene itself leave, no mesh can show. Labels
that take about the work of another one and have twice its error are not tried again.
Example: sg.recommend{ scene = press, error = "ground.max_pressure", at_most = 0.02 }]])
document("sg.stability_map", sg.stability_map, [[
sg.stability_map{ name, x = { name = , values = {…} }, y = { name = , values = {…} }, scene = function(x, y) …,
                  path = function(model, x, y) …, figures = function(model, run, x, y) …, jobs, limit, file }
Where over two parameters the solve holds, and where and why it fails. For each pair of values (numbers or strings) a
process of its own calls scene, which returns a model, and path, which returns stages and options as model:run takes
them. What the functions change is lost with the process. Returns a map.
figures: numbers by name, of cells that reach the end of their path; those that are not finite are left out.
jobs:    cells that are solved side by side; by default what --jobs says, else as many as there are processors.
limit:   seconds by the clock on the wall after which a cell is given up; none by default.
file:    a CSV file that keeps every finished cell at once; a later call with the same names takes up what it holds, but
         solves errors again. Remove it when the problem changes.
A cell: x, y, outcome, reached (part of the path, 0 to 1), steps, increments, iterations, cutbacks, rescues, wall (s),
report and place of a failure, figures. Outcomes: those of run.reason, "completed" is held; "error" (in one of the
functions), "crashed", "time".
map.cells; map:cell(x, y); map:held() → number held, number of cells; map:table(), a text; map:csv(file)
map:compare(other) → { gained, lost, both, neither }: lists of {x, y} that only other or only map holds, and two numbers
map:picture{ file, title, text = "iterations", size, beside = other map, titles = {…, …} }: outcomes as a heat map; text
is the number in the cells, an account of the cell such as "reached" or a figure
map:figure{ name, file, log = false, label, title, range, colormap, size, beside, titles }: one number as a heat map
Example: map = sg.stability_map{ x = { name = "order", values = {"N2", "N4"} }, y = { name = "steps", values = {5, 10} },
           scene = function(order) return press(order) end,
           path = function(model, order, steps) return { { steps = steps, grip = {0, -0.5} } } end }]])
document("sg.work_precision", sg.work_precision, [[
sg.work_precision(study, { error, time = "wall", series = "order", marker, where, at, file or files, title, xlabel, ylabel,
                           size })
Error against time: one curve per series through its cases by rising time, one marker per kind of case, both axes
logarithmic, the Pareto front as grey steps. Returns the comparison; print shows ratios, front and what was left out.
error, time, series, marker: columns of the study, or functions of a row. Errors count by their size. series is the first
         parameter where none is called order; marker all other parameters together, false for none.
where:   a function of a row: only rows for which it is true.
at:      errors at which times are compared; by default the least, the middle and the largest one that both curves reach.
file, files: .png, .svg, .pdf; none by default.
Cases that failed, and those without time or error or with a zero of them, are left out and listed with the reason.
Times at equal error are interpolated on the lines between cases; where a curve comes down to an error more than once, the
least time counts. Nothing is extrapolated: not below a curve's least error, and not above that of its cheapest case.
result.ratios: { a, b, from, to, at = {…}, ratio = {…} } for each pair: at the error at[i] a takes ratio[i] of b's time,
nil beyond from … to; without errors that both reach, why. result.pareto: the rows of the front; result.left_out: { row,
why }; result:table(), result:front(): texts.
Example: print(sg.work_precision(study, { error = "dPx", at = {0.05}, file = "speed.png" }))]])
document("sg.cheapest", sg.cheapest, [[
sg.cheapest(study, { error, at_most, cost = "wall", where })
The cheapest row of a study whose error is at most so large, and the runner-up; nil and a text about the nearest case when
there is none. error and cost: columns, or functions of a row; errors count by their size. where: a function of a row:
only rows for which it is true. Rows that failed, or lack error or cost, do not count.
Example: best, next_best = sg.cheapest(study, { error = "dPx", at_most = 0.05 })]])
document("model:run", core.types.model.run, [[
model:run(stages, options)
Takes a model along its load path and returns a run. Each stage { name = , steps = , <support or load> = {…} } moves driven
supports and loads in equal steps to the values at its end; those that are not named stay where they are.
options:
  newton = { tolerance = 1e-10, iterations = 25, line_search = "none", freeze_active_set = false, active_set_changes = },
    linear = "auto", augmented = { penetration = 1e-6, loops = 100 }, damping = false: see help "model:solve_step";
    freeze_active_set = true is 0.01.
  predictor = "tangent", "constant" or "linear": the first guess of a step; linear goes on as the last one went.
  rescue = true: a step that fails is tried again with the tangent's predictor, and, where the tangent is singular because
    contact alone holds a body, with damping; then, where it cannot be cut any more, with damping, a line search, a frozen
    active set. run.rescues counts what helped, run:attempts(step) tells. Off by default. sg.robust{} turns on all that easy
    runs do not pay for.
  threads = how many work on this solve and later ones; bits are the same for any number. By default what --threads says.
  penalty = { start = 0.01, steps = 20 }: all penalties grow from this part of their values to the whole in so many steps.
  step = { adaptive = true, min = 1/64, max = 1, growth = 2 }: a step that fails is cut in half, down to the part `min` of
  it; after an easy increment (half of the iterations allowed) the next is `growth` times as long, up to `max`.
  Increments are counted (run.cutbacks, run:column "increments", run:attempts(step)); rows are the steps. Off by default.
  arc_length = true: where a step fails, arcs follow the path, also back, until the step's end is passed; rows between
  steps have a fractional step, run.controls says where control changed.
  checkpoint = "run.sgn", or { file = "run.sgn", every = 10 }: after every step, or every so many, and at the end the model
  is saved together with how the run stands; a process that is killed leaves the file of the last such step. It is on the
  disk after a second; durable = true waits for the disk at every step.
  resume = true: goes on from the checkpoint's file where there is one, with the same bits as a run that nothing has
  disturbed; the file of a finished run gives that run at once. Scene and stages must be the same. See also model:save.
  on_step = function(info): sees info.step, info.stage, info["grip.fx"] … after each step; returns nothing, "stop" to end
    cleanly, "cut" to have the step done again in halves, or a table of numbers: columns of the run, else nan.
  on_iteration = function(info): sees stage, step, from, to (parts of the step), iteration, residual, energy, reason;
    returns nothing, "stop", or "cut" to give the attempt up.
A step that is not reached ends the run, a result: run.failed, run.reason, run.cause (what was behind minimum_step),
run.report (in words, with the worst places and what may help), run.places (for sg.picture's marks); the last accepted state
is kept. Reasons: completed, stopped, interrupted, cut, iterations, diverged, cycling, lost_projection, inverted, singular,
indefinite, nan, line_search, penetration, turning_point, minimum_step, strayed.
run:column "grip.fx" is a list over the steps; print(run) is a short table; run:csv(file) writes all columns: step,
increments, iterations, wall; <support>.fx, .fy, in 3D .fz, .moment where it rotates, .ux, .uy, .uz, .angle where driven;
<load>.fx …, .tx … or .pressure; <contact>.fx …, .area, .max_pressure, .max_penetration.
Example: model:run{ { name = "press", steps = 46, grip = {0, -0.23} } }]])
document("model:cost", core.types.model.cost, [[
model:cost()
What a model is made of, before a solve or after it, and what could be saved. print(model:cost()) shows tables and advice.
cost.unknowns:   of the linear system; obstacles (cost.obstacles, how many) have none.
cost.bodies:     by name { unknowns, contact_layer, bulk, prescribed, elements, gauss_points }: contact_layer are the
                 unknowns on the faces that `contact` names, bulk all others, prescribed what supports fix or drive.
cost.contacts:   by name { points, rigid }: contact points, and whether the master is an obstacle.
cost.nonzeros:   of the tangent; it grows where contacts touch.
cost.memory:     bytes, the sum of cost.memory_of { bodies, contacts, tangent, factors }: tables of Gauss points, contact
                 points with their history and what their last evaluation left, the tangent with its patterns, its factors
                 by the solver cost.linear. cost.factors_are is "measured" once a solver has told, before that
                 "counted": from the pattern in the order of nested dissection.
cost.advice:     a list of { kind, saves, needs, text }: unknowns saved and left in the whole scene, and why, for what is
                 certain to be so from the scene alone:
  symmetry:    it is its own mirror image in planes x, y or z = c (in an axisymmetric scene y = c): control points,
               weights, knots, supports, loads, contacts, obstacles. What turns or has moved through it breaks it.
  symmetry if fixed: the same, but a support may drive through the plane: only while it does not.
  axisymmetry: solids of revolution about one axis, or sectors that supports hold in their end planes.
  rigid:       a body at least 100 times as stiff as those that it touches, which one support moves without turning it.
  layer:       a uniform degree above 2 on a body whose contact face alone may need it.
  idle layer:  a layer on a face that is in no contact.
  points:      more than twice 3(p+1) contact points per element and direction; it saves no unknowns.
Paths are not looked at: they must be symmetric, too.
Example: for _, advice in ipairs(model:cost().advice) do print(advice.saves, advice.text) end]])
document("sg.robust", sg.robust, [[
sg.robust{ … }
Options for model:run with the controls on that easy runs do not pay for: steps begin as the last one went on
(predictor = "linear"), what fails is tried again with other controls (rescue = true), then cut in half
(step = { adaptive = true }). What is given replaces these.
Example: model:run(stages, sg.robust{ arc_length = true, step = { adaptive = true, min = 1/256 } })]])
document("help", sg.help, [[
help(), help(sg.nurbs.arc), help "patch:refine", help "labels"
Shows what a function does, its arguments with units and defaults, and an example; a word finds all pages that hold it.]])

return sg
