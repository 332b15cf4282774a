-- Tables, charts and page of the benchmark. Cases come from measure.case; exponents by problem and account.

local sg = require "signorini"
local measure = require "benchmark.measure"

local report = {}

local all_accounts = {}
for _, list in ipairs { measure.accounts, measure.sizes, measure.outputs } do
  table.move(list, 1, #list, #all_accounts + 1, all_accounts)
end

--- A table of cases: mesh and sizes, then the results with these names.
local function case_sheet(cases, names, more)
  local columns, rows = { "problem", "mesh", "DOFs", table.unpack(more) }, {}
  local fixed = #columns
  for _, name in ipairs(names) do columns[#columns + 1] = name end
  for i, case in ipairs(cases) do
    rows[i] = { measure.problems[case.problem].name, case.mesh, case.dofs }
    for j = 4, #columns do rows[i][j] = case[columns[j]] end
  end
  return { columns = columns, rows = rows }, fixed
end

local function case_table(cases, names, more)
  local sheet, fixed = case_sheet(cases, names, more)
  sheet.formats = {}
  for i = fixed + 1, #sheet.columns do sheet.formats[i] = "%.3g" end
  return sg.table(sheet)
end

function report.iteration_table(cases)
  local names = table.move(measure.accounts, 1, #measure.accounts, 1, {})
  table.move({ "around", table.unpack(measure.sizes) }, 1, 1 + #measure.sizes, #names + 1, names)
  return case_table(cases, names, { "iterations" })
end

function report.output_table(cases) return case_table(cases, measure.outputs, {}) end

--- All results, for a CSV file.
function report.sheet(cases, options)
  local names = table.move(all_accounts, 1, #all_accounts, 1, {})
  names[#names + 1] = "around"
  local sheet = case_sheet(cases, names, { "order", "unknowns", "iterations" })
  sheet.comments = { ("ms per iteration and per file, medians of %d; memory in MB; linear solver %s"):format(
    options.repeats, options.linear) }
  return sheet
end

function report.growth_sheet(exponents)
  local sheet = { columns = { "account", "plane", "solid" }, rows = {} }
  local plane, solid = exponents.plane or {}, exponents.solid or {}
  for i, account in ipairs(all_accounts) do sheet.rows[i] = { account, plane[account], solid[account] } end
  return sheet
end

function report.growth_table(exponents)
  local sheet = report.growth_sheet(exponents)
  sheet.columns, sheet.formats = { "", "2D", "3D" }, { "%s", "%.2f", "%.2f" }
  return sg.table(sheet)
end

-- ── Charts ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Adds a curve of one result over the degrees of freedom of a problem.
local function add_line(chart, cases, problem, name, label)
  local line = { x = {}, y = {}, label = label, markers = true }
  for _, case in ipairs(cases) do
    if case.problem == problem and case[name] > 0 then
      line.x[#line.x + 1], line.y[#line.y + 1] = case.dofs, case[name]
    end
  end
  if #line.x > 1 then chart[#chart + 1] = line end
end

local function finish(chart)
  chart.log, chart.xlabel, chart.size = "xy", "degrees of freedom", { 1600, 1000 }
  if #chart > 0 then sg.chart(chart) end
  return #chart > 0
end

local function draw_iteration(problem)
  return function(file, cases)
    local chart = { file = file, ylabel = "time of an iteration (ms)",
                    title = measure.problems[problem].name .. ": parts of a Newton iteration" }
    for _, name in ipairs { "bulk", "contact", "search", "factorization", "solution" } do
      add_line(chart, cases, problem, name, name)
    end
    return finish(chart)
  end
end

--- Charts: file, the meshes that it needs (text), draw(file, cases), which returns whether anything was drawn.
report.charts = {
  { file = "benchmark_2d.png", needs = "2D ironing", draw = draw_iteration "plane" },
  { file = "benchmark_3d.png", needs = "3D ironing", draw = draw_iteration "solid" },
  { file = "benchmark_output.png", needs = "a problem", draw = function(file, cases)
    local chart = { file = file, ylabel = "time of a file (ms)", title = "Writing a state" }
    for _, problem in ipairs { "plane", "solid" } do
      for _, name in ipairs(measure.outputs) do
        local what = name == "csv" and "CSV" or name
        add_line(chart, cases, problem, name, ("%s, %s"):format(problem == "plane" and "2D" or "3D", what))
      end
    end
    return finish(chart)
  end },
}

-- ── Page ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

local function markdown(columns, rows)
  local lines = { "| " .. table.concat(columns, " | ") .. " |", "|" .. ("---|"):rep(#columns) }
  for _, row in ipairs(rows) do
    local cells = {}
    for i in ipairs(columns) do
      cells[i] = math.type(row[i]) == "float" and ("%.3g"):format(row[i]) or tostring(row[i] or "–")
    end
    lines[#lines + 1] = "| " .. table.concat(cells, " | ") .. " |"
  end
  return table.concat(lines, "\n")
end

--- Opens a file, calls body(stream) and returns its result.
local function with_file(path, mode, body)
  local stream <close> = assert(io.open(path, mode))
  return assert(body(stream))
end

--- Replaces the text between two marks of benchmark.md in a folder; the page is written atomically.
local function replace(folder, mark, measured)
  local path = folder .. "/benchmark.md"
  local first, last = ("<!-- %s -->\n"):format(mark), ("<!-- end of %s -->"):format(mark)
  local text = with_file(path, "r", function(stream) return stream:read "a" end)
  local _, from = text:find(first, 1, true)
  local to = from and text:find(last, from, true)
  if not to then error(("%s must have the lines '%s' and '%s'"):format(path, first:sub(1, -2), last), 0) end
  with_file(path .. ".new", "w", function(stream) return stream:write(text:sub(1, from), measured, text:sub(to)) end)
  assert(os.rename(path .. ".new", path))
end

--- Replaces the tables and charts of the page with those of the cases and of the solvers' sheet, if there are any.
function report.page(folder, cases, exponents, element, solvers)
  if #solvers.rows > 0 then replace(folder, "solvers", markdown(solvers.columns, solvers.rows) .. "\n") end
  if #cases == 0 then return end
  local names = table.move(all_accounts, 1, #all_accounts, 1, {})
  names[#names + 1] = "around"
  local sheet, growth = case_sheet(cases, names, { "iterations" }), report.growth_sheet(exponents)
  local measured = table.concat({ markdown(sheet.columns, sheet.rows),
    markdown({ "exponent", "2D", "3D" }, growth.rows),
    ("Time for residual and tangent of a 3D element with 27 functions: %.3f ms.\n"):format(element) }, "\n\n")
  replace(folder, "measured", measured)
  for _, chart in ipairs(report.charts) do chart.draw(folder .. "/" .. chart.file, cases) end
end

return report
