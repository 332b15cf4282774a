-- Hertz contact by formulation: error and oscillation of the pressure against the best-tuned penalty of Gauss points.
--
-- Problem: problems=line: a quarter of a hollow cylinder on a rigid plane (hertz2d.lua, load=force); problems=sphere: a
--          hollow sphere on a rigid plane as an axisymmetric model (hertz_sphere.lua); without friction.
--
--         x = 0   ______   uniform load on the cut y = 0
--        u_x = 0 |  cut |
--                 \    /   quarter ring, linear elastic, E = 1, nu = 0.3
--          _______|\__/____   rigid plane
--
--          Each formulation is solved with all penalties, those with multipliers without any; the best one is that of
--          the smallest error. The error is that
--          of the pressure inside 0.8 of the half-width a against mortar with reduced multipliers, N2-N2.2 and the
--          penalty 1e6 on the finest mesh, in units of Hertz's peak pressure: L2 over x/a, largest, and oscillation
--          (its root mean square minus the best fit by an ellipse and a parabola); all pressures per current area.
-- Source: K. L. Johnson, Contact Mechanics, Cambridge, 1985, sections 4.2(a) and 4.2(c); meshes of V. Agrawal, An
--         Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of Contact
--         Problems, PhD thesis, IIT Guwahati, 2020, sections 6.1 and 6.3; mortar contact: L. De Lorenzis and others,
--         IJNME 87 (2011); over-constraint: L. De Lorenzis, P. Wriggers, T. J. R. Hughes, GAMM-Mitteilungen 37 (2014).
-- Units: any consistent units; lengths relative to the outer radius, pressures to Young's modulus.
-- Expected: mortar with equal multipliers has its smallest error at high penalties, except with N2 on m1 to m3. Line
--           contact at m4: N2 1.7e-4 against 7.9e-4 of Gauss points at their best penalty, in 15 against 39 iterations;
--           N2-N2.2 8e-5 against 1.0e-4, in 37 against 80. At 1e6 plain Newton fails with Gauss points and N2-N2.2.
--           With N2 reduced multipliers are constant per element: their error is that of a staircase, 1.6e-2 at m3.
--           Forces under a given displacement approach their limit as 1/penalty. On the coarsest mesh of the sphere no
--           element of N2 overlaps the plane on average: reduced multipliers start from a singular tangent.
-- Run: signorini -q formulations/hertz_pressure.lua [problems=line,sphere] [meshes=m1,m2,m3,m4,m5]
--      [orders=N2,N2-N2.2] [formulations=…] [penalties=2e2,5e2,1e3,2e3,5e3,1e4,1e5,1e6] [reference=m6] [steps=4]
--      [drift=m3] [out=out/formulations/hertz_pressure]; drift: mesh on which forces under a given displacement are
--      compared over the penalties.

local sg = require "signorini"
local chart = require "formulations.chart"
local deviation = require "formulations.deviation"
local formulations = require "formulations.rows"

local problems = { line = require "problems.hertz2d.problem", sphere = require "problems.hertz_sphere.problem" }
local levels = { "m1", "m2", "m3", "m4", "m5", "m6" }
local on_obstacles = formulations.where(function(row) return not row.two_faces end)
local options = sg.arguments{
  problems = { { "line", "sphere" }, choices = { "line", "sphere" } },
  meshes = { { "m1", "m2", "m3", "m4", "m5" }, choices = levels }, orders = { "N2", "N2-N2.2" },
  formulations = { on_obstacles, choices = on_obstacles },
  penalties = { { 2e2, 5e2, 1e3, 2e3, 5e3, 1e4, 1e5, 1e6 }, above = 0 },
  reference = { "m6", choices = levels }, steps = 4, drift = { "m3", choices = levels },
  out = "out/formulations/hertz_pressure",
}
local part = 0.8 -- of the half-width

