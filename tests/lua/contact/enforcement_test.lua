-- The contact key `enforcement`, and penalty parameters from material and mesh.

require "check"
local show = require "signorini.prompt.show"

local here = "enforcement_test.lua:"

local function block(y, count, young, contact)
  return scenes.body{ corner = { 0, y }, elements = { count, 2 }, contact = contact, E = young }
end

--- A block of 4 elements, E = 20, over one of 8 elements, E = 3, or over a plane; keys of the contact.
local function scene(keys, on_plane)
  local upper, lower = block(0, 4, 20, "south"), block(-1, 8, 3, "north")
  keys.slave = upper:face "south"
  keys.master = on_plane and scenes.floor() or lower:face "north"
  return sg.model{
    bodies   = { upper = upper, lower = not on_plane and lower or nil },
    supports = { grip = { on = upper:face "north", fix = "x", drive = "y" },
                 bed = not on_plane and { on = lower:face "south", fix = "xy" } or nil },
    contacts = { joint = keys },
  }
end

local function law(keys, on_plane) return scene(keys, on_plane):contact_law "joint" end

-- ── Wrong input ──────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("combinations that do not exist are errors that name those that do", function()
  local wrong = {
    { { method = "gpts", enforcement = "multipliers", penalty = 1 },
      'it has enforcement = "multipliers" and method = "gpts"', 'write method = "mortar"' },
    { { enforcement = "multipliers" }, 'Lagrange multipliers need mortar contact' },
    { { augmented = true, penalty = 1 }, "unknown argument 'augmented'",
      'Hint: write method = "mortar", enforcement = "multipliers"' },
    { { adhesion = { hamaker = 1, r0 = 1 }, enforcement = "multipliers" }, "adhesion", 'enforcement = "multipliers"' },
  }
  for _, case in ipairs(wrong) do
    check.fails(function() scene(case[1]) end, here, "sg.model: contacts.joint", table.unpack(case, 2))
  end
end)

check.case("options that no contact can use are errors", function()
  local path = { { steps = 1, grip = -0.01 } }
  local plain = scene{ penalty = 10 }
  check.fails(function() plain:run(path, { augmentation = { loops = 5 } }) end, here,
    "unknown argument 'augmentation'", 'method = "mortar", enforcement = "multipliers"')
  check.fails(function() plain:run(path, { enforcement = "multipliers" }) end, here, "unknown argument 'enforcement'",
    "Hint: write it in the contact")
end)

-- ── Default penalties ────────────────────────────────────────────────────────────────────────────────────────────────

check.case("by default the penalty is 30 E/h, E of the softer body, h of the slave; with multipliers 10 E/h", function()
  local joint = law{ method = "mortar", enforcement = "multipliers", friction = { mu = 0.3 } }
  check.near({ joint.penalty, joint.friction_penalty }, { 10 * 3 * 8, 10 * 3 * 8 }, 1e-9)
  check.equal({ joint.default_penalty, joint.enforcement, joint.method, joint.mu },
    { true, "multipliers", "mortar", 0.3 })
  check.near(law({ method = "mortar", enforcement = "multipliers" }, true).penalty, 10 * 20 * 4, 1e-9)
  local partial = law{ method = "mortar", enforcement = "multipliers", where = function(X) return X[1] < 0.3 end }
  check.near(partial.penalty, 10 * 3 * 8, 1e-9)
  check.equal({ joint.multipliers, joint.per }, { "linear", "reference" })
  for _, alone in ipairs { {}, { method = "mortar" }, { method = "half_passes" } } do
    alone.friction = { mu = 0.3 }
    local joint = law(alone)
    check.near({ joint.penalty, joint.friction_penalty }, { 30 * 3 * 4, 30 * 3 * 4 }, 1e-9)
    check.equal(joint.default_penalty, true)
  end
  check.equal(law{ penalty = 7, friction = { mu = 0.3 } }.friction_penalty, 7.0)
  local given = law{ method = "mortar", enforcement = "multipliers", penalty = 50, friction = { mu = 0.3 } }
  check.equal({ given.penalty, given.friction_penalty, given.default_penalty }, { 50.0, 50.0, false })
end)

check.case("in 3D h is the square root of an element's area, in an axisymmetric model its length", function()
  local cube = scenes.body{ size = { 2, 3, 1 }, elements = { 4, 3, 1 }, contact = "front",
    material = sg.linear_elastic{ E = 5, nu = 0.3 } }
  local solid = scenes.model{ bodies = { cube = cube }, contacts = { floor = { slave = "front",
    method = "mortar", enforcement = "multipliers",
    master = sg.rigid.plane{ point = { 0, 0, -1 }, normal = { 0, 0, 1 } } } } }
  check.near(solid:contact_law("floor").penalty, 10 * 5 / math.sqrt(0.5 * 1), 1e-9)
  local puck = block(0, 4, 20, "south")
  local round = scenes.model{ kind = "axisymmetric", bodies = { puck = puck },
    contacts = { floor = { slave = "south",
      method = "mortar", enforcement = "multipliers", master = scenes.floor(-1) } } }
  check.near(round:contact_law("floor").penalty, 10 * 20 * 4, 1e-9)
end)

check.case("print shows them", function()
  local default = 'method = "mortar", multipliers = "linear", enforcement = "multipliers", '
    .. "penalty = 240 (from material and mesh)"
  local keys = { method = "mortar", enforcement = "multipliers" }
  check.holds(show.text(scene(keys)), "contact joint: open\n    " .. default)
  keys.friction = { mu = 0.3 }
  check.holds(show.text(scene(keys)), default, ", mu = 0.3, friction.penalty = 240")
  check.holds(show.text(scene{ method = "mortar", multipliers = "reduced", penalty = 5 }),
    'method = "mortar", multipliers = "reduced", enforcement = "penalty", penalty = 5')
  check.holds(show.text(scene{ method = "half_passes", penalty = 5 }),
    'method = "half_passes", enforcement = "penalty"')
  check.holds(show.text(scene{ adhesion = { hamaker = 1, r0 = 0.1 } }), "hamaker = 1, r0 = 0.1")
end)

-- ── Runs ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Presses the upper block into the other by 0.05, with friction.
local function press(keys)
  keys.friction = { mu = 0.2 }
  local model = scene(keys)
  check.completed(model:run{ { steps = 2, grip = -0.05 } })
  return model
end

check.case("with multipliers forces hardly depend on the penalty", function()
  local forces = {}
  for i, penalty in ipairs { 60, 240, 1e3 } do
    forces[i] = press{ method = "mortar", enforcement = "multipliers", penalty = penalty }:reaction("grip").fy
  end
  local default = press{ method = "mortar", enforcement = "multipliers" }
  for _, force in ipairs(forces) do check.within_share("force", force, default:reaction("grip").fy, 2e-3) end
  check.holds(show.text(default), 'enforcement = "multipliers", penalty = 240 (from material and mesh)')
end)
