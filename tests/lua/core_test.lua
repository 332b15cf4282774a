-- The functions of the program that the Lua part calls: each one exists.

local core = require "signorini.core"
local check = require "check"

check.case("every name of core in the Lua part is registered or assigned there", function()
  local used = {}
  -- after an error; the options --on, --chunk and --sandbox; what a notebook offers (src/repl/kernel.cpp)
  local assigned = { traceback = true, on = true, chunk = true, sandbox = true, front_end = true }
  for file in io.popen(("find '%s/lua' -name '*.lua'"):format(core.home)):lines() do
    local text = core.read_file(file)
    for name in text:gmatch "%f[%w_.]core%.([%a_][%w_]*)" do used[name] = file end
    for name in text:gmatch "%f[%w_.]core%.([%a_][%w_]*)%s*=[^=]" do assigned[name] = true end
  end
  check.equal(used.fail ~= nil, true)
  for name, file in pairs(used) do
    if core[name] == nil and not assigned[name] then
      error(("%s uses core.%s, which does not exist"):format(file, name))
    end
  end
end)

check.done()
