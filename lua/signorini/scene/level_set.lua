-- Level sets as rigid obstacles: the user's function is called once with symbols, and its formula is compiled.

local core = require "signorini.core"
local formula = require "signorini.scene.formula"

--- sg.rigid.level_set
return function(values)
  local where, names = "sg.rigid.level_set", { "x", "y", "z" }
  local low, high = table.unpack(values.box)
  if #low ~= #high then
    core.fail(("%s: box must have two corners of equal dimension, got %d and %d coordinates"):format(where, #low,
      #high))
  end
  local symbols = core.symbols(table.move(names, 1, #low, 1, {}))
  formula.check_parameters(where, "f", values.f, symbols, false,
    ("the corners of box have %d coordinates; write f = function(%s)"):format(#low, table.concat(names, ", ", 1, #low)))
  return core.level_set{ f = formula.of(where, "f", values.f, symbols), low = low, high = high }
end
