-- A column of width 1 that stands on a bed along its last axis, in models of every kind.

local sg = require "signorini"
local lists = require "signorini.call.lists"
local scenes = require "scenes"

local column = { kinds = { "plane_strain", "plane_stress", "axisymmetric", "space" } }

--- The column: `height`, elements along it, order, material, `bed` (its support, by default a roller),
--- load(body), contacts.
function column.model(kind, o)
  local space = kind == "space"
  local body = scenes.body{ size = space and { 1, 1, o.height } or { 1, o.height }, order = o.order,
    elements = space and { 1, 1, o.elements } or { 1, o.elements }, material = o.material }
  local low = space and "front" or "south"
  return scenes.model{ bodies = { column = body }, kind = not space and kind or nil,
    supports = { bed = lists.merged({ on = low }, o.bed or { fix = space and "z" or "y" }),
      side = { on = "west", fix = "x" }, foot = space and { on = "south", fix = "y" } or nil },
    loads = { g = o.load(body) }, contacts = o.contacts }
end

--- The vector of this value along the axis, and a point at a part of the height.
function column.along(kind, value) return kind == "space" and { 0, 0, value } or { 0, value } end
function column.at(kind, part) return kind == "space" and { 0.3, 0.6, part } or { 0.3, part } end

--- The letter of the axis, the upper face, the area of a section.
function column.letter(kind) return kind == "space" and "z" or "y" end
function column.top(kind) return kind == "space" and "back" or "north" end
function column.area(kind) return kind == "axisymmetric" and math.pi or 1 end

return column
