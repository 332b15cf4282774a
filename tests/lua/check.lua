-- A harness of one page: cases with names, a few comparisons, and the program run as a user runs it. All valid calls of
-- a test must conform to the definitions for editors. A test begins with `require "check"`, which provides check, core,
-- lists, scenes and sg; the end of the program reports.

local core = require "signorini.core"
require("conformity").watch_calls()

--- Modules of tests that messages take as parts of the library, so that errors appear at the line of the test.
for _, name in ipairs { "scenes", "spring_run" } do
  package.preload[name] = function()
    local text = core.read_file(("%s/tests/lua/%s.lua"):format(core.home, name))
    return assert(load(text, ("@%s/lua/%s.lua"):format(core.home, name)))()
  end
end

local check = {}

local failures, cases, folders = 0, 0, {}

--- Runs one case; a failure is reported and the rest goes on. Cases of studies that a case loses are expected; those
--- lost outside of cases count for the exit status of the program.
function check.case(name, body)
  cases = cases + 1
  local lost = core.lost_cases
  core.lost_cases = nil
  local ok, message = xpcall(body, debug.traceback)
  core.lost_cases = lost
  if ok then return end
  failures = failures + 1
  io.stderr:write(("FAILED: %s\n%s\n"):format(name, message))
end

local function quoted(word) return "'" .. word:gsub("'", [['\'']]) .. "'" end

