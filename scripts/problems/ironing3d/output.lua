-- Tables and charts of 3D ironing. A case is what problem.solve returns, measured by measure.lua.

local sg = require "signorini"

local output = {}

function output.dofs_table(dofs)
  local rows = {}
  for i, row in ipairs(dofs) do
    rows[i] = { row.order, row.mesh, row.indenter.interface, row.indenter.bulk, row.indenter.total,
                row.slab.interface, row.slab.bulk, row.slab.total, row.indenter.total + row.slab.total,
                row.printed.total }
  end
  return sg.table{
    columns = { "order", "mesh", "interface", "bulk", "total", "interface", "bulk", "total", "total", "total" },
    units = { "", "", "indenter", "indenter", "indenter", "slab", "slab", "slab", "", "printed" }, rows = rows,
  }
end

--- How a run ended: "complete", or the depth or distance that it reached.
local function ending(case)
  local run = case.run
  if not run.failed then return "complete" end
  local column, what = "grip.uz", "depth"
  if #run.stages > 1 then column, what = "grip.ux", "distance" end
  local reached = run:column(column)
  return ("%s at %s %.2f"):format(run.reason, what, math.abs(reached[#reached] or 0))
end

--- Degrees of freedom, iterations, and where the time went.
function output.work_table(cases)
  local rows = {}
  for i, case in ipairs(cases) do
    local run, spent, dofs = case.run, case.run.timings, case.dofs
    rows[i] = { case.order, case.mesh, dofs.indenter.total + dofs.slab.total, run.steps, run.iterations, run.cutbacks,
                run.wall, spent.bulk, spent.contact, spent.linear, ending(case) }
  end
  return sg.table{
    columns = { "order", "mesh", "DOFs", "steps", "iterations", "cut-backs", "wall", "bulk", "contact", "linear",
                "end" },
    units = { "", "", "", "", "", "", "s", "s", "s", "s", "" }, rows = rows,
    formats = { wall = "%.1f", bulk = "%.1f", contact = "%.1f", linear = "%.1f" },
  }
end

local function oscillation_rows(cases, published)
  local rows = {}
  for i, case in ipairs(cases) do
    local dPz, dPx, printed = case.dPz, case.dPx, published[case.order .. " " .. case.mesh] or {}
    rows[i] = { case.order, case.mesh, case.pressed,
                dPz.raw, dPz.raw_percent, dPz.detrended_percent, printed.dPz_percent_of_N2,
                dPx.raw, dPx.raw_percent, dPx.detrended_percent, printed.dPx_percent_of_N2 }
  end
  return rows
end

--- Oscillations, and in % of coarse N2: raw, detrended by a parabola, as published.
function output.oscillation_table(cases, published)
  return sg.table{
    columns = { "order", "mesh", "Pz", "dPz", "dPz", "detrended", "printed", "dPx", "dPx", "detrended", "printed" },
    units = { "", "", "", "", "% of N2", "% of N2", "% of N2", "", "% of N2", "% of N2", "% of N2" },
    rows = oscillation_rows(cases, published),
    formats = { "%s", "%s", "%.3f", "%.3e", "%.2f", "%.2f", "%.2f", "%.3e", "%.2f", "%.2f", "%.2f" },
  }
end

function output.oscillation_csv(file, set, published)
  local names = { "order", "mesh", "pressed", "dPz", "dPz_percent", "dPz_detrended_percent", "dPz_printed_percent",
                  "dPx", "dPx_percent", "dPx_detrended_percent", "dPx_printed_percent" }
  local data = { columns = names, comments = { ("R = %g, depth %g"):format(set.radius, set.depth) } }
  local rows = oscillation_rows(set.cases, published)
  for c, name in ipairs(names) do
    data[name] = {}
    for r, row in ipairs(rows) do data[name][r] = row[c] or "" end
  end
  sg.csv.write(file, data)
end

--- Half of a state around the indenter, cut through the middle, with the vertical stress.
function output.picture(model, title)
  return sg.picture{ model = model, field = "szz", cut = "-y", title = title, label = "vertical stress",
                     camera = { from = { 0.5, -2, 0.8 } }, crop = { 30, 70, 0, 30, 8, 33 } }
end

--- Keeps the states of some steps for a sheet: a function for on_step, and one that draws the sheet and returns whether
--- there was anything to draw.
function output.record_states(steps)
  local pictures = {}
  local function keep(model, info)
    if steps[info.step] then
      pictures[#pictures + 1] = output.picture(model,
        ("depth %.2f, x + %.2f"):format(-info["grip.uz"], info["grip.ux"]))
    end
  end
  local function draw(file, title)
    if #pictures > 0 then output.draw_sheet(file, pictures, title) end
    return #pictures > 0
  end
  return keep, draw
end

--- A sheet of such pictures, with a common color bar.
function output.draw_sheet(file, pictures, title)
  sg.sheet{ pictures, file = file, columns = 2, title = title }
end

--- Pressing force and drag over the path of the indenter's center; returns whether there was anything to draw.
function output.draw_forces(file, cases, title)
  local chart = { file = file, xlabel = "x of the indenter's center", ylabel = "force of the indenter on the slab",
                  title = title .. ": Pz (full) and Px (dashed)" }
  for _, curve in ipairs { { "Pz", false }, { "Px", true } } do
    for i, case in ipairs(cases) do
      if #case.x > 0 then
        chart[#chart + 1] = { x = case.x, y = case[curve[1]], dashed = curve[2], color = i,
                              label = ("%s %s %s"):format(curve[1], case.order,
                                case.mu and ("μ = %g"):format(case.mu) or case.mesh) }
      end
    end
  end
  if #chart > 0 then sg.chart(chart) end
  return #chart > 0
end

--- The last state of a case, cut through the middle, the slab alone, and the pressure below the indenter, next to the
--- forces over the path.
function output.draw_groove(file, case)
  local x, model = case.x[#case.x], case.model
  if not x then return false end
  local near = { x - 14, x + 14, 0, 30, 4, 31 }
  local forces = { xlabel = "x of the indenter's center", ylabel = "force of the indenter on the slab",
                   title = "forces over the path", size = { 800, 500 },
                   { x = case.x, y = case.Pz, label = "pressing force Pz", markers = false },
                   { x = case.x, y = case.Px, label = "drag Px", markers = false } }
  local function picture(options)
    options.model, options.size, options.ruler = model, 800, false
    if options.field == "von_mises" then options.label = "von Mises stress / E" end
    return sg.picture(options)
  end
  sg.sheet{ columns = 2, file = file, title = ("Ironing with friction, %s, μ = %g"):format(case.order, case.mu),
    picture{ field = "von_mises", gray = { "indenter" }, cut = "-y", crop = near,
             camera = { from = { 0.4, -2, 0.7 } }, title = "cut through the middle" },
    picture{ field = "contact_pressure", label = "contact pressure / E", bodies = { "indenter" },
             camera = { from = { 0.4, -1.6, -1.2 } }, title = "the indenter from below" },
    picture{ field = "von_mises", bodies = { "slab" }, crop = near,
             camera = { from = { 0.5, -1.6, 1.5 } }, title = "the slab alone" },
    sg.chart(forces) }
  return true
end

--- Oscillations in % of those of coarse N2, with the published ones; returns whether there were any.
function output.draw_oscillations(file, set, published)
  local chart = { file = file, ylabel = "oscillation (% of N2)", log = "y", xrange = { 0.5, #set.cases + 0.5 },
                  xticks = {}, title = ("3D ironing, R = %g, depth %g"):format(set.radius, set.depth) }
  for i, case in ipairs(set.cases) do
    chart.xticks[i] = { i, case.mesh == "coarse" and case.order or case.order .. " " .. case.mesh }
  end
  local function curve(label, shift, percent)
    local line = { x = {}, y = {}, label = label, line = false, markers = true }
    for i, case in ipairs(set.cases) do
      local value = percent(case, published[case.order .. " " .. case.mesh] or {})
      if value then line.x[#line.x + 1], line.y[#line.y + 1] = i + shift, value end
    end
    if #line.x > 0 then chart[#chart + 1] = line end
    return #line.x > 0
  end
  local any = curve("dPz", -0.1, function(case) return case.dPz.raw_percent end)
  if not any then return false end
  curve("dPx", -0.1, function(case) return case.dPx.raw_percent end)
  curve("dPz published", 0.1, function(_, printed) return printed.dPz_percent_of_N2 end)
  curve("dPx published", 0.1, function(_, printed) return printed.dPx_percent_of_N2 end)
  sg.chart(chart)
  return true
end

return output
