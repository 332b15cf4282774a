-- %run file arguments: runs a script as `signorini file arguments` does. It sees neither variables nor modules of the
-- prompt, so that edited modules are read again; afterwards its global variables are those of the prompt, too.

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local meant = require("signorini.call.text").meant
local prompt = require "signorini.prompt.prompt"
local scripts = require "signorini.prompt.help.scripts"

--- The words of a line; quotation marks enclose one that has blanks.
local function words_of(line)
  local words, at = {}, line:match "^%s*()"
  while at <= #line do
    local word, quoted = "", nil
    while at <= #line and (quoted or not line:find("^%s", at)) do
      local letter = line:sub(at, at)
      if letter == quoted then
        quoted = nil
      elseif not quoted and letter:find "[\"']" then
        quoted = letter
      else
        word = word .. letter
      end
      at = at + 1
    end
    if quoted then core.fail(("%%run: a quotation mark %s is not closed"):format(quoted)) end
    words[#words + 1], at = word, line:match("^%s*()", at)
  end
  return words
end

--- The file of a name, which may omit ".lua": in the present folder or below it, or a supplied script.
local function find(name)
  name = name:gsub("^~/", function() return (os.getenv "HOME" or "~") .. "/" end)
  for _, file in ipairs { name, name .. ".lua" } do
    local path = core.find_script(file)
    if core.exists(path) and not core.exists(path .. "/.") then return path end
  end
  local listed, files = pcall(core.list_folder, name:match "^(.*/)[^/]*$" or ".")
  local own = lists.filter(listed and files or {}, function(file) return file:find "%.lua$" ~= nil end)
  local known = lists.joined(own, lists.map(scripts.all(), function(script) return script.name end))
  local hint = meant(name:match "[^/]*$", known)
  core.fail(("%%run: there is no script '%s'%s Hint: Tab completes names of files; paths begin in %s")
    :format(name, hint == "" and "." or hint, core.directory))
end

local function is_library(module) return module:find "^signorini%f[.\0]" ~= nil or rawget(_G, module) ~= nil end

local own_folder = "" -- what the last script has added to package.path

--- Modules next to the script are found after the library, as when it is run from the command line.
local function set_path(script)
  local begin, finish = package.path:find(own_folder, 1, true)
  if own_folder ~= "" and begin then
    package.path = package.path:sub(1, begin - 1) .. package.path:sub(finish + 1)
  end
  own_folder = (script:match "^(.*)/[^/]*$" or ".") .. "/?.lua;"
  package.path = package.path:gsub("^[^;]*;", function(library) return library .. own_folder end)
end

--- Replaces variables, modules and arguments by those of a new program. Returns what restores them; variables and
--- modules of the script remain.
local function begin_program(script, arguments)
  local variables, modules, exit = lists.merged(_G), lists.merged(package.loaded), os.exit
  local script_before, arguments_before = core.script, core.arguments
  for name in next, variables do rawset(_G, name, prompt.standard[name]) end
  for name in next, modules do
    if not is_library(name) then package.loaded[name] = nil end
  end
  set_path(script)
  core.script, core.arguments = script, arguments
  arg = lists.merged(arguments, { [0] = script, [-1] = core.program })
  return setmetatable({}, { __close = function()
    local of_prompt = lists.merged(prompt.standard, prompt.names)
    for name, value in next, variables do
      if rawget(_G, name) == nil or of_prompt[name] ~= nil then rawset(_G, name, value) end
    end
    for name, module in next, modules do package.loaded[name] = package.loaded[name] or module end
    os.exit, core.script, core.arguments = exit, script_before, arguments_before
  end })
end

--- Raised by os.exit in the script, which ends the script and not the prompt.
local Exit = {}

--- An error whose traceback is stored already.
local Told = { without_traceback = true, __tostring = function(told) return told.text end }

local function note_traceback(problem)
  local own = type(problem) == "table" and getmetatable(problem)
  if own == Exit or type(own) == "table" and own.without_traceback then return problem end
  core.traceback = debug.traceback(tostring(problem), 2)
  return setmetatable({ text = tostring(problem) }, Told)
end

--- Runs a function and returns its first result, or nothing if it calls os.exit.
local function result_of(f, arguments)
  os.exit = function(status) error(setmetatable({ status = status }, Exit), 0) end
  local ok, result = xpcall(f, note_traceback, table.unpack(arguments))
  if ok then return result end
  if type(result) ~= "table" or getmetatable(result) ~= Exit then error(result, 0) end
  local status = result.status
  if status == false then status = 1 end
  if math.type(status) == "integer" and status ~= 0 then print("exit status " .. status) end
end

return function(line)
  local arguments = words_of(line)
  if #arguments == 0 then core.fail "%run must be followed by the name of a script. Hint: %run study.lua steps=10" end
  local script = find(table.remove(arguments, 1))
  local program, message = loadfile(script, "t")
  if not program then error(message, 0) end
  local result
  do
    local _ <close> = begin_program(script, arguments)
    result = result_of(program, arguments)
  end
  prompt.keep(result)
end
