-- linear = "mumps": the states of other solvers, inertia in diagnoses, and runs on several processes of mpirun.

require "check"

local lacking = [[linear = "mumps" and runs under mpirun need signorini_mumps.so, which was not found in ]]

--- A slab below a driven ball: returns the model after a run, and the run.
local slab = [[
local sg = require "signorini"
return function(options, mu)
  local ball = sg.rigid.sphere{ center = { 0.5, 0.5, 1.5 }, radius = 0.5 }
  local slab = sg.body{ patch = sg.shapes.block{ size = {1, 1, 1} }, elements = {4, 4, 3}, order = "N2",
                        contact = "back", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  local model = sg.model{
    bodies   = { slab = slab },
    supports = { bed = { on = slab:face "front", fix = "xyz" }, grip = { on = ball, drive = "xz" } },
    contacts = { interface = { slave = slab:face "back", master = ball, penalty = 50,
                               friction = mu and { mu = mu, penalty = 50 } or nil,
                               per = not mu and "reference" or nil } },
  }
  return model, model:run({ { name = "press", steps = 2, grip = { 0, -0.1 } },
                            { name = "drag", steps = 3, grip = { 0.1, -0.1 } } }, sg.plain(options))
end
]]
local press = load(slab)()
local program = check.shell(("realpath '%s'"):format(arg[-1])):match "[^\n]+"

local function force(model)
  local resultant = model:contact_resultant "interface"
  return { resultant.fx, resultant.fz }
end

check.case("a program without the module reports what is missing", function()
  local folder = check.folder()
  check.shell(("cp '%s' %s/program"):format(program, folder))
  core.write_file(folder .. "/slab.lua", slab)
  local function run(code, variables)
    return check.shell(("cd %s && SIGNORINI_HOME='%s' %s ./program -q -e \"%s\""):format(folder, core.home, variables,
      code))
  end
  local output, status = run("dofile 'slab.lua'{ linear = 'mumps' }", "")
  check.equal(status, 1)
  check.holds(output, "slab.lua:13: ", lacking .. folder .. "/lib/signorini/modules",
    "Hint: install signorini-mumps, or install libmumps-dev")
  output, status = run("print 'run'", "OMPI_COMM_WORLD_SIZE=2 OMPI_COMM_WORLD_RANK=0")
  check.equal(status, 1)
  check.holds(output, lacking)
  check.equal({ run("print 'run'", "OMPI_COMM_WORLD_SIZE=2 OMPI_COMM_WORLD_RANK=1") }, { "", 0 })
end)

check.case("options are checked", function()
  local model = press { iterations = nil }
  local function wrong(options, ...) check.fails(function() model:solve_step(options) end, ...) end
  wrong({ mumps = { reuse = true } }, 'mumps is for linear = "mumps", got linear = "auto"')
  wrong({ linear = "mumps", mumps = { precision = "half" } }, "mumps.precision must be 'double' or 'single'")
  wrong({ linear = "mumps", mumps = { low_rank = 2 } }, "mumps.low_rank")
  wrong({ linear = "mumps", mumps = { low_rang = 0.1 } }, "did you mean 'low_rank'?")
  check.fails(function() model:solve_arc { length = 0.1, mumps = {} } end, 'got linear = "auto"')
end)

if not core.mumps then return end

check.case("the states of other solvers, with symmetric and other tangents", function()
  local folder = check.folder()
  for _, mu in ipairs { false, 0.3 } do
    local expected = force(press({ linear = "umfpack" }, mu))
    for _, options in ipairs { {}, { reuse = true }, { low_rank = 1e-4 }, { precision = "single" },
                               { out_of_core = folder, low_rank = 1e-6, precision = "single" } } do
      local model, run = press({ linear = "mumps", mumps = options }, mu)
      local solver, reuses = model:solver(), options.reuse or options.low_rank or options.precision
      -- Friction begins where first guesses close points, and guesses of inexact solutions differ.
      check.near(force(model), expected, (mu and 1e-6 or 1e-10) * math.abs(expected[2]))
      check.equal({ run.failed, solver.linear }, { false, "mumps" })
      check.equal(solver.factorizations < run.iterations, reuses ~= nil)
      check.equal(solver.negative_eigenvalues, not (mu or reuses) and 0 or nil)
    end
  end
  collectgarbage() -- models end with their files
  check.equal(check.shell("ls " .. folder), "")
  check.fails(function() press { linear = "mumps", mumps = { out_of_core = folder .. "/none" } } end,
    "mumps.out_of_core must be a folder with write permission, got '" .. folder .. "/none'")
end)

check.case("a full disk is reported, and leaves no files", function()
  local folder = check.folder()
  core.write_file(folder .. "/slab.lua", slab)
  -- Writing beyond a limit fails like writing to a full disk if its signal is ignored.
  local output, status = check.shell(("cd %s && mkdir factors && trap '' XFSZ && ulimit -f 16 && SIGNORINI_HOME='%s' "
    .. "'%s' -q -e \"dofile 'slab.lua'{ linear = 'mumps', mumps = { out_of_core = 'factors' } }\""):format(folder,
    core.home, program))
  check.equal(status, 1)
  check.holds(output, "slab.lua:13: ", "MUMPS cannot write the factors to 'factors'. Hint: choose a folder with more")
  check.equal(check.shell("ls " .. folder .. "/factors"), "")
end)

--- A slender column below a driven support: the model and its run.
local function column(stages, options)
  local model = scenes.model{ bodies = { column = { size = {0.5, 10}, elements = {1, 8}, order = "N3" } },
    supports = { bed = { on = "south", fix = "xy" }, top = { on = "north", drive = "y" } } }
  options.linear = "mumps"
  return model, model:run(stages, sg.plain(options))
end

check.case("a failed step of a column beyond Euler's load reports the number of negative eigenvalues", function()
  local _, run = column({ { steps = 1, top = -0.1 } }, { newton = { iterations = 1 } })
  check.equal(run.cause, "indefinite")
  check.holds(run.failure, "the tangent is indefinite there, with 2 negative eigenvalues", "of body 'column'")
end)

--- A straight column, clamped below and guided above, buckles at a shortening of L (π t / L)² / 12 = 0.0206 (Euler), in
--- its second mode at four times as much. Newton's method stays on the straight branch.
check.case("steps in unstable equilibrium are named", function()
  local function compressed(steps)
    local _, run = column({ { steps = steps, top = -0.0137 * steps } }, { states = steps + 1 })
    check.equal(run.failed, false)
    return table.concat(run.warnings, " ")
  end
  check.equal(compressed(1):find "unstable", nil)
  check.holds(compressed(4), "from step 2 on: 'column' is in unstable equilibrium", "Hint")
end)

-- ── mpirun ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local folder = check.folder()
core.write_file(folder .. "/slab.lua", slab)

--- The output of code that rank 0 runs, and the exit status.
local function mpirun(ranks, code)
  core.write_file(folder .. "/study.lua", code)
  return check.shell(("cd %s && export SIGNORINI_HOME='%s' OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; "
    .. "timeout 300 mpirun --oversubscribe -n %d '%s' -q study.lua 2>&1"):format(folder, core.home, ranks, program))
end

check.case("ranks share factorizations: the same forces, in pieces of memory", function()
  for mu, counts in pairs { ["nil"] = { 4 }, ["0.3"] = { 1, 2 } } do
    local expected = force(press({}, tonumber(mu)))
    for _, ranks in ipairs(counts) do
      local output, status = mpirun(ranks, ([[
        for _, options in ipairs { {}, { low_rank = 1e-4, precision = "single" } } do
          local model, run = dofile "slab.lua"({ linear = "mumps", mumps = options }, %s)
          local resultant, solver = model:contact_resultant "interface", model:solver()
          print(resultant.fx, resultant.fz, solver.linear, run.failed, solver.rank_memory < 100e6)
        end]]):format(mu))
      check.equal(status, 0)
      local solutions = 0
      for fx, fz, rest in output:gmatch "(%S+)\t(%S+)\t(.-)\n" do
        solutions = solutions + 1
        check.equal(rest, "mumps\tfalse\ttrue")
        check.near({ tonumber(fx), tonumber(fz) }, expected, (mu == "nil" and 1e-10 or 1e-6) * math.abs(expected[2]))
      end
      check.equal(solutions, 2)
    end
  end
end)

check.case("only rank 0 runs the program, and the run has its exit status", function()
  local output, status = mpirun(3, "print 'once'")
  check.equal({ output, status }, { "once\n", 0 })
  output, status = mpirun(3, "dofile 'slab.lua'{ linear = 'mumps' } print 'once' os.exit(0)")
  check.equal({ output, status }, { "once\n", 0 })
  output, status = mpirun(2, "local _, run = dofile 'slab.lua'{} print(run.warnings[1])")
  check.equal({ output, status }, { "linear = \"auto\" uses one of the 2 processes that mpirun has started. "
    .. "Hint: linear = \"mumps\" shares factorizations among them\n", 0 })
  output, status = mpirun(2, "print 'once' error 'no'")
  check.equal({ status, select(2, output:gsub("once", "")) }, { 1, 1 })
  check.holds(output, "signorini: study.lua:1: no")
end)

check.case("other launchers are refused, because every process would run the program", function()
  for _, name in ipairs { "SLURM_STEP_NUM_TASKS", "PMI_SIZE" } do
    for count, expected in pairs { [1] = "once", [3] = "another launcher than Open MPI's mpirun has started 3" } do
      local pipe = io.popen(("%s=%d '%s' -q -e \"print 'once'\" 2>&1"):format(name, count, program))
      check.holds(pipe:read "a", expected)
      pipe:close()
    end
  end
end)

--- Waiting in MPI would take a whole processor per rank, and would not give it up by itself.
check.case("ranks sleep while rank 0 computes", function()
  local output, status = mpirun(2, [[
    local own, mpirun = io.open "/proc/self/stat":read "a":match "^(%d+) .* %a (%d+) "
    local function sleeps()
      for other in io.open(("/proc/%s/task/%s/children"):format(mpirun, mpirun)):read "a":gmatch "%d+" do
        if other ~= own then
          local status = io.open(("/proc/%s/status"):format(other)):read "a"
          return tonumber(status:match "\nvoluntary_ctxt_switches:%s*(%d+)")
        end
      end
    end
    local before, count = sleeps(), 0
    while sleeps() < before + 20 and count < 100 do count = count + 1 os.execute "sleep 0.1" end
    print(count < 100)]])
  check.equal({ output, status }, { "true\n", 0 })
end)

check.case("a study is refused, because MPI does not survive its forks", function()
  local output, status = mpirun(2, [[
    local sg = require "signorini"
    local cases = sg.grid{ a = {1, 2} }
    local study = sg.study{ name = "forks", cases = cases, run = function(case) return { b = case.a } end }
    study:execute{}]])
  check.equal(status, 1)
  check.holds(output, "study.lua:4: study:execute: cases run in forked processes, which MPI does not support",
    "Hint: run the study without mpirun")
end)

check.case("a rank that dies ends the run; its checkpoint continues", function()
  local study = [[
    local dies = %s
    local function kill_another_rank()
      local own, mpirun = io.open "/proc/self/stat":read "a":match "^(%%d+) .* %%a (%%d+) "
      for other in io.open(("/proc/%%s/task/%%s/children"):format(mpirun, mpirun)):read "a":gmatch "%%d+" do
        if other ~= own then os.execute("kill -9 " .. other) return end
      end
    end
    local model = dofile "slab.lua"{ linear = "mumps", checkpoint = "run.sgn", resume = true, on_step = function(info)
      if dies and info.step == 4 then kill_another_rank() end
    end }
    local resultant = model:contact_resultant "interface"
    print(resultant.fx, resultant.fz)]]
  local output, status = mpirun(3, study:format "true")
  assert(status ~= 0)
  check.holds(output, "exited on signal 9")
  output, status = mpirun(2, study:format "false")
  check.equal(status, 0)
  local expected, fx, fz = force(press {}), output:match "(%S+)%s+(%S+)\n$"
  check.near({ tonumber(fx), tonumber(fz) }, expected, 1e-10 * math.abs(expected[2]))
end)
