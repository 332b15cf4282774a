-- sg.convergence_map: convergence map over two parameters: where the solve converges, and where and why it fails. A map
-- is a study: each cell is a case, so that a crash or an endless loop is also an outcome.

local core = require "signorini.core"
local accepted = require("signorini.run.controls").accepted
local check = require "signorini.call.check"
local counted = require("signorini.call.text").counted
local csv = require "signorini.output.csv"
local execute = require("signorini.study.execute").execute
local format_table = require("signorini.output.table").text
local grid = require "signorini.study.grid"
local on_behalf_of = require "signorini.call.on_behalf_of"
local lists = require "signorini.call.lists"
local make_study = require("signorini.study.study").make
local pictures = require "signorini.study.convergence_map.pictures"
local types = require "signorini.call.types"
local values = require "signorini.study.values"

local where = "sg.convergence_map"

local Map = { picture = pictures.outcomes, heatmap = pictures.heatmap }
Map.__index = Map
Map.__name = "convergence map"
core.types.map = Map

-- ── One cell: a model is built and follows its path ──────────────────────────────────────────────────────────────────

--- The fraction of a path that a run completed: whole steps, and the accepted fraction of the one that failed.
local function reached(run, stages)
  local total, done = 0, run.steps
  for _, stage in ipairs(stages) do total = total + stage.steps end
  if run.failed then
    local from = 0
    for _, attempt in ipairs(run:attempts(run.steps + 1)) do from = attempt.restarted and from or attempt.from end
    done = done + math.max(0, math.min(1, from))
  end
  return done / total
end

--- The user's results; those that are not finite numbers are left out.
local function read_results(results)
  local finite = {}
  check.value(types.map { kind = "number", gaps = true }, results, where, "what results returns")
  for name, value in next, results do
    if value == value and math.abs(value) < math.huge then finite[name] = value end
  end
  return finite
end

--- Solves the cell at x, y with these functions and returns the result of the study's case. Their errors propagate.
local function solve_cell(functions, x, y)
  local model = functions.scene(x, y)
  if type(model) ~= "userdata" and type(model) ~= "table" then
    core.fail(("%s: scene must return a model, got %s"):format(where, model and core.describe(model) or "nothing"))
  end
  local stages, options = functions.path(model, x, y)
  local run = model:run(stages, options)
  local place, completed = run.places and run.places[1], run.reason == "completed"
  local cell = { outcome = run.reason, reached = reached(run, stages), steps = run.steps,
                 increments = #accepted(run.histories), iterations = run.iterations, cutbacks = run.cutbacks,
                 fallback_steps = run.fallback_steps or 0, wall = run.wall, report = run.failure,
                 place = place and place.text,
                 results = {} }
  if completed and functions.results then cell.results = read_results(functions.results(model, run, x, y)) end
  return { cell = cell, failed = not completed,
           reason = not completed and ("%s: %s"):format(run.reason, run.failure) or nil }
end

-- ── The file ─────────────────────────────────────────────────────────────────────────────────────────────────────────

-- A map's file: its cells, and a title that identifies the map.
local columns = { "x", "y", "outcome", "reached", "steps", "increments", "iterations", "cutbacks", "fallback_steps",
                  "wall",
                  "place", "report" }

local function title(map)
  return (("convergence map: %s; x: %s; y: %s"):format(map.name, map.x.name, map.y.name):gsub("[\r\n]+", " "))
end

