-- Convergence map of peeling: mesh against discretization, under rotation control and with arc length.
--
-- Problem: a strip that adheres to a rigid substrate by van der Waals forces is peeled by rotating its end. On coarse
--          meshes the strip peels in snaps: the path of the discrete problem has turning points, where a step in the
--          angle can only jump (snap-back).
--
--                                                     θ
--           ____________________________________________↶   right edge: rotated as a rigid line, both translations free
--          |        strip 100 × 10 nm                   |
--          |____________________________________________|
--           0  : adhesion : 85                        100     u_x of the left bottom corner fixed
--          =============================================
--
--          Half the published length, with elements of the published length (1.25, 1 and 0.83 nm in m1 to m3; m0: 2.5
--          nm). Two maps for each control: rotation control, and arc_length = true.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, section 7.4.
-- Units: nm, nN, degrees.
-- Expected: under rotation control plain Newton converges in 11 of 15 cells: N2, N4 and N2-N4 at m0 and N2 at m1 reach
--           turning points, at 29.4°, 46.0°, 43.2° and 75.6°; N2-N2.1 and N2-N2.2 converge on every mesh. With arc
--           length it converges in all 15 cells. The default controls converge in all 15, too, jumping at the turning
--           points to a state behind the fold, with 8, 6, 5 and 1 steps solved by fallbacks; also with arc length,
--           before which predictors and step cuts are tried. Where both converge, the controls take 0.77 and 0.83 times
--           as many iterations.
-- Run: signorini stability/peeling.lua [control=rotation,arc] [orders=N2,N4,N2-N4,N2-N2.1,N2-N2.2]
--      [meshes=m0,m1,m2] [angle=90] [pitch=0.2] [length=100] [bonded=85] [jobs=2] [limit=600] [keep=no] [with=robust]
--      [out=out/stability/peeling]; pitch: degrees per step; keep=yes reuses the cells that an earlier call left in the
--      folder; with=cutting, fallback or prediction turns on only one of the controls.

local sg = require "signorini"
local peeling = require "problems.peeling2d.problem"
local study = require "stability.study"

local options = study.arguments{
  control = { { "rotation", "arc" }, choices = { "rotation", "arc" } },
  orders = { "N2", "N4", "N2-N4", "N2-N2.1", "N2-N2.2" },
  meshes = { { "m0", "m1", "m2" }, choices = { "m0", "m1", "m2", "m3" } }, angle = { 90.0, above = 0 },
  pitch = { 0.2, above = 0 }, length = { 100.0, above = 0 }, bonded = { 85.0, above = 0 },
  out = "out/stability/peeling",
}
local angle, length, bonded = options.angle, options.length, options.bonded
local steps = math.ceil(angle / options.pitch - 1e-9)

local names = { rotation = "rotation control", arc = "arc length where rotation fails" }
local files, results = sg.files(options.out), {}
for _, control in ipairs(options.control) do
  results[control] = study.solve({
    name = ("Peeling to %g°, %s"):format(angle, names[control]), key = control,
    x = { name = "order", values = options.orders }, y = { name = "mesh", values = options.meshes },
    scene = function(order, mesh) return (peeling.scene(order, mesh, length, bonded)) end,
    path = function()
      return { { name = "rotate", steps = steps, edge = angle } },
        { newton = { iterations = 30 }, arc_length = control == "arc" }
    end,
  }, options, files)
end
files:report()
return { maps = results, files = files }
