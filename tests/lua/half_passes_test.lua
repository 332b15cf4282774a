-- Contacts with method = "half_passes": contact patch test, no bias by the choice of slave, friction, energies,
-- imbalance, results of both passes, checkpoints, wrong calls.

local check = require "check"
local core = require "signorini.core"
local ironing = require "ironing"
local sg = require "signorini"
local show = require "signorini.show"

local function solved(model, stages, options)
  local run = model:run(stages, options)
  assert(not run.failed, run.report)
  return run
end

-- ── Patch test ───────────────────────────────────────────────────────────────────────────────────────────────────────

--- A block on x, y = 0 … 2 with its contact face at z = 0 (plane: on x, at y = 0), as one patch whose inner lines of
--- elements are slanted by `skew`.
local function patch(flat, from, to, skew)
  local points, knots = {}, { 0, 0, 1, 2, 2 }
  for k = 0, 2 do
    local z = from + (to - from) * k / 2
    for j = 0, flat and 0 or 2 do
      for i = 0, 2 do
        local shift = i == 1 and skew * (0.3 + k / 4 + j / 3) or 0
        local other = j == 1 and skew * (0.5 - i / 4 - k / 5) or 0
        points[#points + 1] = flat and { i + shift, z } or { i + shift, j + other, z }
      end
    end
  end
  if flat then return sg.nurbs.surface{ degrees = { 1, 1 }, knots = { knots, knots }, points = points } end
  return sg.nurbs.volume{ degrees = { 1, 1, 1 }, knots = { knots, knots, knots }, points = points }
end

--- Two blocks under uniform pressure, sides guided; the larger error of the pressures of both passes, and the model.
local function press(o)
  local flat = o.dimension == 2
  local function block(count, is_lower)
    local skew = is_lower and o.skew or -o.skew
    local from, to = is_lower and -1 or -5e-4, is_lower and 0 or 1
    return sg.body{
      patch = patch(flat, from, to, skew),
      elements = flat and { count, 2 } or { count, count, 2 }, order = o.order, thickness_degree = 1,
      contact = flat and (is_lower and "north" or "south") or (is_lower and "back" or "front"),
      material = sg.linear_elastic{ E = is_lower and 1 or 2, nu = 0.3 },
    }
  end
  local lower, upper = block(o.counts[1], true), block(o.counts[2], false)
  local bottom, top = flat and "south" or "front", flat and "north" or "back"
  local function both(...)
    local faces = {}
    for _, name in ipairs { ... } do faces[#faces + 1], faces[#faces + 2] = lower:face(name), upper:face(name) end
    return faces
  end
  local slave, master = upper:face(bottom), lower:face(top)
  if o.slave == "lower" then slave, master = master, slave end
  local model = sg.model{
    bodies = { lower = lower, upper = upper },
    supports = { bed = { on = lower:face(bottom), fix = flat and "y" or "z" },
                 ends = { on = both("west", "east"), fix = "x" },
                 sides = not flat and { on = both("south", "north"), fix = "y" } or nil },
    loads = { push = { on = upper:face(top), pressure = 0 } },
    contacts = { joint = { slave = slave, master = master, penalty = 100, method = "half_passes",
                           friction = { mu = 0.3, penalty = 100 } } },
  }
  solved(model, { { name = "press", steps = 2, push = 0.1 } })
  local largest = 0
  for _, name in ipairs { "joint", "joint.master" } do
    for _, pressure in ipairs(model:profile(name).pressure) do
      largest = math.max(largest, math.abs(pressure / 0.1 - 1))
    end
    check.at_most("imbalance", model:contact_resultant(name).imbalance, 1e-12)
  end
  return largest
end

check.case("patch test, 3 on 5 elements, straight and skewed: uniform to rounding error on either face", function()
  for _, order in ipairs { "N1", "N2", "N3", "N2-N2.2" } do
    for _, skew in ipairs { 0, 0.2 } do
      for _, slave in ipairs { "lower", "upper" } do
        for dimension = 2, order == "N2" and 3 or 2 do
          local error = press{ dimension = dimension, order = order, skew = skew, slave = slave, counts = { 3, 5 } }
          check.at_most(("%dD %s, skew %g, slave %s"):format(dimension, order, skew, slave), error, 1e-12)
        end
      end
    end
  end
end)

-- ── Bias ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

local path = { { name = "press", steps = 10, grip = { 0, -0.2 } },
               { name = "slide", steps = 20, grip = { 0.4, -0.2 } } }

--- Ironing in the plane; `keys` of the contact, `swap`: slave and master.
local function iron(keys, swap, options)
  local original = sg.model
  sg.model = function(scene)
    local contact = scene.contacts.interface
    for key, value in pairs(keys) do contact[key] = value end
    if swap then contact.slave, contact.master = contact.master, contact.slave end
    return original(scene)
  end
  local made, model = pcall(ironing, options or { mu = 0.3 })
  sg.model = original
  assert(made, model)
  return model
end

local half = { method = "half_passes" }

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
  check.at_most("half passes", difference(half), 1e-11)
  check.equal(difference { method = "gpts" } > 1e-4, true)
end)

check.case("the imbalance is that of both forces, and the difference from Gauss points of this size", function()
  local model, one, other = iron(half), iron { method = "gpts" }, iron({ method = "gpts" }, true)
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
    check.within_share("force " .. i, own, mean, 2 * a.imbalance)
  end
  check.equal({ a.imbalance > 1e-8, a.slipping > 0, b.slipping > 0, a.per }, { true, true, true, "current" })
  check.equal(one:contact_resultant "interface".imbalance, nil)
  -- Each body is in equilibrium with its own pass.
  check.near({ run:column "interface.fy"[30], run:column "interface.master.fy"[30] }, { a.fy, b.fy }, 1e-14)
  check.near(-model:reaction("grip").fy, a.fy, 1e-8)
end)

check.case("without friction the imbalance falls with the elements and the penetration", function()
  local last
  for _, case in ipairs { { 1, 100 }, { 1, 1000 }, { 4, 1000 } } do
    local fine, penalty = case[1], case[2]
    local model = iron(half, false, { mu = 0, penalty = penalty,
                                      elements = { die = { 12 * fine, 4 }, slab = { 24 * fine, 6 } } })
    solved(model, path)
    local imbalance = model:contact_resultant "interface".imbalance
    check.at_most(("imbalance, finer %d, penalty %g"):format(fine, penalty), imbalance, last and last / 2 or 0.02)
    last = imbalance
  end
end)

-- ── Energies ─────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("contact energy and dissipation count once", function()
  local function energy(keys)
    local model = iron(keys)
    solved(model, path)
    return model:energy()
  end
  local passes, one = energy(half), energy { method = "gpts" }
  check.within_share("contact", passes.contact, one.contact, 0.05)
  check.within_share("friction", passes.friction, one.friction, 0.05)
  local missing = passes.work + passes.area_growth - passes.stored - passes.contact - passes.friction
  check.at_most("balance", missing / passes.work, 0.02)
end)

-- ── Other scenes ─────────────────────────────────────────────────────────────────────────────────────────────────────

--- A ball pressed on a disc, axisymmetric; a layer on the ball.
local function ball(swap, count, penalty, mu)
  local body = sg.body{ patch = sg.shapes.quarter_annulus{ inner = 0.3, outer = 1, start = 270, center = { 0, 1 } },
                        elements = { count, 2 }, order = "N2-N2.1", contact = "south", thickness_degree = 1,
                        material = sg.neo_hookean{ E = 2, nu = 0.3 } }
  local disc = sg.body{ patch = sg.shapes.rectangle{ width = 1.5, height = 1, corner = { 0, -1 } },
                        elements = { count + 3, 3 }, order = "N2", contact = "north", thickness_degree = 1,
                        material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  local slave, master = body:face "south", disc:face "north"
  if swap then slave, master = master, slave end
  local model = sg.model{
    kind = "axisymmetric", bodies = { ball = body, disc = disc },
    supports = { bed = { on = disc:face "south", fix = "xy" }, axis = { on = disc:face "west", fix = "x" },
                 middle = { on = body:face "west", fix = "x" }, grip = { on = body:face "east", drive = "y" } },
    contacts = { touch = { slave = slave, master = master, penalty = penalty, method = "half_passes",
                           friction = mu and { mu = mu, penalty = penalty } or nil } } }
  solved(model, { { steps = 4, grip = -0.15 } }, { newton = { tolerance = 1e-13 } })
  return model
end

check.case("axisymmetric: unbiased, and without friction the imbalance falls with elements and penetration", function()
  for _, mu in ipairs { false, 0.2 } do
    local one, other = ball(false, 6, 50, mu), ball(true, 6, 50, mu)
    check.near(one:reaction("grip").fy, other:reaction("grip").fy, 1e-11)
    check.near(one:profile("touch").pressure, other:profile("touch.master").pressure, 1e-10)
    check.equal(one:contact_resultant("touch").slipping > 0, mu ~= false)
  end
  local coarse, fine = ball(false, 6, 50), ball(false, 24, 800)
  local last = fine:contact_resultant("touch").imbalance
  check.at_most("imbalance", last / coarse:contact_resultant("touch").imbalance, 0.5)
end)

--- A block pressed on a larger one and dragged, in 3D with friction.
local function drag(swap)
  local function block(size, count, corner, face, young)
    return sg.body{ patch = sg.shapes.block{ size = size, corner = corner }, elements = { count, count, 1 },
                    order = "N2", contact = face, thickness_degree = 1,
                    material = sg.neo_hookean{ E = young, nu = 0.3 } }
  end
  local top = block({ 1, 1, 0.5 }, 2, { 0.5, 0.4, 0 }, "front", 20)
  local bed = block({ 3, 2, 1 }, 5, { 0, 0, -1 }, "back", 1)
  local slave, master = top:face "front", bed:face "back"
  if swap then slave, master = master, slave end
  local model = sg.model{
    bodies = { top = top, bed = bed },
    supports = { floor = { on = bed:face "front", fix = "xyz" }, grip = { on = top:face "back", drive = "xyz" } },
    contacts = { touch = { slave = slave, master = master, penalty = 20, points = 5, method = "half_passes",
                           friction = { mu = 0.2, penalty = 20 } } } }
  local run = solved(model, { { steps = 2, grip = { 0, 0, -0.05 } }, { steps = 6, grip = { 0.3, 0.1, -0.05 } } },
    { newton = { tolerance = 1e-13 } })
  return model, run
end

check.case("solids with friction: unbiased, Coulomb's law on both faces", function()
  local one, other = drag(false), drag(true)
  local a, b = one:reaction "grip", other:reaction "grip"
  check.near({ a[1], a[2], a[3] }, { b[1], b[2], b[3] }, 1e-10)
  check.within_share("mu", math.sqrt(a[1] ^ 2 + a[2] ^ 2) / math.abs(a[3]), 0.2, 0.1)
  for _, name in ipairs { "touch", "touch.master" } do
    local profile, slips = one:profile(name), 0
    for i, state in ipairs(profile.state) do
      if state == "slip" then
        slips = slips + 1
        check.within("traction", profile.traction[i] / profile.pressure[i], 0.2, 1e-12)
      end
    end
    check.equal(slips > 5, true)
  end
end)

-- ── Results, files, errors ───────────────────────────────────────────────────────────────────────────────────────────

check.case("both passes have names, profiles, pressures and lines", function()
  local model = iron(half)
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

check.case("resumed runs and loaded models are bitwise the same", function()
  local file = os.tmpname()
  local function stop(info) return info.stage == "slide" and info.step == 5 and "stop" or nil end
  local whole = iron(half)
  os.remove(file)
  solved(whole, path, { checkpoint = file })
  os.remove(file)
  iron(half):run(path, { checkpoint = file, on_step = stop })
  local resumed = iron(half)
  solved(resumed, path, { checkpoint = file, resume = true })
  for _, model in ipairs { resumed, sg.load(file) } do
    for _, name in ipairs { "interface", "interface.master" } do
      check.equal(core.pack(model:profile(name)), core.pack(whole:profile(name)))
      check.equal(model:contact_resultant(name).imbalance, whole:contact_resultant(name).imbalance)
    end
    check.equal(core.pack(model:energy()), core.pack(whole:energy()))
  end
  check.fails(function() iron { method = "gpts" }:run(path, { checkpoint = file, resume = true }) end, "differences")
  os.remove(file)
end)

check.case("robust runs and arc length", function()
  local expected = iron(half)
  solved(expected, { path[1] })
  for _, options in ipairs { sg.robust {}, { arc_length = true }, { penalty = { start = 0.1, steps = 2 } } } do
    local model = iron(half)
    solved(model, { path[1] }, options)
    check.within_share("force", model:reaction("grip").fy, expected:reaction("grip").fy, 1e-3)
  end
end)

check.case("wrong combinations are errors that name the argument", function()
  local body = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = { 2, 2 }, order = "N1",
                        contact = "south", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  local below = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1, corner = { 0, -1 } }, elements = { 2, 2 },
                         order = "N1", contact = "north", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
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
  check.fails(contact{ master = sg.rigid.plane{ point = { 0, -1 }, normal = { 0, 1 } } }, here, "contacts.floor",
    "half_passes", "obstacle", "gpts", "mortar")
  check.fails(contact{ per = "reference" }, here, "per", "current")
  check.fails(contact{ adhesion = { hamaker = 1, r0 = 1 } }, here, "adhesion", "half_passes")
  check.fails(contact{ multipliers = "equal" }, here, "multipliers", "mortar")
  check.fails(contacts{ floor = { method = "half_pass" } }, here, "method", "half_passes")
  check.fails(contacts{ floor = { method = "half_passes" }, ["floor.master"] = {} }, here, "floor.master",
    "name of a contact")
  check.fails(contact{ enforcement = "augmented" }, here, "contacts.floor", "half_passes", "augmented", "mortar")
end)

check.done()
