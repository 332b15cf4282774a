-- The few lines that print and the prompt show for a patch, a body, a model and a contact profile.

local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local lists = require "signorini.call.lists"

local map, axes = lists.map, { "x", "y", "z" }

local function range_text(name, range) return ("%s %.4g … %.4g"):format(name, range[1], range[2]) end

--- "x 0 … 3, y 0 … 1" of a list of points.
local function box_text(points)
  return table.concat(map(lists.ranges(points), function(range, d) return range_text(axes[d], range) end), ", ")
end

--- "west in y = 0; south in z = 0": the faces in coordinate planes, for plane patches the sides on lines x or y =
--- const; both coordinates of a face that is collapsed to a line.
local function planes_text(patch)
  local tiny, texts = 0, {}
  for _, range in ipairs(lists.ranges(patch:points())) do
    tiny = math.max(tiny, 1e-12 * math.abs(range[1]), 1e-12 * math.abs(range[2]))
  end
  for i, name in ipairs { "west", "east", "south", "north", "front", "back" } do
    if i > 2 * #patch:degrees() then break end
    local parts = {}
    for d, range in ipairs(lists.ranges(patch:face(name):points())) do
      local value = math.abs(range[1]) <= tiny and 0 or range[1]
      if range[2] - range[1] <= tiny then parts[#parts + 1] = ("%s = %.4g"):format(axes[d], value) end
    end
    if #parts > 0 then texts[#texts + 1] = ("%s in %s"):format(name, table.concat(parts, ", ")) end
  end
  return table.concat(texts, "; ")
end

local objects = {}

function objects.patch(patch)
  local text = ("%s\n  control points in %s"):format(patch, box_text(patch:points()))
  local planes = #patch:degrees() > 1 and planes_text(patch) or ""
  return planes == "" and text or ("%s\n  faces: %s"):format(text, planes)
end

function objects.body(body)
  local dofs = body:dofs()
  return ("%s\n  %d degrees of freedom on contact faces, %d in the bulk\n  control points in %s")
    :format(body, dofs.interface, dofs.bulk, box_text(body:points()))
end

--- "grip at x = 0, y = -0.1" for driven supports and loads.
local function driven_text(model, name)
  local values = model:target(name)
  return ("%s at %s"):format(name, table.concat(map(model:driven(name), function(component, i)
    return ("%s = %.4g"):format(component, values[i])
  end), ", "))
end

--- 'method = "mortar", multipliers = "equal", enforcement = "multipliers", penalty = 40 (from material and mesh)'.
local function law_text(law)
  local parts = {}
  for _, key in ipairs { "method", "multipliers", "enforcement", "law" } do
    if law[key] then parts[#parts + 1] = ('%s = "%s"'):format(key, law[key]) end
  end
  for _, key in ipairs { "penalty", "mu", "mu1", "mu2", "friction_penalty", "strength", "energy", "stiffness",
    "shear", "hamaker", "r0" } do
    if law[key] then parts[#parts + 1] = ("%s = %.4g"):format(key:gsub("_", "."), law[key]) end
    if key == "penalty" and law.default_penalty then parts[#parts] = parts[#parts] .. " (from material and mesh)" end
  end
  if law.pressure then parts[#parts + 1] = "pressure = " .. law.pressure end
  if law.mu_formula then parts[#parts + 1] = "mu = " .. law.mu_formula end
  if law.along then
    local words = map(law.along, function(x) return ("%.4g"):format(x) end)
    parts[#parts + 1] = ("along = {%s}"):format(table.concat(words, ", "))
  end
  if law.wear_rate then
    parts[#parts + 1] = ('wear.rate = %s, wear.update = "%s"'):format(law.wear_rate, law.wear_update)
  end
  if law.traction then parts[#parts + 1] = "traction = " .. law.traction end
  if law.bonded then parts[#parts + 1] = counted(law.bonded, "bonded point") end
  if law.offset and law.offset ~= 0 then parts[#parts + 1] = ("offset = %.4g"):format(law.offset) end
  if law.overlap then
    parts[#parts + 1] = ('overlap = "interference", of which %.4g %% is left'):format(100 * law.overlap)
  end
  return table.concat(parts, ", ")
end

--- True if the pressure of a contact is that of the rounding error of its points' positions.
local function is_rounding(model, name, largest, penalty)
  if not penalty then return false end
  local profile, size = model:profile(name), 0
  for _, axis in ipairs(axes) do
    for _, x in ipairs(rawget(profile, axis) or {}) do size = math.max(size, math.abs(x)) end
  end
  return largest <= 1e-12 * penalty * size
end

--- "force {0, 1}", of a set of faces "force on a by b {0, 1}" for each pair of its bodies.
local function forces_text(now)
  local function components(of)
    return table.concat(map(axes, function(axis)
      local part = rawget(of, "f" .. axis)
      return part and ("%.4g"):format(part)
    end), ", ")
  end
  if not rawget(now, "pairs") then return ("force {%s}"):format(components(now)) end
  local names = lists.sorted_names(now.pairs)
  if #names == 0 then return "forces within the body" end
  return table.concat(map(names, function(pair)
    return ("force %s {%s}"):format(pair, components(now.pairs[pair]))
  end), ", ")
end

local function contact_text(model, name)
  local now, constants = model:contact_resultant(name), model:contact_law(name)
  local law = law_text(constants)
  if now.active == 0 then
    return ("  contact %s: %s\n    %s"):format(name, constants.active and "open" or "switched off", law)
  end
  if is_rounding(model, name, now.max_pressure, constants.penalty) then
    return ("  contact %s: touches without a force\n    %s"):format(name, law)
  end
  local text = ("  contact %s: %s, %d slipping; %s, largest pressure %.4g; tractions per %s area")
    :format(name, now.active == 1 and "1 active point" or now.active .. " active points", now.slipping,
      forces_text(now), now.max_pressure, now.per)
  if rawget(now, "debonded") then text = ("%s; debonded %.4g"):format(text, now.debonded) end
  if rawget(now, "imbalance") then text = ("%s; half pass, imbalance %.2g"):format(text, now.imbalance) end
  return ("%s\n    %s"):format(text, law)
end

local function tie_text(model, name)
  local now = model:tie_resultant(name)
  local force = map(axes, function(axis) return now["f" .. axis] and ("%.4g"):format(now["f" .. axis]) end)
  return ("  tie %s: %s of the slave face, at most %.2g apart; force {%s}")
    :format(name, now.part > 0.9995 and "all" or ("%.3g %%"):format(100 * now.part), now.distance,
      table.concat(force, ", "))
end

function objects.model(model)
  local driven = map(model:driven_names(), function(name) return driven_text(model, name) end)
  return table.concat(lists.joined({ tostring(model) },
    map(model:body_names(), function(name) return ("  %s: %s"):format(name, model:body(name)) end),
    #driven > 0 and { "  moved by stages: " .. table.concat(driven, "; ") } or {},
    map(model:contact_names(), function(name) return contact_text(model, name) end),
    map(model:tie_names(), function(name) return tie_text(model, name) end)), "\n")
end

--- True for a result of model:profile, or a table with its lists.
local function is_profile(value)
  local own = getmetatable(value)
  if own and not (type(own) == "table" and own.__name == "contact profile") then return false end
  local needed = { "x", "pressure", "traction", "gap", "state" }
  if lists.any(needed, function(name) return type(rawget(value, name)) ~= "table" end) then return false end
  return #value.pressure > 0 and #value.state == #value.pressure
end

local function profile(value)
  local states = map(lists.grouped(value.state, function(state) return state end), function(group)
    return ("%d %s"):format(#group, group.key)
  end)
  local ranges = map({ "x", "pressure", "traction", "gap" }, function(name)
    local points = map(value[name], function(entry) return { entry } end)
    return range_text(name, lists.ranges(points)[1])
  end)
  return ("contact profile of %s: %s\n  %s\n  lists: %s"):format(counted(#value.pressure, "point"),
    table.concat(states, ", "), table.concat(ranges, ", "), table.concat(lists.sorted_names(value), ", "))
end

--- The text of such an object; nil for other values.
return function(value)
  if type(value) == "table" then return is_profile(value) and profile(value) or nil end
  local own = type(value) == "userdata" and objects[core.kind(value)]
  return own and own(value) or nil
end
