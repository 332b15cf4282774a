-- Two machined faces pressed together: a joint whose roughness is a law of the gap.
--
-- Problem: plane strain; a steel block, 20 × 10 mm, E = 210000 MPa, nu = 0.3, held at its sides, is pressed onto a
--          rigid plane. The roughness of the faces is p = k (−g)^m (`pressure` of the contact), k such that p = 4 MPa
--          closes it by 1 µm: 4e6 MPa/mm^2 for m = 2. Exponents of about 2 are those of measurements on machined
--          joints.
-- Source: springs in series: the approach is u = (p/k)^(1/m) + p h/M, M = E (1 − nu)/((1 + nu) (1 − 2 nu)), since a
--         block that is held at its sides is under uniform strain.
-- Units: mm, N, MPa.
-- Expected: the pressure at each approach is the root of this equation within 1e-9. At low pressures nearly all of the
--           approach is that of the roughness.
-- Run: signorini objects/rough_joint.lua [elements=4] [order=N2] [exponents=1,2,3] [steps=20] [out=out/rough_joint]

local sg = require "signorini"

local options = sg.arguments{ elements = { 4, at_least = 1 }, order = "N2", exponents = { { 1, 2, 3 }, above = 0.99 },
                              steps = { 20, at_least = 2 }, out = "out/rough_joint" }
local files = sg.files(options.out)
local width, height, E, nu, depth = 20, 10, 210000, 0.3, 0.004
local M = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu))

--- All exponents press with 4 MPa where the faces have approached by 1 µm.
local function stiffness(m) return 4 / 0.001 ^ m end

local function pressed(m)
  local block = sg.body{ patch = sg.shapes.rectangle{ width = width, height = height }, contact = "south",
                         elements = { options.elements, options.elements }, order = options.order,
                         material = sg.linear_elastic{ E = E, nu = nu } }
  local k = stiffness(m)
  local model = sg.model{
    bodies = { block = block },
    supports = { left = { on = block:face "west", symmetry = true },
                 right = { on = block:face "east", symmetry = true },
                 press = { on = block:face "north", drive = "y" } },
    contacts = { joint = { slave = block:face "south", master = sg.rigid.plane{ point = {0, 0}, normal = {0, 1} },
                           pressure = function(g) return k * sg.max(0, -g) ^ m end } },
  }
  local run = model:run{ { name = "press", steps = options.steps, press = -depth } }
  if run.failed then error(run.failure, 0) end
  return run
end

--- The pressure at an approach u, by bisection.
local function exact(m, u)
  local low, high = 0, M * u / height
  for _ = 1, 100 do
    local p = (low + high) / 2
    if (p / stiffness(m)) ^ (1 / m) + p * height / M < u then low = p else high = p end
  end
  return low
end

local curves, rows = {}, {}
local points = { x = {}, y = {}, label = "closed form", line = false, markers = true, color = "gray" }
for i, m in ipairs(options.exponents) do
  local run = pressed(m)
  local u, f, approach, p, worst, reference = run:column "press.uy", run:column "joint.fy", {}, {}, 0, 0
  for row = 1, #u do
    approach[row], p[row], reference = -1000 * u[row], f[row] / width, exact(m, -u[row])
    table.insert(points.x, approach[row])
    table.insert(points.y, reference)
    worst = math.max(worst, math.abs(p[row] / reference - 1))
  end
  rows[i] = { m, p[#p], reference, 100 * (p[#p] / stiffness(m)) ^ (1 / m) / depth, worst }
  curves[i] = { x = approach, y = p, label = ("m = %g"):format(m), markers = false }
end
print(sg.table{ columns = { "m", "pressure", "closed form", "share of the roughness", "largest difference" },
                units = { "", "MPa", "MPa", "%", "" }, formats = { "%g", "%.3f", "%.3f", "%.1f", "%.1e" },
                rows = rows })
curves[#curves + 1] = points
curves.file, curves.title = files "pressure.png", "A joint of rough faces: p = k (−g)^m"
curves.xlabel, curves.ylabel, curves.log = "approach (µm)", "pressure (MPa)", "y"
sg.chart(curves)
files:report()

return { rows = rows }
