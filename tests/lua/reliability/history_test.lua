-- The history of the prompt: whole statements, also those of several lines, pasted or unfinished ones; the file.

require "check"

--- The text on a screen, without what moves the cursor and sets modes.
local function plain(screen) return (screen:gsub("\27%[[%d;?]*%a", "")) end

--- What a terminal shows that can move its cursor up, with a history of this content; and the history's new content.
local function session(history, turns)
  local state = check.folder()
  core.mkdir(state .. "/signorini")
  local file = state .. "/signorini/history"
  core.write_file(file, history)
  turns[#turns + 1] = "\4"
  local screen = check.terminal("stty cols 100; exec " .. arg[-1], turns,
    ("XDG_STATE_HOME=%s INPUTRC=/dev/null NO_COLOR=1 TERM=xterm"):format(state))
  return plain(screen), core.read_file(file)
end

local up, down, home, finish = "\27[A", "\27[B", "\27[H", "\27[F"

check.case("a statement of several lines is one entry, recalled and run as one", function()
  local screen, history = session("", { "for i = 7, 8 do\n", "  print(i * 11)\n", "end\n", up .. "\n" })
  check.equal(select(2, screen:gsub("\n77\n88\n", "")), 2)
  check.equal(history, "for i = 7, 8 do\n..>   print(i * 11)\n..> end\n")
end)

check.case("a block of the file is edited as one: Up and Down move in it, Home and End in its lines", function()
  local screen, history = session("old = 1\nfor i = 1, 2 do\n..> \tx = 3\n..> end\n", {
    up .. up .. finish .. " + i" .. home .. "local y = 4;" .. down .. "; z = x\n", "z + 40\n" })
  check.holds(history, "for i = 1, 2 do\n..> local y = 4;\tx = 3 + i\n..> end; z = x\nz + 40\n")
  check.holds(screen, "\n45\n")
end)

check.case("Up beyond the first line of a block, and Ctrl-P within it, lead to the entry before", function()
  local screen = session("40 + 2\nfor i = 1, 2 do\n..> end\n", { up .. up .. up .. "\n", "x = 50\n", "x + 1\n",
    "\16\16\16\16\16\n" })
  check.equal(select(2, screen:gsub("\n42\n", "")), 2)
end)

check.case("an unfinished statement that Ctrl-C or Ctrl-D discards can be recalled", function()
  local _, history = session("", { "x = {\n", "1,\n", "\3", "y = {\n", "\4" })
  check.equal(history, "x = {\n..> 1,\ny = {\n")
end)

check.case("pasted lines run as one and are one entry per statement", function()
  local lines = { "local a = 20", "", "b = a", "  + 1", "for i = 1, 2 do", "\tb = b + i", "end", "b + 18" }
  local screen, history = session("", { "\27[200~" .. table.concat(lines, "\r") .. "\27[201~\n" })
  check.holds(screen, "\n42\n")
  check.equal(history, "local a = 20\nb = a\n..>   + 1\nfor i = 1, 2 do\n..> \tb = b + i\n..> end\nb + 18\n")
end)

check.case("pasted lines with a mistake are entries up to it, the rest is one", function()
  local _, history = session("", { "\27[200~a = 1\rb = = 2\rc = 3\27[201~\n" })
  check.equal(history, "a = 1\nb = = 2\n..> c = 3\n")
end)

check.case("a pipe in place of the file does not stop the prompt", function()
  local state = check.folder()
  core.mkdir(state .. "/signorini")
  check.shell(("mkfifo %s/signorini/history"):format(state))
  local screen = check.terminal("exec " .. arg[-1], { "6 * 7\n", "\4" },
    ("XDG_STATE_HOME=%s INPUTRC=/dev/null NO_COLOR=1 TERM=xterm"):format(state))
  check.holds(plain(screen), "\n42\n")
end)

check.case("commands are entries, and repeated entries are stored once", function()
  local _, history = session("1 + 1\n", { "1 + 1\n", "%who\n", "!true\n", "%who\n", "%who\n" })
  check.equal(history, "1 + 1\n%who\n!true\n%who\n")
end)

check.case("a key that ~/.inputrc binds keeps its function", function()
  local state = check.folder()
  core.write_file(state .. "/inputrc", '"\\e[A": "bound"\n')
  local screen = check.terminal("exec " .. arg[-1], { up .. " = 5\n", "bound + 1\n", "\4" },
    ("XDG_STATE_HOME=%s INPUTRC=%s/inputrc NO_COLOR=1 TERM=xterm"):format(state, state))
  check.holds(plain(screen), "\n6\n")
end)
