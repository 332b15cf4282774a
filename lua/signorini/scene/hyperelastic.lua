-- Elastic laws from an energy: the user's function is called once with symbols, and its formula is compiled.

local core = require "signorini.core"
local formula = require "signorini.scene.formula"

local hyperelastic = {}

--- A material from functions; `label`: its name in print(material), `where`: the function that the user has called.
function hyperelastic.make(where, label, energy, stretches, fibers)
  fibers = fibers or {}
  local measure = stretches and "stretches" or "invariants"
  local name, f = stretches and "stretches" or "energy", stretches or energy
  local symbols = core.strain_symbols(measure, #fibers)
  formula.check_parameters(where, name, f, symbols, not stretches and #fibers == 0,
    stretches and "write function(l1, l2, l3)" or #fibers == 0 and "I4 of a fiber needs fibers = { {x, y} }"
    or "after I1, I2 and J there is one argument per direction of fibers")
  return core.hyperelastic { called = where, label = label, measure = measure, fibers = fibers,
                             energy = formula.of(where, name, f, symbols) }
end

--- sg.hyperelastic
function hyperelastic.new(values)
  if #(values.fibers or {}) > 0 and values.stretches then
    core.fail("sg.hyperelastic: fibers are for energies of invariants. Hint: use energy = function(I1, I2, J, I4)")
  end
  return hyperelastic.make("sg.hyperelastic", "hyperelastic", values.energy, values.stretches, values.fibers)
end

return hyperelastic
