-- The prompt on a terminal, which util-linux' `script` provides: editing, history, completion, Ctrl-C.

require "check"

local state = check.file "state"

--- What the terminal shows, and the exit status; see check.terminal.
local function typed_to(command, turns, variables)
  return check.terminal(command, turns, ("XDG_STATE_HOME=%s %s"):format(state, variables or "TERM=dumb"))
end

local function session(...) return typed_to("exec " .. arg[-1], { ... }) end

check.case("a session: expressions, several lines, Ctrl-C in a loop and at the prompt, Ctrl-D", function()
  check.ended({ session("1 + 1\n", "print 'looping' while true do end\n", { "\nlooping\n", "\3" },
    "abc def", { "abc def", "\3" }, "40 + 2\n",
    "for i = 7, 8 do\n", "print(i) end\n", "for\n", "\3", "'still here'\n", "\4") }, 0,
    "help() shows help", "sg> 1 + 1\n2\n", "^Cinterrupted\n", "abc def^C\n", "sg> 40 + 2\n42\n",
    "..> print(i) end\n7\n8\n", 'sg> \'still here\'\n"still here"\n')
end)

check.case("Tab completes names, fields and methods", function()
  local output = session("p = sg.shapes.rec\t{ width = 1, height = 1 }\n", "p:transl\t{ 1, 1 }\n", "\4")
  check.holds(output, "sg.shapes.rectangle{ width", "p:translate{ 1, 1 }\nNURBS surface in 2D")
end)

check.case("Tab completes named arguments, also on the next line, and names of files in quotes", function()
  local output = session("p = sg.shapes.rectangle{ wid\t3, he\t\n", "1 }\n", "p:degrees()[1] + 41\n",
    "io.open(\"" .. state .. "/signorini/hist\t):read 'l'\n", "\4")
  check.holds(output, "rectangle{ width = 3, height = \n..> 1 }\n", "42\n",
    "/signorini/history\"):read 'l'\n\"1 + 1\"\n")
end)

check.case("Tab completes arguments of tables in tables, and texts in quotes", function()
  local output = session("p = sg.shapes.rectangle{ width = 1, height = 1 }\n", "p:face \"sou\t\n",
    "x = function() return sg.model{ contacts = { c = { friction = { m\t2 } } } } end\n", "\4")
  check.holds(output, 'p:face "south"\nNURBS curve in 2D', "friction = { mu = 2 }")
end)

check.case("Ctrl-D forgets an unfinished statement, a tab at the beginning of a line is a tab", function()
  check.ended({ session("for i = 1, 2 do\n", "\4", "40 + 2\n", "x = {\n", "\t\t5 }\n", "x\n", "\4") }, 0,
    "sg> 40 + 2\n42\n", "sg> x\n{5}\n")
end)

check.case("after Ctrl-Z and fg the line can be edited as before", function()
  local output = typed_to("PS1='ready> ' exec bash --norc -i", {
    { "ready> ", arg[-1] .. "\n" }, "abc", { "abc", "\26" }, { "Stopped", "fg\n" }, { "sg> abc", "\21" .. "2 + 2\n" },
    "\4", { "ready> ", "exit\n" } })
  check.holds(output, "Stopped", "\n4\n")
end)

check.case("the line follows the present width of the terminal", function()
  local long = '"' .. ("x"):rep(60) .. '"'
  local output = session("os.execute 'stty cols 100'\n", long .. "\n", "os.execute 'stty cols 40'\n", long .. "\n",
    "\4")
  local wide, narrow = output:match "^(.*)os.execute 'stty cols 40'(.*)$"
  check.holds(wide, "sg> " .. long)
  check.equal(narrow:find("sg> " .. long, 1, true), nil)
end)

check.case("Ctrl-C keeps the run that it has stopped", function()
  local file, first = check.file "run.sgn", nil
  -- The file is written at the beginning of the run and replaced every eleven steps.
  local function was_replaced()
    local now = core.exists(file) and core.read_file(file) or nil
    first = first or now
    return now ~= first
  end
  local output = session('b = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = {1, 1}, '
    .. 'order = "N1", material = sg.neo_hookean{ E = 1, nu = 0.3 } }\n',
    'm = sg.model{ bodies = { b = b }, supports = { s = { on = b:face "south", '
    .. 'drive = "xy" } } }\n',
    ("m:run({ { steps = 100000000, s = {0, 0} } }, { checkpoint = { file = %q, every = 11 } })\n"):format(file),
    { was_replaced, "\3" }, "_.reason, _.steps > 10\n", "\4")
  check.holds(output, "interrupted; _ is the run so far\n", '"interrupted"\ntrue\n')
end)

check.case("Ctrl-C twice before the first was seen leaves the prompt and its variables", function()
  -- Both come while one call of C waits, which looks at nothing.
  local file = check.file "both"
  check.ended({ session("value = 4711\n",
    ("io.popen('kill -INT $PPID; sleep 0.1; kill -INT $PPID; touch %s'):read 'a'\n"):format(file),
    { function() return io.open(file) end, "value + 1\n" }, { "\n4712\nsg> ", "\4" }) }, 0, "\n4712\n")
end)

check.case("Tab behind help and a quotation mark lists its words", function()
  local output = session('help "contac\t"\n', "\4")
  check.holds(output, 'help "contact')
end)

check.case("what is pasted runs as one, shows its last expression, and keeps its local variables", function()
  local output = typed_to("exec " .. arg[-1], {
    "\27[200~local a = 20\nfor i = 1, 2 do\n\ta = a + i\nend\na - 1\27[201~\n", "\4" }, "NO_COLOR=1 TERM=xterm")
  check.holds(output, "22\n")
end)

check.case("?name is help, and errors are red where the terminal has colors and NO_COLOR does not say no", function()
  local function typed(environment)
    return (typed_to("exec " .. arg[-1], { "?sg.median\n", "error(0)\n", "\4" }, "env " .. environment))
  end
  local output = check.shell(("env -u NO_COLOR TERM=xterm script -qec \"%s -e 'error(0)'\" /dev/null"):format(arg[-1]))
  check.holds(output, "\27[31msignorini:\27[0m 0")
  check.holds(typed "-u NO_COLOR TERM=xterm", "Returns the median of a list", "\27[31m0\27[0m", "\27[32msg> \27[0m")
  for _, environment in ipairs { "NO_COLOR=1 TERM=xterm", "-u NO_COLOR TERM=dumb" } do
    local output = typed(environment)
    check.holds(output, "Returns the median of a list", "0\n")
    check.equal(output:find "\27%[3[12]m", nil)
  end
end)

check.case("help that is longer than a screen is shown by $PAGER, shorter help is printed", function()
  local output = typed_to("exec " .. arg[-1], { 'help "model:run"\n', { "MODEL:RUN(STAGES", "?sg.median\n" }, "\4" },
    "PAGER='tr a-z A-Z' TERM=dumb")
  check.holds(output, "SOLVES A MODEL ALONG ITS LOAD PATH", "Returns the median of a list")
  output = typed_to("exec " .. arg[-1], { '?model.run\n', "\4" }, "PAGER=/no/pager TERM=dumb")
  check.holds(output, "Solves a model along its load path")
end)

check.case("history is saved between sessions", function()
  session("marker = 4711\n", "\4")
  local output = session("\16\n", "\4") -- Ctrl-P
  check.holds(output, "marker = 4711\n")
  check.holds(core.read_file(state .. "/signorini/history"), "40 + 2\n", "marker = 4711\n")
end)
