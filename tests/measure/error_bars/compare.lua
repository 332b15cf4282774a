-- Compares the bars of a solved scene with its errors.

local lists = require "signorini.call.lists"
local terms = require "signorini.errors.terms"

local function largest(list)
  local most = 0
  for _, value in ipairs(list) do most = math.max(most, math.abs(value)) end
  return most
end

local function kind_of(name) return name == "c.area" and "area" or name == "c.max_pressure" and "peak" or "forces" end

local negligible = 1e-6 -- of the largest force of the scene

--- The bars and errors of a solved scene with the program's present limits, a list: { name, what ("forces", "peak",
--- "area"), errors, bars (false where there is none), why (there are none) }.
return function(row)
  local found, force = {}, 0
  for name, values in pairs(row.values) do
    if kind_of(name) == "forces" then force = math.max(force, largest(values)) end
  end
  for _, name in ipairs(lists.sorted_names(row.values)) do
    local values, truth = row.values[name], row.truth[name] or {}
    local radial = name == "grip.fx" and row.kind == "axisymmetric" -- tractions around the axis are no force
    if not radial and (kind_of(name) ~= "forces" or largest(values) > negligible * force) then
      local column = terms.of(name, values, row.records, row.counts, row.tolerance)
      -- as bars.lua marks largest pressures at sharp edges
      local no_limit = row.edge and kind_of(name) == "peak" and column.mesh.order and column.mesh.order <= 1 / 2
      local one = { name = name, what = kind_of(name), errors = {}, bars = {} }
      for i = 1, math.min(#values, #truth) do
        one.errors[i] = math.abs(values[i] - truth[i])
        one.bars[i] = not no_limit and (column.total or {})[i] or false
        if not one.bars[i] then one.why = no_limit and "no limit" or column.mesh.why or "a companion failed" end
      end
      if #one.errors > 0 then found[#found + 1] = one end
    end
  end
  return found
end
