-- Derivatives next to central differences of whole runs, over formulations, states and kinds of parameters; and closed
-- forms.

local check, sg, lists, scenes = require "check", require "signorini", require "signorini.call.lists", require "scenes"

local tight = { newton = { tolerance = 1e-12 } }

--- A half ring that is pressed onto a slab, slides and returns, with this contact; q: E, nu, mu, eps, R.
local function slide(keys)
  return function(q)
    local slab = sg.body { patch = sg.shapes.rectangle { width = 4, height = 1 }, elements = { 12, 3 }, order = "N2",
                           material = sg.neo_hookean { E = q.E, nu = q.nu } }
    local ring = sg.body { patch = sg.shapes.half_annulus { inner = 0.3, outer = q.R, center = { 1.5, 1 + q.R } },
                           elements = { 8, 2 }, order = "N2", material = sg.neo_hookean { E = 10, nu = 0.3 } }
    local penalty = keys.enforcement ~= "multipliers" and q.eps or nil
    local contact = lists.merged({ slave = ring:face "south", master = slab:face "north", penalty = penalty,
                                   friction = { mu = q.mu, penalty = penalty } }, keys)
    local model = sg.model {
      bodies = { slab = slab, ring = ring }, contacts = { c = contact },
      supports = { bed = { on = slab:face "south", fix = "xy" },
                   lid = { on = { ring:face "west", ring:face "east" }, drive = "xy" } } }
    local stages = { { name = "press", steps = 2, lid = { 0, -0.08 } },
                     { name = "slide", steps = 4, lid = { 0.3, -0.08 } },
                     { name = "back", steps = 2, lid = { 0.2, -0.06 } } }
    return model, stages, tight
  end
end

local ironed = { E = 1, nu = 0.3, mu = 0.3, eps = 40, R = 0.8 }

--- Compares with differences at a distance at which no state differs; `columns` with the largest difference.
local function compare(name, scene, at, columns, most, scale)
  local found = sg.check_gradients { scene = scene, at = at, of = columns, by = { 2e-5 }, scale = scale }
  for _, row in ipairs(found.rows) do
    check.at_most(("%s: d %s / d %s"):format(name, row.name, row.parameter), row.difference, most)
  end
  return found.gradients
end

for _, keys in ipairs { {}, { per = "reference" }, { method = "half_passes" }, { method = "mortar" },
                        { method = "mortar", enforcement = "multipliers" } } do
  local name = table.concat({ keys.method or "points", keys.per or "current", keys.enforcement or "penalty" }, ", ")
  check.case("ring on a slab: " .. name, function()
    local at = lists.merged(ironed)
    if keys.enforcement == "multipliers" then at.eps = nil end
    local found = compare(name, slide(keys), at, { "lid.fx", "lid.fy" }, 1e-5)
    check.at_most("residual", found.residual, 1e-6)
  end)
end

-- ── Closed forms ─────────────────────────────────────────────────────────────────────────────────────────────────────

--- A block of linear material without lateral strain on a penalty plane, pressed by d; k = E/H, without friction
--- F = ε k d/(k + ε) per width.
local function pressed(q)
  local block = sg.body { patch = sg.shapes.rectangle { width = 1, height = q.H, corner = { 0, 0 } },
                          elements = { 2, 2 }, order = "N2", material = sg.linear_elastic { E = q.E, nu = 0 } }
  local model = sg.model {
    bodies = { block = block },
    supports = { lid = { on = block:face "north", fix = "x", drive = "y" } },
    contacts = { c = { slave = block:face "south", master = sg.rigid.plane { point = { 0, 0 }, normal = { 0, 1 } },
                       penalty = q.eps, per = "reference" } } }
  return model, { { steps = 2, lid = { -0.01 } } }, tight
end

check.case("a block on a plane: stiffness of block and penalty, and height", function()
  local E, H, eps, d = 2, 0.5, 10, 0.01
  local found = sg.gradients { scene = pressed, at = { E = E, H = H, eps = eps } }
  local k = E / H
  local force = eps * k * d / (k + eps)
  check.within("force", check.last(found.run, "lid.fy"), -force, 1e-9)
  local expected = { eps = k ^ 2 * d / (k + eps) ^ 2, E = eps ^ 2 * d / (k + eps) ^ 2 / H,
                     H = -eps ^ 2 * d / (k + eps) ^ 2 * k / H }
  for name, slope in pairs(expected) do check.within(name, found:column("lid.fy", name)[2], -slope, 1e-7) end
end)

