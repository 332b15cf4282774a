-- Interpolation of the columns of a run between its steps.

local interpolation = {}

local function sign(value) return value > 0 and 1 or value < 0 and -1 or 0 end

--- The slope of a parabola through three points at the middle one, limited so that the curve stays monotone where the
--- points are; s: slopes of the chords before and behind, h: their lengths.
local function inner_slope(s0, s1, h0, h1)
  local p = (s0 * h1 + s1 * h0) / (h0 + h1)
  return (sign(s0) + sign(s1)) * math.min(math.abs(s0), math.abs(s1), 0.5 * math.abs(p))
end

--- Likewise at an end, whose chord is the first one.
local function end_slope(s0, s1, h0, h1)
  local p = s0 * (1 + h0 / (h0 + h1)) - s1 * h0 / (h0 + h1)
  if p * s0 <= 0 then return 0 end
  return math.abs(p) > 2 * math.abs(s0) and 2 * s0 or p
end

--- The slopes at points of which x rises or falls.
local function slopes(x, y)
  local h, s, list, n = {}, {}, {}, #x
  for i = 1, n - 1 do
    h[i] = x[i + 1] - x[i]
    s[i] = (y[i + 1] - y[i]) / h[i]
  end
  if n == 2 then return { s[1], s[1] } end
  list[1], list[n] = end_slope(s[1], s[2], h[1], h[2]), end_slope(s[n - 1], s[n - 2], h[n - 1], h[n - 2])
  for i = 2, n - 1 do list[i] = inner_slope(s[i - 1], s[i], h[i - 1], h[i]) end
  return list
end

--- The interval of a point, the first or the last for points outside.
local function interval(x, at)
  local rising, i = x[2] > x[1], 1
  while i < #x - 1 and (at > x[i + 1]) == rising do i = i + 1 end
  return i
end

--- Values at points of the monotone cubic interpolation of Steffen (Astronomy and Astrophysics 239, 1990, pp. 443–450),
--- which overshoots nowhere; outside straight on. x: rises or falls; y: values there; at: a list.
function interpolation.cubic(x, y, at)
  local slope, values = slopes(x, y), {}
  for k, point in ipairs(at) do
    local i = interval(x, point)
    local h = x[i + 1] - x[i]
    local u = (point - x[i]) / h
    if u < 0 then
      values[k] = y[i] + slope[i] * h * u
    elseif u > 1 then
      values[k] = y[i + 1] + slope[i + 1] * h * (u - 1)
    else
      local v = 1 - u
      values[k] = v * v * ((1 + 2 * u) * y[i] + u * h * slope[i])
        + u * u * ((1 + 2 * v) * y[i + 1] - v * h * slope[i + 1])
    end
  end
  return values
end

--- Values at points of the piecewise linear interpolation.
function interpolation.linear(x, y, at)
  local values = {}
  for k, point in ipairs(at) do
    local i = interval(x, point)
    values[k] = y[i] + (y[i + 1] - y[i]) * (point - x[i]) / (x[i + 1] - x[i])
  end
  return values
end

return interpolation
