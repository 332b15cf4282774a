-- What the prompt does with results and errors (src/repl/prompt.cpp calls these).

local core = require "signorini.core"
local show = require "signorini.show"

local prompt = {}

--- Shows the results of a line; the first one is `_` from then on.
function prompt.results(...)
  if select("#", ...) == 0 then return end
  rawset(_G, "_", (...))
  show.print(...)
end

core.docs.traceback = [[
traceback()
Shows where the last error at the prompt came about: the functions that were being called.]]
function prompt.traceback()
  print(core.traceback or "There has been no error.")
end

return prompt
