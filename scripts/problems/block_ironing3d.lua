-- Block ironing in 3D: a block is pressed into a slab and dragged along it, without friction.
--
-- Problem: the whole lower face of the block is in contact, including its sharp edges, which plow through the slab;
--          the forces oscillate with the element pitch of the slab.
--
--                  ________
--                 |        |  block: 4 × 4 × 4, E = 10, top driven, center starts at x = 3.75, in the middle of
--          z      |        |  the slab; pressed by 1 in 10 steps, then dragged by 12.5 in 125 steps
--          |   ___|________|___________________________
--          |  |                                        |
--          |  |  slab: 20 × 10 × 10, E = 1, bottom     |
--          |  |        clamped                         |
--          |  |________________________________________|
--          +------------------------------------------------ x
--
--          Neo-Hooke, nu = 0.3 both; normal penalty 100; slave: block. Meshes: 4 × 4 × 4 and 8 × 4 × 4 elements.
--          The thesis gives neither the starting position of the block nor the number of steps: x = 3.75 (for a
--          symmetric path), 10 and 125 steps are chosen here. Failed steps are halved; the table gives the step at
--          which equal steps would have ended.
--          variant=sixty: the path in 10 + 50 steps, half model, line search by energy: cost and force.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, section 6.4.1, Figures 6.8 and 6.9, after L. De Lorenzis,
--         P. Wriggers, G. Zavarise, Comput. Mech. 49 (2012) 1-20. Plain Newton, as published; failed steps are cut.
-- Units: any consistent units; the thesis gives none.
-- Expected: all seven discretizations complete in equal steps. Pz = 5.726 after pressing and 6.288 on average over the
--           drag for N2; averages 6.231 (N3), 6.262 (N4), 6.237 (N2-N3), 6.273 (N2-N4), 5.893 (N2-N2.1), 5.804
--           (N2-N2.2). Curves are symmetric about the middle of the path, since without friction a state does not
--           depend on the path. Neither higher degree nor layers reduce the oscillation, since the edges of the block
--           stay sharp (see share/doc/evidence/block_ironing3d.md). variant=sixty: N2-N2.1 with degree 2 in the
--           thickness direction and 4 points gives 5.846 on average on 2x2x1/8x4x2 (part=whole), 5.826 with
--           part=half, and 5.796 there with 3 points, block_order=N2 and layer=below.
-- Run: signorini block_ironing3d.lua [orders=N2,N3,N4,N2-N3,N2-N4,N2-N2.1,N2-N2.2] [mesh=4x4x4/8x4x4]
--      [press=10] [slide=125] [formulation=gpts] [linear=auto] [out=out/block_ironing3d]; mesh: elements of block/slab;
--      press, slide: number of steps; formulation: a row of formulations/rows.lua.
--      signorini block_ironing3d.lua variant=sixty [orders=N2,N2-N2.1,N2-N2.2] [mesh=4x4x4/8x4x4]
--      [block_order=same] [layer=whole] [thickness_degree=1] [points=auto] [part=half] [tolerance=1e-10]
--      [line_search=energy] [linear=auto] [out=out/block_ironing3d_sixty] [page=none]; all but the last four can be
--      lists; block_order: order of the block, if not that of the slab; layer: on the whole upper face of the slab, or
--      below the path of the block; thickness_degree: degree from top to bottom; points: Gauss points per direction of
--      a contact element, auto is 3(p + 1); part: half model up to the plane of symmetry, or whole; tolerance: of the
--      residual, relative to the forces; page: folder of block_ironing3d.md, whose table of this variant is filled.

local sg = require "signorini"
local formulations = require "formulations.rows"
local orders = require "problems.solid_ironing.orders"
local mesh = require "problems.solid_ironing.mesh"
local sixty = require "problems.block_ironing3d.sixty"

local problem = { title = "Block ironing", tool = "block", length = 20, start = 3.75, depth = 1, distance = 12.5 }

--- The elements of the half with y < 5: half as many across.
local function half_of(elements) return { elements[1], elements[2] // 2, elements[3] } end

--- Whether a point of the slab is below the path of the block.
local function below(X) return math.abs(X[2] - 5) < 2 end

--- The whole model, or with case.half the half y < 5 with a plane of symmetry (even numbers of elements across).
function problem.scene(case)
  local width = case.half and 0.5 or 1
  local across = case.half and half_of or function(elements) return elements end
  local slab = sg.body{
    patch    = sg.shapes.block{ size = {20, 10 * width, 10} },
    elements = across(case.mesh.slab), order = case.order, contact = "back",
    layer = case.layer == "below" and below or nil,
    thickness_degree = case.thickness_degree or 1,
    material = sg.neo_hookean{ E = 1, nu = 0.3 },
  }
  local block = sg.body{
    patch    = sg.shapes.block{ size = {4, 4 * width, 4}, corner = {problem.start - 2, 3, 10} },
    elements = across(case.mesh.die), order = case.block_order or case.order, contact = "front",
    thickness_degree = case.thickness_degree or 1,
    material = sg.neo_hookean{ E = 10, nu = 0.3 },
  }
  local supports = { bed  = { on = slab:face "front", fix = "xyz" },
                     grip = { on = block:face "back", drive = "xz", fix = "y" } }
  if case.half then supports.mirror = { on = { slab:face "north", block:face "north" }, fix = "y" } end
  local model = sg.model{
    bodies = { block = block, slab = slab }, supports = supports,
    contacts = { interface = formulations.contact(case.formulation, {
      slave = block:face "front", master = slab:face "back", penalty = 100, points = case.points }) },
  }
  return model, block, slab
end

local function is_count(text) return text == "auto" or (math.tointeger(tonumber(text)) or 0) >= 1 end
local options = sg.arguments{
  linear = "auto", variant = { "standard", variants = {
    standard = { orders = { "N2", "N3", "N4", "N2-N3", "N2-N4", "N2-N2.1", "N2-N2.2" },
                 mesh = mesh.argument "4x4x4/8x4x4", press = 10, slide = 125,
                 formulation = formulations.argument "gpts", out = "out/block_ironing3d" },
    sixty = { orders = { "N2", "N2-N2.1", "N2-N2.2" }, mesh = mesh.argument{ "4x4x4/8x4x4" }, thickness_degree = { 1 },
              block_order = { "same" }, layer = { { "whole" }, choices = { "whole", "below" } }, tolerance = { 1e-10 },
              points = { { "auto" }, check = is_count, expected = "whole numbers of at least 1, or auto" },
              part = { { "half" }, choices = { "half", "whole" } },
              line_search = { "energy", choices = { "energy", "residual", "none" } },
              out = "out/block_ironing3d_sixty", page = "none" },
  } },
}
local files = sg.files(options.out)
local result = (options.variant == "sixty" and sixty or orders).run(problem, options, files)
files:report()
result.files = files
return result
