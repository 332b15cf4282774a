-- The commands of the prompt: ?name, %time, %who, %run, !command; piped to it, and among the lines of a block.

require "check"
local complete = require "signorini.prompt.complete"

sg = require "signorini" -- as at the prompt

--- The output of lines that are piped to the prompt, in a folder, and the exit status.
local function typed(lines, folder) return check.program({}, lines .. "\n", ("cd '%s' && "):format(folder or ".")) end

-- The program's path is relative to the present folder in some runs of this test.
local program = arg[-1]
if not program:find "^/" then arg[-1] = core.directory .. "/" .. program end

check.case("?name and name? show the page of a function, a variable's type, a field and an argument", function()
  local output, status = typed [[
r = sg.csv.read
p = sg.shapes.rectangle{ width = 2, height = 1 }
?sg.median
sg.median?
?p
p.degrees?
?sg.body.order
?r
count = 4711
?count
count?? ]]
  check.equal(status, 0)
  check.equal(select(2, output:gsub("Returns the median of a list", "")), 2)
  check.holds(output, "p, a patch: NURBS surface in 2D", "\npatch", "patch:degrees", "Argument of sg.body\norder: ",
    "sg.csv.read(file)", "count, a number: 4711\ncount, a number: 4711\n")
end)

check.case("? of a call's beginning, of a command, and of a variable without a page", function()
  check.holds(typed "?sg.median{ 1, 2 }", "Returns the median of a list")
  check.holds(typed "?%run", "At the prompt:")
  check.holds(typed "t = { 1, 2 }\n?t\n?t.x", "t, a table: {1, 2}", "no page on 't.x'")
end)

check.case("? of an unknown name is an error with a suggestion", function()
  check.ended({ typed "?sg.boddy\n?x" }, 1,
    "prompt:1: There is no page on 'sg.boddy'; did you mean 'sg.body'?", "no page on 'x'")
  check.holds(typed "?run.filed\n?sg.body.ordr", "prompt:1: run has no field 'filed'; did you mean 'failed'?",
    "sg.body has no argument 'ordr'; did you mean 'order'?")
end)

check.case("%time shows wall-clock and processor time, then the result", function()
  local output, status = typed [[
%time 40 + 2
_ + 1
%time local x = 5; y = x -- a comment
y
%time return 1, 2 -- two]]
  check.equal(status, 0)
  check.equal((output:gsub("%d[%d.e-]* s", "… s")), ([[
T
42
43
T
5
T
1
2
]]):gsub("T", "wall-clock time … s, processor time … s"))
end)

check.case("%time of a statement of several lines, and between others", function()
  local output = typed "%time for i = 1, 2 do\n  print(i * 11)\nend\n"
  check.holds(output, "11\n22\nwall-clock time ")
  check.holds(typed "for i = 1, 1 do\n%time print 'never'\nend", "unexpected symbol near '%'")
end)

