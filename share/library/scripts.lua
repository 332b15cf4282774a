---@meta _
-- Generated from the help pages by scripts/reference; read by editors, not by the program.
-- Tables, files, scripts

---@class sg
local sg = {}

---Returns the arguments name=value that follow a script's name on the command line, as a table of values by name. The
---default gives the type: a whole number (10; 1 or more unless a limit is given), a number (2.5, 100.0), a string, true
---or false (yes or no on the command line), or a list of numbers or of strings (a,b,c); see help "argument" for
---restrictions.
---
---```text
---sg.arguments{ <name> = default, <name> = { default, <restriction> = … }, … }
---```
---
---A wrong argument ends the script with one line that states the value and the expectation; the word help or --help
---prints all arguments with their defaults and ends the program.
---
---Example:
---```lua
---options = sg.arguments{ orders = {"N2", "N4"}, steps = 10, penalty = { 100.0, above = 0 },
---                        out = "out/study" }
---```
---@param defaults table<string, any> # defaults: defaults by the name of the argument (a table of names { name = … })
---@param words? string[] # words: words name=value (a list of strings; by default those of the command line, or of the call of a script called as a function)
---@return table<string, any>
function sg.arguments(defaults, words) end

---An argument of a script with restrictions, which apply to the entries if the default is a list: { {"m1"}, choices =
---{"m1", "m2"} }.
---
---```text
---<name> = { default, <restriction> = …, … }, in sg.arguments{ … }
---```
---@class (exact) sg.argument
---choices: the allowed values (a list of at least one number or a string; optional)
---@field choices? (number|string)[]
---at_least: smallest allowed number (a number; optional)
---@field at_least? number
---above: lower bound, excluded (a number; optional)
---@field above? number
---at_most: largest allowed number (a number; optional)
---@field at_most? number
---below: upper bound, excluded (a number; optional)
---@field below? number
---none: the word none gives the empty list (true or false; optional)
---@field none? boolean
---check: function of the value (or entry) and of all values that returns whether it is valid (a function; optional)
---@field check? fun(value: any, values: table<string, any>): any
---expected: requirement of check, in words that follow "must be" (a string; optional)
---@field expected? string
---variants: a table of names { name = … }; optional. Additional arguments by variant, listed before the common ones:
---```text
---          variant = { "plain", variants = { plain = {…}, deep = { depth = 0.5 } } }
---```
---@field variants? table<string, table<string, any>>
---@field [string] sg.unknown_argument

---Creates the folder and returns a list of the files that a script writes there: files "forces.png" returns the path of
---a file and adds it to the list; files.folder is the folder.
---
---Example:
---```lua
---files = sg.files "out/study"; run:csv(files "N2.csv"); files:report()
---```
---@param folder string # folder: name of the folder (a string)
---@return sg.files
function sg.files(folder) end

---The result of sg.files: files "name" returns a path in its folder; as a list, it holds the files written.
---
---```text
---files(name)
---```
---
---Example:
---```lua
---sg.files("out/study").folder  --> "out/study"
---```
---@class sg.files
---folder: as given (a string)
---@field folder string
---@overload fun(name: string): string
local files = {}

---Calls a function that draws a file and adds the file to the list; if nothing was drawn, prints what the file needs.
---
---Example:
---```lua
---files:draw("forces.png", "two steps", function(path)
---  return run.steps > 1 and run:csv(path) == nil
---end)
---```
---@param name string # name: name of the file in the folder (a string)
---@param need string # need: what the file needs (a string)
---@param body fun(path: string): (any|nil) # body: function of the path that draws and returns whether it did (a function)
function files:draw(name, need, body) end

---Prints the list of files written; prints nothing if it is empty.
---
---Example:
---```lua
---files:report()
---```
function files:report() end

---Creates a folder and its parents; an existing folder is not an error.
---
---Example:
---```lua
---sg.mkdir "out/study"
---```
---@param path string # path: name of the folder (a string)
function sg.mkdir(path) end

---@class (exact) sg.table.arguments
---columns: names (a list of strings)
---@field columns string[]
---rows: nil where missing (a list of rows: each a list of numbers, strings, true or false)
---@field rows table<integer|string, (number|string|boolean)[]>
---units: second header line (a list of strings; optional)
---@field units? string[]
---formats: patterns of string.format by position or name of a column (a table of patterns; optional)
---@field formats? table
---@field [string] sg.unknown_argument

---Returns the text of an aligned table, numbers aligned to the right, with a dash for missing values.
---
---```text
---sg.table{ columns, rows, units, formats }
---```
---
---Example:
---```lua
---print(sg.table{ columns = {"x", "y"}, rows = {{1, 0.5}, {2, 0.25}}, units = {"mm", "N"} })
---```
---@param arguments sg.table.arguments
---@return string
function sg.table(arguments) end

---@class sg.csv
sg.csv = {}

