-- Tangents of models as matrices, and their derivatives by differences of the residual.

local tangents = {}

--- The product of a tangent and a list of numbers.
function tangents.product(tangent, vector)
  local result = {}
  for i = 1, tangent.size do result[i] = 0 end
  for k, value in ipairs(tangent.values) do
    local i = tangent.rows[k]
    result[i] = result[i] + value * vector[tangent.columns[k]]
  end
  return result
end

--- The rows of a tangent.
function tangents.dense(tangent)
  local matrix = {}
  for i = 1, tangent.size do
    matrix[i] = {}
    for j = 1, tangent.size do matrix[i][j] = 0 end
  end
  for k, value in ipairs(tangent.values) do matrix[tangent.rows[k]][tangent.columns[k]] = value end
  return matrix
end

--- The largest entry of K d − (r(u + h d) − r(u − h d))/(2 h), relative to that of K d; the model is rolled back.
function tangents.error(model, h)
  local tangent, d, most, error = model:tangent(), {}, 0, 0
  for i = 1, tangent.size do d[i] = math.sin(7 * i) end
  local function residual_at(part)
    local move = {}
    for i = 1, tangent.size do move[i] = part * d[i] end
    model:move(move)
    return model:residual()
  end
  local product, after = tangents.product(tangent, d), residual_at(h)
  local before = residual_at(-2 * h)
  for i, value in ipairs(product) do
    most, error = math.max(most, math.abs(value)), math.max(error, math.abs(value - (after[i] - before[i]) / (2 * h)))
  end
  model:rollback()
  return error / most
end

return tangents
