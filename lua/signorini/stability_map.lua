-- sg.stability_map: where over two parameters the solve holds, and where and why it fails. A map is a study: each cell
-- is a case, so that a crash or an endless loop is an outcome like others.

local core = require "signorini.core"
local counted = require "signorini.counted"
local execute = require("signorini.study.execute").execute
local file = require "signorini.stability_map.file"
local format_table = require "signorini.table"
local grid = require "signorini.study.grid"
local lists = require "signorini.lists"
local in_name_of = require "signorini.in_name_of"
local make_study = require("signorini.study").make
local pictures = require "signorini.stability_map.pictures"
local solve_cell = require "signorini.stability_map.cell"
local values = require "signorini.study.values"

local where = "sg.stability_map"

local Map = { picture = pictures.outcomes, figure = pictures.figure }
Map.__index = Map
Map.__name = "stability map"
core.types.map = Map

-- ── Reading the arguments ────────────────────────────────────────────────────────────────────────────────────────────

--- Raises an error unless a parameter can have its name, and each of its values is there once.
local function check_axis(key, axis)
  local seen = {}
  if axis.name == "cell" or lists.holds(values.accounts, axis.name) then -- a case of the study has them for itself
    core.fail(("%s: %s.name cannot be '%s', which every cell has: choose another name"):format(where, key, axis.name))
  end
  for _, value in ipairs(axis.values) do
    if seen[value] then core.fail(("%s: %s.values has %s twice"):format(where, key, core.describe(value))) end
    seen[value] = true
  end
end

--- The cases of the study in the order of the cells: y by y.
local function cases_of(x, y)
  return setmetatable(grid({ [y.name] = y.values }, { [x.name] = x.values }), { parameters = { x.name, y.name } })
end

--- The map before any cell is solved.
local function new_map(options)
  local x, y, name = options.x, options.y, options.file
  check_axis("x", x)
  check_axis("y", y)
  if x.name == y.name then core.fail(("%s: x.name and y.name are both '%s', not two"):format(where, x.name)) end
  local parts = { scene = options.scene, path = options.path, figures = options.figures }
  local study = in_name_of(where, "sg.study", make_study, {
    name = options.name, cases = cases_of(x, y), parts = parts, folder = name and name:gsub("%.csv$", "") .. ".cells",
    run = function(case) return solve_cell(parts, case[x.name], case[y.name]) end,
  })
  return setmetatable({ name = options.name, x = x, y = y, cells = {}, by_case = {}, file = name, study = study }, Map)
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

function Map:held() return #lists.filter(self.cells, is_held), #self.x.values * #self.y.values end

function Map:table()
  local columns = { self.x.name, self.y.name, "outcome", "reached", "increments", "iterations", "cut-backs", "rescues",
                    "wall" }
  local figures, first, formats = values.figure_names(self.cells), #columns, { [4] = "%.1f", [9] = "%.2f" }
  for i = 1, #figures do formats[first + i] = "%.4g" end
  local rows = lists.map(self.cells, function(cell)
    local row = { cell.x, cell.y, cell.outcome, cell.reached and 100 * cell.reached, cell.increments, cell.iterations,
                  cell.cutbacks, cell.rescues, cell.wall }
    for i, name in ipairs(figures) do row[first + i] = cell.figures[name] end
    return row
  end)
  return format_table { columns = lists.joined(columns, figures), units = { [4] = "%", [9] = "s" }, rows = rows,
                        formats = formats }
end

function Map:csv(name) file.write("map:csv", name, self) end

function Map:compare(other)
  local result = { gained = {}, lost = {}, both = 0, neither = 0 }
  for _, y in ipairs(self.y.values) do
    for _, x in ipairs(self.x.values) do
      local here, there = is_held(self:cell(x, y)), is_held(other:cell(x, y))
      if here ~= there then
        table.insert(there and result.gained or result.lost, { x, y })
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
  local lost = lists.filter(self.cells, function(cell) return cell.outcome == "error" end)[1]
  return lost and ("%s\nerror at %s, %s: %s"):format(text, lost.x, lost.y, lost.report) or text
end

return function(options)
  local map = new_map(options)
  if map.file and not file.is_there(where, map.file, map) then
    file.write(where, map.file, map) -- a file that cannot be written shows now, not after the first cell
    map.study.fresh = true
  end
  map.study.on_record = function() gather(map) end
  execute(where, map.study, options)
  return map
end
