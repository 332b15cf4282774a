-- A stability map as a table and as a file. The file holds what is known; it is written anew, whole, after each cell.

local in_name_of = require "signorini.in_name_of"
local core = require "signorini.core"
local csv = require "signorini.csv"

local store = {}

local columns = { "x", "y", "outcome", "reached", "steps", "increments", "iterations", "cutbacks", "rescues", "wall",
                  "place", "report" }
local prefix = "figure " -- of the columns with the user's figures

--- The names of the figures that any of these cells has, sorted.
function store.figure_names(cells)
  local seen, names = {}, {}
  for _, cell in ipairs(cells) do
    for name in pairs(cell.figures) do
      if not seen[name] then seen[name], names[#names + 1] = true, name end
    end
  end
  table.sort(names)
  return names
end

--- What a file says it is about, so that no cell comes from another map.
local function title(map)
  return ("stability map: %s; x: %s; y: %s"):format(map.name, map.x.name, map.y.name):gsub("[\r\n]+", " ")
end

--- Writes cells to a CSV file, one a row, for the function `where`.
function store.write(where, file, map, cells)
  local data = { columns = table.move(columns, 1, #columns, 1, {}), rows = {}, comments = { (title(map)) } }
  local figures = store.figure_names(cells)
  for i, name in ipairs(figures) do data.columns[#columns + i] = prefix .. name end
  for r, cell in ipairs(cells) do
    local row = {}
    for j, name in ipairs(columns) do row[j] = cell[name] end
    for i, name in ipairs(figures) do row[#columns + i] = cell.figures[name] end
    data.rows[r] = row
  end
  in_name_of(where, "sg.csv.write", csv.write, file, data)
end

local function read_cell(data, row)
  local cell = { figures = {} }
  for j, name in ipairs(data.columns) do
    local figure = name:sub(1, #prefix) == prefix and name:sub(#prefix + 1)
    if figure then cell.figures[figure] = row[j] else cell[name] = row[j] end
  end
  return cell
end

--- The cells that a file holds; none when there is no file yet.
function store.read(file, map)
  if not core.exists(file) then return {} end
  local data, cells = csv.read(file), {}
  if data.comments[1] ~= title(map) then
    core.fail(("sg.stability_map: '%s' holds something else (%s) than this map (%s): remove it, or choose another file")
      :format(file, data.comments[1] or "without a title", (title(map))))
  end
  for i, row in ipairs(data.rows) do cells[i] = read_cell(data, row) end
  return cells
end

return store
