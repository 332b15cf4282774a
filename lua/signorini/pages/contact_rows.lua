-- Rows of parts of a contact.

local t = require "signorini.call.types"

local rows = {}

--- Why a table of constants without any cannot be meant.
local function conflict_of_change(_, given)
  return next(given) == nil and "the table is empty, so that it changes nothing. Hint: name what changes, or remove it"
    or nil
end

local static = t.named {
  { "static", t.positive, "coefficient where a point begins to slip" },
  { "kinetic", t.non_negative, "that of a point that has slipped far" },
  { "over", t.positive, "slip over which the difference of the two falls to 1/e", unit = "length" },
  conflict = function(values)
    return values.static < values.kinetic
      and ("static = %g is less than kinetic = %g: exchange the two"):format(values.static, values.kinetic) or nil
  end,
}

static.rows.hints = { mu1 = "write the two values without names, as in { 0.3, 0.2 }" }
static.rows.hints.mu2 = static.rows.hints.mu1

local ellipse = t.list(t.positive, 2)
function ellipse.cure() return "write { mu1, mu2 }, along `along` and across it" end

--- A type with a hint for a value of another one.
local function cured(of, cure)
  of.cure = cure
  return of
end

--- A number, or a function that returns a formula, or one of other types.
local function number_or_formula(number, example, ...)
  return cured(t.either(number, t.callback, ...), "write a number, or a formula as in " .. example)
end

--- The coefficient of friction of a contact in sg.model.
rows.coefficient = { "mu",
  number_or_formula(t.non_negative, "function(p) return 0.1 + 0.2 * sg.exp(-p) end", static, ellipse),
  [[Coulomb's coefficient of friction, tan of the angle of friction, not the angle; 0 for a contact whose friction
begins in a later stage.
function(p, v, slip, X, Y, Z, cosine) (those that it needs, by name, in any order) that returns a formula, help
"formulas", of the pressure p (force per area), the slip rate v (length per time; stages then need a duration), the slip
since the touch, the reference position X, Y, in 3D Z, of the slave point, and the cosine of the angle from `along` to
the direction in which the slave slides over the master, in the plane 1 forward and -1 backward. { static, kinetic, over
}: kinetic + (static - kinetic) exp(-s / over), s the slip since the point last stuck for a whole step. { mu1, mu2 }, in
3D: friction (t1, t2) along `along` and across it with (t1/mu1)^2 + (t2/mu2)^2 <= p^2, and slip along the normal of this
ellipse. Where mu falls faster with the slip of a step than friction.penalty can follow, friction jumps, with a
warning]] }

--- The axis of friction that depends on the direction of sliding.
rows.along = { "along", t.point, [[direction in the reference configuration to which cosine of mu, or { mu1, mu2 },
refers. Its projection onto the slave face turns with the face. With method = "half_passes" it is projected onto either
face]], optional = true }

--- Wear of a contact in sg.model.
rows.wear = {
  { "rate", number_or_formula(t.non_negative, "function(p) return 1e-3 * p end"), [[depth per pressure and slip.
function(p, v, slip, X, Y, Z) (those that it needs, by name) that returns a formula of the same variables as
friction.mu]], unit = "1/pressure" },
  { "update", t.choice { "implicit", "explicit" }, [[implicit: the wear of a step acts on its pressure (backward Euler).
explicit: that of the steps before; unstable, with a warning, where rate × slip of a step × stiffness of the contact
(the penalty, with method = "mortar" less) exceeds 2]],
    default = "implicit" },
}

local part = t.either(t.object "face", t.object "body", t.object "compound", t.object "obstacle")

--- Two parts of a set.
rows.pair = t.list(t.worded(t.flat(part), "a face, a body, an obstacle, or a list of these"), 2)
function rows.pair.cure() return "write { A, B }, each a face, a body, an obstacle, or a list of these" end

