-- Scenes for walk_test.lua: a body or an obstacle above a slab, drawn from a seed among all kinds of models, materials,
-- layers, obstacles, contact formulations and laws.

local core = require "signorini.core"
package.path = ("%s;%s/scripts/?.lua;%s/scripts/stability/?.lua"):format(package.path, core.home, core.home)
local sg = require "signorini"
local dice = require "generated.dice"
local formulations = require "formulations.rows"

local scenes = {}

-- ── Descriptions ─────────────────────────────────────────────────────────────────────────────────────────────────────

local kinds = { "plane_strain", "plane_strain", "plane_strain", "plane_stress", "axisymmetric", "axisymmetric", "space",
                "space" }
local uppers = {
  plane = { "block", "block", "ring", "disc", "curve", "free disc", "turning disc" },
  axisymmetric = { "block", "ring", "disc", "curve" },
  space = { "block", "block", "indenter", "disc", "surface", "free disc" },
}
local orders = { "L1", "L2", "N2", "N3", "N2-N3", "N2-N2.1", "N2-N2.2" }
local rigid = { disc = true, curve = true, surface = true, ["free disc"] = true, ["turning disc"] = true }

--- The contact's law: a formulation of formulations/rows.lua, adhesion, or bonds.
local function draw_law(scene, roll)
  local special = roll.uniform(0, 1)
  if special < 0.08 then return "adhesion" end
  if special < 0.16 and scene.upper == "block" then return "cohesive" end
  local suitable = formulations.where(function(row) return not (row.two_faces and scene.rigid) end)
  return roll.one_of(suitable)
end

