-- Memory over long use: many steps, models, errors and pictures in one process.
--
-- Problem: a block of 2 × 1 with 4 × 2 elements (N2, neo-Hooke, E = 1, nu = 0.3) is pressed onto a rigid plane by 0.02
--          and moved to and fro along it with mu = 0.3, as: (1) one run with all steps, whose record grows with them;
--          (2) as many steps in runs of 100, each of which drops the record of the one before; (3) new models, each
--          solved in one step; (4) calls that end with an error: a wrong argument, or a step that does not converge;
--          (5) snapshots, to each of which the model returns; (6) pictures of a state, and charts. After each
--          hundredth of a workload, Lua's garbage is collected and the memory of the process read from
--          /proc/self/status (VmRSS).
-- Source: chosen here.
-- Units: MB of 10⁶ bytes; seconds of wall time.
-- Expected: memory grows by less than 1 MB over the second half of (2) to (6), and in (1) by the record, some kB per
--           step.
-- Run: signorini tests/measure/soak.lua [workloads=run,runs,models,errors,snapshots,pictures]
--      [steps=100000] [models=10000] [pictures=300] [out=out/soak]; steps: of (1) and of (2) each; models: of (3)
--      to (5); pictures: of (6).

local sg = require "signorini"

local options = sg.arguments{
  workloads = { { "run", "runs", "models", "errors", "snapshots", "pictures" },
                choices = { "run", "runs", "models", "errors", "snapshots", "pictures" } },
  steps = 100000, models = 10000, pictures = 300, out = "out/soak",
}
local files = sg.files(options.out)

-- ── The scene ────────────────────────────────────────────────────────────────────────────────────────────────────────

local function scene()
  local block = sg.body{ patch = sg.shapes.rectangle{ width = 2, height = 1 }, elements = {4, 2}, order = "N2",
                         contact = "south", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  return sg.model{
    bodies = { block = block }, supports = { top = { on = block:face "north", drive = "xy" } },
    contacts = { bottom = { slave = block:face "south", master = sg.rigid.plane{ point = {0, 0}, normal = {0, 1} },
                            penalty = 100, friction = { mu = 0.3, penalty = 100 } } },
  }
end

local down = { name = "down", steps = 1, top = {0, -0.02} }

--- Stages of so many steps in all that move the pressed block to and fro by 0.05 in ten steps each.
local function to_and_fro(steps)
  local stages = {}
  for i = 1, steps // 10 do
    stages[i] = { name = "move " .. i, steps = 10, top = { i % 2 == 1 and 0.05 or 0, -0.02 } }
  end
  return stages
end

-- ── Workloads: each calls tick(n) after n of its units ───────────────────────────────────────────────────────────────

local workloads = {}

function workloads.run(tick)
  local model = scene()
  model:run{ down }
  local run = model:run(to_and_fro(options.steps), sg.plain{ on_step = function() tick(1) end })
  if run.failed then error(run.failure, 0) end
end

function workloads.runs(tick)
  local model = scene()
  model:run{ down }
  for _ = 1, options.steps // 100 do
    local run = model:run(to_and_fro(100), sg.plain{})
    if run.failed then error(run.failure, 0) end
    tick(run.steps)
  end
end

function workloads.models(tick)
  for _ = 1, options.models do
    if scene():run{ down }.failed then error("a step did not converge", 0) end
    tick(1)
  end
end

function workloads.errors(tick)
  for i = 1, options.models do
    local fails
    if i % 2 == 0 then
      fails = pcall(sg.shapes.rectangle, { width = -1, height = 1 })
    else
      fails = not scene():run({ { name = "crush", steps = 1, top = {0, -5} } }, sg.plain{}).failed
    end
    if fails then error("an error was expected", 0) end
    tick(1)
  end
end

function workloads.snapshots(tick)
  local model = scene()
  model:run{ down }
  for _ = 1, options.models do
    model:restore(model:snapshot())
    tick(1)
  end
end

function workloads.pictures(tick)
  local drawn = options.out .. "/drawn.png"
  local model = scene()
  model:run{ down }
  for i = 1, options.pictures do
    if i % 2 == 0 then
      sg.chart{ { x = {0, 1, 2}, y = {0, i, 1} }, file = drawn }
    else
      sg.picture{ model = model, field = "von_mises", file = drawn }
    end
    tick(1)
  end
  os.remove(drawn)
end

local totals = { run = options.steps // 10 * 10, runs = options.steps // 100 * 100, models = options.models,
                 errors = options.models, snapshots = options.models, pictures = options.pictures }
local titles = { run = "one run", runs = "runs of 100 steps", models = "models", errors = "errors",
                 snapshots = "snapshots", pictures = "pictures" }

-- ── Memory ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Resident memory of this process in MB, without what Lua's collector can free.
local function memory()
  collectgarbage()
  collectgarbage()
  for line in io.lines "/proc/self/status" do
    local kilobytes = line:match "^VmRSS:%s*(%d+) kB"
    if kilobytes then return tonumber(kilobytes) * 1024 / 1e6 end
  end
end

--- Runs a workload: { share = percent done, memory = MB } after each hundredth, and the seconds it took.
local function watch(name)
  local total, done, next_look = totals[name], 0, 0
  local seen = { share = {}, memory = {} }
  local function look()
    seen.share[#seen.share + 1] = 100 * done / total
    seen.memory[#seen.memory + 1] = memory()
    next_look = next_look + total / 100
  end
  local began = sg.wall_time()
  workloads[name](function(n)
    done = done + n
    if done >= next_look then look() end
  end)
  seen.seconds = sg.wall_time() - began
  if done ~= total then error(("%s: %d of %d were done"):format(name, done, total)) end
  return seen
end

local curves, rows = {}, {}
for _, name in ipairs(options.workloads) do
  local seen = watch(name)
  local middle, last = seen.memory[#seen.memory // 2], seen.memory[#seen.memory]
  rows[#rows + 1] = { titles[name], totals[name], seen.seconds, middle, last, (last - middle) * 2e6 / totals[name] }
  curves[#curves + 1] = { label = titles[name], x = seen.share, y = seen.memory }
end

local columns = { "workload", "count", "time", "memory, half way", "at the end", "growth each" }
print(sg.table{ columns = columns, units = { "", "", "s", "MB", "MB", "bytes" }, rows = rows,
                formats = { time = "%.1f", ["memory, half way"] = "%.1f", ["at the end"] = "%.1f",
                            ["growth each"] = "%.0f" } })
sg.csv.write(files "soak.csv", { columns = columns, rows = rows })
curves.file = files "soak.png"
curves.title = "Memory of one process over long use"
curves.xlabel, curves.ylabel = "done / %", "resident memory / MB"
sg.chart(curves)
files:report()

return rows
