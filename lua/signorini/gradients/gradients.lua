-- sg.gradients: derivatives of all results of a run with respect to parameters of its scene.

local bars = require "signorini.errors.bars"
local check = require "signorini.call.check"
local core = require "signorini.core"
local csv = require "signorini.output.csv"
local format_table = require("signorini.output.table").text
local lists = require "signorini.call.lists"
local named = require "signorini.call.named"
local Neighbors = require "signorini.gradients.neighbors"
local on_behalf_of = require "signorini.call.on_behalf_of"
local run_path = require "signorini.run.run"
local scene = require "signorini.gradients.scene"
local t = require "signorini.call.types"
local without_warnings = require "signorini.call.without_warnings"

local Gradients = {}
Gradients.__index = Gradients
Gradients.__name = "gradients"
core.types.gradients = Gradients
named.strict_type(Gradients, "gradients", "pairs")

-- Residual of the equations of the derivatives above which a warning says so.
local coarse = 1e-5
-- A reach above this tells nothing: slopes hardly hold that far in any case.
local far = 1
-- Share of the contact forces at kinks above which a warning says so.
local noticed = 0.01

-- ── Run ──────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The scenes a step above and below `center`; or false, and the error of one that cannot be made.
local function scenes_around(center, step, where, make, values, name)
  local sides = {}
  for key, sign in pairs { plus = 1, minus = -1 } do
    local value = center + sign * step
    local done, side = pcall(scene.make, where, make, lists.merged(values, { [name] = value }), name)
    if not done then return false, side end
    sides[key], side.value = side, value
  end
  return sides
end

--- The two neighbors on both sides of a value; on one side where the scene does not exist on the other, as with
--- friction that is 0.
local function neighbors_of(where, make, values, run, parameter)
  local step, sides, first = scene.step * parameter.size, nil, nil
  for _, center in ipairs { parameter.at, parameter.at + step, parameter.at - step } do
    local why
    if not sides then sides, why = scenes_around(center, step, where, make, values, parameter.name) end
    first = first or why
  end
  if not sides then error(first, 0) end
  for _, side in pairs(sides) do scene.compare(where, run, side, parameter.name, side.value) end
  return lists.merged(sides, { name = parameter.name, at = parameter.at, size = parameter.size, step = step })
end

local function warnings_of(neighbors, run)
  local texts = {}
  if neighbors:residual() > coarse then
    texts[#texts + 1] = ("derivatives of the states are found to %.1g only: the tangent is close to singular, or "
      .. "rounding errors are large. Hint: sg.check_gradients compares with differences of runs"):format(
      neighbors:residual())
  end
  local heavy = lists.filter(neighbors.kinks, function(kink) return kink.share > noticed end)
  if #heavy > 0 then
    local most = lists.least(heavy, function(kink) return -kink.share end)
    texts[#texts + 1] = ("in %d of %d steps points change between open, stick and slip within a relative change of "
      .. "%g of a parameter, at most with %.2g %% of the contact forces (step %d, %s, contact '%s'): derivatives are "
      .. "means of those on both sides there"):format(#lists.unique(lists.map(heavy, function(kink)
        return kink.step
      end)), run.steps, scene.step, 100 * most.share, most.step, most.parameter, most.contact)
  end
  return texts
end

local function reach_of(neighbors)
  local reach = {}
  for _, pair in ipairs(neighbors.pairs) do reach[pair.name] = pair.reach end
  return reach
end

--- Solves the scene with its neighbors. `search.constant`: parameters without derivatives, by name; `search.is_known`:
--- the scene has been checked; `search.from_start`: columns also have a row 0, the state before the run, those of the
--- run in `start`.
local function solve(where, search)
  local parameters = scene.parameters(where, search.at, search.scale, search.constant)
  local own = scene.make(where, search.scene, search.at)
  local list = without_warnings(function()
    if not search.is_known then scene.check_repeats(where, search.scene, search.at, own) end
    return lists.map(parameters, function(parameter)
      return neighbors_of(where, search.scene, search.at, own, parameter)
    end)
  end)
  local neighbors = Neighbors.new(list, function(pair, text)
    core.fail(("%s: next to %s: %s"):format(where, scene.place(pair.name, pair.at), text))
  end)
  local options = lists.merged(own.options, { measure = search.measure or own.options.measure, neighbors = neighbors })
  local start
  if search.from_start then
    neighbors:record_start(options.measure)
    start = Neighbors.start_of(own.model, own.path, options.measure)
  end
  local run = run_path(own.model, own.list, options)
  return parameters, neighbors, run, own.model, start
end

