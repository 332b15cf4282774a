-- What a run works with, made of the options of model:run: the solver's arguments, a policy that takes the steps, and
-- what keeps checkpoints.

local arc_length = require "signorini.arc_length"
local checkpoint = require "signorini.checkpoint"
local steps = require "signorini.steps"

--- What is on already, in the words of model:diagnose. Rescues try damping, a line search and pseudo-transient
--- continuation by themselves.
local function controls_on(options)
  local newton, on = options.newton, {}
  local function add(name, is_on) if is_on then on[#on + 1] = name end end
  add("step", options.step.adaptive)
  add("line_search", newton.line_search ~= "none" or options.rescue)
  add("damping", options.damping or options.rescue)
  add("pseudo_transient", options.pseudo_transient or options.rescue)
  add("active_set_changes", newton.active_set_changes > 0)
  add("arc_length", options.arc_length)
  add("penalty", options.penalty)
  return on
end

--- The options themselves, with { solver (what model:solve_step takes), policy (see steps.lua), on (controls that are),
--- keeper (of checkpoints) }.
return function(options)
  local solver = {}
  for key, value in pairs(options.newton) do solver[key] = value end
  for _, key in ipairs { "predictor", "linear", "augmented", "damping", "pseudo_transient" } do
    solver[key] = options[key]
  end
  options.solver, options.on, options.keeper = solver, controls_on(options), checkpoint(options)
  options.policy = options.step.adaptive and steps.halving(options.step) or steps.plain()
  if options.arc_length then options.policy = arc_length.policy(options.policy) end
  return options
end