check.case("a sliding block: the drag changes with friction by the pressing force", function()
  local function drag(q)
    local block = sg.body { patch = sg.shapes.rectangle { width = 1, height = 0.5, corner = { 0, 0 } },
                            elements = { 2, 2 }, order = "N2", material = sg.linear_elastic { E = 10, nu = 0 } }
    local plane = sg.rigid.plane { point = { 0, 0 }, normal = { 0, 1 } }
    local model = sg.model {
      bodies = { block = block }, supports = { lid = { on = block:face "north", drive = "xy" } },
      contacts = { c = { slave = block:face "south", master = plane, penalty = 100, per = "reference",
                         friction = { mu = q.mu, penalty = 1e4 } } } }
    return model, { { steps = 1, lid = { 0, -0.01 } }, { steps = 3, lid = { 0.1, -0.01 } } }, tight
  end
  local found = sg.gradients { scene = drag, at = { mu = 0.3 } }
  local run = found.run
  local slope, pressing = found:column("lid.fx", "mu")[run.steps], check.last(run, "lid.fy")
  -- All slips: F = μ P, and P does not depend on μ.
  check.within("pressing force", slope / pressing, -1, 1e-8)
end)

-- ── What it tells, and what it refuses ───────────────────────────────────────────────────────────────────────────────

check.case("the run keeps its bits, and cut steps are followed", function()
  local scene = slide {}
  local model, stages, options = scene(ironed)
  local alone = model:run(stages, options)
  local found = sg.gradients { scene = scene, at = ironed, of = { "lid.fx" } }
  for _, name in ipairs { "lid.fx", "lid.fy", "c.area", "iterations" } do
    check.equal(found.run:column(name), alone:column(name))
  end
  local cut = sg.check_gradients { at = { mu = 0.3 }, of = { "lid.fx" }, by = { 1e-5 }, scene = function(q)
    local made, list = scene(lists.merged(ironed, { mu = q.mu }))
    return made, list, { newton = { tolerance = 1e-12, iterations = 7 }, step = { adaptive = true, max = 0.5 } }
  end }
  check.at_most("increments of half a step", cut.rows[1].difference, 1e-6)
  check.equal(cut.gradients.run:column "increments"[1], 2)
end)

check.case("a value at the end of its range has the derivative of its side", function()
  local scene = slide {}
  local function with(q) return scene(lists.merged(ironed, { mu = q.mu })) end
  local found = sg.gradients { scene = with, at = { mu = 0 }, scale = { mu = 0.1 } }
  local drag = {}
  for k = 0, 2 do
    local model, stages, options = with { mu = 2e-4 * k }
    drag[k] = model:run(stages, options):column "lid.fx"
  end
  -- One-sided differences of second order; forces are about 0.07.
  for i, slope in ipairs(found:column("lid.fx", "mu")) do
    check.within("step " .. i, slope, (4 * drag[1][i] - 3 * drag[0][i] - drag[2][i]) / 4e-4, 1e-5)
  end
end)

check.case("a run that stops goes on from its files, bit for bit", function()
  local function saved(file, last)
    return function(q)
      local model, stages, options = slide {}(lists.merged(ironed, { E = q.E, mu = q.mu }))
      options = lists.merged(options, { checkpoint = { file = file, every = 1 }, resume = true,
                                        on_step = function(info) return info.step == last and "stop" or nil end })
      return model, stages, options
    end
  end
  local at = { E = 1, mu = 0.3 }
  local file = check.file "slide.sgn"
  local whole = sg.gradients { scene = saved(check.file "whole.sgn", 0), at = at }
  local begun = sg.gradients { scene = saved(file, 4), at = at }
  check.equal({ begun.run.reason, begun.run.steps }, { "stopped", 4 })
  local done = sg.gradients { scene = saved(file, 0), at = at }
  for name in pairs(at) do
    check.equal(done:column("lid.fx", name), whole:column("lid.fx", name))
    check.equal(done:column("c.area", name), whole:column("c.area", name))
  end
  check.equal({ done.passes, done.residual, done.reach.mu }, { whole.passes, whole.residual, whole.reach.mu })
  local model, stages, options = saved(file, 0)(at)
  check.fails(function() model:run(stages, options) end, "was saved by sg.gradients")
end)

check.case("reach: as far as sticking points stick", function()
  local function held(q)
    local block = sg.body { patch = sg.shapes.rectangle { width = 1, height = 0.5, corner = { 0, 0 } },
                            elements = { 2, 2 }, order = "N2", material = sg.linear_elastic { E = 10, nu = 0 } }
    local model = sg.model {
      bodies = { block = block }, supports = { lid = { on = block:face "north", drive = "xy" } },
      contacts = { c = { slave = block:face "south", master = sg.rigid.plane { point = { 0, 0 }, normal = { 0, 1 } },
                         penalty = 100, per = "reference", friction = { mu = q.mu, penalty = 100 } } } }
    return model, { { steps = 1, lid = { 0, -0.01 } }, { steps = 1, lid = { 0.001, -0.01 } } }, tight
  end
  local mu = 0.3
  local found = sg.gradients { scene = held, at = { mu = mu } }
  local reach = found.reach.mu
  check.equal({ reach > 0.1, reach < 0.9 }, { true, true })
  check.holds(tostring(found), ("begin to slip at a change of mu by %.2g %%"):format(100 * reach))
  for part, slips in pairs { [0.99] = false, [1.1] = true } do
    local model, stages, options = held { mu = mu * (1 - part * reach) }
    model:run(stages, options)
    check.equal({ part, model:contact_resultant("c").slipping > 0 }, { part, slips })
  end
end)

