-- The few lines that print and the prompt show of a patch, a body, a model and a contact profile.

local core = require "signorini.core"
local counted = require "signorini.counted"

local axes = { "x", "y", "z" }

local function range_text(name, values)
  local low, high = math.huge, -math.huge
  for _, value in ipairs(values) do low, high = math.min(low, value), math.max(high, value) end
  return ("%s %.4g … %.4g"):format(name, low, high)
end

--- "x 0 … 3, y 0 … 1" of a list of points.
local function box_text(points)
  local parts = {}
  for d = 1, #points[1] do
    local values = {}
    for i, point in ipairs(points) do values[i] = point[d] end
    parts[d] = range_text(axes[d], values)
  end
  return table.concat(parts, ", ")
end

--- "west in y = 0; south in z = 0": the faces that lie in coordinate planes, of plane patches the sides on lines x or
--- y = const; both coordinates of a face that is collapsed to a line.
local function planes_text(patch)
  local points, size = patch:points(), 0
  for _, point in ipairs(points) do
    for _, x in ipairs(point) do size = math.max(size, math.abs(x)) end
  end
  local texts = {}
  for i, name in ipairs { "west", "east", "south", "north", "front", "back" } do
    if i > 2 * #patch:degrees() then break end
    local face, parts = patch:face(name):points(), {}
    for d = 1, #points[1] do
      local low, high = math.huge, -math.huge
      for _, point in ipairs(face) do low, high = math.min(low, point[d]), math.max(high, point[d]) end
      local value = math.abs(low) <= 1e-12 * size and 0 or low
      if high - low <= 1e-12 * size then parts[#parts + 1] = ("%s = %.4g"):format(axes[d], value) end
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

--- "grip at x = 0, y = -0.1" for what stages move.
local function driven_text(model, name)
  local components, values = model:driven(name), model:target(name)
  for i, component in ipairs(components) do components[i] = ("%s = %.4g"):format(component, values[i]) end
  return ("%s at %s"):format(name, table.concat(components, ", "))
end

local function contact_text(model, name)
  local now, force = model:contact_resultant(name), {}
  if now.active == 0 then return ("  contact %s: open"):format(name) end
  for i, axis in ipairs(axes) do force[i] = now["f" .. axis] and ("%.4g"):format(now["f" .. axis]) end
  return ("  contact %s: %s, %d of them slip; force {%s}, largest pressure %.4g")
    :format(name, now.active == 1 and "1 point touches" or now.active .. " points touch", now.slipping,
      table.concat(force, ", "), now.max_pressure)
end

function objects.model(model)
  local lines, driven = { tostring(model) }, {}
  for _, name in ipairs(model:body_names()) do lines[#lines + 1] = ("  %s: %s"):format(name, model:body(name)) end
  for i, name in ipairs(model:driven_names()) do driven[i] = driven_text(model, name) end
  if #driven > 0 then lines[#lines + 1] = "  moved by stages: " .. table.concat(driven, "; ") end
  for _, name in ipairs(model:contact_names()) do lines[#lines + 1] = contact_text(model, name) end
  return table.concat(lines, "\n")
end

--- Whether a table is what model:profile returns, or has its lists.
local function is_profile(value)
  local own = getmetatable(value)
  if own and not (type(own) == "table" and own.__name == "contact profile") then return false end
  for _, name in ipairs { "x", "pressure", "traction", "gap", "state" } do
    if type(rawget(value, name)) ~= "table" then return false end
  end
  return #value.pressure > 0 and #value.state == #value.pressure
end

local function profile(value)
  local counts, parts = {}, {}
  for _, state in ipairs(value.state) do
    if not counts[state] then parts[#parts + 1] = state end
    counts[state] = (counts[state] or 0) + 1
  end
  for i, state in ipairs(parts) do parts[i] = ("%d %s"):format(counts[state], state) end
  local ranges, names = {}, {}
  for name in pairs(value) do names[#names + 1] = name end
  table.sort(names)
  for i, name in ipairs { "x", "pressure", "traction", "gap" } do ranges[i] = range_text(name, value[name]) end
  return ("contact profile of %s: %s\n  %s\n  lists: %s"):format(counted(#value.pressure, "point"),
    table.concat(parts, ", "), table.concat(ranges, ", "), table.concat(names, ", "))
end

--- The text of such an object; nothing of other values.
return function(value)
  if type(value) == "table" then return is_profile(value) and profile(value) or nil end
  local own = type(value) == "userdata" and objects[core.kind(value)]
  return own and own(value) or nil
end
