-- Generated contact scenes: a body or a rigid cylinder is pressed into a slab and dragged along it. A seed always gives
-- the same scene; every scene exists in original and mirrored (x to -x).

local sg = require "signorini"
local dice = require "generated.dice"

local scenes = {}

-- The slab is 4 × 1, in 3D 2 × 1.2 × 0.6, with its upper side at zero and its middle above x = 0, E = 1.
local size = { plane = { 4, 1 }, space = { 2, 1.2, 0.6 } }

-- ── Descriptions ─────────────────────────────────────────────────────────────────────────────────────────────────────

local kinds = {
  plane = {
    shapes = { "block", "half ring", "cylinder" },
    orders = { "L1", "L2", "N2", "N3", "N4", "N2-N3", "N2-N4", "N2-N2.1", "N2-N2.2", "N2-N2.3", "N3-N3.1" },
    body = { { 2, 6 }, { 1, 3 } }, slab = { { 6, 16 }, { 2, 4 } }, place = 0.7, distance = 0.6,
  },
  space = {
    shapes = { "block", "half ring", "cylinder", "indenter" },
    orders = { "L1", "N2", "N3", "N2-N3", "N2-N2.1" },
    body = { { 2, 3 }, { 1, 2 }, { 1, 1 } }, slab = { { 4, 6 }, { 2, 4 }, { 1, 2 } }, place = 0.2, distance = 0.3,
  },
}
scenes.kinds = { "plane", "space" }

--- The scene of a seed, as plain data: kind, shape, slave ("body" or "slab"; a rigid cylinder is always the master),
--- orders and elements of body and slab, E of the body, mu, penalty, the place of the body's middle, press, drag and
--- their steps, and for leaning bodies the parts of the largest angle.
function scenes.describe(kind, seed)
  local ranges, roll = kinds[kind], dice(seed)
  local function elements(counts)
    local result = {}
    for i, count in ipairs(counts) do result[i] = roll.integer(table.unpack(count)) end
    return result
  end
  local scene = { kind = kind, seed = seed, shape = roll.one_of(ranges.shapes), slave = roll.one_of{ "body", "slab" } }
  if scene.shape == "cylinder" then scene.slave = "slab" end
  scene.orders = { body = roll.one_of(ranges.orders), slab = roll.one_of(ranges.orders) }
  scene.elements = { body = elements(ranges.body), slab = elements(ranges.slab) }
  -- A ring consists of two arcs: with equal numbers of elements its mesh is symmetric.
  if scene.shape == "half ring" then scene.elements.body[1] = 2 * ((scene.elements.body[1] + 1) // 2) end
  scene.E = roll.decades(0.1, 1000)
  scene.mu = math.max(0, roll.uniform(-0.1, 0.8)) -- one in nine without friction
  scene.penalty = roll.decades(30, 300) * math.min(scene.E, 1)
  scene.place = roll.uniform(-ranges.place, ranges.place)
  scene.press = roll.uniform(0.01, 0.2)
  scene.drag = roll.uniform(-ranges.distance, ranges.distance)
  scene.steps = { press = roll.integer(2, 6), drag = roll.integer(4, 24) }
  scene.lean = { roll.uniform(-1, 1), roll.uniform(-1, 1) }
  return scene
end

-- ── Models ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Shapes in 2D and 3D: the patch, the face that touches the slab, and the supported ones.
local shapes = {
  plane = {
    block = function(x)
      return sg.shapes.rectangle{ width = 0.8, height = 0.5, corner = { x - 0.4, 0 } }, "south", { "north" }
    end,
    ["half ring"] = function(x)
      return sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = { x, 0.5 } }, "south", { "west", "east" }
    end,
  },
  space = {
    block = function(x)
      return sg.shapes.block{ size = { 0.6, 0.5, 0.3 }, corner = { x - 0.3, -0.25, 0 } }, "front", { "back" }
    end,
    ["half ring"] = function(x)
      return sg.shapes.half_cylinder_shell{ inner = 0.25, outer = 0.4, width = 0.5, center = { x, -0.25, 0.4 } },
        "front", { "west", "east" }
    end,
    indenter = function(x)
      return sg.shapes.spherical_indenter{ width = 0.6, depth = 0.5, height = 0.3, radius = 0.6, elements = 1,
                                           corner = { x - 0.3, -0.25, 0 } }, "front", { "back" }
    end,
  },
}

local function cylinder(kind, x)
  if kind == "plane" then return sg.rigid.cylinder{ center = { x, 0.4 }, radius = 0.4 } end
  return sg.rigid.cylinder{ center = { x, 0, 0.4 }, axis = { 0, 1, 0 }, radius = 0.4 }
end

--- The patch and faces of the slab.
local function slab_patch(kind)
  local width, depth, height = table.unpack(size[kind])
  if kind == "plane" then
    return sg.shapes.rectangle{ width = width, height = depth, corner = { -width / 2, -depth } }, "north", "south"
  end
  return sg.shapes.block{ size = { width, depth, height }, corner = { -width / 2, -depth / 2, -height } }, "back",
    "front"
end

