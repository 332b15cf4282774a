-- Generated scenes that are right in form and may be absurd in content: a slab of one or two parts, a body, two bodies
-- or an obstacle above it, any supports, loads, contacts, paths and controls. A seed always gives the same scene.

local dice = require "stability.generated.dice"
local families = require "robustness.families"
local laws = require "robustness.laws"
local parts = require "robustness.parts"

local scenes = {}

local kinds = { "plane_strain", "plane_strain", "plane_strain", "plane_strain", "plane_stress", "axisymmetric",
                "axisymmetric", "space" }
local layouts = { "tool", "tool", "two", "two", "two", "stack", "joined", "compound" }

local Scene = {}
Scene.__index = Scene

--- Whether an absurd feature is drawn, which is noted.
function Scene:odd(chance, name)
  local drawn = self.roll.uniform(0, 1) < chance * self.wild
  if drawn then self.oddities[#self.oddities + 1] = name end
  return drawn
end

-- ── Supports ─────────────────────────────────────────────────────────────────────────────────────────────────────────

local function draw_supports(scene, roll, faces)
  local all, last = scene.space and "xyz" or "xy", scene.space and "z" or "y"
  local supports = scene.supports
  local bed = { on = faces.bottom, fix = all }
  local way = roll.one_of{ "fixed", "fixed", "fixed", "fixed", "sides", "spring" }
  if scene.kind == "axisymmetric" then
    bed.fix = roll.one_of{ "xy", "y" }
    supports.axis = { on = { faces.left }, symmetry = true }
  elseif way == "sides" then
    bed.fix = last
    supports.left = { on = { faces.left }, fix = scene.space and "xy" or "x" }
  elseif way == "spring" then
    bed.fix, bed.spring = nil, scene.space and { 2, 3, 4 } or { 2, 3 }
    if scene:odd(0.3, "extreme springs") then
      local factor = roll.decades(1e-9, 1e9)
      for i, k in ipairs(bed.spring) do bed.spring[i] = factor * k end
    end
  end
  supports.bed = bed
  if scene:odd(0.1, "slab without supports") then supports.bed, supports.axis, supports.left = nil, nil, nil end
  local grip = { on = faces.held, drive = all }
  if faces.tool then
    grip.on = { faces.tool }
    local free = roll.uniform(0, 1)
    if scene.kind == "axisymmetric" then
      grip.drive = "y"
      if free < 0.2 then grip.drive, grip.free = nil, "y" end
    elseif free < 0.2 then
      grip.drive, grip.free = scene.space and "xy" or "x", last
    end
    local turns = { round = true, roll = true, surface = true, level_set = true }
    if turns[scene.shape] and scene.kind ~= "axisymmetric" and roll.uniform(0, 1) < 0.3 then
      grip.rotate = scene.space and { 0, 1, 0 } or true
      if scene.shape == "surface" or scene.shape == "level_set" or scene:odd(0.3, "center far from the obstacle") then
        grip.center = scene.space and { 0, 0, 0.4 } or { 0, 0.4 }
      end
      if grip.free and roll.uniform(0, 1) < 0.4 then grip.angle = "free" end
    end
    if grip.free then
      local weight = roll.decades(0.01, 0.05)
      if scene:odd(0.2, "extreme weight") then weight = weight * roll.decades(1e-9, 1e9) end
      if scene:odd(0.3, "free obstacle without a load") then weight = 0 end
      local force = scene.space and { 0, 0, -weight } or { 0, -weight }
      scene.loads.weight = { on = { faces.tool }, kind = "force", of = "obstacle", value = force }
    end
  elseif scene.kind == "axisymmetric" then
    grip.drive, grip.fix = "y", "x"
    if scene.shape == "arch" then supports.pole = { on = { { body = "c", face = "west" } }, symmetry = true } end
  else
    local how = roll.uniform(0, 1)
    if how < 0.1 then
      grip.drive = last
    elseif how < 0.2 and #faces.held == 1 then
      grip.rotate, grip.drive = scene.space and { 0, 0, 1 } or true, all
    end
  end
  supports.grip = grip
  if scene:odd(0.1, "no grip") then supports.grip = nil end
  if scene:odd(0.1, "contradictory supports") then supports.clash = { on = faces.bottom, drive = last } end
  if scene:odd(0.1, "support of a face in contact") then supports.held_top = { on = faces.top, fix = "x" } end
  if scene:odd(0.1, "everything fixed") then
    supports.all = { on = { faces.left, faces.right, faces.top[1] }, fix = all }
  end
end

-- ── Loads ────────────────────────────────────────────────────────────────────────────────────────────────────────────

local function draw_loads(scene, roll, faces)
  local size = roll.uniform(-0.03, 0.03)
  if scene:odd(0.15, "extreme load") then size = size * roll.decades(1, 1e9) end
  local side = scene.space and { 0.3 * size, 0.1 * size, size } or { 0.3 * size, size }
  local pick = roll.integer(1, 14)
  local corner = scene.space and "east-north-back" or "north-east"
  local loads = {
    { on = { faces.right }, kind = "traction", value = side },
    { on = { faces.right }, kind = "pressure", value = size },
    { on = { faces.right }, kind = "pressure", value = size, follower = true },
    { on = { { body = scene.bodies[#scene.bodies].name } }, kind = "force", of = "volume", value = side },
    { on = { faces.right }, kind = "traction", value = side, slope = 0.7 },
    { on = { faces.right }, kind = "pressure", value = size, slope = 0.7, follower = roll.uniform(0, 1) < 0.5 },
    { on = { { body = scene.bodies[1].name, corner = corner } }, kind = "force", of = "corner", value = side },
  }
  if scene.space then
    local edge = { body = scene.bodies[1].name, edge = "east-back" }
    loads[8] = { on = { edge }, kind = "force", of = "edge", value = side }
  end
  if scene.layout == "compound" then loads[7], loads[8] = nil, nil end
  if loads[pick] then scene.loads.push = loads[pick] end
end

-- ── Paths ────────────────────────────────────────────────────────────────────────────────────────────────────────────

local function draw_stages(scene, roll)
  local down = math.max(0, scene.gap)
  local depth, x, angle = down + roll.uniform(0.01, 0.06), 0, 0
  local last = scene.space and 3 or 2
  for i = 1, roll.one_of{ 1, 2, 2, 3 } do
    local stage = { steps = roll.integer(1, 3), at = { 0, 0, scene.space and 0 or nil }, loads = {} }
    if i > 1 then
      depth = depth + roll.uniform(-0.04, 0.03)
      x = x + roll.uniform(-0.2, 0.2)
    end
    if roll.uniform(0, 1) < 0.3 then angle = angle + roll.uniform(-8, 8) end
    if scene:odd(0.08, "extreme path") then depth = depth * roll.decades(1, 1e3) end
    if scene:odd(0.08, "path in the opposite direction") then depth = -roll.uniform(0, 1) end
    if scene:odd(0.08, "huge turn") then angle = angle + roll.one_of{ 180, 720, -1e5 } end
    stage.at[1], stage.at[last], stage.angle = x, -depth, angle
    if scene:odd(0.1, "stage without motion") and scene.stages[i - 1] then
      stage.at, stage.angle = scene.stages[i - 1].at, scene.stages[i - 1].angle
    end
    stage.curved = roll.uniform(0, 1) < 0.1
    if scene.loads.push and roll.uniform(0, 1) < 0.5 then stage.loads.push = roll.uniform(-1, 2) end
    if i > 1 and roll.uniform(0, 1) < 0.3 then
      stage.change = roll.one_of{ "penalty", "mu", "offset", "active" }
    end
    scene.stages[i] = stage
  end
end

-- ── Scenes ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The scene of a seed, as plain data: kind, layout, oddities (the names of what is absurd), bodies, obstacles,
--- supports, loads, contacts, joins, ties, stages and options. `family`: one of families.names (default: any scene).
function scenes.describe(seed, family)
  if family then return families[family](seed) end
  local roll = dice(seed)
  local scene = setmetatable({ seed = seed, kind = roll.one_of(kinds), layout = roll.one_of(layouts),
                               wild = roll.one_of{ 0, 0, 1, 1, 2, 6 }, roll = roll, oddities = {}, bodies = {},
                               obstacles = {}, supports = {}, loads = {}, contacts = {}, joins = {}, ties = {},
                               stages = {} }, Scene)
  scene.space = scene.kind == "space"
  local x = roll.uniform(-0.5, 0.5)
  scene.gap = roll.one_of{ roll.uniform(0.001, 0.03), 0, -roll.uniform(0, 0.002) }
  if scene:odd(0.1, "initial overlap") then scene.gap = -roll.decades(1e-3, 1) end
  if scene:odd(0.1, "huge gap") then scene.gap = roll.decades(1, 1e6) end
  if scene:odd(0.05, "wrong side") then scene.gap = -3 end
  if scene:odd(0.1, "beyond the slab") then x = roll.one_of{ -1.2, 1.1, 1.9, 40 } end
  local faces = {}
  faces.top, faces.bottom, faces.left, faces.right = parts.slab(scene, roll)
  local pairs_of_faces, softest = {}, 1
  if scene.layout == "tool" or ((scene.layout == "joined" or scene.layout == "compound") and roll.uniform(0, 1) < 0.4)
  then
    faces.tool = parts.tool(scene, roll, x, scene.gap)
    pairs_of_faces[1] = { faces.top, { faces.tool } }
  else
    faces.lower, faces.held, faces.upper = parts.upper(scene, roll, x, scene.gap)
    pairs_of_faces[1] = { faces.top, { faces.lower } }
    if roll.uniform(0, 1) < 0.5 then pairs_of_faces[1] = { { faces.lower }, faces.top } end
    softest = math.min(1, scene.bodies[#scene.bodies].material.E)
  end
  if scene.ties.seam then -- faces of tied bodies do not act as one
    pairs_of_faces[2] = { { faces.top[2] }, { faces.tool or faces.lower } }
    pairs_of_faces[1] = { { faces.top[1] }, pairs_of_faces[2][2] }
  end
  local rigid = faces.tool ~= nil
  if scene.layout == "stack" and scene.shape == "block" then -- an obstacle presses the body between
    local data = scene.bodies[#scene.bodies].patch.points
    local top = -math.huge
    for _, point in ipairs(data) do top = math.max(top, point[#point]) end
    faces.tool = parts.tool(scene, roll, x, top + math.max(0, scene.gap))
    table.insert(pairs_of_faces, { { faces.upper }, { faces.tool } })
  end
  if scene:odd(0.05, "contact given twice") then pairs_of_faces[#pairs_of_faces + 1] = pairs_of_faces[1] end
  if scene:odd(0.05, "contact of a face with itself") then
    pairs_of_faces[#pairs_of_faces + 1] = { faces.top, faces.top }
  end
  if scene:odd(0.05, "slave and master exchanged") then
    pairs_of_faces[1] = { pairs_of_faces[1][2], pairs_of_faces[1][1] }
  end
  if scene:odd(0.05, "wrong face") then pairs_of_faces[1][1] = faces.bottom end
  for i, pair in ipairs(pairs_of_faces) do
    local is_rigid = pair[2][1].obstacle ~= nil or (rigid and i == 1)
    scene.contacts[i] = { name = "k" .. i, slave = pair[1], master = pair[2],
                          law = laws.draw_contact(scene, roll, is_rigid, softest) }
  end
  draw_supports(scene, roll, faces)
  draw_loads(scene, roll, faces)
  draw_stages(scene, roll)
  scene.options = laws.draw_options(scene, roll)
  return scene
end

--- A description in one line.
function scenes.text(scene)
  local bodies, contacts = {}, {}
  for i, one in ipairs(scene.bodies) do
    bodies[i] = ("%s %s %s %s"):format(one.name, one.order, table.concat(one.elements, "x"), one.material.law)
  end
  for i, contact in ipairs(scene.contacts) do
    local law = contact.law
    contacts[i] = ("%s mu %.2g"):format(law.adhesion and "adhesion" or law.cohesive and "cohesive" or law.formulation,
      law.mu)
  end
  return ("%d: %s, %s, %s; %s; %s%s"):format(scene.seed, scene.kind, scene.layout, scene.shape,
    table.concat(bodies, ", "), table.concat(contacts, ", "),
    #scene.oddities > 0 and "; odd: " .. table.concat(scene.oddities, ", ") or "")
end

return scenes
