-- run:report: the page of a run.

local charts = require "signorini.output.report.run_charts"
local controls = require "signorini.run.controls"
local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local energy_balance = require "signorini.run.energy_balance"
local figure = require "signorini.output.report.figure"
local html = require "signorini.output.report.html"
local html_table = require "signorini.output.report.table"
local lists = require "signorini.call.lists"
local on_behalf_of = require "signorini.call.on_behalf_of"
local page = require "signorini.output.report.page"
local stage_names = require("signorini.run.stages").names

local where = "run:report"
local most_attempts, most_states = 200, 6

-- ── Tables ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local function stages(run)
  local rows = lists.map(run.stages, function(stage)
    return { stage.name, stage.steps, stage.iterations, stage.cutbacks, stage.wall }
  end)
  return html_table{ title = "stages", columns = { "stage", "steps", "iterations", "cut-backs", "wall" },
                     units = { [5] = "s" }, rows = rows }
end

--- All columns, one row per step, with the stage of each.
local function steps(run)
  local stages, rows = stage_names(run, 1), {}
  for row = 1, run.rows do
    rows[row] = { [2] = stages[row] }
    for j, name in ipairs(run.names) do
      local value = run.values[name][row]
      rows[row][j > 1 and j + 1 or j] = value == value and value or nil
    end
  end
  local columns = lists.joined(run.names)
  table.insert(columns, 2, "stage")
  local units = lists.map(columns, function(name) return name == "wall" and "s" or "" end)
  return html_table{ title = "steps", columns = columns, units = units, rows = rows }
end

local function attempts(run)
  local rows = {}
  for step, list in ipairs(run.histories) do
    local again = #list > 1 or #list == 1 and not list[1].converged
    for i, attempt in ipairs(again and list or {}) do
      rows[#rows + 1] = { step, i, attempt.from, attempt.to, attempt.arc and "arc length" or attempt.fallback or "",
                          attempt.iterations, attempt.converged and "converged" or attempt.reason,
                          failed = not attempt.converged }
    end
  end
  if #rows == 0 then return "" end
  local note = #rows > most_attempts
    and ("<p>The first %d of %s are shown.</p>\n"):format(most_attempts, counted(#rows, "attempt")) or ""
  return note .. html_table{ title = "attempts", rows = { table.unpack(rows, 1, most_attempts) },
    columns = { "step", "attempt", "from", "to", "fallback", "iterations", "outcome" } }
end

--- Energies and work, and what the balance of each stage lacks.
local function energies(run)
  local list, rows = run.energies, {}
  for i, stage in ipairs(run.stages) do
    local a, b = list[i], list[i + 1]
    if not b then return "" end -- resumed from a file without these
    rows[i] = { stage.name, b.work - a.work, b.stored - a.stored, b.contact - a.contact, b.friction - a.friction,
                energy_balance.missing(a, b) }
  end
  if #rows == 0 then return "" end
  return "<p>Changes within each stage. Missing: work that is neither stored nor dissipated, which tends to zero with "
    .. "the length of the steps.</p>\n" .. html_table{ title = "energies", rows = rows,
    columns = { "stage", "work", "strain energy", "contact energy", "friction", "missing" } }
end

--- The last values with their error bars, and where these come from.
local function errors(run)
  if not run.errors or run.rows == 0 then return "" end
  local cells, notes = require("signorini.errors.bars").last_row(run)
  if not cells then return html.element("p", notes) end
  return html_table(lists.merged(cells, { title = "errors" })) .. html.list(notes)
end

-- ── Texts ────────────────────────────────────────────────────────────────────────────────────────────────────────────

local function summary(run)
  return {
    { "Outcome", run.reason == "completed" and "completed" or ("ended: %s"):format(run.reason) },
    { "Steps", tostring(run.steps) }, { "Iterations", tostring(run.iterations) },
    { "Cut-backs", tostring(run.cutbacks) }, { "Wall time", html.duration(run.wall) },
  }
end

local function times(run)
  local spent = run.timings
  return html.facts{ { "Bulk", html.duration(spent.bulk) }, { "Contact", html.duration(spent.contact) },
                     { "Factorization and solve", html.duration(spent.linear) }, { "Rest", html.duration(spent.rest) } }
end

local function failure(run)
  if run.reason == "completed" then return "" end
  return html.element("p", ("%s: %s"):format(run.reason, run.failure or "on_step ended the run"), "failure")
end

local function warnings(run)
  local texts = lists.joined(run.warnings, controls.lines(run))
  return #texts > 0 and html.list(texts) or ""
end

-- ── Pictures ─────────────────────────────────────────────────────────────────────────────────────────────────────────

--- At most so many entries, evenly distributed, with the first and the last.
local function spread(list, most)
  if #list <= most then return list end
  local chosen = {}
  for i = 0, most - 1 do chosen[i + 1] = list[1 + (i * (#list - 1) + (most - 1) // 2) // (most - 1)] end
  return chosen
end

--- The stored states, colored by a field. If the user names none, a picture that cannot be drawn is not an error.
local function states(run, named)
  local list, field = spread(run.stored_states, most_states), named or "von_mises"
  if #list == 0 or named == false then return nil end
  local function draw()
    local picture = on_behalf_of(where, "sg.picture", core.sg.picture, { states = list, field = field })
    return figure.of_picture(where .. ": states", picture, ("Stored states, colored by %s"):format(field))
  end
  if named then return draw() end
  local drawn, result = pcall(draw)
  return drawn and result or html.element("p", ("The states are not drawn: %s"):format(result))
end

--- `first`: sections above those of the run.
return function(run, options, first)
  local given, films = page.given_figures(where, options)
  table.insert(given.figures, 1, not options.pictures and states(run, options.field) or nil)
  local names = lists.map(run.stages, function(stage) return stage.name end)
  page.write(where, options, {
    title = ("Run: %s"):format(table.concat(names, ", ")), summary = summary(run),
    subtitle = ("%s in %s"):format(counted(run.steps, "step"), counted(#run.stages, "stage")),
    sections = lists.joined(first or {}, {
      { title = "Failure", html = failure(run) },
      { title = "Warnings and controls", html = warnings(run) },
      charts.section(where, run, options.charts),
      given, films,
      { title = "Error bars of the last step", html = errors(run) },
      { title = "Stages", html = #run.stages > 0 and stages(run) or "" },
      { title = "Energy balance", html = energies(run) },
      { title = "Attempts", html = attempts(run) },
      { title = "Steps", html = run.rows > 0 and steps(run) or html.element("p", "No step converged.") },
      { title = "Where the time went", html = times(run) },
    }),
  })
end
