-- One case of a study, solved in its own process, and its record: what the process returned, or how it ended, with what
-- this depends on and where it was made.

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local release = require "signorini.call.release"

local case = {}

local function reject(entry, what, cure)
  core.fail(("sg.study: case %s: %s%s"):format(entry.text, what, cure and ". Hint: " .. cure or ""))
end

local function read_results(entry, results)
  if type(results) ~= "table" then
    reject(entry, ("run returned %s"):format(results == nil and "nothing" or core.describe(results)),
      "return a table of results such as { wall = run.wall }")
  end
  for name, value in next, results do
    if type(name) ~= "string" then
      reject(entry, ("a result has no name but %s"):format(core.describe(name)), "write name = value")
    end
    if name == "outcome" then reject(entry, "a result cannot be called 'outcome', a column of every case") end
    if entry.case[name] ~= nil then reject(entry, ("the result '%s' has the name of a parameter"):format(name)) end
    local ok, message = pcall(core.write_json, value, "the result " .. name) -- finite numbers, plain data
    if not ok then
      reject(entry, tostring(message):gsub("^.-:%d+: ", "", 1):gsub(": only .*$", ""),
        "results are finite numbers, strings, or lists of these; return nil for unknown ones, or failed = true with "
        .. "a reason")
    end
  end
  local failed, reason = rawget(results, "failed"), rawget(results, "reason") -- rawget: for contact profiles
  if failed ~= nil and type(failed) ~= "boolean" then
    reject(entry, "failed must be true or false, got " .. core.describe(failed))
  end
  if reason ~= nil and type(reason) ~= "string" then
    reject(entry, "reason must be a string, got " .. core.describe(reason))
  end
  return failed, reason
end

--- Solves the case of an entry (see cases.lua) with a file for checkpoints: { results, outcome = "done" or "failed",
--- reason, wall (s) }.
function case.solve(run, entry, checkpoint)
  local copy = core.read_json(core.write_json(entry.case)) -- run may change it
  local began = core.now()
  local results = run(copy, checkpoint)
  local wall = core.now() - began
  local failed, reason = read_results(entry, results)
  local record = { outcome = failed and "failed" or "done", reason = reason, wall = wall, results = {} }
  for name, value in next, results do
    if name ~= "failed" and name ~= "reason" then record.results[name] = value end
  end
  return record
end

--- The record of a case from the result of its process, or from how this ended.
function case.record(text, failure, limit)
  if text then return core.read_json(text) end
  if failure == "time" then
    return { outcome = "time", reason = ("not done within %g s"):format(limit), wall = limit, results = {} }
  end
  local message = failure:match "^failed: (.*)$"
  local first = message and message:match "^[^\n]*" or failure
  if failure:find "signal 9" then first = first .. ": killed from outside, possibly because memory ran out" end
  return { outcome = message and "error" or "crashed", reason = first, traceback = message, results = {} }
end

--- Adds the study, the case, its inputs and where it was made; `job`: what names the job, if any.
function case.sign(record, study, entry, now, at_once, job)
  record.study, record.case, record.inputs = study.name, entry.case, now
  record.made = { versions = lists.merged(core.versions, { signorini = release }), host = core.host,
                  processor = core.processor, time = os.date "!%Y-%m-%dT%H:%M:%SZ", at_once = at_once, job = job }
  return record
end

--- The cases of a list of positions that may run in parallel, and those that must run alone.
function case.split_alone(study, list)
  local together, alone = {}, {}
  for _, i in ipairs(list) do
    local asks = study.sequential
    if type(asks) == "function" then asks = asks(study.cases[i].case) end
    table.insert(asks and alone or together, i)
  end
  return together, alone
end

return case
