-- Cases that Slurm solves: submits jobs, waits for them, tells what became of cases that they did not solve. Results
-- are the files of the study's folder, as in other executions; Slurm only tells which tasks are alive.

local core = require "signorini.core"
local chunks = require "signorini.study.chunks"
local claims = require "signorini.study.claims"
local counted = require "signorini.counted"
local display = require "signorini.study.display"
local inputs = require "signorini.study.inputs"
local jobs = require "signorini.study.jobs"
local lists = require "signorini.lists"
local progress = require "signorini.progress"
local slurm = require "signorini.study.slurm"
local store = require "signorini.study.store"

local remote = {}

-- ── Jobs that are alive ──────────────────────────────────────────────────────────────────────────────────────────────

local function ids_of(open) return lists.map(open, function(job) return job.id end) end

local function task_name(job, number) return ("%s_%d"):format(job.id, number) end

--- Whether a task of a job is alive, given what Slurm knows.
local function is_running(job, tasks)
  for number in ipairs(job.chunks) do
    if slurm.is_alive(tasks[task_name(job, number)]) then return true end
  end
  return false
end

--- The jobs of a study that were not known to have ended, and what Slurm knows of their tasks.
local function open_jobs(where, study)
  local open = jobs.open(study)
  if #open == 0 then return open, {} end
  local tasks, failure = slurm.tasks(where, ids_of(open))
  if not tasks then core.fail(("%s: Slurm does not answer: %s"):format(where, failure)) end
  return open, tasks
end

--- The jobs of a study that are alive.
function remote.living(where, study)
  local open, tasks = open_jobs(where, study)
  return lists.filter(open, function(job)
    if is_running(job, tasks) then return true end
    jobs.finish(job)
    return false
  end)
end

--- The record of a case whose task ended without one: how, and the last line of its log.
local function lost(job, number, task)
  local state, file, last = task and task.state or "unknown to Slurm", ("%s/task-%d.log"):format(job.place, number), ""
  if core.exists(file) then
    last = core.read_file(file):match "([^\n]*)\n*$"
  elseif state == "FAILED" then
    last = "it left no log. Hint: the folder must be on a disk that all machines share"
  end
  return { outcome = "crashed", results = {}, reason = ("task %s of Slurm ended before the case was done (%s)%s%s")
    :format(task_name(job, number), state, last ~= "" and ": " or "", last) }
end