--- What a pair of a set may have of its own.
rows.own_law = {
  { "between", rows.pair, "the two parts { A, B } of the set" },
  { "friction", t.named {
    rows.coefficient, rows.along,
    { "penalty", t.positive, "tangential penalty", unit = "pressure per length", otherwise = "that of the contact" },
  }, "Coulomb friction", otherwise = "that of the set" },
  { "penalty", t.positive, "normal penalty", unit = "pressure per length", otherwise = "that of the set" },
  { "wear", t.named(rows.wear), "wear of the points", otherwise = "that of the set" },
}

--- The constants of a contact that a load path changes.
rows.change = {
  { "active", t.flag, [[whether the contact acts. One that does not has no pressure or friction, and of its history
only wear]],
    optional = true },
  { "penalty", t.positive, "normal penalty", unit = "pressure per length", optional = true },
  { "friction", t.named {
    { "mu", t.non_negative, "Coulomb's coefficient of friction", optional = true },
    { "penalty", t.positive, "tangential penalty", unit = "pressure per length", optional = true },
    conflict = conflict_of_change,
  }, [[Coulomb friction, of a contact that has friction or wear in sg.model (there mu = 0 if it is without at first).
Where friction begins, points stick at their present place]], optional = true },
  { "offset", t.number, "gap at which the faces touch", unit = "length", optional = true },
}
rows.change.conflict = conflict_of_change
rows.change.hints = {
  mu = "write friction = { mu = … }", friction_penalty = "write friction = { penalty = … }",
  method = "a path cannot change it: give it in sg.model", enforcement = "a path cannot change it: give it in sg.model",
  slave = "a path cannot change it: give it in sg.model", master = "a path cannot change it: give it in sg.model",
}

local function conflict_of_law(values, given)
  if values.traction then
    for _, other in ipairs { "strength", "energy", "stiffness", "law" } do
      if given[other] then
        return ("it has both traction and %s, but the formula is the whole law: remove one of the two"):format(other)
      end
    end
    return nil
  end
  if not (values.strength and values.energy) then
    local single = values.strength and "strength without energy" or values.energy and "energy without strength"
    return single and ("it has %s: give both, or traction as a formula"):format(single)
      or "it needs strength and energy, or traction as a formula"
  end
  local mixed = type(values.energy) == "function" or type(values.strength) == "function" or values.shear ~= 1
  if mixed and values.law == "bilinear" and not values.stiffness then
    return 'it has law = "bilinear" without stiffness, which a law of the mode mix needs: give it'
  end
  if type(values.strength) == "function" and values.law == "exponential" then
    return 'it has a function as strength and law = "exponential", whose strength at m follows from that at m = 0: '
      .. 'give a number, or write law = "bilinear"'
  end
  if values.stiffness and values.law == "exponential" then
    return 'it has stiffness and law = "exponential", whose stiffness e^2 strength^2 / energy follows from the other '
      .. 'constants: remove stiffness, or write law = "bilinear"'
  end
end

local of_opening = cured(t.worded(t.callback, "a function"),
  "write a formula, as in function(u) return K * u * sg.exp(-u / c) end")
local by_mix = number_or_formula(t.positive, "function(m) return G1 + (G2 - G1) * m ^ 2 end")

