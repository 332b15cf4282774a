-- model:cost: its numbers against those of bodies, contacts and solver.

require "check"

local soft, stiff = sg.neo_hookean{ E = 1, nu = 0.3 }, sg.neo_hookean{ E = 1000, nu = 0.3 }

--- A die on a slab; contact where `where` says.
local function ironing(order, where)
  return scenes.model{
    bodies = { die = { patch = sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = { 1.5, 1.5 } },
        elements = { 6, 2 }, order = order, contact = "south", thickness_degree = 1, material = stiff },
      slab = { size = {3, 1}, elements = { 8, 3 }, order = order, contact = "north", thickness_degree = 1,
        material = soft } }, supports = { bed = { on = "slab.south", fix = "xy" },
      grip = { on = { "die.west", "die.east" }, drive = "y", fix = "x" } },
    contacts = { interface = { slave = "die.south", master = "slab.north", penalty = 100, where = where,
        friction = { mu = 0.2, penalty = 100 } } } }
end

check.case("the numbers are those of bodies, contacts and solver, before a solve and after it", function()
  local model = ironing "N2-N4"
  local cost = model:cost()
  -- N2 on 8 elements along the slab: 10 functions, N4 on its face: 12; through it 4 rows, the lowest fixed. The die's
  -- arc has a knot of its own in the middle, C0: one function more; two more are fixed at the ends of each row.
  check.equal({ cost.bodies.slab.unknowns, cost.bodies.slab.interface, cost.bodies.slab.bulk,
                cost.bodies.slab.prescribed }, { 2 * 32, 2 * 12, 2 * 20, 2 * 10 })
  check.equal({ cost.bodies.slab.elements, cost.bodies.slab.gauss_points }, { 24, 16 * 3 * 2 + 8 * 5 * 2 })
  local die = cost.bodies.die
  check.equal(die.unknowns + die.prescribed, model:body "die":dofs().total)
  check.equal(die.interface, model:body "die":dofs().interface - 4)
  check.equal({ cost.unknowns, cost.obstacles }, { die.unknowns + 64, 0 })
  check.equal(cost.unknowns, #model:unknowns())
  check.equal({ cost.contacts.interface.points, cost.contacts.interface.rigid }, { 6 * 15, false })
  check.equal(cost.nonzeros, #model:tangent().values)
  check.equal({ cost.factors_are, cost.linear }, { "counted", "klu" })
  check.equal(cost.memory, cost.memory_of.bodies + cost.memory_of.contacts + cost.memory_of.tangent
    + cost.memory_of.factors)

  check.completed(model:run({ { steps = 2, grip = { -0.05 } } }))
  local later = model:cost()
  check.equal({ later.factors_are, later.linear }, { "measured", "klu" })
  check.equal({ later.memory_of.factors, later.memory_of.tangent + later.memory_of.bodies },
    { model:solver().factor_memory, model:solver().memory })
  check.equal(later.unknowns, cost.unknowns)
  if not (later.memory_of.contacts > cost.memory_of.contacts) then error "points that touch have groups" end
  if not (later.nonzeros > cost.nonzeros) then error "contact adds to the tangent" end
  local ratio = cost.memory_of.factors / later.memory_of.factors
  if ratio < 0.6 or ratio > 1.1 then error(("counted %g of the measured factors"):format(ratio)) end
end)

check.case("it prints as tables and a line", function()
  check.holds(ironing("N2"):cost(), "body  unknowns  bulk  contact faces  prescribed  elements  Gauss points",
    "die         42", "all        102", "interface      54  body", "nonzeros in the tangent", "factors (klu, counted)")
  check.fails(function() ironing("N2").cost() end, "must be called on a model", "cost_test.lua:")
end)

check.case("obstacles have no unknowns, and shared ones count once", function()
  local cost = scenes.model{
    bodies = {
      strip = { size = {4, 1}, elements = { 4, 2 }, contact = "south", thickness_degree = 1, material = soft } },
    supports = { turn = { on = "east", rotate = true }, wall = { on = "west", fix = "xy" } },
    contacts = { bed = { slave = "south", penalty = 1, master = scenes.floor() } } }:cost()
  check.equal(cost.unknowns, 2 * 4 * 3 + 2) -- two shared by the face that turns
  check.equal({ cost.contacts.bed.rigid, cost.obstacles }, { true, 1 })
  check.holds(cost, "rigid obstacle, no unknowns")
end)

check.case("linear bodies, adhesion, and a body whose DOFs are all prescribed", function()
  local function strip(contact, law)
    local body = scenes.body{ size = {4, 1}, corner = { 0, 1 }, elements = { 8, 2 }, contact = "south",
      thickness_degree = 1, material = sg.linear_elastic{ E = 1, nu = 0.3 } }
    law.slave, law.master = body:face "south", scenes.floor()
    return scenes.model{ bodies = { strip = body }, supports = { top = { on = "north", drive = "xy" } },
                     contacts = contact and { c = law } or nil }
  end
  check.equal(strip(true, { penalty = 1 }):cost().linear, "condensed")
  check.equal(strip(true, { adhesion = { hamaker = 0.1, r0 = 0.4 } }):cost().contacts.c.points, 8 * 9)
  local cost = scenes.model{ bodies = { fixed = { elements = { 1, 1 }, order = "N1", material = soft } },
    supports = { all = { on = { "south", "north" }, fix = "xy" } } }:cost()
  check.equal({ cost.unknowns, cost.nonzeros, cost.memory_of.factors }, { 0, 0, 0 })
end)

check.case("a loaded model has the cost of the saved one", function()
  local model = ironing("N4", function(X) return X[1] < 1.6 end)
  check.equal(tostring(check.reloaded(model):cost()), tostring(model:cost()))
end)

check.case("17,952 unknowns in 3D are counted", function()
  local model = scenes.model{
    bodies = {
      slab = { size = { 4, 4, 2 }, elements = { 16, 16, 16 }, contact = "back", thickness_degree = 1, material = soft },
      top = { size = { 2, 2, 2 }, corner = { 1, 1, 2 }, elements = { 8, 8, 8 }, contact = "front", thickness_degree = 1,
        material = stiff } },
    supports = { bed = { on = "slab.front", fix = "xyz" }, grip = { on = "top.back", drive = "z", fix = "xy" } },
    contacts = { c = { slave = "top.front", master = "slab.back", penalty = 100 } } }
  local cost = model:cost()
  check.equal({ cost.unknowns, cost.linear }, { 17952, "reuse" })
end)
