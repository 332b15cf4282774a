-- Bodies that touch from the start within rounding error, or never touch.

local lists = require "signorini.call.lists"
require "check"
local other_warnings = require "other_warnings"

local function rectangle(width, height, corner, elements, contact)
  return scenes.body{ size = {width, height}, corner = corner, elements = elements, contact = contact, E = 10 }
end

--- A block on a slab, with knots on knots. `extra`: a further support of the block or what replaces its face.
local function scene(gap, friction, options)
  options = options or {}
  local block, slab = rectangle(1, 0.5, {1, 1 + gap}, {8, 4}, "south"), rectangle(4, 1, {0, 0}, {32, 8}, "north")
  local supports = { bed = { on = slab:face "south", fix = "xy" } }
  if not options.load then supports.top = { on = block:face "north", drive = "xy" } end
  return scenes.model{ bodies = { block = block, slab = slab }, supports = supports,
    loads = options.load and { push = { on = block:face "north", traction = {0, 0} } },
    contacts = { c = { slave = block:face(options.slave or "south"), master = "slab.north", penalty = 1000,
        friction = friction } } }
end

local rough = { mu = 0.3, penalty = 1000 }
local press = { { name = "press", steps = 5, top = {0, -0.02} } }

check.case("a gap of exactly zero, with signs that depend on rounding error, is as easy as any other", function()
  local force
  for _, gap in ipairs { 1e-6, 1e-14, 0, -1e-14 } do
    local run = scene(gap, rough):run(press)
    check.equal({ gap, run.reason, run.steps }, { gap, "completed", 5 })
    check.equal(run.iterations <= 32, true)
    local fy = run:column "top.fy"[5]
    force = force or fy
    check.near(fy, force, 1e-4 * math.abs(force))
  end
  check.equal(scene(0, rough):run(press, sg.robust{}).fallback_steps, 0)
end)

check.case("the initial contact set is a first guess: a block that is lifted separates at once", function()
  local run = scene(0, rough):run{ { name = "lift", steps = 1, top = {0, 0.1} } }
  check.equal({ run.reason, run:column "c.area"[1] }, { "completed", 0 })
  check.near(run:column "top.fy"[1], 0, 1e-12)
end)

