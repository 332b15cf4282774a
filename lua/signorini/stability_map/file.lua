-- A stability map as a CSV file: all its cells, and a title that says which map's they are.

local in_name_of = require "signorini.in_name_of"
local core = require "signorini.core"
local csv = require "signorini.csv"
local lists = require "signorini.lists"
local figure_names = require("signorini.study.values").figure_names

local file = {}

local columns = { "x", "y", "outcome", "reached", "steps", "increments", "iterations", "cutbacks", "rescues", "wall",
                  "place", "report" }

local function title(map)
  return (("stability map: %s; x: %s; y: %s"):format(map.name, map.x.name, map.y.name):gsub("[\r\n]+", " "))
end

--- Writes a map's cells, one a row, for the function `where`.
function file.write(where, name, map)
  local figures = figure_names(map.cells)
  local rows = lists.map(map.cells, function(cell)
    local row = lists.map(columns, function(column) return cell[column] end)
    for i, figure in ipairs(figures) do row[#columns + i] = cell.figures[figure] end
    return row
  end)
  local heads = lists.joined(columns, lists.map(figures, function(figure) return "figure " .. figure end))
  in_name_of(where, "sg.csv.write", csv.write, name, { columns = heads, rows = rows, comments = { title(map) } })
end

--- Whether there is a file of this map. One of anything else, or with cells that no folder keeps, is an error: it is
--- not overwritten.
function file.is_there(where, name, map)
  if not core.exists(name) then return false end
  local data, folder = in_name_of(where, "sg.csv.read", csv.read, name), map.study.folder
  if data.comments[1] ~= title(map) then
    core.fail(("%s: '%s' holds something else (%s) than this map (%s): remove it, or choose another file")
      :format(where, name, data.comments[1] or "without a title", title(map)))
  end
  if #data.rows > 0 and not core.exists(folder) then
    core.fail(("%s: the cells in '%s' cannot be taken up, because the folder '%s' is not there: bring it back, or "
      .. "remove the file"):format(where, name, folder))
  end
  return true
end

return file
