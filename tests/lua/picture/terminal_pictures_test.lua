-- Pictures in the terminal: pseudo-terminals that answer like kitty, iTerm2, xterm with sixel, a plain one, and tmux;
-- what arrives there is decoded. Without a terminal a file is needed.

require "check"

local player = arg[-1]:gsub("[^/]*$", "") .. "tests/answering_terminal"
local folder = check.folder()
local chart = "sg.chart{ x = {1, 2, 3}, { y = {1, 4, 9}, label = 'force' } }"

--- What a terminal shows after turns at the prompt. `of`: kind, size and cell of the terminal (see
--- answering_terminal.cpp), keys typed while it answers, variables, options of the program.
local function session(of, ...)
  local terminal = ("%s %s %s %s \"$(printf '%s')\""):format(player, of.kind, of.size or "80x24", of.cell or "10x20",
    (of.keys or ""):gsub("\r", "\\r"))
  local variables = ("env -u TMUX -u STY -u LC_TERMINAL -u TERM_PROGRAM -u KITTY_WINDOW_ID -u COLORTERM NO_COLOR=1 "
    .. "XDG_STATE_HOME=%s TERM=xterm-256color %s"):format(folder, of.variables or "")
  local output, status =
    check.terminal(("exec %s %s"):format(arg[-1], of.options or ""), { ... }, variables, terminal)
  return output:gsub("\27%[%?2004[hl]", ""), status -- without the marks of pasted text
end

local digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"