--- The scene of a seed, as plain data.
function scenes.describe(seed)
  local roll = dice(seed)
  local scene = { seed = seed, kind = roll.one_of(kinds) }
  scene.space, scene.revolved = scene.kind == "space", scene.kind == "axisymmetric"
  scene.upper = roll.one_of(uppers[scene.kind] or uppers.plane)
  scene.rigid = rigid[scene.upper] or false
  scene.slave = scene.rigid and "slab" or roll.one_of{ "body", "slab" }
  scene.law = draw_law(scene, roll)
  if scene.law == "cohesive" then scene.slave = "body" end
  scene.orders = { body = roll.one_of(orders), slab = roll.one_of(orders) }
  if scene.law:find("reduced", 1, true) then -- of degree 2 at least
    for part, label in pairs(scene.orders) do scene.orders[part] = label:gsub("L1", "L2") end
  end
  scene.layer = roll.one_of{ "whole", "range", "knots" }
  scene.elements = {
    slab = scene.space and { roll.integer(3, 4), roll.integer(2, 3), 1 } or { roll.integer(5, 9), roll.integer(1, 2) },
    body = scene.space and { 2, roll.integer(1, 2), 1 } or { roll.integer(2, 4), 1 },
  }
  scene.patches = scene.space and 1 or roll.one_of{ 1, 1, 1, 2 } -- of the slab
  if scene.upper == "ring" then scene.elements.body[1] = 2 * ((scene.elements.body[1] + 1) // 2) end
  scene.material = roll.one_of{ "hyperelastic", "hyperelastic", "linear", "projected" }
  if scene.kind == "plane_stress" and scene.material == "projected" then scene.material = "linear" end
  scene.thickness_degree = roll.one_of{ false, 1 }
  scene.E = roll.decades(0.5, 20)
  scene.mu = math.max(0, roll.uniform(-0.2, 0.6))
  scene.penalty = roll.decades(10, 60)
  scene.points = roll.one_of{ "auto", "auto", 4, 7 }
  scene.per = roll.one_of{ "current", "reference" }
  scene.offset = roll.one_of{ 0, 0, 0.01, -0.01 }
  scene.load = roll.one_of{ "none", "none", "gas", "gravity", "spring" }
  scene.turns = roll.uniform(0, 1) < 0.2
  scene.place = scene.space and roll.uniform(-0.4, 0.4) or roll.uniform(-1.8, 1.8)
  if scene.revolved then scene.place = roll.uniform(0.5, 1.6) end
  scene.lift = scene.law == "cohesive" and 0 or roll.uniform(0.001, 0.05)
  scene.free = scene.upper == "free disc" or scene.upper == "turning disc"
  if scene.free then scene.lift = -0.01 end
  scene.steps, scene.walk = 4, {}
  for step = 1, scene.steps do
    local reach = scene.space and 0.1 or 0.2
    scene.walk[step] = {
      x = roll.uniform(-reach, reach), depth = roll.uniform(-0.03, 0.06), angle = roll.uniform(-4, 4),
      change = roll.one_of{ "none", "none", "penalty", "off", "mu", "offset", "factor" },
    }
  end
  return scene
end

-- ── Models ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Moduli, penalties, strengths and loads are in a unit of stress, 1 unless a test scales it.
local function unit(scene) return scene.unit or 1 end

local function material(scene, E)
  E = E * unit(scene)
  if scene.material == "linear" then return sg.linear_elastic{ E = E, nu = 0.3 } end
  return sg.neo_hookean{ E = E, nu = scene.material == "projected" and 0.45 or 0.3 }
end

--- A body of the scene with a contact face; layers may be local.
local function body(scene, part, patch, face, E)
  local label = scene.orders[part]
  local layered, layer, knots = label:find("-", 1, true), nil, nil
  if layered and scene.layer == "range" then
    layer = scene.space and { { 0, 0.6 }, { 0.3, 1 } } or { 0.2, 0.7 }
    if part == "slab" and scene.patches == 2 then layer = function(X) return X[1] > -0.6 and X[1] < 0.9 end end
  end
  if layered and scene.layer == "knots" then knots = scene.space and { 2, 1 } or 2 end
  return sg.body{ patch = patch, elements = scene.elements[part], order = label, contact = face, layer = layer,
                  layer_knots = knots, material = material(scene, E), thickness_degree = scene.thickness_degree or nil,
                  volumetric = scene.material == "projected" and "projected" or nil }
end

--- The slab and its upper, lower, left and right faces.
local function slab_of(scene)
  if scene.space then
    local patch = sg.shapes.block{ size = { 1.6, 1, 0.5 }, corner = { -0.8, -0.5, -0.5 } }
    return body(scene, "slab", patch, "back", 1), "back", "front", "west", "east"
  end
  local left, width = scene.revolved and 0 or -2, scene.revolved and 2 or 4
  local function part(from, to)
    return sg.shapes.rectangle{ width = (to - from) * width, height = 0.8, corner = { left + from * width, -0.8 } }
  end
  if scene.patches == 1 then return body(scene, "slab", part(0, 1), "north", 1), "north", "south", "west", "east" end
  local pair = { part(0, 0.4), part(0.4, 1), boundaries = { top = { "1.north", "2.north" },
                                                              bottom = { "1.south", "2.south" } } }
  return body(scene, "slab", pair, "top", 1), "top", "bottom", "1.west", "2.east"
end

--- The upper body, the face that touches the slab and the supported ones.
local function upper_body(scene)
  local x, lift = scene.place, scene.lift
  local shapes = {
    block = function()
      if scene.space then
        return sg.shapes.block{ size = { 0.6, 0.5, 0.3 }, corner = { x - 0.3, -0.25, lift } }, "front", { "back" }
      end
      return sg.shapes.rectangle{ width = 0.8, height = 0.4, corner = { x - 0.4, lift } }, "south", { "north" }
    end,
    ring = function()
      return sg.shapes.half_annulus{ inner = 0.25, outer = 0.45, center = { x, 0.45 + lift } }, "south",
        { "west", "east" }
    end,
    indenter = function()
      return sg.shapes.spherical_indenter{ width = 0.6, depth = 0.5, height = 0.3, radius = 0.6, elements = 1,
                                           corner = { x - 0.3, -0.25, lift } }, "front", { "back" }
    end,
  }
  local patch, face, held = shapes[scene.upper]()
  return body(scene, "body", patch, face, scene.E), face, held
end

local function obstacle(scene)
  local x, lift, r = scene.place, scene.lift, 0.4
  if scene.upper == "surface" then
    local arc = sg.nurbs.arc{ center = { x, r + lift, 0 }, radius = r, from = 200, to = 340 }
    return sg.rigid.surface(sg.nurbs.extrude{ patch = arc, along = { 0, 0, 0.7 } }
      :rotate{ axis = { 1, 0, 0 }, angle = 90 }:translate{ 0, 0.3, 0 })
  elseif scene.upper == "curve" then
    return sg.rigid.surface(sg.nurbs.arc{ center = { x, r + lift }, radius = r, from = 200, to = 340 })
  elseif scene.space then
    return sg.rigid.sphere{ center = { x, 0.1, r + lift }, radius = r }
  elseif scene.revolved then
    return sg.rigid.torus{ center = { x, r + lift }, radius = r }
  end
  return sg.rigid.cylinder{ center = { x, r + lift }, radius = r }
end

--- The contact of a law.
local function contact_of(scene, slave, master)
  if scene.law == "adhesion" then
    return { slave = slave, master = master, adhesion = { hamaker = 5e-4 * unit(scene), r0 = 0.1 } }
  end
  local penalty = scene.penalty * unit(scene)
  local contact = { slave = slave, master = master, penalty = penalty,
                    friction = { mu = scene.mu, penalty = penalty } }
  if scene.law == "cohesive" then
    contact.cohesive = { strength = 0.2 * unit(scene), energy = 0.01 * unit(scene) }
    return contact
  end
  contact.offset = scene.offset
  if scene.mu == 0 then contact.friction = nil end
  local row = formulations[scene.law]
  local at_points = row.keys.multipliers == nil and row.keys.method ~= "mortar"
  if scene.points ~= "auto" or at_points then contact.points = scene.points end
  if scene.law == "gpts" then contact.per = scene.per end
  return formulations.contact(row, contact)
end

--- A description in one line.
function scenes.text(scene)
  return ("%d: %s, %s on %s (%s slave), %s, %s on %s, layer %s, mu %.2g, points %s, load %s"):format(scene.seed,
    scene.kind, scene.upper, scene.material, scene.slave, scene.law, scene.orders.body, scene.orders.slab, scene.layer,
    scene.mu, scene.points, scene.load)
end

--- The model, and the targets of the support "grip" at a place: function(x, depth, angle).
function scenes.build(scene)
  local slab, top, bottom, left, right = slab_of(scene)
  local bodies, faces, all = { slab = slab }, { slab = slab:face(top) }, scene.space and "xyz" or "xy"
  local grip, loads = {}, {}
  if scene.rigid then
    faces.body = obstacle(scene)
    grip.on = faces.body
  else
    local held
    bodies.body, top, held = upper_body(scene)
    faces.body, grip.on = bodies.body:face(top), {}
    for i, name in ipairs(held) do grip.on[i] = bodies.body:face(name) end
  end
  grip.drive = scene.revolved and "y" or all
  if scene.revolved and not scene.rigid then grip.fix = "x" end
  if scene.free then
    grip.drive, grip.free = "x", scene.space and "z" or "y"
    if scene.space then grip.drive = "xy" end
    if scene.upper == "turning disc" then grip.rotate, grip.angle = true, "free" end
    local weight = -0.05 * unit(scene)
    loads.weight = { on = faces.body, force = scene.space and { 0, 0, weight } or { 0, weight } }
  end
  local turns = scene.turns and scene.upper == "block" and not scene.space and not scene.revolved
  if turns then grip.on, grip.rotate = grip.on[1], true end
  if scene.load == "gas" then
    loads.gas = { on = slab:face(right), pressure = 0.05 * unit(scene), follower = true }
  elseif scene.load == "gravity" then
    loads.gravity = { on = slab, force = scene.space and { 0, 0, -0.02 * unit(scene) } or { 0, -0.02 * unit(scene) } }
  end
  local supports = { bed = { on = slab:face(bottom), fix = all }, grip = grip }
  if scene.load == "spring" and not scene.revolved then
    local k = unit(scene)
    supports.wall = { on = slab:face(left), spring = scene.space and { k, 2 * k, 0 } or { k, 2 * k } }
  end
  if scene.revolved then supports.axis = { on = slab:face(left), symmetry = true } end
  local model = sg.model{
    bodies = bodies, supports = supports, loads = loads, kind = not scene.space and scene.kind or nil,
    contacts = { touch = contact_of(scene, faces[scene.slave], faces[scene.slave == "slab" and "body" or "slab"]) },
  }
  return model, function(x, depth, angle)
    if scene.revolved then return { -depth } end
    if grip.free then return scene.space and { x, 0.3 * x } or { x } end
    local target = scene.space and { x, 0.3 * x, -depth } or { x, -depth }
    if turns then target[3] = angle end
    return target
  end
end

return scenes
