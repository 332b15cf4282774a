-- Contact patch test: uniform pressure on flat contact of matching and non-matching meshes.
--
-- Problem: one block lies on another; the upper one is supported by the contact alone and loaded by a uniform pressure.
--
--           p0 = 0.04, per reference area
--         ↓ ↓ ↓ ↓ ↓ ↓ ↓ ↓
--        ┌───┬───┬───┬───┐    upper block 2 × 1 (2 × 2 × 1), E = 2
--        │               │    sides = guided: nu = 0.3, no displacement across the lateral faces
--        ├────┬─────┬────┤    sides = free:   nu = 0, two neighboring lateral faces are free
--        │               │    lower block 2 × 1 (2 × 2 × 1), E = 1
--        └────┴─────┴────┘    u_y = 0 (u_z = 0); no friction, normal penalty 100
--
--          In both cases the exact solution is a uniform stress with a linear displacement, which any discretization
--          represents exactly. The error is due to quadrature: the points of the slave integrate the slave's functions
--          (polynomials in its elements) exactly, but the functions of the master have kinks inside slave elements.
--          Elements along the face: 3 and 5 (non-matching), 4 and 4 (matching), 2 and 6 (nested); 2 in the thickness
--          direction.
-- Source: the patch test for contact of R. L. Taylor and P. Papadopoulos, On a patch test for contact problems in two
--         dimensions, in: Nonlinear Computational Mechanics, Springer, 1991; closed forms. Plain Newton.
-- Units: any consistent units; pressures relative to E of the lower block, errors relative to p0.
-- Expected: contact pressure and stress uniform to rounding error (below 1e-11) if no boundary of a master element lies
--           inside a slave element: matching meshes, and nested meshes whose finer side is the slave. Otherwise the
--           error decreases with the number n of points as n^-(k+1), where the k-th derivative of the master's
--           functions is the first that jumps (1 for N1 and L2, 2 for N2 and N2-N2.2, 3 for N3), since Gauss quadrature
--           is not exact for (x − c)^k on x > c.
-- Run: signorini -q patch_test.lua [dimensions=2,3] [materials=linear,neo_hooke] [orders=N1,L2,N2,N3,N2-N2.2]
--      [points=20] [sides=guided] [penalties=10,100,1000,10000] [out=out/patch_test] [page=none]; points: largest
--      number of points per direction, from p + 1 on, p the degree on the face; page: folder of patch_test.md, whose
--      tables are filled.

local sg = require "signorini"
local page = require "page.tables"
local problem = require "problems.patch_test.problem"

local load = problem.load
--- Elements of the lower and the upper block along the face, and which of them is the slave.
local exact_pairs = { { "matching", 4, 4, "lower" }, { "matching", 4, 4, "upper" }, { "slave finer", 2, 6, "upper" } }
local pairs_with_kinks = { { "master finer", 2, 6, "lower" }, { "non-matching", 3, 5, "lower" },
                           { "non-matching", 3, 5, "upper" } }

--- Of an order's functions on the face: their degree, and the first derivative that jumps between elements.
local function smoothness(order)
  local kind, degree, elevations = order:match "([NL])(%d+)%.?(%d*)x?%d*$"
  degree, elevations = math.tointeger(tonumber(degree)), math.tointeger(tonumber(elevations)) or 0
  return degree + elevations, kind == "L" and 1 or degree
end

-- ── Solving ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The largest difference of the vertical stress from −p0 relative to p0, over 8 points per direction along the face
--- and 4 through each block; none of them on a border of elements.
local function stress_error(model, dimension)
  local largest, field = 0, dimension == 2 and "syy" or "szz"
  for _, name in ipairs { "lower", "upper" } do
    for i = 1, 15, 2 do
      for k = 1, 7, 2 do
        for j = 1, dimension == 2 and 1 or 15, 2 do
          local xi = dimension == 2 and { i / 16, k / 8 } or { i / 16, j / 16, k / 8 }
          largest = math.max(largest, math.abs(model:sample(name, field, xi) / -load - 1))
        end
      end
    end
  end
  return largest
