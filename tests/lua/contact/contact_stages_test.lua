-- Constants of contacts that stages change: friction switched on and off, contacts switched off and on, penalties; all
-- methods and enforcements; checkpoints, roll-backs, energies, errors.

require "check"
local contact_keys = require "contact_keys"
local show = require "signorini.prompt.show"
local tangents = require "tangents"

local here = "contact_stages_test.lua:"
local penalty, mu = 1000, 0.3
core.quiet = true

local function block(y, count, young, contact)
  return scenes.body{ corner = { 0, y }, elements = { count, 2 }, contact = contact, E = young }
end

--- A block on a stiffer, wider one, or on a plane.
local function scene(keys, on_plane)
  local upper, lower = block(0, 4, 20, "south"), nil
  if not on_plane then
    lower = scenes.body{ size = {2, 1}, corner = { -0.5, -1 }, elements = { 8, 2 }, contact = "north", E = 60 }
  end
  keys.slave = upper:face "south"
  keys.master = on_plane and scenes.floor() or lower:face "north"
  return scenes.model{ bodies = { upper = upper, lower = lower },
    supports = { grip = { on = "upper.north", drive = "xy" },
      bed = lower and { on = lower:face "south", fix = "xy" } or nil },
    contacts = { joint = keys } }
end

--- A stage that moves the grip, and changes constants of the contact.
local function stage(steps, goal, constants)
  return { steps = steps, grip = goal, contacts = constants and { joint = constants } }
end

--- Runs stages; returns the contact's force and the run.
local function solved(model, name, ...)
  local run = model:run({ ... }, sg.robust{})
  if run.failed then error(("%s: %s"):format(name, run.failure), 2) end
  local now = model:contact_resultant "joint"
  return { now.fx, now.fy }, run, now
end

--- Calls of a test for each method and enforcement, on a plane and on a block.
local function each(test)
  for _, on_plane in ipairs { true, false } do
    for _, name in ipairs(contact_keys.names(on_plane)) do test(name, on_plane) end
  end
end

local down, aside = { 0, -0.02 }, { 0.06, -0.02 }

check.case("pressed with mu = 0, a contact with friction is one without", function()
  each(function(name, on_plane)
    local with = solved(scene(contact_keys.of(name, penalty, 0.2), on_plane), name,
      stage(2, down, { friction = { mu = 0 } }))
    local without, run = solved(scene(contact_keys.of(name, penalty), on_plane), name, stage(2, down))
    check.near(with, without, 1e-8)
    assert(without[2] > 0.1 and run.iterations > 0)
  end)
end)

check.case("friction begins without a jump of the force, then is Coulomb's, and ends at once", function()
  each(function(name, on_plane)
    local model = scene(contact_keys.of(name, penalty, 0), on_plane)
    local pressed = solved(model, name, stage(2, down))
    local held, _, now = solved(model, name, stage(2, down, { friction = { mu = mu } }))
    check.near(held, pressed, name == "multipliers" and 1e-7 or 1e-9) -- points beyond an end weigh 1e-8 there
    check.equal({ now.slipping, now.active > 0 }, { 0, true })
    local slid, run = solved(model, name, stage(12, aside))
    check.within(name .. ": friction", -slid[1] / slid[2], mu, on_plane and 1e-6 or 0.02 * mu)
    -- Forces of half passes differ on these meshes, and pressures with multipliers peak at the corner of a block.
    if not name:find "half" and name ~= "multipliers" then check.equal(run.warnings, {}) end
    assert(model:energy().friction > 0)
    local freed = solved(model, name, stage(1, aside, { friction = { mu = 0 } }))
    check.within(name .. ": no friction", freed[1] / freed[2], 0, 0.01)
    -- Friction begins again where the points are now.
    local again = solved(model, name, stage(1, aside, { friction = { mu = 0.5 } }))
    check.near(again, freed, name == "multipliers" and 1e-6 or 1e-9)
  end)
end)

