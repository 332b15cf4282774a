-- The record of a case: what its process returned, or how this ended, with what it depends on and where it was made.

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local release = require "signorini.call.release"

local record = {}

--- The record of a case from the result of its process, or from how this ended.
function record.of(text, failure, limit)
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
function record.sign(one, study, entry, now, at_once, job)
  one.study, one.case, one.inputs = study.name, entry.case, now
  one.made = { versions = lists.merged(core.versions, { signorini = release }), host = core.host,
               processor = core.processor, time = os.date "!%Y-%m-%dT%H:%M:%SZ", at_once = at_once, job = job }
  return one
end

return record
