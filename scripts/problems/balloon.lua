-- A thick ball of rubber that is inflated past the greatest pressure that it can hold.
--
-- Problem: a hollow ball with the inner radius 1 and the outer radius `outer`, axisymmetric, one half of its section
--          between the axis and a plane of symmetry, of a neo-Hookean and of a Mooney–Rivlin law with the same shear
--          modulus 1 and the bulk modulus K. The pressure of the gas in it follows the inner face. It has a greatest
--          value, the limit point, beyond which the ball grows although the pressure falls: arc-length increments
--          follow the path from a small pressure on.
--          The exact solution of the incompressible ball: with W(s) = W(s^-2, s, s) for the hoop stretch s,
--          p = ∫ W'(s)/(s³ − 1) ds from its value at the outer face, b, to that at the hole, where
--          b³ − 1 = (a³ − 1)/outer³.
-- Source: A. E. Green, W. Zerna, Theoretical Elasticity, Oxford, 1954, section 3.10; R. W. Ogden, Non-linear Elastic
--         Deformations, Ellis Horwood, 1984, section 5.3.2.
-- Units: radii in units of the hole's, pressures and moduli in units of the shear modulus.
-- Expected: pressures within 0.1 % of the incompressible ball's for K = 50000, with a difference proportional to 1/K;
--           the pressure of the neo-Hookean ball falls beyond its limit point, that of the Mooney–Rivlin ball then
--           rises again.
-- Run: signorini balloon.lua [order=N3] [elements=6] [outer=1.5] [K=50000] [share=0.1] [steps=30] [largest=5]
--      [out=out/balloon]; share: of c01 in c10 + c01 of the Mooney–Rivlin law, steps: increments of about the same
--      displacement, largest: radius of the hole at the end

local sg = require "signorini"

local options = sg.arguments{
  order = "N3", elements = { 6, at_least = 1 }, outer = { 1.5, above = 1 }, K = { 50000.0, above = 0 },
  share = { 0.1, above = 0 }, steps = { 30, at_least = 2 }, largest = { 5.0, above = 1 }, out = "out/balloon",
}
local files = sg.files(options.out)

-- ── Exact solution ───────────────────────────────────────────────────────────────────────────────────────────────────

--- The pressure in a hole of radius a; the integrands of c10 (I1 − 3) and c01 (I2 − 3) are 4 c10 (s^-2 + s^-5) and
--- 4 c01 (1 + s^-3).
local function exact_pressure(c10, c01, a)
  local function integral(s) return 4 * c10 * (-1 / s - 1 / (4 * s^4)) + 4 * c01 * (s - 1 / (2 * s^2)) end
  local b = (1 + (a^3 - 1) / options.outer^3)^(1 / 3)
  return integral(a) - integral(b)
end

-- ── Scene ────────────────────────────────────────────────────────────────────────────────────────────────────────────

local function ball(c01)
  local body = sg.body{
    patch = sg.shapes.quarter_annulus{ inner = 1, outer = options.outer, center = { 0, 0 } },
    elements = { options.elements, options.elements }, order = options.order, volumetric = "projected",
    material = sg.mooney_rivlin{ c10 = 0.5 - c01, c01 = c01, K = options.K },
  }
  return sg.model{
    bodies = { ball = body }, kind = "axisymmetric",
    supports = { axis = { on = body:face "west", symmetry = true }, cut = { on = body:face "east", symmetry = true } },
    loads = { gas = { on = body:face "north", pressure = 0, follower = true } },
  }
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

local laws = { { name = "neo-Hooke", c01 = 0 }, { name = "Mooney-Rivlin", c01 = 0.5 * options.share } }
local first_pressure = 0.05
local outer_at_end = (options.outer^3 + options.largest^3 - 1) ^ (1 / 3)
local length = (options.largest - 1 + outer_at_end - options.outer) / 2 / options.steps -- mean of both faces
local rows, curves, fine = {}, {}, 200 -- points of an exact curve
for i, law in ipairs(laws) do
  local c10 = 0.5 - law.c01
  local model = ball(law.c01)
  law.radius, law.pressure, law.exact, law.error = { 1.0 }, { 0.0 }, { 0.0 }, 0
  local function record()
    model:accept()
    local a, pressure = 1 + model:sample("ball", "ux", { 1, 1 }), model:target("gas")[1]
    local exact = exact_pressure(c10, law.c01, a)
    law.radius[#law.radius + 1], law.pressure[#law.pressure + 1], law.exact[#law.exact + 1] = a, pressure, exact
    law.error = math.max(law.error, math.abs(pressure / exact - 1))
    return a
  end
  model:set_target("gas", { first_pressure })
  model:solve_step{}
  local a, increment = record(), length
  while a < options.largest do
    model:set_target("gas", { 1.0 }) -- defines the direction of the path, on which the pressure is an unknown
    local result = model:solve_arc{ length = increment }
    if result.converged then
      a, increment = record(), math.min(length, 2 * increment)
    else
      model:rollback()
      increment = increment / 2
      if increment < 1e-3 * length then error(("%s: %s"):format(law.name, result.message), 0) end
    end
  end
  law.limit = 1
  while law.pressure[law.limit + 1] and law.pressure[law.limit + 1] > law.pressure[law.limit] do
    law.limit = law.limit + 1
  end
  rows[#rows + 1] = { law.name, law.radius[law.limit], law.pressure[law.limit], law.pressure[#law.pressure],
                      100 * law.error }
  local x, y = {}, {}
  for k = 0, fine do
    x[k + 1] = 1 + (options.largest - 1) * k / fine
    y[k + 1] = exact_pressure(c10, law.c01, x[k + 1])
  end
  curves[#curves + 1] = { x = x, y = y, label = law.name .. ", exact", markers = false, color = i }
  curves[#curves + 1] = { x = law.radius, y = law.pressure, label = law.name, line = false, markers = true, color = i }
end

print(sg.table{
  columns = { "law", "radius at the limit", "greatest pressure", "pressure at the end", "error (%)" },
  rows = rows, formats = { "%s", "%.3f", "%.4f", "%.4f", "%.3f" },
})
for _, law in ipairs(laws) do
  sg.csv.write(files(law.name:lower() .. ".csv"), { radius = law.radius, pressure = law.pressure, exact = law.exact })
end
sg.chart{ file = files "pressure.png", title = "Pressure in an inflated ball of rubber", xlabel = "radius of the hole",
          ylabel = "pressure / shear modulus", table.unpack(curves) }
files:report()

return { laws = laws }
