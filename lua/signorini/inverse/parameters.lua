-- Parameters that a search changes, as variables z in which moves are measured: the logarithm of a parameter that stays
-- above 0, otherwise the parameter over its size.

local core = require "signorini.core"
local lists = require "signorini.call.lists"

local parameters = {}

-- Part of the start below which a lower bound is as good as 0, which factors do not reach.
local near_zero = 1e-3

--- The bounds of a parameter, which are infinite where the user gives none.
local function bounds_of(where, name, start, given)
  local low, high = table.unpack(given or { -math.huge, math.huge })
  if not (low <= high) then
    core.fail(("%s: bounds.%s must be {low, high}, got {%g, %g}"):format(where, name, low, high))
  end
  if start < low or start > high then
    core.fail(("%s: start.%s = %g is not within its bounds %g to %g"):format(where, name, start, low, high))
  end
  return low, high
end

--- The parameters that are free, sorted by name, as { name, size, is_log, low, high (of z), limits (of the
--- value) }, and those that bounds fix as values by name.
function parameters.read(where, start, bounds, scale)
  for key, names in pairs { bounds = bounds or {}, scale = scale or {} } do
    for name in pairs(names) do
      if start[name] == nil then
        core.fail(("%s: %s.%s: start has no parameter of this name"):format(where, key, name))
      end
    end
  end
  local free, fixed = {}, {}
  for _, name in ipairs(lists.sorted_names(start)) do
    local value, given = start[name], (bounds or {})[name]
    local low, high = bounds_of(where, name, value, given)
    if low == high then
      fixed[name] = value
    else
      -- Without bounds, a parameter that starts above 0 stays there. A bound far below the start means 0.
      local is_log = value > 0 and (not given or low > near_zero * value)
      local range = high - low
      local size = (scale or {})[name] or not is_log and range < math.huge and range / 2 or math.abs(value)
      if size == 0 then
        core.fail(("%s: start.%s is 0, which has no size of its own. Hint: scale = { %s = 0.1 }, with a typical value")
          :format(where, name, name))
      end
      local function z(bound) return is_log and math.log(math.max(bound, 0)) or bound / size end
      free[#free + 1] = { name = name, size = size, is_log = is_log, low = z(low), high = z(high),
                          limits = { low, high } }
    end
  end
  if #free == 0 then
    core.fail(("%s: %s. Hint: give at least one parameter room in bounds"):format(where,
      next(start) and "all parameters are fixed by their bounds" or "start is empty"))
  end
  return free, fixed
end

--- The variables of values.
function parameters.variables(free, values)
  return lists.map(free, function(one)
    return one.is_log and math.log(values[one.name]) or values[one.name] / one.size
  end)
end

--- The value of a parameter at its variable, within its bounds.
function parameters.value(one, z)
  if z <= one.low then return one.limits[1] end
  if z >= one.high then return one.limits[2] end
  return one.is_log and math.exp(z) or z * one.size
end

--- The values at variables, with those that are fixed.
function parameters.values(free, fixed, z)
  local values = lists.merged(fixed)
  for j, one in ipairs(free) do values[one.name] = parameters.value(one, z[j]) end
  return values
end

--- The sizes of those that may be 0, by name.
function parameters.scale(free)
  local scale = {}
  for _, one in ipairs(free) do scale[one.name] = not one.is_log and one.size or nil end
  return scale
end

--- The limits of a move from z: the bounds, and `radius` in each direction.
function parameters.room(free, z, radius)
  return lists.map(free, function(one, j) return math.max(one.low - z[j], -radius) end),
    lists.map(free, function(one, j) return math.min(one.high - z[j], radius) end)
end

--- dq/dz of a parameter at values.
function parameters.rate(one, values) return one.is_log and values[one.name] or one.size end

--- The free parameters of values in words: "E = 1.02, mu = 0.31".
function parameters.text(free, values)
  return table.concat(lists.map(free, function(one) return ("%s = %.5g"):format(one.name, values[one.name]) end), ", ")
end

return parameters
