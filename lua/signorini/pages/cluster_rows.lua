-- The rows of study:execute for cases that other machines solve.

local core = require "signorini.core"
local t = require "signorini.call.types"

local rows = {
  { "on", t.either(t.choice { "local", "slurm" }, t.one_or_more(t.text)), [[where the cases are solved: on
this machine, by Slurm, or on hosts reached by ssh, { "ssh:host1", "ssh:host2" }; --on of the command line takes
precedence]], default = "local" },
  "For Slurm and hosts:",
  { "cores", t.count, "cores of a task or a host, which solves as many cases in parallel", default = 1 },
  { "wait", t.flag, "whether to wait for the jobs; if not, the study has the cases done so far", default = true },
  { "dry_run", t.flag, "whether only to write the script and to print the command that would submit it",
    default = false },
  "For Slurm:",
  { "partition", t.text, "partition", otherwise = "Slurm's default" },
  { "time", t.text, "time limit of a task, as Slurm writes it: \"02:00:00\" or \"1-12\" (days-hours)",
    otherwise = "the partition's" },
  { "memory", t.text, "memory of a task, such as \"4G\"; help \"model:cost\"", otherwise = "the partition's" },
  { "chunk", t.either(t.count, t.choice { "auto" }), [[cases in a task; "auto": chunks of about equal measured cost,
from a minute to half of the time limit, at most four for each task at a time]], default = "auto" },
  { "at_most", t.count, "tasks at a time", default = 64 },
  { "notice", t.positive, [[before the time limit cases are told to end at their next checkpoint, which takes at most
half of this; the task then returns to the queue]], unit = "seconds", default = 120 },
  { "extra", t.list(t.text), "further options of sbatch, such as { \"--qos=long\", \"--exclusive\" }", default = {} },
}

--- What is wrong with the values of these rows; nil if nothing is.
function rows.conflict(given)
  for _, host in ipairs(type(given.on) == "table" and given.on or {}) do
    if not host:find "^ssh:[^%s%-,][^%s,]*$" then
      return ('on must be "local", "slurm" or hosts such as { "ssh:host1" }, got %s'):format(core.describe(host))
    end
  end
  local seconds = given.time and require("signorini.study.slurm").seconds(given.time)
  if given.time and not seconds then
    return ('time must be a time limit such as "02:00:00" (hours:minutes:seconds), got %s'):format(
      core.describe(given.time))
  end
  if seconds and given.notice > seconds / 2 then
    return ("notice must be at most half of time, %g s, got %g. Hint: raise time, or lower notice"):format(seconds / 2,
      given.notice)
  end
  if given.memory and not given.memory:find "^%d+[KMGT]?$" then
    return ('memory must be a number with a unit such as "4G" or "500M", got %s'):format(core.describe(given.memory))
  end
  for i, word in ipairs(given.extra) do
    if not word:find "^%-%-?%a" or word:find "\n" then
      return ('extra[%d] must be an option of sbatch such as "--qos=long", got %s'):format(i, core.describe(word))
    end
  end
end

return rows
