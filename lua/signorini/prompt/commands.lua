-- Commands among the lines of the prompt or of a notebook's cell, which are not valid Lua: %time, %who, %run, %help,
-- !ls, ?name and name?. Each becomes a call on the same line, so that errors keep their line, and local variables of
-- other lines remain visible.

local core = require "signorini.core"
local lists = require "signorini.call.lists"

local commands = {}

-- ── The commands ─────────────────────────────────────────────────────────────────────────────────────────────────────

--- Commands with %: the form and what it does, for %help.
local known = {
  { "%time <code>", "runs an expression or a statement and shows its wall-clock time and processor time" },
  { "%who", "lists the variables with their types" },
  { "%run <file> <arguments>", "runs a script in a fresh state and takes over its global variables; _ is its result" },
  { "%help", "lists the commands" },
}

local names = lists.map(known, function(entry) return entry[1]:match "%a+" end)
table.sort(names)

--- The names of the commands with %, for Tab.
function commands.names() return names end

local function list_commands()
  for _, entry in ipairs(known) do print(("  %-26s%s"):format(entry[1], entry[2])) end
  print(("  %-26s%s"):format("?<name>, <name>?", "shows help on a name, a variable, a field or an argument"))
  print(("  %-26s%s"):format("!<command>", "runs a command of the shell"))
end

local function without_arguments(name, arguments)
  if arguments ~= "" then core.fail(("%%%s has no arguments, got '%s'"):format(name, arguments)) end
end

--- Runs a command with %, except %time.
function commands.execute(name, arguments)
  if name == "run" then return require "signorini.prompt.commands.run_script"(arguments) end
  without_arguments(name, arguments)
  if name == "who" then return require "signorini.prompt.commands.who"() end
  list_commands()
end

function commands.shell(command) require "signorini.prompt.commands.shell"(command) end
function commands.help(query) require("signorini.prompt.help").ask(query) end

local wall, processor

--- Starts the time of %time.
function commands.start() wall, processor = core.now(), os.clock() end

--- Prints the times since start() and returns the further arguments.
function commands.timed(_, ...)
  print(("wall-clock time %.3g s, processor time %.3g s"):format(core.now() - wall, os.clock() - processor))
  return ...
end

-- ── Translation ──────────────────────────────────────────────────────────────────────────────────────────────────────

local module = 'require"signorini.prompt.commands"'

local function is_known(name) return lists.holds(names, name) end

--- The command in a line: its name and the text after it, or nil. In further lines % may be Lua's modulo, so that only
--- known names are commands there.
local function command_of(line, is_first)
  local sign, text = line:match "^%s*([%%?!])(.*)$"
  if sign == "%" then
    local name, arguments = text:match "^(%S*)%s*(.-)%s*$"
    if is_first or is_known(name) then return name == "" and "help" or name, arguments end
  elseif sign then
    return sign, text:match "^%??%s*(.-)%s*$"
  end
  local asked = line:match "^%s*([%a_][%w_.:]*)%s*%?%??%s*$" or is_first and line:match "^%s*help%s+(%a[%w_.:]*)%s*$"
  if asked then return "?", asked end
end

--- True if code lacks only its end.
local function is_unfinished(code)
  local statements, message = load(code, "=prompt", "t")
  if statements or not message:find "<eof>$" then return false end
  return load("return " .. code, "=prompt", "t") == nil
end

local function call(name, ...)
  local arguments = {}
  for i, text in ipairs { ... } do arguments[i] = ("%q"):format(text) end
  return ("%s.%s(%s)"):format(module, name, table.concat(arguments, ", "))
end

--- The code of %time before an expression or a statement.
local function timed(code)
  if not code:find "%S" then
    core.fail "%time must be followed by an expression or a statement. Hint: %time model:run(path)"
  end
  local start, after = module .. ".start()", code:find("--", 1, true) and "\n" or " " -- behind a comment
  local expression = code:gsub("[%s;]+$", ""):gsub("^%s*return%f[^%w_]", "")
  if load(("return %s\n"):format(expression), "=prompt", "t") then
    return ("%s.timed(%s, %s%s)"):format(module, start, expression, after)
  end
  if is_unfinished(code) then return start .. "; " .. code end
  return ("%s; %s%s%s.timed()"):format(start, code, after, module)
end

local function translated(name, text)
  if name == "?" then return call("help", text) end
  if name == "!" then return call("shell", text) end
  if not is_known(name) then
    local meant = core.nearest(name, names)
    core.fail(("unknown command '%%%s'%s Hint: %%help lists the commands"):format(name,
      meant and ("; did you mean '%%%s'?"):format(meant) or "."))
  end
  return call("execute", name, text)
end

--- Code with its commands as calls. Raises an error for unknown commands.
function commands.translate(code)
  local lines, done, before, i = {}, {}, "", 1 -- before: Lua since the last command
  for line in (code .. "\n"):gmatch "([^\n]*)\n" do lines[#lines + 1] = line end
  while i <= #lines do
    local name, text = command_of(lines[i], i == 1)
    if not name or is_unfinished(before) then
      done[#done + 1], before = lines[i], before .. lines[i] .. "\n"
    else
      while name == "time" and i < #lines and is_unfinished(text) do
        i = i + 1
        text = text .. "\n" .. lines[i]
      end
      done[#done + 1], before = name == "time" and timed(text) or translated(name, text), ""
    end
    i = i + 1
  end
  return table.concat(done, "\n")
end

return commands
