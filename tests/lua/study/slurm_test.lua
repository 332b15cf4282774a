-- Studies on Slurm: the tables are those of a local execution, bit by bit, and each case is done once, although tasks
-- are killed, a node is drained and a time limit hits. On a cluster of two nodes that the test starts on this machine.

require "check"

local here = core.home .. "/tests"
local cluster = check.folder()
local started, status = check.shell(("'%s/slurm/cluster' start '%s'"):format(here, cluster))
if status ~= 0 then error(started, 0) end
local slurm = ("SLURM_CONF='%s/slurm.conf' "):format(cluster)

--- A command in a folder of a study, with the cluster.
local function shell(folder, command)
  return check.shell(("cd '%s' && export %s && %s"):format(folder, slurm, command))
end

--- The script in a folder, with the words of a command line.
local function signorini(folder, words) return shell(folder, ("'%s' study.lua %s"):format(arg[-1], words)) end

-- Ironing with friction by 40 depths. Each case notes that it has ended. Cases 2 and 6 wait for the file `go`; case 40
-- saves checkpoints, and as long as the file `slow` is there its steps take a second each. Tasks note their process and
-- its parent, which reports to Slurm how the task has ended.
local ironing = [[
local sg = require "signorini"
local options = sg.arguments{ chunk = 4, wait = true, notice = 30, columns = "n force pressure" }
local exists = require "signorini.core".exists
local task = os.getenv "SLURM_ARRAY_TASK_ID"
if task then os.execute("echo $PPID $(ps -o ppid= -p $PPID) >task-" .. task) end
local function solve(case, checkpoint)
  local model = sg.scenes.ironing{ order = "N2", mu = 0.2 }
  while (case.n == 2 or case.n == 6) and not exists "go" do os.execute "sleep 0.1" end
  local long = case.n == 40
  local depth = -0.15 - 0.001 * case.n
  local run = model:run({ { name = "press", steps = 8, grip = {0, depth} },
                          { name = "slide", steps = long and 64 or 4, grip = {0.3, depth} } },
    { checkpoint = long and { file = checkpoint, every = 3 } or nil, resume = long,
      on_step = function() if long and exists "slow" then os.execute "sleep 1" end end })
  local log = io.open("ended", "a")
  log:write(case.n, "\n")
  log:close()
  return { force = run:column "grip.fx"[run.steps], pressure = run:column "interface.max_pressure"[run.steps],
           failed = run.failed }
end
local numbers = {}
for n = 1, 40 do numbers[n] = n end
local study = sg.study{ name = "ironing", cases = sg.grid{ n = numbers }, run = solve }
study:execute{ chunk = options.chunk, at_most = 4, time = "1", memory = "100M", wait = options.wait,
               notice = options.notice }
for _, row in ipairs(study.rows) do
  if not row.failed then print(("%d %a %a"):format(row.n, row.force, row.pressure)) end
end
]]

local function new_folder(script)
  local folder = check.folder()
  core.write_file(folder .. "/study.lua", script)
  return folder
end

local function touch(folder, name) core.write_file(("%s/%s"):format(folder, name), "") end

local function claimed(folder, n)
  return check.shell(("ls %s/out/ironing/cases"):format(folder)):find(("\nn=%d%%-%%x+%%.claim\n"):format(n)) ~= nil
end

