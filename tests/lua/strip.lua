-- A strip of 40 × 2 elements that sticks to a rigid plane, so coarse that it peels off element by element, in
-- snap-backs.

local sg = require "signorini"

local film = { hamaker = 0.1, r0 = 0.4 }
local equilibrium = 15 ^ (-1 / 6) * film.r0 -- where the adhesion's traction is zero

local strip = { film = film, equilibrium = equilibrium }

function strip.model()
  local body = sg.body{ patch = sg.shapes.rectangle{ width = 100, height = 5 }, elements = {40, 2}, order = "N2",
                        contact = "south", thickness_degree = 1, material = sg.neo_hookean{ E = 2, nu = 0.2 } }
  return sg.model{
    bodies   = { strip = body },
    supports = { edge = { on = body:face "east", rotate = true }, pin = { on = body:corner "south-west", fix = "x" } },
    contacts = { film = { slave = body:face "south", adhesion = film, where = function(X) return X[1] <= 80 end,
                          master = sg.rigid.plane{ point = {0, -equilibrium}, normal = {0, 1} } } },
  }
end

return strip
