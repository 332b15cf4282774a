-- model:cost: its numbers against the bodies', and every promise of its advice against the model that one gets by
-- following it; nothing is promised where one thing stands in the way. Symmetry: cost_symmetry_test.lua.

local sg = require "signorini"
local check = require "check"
local scenes = require "cost_scenes"

local soft, stiff = scenes.soft, scenes.stiff
local advice, none, promises, ironing, punch = scenes.advice, scenes.none, scenes.promises, scenes.ironing, scenes.punch

check.case("the numbers are those of bodies, contacts and solver, before a solve and after it", function()
  local model = ironing "N2-N4"
  local cost = model:cost()
  -- N2 on 8 elements along the slab: 10 functions, N4 on its face: 12; through it 4 rows, the lowest held. The die's
  -- arc has a knot of its own in the middle, C0: one function more; two more are held at the ends of each row.
  check.equal({ cost.bodies.slab.unknowns, cost.bodies.slab.contact_layer, cost.bodies.slab.bulk,
                cost.bodies.slab.prescribed }, { 2 * 32, 2 * 12, 2 * 20, 2 * 10 })
  check.equal({ cost.bodies.slab.elements, cost.bodies.slab.gauss_points }, { 24, 16 * 3 * 2 + 8 * 5 * 2 })
  local die = cost.bodies.die
  check.equal(die.unknowns + die.prescribed, model:body "die":dofs().total)
  check.equal(die.contact_layer, model:body "die":dofs().interface - 4)
  check.equal({ cost.unknowns, cost.obstacles }, { die.unknowns + 64, 0 })
  check.equal(cost.unknowns, #model:unknowns())
  check.equal({ cost.contacts.interface.points, cost.contacts.interface.rigid }, { 6 * 15, false })
  check.equal(cost.nonzeros, #model:tangent().values)
  check.equal({ cost.factors_are, cost.linear }, { "counted", "klu" })
  check.equal(cost.memory, cost.memory_of.bodies + cost.memory_of.contacts + cost.memory_of.tangent
    + cost.memory_of.factors)

  check.equal(model:run({ { steps = 2, grip = { -0.05 } } }).failed, false)
  local later = model:cost()
  check.equal({ later.factors_are, later.linear }, { "measured", "klu" })
  check.equal({ later.memory_of.factors, later.memory_of.tangent + later.memory_of.bodies },
    { model:solver().factor_memory, model:solver().memory })
  check.equal({ later.unknowns, #later.advice }, { cost.unknowns, #cost.advice })
  if not (later.memory_of.contacts > cost.memory_of.contacts) then error "points that touch have groups" end
  if not (later.nonzeros > cost.nonzeros) then error "contact adds to the tangent" end
  local ratio = cost.memory_of.factors / later.memory_of.factors
  if ratio < 0.6 or ratio > 1.1 then error(("counted %g of the measured factors"):format(ratio)) end
end)

check.case("it prints as tables and sentences", function()
  check.holds(ironing("N2"):cost(), "body  unknowns  bulk  contact faces  prescribed  elements  Gauss points",
    "die         42", "all        102", "interface      54  body", "nonzeros in the tangent", "factors (klu, counted)",
    "its own mirror image in x = 1.5: one half of it, with x fixed on that plane, would need 54 unknowns, 48 fewer")
  local lone = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1, corner = { 1, 0 } }, elements = { 2, 2 },
                        order = "N2", material = soft }
  check.holds(sg.model{ bodies = { lone = lone }, supports = { left = { on = lone:face "west", fix = "xy" },
    below = { on = lone:face "south", fix = "y" } } }:cost(), "Nothing to save in sight.")
  check.fails(function() ironing("N2").cost() end, "must be called on a model", "cost_test.lua:")
end)

-- ── A stiff body as an obstacle ──────────────────────────────────────────────────────────────────────────────────────

local function rigid_ironing(label)
  local slab = sg.body{ patch = sg.shapes.rectangle{ width = 3, height = 1 }, elements = { 8, 3 }, order = label,
                        contact = "north", through = 1, material = soft }
  local die = sg.rigid.surface(sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, centre = { 1.5, 1.5 } }:face "south")
  return sg.model{
    bodies = { slab = slab },
    supports = { bed = { on = slab:face "south", fix = "xy" }, grip = { on = die, drive = "y", fix = "x" } },
    contacts = { interface = { slave = slab:face "north", master = die, penalty = 100,
                               friction = { mu = 0.2, penalty = 100 } } },
  }
end

check.case("a stiff die as a rigid one saves what was promised, and presses as hard", function()
  for _, label in ipairs { "N2", "N2-N4" } do
    check.holds(promises(ironing(label), "rigid", rigid_ironing(label)), "Body 'die' is 1000 times as stiff as 'slab'")
  end
  local forces = {}
  for i, model in ipairs { ironing "N2-N4", rigid_ironing "N2-N4" } do
    check.equal(model:run({ { steps = 10, grip = { -0.2 } } }).failed, false)
    forces[i] = model:reaction "grip"[2]
  end
  if math.abs(forces[2] / forces[1] - 1) > 0.02 then error(("forces %g and %g"):format(forces[1], forces[2])) end
end)

check.case("no obstacle where the body deforms, turns, or is moved by more than one support", function()
  none(ironing("N2", { material = sg.neo_hookean{ E = 99, nu = 0.3 } }), "rigid")
  check.equal(#advice(ironing("N2", { material = sg.neo_hookean{ E = 100, nu = 0.3 } }), "rigid"), 1)
  none(ironing("N2", { support = function(die) return { on = die:face "north", pressure = 0.1 } end }), "rigid")
  local block = sg.shapes.rectangle{ width = 1, height = 1, corner = { 1, 1 } }
  local function pressed(supports)
    local top = sg.body{ patch = block, elements = { 2, 2 }, order = "N2", contact = "south",
                         through = 1, material = stiff }
    local slab = sg.body{ patch = sg.shapes.rectangle{ width = 3, height = 1 }, elements = { 6, 2 }, order = "N2",
                          contact = "north", through = 1, material = soft }
    local list = supports(top)
    list.bed = { on = slab:face "south", fix = "xy" }
    return sg.model{ bodies = { top = top, slab = slab }, supports = list,
      contacts = { c = { slave = slab:face "north", master = top:face "south", penalty = 10 } } }
  end
  check.equal(#advice(pressed(function(top) return { g = { on = top:face "north", drive = "xy" } } end), "rigid"), 1)
  none(pressed(function(top) return { g = { on = top:face "north", drive = "xy", rotate = true } } end), "rigid")
  none(pressed(function(top) return { g = { on = top:face "north", drive = "y" } } end), "rigid")
  none(pressed(function(top)
    return { g = { on = top:corner "north-west", drive = "xy" }, h = { on = top:corner "north-east", drive = "xy" } }
  end), "rigid")
end)

-- ── Labels, points ───────────────────────────────────────────────────────────────────────────────────────────────────

local function slab_alone(label, change)
  local slab = sg.body{ patch = change and change.patch or sg.shapes.rectangle{ width = 3, height = 1 },
                        elements = { 8, 3 }, order = label, contact = "north", through = 1, material = soft }
  return sg.model{ bodies = { slab = slab }, supports = { side = { on = slab:face "west", fix = "xy" } },
    contacts = { c = { slave = slab:face(change and change.face or "north"), points = change and change.points,
      where = change and change.where,
      master = sg.rigid.plane{ point = { 0, 9 }, normal = { 0, -1 } }, penalty = 1 } } }
end

check.case("a high degree on the contact face alone needs what was promised", function()
  for label, layered in pairs { N3 = "N2-N3", N4 = "N2-N4", ["N2.2"] = "N2-N2.2", ["N3.1"] = "N2-N3.1" } do
    check.holds(promises(slab_alone(label), "layer", slab_alone(layered)), ('order = "%s"'):format(layered))
  end
  local model, layered = ironing "N4", ironing "N2-N4"
  check.equal(#advice(model, "layer"), 2)
  local all = advice(model, "layer")
  check.equal(all[1].saves + all[2].saves, model:cost().unknowns - layered:cost().unknowns)
  for i, entry in ipairs(advice(punch("N4", 1, 1), "layer")) do
    local name = entry.text:match "Body '(%w+)'"
    check.equal({ i <= 2, entry.saves }, { true, punch("N4", 1, 1):cost().bodies[name].unknowns
      - punch("N2-N4", 1, 1):cost().bodies[name].unknowns })
  end
end)

check.case("advice names the degree in the thickness direction where the label alone would change it", function()
  local function slab(label, through)
    local body = sg.body{ patch = sg.shapes.rectangle{ width = 3, height = 1 }, elements = { 8, 3 }, order = label,
                          contact = "north", through = through, material = soft }
    return sg.model{ bodies = { slab = body }, supports = { side = { on = body:face "west", fix = "xy" } },
      contacts = { c = { slave = body:face "north", penalty = 1,
                         master = sg.rigid.plane{ point = { 0, 9 }, normal = { 0, -1 } } } } }
  end
  for _, through in ipairs { 1, 3, 4 } do
    check.holds(promises(slab("N4", through), "layer", slab("N2-N4", through)),
      ('order = "N2-N4", through = %d'):format(through))
  end
  check.equal(promises(slab("N4", 2), "layer", slab "N2-N4"):find "through", nil)
end)

check.case("a face that turns shares its unknowns in both", function()
  local function strip(label)
    local body = sg.body{ patch = sg.shapes.rectangle{ width = 4, height = 1 }, elements = { 4, 2 }, order = label,
                          contact = "south", through = 1, material = soft }
    return sg.model{ bodies = { strip = body },
      supports = { turn = { on = body:face "east", rotate = true }, wall = { on = body:face "west", fix = "xy" } },
      contacts = { c = { slave = body:face "south", penalty = 1,
                         master = sg.rigid.plane{ point = { 0, 0 }, normal = { 0, 1 } } } } }
  end
  promises(strip "N4", "layer", strip "N2-N4")
end)

check.case("labels of their own per direction", function()
  local function block(order)
    local body = sg.body{ patch = sg.shapes.block{ size = { 1, 1, 1 } }, elements = { 3, 4, 2 }, order = order,
                          contact = "back", through = 1, material = soft }
    return sg.model{ bodies = { block = body }, supports = { bed = { on = body:face "front", fix = "xyz" } },
      contacts = { c = { slave = body:face "back", penalty = 1,
                         master = sg.rigid.plane{ point = { 0, 0, 2 }, normal = { 0, 0, -1 } } } } }
  end
  check.holds(promises(block{ "N4", "N2" }, "layer", block{ "N2-N4", "N2" }), 'order = {"N2-N4", "N2"}')
end)

check.case("no lower degree where N2 does not hold the shape, where there is a layer, or classical elements", function()
  for _, label in ipairs { "N2", "N2-N4", "N1.2", "L4" } do none(slab_alone(label), "layer") end
  local cubic = sg.nurbs.curve{ degree = 3, knots = { 0, 0, 0, 0, 1, 1, 1, 1 },
                                points = { { 0, 1 }, { 1, 1.2 }, { 2, 0.7 }, { 3, 1 } } }
  local curved = sg.nurbs.ruled{ a = sg.nurbs.line{ from = { 0, 0 }, to = { 3, 0 } }, b = cubic }
  none(slab_alone("N4", { patch = curved }), "layer")
end)

check.case("a layer that touches nothing", function()
  none(slab_alone "N2-N4", "idle layer")
  promises(slab_alone("N2-N4", { face = "south" }), "idle layer", slab_alone("N2", { face = "south" }))
  promises(slab_alone("N2-N4x2", { face = "south" }), "idle layer", slab_alone("N2", { face = "south" }))
end)

check.case("many more contact points than the degree asks for", function()
  local text = advice(slab_alone("N2", { points = 19 }), "points")[1].text
  check.holds(text, "points = 19", ("those would be %d contact points in place of %d"):format(
    slab_alone("N2"):cost().contacts.c.points, slab_alone("N2", { points = 19 }):cost().contacts.c.points))
  none(slab_alone("N2", { points = 18 }), "points")
  none(slab_alone("N2", { points = 19, where = function(X) return X[1] < 1 end }), "points")
end)

-- ── What else there is ───────────────────────────────────────────────────────────────────────────────────────────────

check.case("linear bodies, adhesion, and a body that is held everywhere", function()
  local function strip(contact, law)
    local body = sg.body{ patch = sg.shapes.rectangle{ width = 4, height = 1, corner = { 0, 1 } }, elements = { 8, 2 },
                          order = "N2", contact = "south", through = 1,
                          material = sg.linear_elastic{ E = 1, nu = 0.3 } }
    law.slave, law.master = body:face "south", sg.rigid.plane{ point = { 0, 0 }, normal = { 0, 1 } }
    return sg.model{ bodies = { strip = body }, supports = { top = { on = body:face "north", drive = "xy" } },
                     contacts = contact and { c = law } or nil }
  end
  check.equal(strip(true, { penalty = 1 }):cost().linear, "condensed")
  check.equal(strip(true, { adhesion = { hamaker = 0.1, r0 = 0.4 } }):cost().contacts.c.points, 8 * 9)
  local held = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = { 1, 1 }, order = "N1",
                        material = soft }
  local cost = sg.model{ bodies = { held = held }, supports = {
    all = { on = { held:face "south", held:face "north" }, fix = "xy" } } }:cost()
  check.equal({ cost.unknowns, cost.nonzeros, cost.memory_of.factors, #cost.advice }, { 0, 0, 0, 0 })
end)

check.case("a model from a file costs what the saved one does", function()
  local model, file = ironing("N4", { where = function(X) return X[1] < 1.6 end }), os.tmpname()
  model:save(file)
  check.equal(tostring(sg.load(file):cost()), tostring(model:cost()))
  os.remove(file)
end)

check.case("17,952 unknowns in space are looked through", function()
  local slab = sg.body{ patch = sg.shapes.block{ size = { 4, 4, 2 } }, elements = { 16, 16, 16 }, order = "N2",
                        contact = "back", through = 1, material = soft }
  local top = sg.body{ patch = sg.shapes.block{ size = { 2, 2, 2 }, corner = { 1, 1, 2 } }, elements = { 8, 8, 8 },
                       order = "N2", contact = "front", through = 1, material = stiff }
  local model = sg.model{ bodies = { slab = slab, top = top },
    supports = { bed = { on = slab:face "front", fix = "xyz" },
      grip = { on = top:face "back", drive = "z", fix = "xy" } },
    contacts = { c = { slave = top:face "front", master = slab:face "back", penalty = 100 } } }
  local cost = model:cost()
  check.equal({ cost.unknowns, cost.linear, #cost.advice }, { 17952, "kept", 4 })
end)

check.done()
