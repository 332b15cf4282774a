-- The file of a search, which holds the best values so far, so that a search that has ended early can go on.

local core = require "signorini.core"
local json = require "signorini.output.json"
local lists = require "signorini.call.lists"
local on_behalf_of = require "signorini.call.on_behalf_of"

local File = {}
File.__index = File

--- The file of the argument `checkpoint` of a search.
function File.open(search)
  if search.resume and not search.checkpoint then
    core.fail(search.caller .. ": resume = true needs the file to go on from. Hint: checkpoint = \"<name>.json\"")
  end
  return setmetatable({ name = search.checkpoint, caller = search.caller }, File)
end

--- The values to begin with, and the radius of the trust region, if they are known.
function File:read(search)
  local values = lists.merged(search.start)
  if not (search.resume and core.exists(self.name)) then return values end
  local what = ("%s: checkpoint '%s'"):format(self.caller, self.name)
  local held = on_behalf_of(what, ("sg.json.read: '%s'"):format(self.name), json.read, self.name)
  local is_whole = type(held) == "table" and rawget(held, "search") == self.caller and type(held.values) == "table"
    and type(held.radius) == "number" and held.radius > 0
  if not is_whole or lists.any(lists.sorted_names(held.values), function(name)
    return type(held.values[name]) ~= "number"
  end) then
    core.fail(("%s is not that of such a search"):format(what))
  end
  local names, own = lists.sorted_names(held.values), lists.sorted_names(values)
  if table.concat(names, ", ") ~= table.concat(own, ", ") then
    core.fail(("%s has the parameters %s, start has %s"):format(what, table.concat(names, ", "),
      table.concat(own, ", ")))
  end
  for _, one in ipairs(search.free) do values[one.name] = held.values[one.name] end
  return values, held.radius
end

--- Saves values that are the best so far.
function File:save(values, radius)
  if not self.name then return end
  local text = core.write_json({ search = self.caller, values = values, radius = radius }, self.caller, true)
  on_behalf_of(self.caller, "core.write_output", core.write_output, self.name, text, "json")
end

return File
