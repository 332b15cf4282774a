-- The command line: options, exit status, standard input, the prompt without a terminal, Ctrl-C.

require "check"

local function run(arguments, input, before)
  local output, status = check.program(arguments, input, before)
  return { output = output, status = status }
end

local function ends(result, status, ...) check.ended({ result.output, result.status }, status, ...) end

local function gives(result, output, status)
  check.equal(result.output, output)
  check.equal(result.status, status or 0)
end

check.case("-e runs code, several in a row, with sg defined", function()
  gives(run { "-e", "print(1)" }, "1\n")
  gives(run { "-e", "x = 2", "-e", "print(x + 1)" }, "3\n")
  gives(run { "-e", "print(sg.shapes.rectangle{ width = 1, height = 1 })" },
    "NURBS surface in 2D: degree 1 x 1, elements 1 x 1, 4 control points\n  control points in x 0 … 1, y 0 … 1\n"
    .. "  faces: west in x = 0; east in x = 1; south in y = 0; north in y = 1\n")
end)

check.case("scripts get their arguments, and find modules in their folder", function()
  local name = check.folder()
  local function write(file, text) core.write_file(name .. "/" .. file, text) end
  write("study.lua", "print(require 'scene', arg[1], arg[2], #arg, arg[0]:match '[^/]*$', ...)")
  write("scene.lua", "return 'a scene'")
  gives(run { name .. "/study.lua", "mesh=m1", "-q" }, "a scene\tmesh=m1\t-q\t2\tstudy.lua\tmesh=m1\t-q\n")
end)

check.case("modules of the supplied scripts are found last, from scripts in subfolders and elsewhere", function()
  local folder = check.folder()
  local function write(file, text) core.write_file(folder .. "/" .. file, text) end
  write("study.lua", "print(type(require('problems.ironing2d.problem').scene), (require 'studies.in_turns'))")
  core.mkdir(folder .. "/studies")
  write("studies/in_turns.lua", "return 'my own'")
  gives(run { folder .. "/study.lua" }, "function\tmy own\n")
  gives(run { "-e", "print(type((require 'studies.in_turns')))" }, "function\n")
  check.ended({ check.shell(("cd %s && SIGNORINI_HOME=%s %s stability/locking.lua help"):format(folder,
    core.home, arg[-1])) }, 0, "Arguments of ")
end)

check.case("- reads standard input", function()
  gives(run({ "-", "a" }, "print(1 + 1, arg[1], sg ~= nil)"), "2\ta\ttrue\n")
  ends(run({ "-" }, "print(1)\nerror 'no'"), 1, "signorini: stdin:2: no")
end)

