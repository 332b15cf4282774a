-- Contacts with enforcement = "multipliers": Hertz's contact without a parameter, friction, and what else a run offers.

require "check"
local problem = require "problems.hertz2d.problem"

local spaces = { "equal", "reduced" }

--- Keys of a contact with multipliers; `more` overrides.
local function keys(space, more)
  return lists.merged({ method = "mortar", multipliers = space, enforcement = "multipliers" }, more)
end

local function solved(model, stages, options) return check.completed(model:run(stages, sg.plain(options or {}))) end

-- ── Without friction ─────────────────────────────────────────────────────────────────────────────────────────────────

--- Hertz's line contact (scripts/problems/hertz2d) with other keys in its contact.
local function ring(own, order, mesh)
  local model, stage = problem.scene{ order = order, mesh = mesh, load = "displacement", penalty = own.penalty,
                                      formulation = { keys = own } }
  stage.steps = 2
  return model, stage
end

check.case("Hertz's line contact: hardly a penetration, nearly the same force for any penalty", function()
  for _, space in ipairs(spaces) do
    for _, order in ipairs { "N2", "N2-N2.2" } do
      local name, forces = space .. " " .. order, {}
      for i, penalty in ipairs { 1, 100, 1e4 } do
        local model, stage = ring(keys(space, { penalty = penalty }), order, "m2")
        solved(model, { stage })
        local resultant = model:contact_resultant "ground"
        forces[i] = resultant.fy
        check.at_most(name .. ": penetration", resultant.max_penetration, 5e-5)
      end
      for i = 2, 3 do check.within_share(name .. ": force", forces[i], forces[1], 2e-3) end
    end
  end
end)

check.case("Hertz's line contact: the force of Gauss points as their penalty grows", function()
  local function force(own, mesh)
    local model, stage = ring(own, "N2-N2.2", mesh)
    solved(model, { stage })
    return model:contact_resultant "ground".fy
  end
  for _, space in ipairs(spaces) do
    check.within_share(space, force(keys(space), "m3"), force({ penalty = 2e4 }, "m3"), 2e-3)
  end
end)

check.case("a block between walls on a plane: the exact pressure of uniaxial strain, none once it is lifted", function()
  local E, nu, depth = 2, 0.3, 0.2
  local mu, lambda, f = E / (2 * (1 + nu)), E * nu / ((1 + nu) * (1 - 2 * nu)), 1 - depth
  for _, space in ipairs { "equal", "reduced", "linear" } do
    local block = scenes.body{ contact = "south", material = sg.neo_hookean{ E = E, nu = nu } }
    local model = scenes.model{ bodies = { block = block },
      supports = { walls = { on = { "west", "east" }, fix = "x" }, top = { on = "north", drive = "y" } },
      contacts = { floor = keys(space,
        { slave = "south", penalty = 40, master = sg.rigid.plane{ point = { 0, 0 }, normal = { 0, 1 } } }) } }
    solved(model, { { name = "press", steps = 2, top = -depth } })
    local floor = model:contact_resultant "floor"
    check.within(space, floor.fy, -(mu * f + (lambda * math.log(f) - mu) / f), 1e-8)
    check.at_most(space .. ": penetration", floor.max_penetration, 1e-10)
    solved(model, { { name = "lift", steps = 1, top = 0.01 } })
    check.at_most(space .. ": lifted", model:reaction("top").fy, 1e-9)
  end
end)

check.case("any linear solver finds the same state", function()
  for _, space in ipairs(spaces) do
    local forces = {}
    for i, linear in ipairs { "auto", "klu", "umfpack", "condensed", "reuse", core.mumps and "mumps" or nil } do
      local model, stage = ring(keys(space), "N2", "m1")
      solved(model, { stage }, { linear = linear })
      forces[i] = model:contact_resultant "ground".fy
      check.within_share(linear, forces[i], forces[1], 1e-9)
    end
  end
end)

-- ── Friction ─────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A rigid cylinder on a slab.
local function iron(own, order, mu)
  local roller = sg.rigid.cylinder{ center = { 0.75, 1.5 }, radius = 0.5 }
  local slab = scenes.body{ size = {3, 1}, elements = { 16, 4 }, order = order, contact = "north",
    thickness_degree = 1 }
  own.slave, own.master, own.friction = slab:face "north", roller, mu > 0 and { mu = mu } or nil
  return scenes.model{ bodies = { slab = slab },
    supports = { bed = { on = "south", fix = "xy" }, grip = { on = roller, drive = "xy" } },
    contacts = { interface = own } }
end

local press = { name = "press", steps = 20, grip = { 0, -0.1 } }
local slide = { name = "slide", steps = 40, grip = { 0.4, -0.1 } }

check.case("ironing with friction: the energy balances, and nothing is stored in the contact", function()
  for _, space in ipairs(spaces) do
    for _, order in ipairs { "N2", "N2-N2.2" } do
      local model, name = iron(keys(space), order, 0.2), space .. " " .. order
      -- In plain Newton states cycle in 1 to 2 of 60 such scenes.
      solved(model, { press, { name = "slide", steps = 50, grip = { 0.4, -0.1 } } })
      local energy = model:energy()
      check.equal({ energy.contact }, { 0 })
      check.at_most(name .. ": energy",
        math.abs(energy.stored + energy.friction + energy.area_growth - energy.work), 0.01 * energy.work)
    end
  end
end)

