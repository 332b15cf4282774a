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

local engine = {}

--- The place named by --on: "slurm", "local", or a list of hosts.
function engine.place(text)
  if not text:find "^ssh:" then return text end
  local hosts = {}
  for host in text:gmatch "[^,]+" do hosts[#hosts + 1] = host end
  return hosts
end

--- The engine of a job.
function engine.of(job)
  return type(job.on) == "table" and require "signorini.study.ssh" or require "signorini.study.slurm"
end

return engine
