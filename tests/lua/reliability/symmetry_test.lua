-- Supports with symmetry = true: half and quarter models have half and a quarter of the force.

require "check"

local soft, stiff = sg.neo_hookean{ E = 1, nu = 0.3 }, sg.neo_hookean{ E = 1000, nu = 0.3 }
local exact = { newton = { tolerance = 1e-13 } }

--- Runs `stages` and returns the reaction of "grip".
local function grip(model, stages)
  check.completed(model:run(stages, exact))
  return model:reaction "grip"
end

-- What is mirrored may have a kink in the plane. The wholes of these tests may have it, too: their patches have a knot
-- there at which they are continuous only, which refinement keeps. So both have the same solutions.

--- A ring pressed into a slab; `part` is "whole" or "half", "fixed" is the half in which `fix` holds the plane.
local function ironing(part, order)
  local whole = part == "whole"
  local shape = whole and sg.shapes.half_annulus or sg.shapes.quarter_annulus
  local die = scenes.body{ patch = shape{ inner = 0.3, outer = 0.5, center = { 1.5, 1.5 } },
    elements = { whole and 6 or 3, 2 }, order = order, contact = "south", material = stiff }
  local function line(y)
    return sg.nurbs.curve{ degree = 1, knots = whole and { 0, 0, 0.5, 1, 1 } or { 0, 0, 1, 1 },
                           points = whole and { { 0, y }, { 1.5, y }, { 3, y } } or { { 1.5, y }, { 3, y } } }
  end
  local slab = scenes.body{ patch = sg.nurbs.ruled{ a = line(0), b = line(1) }, elements = { whole and 8 or 4, 3 },
    order = order, contact = "north", material = soft }
  local supports = { bed = { on = slab:face "south", fix = "xy" },
                     grip = { on = whole and { die:face "west", die:face "east" } or die:face "east",
                              drive = "y", fix = "x" } }
  local middle = { die:face "west", slab:face "west" }
  if part == "half" then supports.middle = { on = middle, symmetry = true } end
  if part == "fixed" then supports.middle = { on = middle, fix = "x" } end
  return scenes.model{ bodies = { die = die, slab = slab }, supports = supports,
    contacts = { interface = { slave = "die.south", master = "slab.north", penalty = 100,
                               friction = { mu = 0.2, penalty = 100 } } } }
end

check.case("half a model in 2D has half of the force", function()
  local press = { { steps = 5, grip = { -0.15 } } }
  for _, order in ipairs { "N2", "N4", "N2-N4" } do
    local whole, half = grip(ironing("whole", order), press), grip(ironing("half", order), press)
    check.near(whole[2] / half[2], 2, 1e-6) -- friction begins where first guesses close points, to their accuracy
    check.near(whole[1], 0, 1e-9)
  end
end)

check.case("symmetry is bitwise equal to fix of the normal component", function()
  local press = { { steps = 2, grip = { -0.1 } } }
  local half, fixed = ironing("half", "N2"), ironing("fixed", "N2")
  check.equal(grip(half, press), grip(fixed, press))
  check.equal(half:reaction "middle", fixed:reaction "middle")
  check.equal(half:cost().unknowns, fixed:cost().unknowns)
end)

