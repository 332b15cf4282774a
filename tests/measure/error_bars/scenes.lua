-- Scenes whose error bars are measured: a soft slab, arch or block with a mesh on which a reasonable user would work,
-- pressed and dragged. A seed always gives the same scene; formulations and kinds of scenes take turns.

local sg = require "signorini"
local dice = require "stability.generated.dice"

local scenes = {}

scenes.formulations = { "gpts", "mortar", "multipliers" }
scenes.kinds = { "plane strain", "axisymmetric", "solid" }

-- Solids cost most.
local turns = { "plane strain", "plane strain", "axisymmetric", "solid", "plane strain", "axisymmetric" }
local layouts = {
  ["plane strain"] = { "round", "round", "round", "arch", "arch", "arch on plane", "punch" },
  axisymmetric = { "round", "round", "torus", "arch", "arch on plane", "punch" },
  solid = { "round", "round", "round", "roll", "punch" },
}

local function keys_of(formulation, roll)
  if formulation == "gpts" then return {} end
  return { method = "mortar", multipliers = roll.one_of{ "equal", "reduced" },
           enforcement = formulation == "multipliers" and "multipliers" or nil }
end

local function draw_material(roll, E)
  local nu = roll.uniform(0, 0.45)
  local mu, K = E / (2 * (1 + nu)), E / (3 * (1 - 2 * nu))
  return roll.one_of{ sg.neo_hookean{ E = E, nu = nu }, sg.mooney_rivlin{ c10 = 0.4 * mu, c01 = 0.1 * mu, K = K },
                      sg.linear_elastic{ E = E, nu = nu } }
end

-- ── Parts ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A box between two corners of the plane; of solids with the depth from 0 to `deep`.
local function box(low, high, deep)
  if deep then
    return sg.shapes.block{ size = { high[1] - low[1], deep, high[2] - low[2] }, corner = { low[1], 0, low[2] } }
  end
  return sg.shapes.rectangle{ width = high[1] - low[1], height = high[2] - low[2], corner = low }
end

local function elements(length, size) return math.max(2, math.floor(length / size + 0.5)) end

--- Elements of a box of that many along and through it, with those of the depth between.
local function box_elements(along, through, deep)
  if deep then return { along, deep, through } end
  return { along, through }
end

local tools = {}

--- Obstacles that touch y = 0 (z = 0 of solids) at x = 0.
function tools.round(kind, radius)
  if kind == "plane strain" then return sg.rigid.cylinder{ center = { 0, radius }, radius = radius } end
  return sg.rigid.sphere{ center = kind == "solid" and { 0, 0, radius } or { 0, radius }, radius = radius }
end

function tools.torus(_, radius) -- which must not reach the axis
  radius = math.min(radius, 0.99)
  return sg.rigid.torus{ center = { 1, radius }, radius = radius }
end

function tools.roll(_, radius)
  return sg.rigid.cylinder{ center = { 0, 0, radius }, axis = { 0, 1, 0 }, radius = radius }
end

