-- Bonded scenes: a block pulled off, a double cantilever beam opened by rotations.

local sg = require "signorini"
local lists = require "signorini.call.lists"

local debond = {}

--- A block of width 2 and height 4 without lateral contraction, bonded to a plane; its lid moves.
function debond.block(bond, more)
  local body = sg.body{ patch = sg.shapes.rectangle{ width = 2, height = 4 }, elements = {1, 1}, order = "N1",
                        contact = "south", material = sg.linear_elastic{ E = more and more.E or 1000, nu = 0 } }
  return sg.model{
    bodies = { block = body }, supports = { lid = { on = body:face "north", fix = "x", drive = "y" } },
    contacts = { glue = lists.merged({ slave = body:face "south", penalty = 1000, cohesive = bond,
                                       master = sg.rigid.plane{ point = {0, 0}, normal = {0, 1} } },
                                     more and more.contact) } }
end

--- Double cantilever beam: two beams of height 2, bonded from x = 8 on; their ends at x = 0 are rotated apart.
debond.beam = { E = 70000, nu = 0.3, height = 2, energy = 0.3, crack = 8 }
function debond.cantilevers(length, n, bond)
  local of = debond.beam
  local function beam(y, contact)
    return sg.body{ patch = sg.shapes.rectangle{ width = length, height = of.height, corner = {0, y} },
                    elements = {n, 2}, order = "N2", contact = contact, thickness_degree = 2,
                    material = sg.neo_hookean{ E = of.E, nu = of.nu } }
  end
  local upper, lower = beam(0, "south"), beam(-of.height, "north")
  return sg.model{
    bodies = { upper = upper, lower = lower },
    supports = { up = { on = upper:face "west", rotate = true }, down = { on = lower:face "west", rotate = true },
                 wall = { on = { upper:face "east", lower:face "east" }, fix = "xy" } },
    contacts = { glue = { slave = upper:face "south", master = lower:face "north", penalty = 1e6,
      cohesive = lists.merged({ energy = of.energy, where = function(X) return X[1] >= of.crack end }, bond) } } }
end

return debond
