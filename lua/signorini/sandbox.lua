-- The language inside --sandbox. The kernel confines the process (src/base/sandbox.hpp); this second wall keeps scripts
-- from what could corrupt the program's memory (binary chunks, libraries in C) or the library (the functions of debug),
-- and says clearly what starts programs. It is built before the first other module is loaded.

local core = require "signorini.core"

local load_text, load_file, search, path = load, loadfile, package.searchpath, package.path
local library = path:match "^[^;]*"

-- The library has all functions of debug; scripts cannot reach this table.
local own = setmetatable({ debug = debug }, { __index = _G, __newindex = _G })

--- Loads modules as Lua's searcher does, from text only; those of the library see `own`.
local function find(name)
  local file = search(name, library)
  if file then return load_file(file, "t", own), file end
  local message
  file, message = search(name, package.path)
  if not file then return message end
  local module, problem = load_file(file, "t")
  if not module then error(("error loading module '%s' from file '%s':\n\t%s"):format(name, file, problem), 0) end
  return module, file
end

package.searchers = { package.searchers[1], find }
package.cpath, package.loadlib = "", nil

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
