-- Cook's membrane of a nearly incompressible material: convergence of the displacement of its end, without and with
-- projected volume change.
--
-- Problem: a tapered panel in plane strain, clamped on the left, with a dead shear traction on the right. Corners
--          (0, 0), (48, 44), (48, 60), (0, 44); equal numbers of elements along both sides.
--
--                     _.-| (48, 60)     linear: linear elastic, lambda = 7500, G = 0.375 (nu = 0.499975), force 1
--          (0, 44) _-'   ^              neo-Hooke: E = 240.565, nu = 0.4999, force 100
--                 |    _.| (48, 44)
--                 |_.-'
--           (0, 0)
-- Source: R. D. Cook, J. Struct. Div. ASCE 100 (1974) 1851; linear: 16.4326 for the middle of the right side, quadratic
--         triangles extrapolated by P. Krysl in the examples of FinEALE (Cook_3D_strain);
--         neo-Hooke: J. C. Simo, F. Armero, Int. J. Numer. Meth. Engrg. 33 (1992) 1413.
-- Units: any consistent units.
-- Expected: with projected volume change all orders approach 16.45 (linear, 0.1 % above the published value) and 6.96
--           (neo-Hooke), N2 within 0.6 % on all meshes; pointwise, L1 has a third of it and N2 needs 32 × 32 elements.
-- Run: signorini scripts/cook.lua [laws=linear,neo-Hooke] [orders=L1,L2,N2,N3,N4] [elements=2,4,8,16,32]
--      [volumetric=pointwise,projected] [steps=4] [out=out/cook]; steps: of the load on the neo-Hookean panel

local sg = require "signorini"

local options = sg.arguments{
  laws = { { "linear", "neo-Hooke" }, choices = { "linear", "neo-Hooke" } }, orders = { "L1", "L2", "N2", "N3", "N4" },
  elements = { { 2, 4, 8, 16, 32 }, at_least = 1 },
  volumetric = { { "pointwise", "projected" }, choices = { "pointwise", "projected" } },
  steps = { 4, at_least = 1 }, out = "out/cook",
}
local files = sg.files(options.out)

local lambda, G = 7500, 0.375
local laws = {
  linear = { material = sg.linear_elastic{ E = G * (3 * lambda + 2 * G) / (lambda + G),
                                           nu = lambda / (2 * (lambda + G)) },
             force = 1, steps = 1, published = 16.4326 },
  ["neo-Hooke"] = { material = sg.neo_hookean{ E = 240.565, nu = 0.4999 }, force = 100, steps = options.steps },
}

local function line(from, to) return sg.nurbs.curve{ degree = 1, knots = { 0, 0, 1, 1 }, points = { from, to } } end
local panel = sg.nurbs.ruled{ a = line({ 0, 0 }, { 48, 44 }), b = line({ 0, 44 }, { 48, 60 }) }

--- The vertical displacement of the middle of the right side; nil where the solution fails.
local function tip(law, order, count, volumetric)
  local body = sg.body{ patch = panel, elements = { count, count }, order = order, volumetric = volumetric,
                        material = law.material }
  local model = sg.model{
    bodies = { panel = body }, supports = { wall = { on = body:face "west", fix = "xy" } },
    loads = { shear = { on = body:face "east", traction = { 0, 0 } } },
  }
  local run = model:run{ { name = "shear", steps = law.steps, shear = { 0, law.force / 16 } } }
  return not run.failed and model:sample("panel", "uy", { 1, 0.5 }) or nil
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

local results = {}
for _, name in ipairs(options.laws) do
  local law, rows, curves, columns = laws[name], {}, {}, { "discretization" }
  for i, count in ipairs(options.elements) do columns[i + 1] = ("%d × %d"):format(count, count) end
  results[name] = {}
  for _, volumetric in ipairs(options.volumetric) do
    results[name][volumetric] = {}
    local projected = volumetric == "projected"
    for i, order in ipairs(options.orders) do
      local x, y = {}, {}
      local row = { order .. (projected and ", projected" or "") }
      for _, count in ipairs(options.elements) do
        local value = tip(law, order, count, volumetric)
        row[#row + 1] = value or "failed"
        if value then x[#x + 1], y[#y + 1] = count, value end
      end
      results[name][volumetric][order] = y
      rows[#rows + 1] = row
      curves[#curves + 1] = { x = x, y = y, label = row[1], color = i, dashed = not projected, markers = true }
    end
  end
  print(("\n%s: vertical displacement of the right side%s\n"):format(name,
    law.published and (", published %g"):format(law.published) or ""))
  print(sg.table{ columns = columns, rows = rows })
  local key = name:lower()
  sg.chart{ file = files(key .. ".png"), title = ("Cook's membrane, %s, nearly incompressible"):format(name),
            xlabel = "elements along a side", ylabel = "vertical displacement of the right side", log = "x",
            table.unpack(curves) }
end
files:report()
return { results = results }
