-- The language: what `require "signorini"` returns. The bindings in C++ have made most of it; this adds what is written
-- in Lua.

local core = require "signorini.core"
local sg = core.sg

sg.help = require "signorini.help"
sg.csv = require "signorini.csv"
sg.table = require "signorini.table"
sg.reference = require "signorini.reference"
sg.mkdir = core.mkdir
core.types.model.run = require "signorini.run"

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
document("model:run", core.types.model.run, [[
model:run(stages, options)
Takes a model along its load path and returns a run. Each stage { name = , steps = , <support or load> = {…} } moves driven
supports and loads in equal steps to the values at its end; those that are not named stay where they are.
options: newton = { tolerance, iterations }, linear = "auto", on_step = function(info) (return "stop" to end cleanly),
  step = { adaptive = true, min = 1/64, max = 1, growth = 2 }: a step that fails is cut in half, down to the part `min` of
  it; after an easy increment (half of the iterations allowed) the next is `growth` times as long, up to `max`.
  Increments are counted (run.cutbacks, run:column "increments", run:attempts(step)); rows are the steps. Off by default.
A step that is not reached ends the run: run.failed, run.reason, run.report; the last accepted state is kept.
run:column "grip.fx" is a list over the steps; print(run) is a short table; run:csv(file) writes all columns.
Example: model:run{ { name = "press", steps = 46, grip = {0, -0.23} } }]])
document("help", sg.help, [[
help(), help(sg.nurbs.arc), help "patch:refine", help "labels"
Shows what a function does, its arguments with units and defaults, and an example; a word finds all pages that hold it.]])

return sg
