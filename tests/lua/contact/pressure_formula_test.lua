-- Pressures that are formulas of the gap: a block pressed on a rough face, adhesion, files, what is refused.

require "check"

local function block(keys, face)
  local body = sg.body{ patch = sg.shapes.rectangle{ width = 2, height = 0.5 }, elements = {4, 2}, order = "N2",
                        contact = "south", material = sg.neo_hookean{ E = 1e6, nu = 0 } }
  local contact = { slave = body:face "south", master = face or scenes.floor(0) }
  for key, value in pairs(keys) do contact[key] = value end
  return sg.model{ bodies = { block = body }, contacts = { floor = contact },
                   supports = { top = { on = body:face "north", drive = "xy" } } }
end

check.case("a stiff block on p = k (-g)^m has the force k A (-g)^m", function()
  for _, m in ipairs { 1, 1.5, 2, 3 } do
    for _, method in ipairs { "gpts", "mortar" } do
      local model = block { pressure = function(g) return 1e3 * sg.max(0, -g) ^ m end, method = method }
      check.completed(model:run { { steps = 4, top = {0, -0.01} } })
      local gap = model:profile "floor".gap[1]
      check.near(gap, -0.01, 5e-5)
      check.near(model:contact_resultant "floor".fy, 1e3 * 2 * (-gap) ^ m, 1e-9 * 1e3)
      -- ∫ k (−g)^m dg A
      check.near(model:energy().contact, 1e3 * 2 * (-gap) ^ (m + 1) / (m + 1), 1e-5 * 1e3 * 2 * 0.01 ^ (m + 1))
    end
  end
end)

check.case("a clearance, a place and friction", function()
  local model = block { pressure = function(g, X) return 1e3 * (1 + X) * (0.02 - g) end, clearance = 0.02,
                        friction = { mu = 0.2, penalty = 1e5 } }
  check.completed(model:run { { steps = 4, top = {0, -0.01} }, { steps = 4, top = {0.05, -0.01} } })
  local profile = model:profile "floor"
  for i, pressure in ipairs(profile.pressure) do
    check.near(pressure, 1e3 * (1 + profile.X[i]) * (0.02 - profile.gap[i]), 1e-9 * 1e3)
    check.equal(profile.state[i], "slip")
    check.near(math.abs(profile.traction[i]), 0.2 * pressure, 1e-9 * 1e3)
  end
  local loaded = check.reloaded(model)
  check.equal(loaded:contact_law "floor".pressure, model:contact_law "floor".pressure)
  check.equal(loaded:contact_law "floor".clearance, 0.02)
  local on = { { steps = 2, top = {0.06, -0.02} } }
  model:run(on)
  loaded:run(on)
  check.equal(loaded:contact_resultant "floor".fy, model:contact_resultant "floor".fy)
end)

check.case("adhesion as a formula is adhesion", function()
  local A, r0 = 0.1, 0.4
  local near = 15 ^ (-1 / 6) * r0
  local scale = A / (2 * math.pi * r0 ^ 3)
  local slope = scale * (r0 ^ 3 / near ^ 4 - r0 ^ 9 / (5 * near ^ 10))
  local function traction(g)
    local r = sg.max(g, near)
    return scale * ((r0 / r) ^ 9 / 45 - (r0 / r) ^ 3 / 3) + slope * sg.min(g - near, 0)
  end
  local function pulled(keys)
    local model = block(keys, scenes.floor(-near))
    check.completed(model:run { { steps = 6, top = {0, 0.1} } })
    return model:contact_resultant "floor".fy
  end
  local expected = pulled { adhesion = { hamaker = A, r0 = r0 } }
  check.equal(expected < -0.01, true)
  check.near(pulled { pressure = traction, clearance = "none", per = "reference" }, expected, 1e-10)
end)

check.case("what is refused", function()
  local function refused(keys, ...)
    check.fails(function() block(keys) end, "pressure_formula_test.lua:", ...)
  end
  refused({ pressure = function(g) return -g end, penalty = 1 }, "it has both pressure and penalty")
  refused({ clearance = 1 }, "it has clearance without pressure")
  refused({ pressure = function(g) return -g end, method = "mortar", enforcement = "multipliers" },
    'it has pressure and enforcement = "multipliers"')
  refused({ pressure = function(g) return 1 - g end }, "contacts.floor.pressure is 1 at the clearance, g = 0",
    "give the gap at which the formula vanishes")
  refused({ pressure = function(g) return g * g * (g + 0.1) end },
    "contacts.floor.pressure falls as the faces approach")
  refused({ pressure = function(g) return g * 1.0 end }, "contacts.floor.pressure pulls, -0", 'needs per = "reference"')
  refused({ pressure = function(g) return sg.log(g) end }, "contacts.floor.pressure is", "it must be finite")
  refused({ pressure = function(g) return 0 * g end }, "contacts.floor.pressure is 0 down to g = -0.25")
  refused({ pressure = function() end }, "write return before the formula")
  refused({ pressure = function() return 5 end }, "got the number 5. Hint: let it depend on g")
  refused({ pressure = 5 }, "contacts.floor.pressure must be a function", "as in function(g)")
  refused({ pressure = function(g, Z) return -g * Z end }, "contacts.floor.pressure depends on Z, but a plane")
  local model = block { pressure = function(g) return -g * 1e3 end }
  check.fails(function() model:run { { steps = 1, contacts = { floor = { penalty = 3 } } } } end,
    "the pressure of contacts.floor is a formula, so that it has no penalty to change")
end)

check.case("the greater and the lesser of two", function()
  check.equal({ sg.max(1, 2), sg.min(1, 2), sg.max(-1.5, -2) }, { 2, 1, -1.5 })
  local symbol = core.symbols { "x" }[1]
  check.holds(tostring(sg.max(symbol, 1)), "abs")
end)
