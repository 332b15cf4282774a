-- Common parts of the studies in this folder: arguments, both convergence maps of a problem (plain Newton and all
-- controls), their comparison, and files.

local sg = require "signorini"
local formulations = require "formulations.rows"
local controls = require "stability.controls"

local study = {}

-- ── Arguments ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The arguments of a script: its own defaults, as sg.arguments takes them, and those that all maps have.
function study.arguments(defaults)
  defaults.jobs, defaults.limit, defaults.keep = 2, { 600.0, above = 0 }, false
  defaults.with = { "robust", choices = controls.names }
  return sg.arguments(defaults)
end

-- ── Maps ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The iterations of the cells in which both maps converge.
local function work(plain, robust)
  local before, after = 0, 0
  for _, cell in ipairs(plain.cells) do
    local other = robust:cell(cell.x, cell.y)
    if cell.outcome == "completed" and other.outcome == "completed" then
      before, after = before + cell.iterations, after + other.iterations
    end
  end
  return before, after
end

local function pairs_text(cells)
  local texts = {}
  local function text(value) return type(value) == "number" and ("%g"):format(value) or value end
  for i, cell in ipairs(cells) do texts[i] = ("%s, %s"):format(text(cell[1]), text(cell[2])) end
  return table.concat(texts, "; ")
end

--- Prints both maps with their titles, and the recovered and lost cells. Returns the comparison, with the
--- iterations of the cells in which both converge.
local function report(plain, robust, titles)
  for i, map in ipairs { plain, robust } do print(("\n%s: %s"):format(titles[i], tostring(map))) end
  local result = plain:compare(robust)
  local converged, total = plain:converged()
  local lost = #result.lost > 0 and (" (%s)"):format(pairs_text(result.lost)) or ""
  print(("\n%s: plain Newton converged in %d of %d cells, controls in %d; recovered %d, failed with controls only %d%s")
    :format(plain.name, converged, total, (robust:converged()), #result.recovered, #result.lost, lost))
  result.plain_iterations, result.robust_iterations = work(plain, robust)
  if result.plain_iterations > 0 then
    print(("iterations in cells where both converge: %d and %d, ratio %.3f"):format(result.plain_iterations,
      result.robust_iterations, result.robust_iterations / result.plain_iterations))
  end
  return result
end

--- Draws a number of all cells with controls, since those of plain Newton are the same where it converges; a star marks
--- the cells in which it fails.
local function draw_numbers(file, chart, name, plain, robust)
  local x, y, values, texts, any = robust.x, robust.y, {}, {}, false
  for j, row in ipairs(y.values) do
    values[j], texts[j] = {}, {}
    for i, column in ipairs(x.values) do
      local value, failed = robust:cell(column, row).results[chart.name], plain:cell(column, row).outcome ~= "completed"
      values[j][i], any = value, any or failed
      texts[j][i] = value and ("%.2g%s"):format(value, failed and " *" or ""):gsub("e%-0*(%d+)", "·10^{−%1}")
    end
  end
  sg.heatmap{ file = file, x = x.values, y = y.values, xlabel = x.name, ylabel = y.name, values = values, texts = texts,
              log = chart.log, label = chart.label,
              title = ("%s: %s%s"):format(name, chart.label, any and " (* plain Newton fails)" or "") }
end

--- Solves a problem's map with both options. `problem`: name, x, y, scene, results as sg.convergence_map takes them,
--- path(model, x, y) with the overrides of model:run's options that both ways need, charts (further pictures: the name
--- of a result, log and label as in sg.heatmap, and `key`, their file's name), `key`, part of the files' names when a
--- script has several problems, and `formulation`, a row of formulations/rows.lua that the scenes use. Returns
--- { plain, robust, comparison }; `files` is the result of sg.files.
function study.solve(problem, options, files)
  local function file(name) return files((problem.key and problem.key .. "_" or "") .. name) end
  local path, titles = problem.path, { controls.titles.plain, controls.titles[options.with] }
  local formulation = problem.formulation
  local other = formulation and formulation ~= formulations.gpts
  local name_of_map = problem.name .. (other and ", " .. formulation.label or "")
  local function solve(kind)
    local name = file(kind .. ".csv")
    if not options.keep then os.remove(name) end
    return sg.convergence_map{
      name = name_of_map, x = problem.x, y = problem.y, scene = problem.scene, results = problem.results,
      jobs = options.jobs, limit = options.limit, file = name,
      path = function(model, x, y)
        local stages, overrides = path(model, x, y)
        return stages, controls[kind](overrides or {})
      end,
    }
  end
  local plain, robust = solve "plain", solve(options.with)
  local comparison = report(plain, robust, titles)
  plain:picture{ file = file "outcomes.png", title = name_of_map .. ": outcome and Newton iterations",
                 other = robust, titles = titles }
  for _, chart in ipairs(problem.charts or {}) do
    draw_numbers(file(chart.key .. ".png"), chart, name_of_map, plain, robust)
  end
  for i, kind in ipairs { "plain", options.with } do
    local map = i == 1 and plain or robust
    map:report{ file = file(kind .. ".html"), title = ("%s, %s"):format(name_of_map, titles[i]) }
  end
  return { plain = plain, robust = robust, comparison = comparison }
end

return study
