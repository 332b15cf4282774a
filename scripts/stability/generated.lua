-- Randomly generated models: bodies pressed into a slab and dragged along it, original and mirrored.
--
-- Problem: a block, a half ring or a rigid cylinder (in 3D also an indenter with a spherical bottom) is pressed into a
--          slab by 0.01 to 0.2 and dragged along it by up to 0.6 (0.3 in 3D). Shape, slave, orders, meshes, E (0.1 to
--          1000, slab: 1), mu (0 to 0.8), penalty and steps are determined by a seed, so model number 17 is always the
--          same. If the block is the master, its edges, where the master face ends, cut into the slab.
--
--                 ______
--                | body |         body: block 0.8 × 0.5, half ring of radii 0.3 and 0.5, cylinder of radius 0.4,
--          ______|______|______         top driven
--         |      <---->        |
--         |  slab: 4 × 1       |  in 3D the slab is 2 × 1.2 × 0.6, the bodies are 0.5 wide
--         |____________________|
--
--          Neo-Hooke, nu = 0.3, plane strain or solids, with the controls of sg.robust. Mirrored models replace x by
--          -x: all forces must be equal except for their sign. Runs that are saved after every step must have the same
--          forces.
-- Source: chosen here.
-- Units: the units of E; forces per depth in plane strain.
-- Expected: if the master has no sharp edges, all models complete except one in several hundred; if the block is the
--           master, about 1 % end early (35 % if the traction ended at the boundary of the master face).
-- Run: signorini stability/generated.lua [kind=plane] [first=1] [count=2209] [mirror=no] [saved=no] [law=gpts]
--      [ends=no] [tilt=0] [fewer=1] [jobs=2] [limit=600] [out=out/stability/generated]; kind: plane (2D) or space (3D);
--      first, count: seeds; law: gpts, mortar, multipliers or among, in which all outer faces of the body are in the
--      contact; ends: only the scenes with the block as master; tilt: degrees up to which blocks in space lean, so that
--      a corner or an edge touches first; fewer: divides the numbers of steps, so that more of them are cut; limit:
--      seconds per model. A second call continues from the results in the folder.

local sg = require "signorini"
local scenes = require "generated.scenes"

local laws = { gpts = {}, mortar = { method = "mortar" },
               multipliers = { method = "mortar", enforcement = "multipliers" }, among = {} }
local options = sg.arguments{
  kind = { "plane", choices = scenes.kinds }, first = 1, count = 2209, mirror = false, saved = false,
  law = { "gpts", choices = { "gpts", "mortar", "multipliers", "among" } }, ends = false,
  tilt = { 0.0, at_least = 0, at_most = 45 }, fewer = { 1, at_least = 1 },
  jobs = 2, limit = 600.0, out = "out/stability/generated",
}
local tolerance = 1e-5 -- of the largest force, for a scene and its mirror image, or the same that is saved

-- ── Runs ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

