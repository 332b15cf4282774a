-- Elastic laws from an energy: uniform strains against closed forms, incompressible ones as published and compressible
-- ones, in all kinds of models; the program's neo-Hooke as a formula; what is printed and saved; warnings.

require "check"

local exact = { newton = { tolerance = 1e-13 } }
local c10, c01, c20, c30, stiff = 0.4, 0.2, -0.02, 0.003, 1e5
local terms = { mu = { 0.63, 0.0012, -0.01 }, alpha = { 1.3, 5, -2 } }

local function sum_of_terms(value)
  local sum = 0
  for i, mu in ipairs(terms.mu) do sum = sum + mu * value(terms.alpha[i]) end
  return sum
end

--- Energies of the principal stretches without symbols, and nominal stresses of the incompressible laws: uniaxial,
--- equibiaxial, and the shear stress of simple shear (G. A. Holzapfel, Nonlinear Solid Mechanics, 2000, chapter 6).
local function invariants(a, b, c) return a^2 + b^2 + c^2, a^2 * b^2 + b^2 * c^2 + c^2 * a^2, a * b * c end
local function volumetric(K, J) return K / 4 * (J^2 - 1 - 2 * math.log(J)) end
local laws = {
  mooney_rivlin = {
    make = function(K) return sg.mooney_rivlin{ c10 = c10, c01 = c01, K = K } end,
    energy = function(K, ...)
      local I1, I2, J = invariants(...)
      return c10 * (J^(-2 / 3) * I1 - 3) + c01 * (J^(-4 / 3) * I2 - 3) + volumetric(K, J)
    end,
    uniaxial = function(a) return 2 * (a - a^-2) * (c10 + c01 / a) end,
    biaxial = function(a) return 2 * (a - a^-5) * (c10 + c01 * a^2) end,
    shear = function(g) return 2 * (c10 + c01) * g end,
  },
  yeoh = {
    make = function(K) return sg.yeoh{ c10 = c10, c20 = c20, c30 = c30, K = K } end,
    energy = function(K, ...)
      local I1, _, J = invariants(...)
      local x = J^(-2 / 3) * I1 - 3
      return c10 * x + c20 * x^2 + c30 * x^3 + volumetric(K, J)
    end,
    slope = function(x) return c10 + 2 * c20 * x + 3 * c30 * x^2 end,
    uniaxial = function(a, law) return 2 * (a - a^-2) * law.slope(a^2 + 2 / a - 3) end,
    biaxial = function(a, law) return 2 * (a - a^-5) * law.slope(2 * a^2 + a^-4 - 3) end,
    shear = function(g, law) return 2 * g * law.slope(g^2) end,
  },
  ogden = {
    make = function(K) return sg.ogden{ mu = terms.mu, alpha = terms.alpha, K = K } end,
    energy = function(K, a, b, c)
      local J = a * b * c
      local sum = volumetric(K, J)
      for i, mu in ipairs(terms.mu) do
        local alpha = terms.alpha[i]
        sum = sum + mu / alpha * (J^(-alpha / 3) * (a^alpha + b^alpha + c^alpha) - 3)
      end
      return sum
    end,
    uniaxial = function(a) return sum_of_terms(function(n) return a^(n - 1) - a^(-n / 2 - 1) end) end,
    biaxial = function(a) return sum_of_terms(function(n) return a^(n - 1) - a^(-2 * n - 1) end) end,
    shear = function(g)
      local a = g / 2 + math.sqrt(1 + g^2 / 4)
      return sum_of_terms(function(n) return (a^n - a^-n) / (a + 1 / a) end)
    end,
  },
}

--- The derivative of f at x by central differences with extrapolation, to about 1e-11.
local function derivative(f, x)
  local function central(h) return (f(x + h) - f(x - h)) / (2 * h) end
  return (64 * central(1e-3) - 20 * central(2e-3) + central(4e-3)) / 45
end

