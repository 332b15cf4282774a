-- Cylinder ironing in 3D: a half pipe is pressed into a slab and dragged across its axis, without friction.
--
-- Problem: the pipe is narrower than the slab, so its two rims cut into the slab; its round bottom moves across the
--          elements of the slab, and the forces oscillate with the element pitch.
--
--          |     |      die: half a pipe along y, outer radius 0.5, wall 0.1, width 0.6, E = 100, both flat ends
--           \   /       driven; axis starts at x = 0.5, in the middle of the slab;
--        ____\_/_____________________   pressed by 0.2 in 10 steps, then dragged by 1.5 in 108 steps
--       |  slab: 2.5 × 1.0 × 0.6,    |
--       |  E = 1, bottom clamped     |
--       |____________________________|
--
--          Neo-Hooke, nu = 0.3 both; normal penalty 100; slave: die. Meshes: 12 × 6 × 2 (arc, y, thickness) and
--          18 × 12 × 4 elements. The thesis gives neither the driven faces, the starting position of the die nor the
--          number of steps: the flat ends, x = 0.5 (for a symmetric path), 10 steps and ten steps per element of the
--          slab are chosen here. Failed steps are halved; the table gives the step at which equal steps would have
--          ended.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, section 6.4.2, Figures 6.10 and 6.11, after L. De Lorenzis,
--         P. Wriggers, G. Zavarise, Comput. Mech. 49 (2012) 1-20. Plain Newton, as published; failed steps are cut.
-- Units: any consistent units; the thesis gives none.
-- Expected: six discretizations complete in equal steps. Pz = 0.1700 after pressing and 0.1757 on average over the drag
--           for N2; averages 0.1731 (N3), 0.1736 (N2-N3), 0.1724 (N2-N2.1). Oscillations (peak-to-peak) of Pz and Px:
--           1.95e-3 and 1.00e-3 for N2; in % of these, 54 and 95 for N3, 56 and 94 for N2-N3, 10 and 8 for N2-N2.1.
--           Curves are symmetric about the middle of the path, since without friction a state does not depend on the
--           path.
-- Run: signorini cylinder_ironing3d.lua [orders=N2,N3,N4,N2-N3,N2-N4,N2-N2.1,N2-N2.2]
--      [mesh=12x6x2/18x12x4] [press=10] [slide=108] [formulation=gpts] [linear=auto] [out=out/cylinder_ironing3d];
--      mesh: elements of die/slab; press, slide: number of steps; formulation: a row of formulations/rows.lua.

local sg = require "signorini"
local formulations = require "formulations.rows"
local orders = require "problems.solid_ironing.orders"
local mesh = require "problems.solid_ironing.mesh"

local problem = { title = "Cylinder ironing", tool = "die", length = 2.5, start = 0.5, depth = 0.2, distance = 1.5 }

function problem.scene(case)
  local slab = sg.body{
    patch    = sg.shapes.block{ size = {2.5, 1, 0.6} },
    elements = case.mesh.slab, order = case.order, contact = "back", thickness_degree = 1,
    material = sg.neo_hookean{ E = 1, nu = 0.3 },
  }
  local die = sg.body{
    patch    = sg.shapes.half_cylinder_shell{ inner = 0.4, outer = 0.5, width = 0.6,
                                              center = {problem.start, 0.2, 0.6 + 0.5} },
    elements = case.mesh.die, order = case.order, contact = "front", thickness_degree = 1,
    material = sg.neo_hookean{ E = 100, nu = 0.3 },
  }
  local model = sg.model{
    bodies   = { die = die, slab = slab },
    supports = { bed  = { on = slab:face "front", fix = "xyz" },
                 grip = { on = { die:face "west", die:face "east" }, drive = "xz", fix = "y" } },
    contacts = { interface = formulations.contact(case.formulation, {
      slave = die:face "front", master = slab:face "back", penalty = 100 }) },
  }
  return model, die, slab
end

local options = sg.arguments{
  orders = { "N2", "N3", "N4", "N2-N3", "N2-N4", "N2-N2.1", "N2-N2.2" }, mesh = mesh.argument "12x6x2/18x12x4",
  press = 10, slide = 108, formulation = formulations.argument "gpts", linear = "auto", out = "out/cylinder_ironing3d",
}
local files = sg.files(options.out)
local result = orders.run(problem, options, files)
files:report()
result.files = files
return result
