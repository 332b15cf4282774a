-- 3D ironing with a spherical indenter: oscillation of the contact forces, maximum depth, friction, cost per iteration.
--
-- Problem: a block with a spherical cap at the bottom (the indenter) is pressed into a slab and dragged along it. Its
--          forces oscillate with the element pitch of the slab, the more so the coarser and less smooth the two faces
--          are.
--
--                  ______
--                 |      |  indenter: 10 × 10 × 11 with a cap of radius R below, top driven:
--                  \____/   down by 10.4 minus the gap in steps of 0.2, along by 75 in steps of 0.3,
--        _____________________________________________   center from x = 12.5 to 87.5
--       |  slab: 100 × 30 × 22, bottom clamped        |
--       |_____________________________________________|
--
--          Neo-Hooke, E = 1, nu = 0.3 both; penalty 100; slave: indenter; 3(p + 1) contact points per direction.
--          Meshes: 5 × 5 × 3 and 18 × 6 × 4 elements (coarse), doubled (fine). The thesis gives neither R nor the
--          initial gap: R = 25.5 and gap = 5 (depth 5.4) are chosen here. Without friction a state does not depend on
--          the path, so slide=window presses at the start of the window in which oscillations are measured, and slides
--          through this window only.
--          variant=friction: mu = 0.3, tangential penalty 100: ratio of drag to pressing force, energy balance.
--          variant=depth: maximum depth of the indenter before the path turns (limit point), by R and discretization.
--          variant=layers: N2-N2.2 on whole faces, along the path of the indenter, and on the rest of its cap's center.
--          variant=cost: time per Newton iteration on four meshes, and of N2-N2.2.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, section 7.5, Tables 7.10 and 7.11, Figures 7.28 to 7.32;
--         the geometry after I. Temizer, P. Wriggers, T. J. R. Hughes, CMAME 200 (2011) 1100-1112. Plain Newton, as
--         published; failed steps are cut.
-- Units: any consistent units; the thesis gives none.
-- Expected: the degrees of freedom of Table 7.11 exactly. Table 7.10 is not reproduced: at R = 25.5, N3 and N2-N3 have
--           29.4/34.9 and 27.4/34.5 % of N2's dPz/dPx (printed: 27.5/33.1 and 26.8/33.1), N2-N2.1 32.9/51.7 (6.6/14.4);
--           at R = 7.5, N2-N3 57.9/53.6, N2-N2.1 10.8/32.1. Friction: Px/Pz = 0.306 on average for mu = 0.3. Depth: N2
--           at R = 25.5 has a turning point at 8.43 (see share/doc/evidence/ironing3d.md).
-- Run: signorini ironing3d.lua [orders=N2,N3,N4,N2-N3,N2-N4,N2-N2.1,N2-N2.2] [fine=N2] [radius=25.5] [gap=5]
--      [slide=window] [down=0.2] [cap=1] [formulation=gpts] [linear=auto] [out=out/ironing3d]; radius and gap can be
--      lists; fine: discretizations on the doubled mesh, or none; slide=full: the whole path; down: step length of
--      pressing; cap: biquadratic elements per direction that represent the sphere; formulation: a row of
--      formulations/rows.lua, such as equal or reduced-multipliers.
--      signorini ironing3d.lua variant=friction [orders=N2] [radius=7.5] [gap=5] [mu=0,0.3] [distance=30]
--      [finer=1] [penalty=100]; distance: of sliding through the middle of the slab; finer: divides the steps; penalty:
--      normal and tangential.
--      signorini ironing3d.lua variant=depth [orders=N2] [radius=7.5,12,25.5] [from=50,47.3]; from: x of the
--      center of the indenter.
--      signorini ironing3d.lua variant=cost [orders=N2] [mesh=sparse,coarse,middle,fine] [layered=N2-N2.2]
--      signorini ironing3d.lua variant=layers [orders=N2-N2.1,N2-N2.2] [radius=7.5] [gap=5] [mu=0.3]
--      [from=41.7] [down=0.2] [reach=5] [mesh=coarse]; from: x of the center of the indenter where it is pressed;
--      reach: half-width of the slab's layer.
--      Threads: signorini --threads 2 ironing3d.lua …

local sg = require "signorini"
local formulations = require "formulations.rows"
local problem = require "problems.ironing3d.problem"
local variants = {
  standard = require "problems.ironing3d.oscillation", friction = require "problems.ironing3d.friction",
  depth = require "problems.ironing3d.depth", cost = require "problems.ironing3d.cost",
  layers = require "problems.ironing3d.layers",
}

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Arguments that several variants have: the cap's radii, the gaps before touching, the steps while it is pressed.
local function radii(default) return { default, at_least = 7.1 } end
local function gaps(default) return { default, at_least = 0, below = problem.published_depth } end
local down = { problem.down, at_least = 0.01 }

local options = sg.arguments{
  orders = { "N2" }, linear = "auto", variant = { "standard", variants = {
    standard = { orders = { "N2", "N3", "N4", "N2-N3", "N2-N4", "N2-N2.1", "N2-N2.2" },
                 fine = { { "N2" }, none = true }, radius = radii{ 25.5 }, gap = gaps{ 5.0 }, cap = 1,
                 slide = { "window", choices = { "window", "full" } }, down = down,
                 formulation = formulations.argument "gpts", out = "out/ironing3d" },
    friction = { radius = radii{ 7.5 }, gap = gaps{ 5.0 }, mu = { { 0, 0.3 }, at_least = 0 }, cap = 1,
                 distance = { 30.0, at_least = 0.3, below = 76 }, finer = { 1.0, at_least = 0.25 },
                 penalty = { 100.0, above = 0 }, out = "out/ironing3d_friction" },
    depth = { radius = radii{ 7.5, 12, 25.5 }, from = { { 50, 47.3 }, at_least = 5, below = 95 }, cap = 1, down = down,
              out = "out/ironing3d_depth" },
    layers = { radius = { 7.5, at_least = 7.1 }, gap = { 5.0, at_least = 0, below = problem.published_depth }, mu = 0.3,
               from = { 41.7, at_least = 5, below = 47.3 }, down = down, reach = { 5.0, above = 0 },
               mesh = { "coarse", choices = problem.mesh_names }, out = "out/ironing3d_layers" },
    cost = { mesh = { problem.mesh_names, choices = problem.mesh_names }, layered = { { "N2-N2.2" }, none = true },
             out = "out/ironing3d_cost" },
  } },
}
local files = sg.files(options.out)
local result = variants[options.variant].run(options, files)
files:report()
result.files = files
return result