check.case("Newton's method converges quadratically once few states change", function()
  for _, space in ipairs(spaces) do
    for _, mu in ipairs { 0, 0.2 } do
      local run = solved(iron(keys(space), "N2", mu), { press })
      for _, step in ipairs { 12, 15, 19 } do
        local residuals = run:residuals(step)
        local n = #residuals
        check.equal(n <= 6, true)
        check.at_most(("%s, mu = %g, step %d"):format(space, mu, step), residuals[n - 1],
          math.max(30 * residuals[n - 2] ^ 2, 1e-11))
      end
    end
  end
end)

check.case("load and hold: no creep over 50 steps, and sticking multipliers do not slip", function()
  for _, space in ipairs(spaces) do
    local model = iron(keys(space), "N2-N2.2", 0.3)
    local hold = { name = "hold", steps = 50, grip = { 0.004, -0.1 } }
    local run = solved(model, { press, { name = "nudge", steps = 2, grip = { 0.004, -0.1 } }, hold })
    local fx, fy = run:column "grip.fx", run:column "grip.fy"
    check.within("creep of the drag", fx[#fx], fx[22], 1e-10)
    check.within("creep of the force", fy[#fy], fy[22], 1e-10)
  end
end)

check.case("2D ironing, stiff on soft, either face as slave: few iterations, no cuts, equal forces", function()
  local means = {}
  for _, case in ipairs { { 9 }, { 18 }, { 24 }, { 36 }, { 18, "slab" } } do
    local die = scenes.body{ patch = sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = { 0.5, 1.5 } },
      elements = { case[1], 2 }, order = "N2-N2.2", contact = "south", E = 1000 }
    local slab = scenes.body{ size = { 3, 1 }, elements = { 24, 6 }, order = "N2-N2.2", contact = "north" }
    local slave, master = die:face "south", slab:face "north"
    if case[2] then slave, master = master, slave end
    local model = scenes.model{ bodies = { die = die, slab = slab },
      supports = { bed = { on = "slab.south", fix = "xy" }, grip = { on = { "die.west", "die.east" }, drive = "xy" } },
      contacts = { interface = keys(nil, { slave = slave, master = master, friction = { mu = 0.3 } }) } }
    local run = model:run{ { name = "press", steps = 10, grip = { 0, -0.075 } },
                           { name = "slide", steps = 30, grip = { 0.6, -0.075 } } }
    check.equal({ run.reason, run.cutbacks }, { "completed", 0 })
    check.at_most(("iterations per step, die of %d"):format(case[1]), run.iterations / run.steps, 5)
    local fy, mean = run:column "grip.fy", 0
    for step = 21, 40 do mean = mean + fy[step] / 20 end
    means[#means + 1] = mean
  end
  for i = 2, #means do check.within_share("mean force", means[i], means[1], 0.006) end
end)

-- ── What else a run offers ───────────────────────────────────────────────────────────────────────────────────────────

check.case("multipliers on the stiffer of two bodies are warned of", function()
  local function scene(first, second, space)
    local function block(y, young, face)
      return scenes.body{ corner = { 0, y }, elements = { 4, 2 }, contact = face, E = young }
    end
    local upper, lower = block(0, first, "south"), block(-1, second, "north")
    return scenes.model{ bodies = { upper = upper, lower = lower },
      supports = { bed = { on = "lower.south", fix = "xy" }, grip = { on = "upper.north", drive = "xy" } },
      contacts = { joint = keys(space, { slave = upper:face "south", master = lower:face "north" }) } }
  end
  check.holds(table.concat(scene(100, 1, "equal"):warnings(), "\n"), "contacts.joint", "body 'upper'",
    "100 times as stiff", 'use multipliers = "linear"', "exchange slave and master")
  check.equal({ #scene(1, 100, "equal"):warnings(), #scene(2, 1, "equal"):warnings(), #scene(100, 1):warnings() },
    { 0, 0, 0 })
  check.equal({ scene(100, 1):contact_law("joint").multipliers, scene(1, 100):contact_law("joint").multipliers },
    { "linear", "equal" })
end)

check.case("a block on a rigid plane in 3D: uniform pressure, pressed and dragged", function()
  for _, space in ipairs(spaces) do
    for _, mu in ipairs { 0, 0.3 } do
      local block = scenes.body{ size = { 2, 2, 1 }, elements = { 3, 3, 2 }, order = "N2-N2.1", contact = "front",
        nu = 0 }
      local model = sg.model{
        bodies   = { block = block },
        supports = { grip = { on = block:face "back", drive = "xyz" } },
        contacts = { floor = keys(space, { slave = block:face "front", friction = mu > 0 and { mu = mu } or nil,
                                           master = sg.rigid.plane{ point = { 0, 0, 0 }, normal = { 0, 0, 1 } } }) },
      }
      solved(model, { { name = "press", steps = 2, grip = { 0, 0, -0.1 } } })
      local profile, resultant = model:profile "floor", model:contact_resultant "floor"
      -- Uniaxial strain with nu = 0: the nominal stress of the block's material law is uniform.
      local low, high = math.huge, -math.huge
      for _, pressure in ipairs(profile.pressure) do low, high = math.min(low, pressure), math.max(high, pressure) end
      check.at_most("spread", high - low, 1e-9 * high)
      check.within_share("pressure", high * 4, math.abs(resultant.fz), 1e-9)
      check.at_most("penetration over the block's width", resultant.max_penetration / 2, 1e-12)
    end
  end
end)
