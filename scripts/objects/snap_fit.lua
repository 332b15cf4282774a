-- A snap-fit hook is pushed over a rigid bar and pulled out again.
--
-- Problem: a hook (plane strain, E = 2000 MPa, nu = 0.35) of the length L = 10 and the thickness t = 1 mm with a nose
--          of 0.8 mm is pushed below a fixed rigid bar of the radius 0.5 mm, which bends it down by 0.75 mm, and pulled
--          back, with friction. The bar's rounding and the retention angle of 45 degrees leave the path stable under a
--          prescribed displacement; an upright retention face would snap, which needs arc length control.
-- Source: Bayer MaterialScience, Snap-fit joints for plastics, 2013: W = P tan(alpha + phi), tan(phi) = mu, with the
--         deflecting force P of a cantilever of E' = E/(1 - nu^2). Here alpha includes the slope of the bent beam, the
--         deflection the bar's rounding, and the bending moment that of W, which acts above the beam's axis.
-- Units: mm, N per mm of width, MPa.
-- Expected: greatest insertion and retention force within 15 % of beam theory, which overestimates them: its nose
--           is rigid and touches at a point. Plain: without slope, rounding and lever arm, P = 3 E' I y/l^3.
-- Run: signorini objects/snap_fit.lua [elements=40] [order=N2] [mu=0.2] [steps=80] [penalty=500]
--      [out=out/snap_fit]; penalty: of the contact; a higher one needs shorter steps

local sg = require "signorini"

local options = sg.arguments{ elements = { 40, at_least = 16 }, order = "N2", mu = { 0.2, at_least = 0 },
                              steps = { 80, at_least = 60 }, penalty = { 500.0, above = 0 }, out = "out/snap_fit" }
local files = sg.files(options.out)
local E, nu, length, thickness, nose, land, radius, gap = 2000, 0.35, 10, 1, 0.8, 0.6, 0.5, 0.05
local insertion, retention, travel = 30, 45, 4.0

local hook = sg.body{
  patch = sg.shapes.hook{ length = length, thickness = thickness, nose = nose, land = land, insertion = insertion,
                          retention = retention },
  elements = { options.elements, 4 }, order = options.order, contact = "north",
  material = sg.neo_hookean{ E = E, nu = nu },
}
local tip = length + nose / math.tan(math.rad(retention)) + land + nose / math.tan(math.rad(insertion))
local bar = sg.rigid.cylinder{ center = { tip + radius + 0.1, thickness + gap + radius }, radius = radius }
local model = sg.model{
  bodies = { hook = hook }, supports = { hand = { on = hook:face "west", drive = "x", fix = "y" } },
  contacts = { nose = { slave = hook:face "north", master = bar, penalty = options.penalty, points = 32,
                        friction = options.mu > 0 and { mu = options.mu, penalty = options.penalty } or nil } },
}
--- The step at which the hand has made this share of its way.
local function step(share) return math.floor(share * options.steps + 0.5) end
local run = model:run({ { name = "push", steps = options.steps, hand = travel },
                        { name = "pull", steps = options.steps, hand = 0 } },
                      { states = { step(0.39), step(0.5), step(0.71) } })
if run.failed then error(run.failure, 0) end

local EI = E / (1 - nu^2) * thickness^3 / 12

--- The force along x of the deflecting force of a cantilever with the bar on an edge of the nose at x = l.
local function plain_beam(l, angle)
  return 3 * EI * (nose - gap) / l^3 * math.tan(math.rad(angle) + math.atan(options.mu))
end

--- The force along x by beam theory with the bar on an edge of the nose at x = l, whose face has the angle `angle`;
--- sign: 1 of insertion, -1 of retention. P: deflecting force, T: force along x per P, e: its lever arm.
local function beam(l, angle, sign)
  local e, slope, P, T = thickness / 2 + nose, 0, 0, 0
  for _ = 1, 50 do
    local face = math.rad(angle) + sign * slope
    local y = nose - gap - radius * (1 - math.cos(face))
    T = math.tan(face + math.atan(options.mu))
    -- The deflection of the axis reduces the arm, here for the shape (3 x^2 l - x^3)/(2 l^3) of the bent beam.
    P = y * EI / (l^3 / 3 - sign * (e - 0.8 * y) * T * l^2 / 2)
    slope = P * (l^2 / 2 - sign * (e - 0.625 * y) * T * l) / EI
  end
  return P * T
end
local corner = length + nose / math.tan(math.rad(retention))
local shift, force = run:column "hand.ux", run:column "hand.fx"
local push, pull = math.max(table.unpack(force)), -math.min(table.unpack(force))
local results = { push = push, push_beam = beam(corner + land, insertion, 1),
                  push_plain = plain_beam(corner + land, insertion), pull = pull,
                  pull_beam = beam(corner, retention, -1), pull_plain = plain_beam(corner, retention) }
print(sg.table{ columns = { "", "computed", "beam theory", "plain beam" }, formats = { "%s", "%.3f", "%.3f", "%.3f" },
                rows = { { "insertion force", push, results.push_beam, results.push_plain },
                         { "retention force", pull, results.pull_beam, results.pull_plain } } })
local function part(first, last, label)
  return { x = table.move(shift, first, last, 1, {}), y = table.move(force, first, last, 1, {}), label = label }
end
sg.chart{ file = files "force.png", xlabel = "shift of the root (mm)", ylabel = "force per width (N/mm)",
          title = "Snap-fit hook", part(1, options.steps, "pushed in"), part(options.steps + 1, #force, "pulled out") }
sg.picture{ model = model, states = run:states(), field = "von_mises", label = "von Mises stress (MPa)", unit = "mm",
            file = files "states.png", size = 1200 }
files:report()

results.shift, results.force = shift, force
return results
