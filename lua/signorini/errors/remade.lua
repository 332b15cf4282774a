-- Makes a model again from the tables of sg.body and sg.model with which it was made, with changes: other elements,
-- other rows at the contact, other penalties, other points.

local compound = require "signorini.scene.compound"
local core = require "signorini.core"
local lists = require "signorini.call.lists"
local recipes = require "signorini.scene.recipes"

local remade = {}

--- Why a model cannot be made again, in words; nil if it can.
function remade.obstacle(model)
  local values = recipes.of(model)
  if not values then return "the model was not made by sg.model in this script" end
  for _, name in ipairs(lists.sorted_names(values.bodies)) do
    if not recipes.of(values.bodies[name]) then
      return ("body '%s' was not made by sg.body in this script"):format(name)
    end
  end
end

-- ── Bodies ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The bodies of a scene with those of several patches as their parts: objects in order, and the name of a part's face
--- in its body for each, "%s" or "2.%s".
local function single_bodies(bodies)
  local list = {}
  for _, name in ipairs(lists.sorted_names(bodies)) do
    local body = bodies[name]
    for i, part in ipairs(compound.is(body) and body.parts or { body }) do
      list[#list + 1] = { owner = name, object = part, face = compound.is(body) and i .. ".%s" or "%s" }
    end
  end
  return list
end

--- Calls f(face) for the faces in a value, a face or nested lists of them.
local function each_face(value, f)
  if core.kind(value) == "face" then f(value) end
  for _, one in ipairs(type(value) == "table" and value or {}) do each_face(one, f) end
end

--- The names of the faces in contact, by body: { slab = { "north" } }.
local function contact_faces(values, singles)
  local faces, objects = {}, lists.map(singles, function(one) return one.object end)
  for _, name in ipairs(lists.sorted_names(values.contacts or {})) do
    local contact = values.contacts[name]
    local master = core.kind(contact.master) ~= "obstacle" and contact.master or {}
    each_face({ contact.slave or {}, master, contact.among or {} }, function(face)
      local number, _, side = core.owner(face, objects)
      local single = singles[number]
      faces[single.owner] = lists.unique(lists.joined(faces[single.owner] or {}, { single.face:format(side) }))
    end)
  end
  return faces
end

--- The number of elements of a body of sg.body's table.
local function count(values)
  local lists_of, sum = { values.elements }, 0
  if type(values.elements[1]) == "table" then lists_of = values.elements end
  for _, elements in ipairs(lists_of) do
    local product = 1
    for _, n in ipairs(elements) do product = product * n end
    sum = sum + product
  end
  local several = type(values.patch) == "table" and type(values.elements[1]) ~= "table"
  return several and sum * #values.patch or sum
end

--- The mean size of the elements of a model in units of a scene with a single one, their number ^ (-1/dimension), and
--- the dimension.
function remade.size(model)
  local values, sum, directions = recipes.of(model), 0, 2
  for _, body in pairs(values.bodies) do
    local own = recipes.of(body)
    sum = sum + count(own)
    directions = type(own.elements[1]) == "table" and #own.elements[1] or #own.elements
  end
  return sum ^ (-1 / directions), directions
end

--- The name of a body that has one element in a direction with `factor` times the elements; nil if none has.
function remade.single(model, factor)
  local bodies = recipes.of(model).bodies
  for _, name in ipairs(lists.sorted_names(bodies)) do
    local elements = recipes.of(bodies[name]).elements
    for _, list in ipairs(type(elements[1]) == "table" and elements or { elements }) do
      if lists.any(list, function(n) return math.ceil(factor * n) == 1 end) then return name end
    end
  end
end

-- ── Changes of bodies and contacts ───────────────────────────────────────────────────────────────────────────────────

local changes = {}

--- sg.body's table with elements that are `factor` times as many per direction.
function changes.elements(values, factor)
  local function scaled(n) return type(n) == "table" and lists.map(n, scaled) or math.max(1, math.ceil(n * factor)) end
  return lists.merged(values, { elements = scaled(values.elements) })
end

local function richer(label) return label:find "^N%d+$" and ("%s-%s.2"):format(label, label) or label end

--- sg.body's table with a layer on the faces in contact, or with a layer of elements of half the size.
function changes.row(values, faces)
  local labels = type(values.order) == "table" and values.order or { values.order }
  if lists.any(labels, function(label) return label:find("-", 1, true) end) then
    local knots = values.layer_knots or 1
    if type(knots) == "table" then core.fail "layer_knots is a list, whose elements cannot be halved" end
    return lists.merged(values, { layer_knots = 2 * knots })
  end
  if not faces then return values end
  local order = type(values.order) == "table" and lists.map(values.order, richer) or richer(values.order)
  return lists.merged(values, { order = order, contact = values.contact or faces })
end

local most_points = 100

--- True if the penalty of a contact is a part of its model, not of the method that solves it.
local function is_elastic(law) return law.penalty ~= nil and law.enforcement ~= "multipliers" end

--- sg.model's table of a contact with changes. `law`: its constants in the model; a penalty that would follow from the
--- mesh is that of the model.
local function contact_again(values, law, change)
  local again, factor = lists.merged(values), change.penalty or 1
  local cohesive = values.cohesive
  if cohesive and law.law == "bilinear" then
    again.cohesive = lists.merged(cohesive, { stiffness = cohesive.stiffness or law.stiffness })
  end
  if change.default_penalty then
    again.penalty = nil
  elseif is_elastic(law) then
    again.penalty = factor * (values.penalty or law.penalty)
    local friction = values.friction
    again.friction = friction and lists.merged(friction, { penalty = friction.penalty and factor * friction.penalty })
  end
  return again
end

-- ── The model ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- True if a change of the penalties changes the model.
function remade.has_penalty(model)
  return lists.any(model:contact_names(), function(name) return is_elastic(model:contact_law(name)) end)
end

--- The largest penalty of the contacts in units of the one that follows from material and mesh; 0 without penalties.
function remade.stiffness(model)
  local most, default = 0, remade.model(model, { default_penalty = true })
  for _, name in ipairs(model:contact_names()) do
    local law = model:contact_law(name)
    if is_elastic(law) then most = math.max(most, law.penalty / default:contact_law(name).penalty) end
  end
  return most
end

--- A model of the same scene at the start of its path. change: { elements = factor of their number per direction, row =
--- true: one level richer at the contact, penalty = factor, points = factor, default_penalty = true }. Its remaining
--- constants are those of `model`, also where they would follow from the mesh.
function remade.model(model, change)
  local values, swap, again = recipes.of(model), {}, {}
  local singles = single_bodies(values.bodies)
  local faces = change.row and contact_faces(values, singles)
  local bodies = {}
  for name, body in pairs(values.bodies) do
    local own = recipes.of(body)
    if (change.elements or 1) ~= 1 then own = changes.elements(own, change.elements) end
    if change.row then own = changes.row(own, faces[name]) end
    bodies[name] = core.sg.body(own)
    swap[body] = bodies[name]
  end
  for i, single in ipairs(single_bodies(bodies)) do
    again[i] = single.object
    swap[singles[i].object] = single.object
  end
  local objects = lists.map(singles, function(one) return one.object end)

  local function swapped(value)
    if swap[value] then return swap[value] end
    if core.kind(value) == "face" then
      local number, kind, name = core.owner(value, objects)
      return again[number][kind](again[number], name)
    end
    if core.kind(value) ~= "table" or getmetatable(value) and not lists.length(value) then return value end
    local own = {}
    for key, entry in next, value do own[key] = swapped(entry) end
    return own
  end

  local scene = {}
  for key, value in pairs(values) do scene[key] = key == "bodies" and bodies or swapped(value) end
  for name, contact in pairs(scene.contacts or {}) do
    scene.contacts[name] = contact_again(contact, model:contact_law(name), change)
  end
  local made = core.sg.model(scene)
  if (change.points or 1) == 1 then return made end
  for name, contact in pairs(scene.contacts or {}) do -- of a richer row they are those of its degree
    contact.points = math.min(most_points, math.ceil(change.points * made:contact_law(name).points))
  end
  return core.sg.model(scene)
end

return remade
