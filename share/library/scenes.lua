---@meta _
-- Generated from the help pages by scripts/reference; read by editors, not by the program.
-- Ready scenes

---@class sg
local sg = {}

---@class sg.scenes
sg.scenes = {}

---@class (exact) sg.scenes.ironing.arguments
---order: discretization of all bodies, help "orders" (a label or a list of labels; default "N2-N2.2")
---@field order? string|string[]
---refinement: factor on the number of elements in each direction (a whole number from 1 to 64; default 1)
---@field refinement? integer
---mu: Coulomb's coefficient of friction (a number, 0 or more; default 0.2)
---@field mu? number
---depth: by which it is pressed down (a number from 0.01 to 0.5; length; default 0.23)
---@field depth? number
---distance: by which it is dragged (a number from 0.01 to 1.7; length; default 0.6)
---@field distance? number
---@field [string] sg.unknown_argument

---Returns a plane model of a half ring above a soft slab, and the path that presses it down and drags it along: m, path
---= sg.scenes.ironing{}; m:run(path).
---
---```text
---sg.scenes.ironing{ order = "N2-N2.2", refinement = 1, mu = 0.2, depth = 0.23, distance = 0.6 }
---```
---
---Bodies die (E = 1000) and slab (E = 1, 3 × 1), supports bed and grip, contact interface. The path is a list of two
---stages, press and slide, to be changed as needed: path[2].steps = 200.
---
---Source: V. Agrawal, thesis, IIT Guwahati, 2020, 7.1; the supplied script ironing2d.lua has its variants.
---
---Example:
---```lua
---m, path = sg.scenes.ironing{ mu = 0.1 }
---run = m:run(path)
---sg.picture{ model = m, field = "uy", file = "ironing.png" }
---```
---@param arguments? sg.scenes.ironing.arguments
---@return sg.model
---@return sg.stage[]
function sg.scenes.ironing(arguments) end

