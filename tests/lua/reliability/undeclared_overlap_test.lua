-- Bodies that pass through each other, through themselves or through obstacles where no contact is declared, and scenes
-- whose bodies touch as declared, without a warning.

require "check"

local function box(width, height, x, y, elements)
  return scenes.body{ size = {width, height}, corner = { x, y }, elements = elements or { 4, 2 } }
end

local function cube(size, corner) return scenes.body{ size = size, corner = corner } end

--- The only warning of a run.
local function only(run)
  check.equal({ run.reason, #run.warnings }, { "completed", 1 })
  return run.warnings[1]
end

--- A run without a warning about overlaps.
local function silent(run)
  check.equal(run.reason, "completed")
  local all = table.concat(run.warnings, "\n")
  if all:find(" behind ", 1, true) or all:find("lies inside", 1, true) then error(all, 2) end
end

--- Depth and place in a warning.
local function found(warning)
  local depth, place = warning:match "lies ([%d.e-]+) behind .- at (%b())"
  depth = depth or warning:match ", ([%d.e-]+) behind"
  local at = {}
  for x in (place or warning:match "at (%b())"):gmatch "[%d.e-]+" do at[#at + 1] = tonumber(x) end
  return tonumber(depth), at
end

-- ── Warnings ─────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("a contact that was forgotten", function()
  local low, up = box(2, 1, 0, 0), box(1, 1, 0.5, 1)
  local supports = { bed = { on = low:face "south", fix = "xy" }, lid = { on = up:face "north", drive = "xy" } }
  local warning = only(sg.model{ bodies = { low = low, up = up }, supports = supports }:run{
    { steps = 1, lid = { 0, -0.3 } } })
  check.holds(warning, "lies 0.3 behind", "face 'south' of body 'up'", "face 'north' of body 'low'", "define a contact")
  local contact = { slave = up:face "east", master = low:face "north", penalty = 100 } -- the wrong face
  local model = sg.model{ bodies = { low = low, up = up }, supports = supports, contacts = { k = contact } }
  check.holds(table.concat(model:run({ { steps = 1, lid = { 0, -0.3 } } }).warnings, "\n"),
    "face 'south' of body 'up' lies 0.", "behind face 'north' of body 'low'", "add the faces to contacts.k")
end)

check.case("a third body in the way", function()
  local low, up, post = box(2, 1, 0, 0), box(1, 1, 0.5, 1), box(1, 3, 2.2, 0, { 2, 4 })
  local model = scenes.model{ bodies = { low = low, up = up, post = post },
    supports = { bed = { on = { "low.south", "post.south" }, fix = "xy" }, lid = { on = "up.north", drive = "xy" } },
    contacts = { k = { slave = "up.south", master = "low.north", penalty = 100 } } }
  local run = model:run{ { steps = 2, lid = { 0, -0.02 } }, { name = "slide", steps = 6, lid = { 1, -0.02 } } }
  local depth, at = found(run.warnings[1])
  check.holds(run.warnings[1], "at the end of stage 'slide'", "of body 'up'", "of body 'post'")
  check.within("depth", depth, 0.3, 0.01) -- 0.7 of the way is free
  check.within("x", at[1], 2.5, 0.01)
end)

check.case("two blocks in space, and a floor", function()
  local low, up = cube({ 2, 2, 1 }, { 0, 0, 0 }), cube({ 1, 1, 1 }, { 0.5, 0.5, 1 })
  local supports = { bed = { on = low:face "front", fix = "xyz" }, lid = { on = up:face "back", drive = "xyz" } }
  local warning = only(sg.model{ bodies = { low = low, up = up }, supports = supports }:run{
    { steps = 1, lid = { 0, 0, -0.2 } } })
  check.holds(warning, "lies 0.2 behind", "face 'front' of body 'up'", "face 'back' of body 'low'")
  local floor, side = sg.rigid.plane{ point = { 0, 0, 0 }, normal = { 0, 0, 1 } }, cube({ 1, 1, 1 }, { 3, 0, 0.3 })
  local model = scenes.model{ bodies = { low = low, side = side },
    supports = { bed = { on = "low.back", fix = "xyz" }, lid = { on = "side.back", drive = "xyz" } },
    contacts = { k = { slave = "low.front", master = floor, penalty = 100 } } }
  check.holds(table.concat(model:run({ { steps = 1, lid = { 0, 0, -0.5 } } }).warnings, "\n"),
    "face 'front' of body 'side' lies 0.2 behind the obstacle of contacts.k, whose slave it is not, at (", ", -0.2)")
end)

for name, floor in pairs{ plane = scenes.floor(-1),
                          line = sg.rigid.surface(sg.nurbs.line{ from = { 9, -1 }, to = { -9, -1 } }) } do
  check.case("a beam passes through the floor on which its foot stands: " .. name, function()
    local beam, foot = box(4, 1, 0, 0, { 8, 4 }), box(1, 1, 0, -1, { 2, 4 })
    local model = scenes.model{ bodies = { beam = beam, foot = foot },
      ties = { t = { slave = "foot.north", master = "beam.south" } },
      supports = { push = { on = "beam.east", drive = "y", fix = "x" } },
      contacts = { k = { slave = "foot.south", master = floor, penalty = 100,
                         friction = { mu = 0.5, penalty = 100 } } } }
    local warnings = table.concat(model:run({ { steps = 10, push = { -2.5 } } }).warnings, "\n")
    check.holds(warnings, "Hint: add it to the slave",
      "of body 'beam' lies 1.5 behind the obstacle of contacts.k, whose slave it is not, at (4, -2.5)")
  end)
end

--- How often a face at xi2 crosses itself, as a line of 200 pieces.
local function crossings(model, body, patch, xi2)
  local at, count = {}, 0
  for i = 0, 200 do
    local X, xi = patch{ i / 200, xi2 }, { i / 200, xi2 }
    at[i] = { X[1] + model:sample(body, "ux", xi), X[2] + model:sample(body, "uy", xi) }
  end
  local function side(a, b, c) return (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]) < 0 end
  for i = 0, 197 do
    for j = i + 2, 199 do
      local a, b, c, d = at[i], at[i + 1], at[j], at[j + 1]
      if side(a, b, c) ~= side(a, b, d) and side(c, d, a) ~= side(c, d, b) then count = count + 1 end
    end
  end
  return count
end

check.case("a ring that is crushed passes through itself", function()
  local patch = sg.shapes.ring{ inner = 8, outer = 10 }
  local top = scenes.ceiling(10)
  local bottom = scenes.floor(-10)
  local model = scenes.model{ bodies = { ring = { patch = patch, elements = { 16, 2 }, contact = "south", E = 5 } },
    supports = { push = { on = top, drive = "y" } }, contacts = { top = { slave = "south", master = top, penalty = 50 },
      bottom = { slave = "south", master = bottom, penalty = 50 } } }
  silent(model:run{ { steps = 8, push = { -8 } } })
  check.equal(crossings(model, "ring", patch, 1), 0)
  local run = model:run{ { steps = 8, push = { -16 } } }
  check.equal(crossings(model, "ring", patch, 1) > 0, true)
  check.holds(table.concat(run.warnings, "\n"), "of body 'ring' lies ", "the body passes through itself",
    "add contact with among")
end)

check.case("an obstacle between contact points", function()
  local slab, needle = box(2, 1, 0, 0, { 8, 4 }), sg.rigid.cylinder{ center = { 1.0003, 1.001 }, radius = 0.001 }
  local model = scenes.model{ bodies = { slab = slab },
    supports = { bed = { on = "south", fix = "xy" }, push = { on = needle, drive = "y" } },
    contacts = { c = { slave = "north", master = needle, penalty = 100 } } }
  check.holds(only(model:run{ { steps = 40, push = -0.3 } }),
    "the obstacle of contacts.c lies inside body 'slab', 0.3 behind face 'north' of body 'slab' at (1.0003",
    "use smaller elements on the slave face")
end)

check.case("a pin between the contact points of a face", function()
  local slab, pin = box(2, 1, 0, 0, { 4, 4 }), box(0.02, 0.5, 1.14, 1.001, { 1, 4 })
  local model = scenes.model{ bodies = { slab = slab, pin = pin },
    supports = { bed = { on = "slab.south", fix = "xy" }, push = { on = "pin.north", drive = "xy" } },
    contacts = { c = { slave = "slab.north", master = "pin.south", penalty = 100, points = 3 } } }
  check.holds(only(model:run{ { steps = 40, push = { 0, -0.3 } } }), "face 'south' of body 'pin' lies 0.29",
    "behind face 'north' of body 'slab' at (1.1", "but no point of contacts.c is active")
end)

-- ── Silence ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Presses a body of a disc's patches, or of a ring, between two planes.
local function pressed(patch, elements, faces)
  local body = scenes.body{ patch = patch, elements = elements }
  local lid = scenes.ceiling(1)
  local bed = scenes.floor(-1)
  local on = faces(body)
  return sg.model{ bodies = { body = body }, supports = { lid = { on = lid, drive = "y" } },
    contacts = { top = { slave = on, master = lid, penalty = 100, friction = { mu = 0.3, penalty = 100 } },
                 bottom = { slave = on, master = bed, penalty = 100, friction = { mu = 0.3, penalty = 100 } } } }
end

check.case("a disc of five patches and the seam of a ring", function()
  silent(pressed(sg.shapes.disc{ radius = 1 }, { 3, 3 }, function(body) return body:face "outer" end):run{
    { steps = 5, lid = -0.2 } })
  silent(pressed(sg.shapes.ring{ inner = 0.6, outer = 1 }, { 16, 2 }, function(body) return body:face "south" end):run{
    { steps = 4, lid = -0.2 } })
end)

check.case("tied blocks that bend", function()
  local low, up = box(2, 0.5, 0, 0, { 5, 2 }), box(1, 0.5, 0.5, 0.5, { 3, 2 })
  silent(scenes.model{ bodies = { low = low, up = up }, ties = { seam = { slave = "up.south", master = "low.north" } },
    supports = { bed = { on = "low.west", fix = "xy" }, lid = { on = "up.east", drive = "xy" } } }:run{
    { steps = 4, lid = { 0.1, 0.3 } } })
end)

check.case("a shrink fit, and an axis of revolution below a sphere", function()
  local shaft, hub = box(1, 2, 0, 0, { 4, 8 }), box(1, 2, 0.96, 0, { 4, 8 })
  silent(scenes.model{ kind = "axisymmetric", bodies = { shaft = shaft, hub = hub },
    supports = { mid = { on = { "shaft.south", "hub.south" }, fix = "y" } },
    contacts = { fit = { slave = "shaft.east", master = "hub.west", penalty = 100,
                         overlap = "interference" } } }:run{ { steps = 2 } })
  local slab, sphere = box(2, 1, 0, 0, { 8, 4 }), sg.rigid.sphere{ center = { 0, 1.5 }, radius = 0.5 }
  silent(scenes.model{ kind = "axisymmetric", bodies = { slab = slab },
      supports = { bed = { on = "south", fix = "xy" }, push = { on = sphere, drive = "y" } },
      contacts = { c = { slave = "north", master = sphere, penalty = 100 } } }:run{ { steps = 4, push = -0.2 } })
end)

check.case("half of a disc at a plane of symmetry, and a hollow cylinder around it", function()
  local disc = sg.rigid.cylinder{ center = { 0, 1.5 }, radius = 0.5 }
  local bore = sg.rigid.cylinder{ center = { 0, 0 }, radius = 1.5, inside = true }
  silent(scenes.model{ bodies = { half = { elements = { 4, 4 } } }, supports = { bed = { on = "south", fix = "xy" },
      middle = { on = "west", fix = "x" }, push = { on = disc, drive = "y" } },
    contacts = { c = { slave = "north", master = disc, penalty = 100 },
      wall = { slave = "east", master = bore, penalty = 100 } } }:run{
    { steps = 5, push = -0.3 } })
end)

check.case("a wide rigid line beyond a slab's sides, and a body below an open line next to another one", function()
  local slab, low = box(2, 1, 0, 0, { 8, 4 }), box(1, 0.5, 3, -1)
  local die = sg.rigid.surface(sg.nurbs.line{ from = { -1, 1 }, to = { 3, 1 } })
  local floor = sg.rigid.surface(sg.nurbs.line{ from = { 2.5, 0 }, to = { -0.5, 0 } })
  silent(scenes.model{ bodies = { slab = slab, low = low }, supports = { push = { on = die, drive = "y" },
      hold = { on = "low.south", drive = "xy" }, side = { on = "slab.west", fix = "x" } },
    contacts = { top = { slave = "slab.north", master = die, penalty = 30 },
      bottom = { slave = "slab.south", master = floor, penalty = 30 } } }:run{
    { steps = 4, push = -0.2, hold = { -1.5, 0 } } })
end)

check.case("ironing with a die wider than the contact", function()
  local model, path = sg.scenes.ironing{ order = "N2", depth = 0.1, distance = 0.2 }
  silent(model:run(path))
end)