--- The derivatives of a search { scene, at, of, scale, measure }, whose arguments have been checked.
local function gradients(where, search)
  local parameters, neighbors, run, model, start = solve(where, search)
  local pairs_by_name = {}
  for _, pair in ipairs(neighbors.pairs) do pairs_by_name[pair.name] = pair end
  local results = bars.result_names(run, model)
  for _, name in ipairs(search.of or {}) do check.value(t.choice(results), name, where, "of") end
  local result = setmetatable({
    run = run, start = start, at = lists.merged(search.at),
    parameters = lists.map(parameters, function(one) return one.name end),
    names = search.of or results, results = results, pairs = pairs_by_name, residual = neighbors:residual(),
    reach = reach_of(neighbors), passes = neighbors.passes, kinks = neighbors.kinks,
    warnings = warnings_of(neighbors, run),
  }, Gradients)
  return result
end

-- ── Results ──────────────────────────────────────────────────────────────────────────────────────────────────────────

local function pair_of(self, what, parameter)
  check.value(t.choice(self.parameters), parameter, what, "parameter")
  return self.pairs[parameter]
end

local function slopes(pair, name)
  local plus, minus = pair.plus.record.values[name], pair.minus.record.values[name]
  local list = {}
  for row = 1, pair.plus.record.rows do
    list[row] = plus and (plus[row] - minus[row]) / (2 * pair.step) or -(0 / 0)
  end
  return list
end

function Gradients:column(name, parameter)
  local what = "gradients:column"
  check.value(t.choice(self.results), name, what, "name")
  return slopes(pair_of(self, what, parameter), name)
end

--- Differences of all numbers of two tables of the same form; other values are those of the first.
local function differences(plus, minus, step)
  if type(plus) == "number" then return (plus - minus) / (2 * step) end
  if type(plus) ~= "table" then return plus end
  local all = {}
  for key, value in pairs(plus) do all[key] = differences(value, minus[key], step) end
  return all
end

function Gradients:profile(contact, parameter)
  local pair = pair_of(self, "gradients:profile", parameter)
  local model = core.types.model
  local function profile_of(side)
    return on_behalf_of("gradients:profile", "model:profile", model.profile, side.model, contact)
  end
  local plus, minus = profile_of(pair.plus), profile_of(pair.minus)
  return differences(lists.merged(plus), minus, pair.step)
end

function Gradients:energy(parameter)
  local pair = pair_of(self, "gradients:energy", parameter)
  local model = core.types.model
  return differences(lists.merged(model.energy(pair.plus.model)), model.energy(pair.minus.model), pair.step)
end

function Gradients:csv(file)
  local columns, rows = { "step" }, {}
  for row = 1, self.run.rows do rows[row] = { self.run.values.step[row] } end
  for _, name in ipairs(self.names) do
    columns[#columns + 1] = name
    for row, cells in ipairs(rows) do cells[#columns] = self.run.values[name][row] end
    for _, parameter in ipairs(self.parameters) do
      columns[#columns + 1] = ("d %s / d %s"):format(name, parameter)
      local list = slopes(self.pairs[parameter], name)
      for row, cells in ipairs(rows) do cells[#columns] = list[row] end
    end
  end
  on_behalf_of("gradients:csv", "sg.csv.write", csv.write, file, { columns = columns, rows = rows,
    comments = { self.run.failure } })
end

--- The values at the end of the run, and their change per 1 % of each parameter, or of its scale.
function Gradients:__tostring()
  local row = self.run.rows
  if row == 0 then
    return ("gradients of a run without steps%s"):format(self.run.failure and ": " .. self.run.failure or "")
  end
  local columns, rows = lists.joined({ "quantity", "value" }, self.parameters), {}
  for _, name in ipairs(self.names) do
    local cells = { name, self.run.values[name][row] }
    for _, parameter in ipairs(self.parameters) do
      local pair = self.pairs[parameter]
      cells[#cells + 1] = 0.01 * pair.size * slopes(pair, name)[row]
    end
    rows[#rows + 1] = cells
  end
  local text = format_table { columns = columns, rows = rows } .. ("\nchange per 1 %% of %s, at step %d"):format(
    table.concat(lists.map(self.parameters, function(name) return scene.place(name, self.at[name]) end), ", "),
    self.run.steps)
  local reach = lists.filter(self.parameters, function(name) return self.reach[name] < far end)
  if #reach > 0 then
    text = ("%s\npoints with 1 %% of the contact forces open or begin to slip at a change of %s"):format(text,
      table.concat(lists.map(reach, function(name)
        return ("%s by %.2g %%"):format(name, 100 * self.reach[name])
      end), ", "))
  end
  for _, line in ipairs(self.warnings) do text = text .. "\n" .. line end
  if self.run.reason ~= "completed" then text = ("%s\n%s: %s"):format(text, self.run.reason, self.run.failure) end
  return text
end

require("signorini.call.methods").guard("gradients", "column csv energy profile")

return { gradients = function(search) return gradients("sg.gradients", search) end, of = gradients }