end

--- Solves a scene and measures it.
local function solve(o)
  local model = problem.scene(o)
  local run = model:run({ problem.stage }, sg.plain{})
  if run.failed then
    error(("%s, %d|%d elements, %dD: %s"):format(o.order, o.lower, o.upper, o.dimension, run.failure), 0)
  end
  local case = { profile = model:profile "joint" }
  for key, value in pairs(o) do case[key] = value end
  case.pressure_error = problem.pressure_error(case.profile)
  case.stress_error = stress_error(model, o.dimension)
  local area = o.dimension == 2 and 2 or 4
  case.force_error = math.abs(run:column(o.dimension == 2 and "bed.fy" or "bed.fz")[2] / (load * area) - 1)
  return case
end

-- ── Studies ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- All cases with a list of pairs of meshes; `points` gives the numbers of points for an order's degree.
local function solve_all(options, list, points)
  local cases = {}
  for _, dimension in ipairs(options.dimensions) do
    for _, material in ipairs(options.materials) do
      for _, order in ipairs(options.orders) do
        for _, pair in ipairs(list) do
          for _, count in ipairs(points(smoothness(order))) do
            local case = solve{ dimension = dimension, material = material, order = order, sides = options.sides,
                                pair = pair[1], lower = pair[2], upper = pair[3], slave = pair[4], points = count }
            cases[#cases + 1] = case
            collectgarbage() -- Lua does not count the memory of models and would keep hundreds
          end
        end
      end
    end
  end
  return cases
end

--- Cases of one dimension, material, order, pair and slave, sorted by the number of points.
local function in_series(cases)
  local series = {}
  for _, case in ipairs(cases) do
    local name = ("%dD %s %s %s %s"):format(case.dimension, case.material, case.order, case.pair, case.slave)
    if not series[name] then
      series[name] = { name = name, first = case }
      series[#series + 1] = series[name]
    end
    table.insert(series[name], case)
  end
  return series
end

--- The exponent r of a row's error n^r over the number n of points, by least squares in logarithms.
local function exponent(row)
  local n, sx, sy, sxx, sxy = #row, 0, 0, 0, 0
  for _, case in ipairs(row) do
    local x, y = math.log(case.points), math.log(case.pressure_error)
    sx, sy, sxx, sxy = sx + x, sy + y, sxx + x * x, sxy + x * y
  end
  return (n * sxy - sx * sy) / (n * sxx - sx * sx)
end

--- Decrease of the error with the number n of points. It depends on the position of the kinks between the points, so
--- the exponent is that of all n from 8 to 63; the largest errors over three octaves are also listed. Plane, linear.
local function rate_study(options)
  local list, rates = {}, {}
  for _, pair in ipairs(pairs_with_kinks) do
    if pair[1] == "non-matching" then list[#list + 1] = pair end
  end
  local plane = { dimensions = { 2 }, materials = { "linear" }, orders = options.orders, sides = options.sides }
  local cases = solve_all(plane, list, function()
    local counts = {}
    for count = 8, 63 do counts[#counts + 1] = count end
    return counts
  end)
  for i, row in ipairs(in_series(cases)) do
    local octaves = { 0, 0, 0 }
    for _, case in ipairs(row) do
      local octave = case.points < 16 and 1 or case.points < 32 and 2 or 3
      octaves[octave] = math.max(octaves[octave], case.pressure_error)
    end
    local _, jump = smoothness(row.first.order)
    rates[i] = { order = row.first.order, slave = row.first.slave, octaves = octaves, expected = -(jump + 1),
                 exponent = exponent(row) }
  end
  return rates
end

--- Effect of the penalty on the errors: plane, N2 and N2-N2.2, the finer mesh as slave.
local function penalty_study(options)
  local cases = {}
  for _, order in ipairs { "N2", "N2-N2.2" } do
    for _, value in ipairs(options.penalties) do
      local case = solve{ dimension = 2, material = "linear", order = order, sides = options.sides, penalty = value,
                          lower = 3, upper = 5, slave = "upper", points = 3 * (smoothness(order) + 1) }
      cases[#cases + 1] = case
    end
  end
  return cases
end

-- ── Output ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Of each dimension, material and order: the largest error over the pairs and the numbers of points.
local function exact_table(cases)
  local rows = {}
  for _, case in ipairs(cases) do
    local name = ("%dD %s %s"):format(case.dimension, case.material, case.order)
    local row = rows[name]
    if not row then
      row = { case.dimension .. "D", case.material, case.order, 0, 0, 0 }
      rows[name], rows[#rows + 1] = row, row
    end
    for i, key in ipairs { "pressure_error", "stress_error", "force_error" } do
      row[3 + i] = math.max(row[3 + i], case[key])
    end
  end
  return { columns = { "", "material", "order", "pressure", "stress", "force" }, rows = rows,
           formats = { "%s", "%s", "%s", "%.1e", "%.1e", "%.1e" } }
end

--- Errors of the pressure at p + 1, 2 (p + 1), 3 (p + 1) and the most points; of the stress at 3 (p + 1) and the most.
local function error_table(series)
  local rows = {}
  for i, row in ipairs(series) do
    local first, at = row.first, {}
    for _, case in ipairs(row) do at[case.points] = case end
    local function value(times, key)
      local case = at[times * (smoothness(first.order) + 1)]
      return case and case[key]
    end
    local most = row[#row]
    rows[i] = { first.dimension .. "D", first.material, first.order, first.pair, first.slave,
                value(1, "pressure_error"), value(2, "pressure_error"), value(3, "pressure_error"), most.pressure_error,
                value(3, "stress_error"), most.stress_error }
  end
  return {
    columns = { "", "material", "order", "meshes", "slave", "p+1", "2(p+1)", "3(p+1)", "most", "stress 3(p+1)",
                "most" }, rows = rows,
    formats = { "%s", "%s", "%s", "%s", "%s", "%.1e", "%.1e", "%.1e", "%.1e", "%.1e", "%.1e" },
  }
end

local function rate_table(rates)
  local rows = {}
  for i, r in ipairs(rates) do
    rows[i] = { r.order, r.slave, r.octaves[1], r.octaves[2], r.octaves[3], r.exponent, r.expected }
  end
  return { columns = { "order", "slave", "n = 8…15", "16…31", "32…63", "exponent", "expected" }, rows = rows,
           formats = { "%s", "%s", "%.1e", "%.1e", "%.1e", "%.2f", "%d" } }
end

local function penalty_table(cases)
  local rows = {}
  for i, case in ipairs(cases) do
    rows[i] = { case.order, case.penalty, case.points, case.pressure_error, case.stress_error }
  end
  return { columns = { "order", "penalty", "points", "pressure", "stress" }, rows = rows,
           formats = { "%s", "%g", "%d", "%.1e", "%.1e" } }
end

--- The error of the pressure over the number of points, by order; non-matching meshes, one material.
local function draw_errors(series, dimension, material, slave, file)
  local chart = { file = file, title = ("Patch test in %dD: 5 elements on 3, slave %s"):format(dimension, slave),
                  log = "xy", xlabel = "points per element and direction", ylabel = "largest error of p / p_0" }
  for _, row in ipairs(series) do
    local first = row.first
    if first.dimension == dimension and first.material == material and first.pair == "non-matching" and
       first.slave == slave then
      local line = { x = {}, y = {}, label = first.order, markers = true }
      for i, case in ipairs(row) do line.x[i], line.y[i] = case.points, case.pressure_error end
      chart[#chart + 1] = line
    end
  end
  sg.chart(chart)
end

local function draw_pressure(options, file)
  local order = options.orders[1]
  for _, name in ipairs(options.orders) do order = name == "N2" and name or order end
  local degree = smoothness(order)
  local chart = { file = file, title = ("Patch test in 2D, %s: 3 elements under 5, slave upper"):format(order),
                  xlabel = "x", ylabel = "p / p_0" }
  for _, times in ipairs { 1, 2, 3 } do
    local case = solve{ dimension = 2, material = options.materials[1], order = order, lower = 3, upper = 5,
                        slave = "upper", points = times * (degree + 1), sides = options.sides }
    local line = { x = case.profile.x, y = {}, label = ("%d points"):format(case.points), marker = "none" }
    for i, pressure in ipairs(case.profile.pressure) do line.y[i] = pressure / load end
    chart[times] = line
  end
  sg.chart(chart)
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

local options = sg.arguments{
  dimensions = { { 2, 3 }, choices = { 2, 3 } },
  materials = { { "linear", "neo_hooke" }, choices = { "linear", "neo_hooke" } },
  orders = { "N1", "L2", "N2", "N3", "N2-N2.2" }, points = 20, sides = { "guided", choices = { "guided", "free" } },
  penalties = { { 10.0, 100.0, 1000.0, 10000.0 }, above = 0 }, out = "out/patch_test",
  page = "none",
}
local files = sg.files(options.out)

local exact = solve_all(options, exact_pairs, function(degree) return { degree + 1, 3 * (degree + 1) } end)
print(("Largest errors relative to p0 where the master has no kink inside the slave's elements, sides %s")
  :format(options.sides))
local tables = { exact = exact_table(exact) }
print(sg.table(tables.exact))

local cases = solve_all(options, pairs_with_kinks, function(degree)
  local counts = {}
  for count = degree + 1, math.max(options.points, degree + 2) do counts[#counts + 1] = count end
  return counts
end)
local series = in_series(cases)
print "\nWith kinks: largest errors of the pressure and of the stress by points per element and direction"
tables.errors = error_table(series)
print(sg.table(tables.errors))
local rates, penalties = {}, {}
if options.dimensions[1] == 2 or options.dimensions[2] == 2 then
  rates = rate_study(options)
  print "\nDecrease of the pressure error with the number of points: 2D, linear, 3 elements under 5"
  tables.rates = rate_table(rates)
  print(sg.table(tables.rates))
  penalties = penalty_study(options)
  print "\nEffect of the penalty: 2D, linear, 3 elements under 5, slave upper, 3(p+1) points"
  tables.penalty = penalty_table(penalties)
  print(sg.table(tables.penalty))
  draw_pressure(options, files "pressure.png")
end

local data = { columns = { "dimension", "material", "order", "meshes", "slave", "points", "pressure_error",
                           "stress_error" }, rows = {},
               comments = { "largest errors relative to p0, sides " .. options.sides } }
for i, case in ipairs(cases) do
  data.rows[i] = { case.dimension, case.material, case.order, case.pair, case.slave, case.points, case.pressure_error,
                   case.stress_error }
end
sg.csv.write(files "errors.csv", data)
for _, dimension in ipairs(options.dimensions) do
  for _, slave in ipairs { "lower", "upper" } do
    draw_errors(series, dimension, options.materials[1], slave, files(("error_%dd_%s.png"):format(dimension, slave)))
  end
end
local plain = { columns = tables.errors.columns, formats = tables.errors.formats, rows = {} }
for _, row in ipairs(tables.errors.rows) do
  if row[2] == "linear" and row[4] == "non-matching" then plain.rows[#plain.rows + 1] = row end
end
tables.errors = page.pick(plain, { 1, 3, 5, 6, 7, 8, 9, 10 },
  { "", "order", "slave", "p + 1", "2(p + 1)", "3(p + 1)", ("%d points"):format(options.points), "stress, 3(p + 1)" })
tables.exact = page.across(tables.exact, { 1, 2 }, 3, { 4 }, { "", "material", "%s" })
page.fill(options, "patch_test", "patch_test", tables)
files:report()

return { exact = exact, cases = cases, series = series, rates = rates, penalties = penalties, files = files }