--- The lateral stretch without stress for W(a, b), by the secant method.
local function free_stretch(W, start)
  local function stress(b) return derivative(W, b) end
  local x, y = start, start * 1.001
  for _ = 1, 50 do
    local p, q = stress(x), stress(y)
    if p == q or math.abs(y - x) < 1e-14 then break end
    x, y = y, y - q * (y - x) / (q - p)
  end
  return y
end

--- A cube with one element, whose symmetric faces slide; `pulled` faces are driven along x and y.
local function cube(material, pulled)
  local body = scenes.body{ size = { 1, 1, 1 }, elements = { 1, 1, 1 }, order = "N1", material = material }
  local supports = {}
  for _, face in ipairs { "west", "south", "front" } do supports[face] = { on = body:face(face), symmetry = true } end
  for face, axis in pairs(pulled) do supports[face] = { on = body:face(face), drive = axis } end
  return sg.model{ bodies = { cube = body }, supports = supports }
end

local function square(material, kind, supports)
  local body = scenes.body{ elements = { 1, 1 }, order = "N1", material = material }
  return sg.model{ bodies = { plate = body }, kind = kind, supports = supports(body) }
end

--- Supports of simple shear.
local function sheared(body)
  return { bed = { on = body:face "south", fix = "xy" }, lid = { on = body:face "north", drive = "x", fix = "y" } }
end

local function finish(model, stages)
  check.completed(model:run(stages, exact))
  return model
end

local stretches = { 0.7, 1.2, 2 }

check.case("uniaxial tension of all laws, compressible and in the incompressible limit", function()
  for name, law in pairs(laws) do
    for _, a in ipairs(stretches) do
      local soft = finish(cube(law.make(3), { east = "x" }), { { steps = 6, east = { a - 1 } } })
      local function W(first, b) return law.energy(3, first, b, b) end
      local b = free_stretch(function(x) return W(a, x) end, a^-0.4)
      check.within(name, soft:reaction("east")[1], derivative(function(x) return W(x, b) end, a), 1e-8)
      check.within(name, 1 + soft:sample("cube", "uy", { 1, 1, 1 }), b, 1e-8)
      local rubber = finish(cube(law.make(stiff), { east = "x" }), { { steps = 6, east = { a - 1 } } })
      check.within(name, rubber:reaction("east")[1], law.uniaxial(a, law), 5e-5)
    end
  end
end)

check.case("equibiaxial tension of all laws, in space and under plane stress", function()
  for name, law in pairs(laws) do
    for _, a in ipairs(stretches) do
      local solid = finish(cube(law.make(3), { east = "x", north = "y" }),
        { { steps = 6, east = { a - 1 }, north = { a - 1 } } })
      local c = free_stretch(function(x) return law.energy(3, a, a, x) end, a^-0.8)
      local pull = derivative(function(x) return law.energy(3, x, a, c) end, a)
      check.within(name, solid:reaction("east")[1], pull, 1e-8)
      check.within(name, solid:energy().stored, law.energy(3, a, a, c), 1e-8)
      for _, case in ipairs { { 3, pull, 1e-8 }, { stiff, law.biaxial(a, law), 2e-4 } } do
        local plate = finish(square(law.make(case[1]), "plane_stress", function(body)
          return { west = { on = body:face "west", fix = "x" }, south = { on = body:face "south", fix = "y" },
                   east = { on = body:face "east", drive = "x" }, north = { on = body:face "north", drive = "y" } }
        end), { { steps = 6, east = { a - 1 }, north = { a - 1 } } })
        check.within_share(name, plate:reaction("east")[1], case[2], case[3])
        check.at_most("stress across", plate:sample("plate", "szz", { 0.5, 0.5 }), 1e-13 * case[1])
        if case[1] == 3 then
          check.within(name, plate:sample("plate", "F33", { 0.5, 0.5 }), c, 1e-8)
          check.within(name, plate:energy().stored, law.energy(3, a, a, c), 1e-8)
        end
      end
    end
  end
end)