---@class (exact) sg.scenes.hertz.arguments
---body: a cylinder (plane strain) or a ball (axisymmetric) ('cylinder' or 'ball'; default "cylinder")
---@field body? "cylinder"|"ball"
---order: discretization of all bodies, help "orders" (a label or a list of labels; default "N2-N2.2")
---@field order? string|string[]
---refinement: factor on the number of elements along the arc, of the ball in both directions (a whole number from 1 to
---```text
---            64; default 1)
---```
---@field refinement? integer
---load: force, of the cylinder per depth (a positive number; by default 0.002, of the ball 3.1416e-4)
---@field load? number
---@field [string] sg.unknown_argument

---@class (exact) sg.scenes.hertz.result3
---@field a number
---@field p0 number
---@field load number

---Returns a model of a hollow cylinder or ball on a rigid plane, the path that presses it down by a force, and Hertz's
---closed form { a, p0, load }: half-width (radius) of the contact, peak pressure, force.
---
---```text
---sg.scenes.hertz{ body = "cylinder", order = "N2-N2.2", refinement = 1, load }
---```
---
---Outer radius 1, E = 1, nu = 0.3; half of the section is modeled, x = 0 is the plane of symmetry or the axis. The
---contact is ground. Hertz's half space neglects a/R: pressures agree to about 1 % for the cylinder and 2.5 % for the
---ball.
---
---Source: K. L. Johnson, Contact Mechanics, Cambridge, 1985, 4.2; the supplied scripts hertz2d.lua and
---hertz_sphere.lua.
---
---Example:
---```lua
---m, path, hertz = sg.scenes.hertz{ body = "cylinder" }
---m:run(path)
---print(m:contact_resultant "ground".max_pressure / hertz.p0)
---print(sg.profile_edges{ profile = m:profile "ground" }.to / hertz.a)
---```
---@param arguments? sg.scenes.hertz.arguments
---@return sg.model
---@return sg.stage[]
---@return sg.scenes.hertz.result3
function sg.scenes.hertz(arguments) end

---@class (exact) sg.scenes.rings.arguments
---order: discretization of all bodies, help "orders" (a label or a list of labels; default "N2-N2.2")
---@field order? string|string[]
---refinement: factor on the number of elements along the arcs (a whole number from 1 to 64; default 1)
---@field refinement? integer
---mu: Coulomb's coefficient of friction (a number, 0 or more; default 0.1)
---@field mu? number
---depth: by which the upper ring is pressed down (a number from 0.1 to 4; length; default 4)
---@field depth? number
---@field [string] sg.unknown_argument

---Returns a plane model of two half rings, a quarter of each by symmetry, and the path that presses them together; they
---bend and slide.
---
---```text
---sg.scenes.rings{ order = "N2-N2.2", refinement = 1, mu = 0.1, depth = 4 }
---```
---
---Bodies upper (E = 100) and lower (E = 300), supports bed, symmetry and grip, contact interface.
---
---Source: V. Agrawal, thesis, IIT Guwahati, 2020; the supplied script rings2d.lua.
---
---Example:
---```lua
---m, path = sg.scenes.rings{ depth = 1 }
---m:run(path)
---```
---@param arguments? sg.scenes.rings.arguments
---@return sg.model
---@return sg.stage[]
function sg.scenes.rings(arguments) end

---@class (exact) sg.scenes.block.arguments
---order: discretization of all bodies, help "orders" (a label or a list of labels; default "N2")
---@field order? string|string[]
---refinement: factor on the number of elements in each direction (a whole number from 1 to 64; default 1)
---@field refinement? integer
---mu: Coulomb's coefficient of friction (a number, 0 or more; default 0)
---@field mu? number
---depth: by which it is pressed down (a number from 0.1 to 2; length; default 1)
---@field depth? number
---distance: by which it is dragged (a number from 0.1 to 12.5; length; default 1)
---@field distance? number
---@field [string] sg.unknown_argument

---Returns a 3D model of a block above a slab, half of both by symmetry, and the path that presses it down and drags it
---along.
---
---```text
---sg.scenes.block{ order = "N2", refinement = 1, mu = 0, depth = 1, distance = 1 }
---```
---
---Bodies block (E = 10, 4 × 2 × 4) and slab (E = 1, 20 × 5 × 10), supports bed, grip and mirror, contact interface. The
---sharp edges of the block plow through the slab.
---
---Source: L. De Lorenzis, P. Wriggers, G. Zavarise, Comput. Mech. 49 (2012); the supplied script block_ironing3d.lua.
---
---Example:
---```lua
---m, path = sg.scenes.block{ depth = 0.5, distance = 0.5 }
---m:run(path)
---```
---@param arguments? sg.scenes.block.arguments
---@return sg.model
---@return sg.stage[]
function sg.scenes.block(arguments) end

---@class (exact) sg.scenes.peeling.arguments
---order: discretization of all bodies, help "orders" (a label or a list of labels; default "N2-N2.2")
---@field order? string|string[]
---refinement: factor on the number of elements in each direction (a whole number from 1 to 64; default 1)
---@field refinement? integer
---bonded: length of the bond; the strip is 10 nm longer (a number from 20 to 400; nm; default 50)
---@field bonded? number
---angle: by which the end is rotated (a number from 1 to 180; degrees; default 46)
---@field angle? number
---@field [string] sg.unknown_argument

---@class (exact) sg.scenes.peeling.result3
---@field moment number
---@field work number

---Returns a plane model of a strip that adheres to a rigid plane by van der Waals forces, the path that rotates its end
---and so peels it, and { moment, work }: the moment of steady peeling of a thin strip and the work of adhesion.
---
---```text
---sg.scenes.peeling{ order = "N2-N2.2", refinement = 1, bonded = 50, angle = 46 }
---```
---
---Body strip (E = 2 nN/nm², nu = 0.2, 10 nm high), supports edge and pin, contact film. The columns edge.angle and
---edge.moment of the run show a plateau, within 1 % of the closed form, until the bond ends.
---
---Source: R. A. Sauer, Int. J. Numer. Meth. Engng 87 (2011); the supplied script peeling2d.lua.
---
---Example:
---```lua
---m, path, steady = sg.scenes.peeling{ bonded = 20, angle = 20 }
---run = m:run(path)
---print(run:column "edge.moment"[run.steps] / steady.moment)
---```
---@param arguments? sg.scenes.peeling.arguments
---@return sg.model
---@return sg.stage[]
---@return sg.scenes.peeling.result3
function sg.scenes.peeling(arguments) end

---@class (exact) sg.scenes.patch_test.arguments
---dimension: 2: plane strain, 3: solids (a whole number from 2 to 3; default 2)
---@field dimension? integer
---order: discretization of all bodies, help "orders" (a label or a list of labels; default "N2")
---@field order? string|string[]
---refinement: factor on the number of elements in each direction (a whole number from 1 to 64; default 1)
---@field refinement? integer
---method: contact formulation, help "contact" ('gpts', 'mortar' or 'half_passes'; default "gpts")
---@field method? "gpts"|"mortar"|"half_passes"
---@field [string] sg.unknown_argument

---@class (exact) sg.scenes.patch_test.result3
---@field pressure number

---Returns a model of two blocks with meshes that do not match, the path that loads the upper one by a pressure, and {
---pressure }, the contact pressure at every point.
---
---```text
---sg.scenes.patch_test{ dimension = 2, order = "N2", refinement = 1, method = "gpts" }
---```
---
---Bodies lower (E = 1) and upper (E = 2), load push, contact joint.
---
---Source: R. L. Taylor, P. Papadopoulos, in Nonlinear Computational Mechanics, Springer, 1991; the supplied script
---patch_test.lua.
---
---Example:
---```lua
---m, path, exact = sg.scenes.patch_test{ method = "mortar" }
---m:run(path)
---print(m:contact_resultant "joint".max_pressure / exact.pressure)
---```
---@param arguments? sg.scenes.patch_test.arguments
---@return sg.model
---@return sg.stage[]
---@return sg.scenes.patch_test.result3
function sg.scenes.patch_test(arguments) end
