-- Frames in which a generated scene is described: turned, moved, mirrored, in other units, with other directions of the
-- patches, other names. Forces in all of them are the same except for the frame, which `forces_back` undoes.

local sg = require "signorini"

local Frame = {}
Frame.__index = Frame

local axes = { "x", "y", "z" }
local faces = { west = { 1, 0 }, east = { 1, 1 }, south = { 2, 0 }, north = { 2, 1 }, front = { 3, 0 },
                back = { 3, 1 } }
local face_names = { { [0] = "west", "east" }, { [0] = "south", "north" }, { [0] = "front", "back" } }

local function identity(size)
  local rows = {}
  for i = 1, size do
    rows[i] = {}
    for j = 1, size do rows[i][j] = i == j and 1 or 0 end
  end
  return rows
end

local function determinant(m)
  if #m == 2 then return m[1][1] * m[2][2] - m[1][2] * m[2][1] end
  return m[1][1] * (m[2][2] * m[3][3] - m[2][3] * m[3][2]) - m[1][2] * (m[2][1] * m[3][3] - m[2][3] * m[3][1])
    + m[1][3] * (m[2][1] * m[3][2] - m[2][2] * m[3][1])
end

--- A frame of a scene. `options`: matrix (an orthogonal one), shift (after the matrix, in the scene's unit of length),
--- length and stress (the scene's units in those of the frame), directions (per body: { order, flips }, the old
--- direction of each new one, and whether it runs backwards), renamed, swapped (slaves and masters).
local function frame(scene, options)
  options = options or {}
  local self = setmetatable({}, Frame)
  self.space, self.size = scene.space, scene.space and 3 or 2
  self.matrix = options.matrix or identity(self.size)
  self.sign = determinant(self.matrix) < 0 and -1 or 1
  self.shift = options.shift
  self.length, self.stress = options.length or 1, options.stress or 1
  self.directions, self.renamed, self.swapped = options.directions, options.renamed, options.swapped
  self.solid = scene.space or scene.kind == "axisymmetric" -- forces are not per depth
  return self
end

-- ── Points and vectors ───────────────────────────────────────────────────────────────────────────────────────────────

--- M v
function Frame:direction(v)
  local result = {}
  for i = 1, self.size do
    local sum = 0
    for j = 1, self.size do
      if self.matrix[i][j] == 1 then sum = sum + v[j]
      elseif self.matrix[i][j] ~= 0 then sum = sum + self.matrix[i][j] * v[j] end
    end
    result[i] = sum
  end
  return result
end

function Frame:scaled(v, factor)
  local result = self:direction(v)
  for i = 1, #result do result[i] = factor * result[i] end
  return result
end

--- A displacement.
function Frame:vector(v) return self:scaled(v, self.length) end

function Frame:point(x)
  local result = self:direction(x)
  for i = 1, #result do result[i] = self.length * (result[i] + (self.shift and self.shift[i] or 0)) end
  return result
end

--- The point of the scene at a place of the frame, also of symbols.
function Frame:back(...)
  local x, result = { ... }, {}
  for i = 1, self.size do x[i] = x[i] / self.length - (self.shift and self.shift[i] or 0) end
  for j = 1, self.size do
    local sum
    for i = 1, self.size do
      if self.matrix[i][j] ~= 0 then
        local part = self.matrix[i][j] * x[i]
        sum = sum and sum + part or part
      end
    end
    result[j] = sum
  end
  return result
end

--- The axis along which an axis of the scene lies, if it lies along one, and the direction.
function Frame:axis(j)
  for i = 1, self.size do
    if math.abs(math.abs(self.matrix[i][j]) - 1) < 1e-15 then return i end
  end
end

--- Components such as "xz", sorted.
function Frame:components(text)
  if not text or #text == self.size then return text end
  local held, result = {}, ""
  for j = 1, self.size do
    if text:find(axes[j], 1, true) then held[self:axis(j)] = true end
  end
  for i = 1, self.size do result = result .. (held[i] and axes[i] or "") end
  return result
end

--- The values of the driven components `text`, of which `values` are those of the scene, in order.
function Frame:driven(text, values, factor)
  local full, k, result = {}, 0, {}
  for j = 1, self.size do
    full[j] = 0
    if text:find(axes[j], 1, true) then
      k = k + 1
      full[j] = values[k]
    end
  end
  local turned, held = self:scaled(full, factor or self.length), self:components(text)
  for i = 1, self.size do
    if held:find(axes[i], 1, true) then result[#result + 1] = turned[i] end
  end
  return result
end

--- Stiffnesses of springs along the axes.
function Frame:stiffness(values, factor)
  local result = {}
  for j = 1, self.size do result[self:axis(j)] = values[j] * factor end
  return result
end

--- The axis of a rotation.
function Frame:pseudo(v) return self.sign < 0 and self:scaled(v, -1) or self:direction(v) end

-- ── Units ────────────────────────────────────────────────────────────────────────────────────────────────────────────

function Frame:force() return self.stress * self.length ^ (self.solid and 2 or 1) end

-- ── Patches ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A body, an obstacle or a load of the scene under its name here; sorted differently if renamed.
function Frame:name(name)
  if not self.renamed then return name end
  return string.char(219 - name:byte()) .. name:sub(2) .. "_"
end

local makers = { "curve", "surface", "volume" }

local function made(data)
  local count = #data.degrees
  local single = count == 1
  return sg.nurbs[makers[count]]{
    [single and "degree" or "degrees"] = single and data.degrees[1] or data.degrees,
    knots = single and data.knots[1] or data.knots, points = data.points, weights = data.weights,
  }
end

--- A patch of plain data.
function Frame:patch(data, body)
  local points = {}
  for i, point in ipairs(data.points) do points[i] = self:point(point) end
  local patch = made{ degrees = data.degrees, knots = data.knots, weights = data.weights, points = points }
  if self.sign < 0 then patch = patch:reverse(1) end
  for _, change in ipairs(self:changes(body)) do
    patch = change[2] and patch:swap(change[1], change[2]) or patch:reverse(change[1])
  end
  return patch
end

--- What is done to the directions of a body, in order: { i } reverses, { i, j } exchanges.
function Frame:changes(body) return self.directions and self.directions[body] or {} end

--- Where a direction and a side of a patch end up.
function Frame:side(body, direction, side)
  if self.sign < 0 and direction == 1 then side = 1 - side end
  for _, change in ipairs(self:changes(body)) do
    local i, j = change[1], change[2]
    if j then
      direction = direction == i and j or direction == j and i or direction
    elseif direction == i then
      side = 1 - side
    end
  end
  return direction, side
end

--- The name of a face, an edge or a corner, such as "south-west".
function Frame:place(body, name)
  local found = {}
  for part in name:gmatch "%a+" do
    local direction, side = self:side(body, table.unpack(faces[part]))
    found[#found + 1] = { direction, face_names[direction][side] }
  end
  table.sort(found, function(a, b) return a[1] < b[1] end)
  for i, entry in ipairs(found) do found[i] = entry[2] end
  return table.concat(found, "-")
end

--- Entries per direction in the frame's directions; `kept`: the directions that they belong to (default: all).
function Frame:per_direction(body, list, kept)
  if type(list) ~= "table" then return list end
  local entries = {}
  for k, entry in ipairs(list) do
    local old = kept and kept[k] or k
    local direction, flipped = self:side(body, old, 0)
    entries[k] = { direction, entry, flipped == 1 }
  end
  table.sort(entries, function(a, b) return a[1] < b[1] end)
  local result = {}
  for k, entry in ipairs(entries) do
    local value = entry[2]
    if entry[3] and type(value) == "table" then value = { 1 - value[2], 1 - value[1] } end
    result[k] = value
  end
  return result
end

return { new = frame, faces = faces, face_names = face_names }
