-- Points of error and time as curves, their Pareto front, and times at equal error.

local joined = require("signorini.lists").joined

local curves = {}

local function before(a, b)
  if a.time ~= b.time then return a.time < b.time end
  return a.error < b.error
end

--- The points, by time; where times are equal, the better one first.
function curves.sorted(points)
  local list = joined(points)
  table.sort(list, before)
  return list
end

--- The points that no other one beats in time or error without being worse in the other; by time.
function curves.front(points)
  local front = {}
  for _, point in ipairs(curves.sorted(points)) do
    local last = front[#front]
    if not last or point.error < last.error then front[#front + 1] = point end
  end
  return front
end

--- The errors that a curve reaches at times that are known: from its least one to that of its cheapest point, which
--- might have been cheaper still at any larger error.
function curves.reach(curve)
  local least = math.huge
  for _, point in ipairs(curve) do least = math.min(least, point.error) end
  return least, curve[1].error
end

--- The least time on the curve, straight between points in both logarithms, at which its error is at most this one; nil
--- beyond its reach.
function curves.time(curve, size)
  local last
  for i, point in ipairs(curve) do
    if point.error == size then return point.time end
    if point.error < size then
      if i == 1 then return nil end
      return last.time * (point.time / last.time) ^ (math.log(last.error / size) / math.log(last.error / point.error))
    end
    last = point
  end
end

--- At equal error, a takes so much of b's time: { from, to, at, ratio }. Without `at`, at the least, the
--- (geometrically) middle and the largest error that both reach; where one of them does not, the ratio is nil. Without
--- errors that both reach there are no from, to and ratios, but why.
function curves.compare(a, b, at)
  local least_a, largest_a = curves.reach(a)
  local least_b, largest_b = curves.reach(b)
  local from, to = math.max(least_a, least_b), math.min(largest_a, largest_b)
  if from > to then
    return { at = at or {}, ratio = {},
             why = ("one reaches %.3g to %.3g, the other %.3g to %.3g"):format(least_a, largest_a, least_b, largest_b) }
  end
  local result = { from = from, to = to, at = at or { from, math.sqrt(from) * math.sqrt(to), to }, ratio = {} }
  for i, size in ipairs(result.at) do
    -- Rounding shall not put the middle of a narrow range beside it.
    local within = at and size or math.max(from, math.min(to, size))
    local time_a, time_b = curves.time(a, within), curves.time(b, within)
    result.ratio[i] = time_a and time_b and time_a / time_b
  end
  return result
end

return curves
