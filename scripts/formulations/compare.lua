-- Contact formulations compared: time at equal error of forces and pressures, and what single scripts measure.
--
-- Problem: ironing in the plane and in 3D, Hertz's line contact (problems.lua) with Gauss points, mortar contact with
--          a penalty and with multipliers, and two half passes, on several meshes, by the default controls and with the
--          default penalty. Parts: scripts of this folder with the words that parts.lua has.
--
--                  |  o          time ratio of two formulations at equal error: the
--            error |   \ o       distance of their curves along a horizontal line,
--                  |    o  \     interpolated in both logarithms, where both have the error
--                  |______ o___ time
--
--          Errors are those of studies/speed_against_accuracy.lua: of the mean force, against multipliers on a fine
--          mesh; oscillation while bodies slide, max − min after subtraction of the best-fit parabola; L2 error of
--          Hertz's pressure, here per current area.
-- Source: of the scenes, see studies/accuracy; chosen here.
-- Units: times in s of one processor; errors in %; penalties in E over the radius.
-- Expected: see share/doc/decide/formulations.md. About ten minutes on one processor.
-- Run: signorini formulations/compare.lua [problems=all] [parts=all] [meshes=all] [rounds=3]
--      [out=out/formulations] [page=none]; problems, parts: names, or none; meshes: of the problems; rounds: runs of
--      the plane problems, for the least time; page: folder of the page, such as share/doc/decide, which needs all
--      problems and parts. Finished cases are kept in `out`.

local sg = require "signorini"
local page = require "page.tables"
local parts = require "formulations.parts"
local problems = require "formulations.problems"
local study = require "studies.accuracy.study"

local names = { "ironing", "hertz", "cylinder" }

--- An argument: all, none, or some names.
local function choice(default, known) return { default, choices = { "all", "none", table.unpack(known) } } end

local options = sg.arguments{
  problems = choice({ "all" }, names), parts = choice({ "all" }, parts.names),
  meshes = choice({ "all" }, { "m1", "m2", "m3", "m4" }),
  rounds = { 3, at_least = 1 }, out = "out/formulations", page = "none",
}
local files, base = sg.files(options.out), options.page .. "/formulations"

--- True if a list holds the name, or all.
local function chosen(list, name)
  for _, one in ipairs(list) do
    if one == name or one == "all" then return true end
  end
end

--- Of settings: names in tables, and colors in charts, dashed with a higher penalty.
local labels = { ["default"] = "GPTS", ["penalty × 10"] = "GPTS, penalty × 10", ["half passes"] = "half passes",
                 ["mortar equal"] = "mortar equal", ["mortar reduced"] = "mortar reduced",
                 ["mortar equal + penalty × 10"] = "mortar equal, penalty × 10", ["multipliers"] = "multipliers",
                 ["reduced multipliers"] = "multipliers, reduced" }
local colors = { ["default"] = 1, ["penalty × 10"] = 1, ["mortar equal"] = 2, ["mortar equal + penalty × 10"] = 2,
                 ["mortar reduced"] = 3, ["multipliers"] = 4, ["half passes"] = 5 }

-- ── Problems ─────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Penalties of Hertz's contact at m3, as settings; with Gauss points and averages.
local penalties = { ["penalty / 10"] = 0.1, ["published penalty"] = 1, ["penalty × 10"] = 10, ["penalty × 100"] = 100 }
local penalty_names = { "penalty / 10", "published penalty", "penalty × 10", "penalty × 100" }

