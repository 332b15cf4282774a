-- Sets of faces in contact with each other (among): the same as contacts of pairs of faces, a fold as its half, bodies
-- that cannot touch, all faces with all and with obstacles, corners, wear and adhesion, shapes that overlap themselves,
-- results, saved models.

require "check"
local show = require "signorini.prompt.show"

local last = check.last
local function solved(model, stages, options) return check.completed(model:run(stages, options)) end

local soft = sg.neo_hookean { E = 100, nu = 0.3 }

local function block(corner, width, elements, material)
  return sg.body { patch = sg.shapes.rectangle { width = width, height = 1, corner = corner }, elements = elements,
                   order = "N2", material = material or soft }
end

-- ── Pairs of faces ───────────────────────────────────────────────────────────────────────────────────────────────────

local path = { { name = "press", steps = 4, grip = { 0, -0.1 } }, { name = "slide", steps = 6, grip = { 0.3, -0.1 } } }

--- Two blocks, the upper one narrower, with contacts made of their faces.
local function stacked(contacts)
  local lower, upper = block({ 0, 0 }, 2, { 6, 2 }), block({ 0.3, 1 }, 1.3, { 5, 2 })
  return sg.model { bodies = { lower = lower, upper = upper },
                    supports = { bed = { on = lower:face "south", fix = "xy" },
                                 grip = { on = upper:face "north", drive = "xy" } },
                    contacts = contacts(upper:face "south", lower:face "north") }
end

local function law(penalty, more)
  local values = { penalty = penalty, friction = { mu = 0.3, penalty = penalty } }
  for key, value in pairs(more) do values[key] = value end
  return values
end

check.case("two separate faces are two contacts with half the penalty, or two half passes", function()
  local set = solved(stacked(function(a, b) return { c = law(1000, { among = { a, b } }) } end), path)
  local pairs_of_faces = stacked(function(a, b)
    return { c = law(500, { slave = a, master = b }), d = law(500, { slave = b, master = a }) }
  end)
  local both = solved(pairs_of_faces, path)
  for _, column in ipairs { "grip.fx", "grip.fy" } do
    check.within(column, last(set, column), last(both, column), 1e-12)
  end
  local half = solved(stacked(function(a, b)
    return { c = law(1000, { among = { a, b }, method = "half_passes" }) }
  end), path)
  local passes = solved(stacked(function(a, b)
    return { c = law(1000, { slave = a, master = b, method = "half_passes" }) }
  end), path)
  for _, column in ipairs { "grip.fx", "grip.fy" } do
    check.within("half " .. column, last(half, column), last(passes, column), 1e-12)
  end
  -- Action is reaction: the upper block receives what the grip does not hold.
  check.within("force on the lower block", last(set, "c.lower_upper.fy"), last(set, "grip.fy"), 1e-9)
  check.equal(set:column "c.area"[10] > 1, true)
  check.equal(half.model:contact_resultant("c").imbalance > 0, true)
  check.at_most("imbalance", half.model:contact_resultant("c").imbalance, 0.2)
end)

check.case("the order of the list and the direction of a patch do not matter", function()
  local function pressed(order, reversed)
    local patch = sg.shapes.rectangle { width = 1.3, height = 1, corner = { 0.3, 1 } }
    if reversed then patch = patch:reverse(1):reverse(2) end
    local south, north, west, east = "south", "north", "west", "east"
    if reversed then south, north, west, east = north, south, east, west end
    local lower, upper = block({ 0, 0 }, 2, { 6, 2 }), sg.body { patch = patch, elements = { 5, 2 }, order = "N2",
                                                               material = soft }
    local faces = { upper:face(south), lower:face "north", upper:face(west), upper:face(east) }
    local list = {}
    for i, k in ipairs(order) do list[i] = faces[k] end
    local model = sg.model { bodies = { lower = lower, upper = upper },
                             supports = { bed = { on = lower:face "south", fix = "xy" },
                                          grip = { on = upper:face(north), drive = "xy" } },
                             contacts = { c = law(1000, { among = list }) } }
    return solved(model, path, { newton = { tolerance = 1e-12 } })
  end
  local one = pressed { 1, 2, 3, 4 }
  for _, other in ipairs { pressed { 4, 2, 1, 3 }, pressed({ 1, 2, 3, 4 }, true) } do
    for _, column in ipairs { "grip.fx", "grip.fy" } do
      check.within(column, last(other, column), last(one, column), 1e-9)
    end
  end
end)

