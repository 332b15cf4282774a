-- Ctrl-C while a solid is solved: the prompt comes back within one iteration, and the model can be used. What was
-- solved until then is stored where the line that was typed puts it.

require "check"

local folder = check.folder()
local scene = folder .. "/scene.lua"
core.write_file(scene, [[
local block = sg.body{ patch = sg.shapes.block{ size = {4, 4, 4}, corner = {2, 3, 10} }, elements = {4, 4, 2},
  order = "N3", contact = "front", material = sg.neo_hookean{ E = 10, nu = 0.3 } }
local slab = sg.body{ patch = sg.shapes.block{ size = {20, 10, 10} }, elements = {8, 6, 3}, order = "N3",
  contact = "back", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
model = sg.model{ bodies = { block = block, slab = slab },
  supports = { bed = { on = slab:face "front", fix = "xyz" }, grip = { on = block:face "back", drive = "xyz" } },
  contacts = { interface = { slave = block:face "front", master = slab:face "back", penalty = 100 } } }
accepted = 0
function press(steps)
  local count = 0
  model:run({ { steps = steps, grip = { 0, 0, -0.025 * steps } } },
    { on_step = function() accepted = model:reaction("grip")[3] end,
      on_iteration = function() count = count + 1 print("iteration", count) end })
end
]])

check.case("Ctrl-C in a 3D solve: back at the prompt within an iteration, the last accepted state is there", function()
  local output = check.ended({ check.terminal(("exec %s -q"):format(arg[-1]), {
    ("dofile %q\n"):format(scene), "press(1000)\n", { "\niteration\t9\n", "\3" },
    "accepted ~= 0, model:reaction('grip')[3] - accepted\n",
    "model:run({{ steps = 1, grip = model:target 'grip' }}).reason\n", "\4" },
    ("XDG_STATE_HOME=%s TERM=dumb"):format(folder)) }, 0,
    "interrupted; _ is the run so far\n", "\ntrue\n0.0\n", '"completed"')
  -- The iteration under way ends, and at most one that had just been counted is reported after it.
  local _, later = output:match("%^C(.*)$"):gsub("iteration\t%d+", "")
  check.equal(later <= 1, true)
end)

-- ── What a solve returns because of Ctrl-C ───────────────────────────────────────────────────────────────────────────

local endless = ("folder = %q\n"):format(folder) .. [[
block = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = {2, 2}, order = "N2",
  material = sg.neo_hookean{ E = 1, nu = 0.3 } }
function pressed()
  return sg.model{ bodies = { block = block }, supports = { bed = { on = block:face "south", fix = "xy" },
    top = { on = block:face "north", drive = "y" } } }
end
stages, runs = { { steps = 10000000, top = -0.1 } }, 0
-- Ctrl-C once a run of these has saved its first steps
function interrupt()
  runs = runs + 1
  saving = { checkpoint = { file = ("%s/run_%d"):format(folder, runs), every = 5 } }
  os.remove(saving.checkpoint.file) -- one of an earlier session
  os.execute(("(until [ -e %s ]; do sleep 0.02; done; kill -INT $PPID) &"):format(saving.checkpoint.file))
end
]]

--- What the prompt says to lines behind that scene.
local function type_in(lines)
  local name = check.file()
  core.write_file(name, endless)
  return (check.program({ "-q" }, ("dofile %q\n"):format(name) .. lines))
end

check.case("an assigned run remains; the rest of the line is not executed, the next line is", function()
  local output = type_in [[
run = "old"
interrupt() run = pressed():run(stages, saving) print "the rest"
print(run.reason, run.steps > 0)
local x <const> = 1 interrupt() t = { run = pressed():run(stages, saving) } print "the rest"
print(t.run.reason)
]]
  check.holds(output, "interrupted\ttrue\n")
  check.equal(select(2, output:gsub("the rest", "")), 0)
  check.equal(select(2, output:gsub("interrupted; _ is the run so far\n", "")), 2)
  check.equal(select(2, output:gsub("interrupted\n", "")), 1) -- what the last line prints
end)

check.case("an interrupted recommendation reports it and remains", function()
  local output = type_in [[
interrupt()
measure = function() io.open(saving.checkpoint.file, "w"):close() return { one = 1 } end
r = sg.recommend{ scene = function() return pressed(), stages, { measure = measure } end, tolerance = "1 % of top.fy" }
print("result", r.order, #r.tries)
model = pressed()
interrupt() model:run(stages, { errors = true, measure = measure })
interrupt() model:run(stages, { tolerance = "1 % of top.fy", measure = measure })
print("still", model:last_length())
]]
  check.holds(output, "Stopped by Ctrl-C", "result\tnil\t0", "still\t0")
end)

check.case("an interrupted fit or search for an optimum has the best values so far", function()
  local output = type_in [[
id = io.open "/proc/self/stat":read "n"
function scene(q)
  calls = calls + 1
  if calls == last then os.execute("(sleep 0.1; kill -INT " .. id .. ") &") end
  return pressed(), { { steps = calls < last and 2 or 10000000, top = -q.d } }
end
search = { scene = scene, start = { d = 0.1 }, data = { { y = "top.fy", points = { { 1, -0.2 }, { 2, -0.4 } } } } }
calls, last = 0, 5 fit = sg.fit(search)
print("fit", fit.reason, #fit.tries, fit.at.d, fit.warnings[1])
calls, last, fit = 0, 1, "nothing" fit = sg.fit(search)
print("none", fit)
calls, last = 0, math.huge fit = sg.fit(search)
calls, last = 0, calls - 1 fit = sg.fit(search) -- in the first run at an end of an interval
print("checked", fit.reason, fit.warnings[1])
search = { scene = scene, start = { d = 0.1 }, least = "top.fy", bounds = { d = { 0.1, 0.9 } } }
calls, last = 0, 8 best = sg.optimize(search)
print("optimum", best.reason, #best.tries, best.at.d > 0.1)
print("still", pressed():last_length())
]]
  check.holds(output, "fit\tinterrupted\t1\t0.1\tCtrl-C has ended the search", "none\tnothing",
    "checked\tconverged\tCtrl-C has ended the check of the intervals",
    "optimum\tinterrupted\t2\ttrue", "still\t0")
end)

check.case("an interrupted convergence map reports it and remains, with the finished cells", function()
  local output = type_in [[
id = io.open "/proc/self/stat":read "n"
axes = { x = { name = "a", values = { 1, 2 } }, y = { name = "b", values = { 1 } } }
function scene(a) if a == 2 then os.execute("kill -INT " .. id) end return pressed() end
function path(_, a) return a == 1 and { { steps = 1, top = -0.1 } } or stages end
map = sg.convergence_map{ x = axes.x, y = axes.y, scene = scene, path = path, jobs = 1 } print "the rest"
print("result", #map.cells, map:cell(1, 1).outcome, map:cell(2, 1))
]]
  check.holds(output, "convergence map: interrupted: 1 of 2 cases is done\n", "result\t1\tcompleted\tnil")
  check.equal(output:find("the rest", 1, true), nil)
end)

check.case("an interrupted script ends with status 130", function()
  local output, status = check.script('local sg = require "signorini"\n' .. endless .. [[
interrupt()
for i = 1, 3 do
  local run = pressed():run(stages, saving)
  print("after", i)
end
]])
  check.equal(status, 130)
  check.holds(output, "interrupted")
  check.equal(output:find("after", 1, true), nil)
end)
