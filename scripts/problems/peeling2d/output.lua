-- Tables and charts of peeling runs; cases are what problem.solve returns, measured: window, snap_backs, and
-- printed, the published row.

local sg = require "signorini"
local measure = require "problems.peeling2d.measure"

local output = {}

-- ── Published values ─────────────────────────────────────────────────────────────────────────────────────────────────

local printed = {}
do
  local data = sg.reference "peeling2d_table7_8_and_B2"
  for _, row in ipairs(data.rows) do
    local named = {}
    for j, column in ipairs(data.columns) do named[column] = row[j] end
    printed[named.discretization .. " " .. named.mesh] = named
  end
end

--- The published row of an order on a mesh, of the strip of 200 nm: dM_1e-3_E0L0cubed, max_slope_1e-3, min_slope_1e-3,
--- dofs, converges; empty if there is none.
function output.printed(order, mesh) return printed[order .. " " .. mesh] or {} end

local function ratio(value, reference) return value and reference and value / reference or nil end
local function thousandth(value) return value and 1e3 * value end

-- ── Tables ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Oscillation and slopes, with the published ones.
function output.oscillation_table(cases)
  local rows = {}
  for i, case in ipairs(cases) do
    local w, p = case.window, case.printed
    local oscillation, rise, fall = thousandth(w.oscillation), thousandth(w.rise), thousandth(w.fall)
    rows[i] = { case.order, case.mesh, case.dofs, p.dofs,
                oscillation, p["dM_1e-3_E0L0cubed"], ratio(oscillation, p["dM_1e-3_E0L0cubed"]),
                rise, p["max_slope_1e-3"], ratio(rise, p["max_slope_1e-3"]),
                fall, p["min_slope_1e-3"], ratio(fall, p["min_slope_1e-3"]), thousandth(w.path_oscillation) }
  end
  return sg.table{
    columns = { "order", "mesh", "DOFs", "publ.", "dM", "publ.", "ratio", "rise", "publ.", "ratio", "fall", "publ.",
                "ratio", "dM path" },
    units = { "", "", "", "", "1e-3", "1e-3", "", "1e-3/°", "1e-3/°", "", "1e-3/°", "1e-3/°", "", "1e-3" }, rows = rows,
    formats = { "%s", "%s", "%d", "%d", "%.4f", "%.4f", "%.3f", "%.3f", "%.3f", "%.3f", "%.3f", "%.3f", "%.3f",
                "%.4f" },
  }
end

