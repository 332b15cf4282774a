-- Contact profiles and their deviation from a reference inside the contact zone.

local deviation = {}

--- The pressures of a plane profile per current area: p of the profile, in mortar contact, which has pressures per
--- reference area, times dA/da from ds/dS of both neighbors of a point.
function deviation.cauchy_pressures(profile, mortar)
  if not mortar then return profile.pressure end
  local list, last = {}, #profile.x
  for i, pressure in ipairs(profile.pressure) do
    local a, b = math.max(i - 1, 1), math.min(i + 1, last)
    local current = math.sqrt((profile.x[b] - profile.x[a]) ^ 2 + (profile.y[b] - profile.y[a]) ^ 2)
    local reference = math.sqrt((profile.X[b] - profile.X[a]) ^ 2 + (profile.Y[b] - profile.Y[a]) ^ 2)
    list[i] = pressure * reference / current
  end
  return list
end

--- The piecewise linear function through points (x, y) of increasing x, constant beyond its ends.
function deviation.interpolant(x, y)
  return function(at)
    local low, high = 1, #x
    if at <= x[low] then return y[low] elseif at >= x[high] then return y[high] end
    while high - low > 1 do
      local middle = (low + high) // 2
      if x[middle] <= at then low = middle else high = middle end
    end
    return y[low] + (y[high] - y[low]) * (at - x[low]) / (x[high] - x[low])
  end
end

--- The square root of the integral over s of the squared deviation of values at points s from a function
--- reference(s), where |s| <= part (trapezoidal rule).
function deviation.l2(s, values, reference, part)
  local sum, last, before = 0, nil, nil
  for i, place in ipairs(s) do
    if math.abs(place) <= part then
      local d = values[i] - reference(place)
      if last then sum = sum + (place - last) * (d ^ 2 + before ^ 2) / 2 end
      last, before = place, d
    end
  end
  return math.sqrt(sum)
end

return deviation