--- Writes a map's cells, one per row, for the function `where`.
local function write_file(where, name, map)
  local results = values.result_names(map.cells)
  local rows = lists.map(map.cells, function(cell)
    local row = lists.map(columns, function(column) return cell[column] end)
    for i, result in ipairs(results) do row[#columns + i] = cell.results[result] end
    return row
  end)
  local heads = lists.joined(columns, lists.map(results, function(result) return "result " .. result end))
  on_behalf_of(where, "sg.csv.write", csv.write, name, { columns = heads, rows = rows, comments = { title(map) } })
end

--- True if the map's file exists. If it belongs to something else, or no folder keeps its cells, this is an error, so
--- that it is not overwritten.
local function is_there(where, name, map)
  if not core.exists(name) then return false end
  local data, folder = on_behalf_of(where, "sg.csv.read", csv.read, name), map.study.folder
  if data.comments[1] ~= title(map) then
    core.fail(("%s: '%s' contains something other (%s) than this map (%s). Hint: remove it, or choose another file")
      :format(where, name, data.comments[1] or "without a title", title(map)))
  end
  if #data.rows > 0 and not core.exists(folder) then
    core.fail(("%s: the cells in '%s' cannot be continued, because the folder '%s' is missing. Hint: restore it, or "
      .. "remove the file"):format(where, name, folder))
  end
  return true
end

-- ── Reading the arguments ────────────────────────────────────────────────────────────────────────────────────────────

--- Raises an error unless a parameter can have its name, and each of its values occurs once.
local function check_axis(key, axis)
  local seen = {}
  if axis.name == "cell" or lists.holds(values.accounts, axis.name) then -- columns of every case of a study
    core.fail(("%s: %s.name cannot be '%s', a column of every cell. Hint: choose another name"):format(where, key,
      axis.name))
  end
  for _, value in ipairs(axis.values) do
    if seen[value] then core.fail(("%s: %s.values has %s twice"):format(where, key, core.describe(value))) end
    seen[value] = true
  end
end

--- The cases of the study in the order of the cells: row by row of y.
local function cases_of(x, y)
  return setmetatable(grid({ [y.name] = y.values }, { [x.name] = x.values }), { parameters = { x.name, y.name } })
end

local function new_map(options)
  local x, y, name = options.x, options.y, options.file
  check_axis("x", x)
  check_axis("y", y)
  if x.name == y.name then core.fail(("%s: x.name and y.name must differ, both are '%s'"):format(where, x.name)) end
  local parts = { scene = options.scene, path = options.path, results = options.results }
  local study = on_behalf_of(where, "sg.study", make_study, {
    name = options.name, cases = cases_of(x, y), parts = parts, folder = name and name:gsub("%.csv$", "") .. ".cells",
    run = function(case) return solve_cell(parts, case[x.name], case[y.name]) end,
  })
  return setmetatable({ name = options.name, x = x, y = y, cells = {}, by_case = {}, file = name, study = study }, Map)
end

-- ── Cells ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The cell of a case: its result, or its outcome.
local function cell_of(entry, record, map)
  local cell = record.results.cell or { outcome = record.outcome, report = record.traceback or record.reason,
                                        wall = record.wall, results = {} }
  cell.x, cell.y = entry.case[map.x.name], entry.case[map.y.name]
  return cell
end

--- Rebuilds the cells from the study's records, and writes their file.
local function gather(map)
  map.cells, map.by_case = {}, {}
  for i, entry in ipairs(map.study.cases) do
    local record = map.study.records[i]
    map.by_case[i] = record and cell_of(entry, record, map)
    map.cells[#map.cells + 1] = map.by_case[i]
  end
  if map.file then write_file(where, map.file, map) end
end

-- ── Reading (by the user) ────────────────────────────────────────────────────────────────────────────────────────────

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

local function has_converged(cell) return cell ~= nil and cell.outcome == "completed" end

function Map:converged() return #lists.filter(self.cells, has_converged), #self.x.values * #self.y.values end

function Map:table()
  local columns = { self.x.name, self.y.name, "outcome", "reached", "increments", "iterations", "cut-backs",
                    "fallback_steps",
                    "wall" }
  local results, first, formats = values.result_names(self.cells), #columns, { [4] = "%.1f", [9] = "%.2f" }
  for i = 1, #results do formats[first + i] = "%.4g" end
  local rows = lists.map(self.cells, function(cell)
    local row = { cell.x, cell.y, cell.outcome, cell.reached and 100 * cell.reached, cell.increments, cell.iterations,
                  cell.cutbacks, cell.fallback_steps, cell.wall }
    for i, name in ipairs(results) do row[first + i] = cell.results[name] end
    return row
  end)
  return format_table { columns = lists.joined(columns, results), units = { [4] = "%", [9] = "s" }, rows = rows,
                        formats = formats }
end

function Map:csv(name) write_file("map:csv", name, self) end

function Map:report(options) return require "signorini.output.report.map"(self, options) end

function Map:compare(other)
  local result = { recovered = {}, lost = {}, both = 0, neither = 0 }
  for _, y in ipairs(self.y.values) do
    for _, x in ipairs(self.x.values) do
      local here, there = has_converged(self:cell(x, y)), has_converged(other:cell(x, y))
      if here ~= there then
        table.insert(there and result.recovered or result.lost, { x, y })
      else
        local key = here and "both" or "neither"
        result[key] = result[key] + 1
      end
    end
  end
  return result
end

--- The number of converged cells, the table, and the first error, if there was one.
function Map:__tostring()
  local converged, total = self:converged()
  local text = ("%s: %d of %s converged\n%s"):format(self.name, converged, counted(total, "cell"), self:table())
  local lost = lists.filter(self.cells, function(cell) return cell.outcome == "error" end)[1]
  return lost and ("%s\nerror at %s, %s: %s"):format(text, lost.x, lost.y, lost.report) or text
end

--- Raises an error if --on names another place than this machine.
local function check_place()
  if not core.on or core.on == "local" then return end
  core.fail(("%s: --on %s cannot be followed, because the cells of a map are solved on this machine. Hint: leave out "
    .. "--on, and pass on to study:execute for the studies of this script; or make the cells the cases of a study")
    :format(where, core.on))
end

require("signorini.call.methods").guard("map", "cell compare converged csv heatmap picture report table")

return function(options)
  check_place()
  local map = new_map(options)
  if map.file and not is_there(where, map.file, map) then
    write_file(where, map.file, map) -- a file that cannot be written is reported now, not after the first cell
    map.study.fresh = true
  end
  map.study.on_record = function() gather(map) end
  execute(where, map.study, options)
  return map
end
