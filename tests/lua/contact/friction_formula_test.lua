-- Coefficients of friction that are formulas: a block that is dragged over a plane, in every formulation; durations of
-- stages; checkpoints; what is refused.

require "check"

local function block(mu, keys)
  local body = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 0.5 }, elements = {4, 2}, order = "N2",
                        contact = "south", material = sg.neo_hookean{ E = 100, nu = 0.3 } }
  local contact = { slave = body:face "south", master = scenes.floor(0), penalty = 1e4,
                    friction = { mu = mu, penalty = 1e4 } }
  for key, value in pairs(keys or {}) do contact[key] = value end
  return sg.model{ bodies = { block = body }, supports = { top = { on = body:face "north", drive = "xy" } },
                   contacts = { floor = contact } }
end

local press = { name = "press", steps = 2, top = {0, -0.005}, duration = 1 }
local slide = { name = "slide", steps = 10, top = {0.1, -0.005}, duration = 2 }
local formulations = { points = {}, mortar = { method = "mortar" },
                       multipliers = { method = "mortar", enforcement = "multipliers" } }

-- ── Friction at each point, for each argument ────────────────────────────────────────────────────────────────────────

local laws = {
  number = { 0.3, function() return 0.3 end },
  pressure = { function(p) return 0.1 + 0.2 * sg.exp(-p) end, function(p) return 0.1 + 0.2 * math.exp(-p) end },
  place = { function(X) return 0.2 + 0.1 * X end, function(_, _, X) return 0.2 + 0.1 * X end },
  slip = { function(slip) return 0.3 + 0.1 * slip end, function(_, slip) return 0.3 + 0.1 * slip end },
}
for name, law in pairs(laws) do
  for _, formulation in ipairs { "points", "multipliers" } do
    check.case(("friction by %s, %s"):format(name, formulation), function()
      local model = block(law[1], formulations[formulation])
      local run = model:run({ press, slide })
      check.equal(run.reason, "completed")
      local profile = model:profile "floor"
      local slipping = 0
      for i, pressure in ipairs(profile.pressure) do
        if profile.state[i] == "slip" then
          slipping = slipping + 1
          local mu = law[2](pressure, name == "slip" and profile.slip[i] or 0, profile.X[i])
          check.near(math.abs(profile.traction[i]), mu * pressure, 1e-10 * pressure)
        end
      end
      check.equal(slipping > 25, true)
    end)
  end
end

check.case("friction by the rate of slip in steady sliding: all points slip with the velocity of the block", function()
  local velocity = 0.1 / slide.duration
  local mu = 0.3 + 0.1 * math.exp(-velocity / 0.2)
  for name, keys in pairs(formulations) do
    local model = block(function(v) return 0.3 + 0.1 * sg.exp(-v / 0.2) end, keys)
    check.equal(model:run({ press, slide }).reason, "completed")
    local force = model:contact_resultant "floor"
    check.near(-force.fx / force.fy, mu, name == "points" and 1e-6 or 1e-5)
    check.near(model:time(), 3, 1e-12)
  end
end)

