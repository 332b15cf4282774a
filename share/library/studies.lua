---@meta _
-- Generated from the help pages by scripts/reference; read by editors, not by the program.
-- Studies

---@class sg
local sg = {}

---@class (exact) sg.study.arguments
---name in tables, charts and of the folder (a string)
---@field name string
---tables of parameters, or lists of such tables, as sg.grid makes them (a list of at least one value)
---@field cases any[]
---a function. Function of a case, and of the name of a file for its checkpoints (model:run{ …, checkpoint = file,
---resume = true }), that returns results by name: numbers, strings, true or false, and lists of these, which tables
---omit. A failed case returns failed = true and a reason; this is a result, too. A result that is nan or infinite makes
---the case an error
---@field run fun(case: table<string, any>, checkpoint: string): table<string, any>
---folder to which each finished case is written at once as a JSON file (a string; by default out/\<name>)
---@field folder? string
---units by the name of a result or parameter, for tables and axes (a table of names { name = … }; optional)
---@field units? table<string, string>
---true or false or a function; default false. True, or a function of a case that returns true, for cases with time
---measurements: they run last, one at a time
---@field sequential? boolean|(fun(row: table<string, any>): any)
---values on which the results depend besides the parameters (a value (a finite number, a string, true, false, or a
---table of these); by default everything that run refers to)
---@field inputs? number|string|boolean|table
---@field [string] sg.unknown_argument

---Returns a study: a function evaluated for many cases, whose results are saved. study:execute{} runs each case in a
---separate process, so variables that the function changes do not affect other cases.
---
---```text
---sg.study{ name, cases, run, folder, units, sequential = false, inputs }
---```
---
---A case remains valid as long as its parameters, everything that run refers to and the program's version are
---unchanged. run refers to its own text, to that of the script's functions that it calls, and to the values that these
---use: numbers, tables, and the contents of bodies and models. With inputs, only the parameters and the inputs are
---compared. The file for checkpoints lasts until the case is done, so that a case that was killed continues where it
---was; it is another one if what the result depends on changes. Besides its results each row has wall, the seconds that
---run took, unless run returned a result of that name. A case without results has failed = true, outcome ("failed",
---"error", "crashed", or "time" if it exceeded the limit of study:execute) and reason. Methods of the study:
---study:execute, study:row, study:where, study:with, study:table, study:chart and others, help "studies".
---
---Example:
---```lua
---study = sg.study{ name = "steps", cases = sg.grid{ steps = {5, 10} },
---  run = function(case)
---    local run = press("N2", 1):run{ { name = "press", steps = case.steps, grip = {0, -0.1} } }
---    return { force = run:column "grip.fy"[run.steps] }
---  end }
---```
---@param arguments sg.study.arguments
---@return sg.study
function sg.study(arguments) end

---Returns all combinations of the parameters' values, as a list of cases for sg.study. The parameters are sorted by
---name, and the last one changes fastest; several tables, sg.grid({ order = … }, { mesh = … }), set the order. A value
---that is a table is shown by its field `name`, or as 6×2. print shows the cases as a table.
---
---```text
---sg.grid{ <parameter> = {…}, … }
---```
---
---Example:
---```lua
---#sg.grid{ order = {"N2", "N4"}, mesh = {1, 2, 3} }  --> 6
---```
---@param parameters table<string, (number|string|boolean|table)[]> # values by the name of the parameter (a table of names { name = … })
---@param ... table<string, (number|string|boolean|table)[]>
---@return any[]
function sg.grid(parameters, ...) end

---The result of sg.study; #study is the number of rows, print(study) shows how many cases are done, and the table.
---Methods that select, group or add return a new study that has rows only.
---@class sg.study
---tables of parameters and results by name (a list of values)
---@field rows any[]
---their names (a list of strings)
---@field parameters string[]
---their names (a list of strings)
---@field results string[]
---as given (a table of names { name = … })
---@field units table<string, string>
---as given (a string)
---@field name string
---as given (a string)
---@field folder string
---of the cases; records[i].made: host, processor, versions of libraries, time (a list of values)
---@field records any[]
local study = {}

