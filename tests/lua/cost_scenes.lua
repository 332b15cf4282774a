-- What the tests of model:cost share: how advice is looked for, and two scenes.

local sg = require "signorini"
local check = require "check"

local cost = {}

local soft, stiff = sg.neo_hookean{ E = 1, nu = 0.3 }, sg.neo_hookean{ E = 1000, nu = 0.3 }
cost.soft, cost.stiff = soft, stiff

--- The advice of one kind.
function cost.advice(model, kind)
  local list = {}
  for _, entry in ipairs(model:cost().advice) do
    if entry.kind == kind then list[#list + 1] = entry end
  end
  return list
end

function cost.none(model, kind)
  local found = cost.advice(model, kind)
  if found[1] then error(("no advice on %s was expected, got: %s"):format(kind, found[1].text), 2) end
end

--- Advice number i of a kind promises what the other model has.
function cost.promises(model, kind, other, i)
  local found = cost.advice(model, kind)[i or 1]
  if not found then error(("advice on %s was expected, there is none"):format(kind), 2) end
  check.equal({ found.needs, found.saves }, { other:cost().unknowns, model:cost().unknowns - other:cost().unknowns })
  return found.text
end

-- ── A die on a slab, in the plane ────────────────────────────────────────────────────────────────────────────────────

--- `change` holds what differs from a scene that is symmetric in x = 1.5.
function cost.ironing(label, change)
  change = change or {}
  local die = sg.body{
    patch = sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, centre = { change.x or 1.5, 1.5 } },
    elements = change.die or { 6, 2 }, order = label, contact = "south", through = 1,
    material = change.material or stiff,
  }
  local slab = sg.body{
    patch = change.slab or sg.shapes.rectangle{ width = 3, height = 1 }, elements = change.elements or { 8, 3 },
    grading = change.grading, order = label, contact = "north", through = 1,
    material = soft,
  }
  local supports = { bed = { on = slab:face "south", fix = "xy" },
                     grip = change.grip or { on = { die:face "west", die:face "east" }, drive = "y", fix = "x" } }
  if change.support then supports.more = change.support(die, slab) end
  return sg.model{
    bodies   = { die = die, slab = slab },
    supports = supports,
    contacts = { interface = change.contact and change.contact(die, slab) or
                 { slave = die:face "south", master = slab:face "north", penalty = 100, where = change.where,
                   points = change.points, friction = { mu = 0.2, penalty = 100 } } },
  }
end

--- A punch on a slab; `parts` of it along x and y are left: 1 or 1/2.
function cost.punch(label, along_x, along_y, hold)
  local function body(size, corner, elements, contact, material)
    return sg.body{ patch = sg.shapes.block{ size = { size[1] * along_x, size[2] * along_y, size[3] },
                                            corner = corner },
                    elements = { elements[1] * along_x // 1 | 0, elements[2] * along_y // 1 | 0, elements[3] },
                    order = label, contact = contact, through = 1, material = material }
  end
  local slab = body({ 4, 4, 2 }, { 0, 0, 0 }, { 4, 4, 2 }, "back", soft)
  local top = body({ 2, 2, 1 }, { 2 - 2 * along_x + (along_x == 1 and 1 or 0),
    2 - 2 * along_y + (along_y == 1 and 1 or 0), 2 }, { 2, 2, 1 }, "front", sg.neo_hookean{ E = 50, nu = 0.3 })
  local supports = { bed = { on = slab:face "front", fix = "xyz" },
                     grip = hold and hold(top) or { on = top:face "back", drive = "z", fix = "xy" } }
  if along_x < 1 then supports.x = { on = { slab:face "east", top:face "east" }, fix = "x" } end
  if along_y < 1 then supports.y = { on = { slab:face "north", top:face "north" }, fix = "y" } end
  return sg.model{ bodies = { slab = slab, punch = top }, supports = supports,
    contacts = { interface = { slave = top:face "front", master = slab:face "back", penalty = 100 } } }
end

return cost