check.case("static and kinetic friction: the force falls as the slip since sticking grows", function()
  local model = block({ static = 0.4, kinetic = 0.2, over = 0.01 })
  local run = model:run({ { name = "press", steps = 2, top = {0, -0.005} },
                          { name = "slide", steps = 40, top = {0.1, -0.005} } })
  local fx, fy, largest = run:column "floor.fx", run:column "floor.fy", 0
  for row = 3, #fx do largest = math.max(largest, -fx[row] / fy[row]) end
  check.equal(largest > 0.3 and largest < 0.4, true)
  check.near(-fx[#fx] / fy[#fx], 0.2 + 0.2 * math.exp(-0.09 / 0.01), 1e-4)
  local profile = model:profile "floor"
  for i = 1, #profile.mu do check.near(profile.mu[i], 0.2, 1e-3) end
  -- Turned back, points stick for a step, and begin to slip at the static coefficient.
  model:run({ { name = "back", steps = 2, top = {0.0999, -0.005} } })
  local stuck = 0
  for i, state in ipairs(model:profile "floor".state) do
    if state == "stick" then
      stuck = stuck + 1
      check.near(model:profile "floor".mu[i], 0.4, 1e-12)
    end
  end
  check.equal(stuck > 20, true)
end)

check.case("work and dissipation balance", function()
  for _, keys in pairs(formulations) do
    local model = block({ static = 0.4, kinetic = 0.2, over = 0.05 }, keys)
    model:run({ { name = "press", steps = 4, top = {0, -0.005} },
                { name = "slide", steps = 80, top = {0.1, -0.005} } })
    local energy = model:energy()
    local rest = energy.work - energy.stored - energy.contact - energy.friction - energy.area_growth
    check.at_most("the balance", rest / energy.work, 5e-3)
  end
end)

-- ── Fields and columns ───────────────────────────────────────────────────────────────────────────────────────────────

check.case("mu and slip as columns and fields, of a number and a formula", function()
  for name, keys in pairs(formulations) do
    for _, law in ipairs { laws.number, laws.place } do
      local model = block(law == laws.number and 0.3 or law[1], lists.merged(keys, { points = 3 }))
      local run, profile = model:run { press, slide }, model:profile "floor"
      local slip, sum, area = run:column "floor.slip", 0, 0
      check.near(slip[#slip] - slip[#slip - 1], 0.01, 1e-5) -- as far as the block moves in a step
      for i, a in ipairs(profile.area) do
        sum, area = sum + a * profile.slip[i], area + a
        -- Multipliers with a penalty have a place each, and interpolate between them.
        local tolerance = name == "mortar" and law == laws.place and 0.02 or 1e-12
        check.near(profile.mu[i], law[2](0, 0, profile.X[i]), tolerance)
      end
      check.near(slip[#slip], sum / area, 1e-14)
      check.near(model:contact_resultant "floor".slip, sum / area, 1e-14)
      for e = 1, 4 do -- the middle points of the elements
        for _, field in ipairs { "mu", "slip" } do
          check.near(model:sample("block", field, { (e - 0.5) / 4, 0 }), profile[field][3 * e - 1], 1e-14)
        end
      end
    end
  end
end)

check.case("mu and slip in pictures and .vtu files, of contacts with friction only", function()
  local model, folder = block(laws.place[1]), check.folder()
  model:run { press, slide }
  for _, field in ipairs { "mu", "slip" } do
    sg.picture{ model = model, field = field, file = ("%s/%s.png"):format(folder, field) }
  end
  check.pictures(folder, { "mu", "slip" })
  local file = folder .. "/state.vtu"
  sg.vtu{ model = model, file = file }
  check.holds(core.read_file(file), 'Name="mu"', 'Name="slip"')
  local smooth = scenes.model{ bodies = { block = { elements = {1, 1}, contact = "south" } },
    supports = { grip = { on = "north", drive = "y" } },
    contacts = { floor = { slave = "south", penalty = 1, master = scenes.floor() } } }
  local run = smooth:run { { steps = 1, grip = -0.01 } }
  check.equal(lists.holds(run:columns(), "floor.slip"), false)
  check.equal({ rawget(smooth:profile "floor", "mu"), rawget(smooth:contact_resultant "floor", "slip") }, {})
  sg.vtu{ model = smooth, file = file }
  check.equal(core.read_file(file):find('Name="slip"', 1, true), nil)
  check.fails(function() sg.picture{ model = smooth, field = "slip", file = folder .. "/none.png" } end,
    "field 'slip' needs a contact with friction, and the model has none")
  check.fails(function() smooth:sample("block", "mu", { 0.5, 0 }) end, "mu is defined on slave faces only",
    "contacts with friction")
end)

-- ── Time ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("time: column of a run, roll-back, cut steps, continuation", function()
  local mu = function(v) return 0.3 + 0.1 * sg.exp(-v / 0.2) end
  local model = block(mu)
  local run = model:run({ press, slide })
  local times = { 0.5, 1, 1.2, 1.4, 1.6, 1.8, 2, 2.2, 2.4, 2.6, 2.8, 3 }
  for row, time in ipairs(run:column "time") do check.near(time, times[row], 1e-12) end
  model:set_time(4)
  model:rollback()
  check.near(model:time(), 3, 1e-12)
  local other = block(mu)
  local rest = { { name = "slide", steps = 5, top = {0.1, -0.005}, duration = 1 } }
  other:run({ press, { name = "slide", steps = 5, top = {0.05, -0.005}, duration = 1 } })
  other:run(rest)
  check.near(other:contact_resultant "floor".fx, model:contact_resultant "floor".fx, 1e-6)
  check.near(other:time(), 3, 1e-12)
end)

check.case("a saved model has formula, slips and time", function()
  local function of(p, v, slip) return 0.2 + 0.01 * p + 0.05 * v + 0.3 * slip end
  local mortar = block(of, formulations.mortar)
  mortar:run({ press, slide })
  check.equal(check.reloaded(mortar):profile "floor".slip, mortar:profile "floor".slip)
  check.equal(check.reloaded(mortar):profile "floor".mu, mortar:profile "floor".mu)
  local model = block(of)
  model:run({ press, slide })
  local loaded = check.reloaded(model)
  check.equal(loaded:contact_law "floor".mu_formula, model:contact_law "floor".mu_formula)
  check.equal(loaded:time(), model:time())
  check.equal(loaded:profile "floor".mu, model:profile "floor".mu)
  check.equal(loaded:profile "floor".slip, model:profile "floor".slip)
  local on = { { name = "on", steps = 2, top = {0.12, -0.005}, duration = 0.4 } }
  model:run(on)
  loaded:run(on)
  check.equal(loaded:contact_resultant "floor".fx, model:contact_resultant "floor".fx)
end)

check.case("a function receives its arguments by name, where its names are not known by position", function()
  local function law(slip, p) return 0.2 + 0.01 * p + 0.3 * slip end
  local by_place = load(string.dump(function(p, _, slip) return 0.2 + 0.01 * p + 0.3 * slip end, true))
  local expected = block(function(p, slip) return 0.2 + 0.01 * p + 0.3 * slip end):contact_law "floor".mu_formula
  check.equal(block(law):contact_law "floor".mu_formula, expected)
  check.equal(block(by_place):contact_law "floor".mu_formula, expected)
  local function idle(p, cosine, Z) return 0.1 + p + 0 * cosine + 0 * Z end
  check.equal(block(idle):contact_law "floor".mu_formula, "p + 0.1")
  check.fails(function() block(load(string.dump(function(a, b, c, d, e, f, g, h) return a end, true))) end,
    "contacts.floor.friction.mu must take 7 arguments")
end)

-- ── Warnings and errors ──────────────────────────────────────────────────────────────────────────────────────────────

check.case("a warning where friction jumps or mu is negative, and none otherwise", function()
  local path = { { name = "press", steps = 2, top = {0, -0.005} }, { name = "slide", steps = 4, top = {0.01, -0.005} } }
  local function warned(mu, word)
    return lists.any(block(mu):run(path).warnings, function(text) return text:find(word, 1, true) ~= nil end)
  end
  check.equal(warned({ static = 0.4, kinetic = 0.2, over = 1e-6 }, "friction jumps"), true)
  check.equal(warned({ static = 0.4, kinetic = 0.2, over = 0.05 }, "friction jumps"), false)
  check.equal(warned(function(p) return 0.1 - p end, "the formula of mu is negative"), true)
  check.equal(warned(function(p) return 0.1 + p * 0.01 end, "negative"), false)
end)

check.case("a run whose mu is not finite names contact and argument", function()
  for _, keys in pairs(formulations) do
    local model = block(function(slip) return 0.3 + sg.sqrt(0.02 - slip) end, keys)
    local run = model:run({ press, { name = "slide", steps = 4, top = {0.1, -0.005}, duration = 1 } }, sg.plain{})
    check.equal(run.failed, true)
    check.holds(run.failure, "the formula of contacts.floor.friction.mu is not a finite number at X = (",
      "Hint: let the formula be finite")
  end
end)

check.case("what is refused", function()
  local function refused(mu, keys, path, options, ...)
    check.fails(function() block(mu, keys):run(path or { press }, options) end, ...)
  end
  local function rate(v) return 0.1 + v end
  refused(rate, {}, { { name = "slide", steps = 1, top = {0.1, 0} } }, {}, "model:run: contacts.floor.friction.mu "
    .. "depends on v, but stage 'slide' has no duration. Hint: write duration = its length in time")
  refused(0.1, {}, nil, { arc_length = true }, "stages[1] has a duration, but arc_length = true")
  refused(function() return 0.3 end, {}, nil, nil,
    "contacts.floor.friction.mu must return a formula of its arguments, got the number 0.3. Hint: write mu = 0.3")
  refused(function(p) return p * (0 / 0) end, {}, nil, nil, "contacts.floor.friction.mu contains the number",
    "must be finite")
  refused(0 / 0, {}, nil, nil, "contacts.floor.friction.mu must be", "finite")
  refused({ mu1 = 0.3, mu2 = 0.2 }, {}, nil, nil, "unknown argument 'mu1'", "as in { 0.3, 0.2 }")
  refused({ 0.1, 0.2, 0.3 }, {}, nil, nil, "contacts.floor.friction.mu must be", "write { mu1, mu2 }")
  refused("rough", {}, nil, nil, "contacts.floor.friction.mu must be", "as in function(p) return")
  refused(function() end, {}, nil, nil, "write return before the formula")
  refused(function(p, slips) return p + slips end, {}, nil, nil, "contacts.floor.friction.mu has an unknown parameter "
    .. "'slips'; did you mean 'slip'? known: p, v, slip, X, Y, Z, cosine")
  refused(function(_, v) return 0.1 * v end, {}, nil, nil, "unknown parameter '_'; known")
  refused(function(...) return 0.1 + ... end, {}, nil, nil, "contacts.floor.friction.mu must name its parameters")
  refused(function(cosine) return 0.3 + 0.1 * cosine end, {}, nil, nil, "depends on the direction of sliding")
  refused(function(p, Z) return 0.1 + p + Z end, {}, nil, nil,
    "contacts.floor.friction.mu depends on Z, but a plane model has X and Y")
  refused({ static = 0.2, kinetic = 0.3, over = 1 }, {}, nil, nil, "static = 0.2 is less than kinetic = 0.3")
  refused(function(p) return 0.1 + p end, {}, { { steps = 1, contacts = { floor = { friction = { mu = 0 } } } } }, nil,
    "the mu of contacts.floor is a formula")
  refused(rate, { points = "auto" }, nil, nil, 'contacts.floor.points is "auto", but a formula depends on v')
  local model = block(0.1)
  model:run { press }
  check.fails(function() model:set_time(0.5) end, "the time 0.5 is not one at or after that of the accepted state, 1")
end)
