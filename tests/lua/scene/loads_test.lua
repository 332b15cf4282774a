-- Dead tractions and pressures as a user gives them: against closed forms, as targets of stages, as columns; wrong
-- inputs.

require "check"

--- A bar of 4 × 1 that is fixed along x at its west face and pulled at its east face.
local function bar(material, traction)
  local body = scenes.body{ size = {4, 1}, elements = {4, 2}, contact = "south", material = material }
  return scenes.model{ bodies = { bar = body },
    supports = { wall = { on = "west", fix = "x" }, foot = { on = "south-west", fix = "y" } },
    loads = { pull = { on = "east", traction = traction } } }, body
end

--- Stretches λ₁, λ₂ of neo-Hooke's bar in plane strain under the dead traction t along x, by Newton's method:
---   P₁₁ = μ(λ₁ − 1/λ₁) + Λ ln(λ₁λ₂)/λ₁ = t,  P₂₂ = μ(λ₂ − 1/λ₂) + Λ ln(λ₁λ₂)/λ₂ = 0.
local function stretches(E, nu, t)
  local mu = E / (2 * (1 + nu))
  local lame = 2 * mu * nu / (1 - 2 * nu)
  local a, b = 1, 1
  for _ = 1, 50 do
    local log = math.log(a * b)
    local f, g = mu * (a - 1 / a) + lame * log / a - t, mu * (b - 1 / b) + lame * log / b
    local fa, gb = mu * (1 + 1 / a ^ 2) + lame * (1 - log) / a ^ 2, mu * (1 + 1 / b ^ 2) + lame * (1 - log) / b ^ 2
    local cross = lame / (a * b)
    local determinant = fa * gb - cross * cross
    a, b = a - (gb * f - cross * g) / determinant, b - (fa * g - cross * f) / determinant
  end
  return a, b
end

check.case("a bar under a dead traction has the closed form's stretches, step by step", function()
  local model, body = bar(sg.neo_hookean{ E = 10, nu = 0.3 }, {0, 0})
  local steps = 5
  local run = model:run({ { name = "pull", steps = steps, pull = {4, 0} } }, { on_step = function(info)
    local long, across = stretches(10, 0.3, 4 * info.step / steps)
    check.near(model:sample(body, "ux", {1, 1}), 4 * (long - 1), 1e-8)
    check.near(model:sample(body, "uy", {1, 1}), across - 1, 1e-8)
  end })
  check.equal(run.failed, false)
  check.near(run:column "pull.tx", { 0.8, 1.6, 2.4, 3.2, 4 })
  -- A dead load keeps its size while its face shrinks.
  check.near(run:column "pull.fx", { 0.8, 1.6, 2.4, 3.2, 4 })
  check.near(run:column "wall.fx", { -0.8, -1.6, -2.4, -3.2, -4 }, 1e-9)
  check.near(run:column "pull.fy", { 0, 0, 0, 0, 0 })
end)

check.case("the value in sg.model acts from the first step on; stages go on from it; unnamed it stays", function()
  local model, body = bar(sg.linear_elastic{ E = 10, nu = 0 }, {2, 0})
  local run = model:run{ { steps = 2 }, { steps = 2, pull = {1, 0} }, { steps = 1 } }
  check.near(run:column "pull.tx", { 2, 2, 1.5, 1, 1 })
  check.near(run:column "wall.fx", { -2, -2, -1.5, -1, -1 }, 1e-10)
  check.near(model:sample(body, "ux", {1, 0}), 4 * 1 / 10, 1e-10)
  check.near(model:reaction "pull", { 1, 0 })
end)

check.case("a pressure acts against the outward normal; around a square it makes the pressure inside", function()
  local E, nu, p = 10, 0.3, 0.5
  local model = scenes.model{
    bodies = { square = { size = {2, 2}, contact = "south", material = sg.linear_elastic{ E = E, nu = nu } } },
    supports = { left = { on = "west", fix = "x" }, low = { on = "south", fix = "y" } },
    loads = { gas = { on = { "east", "north" }, pressure = 0 } } }
  local run = model:run{ { steps = 2, gas = p } }
  check.equal({ run.failed, run:column "gas.pressure" }, { false, { 0.25, 0.5 } })
  for _, field in ipairs { "sxx", "syy" } do check.near(model:sample("square", field, {0.3, 0.7}), -p, 1e-10) end
  -- ε = −p (1 + ν)(1 − 2ν)/E in plane strain
  check.near(model:sample("square", "ux", {1, 0.4}), -2 * p * (1 + nu) * (1 - 2 * nu) / E, 1e-10)
  check.near(model:reaction "gas", { -2 * p, -2 * p })
  check.near({ model:reaction "left"[1], model:reaction "low"[2] }, { 2 * p, 2 * p }, 1e-10)
end)