-- ── One body ─────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The right half of a ring between two plates, of which the inner face touches itself, or its upper half with the
--- mirror plane in place of the lower one.
local function flattened(penalty, half)
  local patch = sg.shapes.quarter_annulus { inner = 8, outer = 10, start = 0 }
  if not half then patch = sg.shapes.half_annulus { inner = 8, outer = 10 }:rotate { angle = 90 } end
  local ring = sg.body { patch = patch, elements = { half and 16 or 32, 2 }, order = "N2", material = soft }
  local inner, outer = ring:face "north", ring:face "south"
  local plate = sg.rigid.plane { point = { 0, 10 }, normal = { 0, -1 } }
  local bed = sg.rigid.plane { point = { 0, -10 }, normal = { 0, 1 } }
  local supports = { plate = { on = plate, drive = "y", fix = "x" } }
  local contacts = { upper = { slave = outer, master = plate, penalty = penalty } }
  local stage = { name = "flatten", steps = 40, plate = { -8.3 } }
  if half then
    supports.axis, supports.mirror = { on = ring:face "east", fix = "x" }, { on = ring:face "west", fix = "y" }
    local mirror = sg.rigid.plane { point = { 0, 0 }, normal = { 0, 1 } }
    contacts.fold = { slave = inner, master = mirror, penalty = 2 * penalty }
  else
    supports.axis = { on = { ring:face "east", ring:face "west" }, fix = "x" }
    supports.bed = { on = bed, drive = "y", fix = "x" }
    contacts.lower = { slave = outer, master = bed, penalty = penalty }
    contacts.fold = { among = inner, penalty = penalty }
    stage.bed = { 8.3 }
  end
  return sg.model { bodies = { ring = ring }, supports = supports, contacts = contacts }, { stage }
end

check.case("a fold equals its half against the mirror plane, the more the higher the penalty", function()
  local function difference(penalty)
    local model, stages = flattened(penalty)
    local whole = last(solved(model, stages), "plate.fy")
    local other, half_stages = flattened(penalty, true)
    return math.abs(whole / last(solved(other, half_stages), "plate.fy") - 1)
  end
  local coarse, fine = difference(1e3), difference(1e4)
  check.at_most("difference", coarse, 1e-6)
  check.at_most("difference at a higher penalty", fine, 1e-8)
  check.equal(coarse / fine > 5, true)
end)

