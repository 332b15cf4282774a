-- The language: what `require "signorini"` returns. The bindings in C++ have made most of it; this adds what is written
-- in Lua.

local core = require "signorini.core"
local sg = core.sg

sg.help = require "signorini.help"
sg.csv = require "signorini.csv"
sg.table = require "signorini.table"
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
document("help", sg.help, [[
help(), help(sg.nurbs.arc), help "patch:refine", help "labels"
Shows what a function does, its arguments with units and defaults, and an example; a word finds all pages that hold it.]])

return sg
