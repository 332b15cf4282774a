-- The functions of the program that the Lua part calls: each one exists.

require "check"

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

--- The functions of core that change files or the process, wait, or take long.
local left_out = { jobs = true, sleep = true, set_threads = true, mkdir = true, write_file = true, write_output = true,
                   lock = true, create_claim = true, save = true, show_picture = true, release = true, require = true }

check.case("functions of core check their arguments: any call is answered or an error", function()
  local sg = require "signorini"
  local patch = sg.shapes.rectangle{ width = 1, height = 1 }
  local body = sg.body{ patch = patch, elements = {1, 1}, order = "N2", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  local model = scenes.model{ bodies = { body = body }, supports = { bed = { on = "south", fix = "xy" } } }
  local values = { "A", 12345, -1.5, true, {}, { 1 }, { {} }, { "x", "y" }, { a = {} }, { body }, print, patch, body,
                   model, model:snapshot(), sg.chart{ x = {1, 2}, { y = {1, 2} } }, io.stdout }
  local function call(f, ...)
    local ok, message = pcall(f, ...)
    if not ok and type(message) ~= "string" then error(("an error is %s"):format(core.describe(message))) end
  end
  local count = 0
  for name, f in pairs(core) do
    if type(f) == "function" and not left_out[name] then
      call(f)
      for _, first in ipairs(values) do
        call(f, first)
        for _, second in ipairs(values) do
          call(f, first, second)
          call(f, first, second, {}, second)
        end
      end
      count = count + 1
    end
  end
  check.equal(count > 40, true)
end)
