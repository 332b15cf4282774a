-- Where contacts have touched during a run: boxes of reference positions on the slave faces.

local lists = require "signorini.call.lists"

local zone = {}

local axes = { "X", "Y", "Z" }
local margin = 0.1 -- of the largest side of a box
local least = 3 -- distances between contact points, so that one that touches alone has a part of its element

--- The distance of points i and j of a profile; infinite without a point j.
local function apart(profile, i, j)
  local sum = 0
  for _, axis in ipairs(axes) do
    local values = rawget(profile, axis)
    if values and not values[j] then return math.huge end
    sum = sum + (values and (values[i] - values[j]) ^ 2 or 0)
  end
  return math.sqrt(sum)
end

--- Extends boxes, { low = {…}, high = {…}, spacing } by contact, to the points of a model that are not open.
function zone.extend(boxes, model)
  for _, name in ipairs(model:contact_names()) do
    local profile, box = model:profile(name), boxes[name] or { low = {}, high = {}, spacing = 0 }
    for i, state in ipairs(profile.state) do
      local nearest = state ~= "open" and math.min(apart(profile, i, i - 1), apart(profile, i, i + 1)) or 0
      if nearest < math.huge then box.spacing = math.max(box.spacing, nearest) end
    end
    for d, axis in ipairs(axes) do
      for i, value in ipairs(rawget(profile, axis) or {}) do
        if profile.state[i] ~= "open" then
          box.low[d] = math.min(box.low[d] or value, value)
          box.high[d] = math.max(box.high[d] or value, value)
        end
      end
    end
    boxes[name] = #box.low > 0 and box or nil
  end
end

--- The options of a run that also extends `boxes` after each step.
function zone.watched(options, model, boxes)
  local given = options and options.on_step
  return lists.merged(options or {}, { on_step = function(...)
    zone.extend(boxes, model)
    if given then return given(...) end
  end })
end

--- How far the layer of a box extends beyond it.
local function reach(box)
  local size = 0
  for d, low in ipairs(box.low) do size = math.max(size, box.high[d] - low) end
  return math.max(margin * size, least * box.spacing)
end

--- True if the points from `low` to `high` are within a box with its margin.
local function covers(box, low, high)
  for d, least in ipairs(box.low) do
    if low[d] < least - reach(box) or high[d] > box.high[d] + reach(box) then return false end
  end
  return true
end

--- True if `inner` boxes are within `boxes` with their margins.
function zone.contains(boxes, inner)
  for name, box in pairs(inner) do
    if not (boxes[name] and covers(boxes[name], box.low, box.high)) then return false end
  end
  return true
end

--- The smallest boxes that contain two of them.
function zone.union(boxes, others)
  local result = lists.merged(boxes, {})
  for name, box in pairs(others) do
    local own = boxes[name] or box
    result[name] = { spacing = math.max(box.spacing, own.spacing),
                     low = lists.map(box.low, function(low, d) return math.min(low, own.low[d]) end),
                     high = lists.map(box.high, function(high, d) return math.max(high, own.high[d]) end) }
  end
  return result
end

--- The boxes with a margin as `layer` of sg.body takes them, by contact.
function zone.layers(boxes)
  local layers = {}
  for name, box in pairs(boxes) do layers[name] = function(X) return covers(box, X, X) end end
  return layers
end

--- "ground: X from 0 to 0.058, Y from -1 to -0.998; …".
function zone.text(boxes)
  return table.concat(lists.map(lists.sorted_names(boxes), function(name)
    local box = boxes[name]
    return ("%s: %s"):format(name, table.concat(lists.map(box.low, function(low, d)
      return ("%s from %.4g to %.4g"):format(axes[d], low, box.high[d])
    end), ", "))
  end), "; ")
end

return zone
