-- Contacts with method = "half_passes", at contact points and with multipliers: no bias by the choice of slave,
-- friction, energies, imbalance, results of both passes, checkpoints, wrong calls. half_passes_patch_test.lua has the
-- contact patch test.

require "check"
local ironing = require "ironing"
local show = require "signorini.prompt.show"

local function solved(model, stages, options)
  local run = model:run(stages, options)
  assert(not run.failed, run.failure)
  return run
end

local points = { method = "half_passes" }
local equal = { method = "half_passes", multipliers = "equal" }
local reduced = { method = "half_passes", multipliers = "reduced" }
local kinds = { points, equal, reduced }

local function name_of(keys) return keys.multipliers or "points" end

-- ── Bias ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

local path = { { name = "press", steps = 10, grip = { 0, -0.2 } },
               { name = "slide", steps = 20, grip = { 0.4, -0.2 } } }

-- Averages over elements that are not small compared with the contact differ between the faces: smaller ones, layers.
local small = { die = { 24, 4 }, slab = { 48, 6 } }

--- Ironing in the plane; `keys` of the contact, `swap`: slave and master.
local function iron(keys, swap, options)
  local original = sg.model
  rawset(sg, "model", function(scene)
    local contact = scene.contacts.interface
    for key, value in pairs(keys) do contact[key] = value end
    if swap then contact.slave, contact.master = contact.master, contact.slave end
    return original(scene)
  end)
  local default = keys.multipliers and { mu = 0.3, elements = small, order = "N2-N2.2" } or { mu = 0.3 }
  local made, model = pcall(ironing, options or default)
  rawset(sg, "model", nil)
  assert(made, model)
  return model
end

check.case("slave and master swapped: the same path with friction; one pass differs", function()
  local tight = { newton = { tolerance = 1e-13 } }
  local function difference(keys)
    local one, other = solved(iron(keys), path, tight), solved(iron(keys, true), path, tight)
    local largest = 0
    for _, column in ipairs { "grip.fx", "grip.fy" } do
      local a, b = one:column(column), other:column(column)
      for i = 1, 30 do largest = math.max(largest, math.abs(a[i] - b[i])) end
    end
    return largest / math.abs(one:column "grip.fy"[10])
  end
  for _, keys in ipairs(kinds) do check.at_most(name_of(keys), difference(keys), 1e-11) end
  check.equal(difference { method = "gpts" } > 1e-4, true)
end)

check.case("the imbalance is that of both forces, and the difference from one pass of this size", function()
  for _, keys in ipairs(kinds) do
    local one_pass = { method = keys.multipliers and "mortar" or "gpts", multipliers = keys.multipliers }
    local model, one, other = iron(keys), iron(one_pass), iron(one_pass, true)
    local run = solved(model, path)
    solved(one, path)
    solved(other, path)
    local a, b = model:contact_resultant "interface", model:contact_resultant "interface.master"
    local larger = math.max(math.sqrt(a.fx ^ 2 + a.fy ^ 2), math.sqrt(b.fx ^ 2 + b.fy ^ 2))
    local expected = math.sqrt((a.fx + b.fx) ^ 2 + (a.fy + b.fy) ^ 2) / larger
    check.near({ a.imbalance, b.imbalance }, { expected, expected }, 1e-14)
    check.at_most("imbalance", a.imbalance, 0.03)
    for i = 1, 2 do
      local own, mean = model:reaction("grip")[i], (one:reaction("grip")[i] + other:reaction("grip")[i]) / 2
      check.within_share(("%s, force %d"):format(name_of(keys), i), own, mean, 2 * a.imbalance)
    end
    check.equal({ a.imbalance > 1e-8, a.slipping > 0, b.slipping > 0, a.per }, { true, true, true, "current" })
    for _, pass in ipairs { a, b } do
      check.equal(rawget(pass, "weighted_penetration") ~= nil, keys ~= points)
    end
    check.fails(function() return one:contact_resultant "interface".imbalance end,
      "a contact resultant has no 'imbalance'")
    -- Each body is in equilibrium with its own pass.
    check.near({ run:column "interface.fy"[30], run:column "interface.master.fy"[30] }, { a.fy, b.fy }, 1e-14)
    check.near(-model:reaction("grip").fy, a.fy, 1e-8)
  end
end)

check.case("a run warns of half passes with different forces", function()
  -- A slab with elements as wide as the contact, whose average gap is open
  local coarse = { mu = 0.3, elements = { die = { 6, 2 }, slab = { 8, 3 } } }
  local function warning(keys)
    return table.concat(iron(keys, false, coarse):run({ path[1] }, sg.robust{}).warnings, "\n")
  end
  check.holds(warning(equal), "contact 'interface': the forces of its half passes differ by ", "smaller elements")
  check.equal(warning(points):find("half passes", 1, true), nil)
end)

