-- Where deep ironing holds: discretisation label against step size, with few and with many contact points.
--
-- Problem: a stiff half ring is pressed half of the slab's height into it and dragged along, with friction.
--
--              (   )        die: half annulus, radii 0.3 and 0.5, E = 10000, its two flat ends driven,
--               \_/         pressed by 0.5 in 46 steps, then dragged by 1.5 in 250 steps, or in fewer
--        ______/   \___________________
--       |                              |
--       |  slab: 3 × 1, E = 1, clamped |
--       |______________________________|
--
--          Plane strain, neo-Hooke, nu = 0.3, mu = 0.1, both penalties 100, slave: die; mesh m1: die 6 × 2 and slab
--          8 × 3 elements. Each map: labels against how many times longer than published the steps are.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, section 7.1.4, where N2 at m1 does not converge.
-- Units: mm, N, N/mm².
-- Expected: plain Newton holds 10, 19 and 22 of 40 cells with p + 1, 2(p + 1) and 3(p + 1) contact points. With the
--           published steps all labels hold with 2(p + 1) and more; with p + 1 N4, N6 and N2-N6 fail while the die is
--           pressed. With steps 16 times as long all fail at once. Cutting steps alone holds all 120 cells, with not
--           one iteration more where nothing is cut.
-- Run: signorini scripts/stability/deep_ironing.lua [points=p+1,2(p+1),3(p+1)]
--      [labels=N2,N4,N6,N2-N4,N2-N6,N2-N2.1,N2-N2.2,N2-N2.3] [coarser=1,2,4,8,16] [mesh=m1] [jobs=2] [limit=600]
--      [keep=no] [out=out/stability/deep_ironing]; one map for each of points, the contact points per element, p the
--      degree on the contact face; coarser: steps that many times as long; keep=yes takes up the cells that an earlier
--      call left in the folder.

package.path = require "signorini.core".home .. "/scripts/?.lua;" .. package.path
local ironing = require "ironing2d.problem"
local study = require "stability.study"

local options = study.read(select("#", ...) > 0 and { ... } or arg, {
  points = "p+1,2(p+1),3(p+1)", labels = "N2,N4,N6,N2-N4,N2-N6,N2-N2.1,N2-N2.2,N2-N2.3", coarser = "1,2,4,8,16",
  mesh = "m1", out = "out/stability/deep_ironing",
})
local set_up, elements = ironing.variants.deep, ironing.elements(options.mesh)
local multiples = { ["p+1"] = 1, ["2(p+1)"] = 2, ["3(p+1)"] = 3 }

local files, results = {}, {}
for _, points in ipairs(study.split(options.points)) do
  local multiple = multiples[study.choice("points", points, { "p+1", "2(p+1)", "3(p+1)" })]
  results[points] = study.solve({
    name = ("Deep ironing with %s contact points"):format(points), key = ("points%d"):format(multiple),
    x = { name = "label", values = study.split(options.labels) },
    y = { name = "length of a step (published: 1)", values = study.positive("coarser", options.coarser) },
    scene = function(label)
      return (ironing.scene(set_up, label, elements, multiple * (ironing.layer_degree(label) + 1)))
    end,
    path = function(_, _, coarser) return ironing.path(set_up, coarser) end,
  }, options, files)
end
study.finish(files)
return { maps = results, files = files }
