-- How well data determine parameters: confidence intervals of a fit from its derivatives [theory (12.7)].

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local parameters = require "signorini.inverse.parameters"
local statistics = require "signorini.inverse.statistics"
local dot = require("signorini.inverse.vectors").dot

local intervals = {}

-- The probability of a value outside of its interval.
local outside = 0.05
-- Half width of the interval of ln q above which the data do not determine q: a factor of e.
local unknown = 1
-- Rounding errors of singular values, in parts of the largest.
local rounding = 1e-12

--- Error bars of the results, in parts of the weights; nil without any.
local function weighed_bars(search)
  if not search.bars then return nil end
  return lists.map(lists.flat(search.bars), function(bar, i) return bar / search.weights[i] end)
end

--- What the data say about the parameters with these numbers: { half (widths), of_solution (the part of these from
--- error bars), correlation } by position in the list. `vague`: positions of those that the data do not determine; they
--- count as known to a factor of e, by a further equation each.
local function analyze(search, point, list, scatter, vague)
  local t, errors = statistics.student(outside, #point.residuals - #list), weighed_bars(search) or {}
  local columns = lists.map(list, function(j) return lists.joined(point.columns[j]) end)
  for _, position in ipairs(vague) do
    local row = #columns[1] + 1
    for a, column in ipairs(columns) do column[row] = a == position and t * scatter / unknown or 0 end
  end
  local found = core.singular_values(columns)
  local values = lists.map(found.values, function(value) return math.max(value, rounding * found.values[1]) end)
  local function covariance(a, b)
    local sum = 0
    for k, value in ipairs(values) do sum = sum + found.v[k][a] * found.v[k][b] / value ^ 2 end
    return sum
  end
  local result = { half = {}, of_solution = {}, correlation = {} }
  for a in ipairs(list) do
    local shift = 0
    for k, value in ipairs(values) do shift = shift + found.v[k][a] * dot(errors, found.u[k]) / value end
    result.of_solution[a] = math.abs(shift)
    result.half[a] = t * scatter * math.sqrt(covariance(a, a)) + math.abs(shift)
    result.correlation[a] = lists.map(list, function(_, b)
      return covariance(a, b) / math.sqrt(covariance(a, a) * covariance(b, b))
    end)
  end
  return result
end

--- The position of the widest half width that tells nothing, without those in a list; nil if there is none.
local function least_known(half, without)
  local widest
  for a, value in ipairs(half) do
    local tells = value < 0.999 * unknown or lists.holds(without, a) -- less than what is assumed of the others
    if not tells and not (widest and half[widest] > value) then widest = a end
  end
  return widest
end

--- Of a point: { scatter, names (of the parameters with intervals), intervals, half (widths, of variables),
--- correlation, of_solution, by name; undetermined, at_bounds (names) }. A parameter that the data do not determine has
--- no interval; those of the others hold as long as it changes by no more than a factor of e.
function intervals.of(search, point)
  local result = { names = {}, intervals = {}, half = {}, correlation = {}, of_solution = {}, undetermined = {},
                   at_bounds = {} }
  local inner, vague = {}, {}
  for j, one in ipairs(search.free) do
    local is_inside = point.z[j] > one.low and point.z[j] < one.high
    table.insert(is_inside and inner or result.at_bounds, is_inside and j or one.name)
  end
  result.scatter = math.sqrt(math.max(point.merit / (#point.residuals - #inner), search.rounding))
  if #inner == 0 then return result end
  local found, widest
  repeat
    vague[#vague + 1] = widest
    found = analyze(search, point, inner, result.scatter, vague)
    widest = least_known(found.half, vague)
  until not widest
  for a, j in ipairs(inner) do
    local one = search.free[j]
    local name = one.name
    if lists.holds(vague, a) then
      table.insert(result.undetermined, name)
    else
      table.insert(result.names, name)
      result.half[name], result.of_solution[name] = found.half[a], search.bars and found.of_solution[a] or nil
      result.intervals[name] = { parameters.value(one, point.z[j] - found.half[a]),
                                parameters.value(one, point.z[j] + found.half[a]) }
    end
    result.correlation[name] = {}
    for b, other in ipairs(inner) do
      result.correlation[name][search.free[other].name] = found.correlation[a][b]
    end
  end
  return result
end

return intervals
