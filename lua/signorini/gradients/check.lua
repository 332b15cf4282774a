-- sg.check_gradients: derivatives next to differences of whole runs.

local format_table = require("signorini.output.table").text
local gradients = require "signorini.gradients.gradients"
local lists = require "signorini.call.lists"
local run_path = require "signorini.run.run"
local scene = require "signorini.gradients.scene"
local sizes = require "signorini.gradients.sizes"
local without_warnings = require "signorini.call.without_warnings"

local where = "sg.check_gradients"

local Check = {}
Check.__index = Check
Check.__name = "check of gradients"

--- The columns of a run at other values of the parameters; nil if it has failed.
local function solve(search, values, changed)
  local run = without_warnings(function()
    local made = scene.make(where, search.scene, values, changed)
    return run_path(made.model, made.list,
      lists.merged(made.options, { measure = search.measure or made.options.measure, verbose = false }))
  end)
  return not run.failed and run.values or nil
end

--- The largest difference of slopes and secants over the steps, relative to the largest slope; nan if that is at most
--- `least`.
local function difference(slopes, plus, minus, distance, least)
  local most, size = 0, 0
  for row, slope in ipairs(slopes) do
    most = math.max(most, math.abs((plus[row] - minus[row]) / (2 * distance) - slope))
    size = math.max(size, math.abs(slope))
  end
  return size > least and most / size or -(0 / 0)
end

--- Differences by column and parameter, a column for each distance.
function Check:__tostring()
  local columns, cells, at = { "quantity", "parameter" }, {}, {}
  for _, by in ipairs(self.by) do columns[#columns + 1] = ("± %g"):format(by) end
  for _, row in ipairs(self.rows) do
    local key = row.name .. " " .. row.parameter
    if not at[key] then
      at[key] = { row.name, row.parameter }
      cells[#cells + 1] = at[key]
    end
    table.insert(at[key], row.difference)
  end
  local text = format_table { columns = columns, rows = cells,
                              formats = lists.map(columns, function() return "%.2g" end) }
  text = text .. "\nlargest difference of secants and derivatives, relative to the largest derivative"
  for _, line in ipairs(self.gradients.warnings) do text = text .. "\n" .. line end
  return text
end

return function(search)
  local found = gradients.of(where, search)
  local rows, largest = {}, sizes.largest(found.run, found.results, found.run.model)
  for _, parameter in ipairs(scene.parameters(where, search.at, search.scale)) do
    for _, by in ipairs(search.by) do
      local distance, ends = by * parameter.size, {}
      for k, sign in ipairs { 1, -1 } do
        ends[k] = solve(search, lists.merged(search.at, { [parameter.name] = parameter.at + sign * distance }),
          parameter.name)
      end
      for _, name in ipairs(found.names) do
        rows[#rows + 1] = { name = name, parameter = parameter.name, by = by,
          difference = ends[1] and ends[2] and difference(found:column(name, parameter.name), ends[1][name],
            ends[2][name], distance, sizes.uncertain * largest[sizes.kind_of(name)] / distance) or -(0 / 0) }
      end
    end
  end
  return setmetatable({ gradients = found, rows = rows, by = search.by }, Check)
end
