-- Lists of patches, as the shapes of several patches and sg.nurbs.read return them: motions of all patches at once.

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local methods = require "signorini.call.methods"

local Patches = { __name = "list of patches" }
Patches.__index = Patches
core.types.patch_list = Patches

--- The list with f(patch) in place of each patch; faces of interfaces and boundaries by renamed(name, number).
local function moved(list, f, renamed)
  local result = lists.map(list, f)
  local function faces(names)
    return lists.map(names, function(name)
      local number, face = name:match "^(%d+)%.(.+)$"
      return renamed and number and ("%s.%s"):format(number, renamed(face, tonumber(number))) or name
    end)
  end
  result.interfaces = list.interfaces and lists.map(list.interfaces, faces)
  if list.boundaries then
    result.boundaries = {}
    for name, names in pairs(list.boundaries) do result.boundaries[name] = faces(names) end
  end
  return setmetatable(result, Patches)
end

for _, key in ipairs { "translate", "rotate", "scale" } do
  Patches[key] = function(self, ...)
    local given = table.pack(...)
    return moved(self, function(patch) return patch[key](patch, table.unpack(given, 1, given.n)) end)
  end
end

local faces = { { "west", "east" }, { "south", "north" }, { "front", "back" } }

--- The parametric direction that the mirror image of a patch has reversed; nil if none.
local function reversed_direction(patch, image, values)
  local normal, origin = values.normal, values.point
  local function product(a, b)
    local sum = 0
    for c = 1, #normal do sum = sum + a[c] * b[c] end
    return sum
  end
  local size = 0
  local images = lists.map(patch:points(), function(x)
    local from = lists.map(normal, function(_, c) return x[c] - (origin and origin[c] or 0) end)
    local twice = 2 * product(from, normal) / product(normal, normal)
    return lists.map(normal, function(n, c)
      size = math.max(size, math.abs(x[c]))
      return x[c] - twice * n
    end)
  end)
  for d = 1, #patch:degrees() do
    local same = true
    for i, x in ipairs(image:reverse(d):points()) do
      for c = 1, #normal do same = same and math.abs(x[c] - images[i][c]) <= 1e-9 * size end
    end
    if same then return d end
  end
end

function Patches.mirror(self, values)
  local names = {} -- of faces whose direction is reversed, by patch
  local function image_of(patch, i)
    local image = patch:mirror(values)
    local pair = faces[reversed_direction(patch, image, values)]
    names[i] = pair and { [pair[1]] = pair[2], [pair[2]] = pair[1] } or {}
    return image
  end
  local function renamed(face, number) return names[number] and names[number][face] or face end
  return moved(self, image_of, renamed)
end

methods.guard("patch_list", "mirror rotate scale translate")

return Patches
