-- How often the error bars of a run hold, on generated scenes.
--
-- Problem: a slab, an arch (half or quarter ring) or a block (punch) of 4 to about 20 elements per direction, in plane
--          strain, axisymmetric or solid (half or a quarter of it), is pressed by a rigid cylinder, sphere or torus,
--          against a plane, or by another body, and then dragged or not. A seed determines laws (neo-Hooke,
--          Mooney-Rivlin, linear elastic; Poisson's ratio 0 to 0.45), sizes, orders N2, N3, N2-N2.2, N2-N4, friction,
--          the formulation (Gauss points, mortar with penalty, multipliers), penalties of 30 to 500 E/h or those by
--          default, 4 to 18 steps. The contact is 3 to 7 elements of twice the size wide (solids: 2). Nothing absurd.
--          Each scene is solved with errors = true, and once more as the truth: on a mesh two levels finer (solids:
--          one) with ten times the penalties, in the plane a richer row and twice the points, and with friction four
--          times the steps (solids: twice).
-- Source: chosen here.
-- Units: all figures are ratios; E of the softer body is 1 and the contact about 0.7 wide.
-- Expected: |value - truth| <= bar in 90 % of all forces, peak pressures and areas, bar <= 3 |value - truth| in 75 % of
--           the forces and half of the others. The second is counted step by step, where even the bar of an error
--           that oscillates, its amplitude, is narrow enough in 78 %, and in root mean squares over the path (rms).
--           Even seeds have 91, 90 and 92 % inside; narrow enough are 54, 30 and 66 % of steps, 71, 35 and 78 % of
--           paths. The punch, with the pressure of sharp edges, is counted apart: its peaks have no limit.
-- Run: signorini tests/measure/error_bars.lua [first=1] [count=200] [seeds=all] [levels=2] [jobs=2] [limit=300]
--      [out=out/error_bars]; first, count: seeds; seeds: all, odd or even ones of them; levels: of refinement of the
--      truth (3 shows how accurate it is); limit: seconds per scene. The limits of the estimate
--      (lua/signorini/errors/terms.lua) were chosen on odd seeds, and judged on even ones. Solutions are in the folder:
--      a second call judges them again.

local sg = require "signorini"
local compare = require "error_bars.compare"
local lists = require "signorini.call.lists"
local scenes = require "error_bars.scenes"
local solve = require "error_bars.solve"

local options = sg.arguments{
  first = 1, count = { 200, at_least = 1 }, seeds = { "all", choices = { "all", "odd", "even" } },
  levels = { 2, at_least = 1 }, jobs = 2, limit = 300.0, out = "out/error_bars",
}
local files = sg.files(options.out)

local cases = {}
for seed = options.first, options.first + options.count - 1 do
  if options.seeds == "all" or (seed % 2 == 1) == (options.seeds == "odd") then
    cases[#cases + 1] = { seed = seed, levels = options.levels }
  end
end
local study = sg.study{ name = "error_bars", folder = options.out .. "/scenes", cases = cases,
                        run = function(case) return solve(case.seed, case.levels) end }
study:execute{ jobs = options.jobs, limit = options.limit }

-- ── Counts ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local counts = {} -- by quantity and group

local function count(what, group, one)
  local key = what .. "|" .. group
  local c = counts[key] or { values = 0, inside = 0, close = 0, without = 0, columns = 0, inside_path = 0,
                             close_path = 0, ratios = {} }
  counts[key] = c
  local bars, errors = 0, 0
  for i, error in ipairs(one.errors) do
    local bar = one.bars[i]
    if bar then
      c.values = c.values + 1
      c.inside = c.inside + (error <= bar and 1 or 0)
      c.close = c.close + (bar <= 3 * error and 1 or 0)
      bars, errors = bars + bar ^ 2, errors + error ^ 2
    else
      c.without = c.without + 1
    end
  end
  if errors > 0 then
    c.columns = c.columns + 1
    c.inside_path = c.inside_path + (errors <= bars and 1 or 0)
    c.close_path = c.close_path + (bars <= 9 * errors and 1 or 0)
    c.ratios[c.columns] = math.sqrt(bars / errors)
  end
end

local reasons, unsolved, solved = {}, {}, 0
for _, row in ipairs(study.rows) do
  if not row.values or row.failure or row.truth_failure then
    local why = row.failure or row.truth_failure or row.outcome
    unsolved[#unsolved + 1] = ("seed %d: %s"):format(row.seed, why:match "^[^:]*")
  else
    solved = solved + 1
    for _, one in ipairs(compare(row)) do
      local what = one.what .. (row.sharp and ", sharp edges" or "")
      for _, group in ipairs{ "all", row.formulation, row.kind } do count(what, group, one) end
      if one.why then
        local reason = ("%s: %s"):format(what, one.why)
        reasons[reason] = (reasons[reason] or 0) + 1
      end
    end
  end
end

-- ── Tables ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local function median(list)
  table.sort(list)
  return list[(#list + 1) // 2]
end

local function percent(number, of) return of > 0 and 100 * number / of or nil end

local quantities = { "forces", "peak", "area", "forces, sharp edges", "peak, sharp edges", "area, sharp edges" }
local groups = lists.joined(scenes.formulations, scenes.kinds)
local overall, divided = {}, {}
for _, what in ipairs(quantities) do
  local c = counts[what .. "|all"]
  if c then
    overall[#overall + 1] = { what, c.values, c.without, percent(c.inside, c.values), percent(c.close, c.values),
                              percent(c.inside_path, c.columns), percent(c.close_path, c.columns), median(c.ratios) }
    divided[#divided + 1] = lists.joined({ what }, lists.map(groups, function(group)
      local part = counts[what .. "|" .. group]
      return part and part.values > 0 and ("%.0f / %.0f"):format(percent(part.inside, part.values),
        percent(part.close_path, part.columns)) or "–"
    end))
  end
end
local columns = { "results", "values", "no bar", "inside", "≤ 3 errors", "rms inside", "rms ≤ 3 errors", "bar/error" }
print(("\n%d scenes, %d unsolved"):format(solved, #unsolved))
print(sg.table{ columns = columns, units = { "", "", "", "%", "%", "%", "%", "median" }, rows = overall,
                formats = { inside = "%.1f", ["≤ 3 errors"] = "%.1f", ["rms inside"] = "%.1f",
                            ["rms ≤ 3 errors"] = "%.1f", ["bar/error"] = "%.1f" } })
print "inside / rms ≤ 3 errors, %"
print(sg.table{ columns = lists.joined({ "results" }, groups), rows = divided })
for _, reason in ipairs(lists.sorted_names(reasons)) do
  print(("no bar in %d columns, %s"):format(reasons[reason], reason))
end
for _, line in ipairs(unsolved) do print(line) end
sg.csv.write(files "bars.csv", { columns = columns, rows = overall })
files:report()
return { scenes = solved, unsolved = unsolved, overall = overall, divided = divided }