--- A block on a plane obstacle: all of it, or the quarter with x, y ≥ 0.
local function block(whole)
  local along = whole and { -1, 0, 1 } or { 0, 1 }
  local points = {}
  for _, z in ipairs { 0, 1 } do
    for _, y in ipairs(along) do
      for _, x in ipairs(along) do points[#points + 1] = { x, y, z } end
    end
  end
  local knots = whole and { 0, 0, 0.5, 1, 1 } or { 0, 0, 1, 1 }
  local patch = sg.nurbs.volume{ degrees = { 1, 1, 1 }, knots = { knots, knots, { 0, 0, 1, 1 } }, points = points }
  local elements = whole and 4 or 2
  local body = scenes.body{ patch = patch, elements = { elements, elements, 2 }, contact = "front", material = soft }
  return scenes.model{ bodies = { block = body }, supports = { grip = { on = "back", drive = "z", fix = "xy" },
      x = not whole and { on = body:face "west", symmetry = true } or nil,
      y = not whole and { on = body:face "south", symmetry = true, free = "x" } or nil },
    contacts = { floor = { slave = "front", penalty = 100, friction = { mu = 0.3, penalty = 100 },
        master = sg.rigid.plane{ point = { 0, 0, 0 }, normal = { 0, 0, 1 } } } } }
end

check.case("a quarter of a solid has a quarter of the force", function()
  local press = { { steps = 2, grip = { -0.1 } } }
  local whole, quarter = grip(block(true), press), grip(block(false), press)
  check.near(whole[3] / quarter[3], 4, 4e-9)
end)

-- ── What is refused ──────────────────────────────────────────────────────────────────────────────────────────────────

local start = [[
local sg = require "signorini"
local soft = sg.neo_hookean{ E = 1, nu = 0.3 }
local function body(patch) return sg.body{ patch = patch, elements = {2, 2}, order = "N2", material = soft } end
local square = sg.shapes.rectangle{ width = 1, height = 1, corner = {1, 0} }
local a, skew = body(square), body(square:rotate{ angle = 30, center = {1, 0} })
local arc = body(sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = {3, 3} })
local function fixed(s, kind) return { bodies = { a = a, b = skew, arc = arc }, kind = kind, supports = { s = s } } end
]]
check.refusals(start, "study.lua:8: sg.model: ", {
  { [[sg.model(fixed{ on = skew:face "west", symmetry = true })]],
    "supports.s.symmetry needs a flat face across x or y, but face 'west' of body 'b' is curved or inclined",
    "patch:rotate" },
  { [[sg.model(fixed{ on = arc:face "south", symmetry = true })]], "face 'south' of body 'arc' is curved" },
  { [[sg.model(fixed{ on = {a:face "west", a:face "east"}, symmetry = true })]],
    "needs faces in one plane, but face 'east' of body 'a' lies in x = 2, another one in x = 1",
    "use a separate support for each plane" },
  { [[sg.model(fixed{ on = a:face "west", symmetry = true, drive = "xy" })]],
    "supports.s.symmetry holds x on the plane x = 1, but drive names x, too: remove one of the two" },
  { [[sg.model(fixed{ on = a:face "south", symmetry = true, free = "xy" })]],
    "supports.s.symmetry holds y on the plane y = 0, but free names y, too" },
  { [[sg.model(fixed{ on = a:face "west", symmetry = true, rotate = true })]],
    "supports.s.symmetry cannot be combined with rotate" },
  { [[sg.model(fixed{ on = a:corner "south-west", symmetry = true })]],
    "supports.s.on must be a face, or a list of faces, got the corner 'south-west'" },
  { [[sg.model(fixed{ on = sg.rigid.plane{ point = {0, 0}, normal = {0, 1} }, symmetry = true })]],
    "supports.s.on must be a face, or a list of faces" },
  { [[sg.model(fixed({ on = a:face "west", symmetry = true }, "axisymmetric"))]],
    "needs the axis x = 0 or a face across y, but face 'west' of body 'a' is a cylinder of radius 1", [[fix = "x"]] },
})

check.case("the axis and planes across it in an axisymmetric model; symmetry = false is the same as none", function()
  local patch = sg.shapes.rectangle{ width = 1, height = 1 }
  local function pipe(axis, middle)
    local body = scenes.body{ patch = patch, elements = { 2, 2 }, material = soft }
    axis.on, middle.on = body:face "west", body:face "south"
    return scenes.model{ kind = "axisymmetric", bodies = { b = body }, supports = { axis = axis, middle = middle,
      grip = { on = "north", drive = "y" } } }
  end
  local press = { { steps = 1, grip = { -0.1 } } }
  check.equal(grip(pipe({ symmetry = true }, { symmetry = true }), press),
    grip(pipe({ fix = "x" }, { fix = "y", symmetry = false }), press))
end)