check.case("without friction the imbalance falls with the elements and, at points, with the penetration", function()
  local function imbalance(keys, fine, penalty)
    local model = iron(keys, false, { mu = 0, penalty = penalty,
                                      elements = { die = { 12 * fine, 4 }, slab = { 24 * fine, 6 } } })
    solved(model, path)
    return model:contact_resultant "interface".imbalance
  end
  for _, keys in ipairs(kinds) do
    local coarse, fine = imbalance(keys, 1, 1000), imbalance(keys, 4, 1000)
    check.at_most(name_of(keys) .. ", elements", fine, math.min(coarse / 2, 0.02))
    if keys == points then check.at_most("penetration", coarse, math.min(imbalance(keys, 1, 100) / 2, 0.01)) end
  end
end)

-- ── Energies ─────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("contact energy and dissipation count once", function()
  local function energy(keys)
    local model = iron(keys)
    solved(model, path)
    return model:energy()
  end
  for _, keys in ipairs(kinds) do
    local passes, one = energy(keys), energy { method = keys.multipliers and "mortar" or "gpts",
                                               multipliers = keys.multipliers }
    check.within_share("contact", passes.contact, one.contact, 0.05)
    check.within_share("friction", passes.friction, one.friction, 0.05)
    local missing = passes.work + passes.area_growth - passes.stored - passes.contact - passes.friction
    check.at_most(name_of(keys) .. ": balance", missing / passes.work, 0.02)
  end
end)

-- ── Other scenes ─────────────────────────────────────────────────────────────────────────────────────────────────────

--- A ball pressed on a disc, axisymmetric; a layer on the ball.
local function ball(keys, swap, count, penalty, mu)
  local body = scenes.body{ patch = sg.shapes.quarter_annulus{ inner = 0.3, outer = 1, start = 270, center = { 0, 1 } },
    elements = { count, 2 }, order = "N2-N2.1", contact = "south", thickness_degree = 1, E = 2 }
  local disc = scenes.body{ size = {1.5, 1}, corner = { 0, -1 }, elements = { count + 3, 3 }, contact = "north",
    thickness_degree = 1 }
  local slave, master = body:face "south", disc:face "north"
  if swap then slave, master = master, slave end
  local model = scenes.model{ kind = "axisymmetric", bodies = { ball = body, disc = disc },
    supports = { bed = { on = "disc.south", fix = "xy" }, axis = { on = "disc.west", fix = "x" },
      middle = { on = "ball.west", fix = "x" }, grip = { on = "ball.east", drive = "y" } },
    contacts = { touch = { slave = slave, master = master, penalty = penalty, method = keys.method,
        multipliers = keys.multipliers, friction = mu and { mu = mu, penalty = penalty } or nil } } }
  solved(model, { { steps = 4, grip = -0.15 } }, { newton = { tolerance = 1e-13 } })
  return model
end

check.case("axisymmetric: unbiased, and without friction the imbalance falls as in the plane", function()
  for _, keys in ipairs(kinds) do
    for _, mu in ipairs { false, 0.05 } do
      local one, other = ball(keys, false, 6, 50, mu), ball(keys, true, 6, 50, mu)
      check.near(one:reaction("grip").fy, other:reaction("grip").fy, 1e-11)
      check.near(one:profile("touch").pressure, other:profile("touch.master").pressure, 1e-10)
      local slipping = one:contact_resultant("touch").slipping + one:contact_resultant("touch.master").slipping
      check.equal(slipping > 0, mu ~= false)
    end
    local coarse, fine = ball(keys, false, 6, 50), ball(keys, false, 24, keys == points and 800 or 50)
    local last = fine:contact_resultant("touch").imbalance
    check.at_most("imbalance", last / coarse:contact_resultant("touch").imbalance, 0.5)
  end
end)

--- A block pressed on a larger one and dragged, in 3D with friction.
local function drag(keys, swap)
  local function block(size, count, corner, face, young)
    return scenes.body{ size = size, corner = corner, elements = { count, count, 1 }, contact = face,
      thickness_degree = 1, E = young }
  end
  local top = block({ 1, 1, 0.5 }, 2, { 0.5, 0.4, 0 }, "front", 20)
  local bed = block({ 3, 2, 1 }, 5, { 0, 0, -1 }, "back", 1)
  local slave, master = top:face "front", bed:face "back"
  if swap then slave, master = master, slave end
  local model = scenes.model{ bodies = { top = top, bed = bed },
    supports = { floor = { on = "bed.front", fix = "xyz" }, grip = { on = "top.back", drive = "xyz" } },
    contacts = { touch = { slave = slave, master = master, penalty = 20, points = 5, method = keys.method,
        multipliers = keys.multipliers, friction = { mu = 0.2, penalty = 20 } } } }
  local run = solved(model, { { steps = 2, grip = { 0, 0, -0.05 } }, { steps = 6, grip = { 0.3, 0.1, -0.05 } } },
    { newton = { tolerance = 1e-13 } })
  return model, run
end