local function decoded(text)
  local bytes = {}
  for a, b, c, d in text:gmatch "(.)(.)(.)(.)" do
    local group = 0
    for _, digit in ipairs { a, b, c, d } do group = group << 6 | (digits:find(digit, 1, true) or 1) - 1 end
    bytes[#bytes + 1] = string.pack(">I3", group):sub(1, 3 - (c == "=" and 1 or 0) - (d == "=" and 1 or 0))
  end
  return table.concat(bytes)
end

--- The size of a complete PNG file.
local function png_size(bytes)
  if not (bytes:find "^\137PNG\r\n\26\n" and bytes:find "IEND....$") then error("not a complete PNG file", 2) end
  return { string.unpack(">I4I4", bytes, 17) }
end

--- The pictures in kitty's sequences: { size = …, keys = "a=T,…" of the first sequence }.
local function kitty_pictures(output)
  local pictures, data, first = {}, "", nil
  for keys, payload in output:gmatch "\27_G([^;\27]*);([^\27]*)\27\\" do
    if not keys:find "a=q" then
      check.at_most("characters of a sequence", #payload, 4096)
      first, data = first or keys, data .. payload
      if keys:find "m=0" then
        pictures[#pictures + 1] = { size = png_size(decoded(data)), keys = first }
        data, first = "", nil
      end
    end
  end
  check.equal(data, "")
  return pictures
end

local function fits(size, width, height)
  check.equal({ size[1] <= width, size[2] <= height, size[1] > 0.9 * width or size[2] > 0.9 * height },
    { true, true, true })
end

check.case("kitty gets the PNG file in chunks, as large as two thirds of the window, and keys are kept", function()
  local output, status = session({ kind = "kitty", keys = "40 + 2\r" }, chart .. "\n",
    { "\n42\nsg> ", "1 + 1\n" }, "\4")
  check.equal(status, 0)
  local pictures = kitty_pictures(output)
  check.equal(#pictures, 1)
  fits(pictures[1].size, 79 * 10, 16 * 20)
  check.holds(pictures[1].keys, "a=T,f=100,q=2,m=")
  check.holds(output, "\27\\\n", "\n42\n", "sg> 1 + 1\n2\n")
  check.equal({ output:find "62;c", output:find "i=31;OK", output:find "chart of" }, {})
end)

check.case("the terminal is asked once; its answers replace missing pixels of the window", function()
  local output = session({ kind = "kitty_pixels", cell = "0x0" }, chart .. "\n", chart .. "; " .. chart .. "\n",
    "c = " .. chart .. "\n", "c, c\n", "\4")
  local pictures = kitty_pictures(output)
  check.equal(#pictures, 3) -- `a; b` is a statement, whose results are not shown
  for _, picture in ipairs(pictures) do fits(picture.size, 79 * 9, 16 * 18) end
  check.equal(select(2, output:gsub("a=q", "")), 1)
end)

check.case("in a small window the picture is laid out larger and scaled down", function()
  local output = session({ kind = "kitty", size = "20x9" }, chart .. "\n", "\4")
  local picture = kitty_pictures(output)[1]
  check.equal(picture.size[1] >= 380, true)
  local columns = math.tointeger(picture.keys:match "c=(%d+)")
  check.equal({ columns >= 10, columns <= 19 }, { true, true })
end)

check.case("iTerm2 gets the PNG file, by its name or that of ssh's variable", function()
  for _, variables in ipairs { "LC_TERMINAL=iTerm2", "TERM_PROGRAM=iTerm.app" } do
    local output = session({ kind = "iterm", variables = variables }, chart .. "\n", "\4")
    local bytes, width, payload = output:match "\27%]1337;File=inline=1;size=(%d+);width=(%d+)px:([%w+/=]*)\7\n"
    local png = decoded(payload)
    check.equal(#png, math.tointeger(bytes))
    fits(png_size(png), 79 * 10, 16 * 20)
    check.equal(png_size(png)[1], math.tointeger(width))
  end
end)

check.case("a terminal with sixel gets sixels, not larger than it takes", function()
  local output, status = session({ kind = "sixel", keys = "40 + 2\r" }, chart .. "\n", { "\n42\nsg> ", "\4" })
  check.equal(status, 0)
  local body = output:match "\27P[%d;]*q(.-)\27\\\n"
  local width, height = body:match '^"1;1;(%d+);(%d+)#'
  fits({ tonumber(width), tonumber(height) }, 500, 300)
  check.equal(select(2, body:gsub("%-", "")) >= tonumber(height) // 6 - 1, true) -- lines of six pixels
  check.equal(output:find("63;1;2", 1, true), nil) -- the answer is not shown
end)

check.case("other terminals get half blocks in their colors", function()
  local function lines_of(variables)
    local output = session({ kind = "plain", size = "60x30", variables = variables }, chart .. "\n", "\4")
    local picture = output:match "force' } }\n.*AAAA\27\\\27%[c(.-)\nsg> " -- behind the query
    local lines = {}
    for line in (picture .. "\n"):gmatch "(.-)\n" do lines[#lines + 1] = line end
    return lines, picture
  end
  local lines, direct = lines_of "COLORTERM=truecolor"
  check.equal({ #lines > 10, #lines <= 20 }, { true, true })
  for _, line in ipairs(lines) do
    local cells = line:gsub("\27%[[%d;?]*%a", "")
    check.equal((cells:gsub("▄", ""):gsub("▀", ""):gsub(" ", "")), "")
    check.at_most("cells of a line", utf8.len(cells), 59)
  end
  check.holds(direct, "\27[", "48;2;", "▄")
  local _, indexed = lines_of ""
  check.holds(indexed, "48;5;")
  check.equal(indexed:find "48;2;", nil)
end)

check.case("tmux passes kitty's sequences on, and the prompt stands below the picture", function()
  local name = "signorini-" .. folder:match "[^/]*$"
  core.write_file(folder .. "/tmux.conf", "set -g allow-passthrough on\nset -g default-terminal tmux-256color\n"
    .. "set -g status off\nset -g escape-time 0\n")
  local terminal = ("%s kitty 80x24 10x20 ''"):format(player)
  local variables = ("env -u TMUX -u STY XDG_STATE_HOME=%s TERM=xterm-256color LC_ALL=C.UTF-8"):format(folder)
  local command = ("tmux -L %s -f %s/tmux.conf new-session '%s -q'"):format(name, folder, arg[-1])
  -- tmux learns the type of its terminal a moment after it has started.
  local known = "repeat local p = io.popen \"tmux display-message -p '#{client_termtype}'\"; local type = p:read 'a'; "
    .. "p:close() until type:find 'kitty'; print 'known'\n"
  local output, status = check.terminal(command, { { "sg>", known }, { "\nknown", chart .. "\n" },
    { "\27_Gm=0", "print('be' .. 'low')\n" }, { "below", "\4" } }, variables, terminal)
  check.equal(status, 0)
  local pictures = kitty_pictures(output)
  check.equal(#pictures, 1)
  check.holds(pictures[1].keys, "C=1")
  fits(pictures[1].size, 79 * 10, 16 * 20)
end)

check.case("a script that reads keys gets those that were typed before the picture", function()
  local script = folder .. "/ask.lua"
  core.write_file(script, ("local sg = require 'signorini'\n%s:show()\nprint('read ' .. io.read())\n"):format(chart))
  local output, status = session({ kind = "kitty", keys = "yes\r", options = script })
  check.equal(status, 0)
  check.holds(output, "read yes")
  check.equal(#kitty_pictures(output), 1)
end)

check.case("a picture with a file is not shown as a result; model, state and patch show themselves", function()
  local scene = "b = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = {1, 1}, order = 'N1', "
    .. "material = sg.neo_hookean{ E = 1, nu = 0.3 } } m = sg.model{ bodies = { b = b }, supports = { s = "
    .. "{ on = b:face 'south', drive = 'xy' } } }\n"
  local output = session({ kind = "kitty" }, scene,
    ("sg.chart{ file = '%s/c.png', { x = {1, 2}, y = {1, 2} } }\n"):format(folder),
    "m:show{ field = 'uy' }\n", "m:run({ { steps = 1, s = {0, 0} } }):states()[1]:show()\n",
    ("b:face 'south'; sg.shapes.rectangle{ width = 1, height = 1 }:show{ file = '%s/p.png' }\n"):format(folder),
    "m:show{ feld = 'uy' }\n", "m:show{ field = 'uy', inset = {5, 6, 5, 6} }\n", "sg.picture{ model = m }:show(1)\n",
    "m.show()\n", "m.show{}\n", "\4")
  check.equal(#kitty_pictures(output), 3)
  check.pictures(folder, { "c", "p" })
  check.holds(output, "\nchart of 1 curve\n",
    "model:show: unknown argument 'feld' (the string 'uy'); did you mean 'field'?",
    "model:show: inset", "picture:show: too many arguments", "model:show must be called on a model, got nothing",
    "model:show must be called on a model, got an empty table")
end)

check.case("--pictures chooses the protocol, also on a terminal that says nothing", function()
  local output = session({ kind = "plain", options = "--pictures=kitty", variables = "TERM=dumb" }, chart .. "\n", "\4")
  check.equal(#kitty_pictures(output), 1)
  check.equal(output:find "a=q", nil)
  check.holds(session({ kind = "kitty", options = "--pictures sixel" }, chart .. "\n", "\4"), "\27P", 'q"1;1;')
  check.holds(session({ kind = "kitty", options = "--pictures=blocks" }, chart .. "\n", "\4"), "▄")
  check.holds(session({ kind = "kitty", options = "--pictures=iterm" }, chart .. "\n", "\4"), "\27]1337;File=inline=1")
end)

check.case("without pictures the prompt describes them, and show is an error", function()
  for _, of in ipairs { { options = "--pictures=none", "--pictures=none turns pictures in the terminal off" },
                        { variables = "TERM=dumb", "a terminal with TERM = dumb" } } do
    local output = session({ kind = "kitty", options = of.options, variables = of.variables },
      chart .. "\n", chart .. ":show()\n", "\4")
    check.holds(output, "\nchart of 1 curve\n", "picture:show: file is needed, because " .. of[1])
    check.equal(output:find "\27_G", nil)
  end
end)

check.case("without a terminal show needs a file, and no escape sequence is written", function()
  local code = "local sg = require 'signorini'\nlocal p = sg.shapes.rectangle{ width = 3, height = 1 }\n"
  local output, status = check.script(code .. "p:show{ control_points = true }\n")
  check.equal(status, 1)
  check.holds(output, "study.lua:3: patch:show: file is needed, because the output is not a terminal. Hint: write "
    .. 'patch:show{ file = "patch.png" }')
  output, status = check.script(code .. chart .. ":show()\n")
  check.equal(status, 1)
  check.holds(output, "study.lua:3: picture:show: file is needed", 'picture:write "x.png"')
  output, status = check.script(code .. ("p:show{ file = '%s/s.png' }\n"):format(folder)
    .. ("sg.picture{ patch = p, file = '%s/t.png' }:show()\n"):format(folder))
  check.equal({ output, status }, { "", 0 })
  check.pictures(folder, { "s", "t" })
  for _, option in ipairs { "--pictures=kitty", "--pictures=blocks", "-q" } do
    output, status = check.program({ option }, chart .. "\n", "env TERM=xterm-kitty KITTY_WINDOW_ID=1")
    check.equal({ output, status }, { "chart of 1 curve\n", 0 })
  end
end)

check.case("wrong words behind --pictures are errors of usage", function()
  for words, message in pairs {
    ["--pictures=sixle"] = "must be one of kitty, iterm, sixel, blocks, none, got 'sixle'; did you mean 'sixel'?",
    ["--pictures="] = "got ''", ["--pictures Kitty"] = "got 'Kitty'",
    ["--pictures"] = "--pictures must be followed by kitty, iterm, sixel, blocks or none",
    ["--picture=kitty"] = "unknown option '--picture=kitty'" } do
    local list = {}
    for word in words:gmatch "%S+" do list[#list + 1] = word end
    local output, status = check.program(list)
    check.equal(status, 2)
    check.holds(output, message)
  end
end)

check.case("a front end shows pictures in the terminal's place", function()
  local display, shown = require "signorini.prompt.display", {}
  display.screen = function(picture) shown[#shown + 1] = tostring(picture) end
  local sg = require "signorini"
  sg.chart { { x = { 1, 2 }, y = { 1, 2 } } }:show()
  check.equal(display.show(sg.picture { patch = sg.shapes.rectangle { width = 1, height = 1 } }), true)
  check.equal(shown, { "chart of 1 curve", "picture of 1 patch" })
  display.screen = nil
end)