---Reads a table from a CSV file and returns it: { columns = {…}, rows = {{…}, …}, comments = {…} }. Lines that begin
---with # are comments. An apostrophe before = + - or @, see sg.csv.write, is not part of a text.
---
---Example:
---```lua
---run:csv "run.csv"
---fx = sg.csv.read("run.csv"):column "grip.fx"
---```
---@param file string # file: name of the file (a string)
---@return sg.data
function sg.csv.read(file) end

---@class sg.csv.write.data
---columns: names of the columns (a list of at least one string; by default those of the lists, sorted)
---@field columns? string[]
---rows: values; without rows, give lists of equal length by the names of columns (a list of rows: each a list of
---```text
---      numbers, strings, true or false; optional)
---```
---@field rows? table<integer|string, (number|string|boolean)[]>
---comments: comment lines at the top (a list of strings; optional)
---@field comments? string[]
---@field [string] (number|string|boolean)[]

---Writes a table to a CSV file, atomically. Values are numbers, strings, true or false; a missing value is written as
---an empty field, which is read as nil; so is an empty string. Texts that spreadsheets would take for formulas, because
---they begin with = + - or @, are quoted with an apostrophe before them, which sg.csv.read removes.
---
---Example:
---```lua
---sg.csv.write("a.csv", { columns = {"step", "fx"}, rows = {{1, 0.2}, {2, 0.3}} })
---```
---@param file string # file: name of the file (a string)
---@param data? sg.csv.write.data|sg.model.profile.result # data: the table, or a contact profile (a table of named arguments) columns: names of the columns (a list of at least one string; by default those of the lists, sorted) rows: values; without rows, give lists of equal length by the names of columns (a list of rows: each a list of numbers, strings, true or false; optional) comments: comment lines at the top (a list of strings; optional)
function sg.csv.write(file, data) end

---@class sg.json
sg.json = {}

---Writes a value to a JSON file, atomically, names sorted; numbers are read back bitwise identical.
---
---A table is either a list without gaps or has names as keys. nil is not written: a name without a value is missing in
---the file. nan and infinity are not part of JSON; leave them out. Strings must be valid UTF-8.
---
---Example:
---```lua
---sg.json.write("limits.json", { force = 0.02, meshes = {1, 2} })
---sg.json.write("forces.json", { step = run:column "step", fy = run:column "grip.fy" })
---```
---@param file string # file: name of the file (a string)
---@param value number|string|boolean|table # value: lists become arrays, tables with names objects; an empty table becomes an empty array (plain data (finite numbers, strings, true, false, or tables of these))
function sg.json.write(file, value) end

---Returns the value in a JSON file: a table, a string, a number, true, false or nil.
---
---Objects and arrays become tables, an empty one of either the same {}; null becomes nil, so that an array with null
---has a gap. Numbers without fraction and exponent are integers, unless they are beyond 64 bits. Errors name the line
---and the column of the file.
---
---Example:
---```lua
---sg.json.read("limits.json").meshes[2]  --> 2
---```
---@param file string # file: name of the file (a string)
---@return any
function sg.json.read(file) end

---Returns a published table supplied with the program, as sg.csv.read does; the first comment names its source and
---corrections.
---
---Example:
---```lua
---#sg.reference("ironing2d_dofs_table7_2").rows  --> 8
---```
---@param name string # name: name of a file in share/reference; a wrong one lists them (a string)
---@return sg.data
function sg.reference(name) end

---The result of sg.csv.read and sg.reference.
---@class sg.data
---columns: their names (a list of strings)
---@field columns string[]
---rows: the values, in the order of the columns (a list of entries: each a list of numbers, strings, true or false)
---@field rows (number|string|boolean)[][]
---comments: lines that begin with # (a list of strings)
---@field comments string[]
local data = {}

---Returns the rows, each a table of values by name, with their value in one column as key; for equal values the last
---row is returned.
---
---Example:
---```lua
---sg.reference "hertz2d_dofs_table7_4":by "mesh"
---```
---@param name string # name: name of the column (a string)
---@return table
function data:by(name) end

---Returns the values of a column as a list, nil where missing.
---
---Example:
---```lua
---sg.reference "ironing2d_oscillation_table7_3":column "discretization"
---```
---@param name string # name: name of the column (a string)
---@return any[]
function data:column(name) end

---@class (exact) sg.vtu.arguments
---model: model made by sg.model; needed without `patch` (a model; optional)
---@field model? sg.model
---file: name that ends with .vtu (a string)
---@field file string
---deformed: current shape; false: reference shape, for ParaView's Warp By Vector (true or false; by default true)
---@field deformed? boolean
---patch: patches instead of a model; cells have the number patch (a patch or a list of at least one patch; optional)
---@field patch? sg.patch|sg.patch[]
---cells: 'bezier' or 'linear'; default "bezier". "bezier": exact; "linear": each element is divided into linear
---```text
---       quadrilaterals or hexahedra, for programs without Bezier cells, such as meshio, PyVista, older ParaViews
---```
---@field cells? "bezier"|"linear"
---subdivisions: linear cells per element and direction (a whole number from 1 to 64; by default the highest degree of
---```text
---              all elements, at least 2)
---```
---@field subdivisions? integer
---@field [string] sg.unknown_argument

---Writes a model's current state to a .vtu file for ParaView: every element is a rational Bezier cell with the degrees
---of the element, so shape and displacement are exact, also where rows of different degrees meet.
---
---```text
---sg.vtu{ model, file, deformed, patch, cells = "bezier", subdivisions }
---```
---
---At points: displacement; stress (Cauchy: XX YY ZZ XY YZ XZ), von_mises, pressure (-tr sigma/3) and F (11 12 … 33),
---exact at the p + 1 Gauss points per direction of each element and not smoothed between elements. The slave faces of
---the contacts follow after the bodies, as cells of one dimension less, with the same fields and contact_pressure, of
---cohesive contacts also damage (nan elsewhere): a least-squares fit at the contact points of each element, which may
---be negative near the end of contact; model:profile has the values themselves. Cells have the numbers body and contact
---(0 for elements of bodies); body_names, contact_names list the names. VTK 9.1, ParaView 5.10 or newer. A plane model
---is in z = 0; in an axisymmetric model, ZZ is the hoop direction. Linear cells have the same arrays, with values at
---their corners, which lie on the exact geometry; elements do not share points.
---
---Example:
---```lua
---sg.vtu{ model = model, file = "state.vtu" }
---sg.vtu{ patch = sg.nurbs.circle{ radius = 1 }, file = "circle.vtu" }
---sg.vtu{ model = model, file = "linear.vtu", cells = "linear", subdivisions = 4 }
---```
---@param arguments sg.vtu.arguments
function sg.vtu(arguments) end

---@class (exact) sg.pvd.options
---resume: true or false; default false. Keep the states of an existing file, up to the time of the first one that is
---```text
---        added, as needed with resume = true of model:run
---```
---@field resume? boolean
---@field [string] sg.unknown_argument

---Starts a time series for ParaView and returns it: a .pvd file that lists the .vtu files of states, \<name>_0001.vtu
---and so on in the same folder; series:add adds them. The file can be opened during the run.
---
---Example:
---```lua
---local series = sg.pvd "ironing.pvd"
---model:run(stages, { on_step = function(info) series:add{ model = model, time = info.step } end })
---```
---@param file string # file: name that ends with .pvd (a string)
---@param options? sg.pvd.options
---@return sg.series
function sg.pvd(file, options) end

---A time series for ParaView, made by sg.pvd: a list of { time, name } of its states.
---@class sg.series
local series = {}

---@class (exact) sg.series.add.arguments
---model: a model
---@field model sg.model
---time: time of the state (a number)
---@field time number
---deformed: current shape; false: reference shape (true or false; default true)
---@field deformed? boolean
---cells: 'bezier' or 'linear'; default "bezier". "bezier": exact; "linear": each element is divided into linear
---```text
---       quadrilaterals or hexahedra, for programs without Bezier cells, such as meshio, PyVista, older ParaViews
---```
---@field cells? "bezier"|"linear"
---subdivisions: linear cells per element and direction (a whole number from 1 to 64; by default the highest degree of
---```text
---              all elements, at least 2)
---```
---@field subdivisions? integer
---@field [string] sg.unknown_argument

---Writes the model's current state as sg.vtu does and adds it to a time series; times must increase.
---
---```text
---series:add{ model, time, deformed = true, cells = "bezier", subdivisions }
---```
---
---Example:
---```lua
---sg.pvd("ironing.pvd"):add{ model = model, time = 0 }
---```
---@param arguments sg.series.add.arguments
function series:add(arguments) end

---Returns the median of a list of numbers: the middle one, or the mean of the two middle ones.
---
---Example:
---```lua
---sg.median{3, 1, 2}  --> 2.0
---```
---@param numbers number[]
---@return number
function sg.median(numbers) end

---Returns wall-clock seconds since an arbitrary time: the difference of two values is the time between two calls. For
---the processor time of all threads, use os.clock().
---
---Example:
---```lua
---began = sg.wall_time(); model:run(stages); print(sg.wall_time() - began)
---```
---@return number
function sg.wall_time() end

---Shows the page of a function: arguments with units and defaults, and an example; a word finds all pages and scripts
---that contain it, and common terms of other programs. help "scripts" lists the supplied scripts, help "hertz2d.lua"
---shows what one of them solves. At the prompt ?sg.nurbs.arc and ?refine do the same.
---
---```text
---help(), help(sg.nurbs.arc), help "patch:refine", help "orders"
---```
---
---Example:
---```lua
---help(sg.nurbs.arc)
---```
---@param what? any|string # what: function, value or word (any value or a string; optional)
function sg.help(what) end
