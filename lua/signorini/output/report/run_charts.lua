-- The charts of a run's report: those of the user, or its forces, contact quantities and iterations.

local check = require "signorini.call.check"
local core = require "signorini.core"
local figure = require "signorini.output.report.figure"
local lists = require "signorini.call.lists"
local types = require "signorini.call.types"

local charts = {}

local own_options = { "x", "y" }

--- The last step of each stage but the last, with its name, as vertical lines.
local function ends_of_stages(run)
  local lines, step = {}, 0
  for i, stage in ipairs(run.stages) do
    step = step + stage.steps
    if i < #run.stages and stage.steps > 0 then lines[#lines + 1] = { step, stage.name } end
  end
  return #lines > 0 and lines or nil
end

-- ── Choice ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- True if a column has values other than zero.
local function is_telling(run, name)
  local values = run.values[name]
  for row = 1, run.rows do
    if values[row] and values[row] ~= 0 and values[row] == values[row] then return true end
  end
  return false
end

--- The owners of columns in order, each with the names of its columns: "grip" has "grip.fx" and "grip.fy".
local function owners(run)
  return lists.grouped(lists.filter(run.names, function(name)
    return name:find "%.[%a_]+$" and is_telling(run, name)
  end), function(name) return name:match "^(.*)%.[%a_]+$" end)
end

local quantities = {
  { "force", "^f[xyz]$" }, { "moment", "^moment$" }, { "displacement", "^u[xyz]$" }, { "angle", "^angle$" },
  { "traction", "^t[xyz]$" }, { "pressure", "^pressure$" }, { "contact area", "^area$" },
  { "maximum contact pressure", "^max_pressure$" }, { "maximum penetration", "^max_penetration$" },
  { "mean slip", "^slip$" }, { "debonded area", "^debonded$" },
}

--- The charts of a run without options: for each support, load and contact its quantities over the steps, the columns
--- of on_step, and the iterations.
local function chosen(run)
  local list, vlines, all = {}, ends_of_stages(run), owners(run)
  local function add(y, label, title)
    list[#list + 1] = { x = "step", y = y, xlabel = "step", ylabel = label, title = title, vlines = vlines }
  end
  for _, quantity in ipairs(quantities) do
    for _, owner in ipairs(all) do
      local y = lists.filter(owner, function(name) return name:match "[%a_]+$":find(quantity[2]) end)
      if #y > 0 then
        add(y, quantity[1], ("%s of %s"):format(quantity[1]:gsub("^%l", string.upper), owner.key))
      end
    end
  end
  for _, name in ipairs(lists.sorted_names(run.extra)) do
    if is_telling(run, name) and not name:find "%.error$" then add({ name }, name, name) end
  end
  add({ "iterations" }, "iterations", "Newton iterations of each step")
  if lists.any(run.values.increments, function(count) return count > 1 end) then
    add({ "increments" }, "increments", "Increments of each step")
  end
  return list
end

-- ── Figures ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The chart of columns over a column; the name of a single one is the label of the y axis.
local function chart_of(where, run, entry, i)
  local columns = types.choice(run.names)
  for j, name in ipairs(entry.y) do check.value(columns, name, where, ("charts[%d].y[%d]"):format(i, j)) end
  local x = check.value(columns, entry.x, where, ("charts[%d].x"):format(i))
  local chart = lists.merged(entry, { title = "", xlabel = entry.xlabel or x,
                                      ylabel = entry.ylabel or #entry.y == 1 and entry.y[1] or nil })
  for _, key in ipairs(own_options) do chart[key] = nil end
  for j, name in ipairs(entry.y) do
    chart[j] = { x = run:column(x), y = run:column(name), label = #entry.y > 1 and name or "",
                 error = run.values[name .. ".error"] and run:column(name .. ".error") }
  end
  return core.sg.chart(chart)
end

local function figure_of(where, run, entry, i)
  local what = ("%s: charts[%d]"):format(where, i)
  if core.kind(entry) == "picture" then return figure.of_picture(what, entry) end
  return figure.of_picture(what, chart_of(where, run, entry, i),
    entry.title or ("%s over %s"):format(table.concat(entry.y, ", "), entry.x))
end

--- The section of the charts: of those given, or of those chosen.
function charts.section(where, run, given)
  local list = given or run.rows > 0 and chosen(run) or {}
  return { title = "Charts", figures = lists.map(list, function(entry, i) return figure_of(where, run, entry, i) end) }
end

return charts
