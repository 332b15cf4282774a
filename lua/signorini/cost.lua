-- model:cost: what a model is made of, in numbers.

local core = require "signorini.core"
local format_table = require "signorini.table"
local sorted_names = require("signorini.lists").sorted_names

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
  local rows, total = {}, { "all", 0, 0, 0, 0, 0, 0 }
  for i, name in ipairs(sorted_names(cost.bodies)) do
    local body = cost.bodies[name]
    rows[i] = { name, body.unknowns, body.bulk, body.contact_layer, body.prescribed, body.elements, body.gauss_points }
    for k = 2, #total do total[k] = total[k] + rows[i][k] end
  end
  rows[#rows + 1] = total
  return format_table {
    columns = { "body", "unknowns", "bulk", "contact faces", "prescribed", "elements", "Gauss points" }, rows = rows,
  }
end

local function contacts_text(cost)
  local rows = {}
  for i, name in ipairs(sorted_names(cost.contacts)) do
    local contact = cost.contacts[name]
    rows[i] = { name, contact.points, contact.rigid and "rigid obstacle, no unknowns" or "body" }
  end
  return format_table { columns = { "contact", "points", "master" }, rows = rows }
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

core.docs["model:cost"] = [[
model:cost()
What a model is made of, before a solve or after it; print(model:cost()) shows it as tables.
cost.unknowns:   of the linear system; obstacles (cost.obstacles, how many) have none.
cost.bodies:     by name { unknowns, contact_layer, bulk, prescribed, elements, gauss_points }: contact_layer are the
                 unknowns on the faces that `contact` names, bulk all others, prescribed what supports fix or drive.
cost.contacts:   by name { points, rigid }: contact points, and whether the master is an obstacle.
cost.nonzeros:   of the tangent; it grows where contacts touch.
cost.memory:     bytes, the sum of cost.memory_of { bodies, contacts, tangent, factors }: tables of Gauss points,
                 contact points with their history, the tangent with its patterns, its factors by the solver
                 cost.linear. cost.factors_are is "measured" once a solver has told, before that "counted": from the
                 pattern in the order of nested dissection.
Example: print(model:cost())]]
return function(model) return setmetatable(core.types.model.cost_figures(model), Cost) end
