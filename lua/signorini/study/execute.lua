-- study:execute: solves the missing cases, each in its own process, and keeps each result as soon as it is there; or
-- has other machines solve them (remote.lua).

local core = require "signorini.core"
local case = require "signorini.study.case"
local counted = require("signorini.call.text").counted
local display = require "signorini.study.display"
local inputs = require "signorini.study.inputs"
local lists = require "signorini.call.lists"
local missing = require "signorini.study.missing"
local outcomes = require "signorini.study.outcomes"
local progress = require "signorini.run.progress"
local store = require "signorini.study.store"

local where = "study:execute"

--- Runs the cases of a list, at_once in parallel; keep(case's number, record, at_once), look(cases running). Returns
--- whether all were solved.
local function run_cases(study, list, at_once, now, limit, look, keep)
  return core.jobs(#list, at_once, function(k)
    local entry = study.cases[list[k]]
    return core.write_json(case.solve(study.run, entry, store.checkpoint(study, entry, now)))
  end, function(k, text, failure)
    keep(list[k], case.record(text, failure, limit), at_once)
  end, limit, look)
end

--- Reports how many cases ended by errors, also in a quiet run, and sets the exit status to 1, because a mistake in the
--- script must not look like a result.
local function tell_errors(study)
  local count, first = 0, nil
  for i in ipairs(study.cases) do
    local record = study.records[i]
    if record and outcomes.is_error(record.outcome) then count, first = count + 1, first or i end
  end
  if count == 0 then return end
  core.lost_cases = true
  local words = "signorini: %s: %d of %s ended by an error, which makes the exit status 1; the first one, %s: %s\n"
  io.stderr:write(words:format(study.name, count, counted(#study.cases, "case"), study.cases[first].text,
    study.records[first].reason))
end

local function tell_interrupted(study)
  local done, all = #study.rows, #study.cases
  io.stderr:write(("%s: interrupted: %d of %s %s %s\n"):format(study.name, done, counted(all, "case"),
    (done == 1 or all == 1) and "is" or "are",
    study.folder and "saved; the same call continues with the others" or "done"))
end

--- The positions of the cases to solve, and by name those whose valid record `rerun` rejects.
local function find_missing(study, handle, now, options)
  for i, record in pairs(study.unsaved) do
    store.write(handle, study.cases[i], record)
    study.unsaved[i] = nil
  end
  local list, words, again = missing.find(study, now, options.limit, options.rerun)
  if study.on_record then study.on_record() end
  if words then progress(0):line(words) end
  return list, again
end

--- Runs the missing cases here; `handle`: of the locked folder. Returns whether all were done, not interrupted by
--- Ctrl-C.
local function run_missing(study, handle, options)
  local now = inputs.of(study)
  local list = find_missing(study, handle, now, options)
  if #list > 0 and study.folder and core.exists(study.folder .. "/jobs") then
    list = require "signorini.study.remote".unassigned(where, study, list, now)
  end
  if #list > 0 and core.ranks > 0 then
    core.fail(("%s: cases run in forked processes, which MPI does not support. Hint: run the study without mpirun, or "
      .. "one case without sg.study"):format(handle.where))
  end
  if #list > 0 then store.take_reserve(handle) end
  local bar, look, tell = display(study, #list)
  local function keep(i, record, at_once)
    case.sign(record, study, study.cases[i], now, at_once)
    study.records[i], study.unsaved[i] = record, record
    store.write(handle, study.cases[i], record)
    study.unsaved[i] = nil
    if study.on_record then study.on_record() end
    if handle.full then
      core.fail(("%s: no space is left for '%s'. Hint: free some and execute again; finished cases are saved")
        :format(handle.where, study.folder))
    end
    tell(study.cases[i], record)
  end
  local together, alone = case.split_alone(study, list)
  local whole = run_cases(study, together, options.jobs or core.at_once, now, options.limit, look, keep)
  whole = whole and run_cases(study, alone, 1, now, options.limit, look, keep)
  bar:clear()
  return whole
end

--- Calls work(handle) with the locked folder of a study, then gathers its rows; returns its results.
local function with_folder(name, study, work)
  local handle = store.open(name, study)
  study.records = {}
  local result = table.pack(pcall(work, handle))
  store.close(handle)
  study:gather()
  if not result[1] then error(result[2], 0) end
  return table.unpack(result, 2, result.n)
end

--- Executes a study for the function named in errors: { jobs, limit, rerun }, checked. Returns false after Ctrl-C.
local function execute(name, study, options)
  if core.chunk and study.folder then return require "signorini.study.task"(study) end
  local whole = with_folder(name, study, function(handle) return run_missing(study, handle, options) end)
  tell_errors(study)
  if not whole then tell_interrupted(study) end
  return whole
end

--- Has the missing cases solved elsewhere. Returns false after Ctrl-C.
local function execute_elsewhere(study, options)
  local remote = require "signorini.study.remote"
  with_folder(where, study, function(handle)
    local now = inputs.of(study)
    local list, again = find_missing(study, handle, now, options)
    remote.start(where, study, remote.unassigned(where, study, list, now), now, again, options)
  end)
  if options.dry_run or not options.wait then return true end
  local whole = remote.wait(where, study)
  tell_errors(study)
  return whole
end

local function method(study, options)
  if not study.cases then
    core.fail(where .. ": this is a part of a study, which has results only. Hint: execute the study from which it was "
      .. "taken")
  end
  local on = core.on and require("signorini.study.jobs").place(core.on) or options.on
  local here = core.chunk or on == "local"
  if not here and core.sandbox then
    core.fail(where .. [[: on must be "local" in the sandbox (--sandbox), from which no other machine is reached. ]]
      .. "Hint: leave out on")
  end
  local whole
  if here then
    whole = execute(where, study, options)
  else
    whole = execute_elsewhere(study, lists.merged(options, { on = on }))
  end
  if not whole then core.fail(core.interruption()) end
  return study
end

return { method = method, execute = execute }
