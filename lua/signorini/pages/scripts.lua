-- Pages: tables, files, scripts.

local t = require "signorini.types"

local model = { "model", t.object "model", "" }
local deformed = { "deformed", t.flag, "present shape instead of the reference", default = true }
local file = { "file", t.text, "name of the file" }

local help_words = t.name(function() return require("signorini.help").words() end)

return {
  title = "Tables, files, scripts",
  word = "scripts",
  { "sg.arguments", [[Returns the arguments name=value that stand behind a script's name on the command line, as a table
of values by name. The default gives the type: a whole number (10; 1 or more unless a limit is given), a number (2.5,
100.0), a string, true or false (yes or no on the command line), or a list of numbers or of strings (a,b,c); see help
"argument" for restrictions.]],
    head = "sg.arguments{ <name> = default, <name> = { default, <restriction> = … }, … }",
    arguments = {
      { "defaults", t.map(t.any), "defaults by the name of the argument" },
      { "words", t.list(t.text), "words name=value",
        otherwise = "those of the command line, or of the call of a script that is called as a function" } },
    more = [[
What cannot be understood ends the script with one line that says what came and what was expected; the word help or
--help prints all arguments with their defaults and ends the program.]],
    example = [[options = sg.arguments{ labels = {"N2", "N4"}, steps = 10, penalty = { 100.0, above = 0 },
                        out = "out/study" }]] },
  { "argument", [[An argument of a script with restrictions, which hold for the entries where the default is a list: {
{"m1"}, choices = {"m1", "m2"} }.]], head = "<name> = { default, <restriction> = …, … }, in sg.arguments{ … }",
    named = {
      { "choices", t.list(t.either(t.number, t.text), nil, 1), "the allowed values", optional = true },
      { "at_least", t.number, "least number", optional = true },
      { "above", t.number, "number below all allowed ones", optional = true },
      { "at_most", t.number, "largest number", optional = true },
      { "below", t.number, "number above all allowed ones", optional = true },
      { "none", t.flag, "the word none stands for the empty list", optional = true },
      { "check", t.callback, "function of the value (or entry) and of all values that returns whether it is good",
        optional = true },
      { "expected", t.text, "what check asks for, in words that follow \"must be\"", optional = true },
      { "variants", t.map(t.map(t.any)), [[further arguments by variant, which precede those that all have: variant =
{ "plain", variants = { plain = {…}, deep = { depth = 0.5 } } }]], optional = true } } },
  { "sg.files", [[Makes the folder and returns a list of the files that a script writes there: files "forces.png" is the
path of a file and adds it to the list; files.folder is the folder.]],
    arguments = { { "folder", t.text, "name of the folder" } },
    example = [[files = sg.files "out/study"; run:csv(files "N2.csv"); files:report()]] },
  { "files", [[What sg.files returns: files "name" is a path in its folder; as a list, what was written.]],
    fields = { { "folder", t.text, "as given" } } },
  { "files:draw", [[Has a file drawn and counts it as written; where there was nothing to draw, prints what the file
needs.]],
    arguments = { { "name", t.text, "name of the file in the folder" },
                  { "need", t.text, "what the file needs" },
                  { "body", t.callback, "function of the path that draws, and returns whether it did" } },
    example = [[files:draw("forces.png", "two steps", function(path)
  return run.steps > 1 and run:csv(path) == nil
end)]] },
  { "files:report", "Prints the list of what was written; nothing when nothing was.",
    example = "files:report()" },
  { "sg.mkdir", "Makes a folder and those above it; an existing folder is no error.",
    arguments = { { "path", t.text, "name of the folder" } },
    example = [[sg.mkdir "out/study"]] },
  { "sg.table", [[Returns the text of an aligned table, numbers to the right, with a dash for missing values.]],
    named = { { "columns", t.list(t.text), "names" }, { "rows", t.rows, "nil where missing" },
              { "units", t.list(t.text), "second line of heads", optional = true },
              { "formats", t.any, "patterns of string.format by position or name of a column", optional = true } },
    example = [[print(sg.table{ columns = {"x", "y"}, rows = {{1, 0.5}, {2, 0.25}}, units = {"mm", "N"} })]] },
  { "sg.csv.read", [[Reads a table from a CSV file and returns it: { columns = {…}, rows = {{…}, …}, comments = {…} }.
Lines that begin with # are comments.]],
    arguments = { file },
    example = [[run:csv "run.csv"
fx = sg.csv.read("run.csv"):column "grip.fx"]] },
  { "sg.csv.write", [[Writes a table to a CSV file, whole or not at all. Values are numbers, strings, true or false; a
missing one is an empty field, which reads back as nil, as an empty string does.]],
    arguments = {
      file,
      { "data", t.options({
        { "columns", t.list(t.text, nil, 1), "names of the columns", otherwise = "those of the lists, sorted" },
        { "rows", t.rows, "values; without rows, equally long lists stand under the names of columns",
          optional = true },
        { "comments", t.list(t.text), "lines above", optional = true } }, t.cells), "the table" } },
    example = [[sg.csv.write("a.csv", { columns = {"step", "fx"}, rows = {{1, 0.2}, {2, 0.3}} })]] },
  { "sg.reference", [[Returns a published table that comes with the program, as sg.csv.read does; the first comment says
where it was printed and what was corrected.]],
    arguments = { { "name", t.name(function() return require("signorini.reference").names() end),
                    "name of a file in share/reference; a wrong one lists them" } },
    example = [[#sg.reference("ironing2d_dofs_table7_2").rows  --> 8]] },
  { "data", "What sg.csv.read and sg.reference return.",
    fields = { { "columns", t.list(t.text), "their names" },
               { "rows", t.list(t.cells), "the values, in the order of the columns" },
               { "comments", t.list(t.text), "lines that begin with #" } } },
  { "data:by", [[Returns the rows by the value that they have in one column, each as a table of values by name; of equal
values the last row stays.]],
    arguments = { { "name", t.name(function(data) return data.columns end), "name of the column" } },
    example = [[sg.reference "hertz2d_dofs_table7_4":by "mesh"]] },
  { "data:column", "Returns the values of a column as a list, nil where one is missing.",
    arguments = { { "name", t.name(function(data) return data.columns end), "name of the column" } },
    example = [[sg.reference "ironing2d_oscillation_table7_3":column "discretization"]] },
  { "sg.vtu", [[Writes a model's present state to a .vtu file for ParaView: every element is a rational Bezier cell of
its own degrees, so shape and displacement are exact, also where rows of different degrees meet.]],
    named = {
      { "model", t.object "model", "model made by sg.model; needed without `patch`", optional = true },
      { "file", t.text, "name that ends with .vtu" },
      { "deformed", t.flag, "present shape instead of the reference, from which ParaView's Warp By Vector leads to it",
        otherwise = "true" },
      { "patch", t.one_or_more(t.object "patch"), [[patches in place of a model,
before they are bodies; cells have the number patch]], optional = true } },
    more = [[
At points: displacement; stress (Cauchy: XX YY ZZ XY YZ XZ), von_mises, pressure (-tr sigma/3) and F (11 12 … 33), exact
at the p + 1 Gauss points per direction of each element and not smoothed between elements.
After the bodies follow the slave faces of the contacts, cells of one dimension less, with the same fields and
contact_pressure (nan in bodies): least squares at the contact points of each element, so that it may swing below zero
where contact ends; model:profile has the values themselves.
Cells have the numbers body and contact (0 for elements of bodies); body_names, contact_names list the names.
VTK 9.1, ParaView 5.10 or newer. A plane model lies in z = 0; of an axisymmetric one ZZ is the hoop direction.]],
    example = { [[sg.vtu{ model = model, file = "state.vtu" }]],
                [[sg.vtu{ patch = sg.nurbs.circle{ radius = 1 }, file = "circle.vtu" }]] } },
  { "sg.pvd", [[Begins a time series for ParaView and returns it: a .pvd file that lists the .vtu files of states, which
stand next to it as <name>_0001.vtu and so on; series:add adds them. The file can be opened while the run goes on.]],
    arguments = {
      { "file", t.text, "name that ends with .pvd" },
      { "options", t.options {
        { "resume", t.flag, [[keep the states of a file of this name, up to the time of the first one that is added, as
model:run{ …, resume = true } needs it]], default = false } }, "" } },
    example = [[local series = sg.pvd "ironing.pvd"
model:run(stages, { on_step = function(info) series:add{ model = model, time = info.step } end })]] },
  { "series", "A time series for ParaView, made by sg.pvd: a list of { time, name } of its states." },
  { "series:add", "Writes the model's present state as sg.vtu does and adds it to a time series; times must grow.",
    named = { model, { "time", t.number, "time of the state" }, deformed },
    example = [[sg.pvd("ironing.pvd"):add{ model = model, time = 0 }]] },
  { "sg.median", "Returns the median of a list of numbers: the one in the middle, or the mean of the two.",
    arguments = { { "numbers", t.list(t.number, nil, 1), "" } },
    example = "sg.median{3, 1, 2}  --> 2.0" },
  { "sg.wall_time", [[Returns wall-clock seconds since an arbitrary moment: the difference of two values is the time
between two calls. For the processor time of all threads, use os.clock().]],
    example = "began = sg.wall_time(); model:run(stages); print(sg.wall_time() - began)" },
  { "sg.help", [[Shows what a function does, its arguments with units and defaults, and an example; a word finds all
pages and scripts that contain it. help "scripts" lists the scripts that come along, help "hertz2d.lua" shows what one
of them solves. At the prompt ?sg.nurbs.arc and ?refine do the same.]], unchecked = true,
    head = [[help(), help(sg.nurbs.arc), help "patch:refine", help "labels"]],
    arguments = { { "what", t.either(t.any, help_words), "function, value or word", optional = true } },
    example = "help(sg.nurbs.arc)" },
  { "traceback", "Shows where the last error at the prompt came about: the functions that were being called.",
    head = "traceback()" },
}
