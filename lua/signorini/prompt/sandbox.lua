-- The language inside --sandbox. The kernel confines the process (src/os/sandbox.hpp); this second wall keeps scripts
-- from what could corrupt the program's memory (binary chunks, libraries in C, signorini.core) or the library (its
-- modules, the functions of debug), and says clearly what starts programs. It is built before the first other module is
-- loaded.

local core = require "signorini.core"

local load_text, load_file, search, path = load, loadfile, package.searchpath, package.path
local library, everywhere = path:match "^[^;]*", require

local function copy(of)
  local entries = {}
  for name, value in next, of do entries[name] = value end
  return entries
end

-- What the library sees as globals: functions as they are now, so that a script that replaces them does not change its
-- checks, all of debug, and its own modules, which scripts cannot reach.
local modules = { ["signorini.core"] = core }
local own = { debug = debug, string = copy(string), table = copy(table), math = copy(math), utf8 = copy(utf8) }
own.package = setmetatable({ loaded = modules }, { __index = package })
getmetatable("").__index = setmetatable(copy(string), { __index = string })
getmetatable("").__metatable = false

--- The library's require: its modules are text in its folder, run once with `own`.
function own.require(name)
  if name ~= "signorini" and not name:find "^signorini%." then return everywhere(name) end
  if modules[name] == nil then
    local file = assert(search(name, library))
    local module = assert(load_file(file, "t", own))(name, file)
    modules[name] = module == nil and true or module
  end
  return modules[name]
end
core.require = own.require

-- What scripts may load: the library, and what lines of the prompt such as %run call.
local offered = { signorini = true, ["signorini.prompt.commands"] = true }

--- The scripts' require.
function require(name)
  if offered[name] then return own.require(name) end
  if type(name) == "string" and name:find "^signorini%." then
    core.fail(("require: '%s' is a part of the library, which scripts in the sandbox (--sandbox) cannot load"):format(
      name))
  end
  return everywhere(name)
end

--- Loads modules as Lua's searcher does, from text only.
local function find(name)
  local file, message = search(name, package.path)
  if not file then return message end
  local module, problem = load_file(file, "t")
  if not module then error(("error loading module '%s' from file '%s':\n\t%s"):format(name, file, problem), 0) end
  return module, file
end

package.searchers = { package.searchers[1], find }
package.cpath, package.loadlib = "", nil
package.preload["signorini.core"], package.loaded["signorini.core"] = nil, nil
package.loaded["signorini.prompt.sandbox"] = nil

-- Binary chunks are refused whatever mode is asked for.
function load(chunk, name, _, ...) return load_text(chunk, name, "t", ...) end
function loadfile(file, _, ...) return load_file(file, "t", ...) end
function dofile(file)
  local chunk, problem = load_file(file, "t")
  if not chunk then error(problem, 0) end
  return chunk()
end

debug = { traceback = debug.traceback }
package.loaded.debug = debug

--- A function that fails at the user's line.
local function refused(name, reason)
  return core.offered(function()
    core.fail(("%s is not available in the sandbox (--sandbox): %s"):format(name, reason))
  end)
end
local starts = "no programs are started there"
os.execute, io.popen = refused("os.execute", starts), refused("io.popen", starts)
local files = ("use io.open with a name in the folder '%s'"):format(core.sandbox)
os.tmpname, io.tmpfile = refused("os.tmpname", files), refused("io.tmpfile", files)

for name, value in next, _G do
  if type(value) == "function" and name ~= "print" and name ~= "require" then own[name] = value end
end
setmetatable(own, { __index = _G, __newindex = _G })
own.require "signorini.call.strict"
