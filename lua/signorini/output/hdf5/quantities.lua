-- What the arrays of a run's HDF5 file hold: quantity, text and unit of columns, profiles, resultants and energies.

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local meant = require("signorini.call.text").meant

local quantities = {}

--- Units that do not depend on those of the script.
local own_units = { count = "1", time = "s", angle = "degree" }
local unknown_unit = "consistent units"

--- All quantities; users give units for those that have none of their own.
local all = { "angle", "area", "count", "energy", "force", "force_per_volume", "length", "moment", "stress", "time" }

-- { quantity, text } by the key of a value of a point, a resultant, an energy or a column.
local of_key = {
  step = { "count", "number of the step; a state between steps has a fraction" },
  increments = { "count", "increments of the step" },
  iterations = { "count", "Newton iterations of the step, with failed attempts" },
  wall = { "time", "wall time of the step, with failed attempts" },
  angle = { "angle", "rotation of the support" }, moment = { "moment", "moment about the center or the axis" },
  area = { "area", "area in contact; with mortar contact and adhesion the reference area" },
  inside = { "count", "1 in the contact area, 0 outside" },
  pressure = { "stress", "pressure, positive in compression" },
  traction = { "stress", "tangential traction" },
  factor = { "count", "factor of the values of a function" },
  max_pressure = { "stress", "largest pressure" },
  mean_pressure = { "stress", "largest mean pressure over a slave element" },
  max_penetration = { "length", "largest penetration" },
  gap = { "length", "normal gap, negative where a point penetrates" },
  jump = { "length", "distance by which the tied faces have moved apart" },
  mu = { "count", "coefficient of friction" },
  worn = { "length", "depth of wear" }, worn_volume = { "volume", "volume that has been worn off" },
  wear = { "energy", "work that wear has taken along so far" },
  slip = { "length", "slip since the touch; of a contact its mean over the points that touch" },
  damage = { "count", "fraction of its stiffness that the bond has lost, 1 without a bond" },
  mix = { "count", "share of shear in the energy that the bond has dissipated" },
  debonded = { "area", "new surface: energy dissipated by bonds over energy of separation" },
  state = { "count", "state of the point, an index into the list `states` from 0" },
  active = { "count", "points that touch" }, slipping = { "count", "points that slip" },
  unsettled = { "count", "closest points not found so far" },
  crossed = { "count", "points that have passed through the master since the accepted state" },
  imbalance = { "count", "difference of the forces of the two half passes, relative" },
  weighted_penetration = { "length", "largest weighted penetration of the multipliers" },
  part = { "count", "tied fraction of the slave face" },
  distance = { "length", "largest distance of the tied faces in the reference shape" },
  stored = { "energy", "strain energy" }, contact = { "energy", "energy of penalty springs and bonds, or of adhesion" },
  friction = { "energy", "dissipated by friction so far" },
  debonding = { "energy", "dissipated by bonds so far" },
  work = { "energy", "work of supports, loads and offsets so far" },
  wear = { "energy", "energy that wear has taken along so far" },
  viscous = { "energy", "work of the stresses that relax so far" },
  area_growth = { "energy", "energy of the springs times the growth of their area so far" },
}
for _, axis in ipairs { "x", "y", "z" } do
  of_key[axis] = { "length", "current position, " .. axis }
  of_key[axis:upper()] = { "length", "reference position, " .. axis }
  of_key["f" .. axis] = { "force", "force, " .. axis }
  of_key["u" .. axis] = { "length", "displacement of the support, " .. axis }
  of_key["t" .. axis] = { "stress", "traction, " .. axis }
  of_key["b" .. axis] = { "force_per_volume", "force per reference volume, " .. axis }
  of_key["p" .. axis] = { "force", "force on corners, or per length of edges, " .. axis }
end

local forces = { support = "force of the support on its bodies", load = "force of the load",
                 contact = "force on the slave" }

--- The column whose error bars a column holds; nil for other columns.
local function column_of_error(name) return name:match "^(.*)%.error$" end

--- True for the name of a column of error bars.
function quantities.is_error(name) return column_of_error(name) ~= nil end

--- What a column of a model's run holds: { quantity, text }; nil for one that a function of the user has returned.
function quantities.of_column(model, name)
  if of_key[name] and not name:find "%." then return of_key[name] end
  local whole = column_of_error(name)
  if whole then
    local about = quantities.of_column(model, whole)
    return { about and about[1], ("error bar of %s; nan where it is unknown"):format(whole) }
  end
  local owner, key = name:match "^(.*)%.([^.]*)$"
  local kind = owner and (lists.holds(model:support_names(), owner) and "support"
    or lists.holds(model:load_names(), owner) and "load" or lists.holds(model:contact_names(), owner) and "contact")
  local about = kind and of_key[key]
  if not about then return nil end
  local axis = key:match "^f([xyz])$"
  return axis and { "force", ("%s, %s"):format(forces[kind], axis) } or about
end

--- What the value of this key holds: { quantity, text }.
function quantities.of(key) return of_key[key] or {} end

--- The unit of a quantity; `name`: of a column, which may have a unit of its own.
function quantities.unit(units, quantity, name)
  return units[name] or units[quantity] or own_units[quantity] or unknown_unit
end

--- Refuses units of names that are neither quantities nor columns. `open`: on_step may return further columns.
function quantities.check(where, units, columns, open)
  for _, name in ipairs(lists.sorted_names(units)) do
    if not (open or lists.holds(all, name) or lists.holds(columns, name)) then
      local known = lists.joined(all, columns)
      core.fail(("%s: units: '%s' is neither a quantity nor a column of the run%s; quantities are %s"):format(where,
        name, meant(name, known), table.concat(all, ", ")))
    end
  end
end

return quantities
