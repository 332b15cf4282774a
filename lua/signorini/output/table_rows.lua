-- The rows of a table with columns, as sg.table and sg.csv.write take them.

local core = require "signorini.core"
local counted = require("signorini.call.text").counted

--- Raises an error if a row of a table has more cells than there are columns.
return function(where, rows, columns)
  for i, row in ipairs(rows) do
    for key in next, row do
      if math.type(key) ~= "integer" or key < 1 or key > #columns then
        core.fail(("%s: rows[%d] has an entry '%s', but there %s %s"):format(where, i, tostring(key),
          #columns == 1 and "is" or "are", counted(#columns, "column")))
      end
    end
  end
end
