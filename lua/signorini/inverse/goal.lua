-- What a search for an optimum looks at: numbers of a run at its end, and their derivatives.

local check = require "signorini.call.check"
local lists = require "signorini.call.lists"
local parameters = require "signorini.inverse.parameters"
local Run = require "signorini.run.run_result"
local t = require "signorini.call.types"

local goal = {}

--- The record of a neighbor as a run, for functions of the user.
local function as_run(run, side)
  return setmetatable(lists.merged(run, { model = side.model, names = side.record.names, values = side.record.values,
                                          rows = side.record.rows, recorders = {} }), Run)
end

local function number_of(where, of, run)
  if type(of) == "string" then return run.values[of][run.rows] end
  local value = of(run)
  if type(value) ~= "number" or value ~= value or math.abs(value) == math.huge then
    check.reject(where, "the result of least", "a finite number", value)
  end
  return value
end

--- By how much a value exceeds a limit { from, to }; negative within it.
function goal.excess(value, limit) return math.max(limit.from - value, value - limit.to) end

--- Checks that a column has derivatives.
function goal.check(where, key, name, found) check.value(t.choice(found.results), name, where, key) end

--- The number, and its derivatives by the variables of a search. `of`: a column, or a function of a run.
function goal.evaluate(search, of, found)
  local slopes = lists.map(search.free, function(one)
    local pair = found.pairs[one.name]
    local above = number_of(search.caller, of, as_run(found.run, pair.plus))
    local below = number_of(search.caller, of, as_run(found.run, pair.minus))
    return (above - below) / (2 * pair.step) * parameters.rate(one, found.at)
  end)
  return number_of(search.caller, of, found.run), slopes
end

return goal
