-- Cohesive contact: a block pulled off and its snap-back, energy balance, profiles, checkpoints, threads; invalid
-- arguments. debonding_test.lua has closed forms of cracks.

require "check"
local debond = require "debond"
local show = require "signorini.prompt.show"

core.quiet = true

--- Traction of the two laws over the opening.
local function traction(bond, u)
  if bond.law == "bilinear" then
    local first, last = bond.strength / bond.stiffness, 2 * bond.energy / bond.strength
    return math.max(0, math.min(bond.stiffness * u, bond.strength * (last - u) / (last - first)))
  end
  local c = bond.energy / (math.exp(1) * bond.strength)
  return math.exp(1) * bond.strength * u / c * math.exp(-u / c)
end

local smooth = { strength = 2, energy = 0.4 }
local linear = { strength = 2, energy = 0.4, law = "bilinear", stiffness = 300 }

check.case("a block is pulled off along the law; work = stored + contact + debonding", function()
  for _, bond in ipairs { smooth, linear } do
    local model = debond.block(bond)
    check.equal(model:contact_law "glue".bonded, 6)
    local run = check.completed(model:run{ { steps = 160, lid = {0.5} } })
    for i, u in ipairs(run:column "lid.uy") do
      -- The block's stretch T h/E is a part of u.
      local force = run:column "lid.fy"[i] / 2
      check.near(force, traction(bond, u - force * 4 / 1000), 1e-7)
    end
    local e, whole = model:energy(), 2 * bond.energy
    check.within("balance", e.work - e.stored - e.contact - e.debonding, 0, 1e-3 * whole)
    check.near(model:contact_resultant "glue".debonded, e.debonding / bond.energy, 1e-12)
    if bond == linear then check.near({ e.debonding, e.contact }, { whole, 0 }, 1e-12) end
  end
end)

check.case("bonds that break within one step: the warning names them and the increments that resolve them", function()
  local function warnings(steps)
    return table.concat(debond.block(smooth):run{ { steps = steps, lid = {0.5} } }.warnings, " ")
  end
  check.holds(warnings(2), "the energy balance is off", "bonds of contact 'glue' break within one step",
    "open by at most 0.067")
  check.equal(warnings(math.ceil(0.5 / 0.067)), "")
end)

check.case("an axisymmetric disc is pulled off along the law", function()
  local model = scenes.model{ kind = "axisymmetric",
    bodies = { disc = { size = {2, 4}, elements = {2, 1}, contact = "south",
        material = sg.linear_elastic{ E = 1000, nu = 0 } } },
    supports = { axis = { on = "west", symmetry = true }, lid = { on = "north", fix = "x", drive = "y" } },
    contacts = { glue = { slave = "south", penalty = 1000, cohesive = smooth, master = scenes.floor() } } }
  local run, area = model:run{ { steps = 20, lid = {0.4} } }, math.pi * 4
  for i, u in ipairs(run:column "lid.uy") do
    local force = run:column "lid.fy"[i] / area
    check.near(force, traction(smooth, u - force * 4 / 1000), 1e-7)
  end
  check.near(model:contact_resultant "glue".debonded, model:energy().debonding / smooth.energy, 1e-12)
end)

--- A film peeled upright, as a plane model or as a solid of width 0.5 in plane strain; forces per width, and balance.
local function peel(dimension)
  local is_solid, patch = dimension == 3, sg.shapes.rectangle{ width = 6, height = 0.1 }
  if is_solid then patch = sg.nurbs.extrude{ patch = patch, along = {0, 0, 0.5} } end
  local film = scenes.body{ patch = patch, elements = is_solid and {30, 1, 1} or {30, 1}, contact = "south",
    thickness_degree = 2, E = 2000 }
  local plane = is_solid and sg.rigid.plane{ point = {0, 0, 0}, normal = {0, 1, 0} }
    or scenes.floor()
  local model = scenes.model{ bodies = { film = film },
    supports = { clamp = { on = "east", fix = "xy" },
      grip = { on = is_solid and film:edge "south-west" or film:corner "south-west", drive = "y" },
      sides = is_solid and { on = { "front", "back" }, fix = "z" } or nil },
    contacts = { glue = { slave = "south", master = plane, penalty = 2000, points = 6,
      cohesive = { strength = 1, energy = 0.1, where = function(X) return X[1] >= 1.5 end } } } }
  local run, forces = model:run{ { steps = 24, grip = 3 } }, {}
  for i, force in ipairs(run:column "grip.fy") do forces[i] = force / (is_solid and 0.5 or 1) end
  local e = model:energy()
  return forces, (e.stored + e.contact + e.debonding) / e.work
