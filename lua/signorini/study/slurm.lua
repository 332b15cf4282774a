-- Slurm, an engine (jobs.lua), by its commands: sbatch, squeue, scontrol, scancel. None needs its accounting
-- database.

local core = require "signorini.core"
local chunks = require "signorini.study.chunks"
local jobs = require "signorini.study.jobs"
local lists = require "signorini.call.lists"
local quoted = require("signorini.call.text").quoted

local slurm = {}

--- What a command of Slurm writes, and whether it succeeded; raises an error where Slurm is not installed.
local function call(where, words)
  local pipe = io.popen(table.concat(lists.map(words, quoted), " ") .. " 2>&1 </dev/null")
  local output = pipe:read "a"
  local ok, _, status = pipe:close()
  if status == 127 then
    core.fail(("%s: the command %s of Slurm is not on this machine. Hint: log in where jobs are submitted; --on local "
      .. "solves cases here, study:read() reads those that are done"):format(where, words[1]))
  end
  return output, ok
end

--- The seconds of a time limit as Slurm reads it: minutes, minutes:seconds, hours:minutes:seconds, days-hours,
--- days-hours:minutes or days-hours:minutes:seconds; nil for other texts.
function slurm.seconds(text)
  local days, rest = text:match "^(%d+)%-(.+)$"
  local parts = {}
  for part in ((rest or text) .. ":"):gmatch "(%d+):" do parts[#parts + 1] = tonumber(part) end
  if table.concat(parts, ":"):gsub("%d+", "0") ~= (rest or text):gsub("%d+", "0") or #parts > 3 or #parts == 0 then
    return nil
  end
  local a, b, c = parts[1], parts[2] or 0, parts[3] or 0
  if days then return ((tonumber(days) * 24 + a) * 60 + b) * 60 + c end
  if #parts == 3 then return (a * 60 + b) * 60 + c end
  return a * 60 + b
end

--- The largest number of tasks of an array.
local function most_tasks(where)
  local output = call(where, { "scontrol", "show", "config" })
  return tonumber(output:match "MaxArraySize%s*=%s*(%d+)" or 1001) - 1 -- the largest index is one less
end

function slurm.chunks(where, list, seconds, options)
  local most = most_tasks(where)
  local packed = chunks.pack(list, seconds, { size = options.chunk, slots = options.at_most, most = most,
    limit = options.time and slurm.seconds(options.time) })
  if #packed <= most then return packed end
  core.fail(("%s: chunk = %d makes %d tasks, but Slurm's MaxArraySize allows %d. Hint: chunk = %d, or \"auto\"")
    :format(where, options.chunk, #packed, most, math.ceil(#list / most)))
end

local function script_of(job) return job.place .. "/job.sh" end

--- Writes the script of an array with one task per chunk. It becomes the program, which therefore gets Slurm's signals.
--- It forgets the step of several processes in which sbatch may have been called, because the program refuses to be one
--- of several.
function slurm.prepare(job, options)
  local log = job.place:gsub('[\\"]', "\\%0"):gsub("%%", "%%%%") .. "/task-%a.log"
  local words = { ("--job-name=%s"):format(job.study:gsub("[^%w.=+()-]+", "_")),
                  ("--array=1-%d%%%d"):format(#job.chunks, options.at_most),
                  ('--output="%s"'):format(log), "--open-mode=append", "--requeue",
                  ("--signal=B:USR1@%d"):format(math.ceil(options.notice)),
                  ("--cpus-per-task=%d"):format(options.cores) }
  for option, value in pairs { partition = options.partition, time = options.time, mem = options.memory } do
    words[#words + 1] = ("--%s=%s"):format(option, value)
  end
  table.sort(words)
  local directives = lists.map(lists.joined(words, options.extra), function(word)
    return "#SBATCH " .. word .. "\n"
  end)
  core.write_file(script_of(job), ("#!/bin/sh\n%sunset SLURM_STEP_NUM_TASKS PMI_SIZE\n%s\n"):format(
    table.concat(directives), jobs.command(job, '"$SLURM_ARRAY_TASK_ID"')), true)
  return ("sbatch --parsable '%s'"):format(script_of(job))
end

function slurm.submit(where, job)
  local output, ok = call(where, { "sbatch", "--parsable", script_of(job) })
  local id = ok and output:match "(%d+)[^\n]*\n*$"
  if id then return id, "job " .. id end
  core.fail(("%s: Slurm refused the job: %s"):format(where, (output:gsub("^sbatch: ", ""):gsub("%s*\n%s*", "; ")
    :gsub("[; ]*$", ""))))
end

local ended = { "BOOT_FAIL", "CANCELLED", "COMPLETED", "DEADLINE", "FAILED", "NODE_FAIL", "OUT_OF_MEMORY", "REVOKED",
                "TIMEOUT" }

--- The tasks that Slurm still knows; those that it has forgotten have ended.
function slurm.tasks(where, job)
  local output, ok = call(where, { "squeue", "--noheader", "--array", "--states=all", "--jobs=" .. job.id,
                                   "--format=%i|%T|%r" })
  if not ok and not output:find "Invalid job id" then
    return nil, "Slurm does not answer: " .. output:gsub("%s+$", "")
  end
  local tasks = {}
  for number in ipairs(job.chunks) do tasks[number] = { state = "unknown to Slurm", alive = false } end
  for number, state, why in (ok and output or ""):gmatch "_(%d+)|([^|\n]*)|([^|\n]*)" do
    tasks[tonumber(number)] = { state = state, alive = not lists.holds(ended, state),
                                why = state == "PENDING" and why ~= "None" and why or nil }
  end
  return tasks
end

function slurm.cancel(where, job)
  local output, ok = call(where, { "scancel", job.id })
  if not ok then core.fail(("%s: Slurm did not cancel job %s: %s"):format(where, job.id, output)) end
end

function slurm.label(job) return "Slurm, job " .. job.id end

function slurm.task_label(job, number) return ("task %s_%d of Slurm"):format(job.id, number) end

--- Puts the task of this process back into the queue and waits until Slurm ends the process, whose exit status could
--- otherwise be taken for that of the next start. Returns why it could not. The number SLURM_JOB_ID of an array's last
--- task is that of the whole array.
function slurm.requeue()
  local task = ("%s_%s"):format(os.getenv "SLURM_ARRAY_JOB_ID", os.getenv "SLURM_ARRAY_TASK_ID")
  local output, ok = call("study:execute", { "scontrol", "requeue", task })
  return ok and not core.sleep(60) and "it did not end this process" or output
end

return slurm
