-- Work-precision diagrams: error of the force, and oscillation or error of the pressure, over processor time.
--
-- Problem: ironing in the plane with friction, Hertz's line contact, two rings, peeling, ironing in 3D: discretizations
--          with the default settings, with the published ones (plain Newton, linear functions in the thickness
--          direction, a fixed penalty), and with other formulations, penalties and layers, on several meshes.
--
--          error |  o
--                |   \ o          one curve per discretization and setting, one marker per mesh; lower left is better
--                |    o \
--                |     \ o
--                |______\_________ processor time
--
--          Two errors per problem: that of the mean force (drag, pressing force, moment), relative to a reference with
--          exact contact (Lagrange multipliers on a fine mesh), whose own error bar is the largest difference from
--          another mesh and another formulation; and its oscillation, max − min after subtraction of the best-fit
--          parabola, or the L2 error of the pressure where nothing slides.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, sections 7.1 to 7.5, whose claims of equal accuracy are
--         checked.
-- Units: times in s of one processor; errors in %; work is Newton iterations times unknowns.
-- Expected: see share/doc/evidence/speed_against_accuracy.md. About ten minutes on one processor.
-- Run: signorini studies/speed_against_accuracy.lua [problems=ironing,hertz,rings,peeling,ironing3d] [meshes=all]
--      [rounds=3] [out=out/speed_against_accuracy] [page=none]; meshes: of the problems; rounds: runs of each case, for
--      the median of the time; page: folder of the page, such as share/doc/evidence.
--      Finished cases are kept in `out`.

local sg = require "signorini"
local page = require "page.tables"
local study = require "studies.accuracy.study"

local names = { "ironing", "hertz", "rings", "peeling", "ironing3d" }
local problems = {}
for _, name in ipairs(names) do problems[name] = require("studies.accuracy." .. name) end

local function holds(list, value)
  for _, one in ipairs(list) do
    if one == value then return true end
  end
end

--- True if one of the requested problems has a mesh.
local function is_mesh(mesh, given)
  for _, name in ipairs(given.problems) do
    if holds(problems[name].meshes, mesh) then return true end
  end
  return mesh == "all"
end

local options = sg.arguments{
  problems = { names, choices = names },
  meshes = { { "all" }, check = is_mesh, expected = "all, or meshes that one of the problems has" },
  rounds = { 3, at_least = 1 }, out = "out/speed_against_accuracy", page = "none",
}
local files, base = sg.files(options.out), options.page .. "/speed_against_accuracy"
if options.page ~= "none" then sg.mkdir(base) end

