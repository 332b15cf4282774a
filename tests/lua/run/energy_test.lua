-- The energy balance of whole runs: the work of the supports is stored in the bodies and in the springs of contact, or
-- dissipated by friction. What is missing comes from the steps (the trapezoidal rule, slip measured at a step's end)
-- and, with friction, from the penetration: tractions work on the way of the point, slip is the way of its foot.

require "check"
local ironing = require "ironing"

local friction3d = require "problems.ironing3d.friction"

--- What is missing, in parts of the work; `energy` is what model:energy returns.
local function leak(energy) return (energy.work - energy.stored - energy.contact - energy.friction) / energy.work end

-- ── 2D ironing, the published path at m1 ─────────────────────────────────────────────────────────────────────────────

--- Leak of the whole path and energies at its end; `finer` divides the steps, both penalties are alike.
local function iron(order, finer, mu, penalty)
  local model = ironing{ order = order, mu = mu, penalty = penalty, friction_penalty = penalty }
  check.completed(model:run({ { steps = 46 * finer, grip = { 0, -0.23 } },
    { steps = 250 * finer, grip = { 1.5, -0.23 } } }, { step = { adaptive = true } }))
  return leak(model:energy()), model:energy()
end

check.case("2D ironing, N2-N2.2: the balance closes to 1e-3, with shorter steps better", function()
  local published, energy = iron("N2-N2.2", 1, 0.2, 100)
  local halved = iron("N2-N2.2", 2, 0.2, 100)
  check.at_most("published steps", published, 1e-3)
  if energy.friction < 0.7 * energy.work then error "friction takes most of the work" end
  if math.abs(halved) > 0.75 * math.abs(published) then
    error(("halved steps leave %g of %g"):format(halved, published))
  end
end)

check.case("2D ironing: the error left by shorter steps is due to penetration, stiffer penalties remove it", function()
  local soft, stiff = iron("N2-N2.2", 4, 0.2, 100), iron("N2-N2.2", 4, 0.2, 1000)
  check.at_most("soft", soft, 5e-4)
  check.at_most("stiff relative to soft", stiff / soft, 0.5)
end)

check.case("2D ironing, N2: energy error 2e-3 on the coarse face, less with stiffer penalties", function()
  local soft = iron("N2", 2, 0.2, 100)
  if soft > -2.0e-3 or soft < -2.5e-3 then error(("expected -2.2e-3, got %g"):format(soft)) end
  check.at_most("stiff", iron("N2", 2, 0.2, 1000), 1e-3)
end)

check.case("2D ironing without friction: only the error of the trapezoidal rule remains", function()
  local published, energy = iron("N2", 1, 0, 100)
  check.equal(energy.friction, 0)
  check.at_most("published steps", published, 1e-4)
  check.at_most("halved steps relative to published ones", iron("N2", 2, 0, 100) / published, 0.6)
end)

-- ── The growth of the slave's area ───────────────────────────────────────────────────────────────────────────────────

--- Parts of the work that are missing from the balance of a block which is pressed onto a plane without friction, and
--- ∫∫ ε_N g²/2 ȧ = ∫ p²/(2 ε_N) ȧ of its uniform pressure by the trapezoidal rule.
local function growing(penalty)
  local model = scenes.model{ bodies = { block = { contact = "south", E = 10 } },
    supports = { grip = { on = "north", drive = "y" }, middle = { on = "north-west", fix = "x" } },
    contacts = { touch = { slave = "south", master = scenes.floor(), penalty = penalty } } }
  local area, spring, growth = 1, 0, 0
  model:run({ { name = "press", steps = 64, grip = -0.3 } }, { on_step = function()
    local now = model:contact_resultant "touch"
    local density = now.max_pressure ^ 2 / (2 * penalty)
    growth, area, spring = growth + (density + spring) / 2 * (now.area - area), now.area, density
  end })
  local energy = model:energy()
  return (energy.stored + energy.contact - energy.work) / energy.work, growth / energy.work
end

check.case("with tractions per current area the balance lacks the growth of the slave's area", function()
  local missing, growth = growing(20)
  check.within("soft", missing / growth, 1, 0.01)
  check.within("part of the work", growth, 0.0106, 1e-4)
  local stiffer = select(2, growing(100))
  if stiffer > growth / 2 then error(("%g of the work, under a stiffer penalty %g"):format(growth, stiffer)) end
end)

-- ── 3D ironing on its sparsest mesh ──────────────────────────────────────────────────────────────────────────────────

local function iron3d(finer, mu)
  local case = friction3d.solve{ order = "N2", mesh = "sparse", radius = 7.5, depth = 2, mu = mu, distance = 6,
                                 down = 0.2 / finer, along = 0.3 / finer }
  check.equal({ case.run.failed, #case.energies }, { false, case.run.steps })
  return case
end

local pressed = 10 -- steps of the pressing as published

check.case("3D ironing with friction: the balance of the whole run closes to 1e-3", function()
  local published, halved = iron3d(1, 0.3), iron3d(2, 0.3)
  check.at_most("published steps", published.energy.leak, 1e-3)
  check.at_most("halved steps", halved.energy.leak, 1e-4)
  if published.energy.friction < 0.4 * published.energy.work then error "friction takes half of the work" end
  -- The error of the trapezoidal rule falls with the square of the step.
  local rate = published.energies[pressed].missing / halved.energies[2 * pressed].missing
  if rate < 3 or rate > 5 then error(("halved steps leave 1/%g of what is missing, expected 1/4"):format(rate)) end
end)

check.case("3D ironing without friction: nothing is dissipated", function()
  local case = iron3d(1, 0)
  check.equal(case.energy.friction, 0)
  check.at_most("published steps", case.energy.leak, 2e-3)
  check.near(case.energy.work - case.energy.stored - case.energy.contact, case.energy.missing)
end)
