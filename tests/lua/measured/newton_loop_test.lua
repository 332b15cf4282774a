-- scripts/studies/newton_loop.lua on a short path: a user-defined loop is bitwise equal to model:run.

local core = require "signorini.core"
local check = require "check"

core.quiet = true
local script = core.home .. "/scripts/studies/newton_loop.lua"

check.case("the loop and model:run take the same iterations with bitwise identical results", function()
  local print_to_terminal = print
  print = function() end
  local ok, result = pcall(assert(loadfile(script)), "steps=20", "slides=10")
  print = print_to_terminal
  if not ok then error(result, 0) end
  check.equal(result.differences, 0)
  check.equal({ result.run.reason, result.run.steps, #result.forces.x, #result.forces.y }, { "completed", 30, 30, 30 })
  check.equal(result.iterations, result.run.iterations)
  check.near({ result.forces.x[30], result.forces.y[30] }, { 0.016714, -0.082821 }, 1e-6)
end)

check.case("wrong arguments", function()
  check.fails(function() assert(loadfile(script))("steps=many") end, "steps must be a whole number", "got 'many'")
  check.fails(function() assert(loadfile(script))("slide=10") end, "'slide=10'; did you mean 'slides'?", "slides=250")
end)

check.done()