end

check.case("a solid film in plane strain peels with the force of the plane model", function()
  local plane, balance = peel(2)
  local solid, solid_balance = peel(3)
  check.near(solid, plane, 1e-8)
  check.near({ balance, solid_balance }, { 1, 1 }, 1e-3)
end)

check.case("arc length follows the snap-back of an elastic block", function()
  -- E/h below the law's slope: u = d + T(d) h/E goes back.
  local model, E, first, last = debond.block(smooth, { E = 20 }), 20, 0, 1
  local run = model:run({ { steps = 40, lid = {0.9} } }, { arc_length = true })
  check.equal({ run.failed, #run.controls }, { false, 2 })
  local u, force = run:column "lid.uy", run:column "lid.fy"
  for i = 2, #u do
    if u[i] < u[i - 1] then first, last = math.max(first, u[i - 1]), math.min(last, u[i]) end
    check.near(force[i] / 2, traction(smooth, u[i] - force[i] / 2 * 4 / E), 1e-6)
  end
  assert(first > 0.47 and last < 0.4, "the path has not gone back")
  local e = model:energy()
  check.near(e.debonding, 0.8, 1e-3)
  check.within("balance", e.work - e.stored - e.contact - e.debonding, 0, 0.02 * e.work)
end)

check.case("arc length follows a strip that peels element by element, past its snap-back", function()
  local model = scenes.model{
    bodies = {
      strip = { size = {100, 5}, elements = {40, 2}, contact = "south", thickness_degree = 1, E = 2, nu = 0.2 } },
    supports = { edge = { on = "east", rotate = true }, pin = { on = "south-west", fix = "x" } },
    contacts = { film = { slave = "south", penalty = 20, cohesive = { strength = 0.16, energy = 0.05 },
        master = scenes.floor() } } }
  local run, back = model:run({ { steps = 118, edge = 118 } }, { arc_length = true }), 0
  check.equal({ run.failed, run.reason }, { false, "completed" })
  local angle = run:column "edge.angle"
  for i = 2, #angle do back = math.max(back, angle[i - 1] - angle[i]) end
  assert(back > 1, "the path has not gone back")
  local e = model:energy()
  check.within_share("balance", e.stored + e.contact + e.debonding, e.work, 0.01)
  assert(model:contact_resultant "film".debonded > 20)
end)

check.case("without arc length the failed step names the bonds and arc length", function()
  local run = debond.block(linear, { E = 20 }):run({ { steps = 40, lid = {0.9} } }, sg.plain{})
  check.equal(run.failed, true)
  check.holds(run.failure, "6 bonds of contact 'glue' carried more than half of the strength", "arc_length = true")
end)

check.case("profile: damage, tension and state along the crack", function()
  local model = debond.cantilevers(24, 24, { strength = 20 })
  model:run{ { steps = 8, up = {-1.6}, down = {1.6} } }
  local profile, greatest = model:profile "glue", 0
  for i, X in ipairs(profile.X) do
    if X < 8 then check.equal({ profile.damage[i], profile.state[i] }, { 1, "open" }) end
    if X > 20 then check.at_most("damage", profile.damage[i], 0.1) end
    greatest = math.max(greatest, -profile.pressure[i])
  end
  check.within_share("strength", greatest, 20, 0.03)
  check.holds(show.text(model), "debonded", "law = \"exponential\"", "strength = 20", "144 bonded points")
end)

check.case("damage in samples, pictures and .vtu files", function()
  local model, folder = debond.cantilevers(24, 24, { strength = 20 }), check.folder()
  model:run{ { steps = 4, up = {-1.4}, down = {1.4} } }
  local profile = model:profile "glue"
  check.equal(model:sample("upper", "damage", { 0, 0 }), 1)
  -- Between the two points in the middle of an element, of nine
  check.within("sample", model:sample("upper", "damage", { 10.5 / 24, 0 }), profile.damage[9 * 10 + 5], 1e-12)
  for _, values in ipairs { { "band", field = "damage" }, { "face", field = "contact_pressure" } } do
    sg.picture{ model = model, field = values.field, file = ("%s/%s.png"):format(folder, values[1]) }
  end
  check.pictures(folder, { "band", "face" })
  sg.vtu{ model = model, file = folder .. "/state.vtu" }
  check.holds(core.read_file(folder .. "/state.vtu"), 'Name="damage"', 'Name="contact_pressure"')
  check.fails(function() model:sample("lower", "damage", { 0.5, 1 }) end, "damage is defined on slave faces only",
    "this body has none")
  local plain = scenes.model{ bodies = { block = { elements = {1, 1}, contact = "south" } },
    contacts = { touch = { slave = "south", penalty = 1, master = scenes.floor() } } }
  check.fails(function() sg.picture{ model = plain, field = "damage", file = folder .. "/none.png" } end,
    "field 'damage' needs a cohesive contact, and the model has none")
end)

check.case("a checkpoint amid debonding continues bitwise", function()
  local model = debond.cantilevers(16, 16, { strength = 20 })
  local file = check.file "state.sig"
  model:run{ { steps = 6, up = {-1.2}, down = {1.2} } }
  model:save(file)
  local other = sg.load(file)
  local rest = { { steps = 2, up = {-0.9}, down = {0.9} }, { steps = 2, up = {-1.4}, down = {1.4} } }
  model:run(rest)
  other:run(rest)
  check.equal(other:reaction "up".moment, model:reaction "up".moment)
  check.equal(other:energy().debonding, model:energy().debonding)
  check.equal(other:profile "glue".damage, model:profile "glue".damage)
  check.equal(other:contact_law "glue".bonded, model:contact_law "glue".bonded)
end)

check.case("one and two threads give the same bits", function()
  local code = [[
local sg = require "signorini"
local patch = sg.nurbs.extrude{ patch = sg.shapes.rectangle{ width = 4, height = 1 }, along = {0, 0, 1} }
local body = sg.body{ patch = patch, elements = {6, 1, 2}, order = "N2", contact = "south",
                      material = sg.neo_hookean{ E = 100, nu = 0.3 } }
local model = sg.model{ bodies = { film = body },
  supports = { grip = { on = body:face "west", fix = "xz", drive = "y" } },
  contacts = { glue = { slave = body:face "south", penalty = 500, cohesive = { strength = 3, energy = 0.5 },
                        master = sg.rigid.plane{ point = {0, 0, 0}, normal = {0, 1, 0} } } } }
model:run{ { steps = 4, grip = {0.4} } }
print(("%a %a"):format(model:reaction "grip".fy, model:energy().debonding))]]
  local one, status = check.program{ "-q", "--threads", "1", "-e", code }
  check.equal(status, 0)
  check.equal((check.program{ "-q", "--threads", "2", "-e", code }), one)
  assert(one:match "%-?0x%x" and not one:match "0x0p", one)
end)

-- Each ends with status 1 and a message that names the script's line, the argument, the value and the hint.
local start = [[
local sg = require "signorini"
local s = sg.body{ patch = sg.shapes.rectangle{ width = 20, height = 4 }, elements = {10, 2}, order = "N2",
                   contact = "south", material = sg.neo_hookean{ E = 2, nu = 0.2 } }
local plane = sg.rigid.plane{ point = {0, 0}, normal = {0, 1} }
local function with(bond, more)
  local contact = { slave = s:face "south", master = plane, penalty = 10, cohesive = bond }
  for key, value in pairs(more or {}) do contact[key] = value end
  return sg.model{ bodies = { s = s }, contacts = { f = contact } }
end
local bond = { strength = 0.1, energy = 0.2 }
]]
check.refusals(start, "study.lua:", {
  { "with{ strength = 1, energy = 1, law = 'linear' }", "contacts.f.cohesive.law must be",
    "'exponential' or 'bilinear'", "'linear'" },
  { "with{ strength = 1, energy = 1, stiffness = 100 }",
    "contacts.f.cohesive: it has stiffness and law = \"exponential\"", "law = \"bilinear\"" },
  { "with{ strength = 1, energy = 0.01, law = 'bilinear' }",
    "cohesive.stiffness must be above strength^2 / (2 energy) = 50, got 10", "raise stiffness" },
  { "with(bond, { penalty = false, adhesion = { hamaker = 1, r0 = 1 } })", "contacts.f" },
  { "with(bond, { method = 'mortar' })", "it has both cohesive and method = \"mortar\"", "write method = \"gpts\"" },
  { "with(bond, { method = 'half_passes' })", "it has both cohesive and method = \"half_passes\"" },
  { "with(bond, { enforcement = 'multipliers' })", "cohesive and enforcement = \"multipliers\"",
    "write enforcement = \"penalty\"" },
  { "with(bond, { per = 'current' })", "it has both cohesive and per = \"current\"" },
  { "with(bond, { active = false })", "it has both cohesive and active = false", "cohesive.where" },
  { "with(bond, { offset = 0.1 })", "it has both cohesive and offset" },
  { "with(bond, { overlap = 'interference' })", "overlap = \"interference\"" },
  { "with(bond, { penalty = false })", "contacts.f.penalty" },
  { "with(bond, { master = sg.rigid.plane{ point = {0, -0.5}, normal = {0, 1} } })", "no contact point is bonded",
    "the nearest one is 0.5 from the master", "coincide in the reference shape" },
  { "with{ strength = 1, energy = 1, where = function(X) return false end }",
    "cohesive.where must return true for some contact points" },
  { "with{ strength = 1, energy = 1, where = function(X) return X[1] end }",
    "contacts.f.cohesive.where must return true or false", "got the number" },
  { "with(bond):run{ { steps = 1, contacts = { f = { active = false } } } }",
    "contacts.f is cohesive, of which a load path can change penalty and friction alone", "remove active and offset" },
  { "with(bond):run{ { steps = 1, contacts = { f = { offset = 0.1 } } } }", "contacts.f is cohesive" },
  { "with(bond):run{ { steps = 1, contacts = { f = { friction = { mu = 0.1 } } } } }",
    "has no friction or wear in sg.model" },
})

check.case("bonded bodies with friction turn rigidly without energy", function()
  for _, steps in ipairs { 1, 4 } do
    local function block(y, n)
      return scenes.body{ size = {2, 1}, corner = { 0, y }, elements = { n, 2 }, contact = y < 0 and "north" or "south",
        E = 20 }
    end
    local upper, lower = block(0, 8), block(-1, 6)
    local model = scenes.model{ bodies = { upper = upper, lower = lower },
      supports = { s = { on = "lower.south", drive = "xy", rotate = true } },
      contacts = { g = { slave = "upper.south", master = "lower.north", penalty = 200,
                         friction = { mu = 0.3, penalty = 100 }, cohesive = { strength = 1, energy = 0.2 } } } }
    check.completed(model:run{ { steps = steps, s = { 0, 0, 90 } } })
    local e = model:energy()
    check.near({ e.stored, e.contact, e.friction, e.debonding }, { 0, 0, 0, 0 }, 1e-9)
  end
end)

check.case("a turned tool breaks its bonds and rubs: disc and level set agree, and work balances", function()
  local function turned(tool)
    local ring = scenes.body{ patch = sg.shapes.half_annulus{ inner = 1, outer = 2 }, elements = { 16, 3 },
      contact = "north", E = 20 }
    local model = scenes.model{ bodies = { ring = ring },
      supports = { tool = { on = tool, fix = "xy", rotate = true, center = { 0, 0 } },
                   outer = { on = "south", fix = "xy" } },
      contacts = { g = { slave = "north", master = tool, penalty = 200,
                         friction = { mu = 0.3, penalty = 100 }, cohesive = { strength = 1, energy = 0.2 } } } }
    check.completed(model:run{ { steps = 40, tool = { 20 } }, { steps = 20, tool = { 60 } } })
    return model:energy()
  end
  local disc = turned(sg.rigid.cylinder{ center = { 0, 0 }, radius = 1 })
  local set = turned(sg.rigid.level_set{ f = function(x, y) return x ^ 2 + y ^ 2 - 1 end,
                                         box = { { -1.1, -1.1 }, { 1.1, 1.1 } } })
  for _, name in ipairs { "work", "friction", "debonding" } do check.within_share(name, set[name], disc[name], 1e-3) end
  assert(disc.friction >= 0)
  local kept = disc.stored + disc.contact + disc.friction + disc.debonding
  check.within_share("balance", kept, disc.work, 5e-3)
end)

check.case("points that are slightly too far away for a bond are a warning", function()
  check.ended({ check.script(start
    .. "with(bond, { master = sg.rigid.plane{ point = {0, 0}, normal = {1e-3, 1} } })") }, 0,
    "contacts.f: 86 points of the slave face, up to 0.0199",
    "from the master, are not bonded", "let the faces coincide there")
end)

check.case("coarse elements are a warning with the cure", function()
  check.ended({ check.script(start .. "with{ strength = 1, energy = 0.1 }") }, 0,
    "contacts.f: the elements of the slave face, 2 long, are coarse for the zone in which bonds open",
    "refine the slave face, or lower strength at the same energy")
end)
