-- Vectors as lists of numbers.

local lists = require "signorini.call.lists"

local vectors = {}

function vectors.dot(a, b)
  local sum = 0
  for i, value in ipairs(a) do sum = sum + value * b[i] end
  return sum
end

--- The largest absolute value.
function vectors.norm(a)
  local most = 0
  for _, value in ipairs(a) do most = math.max(most, math.abs(value)) end
  return most
end

--- a + factor b.
function vectors.sum(a, b, factor) return lists.map(a, function(value, i) return value + (factor or 1) * b[i] end) end

function vectors.difference(a, b) return vectors.sum(a, b, -1) end

--- A matrix, a list of rows, as a list of columns.
function vectors.transposed(rows)
  return lists.map(rows[1], function(_, j) return lists.map(rows, function(row) return row[j] end) end)
end

return vectors
