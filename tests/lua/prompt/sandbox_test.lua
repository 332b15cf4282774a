-- --sandbox: escapes that a script may try, each with the wall that stops it: "Lua" (lua/signorini/prompt/sandbox.lua)
-- or "kernel" (src/os/sandbox.hpp, whose walls tests/os/sandbox_test.cpp tries without Lua); work that must go on.

require "check"

local missing = check.program { "--doctor" }:match "\nsandbox +(%-%-sandbox is not available[^\n]*)"
if missing then
  print("skipped: " .. missing)
  os.exit(true)
end

local base = check.folder()
local box, outside = base .. "/box", base .. "/outside"
core.mkdir(box)
core.mkdir(outside)
local secret = outside .. "/secret"
core.write_file(secret, "secret")
core.write_file(secret .. ".xml", "secret")
for name, target in pairs { passwd = "/etc/passwd", secret = secret, new = outside .. "/new" } do
  os.execute(("ln -s %s %s/%s"):format(target, box, name))
end

--- Runs a script in the sandbox of the box; returns what it writes and the exit status.
local function inside(code, options, variables)
  core.write_file(box .. "/script.lua", code)
  local words = { "-q", "--sandbox", box }
  for _, word in ipairs(options or {}) do words[#words + 1] = word end
  words[#words + 1] = box .. "/script.lua"
  return check.program(words, nil, variables)
end

-- Name, code whose error or second value is the message, the wall, a part of the message.
local denied = "Permission denied"
local escapes = {
  { "os.execute", [[os.execute "true"]], "Lua", "no programs are started" },
  { "io.popen", [[io.popen "true"]], "Lua", "no programs are started" },
  { "package.loadlib", [[package.loadlib("/usr/lib/x86_64-linux-gnu/libm.so.6", "*")]], "Lua", "nil value" },
  { "require of a library in C", [[package.cpath = "./?.so" require "evil"]], "Lua", "module 'evil' not found" },
  { "a searcher for libraries in C", [[package.searchers[4]("evil")]], "Lua", "nil value" },
  { "debug.getregistry", [[debug.getregistry()]], "Lua", "nil value" },
  { "debug.sethook", [[debug.sethook()]], "Lua", "nil value" },
  { "debug.setmetatable", [[debug.setmetatable("", {})]], "Lua", "nil value" },
  { "debug.upvaluejoin", [[require("debug").upvaluejoin(print, 1, print, 1)]], "Lua", "nil value" },
  { "debug by package.loaded", [[package.loaded.debug.getupvalue(print, 1)]], "Lua", "nil value" },
  { "debug by an environment", [[return nil, load("return debug.getinfo", "a", "t", _ENV)() or "nil value"]], "Lua",
    "nil value" },
  { "load of bytecode", [[return load(string.dump(function() end))]], "Lua", "attempt to load a binary chunk" },
  { "load of bytecode by its mode", [[return load(string.dump(function() end), "a", "b")]], "Lua", "binary chunk" },
  { "load of bytecode in parts", [[local code = string.dump(function() end)
      return load(function() local part = code code = nil return part end, "a", "bt")]], "Lua", "binary chunk" },
  { "loadfile of bytecode", [[write("code", string.dump(function() end)) return loadfile "code"]], "Lua",
    "binary chunk" },
  { "dofile of bytecode", [[write("code", string.dump(function() end)) dofile "code"]], "Lua", "binary chunk" },
  { "require of bytecode", [[write("code.lua", string.dump(function() end)) require "code"]], "Lua", "binary chunk" },
  { "a module of the library's name", [[write("signorini/sandbox_evil.lua", "return tostring(debug.getinfo)")
      return nil, require "signorini.sandbox_evil"]], "Lua", "cannot load" },
  { "signorini.core", [[return require "signorini.core"]], "Lua", "'signorini.core' is a part of the library" },
  { "signorini.core by package.loaded", [[return package.loaded["signorini.core"], "nothing"]], "Lua", "nothing" },
  { "signorini.core by package.preload", [[return package.preload["signorini.core"], "nothing"]], "Lua", "nothing" },
  { "a module that checks arguments", [[return require "signorini.call.check"]], "Lua", "cannot load" },
  { "such a module by package.loaded", [[return package.loaded["signorini.call.check"], "nothing"]], "Lua", "nothing" },
  { "the functions of strings", [[return getmetatable("") or nil, "hidden"]], "Lua", "hidden" },
  { "os.tmpname", [[os.tmpname()]], "Lua", "use io.open" },
  { "io.tmpfile", [[io.tmpfile()]], "Lua", "use io.open" },
  { "reading /etc/passwd", [[return io.open "/etc/passwd"]], "kernel", denied },
  { "reading through a link to /etc/passwd", [[return io.open "passwd"]], "kernel", denied },
  { "reading through a link to a file outside", [[return io.open "secret"]], "kernel", denied },
  { "reading by ..", [[return io.open "../outside/secret"]], "kernel", denied },
  { "reading by a long way", [[return io.open "/proc/self/cwd/../outside/secret"]], "kernel", denied },
  { "reading by /proc/self/root", [[return io.open("/proc/self/root" .. SECRET)]], "kernel", denied },
  { "reading the user's keys", [[return io.open(USER .. "/.ssh/id_ed25519")]], "kernel", "" },
  { "writing to a file outside", [[return io.open(SECRET, "w")]], "kernel", denied },
  { "appending to a file outside", [[return io.open(SECRET, "a")]], "kernel", denied },
  { "writing through a link", [[return io.open("secret", "w")]], "kernel", denied },
  { "making a file through a link", [[return io.open("new", "w")]], "kernel", denied },
  { "making a file by ..", [[return io.open("../outside/new", "w")]], "kernel", denied },
  { "making a file above", [[return io.open("../../of_the_sandbox", "w")]], "kernel", denied },
  { "removing a file outside", [[return os.remove(SECRET)]], "kernel", denied },
  { "taking a file in", [[return os.rename(SECRET, "taken")]], "kernel", "" },
  { "moving a file out", [[write("a", "a") return os.rename("a", SECRET .. "2")]], "kernel", "" },
  { "the library's files", [[return io.open(HOME .. "/lua/signorini.lua", "a")]], "kernel", denied },
  { "the program", [[return io.open(PROGRAM, "a")]], "kernel", "" },
  { "the user's start files", [[return io.open(USER .. "/.bashrc", "a")]], "kernel", denied },
  { "/proc/self/mem", [[return io.open("/proc/self/mem", "r+")]], "kernel", denied },
  { "/proc/self/environ", [[return io.open "/proc/self/environ"]], "kernel", denied },
  { "/proc/self/maps", [[return io.open "/proc/self/maps"]], "kernel", denied },
  { "/proc/1/environ", [[return io.open "/proc/1/environ"]], "kernel", denied },
  { "the parent's command line", [[return io.open("/proc/" .. PARENT .. "/cmdline")]], "kernel", denied },
  { "a device", [[return io.open "/dev/kmsg"]], "kernel", "" },
  { "shared memory", [[return io.open("/dev/shm/of_the_sandbox", "w")]], "kernel", denied },
  { "secrets in the environment", [[return nil, os.getenv "SECRET_TOKEN" or "no secret"]], "environment", "no secret" },
  { "sg.chart outside", [[sg.chart{ file = OUTSIDE .. "/a.png", x = {1, 2}, { y = {1, 2} } }]], "kernel", denied },
  { "sg.csv.write outside", [[sg.csv.write(OUTSIDE .. "/a.csv", { columns = {"a"}, rows = {{1}} })]], "kernel",
    denied },
  { "sg.csv.read outside", [[sg.csv.read(SECRET)]], "kernel", denied },
  { "sg.mkdir outside", [[sg.mkdir(OUTSIDE .. "/folder")]], "kernel", denied },
  { "sg.nurbs.read outside", [[sg.nurbs.read(OUTSIDE .. "/secret.xml")]], "kernel", denied },
  { "sg.files outside", [[sg.files(OUTSIDE .. "/files")]], "kernel", denied },
  { "a study's folder outside", [[sg.study{ name = "a", folder = OUTSIDE .. "/study", cases = sg.grid{ a = {1} },
      run = function() return {} end }:execute{}]], "kernel", denied },
  { "a study on Slurm", [[sg.study{ name = "a", folder = "s", cases = sg.grid{ a = {1} },
      run = function() return {} end }:execute{ on = "slurm" }]], "Lua", "no other machine" },
  { "a study by ssh", [[sg.study{ name = "b", folder = "s", cases = sg.grid{ a = {1} },
      run = function() return {} end }:execute{ on = "ssh:localhost" }]], "Lua", "no other machine" },
  { "a command of the prompt's shell", [[require("signorini.prompt.commands").shell "ls"]],
    "Lua", "no programs are started" },
  { "a film by ffmpeg", [[local one = sg.chart{ x = {1, 2}, { y = {1, 2} } }
      sg.film{ one, one, file = "a.mp4" }]], "program", "ffmpeg" },
  { "MPI", [[local m, path = sg.scenes.hertz{} m:run(path, { linear = "mumps" })]], "program",
    "not available in the sandbox" },
}
local prelude = ([[
local sg = require "signorini"
local SECRET, OUTSIDE, USER, PARENT, PROGRAM, HOME = %q, %q, %q, %q, %q, %q
local function write(name, text) local f = assert(io.open(name, "w")) f:write(text) f:close() end
sg.mkdir "signorini"
local function try(name, escape)
  local ok, value, message = pcall(escape)
  local stopped = not ok or (value == nil and message ~= nil)
  print(name .. ": " .. (stopped and tostring(ok and message or value):gsub("\n", " ") or "ESCAPED"))
end
]]):format(secret, outside, os.getenv "HOME" or "/root", "1", core.program, core.home)

check.case("every escape is stopped by its wall", function()
  local code = { prelude }
  for _, escape in ipairs(escapes) do
    code[#code + 1] = ("try(%q, function() %s end)\n"):format(escape[1], escape[2])
  end
  local output = inside(table.concat(code), nil, "SECRET_TOKEN=a")
  for _, escape in ipairs(escapes) do
    local line = ("\n" .. output):match("\n" .. escape[1]:gsub("%p", "%%%0") .. ": ([^\n]*)")
    if not line then error(("%s: no answer in\n%s"):format(escape[1], output)) end
    if line == "ESCAPED" then error(escape[1] .. " is not stopped by the wall " .. escape[3]) end
    check.holds(escape[1] .. ": " .. line, escape[4])
  end
  check.equal(core.read_file(secret), "secret")
  check.equal(core.list_folder(outside), { "secret", "secret.xml" })
end)

check.case("a script that replaces Lua's functions does not change the checks of arguments", function()
  check.ended({ inside [[
    local sg = require "signorini"
    local function yes() return "number" end
    type, math.type, select, pairs, ipairs, require = yes, yes, yes, yes, yes, yes
    string.format, string.find, string.match, table.concat, tostring = yes, yes, yes, yes, yes
    package.loaded["signorini.call.check"] = { call = function(_, _, ...) return ... end }
    print(pcall(sg.shapes.rectangle, { width = {}, height = 1 }))
    print(pcall(sg.rigid.plane, { point = {}, normal = "x" }))]] }, 0,
    "width must be a positive number", "point must be a list of 2 or 3 numbers")
end)

check.case("a study cannot start studies without end", function()
  local output = inside [[
    local sg = require "signorini"
    local function solve(case)
      local inner = sg.study{ name = "inner", folder = "inner" .. case.a, cases = sg.grid{ a = {1} }, run = solve }
      local ok, message = pcall(inner.execute, inner, {})
      return { message = message }
    end
    local study = sg.study{ name = "outer", cases = sg.grid{ a = {1, 2} }, run = solve }
    study:execute{ jobs = 1000 }
    print(study.rows[1].message)]]
  check.holds(output, "cannot start another process: Operation not permitted")
end)

check.case("work in the folder goes on", function()
  check.ended({ inside([[
    local sg = require "signorini"
    local model, path = sg.scenes.hertz{}
    local run = model:run(path, { checkpoint = "run.checkpoint" })
    run:csv "run.csv"
    print(#sg.csv.read "run.csv".rows, sg.load "run.checkpoint")
    sg.chart{ file = "chart.png", x = {1, 2}, { y = {1, 2} } }
    sg.picture{ model = model, field = "uy", file = "state.png" }
    local study = sg.study{ name = "squares", folder = "squares", cases = sg.grid{ a = {1, 2, 3} },
      run = function(case) return { b = case.a ^ 2 } end }
    study:execute{ jobs = 8 }
    print("squares", study.rows[3].b, pcall(dofile, "module.lua"))]], { "--jobs", "2", "--threads", "2" }) }, 0,
    "squares\t9", "plane-strain model")
  check.pictures(box, { "chart", "state" })
end)

check.case("supplied scripts run, and write into the folder", function()
  check.ended({ check.program { "-q", "--sandbox", box, "ironing2d.lua", "orders=N2", "out=ironing" } }, 0)
  check.holds(table.concat(core.list_folder(box .. "/ironing"), " "), ".png")
end)

check.case("a script that is not in the folder is read, its neighbors are not", function()
  core.write_file(outside .. "/study.lua", "print('read') print(io.open(arg[1]))")
  local output = check.program { "-q", "--sandbox", box, outside .. "/study.lua", secret }
  check.holds(output, "read\n", "Permission denied")
  os.remove(outside .. "/study.lua")
end)

check.case("the prompt works inside, and goes on after what was stopped", function()
  local output = check.program({ "--sandbox", box }, "x = 2\n!ls\nio.open '/etc/passwd'\nprint(x + 1)\n")
  check.holds(output, "no programs are started", "Permission denied", "\n3")
end)

check.case("a study's environment for libraries is not the script's", function()
  -- SIGNORINI_HOME is the user's, not the script's: a library in the folder is refused.
  core.mkdir(box .. "/lua")
  core.write_file(box .. "/lua/signorini.lua", "")
  check.ended({ inside("print(1)", nil, "SIGNORINI_HOME=" .. box) }, 1, "contains", "which the script could change")
  check.shell("rm -r " .. box .. "/lua")
end)

check.case("folders and options that are not safe are refused before the script starts", function()
  local function refused(words, ...)
    words[#words + 1] = "-e"
    words[#words + 1] = "print 'started'"
    local output, status = check.program(words)
    check.holds(output, ...)
    if status == 0 or output:find "started" then error(output) end
  end
  for _, folder in ipairs { "/", "/usr", core.home, os.getenv "HOME" } do
    refused({ "--sandbox", folder }, "which the script could change", "Hint: make a folder of its own")
  end
  refused({ "--sandbox", core.home .. "/lua/signorini" }, "a part of the program")
  refused({ "--sandbox", box .. "/missing" }, "cannot be used", "make a folder for the script first")
  refused({ "--sandbox", box .. "/script.lua" }, "cannot be used")
  refused({ "--sandbox" , box, "--on", "slurm" }, "--sandbox cannot be combined with --on slurm")
  refused({ "--sandbox" , box, "--chunk", "a:1" }, "--sandbox cannot be combined with --chunk")
  check.holds(check.program { "--sandbox", box, "--kernel", "a.json" }, "for scripts and the prompt only")
end)