--- A solid turned by two angles (degrees) about axes along y and x, so that its lowest corner is at z = 0.
local function leaning(patch, angles)
  patch = patch:rotate{ angle = angles[1], axis = { 0, 1, 0 } }:rotate{ angle = angles[2], axis = { 1, 0, 0 } }
  local lowest = math.huge
  for corner = 0, 7 do lowest = math.min(lowest, patch{ corner % 2, corner // 2 % 2, corner // 4 }[3]) end
  return patch:translate{ 0, 0, -lowest }
end

local mirrors = { plane = { 1, 0 }, space = { 1, 0, 0 } }
local other_side = { west = "east", east = "west" } -- a mirrored patch has the opposite direction along x

--- The slab's upper side and all sides of the body but the driven ones.
local function outline(top, body, driven, plane)
  local faces, inside = { top }, {}
  for _, side in ipairs(driven) do inside[side] = true end
  for i, side in ipairs{ "west", "east", "south", "north", "front", "back" } do
    if (i <= 4 or not plane) and not inside[side] then faces[#faces + 1] = body:face(side) end
  end
  return faces
end

--- Model and stages of a scene, or of its mirror image. scene.law: further arguments of the contact, such as `method`;
--- scene.outline: all sides of the body are in the contact; scene.tilt: the largest angle by which solid blocks lean.
function scenes.build(scene, mirrored)
  local plane = scene.kind == "plane"
  local all, sign = plane and "xy" or "xyz", mirrored and -1 or 1
  local function body(patch, part, face, E)
    if mirrored then patch = patch:mirror{ normal = mirrors[scene.kind], point = plane and { 0, 0 } or { 0, 0, 0 } } end
    -- In space the sides of a body with a layer cross it.
    local order = scene.orders[part]
    if scene.outline and part == "body" and not plane then order = order:match "^[^-]*" end
    return sg.body{ patch = patch, elements = scene.elements[part], order = order, contact = face,
                    material = sg.neo_hookean{ E = E, nu = 0.3 } }
  end
  local patch, top, bottom = slab_patch(scene.kind)
  local slab = body(patch, "slab", top, 1)
  local bodies, faces, driven, around = { slab = slab }, { slab = slab:face(top) }, {}, nil
  if scene.shape == "cylinder" then
    driven = cylinder(scene.kind, sign * scene.place)
    faces.body = driven
  else
    local shape, face, sides = shapes[scene.kind][scene.shape](scene.place)
    if scene.tilt and scene.tilt > 0 and scene.shape == "block" and not plane then
      shape = leaning(shape, { scene.tilt * scene.lean[1], scene.tilt * scene.lean[2] })
    end
    bodies.body = body(shape, "body", face, scene.E)
    faces.body = bodies.body:face(face)
    for i, side in ipairs(sides) do sides[i] = mirrored and other_side[side] or side end
    for i, side in ipairs(sides) do driven[i] = bodies.body:face(side) end
    if scene.outline then around = outline(faces.slab, bodies.body, sides, plane) end
  end
  local interface = {
    slave = faces[scene.slave], master = faces[scene.slave == "slab" and "body" or "slab"], penalty = scene.penalty,
    friction = scene.mu > 0 and { mu = scene.mu, penalty = scene.penalty } or nil,
  }
  for key, value in pairs(scene.law or {}) do interface[key] = value end
  if around then interface.slave, interface.master, interface.among = nil, nil, around end
  local model = sg.model{
    bodies = bodies,
    supports = { bed = { on = slab:face(bottom), fix = all }, grip = { on = driven, drive = all } },
    contacts = { interface = interface },
  }
  local function at(x, depth) return plane and { sign * x, -depth } or { sign * x, 0, -depth } end
  return model, {
    { name = "press", steps = scene.steps.press, grip = at(0, scene.press) },
    { name = "drag", steps = scene.steps.drag, grip = at(scene.drag, scene.press) },
  }
end

-- ── Runs ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Solves a scene, or its mirror image, with options as model:run takes them. Returns the run and a plain account of
--- it: ending (the cause where a step could not be cut any more), steps, iterations, cutbacks, fallback_steps, and the
--- forces on the body after each step as they are without the mirror, all components of a step after those of the one
--- before.
function scenes.solve(scene, options, mirrored)
  local model, stages = scenes.build(scene, mirrored)
  local run = model:run(stages, options)
  local forces, columns = {}, {}
  for i, name in ipairs(scene.kind == "plane" and { "fx", "fy" } or { "fx", "fy", "fz" }) do
    columns[i] = run:column("grip." .. name)
  end
  for step = 1, run.steps do
    for i, column in ipairs(columns) do
      forces[#forces + 1] = (mirrored and i == 1) and -column[step] or column[step]
    end
  end
  return run, { ending = run.failed and (run.cause or run.reason) or "completed", steps = run.steps,
                iterations = run.iterations, cutbacks = run.cutbacks, fallback_steps = run.fallback_steps,
                forces = forces }
end

--- The largest difference of two accounts' forces at one step, as a fraction of the largest force in the first.
function scenes.difference(account, other)
  local largest, difference = 0, 0
  for i = 1, math.min(#account.forces, #other.forces) do
    largest = math.max(largest, math.abs(account.forces[i]))
    difference = math.max(difference, math.abs(account.forces[i] - other.forces[i]))
  end
  return largest > 0 and difference / largest or difference
end

return scenes
