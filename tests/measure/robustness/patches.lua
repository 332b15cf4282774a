-- Patches of generated scenes as plain data: { degrees, knots, points, weights }.

local sg = require "signorini"

local patches = {}

local function data_of(patch)
  local data = { degrees = patch:degrees(), knots = {}, points = patch:points(), weights = patch:weights() }
  for i = 1, #data.degrees do data.knots[i] = patch:knots(i) end
  return data
end
patches.data = data_of

--- A rectangle or a block between two corners.
function patches.box(low, high)
  local size = {}
  for i = 1, #low do size[i] = high[i] - low[i] end
  if #low == 3 then return sg.shapes.block{ size = size, corner = low } end
  return sg.shapes.rectangle{ width = size[1], height = size[2], corner = low }
end

--- The same shape of higher degrees, with further knots of any multiplicity.
function patches.refined(patch, roll, scene)
  for i, degree in ipairs(patch:degrees()) do
    local times = roll.one_of{ 0, 0, 0, 0, 1, 1, 2 }
    if times > 0 then patch = patch:elevate(i, times) end
    local p, spans = degree + times, patch:knots(i)
    if #spans > 2 * p + 2 or roll.uniform(0, 1) < 0.6 then goto next end
    for i_knot = 1, roll.one_of{ 1, 1, 2 } do
      local knots, at = {}, roll.uniform(0.15, 0.85)
      if scene:odd(0.2, "narrow knot span") then at = i_knot == 1 and 1e-7 or 1 - 1e-10 end
      for k = 1, roll.integer(1, p) do knots[k] = at end
      patch = patch:insert(i, knots)
    end
    ::next::
  end
  return patch
end

--- The sizes of the lattice of control points.
local function counts(data)
  local result = {}
  for i, degree in ipairs(data.degrees) do result[i] = #data.knots[i] - degree - 1 end
  return result
end

--- Calls a function with the number and the place in the lattice (from 0 to 1 in each direction) of each point.
local function each_point(data, visit)
  local n, k = counts(data), 0
  for c = 0, (n[3] or 1) - 1 do
    for b = 0, n[2] - 1 do
      for a = 0, n[1] - 1 do
        k = k + 1
        visit(k, { a / (n[1] - 1), b / (n[2] - 1), n[3] and c / (n[3] - 1) or nil })
      end
    end
  end
end

--- A box with other weights, wavy faces, sheared, folded, collapsed, thin or left-handed; `up`: the last direction,
--- along which waves displace; `fixed`: the sides whose shape remains (those that touch at first, or are joined).
function patches.distorted(patch, roll, scene, fixed)
  local data = data_of(patch)
  local up = #data.degrees
  local function free(at)
    for _, side in ipairs(fixed or {}) do
      if math.abs(at[side[1]] - side[2]) < 1e-12 then return false end
    end
    return true
  end
  if roll.uniform(0, 1) < 0.4 then
    local most = scene:odd(0.2, "weights from 0.1 to 10") and 10 or 1.3
    each_point(data, function(k, at)
      local w = roll.decades(1 / most, most)
      if free(at) then data.weights[k] = w end
    end)
  end
  if roll.uniform(0, 1) < 0.4 then
    local high = scene:odd(0.15, "wild waves") and roll.uniform(0.2, 2) or roll.uniform(0, 0.04)
    local phase, length = roll.uniform(0, 6), roll.uniform(2, 9)
    each_point(data, function(k, at)
      local bend = high * math.sin(phase + length * at[1] + (up == 3 and 2 * at[2] or 0))
      if free(at) then data.points[k][up] = data.points[k][up] + bend end
    end)
  end
  if scene:odd(0.05, "folded patch") then
    local a, b = roll.integer(1, #data.points), roll.integer(1, #data.points)
    data.points[a], data.points[b] = data.points[b], data.points[a]
  end
  if scene:odd(0.05, "collapsed side") then
    local direction, side, first = roll.integer(1, up), roll.integer(0, 1), {}
    each_point(data, function(k, at)
      if at[direction] ~= side then return end
      local along = direction == 1 and 2 or 1
      local key = up == 3 and at[6 - direction - along] or 0
      first[key] = first[key] or data.points[k]
      data.points[k] = table.move(first[key], 1, up, 1, {})
    end)
  end
  if scene:odd(0.05, "extreme aspect") then
    local axis, factor = roll.integer(1, up), roll.decades(1e-4, 1e4)
    for _, point in ipairs(data.points) do point[axis] = factor * point[axis] end
  end
  if scene:odd(0.05, "points far away") then
    data.points[roll.integer(1, #data.points)][roll.integer(1, up)] = roll.decades(1, 1e12)
  end
  return data
end

return patches