--- A new empty folder, which is removed at the end.
function check.folder()
  local name = os.tmpname()
  os.remove(name)
  core.mkdir(name)
  folders[#folders + 1] = name
  return name
end

--- The name of a file in a new folder, where there is none yet.
function check.file(name) return ("%s/%s"):format(check.folder(), name or "file") end

local function process() return io.open "/proc/self/stat":read "n" end

--- The end of the program, not of one that it has forked: a test without cases fails, too. Errors in a finalizer are
--- silent, but must not hide failures.
local test = process()
setmetatable(check, { __gc = function()
  local known, now = pcall(process)
  if known and now ~= test then return end
  local whole = pcall(function()
    for _, name in ipairs(folders) do check.shell("rm -r " .. quoted(name)) end
    print(("%d cases, %d failed"):format(cases, failures))
  end)
  if not known or not whole or failures > 0 or cases == 0 then os.exit(false) end
end })

local function text(value)
  if type(value) ~= "table" then return tostring(value) end
  local parts = {}
  for i, entry in ipairs(value) do parts[i] = text(entry) end
  return "{" .. table.concat(parts, ", ") .. "}"
end

local function same(a, b, tolerance)
  if type(a) == "table" and type(b) == "table" then
    if #a ~= #b then return false end
    for i = 1, #a do
      if not same(a[i], b[i], tolerance) then return false end
    end
    return true
  end
  if tolerance and type(a) == "number" and type(b) == "number" then return math.abs(a - b) <= tolerance end
  return a == b
end

--- Equal values, or lists of equal values.
function check.equal(actual, expected)
  if not same(actual, expected) then error(("expected %s, got %s"):format(text(expected), text(actual)), 2) end
end

--- Numbers, points or lists of points that agree within a tolerance.
function check.near(actual, expected, tolerance)
  if not same(actual, expected, tolerance or 1e-13) then
    error(("expected %s, got %s"):format(text(expected), text(actual)), 2)
  end
end

--- A number that is small; `what` is named if not.
function check.at_most(what, value, bound)
  if not (value and math.abs(value) <= bound) then
    error(("%s: expected at most %g in size, got %s"):format(what, bound, tostring(value)), 2)
  end
end

--- A number within a tolerance; `what` is named if not.
function check.within(what, value, expected, tolerance)
  if not (value and math.abs(value - expected) <= tolerance) then
    error(("%s: expected %g ± %g, got %s"):format(what, expected, tolerance, tostring(value)), 2)
  end
end

--- A number within a share of what is expected; `what` is named if not.
function check.within_share(what, value, expected, share)
  if not (value and math.abs(value / expected - 1) <= share) then
    error(("%s: expected %g within %g %%, got %s"):format(what, expected, 100 * share, tostring(value)), 2)
  end
end

--- A PNG file: its width, height and bytes.
function check.png(file)
  local bytes = core.read_file(file)
  local width, height = string.unpack(">I4I4", bytes, 17)
  return { width = width, height = height, bytes = bytes }
end

--- PNG files of these names are in a folder, whole.
function check.pictures(folder, names)
  for _, name in ipairs(names) do
    local bytes = core.read_file(("%s/%s.png"):format(folder, name))
    if not (bytes:find("^\137PNG\r\n\26\n") and bytes:find("IEND....$")) then
      error(name .. " is not a complete picture", 2)
    end
  end
end

--- The run, which has reached its end.
function check.completed(run)
  if run.failed then error(run.failure, 2) end
  return run
end

--- The warnings of a run that hold a text.
function check.warnings(run, fragment)
  local found = {}
  for _, warning in ipairs(run.warnings) do
    if warning:find(fragment, 1, true) then found[#found + 1] = warning end
  end
  return found
end

--- The last value of a run's column.
function check.last(run, name)
  local column = run:column(name)
  return column[#column]
end

--- The model, saved and loaded.
function check.reloaded(model)
  local file = check.file "model.sgn"
  model:save(file)
  return sg.load(file)
end

--- The text holds every fragment.
function check.holds(whole, ...)
  for _, fragment in ipairs { ... } do
    if not tostring(whole):find(fragment, 1, true) then
      error(("'%s' is missing in:\n%s"):format(fragment, whole), 2)
    end
  end
end

--- A command, { output, status }, has ended with this status, and its output holds every fragment; returns the output.
function check.ended(command, status, ...)
  if command[2] ~= status then error(("expected status %d, got %s:\n%s"):format(status, command[2], command[1]), 2) end
  check.holds(command[1], ...)
  return command[1]
end

--- The function ends with an error whose message holds every fragment; returns the message.
function check.fails(body, ...)
  local ok, message = pcall(body)
  if ok then error("an error was expected, there was none", 2) end
  check.holds(message, ...)
  return message
end

--- Waits for an event; the number of looks bounds the time, which is not measured.
function check.await(what, happened)
  for _ = 1, 3000 do
    if happened() then return end
    os.execute "sleep 0.1"
  end
  error("not seen: " .. what, 2)
end

--- A command of the shell: everything it writes, and its exit status.
function check.shell(command)
  local pipe = assert(io.popen(("{ %s; } 2>&1"):format(command)))
  local output = pipe:read "a"
  local _, _, status = pipe:close()
  return output, status
end

--- The program with a list of arguments, as check.shell runs it. `input` is its standard input, `before` goes in front
--- of the command.
function check.program(arguments, input, before)
  local words = { before or "", quoted(arg[-1]) }
  for _, word in ipairs(arguments) do words[#words + 1] = quoted(word) end
  local source = os.tmpname()
  local file = assert(io.open(source, "wb"))
  file:write(input or ""):close()
  local output, status = check.shell(("%s <%s"):format(table.concat(words, " "), quoted(source)))
  os.remove(source)
  return output, status
end

--- Types to a command on a terminal, which util-linux' `script` provides. `turns` are keys, or { event, keys }: typed
--- once that text has appeared behind what was there when the last keys were typed, or the function of that name says
--- true; without an event once a prompt has. No time enters: a slow machine takes longer. `variables` stand in front of
--- the command. `terminal`: the command of another terminal than that script. Returns what the terminal has shown,
--- without carriage returns, and the exit status.
function check.terminal(command, turns, variables, terminal)
  local screen, since = check.file "screen", 0
  core.write_file(screen, "")
  local function shown() return (core.read_file(screen):gsub("\r", "")) end
  -- What was shown, with a new line where a progress bar has been erased.
  local function text()
    return (core.read_file(screen):gsub("\r\27%[K", "\n"):gsub("\r", ""):gsub("\27%[[%d;?]*%a", ""))
  end
  local function happened(event)
    if type(event) == "function" then return event() end
    local new = text():sub(since + 1)
    if event then return new:find(event, 1, true) end
    return new:find "\nsg> $" or new:find "\n%.%.> $"
  end
  local pipe = assert(io.popen(("%s %s %s %s >%s.log 2>&1"):format(variables or "TERM=dumb", terminal or "script -qfec",
    quoted(command), quoted(screen), quoted(screen)), "w"))
  for i, turn in ipairs(turns) do
    local event, keys = nil, turn
    if type(turn) == "table" then event, keys = turn[1], turn[2] end
    local looks = 0
    while not happened(event) do
      looks = looks + 1
      if looks == 5000 then error(("timed out in turn %d; the terminal:\n%s"):format(i, shown()), 2) end
      os.execute "sleep 0.02"
    end
    since = #text()
    pipe:write(keys):flush()
  end
  local _, _, status = pipe:close()
  return shown(), status
end

--- A script with this text, run by the program.
function check.script(code, ...)
  local name = os.tmpname()
  local file = assert(io.open(name, "wb"))
  file:write(code):close()
  local output, status = check.program { name, ... }
  os.remove(name)
  return output:gsub(name:gsub("%p", "%%%0"), "study.lua"), status
end

--- What the code of wrong calls can use; it stands in line 1 of that code.
local prelude = [[local sg = require "signorini" local soft = sg.neo_hookean{ E = 1, nu = 0.3 } ]]
  .. [[local r = sg.shapes.rectangle{ width = 3, height = 1 } ]]
  .. [[local a = sg.body{ patch = r, elements = {4, 2}, order = "N2", contact = "north", material = soft } ]]
  .. [[local north, east = a:face "north", a:face "east" ]]

--- Cases { code, fragment, … }: the code behind `start` ends with an error that holds the fragments and begins with a
--- line of the script, `place` or the case's `line`, or with words, if `place` is those.
function check.refusals(start, place, wrong)
  for _, case in ipairs(wrong) do
    check.case("refused: " .. case[1], function()
      local line = case.line or place
      local begins = math.type(line) and ("study.lua:%d: "):format(line) or line
      local message = check.fails(assert(load(prelude .. start .. case[1], "=study.lua")), table.unpack(case, 2))
      check.equal(message:sub(1, #begins), begins)
    end)
  end
end

--- The Lua listings of a page, run as one script in a new folder as printed: what it writes, and the folder.
function check.page(file)
  local folder, listings = check.folder(), {}
  for code in core.read_file(file):gmatch "```lua\n(.-)```" do
    listings[#listings + 1] = code
  end
  core.write_file(folder .. "/listing.lua", table.concat(listings))
  local program = check.shell("realpath " .. quoted(arg[-1])):match "[^\n]+"
  return check.ended({ check.shell(("cd %s && SIGNORINI_HOME=%s %s -q listing.lua"):format(folder, quoted(core.home),
    quoted(program))) }, 0), folder
end

-- ── Scripts ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The path of a script such as "problems/hertz2d" or "tests/measure/benchmark".
local function path_of(script)
  return ("%s/%s%s.lua"):format(core.home, script:find "^tests/" and "" or "scripts/", script)
end

--- The script as a function, which finds the modules next to it.
function check.load(script)
  local own = ";" .. path_of(script):gsub("[^/]*$", "?.lua")
  if not package.path:find(own, 1, true) then package.path = package.path .. own end
  return assert(loadfile(path_of(script)))
end

--- The words of each script's row in coarse.txt, with which the gallery draws it.
local rows = {}
for prefix, folder in pairs { [""] = "scripts", ["tests/measure/"] = "tests/measure" } do
  for line in core.read_file(("%s/%s/coarse.txt"):format(core.home, folder)):gmatch "[^\n]+" do
    local name, words = line:match "^([%w_/]+) *|", {}
    for word in line:match "[^|]*$":gmatch "%S+" do words[#words + 1] = word end
    if name then rows[prefix .. name] = words end
  end
end
check.rows = rows

--- The files that a script reports at the end of its output.
local function reported_files(output)
  local files, listing = {}, false
  for line in output:gmatch "[^\n]*" do
    local file = line:match "^Written: (.*)" or listing and line:match "^ +(.*)"
    if file then files[#files + 1] = file end
    listing = file
  end
  return files
end

--- How a complete file ends.
local ends = { png = "IEND....$", svg = "\n</svg>\n$", html = "\n</html>\n$", csv = "\n.*\n$", json = "[%]}]\n$" }

--- The files that a script reports are there and complete, and it has written no other picture.
local function check_files(script, folder, files)
  local reported = {}
  for _, file in ipairs(files) do
    reported[file] = true
    if not core.read_file(file):find(ends[file:match "%w+$"]) then error(file .. " is not complete", 3) end
  end
  if not core.exists(folder) then return end
  local drawn = check.shell(("find %s -name '*.png' -o -name '*.svg' -o -name '*.pdf'"):format(quoted(folder)))
  for file in drawn:gmatch "[^\n]+" do
    if not reported[file] then error(("%s does not report %s"):format(script, file), 3) end
  end
end

--- The words, with a folder for what the script writes, which it has to make, unless they name one or it writes
--- nothing; and the folder.
local function with_folder(script, words)
  for _, word in ipairs(words) do
    if word:find "^out=" then return words, word:sub(5) end
  end
  local all, folder = { table.unpack(words) }, check.folder() .. "/out"
  if core.read_file(path_of(script)):find "%f[%w]out = " then all[#all + 1] = "out=" .. folder end
  return all, folder
end

--- What a script returns, run with these words, by default those of its row in coarse.txt, and the folder of its files.
function check.study(script, ...)
  local words, folder = with_folder(script, select("#", ...) > 0 and { ... } or rows[script])
  local own_print, quiet, said = print, core.quiet, {}
  function print(...)
    for _, value in ipairs(table.pack(...)) do said[#said + 1] = tostring(value) end
  end
  core.quiet = true
  local ok, result = xpcall(check.load(script), debug.traceback, table.unpack(words))
  print, core.quiet = own_print, quiet
  local output = table.concat(said, "\n")
  if not ok then
    -- Without the words, which check.fails must not take for the message.
    error(("%s: %s\n%s"):format(script, result, output:sub(-2000)), 2)
  end
  local files = reported_files(output)
  check_files(script, folder, files)
  local must_write = select("#", ...) == 0 and core.read_file(path_of(script)):find "sg%.files%("
  if must_write and #files == 0 then error(script .. " wrote nothing", 2) end
  return result, folder
end

--- A script refuses wrong arguments: { ["mesh=m9 steps=1"] = "got 'm9'" } are words and what the message holds; `…`
--- goes in front of each.
function check.refused(script, wrong, ...)
  for words, message in pairs(wrong) do
    local arguments = { ... }
    for word in words:gmatch "%S+" do arguments[#arguments + 1] = word end
    local output, status = check.program{ "-q", path_of(script), table.unpack((with_folder(script, arguments))) }
    check.equal(status, 1)
    check.holds(output, message)
  end
end

package.loaded.check = check
for name, module in pairs { check = check, core = core, lists = require "signorini.call.lists",
                            scenes = require "scenes", sg = require "signorini" } do
  rawset(_G, name, module)
end

return check