--- The cases of a list that no living task is going to solve, without the claims that dead ones have left; reports what
--- became of the others.
function remote.unassigned(where, study, list, now)
  if #list == 0 then return list end
  local open, tasks = open_jobs(where, study)
  local assigned, dead = {}, {}
  for _, job in ipairs(open) do
    local changed = inputs.difference(job.inputs, now)
    if #changed > 0 and is_running(job, tasks) then
      core.fail(("%s: Slurm's job %s still solves cases of this study, but %s changed after its submission. "
        .. "Hint: study:cancel(), or wait for it"):format(where, job.id, table.concat(changed, ", ")))
    end
    for number, chunk in ipairs(job.chunks) do
      local task = tasks[task_name(job, number)]
      for _, id in ipairs(chunk) do
        if slurm.is_alive(task) then assigned[id] = true else dead[id] = lost(job, number, task).reason end
      end
    end
  end
  local rest = lists.filter(list, function(i) return not assigned[study.cases[i].id] end)
  for _, i in ipairs(rest) do
    local entry = study.cases[i]
    claims.release(study, entry)
    if dead[entry.id] then progress(0):line(("%s: %s: %s"):format(study.name, entry.text, dead[entry.id])) end
  end
  if #rest < #list then
    progress(0):line(("%s: %s with Slurm, job %s"):format(study.name, counted(#list - #rest, "case"),
      table.concat(ids_of(lists.filter(open, function(job) return is_running(job, tasks) end)), ", ")))
  end
  return rest
end

-- ── Submitting ───────────────────────────────────────────────────────────────────────────────────────────────────────

local function check_script(where)
  if (core.script or "") ~= "" and core.script ~= "-" and core.exists(core.script) then return end
  core.fail(where .. ": only the studies of a script in a file can be solved elsewhere, because other machines run it, "
    .. "too. Hint: save it, then signorini study.lua --on slurm")
end

--- Submits the cases of a list, or with dry_run only writes the script.
function remote.start(where, study, engine, list, now, again, options)
  if #list == 0 then return end
  check_script(where)
  local function seconds(i)
    local record = store.read(study, study.cases[i])
    return record and record.wall
  end
  local most = slurm.most_tasks(where)
  local packed = chunks.pack(list, seconds, { size = options.chunk, slots = options.at_most, most = most,
    limit = options.time and slurm.seconds(options.time) })
  if #packed > most then
    core.fail(("%s: chunk = %d makes %d tasks, but Slurm's MaxArraySize allows %d. Hint: chunk = %d, or \"auto\"")
      :format(where, options.chunk, #packed, most, math.ceil(#list / most)))
  end
  local job = jobs.make(study, { on = engine, chunks = packed, inputs = now, again = again, limit = options.limit,
                                 cores = options.cores, notice = options.notice, time = options.time })
  local script = job.place .. "/job.sh"
  core.write_file(script, slurm.script(job, options), true)
  local line = ("%s: %s in %s: sbatch --parsable '%s'"):format(study.name, counted(#list, "case"),
    counted(#packed, "task"), script)
  if options.dry_run then return progress(0):line(line) end
  local id = slurm.submit(where, script)
  jobs.begin(job, id)
  progress(0):line(("%s: job %s"):format(line, id))
end

-- ── Waiting ──────────────────────────────────────────────────────────────────────────────────────────────────────────

local look_share, soonest_look, latest_look = 0.1, 0.1, 5 -- between looks at the folder: share of the time so far; s
local soonest_question, latest_question = 1, 30           -- between questions to Slurm, s

--- The time between two looks or questions, `since` seconds after the begin.
local function pause(since, soonest, latest) return math.max(soonest, math.min(latest, look_share * since)) end

--- Makes a client of a network file system forget what it knows of the folder of cases, by changing it.
local function refresh(study)
  local file = study.folder .. "/cases/refresh"
  core.write_file(file, "")
  os.remove(file)
end

--- The cases of jobs by position: { job, number (of the chunk) }.
local function pending_cases(study, open)
  local position, pending = {}, {}
  for i, entry in ipairs(study.cases) do position[entry.id] = i end
  for _, job in ipairs(open) do
    for number, chunk in ipairs(job.chunks) do
      for _, id in ipairs(chunk) do
        local i = position[id]
        if i then pending[i] = { job = job, number = number } end
      end
    end
  end
  return pending
end

--- Takes new records of pending cases into the study.
local function take_records(study, pending, tell)
  for i, at in pairs(pending) do
    local record = jobs.record(at.job, study, study.cases[i])
    if record then
      study.records[i], pending[i] = record, nil
      tell(i, record)
    end
  end
end

--- Waits until all jobs of a study have ended, and takes their records into it. tell(i, record) for each new one,
--- look(tasks, pending) after each look; `tasks` as of slurm.tasks. Returns false after Ctrl-C.
function remote.follow(where, study, look, tell)
  local open = jobs.open(study)
  local pending, began, asked, tasks = pending_cases(study, open), core.now(), nil, {}
  while #open > 0 do
    local since, ended = core.now() - began, false
    if not asked or since - asked > pause(since, soonest_question, latest_question) then
      asked = since
      local known = slurm.tasks(where, ids_of(open)) -- nil while Slurm is too busy to answer
      tasks = known or tasks
      ended = known and not lists.any(open, function(job) return is_running(job, known) end)
    end
    if ended then refresh(study) end
    take_records(study, pending, tell)
    if ended then break end
    look(tasks, pending)
    if core.sleep(pause(since, soonest_look, latest_look)) then return false end
  end
  for i, at in pairs(pending) do
    study.records[i] = lost(at.job, at.number, tasks[task_name(at.job, at.number)])
    tell(i, study.records[i])
  end
  for _, job in ipairs(open) do jobs.finish(job) end
  return true
end

--- Waits for a study's jobs, with a progress bar.
function remote.wait(where, study)
  local todo = #study.cases - #study.rows
  local bar = progress(todo)
  local look, tell = display(bar, study, todo)
  local whole = remote.follow(where, study, function() look(claims.count(study)) end,
    function(i, record) tell(study.cases[i], record) end)
  bar:clear()
  study:gather()
  if not whole then
    io.stderr:write(("%s: no longer waiting; the jobs continue. Hint: the same call waits again, study:cancel() ends "
      .. "them\n"):format(study.name))
  end
  return whole
end

return remote
