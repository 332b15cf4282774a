-- Families of generated scenes that each look at one thing: stress-free motions, adhesive strips, discs with singular
-- corners, faces in the wrong place, loads, loose bodies, ends of masters. A scene is plain data as that of scenes.lua.
-- must: "complete" where nothing should end the run early; patience: factor on the limit of iterations.

local sg = require "signorini"
local dice = require "stability.generated.dice"
local formulations = require "formulations.rows"
local patches = require "robustness.patches"

local families = {}

-- ── Parts ────────────────────────────────────────────────────────────────────────────────────────────────────────────

local orders = { "L1", "N2", "N2", "N3", "N2-N2.1" }
local nonlinear = { "neo_hookean", "neo_hookean", "mooney_rivlin", "ogden", "energy" }

--- A scene without parts; kinds: of which one is drawn. Returns it, its dice, the names of its sides and components.
local function start(seed, name, kinds)
  local salt = 0
  for i = 1, #name do salt = salt * 31 + name:byte(i) end
  local roll = dice(seed + salt)
  local kind = roll.one_of(kinds)
  local scene = { seed = seed, kind = kind, space = kind == "space", layout = name, shape = "boxes", roll = roll,
                  oddities = {}, bodies = {}, obstacles = {}, supports = {}, loads = {}, contacts = {}, joins = {},
                  ties = {}, stages = {}, options = {}, odd = function() return false end }
  scene.axis = kind == "axisymmetric"
  local sides = { top = "north", bottom = "south", left = "west", right = "east", all = "xy" }
  if scene.space then sides.top, sides.bottom, sides.all = "back", "front", "xyz" end
  return scene, roll, sides
end

--- A point or a vector of a scene.
local function at(scene, x, up)
  if scene.space then return { x, 0, up } end
  return { x, up }
end

--- The box between two corners in the plane, in space 0.6 deep.
local function box(scene, left, bottom, right, top)
  if scene.space then return patches.box({ left, -0.3, bottom }, { right, 0.3, top }) end
  return patches.box({ left, bottom }, { right, top })
end