check.case("%who lists variables with type and size, neither those of Lua nor of the program", function()
  check.equal(typed "%who", "There are no variables.\n")
  local output = typed [[
p = sg.shapes.rectangle{ width = 2, height = 1 }
t, s, f = { 1, 2, x = 3 }, "text", function() end
42
%who]]
  local lines = {}
  for line in output:gmatch "[^\n]+" do lines[#lines + 1] = line end
  check.equal(#lines, 6)
  check.holds(output, "p         patch     NURBS surface in 2D", "t         table     3 values: x\n",
    's         string    "text"', "f         function  function")
end)

--- A folder with scripts: one that uses a module, and others that end in other ways.
local function scripts()
  local folder = check.folder()
  local function write(name, text) core.write_file(folder .. "/" .. name, text) end
  write("study.lua", [[
local sg = require "signorini"
local options = sg.arguments{ steps = 3 }
result = require "factor" * options.steps
fresh = rawget(_G, "secret") == nil and rawget(_G, "result_before") == nil
return { steps = options.steps, script = arg[0] }]])
  write("factor.lua", "return 7")
  write("bad.lua", "first = 1\nlocal function f() error 'broken' end\nf()")
  write("leave.lua", "print 'leaving'\nos.exit(3)")
  write("syntax.lua", "x = = 1")
  write("without.lua", "print(sg)")
  return folder
end

check.case("%run runs a script with arguments in a fresh state, and takes over its variables and its result", function()
  local output, status = typed([[
secret, result_before = 5, 6
%run study.lua steps=4
_.steps, _.script, result, fresh, secret
!echo 'return 8' >factor.lua
%run study
result, arg[0], sg.median{ 1, 2 }]], scripts())
  check.equal(status, 0)
  check.equal(output, '4\n"study.lua"\n28\ntrue\n5\n24\n""\n1.5\n')
end)

check.case("%run: errors of the script at its lines, os.exit, and a script that forgot to load the library", function()
  check.ended({ typed([[
%run bad.lua
first
traceback()
%run leave.lua
%run syntax.lua
%run without.lua
%run study.lua stps=3
1 + 1]], scripts()) }, 1, "bad.lua:2: broken\n1\n", "bad.lua:3: in main chunk", "leaving\nexit status 3\n",
    "syntax.lua:1: unexpected symbol near '='", "undefined variable 'sg'; write local sg", "did you mean 'steps'?",
    "\n2\n")
end)

check.case("!command writes its output in order and tells the exit status if it is not zero", function()
  local output, status = typed "print 'before'\n!echo out; echo err >&2; exit 3\nprint 'after'\n!kill -9 $$\n!true"
  check.equal(status, 0)
  check.equal(output, "before\nout\nerr\nexit status 3\nafter\nended by signal 9\n")
end)

check.case("on a terminal a command of the shell has the terminal", function()
  local output = check.terminal("exec " .. arg[-1], { "!test -t 0 && test -t 1 && echo on a terminal\n", "\4" })
  check.holds(output, "\non a terminal\n")
end)

check.case("%help and % list the commands", function()
  local output = typed "%help\n%"
  for _, form in ipairs { "%time <code>", "%who ", "%run <file> <arguments>", "!<command>", "?<name>" } do
    check.equal(select(2, output:gsub(form:gsub("%p", "%%%0"), "")), 2)
  end
end)

check.case("wrong commands are errors with a hint, and the prompt goes on", function()
  for line, message in pairs {
    ["%tim 1"] = "unknown command '%tim'; did you mean '%time'? Hint: %help lists the commands",
    ["%%time 1"] = "unknown command '%%time'; did you mean '%time'?",
    ["%xyzxyz"] = "unknown command '%xyzxyz'. Hint:",
    ["%time"] = "%time must be followed by an expression or a statement. Hint: %time model:run(path)",
    ["%time x = = 1"] = "unexpected symbol near '='",
    ["%time nothing.x"] = "undefined variable 'nothing'",
    ["%who all"] = "%who has no arguments, got 'all'",
    ["%help me"] = "%help has no arguments, got 'me'",
    ["%run"] = "%run must be followed by the name of a script. Hint: %run study.lua steps=10",
    ["%run stdy.lua"] = "there is no script 'stdy.lua'; did you mean 'study.lua'? Hint: Tab",
    ["%run ."] = "there is no script '.'. Hint: Tab",
    ["%run 'study.lua"] = "a quotation mark ' is not closed",
    ["!"] = "! must be followed by a command of the shell. Hint: !ls",
    ["!cd /tmp"] = "!cd /tmp changes the folder of a shell that ends with the command",
  } do
    check.ended({ typed(line .. "\n40 + 2", scripts()) }, 1, message, "\n42\n")
  end
end)

check.case("commands among other lines keep local variables and the lines of errors; % is also modulo", function()
  local paste = "\27[200~%s\27[201~\n"
  local function pasted(lines)
    return (check.terminal("exec " .. arg[-1], { paste:format(lines:gsub("\n", "\r")), "\4" }, "NO_COLOR=1 TERM=xterm")
      :gsub("\27%[[%d;?]*%a", ""))
  end
  check.holds(pasted "local x = 40\n!echo shell\n%time y = x\ny + 2", "\nshell\nwall-clock time ", "\n42\n")
  check.holds(pasted "!true\n\nnothing.x = 1", "prompt:3: undefined variable 'nothing'")
  check.holds(pasted "local x = 44\n  % 7\nx + 40", "\n42\n")
end)

check.case("Tab completes commands, files after %run and !, and words of help after ?", function()
  local folder = scripts()
  check.equal(complete("", "\n%"), { "help", "run", "time", "who" })
  check.equal(complete("ti", "\n%"), { "time" })
  check.equal(complete(folder .. "/stu", "\n%run "), { folder .. "/study.lua" })
  check.equal(complete("hertz2", "\n%run "), { "hertz2d.lua" })
  check.equal(complete(folder .. "/fa", "\n!ls -l "), { folder .. "/factor.lua" })
  check.equal(complete("sg.shapes.rec", "\n?"), { "sg.shapes.rectangle" })
  check.equal(complete("geom", "\n?"), { "geometry" })
  check.equal(complete("sg.shapes.rec", "\nx = 5 % "), { "sg.shapes.rectangle" })
end)
