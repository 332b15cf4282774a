-- study:execute: solves the missing cases, each in its own process, and keeps each result as soon as it is there.

local core = require "signorini.core"
local counted = require "signorini.counted"
local inputs = require "signorini.study.inputs"
local outcomes = require "signorini.study.outcomes"
local progress = require "signorini.progress"
local solve_case = require "signorini.study.case"
local store = require "signorini.study.store"
local values = require "signorini.study.values"

local where = "study:execute"

-- ── Which cases to solve ─────────────────────────────────────────────────────────────────────────────────────────────

--- Why a record is out of date; nil if it is not.
local function outdated(entry, record, now, limit)
  if not values.same(record.case, entry.case) then return "a parameter changed" end
  local changed = inputs.difference(record.inputs or {}, now)
  if #changed > 0 then return table.concat(changed, ", ") .. " changed" end
  if outcomes.is_error(record.outcome) then return "it ended by an error" end
  if record.outcome == "time" and (not limit or limit > record.wall) then return "the time limit was raised" end
end

--- Whether `rerun` selects a row.
local function is_wanted(again, row)
  if type(again) == "function" then return again(row) end
  return again == true or again == "failed" and row.failed
end

--- The message at the start: how many cases are taken from the folder, and why others are solved again.
local function words_on(study, missing, reasons, older)
  local finished, words = #study.cases - #missing, {}
  for why, count in pairs(reasons) do words[#words + 1] = ("%d because %s"):format(count, why) end
  table.sort(words)
  local again = #words > 0 and "; again: " .. table.concat(words, "; ") or ""
  if finished == 0 and again == "" then return nil end
  local version = older > 0 and (" (%d by another version than %s)"):format(older, core.versions.signorini) or ""
  return ("%s: %d of %d taken from %s%s, %s%s"):format(study.name, finished, #study.cases, study.folder, version,
    #missing > 0 and #missing .. " to solve" or "0 solved", again)
end

--- The positions of the cases to solve, and the message about those solved before.
local function missing(study, now, limit, again)
  local list, reasons, older = {}, {}, 0
  for i, entry in ipairs(study.cases) do
    local record, damaged = store.read(study, entry)
    local why = damaged and "the file cannot be read" or record and outdated(entry, record, now, limit)
    if record and not why and is_wanted(again, study:row_of(entry, record)) then why = "rerun requests it" end
    if why then reasons[why] = (reasons[why] or 0) + 1 end
    if record and not why then
      study.records[i] = record
      if ((record.made or {}).versions or {}).signorini ~= core.versions.signorini then older = older + 1 end
    else
      list[#list + 1] = i
    end
  end
  return list, words_on(study, list, reasons, older)
end

--- Cases that may run in parallel, and those that must run alone.
local function split_alone(study, list)
  local together, alone = {}, {}
  for _, i in ipairs(list) do
    local asks = study.sequential
    if type(asks) == "function" then asks = asks(study.cases[i].case) end
    table.insert(asks and alone or together, i)
  end
  return together, alone
end

-- ── Solving them ─────────────────────────────────────────────────────────────────────────────────────────────────────

--- The record of a case from the result of its process, or from how this ended.
local function finished(text, failure, limit)
  if text then return core.read_json(text) end
  if failure == "time" then
    return { outcome = "time", reason = ("not done within %g s"):format(limit), wall = limit, results = {} }
  end
  local message = failure:match "^failed: (.*)$"
  local first = message and message:match "^[^\n]*" or failure
  if failure:find "signal 9" then first = first .. ": killed from outside, possibly because memory ran out" end
  return { outcome = message and "error" or "crashed", reason = first, traceback = message, results = {} }
end

local function outcome_text(record)
  if record.outcome == "done" then return ("%.1f s"):format(record.wall) end
  return ("%s: %s"):format(record.outcome, (record.reason or "no reason given"):match "^[^\n]*")
end

--- Progress of the execution, on the terminal or line by line: two functions, look(running) and case(entry, record).
local function display(bar, study, todo)
  local all, ended, failed = #study.cases, 0, 0
  local function done() return all - todo + ended end
  return function(running)
    bar:draw(study.name, done() / all, ("%d of %d done, %d failed, %d running, %s"):format(done(), all, failed, running,
      bar:to_go(ended / todo)))
  end, function(entry, record)
    ended = ended + 1
    if record.outcome ~= "done" then failed = failed + 1 end
    if record.outcome ~= "done" or not core.terminal then
      bar:line(("%s: %d of %d: %s: %s"):format(study.name, done(), all, entry.text, outcome_text(record)))
    end
  end
end

--- Runs the cases of a list, at_once in parallel; keep(case's number, record, at_once), look(cases running). Returns
--- whether all were solved.
local function run_cases(study, list, at_once, limit, look, keep)
  return core.jobs(#list, at_once, function(k)
    return core.write_json(solve_case(study.run, study.cases[list[k]]))
  end, function(k, text, failure)
    keep(list[k], finished(text, failure, limit), at_once)
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

--- Reports the state of an execution that Ctrl-C has stopped.
local function tell_interrupted(study)
  local done, all = #study.rows, #study.cases
  io.stderr:write(("%s: interrupted: %d of %s %s %s\n"):format(study.name, done, counted(all, "case"),
    (done == 1 or all == 1) and "is" or "are",
    study.folder and "saved; the same call continues with the others" or "done"))
end

--- Runs the missing cases; `handle`: of the locked folder. Returns whether all were done, not interrupted by Ctrl-C.
local function run_missing(study, handle, options)
  local now = inputs.of(study)
  for i, record in pairs(study.unsaved) do
    store.write(handle, study.cases[i], record)
    study.unsaved[i] = nil
  end
  local list, words = missing(study, now, options.limit, options.rerun)
  if study.on_record then study.on_record() end
  if #list > 0 and core.ranks > 0 then
    core.fail(("%s: cases run in forked processes, which MPI does not support. Hint: run the study without mpirun, or "
      .. "one case without sg.study"):format(handle.where))
  end
  if #list > 0 then store.take_reserve(handle) end
  local bar = progress(#list)
  local look, tell = display(bar, study, #list)
  if words then bar:line(words) end
  local function keep(i, record, at_once)
    record.study, record.case, record.inputs = study.name, study.cases[i].case, now
    record.made = { versions = core.versions, host = core.host, processor = core.processor,
                    time = os.date "!%Y-%m-%dT%H:%M:%SZ", at_once = at_once }
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
  local together, alone = split_alone(study, list)
  local whole = run_cases(study, together, options.jobs or core.at_once, options.limit, look, keep)
  whole = whole and run_cases(study, alone, 1, options.limit, look, keep)
  bar:clear()
  tell_errors(study)
  return whole
end

--- Executes a study for the function named in errors: { jobs, limit, again }, checked. Returns false after Ctrl-C.
local function execute(name, study, options)
  local handle = store.open(name, study)
  study.records = {}
  local ok, result = pcall(run_missing, study, handle, options)
  store.close(handle)
  study:gather()
  if not ok then error(result, 0) end
  if not result then tell_interrupted(study) end
  return result
end

local function method(study, options)
  if not study.cases then
    core.fail(where .. ": this is a part of a study, which has results only. Hint: execute the study from which it was "
      .. "taken")
  end
  if not execute(where, study, options) then core.fail "interrupted" end
  return study
end

return { method = method, execute = execute }
