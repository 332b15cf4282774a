-- sg.stability_map: where over two parameters the solve holds, and where and why it fails. A map is a study: each cell
-- is a case, so that a crash or an endless loop is an outcome like others.

local core = require "signorini.core"
local arguments = require "signorini.arguments"
local counted = require "signorini.counted"
local execute = require("signorini.study.execute").execute
local figure_names = require("signorini.study.values").figure_names
local file = require "signorini.stability_map.file"
local format_table = require "signorini.table"
local in_name_of = require "signorini.in_name_of"
local make_study = require("signorini.study").make
local pictures = require "signorini.stability_map.pictures"
local solve_cell = require "signorini.stability_map.cell"

local where = "sg.stability_map"

local Map = { picture = pictures.outcomes, figure = pictures.figure }
Map.__index = Map
Map.__name = "stability map"
core.types.map = Map

-- ── Reading the arguments ────────────────────────────────────────────────────────────────────────────────────────────

-- What no parameter can be called: names that a case of the study has for itself.
local accounts = { cell = true, wall = true, failed = true, outcome = true, reason = true }

--- A parameter { name, values }: numbers or strings, each once.
local function read_axis(key, axis)
  if type(axis) ~= "table" then arguments.reject(where, key, "a table { name = …, values = {…} }", axis) end
  arguments.table(where, key, axis, { "name", "values" })
  local name, values, seen = arguments.string(where, key .. ".name", axis.name), axis.values, {}
  if accounts[name] then
    core.fail(("%s: %s.name cannot be '%s', which every cell has: choose another name"):format(where, key, name))
  end
  if type(values) ~= "table" or #values == 0 then
    arguments.reject(where, key .. ".values", "a list of numbers or strings", values)
  end
  for i, value in ipairs(values) do
    if type(value) ~= "string" then arguments.number(where, ("%s.values[%d]"):format(key, i), value) end
    if seen[value] then core.fail(("%s: %s.values has %s twice"):format(where, key, core.describe(value))) end
    seen[value] = true
  end
  return { name = name, values = table.move(values, 1, #values, 1, {}) }
end

local function read_function(key, value)
  if value == nil then arguments.reject(where, key, "a function", value) end
  return arguments.callback(where, key, value)
end

--- The cases of the study in the order of the cells: y by y.
local function cases_of(x, y)
  local cases = {}
  for _, b in ipairs(y.values) do
    for _, a in ipairs(x.values) do cases[#cases + 1] = { [x.name] = a, [y.name] = b } end
  end
  return setmetatable(cases, { parameters = { x.name, y.name } })
end

--- The map, and how its study is to be executed.
local function read_map(options)
  if type(options) ~= "table" then arguments.reject(where, "its argument", "a table of named arguments", options) end
  arguments.table(where, "its argument", options,
    { "name", "x", "y", "scene", "path", "figures", "jobs", "limit", "file" })
  local name = arguments.string(where, "name", options.name, "stability map")
  local x, y = read_axis("x", options.x), read_axis("y", options.y)
  if x.name == y.name then core.fail(("%s: x.name and y.name are both '%s', not two"):format(where, x.name)) end
  local parts = { scene = read_function("scene", options.scene), path = read_function("path", options.path),
                  figures = arguments.callback(where, "figures", options.figures) }
  local execution = { jobs = arguments.count(where, "jobs", options.jobs, core.at_once),
                      limit = options.limit and arguments.positive(where, "limit", options.limit) }
  local map = { name = name, x = x, y = y, cells = {}, by_case = {},
                file = options.file and arguments.string(where, "file", options.file) }
  map.study = in_name_of(where, "sg.study", make_study, {
    name = name, cases = cases_of(x, y), parts = parts, folder = map.file and map.file:gsub("%.csv$", "") .. ".cells",
    run = function(case) return solve_cell(parts, case[x.name], case[y.name]) end,
  })
  return setmetatable(map, Map), execution
end

-- ── Cells ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The cell of a case: what it returned, or what became of it.
local function cell_of(entry, record, map)
  local cell = record.figures.cell or { outcome = record.outcome, report = record.traceback or record.reason,
                                        wall = record.wall, figures = {} }
  cell.x, cell.y = entry.case[map.x.name], entry.case[map.y.name]
  return cell
end

--- Makes the cells anew from the study's records, and their file.
local function gather(map)
  map.cells, map.by_case = {}, {}
  for i, entry in ipairs(map.study.cases) do
    local record = map.study.records[i]
    map.by_case[i] = record and cell_of(entry, record, map)
    map.cells[#map.cells + 1] = map.by_case[i]
  end
  if map.file then file.write(where, map.file, map) end
end

-- ── Reading (by the user) ────────────────────────────────────────────────────────────────────────────────────────────

core.docs["map"] = [[
map
What sg.stability_map returns: map.cells, a list of { x, y, outcome, reached, steps, increments, iterations, cutbacks,
rescues, wall, report, place, figures }; print(map) shows how many cells are held, and the table.]]

core.docs["map:cell"] = [[
map:cell(x, y)
The cell at two of the parameters' values; nil when it was not solved.
Example: map:cell("N2", 4).outcome]]
function Map:cell(x, y)
  local function place(key, axis, value)
    for i, known in ipairs(axis.values) do
      if known == value then return i end
    end
    core.fail(("map:cell: %s must be one of the values of %s, got %s"):format(key, axis.name, core.describe(value)))
  end
  local column, line = place("x", self.x, x), place("y", self.y, y)
  return self.by_case[(line - 1) * #self.x.values + column]
end

local function is_held(cell) return cell ~= nil and cell.outcome == "completed" end

core.docs["map:held"] = [[
map:held()
How many cells were held to the end of their path, and how many there are.
Example: held, cells = map:held()]]
function Map:held()
  local count = 0
  for _, cell in ipairs(self.cells) do count = count + (is_held(cell) and 1 or 0) end
  return count, #self.x.values * #self.y.values
end

core.docs["map:table"] = [[
map:table()
The text of a table, one row per cell.
Example: print(map:table())]]
function Map:table()
  local columns = { self.x.name, self.y.name, "outcome", "reached", "increments", "iterations", "cut-backs", "rescues",
                    "wall" }
  local units, formats = { "", "", "", "%", "", "", "", "", "s" }, { [4] = "%.1f", [9] = "%.2f" }
  local figures, rows = figure_names(self.cells), {}
  local first = #columns
  for i, name in ipairs(figures) do columns[first + i], units[first + i], formats[first + i] = name, "", "%.4g" end
  for r, cell in ipairs(self.cells) do
    rows[r] = { cell.x, cell.y, cell.outcome, cell.reached and 100 * cell.reached, cell.increments, cell.iterations,
                cell.cutbacks, cell.rescues, cell.wall }
    for i, name in ipairs(figures) do rows[r][first + i] = cell.figures[name] end
  end
  return format_table { columns = columns, units = units, rows = rows, formats = formats }
end

core.docs["map:csv"] = [[
map:csv(file)
Writes all cells to a CSV file, with the reports of the failures.
Example: map:csv "map.csv"]]
function Map:csv(name) file.write("map:csv", arguments.string("map:csv", "file", name), self) end

core.docs["map:compare"] = [[
map:compare(other)
What another map of the same parameters holds beside this one: { gained, lost, both, neither }. gained and lost are
lists of {x, y} that only the other one or only this one held, both and neither numbers of cells.
Example: #map:compare(map).gained]]
function Map:compare(other)
  if getmetatable(other) ~= Map then arguments.reject("map:compare", "its argument", "a stability map", other) end
  local result = { gained = {}, lost = {}, both = 0, neither = 0 }
  for _, y in ipairs(self.y.values) do
    for _, x in ipairs(self.x.values) do
      local here, there = is_held(self:cell(x, y)), is_held(other:cell(x, y))
      local changed = here ~= there and (there and result.gained or result.lost)
      if changed then
        changed[#changed + 1] = { x, y }
      else
        local key = here and "both" or "neither"
        result[key] = result[key] + 1
      end
    end
  end
  return result
end

--- How many cells were held, the table, and the first error, if there was one.
function Map:__tostring()
  local held, total = self:held()
  local text = ("%s: %d of %s held\n%s"):format(self.name, held, counted(total, "cell"), self:table())
  for _, cell in ipairs(self.cells) do
    if cell.outcome == "error" then return ("%s\nerror at %s, %s: %s"):format(text, cell.x, cell.y, cell.report) end
  end
  return text
end

core.docs["sg.stability_map"] = [[
sg.stability_map{ name, x = { name = , values = {…} }, y = { name = , values = {…} }, scene = function(x, y) …,
                  path = function(model, x, y) …, figures = function(model, run, x, y) …, jobs, limit, file }
Where over two parameters the solve holds, and where and why it fails. It is a study with a case for each pair of values
(numbers or strings): a process of its own calls scene, which returns a model, and path, which returns stages and
options as model:run takes them. What the functions change is lost with the process. Returns a map.
figures: numbers by name, of cells that reach the end of their path; those that are not finite are left out.
jobs:    cells that are solved side by side; by default what --jobs says, else as many as there are processors.
limit:   seconds by the clock on the wall after which a cell is given up; none by default.
file:    a CSV file that shows every finished cell at once; the folder next to it, map.cells for map.csv, keeps them as
         that of a study does. A later call with the same names takes up what is there as long as scene, path, figures
         and all that they refer to stay as they are; it solves errors and crashes again, and what was out of time when
         there is more. Remove the file to have all cells solved again; without one nothing is kept.
A cell: x, y, outcome, reached (part of the path, 0 to 1), steps, increments, iterations, cutbacks, rescues, wall (s),
report and place of a failure, figures. Outcomes: those of run.reason, "completed" is held; "error" (in one of the
functions), "crashed", "time". Ctrl-C ends it with the cells that are done. Errors and crashes are told on standard
error and make the exit status of the program 1, as those of study:execute do.
map.cells is a list; print(map) shows how many are held and the table; see help "map:picture", "map:compare".
Example: map = sg.stability_map{ x = { name = "order", values = {"N2", "N4"} },
           y = { name = "steps", values = {5, 10} }, scene = function(order) return (press(order, 1)) end,
           path = function(model, order, steps) return { { steps = steps, grip = {0, -0.1} } } end }]]
return function(options)
  local map, execution = read_map(options)
  if map.file and not file.is_there(where, map.file, map) then
    file.write(where, map.file, map) -- a file that cannot be written shows now, not after the first cell
    map.study.fresh = true
  end
  map.study.on_record = function() gather(map) end
  execute(where, map.study, execution)
  return map
end
