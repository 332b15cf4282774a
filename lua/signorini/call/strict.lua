-- Reading an undefined variable is an error in every script, so that a misspelled name is not read as nil.

local core = require "signorini.core"

--- The names that are visible where a function is called: its local variables, its upvalues, and the globals.
local function names_in_sight(level)
  local names = {}
  local function add(get, of)
    for i = 1, math.huge do
      local name = get(of, i)
      if not name then return end
      names[#names + 1] = name
    end
  end
  add(debug.getlocal, level + 2)
  add(debug.getupvalue, debug.getinfo(level + 1, "f").func)
  for name in next, _G do names[#names + 1] = tostring(name) end
  return names
end

local function cure(name, level)
  if name == "sg" then return [[; write local sg = require "signorini" at the top]] end
  if name == "help" then return "; in a script it is sg.help, with local sg = require \"signorini\"" end
  if name == "True" or name == "False" or name == "None" then return "; Lua writes true, false and nil" end
  if name == "exit" or name == "quit" then
    return "; alone on a line it ends the prompt; os.exit() ends a script"
  end
  if name == "_" then return "; at the prompt it is the last result, once there is one" end
  if core.line_locals and core.line_locals[name] then
    return core.front_end and "; it was local to its cell: leave out `local`"
      or "; it was local to its line: leave out `local` at the prompt"
  end
  return require("signorini.call.text").meant(name, names_in_sight(level + 1))
end

setmetatable(_G, {
  __index = function(_, name)
    error(("undefined variable '%s'%s"):format(name, cure(tostring(name), 2)), 2)
  end,
})
