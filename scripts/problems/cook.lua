-- Cook's membrane of a nearly incompressible material: convergence of the displacement of its end, without and with
-- projected volume change.
--
-- Problem: a tapered panel in plane strain, clamped on the left, with a dead shear traction on the right. Corners
--          (0, 0), (48, 44), (48, 60), (0, 44); equal numbers of elements along both sides.
--
--                     _.-| (48, 60)     linear: linear elastic, lambda = 7500, G = 0.375 (nu = 0.499975), force 1, of
--          (0, 44) _-'   ^              which a hundredth acts; neo-Hooke: E = 240.565, nu = 0.4999, force 100
--                 |    _.| (48, 44)
--                 |_.-'
--           (0, 0)
-- Source: R. D. Cook, J. Struct. Div. ASCE 100 (1974) 1851; linear: 16.4326 for the middle of the right side, quadratic
--         triangles extrapolated by P. Krysl in the examples of FinEALE (Cook_3D_strain);
--         neo-Hooke: J. C. Simo, F. Armero, Int. J. Numer. Meth. Engrg. 33 (1992) 1413.
-- Units: any consistent units.
-- Expected: with projected volume change all orders approach 16.45 (linear, 0.1 % above the published value) and 6.96
--           (neo-Hooke), N2 within 0.6 % on all meshes; pointwise, L1 has a third of it and N2 needs 32 × 32 elements.
-- Run: signorini cook.lua [laws=linear,neo-Hooke] [orders=L1,L2,N2,N3,N4] [elements=2,4,8,16,32]
--      [volumetric=pointwise,projected] [steps=4] [out=out/cook] [page=none]; steps: of the load on the
--      neo-Hookean panel; page: folder of locking.md, whose tables of the panel are filled

local sg = require "signorini"
local page = require "page.tables"

local options = sg.arguments{
  laws = { { "linear", "neo-Hooke" }, choices = { "linear", "neo-Hooke" } }, orders = { "L1", "L2", "N2", "N3", "N4" },
  elements = { { 2, 4, 8, 16, 32 }, at_least = 1 },
  volumetric = { { "pointwise", "projected" }, choices = { "pointwise", "projected" } },
  steps = { 4, at_least = 1 }, out = "out/cook", page = "none",
}
local files = sg.files(options.out)

local lambda, G = 7500, 0.375
local laws = {
  linear = { material = sg.linear_elastic{ E = G * (3 * lambda + 2 * G) / (lambda + G),
                                           nu = lambda / (2 * (lambda + G)) },
             force = 1, part = 0.01, steps = 1, published = 16.4326 }, -- the whole force strains it by 5 %
  ["neo-Hooke"] = { material = sg.neo_hookean{ E = 240.565, nu = 0.4999 }, force = 100, part = 1,
                    steps = options.steps },
}

local side = 16 -- length of the right side
local panel = sg.nurbs.ruled{ a = sg.nurbs.line{ from = { 0, 0 }, to = { 48, 44 } },
                              b = sg.nurbs.line{ from = { 0, 44 }, to = { 48, 60 } } }

--- The vertical displacement of the middle of the right side over the part of the force that acts, nil where the
--- solution fails; seconds per iteration of Newton's method for assembly and linear solution.
local function tip(law, order, count, volumetric)
  local body = sg.body{ patch = panel, elements = { count, count }, order = order, volumetric = volumetric,
                        material = law.material }
  local model = sg.model{
    bodies = { panel = body }, supports = { wall = { on = body:face "west", fix = "xy" } },
    loads = { shear = { on = body:face "east", traction = { 0, 0 } } },
  }
  local run = model:run{ { name = "shear", steps = law.steps, shear = { 0, law.part * law.force / side } } }
  local times = model:timings()
  return not run.failed and model:sample("panel", "uy", { 1, 0.5 }) / law.part or nil,
         (times.bulk + times.linear) / run.iterations
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The displacements of one discretization by number of elements, a row of the table, a curve of the chart, and the
--- seconds per iteration on the finest mesh.
local function series(law, order, volumetric)
  local label = volumetric == "projected" and order .. ", projected" or order
  local tips, row = {}, { label }
  local seconds
  local curve = { x = {}, y = {}, label = label, dashed = volumetric == "pointwise", markers = true }
  for _, count in ipairs(options.elements) do
    local value
    value, seconds = tip(law, order, count, volumetric)
    tips[count], row[#row + 1] = value, value or "failed"
    if value then
      table.insert(curve.x, count)
      table.insert(curve.y, value)
    end
  end
  return tips, row, curve, seconds
end

local results, tables = {}, {} -- results[law][volumetric][order][elements]
for _, name in ipairs(options.laws) do
  local law, rows, curves, columns, costs = laws[name], {}, {}, { "discretization" }, {}
  local formats = { "%s" }
  for i, count in ipairs(options.elements) do
    columns[i + 1], formats[i + 1] = ("%d × %d"):format(count, count), "%.3f"
  end
  results[name] = {}
  for _, volumetric in ipairs(options.volumetric) do
    local tips = {}
    for i, order in ipairs(options.orders) do
      local row, curve, seconds
      tips[order], row, curve, seconds = series(law, order, volumetric)
      curve.color = i
      rows[#rows + 1], curves[#curves + 1], costs[#costs + 1] = row, curve, { row[1], 1e3 * seconds }
    end
    results[name][volumetric] = tips
  end
  print(("\n%s: vertical displacement of the right side%s\n"):format(name,
    law.published and (", published %g"):format(law.published) or ""))
  tables["cook_" .. name] = { columns = columns, rows = rows, formats = formats }
  print(sg.table{ columns = columns, rows = rows })
  print(("\nper iteration on %s elements: assembly and linear solution\n"):format(columns[#columns]))
  print(sg.table{ columns = { "discretization", "time" }, units = { "", "ms" }, formats = { "%s", "%.1f" },
                  rows = costs })
  local key = name:lower()
  sg.chart{ file = files(key .. ".png"), title = ("Cook's membrane, %s, nearly incompressible"):format(name),
            xlabel = "elements along a side", ylabel = "vertical displacement of the right side", log = "x",
            table.unpack(curves) }
end
page.fill(options, "locking", "cook", tables)
files:report()
return { results = results }
