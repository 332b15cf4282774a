-- Nearly incompressible bodies, Poisson's ratio against discretization: convergence and volumetric locking, without and
-- with projected volume change.
--
-- Problem: a rigid cylinder is pressed into a block that slides on its base: the material must flow sideways.
--
--                 (     )      cylinder: radius 0.5, pressed by 0.15 in 5 steps, without friction
--          x = 0 |_\___/_____
--       u_x = 0  |           |   block: half model, 1 × 1, E = 1, neo-Hooke, plane strain, 8 × 8 elements
--                |           |   right side free
--                |___________|
--                  u_y = 0
--
--          Error: relative difference (absolute value) between the force on the cylinder and that of N4 on 24 × 24
--          elements with the same nu. A mesh that locks is too stiff, so its force is too large. The normal penalty is
--          1000.
-- Source: chosen here. On locking of splines: T. Elguedj, Y. Bazilevs, V. M. Calo, T. J. R. Hughes, CMAME 197 (2008)
--         2732.
-- Units: any consistent units.
-- Expected: plain Newton converges in 38 of 42 cells; the other cells invert elements in the first step (N3 at nu up to
--           0.45, N4 at 0.499). All controls converge in all cells, with 1.02 times as many iterations where both
--           converge. Errors at nu = 0.3, 0.49, 0.499: L1 3 %, 14 %, 79 %; N2 0.7 %, 0.6 %, 3.2 %; N4 0.1 %, 0.1 %,
--           0.1 %. A layer reduces the error of N2 at 0.499 only by a third, since it is the bulk that locks. With
--           projected volume change L1 is off by 2 %, all others by at most 0.7 %, also at 0.4999.
-- Run: signorini stability/locking.lua [orders=L1,L2,N2,N3,N4,N2-N2.1,N2-N4] [nu=0.3,0.4,0.45,0.49,0.495,0.499]
--      [volumetric=pointwise] [elements=8] [reference=24] [steps=5] [depth=0.15] [jobs=2] [limit=600] [keep=no]
--      [with=robust] [out=out/stability/locking]; orders: N2:1 is N2 with degree 1 in the thickness direction,
--      otherwise that of the bulk; volumetric=pointwise,projected draws both maps of the error side by side; elements,
--      reference: elements along each side of the block; keep=yes reuses the cells that an earlier call left in the
--      folder; with=cutting, fallback or prediction turns on only one of the controls.

local sg = require "signorini"
local controls = require "stability.controls"
local study = require "stability.study"

local options = study.arguments{
  orders = { "L1", "L2", "N2", "N3", "N4", "N2-N2.1", "N2-N4" },
  nu = { { 0.3, 0.4, 0.45, 0.49, 0.495, 0.499 }, above = 0 },
  volumetric = { { "pointwise" }, choices = { "pointwise", "projected" } }, elements = 8, reference = 24, steps = 5,
  depth = { 0.15, above = 0 }, out = "out/stability/locking",
}
local elements, finest, ratios = options.elements, options.reference, options.nu
local stages = { { name = "press", steps = options.steps, push = { 0, -options.depth } } }

local function scene(order, nu, count, volumetric)
  -- Without another one the degree of the bulk, in both directions, which determines locking
  local degree = math.tointeger(order:match ":(%d+)$" or order:match "^%a(%d+)")
  local block = sg.body{
    patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = { count, count },
    order = order:match "^[^:]*", thickness_degree = degree, volumetric = volumetric, contact = "north",
    material = sg.neo_hookean{ E = 1, nu = nu },
  }
  local punch = sg.rigid.cylinder{ center = { 0, 1.5 }, radius = 0.5 }
  return sg.model{
    bodies   = { block = block },
    supports = { symmetry = { on = block:face "west", fix = "x" }, bed = { on = block:face "south", fix = "y" },
                 push = { on = punch, drive = "xy" } },
    contacts = { indent = { slave = block:face "north", master = punch, penalty = 1000 } },
  }
end

local function force(run) return math.abs(run:column "push.fy"[run.steps]) end

--- The reference forces by nu, each solved in its own process.
local reference = sg.convergence_map{
  name = ("N4 on %d × %d elements"):format(finest, finest),
  x = { name = "order", values = { "N4" } }, y = { name = "nu", values = ratios },
  scene = function(order, nu) return scene(order, nu, finest) end,
  path = function() return stages, controls.robust() end,
  results = function(_, run) return { force = force(run) } end, jobs = options.jobs,
}
print(reference)

local files = sg.files(options.out)

--- The maps of bodies with one treatment of the volume change.
local function solve(volumetric)
  local projected = volumetric == "projected"
  return study.solve({
    name = ("Indentation, %d × %d elements%s"):format(elements, elements, projected and ", projected volume" or ""),
    key = projected and volumetric or nil,
    x = { name = "order", values = options.orders }, y = { name = "Poisson's ratio", values = ratios },
    scene = function(order, nu) return scene(order, nu, elements, volumetric) end,
    path = function() return stages end,
    results = function(_, run, _, nu)
      local exact = reference:cell("N4", nu).results.force
      return { force = force(run), error = exact and math.abs(force(run) / exact - 1) }
    end,
    charts = { { key = "error", name = "error", log = true, label = "error of the force" } },
  }, options, files)
end

local maps = {}
for _, volumetric in ipairs(options.volumetric) do maps[volumetric] = solve(volumetric) end
if maps.pointwise and maps.projected then
  maps.pointwise.robust:heatmap{
    file = files "both.png", name = "error", log = true, label = "error of the force",
    title = ("Indentation, %d × %d elements: error of the force"):format(elements, elements),
    other = maps.projected.robust, titles = { 'volumetric = "pointwise"', '"projected"' },
  }
end
files:report()
return { maps = maps, reference = reference, files = files }
