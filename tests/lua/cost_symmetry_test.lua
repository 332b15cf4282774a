-- What model:cost promises of symmetry and revolution, against the halves, quarters and sections that one gets by
-- following it; nothing is promised where one thing stands in the way.

local sg = require "signorini"
local check = require "check"
local scenes = require "cost_scenes"

local soft, stiff = scenes.soft, scenes.stiff
local advice, none, promises, ironing, punch = scenes.advice, scenes.none, scenes.promises, scenes.ironing, scenes.punch

-- ── Mirror symmetry ──────────────────────────────────────────────────────────────────────────────────────────────────

--- The right half of it.
local function half_ironing(label, elements)
  local die = sg.body{ patch = sg.shapes.quarter_annulus{ inner = 0.3, outer = 0.5, centre = { 1.5, 1.5 } },
                       elements = { 3, 2 }, order = label, contact = "south", through = 1, material = stiff }
  local slab = sg.body{ patch = sg.shapes.rectangle{ width = 1.5, height = 1, corner = { 1.5, 0 } },
                        elements = elements or { 4, 3 }, order = label, contact = "north", through = 1,
                        material = soft }
  return sg.model{
    bodies   = { die = die, slab = slab },
    supports = { bed    = { on = slab:face "south", fix = "xy" },
                 grip = { on = die:face "east", drive = "y", fix = "x" },
                 middle = { on = { die:face "west", slab:face "west" }, fix = "x" } },
    contacts = { interface = { slave = die:face "south", master = slab:face "north", penalty = 100,
                               friction = { mu = 0.2, penalty = 100 } } },
  }
end

check.case("half of a symmetric scene has the unknowns that were promised", function()
  for _, label in ipairs { "N2", "N4", "N2-N4", "N2-N2.2", "N2-N3x2", "L1", "L2" } do
    promises(ironing(label), "symmetry", half_ironing(label))
  end
  -- An element that the plane cuts is one in each half.
  promises(ironing("N2-N4", { elements = { 7, 3 } }), "symmetry", half_ironing "N2-N4")
end)

check.case("half a scene takes half of the force", function()
  local forces = {}
  for i, model in ipairs { ironing "N2-N4", half_ironing "N2-N4" } do
    check.equal(model:run({ { steps = 5, grip = { -0.15 } } }).failed, false)
    forces[i] = model:reaction "grip"[2]
  end
  -- The whole is smooth across the plane, the half may have a kink there.
  check.near(forces[1] / forces[2], 2, 0.01)
end)

check.case("no symmetry where one thing stands in its way", function()
  local r = sg.shapes.rectangle{ width = 3, height = 1 }
  local function moved(by, weight)
    local fine = r:refine{ elements = { 2, 1 }, degree = { 2, 1 } }
    local points, weights = fine:points(), fine:weights()
    points[6][2], weights[6] = points[6][2] + by, weight
    return sg.nurbs.surface{ degrees = { 2, 1 }, knots = { fine:knots(1), fine:knots(2) }, points = points,
                             weights = weights }
  end
  promises(ironing("N2", { slab = moved(0, 1), elements = { 8, 3 } }), "symmetry", half_ironing "N2")
  for what, change in pairs {
    point = { slab = moved(1e-6, 1) }, weight = { slab = moved(0, 1.001) }, place = { x = 1.500001 },
    grading = { grading = { { elements = 0.6, length = 0.5, at = "end" }, false } },
    corner = { support = function(_, slab) return { on = slab:corner "north-west", fix = "y" } end },
    driven = { support = function(_, slab) return { on = slab:corner "north-west", drive = "y" } end },
    load = { support = function(_, slab) return { on = slab:face "east", pressure = 0 } end },
    shear = { support = function(die) return { on = die:face "north", traction = { 0.1, 0 } } end },
    where = { where = function(X) return X[1] < 1.6 end },
    obstacle = { contact = function(_, slab)
      return { slave = slab:face "north", master = sg.rigid.cylinder{ centre = { 1.4, 2 }, radius = 1 }, penalty = 1 }
    end },
    slope = { contact = function(_, slab)
      return { slave = slab:face "north", master = sg.rigid.plane{ point = { 1.5, 2 }, normal = { 0.1, -1 } },
               penalty = 1 }
    end },
    side = { contact = function(die, slab)
      return { slave = die:face "east", master = slab:face "north", penalty = 1 }
    end },
  } do
    local ok, message = pcall(function() none(ironing("N2", change), "symmetry") end)
    if not ok then error(what .. ": " .. message) end
  end
end)

