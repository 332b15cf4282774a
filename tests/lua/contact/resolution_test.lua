-- Warnings about contacts that the mesh or the penalty do not resolve, the penalty by default, and the mean pressure
-- over an element: against Hertz's line and point contact, blocks in a row, and uniform pressure.

require "check"

local narrow, soft, loose = "elements of the slave face wide", "of the approach of the faces, of which", "elastic slip"

local nu = 0.3
local plane_modulus = 1 / (1 - nu^2)

--- A rigid cylinder of radius 400 on a block with elements of length 1 along its upper face, pressed in by `depth`;
--- with `half` the half on one side of the plane of symmetry.
local function cylinder(contact, depth, half, more)
  local width = half and 24 or 48
  local block = scenes.body{ size = {width, 32}, corner = {-24, -32}, elements = { width, 8 },
    grading = { false, { elements = 0.7, length = 0.25, at = "end" } }, contact = "north",
    material = sg.linear_elastic{ E = 1, nu = nu } }
  local tool = sg.rigid.cylinder{ center = {0, 400}, radius = 400 }
  contact.slave, contact.master = block:face "north", tool
  local model = scenes.model{ bodies = { block = block }, contacts = { touch = contact },
    supports = { bed = { on = "south", fix = "xy" }, push = { on = tool, drive = "xy" },
                 middle = half and { on = "east", symmetry = true } or nil } }
  local stages = { { name = "press", steps = 2, push = {0, -depth} } }
  if more then stages[2] = { name = "slide", steps = 4, push = {more, -depth} } end
  return model:run(stages), model
end

--- Hertz's peak for the force of a run.
local function peak_of(run, half)
  return math.sqrt(-run:column("push.fy")[run.rows] * (half and 2 or 1) * plane_modulus / (math.pi * 400))
end

