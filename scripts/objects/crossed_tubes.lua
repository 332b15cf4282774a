-- Two crossed tubes are pressed together until the softer one lies flat around the other one and touches itself.
--
-- Problem: 3D, a quarter of two tubes by symmetry; 100 mm long, radii 11.2 and 12 mm, axes 24 mm apart at right angles,
--          E = 1e5 MPa below and 1e4 MPa above, nu = 0.3, neo-Hooke. The ends are held; those of the upper tube move
--          down by 40.6 mm. The outer faces and the inner one of the upper tube may touch themselves and each other
--          (among), without friction.
-- Source: after K. Poulios and Y. Renard, Comput. Struct. 153 (2015), in the sizes of an example of Kratos. There is no
--         closed form.
-- Units: mm, N, MPa; forces of the whole tubes.
-- Expected: a force that rises all the time, equal to that at the ends of the other tube; the upper tube collapses, and
--           its walls touch each other above 30 mm. Forces of the two meshes differ by less than 15 %. The work is that
--           of strain energy and penalty within 0.5 %.
-- Run: signorini objects/crossed_tubes.lua [meshes=12,16] [order=N2] [travel=40.6] [steps=40]
--      [out=out/crossed_tubes]; meshes: elements around half of a tube, and as many along half of it

local sg = require "signorini"

local options = sg.arguments{ meshes = { { 12, 16 }, at_least = 4 }, order = "N2",
                              travel = { 40.6, above = 1, at_most = 40.6 }, steps = { 40, at_least = 4 },
                              out = "out/crossed_tubes" }
local files = sg.files(options.out)
local outer, inner, half, travel, steps = 12, 11.2, 50, options.travel, options.steps
local shown = { 0, steps // 3, 2 * steps // 3, steps }

--- A quarter of the lower tube, along y, or of the upper one, along x.
local function tube(n, upper)
  local from = upper and -90 or 90
  local function arc(radius) return sg.nurbs.arc{ radius = radius, from = from, to = from + 180 } end
  local section = sg.nurbs.ruled{ a = arc(outer), b = arc(inner) }
  local patch = sg.nurbs.extrude{ patch = section, along = { 0, 0, half } }:rotate{ angle = 90, axis = { 1, 0, 0 } }
  if upper then patch = patch:rotate{ angle = -90, axis = { 0, 0, 1 } }:translate{ 0, 0, 2 * outer } end
  return sg.body{ patch = patch, elements = { n, 1, n }, order = options.order,
                  grading = { false, false, { elements = 0.7, length = 0.5, at = "start" } },
                  material = sg.neo_hookean{ E = upper and 1e4 or 1e5, nu = 0.3 } }
end

--- Presses the tubes together: run, balance of energies, force on the whole tubes, imbalance of forces.
local function pressed(n)
  local lower, upper = tube(n, false), tube(n, true)
  local inside = upper:face "north"
  local model = sg.model{
    bodies = { lower = lower, upper = upper },
    supports = { bed = { on = lower:face "back", fix = "xyz" },
                 grip = { on = upper:face "back", drive = "z", fix = "xy" },
                 x = { on = { lower:face "west", lower:face "east", upper:face "front" }, symmetry = true },
                 y = { on = { upper:face "west", upper:face "east", lower:face "front" }, symmetry = true } },
    contacts = { tubes = { among = { lower:face "south", upper:face "south", inside }, points = 4,
                           pairs = { inside = { between = { inside, inside } } } } },
  }
  local run = model:run({ { name = "press", steps = steps, grip = -travel } }, { states = shown })
  if run.failed then error(run.failure, 0) end
  local energy, r = model:energy(), { run = run, force = {}, imbalance = 0 }
  for i, force in ipairs(run:column "grip.fz") do
    r.force[i] = -4 * force / 1000
    r.imbalance = math.max(r.imbalance, math.abs(force + run:column "bed.fz"[i]) / math.abs(force))
  end
  r.balance = (energy.stored + energy.contact) / (energy.work + energy.area_growth)
  return r
end
local all = {}
for i, n in ipairs(options.meshes) do all[i] = pressed(n) end
local fine = all[#all]

local path, area, inside = {}, fine.run:column "tubes.area", fine.run:column "tubes.inside.area"
for i, u in ipairs(fine.run:column "grip.uz") do path[i] = -u end
local rows = {}
for tenth = 1, 10 do
  local i = tenth * steps // 10
  if i > 0 then
    rows[#rows + 1] = { path[i], fine.force[i], 100 * (all[1].force[i] / fine.force[i] - 1), 4 * area[i],
                        4 * inside[i] }
  end
end
print(sg.table{ columns = { "travel", "force", "on the first mesh", "area of contact", "inside the upper tube" },
                units = { "mm", "kN", "%", "mm^2", "mm^2" }, formats = { "%.2f", "%.3f", "%+.1f", "%.1f", "%.1f" },
                rows = rows })
print(("energies over work: %.4f"):format(fine.balance))

local chart = { file = files "force.png", title = "Crossed tubes", xlabel = "travel (mm)", ylabel = "force (kN)" }
for i, n in ipairs(options.meshes) do
  chart[i] = { x = path, y = all[i].force, label = ("%d × 1 × %d elements per quarter"):format(n, n),
               dashed = i < #options.meshes, marker = "none" }
end
sg.chart(chart)
local pictures = {}
for i, state in ipairs(fine.run:states()) do
  pictures[i] = sg.picture{ state = state, field = "von_mises", factor = 1e-3, label = "von Mises stress (GPa)",
                            range = { 0, 5 }, mirror = "y", unit = "mm",
                            title = ("%.1f mm"):format(path[shown[i]] or 0) }
end
sg.sheet{ pictures, columns = 2, title = "Crossed tubes, travel of the ends", file = files "states.png" }
files:report()

return { travel = path, force = fine.force, first = all[1].force, area = area, inside = inside, balance = fine.balance,
         imbalance = fine.imbalance, warnings = fine.run.warnings }
