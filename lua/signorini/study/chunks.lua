-- Packs the cases of a study into chunks of about equal cost, one per task of a job array.

local lists = require "signorini.call.lists"

local chunks = {}

-- Starting a task costs a scheduler about a second. Several chunks for each task that may run at a time even out
-- differences between estimated and true costs.
local least_seconds, per_slot = 60, 4

--- Consecutive cases, `size` in each chunk.
local function sliced(list, size)
  local result = {}
  for first = 1, #list, size do
    result[#result + 1] = table.move(list, first, math.min(first + size - 1, #list), 1, {})
  end
  return result
end

--- How many chunks: so that one takes from a minute to half of the time limit, and each slot gets several.
local function count_of(total, slots, limit)
  local length = math.max(least_seconds, total / (per_slot * slots))
  return math.ceil(total / math.min(length, limit and limit / 2 or length))
end

--- Longest first, each into the chunk with the least cost so far, which takes at most 4/3 of the shortest time possible
--- (R. L. Graham, SIAM J. Appl. Math. 17, 1969).
local function balanced(list, costs, count)
  local order, place, result, sums = lists.joined(list), {}, {}, {}
  for i, case in ipairs(list) do place[case] = i end
  table.sort(order, function(a, b)
    if costs[a] ~= costs[b] then return costs[a] > costs[b] end
    return place[a] < place[b]
  end)
  for i = 1, count do result[i] = {} end
  for _, case in ipairs(order) do
    local chunk = lists.least(result, function(one) return sums[one] or 0 end)
    chunk[#chunk + 1], sums[chunk] = case, (sums[chunk] or 0) + costs[case]
  end
  return result
end

--- Chunks of a list of cases. seconds(case): its measured cost, or nil, which then counts as the median of the known
--- ones. `options`: size (cases per chunk) or "auto", slots (tasks at a time), limit (seconds of a task, or nil), most
--- (chunks).
function chunks.pack(list, seconds, options)
  if options.size ~= "auto" then return sliced(list, options.size) end
  local costs, known, total = {}, {}, 0
  for _, case in ipairs(list) do known[#known + 1] = seconds(case) end
  for _, case in ipairs(list) do
    costs[case] = seconds(case) or #known > 0 and lists.median(known) or 1
    total = total + costs[case]
  end
  local count = #known > 0 and count_of(total, options.slots, options.limit) or per_slot * options.slots
  return balanced(list, costs, math.max(1, math.min(count, #list, options.most)))
end

return chunks
