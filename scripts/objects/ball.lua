-- A solid ball of seven patches between two rigid plates.
--
-- Problem: a ball of the radius R = 1, linear elastic with E = 1, nu = 0.3, of seven joined patches without singular
--          points, is compressed by two plates that approach each other by 2 `shift`; friction of 0.1 holds it in place.
--          The axisymmetric model of its lower half is the reference.
-- Source: Hertz's theory (K. L. Johnson, Contact Mechanics, 1985, section 4.2): F = 4/3 E/(1 - nu^2) sqrt(R shift^3).
-- Units: lengths in units of R, stresses in units of E.
-- Expected: force within 3 % of the axisymmetric model's, which is above Hertz's, a theory for shift << R.
-- Run: signorini scripts/objects/ball.lua [elements=3] [shift=0.08] [penalty=50] [out=out/ball]; elements: odd numbers
--      have an element in the middle of the contact

local sg = require "signorini"

local options = sg.arguments{ elements = { 3, at_least = 1 }, shift = { 0.08, above = 0, below = 0.2 },
                              penalty = { 50.0, above = 0 }, out = "out/ball" }
local files = sg.files(options.out)
local R, E, nu, n, shift = 1, 1, 0.3, options.elements, options.shift
local material = sg.linear_elastic{ E = E, nu = nu }

local body = sg.body{ patch = sg.shapes.ball{ radius = R }, elements = { n, n, n }, order = "N4", material = material }
local top = sg.rigid.plane{ point = { 0, 0, R }, normal = { 0, 0, -1 } }
local function touch(face, plate)
  return { slave = body:face(face), master = plate, penalty = options.penalty,
           friction = { mu = 0.1, penalty = options.penalty } }
end
local model = sg.model{
  bodies = { ball = body }, supports = { push = { on = top, drive = "z" } },
  contacts = { above = touch("6.front", top),
               below = touch("1.front", sg.rigid.plane{ point = { 0, 0, -R }, normal = { 0, 0, 1 } }) },
}
local run = model:run{ { name = "press", steps = 1, push = -2 * shift } }
if run.failed then error(run.failure, 0) end

local half = sg.body{ patch = sg.shapes.quarter_annulus{ inner = R / 50, outer = R }, elements = { 40, 20 },
                      order = "N2", contact = "south", material = material }
local section = sg.model{
  bodies = { half = half }, kind = "axisymmetric",
  supports = { push = { on = half:face "east", drive = "y" }, axis = { on = half:face "west", symmetry = true } },
  contacts = { plate = { slave = half:face "south", penalty = options.penalty,
                         master = sg.rigid.plane{ point = { 0, -R }, normal = { 0, 1 } } } },
}
local reference = section:run{ { name = "press", steps = 1, push = -shift } }
if reference.failed then error(reference.failure, 0) end

local results = { force = -model:reaction("push").fz, section = -section:reaction("push").fy,
                  hertz = 4 / 3 * E / (1 - nu^2) * math.sqrt(R * shift^3) }
print(sg.table{ columns = { "", "force" }, formats = { "%s", "%.5f" }, rows = {
  { "seven patches", results.force }, { "axisymmetric", results.section }, { "Hertz", results.hertz } } })
sg.picture{ model = model, field = "szz", cut = "-y", size = 1000, file = files "states.png", title = "Compressed ball" }
files:report()

return results
