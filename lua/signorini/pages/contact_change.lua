-- Rows of the constants of a contact that a load path changes.

local t = require "signorini.call.types"

--- Why a table of constants without any cannot be meant.
local function conflict(_, given)
  return next(given) == nil and "the table is empty, so that it changes nothing. Hint: name what changes, or remove it"
    or nil
end

local rows = {
  { "active", t.flag, "whether the contact acts. One that does not has no pressure, friction or history",
    optional = true },
  { "penalty", t.positive, "normal penalty", unit = "pressure per length", optional = true },
  { "friction", t.named {
    { "mu", t.non_negative, "Coulomb's coefficient of friction", optional = true },
    { "penalty", t.positive, "tangential penalty", unit = "pressure per length", optional = true },
    conflict = conflict,
  }, [[Coulomb friction, of a contact that has friction in sg.model (there mu = 0 if it is without at first). Where
friction begins, points stick at their present place]], optional = true },
  { "offset", t.number, "gap at which the faces touch", unit = "length", optional = true },
}
rows.conflict = conflict
rows.hints = {
  mu = "write friction = { mu = … }", friction_penalty = "write friction = { penalty = … }",
  method = "a path cannot change it: give it in sg.model", enforcement = "a path cannot change it: give it in sg.model",
  slave = "a path cannot change it: give it in sg.model", master = "a path cannot change it: give it in sg.model",
}
return rows