--- The lines of a file, sorted.
local function lines(text)
  local list = {}
  for line in text:gmatch "[^\n]+" do list[#list + 1] = line end
  table.sort(list)
  return list
end

local numbered = {}
for n = 1, 40 do numbered[n] = tostring(n) end
table.sort(numbered)

check.case("40 cases, two killed tasks, a drained node, a time limit: the same table, each case done once", function()
  local locally, remotely = new_folder(ironing), new_folder(ironing)
  touch(locally, "go")
  local expected, ok = signorini(locally, "--jobs 2 2>/dev/null")
  check.equal(ok, 0)
  check.equal(#lines(expected), 40)
  touch(remotely, "slow")

  -- A call waits for the job.
  local call = ("'%s' study.lua --on slurm >output 2>errors; echo $? >status"):format(arg[-1])
  check.shell(("(cd '%s' && export %s && %s) >/dev/null 2>&1 & true"):format(remotely, slurm, call))
  check.await("cases 2 and 6", function() return claimed(remotely, 2) and claimed(remotely, 6) end)
  shell(remotely, "scontrol update nodename=n1 state=drain reason=test")
  shell(remotely, "kill -KILL $(cut -d' ' -f1 task-1)")
  shell(remotely, "scancel 1_2")
  check.await("a drained node", function() return shell(remotely, "sinfo -h -n n1 -o %T"):find "^drained" end)
  shell(remotely, "scontrol update nodename=n1 state=resume")
  touch(remotely, "go")
  check.await("the time limit of case 40", function()
    local log = remotely .. "/out/ironing/jobs/1/task-10.log"
    return core.exists(log) and core.read_file(log):find("1 case left: this task returns to the queue", 1, true)
  end)
  check.await("the end of task 10", function()
    return shell(remotely, "ps -o state= -p $(cut -d' ' -f2 task-10)"):find "^[^Z]" == nil -- a zombie may remain
  end)
  os.remove(remotely .. "/slow")
  -- After requeuing Slurm lets tasks wait for two minutes, because the node refuses to start a task in the second in
  -- which it has revoked the task's credential.
  shell(remotely, "scontrol update jobid=1_10 starttime=now+2")
  check.await("the end of the job", function() return core.exists(remotely .. "/status") end)

  -- It tells which cases have been lost; the next one solves them.
  local errors = core.read_file(remotely .. "/errors")
  check.equal(core.read_file(remotely .. "/status"), "1\n")
  check.holds(errors, "ironing: 40 cases in 10 tasks: sbatch --parsable 'out/ironing/jobs/1/job.sh': job 1",
    "6 of 40 cases ended by an error, which makes the exit status 1",
    "n=2: crashed: task 1_1 of Slurm ended before the case was done (FAILED)",
    "n=6: crashed: task 1_2 of Slurm ended before the case was done (CANCELLED)")
  local output
  output, ok = signorini(remotely, "--on slurm 2>errors")
  check.equal(ok, 0)
  check.holds(core.read_file(remotely .. "/errors"), "34 of 40 taken from out/ironing, 6 to solve")
  check.equal(output == expected, true)
  check.equal(lines(core.read_file(remotely .. "/ended")), numbered)
  check.equal(check.shell(("ls -A %s/out/ironing/cases"):format(remotely)):find "claim", nil)
end)

-- Cases that take no time, or as long as the file `hold` is there.
local short = [[
local sg = require "signorini"
local exists = require "signorini.core".exists
local options = sg.arguments{ cases = 6, chunk = 2, wait = true, dry_run = false, partition = "short", act = "print",
                              memory = "100M", time = "5", notice = 120, extra = "--requeue", cores = 1 }
local numbers = {}
for n = 1, options.cases do numbers[n] = n end
local study = sg.study{ name = "a \"short\" study", folder = "out/a 100% b", cases = sg.grid{ n = numbers },
  run = function(case)
    while case.n > 2 and exists "hold" do os.execute "sleep 0.1" end
    return { square = case.n ^ 2 }
  end }
if options.act == "cancel" then
  print(study:cancel())
elseif options.act == "watch" then
  print(#study:watch().rows)
else
  study:execute{ partition = options.partition, chunk = options.chunk, memory = options.memory, time = options.time,
                 notice = options.notice, wait = options.wait, dry_run = options.dry_run, cores = options.cores,
                 extra = { options.extra } }
  if #study.rows > 0 then print(study:table{ columns = { "n", "square" } }) end
end
]]

check.case("dry_run writes the script, submits nothing, and the script works", function()
  local folder = new_folder(short)
  local output, status = signorini(folder, "--on slurm dry_run=yes extra=--ntasks=2")
  check.equal(status, 0)
  check.holds(output, "6 cases in 3 tasks: sbatch --parsable 'out/a 100% b/jobs/1/job.sh'")
  check.holds(core.read_file(folder .. "/out/a 100% b/jobs/1/job.sh"), "#SBATCH --array=1-3%64", "#SBATCH --requeue",
    "#SBATCH --ntasks=2", "#SBATCH --partition=short", "#SBATCH --mem=100M", "#SBATCH --time=5",
    "#SBATCH --cpus-per-task=1")
  check.equal(shell(folder, "squeue -h"), "")
  -- Neither --ntasks nor the step in which sbatch is called makes a task one of several processes of MPI.
  output, status = shell(folder, "SLURM_STEP_NUM_TASKS=4 PMI_SIZE=4 sbatch --wait 'out/a 100% b/jobs/1/job.sh'")
  check.equal(status, 0)
  output, status = signorini(folder, "--on local") -- only gathers
  check.equal(status, 0)
  check.holds(output, "6 of 6 taken from out/a 100% b, 0 solved", "6      36")
end)

check.case("wait = false returns; the job is watched, gathered in part, not submitted again, and cancelled", function()
  local folder = new_folder(short)
  touch(folder, "hold")
  local output, status = signorini(folder, "--on slurm wait=no")
  check.equal(status, 0)
  check.holds(output, "6 cases in 3 tasks")
  check.await("two cases", function()
    output, status = signorini(folder, "--on local")
    check.equal(status, 0)
    return output:find("2 of 6 taken", 1, true)
  end)
  check.holds(output, "4 cases with Slurm, job", "2       4") -- neither solved here
  output, status = signorini(folder, "--on slurm wait=no")
  check.equal(status, 0)
  check.equal(output:find "sbatch", nil)
  output, status = signorini(folder, "act=cancel")
  check.holds(output, "1")
  output = signorini(folder, "act=watch") -- until the job has ended
  check.holds(output, "waiting  begun  done  failed", "6\n") -- those that were cancelled are rows, too
  os.remove(folder .. "/hold")
  output, status = signorini(folder, "--on slurm")
  check.equal(status, 0)
  check.holds(output, "2 of 6 taken", "4 to solve", "6      36")
end)

--- Whether a case of the short study is claimed.
local function begun(folder, n)
  local _, status = check.shell(("ls '%s/out/a 100%% b/cases/n=%d'-*.claim"):format(folder, n))
  return status == 0
end

check.case("a task solves `cores` cases at a time; Ctrl-C ends the waiting only, the same call waits again", function()
  local folder = new_folder(short)
  touch(folder, "hold")
  local call = ("'%s' study.lua --on slurm chunk=6 cores=2"):format(arg[-1])
  local waiting = shell(folder, ("exec %s >output 2>&1 & echo $!"):format(call)):match "%d+"
  check.await("two cases at a time", function() return begun(folder, 3) and begun(folder, 4) end)
  check.equal(begun(folder, 5), false)
  check.shell("kill -INT " .. waiting)
  check.await("the end of waiting", function()
    return check.shell("ps -o state= -p " .. waiting):find "^[^Z]" == nil end)
  check.holds(core.read_file(folder .. "/output"), "no longer waiting; the jobs continue. Hint: the same call waits",
    "study.lua:17: interrupted")
  check.equal(begun(folder, 3) and begun(folder, 4), true)
  os.remove(folder .. "/hold")
  local output, status = shell(folder, call)
  check.equal(status, 0)
  check.holds(output, "6      36")
  check.equal(output:find "sbatch" or output:find "of 6: n=1: ", nil) -- what was done before is not told again
end)

check.case("what cannot be submitted is refused at the user's line, and nothing is submitted", function()
  local folder = new_folder(short)
  for words, message in pairs {
    ["partition=fast"] = "study:execute: Slurm refused the job: error: invalid partition specified: fast",
    ["memory=4000G"] = "Slurm refused the job",
    ["extra=--qos=none --account=none --nonsense"] = "Slurm refused the job",
    ["memory=4GB"] = 'memory must be a number with a unit such as "4G" or "500M"',
    ["time=soon"] = 'time must be a time limit such as "02:00:00" (hours:minutes:seconds)',
    ["time=1"] = "notice must be at most half of time, 30 s, got 120",
    ["extra=qos"] = 'extra[1] must be an option of sbatch such as "--qos=long"',
    ["cases=1001 chunk=1"] = "chunk = 1 makes 1001 tasks, but Slurm's MaxArraySize allows 1000. Hint: chunk = 2",
  } do
    local output, status = signorini(folder, "--on slurm '" .. words:gsub(" (%w+=)", "' '%1") .. "'")
    check.equal(status, 1)
    check.holds(output, message)
    check.holds(output, "study.lua:17")
  end
  local output, status = shell(folder, ("PATH=. '%s' study.lua --on slurm"):format(arg[-1]))
  check.equal(status, 1)
  check.holds(output, "study:execute: the command scontrol of Slurm is not on this machine. Hint: log in where jobs")
  check.equal(shell(folder, "squeue -h"), "")
end)

check.case("tasks report other versions, changed scripts and folders that are not shared", function()
  local folder = new_folder(short)
  local output, status = shell(folder, ("'%s' --on slurm - <study.lua"):format(arg[-1]))
  check.equal(status, 1)
  check.holds(output, "only the studies of a script in a file can be solved elsewhere")
  signorini(folder, "--on slurm dry_run=yes")
  local job = folder .. "/out/a 100% b/jobs/1/job.json"
  local function task(words) return shell(folder, ("'%s' --chunk %s study.lua"):format(arg[-1], words)) end
  output, status = task "elsewhere/job.json:1"
  check.equal(status, 1)
  check.holds(output, "'elsewhere/job.json:1' is not a job of a study. Hint: the folder must be on a disk that all")
  local text = core.read_file(job)
  core.write_file(job, (text:gsub('("version": *)"[^"]*"', '%1"0.0.1"')))
  output, status = task "'out/a 100% b/jobs/1/job.json:1'"
  check.equal(status, 1)
  check.holds(output, "the job was submitted by signorini 0.0.1, but ")
  core.write_file(job, text)
  core.write_file(folder .. "/study.lua", (short:gsub("case.n %^ 2", "case.n ^ 3")))
  output, status = task "'out/a 100% b/jobs/1/job.json:1'"
  check.equal(status, 1)
  check.holds(output, "run changed after the job was submitted")
  core.write_file(folder .. "/study.lua", "print(1)")
  output, status = task "'out/a 100% b/jobs/1/job.json:1'"
  check.equal(status, 1)
  check.holds(output, "the script ended without executing the study of ")
end)

check.case("the task of a node that fails returns to the queue and continues on the other node", function()
  local folder = new_folder(short)
  touch(folder, "hold")
  local output, status = signorini(folder, "--on slurm chunk=6 wait=no")
  check.equal(status, 0)
  check.await("case 3", function() return begun(folder, 3) end)
  local job, node = output:match "job (%d+)", shell(folder, "squeue -h -o %N"):match "n%d"
  -- All of the node's processes end: slurmd, the task's slurmstepd, the task and its case. Slurm would notice after its
  -- SlurmdTimeout.
  local list = shell(folder, ("scontrol listpids %s %s"):format(job, node))
  local task, others = list:match "\n(%d+) +%d+ +batch +0", {}
  for process in list:gmatch "\n(%d+)" do others[#others + 1] = process end
  shell(folder, ("kill -KILL $(cat '%s/slurmd.%s.pid') $(ps -o ppid= -p %s) %s"):format(cluster, node, task,
    table.concat(others, " ")))
  shell(folder, ("scontrol update nodename=%s state=down reason=test"):format(node))
  check.await("the queue", function() return shell(folder, "squeue -h -o '%i %T'") == job .. "_1 PENDING\n" end)
  os.remove(folder .. "/hold")
  shell(folder, ("scontrol update jobid=%s_1 starttime=now+2"):format(job)) -- as above
  output, status = signorini(folder, "--on slurm")
  check.equal(status, 0)
  check.holds(output, "2 of 6 taken", "4 cases with Slurm, job", "6      36")
  check.equal(output:find "sbatch", nil)
  local log = core.read_file(folder .. "/out/a 100% b/jobs/1/task-1.log")
  check.equal(select(2, log:gsub("n=3: done", "")), 1)
end)

check.shell(("'%s/slurm/cluster' stop '%s'"):format(here, cluster))