check.case("simple shear of all laws does not depend on the bulk modulus", function()
  for name, law in pairs(laws) do
    for _, K in ipairs { 3, stiff } do
      local model = finish(square(law.make(K), "plane_strain", sheared), { { steps = 4, lid = { 0.8 } } })
      check.within(name, model:reaction("lid")[1], law.shear(0.8, law), 1e-9 * K)
    end
  end
end)

check.case("Saint Venant-Kirchhoff has its closed forms", function()
  local E, nu = 2, 0.3
  local mu, lambda = E / 2.6, E * nu / (1.3 * 0.4)
  local law = sg.saint_venant_kirchhoff{ E = E, nu = nu }
  for _, a in ipairs { 0.8, 1.4 } do
    local model = finish(cube(law, { east = "x" }), { { steps = 4, east = { a - 1 } } })
    check.within("P", model:reaction("east")[1], E * a * (a^2 - 1) / 2, 1e-12)
    check.within("b", 1 + model:sample("cube", "uy", { 1, 1, 1 }), math.sqrt(1 - nu * (a^2 - 1)), 1e-12)
    local biaxial = finish(cube(law, { east = "x", north = "y" }),
      { { steps = 4, east = { a - 1 }, north = { a - 1 } } })
    check.within("P", biaxial:reaction("east")[1], E / (1 - nu) * a * (a^2 - 1) / 2, 1e-12)
  end
  local model = finish(square(law, "plane_strain", sheared), { { steps = 2, lid = { 0.4 } } })
  check.near(model:reaction "lid", { mu * 0.4 + (lambda / 2 + mu) * 0.4^3, (lambda / 2 + mu) * 0.4^2 }, 1e-12)
end)

check.case("a fiber adds its stress along its direction only", function()
  local function law(fibers)
    return sg.hyperelastic{ fibers = fibers, energy = function(I1, I2, J, I4)
      return 0.5 * (I1 - 3) - sg.log(J) + 0.3 * sg.log(J)^2 + 0.2 * (I4 - 1)^2
    end }
  end
  local a = 1.3
  local function pull(fibers)
    local model = finish(cube(law(fibers), { east = "x", north = "y", back = "z" }),
      { { steps = 3, east = { a - 1 }, north = { 0.1 }, back = { 0 } } })
    return model:reaction("east")[1]
  end
  check.near(pull { { 2, 0 } } - pull { { 0, 0, 1 } }, 0.8 * a * (a^2 - 1), 1e-12)
  -- At 45 degrees I4 = (a^2 + 1.1^2)/2, and P gets 0.4 (I4 - 1) a.
  check.near(pull { { 1, -1, 0 } } - pull { { 0, 0, 1 } }, 0.4 * ((a^2 + 1.21) / 2 - 1) * a, 1e-12)
end)

--- The program's neo-Hooke as a formula.
local function formula(E, nu)
  local mu = E / (2 * (1 + nu))
  local lambda = 2 * mu * nu / (1 - 2 * nu)
  return sg.hyperelastic{ energy = function(I1, I2, J)
    return lambda / 2 * sg.log(J)^2 + mu / 2 * (I1 - 3) - mu * sg.log(J)
  end }
end

check.case("the formula of neo-Hooke gives the solutions of sg.neo_hookean, with contact and friction", function()
  for _, kind in ipairs { "plane_strain", "plane_stress", "axisymmetric" } do
    local function pressed(material)
      local slab = scenes.body{ size = {2, 1}, elements = { 6, 3 }, order = "N2-N2.1", contact = "north",
        material = material }
      local shape = kind == "axisymmetric" and sg.rigid.sphere{ center = { 0, 2 }, radius = 1 }
        or sg.rigid.cylinder{ center = { 0, 2 }, radius = 1 }
      local model = scenes.model{ bodies = { slab = slab }, kind = kind,
        supports = { bed = { on = "south", fix = "xy" }, axis = { on = "west", fix = "x" },
                     push = { on = shape, drive = "y" } },
        contacts = { touch = { slave = "north", master = shape, penalty = 100,
                               friction = { mu = 0.2, penalty = 100 } } } }
      return finish(model, { { steps = 4, push = { -0.2 } } })
    end
    local by_hand, compiled = pressed(sg.neo_hookean{ E = 1, nu = 0.3 }), pressed(formula(1, 0.3))
    local force = by_hand:reaction("push")[2]
    check.at_most("force", compiled:reaction("push")[2] / force - 1, 1e-11)
    for _, field in ipairs { "uy", "syy", "von_mises", "F33" } do
      local expected = by_hand:sample("slab", field, { 0.2, 0.9 })
      check.within(field, compiled:sample("slab", field, { 0.2, 0.9 }), expected, 1e-11)
    end
  end
end)