--- The bonds of a cohesive contact; `region`: the type of a function of the position.
function rows.cohesive(region)
  return {
    { "strength", by_mix, [[largest traction; of a bilinear law also function(m) that returns
a formula, as energy]], unit = "force per area", optional = true },
    { "energy", by_mix, [[energy of separation per area, G: for any mixture of opening and
shear, or function(m) that returns a formula, help "formulas", of the share m of shear in the work, 0 in opening, 1 in
shear, as in function(m) return G1 + (G2 - G1) * m ^ 2 end (Benzeggagh and Kenane). The zone in which
bonds open has a length of about E G / strength^2, less in thin bodies; its elements should be a third of it]],
      unit = "energy per area", optional = true },
    { "law", t.choice { "exponential", "bilinear" }, [[traction T over the opening u. exponential: T = e strength (u/c)
exp(-u/c) with c = G/(e strength), where G is a function of m with the stiffness of m = 0, so that the strength is
proportional to sqrt(G). bilinear: T = stiffness u up to the strength, then linear to zero at
u = 2 G/strength]], default = "exponential" },
    { "stiffness", t.positive, "initial stiffness of a bilinear law, above strength^2/(2 G)",
      unit = "pressure per length", otherwise = "the contact's penalty; needed with functions of m or shear" },
    { "traction", of_opening, [[function(u, m) (those that it needs) that returns a formula, in place of strength,
energy and law: the traction on first opening, with T = 0 at u = 0, the same finite slope there for all m, T / u
falling, and a finite area below it, the energy of separation]], unit = "force per area", optional = true },
    { "shear", t.positive, [[weight b of shear: u^2 = opening^2 + b^2 shear^2, so that tractions in pure shear are b
times as large; energies of separation stay the same]], default = 1 },
    { "where", region, [[function(X) that returns true where the faces are bonded, to leave out an initial crack;
elsewhere only contact acts. Points farther from the master than 0.001 of the opening at the largest traction are not
bonded; print(model) shows how many are]], otherwise = "everywhere" },
    conflict = conflict_of_law,
  }
end

--- A message for an argument that cohesive contact does not have.
function rows.conflict_of_cohesive(values)
  local function both(what, cure) return ("it has both cohesive and %s: %s"):format(what, cure) end
  if values.adhesion then return both("adhesion", "both hold the faces together, remove one of the two") end
  if values.wear then return both("wear", "bonds are between faces that keep their shape, remove one of the two") end
  if values.method ~= "gpts" then
    return both(('method = "%s"'):format(values.method), 'bonds are at contact points, write method = "gpts"')
  end
  if values.enforcement ~= "penalty" then
    return both(('enforcement = "%s"'):format(values.enforcement),
      'bonds open and close against a penalty, write enforcement = "penalty"')
  end
  if values.per == "current" then
    return both('per = "current"', 'bonds are those of the reference shape, write per = "reference", or omit it')
  end
  if not values.active then
    return both("active = false", "bonds exist from the start; cohesive.where leaves out places without a bond")
  end
  if values.offset ~= 0 then return both("offset", "bonded faces coincide, remove the offset") end
  if values.overlap ~= "error" then
    return both('overlap = "interference"', "bonded faces coincide, remove one of the two")
  end
end

--- A message for faces that are neither slave and master nor a set.
function rows.conflict_of_faces(values)
  if not values.among then
    for _, key in ipairs { "slave", "master" } do
      if not values[key] then
        return ("it needs %s, a face: give slave and master, or among = … for faces in contact with each other"):format(
          key)
      end
    end
    for _, key in ipairs { "except", "pairs" } do
      if values[key] then return ("it has %s without among, whose pairs it names: remove it"):format(key) end
    end
    return nil
  end
  for _, key in ipairs { "slave", "master" } do
    if values[key] then return ("it has both among and %s: a set has no %s, remove one of the two"):format(key, key) end
  end
  local points = 'a set has no slave, so that contact is at points: write method = "gpts" or "half_passes", without '
    .. "multipliers"
  for _, key in ipairs { "multipliers", "cohesive" } do
    if values[key] then return ("it has both among and %s, but %s"):format(key, points) end
  end
  if values.method == "mortar" then return 'it has both among and method = "mortar", but ' .. points end
  if values.enforcement ~= "penalty" then return 'it has both among and enforcement = "multipliers", but ' .. points end
  for name, pair in pairs(values.pairs or {}) do
    for _, key in ipairs { "penalty", "friction", "wear" } do
      for _, other in ipairs { "adhesion", key == "penalty" and "pressure" or nil } do
        if pair[key] and values[other] then
          return ("it has both pairs.%s.%s and %s: remove one of the two"):format(name, key, other)
        end
      end
    end
  end
  if values.overlap ~= "error" then
    return 'it has both among and overlap = "interference", which needs to know the two faces: give slave and master'
  end
end

return rows
