-- Pages: tables, files, scripts.

local t = require "signorini.call.types"

local model = { "model", t.object "model", "" }
local deformed = { "deformed", t.flag, "current shape; false: reference shape", default = true }
local file = { "file", t.text, "name of the file" }

local plain_data = t.worded(t.data, "plain data (finite numbers, strings, true, false, or tables of these)")
--- The cells of .vtu files.
local cells = { "cells", t.choice { "bezier", "linear" }, [["bezier": exact; "linear": each element is divided into
linear quadrilaterals or hexahedra, for programs without Bezier cells, such as meshio, PyVista, older
ParaViews]], default = "bezier" }
local subdivisions = { "subdivisions", t.integer(1, 64), "linear cells per element and direction",
                       otherwise = "the highest degree of all elements, at least 2" }
local function conflict_of_cells(values)
  if values.subdivisions and values.cells ~= "linear" then
    return 'subdivisions is for linear cells: add cells = "linear", or omit it'
  end
end

local help_words = t.name(function() return require("signorini.prompt.help").words() end)

return {
  title = "Tables, files, scripts", word = "scripts",
  { "sg.arguments", [[Returns the arguments name=value that follow a script's name on the command line, as a table of
values by name. The default gives the type: a whole number (10; 1 or more unless a limit is given), a number (2.5,
100.0), a string, true or false (yes or no on the command line), or a list of numbers or of strings (a,b,c); see help
"argument" for restrictions.]],
    head = "sg.arguments{ <name> = default, <name> = { default, <restriction> = … }, … }",
    arguments = {
      { "defaults", t.map(t.any), "defaults by the name of the argument" },
      { "words", t.list(t.text), "words name=value",
        otherwise = "those of the command line, or of the call of a script called as a function" } },
    more = [[
A wrong argument ends the script with one line that states the value and the expectation; the word help or --help prints
all arguments with their defaults and ends the program.]],
    returns = t.map(t.any),
    example = [[options = sg.arguments{ orders = {"N2", "N4"}, steps = 10, penalty = { 100.0, above = 0 },
                        out = "out/study" }]] },
  { "argument", [[An argument of a script with restrictions, which apply to the entries if the default is a list: {
{"m1"}, choices = {"m1", "m2"} }.]], head = "<name> = { default, <restriction> = …, … }, in sg.arguments{ … }",
    named = {
      { "choices", t.list(t.either(t.number, t.text), nil, 1), "the allowed values", optional = true },
      { "at_least", t.number, "smallest allowed number", optional = true },
      { "above", t.number, "lower bound, excluded", optional = true },
      { "at_most", t.number, "largest allowed number", optional = true },
      { "below", t.number, "upper bound, excluded", optional = true },
      { "none", t.flag, "the word none gives the empty list", optional = true },
      { "check", t.callback_of({ { "value", t.any }, { "values", t.map(t.any) } }, t.any),
        "function of the value (or entry) and of all values that returns whether it is valid", optional = true },
      { "expected", t.text, "requirement of check, in words that follow \"must be\"", optional = true },
      { "variants", t.map(t.map(t.any)), [[additional arguments by variant, listed before the common ones: variant = {
"plain", variants = { plain = {…}, deep = { depth = 0.5 } } }]], optional = true } } },
  { "sg.files", [[Creates the folder and returns a list of the files that a script writes there: files "forces.png"
returns the path of a file and adds it to the list; files.folder is the folder.]],
    arguments = { { "folder", t.text, "name of the folder" } },
    returns = t.object "files", example = [[files = sg.files "out/study"; run:csv(files "N2.csv"); files:report()]] },
  { "files", [[The result of sg.files: files "name" returns a path in its folder; as a list, it holds the files
written.]],
    head = "files(name)", arguments = { { "name", t.text, "name of a file in the folder" } }, returns = t.text,
    fields = { { "folder", t.text, "as given" } },
    example = [[sg.files("out/study").folder  --> "out/study"]] },
  { "files:draw", [[Calls a function that draws a file and adds the file to the list; if nothing was drawn, prints what
the file needs.]],
    arguments = { { "name", t.text, "name of the file in the folder" },
                  { "need", t.text, "what the file needs" },
                  { "body", t.callback_of({ { "path", t.text } }, t.or_nil(t.any)),
                    "function of the path that draws and returns whether it did" } },
    example = [[files:draw("forces.png", "two steps", function(path)
  return run.steps > 1 and run:csv(path) == nil
end)]] },
  { "files:report", "Prints the list of files written; prints nothing if it is empty.", example = "files:report()" },
  { "sg.mkdir", "Creates a folder and its parents; an existing folder is not an error.",
    arguments = { { "path", t.text, "name of the folder" } },
    example = [[sg.mkdir "out/study"]] },
  { "sg.table", [[Returns the text of an aligned table, numbers aligned to the right, with a dash for missing values.]],
    named = { { "columns", t.list(t.text), "names" }, { "rows", t.rows, "nil where missing" },
              { "units", t.list(t.text), "second header line", optional = true },
              { "formats", t.table "a table of patterns", "patterns of string.format by position or name of a column",
                optional = true } },
    returns = t.text,
    example = [[print(sg.table{ columns = {"x", "y"}, rows = {{1, 0.5}, {2, 0.25}}, units = {"mm", "N"} })]] },
  { "sg.csv.read", [[Reads a table from a CSV file and returns it: { columns = {…}, rows = {{…}, …}, comments = {…} }.
Lines that begin with # are comments. An apostrophe before = + - or @, see sg.csv.write, is not part of a text.]],
    arguments = { file },
    returns = t.object "data", example = [[run:csv "run.csv"
fx = sg.csv.read("run.csv"):column "grip.fx"]] },
  { "sg.csv.write", [[Writes a table to a CSV file, atomically. Values are numbers, strings, true or false; a missing
value is written as an empty field, which is read as nil; so is an empty string. Texts that spreadsheets would take for
formulas, because they begin with = + - or @, are quoted with an apostrophe before them, which sg.csv.read removes.]],
    arguments = {
      file,
      { "data", t.options({
        { "columns", t.list(t.text, nil, 1), "names of the columns", otherwise = "those of the lists, sorted" },
        { "rows", t.rows, "values; without rows, give lists of equal length by the names of columns", optional = true },
        { "comments", t.list(t.text), "comment lines at the top", optional = true } }, t.cells, "model:profile"),
        "the table, or a contact profile" } },
    example = [[sg.csv.write("a.csv", { columns = {"step", "fx"}, rows = {{1, 0.2}, {2, 0.3}} })]] },
  { "sg.json.write", [[Writes a value to a JSON file, atomically, names sorted; numbers are read back bitwise
identical.]],
    arguments = { file, { "value", plain_data,
      "lists become arrays, tables with names objects; an empty table becomes an empty array" } },
    more = [[
A table is either a list without gaps or has names as keys. nil is not written: a name without a value is missing in the
file. nan and infinity are not part of JSON; leave them out. Strings must be
valid UTF-8.]],
    example = { [[sg.json.write("limits.json", { force = 0.02, meshes = {1, 2} })]],
                [[sg.json.write("forces.json", { step = run:column "step", fy = run:column "grip.fy" })]] } },
  { "sg.json.read", [[Returns the value in a JSON file: a table, a string, a number, true, false or nil.]],
    arguments = { file },
    more = [[
Objects and arrays become tables, an empty one of either the same {}; null becomes nil, so that an array with null has a
gap. Numbers without fraction and exponent are integers, unless they are beyond 64 bits. Errors name the line and the
column of the file.]],
    returns = t.any, example = [[sg.json.read("limits.json").meshes[2]  --> 2]] },
  { "sg.reference", [[Returns a published table supplied with the program, as sg.csv.read does; the first comment names
its source and corrections.]],
    arguments = { { "name", t.name(function() return require("signorini.study.reference").names() end),
                    "name of a file in share/reference; a wrong one lists them" } },
    returns = t.object "data", example = [[#sg.reference("ironing2d_dofs_table7_2").rows  --> 8]] },
  { "data", "The result of sg.csv.read and sg.reference.",
    fields = { { "columns", t.list(t.text), "their names" },
               { "rows", t.list(t.cells), "the values, in the order of the columns" },
               { "comments", t.list(t.text), "lines that begin with #" } } },
  { "data:by", [[Returns the rows, each a table of values by name, with their value in one column as key; for equal
values the last row is returned.]],
    arguments = { { "name", t.name(function(data) return data.columns end), "name of the column" } },
    returns = t.table(), example = [[sg.reference "hertz2d_dofs_table7_4":by "mesh"]] },
  { "data:column", "Returns the values of a column as a list, nil where missing.",
    arguments = { { "name", t.name(function(data) return data.columns end), "name of the column" } },
    returns = t.list(t.any), example = [[sg.reference "ironing2d_oscillation_table7_3":column "discretization"]] },
  { "sg.vtu", [[Writes a model's current state to a .vtu file for ParaView: every element is a rational Bezier cell with
the degrees of the element, so shape and displacement are exact, also where rows of different degrees meet.]],
    named = {
      { "model", t.object "model", "model made by sg.model; needed without `patch`", optional = true,
        excludes = { "patch" } },
      { "file", t.text, "name that ends with .vtu" },
      { "deformed", t.flag, "current shape; false: reference shape, for ParaView's Warp By Vector",
        otherwise = "true", excludes = { "patch", why = "it is for models" } },
      { "patch", t.one_or_more(t.object "patch"), [[patches instead of a model; cells have the number
patch]], optional = true },
      cells, subdivisions, conflict = conflict_of_cells },
    more = [[
At points: displacement; stress (Cauchy: XX YY ZZ XY YZ XZ), von_mises, pressure (-tr sigma/3) and F (11 12 … 33), exact
at the p + 1 Gauss points per direction of each element and not smoothed between elements. The slave faces of the
contacts follow after the bodies, as cells of one dimension less, with the same fields and contact_pressure, of cohesive
contacts also damage, with friction mu and slip (nan elsewhere): a least-squares fit at the contact points of each
element, which may be negative near the end of contact; model:profile has the values themselves. Cells have the numbers
body and contact (0 for elements of bodies); body_names, contact_names list the names. VTK 9.1, ParaView 5.10 or newer.
A plane model is in z = 0; in an axisymmetric model, ZZ is the hoop direction.
Linear cells have the same arrays, with values at their corners, which lie on the exact geometry; elements do not share
points.]],
    example = { [[sg.vtu{ model = model, file = "state.vtu" }]],
                [[sg.vtu{ patch = sg.nurbs.circle{ radius = 1 }, file = "circle.vtu" }]],
                [[sg.vtu{ model = model, file = "linear.vtu", cells = "linear", subdivisions = 4 }]] } },
  { "sg.pvd", [[Starts a time series for ParaView and returns it: a .pvd file that lists the .vtu files of states,
<name>_0001.vtu and so on in the same folder; series:add adds them. The file can be opened during the run.]],
    arguments = {
      { "file", t.text, "name that ends with .pvd" },
      { "options", t.options {
        { "resume", t.flag, [[keep the states of an existing file, up to the time of the first one that is added, as
needed with resume = true of model:run]], default = false } }, "" } },
    returns = t.object "series", example = [[local series = sg.pvd "ironing.pvd"
model:run(stages, { on_step = function(info) series:add{ model = model, time = info.step } end })]] },
  { "series", "A time series for ParaView, made by sg.pvd: a list of { time, name } of its states." },
  { "series:add", "Writes the model's current state as sg.vtu does and adds it to a time series; times must increase.",
    named = { model, { "time", t.number, "time of the state" }, deformed, cells, subdivisions,
              conflict = conflict_of_cells },
    example = [[sg.pvd("ironing.pvd"):add{ model = model, time = 0 }]] },
  { "sg.median", "Returns the median of a list of numbers: the middle one, or the mean of the two middle ones.",
    arguments = { { "numbers", t.list(t.number, nil, 1), "" } },
    returns = t.number, example = "sg.median{3, 1, 2}  --> 2.0" },
  { "sg.wall_time", [[Returns wall-clock seconds since an arbitrary time: the difference of two values is the time
between two calls. For the processor time of all threads, use os.clock().]],
    returns = t.number, example = "began = sg.wall_time(); model:run(stages); print(sg.wall_time() - began)" },
  { "sg.help", [[Shows the page of a function: arguments with units and defaults, and an example; a word finds all pages
and scripts that contain it, and common terms of other programs. help "scripts" lists the supplied scripts, help
"hertz2d.lua" shows what one of them solves. At the prompt ?sg.nurbs.arc and ?refine do the same.]], unchecked = true,
    head = [[help(), help(sg.nurbs.arc), help "patch:refine", help "orders"]],
    arguments = { { "what", t.either(t.any, help_words), "function, value or word", optional = true } },
    example = "help(sg.nurbs.arc)" },
  { "traceback", "Shows the traceback of the last error at the prompt: the functions that were being called.",
    head = "traceback()" },
}
