-- Bonds by formula: the built-in law written as one, mode mix, results, checkpoints, invalid arguments. Faces and
-- tangents are in tests/contact/cohesion_formula_test.cpp, beams in scripts/objects/mixed_mode_bending.lua.

require "check"
local debond = require "debond"
local show = require "signorini.prompt.show"

core.quiet = true

local strength, energy = 2, 0.4
local stiffness = math.exp(2) * strength ^ 2 / energy
local function exponential(u) return stiffness * u * sg.exp(-math.exp(1) * strength / energy * u) end
local function mixed(m) return 0.4 + 0.5 * m ^ 2 end

check.case("a block pulled off by a formula is that pulled off by the law", function()
  local results = {}
  for i, bond in ipairs { { strength = strength, energy = energy }, { traction = exponential } } do
    local model = debond.block(bond)
    local run = check.completed(model:run{ { steps = 30, lid = {0.6} }, { steps = 5, lid = {0.3} },
                                           { steps = 20, lid = {1.2} } })
    local e = model:energy()
    results[i] = { force = run:column "lid.fy", energies = { e.stored, e.contact, e.work, e.debonding },
                   debonded = model:contact_resultant "glue".debonded, damage = model:profile "glue".damage }
  end
  for _, key in ipairs { "force", "energies", "damage" } do check.near(results[2][key], results[1][key], 1e-10) end
  check.within("debonded", results[2].debonded, results[1].debonded, 1e-10)
end)

check.case("a block sheared and pulled off takes the energy of its mode mix", function()
  for _, law in ipairs { "exponential", "bilinear" } do
    for _, way in ipairs { { 1, 0 }, { 0, 1 }, { 0.6, 0.8 } } do
      local body = sg.body{ patch = sg.shapes.rectangle{ width = 2, height = 4 }, elements = {1, 1}, order = "N1",
                            contact = "south", material = sg.linear_elastic{ E = 1e6, nu = 0 } }
      local model = sg.model{ bodies = { block = body },
        supports = { lid = { on = { body:face "north", body:face "west", body:face "east" }, drive = "xy" } },
        contacts = { glue = { slave = body:face "south", penalty = 1000,
          master = sg.rigid.plane{ point = {0, 0}, normal = {0, 1} },
          cohesive = { strength = strength, energy = mixed, law = law,
                       stiffness = law == "bilinear" and 300 or nil } } } }
      check.completed(model:run{ { steps = 400, lid = { 2.5 * way[1], 2.5 * way[2] } } }, sg.plain{})
      local G, e = mixed(way[1] ^ 2), model:energy()
      check.within("dissipated", e.debonding / (2 * G), 1, 1e-4)
      check.within("work", e.work / (2 * G), 1, 2e-3)
      check.within("area", model:contact_resultant "glue".debonded, 2, 1e-4)
      for _, m in ipairs(model:profile "glue".mix) do check.within("mix", m, way[1] ^ 2, 1e-6) end
    end
  end
end)

local function beams(bond) return debond.cantilevers(24, 24, bond) end

check.case("beams that open have no shear, and the energy of m = 0", function()
  local model = beams{ strength = 20, energy = function(m) return 0.3 + 0.6 * m ^ 2 end }
  local plain = beams{ strength = 20 }
  for _, one in ipairs { model, plain } do one:run{ { steps = 8, up = {-1.6}, down = {1.6} } } end
  check.within_share("moment", model:reaction "up".moment, plain:reaction "up".moment, 1e-3)
  local law, profile = model:contact_law "glue", model:profile "glue"
  check.within("strength", law.strength, 20, 1e-6)
  check.within("energies", law.shear_energy / law.energy, 3, 1e-9)
  check.within("shear strength", law.shear_strength, 20 * math.sqrt(3), 1e-6)
  check.equal(law.law, nil)
  for i, X in ipairs(profile.X) do if X > 8 and X < 10 then check.at_most("mix", profile.mix[i], 0.02) end end
  check.holds(show.text(model), "traction = ", "energy = 0.3", "144 bonded points")
end)