-- ── Solving ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Solves a case { problem, order, mesh, formulation, penalty, load }; adds run, outcome, and what is measured.
local function solve(case)
  local problem = problems[case.problem]
  local model, stage = problem.scene{ order = case.order, mesh = case.mesh, load = case.load or "force",
                                      penalty = case.penalty ~= "none" and case.penalty or nil,
                                      formulation = case.formulation }
  stage.steps = options.steps
  local run = model:run({ stage }, sg.plain{ step = { adaptive = true } })
  case.run, case.outcome = run, run.cause or run.reason
  if run.failed then return case end
  case.profile, case.force = model:profile "ground", run:column "ground.fy"[run.steps]
  case.pressure = deviation.cauchy_pressures(case.profile, case.formulation, case.problem == "sphere")
  local resultant = model:contact_resultant "ground"
  case.penetration = case.formulation.keys.method == "mortar" and resultant.weighted_penetration or
                     resultant.max_penetration
  return case
end

--- The reference of a problem: { pressure (a function of x/a, in units of p0), a, p0 }.
local function reference_of(name)
  local case = solve{ problem = name, order = "N2-N2.2", mesh = options.reference,
                      formulation = formulations.reduced, penalty = 1e6 }
  if case.run.failed then error(("reference of %s: %s"):format(name, case.run.failure), 0) end
  local a = sg.profile_edges{ profile = case.profile }.to
  local _, p0 = problems[name].hertz(name == "line" and 2 * case.force or case.force)
  local s, p = {}, {}
  for i, x in ipairs(case.profile.x) do s[i], p[i] = x / a, case.pressure[i] / p0 end
  return { pressure = deviation.interpolant(s, p), a = a, p0 = p0, case = case }
end

--- Adds the errors of a case inside 0.8 a.
local function measure(case, reference)
  if not case.profile then return end
  local s, p = {}, {}
  for i, x in ipairs(case.profile.x) do s[i], p[i] = x / reference.a, case.pressure[i] / reference.p0 end
  for key, value in pairs(deviation.inside(s, p, reference.pressure, part)) do case[key] = value end
end

local function key(...) return table.concat({ ... }, " ") end

--- The penalties with which a formulation is solved; none for multipliers, whose results do not depend on them.
local function penalties_of(formulation)
  return formulation.keys.enforcement == "multipliers" and { "none" } or options.penalties
end

