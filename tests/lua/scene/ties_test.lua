-- Tied faces: patch test, rates of convergence for a curved seam, and what else a run offers with ties.

require "check"

local function solved(model, stages, options) return check.completed(model:run(stages, sg.plain(options or {}))) end

-- ── Patch test ───────────────────────────────────────────────────────────────────────────────────────────────────────

--- Two blocks with 3 and 5 elements along the seam, under uniform pressure: the largest error of stress and traction,
--- and the model. `law` makes the material from its constants.
local function patch_errors(o)
  local flat, load, law = o.dimension == 2, 0.1, o.law or sg.linear_elastic
  local function block(count, is_lower, young)
    return sg.body{
      patch = flat and sg.shapes.rectangle{ width = 2, height = 1, corner = { 0, is_lower and -1 or 0 } } or
              sg.shapes.block{ size = { 2, 2, 1 }, corner = { 0, 0, is_lower and -1 or 0 } },
      elements = flat and { count, 2 } or { count, count, 2 }, order = o.order,
      contact = flat and (is_lower and "north" or "south") or (is_lower and "back" or "front"),
      material = law{ E = young, nu = 0.3 },
    }
  end
  local lower, upper = block(3, true, 1), block(5, false, 2)
  local bottom, top = flat and "south" or "front", flat and "north" or "back"
  local function both(...)
    local faces = {}
    for _, name in ipairs { ... } do faces[#faces + 1], faces[#faces + 2] = lower:face(name), upper:face(name) end
    return faces
  end
  local slave, master = lower:face(top), upper:face(bottom)
  if o.slave == "upper" then slave, master = master, slave end
  local model = scenes.model{ bodies = { lower = lower, upper = upper },
    supports = { bed = { on = lower:face(bottom), fix = flat and "y" or "z" },
      ends = { on = both("west", "east"), fix = "x" },
      sides = not flat and { on = both("south", "north"), fix = "y" } or nil },
    loads = { push = { on = upper:face(top), pressure = 0 } },
    ties = { seam = { slave = slave, master = master, multipliers = o.multipliers } } }
  solved(model, { { name = "press", steps = 2, push = load } }, { linear = o.linear })
  local largest, field, profile = 0, flat and "syy" or "szz", model:tie_profile "seam"
  -- In 3D the tangential tractions of the finer slave are not unique, because its sides are fixed.
  local unique = flat or o.slave == "lower"
  for i, pressure in ipairs(profile.pressure) do
    largest = math.max(largest, math.abs(pressure / load - 1), profile.jump[i] / load,
      unique and math.abs(profile.tx[i]) / load or 0)
  end
  for _, name in ipairs { "lower", "upper" } do
    for i = 1, 7, 2 do
      for k = 1, 7, 2 do
        local xi = flat and { i / 8, k / 8 } or { i / 8, k / 8, 0.9 }
        largest = math.max(largest, math.abs(model:sample(name, field, xi) / -load - 1))
      end
    end
  end
  return largest, model
end

check.case("patch test, 3 on 5 elements: uniform stress to rounding error, 2D and 3D, either slave", function()
  for _, multipliers in ipairs { "equal", "reduced" } do
    for _, order in ipairs { "N2", "N3", "N2-N2.2" } do
      for _, slave in ipairs { "lower", "upper" } do
        for dimension = 2, order == "N2" and 3 or 2 do
          check.at_most(("%s %s %s %dD"):format(multipliers, order, slave, dimension),
            (patch_errors{ dimension = dimension, order = order, slave = slave, multipliers = multipliers }),
            order == "N2-N2.2" and 1e-11 or 1e-12) -- degree 4 on the face
        end
      end
    end
  end
  check.at_most("L2", (patch_errors{ dimension = 2, order = "L2", slave = "upper" }), 1e-12)
  check.at_most("N1", (patch_errors{ dimension = 2, order = "N1", slave = "upper" }), 1e-12)
  check.at_most("3D N2-N2.2", (patch_errors{ dimension = 3, order = "N2-N2.2", slave = "upper" }), 1e-11)
end)

check.case("all linear solvers pass the patch test, with linear and nonlinear materials", function()
  for _, linear in ipairs { "klu", "umfpack", "condensed", "reuse", core.mumps and "mumps" or nil } do
    for dimension = 2, 3 do
      local error, model = patch_errors{ dimension = dimension, order = "N2", slave = "upper", linear = linear }
      check.at_most(linear, error, 1e-12)
      check.equal(model:solver().linear, linear)
    end
  end
  for _, linear in ipairs { "klu", "umfpack", "reuse", "auto", core.mumps and "mumps" or nil } do
    -- The nominal stress is uniform, and so is Cauchy's with guided sides: −p0 in both.
    local error = patch_errors{ dimension = 2, order = "N2", slave = "lower", linear = linear, law = sg.neo_hookean }
    check.at_most("neo-Hooke " .. linear, error, 1e-9)
  end
end)

-- ── Curved seam ──────────────────────────────────────────────────────────────────────────────────────────────────────

local function at_least(what, value, bound)
  if not (value >= bound) then error(("%s: expected at least %g, got %g"):format(what, bound, value), 2) end
end

local function study(...)
  return assert(loadfile(core.home .. "/scripts/problems/tied_seam.lua"))("out=" .. check.folder(), ...).cases
end

check.case("Lamé's cylinder with a tied curved seam: optimal rates with equal multipliers, either slave", function()
  local degrees = { N2 = 2, N3 = 3, ["N2-N2.2"] = 2 }
  local seen = 0
  for _, case in ipairs(study("meshes=2,3", "multipliers=equal")) do
    if case.mesh == 3 then
      local name, p = ("%s, slave %s"):format(case.order, case.slave), degrees[case.order]
      at_least(name .. ": energy", case.rates.energy, p - 0.2)
      at_least(name .. ": displacement", case.rates.displacement, p + 1 - 0.3)
      at_least(name .. ": traction", case.rates.traction, p + 1 - 0.1)
      -- not more than the discretization error of the rings: 2.1e-3 (N2) and 1.2e-4 (N3) with either slave
      check.at_most(name, case.energy, p == 2 and 2.2e-3 or 1.3e-4)
      seen = seen + 1
    end
  end
  check.equal(seen, 6)
end)

check.case("reduced multipliers: rates of the energy as well, traction of degree p - 2", function()
  for _, case in ipairs(study("meshes=2,3", "multipliers=reduced", "orders=N2,N3")) do
    if case.mesh == 3 then
      local name, p = ("%s, slave %s"):format(case.order, case.slave), case.order == "N2" and 2 or 3
      at_least(name .. ": energy", case.rates.energy, p - 0.2)
      at_least(name .. ": traction", case.rates.traction, p - 1 - 0.1)
      check.at_most(name .. ": traction", case.rates.traction, p - 1 + 0.1)
    end
  end
end)

check.case("four rings with seams that meet in two points, and a stiffer outer ring", function()
  for _, case in ipairs(study("meshes=1,2", "rings=4", "orders=N2", "multipliers=equal", "ratio=10")) do
    if case.mesh == 2 then
      at_least(case.slave .. ": energy", case.rates.energy, 1.9)
      at_least(case.slave .. ": displacement", case.rates.displacement, 2.5)
    end
  end
end)

-- ── What else a run offers ───────────────────────────────────────────────────────────────────────────────────────────

--- A strip of two tied halves that is pressed against a plane: contact, tie and large deformation.
local function pressed(o)
  o = o or {}
  local law = o.law or sg.neo_hookean
  local function half(name, y, count)
    return scenes.body{ size = {2, 0.5}, corner = { 0, y }, elements = { count, 2 }, material = law{ E = 1, nu = 0.3 } }
  end
  local lower, upper = half("lower", 0, 4), half("upper", 0.5, 3)
  return scenes.model{ bodies = { lower = lower, upper = upper },
    supports = { grip = { on = "upper.north", drive = "y", fix = "x" } },
    contacts = { ground = { slave = "lower.south", penalty = 100, friction = { mu = 0.3, penalty = 100 },
        master = scenes.floor(-0.02) } },
    ties = { seam = { slave = "lower.north", master = "upper.south" } } }
end

check.case("force balance across tie, contact and support; energy", function()
  local model = pressed()
  local run = solved(model, { { name = "press", steps = 5, grip = -0.2 } })
  local tie, contact, grip = model:tie_resultant "seam", model:contact_resultant "ground", model:reaction "grip"
  check.near(tie.fy, -contact.fy, 1e-9)
  check.near(tie.fy, grip.fy, 1e-9)
  check.near(tie.area, 2, 1e-12)
  check.equal(tie.part > 1 - 1e-12, true)
  local energy = model:energy()
  check.near(energy.work + energy.area_growth, energy.stored + energy.contact + energy.friction, 0.02 * energy.work)
  check.equal(#run.warnings, 0)
  check.equal(model:tie_names(), { "seam" })
  check.holds(tostring(model), "1 tie")
end)

check.case("unconstrained body held by a tie, damping, automatic controls, arc length", function()
  local model = pressed()
  check.equal(#model:unconstrained_bodies(), 0)
  local automatic = check.completed(pressed():run{ { name = "press", steps = 3, grip = -0.2 } })
  local robust = check.completed(pressed():run({ { name = "press", steps = 3, grip = -0.2 } }, sg.robust{}))
  local arc = check.completed(pressed():run({ { name = "press", steps = 3, grip = -0.2 } }, { arc_length = true }))
  solved(model, { { name = "press", steps = 3, grip = -0.2 } })
  for _, other in ipairs { automatic, robust, arc } do
    check.near(other:column "grip.fy"[#other:column "grip.fy"], model:reaction "grip".fy, 1e-6)
  end
end)

check.case("condensation with contact and ties agrees with a direct solver", function()
  local forces = {}
  for _, linear in ipairs { "condensed", "klu", "reuse" } do
    local model = pressed{ law = sg.linear_elastic }
    solved(model, { { name = "press", steps = 3, grip = -0.1 } }, { linear = linear })
    forces[#forces + 1] = model:reaction "grip".fy
  end
  check.near(forces[1], forces[2], 1e-9)
  check.near(forces[3], forces[2], 1e-9)
end)

check.case("saved models continue with the same results", function()
  local model = pressed()
  solved(model, { { name = "press", steps = 2, grip = -0.1 } })
  local copy = check.reloaded(model)
  for _, one in ipairs { model, copy } do solved(one, { { name = "further", steps = 1, grip = -0.15 } }) end
  check.equal(copy:tie_profile("seam").ty, model:tie_profile("seam").ty)
  check.equal(copy:reaction "grip".fy, model:reaction "grip".fy)
end)

check.case("a face tied in part: the tied part carries the force, and a warning says how much", function()
  local function block(from, to, y, count)
    return scenes.body{ size = {to - from, 1}, corner = { from, y }, elements = { count, 2 },
      material = sg.linear_elastic{ E = 1, nu = 0.3 } }
  end
  local lower, upper = block(0, 3, 0, 7), block(1, 2, 1, 4)
  local model = scenes.model{ bodies = { lower = lower, upper = upper },
    supports = { bed = { on = "lower.south", fix = "xy" } },
    loads = { pull = { on = "upper.north", traction = { 0, 0 } } },
    ties = { seam = { slave = "lower.north", master = "upper.south" } } }
  check.equal(#model:warnings(), 1)
  check.holds(model:warnings()[1], "ties.seam: 33 % of face 'north' of body 'lower' is tied")
  solved(model, { { name = "pull", steps = 1, pull = { 0.01, 0.02 } } })
  check.near(model:tie_resultant "seam".area, 1, 1e-12)
  check.near(model:tie_resultant "seam".fx, 0.01, 1e-9)
  check.near(model:tie_resultant "seam".fy, 0.02, 1e-9)
  check.near(model:reaction "bed".fy, -0.02, 1e-9)
end)

-- ── Wrong input ──────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("wrong input is an error at the user's line", function()
  local function block(y, order)
    return scenes.body{ corner = { 0, y }, elements = { 3, 2 }, order = order or "N2",
      material = sg.linear_elastic{ E = 1, nu = 0.3 } }
  end
  local lower, upper = block(0), block(1)
  local plane = scenes.floor(1)
  local function with(tie, other, contacts)
    return function()
      sg.model{ bodies = { lower = lower, upper = other or upper }, ties = { seam = tie }, contacts = contacts }
    end
  end
  local north, south = lower:face "north", upper:face "south"
  check.fails(with{ slave = north, master = plane }, "ties.seam.master must be a face")
  check.fails(with{ slave = north, master = north }, "ties.seam has the same face as slave and as master")
  check.fails(with{ slave = north, master = upper:face "north" }, "must coincide up to 10 % of an element's length",
    "are 1 apart")
  local far = block(1.2)
  check.fails(with({ slave = north, master = far:face "south" }, far), "are 0.2 apart at", "which is 60 %")
  check.fails(with({ slave = north, master = south }, nil,
    { touch = { slave = south, master = north, penalty = 1 } }), "ties.seam and contacts.touch act between the same")
  local linear = block(1, "N1")
  check.fails(with({ slave = linear:face "south", master = north, multipliers = "reduced" }, linear),
    'multipliers = "reduced" has degree p - 2')
  check.fails(function()
    sg.model{ bodies = { lower = lower, upper = upper }, supports = { seam = { on = north, fix = "x" } },
              ties = { seam = { slave = north, master = south } } }
  end, "has the name of a support")
  local model = sg.model{ bodies = { lower = lower, upper = upper },
                          ties = { seam = { slave = north, master = south } } }
  check.fails(function() model:tie_profile "sean" end, "sean")
  check.fails(function() model:profile "seam" end, "seam")
end)
