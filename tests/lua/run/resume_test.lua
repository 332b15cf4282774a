-- Runs with checkpoints: resumed anywhere they end as if uninterrupted; invalid files, paths and options.

require "check"
local ironing = require "ironing"
local bonded = require "strip"

local file = check.file()

local path = { { name = "press", steps = 8, grip = {0, -0.15} }, { name = "slide", steps = 12, grip = {0.2, -0.15} } }

--- Everything of two runs but seconds is the same, bit by bit.
local function alike(run, other, model, other_model)
  local function strip(value)
    if type(value) ~= "table" then return value end
    local copy = {}
    for key, entry in pairs(value) do
      if key ~= "wall" and key ~= "timings" and key ~= "wall_column" and key ~= "stored_states"
        and key ~= "model" then
        copy[key] = strip(entry)
      end
    end
    return copy
  end
  check.equal(core.pack(strip(run)), core.pack(strip(other)))
  for _, name in ipairs(model:support_names()) do check.equal(model:reaction(name), other_model:reaction(name)) end
  for _, name in ipairs(model:contact_names()) do
    check.equal(core.pack(model:profile(name)), core.pack(other_model:profile(name)))
  end
end

--- Runs a path whole; then, for each step of the list, once more up to it, and on from the file with a new model.
local function taken_up(make, stages, options, stops)
  options.checkpoint = options.checkpoint or file
  local model = make()
  local run = model:run(stages, options)
  for _, stop in ipairs(stops) do
    os.remove(file)
    options.on_step = function(info) return info.step == stop and "stop" or nil end
    local part = make():run(stages, options)
    check.equal({ part.reason, part.steps }, { "stopped", stop })
    options.on_step, options.resume = nil, true
    local other = make()
    alike(run, other:run(stages, options), model, other)
    options.resume = nil
  end
  return run, model
end

check.case("a run resumed after any step ends as if it had not been interrupted", function()
  local run = taken_up(ironing, path, {}, { 1, 7, 8, 9, 15, 19, 20 })
  check.equal({ run.failed, run.steps }, { false, 20 })
end)

check.case("with a checkpoint after every few steps it continues from the last one", function()
  taken_up(ironing, path, { checkpoint = { file = file, every = 6 } }, { 5, 6, 11, 18, 20 })
end)

check.case("increments keep their length", function()
  local rough = { { name = "press", steps = 4, grip = {0, -0.3} }, { name = "slide", steps = 5, grip = {0.8, -0.3} } }
  local run = taken_up(ironing, rough, { newton = { iterations = 6 }, step = { growth = 1.5 } }, { 1, 2, 4, 5, 6, 8 })
  assert(run.cutbacks > 2, run.cutbacks)
  local shorter = 0
  for _, count in ipairs(run:column "increments") do shorter = shorter + (count > 1 and 1 or 0) end
  assert(shorter > 3)
end)

check.case("with any controls", function()
  for _, options in ipairs {
    { predictor = "linear" }, { predictor = "constant", newton = { line_search = "energy" } },
    { newton = { freeze_active_set = true } }, { newton = { active_set_changes = 5 } }, { damping = true },
    { penalty = { start = 0.1, steps = 5 } },
    sg.robust{ newton = { iterations = 6 } },
  } do
    check.equal(taken_up(ironing, path, options, { 3, 13 }).failed, false)
  end
end)

