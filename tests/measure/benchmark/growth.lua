-- Growth of a cost: the exponent a of cost ~ size^a.

local growth = {}

--- Slope of the least-squares line through (log size, log cost) over the larger half of the sizes, which are given in
--- increasing order: of five the last three, of four the last two. nil if fewer than two positive costs remain.
function growth.exponent(sizes, costs)
  local xs, ys, mean_x, mean_y = {}, {}, 0, 0
  for i = #sizes // 2 + 1, #sizes do
    if costs[i] and costs[i] > 0 then
      xs[#xs + 1], ys[#ys + 1] = math.log(sizes[i]), math.log(costs[i])
      mean_x, mean_y = mean_x + xs[#xs], mean_y + ys[#ys]
    end
  end
  if #xs < 2 then return nil end
  mean_x, mean_y = mean_x / #xs, mean_y / #xs
  local above, below = 0, 0
  for i, x in ipairs(xs) do
    above, below = above + (x - mean_x) * (ys[i] - mean_y), below + (x - mean_x) ^ 2
  end
  return above / below
end

return growth