check.case("friction that begins later slides as friction from the start does", function()
  each(function(name, on_plane)
    local function slide(first)
      local model = scene(contact_keys.of(name, penalty, mu), on_plane)
      return solved(model, name, stage(2, down, { friction = { mu = first } }),
        stage(20, { 0.1, -0.02 }, { friction = { mu = mu } }))
    end
    local later, always = slide(0), slide(mu)
    for i = 1, 2 do check.within(name, later[i] / always[i], 1, 1e-3) end
  end)
end)

check.case("a larger mu after a smaller one: nothing moves, then the friction of the larger one", function()
  local model = scene(contact_keys.of("points", penalty, 0.1), true)
  local before = solved(model, "points", stage(10, aside))
  check.near(solved(model, "points", stage(1, aside, { friction = { mu = 0.4 } })), before, 1e-9)
  local after = solved(model, "points", stage(10, { 0.1, -0.02 }))
  check.within("ratio", after[1] / after[2], -0.4, 1e-6)
end)

check.case("a contact that is switched off has no force, points or history; on again, it is as before", function()
  each(function(name, on_plane)
    local model = scene(contact_keys.of(name, penalty, 0), on_plane)
    local before = solved(model, name, stage(2, down))
    local none, run, now = solved(model, name, stage(1, down, { active = false }))
    check.equal({ none, now.active, now.area, now.max_pressure }, { { 0, 0 }, 0, 0, 0 })
    check.near({ model:energy().contact, model:energy().stored }, { 0, 0 }, 1e-9)
    check.equal(#run.warnings, 0)
    check.holds(show.text(model), "contact joint: switched off")
    solved(model, name, stage(1, { 0.01, -0.03 }))
    check.near(solved(model, name, stage(2, down, { active = true })), before, 1e-7)
  end)
end)

check.case("a contact that is off at first lets the body through the obstacle and back", function()
  local model = scene(contact_keys.of("points", penalty, nil, { active = false }), true)
  local none, run = solved(model, "points", stage(1, { 0, -3 }), stage(1, down))
  check.equal({ none, run.warnings }, { { 0, 0 }, {} })
  local later = solved(model, "points", stage(1, down, { active = true }))
  check.near(later, solved(scene(contact_keys.of("points", penalty), true), "points", stage(1, down)), 1e-9)
end)

check.case("a contact that is switched on where its faces overlap is a warning", function()
  for _, name in ipairs(contact_keys.names(true)) do
    for _, depth in ipairs { 0.02, 0.1 } do
      local model = scene(contact_keys.of(name, penalty, nil, { active = false }), true)
      local _, run = solved(model, name, stage(2, { 0, -depth }), stage(1, { 0, -depth }, { active = true }))
      local of_this = check.warnings(run, "faces overlap")
      check.equal({ name, #of_this }, { name, depth > 0.05 and 1 or 0 })
      if depth > 0.05 then
        check.holds(of_this[1], "contact 'joint' is switched on by stage 'stage 2'", "overlap by 0.1, 7.1 %")
      end
    end
  end
end)

check.case("a stage that changes contacts alone and fails ends the run, also under arc length", function()
  for _, options in ipairs { sg.plain{}, {}, { arc_length = true } } do
    for _, load in ipairs { false, function() return { 0, -0.1 } end } do -- a plateau changes no target either
      local body = block(0, 2, 20)
      local model = scenes.model{ bodies = { b = body }, supports = { side = { on = "west", fix = "x" } },
        loads = { weight = { on = body, force = { 0, 0 } } },
        contacts = { joint = { slave = "south", penalty = penalty, master = scenes.floor() } } }
      check.equal(model:run({ { steps = 1, weight = { 0, -0.1 } } }, options).reason, "completed")
      local run = model:run({ { steps = 1, weight = load or nil, contacts = { joint = { active = false } } } }, options)
      check.equal({ run.failed, run.reason, run.steps, #run.controls }, { true, "singular", 0, 0 })
      check.holds(run.failure, "was not reached", "rigid-body translation")
      check.equal(model:contact_law("joint").active, true) -- as before the stage
    end
  end
end)

check.case("adhesion can be switched off", function()
  local model = scene({ adhesion = { hamaker = 0.1, r0 = 0.1 } }, true)
  local acts, run = solved(model, "points", stage(1, { 0, 0.05 }))
  assert(acts[2] ~= 0 and not run.failed)
  check.equal(solved(model, "points", stage(1, { 0, 0.05 }, { active = false })), { 0, 0 })
end)

check.case("a new penalty gives the forces of a contact that has it from the start", function()
  each(function(name, on_plane)
    local changed = solved(scene(contact_keys.of(name, penalty), on_plane), name, stage(1, down),
      stage(1, down, { penalty = 3 * penalty }))
    local always, _, now = solved(scene(contact_keys.of(name, 3 * penalty), on_plane), name, stage(2, down))
    check.near(changed, always, 1e-8)
    assert(now.active > 0)
  end)
  -- The trial traction of elastic slip is proportional to its penalty.
  local model = scene(contact_keys.of("points", penalty, 10), true)
  solved(model, "points", stage(2, { 1e-4, -0.02 }), stage(1, { 1e-4, -0.02 }, { friction = { penalty = 10 } }))
  local soft = solved(model, "points", stage(1, { 2e-3, -0.02 }))
  local always = solved(scene({ penalty = penalty, friction = { mu = 10, penalty = 10 } }, true), "points",
    stage(2, { 1e-4, -0.02 }), stage(1, { 2e-3, -0.02 }))
  check.within("tangential", soft[1] / always[1], 1, 0.05)
end)

check.case("constants hold until they change, also in the next run; the law, print and snapshots show the present ones",
  function()
    local model = scene(contact_keys.of("half passes", penalty, 0.2), false)
    solved(model, "half passes", stage(1, down, { friction = { mu = 0.1 }, penalty = 2 * penalty }))
    solved(model, "half passes", stage(1, down))
    for _, pass in ipairs { "joint", "joint.master" } do
      local law = model:contact_law(pass)
      check.equal({ law.mu, law.penalty, law.friction_penalty, law.active }, { 0.1, 2 * penalty, penalty, true })
    end
    check.holds(show.text(model), "mu = 0.1", "penalty = 2000")
    local snapshot = model:snapshot()
    solved(model, "half passes", stage(1, down, { friction = { mu = 0 } }))
    model:restore(snapshot)
    check.equal(model:contact_law("joint.master").mu, 0.1)
    model:set_contact("joint", { active = false, friction = { mu = 0.4 } })
    check.equal({ model:contact_law("joint").mu, model:contact_law("joint.master").active }, { 0.4, false })
    check.fails(function() model:accept() end, "no step has been solved since")
    model:rollback()
    check.equal({ model:contact_law("joint").mu, model:contact_law("joint.master").active }, { 0.1, true })
  end)

check.case("a run that continues inside a stage ends bitwise as one without interruption; files hold the constants",
  function()
    local path = { stage(2, down, { friction = { mu = 0 } }),
                   stage(4, aside, { friction = { mu = mu }, offset = 0.01, penalty = 2 * penalty }) }
    for _, name in ipairs(contact_keys.names()) do
      local file = check.file "run.sgn"
      local keys = contact_keys.of(name, penalty, mu)
      local whole, options = scene(contact_keys.of(name, penalty, mu)), sg.robust{}
      options.checkpoint = { file = file .. ".whole" }
      whole:run(path, options)
      local first = scene(keys)
      options.checkpoint = { file = file }
      options.on_step = function(info) return info.step == 4 and "stop" or nil end
      first:run(path, options)
      local second = scene(contact_keys.of(name, penalty, mu))
      options.on_step, options.resume = nil, true
      check.equal(second:run(path, options).reason, "completed")
      for body in pairs { upper = 1, lower = 1 } do
        for _, point in ipairs { { 0, 0 }, { 0.5, 1 }, { 1, 0.3 } } do
          check.equal(second:sample(body, "uy", point), whole:sample(body, "uy", point))
        end
      end
      check.equal(second:energy().work, whole:energy().work)
      local law = sg.load(file):contact_law "joint"
      check.equal({ law.mu, law.offset, law.penalty }, { mu, 0.01, 2 * penalty })
      check.fails(function()
        options.checkpoint, options.resume = { file = file }, true
        local other = { path[1], stage(4, aside, { friction = { mu = 0.5 } }) }
        scene(contact_keys.of(name, penalty, mu)):run(other, options)
      end, "saved on another path", "different contacts")
      local harder = scene(contact_keys.of(name, 2 * penalty, mu))
      check.fails(function() harder:run(path, options) end, here, "differences: contact 'joint'")
    end
  end)

check.case("other controls lead to the same force, and a contact on a part of the face", function()
  each(function(name, on_plane)
    local expected
    for _, options in ipairs { sg.plain{}, sg.robust{ arc_length = true },
                               sg.robust{ penalty = { start = 0.1, steps = 2 } } } do
      local model = scene(contact_keys.of(name, penalty, mu, { where = function(X) return X[1] < 0.75 end }), on_plane)
      check.completed(model:run({ stage(5, down) }, options))
      expected = expected or model:reaction("grip").fy
      check.within_share(name, model:reaction("grip").fy, expected, 1e-3)
    end
    assert(expected < -0.1)
  end)
end)

check.case("steps that are cut in half: offsets are linear, other constants act in full from the start", function()
  local model, seen = scene(contact_keys.of("points", penalty, mu), true), {}
  local cut = true
  local run = model:run({ stage(2, down, { friction = { mu = 0 }, offset = 0.008 }) }, sg.plain{
    step = { adaptive = true }, on_iteration = function(now)
      local law = model:contact_law "joint"
      if now.iteration == 1 then seen[#seen + 1] = { now.to, law.mu, law.offset } end
      if cut then
        cut = false
        return "cut"
      end
    end })
  check.equal({ run.reason, run.cutbacks }, { "completed", 1 })
  check.near(seen[1], { 1, 0, 0.004 }, 1e-15)
  check.near(seen[2], { 0.5, 0, 0.002 }, 1e-15)
  check.equal(model:contact_law("joint").offset, 0.008)
end)

check.case("work and energies: friction that begins, and its springs that are released", function()
  local model = scene(contact_keys.of("points per reference area", 1e4, 0), true)
  solved(model, "points", stage(8, { 0, -0.002 }), stage(64, { 0.005, -0.002 }, { friction = { mu = mu } }))
  local e = model:energy()
  check.within("balance", e.stored + e.contact + e.friction, e.work, 0.01 * e.work)
  assert(e.friction > 0.1 * e.work)
  -- What is lost when friction ends is what the bodies and the springs of slip stored for it.
  local before, springs = model:energy(), 0
  local profile = model:profile "joint"
  for i, traction in ipairs(profile.traction) do springs = springs + profile.area[i] * traction^2 / 2e4 end
  solved(model, "points", stage(1, { 0.005, -0.002 }, { friction = { mu = 0 } }))
  check.within("springs", model:energy().friction - before.friction, springs, 0.02 * springs)
end)

check.case("where mu is lowered and nothing else moves, slip dissipates what the springs set free", function()
  for _, name in ipairs { "points", "points per reference area", "mortar", "reduced mortar" } do
    for _, lower in ipairs { 0.1, 0.001 } do
      local stiff = block(0, 4, 1e7)
      local model = scenes.model{ bodies = { stiff = stiff }, contacts = { joint = lists.merged(
          contact_keys.of(name, 1e4), { friction = { mu = mu, penalty = 100 }, slave = "south",
                                        master = scenes.floor() }) },
        supports = { grip = { on = "north", drive = "xy" } } }
      solved(model, name, stage(2, { 0, -0.01 }), stage(1, { 0.2, -0.01 })) -- 20 of the limit 30
      check.equal(model:contact_resultant("joint").slipping, 0)
      local before = model:energy()
      solved(model, name, stage(1, { 0.2, -0.01 }, { friction = { mu = lower } }))
      local after = model:energy()
      local lost, freed = after.friction - before.friction,
        before.stored + before.contact - after.stored - after.contact
      check.near(after.work, before.work, 1e-12)
      check.within(("%s, mu = %g"):format(name, lower), lost / freed, 1, 1e-3)
      -- ½ (20² − (100 μ)²)/100
      check.within("springs", freed, (400 - (100 * lower)^2) / 200, 0.01)
    end
  end
end)

check.case("the tangent is the derivative of the residual, with offsets and with mu = 0 of a contact with friction",
  function()
  each(function(name, on_plane)
    local model = scene(contact_keys.of(name, penalty, 0, { offset = 0.01 }), on_plane)
    solved(model, name, stage(2, { 0.001, -0.02 }))
    check.at_most(name .. ": offset", tangents.error(model, 1e-6), 1e-6)
    solved(model, name, stage(4, { 0.05, -0.02 }, { friction = { mu = mu } }))
    -- In an accepted state slipping points are on Coulomb's cone, where the friction has a kink.
    model:set_target("grip", { 0.06, -0.02 })
    assert(model:solve_step{}.converged)
    check.at_most(name .. ": friction", tangents.error(model, 1e-6), 1e-6)
  end)
end)

-- ── Wrong input ──────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("wrong constants are errors before anything is solved", function()
  local model = scene(contact_keys.of("points", penalty, 0), true)
  local smooth, sticky = scene(contact_keys.of("multipliers", penalty), true),
    scene({ adhesion = { hamaker = 1, r0 = 0.1 } }, true)
  local passes = scene(contact_keys.of("half passes", penalty, 0), false)
  local function wrong(of, contacts, ...)
    check.fails(function() of:run{ stage(1, down), { steps = 1, contacts = contacts } } end, here, "model:run", ...)
  end
  wrong(model, { seat = { active = false } }, "stages[2].contacts: unknown argument 'seat'", "known: joint")
  for _, empty in ipairs { { at = "stages[2].contacts", of = {} },
                           { at = "stages[2].contacts.joint", of = { joint = {} } },
                           { at = "stages[2].contacts.joint.friction", of = { joint = { friction = {} } } } } do
    wrong(model, empty.of, empty.at .. ": the table is empty, so that it changes nothing")
  end
  check.fails(function() model:set_contact("joint", {}) end, here, "model:set_contact", "the table is empty")
  wrong(model, { joint = { mu = 0.3 } }, "unknown argument 'mu'", "write friction = { mu = … }")
  wrong(model, { joint = { method = "mortar" } }, "unknown argument 'method'", "give it in sg.model")
  wrong(smooth, { joint = { friction = { mu = 0.3 } } }, "contacts.joint has no friction or wear in sg.model",
    "write friction = { mu = 0, … } in sg.model")
  wrong(sticky, { joint = { penalty = 10 } }, "contacts.joint has adhesion", "active alone")
  wrong(passes, { ["joint.master"] = { active = false } }, "unknown argument 'joint.master'", "joint")
  wrong(sg.model{ bodies = { block = block(0, 2, 1) }, supports = {} }, { joint = {} }, "")
  for _, one in ipairs { model, smooth, passes } do check.equal(one:target "grip", { 0, 0 }) end
  check.fails(function() model:set_contact("seat", { active = false }) end, here, "seat")
  check.fails(function() smooth:set_contact("joint", { friction = { mu = 0.3 } }) end, here, "has no friction or wear")
  check.fails(function()
    local body = block(0, 2, 1)
    scenes.model{ bodies = { block = body }, supports = { contacts = { on = "south", fix = "xy" } } }
  end, here, "cannot be called 'contacts', which is a key of stages")
end)

check.case("a coefficient of friction that looks like an angle is a warning, as in sg.model", function()
  local model = scene({ penalty = penalty, friction = { mu = 0.1, penalty = penalty } }, true)
  local run = model:run{ stage(1, down, { friction = { mu = 20 } }) }
  check.holds(table.concat(run.warnings, "\n"), "stage 'stage 1': contacts.joint: friction.mu = 20 is far above ",
    "for an angle of 20 degrees mu = 0.36397")
end)
