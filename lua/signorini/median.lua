-- The median of a list of numbers.

local core = require "signorini.core"
local arguments = require "signorini.arguments"

core.docs["sg.median"] = [[
sg.median(numbers)
The median of a list of numbers: the one in the middle, or the mean of the two.
Example: sg.median{3, 1, 2}  --> 2.0]]
return function(values)
  if type(values) ~= "table" or #values == 0 then
    arguments.reject("sg.median", "its argument", "a list of numbers", values)
  end
  for i, value in ipairs(values) do arguments.number("sg.median", ("its entry %d"):format(i), value) end
  local sorted = table.move(values, 1, #values, 1, {})
  table.sort(sorted)
  return (sorted[(#sorted + 1) // 2] + sorted[#sorted // 2 + 1]) / 2
end