check.case("a checkpoint amid debonding continues bitwise", function()
  local model = beams{ strength = 20, energy = function(m) return 0.3 + 0.6 * m ^ 2 end, shear = 1.5 }
  local file = check.file "state.sig"
  model:run{ { steps = 6, up = {-1.2}, down = {0.6} } }
  model:save(file)
  local other = sg.load(file)
  local rest = { { steps = 2, up = {-0.9}, down = {0.5} }, { steps = 2, up = {-1.4}, down = {0.7} } }
  for _, one in ipairs { model, other } do one:run(rest) end
  check.equal(other:energy().debonding, model:energy().debonding)
  for _, field in ipairs { "damage", "mix" } do
    check.equal(other:profile "glue"[field], model:profile "glue"[field])
  end
  check.equal(other:contact_law "glue".traction, model:contact_law "glue".traction)
  check.equal(other:contact_resultant "glue".debonded, model:contact_resultant "glue".debonded)
end)

-- Each ends with status 1 and a message that names the script's line, the argument, the value and the hint.
local start = [[
local sg = require "signorini"
local s = sg.body{ patch = sg.shapes.rectangle{ width = 20, height = 4 }, elements = {20, 2}, order = "N2",
                   contact = "south", material = sg.neo_hookean{ E = 2, nu = 0.2 } }
local function with(bond)
  return sg.model{ bodies = { s = s }, contacts = { f = { slave = s:face "south", penalty = 10, cohesive = bond,
                   master = sg.rigid.plane{ point = {0, 0}, normal = {0, 1} } } } }
end
local function G(m) return 0.2 + 0.4 * m ^ 2 end
]]
check.refusals(start, "study.lua:", {
  { "with{ energy = 1 }", "contacts.f.cohesive: it has energy without strength: give both" },
  { "with{}", "contacts.f.cohesive: it needs strength and energy, or traction as a formula" },
  { "with{ traction = 1 }", "contacts.f.cohesive.traction must be a function", "write a formula, as in function(u)" },
  { "with{ strength = 0.1, energy = 'a' }", "contacts.f.cohesive.energy must be", "as in function(m)" },
  { "with{ strength = 0.1, energy = G, law = 'bilinear' }", "without stiffness" },
  { "with{ strength = G, energy = G }", "a function as strength and law = \"exponential\"" },
  { "with{ strength = 1, energy = 1, shear = 0 }", "contacts.f.cohesive.shear must be a positive number" },
  { "with{ traction = function(u) return u * sg.exp(-u) end, energy = 1 }", "both traction and energy" },
  { "with{ traction = function(u, m, x) return u * sg.exp(-u) end }",
    "contacts.f.cohesive.traction has an unknown parameter 'x'; known: u, m." },
  { "with{ traction = function(u) return u * math.exp(-u) end }", "use sg.exp" },
  { "with{ traction = function(u) return 1 - u end }", "cohesive.traction is 1 at u = 0", "where it must be 0" },
  { "with{ traction = function(u) return 1 + 0 * u end }", "cohesive.traction is 1 at u = 0", "where it must be 0" },
  { "with{ traction = function(u) return -u end }", "contacts.f: the slope of cohesive.traction at u = 0 is -1" },
  { "with{ traction = function(u) return 0.1 * (1 + u) * sg.exp(-u / 2) end }", "is 0.1 at u = 0",
    "where it must be 0" },
  { "with{ traction = function(u) return sg.sqrt(u) * sg.exp(-u) end }", "at u = 0 is inf: it must be finite" },
  { "with{ traction = function(u) return u - 2 * u ^ 2 end }", "it must not be negative", "sg.max(0, …)" },
  { "with{ traction = function(u) return sg.max(0, sg.min(3 * u, 1 - u)) end }", "cohesive.traction / u rises",
    "sg.min(K * u, sg.max(0, …))" },
  { "with{ traction = function(u) return u / (1 + u) end }", "it must fall to 0" },
  { "with{ traction = function(u) return u end }", "it must fall to 0" },
  { "with{ traction = function(u) return 1 + u end }", "is 1 at u = 0", "where it must be 0" },
  { "with{ traction = function(u, m) return (1 + m) * u * sg.exp(-u) end }", "is 1.05 at m = 0.05, but 1 at m = 0",
    "shear = b" },
  { "with{ strength = 0.1, energy = function(m) return 0.2 + m ^ 0.5 end }", "exponents of at least 1" },
  { "with{ strength = 0.1, energy = function(m) return 0.2 - m end }",
    "contacts.f.cohesive.energy must be positive, but is 0 at m = 0.2" },
  { "with{ strength = 2, energy = G, law = 'bilinear', stiffness = 3 }", "must be above strength^2 / (2 energy) = 10",
    "at m = 0, got 3" },
})
