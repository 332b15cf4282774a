-- The model, the stages and the options of a generated scene in a frame.

local sg = require "signorini"
local frames = require "robustness.frame"
local laws = require "robustness.laws"

local build = {}

-- ── Bodies and obstacles ─────────────────────────────────────────────────────────────────────────────────────────────

--- The name of a face, an edge or a corner in the frame, also of a part: "1.west".
local function place(frame, body, name)
  local part, rest = name:match "^(%d+%.)(.*)$"
  if not part and body.patches then return name end -- a boundary
  return (part or "") .. frame:place(body.name, rest or name)
end

local function body_of(frame, body)
  local contact = body.contact and place(frame, body, body.contact)
  local along = {} -- the directions of the contact face
  if body.contact and not body.patches then
    local across = frames.faces[body.contact][1]
    for i = 1, #body.elements do
      if i ~= across then along[#along + 1] = i end
    end
  end
  local patch = body.patch and frame:patch(body.patch, body.name)
  if body.patches then
    patch = {}
    for i, data in ipairs(body.patches) do patch[i] = frame:patch(data, body.name) end
    patch.boundaries = {}
    for name, list in pairs(body.boundaries) do
      patch.boundaries[name] = {}
      for i, one in ipairs(list) do patch.boundaries[name][i] = place(frame, body, one) end
    end
  end
  local layer = body.layer
  if body.layer_bound then
    layer = function(X) return frame:back(table.unpack(X))[1] < body.layer_bound end
  elseif layer and #along == 1 then
    layer = frame:per_direction(body.name, { layer }, along)[1]
  elseif layer then
    layer = frame:per_direction(body.name, layer, along)
  end
  return sg.body{ patch = patch, elements = frame:per_direction(body.name, body.elements), order = body.order,
                  contact = contact, layer = layer, layer_knots = body.layer_knots,
                  thickness_degree = body.thickness_degree, volumetric = body.volumetric,
                  material = laws.material(body.material, frame) }
end

--- The box around the images of the corners of a cube.
local function image_of_cube(frame, center, half)
  local low, high = {}, {}
  for k = 0, 2 ^ frame.size - 1 do
    local corner = {}
    for i = 1, frame.size do corner[i] = center[i] + half * (((k >> (i - 1)) & 1) * 2 - 1) end
    for i, value in ipairs(frame:point(corner)) do
      low[i], high[i] = math.min(low[i] or value, value), math.max(high[i] or value, value)
    end
  end
  return { low, high }
end

local obstacles = {
  plane = function(frame, o)
    return sg.rigid.plane{ point = frame:point(o.point), normal = frame:direction(o.normal) }
  end,
  cylinder = function(frame, o)
    return sg.rigid.cylinder{ center = frame:point(o.center), axis = o.axis and frame:direction(o.axis),
                              radius = o.radius * frame.length, inside = o.inside }
  end,
  sphere = function(frame, o)
    return sg.rigid.sphere{ center = frame:point(o.center), radius = o.radius * frame.length, inside = o.inside }
  end,
  torus = function(frame, o)
    return sg.rigid.torus{ center = frame:point(o.center), axis = o.axis and frame:direction(o.axis),
                           ring = o.ring and o.ring * frame.length, radius = o.radius * frame.length,
                           inside = o.inside }
  end,
  surface = function(frame, o)
    local patch = frame:patch(o.patch)
    return sg.rigid.surface(o.inside and patch:reverse(1) or patch)
  end,
  level_set = function(frame, o)
    return sg.rigid.level_set{ f = function(...)
      local x, sum = frame:back(...), nil
      for i, c in ipairs(o.center) do
        local term = ((x[i] - c) / o.radius) ^ (i == 1 and o.exponent or 2)
        sum = sum and sum + term or term
      end
      return o.inside and 1 - sum or sum - 1
    end, box = image_of_cube(frame, o.center, 1.3 * o.radius) }
  end,
}

-- ── Supports and loads ───────────────────────────────────────────────────────────────────────────────────────────────

local function support_of(frame, data, on)
  local support = { on = on, fix = frame:components(data.fix), drive = frame:components(data.drive),
                    free = frame:components(data.free), symmetry = data.symmetry, angle = data.angle }
  if data.spring then support.spring = frame:stiffness(data.spring, frame.stress / frame.length) end
  if data.rotate then
    support.rotate = type(data.rotate) == "table" and frame:pseudo(data.rotate) or data.rotate
    support.center = data.center and frame:point(data.center)
  end
  return support
end

--- The factor of units of a load.
local function units_of(frame, load)
  if load.kind ~= "force" then return frame.stress end
  local powers = { volume = -1, corner = frame.solid and 2 or 1, edge = 1, obstacle = frame.solid and 2 or 1 }
  return frame.stress * frame.length ^ powers[load.of]
end

--- The value of a load times a factor.
local function load_value(frame, load, factor)
  local units = units_of(frame, load) * factor
  if type(load.value) == "table" then return frame:scaled(load.value, units) end
  return load.value * units
end

local function load_of(frame, load, on)
  local result = { on = on, follower = load.follower }
  if load.slope then
    result[load.kind] = function(...)
      return load_value(frame, load, 1 + load.slope * frame:back(...)[1])
    end
    result.factor = 0.0
  else
    result[load.kind] = load_value(frame, load, (load.of == "obstacle" or load.constant) and 1 or 0)
  end
  return result
end

-- ── The scene ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The targets of "grip" in a stage, in the order of its driven components.
local function grip_targets(frame, grip, stage)
  local values, last = {}, nil
  for i, axis in ipairs{ "x", "y", "z" } do
    if grip.drive and grip.drive:find(axis, 1, true) then values[#values + 1] = stage.at[i] end
  end
  local targets = grip.drive and frame:driven(grip.drive, values) or {}
  last = grip.rotate and grip.angle ~= "free"
  if last then targets[#targets + 1] = (frame.space and 1 or frame.sign) * stage.angle end
  return targets
end

local function change_of(frame, contact, what)
  local law = contact.law
  if law.adhesion then return nil end
  if what == "penalty" then return { penalty = 1.3 * law.penalty * frame.stress / frame.length } end
  if what == "mu" and law.mu > 0 then return { friction = { mu = 0.5 * law.mu } } end
  if what == "offset" and law.offset then return { offset = (law.offset + 0.005) * frame.length } end
  if what == "active" then return { active = law.active == false } end
end

local function stages_of(frame, scene)
  local stages = {}
  local grip = scene.supports.grip
  local before = grip and grip_targets(frame, grip, { at = { 0, 0, 0 }, angle = 0 })
  for i, data in ipairs(scene.stages) do
    local stage = { name = "stage " .. i, steps = data.steps }
    if grip then
      local targets = grip_targets(frame, grip, data)
      local from = before
      if #targets > 0 then
        stage[frame:name "grip"] = data.curved and function(s)
          local now = {}
          for k, value in ipairs(targets) do now[k] = from[k] + (value - from[k]) * s * (2 - s) end
          return now
        end or targets
        before = targets
      end
    end
    if scene.supports.clash then stage[frame:name "clash"] = frame:driven(scene.supports.clash.drive, { 0.01 }) end
    for name, factor in pairs(data.loads) do
      local load = scene.loads[name]
      stage[frame:name(name)] = load.slope and factor or load_value(frame, load, factor)
    end
    local change = data.change and change_of(frame, scene.contacts[1], data.change)
    if change then stage.contacts = { [frame:name "k1"] = change } end
    stages[i] = stage
  end
  return stages
end

--- The parts of sg.model, and the stages. Errors are those of the functions called with them.
function build.parts(scene, frame)
  local made, bodies, tools = {}, {}, {}
  for _, body in ipairs(scene.bodies) do
    made[body.name] = body_of(frame, body)
    bodies[frame:name(body.name)] = made[body.name]
  end
  local by_name = {}
  for _, body in ipairs(scene.bodies) do by_name[body.name] = body end
  for _, data in ipairs(scene.obstacles) do tools[data.name] = obstacles[data.shape](frame, data) end
  local function one(reference)
    if reference.obstacle then return tools[reference.obstacle] end
    local body, data = made[reference.body], by_name[reference.body]
    if reference.face then return body:face(place(frame, data, reference.face)) end
    if reference.corner then return body:corner(place(frame, data, reference.corner)) end
    if reference.edge then return body:edge(place(frame, data, reference.edge)) end
    return body
  end
  local function several(references)
    if #references == 1 then return one(references[1]) end
    local list = {}
    for i, reference in ipairs(references) do list[i] = one(reference) end
    return list
  end
  local scene_of = { bodies = bodies, supports = {}, loads = {}, contacts = {}, joins = {}, ties = {} }
  if not scene.space then scene_of.kind = scene.kind end
  for name, data in pairs(scene.supports) do
    scene_of.supports[frame:name(name)] = support_of(frame, data, several(data.on))
  end
  for name, data in pairs(scene.loads) do
    scene_of.loads[frame:name(name)] = load_of(frame, data, several(data.on))
  end
  for _, contact in ipairs(scene.contacts) do
    scene_of.contacts[frame:name(contact.name)] =
      laws.contact(contact.law, several(contact.slave), several(contact.master), frame)
  end
  for name, pair in pairs(scene.joins) do scene_of.joins[frame:name(name)] = { one(pair[1]), one(pair[2]) } end
  for name, pair in pairs(scene.ties) do
    scene_of.ties[frame:name(name)] = { slave = one(pair[1]), master = one(pair[2]), multipliers = pair.multipliers }
  end
  return scene_of, stages_of(frame, scene)
end

--- The model of a scene and its stages.
function build.model(scene, frame)
  local scene_of, stages = build.parts(scene, frame)
  return sg.model(scene_of), stages
end

return build