check.case("default penalties and warnings use the moduli of small strains", function()
  local function penalty(material)
    local slab = scenes.body{ size = {2, 1}, elements = { 6, 3 }, contact = "north", material = material }
    local disc = sg.rigid.cylinder{ center = { 0, 2 }, radius = 1 }
    return scenes.model{ bodies = { slab = slab },
      supports = { bed = { on = "south", fix = "xy" }, push = { on = disc, drive = "y" } },
      contacts = { touch = { slave = "north", master = disc } } }:contact_law("touch").penalty
  end
  check.within_share("default penalty", penalty(formula(2, 0.25)), penalty(sg.neo_hookean{ E = 2, nu = 0.25 }), 1e-12)
  check.holds(tostring(formula(2, 0.25)), "hyperelastic: E = 2, nu = 0.25 without strain\n  W(I1, I2, J) = ")
  check.holds(tostring(sg.mooney_rivlin{ c10 = 0.4, c01 = 0.1, K = 50 }), "Mooney-Rivlin: E = 2.98", "J^(-0.66666")
  check.holds(tostring(sg.ogden{ mu = { 1 }, alpha = { 2 }, K = 20 }), "Ogden: ", "W(l1, l2, l3) = ")
  check.holds(tostring(sg.hyperelastic{ fibers = { { 0, 2 } }, energy = function(I1, _, J, I4)
    return I1 - 2 * sg.log(J) + sg.log(J)^2 + (I4 - 1)^2
  end }), "fibers (0, 1, 0)\n  W(I1, I2, J, I4) = ")
  local body = scenes.body{ size = { 1, 1, 1 }, elements = { 1, 1, 1 }, order = "N1",
    material = sg.yeoh{ c10 = 1, K = 5000 } }
  check.holds(sg.model{ bodies = { ring = body } }:warnings()[1], "ring", "ratio 0.4998")
end)

check.case("exponents that differ by rounding error only", function()
  -- The derivatives have J^(1/3 - 1) and J^(-2/3).
  check.holds(tostring(sg.hyperelastic{ energy = function(I1, _, J)
    return 9 * (J^(1 / 3) - 1)^2 + 0.5 * (J^(-2 / 3) * I1 - 3)
  end }), "hyperelastic: E = ")
end)

check.case("checkpoints hold the formula, and studies distinguish laws by it", function()
  local file = check.file "state.sgn"
  local model = finish(cube(laws.ogden.make(3), { east = "x" }), { { steps = 2, east = { 0.4 } } })
  model:save(file)
  local back = sg.load(file)
  check.equal(back:reaction "east", model:reaction "east")
  check.equal(tostring(back:body "cube"), tostring(model:body "cube"))
  local run, other = model:run { { steps = 1, east = { 0.5 } } }, back:run { { steps = 1, east = { 0.5 } } }
  check.equal(other:column "east.fx", run:column "east.fx")
  local function content(c) return core.content(sg.hyperelastic{ energy = function(I1, _, J)
    return c * (I1 - 3) - 2 * c * sg.log(J) + sg.log(J)^2
  end }) end
  check.equal(content(1), content(1))
  if content(1) == content(1.5) then error "different energies are equal inputs" end
end)

