-- Cases that another engine solves (jobs.lua): submits jobs, waits for them, tells what became of cases that they did
-- not solve. Results are the files of the study's folder, as in other executions; engines only tell which tasks are
-- alive.

local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local display = require "signorini.study.display"
local inputs = require "signorini.study.inputs"
local jobs = require "signorini.study.jobs"
local lists = require "signorini.call.lists"
local progress = require "signorini.run.progress"
local store = require "signorini.study.store"

local remote = {}

-- ── Jobs that are alive ──────────────────────────────────────────────────────────────────────────────────────────────

--- What engines know of the tasks of jobs, by the jobs' numbers; nil and a message if one does not answer.
local function states_of(where, open)
  local states = {}
  for _, job in ipairs(open) do
    local tasks, failure = jobs.engine(job).tasks(where, job)
    if not tasks then return nil, failure end
    states[job.number] = tasks
  end
  return states
end

local function is_alive(task) return task.alive end
local function is_unknown(task) return task.unknown end

local function is_running(job, states) return lists.any(states[job.number], is_alive) end

--- True if a task of a job is not known to have ended.
local function may_run(job, states) return is_running(job, states) or lists.any(states[job.number], is_unknown) end

--- The jobs of a study that were not known to have ended, and the states of their tasks.
local function open_jobs(where, study)
  local open = jobs.open(study)
  local states, failure = states_of(where, open)
  if not states then core.fail(("%s: %s"):format(where, failure)) end
  return open, states
end

--- The jobs of a study that are not known to have ended.
function remote.living(where, study)
  local open, states = open_jobs(where, study)
  return lists.filter(open, function(job)
    if may_run(job, states) then return true end
    jobs.finish(job)
    return false
  end)
end

--- The tasks of jobs by their cases' names, lists of { job, number }.
local function tasks_by_case(open)
  local by_case = {}
  for _, job in ipairs(open) do
    for number, chunk in ipairs(job.chunks) do
      for _, id in ipairs(chunk) do
        by_case[id] = by_case[id] or {}
        table.insert(by_case[id], { job = job, number = number })
      end
    end
  end
  return by_case
end

--- The one of a list of tasks that has claimed a case; nil without a claim of theirs.
local function claimer(study, entry, tasks)
  local owner = jobs.claim_owner(study, entry)
  return owner and lists.filter(tasks, function(at) return jobs.task_name(at.job, at.number) == owner end)[1]
end

