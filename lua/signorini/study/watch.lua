-- study:watch and study:cancel: the jobs of a study.

local core = require "signorini.core"
local format_table = require("signorini.output.table").text
local jobs = require "signorini.study.jobs"
local lists = require "signorini.call.lists"
local progress = require "signorini.run.progress"
local remote = require "signorini.study.remote"
local store = require "signorini.study.store"

local function check_whole(where, study)
  if study.cases then return store.check(where, study) end
  core.fail(where .. ": this is a part of a study, which has no jobs. Hint: take the study from which it was taken")
end

--- The state of all cases in one row: waiting, begun by a task that may be in the queue again, done, failed, the time
--- left at the present rate, and what tasks wait for.
local function state_of(study, states, pending, bar, todo)
  local waiting, failed, done, why = 0, 0, 0, {}
  for _ in pairs(pending) do waiting = waiting + 1 end
  local begun = math.min(waiting, jobs.count_claims(study))
  for i in ipairs(study.cases) do
    local record = study.records[i]
    if record and record.outcome == "done" then done = done + 1 elseif record then failed = failed + 1 end
  end
  for _, tasks in pairs(states) do
    for _, task in ipairs(tasks) do why[#why + 1] = task.why end
  end
  return { waiting - begun, begun, done, failed, bar:to_go((todo - waiting) / todo),
           table.concat(lists.unique(why), ", ") }
end

local columns = { "waiting", "begun", "done", "failed", "time", "waits for" }

local function watch(study)
  local where = "study:watch"
  check_whole(where, study)
  study:read()
  local todo = #study.cases - #study.rows
  local bar, shown = progress(todo), nil
  local function draw(states, pending)
    local row = state_of(study, states, pending, bar, todo)
    local key = table.concat(row, " ", 1, 4) .. row[6]
    if key == shown or core.quiet then return end
    local text = format_table { columns = columns, rows = { row } }
    -- A terminal shows one table, which is drawn again in its place.
    local above = shown and core.terminal and ("\27[%dA\27[J"):format(select(2, text:gsub("\n", "\n")) + 1) or ""
    shown = key
    io.stderr:write(above, text, "\n")
  end
  if remote.follow(where, study, draw, function() end) then draw({}, {}) end
  study:gather()
  return study
end

--- The jobs remain open until their tasks have ended, which may take a minute.
local function cancel(study)
  local where = "study:cancel"
  check_whole(where, study)
  local open = remote.living(where, study)
  for _, job in ipairs(open) do jobs.engine(job).cancel(where, job) end
  return #open
end

return { watch = watch, cancel = cancel }