check.case("arc length requires an accepted step: without one the run fails and reports it", function()
  local column = rectangle(0.5, 10, {0, 0}, {1, 8}, "west")
  local model = scenes.model{ bodies = { column = column }, supports = {
    bed = { on = "south", fix = "xy" }, top = { on = "north", drive = "y" } } }
  local run = model:run({ { steps = 1, top = -0.1 } }, { arc_length = true, newton = { iterations = 1 } })
  check.equal({ run.failed, run.reason, run.steps, #run.controls }, { true, "indefinite", 0, 0 })
  check.holds(run.failure, "arc length can only start after an accepted step")
end)

check.case("a load along a frictionless contact: the hint is not damping", function()
  for _, options in ipairs { {}, sg.robust{} } do
    local run = scene(0, nil, { load = true }):run({ { name = "push", steps = 1, push = {0.01, -0.1} } }, options)
    check.equal({ run.failed, run.cause }, { true, "singular" })
    check.holds(run.failure, "contact 'c' is frictionless, so nothing holds body 'block' tangentially")
    check.equal(run.failure:find("damping = true", 1, true), nil)
  end
end)

check.case("a contact that never touched is reported once, with the smallest gap", function()
  local run = scene(0, rough, { slave = "north" }):run(press)
  check.equal({ run.reason, #run.warnings }, { "completed", 2 })
  check.holds(run.warnings[1], "contact 'c' never touched; smallest gap 0.48")
  check.holds(run.warnings[2], "face 'north' of body 'slab' lies 0.02 behind face 'south' of body 'block'")
  check.holds(run, "contact 'c' never touched")
  check.equal(#scene(0, rough):run(press).warnings, 0)
end)

check.case("half passes of which one has transmitted nothing although its points penetrate", function()
  local function run(slab, arch)
    local rubber = sg.neo_hookean{ E = 1, nu = 0.3 }
    local model = scenes.model{
      bodies = { low = { size = {2, 0.6}, corner = {-1, -0.6}, elements = slab, order = "N3", contact = "north",
          material = rubber }, up = { patch = sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = {0, 0.501} },
          elements = arch, contact = "south", material = rubber } },
      supports = { bed = { on = "low.south", fix = "xy" }, lid = { on = { "up.west", "up.east" }, drive = "xy" } },
      contacts = { k = { slave = "low.north", master = "up.south", method = "half_passes", multipliers = "equal" } } }
    return table.concat(model:run{ { steps = 4, lid = {0, -0.02} } }.warnings, "\n")
  end
  local found = run({16, 6}, {2, 1})
  local depth = tonumber(found:match "'k.master' has transmitted no force, although points .- lie up to (%S+) in the")
  assert(depth > 0.001 and depth < 0.019, depth)
  check.equal(found:find("never touched", 1, true), nil)
  check.holds(found, "the half passes of contact 'k' do different work at any increments")
  -- Where both miss, the bodies' overlap is reported, once.
  found = run({2, 3}, {2, 1})
  check.holds(found, "no point of contacts.k is active")
  check.equal(found:find("transmitted", 1, true), nil)
end)

check.case("a penalty that is soft against the bodies is reported with one that leaves 1 %", function()
  local function sunk(penalty)
    local model = scenes.model{
      bodies = { block = { size = {2, 1}, contact = "south", material = sg.linear_elastic{ E = 1, nu = 0 } } },
      supports = { lid = { on = "north", drive = "y", fix = "x" } },
      contacts = { ground = { slave = "south", penalty = penalty, master = scenes.floor() } } }
    return model:run{ { steps = 2, lid = -0.04 } }
  end
  -- Springs of stiffness E and epsilon in a row: 0.04 E/(E + epsilon) of the lid's way goes into the contact.
  check.equal(sunk(1).warnings, { "at the end of stage 'stage 1': contacts.ground: penetration, 0.02 in the mean, is "
    .. "50 % of the approach of the faces, of which the elasticity of the bodies should be the cause: at prescribed "
    .. "motions "
    .. "forces are too small by about this part. Hint: penalty = 99 leaves about 1 %" })
  check.holds(sunk(18).warnings[1], "5.26 %", "penalty = 99")
  check.equal(sunk(20).warnings, {}) -- 4.8 %
  check.near(sunk(99):column "ground.fy"[2], 0.99 * 0.08, 1e-9)
end)

--- A block on a slab, pressed by the lid; `contact` is added to their contact, `of` to the support of the slab.
local function pressed(contact, of, lid)
  local function block(corner, width, elements)
    return scenes.body{ size = {width, 1}, corner = corner, elements = elements,
      material = sg.linear_elastic{ E = 1, nu = 0 } }
  end
  local upper, slab = block({0, 1}, 2, {2, 2}), block({-1, 0}, 4, {6, 2})
  local model = scenes.model{ bodies = { upper = upper, slab = slab },
    supports = { lid = { on = "upper.north", drive = "y", fix = "x" }, bed = of and of(slab) },
    contacts = { c = lists.merged({ slave = "upper.south", master = "slab.north" }, contact) } }
  return model:run{ { steps = 2, lid = lid } }
end

local function bed(slab) return { on = slab:face "south", fix = "xy" } end

check.case("a last step whose position damping alone determines names the body that nothing holds", function()
  local run = pressed({ penalty = 10 }, nil, -0.08)
  check.equal({ run.reason, #other_warnings(run) }, { "completed", 1 })
  check.holds(other_warnings(run)[1], "damping alone determines the position in step 2: the tangent is singular",
    "rigid-body translation of body 'slab'", "Hint: add a support")
  check.equal(other_warnings(pressed({ penalty = 10 }, bed, -0.08)), {})
end)

check.case("a closest-point projection that did not converge is reported with its place and a hint", function()
  -- The line x = -(2 xi - 1)^7: Newton's method for the closest point to (0, y) takes off 1/13 in each iteration.
  local line = sg.nurbs.curve{ degree = 7, knots = { 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1 },
                               points = { {1, 0}, {-1, 0}, {1, 0}, {-1, 0}, {1, 0}, {-1, 0}, {1, 0}, {-1, 0} } }
  local model = scenes.model{
    bodies = { block = { size = {2, 1}, corner = {-1, 0.1}, elements = {1, 1}, order = "N1", contact = "south",
        material = sg.linear_elastic{ E = 1, nu = 0 } } },
    supports = { grip = { on = { "south", "north" }, drive = "xy" } },
    contacts = { touch = { slave = "south", master = sg.rigid.surface(line), penalty = 1, points = 1 } } }
  local run = model:run{ { steps = 1, grip = {-0.9, -0.15} }, { steps = 1, grip = {0, -0.15} } }
  check.equal(run.reason, "completed")
  check.holds(table.concat(run.warnings, "\n"), "contact 'touch': the search for a closest point or slip point ended "
    .. "at a limit of iterations 1 time in accepted states, the last time at X = (0, 0.1): gap and friction are "
    .. "approximate there")
  check.equal(model:contact_resultant "touch".unsettled, 1) -- not where it is open
end)
