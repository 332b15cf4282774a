-- The pictures of a stability map: heat maps of outcomes, and of numbers.

local check = require "signorini.check"
local core = require "signorini.core"
local types = require "signorini.types"
local values = require "signorini.study.values"

local pictures = {}

-- How a cell can end: the reasons of model:run, and what happens to the cell as a whole. Their order is that of the
-- legend, and gives each its color in every picture.
local outcomes = {
  "completed", "stopped", "interrupted", "cut", "iterations", "diverged", "cycling", "lost_projection", "inverted",
  "singular", "indefinite", "nan", "line_search", "penetration", "turning_point", "minimum_step", "strayed",
  "error", "crashed", "time",
}

local formats = { reached = "%.0f%%", wall = "%.1f", steps = "%d", increments = "%d", iterations = "%d",
                  cutbacks = "%d", rescues = "%d" }

--- A number of a cell by its name, an account of the run or one of the user's figures.
local function number(cell, name)
  if not formats[name] then return cell.figures[name] end
  return cell[name] and (name == "reached" and 100 * cell[name] or cell[name])
end

--- value(cell) for all cells as rows from y's first value on; nil where there is no cell or no value.
local function grid(map, value)
  local rows = {}
  for j, y in ipairs(map.y.values) do
    rows[j] = {}
    for i, x in ipairs(map.x.values) do
      local cell = map:cell(x, y)
      rows[j][i] = cell and value(cell)
    end
  end
  return rows
end

--- The numbers of that name, short: accounts as texts, figures as numbers, which heat maps write with powers of ten.
local function texts(map, name)
  return grid(map, function(cell)
    local value = number(cell, name)
    if not value then return nil end
    return formats[name] and formats[name]:format(value) or tonumber(("%.2g"):format(value))
  end)
end

--- The map and the one beside it, with the titles of the two.
local function read_maps(where, map, options)
  if options.beside == nil then return { map } end
  local other = options.beside
  if not values.same({ map.x.values, map.y.values }, { other.x.values, other.y.values }) then
    core.fail(where .. ": beside is a map of other values: both need the same x and y to stand side by side")
  end
  return { map, other }, options.titles or { map.name, other.name }
end

--- Checks the name of something that a picture can show.
local function check_name(where, argument, maps, name)
  local known = { "iterations", "reached", "increments", "steps", "cutbacks", "rescues", "wall" }
  for _, map in ipairs(maps) do
    for _, figure in ipairs(values.figure_names(map.cells)) do known[#known + 1] = figure end
  end
  check.value(types.choice(known), name, where, argument)
end

--- Draws one heat map, or two side by side. `panel(map)` gives what differs: values, texts.
local function draw(chart, maps, titles, panel)
  local map = maps[1]
  chart.x, chart.y, chart.xlabel, chart.ylabel = map.x.values, map.y.values, map.x.name, map.y.name
  if #maps == 1 then
    for key, value in pairs(panel(map)) do chart[key] = value end
  else
    chart.panels = {}
    for i, one in ipairs(maps) do
      chart.panels[i] = panel(one)
      chart.panels[i].title = titles[i]
    end
  end
  core.sg.heatmap(chart)
end

--- The fixed outcomes as categories, and behind them those that only these maps have.
local function categories(maps)
  local list, known = {}, {}
  local function add(name)
    if not known[name] then known[name], list[#list + 1] = true, { name = name } end
  end
  for _, name in ipairs(outcomes) do add(name) end
  for _, map in ipairs(maps) do
    for _, cell in ipairs(map.cells) do add(cell.outcome) end
  end
  return list
end

function pictures.outcomes(map, options)
  local where = "map:picture"
  local maps, titles = read_maps(where, map, options)
  check_name(where, "text", maps, options.text)
  draw({ file = options.file, size = options.size, categories = categories(maps), title = options.title or map.name },
    maps, titles, function(one)
      return { values = grid(one, function(cell) return cell.outcome end), texts = texts(one, options.text) }
    end)
end

function pictures.figure(map, options)
  local where, name = "map:figure", options.name
  local maps, titles = read_maps(where, map, options)
  check_name(where, "name", maps, name)
  local label = options.label or name
  draw({ file = options.file, size = options.size, range = options.range, colormap = options.colormap, label = label,
         log = options.log, title = options.title or map.name .. ": " .. label }, maps, titles, function(one)
    return { values = grid(one, function(cell) return number(cell, name) end), texts = texts(one, name) }
  end)
end

return pictures
