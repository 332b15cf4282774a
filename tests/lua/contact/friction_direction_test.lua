-- Friction that depends on the direction of sliding: forward and backward in the plane, ellipses and formulas of the
-- cosine in space, in every formulation; checkpoints; what is refused.

require "check"

local formulations = { points = {}, mortar = { method = "mortar" },
                       multipliers = { method = "mortar", enforcement = "multipliers" } }

--- A block on a floor, driven at its top; `friction` has mu and along, `drive` the components.
local function block(friction, keys, E, drive)
  local space = #(friction.along or {0, 0}) == 3
  local contact = { slave = space and "front" or "south", penalty = 1e4,
                    master = space and sg.rigid.plane{ point = {0, 0, 0}, normal = {0, 0, 1} } or scenes.floor(0),
                    friction = { mu = friction.mu, along = friction.along, penalty = 1e4 } }
  return scenes.model{
    bodies = { block = { size = space and {1, 1, 0.5} or {1, 0.5}, elements = space and {2, 2, 1} or {4, 2},
                         E = E or 100, contact = contact.slave } },
    supports = { top = { on = space and "back" or "north", drive = drive or space and "xyz" or "xy" } },
    contacts = { floor = lists.merged(contact, keys or {}) } }
end

local function slid(model, ...)
  local top = {...}
  local path = { { name = "press", steps = 1, top = #top == 2 and {0, top[2]} or {0, 0, top[3]} },
                 { name = "slide", steps = 15, top = top } }
  check.equal(model:run(path).reason, "completed")
  return model
end

-- ── In space ─────────────────────────────────────────────────────────────────────────────────────────────────────────

local mu1, mu2 = 0.4, 0.15

--- The axes of a stiff block do not turn. With multipliers its stiffness gives the pressure.
local function stiff(name)
  if name == "multipliers" then return 1e6, -1e-5, 1e-5 end
  return 1e12, -0.005, 1e-9
end

for name, keys in pairs(formulations) do
  check.case("an ellipse gives the friction of its direction of slip: " .. name, function()
    local E, z, within = stiff(name)
    for _, angle in ipairs { 0, 0.5, 1.2, 2.4 } do
      local d1, d2 = math.cos(angle), math.sin(angle)
      local model = slid(block({ mu = {mu1, mu2}, along = {2, 0, 0} }, keys, E), 0.4 * d1, 0.4 * d2, z)
      local force = model:contact_resultant "floor"
      local scale = -force.fz / math.sqrt((mu1 * d1) ^ 2 + (mu2 * d2) ^ 2)
      check.near(force.fx, scale * mu1 ^ 2 * d1, within * force.fz)
      check.near(force.fy, scale * mu2 ^ 2 * d2, within * force.fz)
    end
  end)

  check.case("a force in one direction moves a block along the normal of the ellipse: " .. name, function()
    -- Free along y: friction acts along x, which has the components (cos, -sin) in the turned axes.
    local angle, E, z, within = 0.6, stiff(name)
    local model = block({ mu = {mu1, mu2}, along = {math.cos(angle), math.sin(angle), 0} }, keys, E, "xz")
    local function drift()
      local profile, x, y = model:profile "floor", 0, 0
      for i = 1, #profile.x do x, y = x + profile.x[i], y + profile.y[i] end
      return x / #profile.x, y / #profile.x
    end
    slid(model, 0.2, z)
    local x, y = drift()
    model:run { { name = "on", steps = 5, top = {0.3, z} } }
    local x2, y2 = drift()
    local g1, g2 = math.cos(angle) / mu1 ^ 2, -math.sin(angle) / mu2 ^ 2
    local slope = (g1 * math.sin(angle) + g2 * math.cos(angle)) / (g1 * math.cos(angle) - g2 * math.sin(angle))
    check.near((y2 - y) / (x2 - x), slope, math.max(within, 1e-6))
    check.near(model:contact_resultant "floor".fy, 0, 1e-8)
  end)
end

check.case("at each point friction is on the ellipse, and its coefficient that of the slip", function()
  local E, z = stiff()
  local profile = slid(block({ mu = {mu1, mu2}, along = {1, 0, 0} }, {}, E), 0.3, 0.2, z):profile "floor"
  local slipping = 0
  for i, pressure in ipairs(profile.pressure) do
    if profile.state[i] == "slip" then
      slipping = slipping + 1
      local t1, t2 = profile.tx[i], profile.ty[i]
      check.near((t1 / mu1) ^ 2 + (t2 / mu2) ^ 2, pressure ^ 2, 1e-10 * pressure ^ 2)
      local g = math.sqrt((t1 / mu1 ^ 2) ^ 2 + (t2 / mu2 ^ 2) ^ 2)
      check.near(profile.mu[i] * g, pressure, 1e-10 * g)
    end
  end
  check.equal(slipping > 20, true)
end)

local function turning(cosine) return 0.3 + 0.1 * cosine + 0.05 * cosine ^ 2 end

for _, name in ipairs { "points", "multipliers" } do
  check.case("a formula of the cosine: " .. name, function()
    local along, E, z, within = {math.cos(0.7), math.sin(0.7), 0}, stiff(name)
    local profile = slid(block({ mu = turning, along = along }, formulations[name], E), 0.3, 0.2, z):profile "floor"
    local slipping = 0
    for i, pressure in ipairs(profile.pressure) do
      if profile.state[i] == "slip" then
        slipping = slipping + 1
        local t1, t2 = profile.tx[i], profile.ty[i]
        local t = math.sqrt(t1 ^ 2 + t2 ^ 2)
        local c = (t1 * along[1] + t2 * along[2]) / t
        check.near(t, (0.3 + 0.1 * c + 0.05 * c ^ 2) * pressure, 0.1 * within * pressure)
      end
    end
    check.equal(slipping > 20, true)
  end)
end

check.case("work and dissipation balance", function()
  for _, friction in ipairs { { mu = {mu1, mu2}, along = {1, 0, 0} }, { mu = turning, along = {1, 0, 0} } } do
    for _, keys in pairs(formulations) do
      local model = block(friction, keys)
      model:run { { name = "press", steps = 4, top = {0, 0, -0.005} },
                  { name = "slide", steps = 40, top = {0.1, 0.07, -0.005} } }
      local energy = model:energy()
      local rest = energy.work - energy.stored - energy.contact - energy.friction - energy.area_growth
      check.at_most("the balance", math.abs(rest / energy.work), 1e-2)
    end
  end
end)

-- ── In the plane ─────────────────────────────────────────────────────────────────────────────────────────────────────

local function both_ways(cosine) return 0.3 + 0.1 * cosine end

check.case("friction forward and backward", function()
  for _, keys in pairs(formulations) do
    for _, sign in ipairs { 1, -1 } do
      local model = block({ mu = both_ways, along = {sign, 0} }, keys)
      local forward = slid(model, 0.2, -0.005):contact_resultant "floor"
      check.near(-forward.fx / forward.fy, 0.3 + 0.1 * sign, 1e-8)
      model:run { { name = "back", steps = 15, top = {0, -0.005} } }
      local back = model:contact_resultant "floor"
      check.near(back.fx / back.fy, 0.3 - 0.1 * sign, 1e-8)
    end
  end
end)

check.case("both half passes have the friction of one direction", function()
  local model = scenes.model{
    bodies = { block = { size = {1, 0.5}, corner = {0.5, 0.5}, elements = {4, 2}, E = 100, contact = "south" },
               slab = { size = {2, 0.5}, elements = {8, 2}, E = 100, contact = "north" } },
    supports = { top = { on = "block.north", drive = "xy" }, ground = { on = "slab.south", fix = "xy" } },
    contacts = { pad = { slave = "block.south", master = "slab.north", method = "half_passes", penalty = 1e4,
                         friction = { mu = both_ways, along = {1, 0}, penalty = 1e4 } } } }
  slid(model, 0.2, -0.005)
  for _, pass in ipairs { "pad", "pad.master" } do
    local force = model:contact_resultant(pass)
    check.near(math.abs(force.fx / force.fy), 0.4, 1e-2)
  end
end)

-- ── Files, stages, errors ────────────────────────────────────────────────────────────────────────────────────────────

check.case("a saved model has its axis", function()
  for _, friction in ipairs { { mu = {mu1, mu2}, along = {0, 1, 0} }, { mu = turning, along = {0, 1, 0} },
                              { mu = both_ways, along = {-1, 0} } } do
    local plane = #friction.along == 2
    local model = plane and slid(block(friction), 0.01, -0.005) or slid(block(friction), 0.01, 0.02, -0.005)
    local loaded = check.reloaded(model)
    check.equal(loaded:contact_law "floor", model:contact_law "floor")
    check.equal(loaded:contact_law "floor".along, friction.along)
    local on = { { name = "on", steps = 2, top = plane and {0, -0.005} or {0, 0, -0.005} } }
    model:run(on)
    loaded:run(on)
    check.equal(loaded:contact_resultant "floor", model:contact_resultant "floor")
  end
  local law = block { mu = {mu1, mu2}, along = {0, 1, 0} }:contact_law "floor"
  check.equal({ law.mu1, law.mu2, law.mu }, {mu1, mu2})
end)

check.case("what is refused", function()
  local function refused(friction, message, keys) check.fails(function() block(friction, keys) end, message) end
  refused({ mu = both_ways }, "friction.mu depends on the direction of sliding, but friction has no along")
  refused({ mu = {0.2, 0.3} }, "friction.mu depends on the direction of sliding, but friction has no along")
  refused({ mu = 0.2, along = {1, 0} }, "contacts.floor: friction.along has no effect, since friction.mu is the same")
  refused({ mu = function(p) return 0.1 + p end, along = {1, 0} }, "friction.along has no effect")
  refused({ mu = {0.2, 0.3}, along = {1, 0} }, "needs two directions of sliding, of which a plane has one")
  refused({ mu = {0.2, 0.3}, along = {0, 0, 0} }, "contacts.floor: friction.along must be a direction, but all of its "
    .. "components are zero. Hint: write a direction along the slave face")
  refused({ mu = {0.2, 0.3}, along = "x" }, "Hint: write its coordinates, as in {1, 2}")
  refused({ mu = {0.2, 0.3}, along = {0, 0, 1} }, "friction.along is normal to the slave face at X = (")
  refused({ mu = {0.2, 0}, along = {1, 0, 0} }, "contacts.floor.friction.mu[2] must be a positive number, got")
  refused({ mu = {0.2, 0.3, 0.4}, along = {1, 0, 0} }, "contacts.floor.friction.mu must be")
  refused({ mu = both_ways, along = {1, 0} }, "cohesive contact needs friction that is the same in all directions",
    { cohesive = { strength = 1, energy = 1 } })
  check.fails(function()
    scenes.model{ bodies = { block = { size = {1, 0.5} } }, supports = { top = { on = "north", drive = "xy" } },
                  contacts = { floor = { slave = "south", master = scenes.floor(0),
                                         friction = { mu = both_ways, along = {1, 0, 0} } } } }
  end, "contacts.floor.friction.along must have 2 components, got 3")
  check.fails(function()
    block { mu = {mu1, mu2}, along = {1, 0, 0} }:run { { steps = 1, top = {0, 0, 0},
                                                         contacts = { floor = { friction = { mu = 0.1 } } } } }
  end, "the mu of contacts.floor is a formula or has two values, so that a load path cannot change it")
end)
