-- A rubber bushing of four joined patches between two steel sleeves.
--
-- Problem: a long bushing (plane strain), a ring with the radii a = 10 and b = 20 mm of four quarters that are joined,
--          of Mooney-Rivlin rubber with the shear modulus G = 2 (c10 + c01) = 1 MPa and the bulk modulus K. It is
--          bonded to a fixed outer sleeve and to an inner one, which moves sideways by up to `most` of the thickness.
-- Source: J. E. Adkins, A. N. Gent, Load-deflexion relations of rubber bush mountings, British Journal of Applied
--         Physics 5 (1954) 354-358: the radial stiffness per length of a long incompressible bushing is
--         k = 4 pi G/(ln(b/a) - (b^2 - a^2)/(b^2 + a^2)). With Poisson's ratio nu the same solution of plane
--         elasticity has k = 2 pi G q (q + 1)/(q^2 ln(b/a) - (b^2 - a^2)/(b^2 + a^2)), q = 3 - 4 nu.
-- Units: mm, N per mm, MPa.
-- Expected: the stiffness of the first, small step within 0.1 % of that for nu, which is 1.3 % below that of an
--           incompressible bushing for K = 2000 MPa. The force remains nearly proportional to the shift.
-- Run: signorini objects/bushing.lua [elements=8] [order=N2] [volumetric=projected] [K=2000] [most=0.4]
--      [steps=10] [out=out/bushing]

local sg = require "signorini"

local options = sg.arguments{ elements = { 8, at_least = 2 }, order = "N2", K = { 2000.0, above = 0 },
                              volumetric = { "projected", choices = { "pointwise", "projected" } },
                              most = { 0.4, above = 0.01, below = 0.7 }, steps = { 10, at_least = 1 },
                              out = "out/bushing" }
local files = sg.files(options.out)
local a, b, c10, c01 = 10, 20, 0.4, 0.1
local first = 0.01 * (b - a)

local quarters = { boundaries = { inner = {}, outer = {} } }
for i = 1, 4 do
  quarters[i] = sg.shapes.quarter_annulus{ inner = a, outer = b, start = 90 * i - 135 }
  quarters.boundaries.inner[i], quarters.boundaries.outer[i] = i .. ".north", i .. ".south"
end
local rubber = sg.body{ patch = quarters, elements = { options.elements, options.elements }, order = options.order,
                        volumetric = options.volumetric,
                        material = sg.mooney_rivlin{ c10 = c10, c01 = c01, K = options.K } }
local model = sg.model{ bodies = { rubber = rubber },
                        supports = { inner = { on = rubber:face "inner", drive = "x", fix = "y" },
                                     outer = { on = rubber:face "outer", fix = "xy" } } }
local run = model:run{ { name = "small", steps = 1, inner = first },
                       { name = "far", steps = options.steps, inner = options.most * (b - a) } }
if run.failed then error(run.failure, 0) end

local G = 2 * (c10 + c01)
--- The stiffness for Poisson's ratio nu.
local function exact(nu)
  local q = 3 - 4 * nu
  return 2 * math.pi * G * q * (q + 1) / (q^2 * math.log(b / a) - (b^2 - a^2) / (b^2 + a^2))
end
local incompressible = exact(0.5)
local compressible = exact((3 * options.K - 2 * G) / (6 * options.K + 2 * G))
local shift, force, linear = run:column "inner.ux", run:column "inner.fx", {}
for i, u in ipairs(shift) do linear[i] = compressible * u end
local stiffness = force[1] / shift[1]
print(sg.table{ columns = { "", "N/mm per mm" }, formats = { "%s", "%.3f" },
                rows = { { "stiffness", stiffness }, { "plane elasticity", compressible },
                         { "incompressible, Adkins and Gent", incompressible },
                         { "farthest, secant", force[#force] / shift[#shift] } } })
sg.chart{ file = files "force.png", title = "Radial force on a bushing", xlabel = "shift (mm)",
          ylabel = "force per length (N/mm)", { x = shift, y = force, label = "computed" },
          { x = shift, y = linear, label = "plane elasticity", markers = false } }
sg.picture{ model = model, field = "von_mises", label = "von Mises stress (MPa)", unit = "mm",
            file = files "states.png", title = "Bushing", size = 1200 }
files:report()

return { stiffness = stiffness, exact = compressible, published = incompressible, warnings = run.warnings,
         shift = shift, force = force }
