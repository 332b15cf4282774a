-- --memory and --time: what exceeds them ends with an error at the user's line, and the prompt goes on.

require "check"

--- Runs a script with options; returns output and status.
local function limited(options, code)
  local name = check.folder() .. "/study.lua"
  core.write_file(name, code)
  local words = { "-q" }
  for word in options:gmatch "%S+" do words[#words + 1] = word end
  words[#words + 1] = name
  return check.program(words)
end

--- The limit of memory is exceeded at a line.
local function exceeds(line, code)
  local output, status = limited("--memory 300M", code)
  check.equal(status, 1)
  check.holds(output, ("study.lua:%d: "):format(line), "more memory is needed than the 300M allowed by --memory")
end

check.case("memory of Lua: tables, strings, coroutines", function()
  exceeds(2, "local t = {}\nfor i = 1, 1e9 do t[i] = { i } end")
  exceeds(2, "local s = 'a'\nwhile true do s = s .. s end")
  exceeds(2, "local s = ('a'):rep(2^26)\nprint(#table.concat({ s, s, s, s, s }))")
  exceeds(3, "local t = {}\ncoroutine.wrap(function()\nfor i = 1, 1e9 do t[i] = { i } end\nend)()")
end)

local solid = [[
local sg = require "signorini"
local function solid(n)
  return sg.body{ patch = sg.shapes.block{ size = {1, 1, 1} }, elements = {n, n, n}, order = "N2",
    material = sg.neo_hookean{ E = 1, nu = 0.3 } }
end
]]

check.case("memory of the program: bodies, models, pictures", function()
  exceeds(6, solid .. "solid(60)")
  exceeds(7, solid .. [[local block = solid(18)
sg.model{ bodies = { block = block }, supports = { bed = { on = block:face "front", fix = "xyz" } } }]])
  exceeds(3, ([[local sg = require "signorini"
local model = sg.scenes.hertz{}
sg.picture{ model = model, field = "uy", file = %q, size = {5000, 5000} }]]):format(check.folder() .. "/large.png"))
end)

check.case("memory of a case of a study", function()
  local output, status = limited("--memory 300M", ([[local sg = require "signorini"
local study = sg.study{ name = "large", folder = %q, cases = sg.grid{ a = {1} }, run = function()
  local t = {}
  for i = 1, 1e9 do t[i] = { i } end
end }
study:execute{}]]):format(check.folder() .. "/large"))
  check.equal(status, 1)
  check.holds(output, "study.lua:4: more memory is needed than the 300M allowed by --memory")
end)

check.case("the prompt goes on after missing memory", function()
  local output = check.program({ "--memory", "300M" },
    "x = 1\n"
    .. "y = {} for i = 1, 1e9 do y[i] = {i} end\ny = nil\nprint(x + 1)\nprint(sg.scenes.hertz{})\n")
  check.holds(output, "more memory is needed than the 300M", "\n2\n", "plane-strain model")
end)

--- The time of one second ends a script at a line.
local function late(line, code)
  local output, status = limited("--time 1s", code)
  check.equal(status, 124)
  check.holds(output, ("study.lua:%d: stopped, because the time limit of 1s is over (--time)"):format(line))
  return output
end

check.case("time ends loops, also in coroutines and around pcall", function()
  late(1, "while true do end")
  late(1, "while true do pcall(function() while true do end end) end")
  late(2, "local function spin() while true do end end\nwhile true do coroutine.resume(coroutine.create(spin)) end")
  late(1, "coroutine.wrap(function() while true do end end)()")
  late(1, "require('signorini.core').sleep(100)")
end)

check.case("time ends a run, whose accepted steps stay", function()
  local output = late(4, [[local sg = require "signorini"
local model, path = sg.scenes.hertz{}
local run = model:run({ { name = "push", steps = 1000000, push = {0, -1e-6} } })
print("not reached")]])
  check.holds(output, "stopped, because")
end)

check.case("what no hook of Lua stops is ended a moment later", function()
  local output, status = limited("--time 1s", "setmetatable({}, { __gc = function() while true do end end })\n"
    .. "collectgarbage()")
  check.equal(status, 124)
  check.holds(output, "the time limit given by --time is over, and the run did not stop")
end)

check.case("the time of the prompt is that of a statement", function()
  local output = check.program({ "--time", "1s" }, "x = 1\nwhile true do end\nprint(x + 1)\n")
  check.holds(output, "stopped, because the time limit of 1s is over", "\n2\n")
end)

check.case("limits that cannot be meant are refused", function()
  for words, message in pairs {
    ["--memory 100K"] = "is too little: the program alone has", ["--memory 4"] = "must be a size such as 500M or 4G",
    ["--memory 4g"] = "must be a size", ["--memory -4G"] = "must be a size", ["--memory 0G"] = "must be a size",
    ["--memory nanG"] = "must be a size", ["--memory 1e99G"] = "must be a size", ["--memory 4GB"] = "must be a size",
    ["--time 10"] = "must be a duration such as 30s", ["--time 0s"] = "must be a duration",
    ["--time=1d"] = "must be a duration", ["--tim 1s"] = "did you mean '--time'?" } do
    local output, status = limited(words, "print 'started'")
    check.holds(output, message)
    if status == 0 or output:find "started" then error(output) end
  end
end)
