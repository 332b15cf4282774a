-- Jobs of a study that other machines solve: <folder>/jobs/<number> holds job.json (what is to be solved, by which
-- program), scripts, one log per task, and `id`, the engine's numbers of the job, as long as the job may be alive.
--
-- Engines, which solve the cases of a study elsewhere: Slurm (slurm.lua) and hosts that are reached by ssh (ssh.lua).
-- Each has these functions:
--   chunks(where, list, seconds, options)  the chunks of a list of cases, one for each task; see chunks.lua
--   prepare(job, options)                  writes the job's scripts; returns the command that submits them
--   submit(where, job)                     submits them; returns the engine's numbers of the job as a text, which
--                                          becomes job.id, and what it did, in words
--   tasks(where, job)                      { state, why, alive, unknown } by the tasks' numbers; `unknown`: its machine
--                                          does not answer; nil and a message if the engine does not answer
--   cancel(where, job)                     ends the tasks
--   label(job), task_label(job, number)    their names in messages

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local missing = require "signorini.study.missing"
local quoted = require("signorini.call.text").quoted
local store = require "signorini.study.store"
local release = require "signorini.call.release"

local jobs = {}

local function read_job(file) return core.read_json(core.read_file(file)) end

local function numbers(study)
  local folder = study.folder .. "/jobs"
  local list = lists.map(core.exists(folder) and core.list_folder(folder) or {}, function(name)
    return tonumber(name)
  end)
  table.sort(list)
  return list
end

local function place_of(study, number) return ("%s/jobs/%d"):format(study.folder, number) end

--- A new job with its folder: the entries of `plan`, the study, the script and the program; `made` names it in records.
--- chunks: lists of cases' positions, saved as their names.
function jobs.make(study, plan)
  local known = numbers(study)
  local number = (known[#known] or 0) + 1
  local place = place_of(study, number)
  local chunks = lists.map(plan.chunks, function(chunk)
    return lists.map(chunk, function(i) return study.cases[i].id end)
  end)
  local job = lists.merged(plan, {
    study = study.name, folder = study.folder, number = number, place = place, chunks = chunks,
    version = release, program = core.program, script = core.script, arguments = core.arguments,
    directory = core.directory, made = ("%d of %s"):format(number, os.date "!%Y-%m-%dT%H:%M:%SZ") })
  core.mkdir(place)
  core.write_file(place .. "/job.json", core.write_json(job))
  return job
end

--- The command of the shell that solves a chunk of a job; `chunk`: its number for the shell.
function jobs.command(job, chunk)
  local words = lists.map(lists.joined({ job.script }, job.arguments), quoted)
  return ("cd %s || exit 1\nexec %s -q --chunk %s:%s %s"):format(quoted(job.directory), quoted(job.program),
    quoted(job.place .. "/job.json"), chunk, table.concat(words, " "))
end

--- The job and the chunk of --chunk.
function jobs.of_process()
  local file, number = core.chunk:match "^(.*):(%d+)$"
  local ok, job = pcall(read_job, file)
  if not ok then
    core.fail(("--chunk: '%s' is not a job of a study. Hint: the folder must be on a disk that all machines share")
      :format(core.chunk))
  end
  return job, tonumber(number)
end

--- The name of a task in claims.
function jobs.task_name(job, number) return ("chunk %d of job %s"):format(number, job.made) end

--- Notes the engine's numbers of a job, which makes it one that may be alive.
function jobs.begin(job, id) core.write_file(job.place .. "/id", id, true) end

--- Notes that a job has ended.
function jobs.finish(job) os.rename(job.place .. "/id", job.place .. "/ended") end

--- The jobs that were not known to have ended, each with its `id`.
function jobs.open(study)
  local list = {}
  for _, number in ipairs(numbers(study)) do
    local place = place_of(study, number)
    if core.exists(place .. "/id") then
      list[#list + 1] = lists.merged(read_job(place .. "/job.json"), { id = core.read_file(place .. "/id") })
    end
  end
  return list
end

--- The record of a case that a job has made or need not make; nil if there is none yet.
function jobs.record(job, study, entry)
  local record = store.read(study, entry)
  if not record then return nil end
  local own = (record.made or {}).job == job.made
  local valid = own or not job.again[entry.id] and not missing.outdated(entry, record, job.inputs, job.limit)
  return valid and record or nil
end

--- The place named by --on: "slurm", "local", or a list of hosts.
function jobs.place(text)
  if not text:find "^ssh:" then return text end
  local hosts = {}
  for host in text:gmatch "[^,]+" do hosts[#hosts + 1] = host end
  return hosts
end

--- The engine of a job.
function jobs.engine(job)
  return type(job.on) == "table" and require "signorini.study.ssh" or require "signorini.study.slurm"
end

-- ── Claims ───────────────────────────────────────────────────────────────────────────────────────────────────────────

-- Claims of cases on a shared disk: one task solves a case, whatever machines the tasks are on. The claim of a case is
-- the file cases/<case>.claim, which names its task; the file system lets only one task create it. Tasks remove it when
-- the case is done. The claim of a task that has died remains until no living task is going to solve the case
-- (remote.lua), or until the same task starts again.

local function claim_file(study, entry) return ("%s/cases/%s.claim"):format(study.folder, entry.id) end

--- The name of the task that has claimed a case; nil without a claim.
function jobs.claim_owner(study, entry)
  local ok, owner = pcall(core.read_file, claim_file(study, entry)) -- it may be released at any time
  return ok and owner or nil
end

--- True if the task of this name got the claim of a case, now or in an earlier start of it. The case may have been done
--- meanwhile: look after the claim.
function jobs.claim(study, entry, name)
  return core.create_claim(claim_file(study, entry), name) or jobs.claim_owner(study, entry) == name
end

function jobs.release_claim(study, entry) os.remove(claim_file(study, entry)) end

--- How many cases are claimed.
function jobs.count_claims(study)
  return #lists.filter(core.list_folder(study.folder .. "/cases"), function(name) return name:find "%.claim$" end)
end

return jobs
