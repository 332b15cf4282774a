-- One problem's results as a sentence, tables and charts, as a list of blocks for the terminal and the page: { text },
-- { title, table }, { title, chart (file) }.

local sg = require "signorini"
local ratios = require "studies.speed_against_accuracy.ratios"
local tables = require "studies.speed_against_accuracy.tables"

local report = {}

--- "a, b and c".
local function series(texts)
  local first = table.concat(texts, ", ", 1, #texts - 1)
  return #texts > 1 and ("%s and %s"):format(first, texts[#texts]) or texts[1]
end

--- The smallest and the largest error of an order.
local function extremes(comparison, order)
  local least, largest = math.huge, 0
  for _, curve in ipairs(comparison.curves) do
    for _, point in ipairs(curve.name == order and curve.points or {}) do
      least, largest = math.min(least, point.error), math.max(largest, point.error)
    end
  end
  return least, largest
end

--- Whether the largest error of one order is below the smallest of another one.
local function is_better(comparison, order, other)
  local _, worst = extremes(comparison, order)
  return worst < extremes(comparison, other)
end

--- The clauses of the conclusion on a pair of orders: the range of time ratios over all errors, and the errors without
--- a common range that are smaller in any case.
local function add_clauses(comparisons, errors, pair, clauses, better)
  local low, high, smaller = math.huge, 0, {}
  for _, error in ipairs(errors) do
    local comparison = comparisons[error.name]
    local found = comparison and ratios.of(comparison, pair[1], pair[2])
    for _, ratio in ipairs(found and found.ratio or {}) do low, high = math.min(low, ratio), math.max(high, ratio) end
    if found and found.why and is_better(comparison, pair[1], pair[2]) then smaller[#smaller + 1] = error.title end
  end
  if high > 0 then
    clauses[#clauses + 1] = ("%s takes %.2f to %.2f of the time of %s"):format(pair[1], low, high, pair[2])
  end
  if #smaller > 0 then
    better[#better + 1] = ("%s has a smaller %s on every mesh than %s on any"):format(pair[1], series(smaller), pair[2])
  end
end

--- The conclusion on a problem, one sentence.
local function conclusion(comparisons, errors)
  local clauses, better = {}, {}
  for _, pair in ipairs(ratios.pairs) do add_clauses(comparisons, errors, pair, clauses, better) end
  local parts = {}
  if #clauses > 0 then parts[1] = "At equal error " .. series(clauses) end
  if #better > 0 then parts[#parts + 1] = series(better) end
  return #parts > 0 and table.concat(parts, "; ") .. "." or "No two of the compared orders reach a common error."
end

--- The cases that are not in a chart.
local function left_out(comparison)
  local lines = {}
  for i, one in ipairs(comparison.left_out) do
    lines[i] = ("%s at %s (%s)"):format(one.row.order, one.row.mesh, tables.reason(one.row) or one.why)
  end
  return #lines > 0 and ("Not in the chart: %s."):format(series(lines)) or nil
end

local function has_errors(cases, error)
  for _, row in ipairs(cases.rows) do
    if row[error.name] then return true end
  end
  return false
end

--- Compares and draws one error; adds its blocks.
local function compare(measured, error, options, files, blocks)
  local problem, time = measured.problem, options.time
  if not has_errors(measured.cases, error) then
    blocks[#blocks + 1] = { text = ("No case has a value of %s; see the table of cases."):format(error.title) }
    return nil
  end
  local chart = ("%s_%s"):format(problem.name, error.name)
  local title = ("%s: %s over time"):format(problem.title, error.title)
  local pictures = { files(chart .. ".svg"), files(chart .. ".png") }
  if options.page ~= "none" then pictures[3] = files.page(chart .. ".png") end
  local comparison = sg.work_precision(measured.cases, {
    time = time, error = error.name, series = "order", marker = "mesh", files = pictures, size = { 1600, 1000 },
    title = title,
    xlabel = time == "cpu" and "processor time (s)" or "time (s)",
    ylabel = error.unit and ("%s (%s)"):format(error.title, error.unit) or error.title,
  })
  blocks[#blocks + 1] = { title = title, chart = chart .. ".png" }
  local missing = left_out(comparison)
  if missing then blocks[#blocks + 1] = { text = missing } end
  local ratio_table = tables.ratios(comparison, error)
  sg.csv.write(files(chart .. "_ratios.csv"), { columns = { "order", "against", "least_error", "largest_error",
    "ratio_at_smallest", "ratio_in_the_middle", "ratio_at_largest" }, rows = ratio_table.rows })
  if #ratio_table.rows > 0 then
    blocks[#blocks + 1] = { title = ("Ratio of times, A to B, at equal %s"):format(error.title), table = ratio_table }
  end
  local least = tables.least(measured, error, time)
  if #least.rows > 0 then
    blocks[#blocks + 1] = { title = ("Fastest cases with at most the %s of N2"):format(error.title), table = least }
  end
  return comparison
end

--- The number of runs of which a time is the median.
local function words_on_rounds(measured)
  local once = {}
  for _, mesh in ipairs(measured.meshes) do
    if measured.problem.once and measured.problem.once[mesh] then once[#once + 1] = mesh end
  end
  if measured.rounds == 1 then return "one run of each" end
  return ("times are medians of %d runs%s"):format(measured.rounds,
    #once > 0 and (", of one at %s"):format(series(once)) or "")
end

--- Draws the charts of a measured problem (study.lua) and writes its tables. `files(name)` and files.page(name) return
--- the paths of files. Returns { measured, comparisons (by error), blocks }.
function report.of(measured, options, files)
  local problem = measured.problem
  local blocks, comparisons = { { text = problem.about } }, {}
  for _, error in ipairs(problem.errors) do
    comparisons[error.name] = compare(measured, error, options, files, blocks)
  end
  table.insert(blocks, 2, { text = conclusion(comparisons, problem.errors) })
  local fronts = tables.fronts(comparisons, problem.errors)
  if #fronts.rows > 0 then
    blocks[#blocks + 1] = { title = "Pareto fronts, from the fastest to the most accurate case", table = fronts }
  end
  local published = tables.published(measured, options.time)
  if #published.rows > 0 then
    blocks[#blocks + 1] = { title = ("Time saved, as published (%s) and here"):format(problem.saved_in),
                            table = published }
  else
    blocks[#blocks + 1] = { text = #problem.savings == 0 and "There are no published times of this problem."
      or "No pair with a published saving was run." }
  end
  local cases = tables.cases(measured, options.time)
  blocks[#blocks + 1] = { title = ("All cases (%s)"):format(words_on_rounds(measured)), table = cases }
  measured.cases:csv(files(problem.name .. ".csv"))
  measured.cases:report{ file = files(problem.name .. ".html"), title = problem.title }
  return { measured = measured, comparisons = comparisons, blocks = blocks }
end

--- Prints the blocks of a problem.
function report.print(result)
  print(("\n── %s ──"):format(result.measured.problem.title))
  for _, block in ipairs(result.blocks) do
    if block.text then print("\n" .. block.text) end
    if block.table then print(("\n%s\n%s"):format(block.title, sg.table(block.table))) end
  end
end

return report