local function cases_of(problem)
  local list = {}
  local function add(order, setting, mesh)
    for _, case in ipairs(list) do
      if case.order == order and case.setting == setting and case.mesh == mesh then return end
    end
    list[#list + 1] = { order = order, setting = setting, mesh = mesh }
  end
  for _, mesh in ipairs(problem.meshes) do
    for _, order in ipairs(chosen(options.meshes, mesh) and problem.orders or {}) do
      for _, setting in ipairs(problem.settings) do add(order, setting, mesh) end
    end
  end
  for _, name in ipairs(problem.name == "hertz" and options.meshes[1] == "all" and penalty_names or {}) do
    add("N2-N2.2", name, "m3")
    add("N2-N2.2", "mortar equal + " .. name, "m3")
  end
  return list
end

local results = {}
for _, name in ipairs(names) do
  local problem = problems[name]
  local cases = chosen(options.problems, name) and cases_of(problem) or {}
  if #cases > 0 then
    local result = study.of(problem, cases, options.rounds, options.out, function()
      return problem == problems.cylinder
    end)
    results[#results + 1], results[name] = result, result
  end
end

--- The row of a case, nil if it has failed or was not solved.
local function row_of(result, order, setting, mesh)
  return study.find(result.cases.rows, { order = order, setting = setting, mesh = mesh })
end

local errors = { ironing = { "error", "oscillation" }, hertz = { "error", "pressure" },
                 cylinder = { "error", "oscillation" } }

--- "0.7 to 1.1": times of a formulation over those of Gauss points at equal error, from the smallest to the largest one
--- that both reach; "better" or "worse" if one has smaller errors on all meshes.
local function at_equal_error(result, order, setting, error)
  local reference = result.problem.reference
  if error == "error" and order == reference.order and setting == reference.setting
     and chosen(result.problem.meshes, reference.mesh) then
    return false -- its finest mesh is what errors are measured against
  end
  local cases = result.cases:with("curve", function(row) return labels[row.setting] end)
  local compared = sg.work_precision(cases:with("least", function(row) return row.cpu_low end, "s"), {
    time = "least", error = error, series = "curve", marker = false,
    where = function(row)
      return row.order == order and (row.setting == "default" or row.setting == setting) and row.way == ""
        and row[error] ~= nil and chosen(result.problem.meshes, row.mesh)
    end,
  })
  local ratio = compared.ratios[1]
  if not ratio then return false end
  local inverse = ratio.a == labels.default
  if ratio.why then
    local function least(name)
      for _, curve in ipairs(compared.curves) do
        if curve.name == name then
          local size = math.huge
          for _, point in ipairs(curve.points) do size = math.min(size, point.error) end
          return size
        end
      end
    end
    return least(labels[setting]) < least(labels.default) and "better" or "worse"
  end
  local low, high = math.huge, 0
  for i = 1, 3 do
    local value = ratio.ratio[i] and (inverse and 1 / ratio.ratio[i] or ratio.ratio[i])
    if value then low, high = math.min(low, value), math.max(high, value) end
  end
  local from, to = ("%.2g"):format(low), ("%.2g"):format(high)
  return from == to and from or ("%s to %s"):format(from, to)
end

--- Columns of a problem's table, and its rows, one per formulation: of each discretization ratios of times, iterations
--- per step, and with `sizes` both errors on the finest mesh.
local function table_of(result, sizes)
  local problem, columns, rows = result.problem, { "" }, {}
  local both = errors[problem.name]
  for _, order in ipairs(problem.orders) do
    local names = { ("%s: time at equal error of the %s"):format(order, problem.force),
                    "at equal " .. (problem.second[1] == "pressure" and "error of the pressure" or problem.second[1]),
                    "iterations per step", ("error of the %s (%%)"):format(problem.force), problem.second[1] .. " (%)" }
    for _, name in ipairs{ table.unpack(names, 1, sizes and 5 or 3) } do columns[#columns + 1] = name end
  end
  for i, setting in ipairs(problem.settings) do
    local cells = { labels[setting] }
    for _, order in ipairs(problem.orders) do
      local finest
      for _, mesh in ipairs(problem.meshes) do
        if chosen(options.meshes, mesh) then finest = mesh end
      end
      local row = row_of(result, order, setting, finest)
      for _, error in ipairs(both) do
        cells[#cells + 1] = setting == "default" and 1 or at_equal_error(result, order, setting, error)
      end
      cells[#cells + 1] = row and ("%.1f%s"):format(row.iterations / row.steps,
        row.cuts > 0 and (", %d cuts"):format(row.cuts) or "") or "fails"
      for _, error in ipairs(sizes and both or {}) do
        cells[#cells + 1] = row and row[error] and ("%.2g"):format(row[error]) or false
      end
    end
    rows[i] = cells
  end
  return { name = problem.name, columns = columns, rows = rows }
end

local tables = {}
for i, result in ipairs(results) do
  tables[i] = table_of(result, result.problem == problems.cylinder)
end

-- ── Charts ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- One panel: an error over time of a discretization, one curve per formulation.
local function panel(result, order, error, ylabel, legend)
  local chart = { log = "xy", title = ("%s, %s"):format(result.problem.title, order), xlabel = "processor time (s)",
                  ylabel = ylabel, legend = legend and "outside" or false, size = { 1000, 760 } }
  for _, setting in ipairs(result.problem.settings) do
    local curve = { x = {}, y = {}, label = labels[setting], markers = true, color = colors[setting],
                    dashed = setting:find "×" ~= nil }
    for _, mesh in ipairs(result.problem.meshes) do
      local row = row_of(result, order, setting, mesh)
      if row and row[error] then curve.x[#curve.x + 1], curve.y[#curve.y + 1] = row.cpu_low, row[error] end
    end
    if #curve.x > 0 then chart[#chart + 1] = curve end
  end
  return #chart > 0 and sg.chart(chart) or nil
end

--- Hertz's pressure over the penalty at m3.
local function penalty_panel(result)
  local chart = { log = "xy", title = "Hertz's line contact, N2-N2.2 at m3", xlabel = "penalty (E / R)",
                  ylabel = "error of the pressure (%)", legend = "outside", size = { 1000, 760 } }
  for k, kind in ipairs{ { "GPTS", "" }, { "mortar equal", "mortar equal + " } } do
    local curve = { x = {}, y = {}, label = kind[1], markers = true, color = k }
    for _, name in ipairs(penalty_names) do
      local row = row_of(result, "N2-N2.2", kind[2] .. name, "m3")
      if row then curve.x[#curve.x + 1], curve.y[#curve.y + 1] = 2000 * penalties[name], row.pressure end
    end
    if #curve.x > 0 then chart[#chart + 1] = curve end
  end
  local row = row_of(result, "N2-N2.2", "multipliers", "m3")
  if row then chart.hlines = { { row.pressure, "multipliers" } } end
  return #chart > 0 and sg.chart(chart) or nil
end

--- Draws the panels that exist as one sheet, also for the page.
local function sheet(name, panels, columns)
  local drawing = { columns = columns }
  for i = 1, columns * 2 do drawing[#drawing + 1] = panels[i] end
  if #drawing == 0 then return end
  drawing.file = files(name)
  sg.sheet(drawing)
  if options.page ~= "none" then
    drawing.file = base .. "/" .. name
    sg.sheet(drawing)
  end
end

if results.ironing then
  local one = results.ironing
  sheet("ironing.png", { panel(one, "N2", "error", "error of the drag (%)"),
                         panel(one, "N2-N2.2", "error", "error of the drag (%)", true),
                         panel(one, "N2", "oscillation", "oscillation of the drag (%)"),
                         panel(one, "N2-N2.2", "oscillation", "oscillation of the drag (%)", true) }, 2)
end
if results.hertz then
  local one = results.hertz
  sheet("pressure.png", { panel(one, "N2", "pressure", "error of the pressure (%)"),
                          panel(one, "N2-N2.2", "pressure", "error of the pressure (%)", true),
                          penalty_panel(one) }, 3)
end

-- ── Parts ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Runs a script with words, and returns its results.
local function call(script, words, out)
  local chunk = assert(loadfile(assert(package.searchpath(script:gsub("/", "."), package.path))))
  local list = {}
  for word in words:gmatch "%S+" do list[#list + 1] = word end
  list[#list + 1] = "out=" .. out
  return chunk(table.unpack(list))
end

--- The study of a part, one case, which is kept; files of its script are written to a folder next to `out`.
local function measured(name)
  local part, folder = parts[name], ("%s/%s"):format(options.out, name)
  local done = sg.study{
    name = "formulations: " .. name, folder = folder, sequential = true,
    cases = sg.grid({ script = { part.script } }, { words = { part.words } }),
    run = function(case)
      local began = os.clock()
      local found = part.rows(call(case.script, case.words, ("%s_%s"):format(options.out, name)))
      return { rows = found, cpu = os.clock() - began }
    end,
  }
  done:execute()
  if done.rows[1].failed then error(("%s: %s"):format(name, done.rows[1].reason), 0) end
  return done
end

--- Adds the columns of a part to a table of formulations.
local function join(whole, part, rows)
  for _, column in ipairs(part.columns) do whole.columns[#whole.columns + 1] = column end
  for i, row in ipairs(rows) do
    whole.rows[i] = whole.rows[i] or { row[1] }
    table.move(row, 2, #row, #whole.rows[i] + 1, whole.rows[i])
  end
end

local joined, commands = { name = "formulations", columns = { "" }, rows = {} }, {}
for _, name in ipairs(parts.names) do
  if chosen(options.parts, name) then
    local done, part = measured(name), parts[name]
    local rows = done.rows[1].rows
    results[#results + 1] = { study = done }
    commands[#commands + 1] = { part.script, part.words, done.rows[1].cpu }
    if chosen(parts.joined, name) then
      join(joined, part, rows)
    else
      tables[#tables + 1] = { name = name, columns = part.columns, rows = rows }
    end
  end
end
if #joined.rows > 0 then tables[#tables + 1] = joined end

-- ── Output ───────────────────────────────────────────────────────────────────────────────────────────────────────────

for _, tabled in ipairs(tables) do
  print(("\n%s\n%s"):format(tabled.name, sg.table{ columns = tabled.columns, rows = tabled.rows }))
end
if options.page ~= "none" then
  local data = { script = "scripts/formulations/compare.lua", made = page.made(results), tables = tables,
                 commands = commands, problems = {} }
  for _, name in ipairs(names) do data.problems[#data.problems + 1] = page.cases(results[name]) end
  page.write(base, data)
end
files:report()

return { results = results, tables = tables, files = files }
