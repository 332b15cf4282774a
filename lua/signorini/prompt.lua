-- What the prompt does with results and errors (src/repl/prompt.cpp calls these).

local core = require "signorini.core"
local show = require "signorini.show"

local prompt = {}
core.line_locals = {}

--- Shows the results of a line; the first one is `_` from then on, unless it is nil.
function prompt.results(...)
  if select("#", ...) == 0 then return end
  if select("#", ...) == 1 and ... == core.sg.help then return core.sg.help() end
  if (...) ~= nil then rawset(_G, "_", (...)) end
  show.print(...)
end

--- Remembers which names a line declares as local.
function prompt.note_locals(code)
  for names in code:gmatch "%f[%w_]local +([%w_, ]+)" do
    for name in names:gsub("^function%s+", ""):gmatch "[%a_][%w_]*" do core.line_locals[name] = true end
  end
end

--- What Ctrl-C leaves: the run that it has stopped is `_`, as the line that would have kept it has come to its end,
--- too.
function prompt.interrupted()
  local run = core.interrupted_run
  core.interrupted_run = nil
  if not run then return "interrupted" end
  rawset(_G, "_", run)
  return "interrupted; _ is the run so far"
end

--- Shows where the last error at the prompt came about.
function prompt.traceback()
  print(core.traceback or "There has been no error.")
end

return prompt
