-- Files of the present formats are read as they were when these began, and those of a newer or older one are errors.
-- The samples were written by the version of the program that introduced their format, see samples/write.lua.

require "check"

local scenes = require "samples.scenes"

local folder = check.folder()

local function sample_of(name) return ("%s/tests/lua/samples/format13/%s"):format(core.home, name) end

local function copy(name)
  check.shell(("cp -r '%s' '%s'"):format(sample_of(name), folder))
  return ("%s/%s"):format(folder, name)
end

local line_of_checkpoints = "SIGNORINI checkpoint\n"

--- A copy of a checkpoint in another format.
local function with_format(name, number)
  local file = copy(name)
  local bytes = core.read_file(file)
  local head = #line_of_checkpoints
  core.write_file(file, bytes:sub(1, head) .. ("<I4"):pack(number) .. bytes:sub(head + 5))
  return file
end

check.case("a run goes on from a checkpoint", function()
  local run = scenes.plane():run(scenes.path, { checkpoint = copy("run.sgn"), resume = true })
  check.equal(run.steps, 4)
  -- The forces of the whole run when the first sample was written.
  check.near(run:column "grip.fx"[4], 0.020066582886142, 1e-11)
  check.near(run:column "grip.fy"[4], -0.067452541098537, 1e-11)
  local whole = scenes.plane():run(scenes.path)
  check.near(run:column "grip.fx"[4], whole:column "grip.fx"[4], 1e-12)
end)

check.case("slip points on obstacles stay where they were in a checkpoint", function()
  local run = scenes.disc():run(scenes.path, { checkpoint = copy("disc.sgn"), resume = true })
  check.near(run:column "grip.fx"[4], 0.023432288152975, 1e-10)
  check.near(run:column "grip.fy"[4], -0.074780181076359, 1e-10)
end)

check.case("a model in space is loaded from a file", function()
  local model = sg.load(sample_of("space.sgn"))
  local here = scenes.space()
  here:run{ { steps = 1, tool = { -0.2 } } }
  for _, name in ipairs{ "fx", "fy", "fz", "area" } do
    check.near(model:contact_resultant("c")[name], here:contact_resultant("c")[name], 1e-12)
  end
  check.near(model:contact_resultant("c").fz, -0.32346387767576, 1e-11)
end)

check.case("a study of the first format is read and not solved again", function()
  local study = scenes.study(copy "study"):read()
  check.equal(#study.rows, 4)
  check.equal({ study.rows[1].force, study.rows[2].force, study.rows[3].force }, { 0.25, 0.25, 0.5 })
  check.equal(study.rows[4].force, nil)
  check.equal(study.rows[1].label, "N2!")
  check.equal(study.rows[4].reason, "a reason")
  local again = scenes.study(study.folder)
  again:execute{ jobs = 1 }
  check.equal(again.rows[2].force, 0.25)
  check.equal(core.read_json(core.read_file(study.folder .. "/study.json")).format, 1)
end)

check.case("checkpoints of a newer format are errors that say so", function()
  for _, number in ipairs{ 14, 0xffffffff } do
    local file = with_format("space.sgn", number)
    check.fails(function() sg.load(file) end, "compatibility_test.lua", "sg.load",
      ("was written by a newer version of the program, in format %d; this one reads formats up to 13"):format(number))
  end
  local file = with_format("run.sgn", 14)
  check.fails(function() scenes.plane():run(scenes.path, { checkpoint = file, resume = true }) end,
    "compatibility_test.lua", "newer version")
  check.fails(function() sg.load(with_format("space.sgn", 12)) end, "older version of the program, in format 12")
end)

check.case("records of runs that cannot be those of a run are errors, not errors of a later step", function()
  local sample, model = sample_of "run.sgn", scenes.plane()
  core.restore(model, sample)
  for _, damage in ipairs{
    function(state) state.memory.length = {} end, function(state) state.spent.contact = true end,
    function(state) state.record.rows = {} end, function(state) state.record.stages = {} end,
    function(state) state.place.stage = 3 end, function(_, rows) rows[2][3] = "x" end,
    function(_, _, histories) histories[1][1] = 5 end,
  } do
    local saved = core.unpack(core.checkpoint_text(sample))
    damage(table.unpack(saved))
    local file = folder .. "/record.sgn"
    core.save(model, file, core.pack(saved), false)
    check.fails(function() scenes.plane():run(scenes.path, { checkpoint = file, resume = true }) end,
      "compatibility_test.lua", "cannot be read as a run")
  end
  local saved = core.unpack(core.checkpoint_text(sample))
  saved[1].format = 2
  core.save(model, folder .. "/record.sgn", core.pack(saved), false)
  check.fails(function() scenes.plane():run(scenes.path, { checkpoint = folder .. "/record.sgn", resume = true }) end,
    "was written by a newer version of the program, in format 2 of runs")
end)

check.case("records of cases that cannot be those of a case count as damaged", function()
  local place = copy "study"
  local case = place .. "/cases/" .. core.list_folder(place .. "/cases")[1]
  core.write_file(case, (core.read_file(case):gsub('"results": {', '"reason": 5, "results": {', 1)))
  check.equal(#scenes.study(place):read().rows, 3)
end)

check.case("studies of a newer format are errors that say so", function()
  local place = copy "study"
  core.write_file(place .. "/study.json", '{"study": "samples", "format": 2}')
  for _, use in ipairs{ function(study) study:read() end, function(study) study:execute{ jobs = 1 } end } do
    check.fails(function() use(scenes.study(place)) end, "compatibility_test.lua", "study.json",
      "was written by a newer version of the program, in format 2", "reads formats up to 1")
  end
  core.write_file(place .. "/study.json", '{"study": "samples"}')
  local case = place .. "/cases/" .. core.list_folder(place .. "/cases")[1]
  core.write_file(case, (core.read_file(case):gsub("{", '{"format": 9, ', 1)))
  check.fails(function() scenes.study(place):read() end, "compatibility_test.lua", "newer version", "format 9")
end)