check.case("functions of formulas accept numbers", function()
  for _, name in ipairs { "log", "exp", "sqrt", "sin", "cos", "tan", "atan", "abs" } do
    check.near(sg[name](0.7), math[name](0.7), 1e-15)
  end
  local e = math.exp(0.7)
  check.near({ sg.sinh(0.7), sg.cosh(0.7), sg.tanh(0.7) },
    { (e - 1 / e) / 2, (e + 1 / e) / 2, (e - 1 / e) / (e + 1 / e) }, 1e-15)
end)

check.case("a run warns once where the law is unstable, and names body and stretches", function()
  local function warnings(material, a)
    return table.concat(cube(material, { east = "x" }):run({ { steps = 8, east = { a - 1 } } }, exact).warnings, "\n")
  end
  local law = sg.saint_venant_kirchhoff{ E = 1, nu = 0 }
  -- With logarithmic strain e = ln a the Kirchhoff stress E (a^4 - a^2)/2 grows down to a = 1/sqrt(2) only.
  check.equal(warnings(law, 0.72), "")
  local text = warnings(law, 0.68)
  check.holds(text, "body 'cube': its elastic law is unstable at strains of step 8",
    "principal stretches 0.68, 1, 1 at X = (")
  check.equal(select(2, text:gsub("unstable", "")), 1)
  -- A run that goes on from a checkpoint keeps the warning.
  local file, steps = check.file "cube.sgn", 0
  local function compressed(options)
    options.checkpoint = file
    return cube(law, { east = "x" }):run({ { steps = 8, east = { -0.4 } } }, lists.merged(exact, options))
  end
  local stopped = compressed{ on_step = function()
    steps = steps + 1
    return steps == 7 and "stop" or nil
  end }
  local resumed = compressed{ resume = true }
  check.equal({ stopped.reason, resumed.reason, resumed.warnings }, { "stopped", "completed", stopped.warnings })
  -- A step that fails there names the law, too.
  local bar = scenes.body{ size = {4, 1}, elements = {4, 2}, material = sg.yeoh{ c10 = 0.5, c20 = -0.05, K = 5 } }
  local run = scenes.model{ bodies = { bar = bar }, supports = { wall = { on = "west", fix = "xy" },
                        grip = { on = "east", drive = "x" } } }:run{ { steps = 20, grip = 8 } }
  check.equal(run.failed, true)
  check.holds(run.failure, "The elastic law of body 'bar' is unstable at the strains reached, which neither the mesh")
  check.holds(table.concat(run.warnings), "body 'bar': its elastic law is unstable")
  check.equal(warnings(sg.neo_hookean{ E = 1, nu = 0.3 }, 0.3), "")
  check.equal(warnings(sg.mooney_rivlin{ c10 = 0.4, c01 = 0.1, K = 5 }, 3), "")
  check.holds(warnings(sg.yeoh{ c10 = 0.5, c20 = -0.05, K = 5 }, 2.2), "unstable")
end)

local function stable(extra)
  return function(I1, I2, J, ...) return I1 - 2 * sg.log(J) + sg.log(J)^2 + extra(I1, I2, J, ...) end
end

