-- Progress of an execution, on the terminal or line by line.

local core = require "signorini.core"
local progress = require "signorini.run.progress"

local function outcome_text(record)
  if record.outcome == "done" then return ("%.1f s"):format(record.wall) end
  return ("%s: %s"):format(record.outcome, (record.reason or "no reason given"):match "^[^\n]*")
end

--- The bar of an execution of `todo` cases, and two functions, look(running) and tell(entry, record).
return function(study, todo)
  local bar, all, ended, failed = progress(todo), #study.cases, 0, 0
  local function done() return all - todo + ended end
  local function look(running)
    bar:draw(study.name, done() / all, ("%d of %d done, %d failed, %d running, %s"):format(done(), all, failed, running,
      bar:to_go(ended / todo)))
  end
  return bar, look, function(entry, record)
    ended = ended + 1
    if record.outcome ~= "done" then failed = failed + 1 end
    if record.outcome ~= "done" or not (core.terminal or core.replace_text) then
      bar:line(("%s: %d of %d: %s: %s"):format(study.name, done(), all, entry.text, outcome_text(record)))
    end
    if ended == todo then look(0) end
  end
end
