-- Stages with functions of their fraction: columns, cut steps, arc length, checkpoints, wrong inputs.

require "check"

local function bar(load)
  return scenes.model{ bodies = { bar = { size = {4, 1}, elements = {4, 2}, E = 10 } },
    supports = { wall = { on = "west", fix = "xy" }, grip = { on = "east", drive = "xy" } },
    loads = { gas = { on = "north", pressure = 0, follower = load } } }
end

local function wave(s) return { 0.2 * math.sin(2 * math.pi * s), 0.1 * s * s } end

check.case("the values are those at the end of each step; a later stage starts from the last", function()
  local model = bar()
  local run = check.completed(model:run({ { steps = 8, grip = wave, gas = function(s) return 0.3 * s ^ 3 end },
                          { steps = 2, grip = {0.4, 0.1}, gas = 0 } }, sg.plain{}))
  local x, y, gas = {}, {}, {}
  for k = 1, 8 do
    x[k], y[k] = table.unpack(wave(k / 8))
    gas[k] = 0.3 * (k / 8) ^ 3
  end
  for k = 1, 2 do x[8 + k], y[8 + k], gas[8 + k] = 0.2 * k, 0.1, 0.3 * (1 - k / 2) end
  check.near(run:column "grip.ux", x, 1e-15)
  check.near(run:column "grip.uy", y, 1e-15)
  check.near(run:column "gas.pressure", gas, 1e-15)
end)

check.case("within a step the path is linear, also where it is cut", function()
  local model, seen = bar(), {}
  model:run({ { steps = 2, grip = wave } }, { step = { adaptive = true, min = 1 / 4 }, on_iteration = function(at)
    if at.step == 2 and at.to - at.from > 0.6 then return "cut" end
    if at.step == 2 and at.from > 0 then seen[#seen + 1] = { at.from, model:target("grip")[2] } end
  end })
  -- The target of the accepted state before the last increment: from 0.025 at s = 1/2 to 0.1 at s = 1
  check.equal(#seen > 0, true)
  check.near(seen[1][2], 0.025 + 0.075 * seen[1][1], 1e-15)
  check.near(model:target "grip", wave(1), 1e-15)
end)

check.case("a resumed run follows the same values; another function is another path", function()
  local file = check.file "wave.sgn"
  local stages = { { steps = 6, grip = wave } }
  local stopped = bar():run(stages, { checkpoint = file, on_step = function(at)
    if at.step == 3 then return "stop" end
  end })
  check.equal(stopped.reason, "stopped")
  check.fails(function()
    bar():run({ { steps = 6, grip = function(s) return { s, 0 } end } }, { checkpoint = file, resume = true })
  end, "stage 1 ('stage 1') has different targets")
  local model = bar()
  local run = model:run(stages, { checkpoint = file, resume = true })
  local whole = bar()
  local straight = whole:run(stages, {})
  check.equal({ run.failed, run.steps }, { false, 6 })
  check.near(run:column "grip.fx", straight:column "grip.fx", 1e-9)
  check.near(model:target "grip", wave(1), 1e-15)
end)

check.case("arc length follows the chord of a step past a limit point", function()
  -- A balloon as in follower_test.lua, with a target that grows as the square root of the fraction
  local body = scenes.body{ patch = sg.shapes.quarter_annulus{ inner = 1, outer = 1.5, center = {0, 0} },
    elements = {4, 2}, order = "N3", volumetric = "projected",
    material = sg.mooney_rivlin{ c10 = 0.45, c01 = 0.05, K = 5000 } }
  local model = scenes.model{ bodies = { ball = body }, kind = "axisymmetric",
    supports = { axis = { on = "west", symmetry = true }, cut = { on = "east", symmetry = true } },
    loads = { gas = { on = "north", pressure = 0, follower = true } } }
  local run = model:run({ { steps = 6, gas = function(s) return 0.56 * math.sqrt(s) end } }, { arc_length = true })
  check.equal(run.failed, false)
  check.near(model:target "gas", { 0.56 }, 1e-14)
  local p, falls = run:column "gas.pressure", false
  for i = 2, #p do falls = falls or p[i] < p[i - 1] end
  check.equal(falls, true)
end)

check.case("a function that jumps at the start of its stage is a warning", function()
  local function warnings(...) return bar():run({ ... }, sg.plain{}).warnings end
  local function falling(s) return { 0, 0.1 * (1 - s) } end
  local found = warnings { name = "pull", steps = 4, grip = falling }
  check.equal(#found, 1)
  check.holds(found[1], "stage 'pull': the function of 'grip' returns {0, 0.1} for s = 0",
    "the stage begins at {0, 0}, so that its first step leads from there to {0, 0.075}. Hint: values are measured")
  check.equal(warnings({ steps = 1, grip = { 0, 0.1 } }, { steps = 2, grip = falling }), {})
  check.equal(warnings({ steps = 2, grip = wave }, { steps = 1, gas = 0.01 }, { steps = 2, grip = falling }), {})
  check.holds(warnings({ steps = 1, gas = 0.02 }, { steps = 2, gas = function(s) return 0.02 * s end })[1],
    "stage 'stage 2': the function of 'gas' returns 0 for s = 0, but the stage begins at 0.02")
  -- Values at the ends of steps, with none at 0
  local list = { 0.01, 0.03 }
  check.equal(warnings { steps = 2, gas = function(s) return list[math.floor(2 * s + 0.5)] end }, {})
  check.equal(warnings { steps = 2, gas = function(s) return list[math.floor(2 * s + 0.5)] + 0 end }, {})
end)

check.refusals([[
local model = sg.model{ bodies = { a = a },
  supports = { w = { on = a:face "west", fix = "xy" }, grip = { on = east, drive = "xy" } } }
local function run(stage) model:run{ stage } end
]], "study.lua:", {
  { "run{ steps = 2, grip = function(s) return s end }",
    "model:run: stages[1].grip must return 2 finite numbers (ux, uy), got the number 0.5 for the fraction 0.5",
    "function(s) return {0, 0.1 * s} end" },
  { "run{ steps = 2, grip = function(s) return {s, s, s} end }", "stages[1].grip must return 2 finite numbers" },
  { "run{ steps = 2, grip = function(s) end }", "must return 2 finite numbers (ux, uy), got nothing" },
  { "run{ steps = 2, grip = function(s) return {0, 0 / 0} end }", "must return 2 finite numbers",
    "got a list with nan (not a number) as entry 2 for the fraction 0.5" },
  { "run{ steps = 2, grip = function(s) return {s, '1'} end }", "must return 2 finite numbers",
    "got a list with the string '1' as entry 2" },
  { "run{ steps = 2, grop = function(s) return {s, s} end }", "grop", "grip" },
  { "run{ steps = 2, grip = function(s) return {s.x.y, 0} end }", "study.lua:4: attempt to index" },
})
