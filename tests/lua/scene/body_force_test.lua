-- Forces per reference volume: gravity columns in every kind of model, bodies of several patches, work, columns of
-- runs, files, wrong inputs.

require "check"
local column = require "column"

local height, E, weight = 4, 10, 0.5 -- weight: force per reference volume

--- A column on a roller bed under its weight, which acts along the last component.
local function heavy(kind, material)
  return column.model(kind, { height = height, elements = 3, order = "N3", material = material,
    load = function(body) return { on = body, force = column.along(kind, 0) } end })
end

check.case("a linear elastic column shortens by b H²/2E, its support holds its weight", function()
  for _, kind in ipairs(column.kinds) do
    local model, letter = heavy(kind, sg.linear_elastic{ E = E, nu = 0 }), column.letter(kind)
    local run = check.completed(model:run({ { steps = 2, g = column.along(kind, -weight) } }, sg.plain{}))
    check.near(model:sample("column", "u" .. letter, column.at(kind, 1)), -weight * height ^ 2 / (2 * E), 1e-10)
    local total = weight * height * column.area(kind)
    check.near(model:reaction "g"["f" .. letter], -total, 1e-10)
    check.near(model:reaction "bed"["f" .. letter], total, 1e-9)
    check.near(run:column("g.b" .. letter), { -weight / 2, -weight }, 1e-14)
    check.near(run:column("g.f" .. letter), { -total / 2, -total }, 1e-10)
    -- The work of a linear load is exact: ½ ∫ b u dV with u = b (H y - y²/2)/E.
    local energy = model:energy()
    local expected = 0.5 * weight ^ 2 * height ^ 3 / (3 * E) * column.area(kind)
    check.near({ energy.work, energy.stored }, { expected, expected }, 1e-10)
  end
end)

-- The force on a cross-section is the weight above it, P_yy = -b (H - Y). With nu = 0 the column does not widen, and
-- neo-Hooke's stretch follows from P = E/2 (s - 1/s).
check.case("a neo-Hookean column shortens by the integral of its stretches, and work is stored", function()
  local load = 4
  local function stretch(P) return (P + math.sqrt(P ^ 2 + E ^ 2)) / E end
  local exact, parts = 0, 2000
  for i = 1, parts do exact = exact + (stretch(-load * height * (i - 0.5) / parts) - 1) * height / parts end
  for _, kind in ipairs(column.kinds) do
    local model = heavy(kind, sg.neo_hookean{ E = E, nu = 0 })
    check.completed(model:run({ { steps = 8, g = column.along(kind, -load) } }, sg.plain{}))
    local shortening = model:sample("column", "u" .. column.letter(kind), column.at(kind, 1))
    check.within_share("shortening", shortening, exact, 1e-4)
    local energy = model:energy()
    check.within_share("work", energy.work, energy.stored, 5e-3) -- trapezoidal rule over 8 steps
  end
end)

check.case("sideways in the plane, it bends: the moment of the support is that of the weight", function()
  local body = scenes.body{ size = {1, height}, elements = { 2, 6 }, order = "N3",
    material = sg.linear_elastic{ E = E, nu = 0.3 } }
  local model = scenes.model{ bodies = { beam = body },
    supports = { clamp = { on = "south", fix = "xy", rotate = true } },
    loads = { wind = { on = body, force = { 0.01, 0 } } } }
  model:set_target("clamp", { 0 })
  check.completed(model:run({ { steps = 1 } }, sg.plain{}))
  local reaction = model:reaction "clamp"
  check.near({ reaction.fx, reaction.fy }, { -0.04, 0 }, 1e-10)
  check.within_share("moment", math.abs(reaction.moment), 0.04 * height / 2, 1e-8)
end)

check.case("bodies of several patches and lists of bodies carry their weight, in files, too", function()
  local square = sg.shapes.rectangle
  local wall = sg.body{ patch = { square{ width = 1, height = 1 }, square{ width = 1, height = 2, corner = { 0, 1 } } },
                        elements = { 2, 2 }, order = "N2", material = sg.neo_hookean{ E = E, nu = 0.3 } }
  local slab = scenes.body{ patch = square{ width = 5, height = 1, corner = { 3, 0 } }, elements = { 2, 2 }, E = E }
  local model = scenes.model{ bodies = { wall = wall, slab = slab },
    supports = { bed = { on = { "wall.1.south", "slab.south" }, fix = "xy" } },
    loads = { own = { on = wall, force = { 0, 0 } }, all = { on = { wall, slab }, force = { 0, -0.1 } } } }
  check.completed(model:run({ { steps = 1, own = { 0, -0.2 } } }, sg.plain{}))
  check.near({ model:reaction "own"[2], model:reaction "all"[2] }, { -0.6, -0.8 }, 1e-12)
  check.near(model:reaction "bed"[2], 1.4, 1e-9)
  local copy = check.reloaded(model)
  check.equal(copy:reaction "own", model:reaction "own")
  check.equal(copy:driven "own", { "bx", "by" })
  -- A load among the supports
  local single = scenes.model{ bodies = { slab = slab },
    supports = { bed = { on = "south", fix = "xy" }, own = { on = slab, force = { 0, -0.1 } } } }
  check.equal(single:load_names(), { "own" })
end)

check.refusals([[
local b = sg.body{ patch = r, elements = {4, 2}, order = "N2", material = soft }
local function model(load)
  return sg.model{ bodies = { a = a }, supports = { w = { on = north, fix = "xy" } }, loads = { g = load } }
end
]], "study.lua:", {
  { "model{ on = north, force = {0, -1} }", "loads.g: it is on the face 'north' of body 'a'", "per volume",
    "give traction" },
  { "model{ on = a, traction = {0, -1} }", "loads.g: it is on the body 'a'", "name a face" },
  { "model{ on = a, force = -9.81 }", "loads.g.force must be a list of 2 or 3 numbers", "got the number -9.81" },
  { "model{ on = a, force = {0, 0, -1} }", "loads.g.force must be a list of 2 numbers {bx, by}" },
  { "model{ on = { a, a }, force = {0, -1} }", "loads.g.on lists body 'a' twice" },
  { "model{ on = b, force = {0, -1} }", "is on a body that is not in bodies" },
  { "model{ on = a, force = {0, -1}, traction = {0, 1} }", "loads.g: it must have one of",
    "but has traction and force" },
  { "model{ on = r, force = {0, -1} }", "loads.g.on must be a face, a body, an obstacle, or a list of these" },
  { "model{ on = a, force = {0, 0} }:run{ { steps = 1, g = -1 } }",
    "stages[1].g must be a list of 2 numbers (bx, by)" },
})

check.case("an unconstrained body under a load is a failed run, however far it goes", function()
  local body = scenes.body{ material = sg.linear_elastic{ E = 1000, nu = 0.3 } }
  local model = scenes.model{ bodies = { block = body }, supports = { bed = { on = "south", fix = "y" } },
                          loads = { push = { on = body, force = { 0, 0 } } } }
  local run = model:run{ { steps = 1, push = { 1, 0 } } }
  check.equal(run.failed, true)
  check.holds(run.failure, "the tangent is singular", "rigid-body translation of body 'block' along (1, 0)")
end)