-- ── Scenes ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The scene of a seed: model, stages, and what it is: { kind, formulation, friction, sharp, text }.
function scenes.make(seed)
  local roll, turn = dice(seed), (seed - 1) // 2
  local kind, formulation = turns[turn // 3 % #turns + 1], scenes.formulations[turn % 3 + 1]
  local solid, axis = kind == "solid", kind == "axisymmetric"
  local layout = roll.one_of(layouts[kind])
  local order = roll.one_of(solid and { "N2", "N2", "N2-N2.2" } or { "N2", "N2", "N3", "N2-N2.2", "N2-N4" })
  local mu = roll.uniform(0, 1) < 0.5 and roll.uniform(0.1, 0.5) or nil
  local radius, height = roll.uniform(0.5, 1.2), roll.uniform(0.6, 1)
  -- Half of the contact's width, and elements over all of it: at least three of twice the size.
  local a = roll.uniform(0.25, 0.45)
  local depth = math.min(a ^ 2 / radius, 0.15 * height)
  a = layout == "punch" and a or math.sqrt(depth * radius)
  local h = 2 * a / (solid and roll.uniform(4, 5.5) or axis and roll.uniform(9, 14) or roll.uniform(6, 10))
  if layout == "punch" then depth = roll.uniform(0.02, 0.08) * height end
  local stays = axis or layout == "punch" and solid or layout == "arch on plane" and not mu
  local drag = not stays and roll.uniform(0, 1) < (solid and 0.4 or 0.7) and roll.uniform(0.3, solid and 0.8 or 2) * a
    or 0
  local margin = (solid and 1.6 or 2.4) * a
  local left, right = -margin, drag + margin
  if axis then left, right = 0, layout == "torus" and 1 + margin or 1.4 * margin end
  if solid and drag == 0 then left = 0 end
  local deep, deep_elements = nil, nil
  if solid then
    deep = layout == "roll" and roll.uniform(0.5, 1) or margin
    deep_elements = layout == "roll" and roll.integer(2, 3) or elements(deep, h)
  end
  local top, bottom = solid and "back" or "north", solid and "front" or "south"
  local all, up = solid and "xyz" or "xy", solid and "z" or "y"
  local contact = keys_of(formulation, roll)
  local bodies, supports, softest, upper, tool = {}, {}, 1, nil, nil

  -- What is pressed down: an obstacle or a body
  if layout == "arch" or layout == "arch on plane" then
    local quarter = axis
    local E = layout == "arch" and roll.decades(3, 300) or 1
    local thick = layout == "arch" and 0.6 or 0.4
    local count = elements(math.pi / 2 * radius, h * roll.uniform(0.8, 1.3))
    upper = sg.body{ patch = sg.shapes[quarter and "quarter_annulus" or "half_annulus"]{ outer = radius,
        inner = thick * radius, center = { 0, radius } }, contact = "south", order = order,
      elements = { quarter and count or 2 * count, elements((1 - thick) * radius, 2 * h) },
      material = draw_material(roll, E) }
    supports.grip = { on = quarter and upper:face "east" or { upper:face "west", upper:face "east" }, drive = "y",
                      fix = "x" }
    if not quarter then supports.grip.drive, supports.grip.fix = "xy", nil end
    bodies.upper = upper
    if quarter then supports.pole = { on = upper:face "west", symmetry = true } end
  elseif layout == "punch" then
    local low = (axis or solid and drag == 0) and 0 or -a
    upper = sg.body{ patch = box({ low, 0 }, { a, a }, solid and a or nil), contact = bottom, order = order,
      elements = box_elements(elements(a - low, h), elements(a, 2 * h), solid and elements(a, h) or nil),
      material = draw_material(roll, roll.decades(1, 30)) }
    supports.grip = { on = upper:face(top), drive = up, fix = solid and "xy" or "x" }
    if not axis and not solid then supports.grip.drive, supports.grip.fix = "xy", nil end
    if axis or solid then supports.pole = { on = upper:face "west", symmetry = true } end
    if solid then supports.half = { on = upper:face "south", symmetry = true } end
    bodies.upper = upper
  else
    tool = tools[layout](kind, radius)
    supports.grip = { on = tool, drive = axis and "y" or solid and drag == 0 and "z" or solid and "xz" or "xy" }
    if solid and drag == 0 then supports.grip.fix = "xy" elseif solid then supports.grip.fix = "y" end
    if axis or solid then supports.grip.fix = nil end
  end

  -- What it is pressed on: a slab, or a plane
  local slave, master = nil, nil
  if layout == "arch on plane" then
    local tilt = axis and 0 or roll.one_of{ 0, roll.uniform(-0.1, 0.1) }
    local length = math.sqrt(1 + tilt ^ 2)
    slave = upper:face "south"
    master = sg.rigid.plane{ point = { -radius * tilt / length, radius - radius / length }, normal = { tilt, 1 } }
  else
    local slab = sg.body{ patch = box({ left, -height }, { right, 0 }, deep), contact = top, order = order,
      elements = box_elements(elements(right - left, h), elements(height, h * roll.uniform(1.2, 2.2)), deep_elements),
      material = draw_material(roll, 1) }
    bodies.slab = slab
    supports.bed = { on = slab:face(bottom), fix = all }
    if left == 0 then supports.west = { on = slab:face "west", symmetry = true } end
    if solid then supports.south = { on = slab:face "south", symmetry = true } end
    slave, master = slab:face(top), tool
    if upper then
      local face = upper:face(bottom)
      -- multipliers belong on the softer body, whose elements are finer here
      if formulation ~= "multipliers" and roll.uniform(0, 1) < 0.5 then slave, master = face, slave
      else master = face end
    end
  end
  contact.slave, contact.master = slave, master
  contact.penalty = formulation ~= "multipliers" and roll.one_of{ roll.decades(30, 500) * softest / h, false } or nil
  contact.friction = mu and { mu = mu } or nil

  -- The path
  local steps = solid and { roll.integer(2, 3), roll.integer(2, 4) } or { roll.integer(2, 6), roll.integer(4, 12) }
  local function at(x, y)
    if axis or solid and drag == 0 or layout == "punch" and solid then return y end
    return { x, y }
  end
  local list = { { steps = steps[1], grip = at(0, -depth) }, { steps = steps[2], grip = at(drag, -depth) } }
  if drag == 0 then list = { { steps = solid and 4 or math.max(4, steps[2] // 2), grip = at(0, -depth) } } end
  if drag > 0 and roll.uniform(0, 1) < 0.2 then table.remove(list, 1) end -- both at once

  local model = sg.model{ kind = not solid and (axis and "axisymmetric" or "plane_strain") or nil, bodies = bodies,
                          supports = supports, contacts = { c = contact } }
  return model, list, { kind = kind, formulation = formulation, friction = mu ~= nil, sharp = layout == "punch",
    text = ("%d: %s, %s, %s %s, %s, mu %.2g, penalty %s, %d stages"):format(seed, kind, layout, formulation,
      contact.multipliers or "", order, mu or 0, contact.penalty and ("%.3g E/h"):format(contact.penalty * h)
        or "default", #list) }
end

return scenes