check.case("--version and --help", function()
  local result = run { "--version" }
  check.equal(result.status, 0)
  assert(result.output:find "^signorini %d+%.%d+%.%d+ %(%x+%)\n$" and #result.output:match "%x+%)" == 17)
  result = run { "--help" }
  check.equal(result.status, 0)
  check.holds(result.output, "Exit status")
  for _, option in ipairs(core.options) do check.holds(result.output, "\n  " .. option[1]) end
end)

check.case("--doctor draws without a display", function()
  for _, display in ipairs { "env -u DISPLAY", "env DISPLAY=nowhere.invalid:7" } do
    ends(run({ "--doctor", "--threads", "2" }, nil, display), 0,
      "Lua 5.4", "Eigen", "SuiteSparse", "BLAS", "readline", "VTK", "threads       2",
      "kernel        ", "test picture  ok", "films         ")
  end
end)

check.case("SIGNORINI_KERNEL chooses the kernels' instructions", function()
  local narrowest = core.versions.kernel == "plain" and "plain" or "sse2" -- plain: not an x86-64 processor
  local result = run({ "-e", "print(require 'signorini.core'.versions.kernel)" }, nil,
    "env SIGNORINI_KERNEL=" .. narrowest)
  check.equal(result, { status = 0, output = narrowest .. "\n" })
  ends(run({ "-e", "print(1)" }, nil, "env SIGNORINI_KERNEL=sse3"), 1,
    ("SIGNORINI_KERNEL must be %s, avx2 or avx512, got 'sse3'"):format(narrowest))
end)

check.case("-q and --threads are visible to the library", function()
  gives(run { "-q", "--threads", "3", "-e", "local core = require 'signorini.core' print(core.quiet, core.threads)" },
    "true\t3\n")
end)

check.case("a wrong command line ends with status 2 and a hint", function()
  for arguments, hint in pairs {
    [{ "--doctr" }] = "unknown option '--doctr'; did you mean '--doctor'?",
    [{ "-x" }] = "unknown option '-x'",
    [{ "--threads", "0" }] = "--threads must be an integer from 1 to 1024, got '0'",
    [{ "--threads", "2x" }] = "got '2x'",
    [{ "--threads=2x" }] = "got '2x'",
    [{ "--quiet=yes" }] = "unknown option '--quiet=yes'",
    [{ "--help=yes" }] = "unknown option '--help=yes'",
    [{ "--threads" }] = "--threads must be followed by a number",
    [{ "--on", "pbs" }] = "--on must be slurm, local or hosts such as ssh:host1,ssh:host2, got 'pbs'",
    [{ "--on", "ssh:a,b" }] = "got 'ssh:a,b'",
    [{ "study.lua", "--on" }] = "--on must be followed by slurm, local or hosts",
    [{ "--chunk" }] = "--chunk must be followed by the file of a job",
    [{ "-e" }] = "-e must be followed by code",
    [{ "--sandbox=", "study.lua" }] = "--sandbox must be followed by the folder that the script may use, got ''",
    [{ "--sandbox", "", "study.lua" }] = "--sandbox must be followed by the folder that the script may use, got ''",
  } do
    ends(run(arguments), 2, "signorini: ", hint)
  end
end)

check.case("--threads N runs N threads, none of them of BLAS, also after a solve", function()
  local code = [[
    local function count() return #require("signorini.core").list_folder "/proc/self/task" end
    local before = count()
    local block = sg.body{ patch = sg.shapes.block{ size = { 1, 1, 1 } }, elements = { 8, 8, 8 }, order = "N2",
                           material = sg.neo_hookean{ E = 1, nu = 0.3 } }
    local model = sg.model{ bodies = { block = block }, supports = { bed = { on = block:face "front", fix = "xyz" },
      grip = { on = block:face "back", drive = "z", fix = "xy" } } }
    model:run({ { steps = 1, grip = { -0.1 } } }, { linear = "umfpack" })
    print(before, count())
  ]]
  for threads = 1, 3 do
    gives(run { "-q", "--threads", tostring(threads), "-e", code }, ("%d\t%d\n"):format(threads, threads))
  end
end)

check.case("more threads than the system allows are an error that states the maximum", function()
  -- a stack of 8 MB each, and 4 GB for all
  ends(run({ "--threads", "1024", "-e", "print(1)" }, nil, "ulimit -s 8192; ulimit -v 4000000;"), 1,
    "signorini: the system started only ", " of 1024 threads", "Hint: use fewer threads")
end)

check.case("closed streams: what is printed does not land in files that are opened later", function()
  local file = check.file "result.txt"
  local code = ("local f = io.open('%s', 'w'); print 'printed'; io.stderr:write 'error'; f:write 'result'; f:close()")
    :format(file)
  for _, closed in ipairs { "<&- >&- 2>&-", ">&- 2>&-", ">&-", "2>&-" } do
    local _, status = check.shell(("'%s' -q -e \"%s\" %s"):format(arg[-1], code, closed))
    check.equal(status, 0)
    check.equal(core.read_file(file), "result")
  end
end)

check.case("output that cannot be written is an error, also with os.exit", function()
  for _, code in ipairs { "print 'lost'", "print 'lost' os.exit(0, true)", "io.write(('x'):rep(100000))" } do
    check.ended({ check.shell(("'%s' -q -e \"%s\" 2>&1 >/dev/full"):format(arg[-1], code)) }, 1,
      "signorini: the output could not be written")
  end
end)

check.case("the library is found by SIGNORINI_HOME, or the message lists the places that were searched", function()
  ends(run({ "-e", "print(1)" }, nil, "env SIGNORINI_HOME=/nowhere"), 1, "/nowhere", "SIGNORINI_HOME")
end)

check.case("the prompt reads lines from a pipe: expressions, statements over several lines, errors", function()
  gives(run({}, "1 + 1\nx = {1, 2, name = 'a'}\nx\nfor i = 1, 2 do\n  print(i)\nend\n'text'\n"),
    '2\n{1, 2, name = "a"}\n1\n2\n"text"\n')
  ends(run({}, "y = 1\nerror 'no'\ny\n"), 1, "prompt:1: no", "\n1\n")
  ends(run({}, "for i = 1, 2 do\n"), 1, "ends inside a statement")
  gives(run({ "-i", "-e", "z = 5" }, "z\n"), "5\n")
end)

check.case("expressions over several lines, and their errors", function()
  gives(run({}, "{1,\n2,\n  3}\n1 +\n2\n'a' ..\n\n'b'\n(2 *\n3)\n"), '{1, 2, 3}\n3\n"ab"\n6\n')
  local output = run({}, "1 + * 2\nx = = 3\n)\nx =\n7\nx\n").output
  check.holds(output, "prompt:1: unexpected symbol near '*'\n", "prompt:1: unexpected symbol near '='\n",
    "prompt:1: unexpected symbol near ')'\n7\n")
end)

check.case("-i opens the prompt after a script, with what it returned as _, and after one that failed", function()
  local name = check.file()
  local function write(text) core.write_file(name, text) end
  write "y = 3 return 42, 43"
  gives(run({ "-i", name }, "_ + y\n"), "45\n")
  gives(run({ "-i", "--", name }, "y\n"), "3\n")
  write "y = 3 error 'no'"
  ends(run({ "-i", name }, "y\n"), 1, ":1: no\nstack traceback:", "\n3\n")
end)

check.case("where entries of a table have no comma in between, the message asks for it", function()
  for _, case in ipairs { { { "-e", "f{ a=1 b=2 }" } }, { { "-" }, "f{ a=1\n b=2 }" } } do
    check.holds(run(case[1], case[2]).output, ": '}' expected", "near 'b'. Hint: a comma may be missing before it")
  end
  check.equal(run { "-e", "f(1 2)" }.output:find "a comma may", nil)
  check.holds(run({}, "f{ a=1 b=2 }\n").output,
    "prompt:1: '}' expected near 'b'. Hint: a comma may be missing before it\n")
end)

check.case("a name of other letters than Lua's is an error that states the allowed ones", function()
  local hint = ". Hint: names consist of a-z, A-Z, digits and _; put other characters in quotes\n"
  check.equal(run({}, "ü = 3\n").output, "prompt:1: unexpected symbol near '<\\195>'" .. hint)
  for _, code in ipairs { "größe = 1", "x = 3 × 4", "x = “a”", "t = { α = 1 }" } do
    check.holds(run({}, code .. "\n").output, "prompt:1: ", hint)
    check.holds(run({ "-e", code }).output, "signorini: (command line):1: ", hint)
  end
  check.equal(run({}, "'ü'\nx = @\n").output, '"ü"\nprompt:1: unexpected symbol near \'@\'\n')
  check.equal(run({}, "x = \1\n").output, "prompt:1: unexpected symbol near '<\\1>'\n")
end)

check.case("at the prompt errors are one line, traceback() tells how they came about, and _ is the last result",
  function()
  local result = run({},
    "function f() error 'no' end\nfunction g() f() return 1 end\ng()\n40 + 2\n_ / 2\nx = 3\n_\nnil\n_\ntraceback()\n")
  check.equal(result.status, 1)
  check.equal(result.output:match "^prompt:1: no\n42\n21.0\n21.0\nnil\n21.0\nprompt:1: no\nstack traceback:\n" ~= nil,
    true)
  check.holds(result.output, "in function 'f'", "in function 'g'")
  check.holds(run({}, "traceback()\n").output, "There has been no error.")
  check.holds(run({}, "local y, z = 3\nlocal function f() end\nx = 1\nz\nf()\nqq\n").output,
    "undefined variable 'z'; it was local to its line: leave "
    .. "out `local` at the prompt\n", "undefined variable 'f'; it was local", "undefined variable 'qq'\n")
  check.holds(run({}, "_\n").output, "undefined variable '_'; at the prompt it is the last result, once there is one")
end)

check.case("an error shows the fields of its table, and reports a missing message", function()
  check.equal(run({}, "error({ code = 1 })\nerror()\nerror({})\nerror(7)\n").output,
    "error: {code = 1}\nerror without a message\nerror: {}\n7\n")
  check.equal(run({}, "error(setmetatable({}, { __tostring = function() return 'own words' end }))\n").output,
    "own words\n")
  check.holds(run({ "-e", "error({ code = 1 })" }).output, "signorini: error: {code = 1}\nstack traceback:")
  check.holds(run({ "-e", "error()" }).output, "signorini: error without a message\nstack traceback:")
  check.holds(run({}, "t = setmetatable({ 5 }, { __name = 'odd', __index = function() error 'no' end })\nerror(t)\n")
    .output, "error: {5}\n")
  local output = check.program({ "-q" }, ([[
    sg.study{ name = "e", folder = %q, cases = { { a = 1 } }, run = function() error{ code = 3 } end }:execute{}
  ]]):format(check.file()))
  check.holds(output, "the first one, a=1: error: {code = 3}\n")
end)

check.case("exit and quit end only the prompt", function()
  for _, word in ipairs { "exit", "quit", "exit()", " quit ( ) ;" } do
    local result = run({}, "1 + 1\n" .. word .. "\n40 + 2\n")
    check.equal({ result.output, result.status }, { "2\n", 0 })
  end
  check.equal(run({}, "nonsense\nexit\n").status, 1)
  check.equal(run({}, "exit = 3\nexit\nx = {\nquit = 1,\n}\nx.quit\n").output, "3\n1\n")
  local hint = "undefined variable 'exit'; alone on a line it ends the prompt; os.exit() ends a script"
  check.holds(run({ "-e", "exit()" }).output, hint)
  check.holds(run({}, "x = exit()\n").output, hint)
  for _, query in ipairs { "?exit", "?quit()", 'help "exit"', "help quit" } do
    check.holds(run({}, query .. "\n").output, "At the prompt:\n", "Ctrl-D, exit, quit      ends the prompt;")
  end
end)

check.case("errors in a call that fills a line, of -e or the end of a script are located", function()
  local result = run({}, "sg.study{ a = 1 }\nreturn sg.median { 'a' }\nfunction f() error('no', 2) end\n\nf()\n(1)\n")
  check.holds(result.output, "prompt:1: sg.study: unknown argument 'a'", "prompt:1: sg.median: ", "prompt:1: no\n1\n")
  check.holds(run { "-e", "return sg.study{ a = 1 }" }.output,
    "signorini: (command line):1: sg.study: unknown argument 'a'")
  check.holds((check.script "local sg = require 'signorini'\n\nreturn sg.study{ a = 1 }"),
    "signorini: study.lua:3: sg.study: unknown")
end)

check.case("no colors unless the output is a terminal", function()
  local output = check.program({}, "error 'no'\n", "env -u NO_COLOR TERM=xterm-256color")
  check.equal(output, "prompt:1: no\n")
end)

check.case("the prompt cuts long tables and does not follow cycles", function()
  ends(run({}, "t = {} for i = 1, 100 do t[i] = i end\nt\nt = {} t.t = t\nt\n{{1, 2}, {{3}}}\n"), 0,
    "… 60 more", "{t = {t = {…}}}", "{{1, 2}, {{…}}}")
end)

check.case("a script without a name", function()
  ends(run { "" }, 2, "the script name must not be empty, got ''")
end)

check.case("a quotation mark that is left open is an error of its line, and the next line is one of its own", function()
  local output = run({}, 'x = "abc\nhelp "galery"\n[[a\nb]]\n').output
  check.holds(output, "prompt:1: unfinished string near '\"abc'\n", "no page on 'galery'; did you mean 'gallery'?\n",
    "a\nb")
end)

check.case("help takes a dot for a colon", function()
  check.holds(run({}, 'help "patch.refine"\nhelp "model.run"\n').output, "patch:refine{ elements", "model:run(stages")
end)

check.case("help finds functions, methods, tables and words", function()
  ends(run({}, 'help()\nhelp(sg.shapes.block)\nhelp "patch:refine"\nhelp(sg.nurbs)\nhelp "orders"\n'
    .. 'help "refin"\nhelp "rectangel"\n'), 0,
    "signorini: isogeometric", "sg.shapes.block{ size", "patch:refine{ elements",
    "sg.nurbs.coons{", "N2-N2.2x2", "Pages with 'refin'", "did you mean 'rectangle'?")
end)

check.case("help shows groups, types of Lua objects, and what a query at the prompt means", function()
  local output = check.program({},
    '?\n?orders\n?sg.shapes.block\n? patch:refine\nx = sg.median\n?x\n?sg.nurbs\n?refin\n'
    .. 'help "studies"\nhelp "rectangel"\n ?sg.bdy\nhelp sg.mkdir\nhelp\nhelp(sg.reference "hertz2d_dofs_table7_4")\n')
  check.holds(output, "signorini: isogeometric", "N2-N2.2x2", "sg.shapes.block{ size", "patch:refine{ elements",
    "sg.median(numbers)", "Functions:\n  sg.nurbs.arc{", "Pages with 'refin':", "Studies:\n  sg.study{",
    "did you mean 'rectangle'?", "did you mean 'sg.body'?",
    "sg.mkdir(path)\n", "mkdir \"out/study\"\nsignorini: isogeometric", "data\nThe result of sg.csv.read")
end)

check.case("a script that comes along runs by its name, unless there is a file of that name", function()
  local folder = check.file "folder"
  core.mkdir(folder .. "/scripts")
  local function run(words)
    return check.shell(("cd %s && SIGNORINI_HOME=%s %s %s"):format(folder, core.home, arg[-1], words))
  end
  local names = { "newton_loop.lua", "hertz2d.lua", "scripts/studies/newton_loop.lua", "stability/peeling.lua" }
  for _, name in ipairs(names) do
    check.ended({ run(name .. " help") }, 0,
      "signorini: running " .. core.home .. "/scripts/", "Arguments of " .. core.home .. "/scripts/")
  end
  core.write_file(folder .. "/newton_loop.lua", "print 'my own'")
  check.equal(run "newton_loop.lua", "my own\n")
  for _, name in ipairs { "none.lua", "lua/signorini.lua", "demo" } do
    check.ended({ run(name) }, 1, "cannot open " .. name)
  end
end)

check.case("help takes a method by the letter that pages call its object by, and closes what a list cuts off",
  function()
  local output = check.program({}, '?m:iterate\nhelp "m:run"\nhelp "p:insert"\nhelp "pictures"\nhelp "m:nonsense"\n')
  check.holds(output, "model:iterate{ … }\n", "model:run(stages, ", "\nSolves a model along",
    "patch:insert(",
    "  sg.picture{ model,", ", … }    Returns a picture", "no page on 'm:nonsense'")
end)

check.case("Ctrl-C ends a script with status 130, wherever it is", function()
  local file = check.file "output"
  for _, code in ipairs { "while true do end", "pcall(function() while true do end end) while true do end" } do
    local _, status = check.shell(([[%s -e 'print "begun" io.flush() %s' >%s 2>&1 &
      until grep -q begun %s; do sleep 0.02; done; kill -INT $!; wait $!]]):format(arg[-1], code, file, file))
    local output = io.open(file):read "a"
    os.remove(file)
    check.equal(status, 130)
    check.holds(output, "signorini: (command line):1: interrupted")
  end
end)
