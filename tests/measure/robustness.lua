-- Randomly generated scenes that are right in form and may be absurd in content, each checked and compared with itself
-- in other words.
--
-- Problem: a slab of one body, of two that are joined or tied, or of two patches; above it a body, a body and an
--          obstacle, or an obstacle. Patches (degrees, knots, weights, waves; folded, collapsed, thin), laws, layers,
--          supports, loads, contacts of all formulations, paths and controls are determined by a seed. A quarter of the
--          scenes has nothing absurd, others up to ten oddities: no supports, contradictory ones, E of 1e-9 to 1e9,
--          obstacles inside out, gaps of 1e6, paths a thousand times as long as the body, …
--          Each scene must be refused at the line of its script, or complete, or end early with a reason; all results
--          are finite, no open point penetrates, no contact without adhesion pulls, and external forces cancel. Deep
--          overlaps at the start, resultants of loads, inverted linear bodies and contacts given twice are found by
--          other means than the program's (robustness/oracles.lua). Variants must have the same outcome and forces:
--          solved again, turned, moved by 1e6, mirrored, in other units (1e-9 to 1e9), with other directions of the
--          patches, other names, slave and master exchanged (half passes), on two threads, by another linear solver,
--          continued from a checkpoint, returned to a snapshot, saved after every step.
-- Source: chosen here.
-- Units: those of the scene, E of the slab 1 and its width 2; tolerances are relative to the forces.
-- Expected: nothing is found. Outcomes of variants differ in some scenes whose iterations are near a border between
--           convergence and none.
-- Run: signorini tests/measure/robustness.lua [first=1] [count=2000] [family=any] [chunk=50] [variants=some] [jobs=2]
--      [limit=900] [out=out/robustness]; first, count: seeds; family: any scene, or scenes that look at one thing:
--      motion, strip, disc, placed, load, loose, ends (robustness/families.lua); chunk: scenes per process; variants:
--      none, some (two or three per scene) or all; limit: seconds per process. A second call continues from the results
--      in the folder. If a process crashes or exceeds its limit, the file seed_<first seed of its chunk> in the folder
--      has the seed of the scene.

local sg = require "signorini"
local families = require "robustness.families"
local survey = require "robustness.survey"

local options = sg.arguments{
  first = 1, count = { 2000, at_least = 1 }, chunk = { 50, at_least = 1 },
  family = { "any", choices = { "any", table.unpack(families.names) } },
  variants = { "some", choices = { "none", "some", "all" } }, jobs = 2, limit = 900.0, out = "out/robustness",
}
local files = sg.files(options.out)

local function solve(case)
  local name = files(("seed_%d"):format(case.first))
  local result = survey.run(case.first, case.count, case.variants, function(seed)
    local file = assert(io.open(name, "w"))
    file:write(seed, "\n")
    file:close()
  end, case.family ~= "any" and case.family or nil)
  os.remove(name)
  return result
end

local cases = {}
for first = options.first, options.first + options.count - 1, options.chunk do
  cases[#cases + 1] = { first = first, family = options.family, variants = options.variants,
                        count = math.min(options.chunk, options.first + options.count - first) }
end
local study = sg.study{ name = "robustness", folder = options.out .. "/chunks", cases = cases, run = solve }
study:execute{ jobs = options.jobs, limit = options.limit }

-- ── Tables ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local total = { outcomes = {}, refusals = {}, compared = {}, different = {} }
local scenes, found, apart, lost = 0, {}, {}, {}
for _, row in ipairs(study.rows) do
  if not row.scenes then
    lost[#lost + 1] = ("%d to %d: %s"):format(row.first, row.first + row.count - 1, row.outcome)
  else
    scenes = scenes + row.scenes
    for key, list in pairs(total) do
      for name, number in pairs(row[key]) do list[name] = (list[name] or 0) + number end
    end
    table.move(row.found, 1, #row.found, #found + 1, found)
    table.move(row.apart, 1, #row.apart, #apart + 1, apart)
  end
end

local outcomes = {} -- rows of the file: kind of count, name, number

--- Prints counts, the largest first, and adds them to the rows.
local function print_counts(title, counts)
  local names = {}
  for name in pairs(counts) do names[#names + 1] = name end
  table.sort(names, function(a, b)
    if counts[a] ~= counts[b] then return counts[a] > counts[b] end
    return a < b
  end)
  if #names == 0 then return end
  local rows = {}
  for i, name in ipairs(names) do
    rows[i] = { name, counts[name] }
    outcomes[#outcomes + 1] = { title, name, counts[name] }
  end
  print(sg.table{ columns = { title, "scenes" }, rows = rows })
end

print(("\n%d scenes from seed %d"):format(scenes, options.first))
print_counts("outcome", total.outcomes)
print_counts("refused", total.refusals)
print_counts("compared", total.compared)
print_counts("different", total.different)
for _, entry in ipairs{ { "found", found }, { "differ from a variant", apart }, { "processes that ended", lost } } do
  local title, list = entry[1], entry[2]
  if #list > 0 then print(("%s: %d\n%s"):format(title, #list, table.concat(list, "\n"))) end
end
sg.csv.write(files "outcomes.csv", { columns = { "count", "name", "scenes" }, rows = outcomes })
files:report()
return { scenes = scenes, total = total, found = found, apart = apart, lost = lost, study = study }
