-- scripts/studies/newton_loop.lua on a short path: a user-defined loop is bitwise equal to model:run.

require "check"

check.case("the loop and model:run take the same iterations with bitwise identical results", function()
  local result = check.study("studies/newton_loop", "steps=20", "slides=10")
  check.equal(result.differences, 0)
  check.equal({ result.run.reason, result.run.steps, #result.forces.x, #result.forces.y }, { "completed", 30, 30, 30 })
  check.equal(result.iterations, result.run.iterations)
  check.near({ result.forces.x[30], result.forces.y[30] }, { 0.016714, -0.082821 }, 1e-6)
end)

check.case("wrong arguments", function()
  local function run(word) check.study("studies/newton_loop", word) end
  check.fails(function() run "steps=many" end, "steps must be a whole number", "got 'many'")
  check.fails(function() run "slide=10" end, "'slide=10'; did you mean 'slides'?", "slides=250")
end)
