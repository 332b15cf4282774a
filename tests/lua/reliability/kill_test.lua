-- Runs that are killed at random moments, also during a write, and resumed have bitwise identical results; so have runs
-- that Ctrl-C ends. More moments: signorini tests/lua/reliability/kill_test.lua 200

require "check"

local study = [[
local sg = require "signorini"
require "signorini.core".quiet = true
local file, resume = arg[1], arg[2] == "resume"
local model = sg.scenes.ironing{ order = "N2", mu = 0.2 }
local run = model:run({ { name = "press", steps = 20, grip = {0, -0.2} },
                        { name = "slide", steps = 80, grip = {0.6, -0.2} } },
  { checkpoint = { file = file, durable = true }, resume = resume })
if run.failed then os.exit(3) end
for _, name in ipairs(run:columns()) do
  if name ~= "wall" then
    for _, value in ipairs(run:column(name)) do io.write(("%a "):format(value)) end
  end
end
for step = 1, run.steps do
  for _, value in ipairs(run:residuals(step)) do io.write(("%a "):format(value)) end
end
for _, value in ipairs(model:profile "interface".pressure) do io.write(("%a "):format(value)) end
io.write(run.iterations, " ", run.steps, "\n")
]]

local folder = check.folder()
local script, file, output = folder .. "/study.lua", folder .. "/run.sgn", folder .. "/output"
core.write_file(script, study)

local function read(name)
  local stream = io.open(name, "rb")
  local text = stream and stream:read "a"
  if stream then stream:close() end
  return text
end

--- The study, with a signal after some seconds; its exit status.
local function run(how, signal, seconds)
  local command = ("'%s' %s %s %s >%s 2>%s/errors & p=$!; "):format(arg[-1], script, file, how, output, folder)
  if signal then command = command .. ("sleep %.4f; kill -%s $p; "):format(seconds, signal) end
  local _, status = check.shell("( " .. command .. "wait $p; exit $? ) 2>" .. folder .. "/shell")
  return status
end

--- The temporary files that writes have left behind, each with its time.
local function leftovers()
  local names = {}
  local listing = check.shell("ls -lA --time-style=full-iso " .. folder)
  for name in listing:gmatch "[^\n]+%.part" do names[#names + 1] = name end
  return names
end

check.equal(run "again", 0)
local undisturbed = read(output)
check.holds(undisturbed, " 100\n")
local largest = #read(file)
os.remove(file)

--- Sends a signal at this many moments, spread over as many runs as that takes; every one of them ends as it should.
--- Returns how many runs that were, and how many moments lay within a write.
local function disturb(moments, signal, expected)
  local sent, finished, torn, seen = 0, 0, 0, {}
  repeat
    local status = run("resume", sent < moments and signal, 0.01 + 0.3 * math.random())
    if status == 0 then
      check.equal(read(output) == undisturbed, true)
      check.equal(leftovers(), {})
      os.remove(file)
      finished = finished + 1
    else
      check.equal(status, expected)
      sent = sent + 1
      for _, name in ipairs(leftovers()) do torn, seen[name] = torn + (seen[name] and 0 or 1), true end
    end
  until sent == moments and finished > 0 and status == 0
  return finished, torn
end

math.randomseed(20)
local moments = tonumber(arg[1] or 25)

check.case("killed at random moments", function()
  local finished, torn = disturb(moments, "KILL", 137)
  print(("%d moments in %d runs, %d in the middle of writing"):format(moments, finished, torn))
end)

check.case("a write that exceeds the limit of files ends the run with the last file", function()
  -- Checkpoints grow with the run; the limit is in blocks of 512.
  local _, status = check.shell(("( ulimit -f %d; exec '%s' %s %s resume >%s 2>%s/errors ) 2>%s/shell")
    :format(largest // 2 // 512, arg[-1], script, file, output, folder, folder))
  check.equal({ status, #leftovers(), read(file) ~= nil }, { 1, 0, true })
  check.equal(run "resume", 0)
  check.equal({ read(output) == undisturbed, #leftovers() }, { true, 0 })
  os.remove(file)
end)

check.case("ended by Ctrl-C at 10 moments", function()
  local finished, torn = disturb(10, "INT", 130)
  assert(finished >= 1)
  check.equal(torn, 0)
end)
