-- Types of arguments that depend on a patch: that on which a method is called, or the argument `patch` of the same
-- call.

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local t = require "signorini.call.types"

local patch_types = {}

--- The numbers of parametric directions and coordinates of the patch of a call, the first one of a list; nil if there
--- is none.
local function sizes(owner, given)
  local patch = owner or given and given.patch
  if type(owner) == "table" then patch = owner[1] end
  if patch and core.kind(patch) == "patch" then return core.patch_sizes(patch) end
end

--- A face of the object on which a method is called; the core rejects others and suggests the most similar one.
patch_types.face = t.name(function(owner) return core.place_names(owner, 1) end, "face name")
patch_types.edge = t.name(function(body) return core.place_names(body, 2) end, "edge name")
patch_types.corner = t.name(function(body) return core.place_names(body, 0) end, "corner name")

--- A face of any object.
patch_types.any_face = t.name(core.place_names(nil, 1), "face name")

local directions = { t.only(1), t.integer(1, 2), t.integer(1, 3) }

--- A parametric direction.
patch_types.direction = t.by(t.integer(1, 3), function(patch) return directions[sizes(patch)] end)

--- One of two directions.
patch_types.one_of_two = t.by(t.integer(1, 3), function(patch)
  return sizes(patch) > 1 and directions[sizes(patch)] or nil
end)

local coordinate_names = { "", " {xi1, xi2}", " {xi1, xi2, xi3}" }

--- Lists with one entry per direction; for a curve also the entry itself.
local function per_direction(of, endings)
  local list = {}
  for count = 1, 3 do
    list[count] = { kind = "list", of = of, size = count, single = count == 1, ending = endings[count] }
  end
  local general = { kind = "list", of = of, ending = endings[2] }
  return t.by(general, function(owner, given)
    local count, dimension = sizes(owner, given)
    if not owner and count ~= dimension then return nil end -- not a body's shape, which is the better message
    return list[count]
  end, t.one_or_more(of))
end

--- One entry per direction.
function patch_types.per_direction(of)
  local ending = ", one per direction"
  return per_direction(of, { "", ending, ending })
end

--- Coordinates of a point in the parameters.
patch_types.parameters = per_direction(t.number, coordinate_names)

--- A point or vector in the plane of the patch, or in its space.
patch_types.vector = t.by(t.point, function(owner, given)
  local _, dimension = sizes(owner, given)
  return dimension == 2 and t.plane_point or t.space_point
end)

--- One positive factor for all coordinates, or a list with one for each.
patch_types.factor = t.by(t.either(t.positive, t.point), function(patch)
  return t.either(t.positive, patch_types.vector.special(patch))
end)

--- A vector; a plane patch lies in z = 0.
patch_types.vector_or_space = t.by(t.point, function(owner, given)
  local _, dimension = sizes(owner, given)
  return dimension == 3 and t.space_point or nil
end)

patch_types.elements = patch_types.per_direction(t.integer(1, 1000000))

local places = t.list(t.text, nil, 1)

--- Several patches: a list with interfaces and boundaries, faces such as "2.north".
patch_types.several = t.worded(t.list_with(t.object "patch", {
  { "interfaces", t.list(t.worded(t.list(t.text, 2), "a list of two faces such as '1.east'")), "faces on each other",
    optional = true },
  { "boundaries", t.map(places), "faces by name", optional = true },
}), "a list of one or more patches")

--- Several patches, or a single one without braces, which becomes a list of one.
patch_types.one_or_several = lists.merged(patch_types.several, { single = true })

patch_types.degree = t.integer(1, core.max_degree)

local below_one = { kind = "number", above = 0, below = 1 }

--- Where elements are graded.
patch_types.grading = patch_types.per_direction(t.either(t.named {
  { "elements", below_one, "fraction of the elements" },
  { "length", below_one, "fraction of the knot length that they fill" },
  { "at", t.choice { "start", "end" }, "the end with the small elements" },
}, t.only(false)))

--- The last argument of functions that write patches.
patch_types.form = { "form", t.choice(core.patch_forms), "format of the file", otherwise = "by the file's ending" }

return patch_types
