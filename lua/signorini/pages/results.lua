-- Pages: what is read off a model.

local core = require "signorini.core"
local t = require "signorini.types"

local a_contact = { "contact", t.name(function(model) return model:contact_names() end), "name of a contact" }
local profile = t.table("a contact profile", "take what model:profile returns")
local coordinate = { "coordinate", t.worded(t.either(t.text, t.callback),
  "the name of a column such as \"x\", or a function of a point"), [[a column such as "x" (deformed) or "X" (reference),
or a function of a point { x =, y =, pressure =, … }; it is s, so ds is its own length. It must grow along the contact
zone; points beyond, where it turns back, are left out]], default = "x" }

local error_rows = {
  { "profile", profile, "the measured profile" },
  { "reference", t.worded(t.either(t.table(), t.callback), "a contact profile"), [[another profile, or a function of the
coordinate that returns the value]] },
  coordinate,
  { "value", t.choice { "pressure", "traction" }, "compared quantity", default = "pressure" },
  { "normalize", t.worded(t.either(t.positive, t.choice { "max" }), "a positive number or \"max\""), [[N; "max": the
largest value of the reference]], default = 1 },
  { "quadrature", t.choice { "profile", "reference", "union" }, [[whose points carry the integral: trapezoids between
them, the other one is interpolated linearly; "union", the points of both, is exact for two polygons]],
    default = "profile" },
  { "zone", t.choice { "either", "both" }, [["either": open points count, with p = 0; "both": only where both touch,
from edge point to edge point. Where the contact of one ends earlier than that of the other, "both" leaves out the
largest differences]], default = "either" },
  { "edge", t.choice { "point", "gap" }, [[how a profile falls to zero between its last point that touches and the next
one: "point", linearly to that next one; "gap", to where the gap, linear between these two, is zero, which is a point of
the integral, too]], default = "point" },
}
error_rows[2][2].cure = "take what model:profile returns, or a function of the coordinate that returns the value"
error_rows.conflict = function(values)
  if type(values.reference) == "function" and values.quadrature == "reference" then
    return "quadrature must not be \"reference\" for a function, which has no points: leave it out"
  end
end

return {
  title = "Results of a model",
  word = "results",
  { "model:profile", [[Returns lists along the slave face, one entry per contact point: x, y (current), X, Y
(reference), area (that the traction acts on), pressure, traction (tangential; in the plane positive along the face's
xi: on the slave it acts the other way), gap, state ("open", "stick", "slip", "adhesion"). Where a point slips
|traction| is mu pressure. In 3D also z, Z, and tx, ty, tz, the components of the tangential traction t_T, whose size is
`traction`; on the slave acts -t_T. Another name is an error.]],
    arguments = { a_contact },
    example = "model:profile(\"interface\").pressure" },
  { "model:sample", "Returns a field's value at a parametric point of a body.",
    arguments = {
      { "body", t.either(t.object "body", t.name(function(model) return model:body_names() end)),
        "a body or its name" },
      { "field", t.choice(core.fields), [[as in sg.picture; contact_pressure is that between the contact points of a
slave face, which xi must lie on]] },
      { "xi", t.worded(t.point, "a list of 2 numbers {xi1, xi2}, in 3D of 3"), "parametric coordinates" },
    },
    example = "model:sample(\"slab\", \"uy\", {0.5, 1})" },
  { "model:energy", [[Returns { stored, contact, friction, work }: the energy in the bodies; in the springs of penalty
laws, or of adhesion; dissipated by friction in all accepted steps; done by supports and loads in all accepted steps
(trapezoidal rule). Per unit depth in plane strain. work = stored + contact + friction as steps become small, except for
the growth of the slave's area: see share/doc/theory.md, What is measured.]],
    example = "model:energy().stored" },
  { "model:reaction", [[Returns the force {fx, fy} ({fx, fy, fz} in 3D) that a support exerts on its bodies, and with it
the moment about the center (in 3D about the axis) of a support that rotates; the force of a load. Also by name: fx, fy,
fz, moment.]],
    arguments = { { "name", t.name(function(model)
      local names = model:support_names()
      return table.move(model:load_names(), 1, #model:load_names(), #names + 1, names)
    end), "a support or a load" } },
    example = "model:reaction(\"grip\").fy" },
  { "model:contact_resultant", [[Returns { fx, fy, fz, area, max_pressure, max_penetration, active, slipping, unsettled,
crossed }: the force on the slave (fz in 3D), the current area in contact, extremes, and how many contact points touch
and slip. unsettled: how often, in all accepted states so far, the search for a point's closest point or slip point
ended at a limit of iterations; then unsettled_at is the reference position of the latest such point. crossed,
crossed_at: the same of points that had gone through the master since the state before, unseen by contact.]],
    arguments = { a_contact },
    example = "model:contact_resultant(\"interface\").area" },
  { "sg.profile_error", [[Returns the L2 error sqrt(integral of ((p - p_ref)/N)^2 ds) of a contact profile against a
reference, and { from, to, points, scale, covered }: the range and the number of points of the integral, N, and the
share of the zone where either one touches that the range covers. Ranges that do not overlap are an error.]],
    named = error_rows,
    more = "Source: V. Agrawal, thesis, IIT Guwahati 2020, eq. (7.2), which leaves the points of the integral open.",
    example = [[
sg.profile_error{ profile = model:profile "interface", reference = finer:profile "interface", normalize = "max" }]] },
  { "sg.profile_edges", [[Returns where the contact of a profile begins and ends: { from, to, from_spacing, to_spacing
}. An edge lies where the gap, linear between the last point that touches and the first one that does not, is zero; the
spacing is the distance of these two points, the accuracy of the edge. Without spacing the contact reaches the profile's
end.]],
    named = { { "profile", profile, "the measured profile" }, coordinate },
    example = "half_width = sg.profile_edges{ profile = model:profile \"interface\" }.to" },
}
