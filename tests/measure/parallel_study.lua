-- Parallel execution of a study, and its restart after being killed: no finished case is lost.
--
-- Problem: 24 cases of 2D frictional ironing at m2 (ironing2d.lua): eight discretizations, each with p + 1,
--          2(p + 1) and 3(p + 1) contact points; the die is pressed and dragged along the first third of its path,
--          failed steps are halved. The study runs with one process at a time and with several; then again, killed
--          three times at random moments.
-- Source: the problem is that of V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for
--         Isogeometric Analysis of Contact Problems, PhD thesis, IIT Guwahati, 2020, section 7.1; the study is defined
--         here.
-- Units: seconds of wall time.
-- Expected: with two jobs on two processors at most 0.6 of the time of one, if nothing else uses them; after the kills
--           the same table, and no finished case repeated.
-- Run: signorini tests/measure/parallel_study.lua [jobs=2]
--      [rounds=3] [orders=N2,N4,N6,N2-N4,N2-N6,N2-N2.1,N2-N2.2,N2-N2.3]
--      [mesh=m2] [steps=130] [out=out/parallel_study]; times are medians of `rounds`; steps: number of steps of the
--      path.
--      signorini tests/measure/parallel_study.lua once=FOLDER jobs=2
--      executes the study in a folder and prints its table; this is the process that is killed.

local sg = require "signorini"
local ironing = require "problems.ironing2d.problem"

local options = sg.arguments{
  jobs = 2, rounds = 3, orders = { "N2", "N4", "N6", "N2-N4", "N2-N6", "N2-N2.1", "N2-N2.2", "N2-N2.3" },
  mesh = ironing.meshes "m2", steps = 130, out = "out/parallel_study", once = "",
}

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

local function solve(case)
  local set_up = ironing.variants.standard
  local model = ironing.scene(set_up, case.order, ironing.elements(case.mesh),
    case.points * (ironing.layer_degree(case.order) + 1))
  local run = model:run(ironing.path(set_up, 1), sg.plain{ step = { adaptive = true }, on_step = function(info)
    return info.step == case.steps and "stop" or nil
  end })
  local last = run.steps
  return { iterations = run.iterations, drag = run:column "grip.fx"[last], press = run:column "grip.fy"[last],
           failed = run.failed, reason = run.failed and run.reason or nil }
end

local function new_study(folder)
  return sg.study{
    name = "ironing", folder = folder, units = { drag = "N/mm", press = "N/mm" }, run = solve,
    cases = sg.grid{ order = options.orders, points = { 1, 2, 3 }, steps = { options.steps },
                     mesh = { options.mesh } },
  }
end

--- The table of what the cases computed, without the times, which differ.
local function table_of(study)
  return study:table{ columns = { "order", "points", "iterations", "drag", "press" } }
end

if options.once ~= "" then
  local study = new_study(options.once):execute{ jobs = options.jobs }
  print(table_of(study))
  return { study = study }
end

-- ── Side by side ─────────────────────────────────────────────────────────────────────────────────────────────────────

local files = sg.files(options.out)

--- Executes the study from scratch; returns its seconds and its table.
local function time(jobs)
  local folder = ("%s/%d_at_once"):format(options.out, jobs)
  local study, began = new_study(folder), sg.wall_time()
  study:execute{ jobs = jobs, rerun = true }
  return sg.wall_time() - began, table_of(study), study
end

local seconds, text, study = { one = {}, several = {} }, nil, nil
for _ = 1, options.rounds do
  local one, first = time(1)
  local several, second
  several, second, study = time(options.jobs)
  if first ~= second then error("results of parallel execution differ") end
  table.insert(seconds.one, one)
  table.insert(seconds.several, several)
  text = second
end
local one, several = sg.median(seconds.one), sg.median(seconds.several)
print(text)
print(("\n%d cases on %s: one at a time %.1f s, %d at a time %.1f s, %.3f times as long (medians of %d)")
  :format(#study, study.records[1].made.processor, one, options.jobs, several, several / one, options.rounds))
study:csv(files "cases.csv")

-- ── Killed ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local folder = options.out .. "/killed"

--- The seconds that the finished cases took, by order and points.
local function finished()
  local cases = {}
  for _, row in ipairs(new_study(folder):read().rows) do
    cases[row.order .. " " .. row.points] = row.wall -- measured once: another one would mean another run
  end
  return cases
end

local function count(cases)
  local number = 0
  for _ in pairs(cases) do number = number + 1 end
  return number
end

local function quoted(word) return "'" .. word:gsub("'", [['\'']]) .. "'" end

--- The command that executes the study in the folder of the kills.
local function command()
  local script = assert(package.searchpath("parallel_study", package.path))
  return ("%s -q %s once=%s jobs=%d mesh=%s steps=%d orders=%s"):format(quoted(arg[-1]), quoted(script),
    quoted(folder), options.jobs, options.mesh, options.steps, table.concat(options.orders, ","))
end

os.execute("rm -rf " .. quoted(folder))
math.randomseed(os.time())
local repeated, moments, counts = 0, {}, {}
for i = 1, 3 do
  local before = finished()
  moments[i] = several / 6 * (0.5 + math.random())
  os.execute(("%s >/dev/null & sleep %.3f; kill -9 $! 2>/dev/null; wait $! 2>/dev/null"):format(command(), moments[i]))
  local after = finished()
  for name, wall in pairs(before) do repeated = repeated + (after[name] == wall and 0 or 1) end
  counts[i] = count(after)
end
local before, pipe = finished(), assert(io.popen(command()))
local taken_up = pipe:read "a":gsub("%s+$", "")
pipe:close()
for name, wall in pairs(before) do repeated = repeated + (finished()[name] == wall and 0 or 1) end
print(("killed after %.1f, %.1f, %.1f s with %d, %d, %d cases finished, then resumed: %s table, %d finished cases "
  .. "repeated"):format(moments[1], moments[2], moments[3], counts[1], counts[2], counts[3],
    taken_up == text and "the same" or "ANOTHER", repeated))
files:report()
return { ratio = several / one, same = taken_up == text, repeated = repeated, counts = counts, study = study }
