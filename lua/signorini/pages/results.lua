-- Pages: results of a model.

local core = require "signorini.core"
local t = require "signorini.call.types"

local a_contact = { "contact", t.name(function(model) return model:contact_names() end), "name of a contact" }
local a_tie = { "tie", t.name(function(model) return model:tie_names() end), "name of a tie" }
local profile = t.table("a contact profile", "use the result of model:profile")
local coordinate = { "coordinate", t.worded(t.either(t.text, t.callback_of({ { "point", t.map(t.any) } }, t.number)),
  "the name of a column such as \"x\", or a function of a point"), [[a column such as "x" (deformed) or "X" (reference),
or a function of a point { x =, y =, pressure =, … }; it is the s of the integral. It must increase along the contact
zone; points beyond, where it decreases, are left out]], default = "x" }

local force = t.record("fx fy fz? moment?", t.number)
force.entries = { "component", t.number }

local error_rows = {
  { "profile", profile, "the measured profile" },
  { "reference", t.worded(t.either(t.table(), t.callback_of({ { "s", t.number } }, t.number)),
    "a contact profile"), [[another profile, or a function of the
coordinate]] },
  coordinate,
  { "value", t.choice { "pressure", "traction" }, "compared quantity", default = "pressure" },
  { "normalize", t.worded(t.either(t.positive, t.choice { "max" }), "a positive number or \"max\""), [[N; "max": the
largest value of the reference]], default = 1 },
  { "quadrature", t.choice { "profile", "reference", "union" }, [[points of the trapezoidal rule; the other profile is
interpolated linearly; "union", the points of both, is exact for two polygons]], default = "profile" },
  { "zone", t.choice { "either", "both" }, [["either": where one of the two touches, with p = 0 at open points; "both":
only where both touch, from edge point to edge point. If the contact of one ends earlier than that of the other, "both"
leaves out the largest differences]], default = "either" },
  { "edge", t.choice { "point", "gap" }, [[how a profile decreases to zero between its last point in contact and the
next one: "point": linearly to that next one; "gap": to where the gap, linear between these two, is zero, which becomes
a point of the integral]], default = "point" },
}
error_rows[2][2].cure = "use the result of model:profile, or a function of the coordinate that returns the value"
error_rows.conflict = function(values)
  if type(values.reference) == "function" and values.quadrature == "reference" then
    return "quadrature must not be \"reference\" for a function, which has no points: omit it"
  end
end

