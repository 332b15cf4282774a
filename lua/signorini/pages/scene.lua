-- Pages: a scene and its parts.

local rows = require "signorini.pages.contact_rows"
local lists = require "signorini.call.lists"
local t = require "signorini.call.types"

local thesis = "V. Agrawal, thesis, IIT Guwahati, 2020"
local axes = t.choice { "x", "y", "z", "xy", "xz", "yz", "xyz" }
axes.cure = 'name components, as in "xy"; stages of model:run give the values of driven ones'
local face, obstacle = t.object "face", t.object "obstacle"

local course = t.callback_of({ { "x", t.number }, { "y", t.number }, { "z", t.number } }, t.any)

local adjacent = t.worded(t.flat(face), "a face or a list of adjacent faces")
local slave = t.worded(t.flat(face), "a face or a list of adjacent faces")
slave.cure = function(value)
  return require("signorini.pages").kind(value) == "obstacle" and "an obstacle can only be the master: exchange the two"
    or nil
end

local region = t.callback_of({ { "X", t.numbers() } }, t.any)
region.cure = "write a function of a reference position of the slave face, as in "
  .. "function(X) return X[1] <= 150 end"

local law_of_gap = t.worded(t.callback, "a function")
law_of_gap.cure = "write a formula, as in function(g) return k * sg.max(0, -g) ^ m end; a constant stiffness is penalty"

