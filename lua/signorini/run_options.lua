-- The options of model:run, as far as they can be read without a model and a path: sg.plain and sg.robust check them,
-- too.

local core = require "signorini.core"
local arc_length = require "signorini.arc_length"
local arguments = require "signorini.arguments"
local checkpoint = require "signorini.checkpoint"
local steps = require "signorini.steps"

local run_options = {}

--- All of them.
run_options.keys = { "step", "arc_length", "on_step", "on_iteration", "checkpoint", "resume", "threads", "newton",
                     "linear", "predictor", "augmented", "damping", "pseudo_transient", "penalty", "rescue", "states" }

--- What steps are solved with unless options say otherwise: `robust`, and `plain` where arcs follow the path, since cut
--- steps and fallbacks may leave it.
run_options.robust = { predictor = "linear", rescue = true, step = { adaptive = true } }
run_options.plain = { predictor = "tangent", rescue = false, step = { adaptive = false } }

--- Options with those of `defaults` that are not given.
function run_options.with(defaults, options)
  local whole = {}
  for _, list in ipairs { defaults, options or {} } do
    for key, value in pairs(list) do whole[key] = value end
  end
  return whole
end

--- ε_acts of the frozen active set: a number, true for 0.01, false or nothing for none.
local function read_freeze(where, value)
  if value == nil or value == false then return 0 end
  if value == true then return 1e-2 end
  return arguments.share(where, "newton.freeze_active_set", value, 1)
end

local function read_augmented(where, value)
  if value == nil or value == false then return nil end
  if value == true then value = {} end
  arguments.table(where, "augmented", value, { "penetration", "loops" })
  return { penetration = arguments.share(where, "augmented.penetration", value.penetration, 1, 1e-6),
           loops = arguments.count(where, "augmented.loops", value.loops, 100) }
end

--- The penalties' factor that grows along the path: { start, steps }, or nothing.
local function read_penalty(where, value)
  if value == nil then return nil end
  arguments.table(where, "penalty", value, { "start", "steps" })
  return { start = arguments.share(where, "penalty.start", value.start, 1),
           steps = arguments.count(where, "penalty.steps", value.steps) }
end

--- What model:solve_step takes.
local function read_solver(where, options)
  local newton = arguments.table(where, "options.newton", options.newton,
    { "tolerance", "iterations", "line_search", "freeze_active_set", "active_set_changes" })
  return {
    tolerance = arguments.positive(where, "newton.tolerance", newton.tolerance, 1e-10),
    iterations = arguments.count(where, "newton.iterations", newton.iterations, 25),
    line_search = arguments.choice(where, "newton.line_search", newton.line_search, { "none", "residual", "energy" },
      "none"),
    freeze_active_set = read_freeze(where, newton.freeze_active_set),
    active_set_changes = newton.active_set_changes and arguments.count(where, "newton.active_set_changes",
      newton.active_set_changes) or 0,
    predictor = arguments.choice(where, "predictor", options.predictor, { "tangent", "constant", "linear" }),
    linear = arguments.choice(where, "linear", options.linear, core.linear_solvers, "auto"),
    augmented = read_augmented(where, options.augmented),
    damping = arguments.flag(where, "damping", options.damping, false),
    pseudo_transient = arguments.flag(where, "pseudo_transient", options.pseudo_transient, false),
  }
end

--- The policy that takes each step (see steps.lua).
local function read_policy(where, step)
  arguments.table(where, "options.step", step, { "adaptive", "min", "max", "growth" })
  local adaptive = arguments.flag(where, "step.adaptive", step.adaptive, true)
  for _, key in ipairs { "min", "max", "growth" } do
    if not adaptive and step[key] ~= nil then
      core.fail(("%s: step.%s has no effect with adaptive = false, which takes each step at once: take one of the two "
        .. "out"):format(where, key))
    end
  end
  local max = arguments.share(where, "step.max", step.max, 1, 1)
  local options = { max = max, min = arguments.share(where, "step.min", step.min, max, math.min(max, 1 / 64)),
                    growth = arguments.at_least(where, "step.growth", step.growth, 1, 2) }
  return adaptive and steps.halving(options) or steps.plain()
end

--- What is on already, in the words of model:diagnose. Rescues try damping, a line search and pseudo-transient
--- continuation by themselves.
local function controls_on(read, adaptive)
  local solver, on = read.solver, {}
  local function add(name, is_on) if is_on then on[#on + 1] = name end end
  add("step", adaptive)
  add("line_search", solver.line_search ~= "none" or read.rescue)
  add("damping", solver.damping or read.rescue)
  add("pseudo_transient", solver.pseudo_transient or read.rescue)
  add("active_set_changes", solver.active_set_changes > 0)
  add("arc_length", read.arcs)
  add("penalty", read.penalty)
  return on
end

--- { solver, rescue, penalty, policy, arcs, on (controls that are), on_step, on_iteration, keeper (of checkpoints),
--- threads }, and the table of options itself. `where`: whose options they are, for messages.
function run_options.read(where, options)
  options = arguments.table(where, "options", options, run_options.keys)
  local arcs = arguments.flag(where, "arc_length", options.arc_length, false)
  options = run_options.with(arcs and run_options.plain or run_options.robust, options)
  local threads = options.threads ~= nil and arguments.count(where, "threads", options.threads, nil, core.most_threads)
  local policy = read_policy(where, options.step)
  if arcs then policy = arc_length.policy(policy) end
  local read = {
    solver = read_solver(where, options), rescue = arguments.flag(where, "rescue", options.rescue),
    penalty = read_penalty(where, options.penalty), policy = policy, arcs = arcs, threads = threads,
    adaptive = options.step.adaptive ~= false,
    on_step = arguments.callback(where, "on_step", options.on_step),
    on_iteration = arguments.callback(where, "on_iteration", options.on_iteration),
    keeper = checkpoint(where, options),
  }
  read.on = controls_on(read, options.step ~= nil and options.step.adaptive ~= false)
  if read.solver.pseudo_transient and read.solver.line_search ~= "none" then
    core.fail(where .. ": pseudo_transient finds the length of its moves by itself: take newton.line_search out")
  end
  if arcs and read.solver.augmented then
    core.fail(where .. ": augmented and arc_length cannot be used together: take one of the two out")
  end
  return read, options
end

return run_options
