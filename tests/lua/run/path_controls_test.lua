-- Reports of a run on its controls: the line in its table, fallbacks that may have left the branch, errors of the
-- energy balance; and plain Newton at reversals of the sliding direction.

require "check"
local controls = require "signorini.run.controls"
local other_warnings = require "other_warnings"
local ironing = require "ironing"
local spring = require "spring"
local run_path = require "spring_run"

--- A spring that is pulled by `steps` in as many steps, and pressed a little, where `works(options, length, from)` of
--- an attempt; see spring.lua.
local function pull(steps, works, options)
  local model
  model = spring(function(x)
    return not works(model.options, x - model.accepted[1], model.accepted[1]) and "diverged" or nil
  end)
  model.run = run_path
  return model:run({ { name = "pull", steps = steps, grip = { steps, -0.1 } } }, options)
end

local function always() return true end

-- ── The line in the table ────────────────────────────────────────────────────────────────────────────────────────────

check.case("a run whose steps all converge at once reports no controls", function()
  local run = pull(3, always)
  check.equal(tostring(run):find("controls", 1, true), nil)
  check.equal({ next(run.fallbacks), #run.warnings }, { nil, 0 })
end)

check.case("controls that differ from the defaults are named", function()
  check.holds(tostring(pull(3, always, sg.plain{})), "\ncontrols: tangent predictor; no fallbacks; no cuts")
  check.holds(tostring(pull(3, always, { predictor = "constant" })), "\ncontrols: constant predictor")
  check.holds(tostring(pull(3, always, { fallback = false })), "\ncontrols: no fallbacks")
end)

check.case("fallbacks are counted by name, and cuts", function()
  local run = pull(4, function(options, length, from)
    if from == 0 then return options.predictor == "tangent" end
    return length < 0.6
  end)
  check.equal({ run.failed, run.fallbacks.tangent, run.fallback_steps, run.fallbacks.frozen }, { false, 1, 1, nil })
  check.holds(tostring(run), ("\ncontrols: fallbacks tangent 1; %d cuts"):format(run.cutbacks))
  check.equal(#run.warnings, 0) -- neither leaves the branch
end)

-- ── Fallbacks that may leave the branch ──────────────────────────────────────────────────────────────────────────────

check.case("a fallback that solves a step which cannot be cut is a warning", function()
  local run = pull(3, function(options, _, from) return from ~= 1 or options.line_search == "residual" end)
  check.equal({ run.failed, run.fallbacks["line search"] }, { false, 1 })
  check.equal(#run.warnings, 1)
  check.holds(run.warnings[1], "may change to another branch of solutions", "(line search in step 2)",
    "compare with more steps", "arc_length = true")
  check.holds(tostring(run), run.warnings[1])
end)

check.case("so is the rest of a step in one increment, as the last resort", function()
  local run = pull(3, function(_, length, from) return from ~= 1 or length == 1 end, { predictor = "tangent" })
  check.equal(run.warnings, {}) -- at once, before anything was cut
  local tried = 0
  run = pull(3, function(_, length, from)
    if from ~= 1 or length < 1 then return from ~= 1 end
    tried = tried + 1
    return tried > 2 -- after the first two attempts, which come before the cuts
  end)
  check.equal({ run.failed, run.cutbacks > 0 }, { false, true })
  check.holds(run.warnings[1], "the rest of the step in one increment", "in step 2")
end)

check.case("if its accepted part leads to no further state, a step is repeated from its start", function()
  local function stuck_at_half(tries)
    local tried = 0
    return pull(3, function(_, length, from)
      if from == 1 and length == 1 then
        tried = tried + 1
        return tried > tries
      end
      return from < 1 or from >= 2 or from == 1 and length == 0.5
    end)
  end
  local run = stuck_at_half(2)
  check.equal({ run.failed, run.steps }, { false, 3 })
  check.holds(run.warnings[1], "the whole step again from its start in step 2")
  local last = run:attempts(2)[#run:attempts(2)]
  check.equal({ last.from, last.to, last.restarted, last.converged, run:column("increments")[2] }, { 0, 1, true, true,
    1 })
  -- Where that fails as well, the accepted part stays.
  run = stuck_at_half(1e9)
  check.equal({ run.failed, run.steps }, { true, 1 })
  check.holds(run.failure, "0.5 of the way from step 1 to step 2", "The whole step was also tried from its start.")
end)

check.case("a long list of them is cut short", function()
  local run = pull(6, function(options) return options.line_search == "residual" end, { step = { min = 1 } })
  check.holds(run.warnings[1], "line search in step 1", "line search in step 4", "and 2 more, see run:attempts(step)")
end)

-- ── Energy ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A ring that is pressed into a slab in `finer` steps, and dragged along it in twice as many; the slab is the slave.
local function drag(finer)
  local model = scenes.model{
    bodies = { ring = { patch = sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = { 1.6, 1.5 } },
        elements = { 6, 2 }, thickness_degree = 1, contact = "south", E = 10 },
      slab = { size = {4, 1}, elements = { 16, 4 }, order = "N2-N2.2", thickness_degree = 1, contact = "north" } },
    supports = { bed = { on = "slab.south", fix = "xy" }, grip = { on = { "ring.west", "ring.east" }, drive = "xy" } },
    contacts = { interface = { slave = "slab.north", master = "ring.south", penalty = 30,
        friction = { mu = 0.8, penalty = 30 } } } }
  local run = check.completed(model:run{ { name = "press", steps = finer, grip = { 0, -0.044 } },
                         { name = "slide", steps = 2 * finer, grip = { 0.56, -0.044 } } })
  local energy = model:energy()
  return run, math.abs(energy.work - energy.stored - energy.contact - energy.friction) / energy.work
end

check.case("too long steps leave an error in the energy balance: a warning names the stage and the steps", function()
  local run, missing = drag(1)
  local others = other_warnings(run)
  check.equal(#others, 1)
  check.holds(others[1], "the energy balance is off by", "of the work in stage 'slide'", "(steps = 4)")
  check.equal(missing > 0.1, true)
  local _, halved = drag(2)
  local _, quarter = drag(4)
  local quiet, eighth = drag(8)
  print(("missing energy, %% of the work: %.1f, %.1f with half the step, %.1f with a quarter, %.1f with an eighth")
    :format(100 * missing, 100 * halved, 100 * quarter, 100 * eighth))
  check.equal({ halved < 0.8 * missing, eighth < 0.3 * missing, #other_warnings(quiet) }, { true, true, 0 })
end)

--- A block on its bed that a load pulls up to a rigid ceiling; the load acts in full before the first stage or is
--- driven.
local function loaded(traction, stages)
  local model = scenes.model{ bodies = { block = { contact = "north" } },
    supports = { bed = { on = "south", fix = "xy" } }, loads = { push = { on = "north", traction = { 0, traction } } },
    contacts = { ceiling = { slave = "north", penalty = 100, master = scenes.ceiling(1.2) } } }
  return model:run(stages), model:energy()
end

local function balance_warnings(run) return #check.warnings(run, "energy balance") end

check.case("no such hint if a load acts at once; no error in a closed cycle", function()
  local run, energy = loaded(1, { { steps = 2 } })
  check.equal(energy.work > 1.2 * (energy.stored + energy.contact), true) -- summed over one step
  check.equal(balance_warnings(run), 0)
  run = loaded(0, { { steps = 30, push = { 0, 0.5 } }, { steps = 50, push = { 0, 0 } } })
  check.equal(balance_warnings(run), 0)
end)

-- ── Where the way turns back ─────────────────────────────────────────────────────────────────────────────────────────

check.case("plain Newton passes the reversals of a die that is dragged back and forth", function()
  local model = ironing{}
  local stages = { { name = "press", steps = 20, grip = { 0, -0.1 } } }
  for _ = 1, 8 do
    stages[#stages + 1] = { name = "there", steps = 100, grip = { 0.5, -0.1 } }
    stages[#stages + 1] = { name = "back", steps = 100, grip = { 0, -0.1 } }
  end
  local run = model:run(stages, sg.plain{})
  check.equal({ run.failed, run.reason, run.steps, #other_warnings(run) }, { false, "completed", 1620, 0 })
end)

check.case("steps that needed damping need it by arc length, too", function()
  local function options(fallback)
    return controls.arc_options { { { converged = false }, { converged = true, fallback = fallback } } }
  end
  check.equal({ options "damping", options "line search", options() },
    { "arc_length = true, damping = true", "arc_length = true", "arc_length = true" })
end)
