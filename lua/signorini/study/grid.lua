-- sg.grid: all combinations of a few parameters' values, as cases of a study.

local core = require "signorini.core"
local arguments = require "signorini.arguments"
local counted = require "signorini.counted"
local cut = require "signorini.cut"
local format_table = require "signorini.table"
local values = require "signorini.study.values"

local where = "sg.grid"
local most, widest = 20, 40 -- cases and characters of a value that print shows

--- The names and lists of one table of parameters, sorted by name.
local function read_axes(name, axes)
  if type(axes) ~= "table" or next(axes) == nil then
    arguments.reject(where, name, "a table of lists such as { order = {\"N2\", \"N4\"} }", axes)
  end
  local sorted = {}
  for key, list in pairs(axes) do
    if type(key) ~= "string" then
      core.fail(("%s: %s has an entry without a name: write parameter = { its values }"):format(where, name))
    end
    if type(list) ~= "table" or #list == 0 then arguments.reject(where, key, "a list of values", list) end
    for i, value in ipairs(list) do
      local finite = type(value) ~= "number" or value == value and math.abs(value) < math.huge
      if type(value) == "function" or type(value) == "userdata" or not finite then
        arguments.reject(where, ("%s[%d]"):format(key, i),
          "a finite number, a string, true, false or a plain table", value)
      end
    end
    sorted[#sorted + 1] = { name = key, values = list }
  end
  table.sort(sorted, function(a, b) return a.name < b.name end)
  return sorted
end

--- How many cases, and the first ones as rows of a table.
local function shown(cases)
  local names, rows = getmetatable(cases).parameters, {}
  for i = 1, math.min(most, #cases) do
    rows[i] = {}
    for j, name in ipairs(names) do
      local value = cases[i][name]
      rows[i][j] = type(value) == "number" and value or cut(values.text(value), widest)
    end
  end
  local more = #cases > most and ("\n… %d more"):format(#cases - most) or ""
  return ("%s\n%s%s"):format(counted(#cases, "case"), format_table{ columns = names, rows = rows }, more)
end

core.docs["sg.grid"] = [[
sg.grid{ order = {"N2", "N4"}, mesh = {"m1", "m2"} }
All combinations of the parameters' values, as a list of cases for sg.study. Values are numbers, strings, true, false or
plain tables; a table shows by its field `name`, or as 6×2. The parameters stand in the order of their names, the last
one changes fastest; several tables, sg.grid({ order = … }, { mesh = … }), put them in this order instead. print shows
the cases as a table.
Example: #sg.grid{ order = {"N2", "N4"}, mesh = {1, 2, 3} }  --> 6]]
return function(...)
  local axes, seen = {}, {}
  for i = 1, math.max(1, select("#", ...)) do
    for _, axis in ipairs(read_axes(("argument %d"):format(i), (select(i, ...)))) do
      if seen[axis.name] then core.fail(("%s: the parameter '%s' is there twice"):format(where, axis.name)) end
      seen[axis.name], axes[#axes + 1] = true, axis
    end
  end
  local cases = { {} }
  for _, axis in ipairs(axes) do
    local longer = {}
    for _, case in ipairs(cases) do
      for _, value in ipairs(axis.values) do
        local copy = { [axis.name] = value }
        for key, known in pairs(case) do copy[key] = known end
        longer[#longer + 1] = copy
      end
    end
    cases = longer
  end
  -- The order in which the parameters were given, for tables; it is no parameter itself.
  local names = {}
  for i, axis in ipairs(axes) do names[i] = axis.name end
  return setmetatable(cases, { parameters = names, __tostring = shown })
end
