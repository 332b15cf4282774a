-- Van der Waals adhesion and rotating faces: a block pulled off against the law in closed form, the region of the law,
-- its reference area; invalid arguments.

require "check"

local film = { hamaker = 0.1, r0 = 0.4 }
local equilibrium = 15 ^ (-1 / 6) * film.r0

--- T(r) = A/(2π r₀³) [(r₀/r)⁹/45 − (r₀/r)³/3], below r_eq along its tangent (thesis 3.87)
local function traction(r)
  local strength = film.hamaker / (2 * math.pi * film.r0 ^ 3)
  if r >= equilibrium then return strength * ((film.r0 / r) ^ 9 / 45 - (film.r0 / r) ^ 3 / 3) end
  local q = film.r0 / equilibrium
  return strength * (q ^ 3 - q ^ 9 / 5) / equilibrium * (r - equilibrium)
end

local modulus, height = 1e6, 4

--- The gap below the block when its lid has been lifted by u: the face follows less the block's stretch T h/E.
local function gap_below(u)
  local gap = equilibrium + u
  for _ = 1, 10 do gap = equilibrium + u + traction(gap) * height / modulus end
  return gap
end

--- A block of 20 × 4 on a film, supported at its lid.
local function block(options)
  local body = scenes.body{ size = {20, height}, elements = {10, 2}, order = options.order or "N2", contact = "south",
    material = sg.linear_elastic{ E = modulus, nu = 0 } }
  return sg.model{
    bodies   = { block = body },
    supports = options.supports and options.supports(body)
      or { lid = { on = body:face "north", fix = "x", drive = "y" } },
    contacts = { film = { slave = body:face "south", adhesion = film, where = options.where, points = options.points,
                          master = scenes.floor(-equilibrium) } },
  }
end

check.case("a block is pulled off along the law, and pressed in along its tangent", function()
  for _, order in ipairs { "N2", "N2-N2.1" } do
    local model, steps, last = block{ order = order }, 60, 0.9
    local run = check.completed(model:run{ { steps = steps, lid = {last} } })
    for i, u in ipairs(run:column "lid.uy") do
      check.near(run:column "film.fy"[i], 20 * traction(gap_below(u)), 1e-8)
      check.near(run:column "lid.fy"[i], -run:column "film.fy"[i], 1e-8)
    end
    model = block{ order = order }
    run = model:run{ { steps = 2, lid = {-0.02} } }
    check.near(run:column "film.fy", { 20 * traction(gap_below(-0.01)), 20 * traction(gap_below(-0.02)) }, 1e-8)
  end
end)

check.case("faces that overlap although adhesion holds them apart are reported", function()
  local function warnings(lid) return block{}:run{ { steps = 5, lid = {lid} } }.warnings end
  check.equal(warnings(-0.9 * equilibrium), {})
  local depth, apart, penalty = table.concat(warnings(-0.5)):match
    "contacts.film: the faces overlap by (%S+), .- holds them (%S+) apart.- penalty of (%S+),"
  check.within("depth", tonumber(depth), -gap_below(-0.5), 1e-3)
  check.within("apart", tonumber(apart), equilibrium, 1e-3)
  check.within("penalty", tonumber(penalty), -traction(0) / -equilibrium, 1e-2)
end)

check.case("pulling off takes the work of adhesion, 15^(1/3) A/(16 pi r0²) per area", function()
  local model, steps, last = block{}, 400, 4
  local run = model:run{ { steps = steps, lid = {last} } }
  local force, work = run:column "lid.fy", 0
  force[0] = 0
  for i = 2, steps, 2 do work = work + last / steps / 3 * (force[i - 2] + 4 * force[i - 1] + force[i]) end -- Simpson
  -- What is left beyond the last distance r: A/(12π r²) but for the repulsion, which is (r₀/r)⁶/60 of it.
  local r = equilibrium + last
  local rest = film.hamaker / (12 * math.pi * r ^ 2)
  check.near(work / 20 + rest, 15 ^ (1 / 3) * film.hamaker / (16 * math.pi * film.r0 ^ 2), 2e-6)
end)

