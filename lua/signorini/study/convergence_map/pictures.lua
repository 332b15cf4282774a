-- The pictures of a convergence map: heat maps of outcomes, and of numbers.

local check = require "signorini.call.check"
local core = require "signorini.core"
local lists = require "signorini.call.lists"
local types = require "signorini.call.types"
local values = require "signorini.study.values"

local pictures = {}

-- The outcomes of a cell: the reasons of model:run, and those of the cell as a whole. Their order is that of the legend
-- and determines the color of each in every picture.
local outcomes = {
  "completed", "stopped", "interrupted", "cut", "iterations", "diverged", "cycling", "lost_projection", "inverted",
  "singular", "indefinite", "nan", "line_search", "turning_point", "minimum_step", "left_path",
  "error", "crashed", "time", "crossed", "friction_exhausted",
}

local formats = { reached = "%.0f%%", wall = "%.1f", steps = "%d", increments = "%d", iterations = "%d",
                  cutbacks = "%d", fallback_steps = "%d" }

--- A number of a cell by its name: an account of the run, or one of the user's results.
local function number(cell, name)
  if not formats[name] then return cell.results[name] end
  return cell[name] and (name == "reached" and 100 * cell[name] or cell[name])
end

--- value(cell) for all cells as rows from y's first value on; nil if there is no cell or no value.
local function grid(map, value)
  return lists.map(map.y.values, function(y)
    return lists.map(map.x.values, function(x)
      local cell = map:cell(x, y)
      return cell and value(cell)
    end)
  end)
end

--- The numbers of that name, short: accounts as text, results as numbers, which heat maps write with powers of ten.
local function texts(map, name)
  return grid(map, function(cell)
    local value = number(cell, name)
    if not value then return nil end
    return formats[name] and formats[name]:format(value) or tonumber(("%.2g"):format(value))
  end)
end

--- The map and the one next to it, with the titles of the two.
local function read_maps(where, map, options)
  if options.other == nil then return { map }, {} end
  local other = options.other
  if not values.same({ map.x.values, map.y.values }, { other.x.values, other.y.values }) then
    core.fail(where .. ": other must be a map of the same values of x and y")
  end
  return { map, other }, options.titles or { map.name, other.name }
end

local function cells_of(maps)
  return lists.flat(lists.map(maps, function(map) return map.cells end))
end

local function check_name(where, argument, maps, name)
  local known = { "iterations", "reached", "increments", "steps", "cutbacks", "fallback_steps", "wall" }
  check.value(types.choice(lists.joined(known, values.result_names(cells_of(maps)))), name, where, argument)
end

--- Draws one heat map, or two side by side. `panel(map)` gives what differs: values, texts.
local function draw(chart, maps, titles, panel)
  local map = maps[1]
  chart.x, chart.y, chart.xlabel, chart.ylabel = map.x.values, map.y.values, map.x.name, map.y.name
  local panels = lists.map(maps, function(one, i) return lists.merged(panel(one), { title = titles[i] }) end)
  return core.sg.heatmap(lists.merged(chart, #maps == 1 and panels[1] or { panels = panels }))
end

--- The fixed outcomes as categories, followed by those that only these maps have.
local function categories(maps)
  local met = lists.map(cells_of(maps), function(cell) return cell.outcome end)
  return lists.map(lists.unique(lists.joined(outcomes, met)), function(name) return { name = name } end)
end

function pictures.outcomes(map, options)
  local where = "map:picture"
  local maps, titles = read_maps(where, map, options)
  check_name(where, "text", maps, options.text)
  return draw({ file = options.file, size = options.size, categories = categories(maps),
                title = options.title or map.name }, maps, titles, function(one)
      return { values = grid(one, function(cell) return cell.outcome end), texts = texts(one, options.text) }
    end)
end

function pictures.heatmap(map, options)
  local where, name = "map:heatmap", options.name
  local maps, titles = read_maps(where, map, options)
  check_name(where, "name", maps, name)
  local label = options.label or name
  return draw({ file = options.file, size = options.size, range = options.range, colormap = options.colormap,
                label = label, log = options.log, title = options.title or map.name .. ": " .. label }, maps, titles,
    function(one)
      return { values = grid(one, function(cell) return number(cell, name) end), texts = texts(one, name) }
    end)
end

return pictures
