-- Studies: cases in separate processes, and results that are saved; study_inputs_test.lua changes their inputs,
-- study_methods_test.lua reads them.

require "check"

--- How many cases a folder holds.
local function files_in(folder)
  return tonumber((check.shell(("ls %s/cases 2>/dev/null | grep -c 'json$'"):format(folder))))
end

-- ── Cases ────────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("a grid holds all combinations, the last name fastest", function()
  local grid = sg.grid{ order = { "N2", "N4" }, mesh = { "m1", "m2", "m3" } }
  local words = {}
  for i, case in ipairs(grid) do words[i] = case.mesh .. case.order end
  check.equal(words, { "m1N2", "m1N4", "m2N2", "m2N4", "m3N2", "m3N4" })
  local ordered = sg.grid({ order = { "N2", "N4" } }, { mesh = { "m1", "m2" } })
  check.equal({ ordered[2].order, ordered[2].mesh, ordered[3].order }, { "N2", "m2", "N4" })
  check.fails(function() sg.grid{ { 1, 2 } } end, "every entry of parameters needs a name")
  check.fails(function() sg.grid({ a = { 1 } }, { a = { 2 } }) end, "the parameter 'a' occurs twice")
  check.fails(function() sg.grid({ a = { 1 } }, {}) end, "parameters must be a table of names")
  check.fails(function() sg.grid{ a = { 1, 0 / 0 } } end,
    "sg.grid: parameters.a[2] must be a value (a finite number", "got nan")
  check.fails(function() sg.grid{ a = { { name = "m1", 1 } } } end,
    "it mixes names and a list in one table: put the list")
  check.equal(tostring(sg.grid{ a = { 0.5 }, mesh = { { 6, 2 }, { name = "m1", die = 1 } } }),
    "2 cases\n  a  mesh\n0.5  6×2\n0.5  m1")
  local list = {}
  for i = 1, 23 do list[i] = i end
  check.holds(tostring(sg.grid{ a = list }), "23 cases\n", "\n20\n… 3 more")
end)

check.case("wrong arguments are errors at the user's line", function()
  local function run() return {} end
  for _, wrong in ipairs {
    { { name = "s", cases = {}, run = run }, "cases must be a list of at least one value", "got an empty table" },
    { { name = "s", cases = { 3 }, run = run }, "cases[1] must be a table of parameters", "the number 3" },
    { { name = "s", cases = sg.grid{ wall = { 1 } }, run = run }, "cannot be called 'wall'" },
    { { name = "s", cases = { { a = print } }, run = run }, "cases[1].a", "function" },
    { { name = "s", cases = { { a = 0 / 0 } }, run = run }, "cases[1].a", "nan" },
    { { name = "s", cases = { { a = 1 }, { a = 1 } }, run = run }, "cases[1] and cases[2]", "'a=1'" },
    { { name = "", cases = sg.grid{ a = { 1 } }, run = run },
      "name must be a string that is valid as the name of a folder, got the string ''" },
    { { name = "..", cases = sg.grid{ a = { 1 } }, run = run },
      "name must be a string that is valid as the name of a folder" },
    { { name = "s", cases = sg.grid{ a = { 1 } }, run = run, folder = "" }, "folder must be the name of a folder" },
    { { name = "s", cases = sg.grid{ outcome = { 1 } }, run = run }, "cannot be called 'outcome'" },
  } do
    check.fails(function() sg.study(wrong[1]) end, "study_test.lua", table.unpack(wrong, 2))
  end
  local study = sg.study{ name = "s", cases = sg.grid{ a = { 1 } }, run = run, folder = check.file() }
  check.fails(function() study:where{ b = 1 } end, "study:where: no case has 'b': none of its cases is done yet")
  check.fails(function() study:where{}:execute{} end, "part of a study")
  check.fails(function() study:exeute{} end, "study_test.lua", "a study has no 'exeute'; did you mean 'execute'?")
end)

-- ── Execution ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A study whose run notes in a file that it was called.
local function noted(folder, cases, run, more)
  return sg.study(lists.merged({ name = "noted", folder = folder, cases = cases, inputs = {}, run = function(case)
    os.execute(("echo %s >>%s.log"):format(case.a, folder))
    return run(case)
  end }, more))
end

local function calls(folder)
  local file, lines = io.open(folder .. ".log"), 0
  for _ in file and file:lines() or function() end do lines = lines + 1 end
  return lines
end