---Iterates over the parts of a study with equal values in a column, in the order of the rows.
---
---Example:
---```lua
---for order, part in study:by "order" do print(order, #part) end
---```
---@param name string # parameter or result (a column)
---@return fun(): (any|nil), (sg.study|nil)
function study:by(name) end

---@class (exact) sg.study.chart.arguments.inset
---part of the x axis (a list of 2 increasing numbers {low, high})
---@field xrange [number, number]
---part of the y axis (a list of 2 increasing numbers {low, high}; by default that of the curves)
---@field yrange? [number, number]
---corner of the chart ('north-east', 'north-west', 'south-east' or 'south-west'; by default the emptiest one)
---@field place? "north-east"|"north-west"|"south-east"|"south-west"
---@field [string] sg.unknown_argument

---@class (exact) sg.study.chart.arguments
---column, or function of a row (a column or a function)
---@field x string|(fun(row: table<string, any>): any)
---column, or function of a row (a column or a function)
---@field y string|(fun(row: table<string, any>): any)
---column, or function of a row, with one curve per value (a column or a function; optional)
---@field series? string|(fun(row: table<string, any>): any)
---file name that ends with .png, .svg or .pdf (a string)
---@field file string
---marker at each point (true or false; default true)
---@field markers? boolean
---whether the line is dashed (true or false; default false)
---@field dashed? boolean
---whether to draw the line (true or false; default true)
---@field line? boolean
---line width in pixels, in a chart of 1600 x 1000 (a positive number; default 3)
---@field width? number
---label of the x axis with its unit: "force (N)" (a string; by default the column and its unit)
---@field xlabel? string
---label of the y axis (a string; by default the column and its unit)
---@field ylabel? string
---logarithmic axes ('x', 'y' or 'xy'; by default none)
---@field log? "x"|"y"|"xy"
---title above the chart (a string; by default the study's name)
---@field title? string
---true or false or 'inside' or 'outside'; default true. Names of the curves. true: in the first corner without curves
---(north-east, north-west, south-east, south-west), otherwise, and with an inset, to the right of the chart, or below
---it if the names are long or many; "inside": in a corner; "outside": outside the axes; false: no legend
---@field legend? boolean|"inside"|"outside"
---title of the legend (a string; by default the column of series)
---@field legend_title? string
---limits of the x axis (a list of 2 increasing numbers {low, high}; by default those of the data)
---@field xrange? [number, number]
---limits of the y axis (a list of 2 increasing numbers {low, high}; by default those of the data within xrange)
---@field yrange? [number, number]
---tick labels instead of numbers, in increasing order (a list of pairs {position, text}; optional)
---@field xticks? [number, string][]
---dotted horizontal reference lines (a list of numbers and pairs {position, text}; optional)
---@field hlines? (number|[number]|[number, string])[]
---dotted vertical reference lines (a list of numbers and pairs {position, text}; optional)
---@field vlines? (number|[number]|[number, string])[]
---a table of named arguments; optional. Magnifies a part of the chart in a box; if no corner is free, the y axis is
---extended, unless yrange is given
---@field inset? sg.study.chart.arguments.inset
---width and height (a list of 2 whole numbers from 120 to 5000; pixels; default {1600, 1000})
---@field size? [integer, integer]
---@field [string] sg.unknown_argument

---Draws the rows as curves, one per value of series, by increasing x. Failed rows and rows without x, y or series have
---no point. Strings and tables along x are in the order of first occurrence; a parameter with few integer values has
---ticks at these. Several rows of one curve at the same value of a parameter along x are an error unless line = false:
---select rows with study:where, or give series.
---
---```text
---study:chart{ x, y, series, file, markers = true, dashed = false, line = true, width = 3, xlabel, ylabel, log, title,
---  legend = true, legend_title, xrange, yrange, xticks, hlines, vlines, inset, size = {1600, 1000} }
---```
---
---Example:
---```lua
---study:chart{ x = "mesh", y = "error", series = "order", file = "error.png" }
---```
---@param arguments sg.study.chart.arguments
---@return sg.picture
function study:chart(arguments) end

---Ends the jobs of Slurm and on hosts that solve cases of this study, and returns their number. Finished cases remain.
---
---Example:
---```lua
---study:cancel()
---```
---@return integer
function study:cancel() end

---Returns a parameter or result as a list over the rows, nan where it is missing.
---
---Example:
---```lua
---study:column "force"
---```
---@param name string # parameter or result (a column)
---@return any[]
function study:column(name) end

---@class (exact) sg.study.csv.options
---columns in this order (a list of columns; by default all parameters and results)
---@field columns? string[]
---columns to sort the rows by, in increasing order (a column or a list of columns; by default the order of the cases)
---@field sort? string|string[]
---@field [string] sg.unknown_argument

---Writes the table of study:table to a CSV file, units in comments, long texts in full.
---
---Example:
---```lua
---study:csv "press.csv"
---```
---@param file string # name of the file (a string)
---@param options? sg.study.csv.options
function study:csv(file, options) end

---@class (exact) sg.study.execute.arguments
---cases solved in parallel, with one thread each (a whole number, 1 or more; by default the value of --jobs, or the
---number of processors)
---@field jobs? integer
---time limit of a case (a positive number; wall-clock seconds; by default none)
---@field limit? number
---finished cases to run again: all (true), those that failed, or a function of a row (true or false, 'failed' or a
---function; default false)
---@field rerun? boolean|"failed"|(fun(row: table<string, any>): any)
---'local' or 'slurm' or a list of at least one string; default "local". Where the cases are solved: on this machine, by
---Slurm, or on hosts reached by ssh, { "ssh:host1", "ssh:host2" }; --on of the command line takes precedence
---@field on? "local"|"slurm"|string[]
---cores of a task or a host, which solves as many cases in parallel (a whole number, 1 or more; default 1)
---@field cores? integer
---whether to wait for the jobs; if not, the study has the cases done so far (true or false; default true)
---@field wait? boolean
---whether only to write the script and to print the command that would submit it (true or false; default false)
---@field dry_run? boolean
---partition (a string; by default Slurm's default)
---@field partition? string
---time limit of a task, as Slurm writes it: "02:00:00" or "1-12" (days-hours) (a string; by default the partition's)
---@field time? string
---memory of a task, such as "4G"; help "model:cost" (a string; by default the partition's)
---@field memory? string
---a whole number, 1 or more or 'auto'; default "auto". Cases in a task; "auto": chunks of about equal measured cost,
---from a minute to half of the time limit, at most four for each task at a time
---@field chunk? integer|"auto"
---tasks at a time (a whole number, 1 or more; default 64)
---@field at_most? integer
---a positive number; seconds; default 120. Before the time limit cases are told to end at their next checkpoint, which
---takes at most half of this; the task then returns to the queue
---@field notice? number
---further options of sbatch, such as { "--qos=long", "--exclusive" } (a list of strings; default {})
---@field extra? string[]
---@field [string] sg.unknown_argument

---Runs the cases that are missing in the study's folder or whose inputs have changed, prints how many are reused and
---how many are to be solved, and returns the study. Each finished case is written to disk at once: if the program is
---stopped by Ctrl-C or killed, the same call continues with the missing cases. A failed case is a result and is saved.
---A case that ended with an error, or whose process crashed, is reported on standard error at the end, runs again at
---the next call, and makes the exit status of the program 1, unless the script ends with os.exit.
---
---```text
---study:execute{ jobs, limit, rerun = false, on = "local", cores = 1, wait = true, dry_run = false, partition, time,
---  memory, chunk = "auto", at_most = 64, notice = 120, extra = {} }
---```
---
---Two processes cannot execute the same study at the same time. study:read() reads the finished cases without running
---any. With on = "slurm", or signorini study.lua --on slurm, the missing cases become tasks of a job array, each of
---which runs the script up to this call and solves its cases; the results are the same files. With on = { "ssh:host1",
---"ssh:host2" }, or --on ssh:host1,ssh:host2, a process on each host does so until no case is left. The folder, the
---script and the program must have the same names on all machines. Cases that a job is still going to solve are not
---solved by other calls. study:watch() shows their state, study:cancel() ends the jobs.
---
---Example:
---```lua
---study:execute{ jobs = 2, rerun = "failed" }
---```
---@param arguments? sg.study.execute.arguments
---@return sg.study
function study:execute(arguments) end

---@alias sg.study.heatmap.arguments.colormap.choice "viridis"|"magma"|"inferno"|"plasma"|"cividis"|"gray"|"coolwarm"

---@class (exact) sg.study.heatmap.arguments
---parameter (a string)
---@field x string
---parameter (a string)
---@field y string
---column, or function of a row (a column or a function)
---@field value string|(fun(row: table<string, any>): any)
---file name that ends with .png, .svg or .pdf (a string)
---@field file string
---numbers in the cells; "failed" or "error" for cases without results (true or false; default true)
---@field texts? boolean
---label of the x axis with its unit (a string; by default the parameter and its unit)
---@field xlabel? string
---label of the y axis with its unit (a string; by default the parameter and its unit)
---@field ylabel? string
---title above the map (a string; by default the study's name)
---@field title? string
---title of the color bar, with the values' unit (a string; by default the column and its unit)
---@field label? string
---lowest and highest value of the colors (a list of 2 increasing numbers {low, high}; by default that of the values)
---@field range? [number, number]
---logarithmic color scale (true or false; default false)
---@field log? boolean
---as in sg.picture ('viridis', 'magma', 'inferno', 'plasma', 'cividis', 'gray' or 'coolwarm'; default "viridis")
---@field colormap? sg.study.heatmap.arguments.colormap.choice
---width and height (a list of 2 whole numbers from 120 to 5000; pixels; by default {1600, 1000}, of two or three panels
---{1600, 850}, of more {1600, 1400})
---@field size? [integer, integer]
---@field [string] sg.unknown_argument

---Draws a number over two parameters x and y, in the order of their values in the cases. More than one case in a cell
---is an error; select cases with study:where.
---
---```text
---study:heatmap{ x, y, value, file, texts = true, xlabel, ylabel, title, label, range, log = false, colormap =
---  "viridis", size }
---```
---
---Example:
---```lua
---study:heatmap{ x = "order", y = "mesh", value = "wall", log = true, file = "wall.png" }
---```
---@param arguments sg.study.heatmap.arguments
---@return sg.picture
function study:heatmap(arguments) end

---Returns the study without one parameter: rows that differ only in it are replaced by one, with the medians of their
---numbers, each over the rows that have it. Use it for results that vary between repetitions, such as times: cases =
---sg.grid{ …, round = {1, 2, 3} }.
---
---Example:
---```lua
---study:median "mesh"
---```
---@param name string # parameter (a string)
---@return sg.study
function study:median(name) end

---Reads the finished cases from the study's folder, without running any, and returns the study. It may be called while
---another process executes the study; inputs are not compared.
---
---Example:
---```lua
---print(study:read())
---```
---@return sg.study
function study:read() end

---Returns the row with these values, a table of parameters and results by name; it is an error if no row or several
---rows match.
---
---```text
---study:row{ <column> = value, … }
---```
---
---Example:
---```lua
---study:row{ order = "N2", mesh = 1 }.force
---```
---@param wanted table<string, any>|(fun(row: table<string, any>): any) # as in study:where (a table of names { name = … } or a function)
---@return table<string, any>
function study:row(wanted) end

---@class (exact) sg.study.table.arguments
---columns in this order (a list of columns; by default all parameters and results)
---@field columns? string[]
---columns to sort the rows by, in increasing order (a column or a list of columns; by default the order of the cases)
---@field sort? string|string[]
---patterns of string.format by the name of a column (a table of names { name = … }; default {wall = "%.3g"})
---@field formats? table<string, string>
---@field [string] sg.unknown_argument

---Returns the text of an aligned table, with units. For cases without results, the columns outcome (failed, error,
---crashed or time) and reason are added. Texts of more than 60 characters are shortened; study.rows and study:csv
---contain them in full.
---
---```text
---study:table{ columns, sort, formats = {wall = "%.3g"} }
---```
---
---Example:
---```lua
---print(study:table{ columns = {"order", "mesh", "error"}, sort = "error" })
---```
---@param arguments? sg.study.table.arguments
---@return string
function study:table(arguments) end

---Shows how many cases are waiting, begun by a task or a host, done and failed, until all jobs of the study have ended
---or Ctrl-C is pressed, and returns the study with the cases done so far.
---
---Example:
---```lua
---print(study:watch())
---```
---@return sg.study
function study:watch() end

---Returns the part of a study with these values, as a study that has rows only. A value that no case has is an error,
---except with a function.
---
---```text
---study:where{ <column> = value, … } or study:where(function(row) … end)
---```
---
---Example:
---```lua
---study:where{ order = "N2", mesh = {1, 2} }
---```
---@param wanted table<string, any>|(fun(row: table<string, any>): any) # values, or lists of values, by column, or a function of a row that returns true (a table of names { name = … } or a function)
---@return sg.study
function study:where(wanted) end

---Returns the study with an additional result, computed from each row.
---
---Example:
---```lua
---study:with("deviation", function(row) return math.abs(row.force / 0.08 - 1) end)
---```
---@param name string # name of the result (a string)
---@param make fun(row: table<string, any>): any # function of a row that returns the value, nil where it is unknown (a function)
---@param unit? string # unit of the result (a string; optional)
---@return sg.study
function study:with(name, make, unit) end

---@class (exact) sg.work_precision.options
---errors, a column or a function of a row; signs are ignored (a column or a function)
---@field error string|(fun(row: table<string, any>): any)
---times, a column or a function of a row (a column or a function; default "wall")
---@field time? string|(fun(row: table<string, any>): any)
---column or function of a row, with one curve per value (a column or a function; by default "order", or the first
---parameter)
---@field series? string|(fun(row: table<string, any>): any)
---the same for markers; false: one marker for all (false, a column or a function; by default all other parameters
---together)
---@field marker? false|string|(fun(row: table<string, any>): any)
---function of a row that returns true for the rows to use (a function; by default all)
---@field where? fun(row: table<string, any>): any
---errors at which times are compared (a list of at least one positive number; by default for each pair of curves the
---smallest, the middle and the largest one that both reach)
---@field at? number[]
---name that ends with .png, .svg or .pdf (a string; optional)
---@field file? string
---several such names (a list of strings; optional)
---@field files? string[]
---title above the chart (a string; by default the study's name)
---@field title? string
---label of the x axis with its unit: "force (N)" (a string; by default time and its unit)
---@field xlabel? string
---label of the y axis (a string; by default error and its unit)
---@field ylabel? string
---width and height (a list of 2 whole numbers from 120 to 5000; pixels; default {1600, 1000})
---@field size? [integer, integer]
---@field [string] sg.unknown_argument

---Draws a work-precision diagram, error over time: one curve per series through its cases by increasing time, one
---marker per kind of case, both axes logarithmic, the Pareto front as gray steps. Returns the comparison; print shows
---time ratios, the front and omitted cases.
---
---Failed cases, and those without time or error or with a zero in them, are omitted and listed with the reason. Times
---at equal error are interpolated on the lines between cases; if a curve reaches an error more than once, the smallest
---time is used. There is no extrapolation below a curve's smallest error or above that of its cheapest case.
---
---Example:
---```lua
---print(sg.work_precision(study, { error = "error", at = {0.1}, file = "speed.png" }))
---```
---@param study sg.study
---@param options sg.work_precision.options
---@return sg.comparison
function sg.work_precision(study, options) end

---The result of sg.work_precision.
---@class sg.comparison
---a list of values. { a, b, from, to, at = {…}, ratio = {…} } for each pair: at the error at[i], a takes ratio[i] times
---b's time, nil beyond from … to; why: the reason if no error is reached by both
---@field ratios any[]
---rows of the front (a list of values)
---@field pareto any[]
---{ row, why } of omitted cases (a list of values)
---@field left_out any[]
local comparison = {}

---Returns the text of a table of the Pareto front of time and error: the cases that no other case beats in both.
---
---Example:
---```lua
---print(comparison:front())
---```
---@return string
function comparison:front() end

---Returns the text of a table of cost ratios: A's time divided by B's at equal errors.
---
---Example:
---```lua
---print(comparison:table())
---```
---@return string
function comparison:table() end

---@class (exact) sg.cheapest.options
---errors, a column or a function of a row; signs are ignored (a column or a function)
---@field error string|(fun(row: table<string, any>): any)
---tolerance of the error (a positive number)
---@field at_most number
---cost, a column or a function of a row (a column or a function; default "wall")
---@field cost? string|(fun(row: table<string, any>): any)
---function of a row that returns true for the rows to use (a function; by default all)
---@field where? fun(row: table<string, any>): any
---@field [string] sg.unknown_argument

---Returns the cheapest row of a study whose error is within a tolerance, and the second cheapest; if there is none, nil
---and a text about the closest case. Failed rows and rows without error or cost are ignored.
---
---Example:
---```lua
---best, next_best = sg.cheapest(study, { error = "error", at_most = 0.1 })
---```
---@param study sg.study
---@param options sg.cheapest.options
---@return table<string, any>|nil
---@return (table<string, any>|string)|nil
function sg.cheapest(study, options) end

---@class (exact) sg.recommend.arguments
---a function. Function of order and mesh, and with formulations of keys for its contacts, that returns a model, and
---what model:run takes
---@field scene fun(order: string, mesh: any, keys: table<string, any>): sg.model, any, (any|nil)
---a string or a function. What is computed, whose error is estimated: a column of the run such as "ground.max_pressure"
---(its last value), or a function of model and run that returns a number, or a list of numbers at places independent of
---the mesh
---@field quantity string|(fun(model: sg.model, run: sg.run): (number|number[]))
---relative error (a number above 0 and below 1)
---@field at_most number
---order labels, cheapest first (a list of at least one string; default {"N2", "N2-N2.2"})
---@field orders? string[]
---a list of at least one value (a finite number, a string, true, false, or a table of these); default {1, 2, 4, 8, 16,
---32}. From coarse to fine, each with about half the element size of the one before, in any form that scene accepts
---@field meshes? (number|string|boolean|table)[]
---a list of at least one value (a finite number, a string, true, false, or a table of these); by default that of the
---scene. Contact formulations to compare, cheapest first: tables of keys that scene gives to its contacts, such as { {
---penalty = 100 }, { method = "mortar", enforcement = "multipliers" } }
---@field formulations? (number|string|boolean|table)[]
---time after which no further level is started (a positive number; seconds; by default none)
---@field limit? number
---@field [string] sg.unknown_argument

---@class (exact) sg.recommend.result
---@field order? string
---@field formulation? any
---@field mesh? any
---@field best? any
---@field error? number
---@field wall? number
---@field unknowns? number
---@field tries any[]
---@field spent number
---@field report string

---Returns the cheapest discretization and mesh, and if wanted contact formulation, that meet a tolerance: solves with
---discretizations and meshes from coarse to fine, estimates the error of each from the next level, and stops as soon as
---an estimate is within the tolerance. Prints the attempts and their times.
---
---```text
---sg.recommend{ scene, quantity, at_most, orders = {"N2", "N2-N2.2"}, meshes = {1, 2, 4, 8, 16, 32}, formulations,
---  limit }
---```
---
---The result has order, formulation (its keys), mesh, error (the estimate), wall (s) and unknowns of the case of least
---work within the tolerance (nil if there is none), tries, spent (s) and report. Work is unknowns times iterations,
---which is reproducible. With d the relative difference of the quantity on two levels, both with the order that comes
---last in the list among those solved on both, and r the fraction of the error that remains after one level (1/2; from
---three levels on as observed, if larger), the error of the finer level is about d r/(1 - r); that of coarser cases is
---larger by their difference from it. This is the discretization error only; errors of penalty, steps or the scene are
---not included. Orders that take about the work of another one and have twice its error are not tried again.
---
---Example:
---```lua
---sg.recommend{ scene = press, quantity = "grip.fy", at_most = 0.1, meshes = {1, 2, 4} }
---```
---@param arguments sg.recommend.arguments
---@return sg.recommend.result
function sg.recommend(arguments) end

---@class (exact) sg.convergence_map.arguments.x
---name of the parameter (a string)
---@field name string
---its values, each once (a list of at least one number or a string)
---@field values (number|string)[]
---@field [string] sg.unknown_argument

---@class (exact) sg.convergence_map.arguments.y
---name of the parameter (a string)
---@field name string
---its values, each once (a list of at least one number or a string)
---@field values (number|string)[]
---@field [string] sg.unknown_argument

---@class (exact) sg.convergence_map.arguments
---name of the map (a string; default "convergence map")
---@field name? string
---parameter along x (a table of named arguments)
---@field x sg.convergence_map.arguments.x
---parameter along y (a table of named arguments)
---@field y sg.convergence_map.arguments.y
---function of x and y that returns a model (a function)
---@field scene fun(x: any, y: any): sg.model
---function of model, x and y that returns stages and options, as model:run takes them (a function)
---@field path fun(model: sg.model, x: any, y: any): any, (any|nil)
---a function; optional. Function of model, run, x and y that returns numbers by name, called for cells that reach the
---end of their path; numbers that are not finite are omitted
---@field results? fun(model: sg.model, run: sg.run, x: any, y: any): table<string, number>
---cases solved in parallel, with one thread each (a whole number, 1 or more; by default the value of --jobs, or the
---number of processors)
---@field jobs? integer
---time limit of a case (a positive number; wall-clock seconds; by default none)
---@field limit? number
---a string; by default not stored. CSV file to which each finished cell is written at once; the folder next to it,
---map.cells for map.csv, stores the cells like that of a study, so that a later call reuses them. Remove the file to
---solve all cells again
---@field file? string
---@field [string] sg.unknown_argument

---Returns a convergence map: where the solve converges over two parameters, and where and why it fails. It is a study
---with a case for each pair of values: a separate process calls scene and path. Errors, crashes and the exit status are
---handled as in study:execute; Ctrl-C ends it with the cells done so far.
---
---```text
---sg.convergence_map{ name = "convergence map", x, y, scene, path, results, jobs, limit, file }
---```
---
---A cell: x, y, outcome, reached (fraction of the path, 0 to 1), steps, increments, iterations, cutbacks,
---fallback_steps, wall (s), report and place of a failure, results. outcome is run.reason ("completed" for converged
---cells), or "error" (in one of the functions), "crashed", "time". map:picture draws the outcomes, map:heatmap a
---number; help "map".
---
---Example:
---```lua
----- press(order, mesh), a function of your own, returns a model and its stages
---map = sg.convergence_map{ x = { name = "order", values = {"N2", "N4"} },
---  y = { name = "steps", values = {5, 10} }, scene = function(order) return (press(order, 1)) end,
---  path = function(model, order, steps) return { { steps = steps, grip = {0, -0.1} } } end }
---```
---@param arguments sg.convergence_map.arguments
---@return sg.map
function sg.convergence_map(arguments) end

---The result of sg.convergence_map; print(map) shows how many cells converged, and the table.
---@class sg.map
---a list of values. { x, y, outcome, reached, steps, increments, iterations, cutbacks, fallback_steps, wall, report,
---place, results } each
---@field cells any[]
local map = {}

---Returns the cell at given values of the two parameters; nil if it was not solved.
---
---Example:
---```lua
---map:cell("N2", 4).outcome
---```
---@param x number|string # value of the first parameter (a number or a string)
---@param y number|string # value of the second parameter (a number or a string)
---@return table<string, any>|nil
function map:cell(x, y) end

---@class (exact) sg.map.compare.result
---@field recovered any[]
---@field lost any[]
---@field both integer
---@field neither integer

---Compares another map of the same parameters with this one and returns { recovered, lost, both, neither }: recovered
---and lost are lists of the {x, y} that converged only in the other map or only in this one, both and neither are
---numbers of cells.
---
---Example:
---```lua
---#map:compare(map).recovered
---```
---@param other sg.map
---@return sg.map.compare.result
function map:compare(other) end

---Writes all cells to a CSV file, with the reports of failures.
---
---Example:
---```lua
---map:csv "map.csv"
---```
---@param file string # name of the file (a string)
function map:csv(file) end

---@alias sg.map.heatmap.arguments.colormap.choice "viridis"|"magma"|"inferno"|"plasma"|"cividis"|"gray"|"coolwarm"

---@class (exact) sg.map.heatmap.arguments
---such as "iterations" (a string)
---@field name string
---file name that ends with .png, .svg or .pdf (a string)
---@field file string
---map of the same values, drawn next to this one (a convergence map; optional)
---@field other? sg.map
---titles of the two maps (a list of 2 strings; by default their names)
---@field titles? [string, string]
---title of the color bar, with the values' unit (a string; by default the name)
---@field label? string
---title above the map (a string; by default the map's name and the label)
---@field title? string
---lowest and highest value of the colors (a list of 2 increasing numbers {low, high}; by default that of the values)
---@field range? [number, number]
---logarithmic color scale (true or false; default false)
---@field log? boolean
---as in sg.picture ('viridis', 'magma', 'inferno', 'plasma', 'cividis', 'gray' or 'coolwarm'; default "viridis")
---@field colormap? sg.map.heatmap.arguments.colormap.choice
---width and height (a list of 2 whole numbers from 120 to 5000; pixels; by default {1600, 1000}, of two or three panels
---{1600, 850}, of more {1600, 1400})
---@field size? [integer, integer]
---@field [string] sg.unknown_argument

---Draws a number of the cells, of the run or a result, as a heat map.
---
---```text
---map:heatmap{ name, file, other, titles, label, title, range, log = false, colormap = "viridis", size }
---```
---
---Example:
---```lua
---map:heatmap{ name = "iterations", file = "iterations.png" }
---```
---@param arguments sg.map.heatmap.arguments
function map:heatmap(arguments) end

---Returns the number of cells that converged to the end of their path, and the number of all cells.
---
---Example:
---```lua
---converged, cells = map:converged()
---```
---@return integer
---@return integer
function map:converged() end

---@class (exact) sg.map.picture.arguments
---file name that ends with .png, .svg or .pdf (a string)
---@field file string
---number shown in the cells: of the run, such as "reached", or a result (a string; default "iterations")
---@field text? string
---map of the same values, drawn next to this one (a convergence map; optional)
---@field other? sg.map
---titles of the two maps (a list of 2 strings; by default their names)
---@field titles? [string, string]
---title above the map (a string; by default the map's name)
---@field title? string
---width and height (a list of 2 whole numbers from 120 to 5000; pixels; by default {1600, 1000}, of two or three panels
---{1600, 850}, of more {1600, 1400})
---@field size? [integer, integer]
---@field [string] sg.unknown_argument

---Draws the outcomes as a heat map.
---
---```text
---map:picture{ file, text = "iterations", other, titles, title, size }
---```
---
---Example:
---```lua
---map:picture{ file = "map.png", text = "reached" }
---```
---@param arguments sg.map.picture.arguments
function map:picture(arguments) end

---Returns the text of a table with one row per cell.
---
---Example:
---```lua
---print(map:table())
---```
---@return string
function map:table() end