local contact = {
  "Most used:",
  { "slave", slave, [[face over which contact is integrated; pressures are computed at its contact points. Use the finer
mesh, of equal meshes the softer body (the published ironing studies use the stiff die); with enforcement =
"multipliers" the softer body, whose functions can follow all multipliers of its face. A list of adjacent faces, of
joined bodies or of one, acts as one face: a chain in the plane, a row or a full grid in 3D; against an obstacle,
without multipliers, any list]], optional = true },
  { "master", t.either(obstacle, t.flat(face)), [[face of the other body onto which these points are projected, a
list of adjacent faces, or an obstacle. Points slide across the borders of a list; only its ends are edges. Beyond its
edges (a closed ring has none along its arc) the master is extended by 0.3 of an element, the smaller of its last one
and the slave's; there the traction decreases to zero]], optional = true },
  { "among", t.worded(t.either(t.flat(face), t.choice { "all" }), 'a face, a list of faces, or "all"'), [[in place of
slave and master: faces of one body or several, any of which may touch itself and any other. Every point of every face
is a contact point, so that no side is preferred; method is "gpts" or "half_passes". Borders that faces of the list have
in common are not edges; corners between them are in contact as well. A piece that turns by less than 60 degrees has
no contact with itself. "all": all faces of all bodies that are neither joined nor tied, and every obstacle that a
support holds, with which contacts are named <name>.<support>]], optional = true },
  { "except", t.list(rows.pair), [[of `among`, pairs { A, B } that do not touch each other: each a face, a body for all
its faces, an obstacle, or a list of these. { A, A }: A does not touch itself]], optional = true },
  { "pairs", t.map(t.named(rows.own_law)), [[of `among`, pairs with constants of their own: { <pair> = { between = { A,
B }, friction, penalty, wear } }, A and B as in `except`. What it does not give is that of the set; a penalty by default
is that of its faces. Each is a contact <name>.<pair> in stages and results]], optional = true },
  { "penalty", t.positive, [[normal penalty: p = -penalty g where the gap g is negative. By default 30 E / h, E of the
softer body, h the (harmonic) mean size of the slave's elements in the contact; print(model) shows it. In Hertz's
contacts the force is then right to 1 or 2 %, and at Gauss points the peak pressure to 10 % where at least 7 control
points of the slave face (with N2 elements) touch across the contact; 100 E / h needs 13, 1000 E / h 40, since a high
penalty over-constrains the face. Mortar contact needs 8 ("reduced": 6) at any penalty. Penetration increases as the
penalty decreases: model:contact_resultant(name).max_penetration. With enforcement = "multipliers" it affects
results by the discretization error alone; it is then 10 E / h by default, h of the softer body]],
    unit = "pressure per length", otherwise = "from material and mesh" },
  { "pressure", law_of_gap, [[function(g, X, Y, Z) (those that it needs, by name) that returns a formula, help
"formulas", of the gap g and the reference position of the slave point, in place of the penalty: the pressure below
`clearance`, which falls to 0 there as the gap grows. Soft layers and rough faces have p = k (-g)^m; sg.max(0, …) cuts a
formula off. Where it pulls, at p < 0, it is adhesion, with per = "reference". For enforcement = "penalty"]],
    unit = "force per area", optional = true },
  { "clearance", t.either(t.number, t.choice { "none" }), 'gap below which `pressure` acts; "none": at any gap',
    unit = "length", otherwise = "0" },
  { "friction", t.named {
    rows.coefficient,
    rows.along,
    { "penalty", t.positive, "tangential penalty, stiffness of elastic slip", unit = "pressure per length",
      otherwise = "that of the contact, with `pressure` 30 E / h" },
  }, "Coulomb friction", otherwise = "none" },
  { "method", t.choice { "gpts", "mortar", "half_passes" }, [[gpts: Gauss-point-to-surface, penalty at the contact
points. mortar: penalty on gaps and slips that are weighted by functions on the slave face (multipliers); a high penalty
then does not over-constrain. half_passes: as gpts, with `multipliers` as mortar, but each of the two faces is slave
once and receives only the force of its own pass: no choice of slave biases the result, twice the points, unsymmetric
tangents, and action equals reaction only up to the discretization error, imbalance in model:contact_resultant]],
    default = "gpts" },
  "Further:",
  { "enforcement", t.choice { "penalty", "multipliers" }, [[penalty: penetrations in proportion to the pressure remain.
multipliers: with method = "mortar", Lagrange multipliers as unknowns; the contact conditions hold weighted by their
functions, and are integrated point by point]],
    default = "penalty" },
  { "multipliers", t.choice { "equal", "reduced", "linear" }, [[functions of the multipliers of mortar contact, in half
passes of either face. equal: those of the slave face. reduced: of degree p - 2 on its elements, continuity two less
(N2: constant per element), proven stable (inf-sup); for degree p >= 2. linear: of degree 1, one per element of the
slave; with enforcement = "multipliers" and a softer master one per so many elements that they are not more than the
functions of the master]],
    otherwise = [["equal" with method = "mortar", with enforcement = "multipliers" on a slave stiffer than the master
"linear"; without it half passes act at contact points]] },
  { "per", t.choice { "current", "reference" }, [[area of the slave face on which tractions act, and to which penalty
and friction.penalty refer. "current" is that of the published studies; with "reference" and without friction the forces
derive from an energy, and the tangent is symmetric. method = "mortar", adhesion and cohesive act per reference area,
half passes per current area, also with multipliers]],
    otherwise = '"current", with method = "mortar", adhesion or cohesive "reference"' },
  { "points", t.worded(t.either(t.integer(1, 100), t.choice { "auto" }), 'a whole number from 1 to 100 or "auto"'),
    [[Gauss points per slave element and direction. "auto": 2 (p + 1) in elements that are wholly open, stick or
slip, away from the border of the contact, 3 (p + 1) elsewhere, chosen after each step; for penalty contact at contact
points and for half passes. In 2D it saves little, because contact takes a small part of the time]],
    otherwise = "3 (p + 1), p the degree along the slave face, that of its layer if it has one, in 3D the higher one" },
  { "wear", t.named(rows.wear), [[the slave's points wear by rate p |slip| as they slide (Archard), and touch at a gap
that is less by this depth: the depth of both faces together. Geometry and stiffness do not change, so that the depth
must be below 1/20 of the master's radius of curvature and 1/10 of the body. Without friction points slide with
mu = 0]],
    otherwise = "none" },
  { "adhesion", t.named {
    { "hamaker", t.positive, "Hamaker's constant", unit = "force times length" },
    { "r0", t.positive, "equilibrium distance of the potential", unit = "length" },
  }, "van der Waals forces in place of penalty and friction; the force is zero at the distance 15^(-1/6) r0",
    optional = true },
  { "cohesive", t.named(rows.cohesive(region)), [[bonds between faces that coincide in the reference shape, which
break as they open: at each contact point a traction per reference area over the distance from the master's point next
to it at first, with irreversible damage d. Pressure acts by the penalty; where bonds are damaged, friction acts on the
fraction d of the area. For method = "gpts", enforcement = "penalty"]], optional = true },
  { "active", t.flag, "whether the contact acts from the start; stages switch it on and off", default = true },
  { "offset", t.number, [[gap at which the faces touch: the gap g of all formulas is the distance less the offset.
Positive: a shim of this thickness; negative: a clearance that the shapes do not have. The offset acts in full from the
first step, without work of its own; stages change it linearly, and this does work. It does not change directions and
areas of the faces, so it should be small compared with their radii of curvature]], unit = "length", default = 0 },
  { "overlap", t.choice { "error", "interference" }, [[initial shapes that overlap. error: a mistake; an overlap above
20 % of the thickness of the thinner body, in obstacles above 1 % of the body's size, is an error, a smaller one is a
warning if closing it strains a body by more than 0.1 %.
interference: a fit; the overlap at each contact point, up to 90 % of the thickness, is allowed at first and closed
linearly over the first stage of model:run in which the contact is active]], default = "error" },
  { "where", region, [[function(X) that returns true where the contact acts; X = {x, y}, in 3D {x, y, z}, is a reference
position of the slave face, with half passes of either face. Called when the model is made]],
    otherwise = "everywhere" },
}
contact.hints = { augmented = 'write method = "mortar", enforcement = "multipliers"' }

local function conflict_of_adhesion(values)
  local function both(other, why)
    return ("it has both adhesion and %s, but %s: remove one of the two"):format(other, why)
  end
  if values.offset ~= 0 or values.overlap ~= "error" then
    return both(values.offset ~= 0 and "offset" or 'overlap = "interference"',
      "van der Waals forces act at every distance")
  end
  for _, other in ipairs { "penalty", "friction" } do
    if values[other] then return both(other, "the van der Waals law is repulsive already") end
  end
  if values.wear then return both("wear", "points at a distance do not slide") end
  if values.method == "mortar" then
    return both('method = "mortar"', "van der Waals forces act at contact points")
  end
  if values.method == "half_passes" then
    return both('method = "half_passes"', "half passes are for penalty contact")
  end
  if values.enforcement ~= "penalty" then
    return both(('enforcement = "%s"'):format(values.enforcement), "van der Waals forces need no enforcement")
  end
end

local function conflict_of_pressure(values)
  for _, other in ipairs { "penalty", "adhesion", "cohesive" } do
    if values[other] then
      return ("it has both pressure and %s, but the formula is the whole law of the gap: remove one of the two"):format(
        other)
    end
  end
  if values.enforcement ~= "penalty" then
    return 'it has pressure and enforcement = "multipliers", but multipliers have no law of the pressure: remove one'
  end
end

contact.conflict = function(values)
  local faces = rows.conflict_of_faces(values)
  if faces then return faces end
  if values.clearance and not values.pressure then return "it has clearance without pressure, which alone knows it" end
  local wrong = values.cohesive and rows.conflict_of_cohesive(values)
    or values.adhesion and conflict_of_adhesion(values) or values.pressure and conflict_of_pressure(values)
  if wrong then return wrong end
  if values.method == "half_passes" and require("signorini.pages").kind(values.master) == "obstacle" then
    return 'method = "half_passes" needs a face of a body as the master, since an obstacle has no contact points: '
      .. 'use method = "gpts" or "mortar"'
  end
  if values.method == "half_passes" and values.per == "reference" then
    return 'it has method = "half_passes" and per = "reference", but the reference areas of the two faces are '
      .. 'stretched differently, so that action and reaction would differ: write per = "current", or omit it'
  end
  local fixed = values.points == "auto" and (values.adhesion and "adhesion" or values.cohesive and "cohesive"
    or values.multipliers and "multipliers" or values.method == "mortar" and 'method = "mortar"')
  if fixed then
    return ('it has both points = "auto" and %s, whose points must stay the same in all steps: give points as a '
      .. "number, or omit them for 3 (p + 1)"):format(fixed)
  end
  if values.enforcement == "multipliers" and values.method ~= "mortar" then
    return ('it has enforcement = "multipliers" and method = "%s", but Lagrange multipliers need mortar contact: write '
      .. 'method = "mortar", or enforcement = "penalty"'):format(values.method)
  end
  if values.multipliers and values.method == "gpts" then
    return ('multipliers = "%s" is for method = "mortar" or "half_passes": add one of these, or remove multipliers')
      :format(values.multipliers)
  end
  if values.per == "current" and (values.method == "mortar" or values.adhesion) then
    return ('it has %s and per = "current", but %s per reference area: write per = "reference", or omit it'):format(
      values.adhesion and "adhesion" or 'method = "mortar"',
      values.adhesion and "the van der Waals law is a force" or "mortar contact acts")
  end
end

local tie = {
  { "slave", adjacent, [[face with the multipliers, over which the coupling is integrated; in general the finer mesh. A
list of adjacent faces acts as one face]] },
  { "master", adjacent, "face of the other body that coincides with it, as a whole or in part, or such a list" },
  { "multipliers", t.choice { "equal", "reduced" }, [[functions of the tractions. equal: those of the slave face, with
optimal rates of convergence. reduced: of degree p - 2 on its elements, continuity two less (N2: constant per element),
proven stable (inf-sup), less accurate; for degree p >= 2]], default = "equal" },
}

local components = t.either(t.point, course)
components.cure = "put it into braces, as in {0, -1}, or give a function of the position"
local load = {
  { "on", t.worded(t.flat(t.either(face, t.object "body", t.object "compound", obstacle)),
    "a face, a body, an obstacle, or a list of these"),
    "loaded faces; of a force, bodies, corners, in 3D edges, or an obstacle; of a moment, an obstacle" },
  { "traction", components, "dead load {tx, ty}, in 3D {tx, ty, tz}", unit = "force per reference area",
    optional = true },
  { "pressure", t.either(t.number, course),
    "load against the outward normal, of the reference shape unless it is a follower", unit = "force per area",
    optional = true },
  { "follower", t.flag, [[whether the pressure follows the deformation, as that of a gas or a fluid: it acts along the
current normal and per current area, under plane stress per current length and undeformed thickness. Otherwise it is a
dead load per reference area]], default = false },
  { "force", components, [[dead load {bx, by}, in 3D {bx, by, bz}, on bodies, such as density times gravity; {px, py},
in 3D {px, py, pz}, on edges per reference length, or in total on corners, in axisymmetric models around the full
circle, and on an obstacle, which moves in the components that its supports free]],
    unit = "force per reference volume", optional = true },
  { "moment", t.number, [[moment on an obstacle about the center, in 3D about the axis, of the support that rotates it
with angle = "free"; positive from x to y, or by the right-hand rule about the axis]], unit = "force times length",
    optional = true },
  { "factor", t.number, "initial factor of a function's values, which stages change; of functions only", default = 1.0,
    otherwise = "1" },
}
load.hints = {
  gravity = "write force = {0, -density * g}, in 3D {0, 0, -density * g}, and on = body",
  body_force = "write force = {bx, by}, in 3D {bx, by, bz}, and on = body",
}
load.conflict = function(values, given)
  local kinds = lists.filter({ "traction", "pressure", "force", "moment" }, function(kind)
    return values[kind] ~= nil
  end)
  if #kinds ~= 1 then
    return "it must have one of traction = {tx, ty} ({tx, ty, tz} in 3D) and pressure = p, or force = {bx, by}"
      .. " on bodies or an obstacle, or moment = m"
      .. (#kinds > 1 and ", but has " .. table.concat(kinds, " and ") or "")
  end
  if given.factor and type(values[kinds[1]]) ~= "function" then
    return ("factor is for functions, but %s is constant: give its value, and another one in a stage"):format(kinds[1])
  end
  if values.follower and not values.pressure then
    return ("follower = true is for a pressure, but it has %s, which keeps its direction: give pressure, or remove "
      .. "follower"):format(kinds[1])
  end
end

return {
  title = "Models and load paths", word = "solving",
  { "sg.model", [[Returns a model: a scene of plane bodies or of solids with its state. All parts are tables with names
as keys. Plane strain has unit depth; under plane stress forces and energies refer to a plate whose undeformed thickness
is 1, and pressures of contacts to the current length and the undeformed thickness; in an axisymmetric model x is the
radius, y the axis, and forces refer to the full circle.]],
    named = {
      hints = { gravity = "write loads = { weight = { on = a body, force = {0, -density * g} } }" },
      { "bodies", t.map(t.or_nil(t.either(t.object "body", t.object "compound")), 1), [[the bodies. The parts of one of
several patches are named after it: "ball.1", "ball.2", …]] },
      { "supports", t.map(t.or_nil(t.either(t.named "support", t.named "load"))),
        "supports of bodies and obstacles; entries with traction, pressure, force or moment are loads",
        optional = true },
      { "loads", t.map(t.or_nil(t.named "load")), "external forces", optional = true },
      { "contacts", t.map(t.or_nil(t.named "contact")), "pairs of faces that may touch", optional = true },
      { "ties", t.map(t.or_nil(t.named "tie")), "pairs of faces that move as one", optional = true },
      { "joins", t.map(t.or_nil(t.worded(t.list(face, 2), "a list of two faces"))),
        "pairs of faces of which the bodies become one", optional = true },
      { "kind", t.choice { "plane_strain", "plane_stress", "axisymmetric" },
        "plane strain, thin plates, or a section of bodies of revolution",
        otherwise = '"plane_strain" for plane bodies' },
    },
    more = 'The load path: help "stage".',
    returns = t.object "model", example = { [[
sg.model{
  bodies   = { die = die, slab = slab },
  supports = { bed  = { on = slab:face "south", fix = "xy" },
               grip = { on = {die:face "west", die:face "east"}, drive = "xy" } },
  contacts = { interface = { slave = die:face "south", master = slab:face "north", penalty = 100,
                             friction = { mu = 0.2, penalty = 100 } } } }]], [[
sg.model{ bodies = { slab = slab }, supports = { bed = { on = slab:face "south", fix = "x", drive = "y" } },
          contacts = { roof = { slave = slab:face "north", penalty = 100,
                                master = sg.rigid.plane{ point = {0, 1}, normal = {0, -1} } } } }]], [[
sg.model{ bodies = { cube = cube }, loads = { push = { on = cube:face "east", traction = {0, 0, -1} } },
          supports = { bed = { on = cube:face "front", fix = "xyz" },
                       grip = { on = cube:face "back", drive = "z", fix = "xy", rotate = "z" } } }]] } },
  { "support", "Fixes or prescribes displacements of faces, edges, corners or obstacles; at least one component.",
    head = "supports = { <name> = { on, fix, drive, free, rotate, center, angle, spring, shape, symmetry } }, in "
      .. "sg.model{ … }",
    named = {
      hints = { stiffness = "write spring = {kx, ky}, in 3D {kx, ky, kz}" },
      { "on", t.worded(t.flat(t.either(face, obstacle)),
        "a face or a list of faces, an edge, a corner or an obstacle"), "where; the reaction of a list is the sum" },
      { "fix", axes, "components with zero displacement", optional = true },
      { "drive", axes, "components that stages prescribe", unit = "length", optional = true },
      { "free", axes, [[free components. Of faces, edges and corners for documentation: unlisted components are free; of
one obstacle those that loads, springs and contact move, while unlisted components are fixed]], optional = true },
      { "rotate", t.worded(t.either(t.flag, t.choice { "x", "y", "z" }, t.space_point),
        "true in the plane; in 3D 'x', 'y', 'z' or a vector {ax, ay, az}"), [[the face rotates as a rigid body about its
centroid, in 3D about the axis through it, by an angle in degrees that stages give after the driven components; in 3D a
list of faces rotates as one, in the plane it must be one face. fix and drive then refer to the centroid, whose other
components are free: rotate = true, fix = "xy" rotates the face about a fixed point. An obstacle rotates about its
center, which moves with its translation]], otherwise = "no rotation" },
      { "center", t.point, "the point {x, y}, in 3D {x, y, z}, about which an obstacle rotates",
        otherwise = "that of a sphere or cylinder" },
      { "angle", t.choice { "driven", "free" }, [[of an obstacle that rotates: prescribed by stages, or an unknown that
moments, friction and the shape of the obstacle determine]], otherwise = '"driven"' },
      { "spring", t.point, [[stiffness {kx, ky}, in 3D {kx, ky, kz}, of springs that hold the faces, or an obstacle in
free components, then in all; 0 where there is none. They are free of forces in the reference shape and keep the
directions of the axes]], unit = "force per length and reference area; of an obstacle per length", optional = true },
      { "shape", course, [[function(x, y), in 3D function(x, y, z), that returns the displacement {ux, uy} of a
reference position of the faces, of which the driven components follow it, times a factor that stages prescribe; the
others must be 0. It is called when the model is made, and projected onto the faces (least squares), which reproduces
fields of their space; a difference above 1 % is a warning]], otherwise = "a displacement for each driven component" },
      { "symmetry", t.flag, [[fixes the normal component on flat faces in a plane of symmetry x, y or z = c, in an
axisymmetric model on the axis or y = c. Each plane of symmetry halves the scene and its forces; on the axis forces
remain those of the full circle]], default = false },
    },
    more = [[model:reaction(name) is the force that it exerts, followed by the moment if it rotates; the columns of a
run are <name>.fx, .fy, .fz, .moment, and for driven components and those of obstacles that are free <name>.ux …
.angle (model:free_motion), or .factor of a shape. The angle of an obstacle may exceed a turn; points that stick or slip
on its surface turn with it. More in share/doc/reference/theory.md, Rigid obstacles.]],
    example = { [[
supports = { bed  = { on = slab:face "south", fix = "xy" },
             grip = { on = { die:face "west", die:face "east" }, drive = "xy" } }]], [[
supports = { roller = { on = sg.rigid.cylinder{ center = {0, 1.2}, radius = 0.2 }, free = "y", drive = "x",
                        rotate = true, angle = "free" } }]] } },
  { "load", "Applies a traction or pressure to faces, a force per volume to bodies, or a force or moment to obstacles.",
    head = "loads = { <name> = { on, traction or pressure or force or moment, follower, factor } }, in sg.model{ … }",
    named = load,
    more = [[Loads are dead, with the direction and the magnitude that they have in the reference shape, except for a
pressure with follower = true. The tangent has the follower's exact derivative. For a uniform pressure it is symmetric,
because the load has an energy, pressure times volume, if the borders of the faces close, lie on the axis, or stay in
planes of symmetry; a pressure that is a function of the position has no energy.
A function of the coordinates, function(x, y) or function(x, y, z), returns the value at a reference position, {tx, ty}
or a number; it is called at the Gauss points when the model is made. Its values act times a factor, which stages
change. Displacements at a point force and stresses near it grow without limit as the mesh is refined.
The value given here is that at the start of the path; stages change it linearly to theirs. A load that no
stage names acts in full from the first step; to increase one from zero, give 0 here and its value in a stage.
model:reaction(name) is the force; the columns of a run are <name>.fx …, and the values that stages change: .tx …,
.pressure, .bx … of a force on bodies, .px … on corners, edges and obstacles, .moment, or .factor of a function.]],
    example = { [[loads = { push = { on = die:face "east", traction = {0, -1} } }]],
                [[loads = { gravity = { on = slab, force = {0, -9.81e-3} },
          gas = { on = slab:face "north", pressure = 0, follower = true } }]],
                [[
loads = { sea = { on = die:face "east", pressure = function(x, y) return 9.81e-3 * (2 - y) end, factor = 0 },
          tip = { on = slab:corner "north-east", force = {0, -0.01} } }]] } },
  { "contact", "Defines contact between faces of bodies, or with an obstacle.",
    head = "contacts = { <name> = { slave, master, or among, penalty, friction, method, … } }, in sg.model{ … }",
    named = contact,
    more = [[Results: model:profile(name), model:contact_resultant(name), the columns <name>.fx … of a run (force on the
slave). Two half passes have two names: <name> is the pass over the slave face, <name>.master that over the master face.
Between two bodies of a set (among) there are columns <name>.<body>_<body>.fx …, the force of the second body on the
first.
Source: projection and gap (3.45), (3.46), penalty (3.73), forces (3.83), friction (3.74) to (3.76), adhesion (3.85) to
(3.89), points 7.1.1 of ]] .. thesis .. [[. More in share/doc/reference/theory.md.
Debonding often snaps: follow it with arc_length = true of model:run, or with prescribed displacements and damping.]],
    example = { [[
contacts = { interface = { slave = die:face "south", master = slab:face "north", penalty = 100,
                           friction = { mu = 0.2, penalty = 100 } } }]], [[
contacts = { edge = { among = { die:face "south", die:face "west", slab:face "north" },
                      friction = { mu = 0.3 } } }]], [[
contacts = { all = { among = "all" } }]], [[
contacts = { glue = { slave = slab:face "south", master = sg.rigid.plane{ point = {0, 0}, normal = {0, 1} },
                      penalty = 1000, cohesive = { strength = 2, energy = 0.5,
                                                   where = function(X) return X[1] > 0.1 end } } }]] } },
  { "join", "Joins two faces, so that their bodies deform as one without further unknowns.",
    head = "joins = { <name> = { face, face } }, in sg.model{ … }",
    more = [[Faces that match point by point share their control points' unknowns (C0): they have the same degrees and
elements, with parameters that differ by a constant factor, the same control points, and weights that differ by a
constant factor; directions may be reversed, in 3D also exchanged. On sides of solids that cross a layer the layers must
match, too, and points up to 1e-3 of the face's size apart are joined, with a warning. Two faces of one body can be
joined, as in a ring. Where several joins meet, all share one unknown. Others are tied (help "tie"), with the face of
more elements as slave, and with a warning if they are apart or overlap; model:tie_profile and model:tie_resultant then
accept the join's name. print(model) shows for each join what was done, and what differs.
Supports, symmetry and reactions act on all control points that share an unknown; a joined face lies inside the body and
has no contact, load or spring.]],
    example = [[
joins = { seam = { left:face "east", right:face "west" } }]] },
  { "tie", "Ties two faces whose meshes need not match: they neither open nor slip.",
    head = "ties = { <name> = { slave, master, multipliers } }, in sg.model{ … }",
    named = tie,
    more = [[The tractions across the seam are unknowns (Lagrange multipliers); there is no penalty to choose. The tie
holds in the mean: for each multiplier function M the integral of M (u_master - u_slave) over the slave face is zero,
with closest points of the reference shape. Faces of curved meshes may lie up to 10 % of an element's length apart:
since displacements are tied, they start without stress, but a distance d resists large rotations, so refine until d is
small (model:tie_resultant(name).distance). The part of the slave face that is not opposite the master remains free,
with a warning.
Results: model:tie_profile(name), model:tie_resultant(name). Source: E. Brivadis, A. Buffa, B. Wohlmuth, L. Wunderlich,
Comput. Methods Appl. Mech. Engrg. 284 (2015), arXiv:1407.8313. More in share/doc/reference/theory.md.]],
    example = [[
ties = { seam = { slave = coating:face "south", master = block:face "north" } }]] },
}