check.case("a point on a kink is counted", function()
  -- A flat block that touches the plane exactly: closed above, open below.
  local function touching(q)
    local model, stages = pressed { E = 2, H = 0.5, eps = 10 }
    stages[1].steps, stages[1].lid = 1, { q.d }
    return model, stages, tight
  end
  local found = sg.gradients { scene = touching, at = { d = 0 }, scale = { d = 0.01 } }
  check.equal(#found.kinks, 1)
  check.equal({ found.kinks[1].parameter, found.kinks[1].contact, found.kinks[1].step }, { "d", "c", 1 })
  check.holds(found.warnings[1], "points change between open, stick and slip")
  -- The mean of both sides, 0 and ε k/(k + ε)
  check.within("slope", found:column("lid.fy", "d")[1], 0.5 * 10 * 4 / 14, 1e-6)
end)

check.case("profiles, energies, measured results, print and files", function()
  local found = sg.gradients { scene = slide {}, at = { E = 1, nu = 0.3, mu = 0.3, eps = 40, R = 0.8 },
                               of = { "lid.fx", "twice" },
                               measure = function(model) return { twice = 2 * model:reaction "lid"[1] } end }
  local slopes = found:column("lid.fx", "mu")
  check.within("measured", found:column("twice", "mu")[8], 2 * slopes[8], 1e-12)
  local profile = found:profile("c", "E")
  check.equal(#profile.pressure, #found.run.model:profile("c").pressure)
  local energy, step = found:energy "E", 1e-4
  local function stored(E)
    local model, stages, options = slide {}(lists.merged(ironed, { E = E }))
    model:run(stages, options)
    return model:energy().stored
  end
  check.within("energy", energy.stored, (stored(1 + step) - stored(1 - step)) / (2 * step), 1e-5)
  check.holds(tostring(found), "change per 1 % of E = 1, R = 0.8")
  local file = check.file "gradients.csv"
  found:csv(file)
  local data = sg.csv.read(file)
  check.equal({ data.columns[1], data.columns[3], #data.rows }, { "step", "d lid.fx / d E", 8 })
  check.near(data.rows[8][3], found:column("lid.fx", "E")[8])
end)

check.case("scenes that depend on more than values, and parameters without size", function()
  local function refused(text, changed, at, scale)
    check.fails(function() sg.gradients { scene = changed, at = at or { E = 1 }, scale = scale } end, text)
  end
  local function with(q) return lists.merged(ironed, { E = q.E }) end
  refused("scene at E = 1.00003: it has 184 unknowns instead of 24: a parameter must not change meshes", function(q)
    if q.E > 1 then return slide {}(with(q)) end
    return pressed { E = 1, H = 0.5, eps = 10 }
  end)
  refused("has another number of steps", function(q)
    local model, stages = slide {}(with(q))
    stages[2].steps = q.E > 1 and 5 or 4
    return model, stages
  end)
  refused("returns the option arc_length", function(q)
    local model, stages = slide {}(with(q))
    return model, stages, { arc_length = true }
  end)
  refused("at.mu is 0, which has no size of its own. Hint: scale = { mu = 0.1 }", slide {}, { mu = 0 })
  refused("scale.nu: there is no parameter of this name", slide {}, { mu = 0.3 }, { nu = 1 })
  refused("scale.E = 1e-08 is too small next to the value 1", slide {}, { E = 1 }, { E = 1e-8 })
  refused("must return a model and its stages, got nothing", function(q) return nil, q.E end)
  refused("scene does not read the parameter 'E'", function() return pressed { E = 1, H = 0.5, eps = 10 } end)
  local calls = 0
  refused("scene returns another model when it is called again with the same values", function(q)
    calls = calls + 1
    return pressed { E = q.E, H = 0.5 + 1e-9 * calls, eps = 10 }
  end)
  refused("scene returns another path", function(q)
    calls = calls + 1
    local model, stages = pressed { E = q.E, H = 0.5, eps = 10 }
    stages[1].lid[1] = -0.01 - 1e-9 * calls
    return model, stages
  end)
  local once = table.pack(pressed { E = 1, H = 0.5, eps = 10 })
  refused("it returns the model of another call", function(q) return q.E > 0 and once[1], once[2] end)
  refused("at is empty", slide {}, {})
  refused("the argument of scene has no 'eps'", slide {}, { E = 1, nu = 0.3, mu = 0.3, R = 0.8 })
  local found = sg.gradients { scene = pressed, at = { E = 2, H = 0.5, eps = 10 } }
  check.fails(function() found:column("lid.fz", "E") end, "lid.fz")
  check.fails(function() found:column("lid.fy", "nu") end, "nu")
end)
