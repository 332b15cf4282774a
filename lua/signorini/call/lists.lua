-- Common operations on lists, sets and tables by key.

local lists = {}

--- True if a list contains a value.
function lists.holds(list, value) return lists.any(list, function(known) return known == value end) end

--- The names of a table's entries, sorted.
function lists.sorted_names(entries)
  local names = {}
  for name in next, entries do names[#names + 1] = name end
  table.sort(names)
  return names
end

--- f(entry, place) of each entry; where that is nil, the list has a gap.
function lists.map(list, f)
  local made = {}
  for i = 1, #list do made[i] = f(list[i], i) end
  return made
end

--- The entries for which `keeps` is true.
function lists.filter(list, keeps)
  local kept = {}
  for i = 1, #list do
    if keeps(list[i], i) then kept[#kept + 1] = list[i] end
  end
  return kept
end

--- True if `is` is true for any entry.
function lists.any(list, is)
  for i = 1, #list do
    if is(list[i], i) then return true end
  end
  return false
end

--- The entry with the smallest value(entry), the first of several; entries without such a value are ignored.
function lists.least(list, value)
  local best, least
  for _, entry in ipairs(list) do
    local now = value(entry)
    if now and not (best and now >= least) then best, least = entry, now end
  end
  return best
end

--- The entries of the lists in a list, concatenated.
function lists.flat(all)
  local flat = {}
  for _, list in ipairs(all) do table.move(list, 1, #list, #flat + 1, flat) end
  return flat
end

--- The entries of several lists, concatenated; of one list, a copy.
function lists.joined(...) return lists.flat { ... } end

--- The distinct values, in the order of their first occurrence.
function lists.unique(list)
  local seen = {}
  return lists.filter(list, function(value)
    local is_new = not seen[value]
    seen[value] = true
    return is_new
  end)
end

--- Lists of the entries with equal key(entry), each with its `key`, in the order in which the keys first occur.
function lists.grouped(list, key)
  local groups, by_key = {}, {}
  for i = 1, #list do
    local name = key(list[i])
    if not by_key[name] then
      by_key[name] = { key = name }
      groups[#groups + 1] = by_key[name]
    end
    table.insert(by_key[name], list[i])
  end
  return groups
end

--- The entries of several tables by key; of equal keys the last one.
function lists.merged(...)
  local all = {}
  for _, entries in ipairs { ... } do
    for key, value in next, entries do all[key] = value end
  end
  return all
end

function lists.median(numbers)
  local sorted = lists.joined(numbers)
  table.sort(sorted)
  return (sorted[(#sorted + 1) // 2] + sorted[#sorted // 2 + 1]) / 2
end

--- The length of a list; nil if the value is not a list. `fields`: rows of the names that it may have, too.
function lists.length(value, fields)
  if type(value) ~= "table" then return nil end
  local count = 0
  for key in next, value do
    if not fields or math.type(key) then count = count + 1 end
  end
  return count == rawlen(value) and count or nil
end

--- A list with the entries of the lists in it in their place.
function lists.flattened(list)
  local function is_list(entry) return lists.length(entry) ~= nil end
  if not lists.any(list, is_list) then return list end
  return lists.flat(lists.map(list, function(entry) return is_list(entry) and entry or { entry } end))
end

--- The range { low, high } of each coordinate of points.
function lists.ranges(points)
  return lists.map(points[1], function(_, d)
    local low, high = math.huge, -math.huge
    for _, point in ipairs(points) do low, high = math.min(low, point[d]), math.max(high, point[d]) end
    return { low, high }
  end)
end

return lists
