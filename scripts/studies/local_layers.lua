-- Local layers and layer knots: where the contact rows of Hertz's problems need a higher degree, and where more knots.
--
-- Problem: the line contact of hertz2d.lua (load by force), the sphere of hertz_sphere.lua
--          (axisymmetric) and its eighth of hertz3d.lua (solid). Variants on each mesh: N2; N2-N2.2 on the
--          whole face; N2-N2.2 in r < 1.2 a (local), a the half-width or radius of contact; N2-N2.2 in 0.8 a < r < 1.2
--          a (edge); N2 with `knots` parts of each element of the contact row in 0.8 a < r < 1.2 a (knots); and both
--          (edge, knots). In the solid r < 1.2 a is a strip along the meridian, all around.
-- Source: Hertz's closed forms for a and the peak; K. L. Johnson, Contact Mechanics, Cambridge, 1985. The error is that
--         of the pressure against N2-N2.2 on a fine mesh, for the solid of the axisymmetric sphere, whose states its
--         function space contains; so it is free of the finite size and of the penalty. Plain Newton.
-- Units: any consistent units; errors relative to the peak pressure, lengths to a.
-- Expected: the local layer has the error of the full one to 3 %, from m2 on the edge, too; knots alone halve that of
--           N2 on the sphere; see share/doc/decide/layers.md.
-- Run: signorini local_layers.lua [problems=line,sphere,solid] [meshes=m1,m2,m3] [solid=m1,m2] [reference=m5]
--      [knots=2] [steps=5] [repeats=3] [out=out/local_layers]; solid: meshes of the solid.

local sg = require "signorini"
local in_turns = require "studies.in_turns"
local line = require "problems.hertz2d.problem"
local sphere = require "problems.hertz_sphere.problem"
local solid = require "problems.hertz3d.problem"

-- ── Scenes ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local problems = {}

--- Each returns the model, its stage, the body's degrees of freedom, and Hertz's a and peak pressure.
function problems.line(o)
  local a, peak = line.hertz(2 * line.half_load * line.outer)
  o.load = "force"
  local model, stage, body = line.scene(o)
  return model, stage, body:dofs(), a, peak
end

function problems.sphere(o)
  local a, peak = sphere.hertz(sphere.load)
  local model, stage, body = sphere.scene(o)
  return model, stage, body:dofs(), a, peak
end

function problems.solid(o)
  local a, peak = solid.hertz(solid.load)
  local scene = solid.solid(o)
  return scene.model, { name = "press", push = scene.target }, scene.dofs, a, peak
end

--- The variants with the condition on r/a where the layer is.
local variants = {
  { name = "N2", order = "N2" },
  { name = "N2-N2.2", order = "N2-N2.2" },
  { name = "N2-N2.2, local", order = "N2-N2.2", low = -1, high = 1.2 },
  { name = "N2-N2.2, edge", order = "N2-N2.2", low = 0.8, high = 1.2 },
  { name = "N2, knots", order = "N2", low = 0.8, high = 1.2, knots = true },
  { name = "N2-N2.2, edge, knots", order = "N2-N2.2", low = 0.8, high = 1.2, knots = true },
}

local radius_of_contact = { line = line.hertz(2 * line.half_load * line.outer), sphere = sphere.hertz(sphere.load),
                            solid = solid.hertz(solid.load) }

--- Solves a case { problem, variant, mesh } and adds its measures.
local function solve(case, options)
  local began, a = sg.wall_time(), radius_of_contact[case.problem]
  local variant = case.variant
  local model, stage, dofs, _, peak = problems[case.problem]{
    order = variant.order, mesh = case.mesh, layer_knots = variant.knots and options.knots or nil,
    layer = variant.low and function(X)
      local r = X[3] and math.sqrt(X[1] ^ 2 + X[2] ^ 2) or X[1]
      return r > variant.low * a and r < variant.high * a
    end or nil }
  stage.steps = options.steps
  local run = model:run({ stage }, sg.plain{})
  if run.failed then error(("%s, %s at %s: %s"):format(case.problem, variant.name, case.mesh, run.failure), 0) end
  local profile = model:profile "ground"
  if case.problem == "solid" then profile = solid.ring_profile(profile) end
  return { problem = case.problem, name = variant.name, order = variant.order, mesh = case.mesh, dofs = dofs,
           profile = profile, run = run, a = a, p0 = peak, wall = sg.wall_time() - began, model = model }