return {
  title = "Results of a model", word = "results",
  { "model:profile", [[Returns lists along the slave face, one entry per contact point: x, y (current), X, Y
(reference), area (current, on which the traction acts; 0 at an open point, but for adhesion and bonds), inside (1 in
the contact area, see model:contact_resultant, otherwise 0), pressure, traction (of friction, along the chord from slip
point to foot point, which is tangential on a straight master; in the plane positive along the slave face's xi; on the
slave it acts in the opposite direction), gap (beyond an open end of the master the distance), state ("open", "stick",
also of a closed point without friction, "slip", "adhesion", "bonded": not closed, held by a bond). At a slipping point
|traction| = mu pressure (mortar: at each multiplier). A cohesive contact also has damage, from 0 to 1 (no bond), and
with a formula mix, the share of shear in the energy that a bond has dissipated (0 where it is whole); its pressure,
negative in tension, and traction include those of the bonds. Pressure and traction are forces per current area,
whatever `per` of the contact is; with method = "mortar" `area`, pressure and traction refer to the reference area. With
friction or wear also mu, the coefficient with which a touching point slips or, of a formula, would begin to
(orthotropic: friction along the slip over pressure; 0 with wear alone), and slip, since the touch, without the elastic
slip of the penalty; with method = "mortar" and a penalty both are interpolated between multipliers, as is the pressure.
With wear worn, its depth, which a contact keeps while it is switched off. A set (among) has the points of all its
faces, each with half of its area, and face, "<body>.<face>"; gap is nan where no face is opposite within three
elements. In 3D also z, Z, and tx, ty, tz, the components of the friction traction t_T, whose magnitude is `traction`;
-t_T acts on the slave. Reading any other field is an error.]],
    arguments = { a_contact },
    returns = t.record("x y X Y area inside pressure traction gap", t.numbers(), "state face?", t.list(t.text),
      "z? Z? tx? ty? tz?", t.numbers(), "damage? mix? mu? slip? worn?", t.numbers()),
    example = "model:profile(\"interface\").pressure" },
  { "model:sample", "Returns a field's value at a parametric point of a body.",
    arguments = {
      { "body", t.either(t.object "body", t.name(function(model) return model:body_names() end)),
        "a body or its name" },
      { "field", t.choice(core.fields), [[as in sg.picture; contact_pressure, damage, mu, slip and worn are interpolated
between the contact points of a slave face, on which xi must be]] },
      { "xi", t.worded(t.point, "a list of 2 numbers {xi1, xi2}, in 3D of 3"), "parametric coordinates" },
    },
    returns = t.number, example = "model:sample(\"slab\", \"uy\", {0.5, 1})" },
  { "model:energy", [[Returns { stored, contact, friction, work, area_growth, debonding, wear, viscous }: strain energy
of the bodies, and that of springs of supports; energy of penalty springs and bonds, or of adhesion; and, summed over
accepted steps (trapezoidal rule), dissipation by friction; work of supports, of loads and of changing offsets and
overlaps of contacts; energy of the penalty springs times the growth of the area on which they act, zero for contacts
with per = "reference"; dissipation by bonds; energy that material takes along as it wears, pressure times depth; work
of the stresses that relax in viscoelastic bodies, of which stored contains none. Per unit depth in plane strain. Where
nothing changes suddenly, as when a contact is switched off, work + area_growth = stored + contact + friction +
debonding + wear + viscous in the limit of small steps (with friction: and of small penetration): see
share/doc/reference/theory.md, Output quantities.]],
    returns = t.record("stored contact friction work area_growth debonding wear viscous", t.number),
    example = "model:energy().stored" },
  { "model:reaction", [[Returns the force {fx, fy} ({fx, fy, fz} in 3D) that a support exerts on its bodies, followed,
for a support that rotates, by the moment about its center (in 3D about the axis); for a load, its force. Also by name:
fx, fy, fz, moment.]],
    arguments = { { "name", t.name(function(model)
      local names = model:support_names()
      return table.move(model:load_names(), 1, #model:load_names(), #names + 1, names)
    end), "a support or a load" } },
    returns = force, example = "model:reaction(\"grip\").fy" },
  { "model:free_motion", [[Returns the motions of an obstacle that are unknowns, by name: ux, uy, uz of its translation
as far as its support frees them, and its angle if that is free. Empty for other supports.]],
    arguments = { { "name", t.name(function(model) return model:support_names() end), "a support" } },
    returns = t.table(), example = "model:free_motion(\"grip\")" },
  { "model:contact_law", [[Returns the constants of a contact: { method, enforcement, per, points, penalty,
default_penalty, active, offset }, as given to sg.model or by default, in the present state; default_penalty is true
where the penalty is from material and mesh. With friction or wear also mu, friction_penalty, with a formula of it
mu_formula, its text, in place of mu, or mu1 and mu2; along, if it depends on the direction; with wear wear_rate, its
text, and wear_update, "implicit" or "explicit"; of_rate, "friction.mu" or "wear.rate", if that depends on v; with a
formula of the pressure pressure, its text, and clearance, in place of penalty; with overlap = "interference" overlap,
the fraction of the initial overlap that is still allowed; with method = "mortar" multipliers; of a cohesive contact
strength, energy, law, stiffness, and bonded, the number of points with a bond; of one by formula (also of m, and with
shear) not law but traction, its text, stiffness, shear, strength and energy in opening, shear_strength and
shear_energy; with adhesion { method, per, points, active, hamaker, r0 }. print(model) shows them.]],
    arguments = { a_contact },
    returns = t.record("method per", t.text, "enforcement? multipliers? law?", t.text,
      "mu_formula? pressure? wear_rate? wear_update? of_rate? traction?", t.text, "points bonded?", t.count,
      "penalty? mu? mu1? mu2? friction_penalty? hamaker? r0? strength? energy? stiffness? offset? overlap? clearance?",
      t.number, "shear? shear_strength? shear_energy?", t.number, "active default_penalty?", t.flag, "along?",
      t.point),
    example = "model:contact_law(\"interface\").penalty" },
  { "model:contact_resultant", [[Returns { fx, fy, fz, area, max_pressure, mean_pressure, max_penetration, active,
slipping, per, unsettled, crossed }: the force on the slave (fz in 3D); the current area in contact (with method =
"mortar" the reference area), which is that inside gap = 0, linear between contact points; extremes; the largest mean
pressure over a slave element (where elements or a high penalty do not resolve the peak, it is closer to the peak than
max_pressure); the numbers of contact points that touch and slip; and per, "current" or "reference", the area on which
tractions act; of mortar contact with a penalty also weighted_penetration, the largest of its multipliers; with friction
or wear slip, the mean slip since the touch over the area of the points that touch; of a cohesive contact debonded, the
area of new surface: energy dissipated by bonds over energy of separation; with wear worn_volume, the volume that has
been worn off, which half passes share; with "half_passes" also imbalance, |f + f2| / max(|f|, |f2|) with the force f2
of the other pass: by how much action and reaction differ, 0 without forces. A set (among) has no force; its area is the
mean of both sides, and pairs["<body>_<body>"] { fx, fy, fz } the force of the second body on the first, of half passes
half of the difference of both, with imbalance |sum f| / (sum |f| / 2). unsettled: how often, in all accepted
states so far, the search for the closest point or slip point of a point with a force ended at the limit of iterations;
unsettled_at is the reference position of the latest such point. With a formula of friction or wear flawed: how often it
was negative at a point, not a finite number, or fell faster with the slip than the tangential penalty can follow; flaw
("negative", "negative wear", "undefined", "undefined wear" or "jumps") and flawed_at tell the latest. crossed: how many
points have passed through the master without contact since the accepted state, 0 in accepted states; crossed_at is the
reference position of the last of them. Reading any other field is an error.]],
    arguments = { a_contact },
    returns = t.record("fx? fy? fz?", t.number, "pairs?", t.any,
      "area max_pressure mean_pressure max_penetration", t.number,
      "weighted_penetration? imbalance? slip? debonded? worn_volume?", t.number,
      "active slipping unsettled crossed flawed?", t.integer(0), "per", t.text, "flaw?", t.text,
      "unsettled_at? crossed_at? flawed_at?", t.point),
    example = "model:contact_resultant(\"interface\").area" },
  { "model:modes", [[Returns the free vibration modes of the accepted state with the lowest values, and whether the
state is stable. A small motion about it is a sum of modes, mode * cos(2 pi frequency t); one with a negative value
grows, mode * exp(growth t): the state is unstable, and does not exist in reality. The bodies' density scales
values, but does not change signs.]],
    named = { { "count", t.integer(1, 1000), "how many", default = 6 } }, may_be_empty = true,
    more = [[
Value: K mode = value M mode with the tangent K of loads that follow the deformation, springs, ties and contacts, and
the mass M: (2 pi frequency)^2, in 1/time^2 of the units of density, length and force (with E in N/mm^2 and density in
t/mm^3: frequency in Hz). Closed contact points hold, open ones do not, points with friction stick; bonds and materials
that soften do not soften on. Obstacles have no mass. Rigid motions that nothing resists have the value 0 and are named;
the others begin with bending or swaying in most cases. Theory and accuracy: share/doc/reference/theory.md.]],
    returns = t.object "modes", example = { "print(model:modes{ count = 4 })", [[
modes = model:modes{}
sg.picture{ model = model, mode = modes[1], undeformed = true, file = "mode.png" }]] } },
  { "modes", [[The result of model:modes, a list of modes by increasing value; print shows it with the verdict and the
warnings.]],
    fields = {
      { "stable", t.or_nil(t.flag), [[whether all small motions stay small, except for rigid ones that nothing resists;
nil: undecided. If the tangent is not symmetric, true means that no motion grows steadily; growing oscillations are
excluded of the listed modes only]] },
      { "complete", t.or_nil(t.flag), "whether no mode below the last one is missing; nil: undecided" },
      { "symmetric", t.flag, [[whether the tangent is. It is not with friction that slips and with pressures that follow
faces whose borders move; then values may be complex]] },
      { "warnings", t.list(t.text), "sentences about what the modes do not tell" } } },
  { "mode", "An entry of model:modes, for sg.picture.",
    fields = {
      { "value", t.number, "(2 pi frequency)^2; negative: -growth^2" },
      { "frequency", t.or_nil(t.number), "oscillations per time; nil if the motion grows without oscillating" },
      { "growth", t.or_nil(t.number), "the motion grows by a factor of e in 1/growth; nil if it does not grow" },
      { "imaginary", t.or_nil(t.number), [[imaginary part of a complex value, whose modes come in pairs: real and
imaginary part of the motion]] },
      { "mode", t.numbers(nil, true), [[displacement of each unknown, in the order of model:unknowns; the longest of a
control point is 1]] },
      { "rigid", t.or_nil(t.text), "the bodies and the direction or axis of a rigid motion" } } },
  { "model:tie_profile", [[Returns lists along the slave face of a tie, one entry per quadrature point opposite the
master: x, y (current), X, Y (reference), area (reference area with the point's weight), tx, ty (traction of the master
on the slave per reference area), pressure (its part against the slave's current normal, negative in tension), traction
(its tangential part: in the plane positive along the slave face's xi, in 3D its magnitude), jump (distance by which the
two faces have moved apart, which vanishes in the weighted mean only). In 3D also z, Z, tz. Points are ordered by
elements of the slave face, which are divided at the borders of the master's elements.]],
    arguments = { a_tie },
    returns = t.record("x y X Y area tx ty pressure traction jump z? Z? tz?", t.numbers()),
    example = "coated:tie_profile(\"seam\").pressure" },
  { "model:tie_resultant", [[Returns { fx, fy, fz, area, part, distance }: the force of the master on the slave (fz in
3D), the tied reference area, its fraction of the slave face, and the largest distance of the two faces in the reference
shape (relative to the elements there).]],
    arguments = { a_tie },
    returns = t.record("fx fy fz? area part distance", t.number), example = "coated:tie_resultant(\"seam\").fy" },
  { "sg.profile_error", [[Returns the L2 error sqrt(integral of ((p - p_ref)/N)^2 ds) of a contact profile against a
reference, and { from, to, points, scale, covered }: the range and the number of points of the integral, N, and the
fraction of the zone (where either one touches) that the range covers. Ranges that do not overlap are an error.]],
    named = error_rows,
    more = "Source: V. Agrawal, thesis, IIT Guwahati 2020, eq. (7.2), which leaves the points of the integral open.",
    returns = { t.number, t.record("from to", t.number, "points", t.count, "scale covered", t.number) }, example = [[
sg.profile_error{ profile = model:profile "interface", reference = finer:profile "interface", normalize = "max" }]] },
  { "sg.profile_edges", [[Returns the ends of the contact zone of a profile: { from, to, from_spacing, to_spacing }. An
edge is where the gap is zero, linear between the last point inside the contact area and the first one outside; the
spacing is the distance of these two points. Without spacing, contact extends to the profile's end.]],
    named = { { "profile", profile, "the measured profile" }, coordinate },
    returns = t.record("from to from_spacing? to_spacing?", t.number),
    example = "half_width = sg.profile_edges{ profile = model:profile \"interface\" }.to" },
}