--- The record of a case whose tasks ended without one: how the one that had claimed it ended, or the last one, and the
--- last line of its log.
local function lost(study, entry, tasks, states)
  local at = claimer(study, entry, tasks) or tasks[#tasks]
  local task, name = states[at.job.number][at.number], jobs.engine(at.job).task_label(at.job, at.number)
  local file, last = ("%s/task-%d.log"):format(at.job.place, at.number), ""
  if task.unknown then
    return { outcome = "crashed", results = {}, reason = ("%s cannot be asked, it may still solve the case (%s). Hint: "
      .. "the same call looks again, study:cancel() gives it up"):format(name, task.state) }
  elseif core.exists(file) then
    last = core.read_file(file):match "([^\n]*)\n*$"
  elseif task.state == "FAILED" then
    last = "it left no log. Hint: the folder must be on a disk that all machines share"
  end
  return { outcome = "crashed", results = {}, reason = ("%s ended before the case was done (%s)%s%s")
    :format(name, task.state, last ~= "" and ": " or "", last) }
end

--- True if one of a list of tasks is going to solve a case. A task that cannot be asked keeps the case that it claimed.
local function is_assigned(study, entry, tasks, states)
  local owner = claimer(study, entry, tasks)
  return lists.any(owner and { owner } or tasks, function(at)
    local task = states[at.job.number][at.number]
    return task.alive or owner and task.unknown
  end)
end

--- The cases of a list that no living task is going to solve, without the claims that dead ones have left; reports what
--- became of the others.
function remote.unassigned(where, study, list, now)
  if #list == 0 then return list end
  local open, states = open_jobs(where, study)
  local running = lists.filter(open, function(job) return may_run(job, states) end)
  for _, job in ipairs(running) do
    local changed = inputs.difference(job.inputs, now)
    if #changed > 0 then
      core.fail(("%s: a job still solves cases of this study (%s), but %s changed after its submission. Hint: "
        .. "study:cancel(), or wait for it"):format(where, jobs.engine(job).label(job), table.concat(changed, ", ")))
    end
  end
  local by_case = tasks_by_case(open)
  local rest = lists.filter(list, function(i)
    local entry = study.cases[i]
    return not is_assigned(study, entry, by_case[entry.id] or {}, states)
  end)
  for _, i in ipairs(rest) do
    local entry = study.cases[i]
    if by_case[entry.id] then
      progress(0):line(("%s: %s: %s"):format(study.name, entry.text,
        lost(study, entry, by_case[entry.id], states).reason))
    end
    jobs.release_claim(study, entry)
  end
  if #rest < #list then
    local labels = lists.map(running, function(job) return jobs.engine(job).label(job) end)
    progress(0):line(("%s: %s with %s"):format(study.name, counted(#list - #rest, "case"), table.concat(labels, "; ")))
  end
  return rest
end

-- ── Submitting ───────────────────────────────────────────────────────────────────────────────────────────────────────

local function check_script(where)
  if (core.script or "") ~= "" and core.script ~= "-" and core.exists(core.script) then return end
  core.fail(where .. ": only the studies of a script in a file can be solved elsewhere, because other machines run it, "
    .. "too. Hint: save it, then signorini study.lua --on slurm")
end

--- Submits the cases of a list, or with dry_run only writes the scripts.
function remote.start(where, study, list, now, again, options)
  if #list == 0 then return end
  check_script(where)
  local function seconds(i)
    local record = store.read(study, study.cases[i])
    return record and record.wall
  end
  local by = jobs.engine(options)
  local packed = by.chunks(where, list, seconds, options)
  local job = jobs.make(study, { on = options.on, chunks = packed, inputs = now, again = again, limit = options.limit,
                                 cores = options.cores, notice = options.notice, time = options.time })
  local line = ("%s: %s in %s: %s"):format(study.name, counted(#list, "case"), counted(#packed, "task"),
    by.prepare(job, options))
  if options.dry_run then return progress(0):line(line) end
  local id, done = by.submit(where, job)
  jobs.begin(job, id)
  progress(0):line(("%s: %s"):format(line, done))
end

-- ── Waiting ──────────────────────────────────────────────────────────────────────────────────────────────────────────

local look_share, soonest_look, latest_look = 0.1, 0.1, 5 -- between looks at the folder: share of the time so far; s
local soonest_question, latest_question = 1, 30           -- between questions to engines, s
local most_silence = 2 -- further questions to machines that do not answer when all other tasks have ended

--- The time between two looks or questions, `since` seconds after the begin.
local function pause(since, soonest, latest) return math.max(soonest, math.min(latest, look_share * since)) end

--- Makes a client of a network file system forget what it knows of the folder of cases, by changing it.
local function refresh(study)
  local file = study.folder .. "/cases/refresh"
  core.write_file(file, "")
  os.remove(file)
end

--- The first record of a case that one of its tasks has made or need not make; nil if there is none yet.
local function record_of(study, entry, tasks)
  local job
  for _, at in ipairs(tasks) do
    local record = at.job ~= job and jobs.record(at.job, study, entry)
    if record then return record end
    job = at.job
  end
end

--- The tasks of the cases of jobs that the study does not have yet, by the cases' positions.
local function pending_cases(study, open)
  local by_case, pending = tasks_by_case(open), {}
  for i, entry in ipairs(study.cases) do
    local tasks = by_case[entry.id]
    local record = tasks and study.records[i] and record_of(study, entry, tasks)
    if record then study.records[i] = record else pending[i] = tasks end
  end
  return pending
end

--- Takes new records of pending cases into the study.
local function take_records(study, pending, tell)
  for i, tasks in pairs(pending) do
    local record = record_of(study, study.cases[i], tasks)
    if record then
      study.records[i], pending[i] = record, nil
      tell(i, record)
    end
  end
end

--- Waits until all jobs of a study have ended, and takes their records into it. tell(i, record) for each new one,
--- look(states, pending) after each look; `states`: the engines' tasks by the jobs' numbers. Returns false after
--- Ctrl-C.
function remote.follow(where, study, look, tell)
  local open = jobs.open(study)
  local pending, began, asked, states, silence, told = pending_cases(study, open), core.now(), nil, {}, 0, nil
  while #open > 0 do
    local since, ended = core.now() - began, false
    if not asked or since - asked > pause(since, soonest_question, latest_question) then
      asked = since
      local known, failure = states_of(where, open)
      if failure and failure ~= told then
        progress(0):line(("%s: %s; waiting continues"):format(study.name, failure))
      end
      states, told = known or states, failure
      local running = not known or lists.any(open, function(job) return is_running(job, known) end)
      local unknown = known and lists.any(open, function(job) return may_run(job, known) end)
      silence = running and 0 or silence + 1
      ended = silence > (unknown and most_silence or 0)
    end
    if ended then refresh(study) end
    take_records(study, pending, tell)
    if ended then break end
    look(states, pending)
    if core.sleep(pause(since, soonest_look, latest_look)) then return false end
  end
  for i, tasks in pairs(pending) do
    study.records[i] = lost(study, study.cases[i], tasks, states)
    tell(i, study.records[i])
  end
  for _, job in ipairs(open) do
    if not may_run(job, states) then jobs.finish(job) end
  end
  return true
end

--- Waits for a study's jobs, with a progress bar.
function remote.wait(where, study)
  local todo = #study.cases - #study.rows
  local bar, look, tell = display(study, todo)
  local whole = remote.follow(where, study, function() look(jobs.count_claims(study)) end,
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
