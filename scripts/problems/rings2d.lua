-- Two elastic rings in frictional contact: effect of varying-order layers on the contact pressure.
--
-- Problem: two half rings touch at their apexes; the flat ends of the upper ring are pushed down by 4. Half model.
--
--              | |     | |    upper: radii 10 and 8, E = 100, flat ends pushed down by 4 in 40 steps, u_x = 0
--              \ \_____/ /
--               \___.___/     both apexes on the line of symmetry x = 0, where u_x = 0
--              /  _____  \
--             /  /     \  \   lower: radii 12 and 10, E = 300, flat ends fixed
--
--          Plane strain, neo-Hooke, nu = 0.3, mu = 0.1, penalties 100 (normal) and 10 (tangential), slave: upper ring.
--          Meshes: 12 × 3 (upper) and 20 × 3 elements (lower) over a quarter at m1; each further mesh halves every
--          angle, 3 elements in the thickness direction on every mesh. Reference: N2 at m3.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, section 7.3, Tables 7.5 and 7.6, Figures 7.18 to 7.20.
--         Plain Newton, as published.
-- Units: m, N, N/m²; L2 errors √∫ (p − p_ref)² dx in N/m²·√m.
-- Expected: the errors of Table 7.5 at m1 (p_N: N2 0.2438, N4 0.1745, N2-N4 0.1718, N2-N2.1 0.0710) to 10 %, at m2 N2
--           0.0343 to 5 %, N4 and N2-N4 to 15 %; N2-N2.1 at m2 is 1.0 to 3.1 times the printed 0.0034, depending on the
--           integration rule. All points slip except one to three at the apex: p_T = mu p_N, with a tenth of its
--           errors.
-- Run: signorini rings2d.lua [meshes=m1,m2] [orders=N2,N4,N2-N4,N2-N2.1] [reference=m3] [coordinate=x]
--      [repeats=3] [linear=auto] [out=out/rings2d] [page=none]; reference: mesh of the N2 reference solution;
--      coordinate: x (deformed) or X (undeformed); repeats: number of runs, of which the time is the median; page:
--      folder of rings2d.md, whose tables are filled.

local sg = require "signorini"
local page = require "page.tables"
local problem = require "problems.rings2d.problem"
local in_turns = require "studies.in_turns"

