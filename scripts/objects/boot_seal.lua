-- A boot of rubber seals a joint: the shaft moves in and tilts, and its folds touch each other and the shaft.
--
-- Problem: 3D, half of a bellows by symmetry; wall 4.75 mm at the wide end, 3 mm at the narrow end, a cuff around a
--          rigid shaft of radius 14 mm. The faces are quadratic B-splines whose control polygons are parallel to that
--          of the middle of the wall, which alternates between the radii 17.5 and 29 mm, both 1.5 mm more per fold, in
--          levels 4.5 mm long and 2.5 mm apart. Neo-Hookean rubber, c10 = 0.752 MPa, K = 2/0.026 MPa, projected volume
--          change (without it N2 locks). The wide end is fixed, the cuff bonded to the shaft, which is pushed in by
--          14 mm, then tilts by 10 degrees about the center of the joint, 15 mm outside the wide end. Inner and outer
--          face may touch themselves and each other (among), the inner one the shaft, without friction.
-- Source: radius, wall and material as in "Analysis of an automotive boot seal", 1.1.14 of the Abaqus Example Problems
--         Manual 6.5; the corrugation is chosen, so that no figures are comparable. There is no closed form.
-- Units: mm, N, MPa; moments N mm, about the center of the joint; forces and moments of the whole seal.
-- Expected: while the shaft is pushed in, the force of an axisymmetric model, within 1 %. The moment is proportional to
--           the tilt until folds touch each other and the shaft, then rises faster; a tilt to the other side has the
--           opposite moment. Moments of the two meshes differ by less than 15 %. The work is that of strain energy and
--           penalty within 0.5 %.
-- Run: signorini objects/boot_seal.lua [meshes=2,3] [order=N2] [stroke=14] [tilt=10] [steps=20] [out=out/boot_seal];
--      meshes: factors on 15 × 4 elements along the wall and around, 2 through it; steps: of the tilt

local sg = require "signorini"

local options = sg.arguments{ meshes = { { 2, 3 }, at_least = 1 }, order = "N2",
                              stroke = { 14.0, above = 0, at_most = 16 },
                              tilt = { 10.0, at_least = -12, at_most = 12 }, steps = { 20, at_least = 4 },
                              out = "out/boot_seal" }
local files = sg.files(options.out)
local radius, joint, stroke, steps = 14, 15, options.stroke, options.steps
local press = math.ceil(stroke / 2)

