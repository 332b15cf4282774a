-- Formulas of the user in elastic laws, level sets and coefficients of friction: a function is called once with
-- symbols, and its formula is compiled.

local core = require "signorini.core"
local check = require "signorini.call.check"
local counted = require("signorini.call.text").counted
local lists = require "signorini.call.lists"
local named = require "signorini.call.named"

local formula = {}

--- A hint for an error in the function, such as math.log of a symbol, or "".
local function cure(message)
  local name = message:match "'(%w+)' %(number expected, got symbol%)"
  if not name then return "" end
  if not rawget(named.entries(core.sg), name) then return ". Hint: help 'formulas' lists the functions of symbols" end
  return (". Hint: use sg.%s, which accepts symbols"):format(name)
end

--- The formula that a function of symbols returns; `where`: the function that the user has called, `name`: the argument
--- that holds the function.
local function formula_of(where, name, f, symbols)
  local ok, result = pcall(f, table.unpack(symbols))
  if not ok then error(type(result) == "string" and result .. cure(result) or result, 0) end
  if type(result) == "number" then
    core.fail(("%s: %s must return a formula of its arguments, got the number %s"):format(where, name, result))
  end
  if core.kind(result) ~= "symbol" then
    check.reject(where, "the result of " .. name, "a formula of its arguments", result,
      result == nil and "write return before the formula" or nil)
  end
  return result
end

--- Raises an error unless a function has as many parameters as there are arguments for it; `fewer`: or less.
local function check_parameters(where, name, f, symbols, fewer, hint)
  local about = debug.getinfo(f, "u")
  local takes, has = about.nparams, #symbols
  if about.isvararg or takes == has or (fewer and takes < has) then return end
  core.fail(("%s: %s must take %s, %s, but takes %d. Hint: %s"):format(where, name, counted(has, "argument"),
    table.concat(lists.map(symbols, tostring), ", "), takes, hint))
end

--- A material from functions; `label`: its name in print(material), `where`: the function that the user has called.
function formula.elastic_law(where, label, energy, stretches, fibers)
  fibers = fibers or {}
  local measure = stretches and "stretches" or "invariants"
  local name, f = stretches and "stretches" or "energy", stretches or energy
  local symbols = core.strain_symbols(measure, #fibers)
  check_parameters(where, name, f, symbols, not stretches and #fibers == 0,
    stretches and "write function(l1, l2, l3)" or #fibers == 0 and "I4 of a fiber needs fibers = { {x, y} }"
    or "after I1, I2 and J there is one argument per direction of fibers")
  return core.hyperelastic { called = where, label = label, measure = measure, fibers = fibers,
                             energy = formula_of(where, name, f, symbols) }
end

--- sg.hyperelastic
function formula.hyperelastic(values)
  if #(values.fibers or {}) > 0 and values.stretches then
    core.fail("sg.hyperelastic: fibers are for energies of invariants. Hint: use energy = function(I1, I2, J, I4)")
  end
  return formula.elastic_law("sg.hyperelastic", "hyperelastic", values.energy, values.stretches, values.fibers)
end

--- sg.rigid.level_set
function formula.level_set(values)
  local where, names = "sg.rigid.level_set", { "x", "y", "z" }
  local low, high = table.unpack(values.box)
  if #low ~= #high then
    core.fail(("%s: box must have two corners of equal dimension, got %d and %d coordinates"):format(where, #low,
      #high))
  end
  local symbols = core.symbols(table.move(names, 1, #low, 1, {}))
  check_parameters(where, "f", values.f, symbols, false,
    ("the corners of box have %d coordinates; write f = function(%s)"):format(#low, table.concat(names, ", ", 1, #low)))
  return core.level_set{ f = formula_of(where, "f", values.f, symbols), low = low, high = high }
end

-- As slip_variables() of src/contact/law/slip_formula.cpp; users have all but `recent`.
local friction_names = { "p", "v", "slip", "X", "Y", "Z", "recent", "cosine" }

--- The formula of a coefficient of friction: of a function, or of { static, kinetic, over }.
function formula.friction(name, mu)
  local symbols = core.symbols(friction_names)
  if type(mu) == "table" then
    return mu.kinetic + (mu.static - mu.kinetic) * core.sg.exp(-symbols[7] / mu.over)
  end
  local given = table.move(symbols, 1, 6, 1, { [7] = symbols[8] })
  check_parameters("sg.model", name, mu, given, true, "write those that it uses, in this order")
  return formula_of("sg.model", name, mu, given)
end

--- The formula of a rate of wear.
function formula.wear(name, rate)
  local symbols = table.move(core.symbols(friction_names), 1, 6, 1, {})
  check_parameters("sg.model", name, rate, symbols, true, "write those that it uses, in this order")
  return formula_of("sg.model", name, rate, symbols)
end

--- The formula of a pressure.
function formula.pressure(name, f)
  local symbols = core.symbols { "g", "X", "Y", "Z" }
  check_parameters("sg.model", name, f, symbols, true, "write function(g) or function(g, X, Y, Z)")
  return formula_of("sg.model", name, f, symbols)
end

--- A constant of bonds that may be a function of the mode mix: its formula, and its values at m = 0, 0.1, … 1.
local function by_mix(name, value, mix)
  if type(value) == "number" then return value, function() return value end end
  check_parameters("sg.model", name, value, { mix }, false, "write function(m)")
  local made = formula_of("sg.model", name, value, { mix })
  for k = 0, 10 do
    local m = k / 10
    local at = value(m)
    if not (at > 0 and at < math.huge) then
      core.fail(("sg.model: %s must be positive, but is %g at m = %g"):format(name, at, m))
    end
  end
  return made, value
end

--- The formula of the traction of bonds: of a function, or of strength and energy as functions of the mode mix.
function formula.cohesion(name, bond)
  local sg, u, m = core.sg, table.unpack(core.symbols { "u", "m" })
  if bond.traction then
    local where = name .. ".traction"
    check_parameters("sg.model", where, bond.traction, { u, m }, true, "write function(u) or function(u, m)")
    return formula_of("sg.model", where, bond.traction, { u, m })
  end
  local energy, energy_at = by_mix(name .. ".energy", bond.energy, m)
  local strength, strength_at = by_mix(name .. ".strength", bond.strength, m)
  if bond.law == "exponential" then
    -- T = K u exp(−u/c),  K = e² σ_c²/G_c(0),  G_c(m) = K c²
    local stiffness = math.exp(2) * bond.strength ^ 2 / energy_at(0)
    return stiffness * u * sg.exp(-u * sg.sqrt(stiffness / energy))
  end
  local stiffness = bond.stiffness
  for k = 0, 10 do
    local least = strength_at(k / 10) ^ 2 / (2 * energy_at(k / 10))
    if stiffness <= least then
      core.fail(("sg.model: %s.stiffness must be above strength^2 / (2 energy) = %.6g at m = %g, got %g. Hint: raise "
        .. "stiffness or energy, or lower strength"):format(name, least, k / 10, stiffness))
    end
  end
  -- T = min(K u, σ_c (δ_f − u)/(δ_f − δ₀)),  δ₀ = σ_c/K,  δ_f = 2 G_c/σ_c
  local last = 2 * energy / strength
  return sg.min(stiffness * u, sg.max(0, strength * (last - u) / (last - strength / stiffness)))
end

return formula
