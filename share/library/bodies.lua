---@meta _
-- Generated from the help pages by scripts/reference; read by editors, not by the program.
-- Materials, bodies, obstacles

---@class sg
local sg = {}

---@class (exact) sg.neo_hookean.arguments
---E: Young's modulus (a positive number; force per area)
---@field E number
---nu: Poisson's ratio (a number above -1 and below 0.5)
---@field nu number
---@field [string] sg.unknown_argument

---Returns a compressible neo-Hookean material, W = lambda/2 (ln J)^2 + mu/2 (tr C - 3) - mu ln J. In 2D the kind of the
---model decides: plane strain, plane stress or axisymmetric.
---
---```text
---sg.neo_hookean{ E, nu }
---```
---
---Source: (3.29) of V. Agrawal, thesis, IIT Guwahati, 2020.
---
---Example:
---```lua
---sg.neo_hookean{ E = 1, nu = 0.3 }
---```
---@param arguments sg.neo_hookean.arguments
---@return sg.material
function sg.neo_hookean(arguments) end

---@class (exact) sg.linear_elastic.arguments
---E: Young's modulus (a positive number; force per area)
---@field E number
---nu: Poisson's ratio (a number above -1 and below 0.5)
---@field nu number
---@field [string] sg.unknown_argument

---Returns a linear elastic material (Hooke's law of small strains), sigma = lambda tr(eps) I + 2 mu eps; contact still
---follows the deformed surface. In 2D the kind of the model decides: plane strain, plane stress or axisymmetric.
---
---```text
---sg.linear_elastic{ E, nu }
---```
---
---Source: linear elasticity; its use: share/doc/theory.md, Bodies.
---
---Example:
---```lua
---sg.linear_elastic{ E = 1, nu = 0.3 }
---```
---@param arguments sg.linear_elastic.arguments
---@return sg.material
function sg.linear_elastic(arguments) end

---@class (exact) sg.mooney_rivlin.arguments
---c10: modulus of I1' (a number; force per area)
---@field c10 number
---c01: modulus of I2' (a number; force per area)
---@field c01 number
---K: bulk modulus (a positive number; force per area)
---@field K number
---@field [string] sg.unknown_argument

---Returns a Mooney-Rivlin material, W = c10 (I1' - 3) + c01 (I2' - 3) + K/4 (J^2 - 1 - 2 ln J). In 2D the kind of the
---model decides: plane strain, plane stress or axisymmetric.
---
---```text
---sg.mooney_rivlin{ c10, c01, K }
---```
---
---I1' = J^(-2/3) I1 and I2' = J^(-4/3) I2 measure the change of shape, J that of volume. For rubber K is 1000 to 5000
---times the shear modulus, for which elements need degree 2 or more in all directions so as not to lock (nu near 0.5).
---The shear modulus is 2 (c10 + c01).
---
---Source: M. Mooney, J. Appl. Phys. 11, 1940; R. S. Rivlin, Phil. Trans. R. Soc. A 241, 1948. Change of volume: J. C.
---Simo, C. Miehe, Comput. Methods Appl. Mech. Eng. 98, 1992.
---
---Example:
---```lua
---sg.mooney_rivlin{ c10 = 0.4, c01 = 0.1, K = 50 }
---```
---@param arguments sg.mooney_rivlin.arguments
---@return sg.material
function sg.mooney_rivlin(arguments) end

---@class (exact) sg.yeoh.arguments
---c10: half of the shear modulus (a number; force per area)
---@field c10 number
---c20: second modulus, often negative (a number; force per area; default 0)
---@field c20? number
---c30: third modulus (a number; force per area; default 0)
---@field c30? number
---K: bulk modulus (a positive number; force per area)
---@field K number
---@field [string] sg.unknown_argument

---Returns a Yeoh material, W = c10 (I1' - 3) + c20 (I1' - 3)^2 + c30 (I1' - 3)^3 + K/4 (J^2 - 1 - 2 ln J), whose
---stiffness depends on the stretch. In 2D the kind of the model decides: plane strain, plane stress or axisymmetric.
---
---```text
---sg.yeoh{ c10, c20 = 0, c30 = 0, K }
---```
---
---I1' = J^(-2/3) I1 and I2' = J^(-4/3) I2 measure the change of shape, J that of volume. For rubber K is 1000 to 5000
---times the shear modulus, for which elements need degree 2 or more in all directions so as not to lock (nu near 0.5).
---Without c20 and c30 it is neo-Hookean.
---
---Source: O. H. Yeoh, Rubber Chem. Technol. 66, 1993. Change of volume: J. C. Simo, C. Miehe, Comput. Methods Appl.
---Mech. Eng. 98, 1992.
---
---Example:
---```lua
---sg.yeoh{ c10 = 0.5, c20 = -0.01, c30 = 0.001, K = 50 }
---```
---@param arguments sg.yeoh.arguments
---@return sg.material
function sg.yeoh(arguments) end

---@class (exact) sg.ogden.arguments
---mu: one modulus per term (a list of at least one number; force per area)
---@field mu number[]
---alpha: one exponent per term, none of them zero (a list of at least one number)
---@field alpha number[]
---K: bulk modulus (a positive number; force per area)
---@field K number
---@field [string] sg.unknown_argument

---Returns an Ogden material, the sum of mu/alpha (l1'^alpha + l2'^alpha + l3'^alpha - 3) over its terms and K/4 (J^2 -
---1 - 2 ln J), with the principal stretches l' = J^(-1/3) l. In 2D the kind of the model decides: plane strain, plane
---stress or axisymmetric.
---
---```text
---sg.ogden{ mu, alpha, K }
---```
---
---The shear modulus is half of the sum of mu alpha; some programs have 2 mu/alpha^2 in place of mu/alpha.
---
---Source: R. W. Ogden, Proc. R. Soc. A 326, 1972. Change of volume: J. C. Simo, C. Miehe, Comput. Methods Appl. Mech.
---Eng. 98, 1992.
---
---Example:
---```lua
---sg.ogden{ mu = {0.63, 0.0012, -0.01}, alpha = {1.3, 5, -2}, K = 20 }
---```
---@param arguments sg.ogden.arguments
---@return sg.material
function sg.ogden(arguments) end

---@class (exact) sg.saint_venant_kirchhoff.arguments
---E: Young's modulus (a positive number; force per area)
---@field E number
---nu: Poisson's ratio (a number above -1 and below 0.5)
---@field nu number
---@field [string] sg.unknown_argument

---Returns a Saint Venant-Kirchhoff material, W = lambda/2 (tr E)^2 + mu tr E^2 with Green's strain E: Hooke's law for
---large rotations and small strains. It softens under compression and is unstable there. In 2D the kind of the model
---decides: plane strain, plane stress or axisymmetric.
---
---```text
---sg.saint_venant_kirchhoff{ E, nu }
---```
---
---Source: P. Wriggers, Nonlinear Finite Element Methods, Springer, 2008.
---
---Example:
---```lua
---sg.saint_venant_kirchhoff{ E = 1, nu = 0.3 }
---```
---@param arguments sg.saint_venant_kirchhoff.arguments
---@return sg.material
function sg.saint_venant_kirchhoff(arguments) end

---@class (exact) sg.hyperelastic.arguments
---energy: W(I1, I2, J) per volume without strain, and with fibers W(I1, I2, J, I4, …) (a function; optional)
---@field energy? function
---stretches: instead of energy: W of the principal stretches, in any order of which it must be the same (a function;
---```text
---           optional)
---```
---@field stretches? function
---fibers: a list of at least one list of 2 or 3 numbers; optional. Directions of fibers without strain, up to four, of
---```text
---        any length: each adds an argument I4 = |F a|^2, the square of its stretch. {x, y} or {x, y, z}; in
---        axisymmetric models {r, y} or {r, y, around}, without twist
---```
---@field fibers? ([number, number]|[number, number, number])[]
---@field [string] sg.unknown_argument

---Returns an elastic material from its energy per undeformed volume: a function that is called once with symbols for
---the invariants or for the principal stretches, to read its formula. In 2D the kind of the model decides: plane
---strain, plane stress or axisymmetric.
---
---```text
---sg.hyperelastic{ energy, stretches, fibers }
---```
---
---I1 = tr C and I2 = (I1^2 - tr C^2)/2 are those of C = F^T F, which contain the change of volume J = det F; those of
---the change of shape alone are J^(-2/3) \* I1 and J^(-4/3) \* I2. A formula has + - \* / ^ and the functions in help
---"formulas"; ==, \< and > of symbols are errors, but == of a symbol and a number is false and a symbol counts as true,
---which Lua does not report: write no if. The energy must have zero stress and positive moduli without strain. A run
---warns where the law becomes unstable (share/doc/theory.md). Checkpoints and studies hold the formula.
---
---Example:
---```lua
---sg.hyperelastic{ energy = function(I1, I2, J)
---  return 0.2 * (I1 - 3) - 0.4 * sg.log(J) + 0.5 * sg.log(J)^2
---end }
---sg.hyperelastic{ stretches = function(l1, l2, l3)
---  local J = l1 * l2 * l3
---  return 0.1 * (l1^3 + l2^3 + l3^3 - 3) - 0.3 * sg.log(J) + (J - 1)^2
---end }
---sg.hyperelastic{ fibers = { {1, 0} }, energy = function(I1, I2, J, I4)
---  return 0.2 * (I1 - 3) - 0.4 * sg.log(J) + 0.5 * sg.log(J)^2 + 0.3 * (sg.exp((I4 - 1)^2) - 1)
---end }
---```
---@param arguments sg.hyperelastic.arguments
---@return sg.material
function sg.hyperelastic(arguments) end

---A material; print(material) shows law and constants. For a law from an energy E and nu are those of small strains,
---with fibers on average over all directions.
---@class sg.material
local material = {}

---@class (exact) sg.body.arguments.patch
---interfaces: faces on each other (a list of entries: each a list of two faces such as '1.east'; optional)
---@field interfaces? [string, string][]
---boundaries: faces by name (a table of names { name = … }; optional)
---@field boundaries? table<string, string[]>
---@field [integer] sg.patch
---@field [string] sg.unknown_argument

---@alias sg.body.arguments.order.choice "N1"|"N2"|"N3"|"N4"|"N2-N2.1"|"N2-N2.2"|"N2-N4"|"L1"|"L2"|string

---@alias sg.body.arguments.contact.choice "west"|"east"|"south"|"north"|"front"|"back"|string

---@class (exact) sg.body.arguments.grading
---elements: fraction of the elements (a number above 0 and below 1)
---@field elements number
---length: fraction of the knot length that they fill (a number above 0 and below 1)
---@field length number
---at: the end with the small elements ('start' or 'end')
---@field at "start"|"end"
---@field [string] sg.unknown_argument

---@class (exact) sg.body.arguments
---patch: shape: a surface in the plane, a volume in 3D, or a list of these, see help "compound" (a patch or a list of
---```text
---       one or more patches)
---```
---@field patch sg.patch|sg.body.arguments.patch
---elements: a list of whole numbers from 1 to 1000000, one per direction. Knot spans; with a list of patches also a
---list
---```text
---          with an entry per patch. Peak pressures need at least 7 across a contact with order N2, 3 with N2-N2.2
---          (penalty in help "contact"); a run warns if a contact has fewer
---```
---@field elements integer|integer[]
---order: discretization label such as "N2-N2.2", help "orders" (a label or a list of labels, one per direction (along
---```text
---       the contact face, if any))
---```
---@field order sg.body.arguments.order.choice|sg.body.arguments.order.choice[]
---contact: a face name or a list of at least one face name; by default none. Face that carries the layer, or two
---```text
---         opposite ones; required for orders with a layer. Any face can be slave or master of a contact
---```
---@field contact? sg.body.arguments.contact.choice|sg.body.arguments.contact.choice[]
---layer: a list of 2 increasing numbers {low, high}, a list of 2 ranges {{low, high}, {low, high}} or a function; by
---```text
---       default the whole face. Where the layer is, with elements that overlap it: parameters along the contact face;
---       in space a range per direction, whose strips both have the layer's degree along them; or a function of the
---       undeformed position X. With the degree the continuity changes: that of the bulk at the borders
---```
---@field layer? [number, number]|[[number, number], [number, number]]|(fun(X: [number, number]|[number, number, number]): boolean)
---layer_knots: a whole number from 1 to 1000 or a list of entries: each a number or a list of numbers; optional. Knots
---```text
---             of the contact rows only: the number of equal parts of each element of the layer, or a list of knots; in
---             space also a list with one of these per direction
---```
---@field layer_knots? integer|(number|number[])[]
---material: the material (a material)
---@field material sg.material
---thickness_degree: a whole number from 1 to 15; by default that of the label's bulk. Degree in the thickness
---direction,
---```text
---              from the contact face to the opposite one, at least the geometry's own. Degree 1, as in the published
---              studies, has fewer unknowns and takes about half of the time, but locks in bending and for nu near 0.5
---```
---@field thickness_degree? integer
---volumetric: 'pointwise' or 'projected'; by default "pointwise". Volume change of each point, or its projection on
---```text
---            polynomials of one degree less in macro-elements of p elements per direction: nothing locks for nu near
---            0.5, at the cost of larger coupled groups. Not for plane stress
---```
---@field volumetric? "pointwise"|"projected"
---grading: where elements are concentrated; false: uniform (a list of entries: each a table of named arguments or
---false,
---```text
---         one per direction; by default uniform elements)
---  elements: fraction of the elements (a number above 0 and below 1)
---  length:   fraction of the knot length that they fill (a number above 0 and below 1)
---  at:       the end with the small elements ('start' or 'end')
---```
---@field grading? sg.body.arguments.grading|false|(sg.body.arguments.grading|false)[]
---@field [string] sg.unknown_argument

---Returns a solid body: a patch with a discretization and a material.
---
---```text
---sg.body{ patch, elements, order, contact, layer, layer_knots, material, thickness_degree, volumetric, grading }
---```
---
---Where two opposite faces of the patch coincide, as in a full ring, the body is joined at this seam. print(body) shows
---the degrees and the closed directions.
---
---Source: k-refinement 2.3.3, varying-order layers (5.1) to (5.6) of V. Agrawal, thesis, IIT Guwahati, 2020.
---
---Example:
---```lua
---sg.body{ patch = sg.shapes.rectangle{ width = 3, height = 1 }, elements = {8, 3}, order = "N2-N2.2",
---         contact = "north", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
---sg.body{ patch = sg.shapes.block{ size = {4, 4, 2} }, elements = {4, 4, 2}, order = {"N2-N4", "N2"},
---         contact = "back", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
---sg.body{ patch = sg.shapes.block{ size = {9, 6, 2} }, elements = {9, 6, 2}, order = "N2-N2.2", contact = "back",
---         layer = function(X) return (X[1] - 4) ^ 2 + (X[2] - 3) ^ 2 < 1 end,
---         material = sg.neo_hookean{ E = 1, nu = 0.3 } }
---```
---@param arguments sg.body.arguments
---@return sg.body|sg.compound
function sg.body(arguments) end

---The result of sg.body, an immutable value. print(body) shows elements and degrees per direction (per row of control
---points where these differ) and the size; tostring(body) shows the first line only.
---
---Methods: face, edge, corner, dofs, points.
---@class sg.body
local body = {}

---The result of sg.body for a list of patches, such as sg.nurbs.read returns: a body of several patches, whose parts
---are single bodies. In a model the parts of `ball` are "ball.1", "ball.2", …, in the order of the list; as `bodies` of
---a picture "ball" means all of them.
---
---Faces of two parts that lie on each other are joined; where their meshes do not match they are tied, and so are faces
---up to 10 % of an element's length apart, with a warning. print(model) shows what happened. If the list has
---`interfaces`, only the faces in it are joined: { { "1.east", "2.west" }, … }. Parts that nothing connects with others
---are an error. `boundaries` of the list names faces: { outer = { "1.south", "2.south" } }; compound:face "outer" then
---returns these. Arguments of sg.body: order is one label for all; contact lists faces such as "1.south", or
---boundaries; parts without such a face have the label's bulk, N2 of N2-N4; layer is a function if several parts have
---contact faces. Methods: face, edge, corner, part.
---
---Example:
---```lua
---square = sg.shapes.rectangle
---pair = sg.body{ patch = { square{ width = 1, height = 1 }, square{ width = 1, height = 1, corner = {1, 0} },
---                          boundaries = { top = { "1.north", "2.north" } } },
---                elements = {2, 2}, order = "N2", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
---beam = sg.model{ bodies = { pair = pair }, supports = { lid = { on = pair:face "top", fix = "xy" } } }
---```
---@class sg.compound
local compound = {}

---Returns the control point of a corner of a part, for supports.
---
---Example:
---```lua
---pair:corner "1.south-west"
---```
---@param name string # name: part and corner: "2.south-west" (a corner name)
---@return sg.face
function compound:corner(name) end

---Returns the control points of an edge of a part of a solid body, for supports.
---
---Example:
---```lua
---cubes:edge "1.south-front"
---```
---@param name string # name: part and edge: "2.south-front" (an edge name)
---@return sg.face
function compound:edge(name) end

---Returns a face of a part, or the list of the faces of a boundary, for supports, loads, contacts, ties and joins. As
---slave or master the faces of a list must be adjacent.
---
---Example:
---```lua
---pair:face "top"
---```
---@param name string # name: part and face, "2.north", or a boundary (a face name)
---@return any
function compound:face(name) end

---Returns a part as a body.
---
---Example:
---```lua
---pair:part(2):dofs().total
---```
---@param number integer # number: from 1, in the order of the patches (a whole number, 1 or more)
---@return sg.body
function compound:part(number) end

---@class (exact) sg.body.dofs.result
---@field interface integer
---@field bulk integer
---@field total integer

---Returns the numbers of degrees of freedom { interface, bulk, total }: those of the contact faces' control points, of
---all others, of all.
---
---Example:
---```lua
---slab:dofs().total
---```
---@return sg.body.dofs.result
function body:dofs() end

---Returns a face for supports, loads and contacts.
---
---Example:
---```lua
---slab:face "north"
---```
---@param name string # name: west, east (ends of xi1), south, north (xi2), front, back (xi3) (a face name)
---@return sg.face
function body:face(name) end

---Returns the control points where two faces of a solid body meet, for supports.
---
---Example:
---```lua
---cube:edge "south-front"
---```
---@param name string # name: both faces, such as "south-front" (an edge name)
---@return sg.face
function body:edge(name) end

---Returns the control point of a corner, for supports.
---
---Example:
---```lua
---slab:corner "south-west"
---```
---@param name string # name: its faces: "south-west", in 3D "west-south-front" (a corner name)
---@return sg.face
function body:corner(name) end

---Returns the control points {{x, y}, …} of the undeformed body, row after row from south to north, or from west to
---east where the contact face is west or east; in 3D {{x, y, z}, …}, layer after layer from front to back, or along the
---direction of the contact face.
---
---Example:
---```lua
---slab:points()[1]  --> {0.0, 0.0}
---```
---@return ([number, number]|[number, number, number])[]
function body:points() end

---A face, edge or corner of a body, for supports, loads and contacts; print(face) shows which one it is.
---@class sg.face
local face = {}

---@class sg.rigid
sg.rigid = {}

---@class (exact) sg.rigid.plane.arguments
---point: a point of the plane (a list of 2 or 3 numbers; length)
---@field point [number, number]|[number, number, number]
---normal: direction out of the obstacle, towards the body (a list of 2 or 3 numbers)
---@field normal [number, number]|[number, number, number]
---@field [string] sg.unknown_argument

---Returns a rigid half space in 2D or 3D as an obstacle, the master of a contact. A support can move it: see help
---"obstacle".
---
---```text
---sg.rigid.plane{ point, normal }
---```
---
---Example:
---```lua
---sg.rigid.plane{ point = {0, -1}, normal = {0, 1} }
---sg.rigid.plane{ point = {0, 0, -1}, normal = {0, 0, 1} }
---```
---@param arguments sg.rigid.plane.arguments
---@return sg.obstacle
function sg.rigid.plane(arguments) end

---@class (exact) sg.rigid.cylinder.arguments
---center: a point of the axis (a list of 2 or 3 numbers; length)
---@field center [number, number]|[number, number, number]
---axis: direction of the axis; needed in 3D, not allowed in 2D (a list of 3 numbers {x, y, z}; optional)
---@field axis? [number, number, number]
---radius: a positive number; length
---@field radius number
---inside: hollow: the body is inside, as in a bore, a socket or a groove (true or false; default false)
---@field inside? boolean
---@field [string] sg.unknown_argument

---Returns a rigid cylinder of infinite length as an obstacle; in the plane, a disc. A support can move it: see help
---"obstacle".
---
---```text
---sg.rigid.cylinder{ center, axis, radius, inside = false }
---```
---
---Example:
---```lua
---sg.rigid.cylinder{ center = {0, 2}, radius = 1 }
---sg.rigid.cylinder{ center = {0, 0, 2}, axis = {0, 1, 0}, radius = 1 }
---sg.rigid.cylinder{ center = {0, 0}, radius = 3, inside = true }
---```
---@param arguments sg.rigid.cylinder.arguments
---@return sg.obstacle
function sg.rigid.cylinder(arguments) end

---@class (exact) sg.rigid.sphere.arguments
---center: a list of 2 or 3 numbers; length
---@field center [number, number]|[number, number, number]
---radius: a positive number; length
---@field radius number
---inside: hollow: the body is inside, as in a bore, a socket or a groove (true or false; default false)
---@field inside? boolean
---@field [string] sg.unknown_argument

---Returns a rigid sphere in 3D, or on the axis of an axisymmetric model, as an obstacle. A support can move it: see
---help "obstacle".
---
---```text
---sg.rigid.sphere{ center, radius, inside = false }
---```
---
---Example:
---```lua
---sg.rigid.sphere{ center = {0, 0, 2}, radius = 1 }
---sg.rigid.sphere{ center = {0, 0, 0}, radius = 3, inside = true }
---```
---@param arguments sg.rigid.sphere.arguments
---@return sg.obstacle
function sg.rigid.sphere(arguments) end

---@class (exact) sg.rigid.torus.arguments
---center: in 2D {r, z}, of the circle; in 3D of the torus (a list of 2 or 3 numbers; length)
---@field center [number, number]|[number, number, number]
---axis: direction of the axis; needed in 3D, not allowed in 2D (a list of 3 numbers {x, y, z}; optional)
---@field axis? [number, number, number]
---ring: distance of the circle's center from the axis; needed in 3D, not allowed in 2D (a positive number; length;
---```text
---      optional)
---```
---@field ring? number
---radius: of the circle (a positive number; length)
---@field radius number
---inside: hollow: the body is inside, as in a bore, a socket or a groove (true or false; default false)
---@field inside? boolean
---@field [string] sg.unknown_argument

---Returns a rigid torus as an obstacle: in an axisymmetric model a disc off the axis, in 3D a circle revolved about an
---axis. A groove is a hollow one, inside = true. A support can move it: see help "obstacle".
---
---```text
---sg.rigid.torus{ center, axis, ring, radius, inside = false }
---```
---
---Example:
---```lua
---sg.rigid.torus{ center = {4, 1}, radius = 0.5 }
---sg.rigid.torus{ center = {0, 0, 1}, axis = {0, 0, 1}, ring = 4, radius = 0.5 }
---```
---@param arguments sg.rigid.torus.arguments
---@return sg.obstacle
function sg.rigid.torus(arguments) end

---@class (exact) sg.rigid.level_set.arguments
---f: positive outside, negative inside (a function)
---@field f fun(x: sg.symbol, y: sg.symbol, z: sg.symbol): sg.symbol
---box: {corner, opposite corner}: where contact occurs (a list of 2 points; length)
---@field box [[number, number]|[number, number, number], [number, number]|[number, number, number]]
---@field [string] sg.unknown_argument

---Returns an obstacle bounded by the curve or surface f = 0 of a formula, with f > 0 outside. The function is called
---once with symbols for the coordinates, to read its formula; in an axisymmetric model x is the radius. A support can
---move it: see help "obstacle".
---
---```text
---sg.rigid.level_set{ f, box }
---```
---
---Closest points are searched from points of the surface in the box, found on a lattice of 160 (in 3D 40) cells along
---its longest side, so that details must be larger; pictures show that part. The surface does not end at the box. It
---may have several parts. f must be finite in the box and have a gradient where it is zero: use one obstacle per
---surface where surfaces cross. Corners and edges, as of sg.abs, have no closest points that Newton's method finds:
---round them, as in the superellipse below. A formula has + - \* / ^ and the functions in help "formulas"; write no if.
---Checkpoints and studies hold the formula.
---
---Example:
---```lua
---sg.rigid.level_set{ f = function(x, y) return x^4 + (y / 2)^4 - 1 end, box = { {-2, -3}, {2, 3} } }
---sg.rigid.level_set{ f = function(x, y, z) return z - 0.1 * sg.cos(x) * sg.cos(y) end,
---  box = { {-5, -5, -1}, {5, 5, 1} } }
---```
---@param arguments sg.rigid.level_set.arguments
---@return sg.obstacle
function sg.rigid.level_set(arguments) end

---Returns an obstacle bounded by a NURBS: a curve in the plane, whose outside is on the right of its direction, or a
---surface in 3D, whose outward normal is the cross product of its tangents along xi1 and xi2. patch:reverse(1)
---exchanges inside and outside. A support can move it: see help "obstacle".
---
---The patch may come from a file, sg.rigid.surface(sg.nurbs.read("tool.xml")[1]); of a body's shape take a face,
---patch:face "north". Rounding errors are those of its largest coordinate: an arc of radius 4e6 on a layer 0.25 thick
---gives a force 2e-4 off. Planes, cylinders, spheres and tori have no such limit.
---
---Example:
---```lua
---sg.rigid.surface(sg.nurbs.arc{ center = {0, 0}, radius = 1, from = 0, to = 180 })
---sg.rigid.surface(sg.shapes.block{ size = {9, 9, 1}, corner = {0, 0, -1} }:face "back")
---```
---@param patch sg.patch # patch: curve in the plane, or surface in 3D (a patch)
---@return sg.obstacle
function sg.rigid.surface(patch) end

---The result of sg.rigid.\*: a rigid master; print(obstacle) shows its shape. It is fixed unless a support drives,
---rotates or frees it: supports = { push = { on = obstacle, drive = "y" } }; stages then give its displacement, push =
---{-0.1}, and run:column "push.fy" returns the force that the support exerts on the obstacle, which equals the contact
---force on the slave, run:column "touch.fy".
---
---Example:
---```lua
---disc = sg.rigid.cylinder{ center = {1.5, 2}, radius = 1 }
---sg.model{ bodies = { slab = slab },
---  supports = { bed = { on = slab:face "south", fix = "xy" }, push = { on = disc, drive = "y" } },
---  contacts = { touch = { slave = slab:face "north", master = disc, penalty = 100 } } }
---```
---@class sg.obstacle
local obstacle = {}
