-- Ctrl-C while a solid is solved: the prompt comes back within one iteration, and the model can be used. What was
-- solved until then is kept where the line that was typed puts it.

local check = require "check"

local state, scene = os.tmpname(), os.tmpname()
os.remove(state)
local file = assert(io.open(scene, "w"))
file:write [[
core = require "signorini.core"
local block = sg.body{ patch = sg.shapes.block{ size = {4, 4, 4}, corner = {2, 3, 10} }, elements = {6, 6, 4},
  order = "N3", contact = "front", material = sg.neo_hookean{ E = 10, nu = 0.3 } }
local slab = sg.body{ patch = sg.shapes.block{ size = {20, 10, 10} }, elements = {16, 8, 5}, order = "N3",
  contact = "back", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
model = sg.model{ bodies = { block = block, slab = slab },
  supports = { bed = { on = slab:face "front", fix = "xyz" }, grip = { on = block:face "back", drive = "xyz" } },
  contacts = { interface = { slave = block:face "front", master = slab:face "back", penalty = 100 } } }
accepted = 0
function press(steps)
  times = { core.now() }
  model:run({ { steps = steps, grip = { 0, 0, -1 } } },
    { on_step = function() accepted = model:reaction("grip")[3] end,
      on_iteration = function() times[#times + 1] = core.now() end })
end
function longest()
  local most = 0
  for i = 2, #times do most = math.max(most, times[i] - times[i - 1]) end
  return most
end
]]
file:close()

check.case("Ctrl-C in a 3D solve: back at the prompt within an iteration, the last accepted state is there", function()
  -- What is typed after Ctrl-C waits in the terminal until the prompt reads it.
  local typing = ([[sleep 1; printf 'dofile "%s"\n'; sleep 1.5; printf 'press(40)\n'; sleep 6; printf '\003'; ]]
    .. [[printf 'print("late", core.now() - times[#times], "longest", longest())\n'; sleep 2; ]]
    .. [[printf 'model:reaction("grip")[3] - accepted\n'; ]]
    .. [[printf 'model:run({{ steps = 1, grip = model:target "grip" }}).reason\n'; sleep 3; printf '\004']])
    :format(scene)
  local output, status = check.shell(("(%s) | XDG_STATE_HOME=%s TERM=dumb script -qec 'exec %s -q' /dev/null")
    :format(typing, state, arg[-1]))
  output = output:gsub("\r", "")
  check.equal(status, 0)
  check.holds(output, "\ninterrupted; _ is the run so far\n", "\n0.0\n", '"completed"')
  local late, longest = output:match "\nlate%s+(%S+)%s+longest%s+(%S+)"
  print(("an iteration takes up to %s s; the prompt came %s s after the last one"):format(longest, late))
  if not (tonumber(late) <= 1.5 * tonumber(longest) + 0.1) then
    error(("the prompt came %s s after the last iteration, the longest of which took %s s"):format(late, longest))
  end
end)

-- ── What a solve returns because of Ctrl-C ───────────────────────────────────────────────────────────────────────────

local endless = [[
block = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = {2, 2}, order = "N2",
  material = sg.neo_hookean{ E = 1, nu = 0.3 } }
function pressed()
  return sg.model{ bodies = { block = block }, supports = { bed = { on = block:face "south", fix = "xy" },
    top = { on = block:face "north", drive = "y" } } }
end
stages = { { steps = 10000000, top = -0.1 } }
function interrupt() os.execute("(sleep 1; kill -INT $PPID) &") end
]]

--- What the prompt says to lines behind that scene.
local function type_in(lines)
  local name = os.tmpname()
  local file = assert(io.open(name, "w"))
  file:write(endless):close()
  local output = check.program({ "-q" }, ("dofile %q\n"):format(name) .. lines)
  os.remove(name)
  return output
end

check.case("a run that is assigned is kept; what follows on the line is not done, the next line is", function()
  local output = type_in [[
run = "old"
interrupt() run = pressed():run(stages) print "the rest"
print(run.reason, run.steps > 0)
local x <const> = 1 interrupt() t = { run = pressed():run(stages) } print "the rest"
print(t.run.reason)
]]
  check.holds(output, "interrupted\ttrue\n")
  check.equal(select(2, output:gsub("the rest", "")), 0)
  check.equal(select(2, output:gsub("interrupted; _ is the run so far\n", "")), 2)
  check.equal(select(2, output:gsub("interrupted\n", "")), 1) -- what the last line prints
end)

check.case("a recommendation that is stopped says so and is kept", function()
  local output = type_in [[
interrupt() r = sg.recommend{ scene = function() return pressed(), stages end, error = "top.fy", at_most = 0.1 }
print("kept", r.label, #r.tries)
]]
  check.holds(output, "Stopped by Ctrl-C", "kept\tnil\t1")
end)

check.case("a script that is stopped goes on with nothing, and its status is 130", function()
  local output, status = check.script('local sg = require "signorini"\n' .. endless .. [[
interrupt()
for i = 1, 3 do
  local run = pressed():run(stages)
  print("after", i)
end
]])
  check.equal(status, 130)
  check.holds(output, "interrupted")
  check.equal(output:find("after", 1, true), nil)
end)

os.execute("rm -rf " .. state .. " " .. scene)
check.done()
