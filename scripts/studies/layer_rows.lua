-- Control points of varying-order layers: what an order label adds to a body, and where.
--
-- Problem: the die of the ironing benchmark, 6 × 2 elements, with the contact face below: N2; N4, which adds a few
--          functions of higher continuity in all rows; N2-N2.2, which elevates the degree of the contact row at
--          constant continuity; N2-N2.2x2, which elevates two rows.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, section 5.1.
-- Units: none.
-- Expected: 9, 13, 21 and 21 control points on the contact face; 36, 52, 48 and 60 in the body.
-- Run: signorini studies/layer_rows.lua [orders=N2,N4,N2-N2.2,N2-N2.2x2] [out=out/layer_rows]

local sg = require "signorini"

local options = sg.arguments{ orders = { "N2", "N4", "N2-N2.2", "N2-N2.2x2" }, out = "out/layer_rows" }
local files, pictures, counts = sg.files(options.out), {}, {}
for i, order in ipairs(options.orders) do
  local die = sg.body{ patch = sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = { 0, 0.5 } },
                       elements = { 6, 2 }, order = order, contact = "south", thickness_degree = 2,
                       material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  local model = sg.model{ bodies = { die = die }, supports = { grip = { on = die:face "west", fix = "xy" } } }
  local dofs = die:dofs()
  counts[i] = { order, dofs.interface // 2, dofs.total // 2 }
  pictures[i] = sg.picture{ model = model, control_points = true, axes = { "", "" },
                            title = ("%s: %d control points"):format(order, dofs.total // 2) }
end
print(sg.table{ columns = { "order", "contact row", "all" }, units = { "", "control points", "control points" },
                rows = counts })
sg.sheet{ pictures, columns = 2, file = files "rows.png" }
files:report()

return counts
