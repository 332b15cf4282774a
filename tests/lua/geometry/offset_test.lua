-- Offsets and interference fits: Lamé's rings, planes that are moved instead; energies, errors.

require "check"
local other_warnings = require "other_warnings"
local contact_keys = require "contact_keys"
local show = require "signorini.prompt.show"

local here = "offset_test.lua:"
core.quiet = true

-- ── Rings ────────────────────────────────────────────────────────────────────────────────────────────────────────────

local E, nu, a, R, b = 1000, 0.3, 0.5, 1, 2
local steel = sg.neo_hookean{ E = E, nu = nu }

--- Radial displacement of a ring per pressure on its inner and outer face, plane strain (Timoshenko, Goodier, Theory of
--- Elasticity, section 28): of the outer ring at R, and of the inner one, inwards.
local outer_softness = (1 + nu) * R * ((1 - 2 * nu) * R^2 + b^2) / (E * (b^2 - R^2))
local inner_softness = (1 + nu) * R * ((1 - 2 * nu) * R^2 + a^2) / (E * (R^2 - a^2))

--- Half the section of an axisymmetric ring of height 0.25, without axial strain.
local function ring(inner, outer, contact)
  return scenes.body{ size = {outer - inner, 0.25}, corner = { inner, 0 }, elements = { 6, 2 }, contact = contact,
    thickness_degree = 3, material = steel }
end

--- Supports of rings that keep their height.
local function rollers(...)
  local supports = {}
  for i, body in ipairs { ... } do
    supports["low" .. i] = { on = body:face "south", symmetry = true }
    supports["high" .. i] = { on = body:face "north", fix = "y" }
  end
  return supports
end

--- A ring on a rigid shaft of radius R, a plane in the section. `cut`: by which the ring's radius is smaller.
local function on_shaft(keys, cut)
  local outer = ring(R - (cut or 0), b, "west")
  keys.slave, keys.master = outer:face "west", sg.rigid.plane{ point = { R, 0 }, normal = { 1, 0 } }
  return sg.model{ kind = "axisymmetric", bodies = { outer = outer }, supports = rollers(outer),
                   contacts = { seat = keys } }
end

--- A ring on a ring, whose radius is larger by `cut`.
local function on_ring(keys, cut)
  local inner, outer = ring(a, R + (cut or 0), "east"), ring(R, b, "west")
  keys.slave, keys.master = outer:face "west", inner:face "east"
  return sg.model{ kind = "axisymmetric", bodies = { inner = inner, outer = outer },
                   supports = rollers(inner, outer), contacts = { seat = keys } }
end

local function mean_pressure(model)
  local profile, force, area = model:profile "seat", 0, 0
  for i, pressure in ipairs(profile.pressure) do
    force, area = force + pressure * profile.area[i], area + profile.area[i]
  end
  return force / area
end

--- The balance of energies. Half passes act with one pressure on two areas, whose radii differ by the offset.
local function check_balance(name, model, bound, offset)
  local e = model:energy()
  check.at_most(name .. ": energies", (e.work + e.area_growth - e.stored - e.contact - e.friction) / e.work,
    name:find "half" and offset / R or bound)
end

local penalty = 1e5 -- 25 E/h

