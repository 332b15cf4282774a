-- model:cost: sizes of a model: unknowns, elements, contact points, matrix entries, memory.

local format_table = require("signorini.output.table").text
local lists = require "signorini.call.lists"

local Cost = {}
Cost.__index = Cost
Cost.__name = "cost"

--- "1.25 MB".
local function bytes_text(bytes)
  for _, unit in ipairs { "bytes", "kB", "MB" } do
    if bytes < 1000 then return (unit == "bytes" and "%d %s" or "%.3g %s"):format(bytes // 1 | 0, unit) end
    bytes = bytes / 1000
  end
  return ("%.3g GB"):format(bytes)
end

local function bodies_text(cost)
  local total = { "all", 0, 0, 0, 0, 0, 0 }
  local rows = lists.map(lists.sorted_names(cost.bodies), function(name)
    local body = cost.bodies[name]
    local row = { name, body.unknowns, body.bulk, body.interface, body.prescribed, body.elements, body.gauss_points }
    for k = 2, #total do total[k] = total[k] + row[k] end
    return row
  end)
  return format_table { rows = lists.joined(rows, { total }),
    columns = { "body", "unknowns", "bulk", "contact faces", "prescribed", "elements", "Gauss points" } }
end

local function contacts_text(cost)
  return format_table { columns = { "contact", "points", "master" },
    rows = lists.map(lists.sorted_names(cost.contacts), function(name)
      local contact = cost.contacts[name]
      return { name, contact.points, contact.rigid and "rigid obstacle, no unknowns" or "body" }
    end) }
end

--- The tables, then a line on the linear system and the memory.
function Cost:__tostring()
  local parts = { bodies_text(self) }
  if next(self.contacts) then parts[#parts + 1] = contacts_text(self) end
  local of = self.memory_of
  parts[#parts + 1] = ("%d nonzeros in the tangent; memory %s: bodies %s, contacts %s, tangent %s, factors "
    .. "(%s, %s) %s"):format(self.nonzeros, bytes_text(self.memory), bytes_text(of.bodies), bytes_text(of.contacts),
      bytes_text(of.tangent), self.linear, self.factors_are, bytes_text(of.factors))
  return table.concat(parts, "\n")
end

--- The method model:cost; `figures` reads the numbers from a model.
return function(figures)
  return function(model) return setmetatable(figures(model), Cost) end
end