local function solve(case)
  local scene = scenes.describe(case.kind, case.seed)
  scene.law, scene.outline, scene.tilt = laws[case.law], case.law == "among", case.tilt
  for stage, steps in pairs(scene.steps) do scene.steps[stage] = math.max(1, steps // case.fewer) end
  local _, account = scenes.solve(scene, sg.robust{})
  local result = {
    shape = scene.shape, slave = scene.slave, ending = account.ending, steps = account.steps,
    iterations = account.iterations, cutbacks = account.cutbacks, fallback_steps = account.fallback_steps,
    forces = account.forces,
  }
  if case.mirror then
    local _, image = scenes.solve(scene, sg.robust{}, true)
    result.image, result.difference = image.ending, scenes.difference(account, image)
    result.image_cutbacks = image.cutbacks
  end
  if case.saved then
    local file = os.tmpname()
    local _, saved = scenes.solve(scene, sg.robust{ checkpoint = file })
    os.remove(file)
    result.saved_ending, result.saved_difference = saved.ending, scenes.difference(account, saved)
  end
  return result
end

local seeds = {}
for seed = options.first, options.first + options.count - 1 do
  local scene = scenes.describe(options.kind, seed)
  if not options.ends or (scene.shape == "block" and scene.slave == "slab") then seeds[#seeds + 1] = seed end
end
local name = options.kind .. (options.mirror and "_mirrored" or "") .. (options.saved and "_saved" or "")
  .. (options.law ~= "gpts" and "_" .. options.law or "") .. (options.fewer > 1 and "_" .. options.fewer or "")
  .. (options.ends and "_ends" or "") .. (options.tilt > 0 and ("_%g"):format(options.tilt) or "")
local study = sg.study{
  name = "generated " .. options.kind, folder = options.out .. "/" .. name, run = solve,
  cases = sg.grid{ kind = { options.kind }, mirror = { options.mirror }, saved = { options.saved },
                   law = { options.law }, fewer = { options.fewer }, tilt = { options.tilt }, seed = seeds },
}
study:execute{ jobs = options.jobs, limit = options.limit }

-- ── Tables ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The outcome of a row: that of the run, or that of the process.
local function ending(row) return row.ending or row.outcome end

local rows = {}
for _, row in ipairs(study.rows) do rows[#rows + 1] = row end

--- Counts the rows by shape and slave, and how each of them ended: { name, scenes, iterations, ends }.
local function count()
  local kinds, endings = {}, {}
  for _, row in ipairs(rows) do
    local name = row.shape and ("%s, slave: %s"):format(row.shape, row.slave) or "unknown"
    local how = ending(row)
    for _, key in ipairs { name, "all" } do
      if not kinds[key] then
        kinds[key] = { name = key, scenes = 0, iterations = 0, ends = { completed = 0 } }
        kinds[#kinds + 1] = kinds[key]
      end
      local kind = kinds[key]
      kind.scenes, kind.ends[how] = kind.scenes + 1, (kind.ends[how] or 0) + 1
      kind.iterations = kind.iterations + (row.iterations or 0)
    end
    if how ~= "completed" and not endings[how] then
      endings[how] = true
      endings[#endings + 1] = how
    end
  end
  table.sort(kinds, function(a, b) return (a.name == "all" and "~" or a.name) < (b.name == "all" and "~" or b.name) end)
  table.sort(endings)
  return kinds, endings
end

local kinds, endings = count()
local lines = {}
for i, kind in ipairs(kinds) do
  local early = kind.scenes - kind.ends.completed
  lines[i] = { kind.name, kind.scenes, early, 100 * early / kind.scenes, kind.iterations / kind.scenes }
  for _, how in ipairs(endings) do table.insert(lines[i], kind.ends[how] or 0) end
end
print(("\nScenes %d to %d%s, and their outcomes"):format(options.first, options.first + options.count - 1,
  options.kind == "space" and " in 3D" or ""))
print(sg.table{
  columns = { "body and slave", "scenes", "early", "part", "per run", table.unpack(endings) },
  units = { "", "", "", "%", "iterations" }, rows = lines, formats = { part = "%.1f", ["per run"] = "%.0f" },
})

--- Prints the seeds of the rows that satisfy a condition in one line; nothing if there are none.
local function print_seeds(text, holds)
  local found = {}
  for _, row in ipairs(rows) do
    if holds(row) then found[#found + 1] = row.seed end
  end
  if #found > 0 then print(("%s: %d: %s"):format(text, #found, table.concat(found, " "))) end
  return found
end

local early = print_seeds("\nend early", function(row) return ending(row) ~= "completed" end)

--- Prints the seeds of the rows whose variant ends in another way, or with other forces: two lists.
local function compare(variant, outcome, difference)
  local unlike = print_seeds("differ in outcome when " .. variant, function(row)
    return row.ending and row[outcome] ~= row.ending
  end)
  local apart = print_seeds(("complete, but differ by more than %g of the largest force"):format(tolerance),
    function(row)
      return row.ending == "completed" and row[outcome] == "completed" and row[difference] > tolerance
    end)
  print(("of %d scenes %d differ in outcome when %s, %d by more than %g of the largest force"):format(#rows, #unlike,
    variant, #apart, tolerance))
  return unlike, apart
end

local unlike, apart = {}, {}
if options.mirror then unlike, apart = compare("mirrored", "image", "difference") end
if options.saved then compare("saved", "saved_ending", "saved_difference") end
local files = sg.files(options.out)
study:csv(files(name .. ".csv"))
study:report(files(name .. ".html"))
files:report()
return { study = study, kinds = kinds, early = early, unlike = unlike, apart = apart, files = files }
