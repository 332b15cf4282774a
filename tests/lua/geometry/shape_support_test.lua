-- Supports with a shape, displacements that are functions of the reference position: exact fields, factors as targets,
-- joined bodies, files, wrong inputs.

require "check"

local function faces_of(body, names)
  local faces = {}
  for name in names:gmatch "%S+" do faces[#faces + 1] = body:face(name) end
  return faces
end

--- The largest difference of a displacement from a function over points of a body with this patch.
local function difference(model, name, exact, patch)
  local largest, space = 0, #patch:degrees() == 3
  for _, a in ipairs { 0, 0.3, 0.5, 1 } do
    for _, b in ipairs { 0.1, 0.7, 1 } do
      local xi = space and { a, b, 0.4 } or { a, b }
      for i, value in ipairs(exact(table.unpack(patch:evaluate(xi)))) do
        local axis = ({ "x", "y", "z" })[i]
        largest = math.max(largest, math.abs(model:sample(name, "u" .. axis, xi) - value))
      end
    end
  end
  return largest
end

-- Bending with nu = 0: u = (-k x y, k x²/2) solves the equations and lies in the space of degree 2.
check.case("prescribed on the whole boundary, a solution of the space's degree is reproduced inside", function()
  local patch = sg.shapes.rectangle{ width = 2, height = 1 }
  local body = scenes.body{ patch = patch, elements = { 3, 2 }, material = sg.linear_elastic{ E = 10, nu = 0 } }
  local function bending(x, y) return { -0.1 * x * y, 0.05 * x * x } end
  local model = sg.model{ bodies = { beam = body },
    supports = { rim = { on = faces_of(body, "west east south north"), drive = "xy", shape = bending } } }
  check.equal(model:driven "rim", { "factor" })
  local run = model:run({ { steps = 2, rim = 1 } }, sg.plain{})
  check.equal({ run.failed, run:column "rim.factor" }, { false, { 0.5, 1 } })
  check.at_most("error", difference(model, "beam", bending, patch), 1e-12)
  local energy, stored = model:energy(), 0.5 * 10 * 0.1 ^ 2 * 2 / 3 -- E/2 ∫ (k y)² dV
  check.near({ energy.work, energy.stored }, { stored, stored }, 1e-10)
end)

check.case("linear fields are exact on curved bodies, joined ones, layers, and in 3D", function()
  local function plane(x, y) return { 0.1 * x - 0.05 * y, 0.2 * x + 0.07 * y } end
  local rubber = sg.neo_hookean{ E = 10, nu = 0.3 }
  local arc = sg.shapes.quarter_annulus{ inner = 1, outer = 2, center = { 0, 0 } }
  local five = sg.shapes.disc{ radius = 1, center = { 0, 0 } }
  local ring = scenes.body{ patch = arc, elements = { 3, 2 }, order = "N2-N4", contact = "south", material = rubber }
  local disc = scenes.body{ patch = five, elements = { 2, 2 }, material = rubber }
  -- Inside up to the quadrature error of uniform stresses on coarse, rational elements
  for name, case in pairs { ring = { ring, faces_of(ring, "west east south north"), { arc } },
                            disc = { disc, disc:face "outer", five } } do
    local model = sg.model{ bodies = { [name] = case[1] },
                            supports = { rim = { on = case[2], drive = "xy", shape = plane } } }
    check.completed(model:run({ { steps = 2, rim = 1 } }, sg.plain{}))
    for i, body in ipairs(model:body_names()) do
      check.at_most(body, difference(model, body, plane, case[3][i]), 1e-4)
    end
  end
  local function space(x, y, z) return { 0.1 * y, 0.05 * z - 0.1 * x, 0.1 * x + 0.1 * z } end
  local brick = sg.shapes.block{ size = { 1, 2, 1 } }
  local block = scenes.body{ patch = brick, elements = { 1, 2, 1 }, material = rubber }
  local model = sg.model{ bodies = { block = block },
    supports = { rim = { on = faces_of(block, "west east south north front back"), drive = "xyz", shape = space } } }
  check.completed(model:run({ { steps = 1, rim = 1 } }, sg.plain{}))
  check.at_most("block", difference(model, "block", space, brick), 1e-9)
end)

check.case("other components stay free, and files hold the shape", function()
  local body = scenes.body{ size = {2, 1}, elements = { 4, 2 }, E = 10 }
  local function model_of()
    return scenes.model{ bodies = { body = body },
      supports = { bed = { on = "south", fix = "xy" },
        top = { on = "north", drive = "y", shape = function(x) return { 0, -0.1 * x * (2 - x) } end } } }
  end
  local model = model_of()
  check.completed(model:run({ { steps = 2, top = 0.8 } }, sg.plain{}))
  -- A parabola is in the space of degree 2.
  for _, s in ipairs { 0, 0.2, 0.5, 1 } do
    check.near(model:sample("body", "uy", { s, 1 }), -0.8 * 0.1 * 2 * s * (2 - 2 * s), 1e-13)
  end
  check.equal(model:sample("body", "ux", { 1, 1 }) ~= 0, true)
  check.near(model:reaction "top"[1], 0, 1e-12)
  local copy = check.reloaded(model)
  for _, one in ipairs { copy, model } do check.equal(one:run({ { steps = 1, top = 1 } }, sg.plain{}).failed, false) end
  check.equal(copy:displacements(), model:displacements())
  check.equal(copy:reaction "top", model:reaction "top")
end)

check.case("a function that the elements cannot follow is a warning with the error, also after loading", function()
  local function warnings(elements, f)
    local model = scenes.model{
      bodies = {
        body = { size = {2, 1}, elements = { elements, 1 }, material = sg.linear_elastic{ E = 10, nu = 0.3 } } },
      supports = { bed = { on = "south", fix = "xy" }, top = { on = "north", drive = "xy", shape = f } } }
    local file = check.file "rough.sgn"
    model:save(file)
    check.equal(sg.load(file):warnings(), model:warnings())
    return model:warnings()
  end
  -- The best parabola for x³ on (0, 2) differs by Legendre's polynomial of degree 3 times 2/5, with the mean square
  -- (2/5)²/7; that of x³ is 2⁶/7. With eight elements the difference is about 8³ times smaller.
  local function cubic(x) return { 0, x ^ 3 } end
  local percent = 100 * math.sqrt((2 / 5) ^ 2 / 2 ^ 6)
  check.equal(#warnings(1, cubic), 1)
  check.holds(warnings(1, cubic)[1], "supports.top.shape",
    ("differ from it by %.6g %% (root mean square)"):format(percent), "Hint: use finer elements")
  check.equal(warnings(8, cubic), {})
  check.equal(#warnings(8, function(x) return { x < 1 and 0 or 1, 0 } end), 1)
  check.equal(warnings(1, function() return { 0, 0 } end), {})
end)

check.refusals([[
local function model(support) return sg.model{ bodies = { a = a }, supports = { top = support } } end
]], "study.lua:", {
  { [[model{ on = north, fix = "xy", shape = function() return {0, 1} end }]],
    "supports.top.shape needs driven components", 'add drive = "xy"' },
  { [[model{ on = north, drive = "xy", rotate = true, shape = function() return {0, 1} end }]],
    "supports.top.shape cannot be combined with rotate" },
  { [[model{ on = a:corner "north-east", drive = "y", shape = function() return {0, 1} end }]], "supports.top.on",
    "a shape is for faces of bodies" },
  { [[model{ on = north, drive = "xy", shape = function(x) return x end }]],
    "supports.top.shape must return a list of 2 numbers {ux, uy}, got the number", "at X = (" },
  { [[model{ on = north, drive = "x", shape = function() return {0.1, 1} end }]],
    "supports.top.shape returns uy = 1 at X = (", "but the support does not drive y: add y to drive, or return 0" },
  { [[model{ on = north, drive = "y", fix = "x", shape = function(x) return {x, 1} end }]],
    "supports.top.shape returns ux = ", "does not drive x" },
  { [[model{ on = north, drive = "xy", shape = function() return {0, 1} end }:run{ { steps = 1, top = {1, 2} } }]],
    "stages[1].top must be a list of 1 number (factor), got a list of 2 values" },
})