check.case("what is symmetric in itself does not stand in the way", function()
  for _, change in ipairs {
    { where = function(X) return math.abs(X[1] - 1.5) < 0.3 end },
    { support = function(die) return { on = die:face "north", traction = { 0, 0.1 } } end },
    { support = function(_, slab) return { on = { slab:face "east", slab:face "west" }, pressure = 0.1 } end },
  } do
    promises(ironing("N2", change), "symmetry", half_ironing "N2")
  end
  for _, shape in ipairs {
    sg.rigid.cylinder{ centre = { 1.5, 2 }, radius = 1 }, sg.rigid.plane{ point = { 9, 1 }, normal = { 0, -1 } },
    sg.rigid.surface(sg.nurbs.line{ from = { -1, 2 }, to = { 4, 2 } }),
  } do
    local model = ironing("N2", { contact = function(_, slab)
      return { slave = slab:face "north", master = shape, penalty = 1 }
    end })
    check.equal({ #advice(model, "symmetry"), model:cost().contacts.interface.rigid, model:cost().obstacles },
      { 1, true, 1 })
  end
  none(ironing("N2", { contact = function(_, slab)
    return { slave = slab:face "north", master = sg.rigid.surface(sg.nurbs.line{ from = { -1.1, 2 }, to = { 4, 2 } }),
             penalty = 1 }
  end }), "symmetry")
end)

check.case("what may move or turns through the plane breaks the symmetry", function()
  for _, hold in ipairs { { drive = "xy" }, { drive = "x", fix = "y" } } do
    local function scene(patch, faces)
      local die = sg.body{ patch = patch { inner = 0.3, outer = 0.5 }, elements = { faces == 2 and 4 or 2, 2 },
                           order = "N2", material = soft }
      local supports = { grip = { drive = hold.drive, fix = hold.fix,
                                  on = faces == 2 and { die:face "west", die:face "east" } or die:face "east" } }
      if faces == 1 then supports.middle = { on = die:face "west", fix = "x" } end
      return sg.model{ bodies = { die = die }, supports = supports }
    end
    local model = scene(sg.shapes.half_annulus, 2)
    none(model, "symmetry")
    check.holds(promises(model, "symmetry if fixed", scene(sg.shapes.quarter_annulus, 1)),
      "mirror image in x = 0 as long as 'grip' is not driven along x: one half")
    check.equal(model:run({ { steps = 1, grip = #hold.drive == 2 and { 0.01, 0 } or { 0.01 } } }).failed, false)
    none(model, "symmetry if fixed")
  end
  local strip = sg.body{ patch = sg.shapes.rectangle{ width = 4, height = 1 }, elements = { 4, 2 }, order = "N2",
                         contact = "south", through = 1, material = soft }
  local model = sg.model{ bodies = { strip = strip },
    supports = { turn = { on = strip:face "east", rotate = true }, wall = { on = strip:face "west", fix = "xy" } } }
  check.equal(model:cost().unknowns, 2 * 4 * 3 + 2) -- two shared by the face that turns
  none(model, "symmetry")
end)

-- ── Solids ───────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("halves and the quarter of a solid scene", function()
  for _, label in ipairs { "N2", "N2-N3" } do
    local model = punch(label, 1, 1)
    check.equal(#advice(model, "symmetry"), 3)
    promises(model, "symmetry", punch(label, 0.5, 1), 1)
    promises(model, "symmetry", punch(label, 1, 0.5), 2)
    check.holds(promises(model, "symmetry", punch(label, 0.5, 0.5), 3),
      "x = 2, y = 2: one quarter of it, with x and y fixed on these planes")
  end
  local function along(direction)
    return function(top)
      return { on = top:face "back", drive = direction .. "z", fix = direction == "x" and "y" or "x" }
    end
  end
  local model = punch("N2", 1, 1, along "x")
  check.equal({ #advice(model, "symmetry"), #advice(model, "symmetry if fixed") }, { 1, 1 })
  check.holds(advice(model, "symmetry")[1].text, "mirror image in y = 2")
  promises(model, "symmetry if fixed", punch("N2", 0.5, 1))
  none(punch("N2", 1, 1, function(top) return { on = top:face "back", drive = "z", fix = "xy", rotate = "z" } end),
    "symmetry")
end)

--- A ring about z of inner radius 1; the turn starts in the plane y = 0.
local function ring(angle)
  local section = sg.nurbs.surface{ degrees = { 1, 1 }, knots = { { 0, 0, 1, 1 }, { 0, 0, 1, 1 } },
                                    points = { { 2, 0, 0 }, { 1, 0, 0 }, { 2, 0, 1 }, { 1, 0, 1 } } }
  return sg.body{ patch = sg.nurbs.revolve{ patch = section, angle = angle }, elements = { 2, 2, angle // 45 },
                  order = "N2", material = soft }
end

check.case("a ring that is cut ends in the plane on both sides", function()
  local whole, half = ring(360), ring(180)
  local model = sg.model{ bodies = { ring = whole }, supports = { bed = { on = whole:face "south", fix = "z" } } }
  check.holds(promises(model, "symmetry", sg.model{ bodies = { ring = half }, supports = {
    bed = { on = half:face "south", fix = "z" }, cut = { on = { half:face "front", half:face "back" }, fix = "y" } } }),
    "mirror image in y = 0")
end)

-- ── Bodies of revolution ─────────────────────────────────────────────────────────────────────────────────────────────

--- An octant of a ball on a floor; `change` holds what differs.
local function octant(label, change)
  change = change or {}
  local ball = sg.body{ patch = change.patch or sg.shapes.sphere_octant{ inner = 0.5, outer = 1, centre = { 3, 2, 0 } },
                        elements = { 3, 4, 2 }, order = label, contact = "front", through = 1, material = soft }
  return sg.model{
    bodies   = { ball = ball },
    loads    = { wind = change.traction and { on = ball:face "back", traction = change.traction } },
    supports = { top = { on = ball:face "south", drive = change.drive or "z", fix = change.fix },
                 y = { on = ball:face(change.y or "west"), fix = "y" },
                 x = not change.free and { on = ball:face(change.x or "east"), fix = "x" } or nil },
    contacts = { floor = { slave = ball:face "front", penalty = 100, where = change.where,
                           master = change.master or sg.rigid.plane{ point = { 0, 0, -1 }, normal = { 0, 0, 1 } } } },
  }
end

local function section(label)
  local ball = sg.body{ patch = sg.shapes.quarter_annulus{ inner = 0.5, outer = 1 }, elements = { 4, 2 }, order = label,
                        contact = "south", through = 1, material = soft }
  return sg.model{
    kind = "axisymmetric", bodies = { ball = ball },
    supports = { top = { on = ball:face "east", drive = "y" }, axis = { on = ball:face "west", fix = "x" } },
    contacts = { floor = { slave = ball:face "south", penalty = 100,
                           master = sg.rigid.plane{ point = { 0, -1 }, normal = { 0, 1 } } } },
  }
end

check.case("the section of a ball's octant has the unknowns that were promised", function()
  for _, label in ipairs { "N2", "N3", "N2.1" } do
    check.holds(promises(octant(label), "axisymmetry", section(label)), "parallel to z through (3, 2, 0)")
  end
  promises(octant("N2", { traction = { 0, 0, 1 } }), "axisymmetry", section "N2")
  promises(octant("N2", { master = sg.rigid.sphere{ centre = { 3, 2, -2 }, radius = 1 } }), "axisymmetry", section "N2")
end)

check.case("no axis where one thing stands in its way", function()
  local octant_patch = sg.shapes.sphere_octant{ inner = 0.5, outer = 1, centre = { 3, 2, 0 } }
  local points = octant_patch:points()
  points[#points // 2][1] = points[#points // 2][1] + 1e-5
  local degrees = octant_patch:degrees()
  local bent = sg.nurbs.volume{ degrees = degrees, points = points, weights = octant_patch:weights(),
    knots = { octant_patch:knots(1), octant_patch:knots(2), octant_patch:knots(3) } }
  for what, change in pairs {
    point = { patch = bent }, free = { free = true }, sideways = { fix = "x" },
    drive = { drive = "xz", fix = "y", free = true },
    where = { where = function(X) return X[3] < -0.5 end }, load = { traction = { 0.1, 0, 1 } },
    slope = { master = sg.rigid.plane{ point = { 0, 0, -1 }, normal = { 0, 0.01, 1 } } },
    off = { master = sg.rigid.sphere{ centre = { 3, 2.001, -2 }, radius = 1 } },
    across = { master = sg.rigid.cylinder{ centre = { 3, 2, -2 }, axis = { 1, 0, 0 }, radius = 1 } },
  } do
    local ok, message = pcall(function() none(octant("N2", change), "axisymmetry") end)
    if not ok then error(what .. ": " .. message) end
  end
  none(punch("N2", 1, 1), "axisymmetry")
end)

check.case("a whole turn with a pole needs no support around it", function()
  local shell = sg.body{ patch = sg.shapes.hollow_hemisphere{ inner = 0.6, outer = 1, poles = "bottom" },
                         elements = { 8, 4, 2 }, order = "N2", contact = "front", through = 1, material = soft }
  local model = sg.model{ bodies = { shell = shell }, supports = { top = { on = shell:face "south", drive = "z" } } }
  local plane = sg.body{ patch = sg.shapes.quarter_annulus{ inner = 0.6, outer = 1 }, elements = { 4, 2 }, order = "N2",
                         contact = "south", through = 1, material = soft }
  promises(model, "axisymmetry", sg.model{ kind = "axisymmetric", bodies = { plane = plane }, supports = {
    top = { on = plane:face "east", drive = "y" }, axis = { on = plane:face "west", fix = "x" } } })
end)

check.case("a whole ring on a rigid shaft", function()
  local function scene(shaft, hold)
    local body = ring(360)
    return sg.model{ bodies = { ring = body }, supports = { bed = { on = body:face "south", fix = hold or "z" } },
                     contacts = { shaft = { slave = body:face "east", master = shaft, penalty = 1 } } }
  end
  local section = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1, corner = { 1, 0 } }, elements = { 2, 2 },
                           order = "N2", material = soft }
  promises(scene(sg.rigid.cylinder{ centre = { 0, 0, 0 }, axis = { 0, 0, 1 }, radius = 0.9 }), "axisymmetry",
    sg.model{ kind = "axisymmetric", bodies = { ring = section }, supports = {
      bed = { on = section:face "south", fix = "y" } } })
  none(scene(sg.rigid.cylinder{ centre = { 0.05, 0, 0 }, axis = { 0, 0, 1 }, radius = 0.9 }), "axisymmetry")
  none(scene(sg.rigid.cylinder{ centre = { 0, 0, 0 }, axis = { 0, 0, 1 }, radius = 0.9 }, "xz"), "axisymmetry")
end)

check.case("an axisymmetric scene: only planes across its axis", function()
  local function pipe(height, elements, more)
    local body = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = height, corner = { 1, -1 } },
                          elements = { 3, elements }, order = "N2", contact = "east", through = 1, material = soft }
    local supports = { inside = { on = body:face "west", fix = "x" } }
    if more then supports.middle = { on = body:face "north", fix = "y" } end
    return sg.model{ kind = "axisymmetric", bodies = { ring = body }, supports = supports, contacts = { pipe = {
      slave = body:face "east", master = sg.rigid.plane{ point = { 2.1, 0 }, normal = { -1, 0 } }, penalty = 10 } } }
  end
  local model = pipe(2, 4)
  check.equal(#advice(model, "symmetry"), 1)
  promises(model, "symmetry", pipe(1, 2, true))
end)

check.done()