--- Adds a body of a patch, with a contact face or without.
local function add_body(scene, name, patch, contact, E, law)
  local roll, data, elements = scene.roll, type(patch) == "table" and patch or patches.data(patch), {}
  for i, knots in ipairs(data.knots) do
    local count, spans = roll.integer(i == 1 and 2 or 1, scene.space and 2 or 4), 0
    for k = 2, #knots do spans = spans + (knots[k] > knots[k - 1] and 1 or 0) end
    elements[i] = spans * math.max(1, count // spans)
  end
  local least, suitable = math.max(table.unpack(data.degrees)), {}
  for _, order in ipairs(orders) do
    local layered = order:find("-", 1, true)
    if tonumber(order:match "%d") >= least and (contact or not layered) then suitable[#suitable + 1] = order end
  end
  table.insert(scene.bodies, { name = name, patch = data, contact = contact, elements = elements,
                               order = roll.one_of(suitable), E = E,
                               material = { law = law, E = E, nu = roll.uniform(0, 0.4) } })
end

local function add_contact(scene, slave, master, law)
  law.penalty, law.mu = law.penalty or 20, law.mu or 0
  scene.contacts[#scene.contacts + 1] = { name = "k" .. #scene.contacts + 1, slave = { slave }, master = { master },
                                          law = law }
end

local function add_stage(scene, steps, x, up, more)
  local stage = { steps = steps, at = at(scene, x, up), angle = 0, loads = {} }
  for key, value in pairs(more or {}) do stage[key] = value end
  scene.stages[#scene.stages + 1] = stage
end

local function face(body, side) return { body = body, face = side } end

--- Controls of most runs: the default ones, plain Newton, sg.robust.
local function controls(roll)
  local kind = roll.one_of{ "default", "plain", "robust" }
  return kind == "plain" and sg.plain{} or kind == "robust" and sg.robust{} or {}
end

-- ── Stress-free motions ──────────────────────────────────────────────────────────────────────────────────────────────

--- A body that one face carries along a path of up to a thousand times its size, or turns.
function families.motion(seed)
  local scene, roll, sides = start(seed, "motion",
    { "plane_strain", "plane_strain", "plane_stress", "axisymmetric", "space" })
  local turns = not scene.axis and roll.uniform(0, 1) < 0.5
  local place = scene.axis and 0 or roll.one_of{ 0, roll.uniform(-1, 1) * roll.decades(1, 1e5) }
  local patch = box(scene, place, 0, place + roll.uniform(0.3, 3), roll.uniform(0.3, 1))
  patch = patches.distorted(patch, roll, scene, { { scene.space and 3 or 2, 0 }, { 1, 0 } })
  local law = roll.one_of(nonlinear)
  if not turns and roll.uniform(0, 1) < 0.3 then law = "linear_elastic" end
  add_body(scene, "a", patch, nil, roll.decades(1e-3, 1e3), law)
  scene.supports.grip = { on = { face("a", sides.bottom) }, drive = scene.axis and "y" or sides.all,
                          rotate = turns and (scene.space and { 0, 1, 0 } or true) or nil }
  local far = roll.decades(0.1, 1e3)
  add_stage(scene, roll.integer(turns and 4 or 1, 10), scene.axis and 0 or roll.uniform(-1, 1) * far,
    roll.uniform(-1, 1) * far, { angle = turns and roll.uniform(-90, 90) or 0 })
  scene.options = controls(roll)
  scene.must, scene.patience = "complete", 5
  return scene
end

-- ── Adhesive strips ──────────────────────────────────────────────────────────────────────────────────────────────────

--- A strip, often far from the origin, on a film of adhesion above a plane or a block, pulled off by its lid or an end.
function families.strip(seed)
  local scene, roll, sides = start(seed, "strip", { "plane_strain", "plane_strain", "plane_stress", "space" })
  local r0 = 0.1
  local gap = 15 ^ (-1 / 6) * r0 -- without traction
  local x = roll.one_of{ 0, roll.uniform(-1, 1) * roll.decades(10, 1e5) }
  local law, E = roll.one_of{ "linear_elastic", "linear_elastic", "neo_hookean" }, roll.decades(0.05, 10)
  add_body(scene, "c", box(scene, x - 1, gap, x + 1, gap + roll.decades(0.03, 1)), sides.bottom, E, law)
  if not scene.space then scene.bodies[1].elements[1] = roll.integer(2, 16) end
  local master = { obstacle = "t" }
  if roll.uniform(0, 1) < 0.6 then
    scene.obstacles[1] = { name = "t", shape = "plane", point = at(scene, 0, 0), normal = at(scene, 0, 1) }
  else
    add_body(scene, "a", box(scene, x - 1.5, -0.5, x + 1.5, 0), sides.top, E * roll.decades(1, 100), law)
    scene.supports.bed = { on = { face("a", sides.bottom) }, fix = sides.all }
    master = face("a", sides.top)
  end
  local end_face = roll.one_of{ sides.top, sides.right }
  scene.supports.grip = { on = { face("c", end_face) }, drive = sides.all }
  add_contact(scene, face("c", sides.bottom), master, { adhesion = { hamaker = roll.decades(1e-4, 1e-2), r0 = r0 } })
  add_stage(scene, roll.integer(3, 10), 0, roll.uniform(0.05, 0.5))
  scene.options = controls(roll)
  if roll.uniform(0, 1) < 0.4 then
    scene.options = sg.plain{ pseudo_transient = true, newton = { iterations = 50 } }
  end
  scene.patience = 3
  return scene
end

-- ── Discs ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A disc of four arcs, whose map is singular in four corners, between a bed and a plane; in space extruded.
function families.disc(seed)
  local scene, roll, sides = start(seed, "disc", { "plane_strain", "plane_stress", "space" })
  local r, arcs = roll.uniform(0.3, 1), {}
  for i, name in ipairs{ "north", "west", "south", "east" } do
    arcs[name] = sg.nurbs.arc{ center = { 0, 0 }, radius = r, from = 90 * i - 45, to = 90 * i + 45 }
  end
  local patch = sg.nurbs.coons{ north = arcs.north:reverse(1), south = arcs.south, west = arcs.west:reverse(1),
                                east = arcs.east }
  if scene.space then -- the disc in the x-z plane
    patch = sg.nurbs.extrude{ patch = patch:to_space(), along = { 0, 0, 0.5 } }:rotate{ axis = { 1, 0, 0 }, angle = 90 }
  end
  add_body(scene, "c", patch, "north", 1, roll.one_of{ "linear_elastic", "neo_hookean", "mooney_rivlin" })
  scene.obstacles[1] = { name = "t", shape = "plane", point = at(scene, 0, r),
                         normal = at(scene, roll.uniform(-0.05, 0.05), -1) }
  scene.supports.bed = { on = { face("c", "south") }, fix = sides.all }
  scene.supports.grip = { on = { { obstacle = "t" } }, drive = sides.all }
  add_contact(scene, face("c", "north"), { obstacle = "t" }, { mu = roll.one_of{ 0, 0.3 }, formulation = "gpts" })
  add_stage(scene, roll.integer(1, 4), 0, -roll.uniform(0.01, 0.1) * r)
  scene.options = controls(roll)
  return scene
end

-- ── Wrong places ─────────────────────────────────────────────────────────────────────────────────────────────────────

--- Two blocks at any height above each other whose contact has any two faces.
function families.placed(seed)
  local scene, roll, sides = start(seed, "placed", { "plane_strain", "plane_stress", "axisymmetric", "space" })
  local gap, left = roll.one_of{ 0, 0, 0.002, -roll.decades(1e-3, 1) }, scene.axis and 0 or -1
  add_body(scene, "a", box(scene, left, -1, left + 2, 0), sides.top, 1, "neo_hookean")
  add_body(scene, "c", box(scene, left + roll.uniform(0, 1), gap, left + 2, gap + 1), sides.bottom,
    roll.decades(0.3, 3), "neo_hookean")
  local function any(likely)
    return roll.one_of{ likely, likely, likely, sides.top, sides.bottom, sides.left, sides.right }
  end
  local slave, master = face("c", any(sides.bottom)), face("a", any(sides.top))
  if roll.uniform(0, 1) < 0.3 then slave, master = master, slave end
  if roll.uniform(0, 1) < 0.05 then master = face(slave.body, any(sides.top)) end
  add_contact(scene, slave, master, { formulation = roll.one_of(formulations.names) })
  scene.supports.bed = { on = { face("a", sides.bottom) }, fix = sides.all }
  scene.supports.grip = { on = { face("c", sides.top) }, drive = sides.all }
  if scene.axis then
    scene.supports.axis = { on = { face("a", sides.left) }, symmetry = true }
    scene.supports.grip.drive, scene.supports.grip.fix = "y", "x"
  end
  add_stage(scene, roll.integer(1, 4), 0, -roll.uniform(0.01, 0.1))
  scene.options = controls(roll)
  return scene
end

-- ── Loads ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A block under a load on one or two faces, one of which may be listed twice, and which may invert a linear body.
function families.load(seed)
  local scene, roll, sides = start(seed, "load", { "plane_strain", "plane_stress", "axisymmetric", "space" })
  local left = scene.axis and roll.one_of{ 0, 0.5 } or -1
  local patch = patches.distorted(box(scene, left, -1, left + 2, 0), roll, scene, { { 1, 0 } })
  local law = roll.one_of{ "linear_elastic", "neo_hookean" }
  add_body(scene, "a", patch, nil, 1, law)
  local on = { face("a", sides.top) }
  if roll.uniform(0, 1) < 0.4 then on[2] = face("a", sides.right) end
  if roll.uniform(0, 1) < 0.3 then on[#on + 1] = on[roll.integer(1, #on)] end
  local size = roll.uniform(-1, 1) * roll.decades(0.01, law == "linear_elastic" and 10 or 0.2)
  local value = at(scene, 0.3 * size, size)
  scene.loads.push = roll.one_of{ { on = on, kind = "pressure", value = size },
                                  { on = on, kind = "traction", value = value },
                                  { on = on, kind = "traction", value = value, slope = 0.5 } }
  scene.supports.bed = { on = { face("a", sides.bottom) }, fix = sides.all }
  if left == 0 then scene.supports.axis = { on = { face("a", sides.left) }, symmetry = true } end
  add_stage(scene, roll.integer(1, 3), 0, 0, { loads = { push = roll.uniform(0.5, 1.5) } })
  scene.options = controls(roll)
  return scene
end

-- ── Loose bodies ─────────────────────────────────────────────────────────────────────────────────────────────────────

--- A block that nothing holds but contact with friction, under its full load from the first step.
function families.loose(seed)
  local scene, roll, sides = start(seed, "loose", { "plane_strain", "plane_stress", "axisymmetric", "space" })
  local gap, left = roll.one_of{ 0, 0.001, 0.01, roll.uniform(0, 0.02) }, scene.axis and 0 or -0.5
  local E = roll.decades(0.1, 100)
  add_body(scene, "c", box(scene, left, gap, 0.5, gap + roll.uniform(0.3, 1)), sides.bottom, E,
    roll.one_of{ "linear_elastic", "neo_hookean" })
  local master = { obstacle = "t" }
  if roll.uniform(0, 1) < 0.5 then
    scene.obstacles[1] = { name = "t", shape = "plane", point = at(scene, 0, 0), normal = at(scene, 0, 1) }
  else
    add_body(scene, "a", box(scene, scene.axis and 0 or -1, -0.5, 1, 0), sides.top, E * roll.decades(0.3, 30),
      "neo_hookean")
    scene.supports.bed = { on = { face("a", sides.bottom) }, fix = sides.all }
    if scene.axis then scene.supports.inner = { on = { face("a", sides.left) }, symmetry = true } end
    master = face("a", sides.top)
  end
  if scene.axis then scene.supports.axis = { on = { face("c", sides.left) }, symmetry = true } end
  local size = E * roll.decades(1e-3, 3e-2)
  scene.loads.push = { on = { face("c", sides.top) }, kind = "traction", constant = true,
                       value = at(scene, scene.axis and 0 or roll.uniform(-0.2, 0.2) * size, -size) }
  local formulation = roll.one_of{ "gpts", "gpts", "equal", "gpts" }
  add_contact(scene, face("c", sides.bottom), master,
    { mu = roll.uniform(0.3, 1), penalty = roll.decades(10, 100) * E, formulation = formulation })
  add_stage(scene, roll.integer(1, 4), 0, 0)
  local robust = roll.one_of{ "robust", "damping" } == "robust"
  scene.options = robust and sg.robust{} or sg.plain{ damping = true }
  scene.must = (robust or not scene.space) and "complete" or nil -- in space damping alone cycles in 2 of 45
  scene.patience = 5
  return scene
end

-- ── Ends of masters ──────────────────────────────────────────────────────────────────────────────────────────────────

--- A block or an arch as the master, pressed into a slab and dragged along it beyond its ends, there and back.
function families.ends(seed)
  local scene, roll, sides = start(seed, "ends", { "plane_strain", "plane_strain", "plane_stress", "space" })
  local law = { "neo_hookean", "linear_elastic" }
  add_body(scene, "a", box(scene, -1, -0.5, 1, 0), sides.top, 1, "neo_hookean")
  local half, x, lower, held = roll.uniform(0.15, 0.5), roll.uniform(-0.8, 0.8), sides.bottom, sides.top
  if not scene.space and roll.uniform(0, 1) < 0.4 then
    add_body(scene, "c", sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = { x, 0.5 } }, lower,
      roll.decades(0.1, 10), roll.one_of(law))
    held = sides.left
  else
    add_body(scene, "c", box(scene, x - half, 0, x + half, roll.uniform(0.2, 0.5)), lower, roll.decades(0.03, 30),
      roll.one_of(law))
    if roll.uniform(0, 1) < 0.3 then held = sides.right end
  end
  scene.supports.bed = { on = { face("a", sides.bottom) }, fix = sides.all }
  scene.supports.grip = { on = { face("c", held) }, drive = sides.all }
  add_contact(scene, face("a", sides.top), face("c", lower),
    { mu = math.max(0, roll.uniform(-0.3, 0.6)), points = roll.one_of{ false, "auto", 4, 8 }, penalty = 30,
      formulation = roll.one_of{ "gpts", "gpts", "gpts", "half-passes" } })
  local depth = roll.uniform(0.005, 0.1)
  add_stage(scene, roll.integer(1, 3), 0, -depth)
  add_stage(scene, roll.integer(1, 6), roll.uniform(-1.2, 1.2), -depth * roll.uniform(-0.5, 1))
  add_stage(scene, roll.integer(1, 6), roll.uniform(-0.2, 0.2), -depth)
  scene.options = controls(roll)
  scene.patience = 3
  return scene
end

families.names = { "motion", "strip", "disc", "placed", "load", "loose", "ends" }

return families