--- Mean moment on the plateau, with its two estimates.
function output.plateau_table(cases, thin, finite)
  local rows = {}
  for _, case in ipairs(cases) do
    local mean = case.window.mean
    if mean then
      rows[#rows + 1] = { case.order, case.mesh, mean, 100 * (mean / thin - 1), 100 * (mean / finite - 1) }
    end
  end
  return sg.table{
    columns = { "order", "mesh", "plateau", "off thin strip", "off finite strain" },
    units = { "", "", "E0 L0³", "%", "%" }, rows = rows, formats = { "%s", "%s", "%.5f", "%.3f", "%.3f" },
  }
end

--- End of rotation control, and of arc-length control after it.
function output.path_table(cases)
  local rows = {}
  for i, case in ipairs(cases) do
    local run, widest, drop = case.rotation, nil, nil
    for _, back in ipairs(case.snap_backs) do
      widest, drop = math.max(widest or 0, back.width), math.max(drop or 0, back.drop)
    end
    local last = run:column "edge.angle"
    rows[i] = { case.order, case.mesh, last[#last], run.reason, measure.reported_turn(run), case.angle[#case.angle],
                case.arc and case.arc.reason or nil, #case.snap_backs, widest, thousandth(drop) }
  end
  return sg.table{
    columns = { "order", "mesh", "rotation to", "because", "turn", "in all to", "because", "snap-backs", "widest",
                "drop" },
    units = { "", "", "°", "", "°", "°", "", "", "°", "1e-3" }, rows = rows,
    formats = { "%s", "%s", "%.1f", "%s", "%.2f", "%.1f", "%s", "%d", "%.4f", "%.3f" },
  }
end

--- Iterations and where the time went.
function output.time_table(cases, repeats)
  local rows = {}
  for i, case in ipairs(cases) do
    local work = case.work
    local spent = work.timings
    rows[i] = { case.order, case.mesh, case.dofs, work.iterations / math.max(1, work.reached), work.wall, spent.bulk,
                spent.contact, spent.linear, spent.rest, 100 * (1 - spent.linear / work.wall) }
  end
  return sg.table{
    columns = { "order", "mesh", "DOFs", "iterations", "wall", "bulk", "contact", "linear", "rest", "outside linear" },
    units = { "", "", "", "per step", "s", "s", "s", "s", "s", "%" }, rows = rows,
    formats = { "%s", "%s", "%d", "%.2f", "%.1f", "%.1f", "%.1f", "%.1f", "%.1f", "%.1f" },
  }, repeats > 1 and (", medians of %d runs"):format(repeats) or ""
end

-- ── Charts ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local angle_label, moment_label = "rotation of the edge θ (°)", "moment M / (E0 L0³)"

--- Angles and moments of the rows within a range of angles; on request of whole steps or of others only.
local function part(case, from, to, whole)
  local x, y = {}, {}
  for row, angle in ipairs(case.angle) do
    local wanted = whole == nil or whole == measure.is_whole(case.step[row])
    if wanted and angle > from - 1e-6 and angle < to + 1e-6 then x[#x + 1], y[#y + 1] = angle, case.moment[row] end
  end
  return x, y
end

--- Figure 7.23: the whole curve of one case, the plateau magnified, with the energy balance.
function output.draw_moment(file, case, balance, window)
  local last = case.angle[#case.angle]
  local inset = last > window[1] and { xrange = { window[1], math.min(last, window[1] + 5) } } or nil
  sg.chart{
    file = file, xlabel = angle_label, ylabel = moment_label, yrange = { 0, 1.15 * balance }, inset = inset,
    legend = false, title = ("Peeling: moment over rotation, %s at %s"):format(case.order, case.mesh),
    hlines = { { balance, ("energy balance %.4f"):format(balance) } },
    { x = case.angle, y = case.moment, label = case.order },
  }
end

--- Figure 7.25: a part of the plateau, of all cases for which `wanted(order)`; returns whether there was anything to
--- draw.
function output.draw_plateau(file, cases, title, window, wanted)
  local to = math.min(window[2], window[1] + 6)
  local chart = { file = file, title = title, xlabel = angle_label, ylabel = moment_label, xrange = { window[1], to } }
  for i, case in ipairs(cases) do
    local x, y = part(case, window[1], to)
    if #x > 1 and wanted(case.order) then
      chart[#chart + 1] = { x = x, y = y, label = case.order, color = i }
    end
  end
  if #chart > 0 then sg.chart(chart) end
  return #chart > 0
end

--- Figure 7.27: oscillation over the mesh, and all published values; returns whether there was anything to draw.
function output.draw_over_mesh(file, orders, meshes, case_of)
  local chart = { file = file, title = "Peeling: oscillation of the moment over the mesh", xlabel = "mesh",
                  ylabel = "dM (1e-3 E0 L0³)", log = "y", xrange = { 0.8, #meshes + 0.2 }, xticks = {} }
  local aside = 0.06 -- offset of the published values
  local printed_ones = { x = {}, y = {}, label = "published", line = false, markers = true, marker = "plus", color = 7 }
  local function add(curve, x, y)
    if y then curve.x[#curve.x + 1], curve.y[#curve.y + 1] = x, y end
  end
  for m, mesh in ipairs(meshes) do chart.xticks[m] = { m, mesh } end
  for l, order in ipairs(orders) do
    local ours = { x = {}, y = {}, label = order, markers = true, color = l }
    for m, mesh in ipairs(meshes) do
      local case = case_of(order, mesh)
      add(ours, m, thousandth(case.window.oscillation))
      add(printed_ones, m + aside, case.printed["dM_1e-3_E0L0cubed"])
    end
    if #ours.x > 0 then chart[#chart + 1] = ours end
  end
  if #printed_ones.x > 0 then chart[#chart + 1] = printed_ones end
  if #chart > 0 then sg.chart(chart) end
  return #chart > 0
end

--- The widest snap-back of a case and its surroundings: the path, its whole steps and the states of arc-length
--- increments. Returns whether there is one.
function output.draw_snap_back(file, case)
  local widest
  for _, back in ipairs(case.snap_backs) do
    if not widest or back.width > widest.width then widest = back end
  end
  if not widest then return false end
  local from, to = widest.to - 0.6, widest.from + 0.6
  local function curve(look, whole)
    look.x, look.y = part(case, from, to, whole)
    return look
  end
  sg.chart{
    file = file, xlabel = angle_label, ylabel = moment_label,
    title = ("Peeling, %s at %s: the widest snap-back, %.3f° back from %.2f°")
      :format(case.order, case.mesh, widest.width, widest.from),
    curve({ label = "path", color = 1, marker = "none" }),
    curve({ label = "whole steps", line = false, markers = true, marker = "circle", color = 1 }, true),
    curve({ label = "by arc length", line = false, markers = true, marker = "square", color = 2 }, false),
  }
  return true
end

return output
