-- Springs on faces: in series with a bar in every kind of model, work, reactions, static condensation, files, bodies
-- that only springs hold, wrong inputs.

require "check"
local column = require "column"

local height, E, k, t = 2, 10, 5, 0.4 -- t: traction

--- A bar on springs at its lower end, pulled at its upper end.
local function bar(kind, material, contacts)
  return column.model(kind, { height = height, elements = 2, material = material, contacts = contacts,
    bed = { spring = column.along(kind, k) },
    load = function(body) return { on = body:face(column.top(kind)), traction = column.along(kind, 0) } end })
end

check.case("springs in series with a bar: the displacement is t/k + t H/E, also by static condensation", function()
  for _, kind in ipairs(column.kinds) do
    local model = bar(kind, sg.linear_elastic{ E = E, nu = 0 })
    local run = check.completed(model:run({ { steps = 2, g = column.along(kind, t) } }, sg.plain{}))
    check.holds(tostring(model), "; on springs: bed")
    local u = "u" .. column.letter(kind)
    check.near({ model:sample("column", u, column.at(kind, 0)), model:sample("column", u, column.at(kind, 1)) },
               { t / k, t / k + t * height / E }, 1e-10)
    check.near(model:reaction "bed"["f" .. column.letter(kind)], -t * column.area(kind), 1e-9)
    check.near(run:column("bed.f" .. column.letter(kind)), { -t / 2 * column.area(kind), -t * column.area(kind) }, 1e-9)
    local energy, stored = model:energy(), 0.5 * t * (t / k + t * height / E) * column.area(kind)
    check.near({ energy.stored, energy.work }, { stored, stored }, 1e-10)
  end
  local model = bar("plane_strain", sg.linear_elastic{ E = E, nu = 0 }, { roof = { slave = "north", penalty = 1e4,
    master = scenes.ceiling(height + 0.1) } })
  check.completed(model:run({ { steps = 1, g = { 0, t } } }, sg.plain{ linear = "condensed" }))
  -- The roof stops the bar at 0.1: springs and bar share this displacement.
  check.within_share("roof", model:sample("column", "uy", { 0.5, 0 }), 0.1 * (1 / k) / (1 / k + height / E), 1e-3)
end)

check.case("with large strains the springs remain linear, and steps converge quadratically", function()
  for _, kind in ipairs(column.kinds) do
    local model = bar(kind, sg.neo_hookean{ E = E, nu = 0.3 })
    local run = check.completed(model:run({ { steps = 2, g = column.along(kind, 3) } }, sg.plain{}))
    check.within_share("spring", k * model:sample("column", "u" .. column.letter(kind), column.at(kind, 0)), 3, 1e-8)
    check.equal(run.iterations <= 14, true) -- linear convergence without the springs in the tangent takes far more
  end
end)

check.case("a body that only springs hold is constrained, and files keep springs", function()
  local body = scenes.body{ size = {2, 1}, E = E }
  local function model_of(spring)
    return scenes.model{ bodies = { raft = body }, supports = { water = { on = "south", spring = spring } },
                     loads = { g = { on = body, force = { 0, 0 } } } }
  end
  check.equal(model_of { 1, 1 }:unconstrained_bodies(), {})
  check.equal(model_of { 0, 1 }:unconstrained_bodies(), { "raft" })
  local model = model_of { 1, 4 }
  check.completed(model:run({ { steps = 1, g = { 0.2, -0.8 } } }, sg.plain{}))
  check.near(model:reaction "water", { -0.4, 1.6 }, 1e-9)
  local copy = check.reloaded(model)
  for _, one in ipairs { copy, model } do
    check.completed(one:run({ { steps = 1, g = { 0, -0.4 } } }, sg.plain{}))
  end
  check.equal(copy:reaction "water", model:reaction "water")
  check.near(copy:reaction "water", { 0, 0.8 }, 1e-9)
end)

check.refusals([[
local plane = sg.rigid.plane{ point = {0, 2}, normal = {0, -1} }
local function model(support) return sg.model{ bodies = { a = a }, supports = { top = support } } end
]], "study.lua:", {
  { "model{ on = north, spring = 3 }", "supports.top.spring must be a list of 2 or 3 numbers" },
  { "model{ on = north, spring = {1, 2, 3} }", "spring must be a list of 2 numbers {kx, ky}" },
  { "model{ on = north, spring = {0, -2} }", "supports.top.spring must not be negative, got -2 for y" },
  { "model{ on = north, spring = {0, 0} }", "supports.top.spring has no stiffness" },
  { [[model{ on = north, spring = {0, 2}, fix = "xy" }]],
    "supports.top.spring acts on y, which the support also fixes" },
  { [[model{ on = a:corner "north-east", spring = {0, 2} }]], "supports.top.on", "springs are for faces of bodies" },
  { "model{ on = plane, spring = {0, 2} }", "supports.top.spring acts on y", 'add free = "y"' },
  { "model{ on = north, spring = {0, 2}, rotate = true }", "supports.top.spring cannot be combined" },
  { "model{ on = north, stiffness = {0, 1} }", "supports.top: unknown argument 'stiffness'",
    "Hint: write spring = {kx, ky}" },
})
