-- sg.stability_map: where over two parameters the solve holds, and where and why it fails. Each cell is solved in a
-- process of its own, so that a crash or an endless loop is an outcome like others.

local core = require "signorini.core"
local arguments = require "signorini.arguments"
local counted = require "signorini.counted"
local format_table = require "signorini.table"
local holds = require("signorini.lists").holds
local literal = require "signorini.literal"
local pictures = require "signorini.stability_map.pictures"
local progress = require "signorini.progress"
local solve_cell = require "signorini.stability_map.cell"
local store = require "signorini.stability_map.store"

local where = "sg.stability_map"

local Map = { picture = pictures.outcomes, figure = pictures.figure }
Map.__index = Map
Map.__name = "stability map"
core.types.map = Map

-- ── Reading the arguments ────────────────────────────────────────────────────────────────────────────────────────────

--- A parameter { name, values }: numbers or strings, each once.
local function read_axis(key, axis)
  if type(axis) ~= "table" then arguments.reject(where, key, "a table { name = …, values = {…} }", axis) end
  arguments.table(where, key, axis, { "name", "values" })
  local name, values, seen = arguments.string(where, key .. ".name", axis.name), axis.values, {}
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

local function read_map(options)
  if type(options) ~= "table" then arguments.reject(where, "its argument", "a table of named arguments", options) end
  arguments.table(where, "its argument", options,
    { "name", "x", "y", "scene", "path", "figures", "jobs", "limit", "file" })
  return setmetatable({
    name = arguments.string(where, "name", options.name, "stability map"),
    x = read_axis("x", options.x), y = read_axis("y", options.y),
    scene = read_function("scene", options.scene), path = read_function("path", options.path),
    figures = arguments.callback(where, "figures", options.figures),
    jobs = arguments.count(where, "jobs", options.jobs, core.at_once),
    limit = options.limit and arguments.positive(where, "limit", options.limit),
    file = options.file and arguments.string(where, "file", options.file),
    cells = {}, by_x = {}, elsewhere = {},
  }, Map)
end

-- ── Cells ────────────────────────────────────────────────────────────────────────────────────────────────────────────

local function place(map, cell)
  map.by_x[cell.x] = map.by_x[cell.x] or {}
  map.by_x[cell.x][cell.y] = cell
end

--- All cells in the order of their values, y by y.
local function sort_cells(map)
  map.cells = {}
  for _, y in ipairs(map.y.values) do
    for _, x in ipairs(map.x.values) do map.cells[#map.cells + 1] = map:cell(x, y) end
  end
end

--- Takes up the cells of an earlier call. An error is no result: such cells are solved again. Those of other values
--- stay in the file.
local function take_up(map)
  for _, cell in ipairs(map.file and store.read(map.file, map) or {}) do
    local inside = holds(map.x.values, cell.x) and holds(map.y.values, cell.y)
    if inside and cell.outcome ~= "error" then place(map, cell) end
    if not inside then map.elsewhere[#map.elsewhere + 1] = cell end
  end
end

local function save(map)
  sort_cells(map)
  if not map.file then return end
  local cells = table.move(map.cells, 1, #map.cells, 1, {})
  store.write("sg.stability_map", map.file, map, table.move(map.elsewhere, 1, #map.elsewhere, #cells + 1, cells))
end

--- What became of a job that returned nothing.
local function lost_cell(map, failure)
  if failure == "time" then
    return { outcome = "time", wall = map.limit, report = ("not done within %g s"):format(map.limit), figures = {} }
  end
  local message = failure:match "^failed: (.*)$"
  return { outcome = message and "error" or "crashed", report = message or failure, figures = {} }
end

local function outcome_text(cell)
  local parts = { cell.outcome }
  if cell.iterations then parts[#parts + 1] = counted(cell.iterations, "iteration") end
  if cell.outcome ~= "completed" and cell.reached then parts[#parts + 1] = ("at %.0f%%"):format(100 * cell.reached) end
  if cell.wall then parts[#parts + 1] = ("%.1f s"):format(cell.wall) end
  if cell.outcome == "error" then parts[#parts + 1] = cell.report:match "^[^\n]*" end
  return table.concat(parts, ", ")
end

--- Solves the cells that are missing.
local function execute(map)
  local missing = {}
  for _, y in ipairs(map.y.values) do
    for _, x in ipairs(map.x.values) do
      if not map:cell(x, y) then missing[#missing + 1] = { x = x, y = y } end
    end
  end
  local display = progress(#missing)
  core.jobs(#missing, map.jobs, function(i)
    return literal.write(solve_cell(map, missing[i].x, missing[i].y))
  end, function(i, text, failure)
    local cell = text and literal.read(text) or lost_cell(map, failure)
    cell.x, cell.y = missing[i].x, missing[i].y
    place(map, cell)
    save(map)
    display:step(map.name)
    if not core.terminal then
      display:line(("%s: %s = %s, %s = %s: %s")
        :format(map.name, map.x.name, cell.x, map.y.name, cell.y, outcome_text(cell)))
    end
  end, map.limit)
  display:clear()
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
  for _, entry in ipairs { { "x", self.x, x }, { "y", self.y, y } } do
    local name, axis, given = table.unpack(entry, 1, 3)
    if not holds(axis.values, given) then
      core.fail(("map:cell: %s must be one of the values of %s, got %s"):format(name, axis.name, core.describe(given)))
    end
  end
  return self.by_x[x] and self.by_x[x][y]
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
  local figures, rows = store.figure_names(self.cells), {}
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
function Map:csv(file)
  store.write("map:csv", arguments.string("map:csv", "file", file), self, self.cells)
end

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
functions), "crashed", "time". Ctrl-C ends it with the cells that are done.
map.cells is a list; print(map) shows how many are held and the table; see help "map:picture", "map:compare".
Example: map = sg.stability_map{ x = { name = "order", values = {"N2", "N4"} },
           y = { name = "steps", values = {5, 10} }, scene = function(order) return (press(order, 1)) end,
           path = function(model, order, steps) return { { steps = steps, grip = {0, -0.1} } } end }]]
return function(options)
  local map = read_map(options)
  take_up(map)
  save(map) -- a file that cannot be written shows now, not after the first cell
  execute(map)
  sort_cells(map)
  return map
end
