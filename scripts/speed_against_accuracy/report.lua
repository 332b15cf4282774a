-- One problem's results in words, tables and charts, as a list of blocks for the terminal and the page: { text }, {
-- title, table }, { title, chart (file) }.

local sg = require "signorini"
local shares = require "speed_against_accuracy.shares"
local tables = require "speed_against_accuracy.tables"

local report = {}

local function amount(value, unit) return ("%.2e%s"):format(value, unit and " " .. unit or "") end

--- "a, b and c".
local function series(texts)
  local first = table.concat(texts, ", ", 1, #texts - 1)
  return #texts > 1 and ("%s and %s"):format(first, texts[#texts]) or texts[1]
end

--- The least and the largest error of a label.
local function extremes(comparison, label)
  local least, largest = math.huge, 0
  for _, curve in ipairs(comparison.curves) do
    for _, point in ipairs(curve.name == label and curve.points or {}) do
      least, largest = math.min(least, point.error), math.max(largest, point.error)
    end
  end
  return least, largest
end

--- Where a label stands against another one.
local function standing(comparison, error, label, other, found)
  if found.why then
    local _, worst = extremes(comparison, label)
    local best = extremes(comparison, other)
    if worst < best then
      return ("On all of its meshes %s has less %s than %s on any (at most %s, at least %s)."):format(label,
        error.title, other, amount(worst, error.unit), amount(best, error.unit))
    end
    return ("%s and %s reach no %s that both have (%s)."):format(label, other, error.title, found.why)
  end
  local parts, at = {}, {}
  for i, share in ipairs(found.share) do parts[i], at[i] = ("%.2f"):format(share), ("%.2e"):format(found.at[i]) end
  local unit = error.unit and " " .. error.unit or ""
  local range = ("at %s%s, the least, the middle and the largest that both reach"):format(series(at), unit)
  if at[1] == at[#at] then parts, range = { parts[1] }, ("at %s%s, which both reach"):format(at[1], unit) end
  return ("At equal %s %s takes %s of the time of %s (%s)."):format(error.title, label, series(parts), other, range)
end

--- The cases that none beats in both time and error.
local function front(comparison)
  local names = {}
  for i, row in ipairs(comparison.pareto) do
    names[i] = ("%s %s"):format(row.order, row.mesh)
  end
  return ("On the Pareto front, from the fastest to the best: %s."):format(series(names))
end

--- What has no place in a chart, by name.
local function left_out(comparison)
  local lines = {}
  for i, one in ipairs(comparison.left_out) do
    lines[i] = ("%s at %s (%s)"):format(one.row.order, one.row.mesh, tables.reason(one.row) or one.why)
  end
  return #lines > 0 and ("Not in the chart: %s."):format(series(lines)) or nil
end

local function words(comparison, error)
  local lines = {}
  for _, pair in ipairs(shares.pairs) do
    local found = shares.of(comparison, pair[1], pair[2])
    if found then lines[#lines + 1] = standing(comparison, error, pair[1], pair[2], found) end
  end
  lines[#lines + 1] = front(comparison)
  lines[#lines + 1] = left_out(comparison)
  return table.concat(lines, " ")
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
    blocks[#blocks + 1] = { text = ("No case has a %s: see the table of cases."):format(error.title) }
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
  blocks[#blocks + 1] = { text = words(comparison, error) }
  local ratios = tables.ratios(comparison, error)
  sg.csv.write(files(chart .. "_ratios.csv"), { columns = { "label", "against", "least_error", "largest_error",
    "share_at_least", "share_in_the_middle", "share_at_largest" }, rows = ratios.rows })
  if #ratios.rows > 0 then
    blocks[#blocks + 1] = { title = ("What a label takes of another one's time at equal %s"):format(error.title),
                            table = ratios }
  end
  local least = tables.least(measured, error, time)
  if #least.rows > 0 then
    blocks[#blocks + 1] = { title = ("The least that is enough for the %s of N2"):format(error.title), table = least }
  end
  return comparison
end

--- Of how many runs a time is the median.
local function words_on_rounds(measured)
  local once = {}
  for _, mesh in ipairs(measured.meshes) do
    if measured.problem.once and measured.problem.once[mesh] then once[#once + 1] = mesh end
  end
  if measured.rounds == 1 then return "one run of each" end
  return ("times are medians of %d runs%s"):format(measured.rounds,
    #once > 0 and (", but of one at %s"):format(series(once)) or "")
end

--- Draws the charts of a measured problem (study.lua) and writes its tables. `files(name)` and files.page(name) give
--- the paths of files. Returns { measured, comparisons (by error), blocks }.
function report.of(measured, options, files)
  local problem = measured.problem
  local blocks, comparisons = { { text = problem.about } }, {}
  for _, error in ipairs(problem.errors) do
    comparisons[error.name] = compare(measured, error, options, files, blocks)
  end
  local published = tables.published(measured, options.time)
  if #published.rows > 0 then
    blocks[#blocks + 1] = { title = ("Savings that the thesis prints (%s), and ours"):format(problem.saved_in),
                            table = published }
  else
    blocks[#blocks + 1] = { text = #problem.savings == 0 and "No published time of this problem is known to us."
      or "None of the pairs was run whose saving the thesis prints." }
  end
  local cases = tables.cases(measured, options.time)
  blocks[#blocks + 1] = { title = ("All cases (%s)"):format(words_on_rounds(measured)), table = cases }
  measured.cases:csv(files(problem.name .. ".csv"))
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
