-- A jounce bumper of rubber is compressed by half: its grooves close, and its bore folds.
--
-- Problem: sg.scenes.bumper, axisymmetric; a hollow cylinder, 60 mm high, outer radius 30 mm, with two grooves, 8 mm
--          deep and 12 mm wide, in its outer face. The bore has a radius of 10 mm at its ends and 14 mm in the middle,
--          where it folds. Neo-Hookean rubber, c10 = 0.752 MPa, nearly incompressible (K = 400 MPa). A plate presses
--          it onto another one with friction; outer face and bore may touch themselves and each other (among), without
--          friction.
-- Source: a shape such as those of car suspensions; there is no closed form. The rounded corners of the grooves are
--         those of quadratic B-splines in their control polygons.
-- Units: mm, N, MPa.
-- Expected: forces with and without self-contact are equal until the bore touches itself, above 20 %; then the force
--           with it rises ever faster, and without it falls while the bumper passes through itself. The work is that
--           of strain energy, friction and penalty within 0.5 %.
-- Run: signorini objects/bumper.lua [refinement=2] [order=N2] [mu=0.3] [most=0.5] [steps=30]
--      [out=out/bumper]; refinement: factor on 24 × 3 elements; mu: on the plates

local sg = require "signorini"

local options = sg.arguments{ refinement = 2, order = "N2", mu = { 0.3, at_least = 0 },
                              most = { 0.5, above = 0.01, at_most = 0.55 }, steps = { 30, at_least = 4 },
                              out = "out/bumper" }
local files = sg.files(options.out)
local height = 60 -- of the scene

--- Compresses the bumper: its model and run, compressions in percent, forces in kN.
local function compressed(self_contact)
  local model, path = sg.scenes.bumper{ refinement = options.refinement, order = options.order, mu = options.mu,
                                        depth = options.most * height, self_contact = self_contact }
  local steps = options.steps
  path[1].steps = steps
  local run = model:run(path, { states = { 0, steps // 2, steps } })
  if run.failed then error(run.failure, 0) end
  local r = { model = model, run = run, compression = run:column "plate.uy", force = run:column "plate.fy" }
  for i, u in ipairs(r.compression) do
    r.compression[i], r.force[i] = -100 * u / height, -r.force[i] / 1000
  end
  return r
end

local with, without = compressed(true), compressed(false)
local bed, imbalance = with.run:column "bed.fy", 0
for i, force in ipairs(with.force) do imbalance = math.max(imbalance, math.abs(force - bed[i] / 1000) / force) end

local rows = {}
for tenth = 1, 10 do
  local i = tenth * options.steps // 10
  if i > 0 then
    rows[#rows + 1] = { with.compression[i], with.force[i], without.force[i],
                        with.run:column "folds.area"[i], with.run:column "folds.max_pressure"[i] }
  end
end
print(sg.table{ columns = { "compression", "force", "without self-contact", "area of the folds", "largest pressure" },
                units = { "%", "kN", "kN", "mm^2", "MPa" }, formats = { "%.1f", "%.3f", "%.3f", "%.0f", "%.2f" },
                rows = rows })
local energy = with.model:energy()
local balance = (energy.stored + energy.contact + energy.friction) / (energy.work + energy.area_growth)
print(("energies over work: %.4f"):format(balance))

sg.chart{ file = files "force.png", title = "Force on a jounce bumper", xlabel = "compression (%)",
          ylabel = "force (kN)", xrange = { 0, 100 * options.most }, yrange = { 0, 1.05 * with.force[#with.force] },
          { x = with.compression, y = with.force, label = "with self-contact" },
          { x = without.compression, y = without.force, label = "without" } }
local states = with.run:states()
states[#states + 1] = without.run:states()[#without.run:states()]
local function reached(r, step) return ("%.0f %%"):format(r.compression[step]) end
local titles = { "start", reached(with, options.steps // 2), reached(with, options.steps),
                 reached(without, options.steps) .. " without self-contact" }
for i, state in ipairs(states) do
  states[i] = sg.picture{ state = state, field = "von_mises", label = "von Mises stress (MPa)", range = { 0, 4 },
                          mirror = "x", axes = { "r (mm)", "z (mm)" }, title = titles[i] }
end
sg.sheet{ states, columns = 2, title = "Jounce bumper", file = files "states.png" }
files:report()

return { compression = with.compression, force = with.force, without = without.force, balance = balance,
         imbalance = imbalance, warnings = with.run.warnings }
