-- sg.optimize: the values of parameters at which a result is least while others stay within limits, by sequential
-- quadratic programming in a trust region [theory 12.4].

local core = require "signorini.core"
local descent = require "signorini.inverse.descent"
local goal = require "signorini.inverse.goal"
local lists = require "signorini.call.lists"
local parameters = require "signorini.inverse.parameters"
local progress_file = require "signorini.inverse.progress_file"
local trial = require "signorini.inverse.trial"
local vectors = require "signorini.inverse.vectors"

local where = "sg.optimize"
local dot, difference = vectors.dot, vectors.difference

-- Moves of ln q below this end a search: the result changes by its square.
local smallest = 1e-5
-- Moves that promise less than this part of the result at the start are within its rounding errors.
local negligible = 1e-9
-- Weight of the limits in the quadratic problem, whose square is large next to that of the result, which is 1.
local weight = 1e4
-- Part of sᵀ B s below which the curvature of a move is replaced [Powell 1978].
local least_curvature = 0.2

local function beyond(value, limit) return math.max(0, goal.excess(value, limit)) end

--- A point: `value` (of the result over that at the start), its `slope`, and `results` and `slopes` of the limits over
--- their sizes.
local function point_of(search, z, found)
  local value, slope = goal.evaluate(search, search.least, found)
  search.size = search.size or math.max(math.abs(value), math.sqrt(dot(slope, slope)), 1e-300)
  local point = { z = z, values = found.at, found = found, raw = value, value = value / search.size,
                  slope = lists.map(slope, function(part) return part / search.size end), results = {}, slopes = {} }
  for i, limit in ipairs(search.limits) do
    local result, parts = goal.evaluate(search, limit.name, found)
    point.results[i] = result / limit.size
    point.slopes[i] = lists.map(parts, function(part) return part / limit.size end)
  end
  return point
end

--- The result and what limits are exceeded by, at the prices of the multipliers.
local function merit(search, point)
  local sum = point.value
  for i, limit in ipairs(search.limits) do sum = sum + limit.price * beyond(point.results[i], limit) end
  return sum
end

--- The move d that minimizes gᵀ d + ½ dᵀ B d within limits of d and of c + C d [theory (12.8)]: with B = Σ σ v vᵀ the
--- least squares of √σ v · d + v · g/√σ and of the weighed c + C d − s, s within the limits. Where these leave no room,
--- they are exceeded as little as possible. Sets the multipliers of the limits.
local function move(search, point, low, high)
  local n, found = #search.free, core.singular_values(search.curvature)
  local none = lists.map(search.limits, function() return 0 end)
  local rows, right, inside = {}, {}, {}
  for k, value in ipairs(found.values) do
    rows[k] = lists.joined(lists.map(found.v[k], function(part) return math.sqrt(value) * part end), none)
    right[k] = -dot(found.v[k], point.slope) / math.sqrt(value)
  end
  low, high = lists.joined(low), lists.joined(high)
  for i, limit in ipairs(search.limits) do
    inside[i] = math.max(limit.from, math.min(limit.to, point.results[i]))
    rows[n + i] = lists.joined(lists.map(point.slopes[i], function(part) return weight * part end), none)
    rows[n + i][n + i] = -weight
    right[n + i] = weight * (inside[i] - point.results[i])
    low[n + i], high[n + i] = limit.from - inside[i], limit.to - inside[i]
  end
  local all = core.box_least_squares(vectors.transposed(rows), right, low, high)
  local d = { table.unpack(all, 1, n) }
  local promise = -dot(point.slope, d) - 0.5 * dot(d, lists.map(search.curvature, function(c) return dot(c, d) end))
  for i, limit in ipairs(search.limits) do
    local result = point.results[i] + dot(point.slopes[i], d)
    limit.multiplier = weight ^ 2 * (result - inside[i] - all[n + i])
    limit.price = math.max(2 * math.abs(limit.multiplier), limit.price)
    promise = promise + limit.price * (beyond(point.results[i], limit) - beyond(result, limit))
  end
  return d, promise, promise < negligible
end

--- The slope of the result and of the limits at the prices of their multipliers.
local function slope_of_all(search, point)
  return lists.map(point.slope, function(value, j)
    for i, limit in ipairs(search.limits) do value = value + limit.multiplier * point.slopes[i][j] end
    return value
  end)
end

--- Learns the curvature along a move from `before` to `after`: BFGS, damped where it is small or negative.
local function learn(search, before, after)
  local B = search.curvature
  local s = difference(after.z, before.z)
  local y = difference(slope_of_all(search, after), slope_of_all(search, before))
  local Bs = lists.map(B, function(column) return dot(column, s) end)
  local sBs, sy = dot(s, Bs), dot(s, y)
  if sy < least_curvature * sBs then
    local part = (1 - least_curvature) * sBs / (sBs - sy)
    y = lists.map(y, function(value, j) return part * value + (1 - part) * Bs[j] end)
    sy = dot(s, y)
  end
  search.curvature = lists.map(B, function(column, j)
    return lists.map(column, function(value, i) return value - Bs[i] * Bs[j] / sBs + y[i] * y[j] / sy end)
  end)
end

--- The limits { name, size, from, to (in sizes), multiplier, price } of an argument `where`, sorted by name, without
--- those that limit nothing.
local function read_limits(given)
  local limits = {}
  for _, name in ipairs(lists.sorted_names(given)) do
    local from, to = table.unpack(given[name])
    if not (from <= to) then
      core.fail(("%s: where[\"%s\"] must be {from, to}, got {%g, %g}"):format(where, name, from, to))
    end
    local size = 0
    for _, bound in ipairs { from, to } do
      if math.abs(bound) < math.huge then size = math.max(size, math.abs(bound)) end
    end
    if size == 0 then size = 1 end
    if from > -math.huge or to < math.huge then
      limits[#limits + 1] = { name = name, size = size, from = from / size, to = to / size, multiplier = 0, price = 0 }
    end
  end
  return limits
end

local function descend(search, point, radius)
  local best = point
  return descent({
    name = where, free = search.free, fixed = search.fixed, most = search.runs, smallest = smallest,
    merit = function(at) return merit(search, at) end,
    describe = function(at) return ("%.6g"):format(at.raw) end,
    move = function(at, low, high) return move(search, at, low, high) end,
    accepted = function(at, now)
      learn(search, best, at)
      best = at
      search.file:save(at.values, now)
    end,
    evaluate = function(z)
      local found, why = trial.solve(search, parameters.values(search.free, search.fixed, z))
      if not found then return nil, why end
      return point_of(search, z, found)
    end,
  }, point, radius)
end

return function(search)
  search.caller, search.limits = where, read_limits(search.where or {})
  search.free, search.fixed = parameters.read(where, search.start, search.bounds, search.scale)
  search.file = progress_file.open(search)
  local values, radius = search.file:read(search)
  local found = trial.begin(search, values)
  if type(search.least) == "string" then goal.check(where, "least", search.least, found) end
  for name in pairs(search.where or {}) do goal.check(where, ("where[\"%s\"]"):format(name), name, found) end
  search.curvature = lists.map(search.free, function(_, i)
    return lists.map(search.free, function(_, j) return i == j and 1 or 0 end)
  end)
  local first = point_of(search, parameters.variables(search.free, values), found)
  search.began = first.raw
  local point, reason, tries = descend(search, first, radius)
  -- The multipliers there, as far as the bounds allow a move.
  move(search, point, parameters.room(search.free, point.z, math.huge))
  return require "signorini.inverse.optimum"(search, point, reason, tries)
end
