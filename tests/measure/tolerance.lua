-- True errors and cost of model:run(path, { tolerance = … }), compared with the cheapest setting of a study.
--
-- Problem: ten problems on coarse meshes (tolerance/scenes.lua): a half ring that slides on a slab with friction, Hertz
--          contacts of a line and of a sphere, a pin in a bore, a lip seal, two rings, a strip that peels by a moment,
--          cohesive beams; in space a cylinder and a block that slide on a slab. Each is solved to tolerances of one
--          result (the largest difference over the path in % of its largest value), and by a study over the mesh, a
--          layer at the contact, penalties and steps. The reference has smaller elements, a layer, penalties and steps
--          of its own; its error is estimated by another one with elements 1.5 times as large, a third of the penalties
--          and half of the steps.
-- Source: chosen here; the scenes are those of sg.scenes where there is one.
-- Units: seconds of processor time, of companions and all levels; work is the sum of unknowns times iterations.
-- Expected: see share/doc/use/errors.md. The levels solve several times the work of the cheapest setting of the study,
--           which reaches the tolerance with a bar far above it, or by errors that cancel.
-- Run: signorini tests/measure/tolerance.lua [problems=ironing,line,sphere,pin,seal,rings,peeling,cohesive,cylinder,
--      block] [tolerances=5,2,0.5] [study=yes] [most=3] [limit=60] [reference=1] [keep=no] [out=out/tolerance];
--      tolerances: those that the problem has (0.5 only in the plane); study=no leaves the study out; most: seconds of
--      its longest solution; limit: wall time after which no further level begins; reference: factor on the elements
--      of the references; keep=yes reuses the references and studies that an earlier call left in the folder.

local sg = require "signorini"
local scenes = require "tolerance.scenes"
local solve = require "tolerance.solve"

local names = {}
for i, problem in ipairs(scenes) do names[i] = problem.name end
local options = sg.arguments{ problems = { names, choices = names }, tolerances = { { 5, 2, 0.5 }, above = 0 },
                              study = { "yes", choices = { "yes", "no" } }, most = { 3.0, above = 0 },
                              limit = { 60.0, above = 0 }, reference = { 1.0, above = 0 },
                              keep = { "no", choices = { "yes", "no" } }, out = "out/tolerance" }
local files = sg.files(options.out)

local function has(list, value)
  for _, one in ipairs(list) do
    if one == value then return true end
  end
end

-- ── Reference and study ──────────────────────────────────────────────────────────────────────────────────────────────

--- The reference of a problem, a curve with an estimate of its own error in %.
local function reference_of(problem)
  local own = setmetatable({ elements = options.reference * problem.reference.elements },
    { __index = problem.reference })
  local curve = assert(solve.with(problem, own), problem.name .. ": the reference has failed")
  local coarser = solve.with(problem, { elements = own.elements / 1.5, row = own.row, penalty = own.penalty / 3,
                                        steps = math.max(1, own.steps / 2) })
  curve.error = coarser and solve.error(coarser, curve)
  return curve
end

