-- Which tables are lists.

local lists = require "signorini.call.lists"

local list_shape = {}

--- The length of a list; nil if the value is not a list. `fields`: rows of the names that it may have, too.
function list_shape.length(value, fields)
  if type(value) ~= "table" then return nil end
  local count = 0
  for key in next, value do
    if not fields or math.type(key) then count = count + 1 end
  end
  return count == rawlen(value) and count or nil
end

--- A list with the entries of the lists in it in their place.
function list_shape.flattened(list)
  local function is_list(entry) return list_shape.length(entry) ~= nil end
  if not lists.any(list, is_list) then return list end
  return lists.flat(lists.map(list, function(entry) return is_list(entry) and entry or { entry } end))
end

return list_shape