end

-- ── Output ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local function case_table(cases)
  local rows, before = {}, {}
  for i, case in ipairs(cases) do
    local key = case.problem .. case.name
    local old = before[key]
    case.rate = old and math.log(old.error / case.error, 2) or nil
    before[key] = case
    rows[i] = { case.problem, case.name, case.mesh, case.dofs.total, case.dofs.interface, case.error, case.rate,
                case.run.iterations, case.times.wall }
  end
  return sg.table{
    columns = { "problem", "variant", "mesh", "DOFs", "on the face", "L2 error", "rate", "iterations", "wall" },
    units = { "", "", "", "", "", "", "", "", "s" }, rows = rows,
    formats = { "%s", "%s", "%s", "%d", "%d", "%.2e", "%.2f", "%d", "%.3f" },
  }
end

--- The errors of a problem over `abscissa` of a case.
local function draw_errors(cases, problem, file, xlabel, abscissa)
  local chart = { file = file, title = ("Hertz, %s: error of the contact pressure"):format(problem), log = "xy",
                  xlabel = xlabel, ylabel = "L2 error of p / p_max" }
  for _, variant in ipairs(variants) do
    local curve = { x = {}, y = {}, label = variant.name, markers = true }
    for _, case in ipairs(cases) do
      if case.problem == problem and case.name == variant.name then
        curve.x[#curve.x + 1], curve.y[#curve.y + 1] = abscissa(case), case.error
      end
    end
    chart[#chart + 1] = curve
  end
  sg.chart(chart)
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

local levels = { "m1", "m2", "m3", "m4", "m5", "m6" }
local options = sg.arguments{
  problems = { { "line", "sphere", "solid" }, choices = { "line", "sphere", "solid" } },
  meshes = { { "m1", "m2", "m3" }, choices = levels }, solid = { { "m1", "m2" }, choices = levels },
  reference = { "m5", choices = levels }, knots = { 2, at_least = 1 }, steps = 5, repeats = 3, out = "out/local_layers",
}
local files, references, list = sg.files(options.out), {}, {}
for _, problem in ipairs(options.problems) do
  local name = problem == "solid" and "sphere" or problem
  references[problem] = references[name]
    or solve({ problem = name, variant = variants[2], mesh = options.reference }, options)
  for _, mesh in ipairs(problem == "solid" and options.solid or options.meshes) do
    for _, variant in ipairs(variants) do list[#list + 1] = { problem = problem, variant = variant, mesh = mesh } end
  end
end
local cases = in_turns(list, options.repeats, function(case, k)
  local solved = solve(case, options)
  if k > 1 then solved.model = nil end
  return solved
end)
for _, case in ipairs(cases) do
  case.error = sg.profile_error{ profile = case.profile, reference = references[case.problem].profile,
                                 normalize = "max", coordinate = function(point) return point.x / case.a end }
  cases[("%s %s %s"):format(case.problem, case.name, case.mesh)] = case
end

print(("\nError of the pressure against N2-N2.2 at %s, rate from mesh to mesh, time with setup as median of %d")
  :format(options.reference, options.repeats))
print(case_table(cases))
for _, problem in ipairs(options.problems) do
  draw_errors(cases, problem, files(problem .. "_dofs.png"), "degrees of freedom",
    function(case) return case.dofs.total end)
  draw_errors(cases, problem, files(problem .. "_time.png"), "time in s", function(case) return case.times.wall end)
end
files:report()

return { cases = cases, references = references, files = files }