check.case("wrong energies are errors that say what to do", function()
  local function law(energy, fibers) return function() sg.hyperelastic{ energy = energy, fibers = fibers } end end
  local function wrong(extra) return law(stable(extra)) end
  local here = "elastic_laws_test.lua:"
  check.fails(law(function() end), here, "the result of energy is missing", "a formula", "write return")
  check.fails(law(function(I1) return tostring(I1) end), here, "the result of energy", "got the string 'I1'")
  check.fails(law(function() return 3 end), here, "energy must return a formula of its arguments, got the number 3")
  check.fails(law(function(I1, _, J) return I1 - 3 + math.log(J) end), here, "Hint: use sg.log, which accepts symbols")
  check.fails(law(function(I1) return math.floor(I1) end), here, "Hint: help 'formulas'")
  check.fails(law(function(I1) return nothing * I1 end), here, "nothing")
  check.fails(law(function() error "mine" end), here, "mine")
  check.fails(wrong(function(I1) return I1 > 3 and 1 or 0 end), here, "a symbol has no value that could be compared")
  check.fails(wrong(function(I1) return I1 <= 3 and 1 or 0 end), here, "without if, and, or")
  check.fails(wrong(function(I1, I2) return I1 == I2 and 1 or 0 end), here, "a symbol has no value")
  check.fails(wrong(function(I1) return math.max(I1, 3) end), here, "compare")
  check.fails(wrong(function(I1) return I1 .. "" end), here, "concatenate")
  check.fails(wrong(function(I1) return I1 * "2x" end), here, "numbers and symbols, got the string '2x'")
  check.fails(wrong(function(I1) return I1:log() end), here, "a symbol has no method 'log'")
  check.fails(law(function(I1) return I1 - 3 end), here, "the energy must have no stress without strain",
    "principal stresses are (2, 2, 2)")
  check.fails(law(function(I1) return (I1 - 3)^2 end), here, "must be stable without strain", "shear modulus")
  check.fails(wrong(function(I1, _, J) return -5 * sg.log(J)^2 end), here, "its bulk modulus is -")
  check.fails(wrong(function(_, _, J) return sg.log(J - 1) end), here, "must be finite without strain")
  check.fails(wrong(function(I1) return (I1 - 3)^1.5 end), here, "must be finite without strain")
  check.fails(wrong(function(I1) return (0 / 0) * (I1 - 3) end), here, "must be finite without strain")
  check.fails(wrong(function(I1, _, J) return 2 * J^2 + (0 / 0) * (J - 1)^2 + 2 * I1 - 8 * J end), here,
    "must be finite without strain")
  check.fails(law(function(I1, I2, J, I4) return I1 * I2 * J * I4 end), here,
    "energy must take 3 arguments, I1, I2, J, but takes 4", "needs fibers")
  check.fails(law(function(I1, I2, J) return I1 end, { { 1, 0 } }), here, "must take 4 arguments, I1, I2, J, I4")
  check.fails(law(stable(function() return 0 end), { { 0, 0 } }), here, "fibers[1] must be a direction")
  check.fails(law(stable(function() return 0 end), { { 1, 0, 0, 0 } }), here, "fibers")
  check.fails(wrong(function(I1)
    local sum = I1
    for i = 1, 100000 do sum = sg.sin(sum + i) end
    return sum
  end), here, "the energy must have at most 2000 operations, got 3")
  check.fails(function() sg.hyperelastic{} end, here, "it must have one of energy")
  local kept
  sg.hyperelastic{ energy = stable(function(I1) kept = I1 return 0 end) }
  check.fails(wrong(function(I1) return I1 - kept end), here, "symbols of two functions")
  local function by_stretches(f) return function() sg.hyperelastic{ stretches = f } end end
  check.fails(by_stretches(function(l1, l2) return l1 * l2 end), here, "stretches must take 3 arguments", "but takes 2")
  check.fails(by_stretches(function(l1, l2, l3) return (l1 - 1)^2 + l2 * l3 end), here, "order of the stretches")
  local function product(a, b, c) return a * b * c end
  check.fails(function() sg.hyperelastic{ stretches = product, fibers = { { 1, 0 } } } end, here,
    "fibers are for energies of invariants")
end)

check.case("wrong parameters of the ready laws are errors", function()
  check.fails(function() sg.mooney_rivlin{ c10 = -1, c01 = 0, K = 5 } end,
    "sg.mooney_rivlin: the energy must be stable", "shear modulus -2")
  check.fails(function() sg.yeoh{ c10 = 0, K = 5 } end, "sg.yeoh: the energy must be stable")
  check.fails(function() sg.ogden{ mu = { 1, 2 }, alpha = { 2 }, K = 5 } end, "one value per term, got 2 and 1")
  check.fails(function() sg.ogden{ mu = { 1 }, alpha = { 0 }, K = 5 } end, "alpha[1] must not be zero")
  check.fails(function() sg.saint_venant_kirchhoff{ E = 1, nu = 0.5 } end, "nu")
end)
