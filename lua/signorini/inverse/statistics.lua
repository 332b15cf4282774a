-- Student's distribution.

local statistics = {}

--- The probability of |t| ≤ √n tan(angle) with n degrees of freedom: Abramowitz and Stegun, (26.7.3), (26.7.4).
local function inside(angle, n)
  local c, sum = math.cos(angle), 0
  local term = n % 2 == 1 and c or 1
  for k = n % 2 == 1 and 3 or 2, n, 2 do -- k − 2 is the power of the cosine
    sum = sum + term
    term = term * c * c * (k - 1) / k
  end
  if n % 2 == 0 then return math.sin(angle) * sum end
  return 2 / math.pi * (angle + math.sin(angle) * sum)
end

--- The t that |t| exceeds with the probability `out`, with n degrees of freedom.
function statistics.student(out, n)
  local low, high = 0, math.pi / 2
  for _ = 1, 60 do
    local middle = (low + high) / 2
    if inside(middle, n) < 1 - out then low = middle else high = middle end
  end
  return math.sqrt(n) * math.tan(low)
end

return statistics
