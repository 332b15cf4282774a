-- Hosts without a scheduler, by ssh: on each a process solves cases of the study until none is left. All processes have
-- all cases; which one solves a case is decided when it begins, by its claim (jobs.lua). User names, keys and ports
-- come from ~/.ssh/config.

local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local jobs = require "signorini.study.jobs"
local lists = require "signorini.call.lists"
local quoted = require("signorini.call.text").quoted

local ssh = {}

-- Errors only; never ask for a password; three attempts of ten seconds; notice a connection that has died.
local command = "ssh -o LogLevel=ERROR -o BatchMode=yes -o ConnectTimeout=10 -o ConnectionAttempts=3 "
  .. "-o ServerAliveInterval=10"
local no_connection = 255 -- exit status of ssh

local function name_of(place) return (place:gsub("^ssh:", "")) end

--- Calls ssh for several hosts at the same time. lines[k]: the rest of the command for host k, nil for none. Returns
--- what they write, and their exit status.
local function call(where, on, lines)
  local pipes, outputs, statuses = {}, {}, {}
  for k, line in pairs(lines) do
    pipes[k] = io.popen(("%s %s %s 2>&1"):format(command, quoted(name_of(on[k])), line))
  end
  for k, pipe in pairs(pipes) do
    outputs[k] = pipe:read "a"
    local _, _, status = pipe:close()
    statuses[k] = status
    if status == 127 and outputs[k]:find "ssh:? " then
      core.fail(("%s: ssh is not on this machine: %s"):format(where, outputs[k]))
    end
  end
  return outputs, statuses
end

local function one_line(text) return (text:gsub("%s*[\r\n]+%s*", "; "):gsub("[; ]*$", "")) end

local function script_of(job, number) return ("%s/host-%d.sh"):format(job.place, number) end

function ssh.chunks(_, list, _, options)
  return lists.map(options.on, function() return list end)
end

-- ── Starting ─────────────────────────────────────────────────────────────────────────────────────────────────────────

local script = [[
cd %s 2>/dev/null && [ -f %s ] ||
  { echo 'it does not see the folder '%s'. Hint: it must be on a disk that all hosts share'; exit 1; }
found=$(%s --version 2>&1)
[ "$found" = %s ] ||
  { echo 'it does not have '%s' as '%s": $found. Hint: install the same version on all hosts"; exit 1; }
setsid sh -c %s >>%s 2>&1 </dev/null &
echo "process $!"
]]

function ssh.prepare(job)
  local version = quoted("signorini " .. job.version)
  return table.concat(lists.map(job.on, function(place, number)
    core.write_file(script_of(job, number), script:format(quoted(job.directory), quoted(job.place .. "/job.json"),
      quoted(job.directory .. "/" .. job.place), quoted(job.program), version, version, quoted(job.program),
      quoted(jobs.command(job, number)), quoted(("%s/task-%d.log"):format(job.place, number))), true)
    return ("ssh %s sh <'%s'"):format(name_of(place), script_of(job, number))
  end), "; ")
end

--- The hosts that cannot take part are reported, and are an error only if there is no other one.
function ssh.submit(where, job)
  local lines, processes, failures = {}, {}, {}
  for number in ipairs(job.on) do lines[number] = "sh <" .. quoted(script_of(job, number)) end
  local outputs = call(where, job.on, lines)
  for number, place in ipairs(job.on) do
    local process = outputs[number]:match "process (%d+)\n"
    processes[number] = process or "0"
    if not process then failures[#failures + 1] = ("%s: %s"):format(name_of(place), one_line(outputs[number])) end
  end
  local started = #job.on - #failures
  if started == 0 then
    core.fail(("%s: no host could be used:\n  %s"):format(where, table.concat(failures, "\n  ")))
  end
  for _, failure in ipairs(failures) do io.stderr:write(("signorini: %s: %s\n"):format(job.study, failure)) end
  return table.concat(processes, " "), ("started on %d of %s"):format(started, counted(#job.on, "host"))
end

-- ── Afterwards ───────────────────────────────────────────────────────────────────────────────────────────────────────

--- The numbers of a job's processes; 0 for those that were not started.
local function processes_of(job)
  local processes = {}
  for process in job.id:gmatch "%d+" do processes[#processes + 1] = math.tointeger(process) end
  return processes
end

function ssh.tasks(where, job)
  local lines, tasks = {}, {}
  for number, process in ipairs(processes_of(job)) do
    if process > 0 then
      lines[number] = ("ps -ww -o args= -p %d"):format(process)
    else
      tasks[number] = { state = "not started", alive = false }
    end
  end
  local outputs, statuses = call(where, job.on, lines)
  for number, output in pairs(outputs) do
    if statuses[number] == no_connection then
      local state = one_line(output)
      tasks[number] = { state = state, why = state, alive = false, unknown = true }
    else -- another process may have got the number after the host has been started again
      local alive = output:find(("--chunk %s/job.json:%d "):format(job.place, number), 1, true) ~= nil
      tasks[number] = { state = alive and "running" or "no longer running", alive = alive }
    end
  end
  return tasks
end

--- Hosts that do not answer are reported and given up, together with the job.
function ssh.cancel(where, job)
  local processes, lines, given_up = processes_of(job), {}, false
  for number, task in ipairs(ssh.tasks(where, job)) do
    if task.alive then lines[number] = ("kill -TERM -%d"):format(processes[number]) end -- with those of its cases
    if task.unknown then
      given_up = true
      io.stderr:write(("signorini: %s: %s does not answer, and may still solve cases: %s\n"):format(job.study,
        name_of(job.on[number]), task.state))
    end
  end
  call(where, job.on, lines)
  if given_up then jobs.finish(job) end
end

function ssh.label(job) return table.concat(lists.map(job.on, name_of), ", ") end

function ssh.task_label(job, number) return "the process on " .. name_of(job.on[number]) end

return ssh
