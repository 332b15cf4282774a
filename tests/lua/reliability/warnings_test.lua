-- Valid but questionable scenes and runs: run.warnings, and errors.

require "check"
local other_warnings = require "other_warnings"

local function slab_on(order, nu, material)
  return scenes.body{ size = {2, 1}, elements = {64, 4}, order = order or "N2",
    material = (material or sg.neo_hookean){ E = 1, nu = nu or 0.3 } }
end

--- A slab under a rigid cylinder. `given`: replaces parts of the contact.
local function pressed(given, nu)
  local slab = slab_on("N2", nu)
  local disc = sg.rigid.cylinder{ center = {1, 1.5}, radius = 0.5 }
  local contact = lists.merged({ slave = slab:face "north", master = disc }, given)
  return scenes.model{ bodies = { slab = slab },
    supports = { bed = { on = "south", fix = "xy" }, push = { on = disc, drive = "y" } }, contacts = { c = contact } }
end

--- The only warning of a model, which a run repeats.
local function only(model)
  local run = model:run{ { steps = 1, push = -0.05 } }
  local others = other_warnings(run)
  check.equal({ #model:warnings(), #others, others[1] }, { 1, 1, model:warnings()[1] })
  return others[1]
end

check.case("a correct scene has no warnings", function()
  local model = pressed{ friction = { mu = 0.8 } }
  check.equal({ #model:warnings(), #model:run({ { steps = 1, push = -0.05 } }).warnings }, { 0, 0 })
end)

check.case("mu that looks like an angle", function()
  check.holds(only(pressed{ friction = { mu = 30 } }), "contacts.c: friction.mu = 30",
    "for an angle of 30 degrees mu = 0.57735")
end)

check.case("nearly incompressible material", function()
  check.holds(only(pressed({}, 0.4999999)),
    "bodies.slab: at Poisson's ratio 0.4999999 elements of degree 2 (along xi1)",
    "lock", 'Hint: use nu = 0.497 or less, or volumetric = "projected" in sg.body')
  check.equal(#pressed({}, 0.49):warnings(), 0)
end)

check.case("the limit of Poisson's ratio depends on the degree", function()
  local function warnings(order, nu)
    local body = scenes.body{ order = order, nu = nu }
    return scenes.model{ bodies = { slab = body }, supports = { bed = { on = "south", fix = "xy" } } }:warnings()
  end
  for order, limit in pairs { N2 = 0.497, N3 = 0.499, N4 = 0.499 } do
    check.equal(#warnings(order, limit), 0)
    check.holds(warnings(order, limit + 1e-4)[1], "slab", ("nu = %g or less"):format(limit))
  end
end)

check.case("degree 1 in any direction of a nearly incompressible body", function()
  local function warnings(options)
    local dimension = #options.elements
    local body = sg.body{ patch = dimension == 2 and sg.shapes.rectangle{ width = 10, height = 1 }
        or sg.shapes.block{ size = {10, 1, 1} }, elements = options.elements, order = options.order,
      contact = dimension == 2 and "south" or "front", thickness_degree = options.thickness_degree,
      material = sg[options.law or "neo_hookean"]{ E = 1, nu = options.nu } }
    return scenes.model{ bodies = { beam = body }, supports = { wall = { on = "west", fix = "x" } } }:warnings()
  end
  for _, law in ipairs { "neo_hookean", "linear_elastic" } do
    local found = warnings{ elements = {4, 2}, order = "N2", thickness_degree = 1, nu = 0.45, law = law }
    check.equal(#found, 1)
    check.holds(found[1], "bodies.beam: at Poisson's ratio 0.45 elements of degree 1 (along xi2) lock",
      "degree 2 or more in all directions (order N2 or higher, without thickness_degree or with thickness_degree = 2)")
  end
  check.holds(warnings{ elements = {2, 2, 1}, order = {"N2", "N1"}, thickness_degree = 2, nu = 0.47 }[1],
              "(along xi2) lock")
  check.holds(warnings{ elements = {2, 2, 1}, order = "N2-N3", thickness_degree = 1, nu = 0.47 }[1], "(along xi3) lock")
  check.equal(#warnings{ elements = {4, 2}, order = "N2", thickness_degree = 1, nu = 0.44 }, 0)
  check.equal(#warnings{ elements = {4, 2}, order = "N2", nu = 0.47 }, 0)
end)

check.case("a penalty beyond rounding is reported before the run and as the cause of its failure", function()
  local model = pressed{ penalty = 1e20 }
  check.holds(model:warnings()[1], "contacts.c: penalty = 1e+20 is 2.5e+19 times the stiffness E/h", "rounding error",
    "10 to 100 times E/h = 4, by default 30 times")
  local run = model:run{ { steps = 2, push = -0.05 } }
  check.equal(run.failed, true)
  check.holds(run.failure, "at this ratio the body's stiffness is lost",
    "Hint: lower the penalty of contact 'c'")
  check.equal(run.failure:find("add a support to the body", 1, true), nil)
end)

--- A slab of thickness 1 under a tool of radius 0.5 half above it, whose grip is driven by `depth`.
local function lowered(tool, depth, steps, options)
  local space = tool == "sphere"
  local slab = sg.body{ patch = space and sg.shapes.block{ size = {2, 2, 1}, corner = {-1, -1, 0} }
      or sg.shapes.rectangle{ width = 2, height = 1, corner = {-1, 0} },
    elements = space and {6, 6, 1} or {8, 2}, order = "N2", contact = space and "back" or "north",
    material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  local bodies, master, grip = { slab = slab }, nil, nil
  if tool == "ring" then
    local ring = scenes.body{ patch = sg.nurbs.ruled{ a = sg.nurbs.circle{ radius = 0.5, center = {0, 2} },
        b = sg.nurbs.circle{ radius = 0.3, center = {0, 2} } }, elements = {8, 1}, contact = "south", E = 10 }
    bodies.ring, master, grip = ring, ring:face "south", ring:face "north"
  elseif tool == "cylinder" then
    master = sg.rigid.cylinder{ center = {0, 2}, radius = 0.5 }
  else
    master = sg.rigid.sphere{ center = {0, 0, 2}, radius = 0.5 }
  end
  return sg.model{ bodies = bodies, supports = { bed = { on = slab:face(space and "front" or "south"),
      fix = space and "xyz" or "xy" }, grip = { on = grip or master, drive = space and "xyz" or "xy" } },
    contacts = { c = { slave = slab:face(space and "back" or "north"), master = master, penalty = 20 } } }
    :run({ { steps = steps, grip = space and {0, 0, -depth} or {0, -depth} } }, options)
end

check.case("a tool that passes through a slab in one step, or into it", function()
  for _, tool in ipairs { "cylinder", "sphere", "ring" } do
    for _, depth in ipairs { 3.5, 2.6 } do -- far beyond, and just behind the far side
      local run = lowered(tool, depth, 1, sg.plain{})
      check.equal({ run.reason, run.steps }, { "crossed", 0 })
      check.holds(run.failure, "points of the slave face of contact 'c' passed through the master without contact",
        "behind the master", "Hint: take smaller steps")
    end
    check.equal(lowered(tool, 0.7, 4).reason, "completed")
  end
  check.equal(lowered("cylinder", 1.5, 1, sg.plain{}).reason, "crossed") -- inside
end)

check.case("the same pair of faces in two contacts", function()
  local function twice(options)
    local lower, upper = slab_on(), scenes.body{ size = {2, 1}, corner = {0, 1}, elements = {4, 4} }
    local one = { slave = upper:face "south", master = lower:face "north", penalty = 10, where = options.left }
    local two = { slave = upper:face "south", master = lower:face "north", penalty = 10, where = options.right }
    if options.swap then two.slave, two.master = one.master, one.slave end
    return scenes.model{ bodies = { lower = lower, upper = upper }, contacts = { a = one, b = two },
      supports = { bed = { on = "lower.south", fix = "xy" }, lid = { on = "upper.north", fix = "xy" } } }
  end
  for _, options in ipairs { {}, { swap = true } } do
    local warnings = twice(options):warnings()
    check.equal(#warnings, 1)
    check.holds(warnings[1], "contacts.a and contacts.b act between the same faces", "face 'south' of body 'upper'",
      "pressures are counted twice")
  end
  local parted = twice{ left = function(X) return X[1] < 1.1 end, right = function(X) return X[1] >= 1.1 end }
  check.equal(#parted:warnings(), 0)
end)

check.case("a linear elastic body with large strains or rotations, in a plane, a ring and space", function()
  --- The only warning of a run, nil without one.
  local function warning(model, targets)
    local run = model:run{ { steps = 1, move = targets } }
    check.equal({ run.reason, #run.warnings <= 1 }, { "completed", true })
    return run.warnings[1]
  end
  -- Compressed between frictionless plates by the exact strain, also beyond inversion.
  local function squeezed(strain)
    local slab = slab_on("N2", 0, sg.linear_elastic)
    return warning(scenes.model{ bodies = { slab = slab }, supports = { bed = { on = "south", fix = "y" },
        side = { on = "west", fix = "x" }, move = { on = "north", drive = "y" } } }, { strain })
  end
  check.equal(squeezed(-0.045), nil)
  check.holds(squeezed(-0.055), "at the end of stage", "bodies.slab: the linear elastic body turns by 0 degrees",
    "strained by -5.5 %", "Hint: use sg.neo_hookean")
  check.holds(squeezed(-1.8), "strained by -180 %")
  -- A ring with a grown radius, u/R = 0.06 at its middle, is strained in the third direction alone.
  check.holds(warning(scenes.model{ kind = "axisymmetric",
    bodies = { ring = { size = {0.02, 0.02}, corner = { 0.99, 0 }, elements = { 1, 1 },
        material = sg.linear_elastic{ E = 1, nu = 0 } } }, supports = { bed = { on = "south", fix = "y" },
      move = { on = { "west", "east" }, drive = "x" } } }, { 0.06 }), "strained by 6 %")
  -- Turned as a whole: the law shortens the body, but its face turns by the angle that is prescribed.
  local function turned(angle, space)
    local body = scenes.body{
      patch = space and sg.shapes.block{ size = { 1, 1, 0.1 } } or sg.shapes.rectangle{ width = 1, height = 0.1 },
      elements = space and { 1, 1, 1 } or { 1, 1 }, material = sg.linear_elastic{ E = 1, nu = 0.3 } }
    local model = sg.model{ bodies = { body = body }, supports = { move = {
      on = body:face(space and "front" or "south"), rotate = space and "z" or true,
      drive = space and "xyz" or "xy" } } }
    return warning(model, space and { 0, 0, 0, angle } or { 0, 0, angle })
  end
  for _, space in ipairs { false, true } do
    check.equal(turned(9, space), nil)
    check.holds(turned(12, space), "turns by 1", "degrees")
  end
end)

check.case("a load that no stage changes is reported once, one that a stage changes is not", function()
  local function loaded()
    local slab = slab_on()
    return scenes.model{ bodies = { slab = slab }, supports = { bed = { on = "south", fix = "xy" } },
      loads = { dead = { on = "north", traction = {0, -0.01} }, none = { on = "west", pressure = 0 } } }
  end
  local model = loaded()
  local run = model:run{ { steps = 1 } }
  check.equal(#run.warnings, 1)
  check.holds(run.warnings[1], "no stage changes the load 'dead', which acts in full from the first step on")
  check.equal(#model:run({ { steps = 1 } }).warnings, 0)
  check.equal(#loaded():run({ { steps = 1, dead = {0, -0.02} } }).warnings, 0)
end)

check.case("a loose tolerance", function()
  local run = pressed():run({ { steps = 1, push = -0.05 } }, { newton = { tolerance = 1 } })
  check.equal(#other_warnings(run), 1)
  check.holds(run.warnings[1], "newton.tolerance = 1:", "expected at most 0.001", "the default is 1e-10")
end)

check.case("contact between the last step and the failure counts", function()
  local nose = sg.rigid.cylinder{ center = {11.2, -0.2}, radius = 0.6 }
  local model = scenes.model{
    bodies = {
      beam = { size = {10, 0.8}, elements = {10, 1}, contact = "south", thickness_degree = 2, E = 2000, nu = 0.35 } },
    supports = { wall = { on = "west", drive = "x", fix = "y" } },
    contacts = { nose = { slave = "south", master = nose, penalty = 5e4, friction = { mu = 0.2, penalty = 5e4 } } } }
  local run = model:run({ { name = "insert", steps = 40, wall = {4} } }, sg.robust{})
  check.equal(check.warnings(run, "never touched; smallest gap -"), {})
end)

check.case("a face that is listed twice is an error", function()
  local slab, other = slab_on(), slab_on()
  local north, bed = slab:face "north", { on = slab:face "south", fix = "xy" }
  check.fails(function()
    scenes.model{ bodies = { slab = slab }, supports = { bed = bed },
              loads = { p = { on = { north, "north" }, traction = {0, -0.1} } } }
  end, "loads.p.on lists face 'north' of body 'slab' twice, expected once")
  check.fails(function()
    sg.model{ bodies = { slab = slab }, supports = { bed = { on = { north, north }, fix = "xy" } } }
  end, "supports.bed.on lists face 'north' of body 'slab' twice")
  check.fails(function()
    scenes.model{ bodies = { slab = slab }, supports = { bed = { on = { "north-west", "west-north" }, fix = "xy" } } }
  end, "supports.bed.on lists corner 'west-north' of body 'slab', also called 'north-west', twice")
  local floor = scenes.floor(-1)
  check.fails(function()
    sg.model{ bodies = { slab = slab }, supports = { floor = { on = { floor, floor }, drive = "y" } } }
  end, "supports.floor.on lists an obstacle twice")
  scenes.model{ bodies = { slab = slab, other = other }, supports = { bed = { on = { north, "other.north" },
    fix = "xy" } } }
end)

check.case("hints do not name controls that are on", function()
  local slab = slab_on()
  local model = scenes.model{ bodies = { slab = slab }, supports = { -- pressed flat and farther
    bed = { on = "south", fix = "xy" }, lid = { on = "north", drive = "y" } } }
  model:set_target("lid", { -1.2 })
  check.equal(model:solve_step{ predictor = "tangent" }.reason, "inverted")
  check.holds(model:diagnose().cure, "take smaller steps (step = { adaptive = true })", "line_search", "a mesh")
  local cure = model:diagnose{ "step", "line_search" }.cure
  check.holds(cure, "allow smaller steps (step = { min = … })", "a mesh")
  check.equal({ cure:find("adaptive", 1, true), cure:find("line_search", 1, true) }, {})
  check.fails(function() model:diagnose{ "steps" } end, "on", "'steps'")
  model:rollback()

  local run = pressed():run({ { steps = 1, push = -0.05 } }, sg.robust{ fallback = false, newton = { iterations = 1 } })
  check.equal({ run.failed, run.failure:find("adaptive = true", 1, true) }, { true, nil })
  check.holds(run.failure, "allow more iterations", "allow smaller steps (step = { min = … })")
end)

check.case("loads and springs on prescribed displacements alone", function()
  local slab = slab_on()
  local bed = { on = slab:face "south", fix = "xy" }
  local function warnings(parts)
    local supports = { bed = bed, more = parts.support }
    return sg.model{ bodies = { slab = slab }, kind = parts.kind, supports = supports, loads = { p = parts.load } }
      :warnings()
  end
  local south, north = slab:face "south", slab:face "north"
  local lid = { on = north, drive = "y" }
  for _, load in ipairs { { on = slab:corner "south-west", force = {0, -1} }, { on = south, traction = {0, 0} },
                          { on = south, pressure = 0 }, { on = south, pressure = 1, follower = true },
                          { on = south, traction = function(x) return {x, 1} end, factor = 0 } } do
    local found = warnings{ load = load }
    check.equal(#found, 1)
    check.holds(found[1], "loads.p has no effect on the deformation", "prescribed, by supports.bed. Hint: ")
  end
  check.holds(warnings{ load = { on = north, traction = {0, -1} }, support = lid }[1], "loads.p", "by supports.more.")
  check.holds(warnings{ support = { on = south, spring = {1, 1} } }[1], "the spring of supports.more has no effect",
              "by supports.bed.")

  -- Some of the displacements are free, or may be where the load turns.
  for _, load in ipairs { { on = north, traction = {1, -1} }, { on = north, traction = {0, 0} },
                          { on = north, pressure = 1, follower = true }, { on = slab, force = {0, -1} } } do
    check.equal(warnings{ load = load, support = lid }, {})
  end
  check.equal(warnings{ load = { on = { south, north }, traction = {0, 0} } }, {})
  check.equal(warnings{ support = { on = { south, north }, spring = {1, 1} } }, {})
  check.equal(warnings{ load = { on = slab:face "west", pressure = 1 } }, {})

  for _, parts in ipairs { { load = { on = slab:corner "north-west", force = {1, 0} } },
                           { load = { on = slab:face "west", pressure = 1, follower = true } },
                           { support = { on = slab:face "west", spring = {1, 1} } } } do
    parts.kind = "axisymmetric"
    local found = warnings(parts)
    check.equal(#found, 1)
    check.holds(found[1], parts.load and "loads.p" or "supports.more", "on the axis faces have no area")
  end
  check.equal(warnings{ kind = "axisymmetric", load = { on = slab:corner "north-west", force = {1, -1} } }, {})
  check.equal(warnings{ kind = "axisymmetric", load = { on = slab:face "east", pressure = 1 } }, {})
end)

check.case("a large number of elements is announced before they are made, and too many are rejected", function()
  local script = check.file "large.lua"
  -- Contact faces that are not opposite ones stop it before the tables are made.
  core.write_file(script, [[ local sg = require "signorini"
    sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = {1000, 1000}, order = "L1",
             contact = { "north", "east" }, material = sg.linear_elastic{ E = 1, nu = 0.3 } } ]])
  check.holds(check.program { script }, "elements = {1000, 1000} make at least 2004002 unknowns", "takes a while")
end)

check.case("faces in coordinate planes are named where a patch is shown", function()
  local text = require("signorini.prompt.show").text(sg.shapes.sphere_octant{ inner = 0.5, outer = 1 })
  check.holds(text, "faces: west in y = 0; east in x = 0; south in z = 0; north in x = 0, y = 0")
end)

check.case("fewer contact points per element than the degree of the slave face", function()
  local function warnings(order, points)
    local upper = scenes.body{ size = {2, 1}, corner = {0, 1}, elements = {4, 4}, order = order, contact = "south" }
    return scenes.model{ bodies = { upper = upper }, supports = { lid = { on = "north", fix = "xy" } },
      contacts = { touch = { slave = "south", penalty = 10, points = points, master = scenes.floor(1) } } }:warnings()
  end
  check.equal({ warnings("N1", 1), warnings("N2", 2), warnings("N2-N4", 4), warnings("N2-N4") }, { {}, {}, {}, {} })
  check.holds(warnings("N2", 1)[1], "contacts.touch: points = 1 per element and direction is less than the degree 2")
  check.holds(warnings("N2-N4", 3)[1], "less than the degree 4 of the slave face", "Hint: leave points out")
end)

check.case("weights so different that Gauss points miss the geometry", function()
  local function warnings(weight, elements)
    local patch = sg.nurbs.surface{ degrees = {1, 1}, knots = { {0, 0, 1, 1}, {0, 0, 1, 1} },
                                    points = { {0, 0}, {1, 0}, {0, 1}, {1, 1} }, weights = { 1, weight, 1, weight } }
    return scenes.model{ bodies = { slab = { patch = patch, elements = elements } },
      supports = { bed = { on = "south", fix = "xy" } } }:warnings()
  end
  check.equal({ warnings(3, {1, 1}), warnings(50, {32, 1}) }, { {}, {} })
  check.holds(warnings(50, {1, 1})[1], "bodies.slab: the weights of its control points differ by a factor of 50",
    "by a factor of 50, so that Gauss points find its volume with an error of 52 %", "Hint: more elements")
end)
