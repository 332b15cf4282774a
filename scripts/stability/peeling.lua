-- Where peeling holds: mesh against discretisation label, under rotation control and with arcs.
--
-- Problem: a strip that sticks to a rigid substrate by van der Waals forces is peeled by turning its free end. On
--          coarse meshes the film tears in jerks: the path of the discrete problem turns back, and a step in the
--          angle can only jump.
--
--                                                     θ
--           ____________________________________________↶   right edge: turned as a rigid line, both translations free
--          |        strip 100 × 10 nm                   |
--          |____________________________________________|
--           0  : adhesion : 85                        100     one u_x of the left bottom corner pinned
--          =============================================
--
--          Half as long as published, with elements as long as published (1.25, 1 and 0.83 nm in m1 to m3; m0: 2.5 nm).
--          Two maps each way: rotation control, and arc_length = true.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, section 7.4.
-- Units: nm, nN, degrees.
-- Expected: under rotation control plain Newton holds 11 of 15 cells: N2, N4 and N2-N4 at m0 and N2 at m1 meet turning
--           points, at 35°, 46°, 40° and 76°; N2-N2.1 and N2-N2.2 hold on every mesh. Arcs lead through all 15 cells.
--           The controls hold 14, jumping at the turning points, by 7, 6 and 3 rescues, to a state behind the fold; N4
--           at m0 stops at 82°. With arcs they hold all 15, and jump as well: other first guesses and cut steps come
--           before arcs. Where both hold, the controls take 0.87 and 0.96 times as many iterations.
-- Run: signorini scripts/stability/peeling.lua [control=rotation,arc] [labels=N2,N4,N2-N4,N2-N2.1,N2-N2.2]
--      [meshes=m0,m1,m2] [angle=90] [pitch=0.2] [length=100] [bonded=85] [jobs=2] [limit=600] [keep=no] [with=robust]
--      [out=out/stability/peeling]; pitch: degrees a step; keep=yes takes up the cells that an earlier call left in the
--      folder; with=cutting, rescue or prediction turns on one of the controls alone.

local sg = require "signorini"
local peeling = require "peeling2d.problem"
local study = require "stability.study"

local options = study.arguments{
  control = { { "rotation", "arc" }, choices = { "rotation", "arc" } },
  labels = { "N2", "N4", "N2-N4", "N2-N2.1", "N2-N2.2" },
  meshes = { { "m0", "m1", "m2" }, choices = { "m0", "m1", "m2", "m3" } }, angle = { 90.0, above = 0 },
  pitch = { 0.2, above = 0 }, length = { 100.0, above = 0 }, bonded = { 85.0, above = 0 },
  out = "out/stability/peeling",
}
local angle, length, bonded = options.angle, options.length, options.bonded
local steps = math.ceil(angle / options.pitch - 1e-9)

local names = { rotation = "rotation control", arc = "arcs where rotation fails" }
local files, results = sg.files(options.out), {}
for _, control in ipairs(options.control) do
  results[control] = study.solve({
    name = ("Peeling to %g°, %s"):format(angle, names[control]), key = control,
    x = { name = "label", values = options.labels }, y = { name = "mesh", values = options.meshes },
    scene = function(label, mesh) return (peeling.scene(label, mesh, length, bonded)) end,
    path = function()
      return { { name = "rotate", steps = steps, edge = angle } },
        { newton = { iterations = 30 }, arc_length = control == "arc" }
    end,
  }, options, files)
end
files:report()
return { maps = results, files = files }
