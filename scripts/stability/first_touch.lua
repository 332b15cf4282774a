-- First touch: a body that only contact can hold, and that does not touch yet.
--
-- Problem: a quarter of a hollow cylinder hangs above a plane or a slab and is loaded downwards. Nothing holds it
--          vertically before it touches: the tangent is singular, and where a step begins there is nothing to start
--          from.
--
--         x = 0   ______   load P spread evenly over the cut y = 0
--        u_x = 0 |  cut |
--                 \    /   quarter ring, radii 0.5 and 1, neo-Hooke, E = 1, nu = 0.3, plane strain, 12 × 3 elements
--                  \__/
--          gap  _________________
--                 under=plane: rigid; under=slab: 2 × 1, E = 1, 10 × 5 elements, bottom clamped, u_x = 0 at x = 0
--
--          Gaps below 0 are overlaps, a usual way out: the first iteration finds points in contact.
--          Normal penalty 100; with mu = 0.3 also a tangential one of 100. The load is applied in 5 steps.
-- Source: chosen here.
-- Units: any consistent ones; lengths in outer radii, loads in Young's modulus times outer radius.
-- Expected: plain Newton holds no cell without overlap: the tangent is singular. With overlap it holds all on the
--           plane without friction, elsewhere all but those of the highest load: 8 and 6 of 24 cells.
--           The controls hold all 96: damping carries the body to its first contact. The contact carries the load.
-- Run: signorini scripts/stability/first_touch.lua [under=plane,slab] [friction=0,0.3] [label=N2]
--      [gaps=-1e-2,-1e-3,0,1e-3,1e-2,1e-1] [loads=1e-4,1e-3,1e-2,0.05] [steps=5] [jobs=2] [limit=600] [keep=no]
--      [with=robust] [out=out/stability/first_touch]; one map for each of under and friction; keep=yes takes up the
--      cells that an earlier call left in the folder; with=cutting, rescue or prediction turns on one of the controls
--      alone.

local sg = require "signorini"
local study = require "stability.study"

local options = study.arguments{
  under = { { "plane", "slab" }, choices = { "plane", "slab" } }, friction = { 0, 0.3 }, label = "N2",
  gaps = { -1e-2, -1e-3, 0, 1e-3, 1e-2, 1e-1 }, loads = { { 1e-4, 1e-3, 1e-2, 0.05 }, above = 0 }, steps = 5,
  out = "out/stability/first_touch",
}
local label, steps = options.label, options.steps
local inner, outer, penalty = 0.5, 1, 100

local function scene(under, mu, gap)
  local ring = sg.body{
    patch = sg.shapes.quarter_annulus{ inner = inner, outer = outer, start = 270 }, elements = { 12, 3 },
    order = label, contact = "south", through = 1, material = sg.neo_hookean{ E = 1, nu = 0.3 },
  }
  local bodies = { ring = ring }
  local supports = { symmetry = { on = ring:face "west", fix = "x" } }
  local master = sg.rigid.plane{ point = { 0, -outer - gap }, normal = { 0, 1 } }
  if under == "slab" then
    local slab = sg.body{
      patch = sg.shapes.rectangle{ width = 2, height = 1, corner = { 0, -outer - gap - 1 } }, elements = { 10, 5 },
      order = label, contact = "north", through = 1, material = sg.neo_hookean{ E = 1, nu = 0.3 },
    }
    bodies.slab, master = slab, slab:face "north"
    supports.bed = { on = slab:face "south", fix = "xy" }
    supports.middle = { on = slab:face "west", fix = "x" }
  end
  return sg.model{
    bodies = bodies, supports = supports,
    loads = { push = { on = ring:face "east", traction = { 0, 0 } } },
    contacts = { ground = { slave = ring:face "south", master = master, penalty = penalty,
                            friction = mu > 0 and { mu = mu, penalty = penalty } or nil } },
  }
end

local files, results = sg.files(options.out), {}
for _, under in ipairs(options.under) do
  for _, mu in ipairs(options.friction) do
    local key = ("%s_mu%g"):format(under, mu)
    results[key] = study.solve({
      name = ("First touch of a %s, friction %g"):format(under, mu), key = key,
      x = { name = "gap", values = options.gaps }, y = { name = "load", values = options.loads },
      scene = function(gap) return scene(under, mu, gap) end,
      path = function(_, _, load)
        return { { name = "press", steps = steps, push = { 0, -load / (outer - inner) } } }
      end,
      figures = function(_, run) return { carried = run:column "ground.fy"[run.steps] } end,
    }, options, files)
  end
end
files:report()
return { maps = results, files = files }
