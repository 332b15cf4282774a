-- Formulas of the user in elastic laws, level sets and contacts: a function is called once with symbols, and its
-- formula is compiled.

local core = require "signorini.core"
local check = require "signorini.call.check"
local counted = require("signorini.call.text").counted
local lists = require "signorini.call.lists"
local meant = require("signorini.call.text").meant
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
--- that holds the function; `first`: the first variable that it can have; `or_number`: the argument can be a number.
local function formula_of(where, name, f, symbols, first, or_number)
  local ok, result = pcall(f, table.unpack(symbols))
  if not ok then error(type(result) == "string" and result .. cure(result) or result, 0) end
  if type(result) == "number" then
    local hint = math.abs(result) < math.huge and "let it depend on " .. tostring(first or symbols[1])
      or "look for a division by zero"
    if or_number and math.abs(result) < math.huge then hint = ("write %s = %s"):format(name:match "%w+$", result) end
    core.fail(("%s: %s must return a formula of its arguments, got the number %s. Hint: %s"):format(where, name, result,
      hint))
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

--- The symbols that a function of a contact receives: those of its parameters, by name; all, in order, where the names
--- are not known, as of a function that string.dump has stripped.
local function arguments_of(name, f, symbols)
  local about, names = debug.getinfo(f, "u"), lists.map(symbols, tostring)
  local known = table.concat(names, ", ")
  if about.isvararg then
    core.fail(("sg.model: %s must name its parameters, but takes any number of them. Hint: write function(%s), with "
      .. "those that it needs of %s"):format(name, names[1], known))
  end
  local given = {}
  for i = 1, about.nparams do
    local parameter = debug.getlocal(f, i)
    if not parameter then
      check_parameters("sg.model", name, f, symbols, true, "write those that it uses, in this order")
      return symbols
    end
    given[i] = lists.filter(symbols, function(symbol) return tostring(symbol) == parameter end)[1]
    if not given[i] then
      local hint = meant(parameter, names)
      core.fail(("sg.model: %s has an unknown parameter '%s'%s known: %s. Hint: write those that it needs, by name, in "
        .. "any order"):format(name, parameter, hint == "" and ";" or hint, known))
    end
  end
  return given
end

--- The formula of a function of a contact.
local function contact_formula(name, f, symbols, or_number)
  return formula_of("sg.model", name, f, arguments_of(name, f, symbols), symbols[1], or_number)
end

-- As slip_variables() of src/contact/law/slip_formula.cpp; users have all but `recent`.
local friction_names = { "p", "v", "slip", "X", "Y", "Z", "recent", "cosine" }

--- The formula of a coefficient of friction: of a function, or of { static, kinetic, over }.
function formula.friction(name, mu)
  local symbols = core.symbols(friction_names)
  if type(mu) == "table" then
    return mu.kinetic + (mu.static - mu.kinetic) * core.sg.exp(-symbols[7] / mu.over)
  end
  return contact_formula(name, mu, table.move(symbols, 1, 6, 1, { [7] = symbols[8] }), true)
end

--- The formula of a rate of wear.
function formula.wear(name, rate)
  return contact_formula(name, rate, table.move(core.symbols(friction_names), 1, 6, 1, {}), true)
end

--- The formula of a pressure.
function formula.pressure(name, f)
  return contact_formula(name, f, core.symbols { "g", "X", "Y", "Z" })
end

--- A constant of bonds that may be a function of the mode mix: its formula, and its values at m = 0, 0.1, … 1.
local function by_mix(name, value, mix)
  if type(value) == "number" then return value, function() return value end end
  local made = contact_formula(name, value, { mix }, true)
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
  if bond.traction then return contact_formula(name .. ".traction", bond.traction, { u, m }) end
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
