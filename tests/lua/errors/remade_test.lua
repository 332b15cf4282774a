-- Scenes made again from their tables: without changes bit for bit, with changes as described.

require "check"
local remade = require "signorini.errors.remade"

--- Scenes that differ in what a table of sg.body and sg.model can hold.
local made = {}

function made.ironing() return (sg.scenes.ironing{ order = "N2-N2.2" }) end
function made.hertz() return (sg.scenes.hertz{ body = "ball" }) end
function made.peeling() return (sg.scenes.peeling{}) end

function made.interference()
  return scenes.model{
    bodies = { ring = { size = { 2, 1 }, contact = "south", layer = { 0, 0.5 }, order = "N2-N2.1" } },
    supports = { lid = { on = "north", drive = "y", fix = "x" } },
    contacts = { seat = { slave = "south", master = scenes.floor(0.1), overlap = "interference",
                          where = function(X) return X[1] < 1 end } } }
end

function made.compound()
  local square = sg.shapes.rectangle
  local pair = sg.body{ patch = { square{ width = 1, height = 1 }, square{ width = 1, height = 1, corner = { 1, 0 } },
                                  boundaries = { sole = { "1.south", "2.south" } } },
                        elements = { { 2, 2 }, { 3, 2 } }, order = "N2", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  return sg.model{ bodies = { pair = pair },
    supports = { lid = { on = { pair:face "1.north", pair:face "2.north" }, drive = "xy" },
                 pin = { on = pair:corner "2.south-east", fix = "x" } },
    loads = { weight = { on = pair, force = { 0, -0.01 } } },
    contacts = { ground = { slave = pair:face "sole", master = scenes.floor(), friction = { mu = 0.2 } } } }
end

function made.solid()
  return scenes.model{
    bodies = { lower = { size = { 2, 2, 1 } }, upper = { size = { 1, 1, 1 }, corner = { 0, 0, 1 } } },
    supports = { bed = { on = "lower.front", fix = "xyz" }, edge = { on = "upper.back", drive = "z", rotate = "z",
                                                                      fix = "xy" } },
    contacts = { touch = { slave = "upper.front", master = "lower.back", method = "mortar", penalty = 50 } } }
end

for name, make in pairs(made) do
  check.case(name .. ": made again without changes, equal bit for bit", function()
    local model = make()
    local first, again = core.content(model), core.content(remade.model(model, {}))
    -- the penalty is given in the second model where it followed from the mesh in the first
    for _, contact in ipairs(model:contact_names()) do
      if model:contact_law(contact).default_penalty then return check.equal(#again, #first) end
    end
    if first ~= again then error "the contents differ" end
  end)
end

check.case("elements are halved, rounded up; penalties and points keep their values", function()
  local model = sg.scenes.ironing{ order = "N2" }
  local coarse = remade.model(model, { elements = 1 / 2 })
  check.equal(coarse:body "slab":dofs().total, 2 * (4 + 2) * (2 + 2)) -- 8 × 3 elements become 4 × 2
  check.equal(coarse:contact_law("interface").points, model:contact_law("interface").points)
  local hertz = sg.scenes.hertz{}
  check.equal(remade.model(made.compound(), { elements = 1 / 2 }):contact_law("ground").penalty,
    made.compound():contact_law("ground").penalty)
  check.equal(#remade.model(hertz, { elements = 1 }):unknowns(), #hertz:unknowns())
end)

check.case("a richer row is a layer on the faces in contact, or a layer of half the size", function()
  local plain, layered = sg.scenes.ironing{ order = "N2" }, sg.scenes.ironing{ order = "N2-N2.2" }
  check.equal(#remade.model(plain, { row = true }):unknowns(), #layered:unknowns())
  if #remade.model(layered, { row = true }):unknowns() <= #layered:unknowns() then error "no more unknowns" end
end)

check.case("points of a richer row are multiplied from those of its degree", function()
  local model = sg.scenes.ironing{ order = "N2" }
  local row = remade.model(model, { row = true }):contact_law("interface").points
  check.equal(remade.model(model, { row = true, points = 2 }):contact_law("interface").points, 2 * row)
end)

check.case("the stiffness of bilinear bonds stays where penalties change", function()
  local model = scenes.model{
    bodies = { lower = { contact = "north" }, upper = { corner = { 0, 1 }, contact = "south" } },
    supports = { bed = { on = "lower.south", fix = "xy" }, grip = { on = "upper.north", drive = "y" } },
    contacts = { seam = { slave = "upper.south", master = "lower.north", penalty = 500,
                          cohesive = { strength = 1, energy = 0.01, law = "bilinear" } } } }
  check.equal(remade.model(model, { penalty = 2 }):contact_law("seam").stiffness, 500)
end)

check.case("loads on a part of a body of several patches are on the part of the new one", function()
  local square = sg.shapes.rectangle
  local pair = sg.body{ patch = { square{ width = 1, height = 1 }, square{ width = 1, height = 1, corner = { 1, 0 } } },
                        elements = { 2, 2 }, order = "N2", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  local model = sg.model{ bodies = { pair = pair }, supports = { bed = { on = pair:face "1.south", fix = "xy" } },
    loads = { weight = { on = pair:part(2), force = { 0, -0.01 } } } }
  check.equal(core.content(remade.model(model, {})), core.content(model))
end)

check.case("penalties of both directions and points are multiplied", function()
  local model = sg.scenes.ironing{ mu = 0.3 }
  local law, other = model:contact_law "interface", remade.model(model, { penalty = 1 / 2, points = 2 })
  local changed = other:contact_law "interface"
  check.equal(changed.penalty, law.penalty / 2)
  check.equal(changed.friction_penalty, law.friction_penalty / 2)
  check.equal(changed.points, 2 * law.points)
end)

check.case("tables changed after the call do not count", function()
  local given = { patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = { 4, 4 }, order = "N2",
                  material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  local body = sg.body(given)
  given.elements[1] = 1
  local model = sg.model{ bodies = { block = body }, supports = { bed = { on = body:face "south", fix = "xy" } } }
  check.equal(#remade.model(model, {}):unknowns(), #model:unknowns())
end)