check.case("the traction is zero at the equilibrium distance", function()
  local model = block{}
  model:run{ { steps = 1 } }
  local sum = model:contact_resultant "film"
  check.near({ sum.fx, sum.fy }, { 0, 0 }, 1e-12)
end)

check.case("where: the law acts on the part of the face that the function names, by reference position", function()
  local seen = { 0, 0 }
  local model = block{ where = function(X)
    check.near(X[2], 0)
    seen = { math.max(seen[1], X[1]), seen[2] + 1 }
    return X[1] <= 12
  end }
  check.equal({ seen[2], seen[1] > 19.9 }, { 10 * 9, true })
  model:run{ { steps = 4, lid = {0.1} } }
  check.near(model:contact_resultant "film".fy, 12 * traction(equilibrium + 0.1), 12 * 1e-5)
  local profile, area = model:profile "film", 0
  check.equal(#profile.X, 6 * 9)
  for i, X in ipairs(profile.X) do
    assert(X < 12)
    area = area + profile.area[i]
    check.near(profile.pressure[i], traction(profile.gap[i]), 1e-8) -- per current area, which a stretch of 1e-8 changes
    check.equal(profile.state[i], profile.gap[i] < 5 ^ (-1 / 6) * film.r0 and "adhesion" or "open")
  end
  check.near(area, 12, 1e-6)
end)

check.case("the traction refers to the reference area at any stretch of the face", function()
  local model = block{ supports = function(body)
    return { lid = { on = body:face "north", drive = "y" },
             left = { on = body:face "west", fix = "x" }, right = { on = body:face "east", drive = "x" } }
  end }
  model:run{ { steps = 1, lid = {0.05}, right = {4} } }
  local profile = model:profile "film"
  check.near(profile.x[#profile.x] / profile.X[#profile.X], 24 / 20, 1e-12)
  check.near(model:contact_resultant "film".fy, 20 * traction(gap_below(0.05)), 1e-8)
end)

-- Each ends with status 1 and a message that names the script's line, the argument, the value and the hint.
local start = [[
local sg = require "signorini"
local s = sg.body{ patch = sg.shapes.rectangle{ width = 20, height = 4 }, elements = {10, 2}, order = "N2",
                   contact = "south", material = sg.neo_hookean{ E = 2, nu = 0.2 } }
local low, edge, film = s:face "south", s:face "east", { hamaker = 0.1, r0 = 0.4 }
local plane = sg.rigid.plane{ point = {0, -0.2547}, normal = {0, 1} }
local function with(contact)
  contact.slave, contact.master = contact.slave or low, contact.master or plane
  return { bodies = { s = s }, contacts = { f = contact } }
end
local function turned(support) return { bodies = { s = s }, supports = { e = support } } end
]]
check.refusals(start, 11, {
  { "sg.model(with{ slave = plane, master = low, adhesion = film })",
    "contacts.f.slave must be a face or a list of adjacent faces, got an obstacle",
    "an obstacle can only be the master: exchange the two" },
  { "sg.model(with{ adhesion = film, penalty = 10 })", "contacts.f: it has both adhesion and penalty",
    "remove one of the two" },
  { [[sg.model(with{ adhesion = film, per = "current" })]], "contacts.f: it has adhesion and per = \"current\"",
    "write per = \"reference\", or omit it" },
  { "sg.model(with{ adhesion = film, friction = { mu = 0.1, penalty = 1 } })",
    "contacts.f: it has both adhesion and friction", "remove one of the two" },
  { "sg.model(with{ adhesion = film, where = 150 })", "contacts.f.where must be a function", "X[1] <= 150 end" },
  { "sg.model(with{ adhesion = film, where = function(X) return X[2] end })",
    "contacts.f.where must return true or false", "must return true or false, got the number 0" },
  { "sg.model(with{ adhesion = film, where = function(X) end })", "contacts.f.where",
    "contacts.f.where must return true or false, got nothing" },
  { "sg.model(with{ adhesion = film, where = function(X) return X.x <= 15 end })",
    "attempt to compare nil with number" },
  { "sg.model(with{ adhesion = film, master = sg.rigid.plane{ point = {0, 2}, normal = {0, 1} } })",
    "contacts.f: the obstacle is inside body 's' at the start", "2 deep", "move the obstacle out" },
  { "sg.model(with{ adhesion = film, master = sg.rigid.cylinder{ center = {10, 2}, radius = 1 } })",
    "contacts.f: the obstacle is inside body 's' at the start", "its center (10, 2) is in the body",
    "move the obstacle out" },
  { [[sg.model(turned{ on = { edge, s:face "west" }, rotate = true })]], "supports.e.on must be one face",
    "got a list of 2 values", "use separate supports for other faces" },
  { [[sg.model(turned{ on = s:corner "south-east", rotate = true })]], "supports.e.on must be one face",
    "only one face of a body can rotate" },
  { "sg.model(turned{ on = edge, rotate = 90 })", "supports.e.rotate must be true in the plane; in 3D",
    "got the number 90" },
  { [[sg.model(turned{ on = edge, rotate = true, drive = "xy" }):run{ { steps = 1, e = {0, 1} } }]],
    "model:run: stages[1].e must be a list of 3 numbers (ux, uy, angle), got a list of 2 values",
    "one for each driven component" },
  { [[sg.model(turned{ on = edge, rotate = true, fix = "xy" }):run{ { steps = 1, e = {} } }]],
    "model:run: stages[1].e must be a list of 1 number (angle), got an empty table" },
  { [[sg.model(turned{ on = edge, rotate = true, fix = "xy" }):run{ { steps = 1, e = {90, 1} } }]],
    "model:run: stages[1].e must be a list of 1 number (angle), got a list of 2 values" },
  { [[sg.model(turned{ on = edge, rotate = true, fix = "xy" }):run{ { steps = 1, e = {"90"} } }]],
    "model:run: stages[1].e[1] must be a number, got the string '90'. Hint: remove the quotes" },
})

check.case("pseudo-transient continuation passes the snap of a linear elastic block, with every solver", function()
  local function pulled(linear)
    local model = scenes.model{
      bodies = { block = { size = {8, 4}, elements = {8, 3}, contact = "south",
          material = sg.linear_elastic{ E = 0.2, nu = 0.3 } } },
      supports = { lid = { on = "north", fix = "x", drive = "y" } },
      contacts = { film = { slave = "south", adhesion = film, master = scenes.floor(-equilibrium) } } }
    return model:run({ { steps = 20, lid = {3} } },
      sg.plain{ pseudo_transient = linear ~= "none", linear = linear ~= "none" and linear or nil,
                newton = { iterations = 50 } })
  end
  local direct = pulled "umfpack"
  check.equal({ direct.reason, direct:column "lid.fy"[20] < 0.01 }, { "completed", true })
  for _, linear in ipairs { "auto", "condensed" } do
    local run = pulled(linear)
    check.equal({ run.reason, run.iterations }, { "completed", direct.iterations })
    check.near(run:column "lid.fy", direct:column "lid.fy", 1e-8)
  end
  check.equal(pulled("none").reason, "turning_point") -- Newton's method alone ends there
end)

check.case("a run that pseudo-transient continuation cannot save reports the failed step", function()
  local body = scenes.body{ size = {8, 4}, elements = {4, 2}, contact = "south",
    material = sg.linear_elastic{ E = 2, nu = 0.3 } }
  local model = scenes.model{
    bodies = { block = body }, supports = { lid = { on = "north", fix = "x" } },
    loads = { pull = { on = "north", traction = {0, 0} } }, -- beyond the strength there is no equilibrium
    contacts = { film = { slave = "south", adhesion = film,
                          master = scenes.floor(-equilibrium) } } }
  local run = model:run({ { steps = 10, pull = {0, 0.3} } }, sg.plain{ pseudo_transient = true })
  check.equal({ run.failed, run.steps > 2 }, { true, true })
end)
