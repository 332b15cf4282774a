-- Bodies and obstacles of generated scenes as plain data, above and below the plane in which they touch.

local sg = require "signorini"
local laws = require "robustness.laws"
local patches = require "robustness.patches"

local parts = {}

local orders = { "L1", "L2", "N2", "N2", "N3", "N4", "N2-N3", "N2-N4", "N2-N2.1", "N2-N2.2", "N3-N3.1" }

--- Degrees of the orders' bulk that a patch allows.
local function order_of(scene, roll, patch)
  local least, suitable = 1, {}
  for _, degree in ipairs(patch.degrees) do least = math.max(least, degree) end
  if scene:odd(0.05, "order below that of the geometry") then least = 1 end
  for _, order in ipairs(orders) do
    local bulk = tonumber(order:match "%d")
    if bulk >= math.min(least, 4) and not (scene.space and (bulk > math.max(least, 2))) then
      suitable[#suitable + 1] = order
    end
  end
  return roll.one_of(suitable), least
end

--- Discretization and material of a body with a contact face.
local function body(scene, roll, name, shape, contact, E)
  local space = scene.space
  local count = space and 3 or 2
  local result = { name = name, contact = contact, elements = {}, E = E }
  if shape.degrees then
    result.patch = shape
  else
    result.patches, result.boundaries = shape.patches, shape.boundaries
  end
  local least
  result.order, least = order_of(scene, roll, result.patch or result.patches[1])
  for i = 1, count do result.elements[i] = roll.integer(1, not space and 4 or i == 1 and 2 or 1) end
  local patch = result.patch or result.patches[1]
  for i, knots in ipairs(patch.knots) do -- a multiple of those of the patch, so that mirrored meshes are mirror images
    local spans = 0
    for k = 2, #knots do spans = spans + (knots[k] > knots[k - 1] and 1 or 0) end
    result.elements[i] = spans * math.max(1, result.elements[i] // spans)
  end
  if scene:odd(0.05, "too few elements") then result.elements[1] = 1 end
  if scene:odd(0.03, "zero elements") then result.elements[1] = 0 end
  if result.order:find("-", 1, true) then
    local local_layer = roll.one_of{ "whole", "whole", "range", "knots" }
    if local_layer == "range" and result.patch then
      local from = roll.uniform(0, 0.4)
      result.layer = { from, from + roll.uniform(0.3, 0.6) }
      if space then result.layer = { result.layer, { 0, 0.7 } } end
    elseif local_layer == "range" then
      result.layer_bound = roll.uniform(-0.5, 0.5)
    elseif local_layer == "knots" and not space then
      result.layer_knots = 2
    end
    if scene:odd(0.1, "layer outside of the face") and result.layer and not space then result.layer = { 1.2, 1.7 } end
  end
  if scene:odd(0.05, "order without a contact face") then result.contact = nil end
  if roll.uniform(0, 1) < 0.2 then result.thickness_degree = roll.integer(least, 4) end
  if roll.uniform(0, 1) < 0.15 and scene.kind ~= "plane_stress" then result.volumetric = "projected" end
  result.material = laws.draw_material(scene, roll, E)
  return result
end

--- A box of a scene between two values of x and of the height.
local function box(scene, x, up, depth)
  if scene.space then
    return patches.box({ x[1], -depth, up[1] }, { x[2], depth, up[2] })
  end
  return patches.box({ x[1], up[1] }, { x[2], up[2] })
end

local function distorted(scene, roll, patch, fixed)
  return patches.distorted(patches.refined(patch, roll, scene), roll, scene, fixed)
end

-- ── Below ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The slab, of one body, of two that are joined or tied, or of two patches. Appends bodies to the scene; returns the
--- faces on top, at the bottom, at the left and right end.
function parts.slab(scene, roll)
  local up = scene.space and 3 or 2
  local top, bottom = scene.space and "back" or "north", scene.space and "front" or "south"
  local left = scene.kind == "axisymmetric" and 0 or -1
  local right, depth = left + 2, 0.5
  local height = { -roll.uniform(0.3, 0.8), 0 }
  if scene:odd(0.1, "thin slab") then height[1] = -roll.decades(1e-4, 1e-1) end
  local function append(name, shape, contact) table.insert(scene.bodies, body(scene, roll, name, shape, contact, 1)) end
  local function face(name, side) return { body = name, face = side } end
  if scene.layout ~= "joined" and scene.layout ~= "compound" then
    append("a", distorted(scene, roll, box(scene, { left, right }, height, depth), { { up, 0 }, { 1, 0 } }), top)
    return { face("a", top) }, { face("a", bottom) }, face("a", "west"), face("a", "east")
  end
  local middle = left + roll.uniform(0.6, 1.4)
  local one, two = box(scene, { left, middle }, height, depth), box(scene, { middle, right }, height, depth)
  if scene.layout == "compound" then
    append("a", { patches = { patches.data(one), patches.data(two) },
                  boundaries = { top = { "1." .. top, "2." .. top }, bottom = { "1." .. bottom, "2." .. bottom } } },
      "top")
    return { face("a", "top") }, { face("a", "bottom") }, face("a", "1.west"), face("a", "2.east")
  end
  append("a", distorted(scene, roll, one, { { up, 0 }, { 1, 0 }, { 1, 1 } }), top)
  append("b", distorted(scene, roll, two, { { up, 0 }, { 1, 0 }, { 1, 1 } }), top)
  if roll.uniform(0, 1) < 0.6 then
    scene.joins.seam = { face("a", "east"), face("b", "west") }
    if roll.uniform(0, 1) < 0.5 then -- of equal meshes
      scene.bodies[2].order, scene.bodies[2].elements[up] = scene.bodies[1].order, scene.bodies[1].elements[up]
    end
  else
    scene.ties.seam = { face("a", "east"), face("b", "west"), multipliers = roll.one_of{ "equal", "reduced" } }
  end
  return { face("a", top), face("b", top) }, { face("a", bottom), face("b", bottom) }, face("a", "west"),
    face("b", "east")
end

-- ── Above ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Shapes of the upper body: patch, lower face, held faces, whether it is a box.
local uppers = {
  block = function(scene, x, gap, roll)
    local half, height = roll.uniform(0.25, 0.6), roll.uniform(0.3, 0.5)
    if scene.kind == "axisymmetric" then x = half + math.max(x, 0) end
    return box(scene, { x - half, x + half }, { gap, gap + height }, 0.3), scene.space and "front" or "south",
      { scene.space and "back" or "north" }, true
  end,
  arch = function(scene, x, gap)
    if scene.space then
      return sg.shapes.half_cylinder_shell{ inner = 0.25, outer = 0.4, width = 0.5, center = { x, -0.25, 0.4 + gap } },
        "front", { "west", "east" }
    elseif scene.kind == "axisymmetric" then
      return sg.shapes.quarter_annulus{ inner = 0.3, outer = 0.5, center = { 0, 0.5 + gap } }, "south", { "east" }
    end
    return sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = { x, 0.5 + gap } }, "south", { "west", "east" }
  end,
  indenter = function(_, x, gap)
    return sg.shapes.spherical_indenter{ width = 0.6, depth = 0.5, height = 0.3, radius = 0.6, elements = 1,
                                         corner = { x - 0.3, -0.25, gap } }, "front", { "back" }
  end,
  shell = function(_, x, gap) -- with poles
    return sg.shapes.hollow_hemisphere{ inner = 0.25, outer = 0.4, center = { x, 0, 0.4 + gap } }, "front",
      { "west", "east" }
  end,
}

--- The upper body; returns its lower face, the held ones and its upper face.
function parts.upper(scene, roll, x, gap)
  local shape = roll.one_of(scene.space and { "block", "block", "arch", "indenter", "shell" } or { "block", "block",
                            "arch" })
  local patch, lower, held, is_box = uppers[shape](scene, x, gap, roll)
  local data = is_box and distorted(scene, roll, patch, { { scene.space and 3 or 2, 0 }, { 1, 0 } })
    or patches.data(patch)
  if shape == "block" and scene.kind == "axisymmetric" then scene.ring = true end
  scene.shape = shape
  table.insert(scene.bodies, body(scene, roll, "c", data, lower, roll.decades(0.3, 30)))
  for i, side in ipairs(held) do held[i] = { body = "c", face = side } end
  return { body = "c", face = lower }, held, { body = "c", face = scene.space and "back" or "north" }
end

-- ── Obstacles ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Obstacles as plain data, with their lowest point at the height `gap` above x; inside out if `wrong`.
local tools = {
  round = function(scene, x, gap)
    local r = 0.4
    if scene.space then return { shape = "sphere", center = { x, 0.05, r + gap }, radius = r } end
    if scene.kind == "axisymmetric" then return { shape = "sphere", center = { 0, r + gap }, radius = r } end
    return { shape = "cylinder", center = { x, r + gap }, radius = r }
  end,
  plane = function(scene, x, gap)
    local tilt = scene.kind == "axisymmetric" and 0 or 0.1 * x
    if scene.space then return { shape = "plane", point = { x, 0, gap }, normal = { tilt, 0.02, -1 } } end
    return { shape = "plane", point = { x, gap }, normal = { tilt, -1 } }
  end,
  roll = function(scene, x, gap)
    local r = 0.3
    if scene.space then return { shape = "cylinder", center = { x, 0, r + gap }, axis = { 0.1, 1, 0 }, radius = r } end
    if scene.kind == "axisymmetric" then
      return { shape = "torus", center = { math.abs(x) + 0.4, r + gap }, radius = r }
    end
    return { shape = "cylinder", center = { x, r + gap }, radius = r }
  end,
  ring = function(scene, x, gap)
    if scene.space then
      return { shape = "torus", center = { x, 0, 0.2 + gap }, axis = { 0, 0, 1 }, ring = 0.4, radius = 0.2 }
    end
  end,
  surface = function(scene, x, gap)
    local r = 0.4
    if scene.kind == "axisymmetric" then x = math.abs(x) + 0.5 end
    local arc = sg.nurbs.arc{ center = { x, r + gap }, radius = r, from = 200, to = 340 }
    if scene.space then
      arc = sg.nurbs.arc{ center = { x, r + gap, 0 }, radius = r, from = 200, to = 340 }
      return { shape = "surface", patch = patches.data(sg.nurbs.extrude{ patch = arc, along = { 0, 0, 0.9 } }
        :rotate{ axis = { 1, 0, 0 }, angle = 90 }:translate{ 0, 0.45, 0 }) }
    end
    return { shape = "surface", patch = patches.data(arc) }
  end,
  level_set = function(scene, x, gap)
    if scene.kind == "axisymmetric" then x = 0 end
    return { shape = "level_set", center = scene.space and { x, 0, 0.3 + gap } or { x, 0.3 + gap }, radius = 0.3,
             exponent = 4 }
  end,
}

--- An obstacle above the slab.
function parts.tool(scene, roll, x, gap)
  local names = { "round", "round", "plane", "roll", "surface", "level_set" }
  if scene.space then names[#names + 1] = "ring" end
  scene.shape = roll.one_of(names)
  local tool = tools[scene.shape](scene, x, gap)
  if scene:odd(0.1, "obstacle inside out") then
    tool.inside = true
    if tool.normal then tool.normal[#tool.normal] = -tool.normal[#tool.normal] end
  end
  if scene:odd(0.1, "extreme obstacle") and tool.radius then tool.radius = tool.radius * roll.decades(1e-6, 1e6) end
  tool.name = "t"
  table.insert(scene.obstacles, tool)
  return { obstacle = "t" }
end

return parts