check.case("a body that cannot touch itself: the path without contact", function()
  local function bent(contacts)
    local bar = block({ 0, 0 }, 10, { 20, 2 })
    local model = sg.model { bodies = { bar = bar }, contacts = contacts and contacts(bar),
                             supports = { a = { on = bar:face "west", fix = "xy" },
                                          b = { on = bar:face "east", drive = "xy" } } }
    return solved(model, { { name = "bend", steps = 10, b = { -1, 5 } } })
  end
  local free = bent(function(bar)
    return { far = { slave = bar:face "south", master = sg.rigid.plane { point = { 0, -50 }, normal = { 0, 1 } } } }
  end)
  local all = bent(function() return { all = { among = "all" } } end)
  check.equal(all.iterations, free.iterations)
  for _, column in ipairs { "b.fx", "b.fy" } do check.equal(last(all, column), last(free, column)) end
  check.within("force without a contact", last(all, "b.fy"), last(bent(), "b.fy"), 1e-9)
  check.equal(#check.warnings(all, "never touched"), 1)
  local gap = all.model:profile("all").gap
  check.equal(gap[1] ~= gap[1], true) -- nan: nothing is opposite
end)

check.case("so does a bent block in space, whose faces meet at edges", function()
  local function bent(all)
    local bar = sg.body { patch = sg.shapes.block { size = { 5, 1, 1 } }, elements = { 7, 2, 2 }, order = "N2",
                          material = soft }
    local far = sg.rigid.plane { point = { 0, 0, -100 }, normal = { 0, 0, 1 } }
    local contact = all and { among = "all" } or { slave = bar:face "front", master = far }
    local model = sg.model { bodies = { bar = bar }, contacts = { c = contact },
                             supports = { a = { on = bar:face "west", fix = "xyz" },
                                          b = { on = bar:face "east", drive = "xz" } } }
    return solved(model, { { name = "bend", steps = 3, b = { -0.5, 2 } } })
  end
  local free, all = bent(false), bent(true)
  check.equal(all.iterations, free.iterations)
  for _, column in ipairs { "b.fx", "b.fz" } do check.equal(last(all, column), last(free, column)) end
  check.equal(check.warnings(all, "never touched"), { "contact 'c' never touched" })
end)

-- ── All with all ─────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("all faces with all: blocks of equal width as contacts of pairs of faces", function()
  local function tower(contacts)
    local upright = sg.neo_hookean { E = 100, nu = 0 } -- with equal widths in all states
    local a, b, c = block({ 0, 0 }, 1, { 4, 2 }, upright), block({ 0, 1 }, 1, { 3, 2 }, upright),
      block({ 0, 2 }, 1, { 5, 2 }, upright)
    local model = sg.model { bodies = { a = a, b = b, c = c }, contacts = contacts(a, b, c),
                             supports = { bed = { on = a:face "south", fix = "y" },
                                          side = { on = { a:face "west", b:face "west", c:face "west" }, fix = "x" },
                                          grip = { on = c:face "north", drive = "y" } } }
    return solved(model, { { name = "press", steps = 2, grip = { -0.3 } } })
  end
  -- Penetrations are less than the distance of the last contact points from the corners, where the nearest face would
  -- be a side.
  local all = tower(function() return { all = { among = "all", penalty = 1e5 } } end)
  local pairwise = tower(function(a, b, c)
    local function contact(slave, master) return { slave = slave, master = master, penalty = 5e4 } end
    return { ab = contact(a:face "north", b:face "south"), ba = contact(b:face "south", a:face "north"),
             bc = contact(b:face "north", c:face "south"), cb = contact(c:face "south", b:face "north") }
  end)
  check.within("force", last(all, "grip.fy"), last(pairwise, "grip.fy"), 1e-12)
  check.within("lower contact", last(all, "all.a_b.fy"), last(all, "grip.fy"), 1e-10)
  check.within("upper contact", last(all, "all.b_c.fy"), last(all, "grip.fy"), 1e-10)
  check.equal(last(all, "all.a_c.fy"), 0)
end)

check.case("all faces with all: obstacles, joined faces", function()
  local left, right = block({ 0, 0 }, 1, { 2, 2 }), block({ 1, 0 }, 1, { 2, 2 })
  local floor = sg.rigid.plane { point = { 0, 0 }, normal = { 0, 1 } }
  local model = sg.model { bodies = { left = left, right = right },
                           joins = { seam = { left:face "east", right:face "west" } },
                           supports = { grip = { on = { left:face "north", right:face "north" }, drive = "xy" },
                                        floor = { on = floor, fix = "xy" } },
                           contacts = { all = { among = "all", friction = { mu = 0.5 } } } }
  check.equal(model:contact_names(), { "all", "all.floor" })
  local run = solved(model, { { name = "press", steps = 2, grip = { 0.02, -0.1 } } })
  check.within("force", last(run, "all.floor.fy"), -last(run, "grip.fy"), 1e-10)
  check.equal(last(run, "all.area"), 0)
end)

check.case("pairs that do not touch, or have constants of their own", function()
  --- Three blocks in a column, pressed and dragged by the uppermost, on a plane.
  local function column(more)
    local a, b, c = block({ 0, 0 }, 1.2, { 4, 2 }), block({ 0.1, 1 }, 1, { 3, 2 }), block({ 0.2, 2 }, 0.8, { 3, 2 })
    local floor = sg.rigid.plane { point = { 0, 0 }, normal = { 0, 1 } }
    local contact = law(1000, { among = "all" })
    for key, value in pairs(more(a, b, c, floor)) do contact[key] = value end
    local model = sg.model { bodies = { a = a, b = b, c = c }, contacts = { all = contact },
                             supports = { floor = { on = floor, fix = "xy" },
                                          side = { on = { a:face "west", b:face "west" }, fix = "x" },
                                          grip = { on = c:face "north", drive = "xy" } } }
    return model, solved(model, { { name = "press", steps = 2, grip = { 0, -0.1 } },
                                  { name = "drag", steps = 3, grip = { 0.1, -0.1 } } })
  end
  local _, plain = column(function() return {} end)
  local fx, fy = last(plain, "grip.fx"), last(plain, "grip.fy")
  check.within("slides", -last(plain, "all.b_c.fx"), 0.3 * last(plain, "all.b_c.fy"), 0.3)

  local model, split = column(function(_, b, c)
    return { pairs = { joint = { between = { b, c }, friction = { mu = 0.3, penalty = 1000 } } } }
  end)
  check.equal(model:contact_names(), { "all.joint", "all", "all.floor" })
  check.within("the same law in a contact of its own", last(split, "grip.fx"), fx, 1e-10)
  check.within("the same law in a contact of its own", last(split, "grip.fy"), fy, 1e-10)
  check.within("its force", last(split, "all.joint.b_c.fy"), last(plain, "all.b_c.fy"), 1e-9)
  check.equal(last(split, "all.b_c.fy"), 0)
  local again = check.reloaded(model)
  check.equal(#again:warnings(), #model:warnings())
  local further = { { name = "more", steps = 1, grip = { 0.12, -0.1 } } }
  check.equal(last(solved(again, further), "grip.fx"), last(solved(model, further), "grip.fx"))

  local _, smooth = column(function(_, b, c)
    return { pairs = { joint = { between = { b:face "north", { c:face "south" } }, friction = { mu = 0 } } } }
  end)
  check.within("without friction", last(smooth, "all.joint.b_c.fx") / fy, 0, 0.03)
  local slippery, held = column(function(a, _, _, floor)
    return { pairs = { bed = { between = { floor, a }, penalty = 500 } } }
  end)
  check.equal(slippery:contact_names(), { "all.bed", "all", "all.floor" })
  check.within("on the floor", last(held, "all.bed.fy"), -last(held, "grip.fy"), 1e-9)

  -- Without contact the uppermost block moves freely into the one below, whose sides it does not touch, either.
  for _, upper in ipairs { "body", "face" } do
    local _, free = column(function(a, b, c)
      return { except = { { { a, b }, c }, { a, upper == "body" and b or { b:face "south" } } } }
    end)
    check.at_most("force", math.abs(last(free, "grip.fy")), 1e-9)
  end
end)

check.case("any list of faces against an obstacle", function()
  local foot = block({ 0, 0 }, 1, { 3, 2 })
  local model = sg.model { bodies = { foot = foot },
                           supports = { grip = { on = foot:face "north", drive = "xy" } },
                           contacts = { floor = { slave = { foot:face "south", foot:face "north" }, penalty = 100,
                                                  master = sg.rigid.plane { point = { 0, 0 }, normal = { 0, 1 } } } } }
  local run = solved(model, { { name = "press", steps = 2, grip = { 0, -0.1 } } })
  check.within("force", last(run, "floor.fy"), -last(run, "grip.fy"), 1e-10)
  check.within("area", last(run, "floor.area"), 1, 0.2)
end)

--- A block is pressed over the edge of a slab, so that corners carry load.
check.case("a corner with its two sides", function()
  local lower, upper = block({ 0, 0 }, 2, { 8, 3 }), block({ 1.3, 1 }, 1.5, { 6, 3 })
  local model = sg.model { bodies = { lower = lower, upper = upper },
                           supports = { bed = { on = lower:face "south", fix = "xy" },
                                        grip = { on = upper:face "north", drive = "xy" } },
                           contacts = { all = law(1000, { among = "all" }) } }
  local run = solved(model, { { name = "press", steps = 4, grip = { 0, -0.15 } },
                              { name = "pull", steps = 12, grip = { 1, -0.15 } } })
  check.equal(last(run, "all.area"), 0)
  check.at_most("force after the end", last(run, "grip.fy"), 1e-9)
  check.equal(run.cutbacks, 0)
end)

--- The corner of a soft block becomes a sharp edge, whose flanks do not touch each other.
check.case("a sharp corner has no contact with itself", function()
  local body = sg.body { patch = sg.shapes.rectangle { width = 1, height = 1 }, elements = { 2, 2 }, order = "N2",
                         material = soft }
  local model = sg.model { bodies = { body = body }, contacts = { all = { among = "all", penalty = 1000 } },
                           supports = { bed = { on = body:face "south", fix = "xy" },
                                        grip = { on = body:face "north", drive = "xy" } } }
  local run = solved(model, { { name = "shear", steps = 10, grip = { 6, 0 } } })
  for i, area in ipairs(run:column "all.area") do check.equal(area, 0, ("step %d"):format(i)) end
end)

--- A strip under a falling block: whatever the steps, nothing passes through anything.
check.case("a step in which bodies pass through each other is cut", function()
  local strip = sg.body { patch = sg.shapes.rectangle { width = 3, height = 0.1 }, elements = { 12, 1 }, order = "N2",
                          material = soft }
  local hammer = sg.body { patch = sg.shapes.rectangle { width = 0.4, height = 0.4, corner = { 1.3, 0.15 } },
                           elements = { 2, 2 }, order = "N2", material = soft }
  local model = sg.model { bodies = { strip = strip, hammer = hammer }, contacts = { all = { among = "all" } },
                           supports = { ends = { on = { strip:face "west", strip:face "east" }, fix = "xy" },
                                        grip = { on = hammer:face "north", drive = "xy" } } }
  local run = solved(model, { { name = "fall", steps = 1, grip = { 0, -0.8 } } })
  check.equal(run.cutbacks > 0, true)
  local crossed = 0
  for _, attempt in ipairs(run:attempts(1)) do
    if attempt.reason == "crossed" then
      crossed = crossed + 1
      check.equal(#attempt.residuals, 1) -- after the solution that applies the displacements
    end
  end
  check.equal(crossed > 0, true)
  check.equal(last(run, "grip.fy") < 0, true)
  check.within("force on the strip", last(run, "all.hammer_strip.fy"), -last(run, "grip.fy"), 1e-8)
end)

--- A coil whose layers overlap by half of the thickness, or lie apart.
check.case("shapes that overlap themselves", function()
  local function coil(pitch)
    local function spiral(radius)
      local points = {}
      for i = 0, 20 do
        local angle = math.rad(30 * i)
        local r = radius + pitch * i / 12
        points[#points + 1] = { r * math.cos(angle), r * math.sin(angle) }
      end
      return points
    end
    local knots = { 0, 0, 0 }
    for i = 1, 18 do knots[#knots + 1] = i / 19 end
    for _ = 1, 3 do knots[#knots + 1] = 1 end
    local function curve(radius) return sg.nurbs.curve { degree = 2, knots = knots, points = spiral(radius) } end
    local body = sg.body { patch = sg.nurbs.ruled { a = curve(3.2), b = curve(3) }, elements = { 19, 1 }, order = "N2",
                           material = soft }
    return sg.model { bodies = { coil = body }, supports = { bed = { on = body:face "west", fix = "xy" } },
                      contacts = { all = { among = "all" } } }
  end
  local apart, overlapping = coil(0.4), coil(0.1)
  check.equal(apart:warnings(), {})
  check.equal(#overlapping:warnings(), 1)
  check.holds(overlapping:warnings()[1], "of body 'coil' lies 0.12", "overlaps itself before the first step",
    "contacts.all")
  for _, model in ipairs { apart, overlapping } do check.equal(model:contact_resultant "all".active, 0) end
end)

check.case("wear and adhesion of a set are those of two faces", function()
  local function dragged(set, keys)
    local lower, upper = block({ -0.5, -1 }, 2, { 8, 3 }), block({ 0.2, 0 }, 0.6, { 3, 4 })
    local one, other = upper:face "south", lower:face "north"
    local law = lists.merged(keys, set and { among = { one, other } } or { slave = one, master = other })
    local model = sg.model { bodies = { lower = lower, upper = upper }, contacts = { touch = law },
                             supports = { bed = { on = lower:face "south", fix = "xy" },
                                          grip = { on = upper:face "north", drive = "xy" } } }
    return solved(model, { { steps = 2, grip = { 0, -0.02 } }, { steps = 6, grip = { 0.1, -0.02 } } })
  end
  local worn = { penalty = 50, friction = { mu = 0.2, penalty = 50 }, wear = { rate = 0.002 } }
  local pair, set = dragged(false, worn), dragged(true, worn)
  check.within_share("worn volume", last(set, "touch.worn_volume"), last(pair, "touch.worn_volume"), 0.05)
  local sticky = { adhesion = { hamaker = 1e-6, r0 = 1e-2 } }
  pair, set = dragged(false, sticky), dragged(true, sticky)
  check.within_share("force", last(set, "grip.fy"), last(pair, "grip.fy"), 0.05)
end)

-- ── Results ──────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("results, saved models", function()
  local model, stages = flattened(1e3)
  solved(model, stages)
  local now = model:contact_resultant "fold"
  check.equal(now.pairs, {})
  check.equal(rawget(now, "fx"), nil)
  check.holds(show.text(model), "contact fold: ", "forces within the body, largest pressure")
  local profile = model:profile "fold"
  for i, gap in ipairs(profile.gap) do
    if profile.pressure[i] > 0 then check.equal(gap < 0, true) end
  end
  check.equal(profile.face[1], "ring.north")
  local again = check.reloaded(model)
  check.equal(again:contact_resultant("fold").area, now.area)
  local further = { { name = "more", steps = 2, plate = { -8.4 }, bed = { 8.4 } } }
  check.equal(last(solved(again, further), "plate.fy"), last(solved(model, further), "plate.fy"))
end)

check.case("contacts of the same faces are counted twice", function()
  local slab = block({ 0, 0 }, 2, { 2, 1 })
  local floor = sg.rigid.plane { point = { 0, 0 }, normal = { 0, 1 } }
  local function warnings(contacts)
    return #lists.filter(sg.model { bodies = { slab = slab }, contacts = contacts,
                                    supports = { floor = { on = floor, fix = "xy" } } }:warnings(), function(text)
      return text:find("counted twice", 1, true) ~= nil
    end)
  end
  local north, south = slab:face "north", slab:face "south"
  check.equal(warnings { a = { among = north }, b = { among = { north, south } } }, 1)
  check.equal(warnings { a = { among = north }, b = { among = south } }, 0)
  check.equal(warnings { all = { among = "all" }, bed = { slave = south, master = floor } }, 1)
end)
