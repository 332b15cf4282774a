-- Contact patch test by formulation: deviation of the pressure from a uniform one over the number of contact points.
--
-- Problem: patch_test.lua with 3 elements under 5, straight and skewed meshes, either block as slave.
--
--           p0 = 0.04, per reference area
--         ↓ ↓ ↓ ↓ ↓ ↓ ↓ ↓
--        ┌──┬──┬─┬──┬────┐    upper block 2 × 1 (2 × 2 × 1), E = 2, nu = 0.3, 5 elements along the face
--        ├───┬────┬──────┤    lower block 2 × 1 (2 × 2 × 1), E = 1, nu = 0.3, 3 elements along the face
--        └───┴────┴──────┘    sides guided, no friction, normal penalty 100, linear elastic
--
--          skew: the blocks consist of two parts (in 3D four) with slanted borders, in opposite directions; functions
--          are only C⁰ there.
-- Source: R. L. Taylor and P. Papadopoulos, On a patch test for contact problems in two dimensions, in: Nonlinear
--         Computational Mechanics, Springer, 1991; two half passes: R. A. Sauer and L. De Lorenzis, CMAME 253 (2013).
-- Units: errors relative to p0.
-- Expected: two half passes are uniform to rounding error (below 1e-12) for any number of points. In one pass the error
--           is that of the quadrature of the master's functions and falls with the number n of points, as n^-3 (N2 and
--           N2-N2.2) on straight meshes and as n^-2 on skewed ones. With the coarser block as slave mortar has at most
--           a third of the error of Gauss points.
-- Run: signorini -q formulations/uniform_pressure.lua [dimensions=2,3] [orders=N2,N2-N2.2] [formulations=…]
--      [skews=0,0.2] [points=20] [points_3d=8] [out=out/formulations/uniform_pressure]; points, points_3d: largest
--      number of points per element and direction, from p + 1 on, p the degree on the face; in 3D the first order only.

local sg = require "signorini"
local chart = require "formulations.chart"
local formulations = require "formulations.rows"
local problem = require "problems.patch_test.problem"

local options = sg.arguments{
  dimensions = { { 2, 3 }, choices = { 2, 3 } }, orders = { "N2", "N2-N2.2" },
  formulations = formulations.argument(formulations.names), skews = { { 0.0, 0.2 }, at_least = 0, below = 0.5 },
  points = 20, points_3d = 8, out = "out/formulations/uniform_pressure",
}

-- ── Solving ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Degree of an order's functions on the face: N2-N2.1x2 has 2 + 1.
local function degree_of(order)
  local degree, elevations = order:match "[^-]*$":match "^%a(%d+)%.?(%d*)"
  return math.tointeger(tonumber(degree)) + (math.tointeger(tonumber(elevations)) or 0)
end

--- Solves a case { dimension, order, formulation, slave, skew, points }; adds error, or reason if it failed.
local function solve(case)
  case.lower, case.upper = 3, 5
  local model = problem.scene(case)
  local run = model:run({ problem.stage }, sg.plain{})
  if run.failed then
    case.reason = run.cause or run.reason
    return case
  end
  case.error = problem.pressure_error(model:profile "joint")
  return case
end

--- One series per dimension, order, formulation, slave and skew: a list of cases by number of points.
local series = {}
for _, dimension in ipairs(options.dimensions) do
  for k, order in ipairs(options.orders) do
    for _, skew in ipairs(dimension == 3 and k > 1 and {} or options.skews) do
      for _, slave in ipairs { "lower", "upper" } do
        for _, formulation in ipairs(formulations.of(options.formulations)) do
          local degree = degree_of(order)
          local one = { dimension = dimension, order = order, skew = skew, slave = slave, formulation = formulation,
                        degree = degree }
          for points = degree + 1, math.max(dimension == 2 and options.points or options.points_3d, degree + 2) do
            one[#one + 1] = solve{ dimension = dimension, order = order, skew = skew, slave = slave, points = points,
                                   formulation = formulation }
            collectgarbage() -- Lua does not count the memory of models and would keep hundreds
          end
          series[#series + 1] = one
        end
      end
    end
  end
end

-- ── Output ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The error with a multiple of p + 1 points, or the reason of the failure; nil if it was not run.
local function entry(one, points)
  local case = one[points - one.degree]
  return case and (case.error and ("%.1e"):format(case.error) or case.reason) or nil
end

local rows, data = {}, { columns = { "dimension", "order", "skew", "slave", "formulation", "points", "error" },
                         rows = {}, comments = { "largest deviation of the contact pressure relative to p0" } }
for i, one in ipairs(series) do
  local p1, last = one.degree + 1, one[#one]
  rows[i] = { one.dimension .. "D", one.order, one.skew, one.slave, one.formulation.label, entry(one, p1),
              entry(one, 2 * p1), entry(one, 3 * p1), entry(one, last.points) }
  for _, case in ipairs(one) do
    data.rows[#data.rows + 1] = { case.dimension, case.order, case.skew, case.slave, case.formulation.name, case.points,
                                  case.error }
  end
end
print "Patch test, 3 elements under 5: largest error of the pressure relative to p0 by points per element and direction"
print(sg.table{ columns = { "", "order", "skew", "slave", "formulation", "p+1", "2(p+1)", "3(p+1)", "most" },
                rows = rows, formats = { skew = "%g" } })

local files = sg.files(options.out)
sg.csv.write(files "errors.csv", data)

--- The series of a formulation for one dimension, order and slave, and the first skew.
local function series_of(formulation, dimension, order, slave)
  for _, one in ipairs(series) do
    if one.formulation == formulation and one.dimension == dimension and one.order == order and one.slave == slave and
       one.skew == options.skews[1] then
      return one
    end
  end
end

for _, dimension in ipairs(options.dimensions) do
  for k, order in ipairs(options.orders) do
    for _, slave in ipairs(dimension == 3 and k > 1 and {} or { "lower", "upper" }) do
      local degree, points = degree_of(order), {}
      local most = math.max(dimension == 2 and options.points or options.points_3d, degree + 2)
      for count = degree + 1, most do points[#points + 1] = count end
      chart(files, ("%dd_%s_%s.png"):format(dimension, order, slave), formulations.of(options.formulations), points,
        function(formulation, i) return series_of(formulation, dimension, order, slave)[i].error end,
        { log = "xy", xlabel = "points per element and direction", ylabel = "largest error of p / p_0",
          title = ("Patch test in %dD, %s: 3 elements under 5, slave %s"):format(dimension, order, slave) })
    end
  end
end
files:report()

return { series = series, files = files }
