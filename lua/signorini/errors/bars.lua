-- Error bars of a run: the terms of its columns, as lists, budgets and text.

local check = require "signorini.call.check"
local core = require "signorini.core"
local cut = require("signorini.call.text").cut
local format_table = require("signorini.output.table").text
local lists = require "signorini.call.lists"
local stages = require "signorini.run.stages"
local t = require "signorini.call.types"
local terms = require "signorini.errors.terms"

local bars = {}

local nan = -(0 / 0) -- which prints without a sign
local accounts = { "step", "increments", "iterations", "wall" }
local suffix = ".error"

--- The names of the columns of results: those that are not prescribed, counted, or returned by on_step.
function bars.result_names(run, model)
  local others = lists.joined(accounts)
  for _, name in ipairs(model:driven_names()) do
    for _, component in ipairs(stages.components(model, name)) do
      others[#others + 1] = ("%s.%s"):format(name, component)
    end
  end
  return lists.filter(run.names, function(name)
    return not lists.holds(others, name) and (not run.extra[name] or run.measured[name])
  end)
end

--- The constants of the model that the advice names.
local function settings(model, run)
  local penalties, points = {}, {}
  for _, name in ipairs(model:contact_names()) do
    local law = model:contact_law(name)
    penalties[#penalties + 1], points[#points + 1] = law.penalty, law.points
  end
  local rows = lists.unique(penalties)
  return { penalty = #rows == 1 and rows[1] or nil, points = #lists.unique(points) == 1 and points[1] or nil,
           steps = #run.outline == 1 and run.outline[1].steps or nil }
end

--- Marks the largest pressures at sharp edges, which have no limit as elements get smaller.
local function mark_edges(model, columns)
  for _, contact in ipairs(model:contact_names()) do
    local column = columns[contact .. ".max_pressure"]
    if column and not column.mesh.exact and core.is_peak_at_edge(model, contact) then column.mesh.why = "no limit" end
  end
end

--- Estimates the error of all results of a run that has ended, and adds a column for each: "grip.fx.error".
function bars.attach(run, model)
  local counts, columns = lists.map(run.outline, function(stage) return stage.steps end), {}
  for _, name in ipairs(bars.result_names(run, model)) do
    columns[name] = terms.of(name, run:column(name), run.companions, counts, run.used.tolerance)
  end
  mark_edges(model, columns)
  run.errors = { columns = columns, settings = settings(model, run), missing = run.companions.missing,
                 names = lists.filter(run.names, function(name) return columns[name] end) }
  for _, name in ipairs(run.errors.names) do
    if not run.values[name .. suffix] then run:add_extra(name .. suffix) end
  end
  for _, name in ipairs(run.errors.names) do
    local values, total = run.values[name .. suffix], bars.list(run, name)
    for row = 1, run.rows do values[row] = total[row] end
  end
end

--- The bar of each row; nan where it is unknown, or where there is no honest one.
function bars.list(run, name)
  local column, list = run.errors.columns[name], {}
  for row = 1, run.rows do list[row] = column.mesh.why ~= "no limit" and (column.total or {})[row] or nan end
  return list
end

--- The column of a name that a method was called with.
local function column_of(run, what, name)
  if not run.errors then
    core.fail(what .. ": the run has no error bars. Hint: model:run(stages, { errors = true })")
  end
  check.value(t.choice(run.errors.names), name, what, "name")
  return run.errors.columns[name]
end

function bars.error(run, name)
  column_of(run, "run:error", name)
  return bars.list(run, name)
end

-- ── Budget ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local parts = { "bulk", "row", "points", "penalty", "steps", "newton" }

--- The terms of a row by name; those of the mesh divided into bulk and row as far as that is known.
local function budget_of(column, row)
  local mesh = column.mesh.bars[row]
  local budget = { points = column.points and column.points[row], penalty = column.penalty and column.penalty[row],
                   steps = column.steps and column.steps[row], newton = column.newton and column.newton[row] }
  if mesh and column.row then
    budget.row = column.row * mesh
    budget.bulk = mesh - budget.row
  else
    budget.bulk = mesh
  end
  return budget
end

--- A number with two digits, without an exponent.
local function short(value) return ("%.15g"):format(tonumber(("%.2g"):format(value))) end

local function finer(factor, _, order) return ("elements × %s per direction"):format(short(factor ^ (1 / order))) end

-- What makes a term `factor` times as small, in words.
local cures = {
  bulk = finer,
  penalty = function(factor, given)
    return given.penalty and "penalty " .. short(factor * given.penalty) or "penalties × " .. short(factor)
  end,
  steps = function(factor, given)
    return given.steps and ("%d steps"):format(math.ceil(factor * given.steps)) or "steps × " .. short(factor)
  end,
  points = function(factor, given)
    local more = math.sqrt(factor)
    return given.points and ("points = %d"):format(math.ceil(more * given.points)) or "points × " .. short(more)
  end,
  row = function(factor, given, order)
    return factor <= 4 and "a richer row (a layer, or layer_knots = 2)" or finer(factor, given, order)
  end,
}

local most_factor = 8 -- by which the advice reduces a single term
local most_finer = 4 -- elements per direction

--- What halves the sum of the terms, in words: the largest ones, as few as possible, reduced by the same factor.
local function advice(column, budget, total, given)
  local list = lists.filter({ "bulk", "row", "points", "penalty", "steps" }, function(key) return budget[key] end)
  table.sort(list, function(a, b) return budget[a] > budget[b] end)
  local rest, sum = total, 0
  for count, key in ipairs(list) do
    sum, rest = sum + budget[key], rest - budget[key]
    local left = total / 2 - rest
    local mesh = lists.any({ table.unpack(list, 1, count) }, function(term) return term == "bulk" or term == "row" end)
    if mesh and left > 0 and (sum / left) ^ (1 / column.mesh.order) > most_finer then return nil end
    if left > 0 and sum / left <= most_factor then
      return table.concat(lists.map({ table.unpack(list, 1, count) }, function(term)
        return cures[term](sum / left, given, column.mesh.order)
      end), ", ")
    end
  end
end

--- The budget of a row: value, error, each term as far as it is known, and why bars are missing or doubtful.
function bars.budget(run, name, row)
  local column = column_of(run, "run:budget", name)
  row = row or run.rows
  check.value(t.integer(1, run.rows), row, "run:budget", "step")
  local budget, error = budget_of(column, row), bars.list(run, name)[row]
  budget.value, budget.error, budget.why = run.values[name][row], error, column.mesh.why
  local known = error == error and error > 0 and (not column.mesh.why or column.mesh.why == "one element")
  budget.to_halve_it = known and advice(column, budget, error, run.errors.settings) or nil
  return budget
end

-- ── Text ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A value with as many digits as its bar allows, and the bar: "-0.0176 ± 2.5 %", of small values "0.003 ± 0.02".
local function value_text(value, error, doubt)
  if error ~= error then return ("%.6g"):format(value), doubt == "no limit" and "no limit" or "unknown" end
  local sign = doubt and "±? " or "± "
  if error == 0 then return ("%.10g"):format(value), sign .. "0" end
  local last = math.floor(math.log(error, 10)) - 1
  local digits = math.max(0, -last)
  local text = math.abs(value) >= 1e-4 and math.abs(value) < 1e7 and digits <= 12 and ("%.*f"):gsub("%*", digits)
    or "%.6g"
  local share = 100 * error / math.abs(value)
  return text:format(value), share < 100 and ("%s%.2g %%"):format(sign, share) or ("%s%.2g"):format(sign, error)
end

local most_lines = 16

local doubts = {
  ["one element"] = "a body has one element in a direction: its error there is not contained in the bar",
  ["elements cannot be larger"] = "unknown: the bodies have too few elements for companions with larger ones",
  ["no limit"] = "at a sharp edge, where it grows with each refinement: there is no value that finer meshes reach",
  ["not converging"] = "not converging with the mesh (±?: the largest difference of three meshes), as at "
    .. "irregular stick–slip, jumps, or elements too large for the contact",
}

local rounding = 1e-9 -- of the largest force: components that are zero but for rounding errors

--- True if a result differs from zero.
function bars.is_telling(run, name)
  local size, most = run.errors.columns[name].size, 0
  for other, column in pairs(name:find "%.f[xyz]$" and run.errors.columns or {}) do
    if other:find "%.f[xyz]$" then most = math.max(most, column.size) end
  end
  return size > rounding * most
end

--- Sentences about companions that ended early, whose terms are unknown from there on.
local function failures(run)
  local texts = {}
  for _, name in ipairs { "2h", "4h", "row", "points", "penalty", "steps" } do
    local record = run.companions[name]
    if record and record.failure then
      local why = record.reason ~= "error" and record.reason or record.failure:gsub("^[^:]*:%d+: ", "")
      texts[#texts + 1] = ("companion '%s' ended after step %d%s: %s"):format(name, record.rows,
        name == "2h" and ", the mesh is too coarse to judge" or "", cut(why, 160))
    end
  end
  return texts
end

--- The last row as a table { columns, units, rows }, and sentences about it; nil if all bars are unknown, and why.
function bars.last_row(run)
  if run.errors.missing then return nil, "errors are unknown: " .. run.errors.missing end
  local names = lists.filter(run.errors.names, function(name)
    return not name:find "%.max_penetration$" and bars.is_telling(run, name) -- penetration is an error itself
  end)
  local shown, rows, notes = { table.unpack(names, 1, most_lines) }, {}, {}
  local budgets = lists.map(shown, function(name) return bars.budget(run, name, run.rows) end)
  local used = lists.filter(parts, function(part)
    return part ~= "newton" and lists.any(budgets, function(budget) return budget[part] end)
  end)
  for i, name in ipairs(shown) do
    local column, budget = run.errors.columns[name], budgets[i]
    local value, bar = value_text(budget.value, budget.error, budget.why)
    rows[i] = { name, value, bar }
    for k, part in ipairs(used) do
      rows[i][3 + k] = budget[part] and ("%.2g"):format(100 * budget[part] / column.size) or "unknown"
    end
    rows[i][4 + #used] = budget.to_halve_it or ""
  end
  local doubtful = lists.filter(shown, function(name) return doubts[run.errors.columns[name].mesh.why] end)
  for _, group in ipairs(lists.grouped(doubtful, function(name) return run.errors.columns[name].mesh.why end)) do
    notes[#notes + 1] = ("%s: %s"):format(table.concat(group, ", "), doubts[group.key])
  end
  if #names > most_lines then notes[#notes + 1] = ("and %d more, see run:budget"):format(#names - most_lines) end
  notes = lists.joined(notes, failures(run))
  notes[#notes + 1] = "Terms in % of the largest value of the run. Errors are those of the solution of this model; its "
    .. "laws, data and idealization are not included."
  local columns = lists.joined({ "quantity", "value", "error" }, used, { "to halve it" })
  local units = lists.map(columns, function(_, i) return i > 3 and i < #columns and "%" or "" end)
  return { columns = columns, units = units, rows = rows }, notes
end

--- Lines about the last row, for print(run).
function bars.lines(run)
  if not run.errors or run.rows == 0 then return {} end
  local cells, notes = bars.last_row(run)
  if not cells then return { notes } end
  return lists.joined({ "", format_table(cells) }, notes)
end

return bars