-- ── Measuring ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The requested cases of a problem.
local function cases_of(problem)
  local list, affordable = {}, problem.affordable or function() return true end
  for _, mesh in ipairs(problem.meshes) do
    local wanted = options.meshes[1] == "all" or holds(options.meshes, mesh)
    for _, row in ipairs(wanted and problem.series or {}) do
      for i = 2, #row do
        if affordable(row[i], mesh, row[1]) then list[#list + 1] = { order = row[i], setting = row[1], mesh = mesh } end
      end
    end
  end
  return list
end

--- The exact solution with the published penalty, against which claims of the thesis are checked.
local limits = { ironing = { order = "N2-N2.2", setting = "published penalty", mesh = "m4" },
                 hertz = { order = "N2-N2.2", setting = "published penalty", mesh = "m5" } }

local function label(row) return row.setting == "default" and row.order or ("%s, %s"):format(row.order, row.setting) end

--- Draws and compares one error of a result: the comparison of sg.work_precision.
local function compare(result, key, error, ylabel)
  local problem, list = result.problem, { files(("%s_%s.png"):format(result.problem.name, key)) }
  if options.page ~= "none" then list[2] = ("%s/%s_%s.png"):format(base, problem.name, key) end
  return sg.work_precision(result.cases:with("discretization", label), {
    time = "cpu", error = error, series = "discretization", marker = false, files = list, size = { 1600, 1100 },
    where = function(row)
      return holds(result.labels, label(row)) and holds(problem.meshes, row.mesh)
        or key == "force" and study.find({ row }, problem.reference) ~= nil
    end,
    title = problem.title, xlabel = "processor time (s)", ylabel = ylabel,
  })
end

local results, comparisons = {}, {}
for _, name in ipairs(options.problems) do
  local problem, cases = problems[name], cases_of(problems[name])
  if #cases > 0 then
    local labels, finest = {}, cases[#cases].mesh
    for i, case in ipairs(cases) do labels[i] = label(case) end
    if options.meshes[1] == "all" then cases[#cases + 1] = limits[name] end
    local result = study.of(problem, cases, options.rounds, options.out, function(case)
      return case == limits[name] or problem.once and problem.once[case.mesh]
    end)
    result.labels, result.finest = labels, finest
    local reference = { order = problem.reference.order, setting = problem.reference.setting,
                        mesh = problem.reference.mesh, way = "" }
    comparisons[name] = {
      force = compare(result, "force", { of = "force", reference = reference },
        ("error of the %s (%%)"):format(problem.force)),
      second = compare(result, problem.second[1], problem.second[1], problem.second[2]),
    }
    results[#results + 1], results[name] = result, result
  end
end

-- ── Tables ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- "N2 m1: 41, 0.12 s": name, work in thousands and time of the case of least time whose error is within a limit, as
--- are those on all finer meshes: errors of mesh, penalty and thickness degree that cancel on one mesh do not count.
local function cheapest(result, error, limit)
  local best
  for _, row in ipairs(result.chosen.rows) do
    local within = not row.failed and holds(result.labels, label(row)) and study.find(result.chosen.rows,
      { order = row.order, setting = row.setting, mesh = result.finest }) ~= nil
    for _, other in ipairs(result.chosen.rows) do
      if within and label(other) == label(row) and other.unknowns >= row.unknowns then
        within = not other.failed and other[error] and other[error] <= limit
      end
    end
    if within and not (best and best.cpu <= row.cpu) then best = row end
  end
  return best and ("%s %s: %.0f, %.2g s"):format(label(best), best.mesh, best.work / 1e3, best.cpu) or "none"
end

local function cheapest_rows()
  local rows = {}
  for i, result in ipairs(results) do
    local problem, second = result.problem, result.problem.second[1]
    rows[i] = { problem.title, cheapest(result, "error", 5), cheapest(result, "error", 1), second,
                cheapest(result, second, 5), cheapest(result, second, 1),
                ("%s %.5g %s"):format(problem.force, result.reference.force, problem.unit), result.bar }
  end
  return rows
end

--- What the thesis calls equally accurate: problem, case, other case.
local claims = {
  { "ironing", "N2-N2.2", "m1", "N2", "m3" }, { "hertz", "N2-N2.2", "m3", "N2", "m4" },
  { "hertz", "N2-N2.2", "m1", "L1", "m2" }, { "hertz", "N2-N2.2", "m2", "L1", "m3" },
}

local function claim_rows()
  local rows = {}
  for _, claim in ipairs(claims) do
    local result = results[claim[1]]
    local limit = result and study.find(result.cases.rows, limits[claim[1]])
    local function of(order, mesh)
      return result and study.find(result.chosen.rows, { order = order, mesh = mesh, setting = "published" })
    end
    local a, b = of(claim[2], claim[3]), of(claim[4], claim[5])
    if a and b and limit then
      local function error_of(row) return 100 * math.abs(row.force / limit.force - 1) end
      local second = result.problem.second[1]
      rows[#rows + 1] = { result.problem.title, ("%s %s as %s %s"):format(claim[2], claim[3], claim[4], claim[5]),
                          error_of(a), error_of(b), second, a[second], b[second], a.cpu / b.cpu }
    end
  end
  return rows
end

local tables = {
  { name = "cheapest", columns = { "problem", "force to 5 %", "force to 1 %", "second quantity", "to 5 %", "to 1 %",
    "reference", "± (%)" }, rows = cheapest_rows() },
  { name = "claims", columns = { "problem", "claim", "error of the force (%)", "of the other (%)", "second quantity",
    "of it (%)", "of the other (%)", "time ratio" }, rows = claim_rows() },
}
for _, tabled in ipairs(tables) do print(("\n%s"):format(sg.table{ columns = tabled.columns, rows = tabled.rows })) end

-- ── Files ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- All pairs of two curves with their ratio of times at equal error.
local function ratio_rows()
  local rows = {}
  for _, result in ipairs(results) do
    for _, key in ipairs { "force", "second" } do
      local name = key == "force" and "force" or result.problem.second[1]
      for _, ratio in ipairs(comparisons[result.problem.name][key].ratios) do
        if not ratio.why then
          rows[#rows + 1] = { result.problem.name, name, ratio.a, ratio.b, ratio.from, ratio.to, ratio.ratio[1],
                              ratio.ratio[2], ratio.ratio[3] }
        end
      end
    end
  end
  return rows
end

local function write_csv(file)
  sg.csv.write(file, { columns = { "problem", "error of", "a", "b", "smallest error", "largest error",
    "time a/b at smallest", "in the middle", "at largest" }, rows = ratio_rows() })
end

write_csv(files "ratios.csv")
if options.page ~= "none" and #results > 0 then
  local data = { script = "scripts/studies/speed_against_accuracy.lua", made = page.made(results), tables = tables,
                 problems = {} }
  for i, result in ipairs(results) do data.problems[i] = page.cases(result) end
  page.write(base, data)
  write_csv(base .. "/ratios.csv")
end
files:report()

return { results = results, comparisons = comparisons, tables = tables, files = files }
