-- A C-shape is pressed shut between two plates until it is flat.
--
-- Problem: plane strain; a ring of the radii 8 and 10 mm, open by 60 degrees, E = 10 MPa, nu = 0.3, of two joined
--          patches, is held where these meet, between two rigid plates that approach each other. All faces may touch
--          each other and the plates (among = "all"), with friction. The opening is turned, so that one end slides
--          below the other.
-- Source: theory of curved beams: two arms, quarter circles of the mean radius R that are clamped at the bottom, have
--         at their ends a force F against the plate and mu F along it, down; the ends move by
--         F R^3 (pi/4 - mu/2)/(E' I), E' = E/(1 - nu^2).
-- Units: mm, N per mm, MPa.
-- Expected: the force of the first step within 8 % of beam theory. The force rises when the ends touch, and without
--           bound when the arms lie on each other. The work is that of strain energy, friction and penalty within 3 %.
-- Run: signorini objects/cshape.lua [elements=32] [order=N2] [mu=0.3] [turn=10] [travel=8] [steps=80]
--      [out=out/cshape]; elements: along each arm; turn: of the opening, in degrees; travel: of each plate

local sg = require "signorini"

local options = sg.arguments{ elements = { 32, at_least = 12 }, order = "N2", mu = { 0.3, at_least = 0, below = 1 },
                              turn = { 10.0, at_least = 5, at_most = 25 },
                              travel = { 8.0, above = 1, at_most = 8.5 }, steps = { 80, at_least = 20 },
                              out = "out/cshape" }
local files = sg.files(options.out)
local inner, outer, E, nu, mu = 8, 10, 10, 0.3, options.mu

local function arm(from, to)
  local function arc(radius) return sg.nurbs.arc{ radius = radius, from = from, to = to } end
  return sg.body{ patch = sg.nurbs.ruled{ a = arc(outer), b = arc(inner) }, elements = { options.elements, 3 },
                  order = options.order, material = sg.neo_hookean{ E = E, nu = nu } }
end
local left, right = arm(120 - options.turn, 270), arm(270, 420 - options.turn)
local west = sg.rigid.plane{ point = { -outer, 0 }, normal = { 1, 0 } }
local east = sg.rigid.plane{ point = { outer, 0 }, normal = { -1, 0 } }
local model = sg.model{
  bodies = { left = left, right = right }, joins = { middle = { left:face "east", right:face "west" } },
  supports = { bottom = { on = left:face "east", fix = "x" }, foot = { on = left:corner "south-east", fix = "y" },
               west = { on = west, drive = "x", fix = "y" }, east = { on = east, drive = "x", fix = "y" } },
  contacts = { all = { among = "all", friction = mu > 0 and { mu = mu } or nil } },
}
local steps = options.steps
local shown = { 0, steps // 4, steps // 2, 3 * steps // 4, steps * 15 // 16, steps }
local run = model:run({ { name = "shut", steps = steps, west = options.travel, east = -options.travel } },
                      { states = shown })
if run.failed then error(run.failure, 0) end

local travel, force, bottom, ends = run:column "west.ux", run:column "west.fx", run:column "bottom.fx", {}
local imbalance = 0
for i, east_force in ipairs(run:column "east.fx") do
  ends[i] = -run:column "all.left_right.fx"[i]
  imbalance = math.max(imbalance, math.abs(force[i] + east_force + bottom[i]) / force[i])
end
local radius, inertia = (inner + outer) / 2, (outer - inner) ^ 3 / 12
local beam = travel[1] * E / (1 - nu ^ 2) * inertia / (radius ^ 3 * (math.pi / 4 - mu / 2))
local energy = model:energy()
local balance = (energy.stored + energy.contact + energy.friction) / (energy.work + energy.area_growth)

local rows = {}
for share = 1, 8 do
  local i = share * steps // 8
  rows[share] = { travel[i], force[i], ends[i] }
end
print(sg.table{ columns = { "travel", "force", "between the arms" }, units = { "mm", "N/mm", "N/mm" },
                formats = { "%.3f", "%.4f", "%.4f" }, rows = rows })
print(("first step: %.6f N/mm, beam theory %.6f"):format(force[1], beam))
print(("energies over work: %.4f"):format(balance))

sg.chart{ file = files "force.png", title = "A C-shape pressed shut", xlabel = "travel of each plate (mm)",
          ylabel = "force per width (N/mm)", { x = travel, y = force, label = "on a plate" },
          { x = travel, y = ends, label = "between the arms" } }
local pictures = {}
for i, state in ipairs(run:states()) do
  pictures[i] = sg.picture{ state = state, field = "von_mises", label = "von Mises stress (MPa)", range = { 0, 4 },
                            title = ("%.1f mm"):format(travel[shown[i]] or 0), unit = "mm" }
end
sg.sheet{ pictures, columns = 3, title = "A C-shape pressed shut, travel of each plate", file = files "states.png" }
files:report()

return { travel = travel, force = force, ends = ends, beam = beam, balance = balance, imbalance = imbalance,
         warnings = run.warnings }