local picture_steps = { [10] = true, [20] = true, [30] = true, [40] = true }
--- Rules of integration of an error: quadrature points, zone (where either or both sides touch), and edge of a profile
--- (zero at the next open point, or at zero gap). The first one is that of the table.
local rules = {}
for _, way in ipairs { { "either", "point" }, { "either", "gap" }, { "both", "point" } } do
  for _, quadrature in ipairs { "profile", "reference", "union" } do
    rules[#rules + 1] = { quadrature = quadrature, zone = way[1], edge = way[2] }
  end
end

-- ── Pressures ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Contact states: their number, that of those that stick, and the largest
--- |p_T| / (mu p_N) − 1 of the others in size.
local function coulomb(profile)
  local count = { touching = 0, sticking = 0, deviation = 0 }
  for i, state in ipairs(profile.state) do
    if state ~= "open" then count.touching = count.touching + 1 end
    if state == "stick" then count.sticking = count.sticking + 1 end
    if state == "slip" then
      local ratio = math.abs(profile.traction[i]) / (problem.mu * profile.pressure[i])
      count.deviation = math.max(count.deviation, math.abs(ratio - 1))
    end
  end
  return count
end

--- L2 errors of both tractions by the first rule, and of the pressure by all of them.
local function measure(case, finest, coordinate)
  local function error_of(value, rule)
    return (sg.profile_error{ profile = case.profile, reference = finest.profile, coordinate = coordinate,
                              value = value, quadrature = rule.quadrature, zone = rule.zone, edge = rule.edge })
  end
  case.pT_error, case.errors = error_of("traction", rules[1]), {}
  for i, rule in ipairs(rules) do case.errors[i] = error_of("pressure", rule) end
  case.pN_error = case.errors[1]
  case.coulomb = coulomb(case.profile)
end

--- The row of a published table for an order and a mesh.
local function printed(rows, case)
  for _, row in ipairs(rows) do
    if row.discretization == case.order and row.mesh == case.mesh then return row end
  end
  return {}
end

--- A published table as a list of named rows.
local function published(name)
  local data, rows = sg.reference(name), {}
  for i, row in ipairs(data.rows) do
    rows[i] = {}
    for j, column in ipairs(data.columns) do rows[i][column] = row[j] end
  end
  return rows
end

-- ── Output ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local function deviation(value, reference) return reference and 100 * (value / reference - 1) or nil end

local function error_table(cases)
  local rows, reference = {}, published "rings2d_error_table7_5"
  for i, case in ipairs(cases) do
    local row = printed(reference, case)
    rows[i] = { case.order, case.mesh, case.pN_error, row.pN_L2_error, deviation(case.pN_error, row.pN_L2_error),
                case.pT_error, row.pT_L2_error, deviation(case.pT_error, row.pT_L2_error),
                case.coulomb.touching, case.coulomb.sticking, case.coulomb.deviation }
  end
  return {
    columns = { "order", "mesh", "p_N", "published", "differs", "p_T", "published", "differs", "touching", "sticking",
                "|p_T| / mu p_N − 1" },
    units = { "", "", "", "", "%", "", "", "%", "points", "points", "at most" }, rows = rows,
    formats = { "%s", "%s", "%.4g", "%.4g", "%.1f", "%.4g", "%.4g", "%.1f", "%d", "%d", "%.1e" },
  }
end

--- One row per rule, one column per case.
local function rule_table(cases)
  local columns, units, formats, last = { "points", "zone", "edge" }, { "", "", "" }, {}, { "published", "", "" }
  local reference, rows = published "rings2d_error_table7_5", {}
  for i, rule in ipairs(rules) do rows[i] = { rule.quadrature, rule.zone, rule.edge } end
  for i, case in ipairs(cases) do
    columns[3 + i], units[3 + i], formats[3 + i] = case.order, case.mesh, "%.4g"
    for k, row in ipairs(rows) do row[3 + i] = case.errors[k] end
    last[3 + i] = printed(reference, case).pN_L2_error
  end
  rows[#rows + 1] = last
  return { columns = columns, units = units, rows = rows, formats = formats }
end

local function time_table(cases)
  local rows, reference, unit = {}, published "rings2d_time_table7_6", nil
  for _, case in ipairs(cases) do
    if case.order == "N2" and case.mesh == "m1" then unit = case.times.processor end
  end
  for i, case in ipairs(cases) do
    local t = case.times
    rows[i] = { case.order, case.mesh, case.dofs, case.run.iterations / case.run.steps, 1e3 * t.wall, 1e3 * t.bulk,
                1e3 * t.contact, 1e3 * t.linear, 1e3 * t.rest, 1e3 * t.processor, unit and t.processor / unit,
                printed(reference, case).time_over_N2_m1 }
  end
  return {
    columns = { "order", "mesh", "DOFs", "iterations", "wall", "bulk", "contact", "linear", "rest", "processor",
                "over N2 m1", "published" },
    units = { "", "", "", "per step", "ms", "ms", "ms", "ms", "ms", "ms", "", "" }, rows = rows,
    formats = { "%s", "%s", "%d", "%.2f", "%.1f", "%.1f", "%.1f", "%.1f", "%.1f", "%.0f", "%.2f", "%.2f" },
  }
end

--- Figure 7.20: the size of one traction of all orders on one mesh over the ring's coordinate, the reference dashed.
local function draw_traction(cases, finest, mesh, value, coordinate, file)
  local name = value == "pressure" and "normal contact pressure" or "tangential contact traction"
  local chart = { file = file, title = ("Rings, mesh %s: %s at the last step"):format(mesh, name),
                  xlabel = ("%s of the contact point (m)"):format(coordinate),
                  ylabel = ("%s (N/m²)"):format(value == "pressure" and "p_N" or "|p_T|"),
                  inset = { xrange = { 2.95, 3.45 } } }
  local function curve(case, label, dashed)
    local x, y, profile = {}, {}, case.profile
    for i, p in ipairs(profile.pressure) do
      if p > 0 or (profile.pressure[i - 1] or 0) > 0 then
        x[#x + 1], y[#y + 1] = profile[coordinate][i], math.abs(profile[value][i])
      end
    end
    chart[#chart + 1] = { x = x, y = y, label = label, dashed = dashed, marker = "none" }
  end
  for _, case in ipairs(cases) do
    if case.mesh == mesh then curve(case, case.order, false) end
  end
  curve(finest, ("%s at %s"):format(finest.order, finest.mesh), true)
  sg.chart(chart)
end

local function write_profile(case, file)
  local data = { columns = { "x", "y", "pressure", "traction", "gap", "state" } }
  for _, name in ipairs(data.columns) do data[name] = case.profile[name] end
  sg.csv.write(file, data)
end

local function write_errors(cases, file)
  local columns, rows = { "discretization", "mesh", "points", "zone", "edge", "pN_L2_error" }, {}
  for _, case in ipairs(cases) do
    for i, rule in ipairs(rules) do
      rows[#rows + 1] = { case.order, case.mesh, rule.quadrature, rule.zone, rule.edge, case.errors[i] }
    end
  end
  sg.csv.write(file, { columns = columns, rows = rows })
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

local levels = { "m1", "m2", "m3", "m4", "m5" }
local options = sg.arguments{
  meshes = { { "m1", "m2" }, choices = levels }, orders = { "N2", "N4", "N2-N4", "N2-N2.1" },
  reference = { "m3", choices = levels }, coordinate = { "x", choices = { "x", "X" } }, repeats = 3, linear = "auto",
  out = "out/rings2d", page = "none",
}
local files, cases = sg.files(options.out), {}

local pictures = {}
local function keep_state(model, step)
  if not picture_steps[step] then return end
  pictures[#pictures + 1] = sg.picture{ model = model, field = "von_mises", label = "von Mises stress (N/m²)",
                                        mirror = "x", unit = "m", title = ("load step %d"):format(step) }
end

local list = { { "N2", options.reference } }
for _, mesh in ipairs(options.meshes) do
  for _, order in ipairs(options.orders) do list[#list + 1] = { order, mesh } end
end
local solved = in_turns(list, options.repeats,
  function(pair) return problem.solve(pair[1], pair[2], options.linear) end)
local finest = solved[1]
write_profile(finest, files(("%s_%s.csv"):format(finest.order, finest.mesh)))
for i = 2, #solved do
  local case = solved[i]
  measure(case, finest, options.coordinate)
  write_profile(case, files(("%s_%s.csv"):format(case.order, case.mesh)))
  cases[i - 1], cases[case.order .. " " .. case.mesh] = case, case
end
problem.solve(options.orders[1], options.meshes[1], options.linear, keep_state)

print(("\nL2 errors of the contact tractions against %s at %s over %s, with Table 7.5 (N/m²·√m)")
  :format(finest.order, finest.mesh, options.coordinate))
local errors, of_rules, times = error_table(cases), rule_table(cases), time_table(cases)
print(sg.table(errors))
print "\nError of p_N by rule of integration (arguments of sg.profile_error)"
print(sg.table(of_rules))
print(("\nTime, with Table 7.6, medians of %d (linear: factorization and solve)"):format(options.repeats))
print(sg.table(times))

write_errors(cases, files "errors.csv")
sg.sheet{ pictures, columns = 2, file = files "states.png",
          title = ("Rings, %s at %s"):format(options.orders[1], options.meshes[1]) }
for _, mesh in ipairs(options.meshes) do
  draw_traction(cases, finest, mesh, "pressure", options.coordinate, files(("pressure_%s.png"):format(mesh)))
  draw_traction(cases, finest, mesh, "traction", options.coordinate, files(("traction_%s.png"):format(mesh)))
end
page.fill(options, "rings2d", "rings2d", {
  errors = page.pick(errors, { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 }, { "discretization" }), rules = of_rules,
  times = page.pick(times, { 1, 2, 3, 4, 10, 11, 12 },
    { "discretization", "mesh", "DOFs", "iterations per step", "processor time (ms)", "over N2 m1", "Table 7.6" }),
})
files:report()

return { cases = cases, reference = finest, files = files }
