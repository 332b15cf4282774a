-- A process that solves one chunk of a study's cases, started by another machine (see jobs.lua). It runs the script up
-- to study:execute, which solves the cases of the chunk and ends the program. Other studies that the script executes
-- are only read: what they hold was there when the job was submitted.

local core = require "signorini.core"
local case = require "signorini.study.case"
local counted = require("signorini.call.text").counted
local inputs = require "signorini.study.inputs"
local jobs = require "signorini.study.jobs"
local lists = require "signorini.call.lists"
local slurm = require "signorini.study.slurm"
local store = require "signorini.study.store"
local release = require "signorini.call.release"

local where = "study:execute"
local grace_share = 0.5 -- of the notice, which Slurm may give late; the rest is for ending and requeuing

--- Raises an error unless program, script and values are those with which the job was submitted.
local function check_same(job, now)
  if job.version ~= release then
    core.fail(("%s: the job was submitted by signorini %s, but %s has %s. Hint: install the same version on all "
      .. "machines, or run it from the shared disk"):format(where, job.version, core.host, release))
  end
  local changed = inputs.difference(job.inputs, now)
  if #changed > 0 then
    core.fail(("%s: %s changed after the job was submitted. Hint: study:cancel() and submit again")
      :format(where, table.concat(changed, ", ")))
  end
end

--- How far a case's checkpoint has come: the rows of its run; 0 without one; the hash of a file that no run has saved.
local function saved(study, entry, now)
  local file = store.checkpoint(study, entry, now)
  if not core.exists(file) then return 0 end
  local ok, rows = pcall(function() return #core.unpack(core.checkpoint_text(file))[2] end)
  return ok and rows or core.hash(core.read_file(file))
end

--- True if a checkpoint went on from `before` to `after`. A run that does not resume begins again at each start.
local function went_on(before, after)
  if type(before) == "number" and type(after) == "number" then return after > before end
  return after ~= before
end

--- One start of a task: its study, job, name, inputs `now` and handle of the folder.
local Task = {}
Task.__index = Task

--- The positions of the cases that still have to be solved.
function Task:left()
  return lists.filter(self.chunk, function(i) return not jobs.record(self.job, self.study, self.study.cases[i]) end)
end

function Task:write(entry, record, at_once)
  store.write(self.handle, entry, case.sign(record, self.study, entry, self.now, at_once, self.job.made))
  print(("%s: %s"):format(entry.text, record.reason or record.outcome))
end

--- In the process of a case: what core.jobs passes to Task:keep.
function Task:solve_case(entry)
  if not jobs.claim(self.study, entry, self.name) then return "claimed" end
  if jobs.record(self.job, self.study, entry) then return "done" end
  return core.write_json(case.solve(self.study.run, entry, store.checkpoint(self.study, entry, self.now)))
end

--- Keeps what became of a case that was not stopped.
function Task:keep(entry, text, failure, at_once)
  if text == "claimed" then return end
  if text ~= "done" then self:write(entry, case.record(text, failure, self.job.limit), at_once) end
  jobs.release_claim(self.study, entry)
  if self.handle.full then core.fail(("%s: no space is left for '%s'"):format(where, self.study.folder)) end
end

--- Solves the cases of a list, at_once in parallel. A stopped case keeps its claim, because this task continues it when
--- it starts again.
function Task:solve(list, at_once)
  local entries = lists.map(list, function(i) return self.study.cases[i] end)
  local before = lists.map(entries, function(entry) return saved(self.study, entry, self.now) end)
  local stopped, ended = {}, 0
  core.jobs(#list, at_once, function(k) return self:solve_case(entries[k]) end, function(k, text, failure)
    if failure == "stopped" then
      stopped[#stopped + 1] = k
    else
      ended = ended + 1
      self:keep(entries[k], text, failure, at_once)
    end
  end, self.job.limit, nil, self.job.notice * grace_share)
  self.progress = self.progress + ended
  if ended > 0 then return end
  for _, k in ipairs(stopped) do -- they had a whole start for themselves
    self.progress = self.progress + 1
    local after = saved(self.study, entries[k], self.now)
    if not went_on(before[k], after) then
      local what = after == 0 and "no checkpoint was saved" or "its checkpoint is not further than before"
      local reason = ("not done within the time of a task%s, and %s. Hint: raise time, or save checkpoints and pass "
        .. "resume = true, help \"sg.study\""):format(self.job.time and ", " .. self.job.time or "", what)
      self:write(entries[k], { outcome = "error", reason = reason, results = {}, wall = core.now() }, at_once)
      jobs.release_claim(self.study, entries[k])
    end
  end
end

--- Puts the task back into the queue, to continue with the cases of a list.
local function requeue(list)
  print(counted(#list, "case") .. " left: this task returns to the queue")
  io.stdout:flush()
  core.fail(("%s: Slurm did not requeue the task: %s"):format(where, slurm.requeue()))
end

local function positions(study, chunk)
  local position = {}
  for i, entry in ipairs(study.cases) do position[entry.id] = i end
  return lists.map(chunk, function(id)
    return position[id] or core.fail(("%s: the case %s is no longer in the script"):format(where, id))
  end)
end

--- Solves the chunk of this process and ends it: status 0 when all of its cases are done.
local function run(study, job, number)
  local now = inputs.of(study)
  check_same(job, now)
  local task = setmetatable({ study = study, job = job, now = now, progress = 0,
    chunk = positions(study, job.chunks[number]), name = jobs.task_name(job, number),
    handle = store.share(where, study, ("reserve-%d-%d"):format(job.number, number)) }, Task)
  store.take_reserve(task.handle)
  local ok, message = pcall(function()
    local together, alone = case.split_alone(study, task:left())
    if #together > 0 then task:solve(together, job.cores) end
    if #alone > 0 and not core.notice_given() then task:solve(alone, 1) end
  end)
  store.close(task.handle)
  if not ok then error(message, 0) end
  local rest = task:left()
  if #rest > 0 and core.notice_given() and job.on == "slurm" then
    if task.progress == 0 then
      core.fail(where .. ": the script took the whole time of the task before its first case. Hint: raise time")
    end
    requeue(rest)
  end
  if #rest > 0 then print(counted(#rest, "case") .. " left to other tasks") end
  os.exit(#rest == 0, true)
end

return function(study)
  local job, number = jobs.of_process()
  if study.folder == job.folder then run(study, job, number) end
  study.records = lists.map(study.cases, function(entry) return (store.read(study, entry)) end)
  study:gather()
  if study.on_record then study.on_record() end
  return true
end
