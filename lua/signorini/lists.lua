-- Small questions to lists and sets.

local lists = {}

--- Whether a list has a value.
function lists.holds(list, value)
  for _, known in ipairs(list) do
    if known == value then return true end
  end
  return false
end

--- The names of a table's entries, sorted.
function lists.sorted_names(entries)
  local names = {}
  for name in pairs(entries) do names[#names + 1] = name end
  table.sort(names)
  return names
end

return lists