--- The settings { elements, row, penalty, steps, error, time, work } of a problem from the coarsest mesh on, until
--- meshes take longer than `most` seconds, or longer than a setting that reaches the lowest tolerance. Left out are
--- further penalties once the error of a mesh has decreased by less than a tenth, and more steps where they have not
--- decreased it on the coarsest mesh.
local function study_of(problem, reference)
  local list, least, lowest = {}, options.most, math.min(table.unpack(problem.tolerances))
  local function solved(elements, row, penalty, steps)
    local one = { elements = elements, row = row, penalty = penalty, steps = steps }
    local curve
    curve, one.time, one.work = solve.with(problem, one)
    one.error = curve and solve.error(curve, reference) or nil
    if one.error and one.error <= lowest then least = math.min(least, one.time) end
    list[#list + 1] = one
    return one
  end
  local few, many = solved(1, false, 1, 1), solved(1, false, 1, 2)
  local all_steps = few.error and many.error and few.error - many.error < lowest / 4 and { 1 } or { 1, 2 }
  for _, row in ipairs { false, true } do
    local size, before = 1, 0 -- elements and time of the mesh before
    for _, elements in ipairs { 1, 1.5, 2, 3, 4, 6, 8 } do
      if before * (elements / size) ^ (#problem.tolerances == 2 and 3 or 2) > least then break end
      size, before = elements, math.huge
      for _, steps in ipairs(all_steps) do
        local last = math.huge
        for _, penalty in ipairs { 1, 3, 10, 30 } do
          local one = solved(elements, row, penalty, steps)
          before = math.min(before, one.time)
          if (one.error or math.huge) > 0.9 * last then break end
          last = one.error or math.huge
        end
      end
    end
  end
  return list
end

local function known(problem)
  local file = files(problem.name .. ".json")
  local old = options.keep == "yes" and pcall(sg.json.read, file) and sg.json.read(file) or {}
  local reference = old.reference or reference_of(problem)
  local study = old.study or options.study == "yes" and study_of(problem, reference) or nil
  sg.json.write(file, { reference = reference, study = study })
  return reference, study
end

--- The setting of the study with the least work whose error is within a tolerance.
local function cheapest(study, tolerance)
  local best
  for _, one in ipairs(study or {}) do
    if one.error and one.error <= tolerance and not (best and best.work <= one.work) then best = one end
  end
  return best
end

local function text_of(one)
  return one and ("%s%g%s%s"):format(one.row and "row " or "", one.elements,
    one.penalty > 1 and (" ε %g"):format(one.penalty) or "", one.steps > 1 and (" n %g"):format(one.steps) or "")
end

-- ── Table ────────────────────────────────────────────────────────────────────────────────────────────────────────────

local rows, result = {}, {}
local count = { cases = 0, inside = 0, compared = 0, cheap = 0 }
for _, problem in ipairs(scenes) do
  if has(options.problems, problem.name) then
    local reference, study = known(problem)
    for _, tolerance in ipairs(problem.tolerances) do
      if has(options.tolerances, tolerance) then
        local own, best = solve.to(problem, tolerance, options.limit), cheapest(study, tolerance)
        local settings, error = own.run.settings, own.curve and solve.error(own.curve, reference)
        local ratio = best and own.work / best.work
        local inside = settings.reached and error and error <= tolerance
        count.cases, count.inside = count.cases + 1, count.inside + (inside and 1 or 0)
        if ratio then
          count.compared, count.cheap = count.compared + 1, count.cheap + (ratio <= 3 and 1 or 0)
        end
        rows[#rows + 1] = { problem.name, tolerance, settings.reached and "yes" or "no", error, reference.error,
                            #settings.levels, settings.text, own.time, own.work, text_of(best), best and best.time,
                            best and best.work, ratio }
        result[#result + 1] = { problem.name, tolerance, error, ratio }
        print(("%s, %g %%: error %.3g %%"):format(problem.name, tolerance, error or 0 / 0))
      end
    end
  end
end
local columns = { "problem", "tolerance", "reached", "error", "reference", "levels", "settings", "time", "work",
                  "cheapest", "time", "work", "ratio" }
print(sg.table{ columns = columns, units = { "", "%", "", "%", "± %", "", "", "s", "", "", "s", "", "" }, rows = rows,
                formats = { [2] = "%g", [4] = "%.2g", [5] = "%.2g", [8] = "%.2f", [9] = "%.2g", [11] = "%.2f",
                            [12] = "%.2g", [13] = "%.2g" } })
print(("%d of %d within the tolerance, %d of %d with at most three times the work of the cheapest setting")
  :format(count.inside, count.cases, count.cheap, count.compared))
sg.csv.write(files "tolerance.csv", { columns = { "problem", "tolerance", "error", "ratio of work" }, rows = result })
files:report()
return result