check.case("around an axis forces are those over the full circle", function()
  local model = scenes.model{ kind = "axisymmetric",
    bodies = {
      ring = { size = {1, 2}, corner = {1, 0}, contact = "south", material = sg.linear_elastic{ E = 10, nu = 0 } } },
    supports = { bed = { on = "south", fix = "y" } }, loads = { push = { on = "north", traction = {0, 0} } } }
  model:run{ { steps = 1, push = {0, -0.5} } }
  local force = -0.5 * math.pi * (2 ^ 2 - 1 ^ 2)
  check.near(model:reaction "push"[2], force, 1e-12)
  check.near(model:reaction "bed"[2], -force, 1e-9)
  check.near(model:sample("ring", "uy", {0.5, 1}), -2 * 0.5 / 10, 1e-10)
end)

check.case("F33 is the hoop stretch, 1 in plane strain", function()
  local patch = sg.shapes.rectangle{ width = 1, height = 2, corner = {1, 0} }
  for kind, hoop in pairs { axisymmetric = true, plane_strain = false } do
    local ring = scenes.body{ patch = patch, elements = {2, 2}, contact = "south", E = 10 }
    local model = scenes.model{ kind = kind, bodies = { ring = ring }, supports = {
      bed = { on = "south", fix = "y" }, wall = { on = "west", drive = "x" } } }
    model:run{ { steps = 1, wall = 0.1 } }
    local expected = hoop and 1 + model:sample("ring", "ux", {0.25, 0.5}) / 1.25 or 1
    check.within(kind, model:sample("ring", "F33", {0.25, 0.5}), expected, 1e-14)
    check.within("hoop at the wall", model:sample("ring", "F33", {0, 0.5}), hoop and 1.1 or 1, 1e-12)
  end
end)

check.case("a load is also accepted among the supports", function()
  local model = scenes.model{
    bodies = { body = { elements = {1, 1}, contact = "south", material = sg.linear_elastic{ E = 1, nu = 0 } } },
    supports = { wall = { on = "west", fix = "xy" }, push = { on = "east", traction = {0.25, 0} } } }
  check.equal(model:load_names(), { "push" })
  model:run{ { steps = 1 } }
  check.near(model:sample("body", "ux", {1, 0.5}), 0.25, 1e-10)
end)

-- Each ends with status 1 and a message that names the script's line, the argument, the value and the hint.
check.refusals([[
local plane = sg.rigid.plane{ point = {0, -1}, normal = {0, 1} }
local function with(load)
  return { bodies = { a = a }, supports = { w = { on = a:face "west", fix = "xy" } }, loads = { push = load } }
end
]], 5, {
  { "sg.model(with{ on = east, traction = {1} })",
    "sg.model: loads.push.traction must be a list of 2 or 3 numbers (dead load {tx, ty}, in 3D {tx, ty, tz})",
    "got a list of 1 value" },
  { "sg.model(with{ on = east, traction = 1 })", "loads.push.traction must be a list of 2 or 3 numbers",
    "put it into braces" },
  { "sg.model(with{ on = east, traction = {1, 0}, pressure = 2 })",
    "loads.push: it must have one of traction = {tx, ty} ({tx, ty, tz} in 3D) and pressure = p" },
  { "sg.model(with{ on = east })", "loads.push: it must have one of traction" },
  { [[sg.model(with{ on = a:corner "south-east", traction = {1, 0} })]], "loads.push.on must be a face",
    "a corner has no surface" },
  { "sg.model(with{ on = plane, pressure = 1 })", "loads.push.on must be a face" },
  { "sg.model(with{ on = a, gravity = {0, -1} })", "loads.push: unknown argument 'gravity'",
    "Hint: write force = {0, -density * g}" },
  { "sg.model(with{ on = a, body_force = {0, -1} })", "loads.push: unknown argument 'body_force'",
    "Hint: write force = {bx, by}" },
  { "sg.model{ bodies = { a = a }, gravity = {0, -1} }", "sg.model: unknown argument 'gravity'",
    "Hint: write loads = { weight = { on = a body, force =" },
  { [[sg.model{ bodies = { a = a }, supports = { w = { on = east, fix = "x" } },
      loads = { w = { on = east, pressure = 1 } } }]], "loads.w has the name of a support", "choose another name" },
  { "sg.model(with{ on = east, traction = {0, 0} }):run{ { steps = 1, push = 3 } }",
    "model:run: stages[1].push must be a list of 2 numbers (tx, ty), got the number 3" },
  { "sg.model(with{ on = east, pressure = 0 }):run{ { steps = 1, push = {1, 2} } }",
    "model:run: stages[1].push must be a list of 1 number (pressure), got a list of 2 values" },
})
