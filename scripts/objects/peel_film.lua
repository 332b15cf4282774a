-- A film is peeled off a rigid plate at 90°.
--
-- Problem: plane strain; a film of thickness t = 0.1 mm, E = 2000 MPa, nu = 0.3, bonded to a rigid plate with the
--          energy of separation G and a strength of 1 MPa except for the first 2 mm. Its free end is lifted and may
--          move along the plate, so that the lifted part stands upright when the film peels steadily.
-- Source: R. S. Rivlin, Paint Technol. 9, 1944; K. Kendall, J. Phys. D 8, 1975: at 90° the force per width F satisfies
--         F + F²/(2 E' t) = G, E' = E/(1 − nu²); without stretch F = G.
-- Units: mm, N, MPa; forces per mm of width.
-- Expected: the steady force is the closed form within 1 %, and work = stored energy + G times the peeled length.
-- Run: signorini objects/peel_film.lua [elements=70] [order=N2] [energy=0.1] [strength=1] [steps=60]
--      [law=exponential] [out=out/peel_film]

local sg = require "signorini"

local options = sg.arguments{ elements = { 70, at_least = 14 }, order = "N2", energy = { 0.1, above = 0 },
                              strength = { 1, above = 0 }, steps = { 60, at_least = 20 },
                              law = { "exponential", choices = { "exponential", "bilinear" } }, out = "out/peel_film" }
local files = sg.files(options.out)
local length, free, t, E, nu, lift = 14, 2, 0.1, 2000, 0.3, 9
local G = options.energy

local film = sg.body{ patch = sg.shapes.rectangle{ width = length, height = t }, elements = { options.elements, 1 },
                      order = options.order, contact = "south", thickness_degree = 2,
                      material = sg.neo_hookean{ E = E, nu = nu } }
local model = sg.model{
  bodies   = { film = film },
  supports = { clamp = { on = film:face "east", fix = "xy" }, grip = { on = film:corner "south-west", drive = "y" } },
  contacts = { glue = { slave = film:face "south", master = sg.rigid.plane{ point = {0, 0}, normal = {0, 1} },
                        penalty = 2000, cohesive = { strength = options.strength, energy = G, law = options.law,
                                                     where = function(X) return X[1] >= free end } } },
}

local run = model:run{ { name = "peel", steps = options.steps, grip = lift } }
if run.failed then error(run.failure, 0) end

local lifted, force, peeled = run:column "grip.uy", run:column "grip.fy", run:column "glue.debonded"
local stiffness = E / (1 - nu^2) * t
local closed = stiffness * (math.sqrt(1 + 2 * G / stiffness) - 1)
local sum, count = 0, 0
for i, u in ipairs(lifted) do
  if u > 0.6 * lift then sum, count = sum + force[i], count + 1 end
end
local steady, e = sum / count, model:energy()
local balance = (e.stored + e.contact + e.debonding) / e.work
print(sg.table{ columns = { "", "computed", "closed form" }, formats = { "%s", "%.5f", "%.5f" },
                rows = { { "steady force (N/mm)", steady, closed }, { "energies over work", balance, 1 } } })
table.insert(lifted, 1, 0)
table.insert(force, 1, 0)
table.insert(peeled, 1, 0)
sg.chart{ file = files "force.png", title = "Peeling a film at 90°", xlabel = "lift (mm)", ylabel = "force (N/mm)",
          { x = lifted, y = force, label = "computed", marker = "none" },
          { x = { 0, lift }, y = { closed, closed }, label = "closed form", marker = "none", dashed = true } }
local profile, tension = model:profile "glue", {}
for i, pressure in ipairs(profile.pressure) do tension[i] = -pressure / options.strength end
sg.chart{ file = files "damage.png", title = "Bonds at the end of the path", xlabel = "X (mm)",
          ylabel = "damage, tension over strength",
          { x = profile.X, y = profile.damage, label = "damage", marker = "none" },
          { x = profile.X, y = tension, label = "tension over strength (negative: pressure)", marker = "none" } }
local front = free + peeled[#peeled]
sg.picture{ model = model, field = "von_mises", label = "von Mises stress (MPa)", unit = "mm",
            file = files "states.png", size = 1200, inset = { front - 1.2, front + 0.8, -0.1, 0.9 },
            title = "Peeling a film" }
files:report()

return { force = force, lifted = lifted, peeled = peeled, steady = steady, closed = closed, balance = balance }