check.case("solids with friction: unbiased, Coulomb's law on both faces", function()
  for _, keys in ipairs(kinds) do
    local one, other = drag(keys, false), drag(keys, true)
    local a, b = one:reaction "grip", other:reaction "grip"
    check.near({ a[1], a[2], a[3] }, { b[1], b[2], b[3] }, 1e-10)
    check.within_share("mu", math.sqrt(a[1] ^ 2 + a[2] ^ 2) / math.abs(a[3]), 0.2, 0.1)
    for _, name in ipairs { "touch", "touch.master" } do
      local profile, slips = one:profile(name), 0
      for i, state in ipairs(profile.state) do
        if state == "slip" then
          slips = slips + 1
          -- At multipliers |t_A| = mu z_A; between them sums of vectors are shorter.
          local mobilized = profile.traction[i] / profile.pressure[i]
          check.at_most("traction", mobilized, 0.2 + 1e-12)
          if keys == points then check.within("traction", mobilized, 0.2, 1e-12) end
        end
      end
      check.equal(slips > 5, true)
    end
  end
end)

-- ── Results, files, errors ───────────────────────────────────────────────────────────────────────────────────────────

check.case("both passes have names, profiles, pressures and lines", function()
  local model = iron(points)
  check.equal(model:contact_names(), { "interface", "interface.master" })
  solved(model, { path[1] })
  for _, part in ipairs { { "die", "interface", { 0.5, 0 } }, { "slab", "interface.master", { 0.25, 1 } } } do
    local largest = model:contact_resultant(part[2]).max_pressure
    local value = model:sample(part[1], "contact_pressure", part[3])
    check.at_most(part[1], value, 1.01 * largest)
    check.equal(value > 0.5 * largest, true)
  end
  check.holds(show.text(model), "contact interface: ", "contact interface.master: ", "half pass, imbalance ")
  for _, warning in ipairs(model:warnings()) do check.equal(warning:find("counted twice", 1, true), nil) end
end)

local function expect_resumed(keys)
  local file = os.tmpname()
  local function stop(info) return info.stage == "slide" and info.step == 5 and "stop" or nil end
  local whole = iron(keys)
  os.remove(file)
  solved(whole, path, { checkpoint = file })
  os.remove(file)
  iron(keys):run(path, { checkpoint = file, on_step = stop })
  local resumed = iron(keys)
  solved(resumed, path, { checkpoint = file, resume = true })
  for _, model in ipairs { resumed, sg.load(file) } do
    for _, name in ipairs { "interface", "interface.master" } do
      check.equal(core.pack(model:profile(name)), core.pack(whole:profile(name)))
      check.equal(model:contact_resultant(name).imbalance, whole:contact_resultant(name).imbalance)
    end
    check.equal(core.pack(model:energy()), core.pack(whole:energy()))
  end
  local other = keys == points and equal or points
  check.fails(function() iron(other):run(path, { checkpoint = file, resume = true }) end, "differences")
  os.remove(file)
end

check.case("resumed runs and loaded models are bitwise the same", function()
  for _, keys in ipairs(kinds) do expect_resumed(keys) end
end)

check.case("robust runs and arc length", function()
  for _, keys in ipairs(kinds) do
    local expected = iron(keys)
    solved(expected, { path[1] })
    for _, options in ipairs { sg.robust {}, { arc_length = true }, { penalty = { start = 0.1, steps = 2 } } } do
      local model = iron(keys)
      solved(model, { path[1] }, options)
      -- First touches are foreseen from the guess of a step, which these options change.
      check.within_share("force", model:reaction("grip").fy, expected:reaction("grip").fy, 3e-3)
    end
  end
end)

check.case("wrong combinations are errors that name the argument", function()
  local body = scenes.body{ order = "N1", contact = "south" }
  local below = scenes.body{ corner = { 0, -1 }, order = "N1", contact = "north" }
  local function contacts(list)
    for _, keys in pairs(list) do
      keys.slave, keys.master = body:face "south", keys.master or below:face "north"
      keys.penalty = not keys.adhesion and 1 or nil
    end
    return function() sg.model{ bodies = { block = body, below = below }, contacts = list } end
  end
  local function contact(keys)
    keys.method = "half_passes"
    return contacts{ floor = keys }
  end
  local here = "half_passes_test.lua:"
  check.fails(contact{ master = scenes.floor(-1) }, here, "contacts.floor",
    "half_passes", "obstacle", "gpts", "mortar")
  check.fails(contact{ per = "reference" }, here, "per", "current")
  check.fails(contact{ adhesion = { hamaker = 1, r0 = 1 } }, here, "adhesion", "half_passes")
  check.fails(contact{ multipliers = "reduced" }, here, "reduced", "half passes", "p >= 2", "got 1", "equal")
  check.fails(contacts{ floor = { multipliers = "equal" } }, here, "multipliers", "mortar", "half_passes")
  check.fails(contacts{ floor = { method = "half_pass" } }, here, "method", "half_passes")
  check.fails(contacts{ floor = { method = "half_passes" }, ["floor.master"] = {} }, here, "floor.master",
    "name of a contact")
  check.fails(contact{ enforcement = "multipliers" }, here, "contacts.floor", "half_passes", "multipliers", "mortar")
end)
