-- sg.grid: all combinations of a few parameters' values, as cases of a study.

local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local cut = require("signorini.call.text").cut
local format_table = require("signorini.output.table").text
local lists = require "signorini.call.lists"
local values = require "signorini.study.values"

local most, widest = 20, 40 -- printed cases, and characters of a value

local function shown(cases)
  local names = getmetatable(cases).parameters
  local rows = lists.map({ table.unpack(cases, 1, math.min(most, #cases)) }, function(case)
    return lists.map(names, function(name)
      return type(case[name]) == "number" and case[name] or cut(values.text(case[name]), widest)
    end)
  end)
  local more = #cases > most and ("\n… %d more"):format(#cases - most) or ""
  return ("%s\n%s%s"):format(counted(#cases, "case"), format_table{ columns = names, rows = rows }, more)
end

return function(...)
  -- The order in which the parameters were given is for tables; it is not a parameter itself.
  local cases, names, seen = { {} }, {}, {}
  for _, parameters in ipairs { ... } do
    for _, name in ipairs(lists.sorted_names(parameters)) do
      if seen[name] then core.fail(("sg.grid: the parameter '%s' occurs twice"):format(name)) end
      seen[name], names[#names + 1] = true, name
      local longer = {}
      for _, case in ipairs(cases) do
        for _, value in ipairs(parameters[name]) do
          longer[#longer + 1] = lists.merged(case, { [name] = value })
        end
      end
      cases = longer
    end
  end
  return setmetatable(cases, { parameters = names, __tostring = shown })
end
