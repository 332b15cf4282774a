-- The controls of a run: fallbacks after a failed step, growing penalties, callbacks, sg.robust, invalid options.

require "check"
local ironing = require "ironing"
local spring = require "spring"
local run_path = require "spring_run"

--- Pressed by 0.5 in 46 steps, plain Newton cycles in the 33rd or the 34th.
local function deep() return ironing{ E = 1e4, mu = 0.1, order = "N4", penalty = 1000, points = 7 } end

--- The published path's first 60 steps: 46 of pressing, 14 of sliding.
local sixty = { { name = "press", steps = 46, grip = {0, -0.23} },
  { name = "slide", steps = 14, grip = {0.084, -0.23} } }

local function largest_difference(a, b)
  local most = 0
  for i = 1, math.max(#a, #b) do most = math.max(most, math.abs(a[i] - b[i])) end
  return most
end

--- A spring whose steps are not solved unless `works(options)` of an attempt; see spring.lua.
local function spring_model(works, unconstrained)
  local model
  model = spring(function() return not works(model.options) and "cycling" or nil end)
  if unconstrained then function model:unconstrained_bodies() return { "ball" } end end
  model.run = run_path
  return model
end

local one_step = { { name = "pull", steps = 1, grip = {1, 0} } }

-- ── Fallback ─────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The names of the attempts at a step, with how they ended: "plain cycling, tangent converged".
local function story(run, step)
  local words = {}
  for i, attempt in ipairs(run:attempts(step)) do words[i] = (attempt.fallback or "plain") .. " " .. attempt.reason end
  return table.concat(words, ", ")
end

check.case("fallbacks are tried in order, each with its own change only", function()
  local tried = {}
  local model = spring_model(function(options)
    tried[#tried + 1] = ("%s %s %g %s%s"):format(options.predictor, options.line_search, options.freeze_active_set or 0,
      options.damping, options.pseudo_transient and " pseudo-transient" or "")
    return false
  end, true)
  local run = model:run(one_step, sg.plain{ fallback = true, predictor = "linear" })
  check.equal(tried,
    { "linear energy 0 false", "tangent energy 0 false", "tangent none 0 true", "tangent residual 0 false",
      "tangent none 0 false pseudo-transient", "tangent energy 0.01 false" })
  check.equal(story(run, 1),
    "plain cycling, tangent cycling, damping cycling, line search cycling, pseudo-transient cycling, frozen cycling")
  -- The attempt in pseudo-time may use 7 * 40 iterations, what is left of 16 * 25.
  check.equal({ run.failed, run.reason, run.fallback_steps, run.iterations }, { true, "cycling", 0, 5 * 25 + 7 })
  check.holds(run.failure, "Attempts, by fraction of the step: 1 (cycling), 1 with tangent (cycling), "
    .. "1 with damping (cycling), 1 with line search (cycling), 1 with pseudo-transient (cycling), 1 with frozen "
    .. "(cycling).")
end)

check.case("the line search is by energy, but none with damping, in pseudo-time, or where contact pulls", function()
  local function search(options, law)
    local found
    local model = spring_model(function(given)
      found = given.line_search
      return true
    end)
    if law then function model:contact_law() return law end end
    model:run(one_step, options)
    return found
  end
  check.equal({ search{}, search({}, { penalty = 1 }), search(sg.plain{ fallback = true }) },
    { "energy", "energy", "energy" })
  check.equal({ search(sg.plain{}), search{ arc_length = true }, search{ damping = true },
                search{ pseudo_transient = true }, search({}, { hamaker = 1 }), search({}, { strength = 1 }),
                search({}, { method = "half_passes" }) },
    { "none", "none", "none", "none", "none", "none", "none" })
  check.equal({ search{ newton = { line_search = "none" } }, search{ newton = { line_search = "residual" } },
                search({ newton = { line_search = "energy" } }, { strength = 1 }) }, { "none", "residual", "energy" })
end)

check.case("after a failed predictor the next attempts do without it", function()
  local tried, model = {}, nil
  model = spring_model(function(options)
    tried[#tried + 1] = options.predictor
    return options.predictor == "tangent" or #tried ~= 2
  end)
  local run = model:run({ { name = "pull", steps = 12, grip = {1, 0} } }, { fallback = true, predictor = "linear" })
  check.equal({ run.failed, run.fallback_steps }, { false, 1 })
  local expected = { "linear", "linear", "tangent" }
  for _ = 1, 8 do expected[#expected + 1] = "tangent" end
  table.move({ "linear", "linear" }, 1, 2, #expected + 1, expected)
  check.equal(tried, expected)
  for step = 3, 12 do check.equal(run:attempts(step)[1].fallback, nil) end
end)

check.case("fallbacks without effect are not tried, damping only for unconstrained bodies", function()
  local function tried(options) return story(spring_model(function() return false end):run(one_step, options), 1) end
  check.equal(tried(sg.plain{ fallback = true }),
    "plain cycling, line search cycling, pseudo-transient cycling, frozen cycling")
  check.equal(tried(sg.plain{ fallback = true, newton = { line_search = "residual", freeze_active_set = true } }),
    "plain cycling, pseudo-transient cycling")
  check.holds(tried(sg.plain{ fallback = true, pseudo_transient = true }), "line search cycling, frozen cycling")
  check.equal(tried(sg.plain{}), "plain cycling")
end)

check.case("a body that contact cannot hold is not damped", function()
  local model = spring_model(function() return false end, true)
  function model:contact_names() return {} end
  check.equal(story(model:run(one_step, sg.plain{ fallback = true }), 1),
    "plain cycling, line search cycling, pseudo-transient cycling, frozen cycling")
end)

check.case("the first fallback that converges ends the search and is counted; the next step is normal", function()
  local model
  model = spring_model(function(options) return model.accepted[1] ~= 1 or options.line_search == "residual" end)
  local run = model:run({ { steps = 3, grip = {3, 0} } }, sg.plain{ fallback = true, predictor = "linear" })
  check.equal({ story(run, 1), story(run, 2), story(run, 3) },
    { "plain converged", "plain cycling, tangent cycling, line search converged", "plain converged" })
  check.equal({ run.failed, run.fallback_steps, run.cutbacks }, { false, 1, 0 })
  check.equal({ run:attempts(2)[1].fallback, run:attempts(2)[3].fallback }, { nil, "line search" })
  check.equal(run:column "iterations", { 3, 25 + 25 + 3, 3 })
end)

check.case("fallbacks but the predictor wait until no step can be cut, then try rest and whole step", function()
  local model
  model = spring_model(function(options) return options.freeze_active_set and model.next[1] <= 0.5 end)
  local run = model:run(one_step, sg.plain{ fallback = true, step = { adaptive = true, min = 0.5 } })
  local vain = "plain cycling, line search cycling, pseudo-transient cycling, frozen "
  check.equal(story(run, 1), "plain cycling, " .. vain .. "converged" .. (", " .. vain .. "cycling"):rep(3))
  local attempts = run:attempts(1)
  check.near({ attempts[1].to, attempts[2].to, attempts[6].from, attempts[6].to, attempts[10].to, attempts[14].from },
    { 1, 0.5, 0.5, 1, 1, 0 })
  check.equal({ run.fallback_steps, run.cutbacks, run.reason, run.cause }, { 1, 1, "minimum_step", "cycling" })
end)

check.case("deep ironing, where plain Newton cycles, completes", function()
  local path = { { name = "press", steps = 46, grip = {0, -0.5} } }
  local run = deep():run(path, sg.plain{ fallback = true, newton = { line_search = "none" } })
  check.equal({ run.failed, run.steps, run.fallback_steps > 0 }, { false, 46, true })
  for step = 1, 46 do -- in which steps plain Newton fails depends on the first guesses before them
    if #run:attempts(step) > 1 then
      local failed = story(run, step)
      check.equal({ failed:match "^plain (%a+), line search converged$" ~= nil, step > 20 }, { true, true })
    end
  end
  local fy = run:column "grip.fy"
  for _, newton in ipairs { { line_search = "residual" }, { line_search = "energy" } } do
    run = deep():run(path, sg.plain{ newton = newton })
    check.equal({ run.failed, run.steps }, { false, 46 })
    check.near(run:column("grip.fy")[46] / fy[46], 1, 1e-6)
  end
end)

check.case("fixed states of cycling points do no harm: if they cannot be freed the run reports it", function()
  for _, changes in ipairs { 2, 4, 8 } do
    local run = deep():run({ { name = "press", steps = 46, grip = {0, -0.5} } },
      sg.plain{ newton = { active_set_changes = changes } })
    check.equal({ run.reason, run.steps < 46, run.places[1].contact }, { "cycling", true, "interface" })
    check.holds(run.failure, "contact points whose state was fixed change it again when they are released")
  end
  local run = ironing{ E = 1e4, mu = 0.1, order = "N6", points = 7 }:run({ { steps = 46, grip = {0, -0.5} } },
    sg.plain{ newton = { active_set_changes = 4 } })
  check.equal({ run.failed, run.steps }, { false, 46 })
end)

check.case("damping holds an unconstrained body until contact", function()
  local model = scenes.model{ bodies = { block = { corner = {0, 0.2}, contact = "south" } },
    supports = { wall = { on = "west", fix = "x" } }, loads = { weight = { on = "north", traction = {0, 0} } },
    contacts = { floor = { slave = "south", penalty = 50, master = scenes.floor() } } }
  check.equal(model:unconstrained_bodies(), { "block" })
  local run = model:run({ { steps = 2, weight = {0, -0.1} } }, sg.plain{ fallback = true })
  check.equal({ run.failed, story(run, 1) }, { false, "plain singular, damping converged" })
  check.near(run:column "floor.fy", { 0.05, 0.1 }, 1e-9)
end)

-- ── Penalties that grow ──────────────────────────────────────────────────────────────────────────────────────────────

check.case("a growing penalty ends in the states of the full one", function()
  local path = { { steps = 8, grip = {0, -0.1} } }
  local full, model = ironing{ mu = 0 }:run(path), ironing{ mu = 0 }
  local factors = {}
  local run = model:run(path, { penalty = { start = 0.01, steps = 4 },
                                on_step = function() factors[#factors + 1] = model:penalty_factor() end })
  -- start^(1 − step/steps)
  check.near(factors, { 0.01 ^ 0.75, 0.1, 0.01 ^ 0.25, 1, 1, 1, 1, 1 }, 1e-12)
  local reference, forces = full:column "grip.fy", run:column "grip.fy"
  for step = 1, 3 do check.equal(forces[step] > reference[step] + 1e-4, true) end -- softer: less thrust
  for step = 4, 8 do check.near(forces[step], reference[step], 1e-8) end
end)

check.case("a failed step keeps the penalty of the last accepted one", function()
  local model = ironing{ mu = 0 }
  local run = model:run({ { steps = 2, grip = {0, -0.1} } },
    { penalty = { start = 0.01, steps = 4 },
      on_iteration = function(info) return info.step == 2 and "stop" or nil end })
  check.equal({ run.reason, run.steps }, { "stopped", 1 })
  check.near(model:penalty_factor(), 0.01 ^ 0.75, 1e-15)
  check.near(model:reaction("grip")[2], run:column("grip.fy")[1], 1e-12)
end)

-- ── Callbacks ────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("on_iteration is called after every iteration and changes no bit", function()
  local path = { { name = "press", steps = 3, grip = {0, -0.015} } }
  local plain, seen = ironing{}:run(path), {}
  local run = ironing{}:run(path, { on_iteration = function(info) seen[#seen + 1] = info end })
  for _, column in ipairs { "grip.fx", "grip.fy", "interface.area", "iterations" } do
    check.equal(run:column(column), plain:column(column))
  end
  local i = 0
  for step = 1, 3 do
    check.equal(run:residuals(step), plain:residuals(step))
    for k, residual in ipairs(run:residuals(step)) do
      i = i + 1
      local info, last = seen[i], k == #run:residuals(step)
      check.equal({ info.stage, info.step, info.from, info.to, info.residual }, { "press", step, 0, 1, residual })
      check.equal({ info.iteration, info.reason }, { last and k - 1 or k, last and "converged" or "iterating" })
    end
  end
  check.equal(#seen, i)
end)

check.case("on_iteration cuts an attempt, and shorter steps follow", function()
  local run = ironing{}:run({ { steps = 2, grip = {0, -0.01} } }, { step = { adaptive = true }, fallback = true,
    on_iteration = function(info) return info.to - info.from > 0.6 and info.iteration == 2 and "cut" or nil end })
  check.equal({ run.failed, run.steps, run.cutbacks, run.fallback_steps }, { false, 2, 2, 0 })
  check.equal(story(run, 1), "plain cut, plain converged, plain converged")
  check.equal({ run:attempts(1)[1].iterations, run:column("increments")[1] }, { 2, 2 })
end)

check.case("on_step cuts an accepted step, and adds columns", function()
  local model = ironing{}
  local reference = ironing{}:run{ { steps = 4, grip = {0, -0.01} } }
  local seen = 0
  local run = model:run({ { steps = 2, grip = {0, -0.01} } }, { step = { adaptive = true, growth = 1 },
    on_step = function(info)
      seen = seen + 1
      if seen == 1 then return "cut" end
      return { twice = 2 * info["grip.fy"], late = info.step == 2 and 7 or nil }
    end })
  check.equal({ run.failed, run.steps, run.cutbacks, seen }, { false, 2, 1, 3 })
  check.equal(run:column "increments", { 3, 2 }) -- one that was taken back
  local fy, by_four = run:column "grip.fy", reference:column "grip.fy"
  check.near(fy, { by_four[2], by_four[4] }, 1e-10) -- the same increments
  check.equal(run:column "twice", { 2 * fy[1], 2 * fy[2] })
  local late, name = run:column "late", check.file()
  check.equal({ #late, late[1] ~= late[1], late[2] }, { 2, true, 7 }) -- nan, 7
  run:csv(name)
  local read = sg.csv.read(name)
  local n = #read.columns
  check.equal({ read.columns[n], read.rows[2][n], read.rows[1][n] }, { "late", 7 })
end)

check.case("results that on_step must not return", function()
  local function returning(value)
    local options = { on_step = function() return value end }
    return function() spring_model(function() return true end):run(one_step, options) end
  end
  check.fails(returning { 1, 2 }, "controls_test.lua:", "on_step: its result must be")
  check.fails(returning "stopp", "controls_test.lua:",
    "on_step: its result must be nothing, \"stop\", \"cut\" or a table", "got the string 'stopp'")
  check.fails(returning(true), "controls_test.lua:", "on_step: its result must be", "got true")
  check.fails(returning { depth = "1" }, "controls_test.lua:",
    "on_step: depth must be a number, got the string '1'")
  check.fails(returning { ["grip.fx"] = 1 }, "on_step: 'grip.fx' is already a column of the run")
end)

check.case("errors and invalid results of on_iteration keep their line and the model's accepted state", function()
  local model, stages = ironing{}, { { steps = 1, grip = {0, -0.01} } }
  local function run(on_iteration) return model:run(stages, { on_iteration = on_iteration }) end
  check.fails(function() run(function() return "halt" end) end, "controls_test.lua:",
    "on_iteration: its result must be nothing, \"stop\" or \"cut\", got the string 'halt'")
  check.fails(function() run(function() error "a mistake of mine" end) end, "controls_test.lua:", "a mistake of mine")
  check.equal(model:target "grip", {0, 0})
  check.equal(run(function() return false end).failed, false)
end)

-- ── sg.robust ────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("sg.robust turns on controls that cost nothing in easy runs", function()
  local robust = sg.robust()
  check.equal({ robust.predictor, robust.fallback, robust.step.adaptive }, { "quadratic", true, true })
  robust = sg.robust { step = { adaptive = true, min = 1 / 256 }, predictor = "tangent", linear = "klu" }
  check.equal({ robust.predictor, robust.fallback, robust.step.min, robust.linear },
    { "tangent", true, 1 / 256, "klu" })
end)

check.case("easy ironing takes fewer iterations by default than with plain Newton, with the same states", function()
  local plain, robust = ironing{}:run(sixty, sg.plain{}), ironing{}:run(sixty)
  check.equal({ robust.failed, robust.fallback_steps, robust.cutbacks }, { false, 0, 0 })
  check.equal(robust.iterations < 0.75 * plain.iterations, true)
  for _, column in ipairs { "grip.fx", "grip.fy" } do
    -- Friction of a point that closes begins where the first guess of the step closes it, and guesses differ.
    check.equal(largest_difference(robust:column(column), plain:column(column)) < 1e-5, true)
  end
end)

check.case("only a converged step is accepted", function()
  local model = ironing{}
  local function refused(...)
    check.fails(function() model:accept() end, "controls_test.lua:", "model:accept: ", ...)
  end
  model:accept() -- what is accepted already
  model:set_target("grip", {0, -0.01})
  refused("no step has been solved since targets, penalties or contacts were changed", "Hint: solve a step, or call")
  check.equal(model:iterate{}.reason, "iterating")
  refused("the step is not in equilibrium yet", "iterate until")
  repeat local result = model:iterate{} until result.reason ~= "iterating"
  model:set_penalty_factor(2) -- the state belongs to another penalty
  refused "no step has been solved since targets, penalties or contacts were changed"
  model:set_penalty_factor(1)
  check.equal(model:solve_step{}.converged, true)
  model:accept()
  check.equal(model:target "grip", {0, -0.01})
  local length = model:last_length()
  model:accept()
  check.equal({ length > 0, model:last_length() }, { true, length })
  model:set_target("grip", {0, -5})
  check.equal(model:solve_step{}.reason, "inverted")
  refused("the step has failed (inverted)", "Hint: call model:rollback()")
  check.fails(function() model:residual() end, "model:residual: the current state has no residual", "model:rollback()")
  check.equal(model:iterate{}.reason, "inverted") -- it stays failed
  model:rollback()
  check.equal(#model:residual(), #model:unknowns())
  check.equal(model:target "grip", {0, -0.01})
end)

check.case("extreme targets end a run and leave the model unchanged", function()
  local model = ironing{}
  local run = model:run({ { steps = 1, grip = {1e300, 0} } }, sg.robust{})
  check.equal({ run.failed, run.reason, run.cause, model:target "grip" }, { true, "minimum_step", "nan", {0, 0} })
  for _, depth in ipairs { 5, 0.01 } do
    run = model:run({ { steps = 1, grip = {0, -depth} } }, sg.plain{})
    check.equal(run.failed, depth == 5)
  end
end)

-- ── Wrong options ────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("invalid options are rejected before the first step, at the user's line", function()
  local model = spring_model(function() return true end)
  for _, case in ipairs {
    { { predicter = "linear" }, "options: unknown argument 'predicter'", "did you mean 'predictor'?" },
    { { newton = { freeze_active_set = 2 } }, "newton.freeze_active_set must be true, false or a number from 0 to 1" },
    { { resume = true }, "resume = true needs a checkpoint file", "add checkpoint =" },
  } do
    check.fails(function() model:run(one_step, case[1]) end, "controls_test.lua:", "model:run: ", table.unpack(case, 2))
  end
  check.equal({ model.spent, #model.calls }, { 0, 0 })
end)

check.case("so are those of a real model's methods, and there is nothing to diagnose without a step", function()
  local model = ironing{}
  local wrong = { freeze_active_set = -1 }
  check.fails(function() model:solve_step(wrong) end, "controls_test.lua:", "freeze_active_set")
  check.fails(function() model:iterate(wrong) end, "controls_test.lua:", "freeze_active_set")
  check.fails(function() model:diagnose() end, "controls_test.lua:", "no step to diagnose: call diagnose after")
end)