check.case("also with arc length through a snap-back in step 145", function()
  local run = taken_up(bonded.model, { { name = "peel", steps = 152, edge = 76 } },
    { checkpoint = { file = file, every = 5 }, arc_length = true, newton = { iterations = 10 } }, { 143, 145, 149 })
  check.equal({ run.reason, run.steps, #run.controls }, { "completed", 152, 2 })
end)

check.case("a failed step leaves the last file; the resumed run fails in the same way", function()
  os.remove(file)
  local far = { { name = "press", steps = 6, grip = {0, -0.15} }, { name = "leap", steps = 1, grip = {2.5, -2.5} } }
  local model, other = ironing(), ironing()
  local run = model:run(far, { checkpoint = file })
  check.equal({ run.failed, run.steps }, { true, 6 })
  local again = other:run(far, { checkpoint = file, resume = true })
  check.equal({ again.reason, again.failure }, { run.reason, run.failure })
  alike(run, again, model, other)
end)

check.case("the file of a finished run gives the run at once; without a file it begins", function()
  os.remove(file)
  local model, other = ironing(), ironing()
  local run = model:run(path, { checkpoint = file, resume = true })
  check.equal(run.steps, 20)
  local again = other:run(path, { checkpoint = file, resume = true })
  alike(run, again, model, other)
  check.equal(other:solver().factorizations, 0)
  check.holds(tostring(again), "press", "slide", "total")
  local fresh = ironing()
  fresh:run(path, { checkpoint = file })
  assert(fresh:solver().factorizations > 0)
  -- The model of the file alone, too
  local loaded = sg.load(file)
  check.equal(loaded:reaction "grip", model:reaction "grip")
end)

check.case("a path from a state that is not the first one, in two runs of one model", function()
  local function both(options, stop)
    local model = ironing()
    model:run{ { steps = 6, grip = {0, -0.12} } }
    options.on_step = stop and function(info) return info.step == stop and "stop" or nil end
    return model:run({ { steps = 8, grip = {0.16, -0.12} } }, options), model
  end
  local run, model = both({ checkpoint = file })
  os.remove(file)
  both({ checkpoint = file }, 3)
  local again, other = both({ checkpoint = file, resume = true })
  alike(run, again, model, other)
end)

check.case("unsuitable files are errors at the user's line", function()
  local function refused(model, stages, ...)
    local before = model:reaction "grip"
    check.fails(function() model:run(stages, { checkpoint = file, resume = true }) end, "resume_test.lua:",
      "model:run: ", file, ...)
    check.equal(model:reaction "grip", before)
  end
  ironing():run(path, { checkpoint = file })
  refused(ironing{ slab_E = 2 }, path, "was saved from a different scene; differences: body 'slab'")
  refused(ironing(), { path[1] }, "another path: it has 1 stage, the file's has 2")
  refused(ironing(), { path[1], { name = "slide", steps = 13, grip = {0.2, -0.15} } },
    "stage 2 ('slide').steps is 13, in the file 12")
  refused(ironing(), { path[1], { name = "slide", steps = 12, grip = {0.3, -0.15} } },
    "stage 2 ('slide') has different targets")
  refused(ironing(), { { name = "down", steps = 8, grip = {0, -0.15} }, path[2] }, "stage 1 ('down').name", "press")
  local model = ironing()
  model:save(file)
  refused(ironing(), path, "was saved by model:save, not by a run")
  core.save(model, file, "{{},{},")
  refused(ironing(), path, "cannot be read as a run")
  core.write_file(file, "SIGNORINI checkpoint\n")
  refused(ironing(), path, "is damaged: it is truncated after 21 bytes")
  core.write_file(file, "something else")
  refused(ironing(), path, "is not a checkpoint written by signorini")
  check.ended({ check.script("local sg = require 'signorini'\nprint(sg.load(arg[1]))", file) }, 1,
    "study.lua:2: sg.load: '" .. file)
end)

check.case("wrong options", function()
  local model = ironing()
  local function refused(options, ...)
    check.fails(function() model:run(path, options) end, "resume_test.lua:", "model:run: ", ...)
  end
  refused({ resume = true }, "resume = true needs a checkpoint file: add checkpoint = \"run.sgn\"")
  -- before the first step, not after it
  refused({ checkpoint = "nowhere/at/all.sgn" }, "cannot write 'nowhere/at/all.sgn'", "create it first")
  check.equal(model:solver().factorizations, 0)
end)

check.case("plain data as bytes and back, bit by bit", function()
  local value = { 1, -2, 0.1, 1 / 3, -0.0, 5e-324, 1e308, math.huge, -math.huge, math.mininteger, true, false, "",
                  "a\"b\\c\nd\0e ü \xff", {}, { { 3 } }, { name = "x", ["grip.fx"] = { 1.5 } } }
  local text = core.pack(value)
  local back = core.unpack(text)
  check.equal(core.pack(back), text)
  for i, entry in ipairs(value) do
    if type(entry) ~= "table" then check.equal(back[i], entry) end
    check.equal(math.type(back[i]), math.type(entry))
  end
  check.equal(1 / back[5], -math.huge)
  local nan = core.unpack(core.pack(0 / 0))
  assert(nan ~= nan)
  for _, wrong in ipairs { "", text:sub(1, -2), text .. "\0", "{1}", "\xc1" } do
    check.equal((pcall(core.unpack, wrong)), false)
  end
  for _, wrong in ipairs { print, { [1.5] = 1 }, { [3] = 1 }, io.stdout } do
    check.equal((pcall(core.pack, wrong)), false)
  end
end)