--- Control points of the middle of the wall, from the wide end to the narrow one.
local middle = { { 33.5, 0 }, { 33.5, 5 } }
for fold = 2, 0, -1 do
  for _, level in ipairs{ 17.5, 29 } do
    local y = middle[#middle][2] + 2.5
    for _, along in ipairs{ y, y + 4.5 } do middle[#middle + 1] = { level + 1.5 * fold, along } end
  end
end
local neck = middle[#middle][2] + 2.5
for _, along in ipairs{ 0, 4, 8 } do middle[#middle + 1] = { radius + 1.5, neck + along } end

--- The face of the seal that lies half the wall from its middle, outside (1) or inside (-1).
local function face(side)
  local points, knots = {}, { 0, 0 }
  local function normal(i)
    local a, b = middle[math.max(i, 1)], middle[math.min(i + 1, #middle)]
    local dx, dy = b[1] - a[1], b[2] - a[2]
    local length = math.sqrt(dx ^ 2 + dy ^ 2)
    return length > 0 and { dy / length, -dx / length } or { 1, 0 }
  end
  for i, point in ipairs(middle) do
    local before, after = normal(i - 1), normal(i)
    local half = side * (4.75 - 1.75 * math.min(1, point[2] / neck)) / 2
    local share = half / (1 + before[1] * after[1] + before[2] * after[2])
    points[i] = { point[1] + share * (before[1] + after[1]), point[2] + share * (before[2] + after[2]) }
  end
  for i = 0, #points - 2 do knots[#knots + 1] = i / (#points - 2) end
  return sg.nurbs.curve{ degree = 2, knots = table.move({ 1, 1 }, 1, 2, #knots + 1, knots), points = points }
end
local strip = sg.nurbs.ruled{ a = face(1), b = face(-1) }

--- Pushes the shaft in and tilts it: run, balance of energies, force and moment of the whole seal.
local function moved(n, solid)
  local half = sg.nurbs.revolve{ patch = strip, angle = 180 }:rotate{ angle = 180, axis = { 0, 1, 0 } }
  local seal = sg.body{ patch = solid and half or strip, elements = { 15 * n, 2, solid and 4 * n or nil },
                        order = options.order, volumetric = "projected",
                        material = sg.yeoh{ c10 = 0.752, K = 2 / 0.026 } }
  local shaft = solid and sg.rigid.cylinder{ center = { 0, stroke - joint, 0 }, axis = { 0, 1, 0 }, radius = radius }
    or sg.rigid.plane{ point = { radius, 0 }, normal = { 1, 0 } }
  local outside, inside, points = seal:face "south", seal:face "north", solid and 4 or nil
  local model = sg.model{
    kind = not solid and "axisymmetric" or nil, bodies = { seal = seal },
    supports = { wide = { on = seal:face "west", fix = solid and "xyz" or "xy" },
                 half = solid and { on = { seal:face "front", seal:face "back" }, symmetry = true } or nil,
                 shaft = { on = shaft, drive = "y", fix = solid and "xz" or "x", rotate = solid and "z" or nil } },
    contacts = { folds = { among = { outside, inside }, points = points },
                 bore = { slave = inside, master = shaft, points = points,
                          where = function(X) return X[2] < neck + 2 end },
                 cuff = { slave = inside, master = shaft, points = points,
                          where = function(X) return X[2] > neck + 2 end,
                          cohesive = { strength = 1, energy = 1e4, law = "bilinear" } } },
  }
  local path = { { name = "press", steps = press, shaft = solid and { -stroke, 0 } or -stroke },
                 solid and { name = "tilt", steps = steps, shaft = { -stroke, options.tilt } } or nil }
  local run = model:run(path, { states = solid and { 0, press, press + steps // 2, press + steps } or 2 })
  if run.failed then error(run.failure, 0) end
  local energy, r = model:energy(), { run = run, force = {}, moment = {} }
  for i, force in ipairs(run:column "shaft.fy") do
    r.force[i] = -(solid and 2 or 1) * force
    r.moment[i] = solid and 2 * run:column "shaft.moment"[i] or nil
  end
  r.balance = (energy.stored + energy.contact + energy.debonding) / (energy.work + energy.area_growth)
  return r
end
local solids = {}
for i, n in ipairs(options.meshes) do solids[i] = moved(n, true) end
local fine, revolved = solids[#solids], moved(options.meshes[#options.meshes], false)

local angle, area, bore = fine.run:column "shaft.angle", fine.run:column "folds.area", fine.run:column "bore.area"
local rows = {}
for quarter = 0, 4 do
  local i = press + quarter * steps // 4
  local difference = angle[i] == 0 and 0 or 100 * (solids[1].moment[i] / fine.moment[i] - 1)
  rows[#rows + 1] = { angle[i], fine.moment[i], difference, fine.force[i], 2 * area[i], 2 * bore[i] }
end
print(("pushed in by %g mm: %.3f N, axisymmetric %.3f N"):format(stroke, fine.force[press], revolved.force[press]))
print(sg.table{ columns = { "tilt", "moment", "on the first mesh", "force", "area of the folds", "at the shaft" },
                units = { "°", "N mm", "%", "N", "mm^2", "mm^2" },
                formats = { "%.1f", "%.1f", "%+.1f", "%.2f", "%.1f", "%.1f" }, rows = rows })
print(("energies over work: %.4f"):format(fine.balance))

local chart = { file = files "moment.png", title = "A boot seal is tilted", xlabel = "tilt (°)",
                ylabel = "moment (N mm)" }
for i, n in ipairs(options.meshes) do
  chart[i] = { x = table.move(angle, press, #angle, 1, {}), y = table.move(solids[i].moment, press, #angle, 1, {}),
               label = ("%d × 2 × %d elements"):format(15 * n, 4 * n), dashed = i < #options.meshes }
end
sg.chart(chart)
local pictures, titles = {}, { "start", ("pushed in by %g mm"):format(stroke) }
for i, state in ipairs(fine.run:states()) do
  local step = press + (i - 2) * steps // 2
  pictures[i] = sg.picture{ state = state, field = "von_mises", label = "von Mises stress (MPa)", range = { 0, 1 },
                            camera = { from = { 0, 0, 1 }, up = { 0, 1, 0 } }, unit = "mm",
                            title = titles[i] or ("tilted by %g°"):format(angle[step]) }
end
sg.sheet{ pictures, columns = 2, title = "Boot seal around a shaft", file = files "states.png" }
files:report()

return { force = fine.force, revolved = revolved.force, angle = angle, moment = fine.moment, area = area, bore = bore,
         first = solids[1].moment, balance = fine.balance, press = press, warnings = fine.run.warnings }
