-- Bodies that overlap before the first step, and masters that are the wrong face: errors or warnings at sg.model.

require "check"

local material = sg.neo_hookean{ E = 1, nu = 0.3 }

--- Two plane blocks of width 2, the upper one's south at height y, everything moved by `origin`.
local function blocks(y, options)
  options = options or {}
  local x0, height = options.origin or 0, options.height or 1
  local function block(bottom, tall)
    return scenes.body{ size = {2, tall}, corner = {x0, x0 + bottom}, elements = {4, 2}, material = material }
  end
  local lower, upper = block(0, height), block(y, 1)
  return scenes.model{ kind = options.kind, bodies = { lower = lower, upper = upper },
    supports = { bed = { on = "lower.south", fix = "xy" }, lid = { on = "upper.north", drive = "y", fix = "x" } },
    contacts = { c = { slave = "upper.south", master = lower:face(options.master or "north"),
        penalty = not options.adhesion and 100 or nil, adhesion = options.adhesion } } }
end

check.case("bodies that overlap deeply are an error that names both faces and the depth", function()
  for _, kind in ipairs { "plane_strain", "axisymmetric" } do
    check.fails(function() blocks(0.5, { kind = kind }) end, "contacts.c",
      "face 'south' of body 'upper' penetrates face 'north' of body 'lower' by 0.5 before the first step",
      "50 % of the thickness of the thinner body", "move the bodies apart", "the wrong face", "its normal is reversed")
  end
  check.fails(function() blocks(0.5, { origin = 1e6 }) end, "by 0.5 before the first step")
end)

check.case("a master that looks away from the slave is an error that names the opposite face", function()
  for _, kind in ipairs { "plane_strain", "axisymmetric" } do
    check.fails(function() blocks(1, { master = "south", kind = kind }) end,
      "face 'south' of body 'upper' penetrates face 'south' of body 'lower' by 1 before the first step",
      "did you mean face 'north'?")
  end
  check.fails(function() blocks(1.3, { master = "south" }) end, "by 1.3 before", "did you mean face 'north'?")
  check.fails(function() blocks(1e-3, { master = "south", height = 1e-3 }) end, "did you mean face 'north'?") -- a film
  check.fails(function() blocks(1, { master = "south", adhesion = { hamaker = 0.1, r0 = 0.4 } }) end,
    "did you mean face 'north'?")
end)

check.case("two opposite faces of one body are not a contact pair", function()
  local strip = scenes.body{ size = {5, 0.1}, elements = {4, 1}, material = material }
  check.fails(function()
    scenes.model{ bodies = { strip = strip }, supports = { wall = { on = "west", fix = "xy" } },
              contacts = { c = { slave = "south", master = "north", penalty = 10 } } }
  end, "face 'south' of body 'strip' penetrates face 'north' of body 'strip' by 0.1", "did you mean face 'south'?")
end)

