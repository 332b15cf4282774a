-- Convergence of first contact: an unconstrained body, or a rigid tool under a force, that does not touch yet.
--
-- Problem: a quarter of a hollow cylinder is placed above a plane or a slab and loaded downwards. Before contact it is
--          unconstrained vertically (rigid-body mode), so the tangent is singular.
--
--         x = 0   ______   load P uniformly distributed over the cut y = 0
--        u_x = 0 |  cut |
--                 \    /   quarter ring, radii 0.5 and 1, neo-Hooke, E = 1, nu = 0.3, plane strain, 12 × 3 elements
--                  \__/
--          gap  _________________
--                 under=plane: rigid; under=slab: 2 × 1, E = 1, 10 × 5 elements, bottom clamped, u_x = 0 at x = 0;
--                 under=tool: the ring's cut is held, and P lifts the rigid plane, whose height is an unknown
--
--          Gaps below 0 are initial overlaps, a common workaround: the first iteration finds points in contact.
--          Normal penalty 100; with mu = 0.3 also a tangential penalty of 100. The load is applied in 5 steps.
-- Source: chosen here.
-- Units: any consistent units; lengths relative to the outer radius, loads to Young's modulus times outer radius.
-- Expected: plain Newton converges in no cell without overlap: the tangent is singular. With overlap it converges in
--           all cells on the plane without friction and under the tool, otherwise in all but those of the highest load:
--           8 and 6 of 24 cells. All controls converge in all 144: damping moves the body to its first contact. The
--           contact force equals the load.
-- Run: signorini stability/first_touch.lua [under=plane,slab,tool] [friction=0,0.3] [order=N2]
--      [gaps=-1e-2,-1e-3,0,1e-3,1e-2,1e-1] [loads=1e-4,1e-3,1e-2,0.05] [steps=5] [jobs=2] [limit=600] [keep=no]
--      [with=robust] [formulation=gpts] [out=out/stability/first_touch]; one map for each of under and friction;
--      keep=yes reuses the cells that an earlier call left in the folder; with=cutting, fallback or prediction turns on
--      only one of the controls; formulation: a row of formulations/rows.lua (half-passes with under=slab only).

local sg = require "signorini"
local formulations = require "formulations.rows"
local study = require "stability.study"

local options = study.arguments{
  under = { { "plane", "slab", "tool" }, choices = { "plane", "slab", "tool" } }, friction = { 0, 0.3 }, order = "N2",
  gaps = { -1e-2, -1e-3, 0, 1e-3, 1e-2, 1e-1 }, loads = { { 1e-4, 1e-3, 1e-2, 0.05 }, above = 0 }, steps = 5,
  formulation = formulations.argument "gpts", out = "out/stability/first_touch",
}
local formulation = formulations[options.formulation]
if formulation.two_faces and table.concat(options.under) ~= "slab" then
  error(("formulation=%s needs under=slab, since a plane is never the slave"):format(formulation.name), 0)
end
local order, steps = options.order, options.steps
local inner, outer, penalty = 0.5, 1, 100

local function scene(under, mu, gap)
  local ring = sg.body{
    patch = sg.shapes.quarter_annulus{ inner = inner, outer = outer, start = 270 }, elements = { 12, 3 },
    order = order, contact = "south", thickness_degree = 1, material = sg.neo_hookean{ E = 1, nu = 0.3 },
  }
  local bodies = { ring = ring }
  local supports = { symmetry = { on = ring:face "west", fix = "x" } }
  local master = sg.rigid.plane{ point = { 0, -outer - gap }, normal = { 0, 1 } }
  if under == "slab" then
    local slab = sg.body{
      patch = sg.shapes.rectangle{ width = 2, height = 1, corner = { 0, -outer - gap - 1 } }, elements = { 10, 5 },
      order = order, contact = "north", thickness_degree = 1, material = sg.neo_hookean{ E = 1, nu = 0.3 },
    }
    bodies.slab, master = slab, slab:face "north"
    supports.bed = { on = slab:face "south", fix = "xy" }
    supports.middle = { on = slab:face "west", fix = "x" }
  end
  local push = { on = ring:face "east", traction = { 0, 0 } }
  if under == "tool" then
    supports.cut = { on = ring:face "east", fix = "y" }
    supports.tool = { on = master, free = "y" }
    push = { on = master, force = { 0, 0 } }
  end
  return sg.model{
    bodies = bodies, supports = supports, loads = { push = push },
    contacts = { ground = formulations.contact(formulation, {
      slave = ring:face "south", master = master, penalty = penalty,
      friction = mu > 0 and { mu = mu, penalty = penalty } or nil }) },
  }
end

local files, results = sg.files(options.out), {}
for _, under in ipairs(options.under) do
  for _, mu in ipairs(options.friction) do
    local key = ("%s_mu%g"):format(under, mu)
    results[key] = study.solve({
      name = ("First contact with a %s, μ = %g"):format(under, mu), key = key,
      x = { name = "gap (R)", values = options.gaps }, y = { name = "load (E R)", values = options.loads },
      scene = function(gap) return scene(under, mu, gap) end,
      path = function(_, _, load)
        local force = under == "tool" and load or -load / (outer - inner)
        return { { name = "press", steps = steps, push = { 0, force } } }
      end,
      formulation = formulation,
      results = function(_, run) return { carried = run:column "ground.fy"[run.steps] } end,
    }, options, files)
  end
end
files:report()
return { maps = results, files = files }