check.case("the peak of a contact that is wide enough is Hertz's, a narrower one is reported", function()
  for _, half in ipairs { false, true } do
    local run, model = cylinder({}, 0.06, half) -- 8 elements wide
    check.equal(check.warnings(run, narrow), {})
    check.within_share("peak", model:contact_resultant("touch").max_pressure, peak_of(run, half), 0.1)
    check.within_share("mean", model:contact_resultant("touch").mean_pressure, peak_of(run, half), 0.05)
    run, model = cylinder({}, 0.006, half) -- 2.7 elements wide
    check.equal(#check.warnings(run, narrow), 1)
    assert(math.abs(model:contact_resultant("touch").max_pressure / peak_of(run, half) - 1) > 0.1)
    check.holds(check.warnings(run, narrow)[1], "at the end of stage 'press': contacts.touch", "from 7 on",
      "Hint: use smaller elements of the slave face there")
  end
end)

check.case("a high penalty at Gauss points needs more elements, mortar averages do not", function()
  local run, model = cylinder({ penalty = 300 }, 0.05)
  assert(model:contact_resultant("touch").max_pressure > 1.5 * peak_of(run))
  check.within_share("mean", model:contact_resultant("touch").mean_pressure, peak_of(run), 0.05)
  check.equal(#check.warnings(run, narrow), 1)
  check.holds(check.warnings(run, narrow)[1], "from 23 on", "a high penalty at Gauss points over-constrains the face")
  local given = tonumber(check.warnings(run, narrow)[1]:match "penalty = (%S+):")
  for _, better in ipairs { { penalty = given }, { penalty = 300, method = "mortar" } } do
    run, model = cylinder(better, 0.05)
    check.equal(check.warnings(run, narrow), {})
    check.within_share("peak", model:contact_resultant("touch").max_pressure, peak_of(run), 0.1)
  end
  -- Where the peak is right by chance, the mean confirms it.
  run, model = cylinder({ penalty = 300 }, 0.06)
  check.equal(check.warnings(run, narrow), {})
  check.within_share("peak", model:contact_resultant("touch").max_pressure, peak_of(run), 0.1)
end)

--- A block of few elements on its whole face, pressed by 1 %.
local function pressed(contact, elements, order, law)
  local block = scenes.body{ size = {2, 1}, elements = elements, order = order, contact = "south",
    material = (law or sg.linear_elastic){ E = 1, nu = 0 } }
  contact.slave, contact.master = block:face "south", scenes.floor()
  local model = scenes.model{ bodies = { block = block }, contacts = { floor = contact },
    supports = { lid = { on = "north", drive = "y", fix = "x" } } }
  return model:run{ { steps = 1, lid = -0.01 } }, model
end

check.case("faces that touch as a whole are not narrow, and their mean pressure is the pressure", function()
  for _, elements in ipairs { { 1, 1 }, { 2, 1 }, { 4, 2 } } do
    for _, order in ipairs { "N1", "N2", "N2-N2.2" } do
      for _, contact in ipairs { {}, { penalty = 1000 }, { method = "mortar", enforcement = "multipliers" } } do
        local run, model = pressed(contact, elements, order)
        check.equal(run.warnings, {})
        local now = model:contact_resultant "floor"
        check.near(now.mean_pressure, now.fy / 2, 1e-9)
        check.near(now.max_pressure, now.fy / 2, 1e-9)
      end
    end
  end
end)

check.case("in space the narrowest direction counts, and directions that touch from end to end do not", function()
  local block = scenes.body{ size = {4, 1, 2}, corner = {-2, 0, -2}, elements = {8, 1, 2}, contact = "back",
    material = sg.linear_elastic{ E = 1, nu = 0 } }
  local function run(master)
    local model = scenes.model{ bodies = { block = block }, contacts = { touch = { slave = "back", master = master } },
      supports = { bed = { on = "front", fix = "xyz" }, push = { on = master, drive = "z" } } }
    return model:run{ { steps = 2, push = {-0.05} } }
  end
  check.equal(#check.warnings(run(sg.rigid.cylinder{ center = {0, 0, 4}, axis = {0, 1, 0}, radius = 4 }), narrow), 1)
  check.equal(check.warnings(run(sg.rigid.plane{ point = {0, 0, 0}, normal = {0, 0, -1} }), narrow), {})
end)

-- Springs in a row: the block's E/H = 1 and the penalty.
check.case("a soft penalty is reported at any factor, with one that leaves 1 %", function()
  for _, law in ipairs { sg.linear_elastic, sg.neo_hookean } do -- their strain is lost in rounding errors
    local found = check.warnings(pressed({ penalty = 1e-16 }, { 2, 2 }, "N2", law), soft)
    check.holds(found[1], "0.01 in the mean, is 100 %", "Hint: penalty = 30 leaves")
  end
  for _, penalty in ipairs { 1e-3, 1, 10 } do
    local run = pressed({ penalty = penalty }, { 2, 2 }, "N2")
    local found = check.warnings(run, soft)
    check.equal(#found, 1)
    local given = tonumber(found[1]:match "penalty = (%S+) leaves")
    check.within_share("penalty", given, 99, 0.02)
    local better = pressed({ penalty = given }, { 2, 2 }, "N2")
    check.within_share("force", better:column("floor.fy")[1], 0.02, 0.011)
    check.equal(better.warnings, {})
  end
  check.equal(pressed({ penalty = 20 }, { 2, 2 }, "N2").warnings, {})
end)

--- A tool of radius 2 that lies on a block under a load, with mortar contact.
local function resting(contact, elements)
  local block = scenes.body{ size = {2, 1}, corner = {-1, -1}, elements = elements, order = "N3", contact = "north",
    material = sg.linear_elastic{ E = 1, nu = 0 } }
  contact.slave, contact.master, contact.method = block:face "north", sg.rigid.cylinder{ center = {0, 2}, radius = 2 },
    "mortar"
  local model = scenes.model{ bodies = { block = block }, contacts = { touch = contact },
    supports = { bed = { on = "south", fix = "xy" }, tool = { on = contact.master, fix = "x", free = "y" } },
    loads = { weight = { on = contact.master, force = {0, 0} } } }
  return model:run{ { steps = 1, weight = {0, -0.02} } }, model
end

-- Pressure acts on the whole face where a contact of Hertz's width 4 (F R/(π E'))^½ is expected.
check.case("mortar contact whose elements cannot follow the master is reported, with the depth", function()
  local uneven, expected = "the means of its gaps over functions", 4 * math.sqrt(0.02 * 2 / math.pi)
  for _, count in ipairs { 1, 2 } do
    local run, model = resting({}, { count, 3 })
    local found = check.warnings(run, uneven)
    check.equal(#found, 1)
    check.within("area", model:contact_resultant("touch").area, 2, 1e-9)
    local distance, approach = found[1]:match "points lie (%S+) from .- approach each other by (%S+):"
    check.holds(found[1], "at the end of stage 'stage 1': contacts.touch", "Hint: use smaller elements")
    check.at_most("approach", tonumber(approach), 0.02)
    check.at_most("distance", tonumber(distance), 0.25) -- the arc's height over half of the face
    assert(tonumber(distance) > tonumber(approach))
  end
  for _, how in ipairs { {}, { enforcement = "multipliers" },
                         { enforcement = "multipliers", multipliers = "reduced" } } do
    local run, model = resting({ enforcement = how.enforcement, multipliers = how.multipliers }, { 32, 6 })
    check.equal(check.warnings(run, uneven), {})
    check.within_share("area", model:contact_resultant("touch").area, expected, 0.05)
  end
end)

check.case("multipliers decide point by point, also on elements wider than the contact, which is reported", function()
  for _, space in ipairs { "equal", "reduced" } do
    for _, count in ipairs { 1, 2 } do
      local run, model = resting({ enforcement = "multipliers", multipliers = space }, { count, 3 })
      check.equal(#check.warnings(run, "the zone of contact around the largest pressure"), 1)
      check.at_most("area", model:contact_resultant("touch").area, 1)
    end
  end
end)

check.case("a stage that lowers the penalty is reported", function()
  local run, model = pressed({}, { 2, 2 }, "N2")
  check.equal(run.warnings, {})
  local lowered = model:run{ { name = "lower", steps = 1, lid = -0.01, contacts = { floor = { penalty = 2 } } } }
  check.holds(check.warnings(lowered, soft)[1], "at the end of stage 'lower'", "33.3 %")
end)

check.case("the default penalty is right to 1 % of Hertz's force, and does not give rise to its warning", function()
  local run = cylinder({}, 0.06)
  local exact = cylinder({ method = "mortar", enforcement = "multipliers" }, 0.06)
  check.within_share("force", run:column("push.fy")[2], exact:column("push.fy")[2], 0.01)
  check.equal(check.warnings(run, soft), {})
  check.equal(check.warnings(cylinder({}, 0.0005), soft), {}) -- less than an element wide
end)

check.case("the penalty of bonds is optional, too, and the stiffness of bilinear ones by default", function()
  local function block(y)
    return scenes.body{ size = {2, 1}, corner = {0, y}, elements = {8, 2}, contact = y < 0 and "north" or "south",
      material = sg.linear_elastic{ E = 100, nu = 0 } }
  end
  local lower, upper = block(-1), block(0)
  local model = scenes.model{ bodies = { lower = lower, upper = upper },
    supports = { bed = { on = "lower.south", fix = "xy" }, grip = { on = "upper.north", drive = "y" } },
    contacts = { seam = { slave = "upper.south", master = "lower.north",
                          cohesive = { strength = 2, energy = 0.5, law = "bilinear" } } } }
  local law = model:contact_law "seam"
  check.near({ law.penalty, law.stiffness }, { 30 * 100 * 4, 30 * 100 * 4 }, 1e-9)
  local run = model:run{ { steps = 1, grip = 0.01 } }
  check.equal(run.warnings, {})
  check.near(run:column("grip.fy")[1], 0.01 * 2 / (2 / 100 + 1 / law.stiffness), 1e-9) -- bodies and bonds in a row
end)

-- A slide of 0.5 exceeds the elastic deformation by far: full friction.
check.case("friction.penalty is optional; a soft one, with which points stick, is reported", function()
  local function drag(contact)
    local run = cylinder(contact, 0.06, false, 0.5)
    return run, math.abs(run:column("push.fx")[run.rows] / run:column("push.fy")[run.rows])
  end
  local run, ratio = drag{ friction = { mu = 0.2 } }
  check.near(ratio, 0.2, 0.004)
  check.equal(check.warnings(run, loose), {})
  for _, penalty in ipairs { 1e-12, 3e-4 } do
    run, ratio = drag{ friction = { mu = 0.2, penalty = penalty } }
    assert(ratio < 0.1)
    check.equal(#check.warnings(run, loose), 1)
    local given = tonumber(check.warnings(run, loose)[1]:match "friction.penalty = (%S+)$")
    run, ratio = drag{ friction = { mu = 0.2, penalty = given } }
    check.near(ratio, 0.2, 0.004)
    check.equal(check.warnings(run, loose), {})
  end
end)

check.case("scripts/studies/contact_width.lua: the widths behind the warning", function()
  local study = assert(loadfile(core.home .. "/scripts/studies/contact_width.lua"))("orders=N2,N2-N2.2",
    "penalties=30,100",    "formulations=gpts", "problems=line", "depths=12")
  local widths = {}
  for _, row in ipairs(study.rows) do widths[#widths + 1] = row[5] end
  check.at_most("N2, 30", widths[1], 7)
  assert(widths[2] > 7, "N2 with 100 E/h needs more")
  check.at_most("N2, 100", widths[2], 7 * math.sqrt(100 / 30))
  check.at_most("N2-N2.2, 100", widths[4], 7 / 3 * math.sqrt(100 / 30))
end)
