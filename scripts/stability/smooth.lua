-- Difference of a curve from its smooth part.

local smooth = {}

--- Solves the least-squares problem min |A c − b| of columns A by the Gram–Schmidt process, twice because of
--- rounding error, and returns the residual b − A c.
local function rest(columns, b)
  local left = table.move(b, 1, #b, 1, {})
  local function take_off(vector, unit)
    local projection = 0
    for i, value in ipairs(unit) do projection = projection + value * vector[i] end
    for i, value in ipairs(unit) do vector[i] = vector[i] - projection * value end
  end
  local units = {}
  for _, column in ipairs(columns) do
    for _ = 1, 2 do
      for _, unit in ipairs(units) do take_off(column, unit) end
    end
    local norm = 0
    for _, value in ipairs(column) do norm = norm + value ^ 2 end
    for i, value in ipairs(column) do column[i] = value / math.sqrt(norm) end
    units[#units + 1] = column
    take_off(left, column)
  end
  return left
end

--- The root mean square of the values at points x in [0, 1) minus their best fit by an ellipse √(1 − x²) and a
--- parabola 1 − x²; nil for fewer than four points.
function smooth.rest_of_hump(x, values)
  if #x < 4 then return nil end
  local ellipse, parabola = {}, {}
  for i, place in ipairs(x) do ellipse[i], parabola[i] = math.sqrt(1 - place ^ 2), 1 - place ^ 2 end
  local sum = 0
  for _, value in ipairs(rest({ ellipse, parabola }, values)) do sum = sum + value ^ 2 end
  return math.sqrt(sum / #x)
end

return smooth
