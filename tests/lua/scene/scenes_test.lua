-- sg.scenes: each scene is solved with its defaults and compared with a closed form, a published figure or a balance.

require "check"
local other_warnings = require "other_warnings"

local function solved(name, o)
  local m, path, exact = sg.scenes[name](o or {})
  local run = m:run(path)
  if run.reason ~= "completed" then error(("%s: %s"):format(name, run.failure or run.reason), 2) end
  check.equal(o and other_warnings(run) or run.warnings, {}) -- defaults resolve the contact
  return m, run, exact
end

--- Forces of all supports add up to zero, and so do those of the support grip and the contact interface in y.
local function is_balanced(m)
  local contact, sum = m:contact_resultant "interface", { 0, 0 }
  local size = math.sqrt(contact.fx ^ 2 + contact.fy ^ 2)
  assert(size > 0)
  for _, name in ipairs(m:support_names()) do
    for i, force in ipairs(m:reaction(name)) do sum[i] = sum[i] + force / size end
  end
  check.near(sum, { 0, 0 }, 1e-6)
  check.at_most("force on the driven body", (m:reaction "grip"[2] + contact.fy) / size, 1e-6)
end

check.case("ironing: forces balance, and the energies of the path do", function()
  local m, run = solved "ironing"
  check.equal(run.steps, 146)
  is_balanced(m)
  local energy = m:energy()
  check.within_share("work", energy.stored + energy.contact + energy.friction, energy.work, 0.02)
  check.equal(run:column "grip.fx"[run.steps] > 0, true) -- friction and plowing resist the drag
end)

check.case("hertz: peak pressure and half-width agree with Hertz's, the force is the given one", function()
  for body, percent in pairs { cylinder = 1.5, ball = 3 } do
    local m, _, hertz = solved("hertz", { body = body })
    local now, edges = m:contact_resultant "ground", sg.profile_edges{ profile = m:profile "ground" }
    check.within_share(body .. " force", now.fy, body == "ball" and hertz.load or hertz.load / 2, 1e-6)
    check.within_share(body .. " peak", now.max_pressure, hertz.p0, percent / 100)
    check.within_share(body .. " half-width", edges.to, hertz.a, 0.015)
  end
end)

check.case("hertz: four times the load is twice the half-width of the cylinder", function()
  local _, _, once = sg.scenes.hertz{}
  local _, _, four = sg.scenes.hertz{ load = 4 * once.load }
  check.near({ four.a / once.a, four.p0 / once.p0 }, { 2, 2 }, 1e-12)
  local m, path, hertz = sg.scenes.hertz{ load = 2 * once.load, refinement = 2 }
  m:run(path)
  check.within_share("peak", m:contact_resultant "ground".max_pressure, hertz.p0, 0.015)
end)

check.case("rings: forces balance, and mu = 0 leaves none in the tangential direction", function()
  local m = solved("rings", { depth = 2 })
  is_balanced(m)
  local smooth = solved("rings", { depth = 0.5, mu = 0 })
  check.equal(smooth:contact_law "interface".mu, nil)
  for _, friction in ipairs(smooth:profile "interface".traction) do check.at_most("friction", friction, 1e-12) end
end)

check.case("block: the force of the published 3D scene, N2 on a finer mesh: 5.726 after pressing", function()
  local m, run = solved "block"
  check.within_share("force", -2 * run:column "grip.fz"[10], 5.726, 0.1)
  check.within_share("bed", -m:reaction "bed"[3], m:reaction "grip"[3], 1e-6)
end)

check.case("bumper: self-contact carries load once the bore touches itself, and energies balance", function()
  local m, run = solved("bumper", { order = "N2" })
  local _, without = solved("bumper", { depth = 11, self_contact = false })
  check.within_share("before the contact", without:column "plate.fy"[11], run:column "plate.fy"[11], 1e-6)
  check.equal(run:column "folds.area"[11], 0)
  assert(run:column "folds.area"[24] > 1500)
  local energy = m:energy()
  check.within_share("work", energy.stored + energy.contact + energy.friction, energy.work + energy.area_growth, 0.002)
end)

check.case("peeling: the moment of steady peeling from the energy balance", function()
  local _, run, steady = solved "peeling"
  local angle, moment = run:column "edge.angle", run:column "edge.moment"
  check.equal(angle[#angle], 46)
  for i, value in ipairs(angle) do
    if value >= 36 then check.within_share(("moment at %g degrees"):format(value), moment[i], steady.moment, 0.01) end
  end
end)

check.case("patch_test: uniform pressure, with two half passes to rounding error", function()
  for method, share in pairs { gpts = 2e-3, mortar = 2e-3, half_passes = 1e-8 } do
    for dimension = 2, 3 do
      local m, _, exact = solved("patch_test", { method = method, dimension = dimension, order = "N2-N2.1" })
      for _, pressure in ipairs(m:profile "joint".pressure) do
        check.within_share(("%s in %dD"):format(method, dimension), pressure, exact.pressure, share)
      end
    end
  end
end)

check.case("refinement multiplies the elements, order is that of all bodies, paths can be changed", function()
  local coarse, path = sg.scenes.ironing{ order = "N2", depth = 0.02, distance = 0.1 }
  local fine = sg.scenes.ironing{ refinement = 2 }
  check.holds(coarse:body "die", "6 x 2 elements", "degree 2 x 2")
  check.holds(fine:body "slab", "16 x 6 elements")
  path[1].steps = 2
  check.equal(coarse:run{ path[1] }.steps, 2)
end)

check.case("print(sg.scenes) lists them, and help has a page on each", function()
  check.holds(tostring(sg.scenes), "block, bumper, hertz, ironing, patch_test, peeling, rings")
  local output = check.program({}, "?sg.scenes\n?sg.scenes.peeling.bonded\nhelp 'scenes'\n?ironing\n")
  check.holds(output, 'sg.scenes.ironing{ order = "N2-N2.2"', "Argument of sg.scenes.peeling\nbonded: ",
    "Ready scenes:")
end)

check.case("wrong calls name the argument at the user's line", function()
  for code, message in pairs {
    ["sg.scenes.irning{}"] = "there is no sg.scenes.irning; did you mean 'ironing'?",
    ["sg.scenes.ironing{ mue = 0.1 }"] = "prompt:1: sg.scenes.ironing: unknown argument 'mue'",
    ["sg.scenes.ironing{ mu = -0.1 }"] = "sg.scenes.ironing: mu must be",
    ["sg.scenes.ironing{ order = 'N9x' }"] = "N9x",
    ["sg.scenes.patch_test{ method = 'gtps' }"] = "did you mean 'gpts'?",
    ["sg.scenes.bumper{ depth = 40 }"] = "sg.scenes.bumper: depth must be",
    ["sg.scenes.block('N2')"] = "sg.scenes.block",
  } do
    check.ended({ check.program({}, code .. "\n") }, 1, message)
  end
end)

check.case("from an empty prompt to a picture in three statements", function()
  local folder = check.folder()
  check.ended({ check.program({ "-q" }, ([[
m, path = sg.scenes.ironing{}
m:run(path)
sg.picture{ model = m, field = "uy", file = "%s/first.png" }]]):format(folder)) }, 0, "press", "slide")
  check.pictures(folder, { "first" })
end)
