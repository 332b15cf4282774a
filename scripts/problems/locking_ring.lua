-- A thick ring and a hollow ball of nearly incompressible material under inner pressure: errors of displacement and
-- stress, without and with projected volume change.
--
-- Problem: a quarter of a ring (plane strain) and of the section of a hollow ball (axisymmetric), radii 1 and 2, inner
--          pressure 10⁻³, linear elastic, E = 1; n × n elements.
-- Source: G. Lamé's closed forms, e.g. S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd edition, 1970,
--         articles 28 (ring) and 142 (ball).
-- Units: pressures of Young's modulus, lengths of the inner radius.
-- Expected: with projection the displacement converges with p + 1 and the stress with p, from the coarsest mesh on.
--           Without it stresses of N2 are off by more than their size even on fine meshes.
-- Run: signorini locking_ring.lua [shapes=ring,ball] [orders=N2,N3,N4] [elements=4,8,16,32] [nu=0.4999]
--      [volumetric=pointwise,projected] [out=out/locking_ring] [page=none]; page: folder of locking.md, whose tables of
--      the ring and the ball are filled

local sg = require "signorini"
local page = require "page.tables"

local options = sg.arguments{
  shapes = { { "ring", "ball" }, choices = { "ring", "ball" } }, orders = { "N2", "N3", "N4" },
  elements = { { 4, 8, 16, 32 }, at_least = 2 }, nu = { 0.4999, above = 0, below = 0.5 },
  volumetric = { { "pointwise", "projected" }, choices = { "pointwise", "projected" } }, out = "out/locking_ring",
  page = "none",
}
local files, nu = sg.files(options.out), options.nu
local inner, outer, pressure, dimensions = 1, 2, 1e-3, { ring = 2, ball = 3 }
local quarter = sg.shapes.quarter_annulus{ inner = inner, outer = outer }

--- Radial displacement and stress at the radius r: u = A r + B/r^(D−1) with the stress s (1 − (outer/r)^D).
local function lame(shape, r)
  local D = dimensions[shape]
  local s = pressure / ((outer / inner)^D - 1)
  local share = D == 2 and 1 + nu or (1 + nu) / 2
  local stretch = D == 2 and (1 + nu) * (1 - 2 * nu) or 1 - 2 * nu
  return s * (stretch * r + share * outer^D / r^(D - 1)), s * (1 - (outer / r)^D)
end

local function solved(shape, order, count, volumetric)
  local body = sg.body{ patch = quarter, elements = { count, count }, order = order,
                        volumetric = volumetric, material = sg.linear_elastic{ E = 1, nu = nu } }
  local model = sg.model{
    bodies = { [shape] = body }, kind = shape == "ball" and "axisymmetric" or "plane_strain",
    supports = { left = { on = body:face "west", symmetry = true }, low = { on = body:face "east", symmetry = true } },
    loads = { gas = { on = body:face "north", pressure = 0 } },
  }
  local run = model:run{ { name = "inflate", steps = 1, gas = pressure } }
  if run.failed then error(run.failure, 0) end
  return model
end

local points = 41 -- per direction, at which errors are evaluated; prime: they are anywhere in elements

--- Root mean square errors of radial displacement and stress, relative to the root mean squares of the exact ones.
local function errors(shape, model)
  local squares = { 0, 0, 0, 0 } -- error and exact value of displacement and stress
  for i = 1, points do
    for k = 1, points do
      local xi = { (i - 0.5) / points, (k - 0.5) / points }
      local function at(field) return model:sample(shape, field, xi) end
      local X = quarter(xi)
      local r = math.sqrt(X[1]^2 + X[2]^2)
      local x, y = X[1] / r, X[2] / r
      local u, s = lame(shape, r)
      local found = x * at "ux" + y * at "uy"
      local stress = x^2 * at "sxx" + 2 * x * y * at "sxy" + y^2 * at "syy"
      for j, term in ipairs { found - u, u, stress - s, s } do squares[j] = squares[j] + term^2 end
    end
  end
  return math.sqrt(squares[1] / squares[2]), math.sqrt(squares[3] / squares[4])
end

--- The rate of convergence between the last two meshes; nil with one mesh.
local function rate(list)
  local n, counts = #list, options.elements
  return n > 1 and math.log(list[n - 1] / list[n]) / math.log(counts[n] / counts[n - 1]) or nil
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

local results, tables = {}, {} -- results[shape][volumetric][order] = { displacement, stress }, lists of errors by mesh
local columns = { "order", "volumetric" }
for _, count in ipairs(options.elements) do columns[#columns + 1] = ("%d × %d"):format(count, count) end
columns[#columns + 1] = "rate"
local formats = { "%s", "%s" }
for i = 3, #columns do formats[i] = i < #columns and "%.2g" or "%.1f" end

for _, shape in ipairs(options.shapes) do
  results[shape] = {}
  local rows, curves = { displacement = {}, stress = {} }, {}
  for i, order in ipairs(options.orders) do
    for _, volumetric in ipairs(options.volumetric) do
      local case = { displacement = {}, stress = {} }
      for n, count in ipairs(options.elements) do
        case.displacement[n], case.stress[n] = errors(shape, solved(shape, order, count, volumetric))
      end
      results[shape][volumetric] = results[shape][volumetric] or {}
      results[shape][volumetric][order] = case
      for quantity, list in pairs(case) do
        local row = table.move(list, 1, #list, 3, { order, volumetric })
        row[#columns] = rate(list)
        table.insert(rows[quantity], row)
      end
      curves[#curves + 1] = { x = options.elements, y = case.stress, label = order .. ", " .. volumetric, color = i,
                              dashed = volumetric == "pointwise", markers = true }
    end
  end
  for _, quantity in ipairs { "displacement", "stress" } do
    print(("\n%s: relative error of the radial %s\n"):format(shape, quantity))
    tables[shape .. "_" .. quantity] = { columns = columns, rows = rows[quantity], formats = formats }
    print(sg.table(tables[shape .. "_" .. quantity]))
  end
  sg.chart{ file = files(shape .. ".png"), title = ("Thick %s, ν = %g: error of the stress"):format(shape, nu),
            xlabel = "elements along a side", ylabel = "relative error of the radial stress", log = "xy",
            table.unpack(curves) }
end
page.fill(options, "locking", "locking_ring", tables)
files:report()
return results