check.case("solids: deep overlap and the wrong face are errors", function()
  local function solids(z, master)
    local function cube(bottom)
      return scenes.body{ size = {2, 2, 1}, corner = {0, 0, bottom}, elements = {2, 2, 1}, material = material }
    end
    local lower, upper = cube(0), cube(z)
    return scenes.model{ bodies = { lower = lower, upper = upper },
      supports = { bed = { on = "lower.front", fix = "xyz" }, lid = { on = "upper.back", drive = "z", fix = "xy" } },
      contacts = { c = { slave = "upper.front", master = lower:face(master), penalty = 100 } } }
  end
  check.fails(function() solids(0.5, "back") end, "penetrates face 'back' of body 'lower' by 0.5")
  check.fails(function() solids(1, "front") end, "did you mean face 'back'?")
  check.equal(#solids(1, "back"):warnings(), 0)
end)

check.case("an overlap of some percent, as of an interference fit, is a warning that every run repeats", function()
  local model = blocks(0.95)
  check.equal(#model:warnings(), 1)
  check.holds(model:warnings()[1], "by 0.05 before the first step", "by about 2.5 %", "interference fit")
  local run = model:run({ { steps = 1, lid = {0} } }, sg.robust{})
  check.equal({ run.reason, run.warnings[1] }, { "completed", model:warnings()[1] })
  check.holds(run, "interference fit")
  local script = check.file "overlap.lua"
  core.write_file(script, [[
    local sg = require "signorini"
    local function block(y)
      return sg.body{ patch = sg.shapes.rectangle{ width = 2, height = 1, corner = {0, y} }, elements = {2, 2},
                      order = "N2", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
    end
    local a, b = block(0), block(0.95)
    local m = sg.model{ bodies = { a = a, b = b }, supports = { bed = { on = a:face "south", fix = "xy" },
                        lid = { on = b:face "north", drive = "y", fix = "x" } },
                        contacts = { c = { slave = b:face "south", master = a:face "north", penalty = 100 } } }
    m:run{ { steps = 1, lid = {0} } }]])
  local _, said = check.program({ script }):gsub("interference fit", "")
  check.equal(said, 1) -- by sg.model, not by the run once more
end)

check.case("touching within rounding, small overlaps, gaps and equilibrium distances are fine", function()
  for _, y in ipairs { 1.2, 1 + 1e-15, 1, 1 - 1e-9, 0.9985 } do check.equal(#blocks(y):warnings(), 0) end
  check.equal(#blocks(1, { origin = 1e6 }):warnings(), 0)
  check.equal(#blocks(1 + 15 ^ (-1 / 6) * 0.4, { adhesion = { hamaker = 0.1, r0 = 0.4 } }):warnings(), 0)
end)

check.case("a small overlap is a warning if closing it strains a body, which the stress confirms", function()
  -- Two blocks of steel between fixed plates: mean strain and stress are those of the overlap over both heights.
  local function stacked(overlap, more)
    local steel = sg.linear_elastic{ E = 210000, nu = 0 }
    local function block(y)
      return scenes.body{ size = {10, 10}, corner = {0, y}, elements = {3, 3}, material = steel }
    end
    local a, b = block(overlap - 10), block(0)
    local contact = lists.merged({ slave = b:face "south", master = a:face "north", penalty = 1e8 }, more)
    return scenes.model{ bodies = { a = a, b = b }, contacts = { c = contact },
      supports = { low = { on = "a.south", fix = "xy" }, up = { on = "b.north", fix = "xy" } } }
  end
  local model = stacked(0.09)
  check.holds(model:warnings()[1], "by 0.09 before the first step", "by about 0.45 %", "although nothing loads it")
  model:run({ { steps = 1 } }, sg.plain{})
  check.within_share("pressure", model:contact_resultant "c".max_pressure, 210000 * 0.0045, 0.02)
  check.equal(#stacked(0.019):warnings(), 0)
  check.equal(#stacked(0.09, { overlap = "interference" }):warnings(), 0)
  -- In a rigid plane, of which the block alone is strained, and by a small cylinder
  local function on(obstacle)
    local b = scenes.body{ size = {10, 10}, elements = {10, 10}, material = material }
    return scenes.model{ bodies = { b = b }, supports = { up = { on = "north", fix = "xy" } },
                     contacts = { c = { slave = "south", master = obstacle, penalty = 10 } } }:warnings()
  end
  check.holds(on(scenes.floor(0.05))[1], "penetrates the obstacle by 0.05",
    "by about 0.5 %")
  check.equal(#on(scenes.floor(0.009)), 0)
  check.holds(on(sg.rigid.cylinder{ center = {5, -0.991}, radius = 1 })[1], "penetrates the obstacle by 0.00")
end)

check.case("a body behind a rigid curve or surface is an error, however near it is", function()
  local function under(y, curve, width)
    return scenes.model{ bodies = { slab = { size = {2, 1}, corner = {0, y}, elements = {8, 4}, material = material } },
      supports = { bed = { on = "south", fix = "xy" }, push = { on = curve, drive = "y" } },
      contacts = { c = { slave = "north", master = curve, penalty = 100 } } }
  end
  local function line(height, turned)
    local patch = sg.nurbs.line{ from = {-1, height}, to = {3, height} }
    return sg.rigid.surface(turned and patch:reverse(1) or patch)
  end
  --- A line from left to right has its outside below it.
  for _, height in ipairs { 0.995, 0.9999, 1, 1.001, 1.009, 1.1 } do
    assert(under(0, line(height)))
    check.fails(function() under(0, line(height, true)) end, "overlap_test.lua", "contacts.c", "reverse its normal")
  end
  check.fails(function() under(0, line(1.001, true)) end, "face 'north' of body 'slab' and the obstacle are closest",
    "0.001 apart, both face the same way", "patch:reverse(1)")
  assert(under(0, line(0.995)):warnings()[1])
  -- Beyond its ends a curve has no sides: a body may be there.
  for _, turned in ipairs { false, true } do
    local short = sg.nurbs.line{ from = {2.5, 0.995}, to = {5, 0.995} }
    assert(under(0, sg.rigid.surface(turned and short:reverse(1) or short)))
  end
  -- A circle above the slab, and as a bore about a disc of nearly its size
  local function circle(radius, turned, height)
    local patch = sg.nurbs.circle{ center = {1, height}, radius = radius }
    return sg.rigid.surface(turned and patch:reverse(1) or patch)
  end
  for _, height in ipairs { 1.499, 1.5, 1.501, 2 } do
    assert(under(0, circle(0.5, false, height)))
    check.fails(function() under(0, circle(0.5, true, height)) end, "contacts.c", "reverse its normal")
  end
  local disc = scenes.body{ patch = sg.shapes.polar_disc{ radius = 1, center = {1, 0} }, elements = {8, 2},
    material = material }
  local function bored(radius, turned)
    return scenes.model{ bodies = { disc = disc }, contacts = { c = { slave = "south", penalty = 100,
      master = circle(radius, turned, 0) } }, supports = { hub = { on = "north", fix = "xy" } } }
  end
  for _, radius in ipairs { 0.999, 1, 1.001, 1.2 } do
    assert(bored(radius, true))
    check.fails(function() bored(radius, false) end, "contacts.c", "reverse its normal")
  end
  local block = scenes.body{ size = {2, 2, 1}, elements = {2, 2, 1}, material = material }
  local function below(height, turned)
    local sheet = sg.nurbs.extrude{ patch = sg.nurbs.line{ from = {-1, -1, height}, to = {3, -1, height} },
                                    along = {0, 4, 0} }
    return scenes.model{ bodies = { block = block }, contacts = { c = { slave = "back", penalty = 100,
      master = sg.rigid.surface(turned and sheet or sheet:reverse(1)) } },
      supports = { bed = { on = "front", fix = "xyz" } } }
  end
  for _, height in ipairs { 0.995, 1, 1.001, 1.02, 1.5 } do
    assert(below(height))
    check.fails(function() below(height, true) end, "contacts.c", "reverse its normal")
  end
end)

check.case("a thin body behind an obstacle is found although its length is many times the depth", function()
  local strip = scenes.body{ size = {10, 0.05}, corner = {0, -0.05}, elements = {4, 1}, material = material }
  check.fails(function()
    scenes.model{ bodies = { strip = strip }, supports = { wall = { on = "west", fix = "xy" } },
              contacts = { c = { slave = "south", penalty = 10,
                                 master = sg.rigid.surface(sg.nurbs.line{ from = {12, 0}, to = {-2, 0} }) } } }
  end, "contacts.c: the obstacle is inside body 'strip' at the start", "0.05 deep")
end)