check.case("results, failures, errors and crashes become rows; finished cases do not run again", function()
  local folder = check.file()
  local function study()
    return noted(folder, sg.grid{ a = { 1, 2, 3, 4, 5 } }, function(case)
      if case.a == 2 then return { failed = true, reason = "cycling", at = 0.5 } end
      if case.a == 3 then error "no luck" end
      if case.a == 4 then os.execute "kill -SEGV $PPID" end
      return { b = case.a ^ 2 / 3, list = { 0.1, 0.2 }, word = "w", flag = true }
    end, { units = { b = "N" } })
  end
  local first = study():execute{ jobs = 2 }
  check.equal(#first, 5)
  check.equal(first:row{ a = 5 }.b, 25 / 3)
  check.equal(first:row{ a = 5 }.list, { 0.1, 0.2 })
  check.equal({ first.rows[2].failed, first.rows[2].reason, first.rows[2].at }, { true, "cycling", 0.5 })
  check.holds(first.rows[3].reason, "study_test.lua", "no luck")
  check.equal(first.rows[4].reason, "terminated by signal 11")
  check.holds(tostring(first), "noted: 5 of 5 cases are done, 1 failed, 1 ended by an error, 1 crashed\n", "cycling",
    "8.33333", "  N ")
  check.equal({ first.rows[1].outcome, first.rows[2].outcome, first.rows[3].outcome, first.rows[4].outcome },
    { nil, "failed", "error", "crashed" })
  check.equal(calls(folder), 5)
  local second = study():execute{ jobs = 2 }
  check.equal(calls(folder), 7) -- the error and the crash, which may have passed
  check.equal(second:row{ a = 5 }.b, 25 / 3)
  check.equal(study():read():table{ columns = { "a", "b" } }, first:table{ columns = { "a", "b" } })
  study():execute{ rerun = "failed" }
  check.equal(calls(folder), 10)
  study():execute{ rerun = function(row) return row.a == 1 end }
  check.equal(calls(folder), 13)
end)

check.case("the file of a case is JSON with inputs, results, version, host and time", function()
  local folder = check.file()
  sg.study{ name = "one", folder = folder, cases = { { order = "N2", mesh = { name = "m1", die = { 6, 2 } } } },
            run = function(case) return { third = 1 / 3, die = case.mesh.die[1] } end }:execute{}
  local name = check.shell(("ls %s/cases"):format(folder)):gsub("\n", "")
  check.holds(name, "mesh=m1_order=N2-", ".json")
  local record = core.read_json(core.read_file(folder .. "/cases/" .. name))
  check.equal({ record.study, record.case.order, record.case.mesh.die, record.results.third, record.results.die },
    { "one", "N2", { 6, 2 }, 1 / 3, 6 })
  check.equal({ record.made.versions.signorini, record.made.host, record.outcome },
    { core.release(), core.host, "done" })
  check.holds(record.made.time:gsub("%d", "0"), "0000-00-00T00:00:00Z")
  check.equal(record.wall > 0, true)
end)

check.case("cases that request it run last, and alone", function()
  local folder = check.file()
  local study = noted(folder, sg.grid{ a = { 1, 2, 3, 4 } }, function() return {} end,
    { sequential = function(case) return case.a <= 2 end })
  study:execute{ jobs = 2 }
  local order = {}
  for line in io.lines(folder .. ".log") do order[#order + 1] = tonumber(line) end
  check.equal({ order[3], order[4] }, { 1, 2 })
  local record = core.read_json((check.shell(("cat %s/cases/a=1-*.json"):format(folder))))
  check.equal(record.made.at_once, 1)
end)

check.case("an error of a case is reported and makes the status 1; a case that failed, or os.exit, leaves it 0",
  function()
  local function run(body, ending)
    return check.script(([[
      require "signorini".study{ name = "e", folder = arg[1], cases = { { a = 1 }, { a = 2 } },
                                 run = function(case) %s end }:execute{}
      print "end" %s]]):format(body, ending or ""), check.file())
  end
  local output, status = run 'if case.a == 2 then error "no luck" end return {}'
  check.holds(output, "end\n",
    "signorini: e: 1 of 2 cases ended by an error, which makes the exit status 1; the first one, a=2: ",
    "study.lua:2: no luck\n")
  check.equal(status, 1)
  output, status = run 'return { failed = true, reason = "cycling" }'
  check.equal({ status, output:find "ended by an error" }, { 0, nil })
  check.equal({ select(2, run('error "no luck"', "os.exit(true)")) }, { 0 })
end)

check.case("a limit ends a case; with more time it runs again", function()
  local folder = check.file()
  local function study() return noted(folder, { { a = 1 } }, function() os.execute "sleep 0.4" return { b = 1 } end) end
  local late = study():execute{ limit = 0.1 }
  check.equal(late.rows[1].reason, "not done within 0.1 s")
  study():execute{ limit = 0.1 }
  check.equal(calls(folder), 1)
  check.equal(study():execute{ limit = 20 }.rows[1].b, 1)
end)

check.case("two jobs run two cases in parallel", function()
  local folder = check.file()
  local function mark(a) return ("%s/begun_%d"):format(folder, a) end
  local study = sg.study{ name = "t", folder = folder, cases = sg.grid{ a = { 1, 2, 3, 4 } }, inputs = {},
    run = function(case)
      -- 1 and 2 wait for each other, 3 and 4 as well; whoever is alone gives up.
      os.execute("touch " .. mark(case.a))
      local partner = mark(case.a % 2 == 1 and case.a + 1 or case.a - 1)
      for _ = 1, 600 do
        if io.open(partner) then return { met = 1 } end
        os.execute "sleep 0.05"
      end
      return { met = 0 }
    end }
  local met = {}
  for i, row in ipairs(study:execute{ jobs = 2 }.rows) do met[i] = row.met end
  check.equal(met, { 1, 1, 1, 1 })
end)

check.case("killed three times and resumed it ends with the same table and repeats no finished case", function()
  local script = ([[
    local sg = require "signorini"
    local folder = arg[1]
    local study = sg.study{ name = "killed", folder = folder, cases = sg.grid{ a = { 1, 2, 3, 4 }, b = { 1, 2, 3 } },
      inputs = {}, run = function(case)
        os.execute "sleep 0.05"
        os.execute(("echo %d %d >>%s.log"):format(case.a, case.b, folder))
        return { c = case.a / case.b }
      end }:execute{ jobs = 2 }
    print(study:table{ columns = { "a", "b", "c" } })]])
  local whole, broken, name = check.file(), check.file(), check.file()
  core.write_file(name, script)
  local expected = check.program { "-q", name, whole }
  for _, count in ipairs { 1, 4, 7 } do -- files, from which on it is killed
    check.shell(("%s -q %s %s & until [ $(ls %s/cases 2>/dev/null | grep -c json$) -ge %d ]; do sleep 0.01; done; "
      .. "kill -9 $!; wait $! 2>/dev/null; true"):format(arg[-1], name, broken, broken, count))
    check.equal(files_in(broken) >= count, true)
  end
  local finished = files_in(broken)
  -- Cases that were under way when they were killed may have been begun twice; none of those that had ended.
  local before = calls(broken)
  check.equal(check.program { "-q", name, broken }, expected)
  check.equal(calls(broken) - before, 12 - finished)
end)

check.case("Ctrl-C ends it with the finished cases, and unlocks the folder", function()
  local folder, name = check.file(), check.file()
  core.write_file(name, ([[
    local sg = require "signorini"
    sg.study{ name = "stopped", folder = "%s", cases = sg.grid{ a = { 1, 2, 3, 4, 5, 6 } }, inputs = {},
              run = function(case)
                while case.a > 1 and not io.open "%s.go" do os.execute "sleep 0.02" end
                return { b = case.a }
              end }:execute{ jobs = 1 }
    print "not stopped"]]):format(folder, folder))
  local output = check.shell(("%s -q %s & for i in $(seq 1000); do ls %s/cases/*.json >/dev/null 2>&1 && break; "
    .. "sleep 0.02; done; kill -INT $!; wait $!; echo status $?"):format(arg[-1], name, folder))
  local finished = files_in(folder)
  check.equal(finished, 1) -- the others wait
  core.write_file(folder .. ".go", "")
  check.holds(output, ("stopped: interrupted: %d of 6 cases %s saved; the same call continues with the others\n")
    :format(finished, finished == 1 and "is" or "are"), ":2: interrupted", "status 130")
  check.holds(check.program { name }, ("stopped: %d of 6 taken from %s, %d to solve\nstopped: %d of 6: a=")
    :format(finished, folder, 6 - finished, finished + 1), "not stopped\n")
  check.equal(files_in(folder), 6)
end)

-- ── What goes wrong ──────────────────────────────────────────────────────────────────────────────────────────────────

check.case("a result that is nan makes its case an error that names it; the others are saved", function()
  local study = noted(check.file(), sg.grid{ a = { 1, 2, 3, 4, 5 } }, function(case)
    if case.a == 2 then return { dPx = 0 / 0 } end
    if case.a == 3 then return { curve = { 1, math.huge } } end
    if case.a == 4 then return { a = 1 } end
    if case.a == 5 then return end
    return { dPx = 1 }
  end):execute{}
  check.equal(study.rows[1].dPx, 1)
  check.holds(study.rows[2].reason, "case a=2: the result dPx is nan (not a number). Hint: results are finite numbers",
    "return nil for unknown ones")
  check.holds(study.rows[3].reason, "case a=3: the result curve[2] is infinity")
  check.holds(study.rows[4].reason, "the result 'a' has the name of a parameter")
  check.holds(study.rows[5].reason, "run returned nothing. Hint: return a table of results")
  check.equal({ study.rows[2].failed, study.rows[2].dPx }, { true, nil })
end)

check.case("two studies cannot use a folder: neither of different names, nor the same one twice at a time", function()
  local folder = check.file()
  noted(folder, { { a = 1 } }, function() return {} end):execute{}
  local other = sg.study{ name = "other", folder = folder, cases = { { a = 1 } }, run = function() return {} end }
  check.fails(function() other:execute{} end, "study_test.lua", folder, "holds the study 'noted', not 'other'",
    "give this one another folder")
  check.fails(function() other:read() end, "holds the study 'noted'")
  local lock = core.lock(folder .. "/lock")
  check.fails(function() noted(folder, { { a = 2 } }, function() return {} end):execute{} end,
    "study:execute: '" .. folder .. "/lock' is locked by process", "choose another folder")
  lock:release()
  check.equal(files_in(folder), 1)
end)

check.case("an unreadable file is solved again; leftovers of a killed process are removed", function()
  local folder = check.file()
  local function study() return noted(folder, sg.grid{ a = { 1, 2 } }, function(case) return { b = case.a } end) end
  study():execute{}
  check.shell(("cd %s/cases; for f in a=1-*; do head -c 40 $f >x; mv x $f; echo >.$f.part; done")
    :format(folder))
  check.equal(study():execute{}.rows[1].b, 1)
  check.equal(check.shell(("ls -A %s/cases | grep -c part"):format(folder)), "0\n")
  check.equal(calls(folder), 3)
end)

--- A command with a small file system at a folder: nothing where the machine does not allow that.
local function with_disk(folder, options, command)
  for _, way in ipairs { "unshare -m", "unshare -rm" } do
    if select(2, check.shell(way .. " sh -c 'mount -t tmpfs tmpfs /mnt'")) == 0 then
      return check.shell(("mkdir -p %s; %s sh -c 'mount -t tmpfs -o %s tmpfs %s && { %s; }'")
        :format(folder, way, options, folder, command))
    end
  end
  print "this machine allows no small file systems: full disks are left out"
end

check.case("on a full disk no finished case is lost, and with more space it continues", function()
  local folder, name = check.file(), check.file()
  core.write_file(name, ([[
    local sg = require "signorini"
    local study = sg.study{ name = "large", folder = "%s", cases = sg.grid{ a = { 1, 2, 3, 4, 5, 6, 7, 8 } },
      inputs = {}, run = function(case)
        local list = {}
        for i = 1, 40000 do list[i] = i + case.a end
        return { list = list, sum = case.a }
      end }
    study:execute{ jobs = 1 }
    local sum = 0
    for _, row in ipairs(study.rows) do sum = sum + row.list[40000] end
    print("sum", sum)]]):format(folder))
  local run = ("%s %s 2>&1"):format(arg[-1], name)
  local output = with_disk(folder, "size=3m",
    ("%s; echo status $?; ls %s/cases | wc -l; mount -o remount,size=30m %s; %s")
    :format(run, folder, folder, run))
  if not output then return end
  check.holds(output, "no space is left for '" .. folder .. "'", "free some and execute again", "status 1",
    "sum\t320036")
  -- Each case that said that it was done is there, and only the others run after that.
  local first, rest = output:match "^(.-)status 1\n(.*)$"
  local _, done = first:gsub(": a=%d: %d", "")
  local finished = tonumber(rest:match "^%s*(%d+)")
  check.equal(finished >= done and finished <= done + 1 and finished >= 3, true)
  local _, later = rest:gsub(": a=%d: %d", "")
  check.equal(later, 8 - finished)
end)

check.case("a folder that cannot be written to is an error before any case runs", function()
  local folder = check.file()
  core.write_file(folder, "x\n")
  local function execute(where) noted(where, { { a = 1 } }, function() return {} end):execute{} end
  check.fails(function() execute(folder) end, "study_test.lua",
    "study:execute: cannot create the folder '" .. folder .. "/cases'")
  check.equal(calls(folder), 0)
  local inside = check.file()
  local output = with_disk(inside, "ro", ([[%s -e "require(\"signorini\").study{ name = \"s\", folder = \"%s\",
    cases = { { a = 1 } }, run = function() print(1) return {} end }:execute{}"]]):format(arg[-1], inside))
  if output then
    check.holds(output, "cannot create the folder '" .. inside .. "/cases'", "Read-only", "choose a place")
  end
end)