--- All cases, also by problem, order, mesh, formulation and penalty.
local cases, references = {}, {}
for _, name in ipairs(options.problems) do
  references[name] = reference_of(name)
  for _, mesh in ipairs(options.meshes) do
    for _, order in ipairs(options.orders) do
      for _, formulation in ipairs(formulations.of(options.formulations)) do
        for _, penalty in ipairs(penalties_of(formulation)) do
          local case = solve{ problem = name, order = order, mesh = mesh, formulation = formulation,
                              penalty = penalty }
          measure(case, references[name])
          cases[#cases + 1] = case
          cases[key(name, order, mesh, formulation.name, penalty)] = case
          collectgarbage() -- Lua does not count the memory of models
        end
      end
    end
  end
end

--- The case of the smallest error over the penalties, also by problem, order, mesh and formulation.
local best = {}
for _, case in ipairs(cases) do
  local name = key(case.problem, case.order, case.mesh, case.formulation.name)
  local known = best[name]
  if not known then
    best[#best + 1], best[name] = name, case
  elseif case.l2 and not (known.l2 and known.l2 <= case.l2) then
    best[name] = case
  end
end

-- ── Forces over the penalty ──────────────────────────────────────────────────────────────────────────────────────────

--- Of each formulation the forces under a given displacement, line contact, relative to that at the highest penalty
--- that converged.
local function drift_of_forces()
  local rows = {}
  for _, order in ipairs(options.orders) do
    for _, formulation in ipairs(formulations.of(options.formulations)) do
      local forces, row, last = {}, { order, formulation.label }, nil
      for i, penalty in ipairs(options.penalties) do
        forces[i] = solve{ problem = "line", order = order, mesh = options.drift, formulation = formulation,
                           penalty = penalty, load = "displacement" }.force
        last = forces[i] or last
      end
      for i = 1, #options.penalties do row[2 + i] = forces[i] and math.abs(forces[i] / last - 1) end
      rows[#rows + 1] = row
    end
  end
  return rows
end

-- ── Output ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local function text_of(penalty) return penalty == "none" and penalty or ("%g"):format(penalty) end

local rows = {}
for i, name in ipairs(best) do
  local case = best[name]
  rows[i] = { case.problem, case.order, case.mesh, case.formulation.label, case.l2 and text_of(case.penalty), case.l2,
              case.largest, case.oscillation, case.penetration, case.run.iterations,
              case.run.cutbacks, not case.l2 and case.outcome or nil }
end
print "Pressure inside 0.8 a against the finest mesh, at the penalty of the smallest L2 error of each formulation"
print(sg.table{
  columns = { "", "order", "mesh", "formulation", "penalty", "L2 error", "largest", "oscillation", "penetration",
              "iterations", "cuts", "failed" },
  units = { "", "", "", "", "", "of p_0", "of p_0", "of p_0", "R", "", "", "" }, rows = rows,
  formats = { ["L2 error"] = "%.1e", largest = "%.1e", oscillation = "%.1e", penetration = "%.1e" } })

local drift = drift_of_forces()
local drift_columns, drift_formats = { "order", "formulation" }, {}
for _, penalty in ipairs(options.penalties) do
  local name = ("%g"):format(penalty)
  drift_columns[#drift_columns + 1], drift_formats[name] = name, "%.1e"
end
print(("\nForce under a given displacement, line contact at %s: relative difference from that at the highest penalty")
  :format(options.drift))
print(sg.table{ columns = drift_columns, rows = drift, formats = drift_formats })

local files = sg.files(options.out)
local data = { columns = { "problem", "order", "mesh", "formulation", "penalty", "l2", "largest", "oscillation",
                           "penetration", "iterations" }, rows = {}, comments = { "inside 0.8 a, of p0" } }
for i, case in ipairs(cases) do
  data.rows[i] = { case.problem, case.order, case.mesh, case.formulation.name, text_of(case.penalty), case.l2,
                   case.largest, case.oscillation, case.penetration, case.run.iterations }
end
sg.csv.write(files "cases.csv", data)

local ticks, numbers = {}, {}
for i, mesh in ipairs(options.meshes) do ticks[i], numbers[i] = { i, mesh }, i end
local titles = { line = "Hertz, line contact", sphere = "Hertz, sphere" }
local middle = options.meshes[(#options.meshes + 1) // 2]
for _, name in ipairs(options.problems) do
  for _, order in ipairs(options.orders) do
    local shown = formulations.of(options.formulations)
    chart(files, ("%s_%s_mesh.png"):format(name, order), shown, numbers,
      function(formulation, i) return best[key(name, order, options.meshes[i], formulation.name)].l2 end,
      { log = "y", xlabel = "mesh", xticks = ticks, ylabel = "L2 error of p / p_0 inside 0.8 a",
        title = ("%s, %s: error at the best penalty"):format(titles[name], order) })
    chart(files, ("%s_%s_penalty.png"):format(name, order), shown, options.penalties,
      function(formulation, i)
        local penalties = penalties_of(formulation)
        return cases[key(name, order, middle, formulation.name, penalties[math.min(i, #penalties)])].l2
      end,
      { log = "xy", xlabel = "penalty (E / R)", ylabel = "L2 error of p / p_0 inside 0.8 a",
        title = ("%s, %s at %s: error over the penalty"):format(titles[name], order, middle) })
  end
end
files:report()

return { cases = cases, best = best, drift = drift, references = references, files = files }