--- The pressure of an offset of this size, relative to Lamé's of the rings in a row with the penalty's springs.
local function of_offset(scene, name, softness, offset)
  local model = scene(contact_keys.of(name, penalty))
  local run = model:run({ { steps = 4, contacts = { seat = { offset = offset } } } }, sg.robust{})
  check.equal({ run.reason, #run.warnings }, { "completed", 0 })
  local springs = contact_keys.penetrates(name) and 1 / penalty or 0
  return mean_pressure(model) * (softness + springs) / offset, model
end

for _, case in ipairs { { "a rigid shaft", on_shaft, outer_softness, true },
                        { "a ring", on_ring, outer_softness + inner_softness } } do
  local name, scene, softness, on_obstacle = table.unpack(case)
  check.case(("ring on %s: Lamé's pressure in the limit of small offsets, work and energies"):format(name), function()
    for _, form in ipairs(contact_keys.names(on_obstacle)) do
      -- The error of small strains is linear in the offset, so that this is exact up to its square.
      local large, model = of_offset(scene, form, softness, 2e-3)
      local small = of_offset(scene, form, softness, 1e-3)
      check.within(form .. ": small strains", 2 * small - large, 1, 1e-4)
      check.within(form .. ": rate", (large - 1) / (small - 1), 2, 0.1)
      check_balance(form, model, 1e-4, 2e-3)
      assert(model:energy().work > 0)
    end
  end)
end

check.case("an interference fit of the shapes is that of an offset, closed over the first stage alone", function()
  for _, scene in ipairs { on_shaft, on_ring } do
    for _, form in ipairs(contact_keys.names(scene == on_shaft)) do
      local fit = scene(contact_keys.of(form, penalty, nil, { overlap = "interference" }), 0.04)
      check.equal({ #fit:warnings(), fit:contact_law("seat").overlap }, { 0, 1 })
      check.near(fit:contact_resultant("seat").max_pressure, 0, 1e-9)
      local left = {}
      local options = sg.robust{}
      function options.on_step(info)
        left[info.step] = fit:contact_law("seat").overlap
        return { pressure = mean_pressure(fit) }
      end
      local run = fit:run({ { steps = 4 }, { steps = 1 } }, options)
      check.equal({ run.failure or run.reason, left }, { "completed", { 0.75, 0.5, 0.25, 0, 0 } })
      local pressure = run:column "pressure"
      check.within(form .. ": linear", pressure[1] / pressure[4], 0.25, 0.02)
      check.near(pressure[5] / pressure[4], 1, 1e-8)
      check_balance(form, fit, 1e-3, 0.04)
      -- The overlap stays closed.
      check.equal(fit:run({ { steps = 1 } }, sg.robust{}).reason, "completed")
      check.near(mean_pressure(fit) / pressure[4], 1, 1e-8)
    end
  end
end)

check.case("a contact that is off at first closes its overlap in the stage that switches it on", function()
  local keys = { "points", "mortar", "half passes" }
  for _, form in ipairs(keys) do
    local function fit(active)
      return on_ring(contact_keys.of(form, penalty, nil, { overlap = "interference", active = active }), 0.04)
    end
    local late, left = fit(false), {}
    local options = sg.robust{}
    function options.on_step(info) left[info.step] = late:contact_law("seat").overlap end
    local on = { seat = { active = true } }
    local run = late:run({ { steps = 1 }, { steps = 2, contacts = on } }, options)
    check.equal({ run.failure or run.reason, left, run.fallback_steps }, { "completed", { 1, 0.5, 0 }, 0 })
    check_balance(form, late, 1e-3, 0.04)
    local first = fit(true)
    first:run({ { steps = 2 } }, sg.robust{})
    check.near(mean_pressure(late) / mean_pressure(first), 1, 1e-8)
    check.fails(function() fit(false):run({ { steps = 1, contacts = on } }, { arc_length = true }) end,
      "arc_length cannot follow")
  end
end)

check.case("the shapes' interference tends to Lamé's pressure, too", function()
  local function relative(cut)
    local fit = on_ring(contact_keys.of("mortar", penalty, nil, { overlap = "interference" }), cut)
    fit:run({ { steps = 2 } }, sg.plain{})
    return mean_pressure(fit) * (outer_softness + inner_softness + 1 / penalty) / cut
  end
  check.within("limit", 2 * relative(1e-3) - relative(2e-3), 1, 1e-4)
end)

--- A quarter of the section of both rings in the plane, on curved faces.
local function on_quarter(keys)
  local function quarter(low, high, contact, around)
    return scenes.body{ patch = sg.shapes.quarter_annulus{ inner = low, outer = high }, elements = { around, 6 },
      contact = contact, thickness_degree = 3, material = steel }
  end
  local inner, outer = quarter(a, R, "south", 4), quarter(R, b, "north", 5)
  keys.slave, keys.master = outer:face "north", inner:face "south"
  local supports = {}
  for name, body in pairs { inner = inner, outer = outer } do
    for _, side in ipairs { "west", "east" } do supports[name .. side] = { on = body:face(side), symmetry = true } end
  end
  return sg.model{ bodies = { inner = inner, outer = outer }, supports = supports, contacts = { seat = keys } }
end

check.case("quarters of both rings in the plane, whose meshes differ: Lamé's pressure on curved faces", function()
  for _, form in ipairs { "points", "points per reference area", "mortar", "multipliers", "half passes" } do
    local large, model = of_offset(on_quarter, form, outer_softness + inner_softness, 2e-3)
    local small = of_offset(on_quarter, form, outer_softness + inner_softness, 1e-3)
    check.within(form .. ": small strains", 2 * small - large, 1, 1e-3)
    check_balance(form, model, 1e-3, 2e-3)
  end
end)

-- ── Plane and solid scenes ───────────────────────────────────────────────────────────────────────────────────────────

--- A block of width 1 on a plane at height `at`, in the plane or in space.
local function block(dimension, keys, at)
  local body, point, normal, low, high
  if dimension == 2 then
    body = scenes.body{ elements = { 3, 2 }, material = steel }
    point, normal, low, high = { 0, at or 0 }, { 0, 1 }, "south", "north"
  else
    body = scenes.body{ size = { 1, 1, 1 }, elements = { 2, 2, 1 }, material = steel }
    point, normal, low, high = { 0, 0, at or 0 }, { 0, 0, 1 }, "front", "back"
  end
  keys.slave, keys.master = body:face(low), sg.rigid.plane{ point = point, normal = normal }
  return sg.model{ bodies = { block = body }, contacts = { seat = keys },
                   supports = { grip = { on = body:face(high), drive = dimension == 2 and "xy" or "xyz" } } }
end

--- Moves the grip sideways and down; returns force and smallest gap.
local function pressed(model, dimension)
  local goal = dimension == 2 and { 0.02, -0.03 } or { 0.02, 0.01, -0.03 }
  check.completed(model:run({ { steps = 3, grip = goal } }, sg.plain{}))
  return table.move(model:reaction "grip", 1, dimension, 1, {}), model:contact_resultant("seat").max_penetration
end

check.case("on a plane, an offset is a plane that is moved: forces, friction, penetration", function()
  for dimension = 2, 3 do
    for _, form in ipairs(contact_keys.names(true)) do
      for _, offset in ipairs { -0.01, 0.004 } do
        local shim, depth = pressed(block(dimension, contact_keys.of(form, 1e4, 0.2, { offset = offset })), dimension)
        local moved, same = pressed(block(dimension, contact_keys.of(form, 1e4, 0.2), offset), dimension)
        local scale = math.abs(moved[dimension])
        for i = 1, dimension do check.within(form .. ": force", shim[i] / scale, moved[i] / scale, 1e-8) end
        check.near(depth, same, 1e-10)
      end
    end
  end
end)

check.case("a clearance is felt where it ends", function()
  local model = block(2, { penalty = 1e4, offset = -0.01 })
  model:run({ { steps = 1, grip = { 0, -0.009 } } }, sg.plain{})
  check.equal(model:contact_resultant("seat").active, 0)
  check.near(math.min(table.unpack(model:profile("seat").gap)), 0.001, 1e-9)
  model:run({ { steps = 1, grip = { 0, -0.011 } } }, sg.plain{})
  assert(model:contact_resultant("seat").fy > 0)
end)

check.case("no work is counted for an offset of sg.model, where all supports are at rest", function()
  for _, form in ipairs(contact_keys.names(true)) do
    local model = block(2, contact_keys.of(form, 1e4, nil, { offset = 0.02 }))
    local run = model:run({ { steps = 1 } }, sg.robust{})
    check.equal({ run.reason, #other_warnings(run) }, { "completed", 0 })
    local pressed = model:energy()
    check.near(pressed.work, 0, 1e-12)
    assert(pressed.stored > 1e-3)
    model:run({ { steps = 4, grip = { 0, -0.001 } } }, sg.robust{})
    local e = model:energy()
    check.within(form, e.work + e.area_growth - pressed.area_growth,
      e.stored + e.contact - pressed.stored - pressed.contact, 0.01 * e.work)
  end
end)

check.case("an offset above 20 % of the thinner body's thickness is a warning, in sg.model and in a stage", function()
  local words = { "contacts.seat: offset = -0.25 is 25 % of the thickness of the thinner body", "Hint" }
  local model = block(2, { penalty = 1e4, offset = -0.25 })
  check.holds(model:warnings()[1], table.unpack(words))
  model = block(2, { penalty = 1e4, offset = -0.19 })
  check.equal(model:warnings(), {})
  local run = model:run({ { name = "wear", steps = 1, contacts = { seat = { offset = -0.25 } } } }, sg.plain{})
  check.holds(run.warnings[1], "stage 'wear': ", table.unpack(words))
end)

-- ── What belongs to a constant of a state ────────────────────────────────────────────────────────────────────────────

check.case("print, help and the law show offset and overlap; a roll-back restores them", function()
  local model = on_ring({ penalty = penalty, offset = 0.001, overlap = "interference" }, 0.04)
  check.holds(show.text(model), "offset = 0.001",
    'overlap = "interference", of which 100 % is left')
  model:set_contact("seat", { offset = 0.002, overlap = 0.5 })
  check.equal({ model:contact_law("seat").offset, model:contact_law("seat").overlap }, { 0.002, 0.5 })
  model:rollback()
  check.equal({ model:contact_law("seat").offset, model:contact_law("seat").overlap }, { 0.001, 1 })
end)

--- The vertical force on a block, in the last of 8 steps and in one from the same state after `model:save`, which
--- forgets what points remember of the search. The block comes around the end of a slab, its gap to `offset` below it.
local function forces_around_end(offset, method)
  local material = sg.linear_elastic{ E = 1000, nu = 0.3 }
  local slab = scenes.body{ size = {4, 1}, elements = { 20, 2 }, contact = "north", material = material }
  -- Beyond the extension of the slab's end by 0.3 of an element
  local model = scenes.model{
    bodies = { block = { size = {0.5, 0.5}, corner = { 4.12, 1.001 }, elements = { 10, 2 }, contact = "south",
        material = material }, slab = slab },
    supports = { bed = { on = "slab.south", fix = "xy" }, top = { on = "block.north", drive = "xy" } },
    contacts = {
      seat = { slave = "block.south", master = "slab.north", penalty = 1e4, offset = offset, method = method } } }
  local x, y = -0.16, offset - 0.007
  local run = model:run({ { steps = 8, top = { x, y } } }, sg.plain{})
  model:save(check.file "state.sgn")
  local again = model:run({ { steps = 1, top = { x, y - 1e-9 } } }, sg.plain{})
  return run:column "top.fy"[8], again:column "top.fy"[1]
end

check.case("points that come around an end touch on arrival, with clearance and overlap", function()
  for _, offset in ipairs { -0.05, 0, 0.02 } do
    for _, method in ipairs { "gpts", "mortar" } do
      local force, again = forces_around_end(offset, method)
      check.equal({ offset, method, force < -0.1 }, { offset, method, true })
      check.near(force, again, 1e-4 * math.abs(force))
    end
  end
end)

check.case("wrong input", function()
  local function wrong(make, ...) check.fails(make, here, ...) end
  local model = on_ring({ penalty = penalty })
  wrong(function() on_ring({ penalty = penalty, overlap = "interference" }, 1) end, "of the thickness of the thinner",
    "more than 90 %")
  wrong(function() on_shaft({ penalty = penalty }, 0.1) end, "the obstacle is inside body 'outer'", "interference")
  wrong(function() on_shaft({ adhesion = { hamaker = 1, r0 = 1 }, offset = 0.1 }) end, "both adhesion and offset")
  wrong(function() on_shaft({ adhesion = { hamaker = 1, r0 = 1 }, overlap = "interference" }) end,
    'both adhesion and overlap = "interference"')
  wrong(function() model:run{ { steps = 1, contacts = { seat = { offset = true } } } } end,
    "stages[1].contacts.seat.offset must be a number")
  wrong(function() model:run({ { steps = 1, contacts = { seat = { offset = 0.1 } } } }, { arc_length = true }) end,
    "model:run: stages[1]: contacts.seat.offset changes over the stage", "remove arc_length")
  wrong(function() on_ring({ penalty = penalty, overlap = "interference" }, 0.01):run({ { steps = 1 } },
    { arc_length = true }) end, 'contacts.seat has overlap = "interference"', "arc_length cannot follow")
  wrong(function() model:set_contact("seat", { overlap = 0.5 }) end, 'has no overlap = "interference" in sg.model')
end)
