-- How steps are solved: the options of model:run that say so, and sg.robust, which turns on all that easy runs do not
-- pay for.

local core = require "signorini.core"
local arguments = require "signorini.arguments"

local controls = {}

local where = "model:run"

--- What may be tried, in turn, where an attempt at a step has failed: names as they appear in records, and the solver's
--- arguments that differ from those of the attempt that failed. `loose`: of use only where bodies are held by contact
--- alone. `early`: tried before a step is cut, always or for that reason. The others are tried only where it cannot be
--- cut any more: what they converge to on a long step may be another equilibrium than the one that the path leads to.
local rescues = {
  { name = "tangent", change = { predictor = "tangent" }, early = true },
  { name = "damping", change = { predictor = "tangent", damping = true }, loose = true, early = "singular" },
  { name = "line search", change = { predictor = "tangent", line_search = "residual" } },
  { name = "frozen", change = { predictor = "tangent", freeze_active_set = 1e-2 } },
}

--- ε_acts of the frozen active set: a number, true for 0.01, false or nothing for none.
local function read_freeze(value)
  if value == nil or value == false then return 0 end
  if value == true then return 1e-2 end
  return arguments.share(where, "newton.freeze_active_set", value, 1)
end

local function read_augmented(value)
  if value == nil or value == false then return nil end
  if value == true then value = {} end
  arguments.table(where, "augmented", value, { "penetration", "loops" })
  return { penetration = arguments.share(where, "augmented.penetration", value.penetration, 1, 1e-6),
           loops = arguments.count(where, "augmented.loops", value.loops, 100) }
end

--- The penalties' factor that grows along the path: { start, steps }, or nothing.
local function read_penalty(value)
  if value == nil then return nil end
  arguments.table(where, "penalty", value, { "start", "steps" })
  return { start = arguments.share(where, "penalty.start", value.start, 1),
           steps = arguments.count(where, "penalty.steps", value.steps) }
end

--- A solver's arguments with some of them changed, and whether that makes a difference.
function controls.changed(solver, change)
  local changed, differs = {}, false
  for key, value in pairs(solver) do changed[key] = value end
  for key, value in pairs(change) do
    differs = differs or changed[key] ~= value
    changed[key] = value
  end
  return changed, differs
end

--- The keys of model:run's options; those from newton to rescue are read here.
controls.keys = { "step", "arc_length", "on_step", "on_iteration", "checkpoint", "resume", "threads", "newton",
                  "linear", "predictor", "augmented", "damping", "penalty", "rescue", "states" }

--- What model:solve_step takes; what is tried where it fails, a list of { name, solver, early } that is also a table by
--- name; and the growing penalty.
function controls.read(model, options)
  local newton = arguments.table(where, "options.newton", options.newton,
    { "tolerance", "iterations", "line_search", "freeze_active_set", "active_set_changes" })
  local solver = {
    tolerance = arguments.positive(where, "newton.tolerance", newton.tolerance, 1e-10),
    iterations = arguments.count(where, "newton.iterations", newton.iterations, 25),
    line_search = arguments.choice(where, "newton.line_search", newton.line_search, { "none", "residual", "energy" },
      "none"),
    freeze_active_set = read_freeze(newton.freeze_active_set),
    active_set_changes = newton.active_set_changes and arguments.count(where, "newton.active_set_changes",
      newton.active_set_changes) or 0,
    predictor = arguments.choice(where, "predictor", options.predictor, { "tangent", "constant", "linear" }, "tangent"),
    linear = arguments.choice(where, "linear", options.linear, core.linear_solvers, "auto"),
    augmented = read_augmented(options.augmented),
    damping = arguments.flag(where, "damping", options.damping, false),
  }
  local tries = {}
  if arguments.flag(where, "rescue", options.rescue, false) then
    local loose = #model:loose_bodies() > 0
    for _, rescue in ipairs(rescues) do
      local changed, differs = controls.changed(solver, rescue.change)
      if differs and (loose or not rescue.loose) then
        tries[rescue.name] = { name = rescue.name, solver = changed, early = rescue.early }
        tries[#tries + 1] = tries[rescue.name]
      end
    end
  end
  return solver, tries, read_penalty(options.penalty)
end

core.docs["sg.robust"] = [[
sg.robust{ … }
Options for model:run with the controls on that easy runs do not pay for: steps begin as the last one went on
(predictor = "linear"), what fails is tried again with other controls (rescue = true), then cut in half
(step = { adaptive = true }). What is given replaces these.
Example: model:run(stages, sg.robust{ arc_length = true, step = { adaptive = true, min = 1/256 } })]]
function controls.robust(options)
  if options ~= nil and type(options) ~= "table" then
    arguments.reject("sg.robust", "options", "a table of options of model:run", options)
  end
  arguments.table("sg.robust", "options", options, controls.keys)
  local robust = { predictor = "linear", rescue = true, step = { adaptive = true } }
  for key, value in pairs(options or {}) do robust[key] = value end
  return robust
end

return controls
