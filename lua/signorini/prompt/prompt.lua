-- Results and errors at the prompt (called by src/repl/prompt.cpp), and its variables.

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local show = require "signorini.prompt.show"

local prompt = {}
core.line_locals = {}

--- The global names of Lua, with their values.
prompt.standard = lists.merged(_G)

--- The names that only the prompt defines.
prompt.names = { sg = true, help = true, traceback = true, arg = true, _ = true }

--- The user's variables, by name: new ones, and names of Lua with another value.
function prompt.variables()
  local own = {}
  for name, value in next, _G do
    if type(name) == "string" and not prompt.names[name] and prompt.standard[name] ~= value then own[name] = value end
  end
  return own
end

--- Assigns the first result to `_`, unless it is nil.
function prompt.keep(...)
  if (...) ~= nil then rawset(_G, "_", (...)) end
end

--- Shows a picture that is in no file; returns whether it did.
local function is_shown(value)
  return core.kind(value) == "picture" and not core.picture_file(value)
    and (require("signorini.prompt.display").show(value))
end

--- Shows the results of a line; the first one is then `_`, unless it is nil.
function prompt.results(...)
  if select("#", ...) == 0 then return end
  if select("#", ...) == 1 and ... == core.sg.help then return core.sg.help() end
  prompt.keep(...)
  for i = 1, select("#", ...) do
    local value = select(i, ...)
    if not is_shown(value) then show.print(value) end
  end
end

--- Remembers the names that a line declares as local.
function prompt.note_locals(code)
  for names in code:gmatch "%f[%w_]local +([%w_, ]+)" do
    for name in names:gsub("^function%s+", ""):gmatch "[%a_][%w_]*" do core.line_locals[name] = true end
  end
end

--- After Ctrl-C or the end of --time: `_` is the interrupted run, because the line that would have stored it has ended.
function prompt.interrupted()
  local run = core.interrupted_run
  core.interrupted_run = nil
  local why = core.interruption()
  if not run then return why end
  rawset(_G, "_", run)
  return why .. "; _ is the run so far"
end

--- Shows the traceback of the last error at the prompt.
function prompt.traceback()
  print(core.traceback or "There has been no error.")
end

return prompt
