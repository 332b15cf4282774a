-- Geometry of generated scenes by brute force, from their descriptions alone: samples of faces, signed distances,
-- thicknesses, areas. Nothing of the program is used but the evaluation of patches.

local frames = require "robustness.frame"

local geometry = {}

local function difference(a, b)
  local result = {}
  for i = 1, #a do result[i] = a[i] - b[i] end
  return result
end

local function dot(a, b)
  local sum = 0
  for i = 1, #a do sum = sum + a[i] * b[i] end
  return sum
end

local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end

-- ── Samples ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Calls visit(u, inner) with parameters of the face { direction, side } of a patch, the fractions of which are the
--- middles of n intervals (2D) or of n × n of them; inner: whether none of them is the first or the last.
local function each_sample(size, face, n, visit)
  for j = 1, size == 3 and n or 1 do
    for i = 1, n do
      local at, k = {}, 0
      for d = 1, size do
        if d == face[1] then
          at[d] = face[2]
        else
          k = k + 1
          at[d] = ((k == 1 and i or j) - 0.5) / n
        end
      end
      visit(at, i > 1 and i < n and (size == 2 or (j > 1 and j < n)))
    end
  end
end

--- Parameters of fractions in the range of a patch.
local function parameters(patch, at)
  local xi = {}
  for d = 1, #at do
    local knots = patch:knots(d)
    xi[d] = knots[1] + at[d] * (knots[#knots] - knots[1])
  end
  return xi
end
geometry.parameters = parameters

--- Positions of a face and the middles of its chords, the outward normals there, areas and thicknesses of samples.
local function samples(patch, size, face, n)
  -- Patches are right-handed. A face that folds back has one side that is outside all the same.
  local list, sign = {}, (face[2] == 0 and -1 or 1) * (face[1] == 2 and -1 or 1)
  each_sample(size, face, n, function(at, inner)
    local opposite = table.move(at, 1, size, 1, {})
    opposite[face[1]] = 1 - face[2]
    local x = patch:evaluate(parameters(patch, at))
    local tangents, middle = {}, x
    for d = 1, size do
      if d ~= face[1] then
        local ahead, behind = table.move(at, 1, size, 1, {}), table.move(at, 1, size, 1, {})
        ahead[d], behind[d] = at[d] + 0.5 / n, at[d] - 0.5 / n
        local to, from = patch:evaluate(parameters(patch, ahead)), patch:evaluate(parameters(patch, behind))
        tangents[#tangents + 1] = difference(to, from)
        if size == 2 then middle = { (to[1] + from[1]) / 2, (to[2] + from[2]) / 2 } end
      end
    end
    local normal = size == 2 and { tangents[1][2], -tangents[1][1] } or cross(tangents[1], tangents[2])
    local area = math.sqrt(dot(normal, normal))
    for i = 1, size do normal[i] = area > 0 and sign * normal[i] / area or 0 end
    local through = difference(x, patch:evaluate(parameters(patch, opposite)))
    list[#list + 1] = { x = x, middle = middle, normal = normal, area = area, inner = inner,
                        thickness = math.sqrt(dot(through, through)) }
  end)
  return list
end

--- Samples of several faces { body =, face = } of a scene; nil if one of the bodies has several patches.
function geometry.faces(scene, references, n)
  local frame, all = frames.new(scene), {}
  for _, reference in ipairs(references) do
    local body
    for _, one in ipairs(scene.bodies) do
      if one.name == reference.body then body = one end
    end
    if not body or not body.patch then return nil end
    local patch = frame:patch(body.patch, body.name)
    for _, sample in ipairs(samples(patch, scene.space and 3 or 2, frames.faces[reference.face], n)) do
      all[#all + 1] = sample
    end
  end
  return all
end

function geometry.thickness(list)
  local sum = 0
  for _, sample in ipairs(list) do sum = sum + sample.thickness end
  return sum / #list
end

--- What a tenth of a list exceeds: contact points lie between the samples, and may miss a few of them.
local function exceeded(list)
  table.sort(list, function(a, b) return a > b end)
  return list[math.ceil(#list / 10) + 1]
end

-- ── Distances ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The depth which a tenth of a face's samples exceeds behind another face: behind the nearest sample, against its
--- normal, where that sample is not at a border of the face and the point lies straight behind. 0 without any.
function geometry.depth(slave, master)
  local depths = {}
  for _, point in ipairs(slave) do
    local least, nearest = math.huge, nil
    for _, sample in ipairs(master) do
      local way = difference(point.x, sample.x)
      local distance2 = dot(way, way)
      if distance2 < least then least, nearest = distance2, sample end
    end
    local height = dot(difference(point.x, nearest.x), nearest.normal)
    local behind = nearest.inner and height < 0 and height * height > 0.9 * least
    depths[#depths + 1] = behind and -height or 0
  end
  return exceeded(depths)
end

--- The greatest depth of a face's samples in an obstacle of plain data; nil for shapes without a closed form.
function geometry.depth_in(obstacle, slave)
  local depths = {}
  for _, point in ipairs(slave) do
    local height
    if obstacle.shape == "plane" then
      local normal = obstacle.normal
      height = dot(difference(point.x, obstacle.point), normal) / math.sqrt(dot(normal, normal))
    elseif obstacle.shape == "sphere" or (obstacle.shape == "cylinder" and not obstacle.axis) then
      local way = difference(point.x, obstacle.center)
      height = math.sqrt(dot(way, way)) - obstacle.radius
      if obstacle.inside then height = -height end
    else
      return nil
    end
    depths[#depths + 1] = math.max(0, -height)
  end
  return exceeded(depths)
end

return geometry
