-- Tables, charts and files of block and cylinder ironing. A case is what study.solve returns.

local sg = require "signorini"

local output = {}

--- How a run ended: "complete", or why and where the die was.
local function ending(case)
  if not case.run.failed then return "complete" end
  return case.x[1] and ("%s at x = %.2f"):format(case.run.reason, case.x[#case.x]) or case.run.reason
end

--- Degrees of freedom, work, first failure of plain Newton, and how the run ended.
function output.work_table(cases)
  local rows = {}
  for i, case in ipairs(cases) do
    local run, spent, failure = case.run, case.run.timings, case.first_failure
    rows[i] = { case.order, case.dofs.die, case.dofs.slab, case.dofs.total, run.iterations,
                run.iterations / math.max(1, run.steps),
                failure and ("%s in step %d"):format(failure.reason, failure.step) or "none", run.cutbacks,
                ending(case), case.user, run.wall, spent.bulk, spent.contact, spent.linear }
  end
  return sg.table{
    columns = { "order", "die", "slab", "total", "iterations", "iterations", "first failure", "cut-backs", "end",
                "user", "wall", "bulk", "contact", "linear" },
    units = { "", "DOFs", "DOFs", "DOFs", "", "per step", "", "", "", "s", "s", "s", "s", "s" }, rows = rows,
    formats = { "%s", "%d", "%d", "%d", "%d", "%.2f", "%s", "%d", "%s", "%.1f", "%.1f", "%.1f", "%.1f", "%.1f" },
  }
end

local force_columns = { "order", "pressed", "drag_mean", "drag_low", "drag_high", "dPz", "dPz_percent", "dPz_detrended",
                        "dPz_detrended_percent", "dPx", "dPx_percent", "dPx_detrended", "dPx_detrended_percent" }

local function force_rows(cases)
  local rows = {}
  for i, case in ipairs(cases) do
    local drag, dPz, dPx = case.drag or {}, case.dPz, case.dPx
    rows[i] = { case.order, case.pressed, drag.mean, drag.low, drag.high,
                dPz.raw, dPz.raw_percent, dPz.detrended, dPz.detrended_percent,
                dPx.raw, dPx.raw_percent, dPx.detrended, dPx.detrended_percent }
  end
  return rows
end

--- Pressing force at the full depth and while the die slides, oscillations raw and detrended by a parabola.
function output.force_table(cases)
  return sg.table{
    columns = { "order", "Pz", "Pz", "Pz", "Pz", "dPz", "dPz", "detrended", "detrended", "dPx", "dPx", "detrended",
                "detrended" },
    units = { "", "pressed", "mean", "least", "greatest", "", "% of N2", "", "% of N2", "", "% of N2", "", "% of N2" },
    rows = force_rows(cases),
    formats = { "%s", "%.5g", "%.5g", "%.5g", "%.5g", "%.2e", "%.1f", "%.2e", "%.1f", "%.2e", "%.1f", "%.2e", "%.1f" },
  }
end

function output.force_csv(file, cases, comment)
  sg.csv.write(file, { columns = force_columns, rows = force_rows(cases), comments = { comment } })
end

--- Pressing force or drag over the die's place while it slides, all orders; returns whether there was anything to draw.
function output.draw_force(file, cases, key, chart)
  chart.file, chart.xlabel = file, "x of the die's center"
  for _, case in ipairs(cases) do
    local line = { x = {}, y = {}, label = case.order }
    for i = case.press, #case.x do line.x[#line.x + 1], line.y[#line.y + 1] = case.x[i], case[key][i] end
    if #line.x > 1 then chart[#chart + 1] = line end
  end
  if #chart > 0 then sg.chart(chart) end
  return #chart > 0
end

--- Pressing force over the load step, all orders; returns whether there was anything to draw.
function output.draw_path(file, cases, title)
  local chart = { file = file, title = title, xlabel = "load step", ylabel = "pressing force Pz" }
  for _, case in ipairs(cases) do
    if case.run.steps > 0 then
      chart[#chart + 1] = { x = case.run:column "step", y = case.Pz, label = case.order }
    end
  end
  if #chart > 0 then sg.chart(chart) end
  return #chart > 0
end

--- Oscillations by discretization in % of those of N2; returns whether there was anything to draw.
function output.draw_oscillations(file, cases, title)
  local chart = { file = file, title = title, ylabel = "oscillation (% of N2)", log = "y",
                  xrange = { 0.5, #cases + 0.5 }, xticks = {} }
  for i, case in ipairs(cases) do chart.xticks[i] = { i, case.order } end
  for _, curve in ipairs {
    { "dPz", "raw", "dPz" }, { "dPx", "raw", "dPx" }, { "dPz", "detrended", "dPz detrended" },
    { "dPx", "detrended", "dPx detrended" },
  } do
    local line = { x = {}, y = {}, label = curve[3], line = false, markers = true }
    for i, case in ipairs(cases) do
      local value = case[curve[1]][curve[2] .. "_percent"]
      if value then line.x[#line.x + 1], line.y[#line.y + 1] = i + (curve[2] == "raw" and -0.1 or 0.1), value end
    end
    if #line.x > 0 then chart[#chart + 1] = line end
  end
  if #chart > 0 then sg.chart(chart) end
  return #chart > 0
end

return output
