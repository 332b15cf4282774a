-- Cases of a problem as a study: executed, medians of the rounds taken, errors measured against the reference.
--
-- A problem has name, title, unit; scene(options) as solve.lua calls it, whose results are `force` and those of
-- second = { column, title }; reference { order, setting, mesh } and checks, a list of other cases: the largest
-- difference of their forces from that of the reference, a third of it with another mesh, is its error bar. A problem
-- with a function <column>(row, reference) gets this column from it.

local sg = require "signorini"
local solve = require "studies.accuracy.solve"

local study = {}

local function same(row, case)
  return row.order == case.order and row.setting == case.setting and row.mesh == case.mesh
    and (row.way or "") == (case.way or "")
end

--- True if a list has the case.
local function has(list, case)
  for _, one in ipairs(list) do
    if same(one, case) then return true end
  end
end

--- The first row that is this case and has not failed.
function study.find(rows, case)
  for _, row in ipairs(rows) do
    if same(row, case) and not row.failed then return row end
  end
end

--- The least and the largest processor time of a case over the rounds, in s.
local function spread(rows, case)
  local low, high = math.huge, 0
  for _, row in ipairs(rows) do
    if same(row, case) then low, high = math.min(low, row.cpu or low), math.max(high, row.cpu or high) end
  end
  return low, high
end

--- The columns of errors, for all rows but the reference.
local function with_errors(problem, medians, reference)
  local bar = 0
  for _, check in ipairs(problem.checks) do
    local row = study.find(medians.rows, check)
    -- Second order: the error is a third of the difference from elements twice as large.
    local part = check.mesh == problem.reference.mesh and 1 or 3
    if row then bar = math.max(bar, math.abs(row.force - reference.force) / part) end
  end
  local column = problem.second and problem.second[1]
  medians = medians:with("force.error", function(row) return row == reference and bar or nil end)
  if column and problem[column] then
    medians = medians:with(column, function(row)
      if row.failed or same(row, reference) then return nil end
      return problem[column](row, reference)
    end)
  end
  medians = medians:with("error", function(row)
    if row.failed or same(row, reference) then return nil end
    return 100 * math.abs(row.force / reference.force - 1)
  end, "%")
  return medians, 100 * bar / math.abs(reference.force)
end

--- Executes the missing ones of some cases { order, setting, mesh, way = nil, "steps × 4" or "plain Newton" } of a
--- problem in `rounds` rounds; once(case): those that are run in the first one only. The reference and its checks are
--- run once, first. Returns { problem, study, cases (of medians, with errors), reference (its row), bar (%) }.
function study.of(problem, cases, rounds, out, once)
  local list, scene = {}, problem.scene
  local function add(round, case)
    list[#list + 1] = { round = round, order = case.order, setting = case.setting, mesh = case.mesh,
                        way = case.way or "" }
  end
  add(1, problem.reference)
  for _, check in ipairs(problem.checks) do
    if not has(cases, check) then add(1, check) end
  end
  for round = 1, rounds do
    for _, case in ipairs(cases) do
      if (round == 1 or not once(case)) and not same(case, problem.reference) then add(round, case) end
    end
  end
  local executed = sg.study{
    name = "accuracy: " .. problem.name, folder = ("%s/%s"):format(out, problem.name), sequential = true,
    cases = { list }, units = { force = problem.unit, cpu = "s" },
    run = function(case)
      local plain, coarser = case.way == "plain Newton" or nil, case.way == "steps × 4" and 4 or nil
      return solve(scene, { order = case.order, setting = case.setting, mesh = case.mesh, plain = plain,
                              coarser = coarser })
    end,
  }
  executed:execute()
  local medians = executed:median "round"
  local reference = study.find(medians.rows, problem.reference)
  if not reference then error(("%s: the reference has failed"):format(problem.name), 0) end
  for _, row in ipairs(medians.rows) do row.cpu_low, row.cpu_high = spread(executed.rows, row) end
  local measured, bar = with_errors(problem, medians, reference)
  return { problem = problem, study = executed, cases = measured, wanted = cases, bar = bar, reference = reference,
           chosen = measured:where(function(row) return has(cases, row) end) }
end

return study
