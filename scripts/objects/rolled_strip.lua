-- A strip is rolled up into a coil, which touches itself with friction.
--
-- Problem: plane strain; a strip, 100 mm long and t = 2 mm thick, E = 10 MPa, nu = 0.3, neo-Hooke, is clamped at one
--          end. The face of the other one turns by 270° and moves freely, so that a moment bends the strip to an arc. A
--          dead force along the strip, F = E' I/rho^2, E' = E/(1 - nu^2), I = t^3/12, then pulls at it while it turns
--          to 360°, and stays while it turns further: the strip winds up around its own end like a carpet. All faces
--          may touch each other (among = "all").
-- Source: theory of beams: a moment alone bends the strip to an arc, M = E' I kappa, kappa the angle over the length.
--         There is no closed form of the coil.
-- Units: mm, N per mm, MPa; moments N mm per mm.
-- Expected: M of beam theory within 0.2 % up to 270°. The force tightens the arc, and the end touches the strip. The
--           work is that of strain energy, friction and penalty within 0.5 %; moments of two meshes differ by less than
--           2 %.
-- Run: signorini objects/rolled_strip.lua [elements=60] [order=N2] [mu=0.3] [rho=6] [angle=540] [steps=72]
--      [out=out/rolled_strip]; elements: along the strip, of the finer of two meshes; steps: from 360° to the angle

local sg = require "signorini"

local options = sg.arguments{ elements = { 60, at_least = 30 }, order = "N2", mu = { 0.3, at_least = 0, below = 1 },
                              rho = { 6.0, at_least = 4, at_most = 8 },
                              angle = { 540.0, above = 360, at_most = 540 }, steps = { 72, at_least = 4 },
                              out = "out/rolled_strip" }
local files = sg.files(options.out)
local length, t, E, nu, mu, steps = 100, 2, 10, 0.3, options.mu, options.steps
local stiffness = E / (1 - nu ^ 2) * t ^ 3 / 12
local bend, pull = 18, 36
local shown = { bend + pull // 2, bend + pull, bend + pull + steps // 2, bend + pull + steps }

--- Rolls up the strip on a mesh: its run, balance of energies, imbalance of forces.
local function rolled(elements)
  local strip = sg.body{ patch = sg.shapes.rectangle{ width = length, height = t }, elements = { elements, 2 },
                         order = options.order, material = sg.neo_hookean{ E = E, nu = nu } }
  local model = sg.model{
    bodies = { strip = strip },
    supports = { clamp = { on = strip:face "west", fix = "xy" }, grip = { on = strip:face "east", rotate = true } },
    loads = { pull = { on = strip:face "east", traction = { 0, 0 } } },
    contacts = { coil = { among = "all", friction = mu > 0 and { mu = mu } or nil } },
  }
  local run = model:run({ { name = "bend", steps = bend, grip = 270 },
                          { name = "pull", steps = pull, grip = 360, pull = { stiffness / options.rho ^ 2 / t, 0 } },
                          { name = "roll", steps = steps, grip = options.angle } }, { states = shown })
  if run.failed then error(run.failure, 0) end
  local energy, force, held = model:energy(), run:column "pull.fx", run:column "clamp.fx"
  return { run = run, angle = run:column "grip.angle", moment = run:column "grip.moment",
           imbalance = math.abs(force[#force] + held[#held]) / force[#force],
           balance = (energy.stored + energy.contact + energy.friction) / (energy.work + energy.area_growth) }
end
local fine, coarse = rolled(options.elements), rolled(2 * options.elements // 3)

local beam, worst, rows = {}, 0, {}
for i, angle in ipairs(fine.angle) do
  beam[i] = stiffness * math.rad(angle) / length
  if i <= bend then worst = math.max(worst, math.abs(fine.moment[i] / beam[i] - 1)) end
end
local area = fine.run:column "coil.area"
for _, i in ipairs{ bend, table.unpack(shown) } do
  rows[#rows + 1] = { fine.angle[i], fine.moment[i], 100 * (coarse.moment[i] / fine.moment[i] - 1), beam[i], area[i] }
end
print(sg.table{ columns = { "angle", "moment", "on the coarser mesh", "of an arc", "area of contact" },
                units = { "°", "N", "%", "N", "mm" }, formats = { "%.0f", "%.4f", "%+.2f", "%.4f", "%.2f" },
                rows = rows })
print(("bending up to 270°: within %.3f %% of beam theory"):format(100 * worst))
print(("energies over work: %.4f"):format(fine.balance))

sg.chart{ file = files "moment.png", title = "A strip is rolled up", xlabel = "angle (°)",
          ylabel = "moment per width (N)",
          { x = fine.angle, y = fine.moment, label = ("%d × 2 elements"):format(options.elements), marker = "none" },
          { x = coarse.angle, y = coarse.moment, label = ("%d × 2 elements"):format(2 * options.elements // 3),
            marker = "none", dashed = true },
          { x = fine.angle, y = beam, label = "arc without a force, E' I κ", color = "gray", marker = "none" } }
local pictures = {}
for i, state in ipairs(fine.run:states()) do
  pictures[i] = sg.picture{ state = state, field = "von_mises", label = "von Mises stress (MPa)", range = { 0, 3 },
                            crop = { 35, 80, -2, 22 }, unit = "mm", title = ("%.0f°"):format(fine.angle[shown[i]]) }
end
sg.sheet{ pictures, columns = 2, title = "A strip is rolled up", file = files "states.png" }
files:report()

return { angle = fine.angle, moment = fine.moment, beam = beam, worst = worst, balance = fine.balance, area = area,
         coarse = coarse.moment, imbalance = fine.imbalance, warnings = fine.run.warnings }
