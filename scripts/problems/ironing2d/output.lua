-- Tables and charts of ironing runs. A case is what problem.solve returns; `case.work` is the run whose time counts.

local sg = require "signorini"

local output = {}

--- Degrees of freedom, iterations, and where the time went.
function output.work_table(cases)
  local rows = {}
  for i, case in ipairs(cases) do
    local run, spent = case.work, case.work.timings
    rows[i] = { case.order, case.die_dofs.total, case.slab_dofs.total, case.die_dofs.total + case.slab_dofs.total,
                case.die_dofs.interface + case.slab_dofs.interface, run.iterations / math.max(1, run.steps), run.wall,
                spent.bulk, spent.contact, spent.linear, spent.rest }
  end
  return sg.table{
    columns = { "order", "die", "slab", "total", "interface", "iterations", "wall", "bulk", "contact", "linear",
                "rest" },
    units = { "", "DOFs", "DOFs", "DOFs", "DOFs", "per step", "s", "s", "s", "s", "s" }, rows = rows,
    formats = { iterations = "%.2f", wall = "%.3f", bulk = "%.3f", contact = "%.3f", linear = "%.3f", rest = "%.3f" },
  }
end

--- Oscillations with the published values where there are some, otherwise with the detrended ones, for sg.table.
function output.oscillation_table(cases, published)
  local rows, formats = {}, { "%s", "%d", "%.3e", "%.2f", "%.2f", "%.3e", "%.2f", "%.2f" }
  for i, case in ipairs(cases) do
    local dPy, dPx = case.dPy, case.dPx
    local compared = { dPy_percent_of_N2 = dPy.detrended_percent, dPx_percent_of_N2 = dPx.detrended_percent }
    if published then compared = published[case.order] or {} end
    rows[i] = { case.order, case.die_dofs.total + case.slab_dofs.total, dPy.raw, dPy.raw_percent,
                compared.dPy_percent_of_N2, dPx.raw, dPx.raw_percent, compared.dPx_percent_of_N2 }
  end
  local other = published and "published" or "detrended"
  return {
    columns = { "order", "DOFs", "dPy", "dPy", other, "dPx", "dPx", other },
    units = { "", "", "N/mm", "% of N2", "% of N2", "N/mm", "% of N2", "% of N2" }, rows = rows, formats = formats,
  }
end

--- Keeps the states of some steps for a sheet: a function for on_step, and one that draws the sheet and returns whether
--- there was anything to draw.
function output.record_states(steps)
  local pictures = {}
  local function keep(model, info)
    if steps[info.step] then
      pictures[#pictures + 1] = sg.picture{ model = model, field = "von_mises", label = "von Mises stress (N/mm²)",
                                            gray = { "die" }, unit = "mm", title = ("load step %d"):format(info.step) }
    end
  end
  local function draw(file, title, columns)
    if #pictures > 0 then sg.sheet{ pictures, file = file, columns = columns, title = title } end
    return #pictures > 0
  end
  return keep, draw
end

--- Pressing force and drag over the load step; returns whether there was anything to draw.
function output.draw_forces(file, cases, title)
  local chart = { file = file, xlabel = "load step", ylabel = "force on the die per unit depth (N/mm)",
                  title = title .. ": pressing force Py (full) and drag Px (dashed)" }
  local function curves(name, column, sign, dashed)
    for i, case in ipairs(cases) do
      local values = case.run:column(column)
      for step, value in ipairs(values) do values[step] = sign * value end
      if #values > 0 then
        chart[#chart + 1] = { x = case.run:column "step", y = values, label = name .. " " .. case.order,
                              dashed = dashed, color = i }
      end
    end
  end
  curves("Py", "grip.fy", -1, false)
  curves("Px", "grip.fx", 1, true)
  if #chart > 0 then sg.chart(chart) end
  return #chart > 0
end

--- Oscillations by discretization, in % of those of the reference; returns whether there was anything to draw.
function output.draw_oscillations(file, cases, title, published)
  local chart = { file = file, title = title .. ": oscillation of the contact forces", ylabel = "oscillation (% of N2)",
                  log = "y", xrange = { 0.5, #cases + 0.5 }, xticks = {} }
  local curves = 0
  local function curve(label, shift, percent)
    local line = { x = {}, y = {}, label = label, line = false, markers = true }
    for i, case in ipairs(cases) do
      local value = percent(case)
      if value then line.x[#line.x + 1], line.y[#line.y + 1] = i + shift, value end
    end
    if #line.x > 0 then
      curves = curves + 1
      chart[curves] = line
    end
  end
  for i, case in ipairs(cases) do chart.xticks[i] = { i, case.order } end
  curve("dPy", -0.1, function(case) return case.dPy.raw_percent end)
  curve("dPx", -0.1, function(case) return case.dPx.raw_percent end)
  if published then
    curve("dPy published", 0.1, function(case) return (published[case.order] or {}).dPy_percent_of_N2 end)
    curve("dPx published", 0.1, function(case) return (published[case.order] or {}).dPx_percent_of_N2 end)
  else
    curve("dPy detrended", 0.1, function(case) return case.dPy.detrended_percent end)
    curve("dPx detrended", 0.1, function(case) return case.dPx.detrended_percent end)
  end
  if curves > 0 then sg.chart(chart) end
  return curves > 0
end

--- Curves over the mesh, one per order: value(case) of every study that has the order. Returns whether there were any.
function output.draw_over_mesh(chart, studies, orders, value)
  chart.xlabel, chart.log, chart.xticks, chart.xrange = "mesh", "y", {}, { 0.7, #studies + 0.3 }
  for i, study in ipairs(studies) do chart.xticks[i] = { i, study.mesh } end
  for l, order in ipairs(orders) do
    local line = { x = {}, y = {}, label = order, markers = true, color = l }
    for i, study in ipairs(studies) do
      local number = study.cases[order] and value(study.cases[order])
      if number then line.x[#line.x + 1], line.y[#line.y + 1] = i, number end
    end
    if #line.x > 0 then chart[#chart + 1] = line end
  end
  if #chart > 0 then sg.chart(chart) end
  return #chart > 0
end

return output
