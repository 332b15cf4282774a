-- Which model is enough: one lever at a time from a base model of six problems; error of the force, oscillation, time.
--
-- Problem: ironing in the plane and in 3D, Hertz's point contact, peeling, an O-ring, a pin in a bore. The base model
--          has the default settings; each lever changes one thing: rigid instead of deformable, plane or axisymmetric
--          instead of solid, half or whole, mesh, order, width of the layer, degree in the thickness direction,
--          formulation, penalty, steps. The reference has exact contact (Lagrange multipliers) on a fine mesh. Each
--          model is also solved with steps four times as long, and by plain Newton.
--
--                  |  o  <- a lever that saves time      one chart per problem: a marker per lever, hollow where plain
--            error |     o <- base model                 Newton fails; gray: the range of the error if the penalty
--                  |________ o____ time                  is between a tenth of and ten times the usual one
-- Source: chosen here; scenes of ironing2d.lua, hertz3d.lua, peeling2d.lua, objects/o_ring.lua.
-- Units: times in s of one processor; errors in %; work is Newton iterations times unknowns.
-- Expected: see share/doc/decide/which_model.md. About four minutes on one processor.
-- Run: signorini studies/which_model.lua [problems=ironing,cylinder,sphere,peeling,o_ring,pin] [rounds=3]
--      [levers=all] [out=out/which_model] [page=none]; levers: all, or a list of names; rounds: runs of the models, for
--      the least time; page: folder of the page, such as share/doc/decide. Finished cases are kept in `out`.

local sg = require "signorini"
local page = require "page.tables"
local study = require "studies.accuracy.study"

local names = { "ironing", "cylinder", "sphere", "peeling", "o_ring", "pin" }
local problems, levers = {}, { "all" }
for _, name in ipairs(names) do
  problems[name] = require("studies.accuracy." .. name)
  table.move(problems[name].levers, 1, #problems[name].levers, #levers + 1, levers)
end

local options = sg.arguments{
  problems = { names, choices = names }, rounds = { 3, at_least = 1 }, levers = { { "all" }, choices = levers },
  out = "out/which_model", page = "none",
}
local files, base_name = sg.files(options.out), options.page .. "/which_model"

-- ── Levers ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Kinds of levers in the order of the legend, each with its markers: filled, and hollow where plain Newton fails.
local kinds = {
  { "mesh", "circle" }, { "rigid, plane, symmetry", "square" }, { "order, layer", "triangle" },
  { "thickness degree", "diamond" }, { "formulation, penalty", "triangle down" }, { "steps", "pentagon" },
}
local kind_of = {
  ["rigid body"] = 2, ["whole model"] = 2, ["plane model"] = 2, ["solid model"] = 2, ["longer strip"] = 2,
  ["local layer"] = 3, ["layer at the edge"] = 3, ["following layer"] = 3, ["thickness degree 1"] = 4,
  ["projected volume"] = 4, ["mortar equal"] = 5, ["multipliers"] = 5, ["penalty / 10"] = 5, ["penalty × 10"] = 5,
  ["half the steps"] = 6,
}

--- The case of a lever: a mesh such as m1, a discretization such as N2, or a setting.
local function case_of(base, lever)
  local case = { order = base.order, setting = base.setting, mesh = base.mesh, lever = lever,
                 kind = lever:match "^[NL]%d" and 3 or kind_of[lever] or 1 }
  local key = lever:match "^m%d$" and "mesh" or lever:match "^[NL]%d" and "order" or "setting"
  if lever ~= "base" then case[key] = lever end
  return case
end

local function wanted(lever)
  for _, name in ipairs(options.levers) do
    if name == "all" or name == lever or lever == "base" then return true end
  end
end

-- ── Measuring ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A problem's result: levers, a list of { lever, kind, row, long (true if steps × 4 converge), plain }, base first.
local function measured(problem)
  local cases, chosen = {}, {}
  for _, lever in ipairs{ "base", table.unpack(problem.levers) } do
    if wanted(lever) then chosen[#chosen + 1] = case_of(problem.base, lever) end
  end
  for _, case in ipairs(chosen) do
    for _, way in ipairs(case.kind == 6 and { "", "plain Newton" } or { "", "steps × 4", "plain Newton" }) do
      cases[#cases + 1] = { order = case.order, setting = case.setting, mesh = case.mesh, way = way }
    end
  end
  -- The solids take long; whether a way converges does not depend on the time.
  local result = study.of(problem, cases, options.rounds, options.out, function(case)
    return case.way ~= "" or problem.name == "cylinder"
  end)
  for _, case in ipairs(chosen) do
    local function converged(way)
      return study.find(result.cases.rows,
        { order = case.order, setting = case.setting, mesh = case.mesh, way = way })
    end
    case.row, case.plain = converged "", converged "plain Newton" ~= nil
    case.long = case.kind == 6 or converged "steps × 4" ~= nil
  end
  result.levers = chosen
  return result
end

local results = {}
for i, name in ipairs(options.problems) do
  results[i] = measured(problems[name])
  results[name] = results[i]
end

-- ── Chart ────────────────────────────────────────────────────────────────────────────────────────────────────────────

local function lever_of(result, name)
  for _, case in ipairs(result.levers) do
    if case.lever == name then return case end
  end
end

--- One chart: errors below the bar of the reference are drawn at the bar.
local function draw(result, legend)
  local problem, least = result.problem, math.max(result.bar, 1e-3)
  local times = { math.huge, 0 }
  for _, case in ipairs(result.levers) do
    if case.row then
      times[1], times[2] = math.min(times[1], case.row.cpu_low), math.max(times[2], case.row.cpu_low)
    end
  end
  local chart = { log = "xy", title = problem.title, xlabel = "processor time (s)",
                  ylabel = ("error of the %s (%%)"):format(problem.force), legend = legend and "outside" or false,
                  xrange = { times[1] / 1.3, times[2] * 1.3 }, size = { 1000, 800 } }
  local function add(kind, color, plain, label)
    local curve = { x = {}, y = {}, line = false, markers = true, color = color, label = label,
                    marker = plain and kinds[kind][2] or "open " .. kinds[kind][2] }
    for _, case in ipairs(result.levers) do
      if case.row and case.kind == kind and case.plain == plain and (color == 7) == (case.lever == "base") then
        curve.x[#curve.x + 1], curve.y[#curve.y + 1] = case.row.cpu_low, math.max(least, case.row.error)
      end
    end
    if #curve.x == 0 and label then curve.x, curve.y = { 0 / 0 }, { 0 / 0 } end
    if #curve.x > 0 then chart[#chart + 1] = curve end
  end
  add(1, 7, true, "base model")
  add(1, 7, false)
  for kind = 1, #kinds do
    add(kind, kind, true, kinds[kind][1])
    add(kind, kind, false)
  end
  local soft, hard = lever_of(result, "penalty / 10"), lever_of(result, "penalty × 10")
  if soft and hard and soft.row and hard.row then
    local low, high = math.max(least, math.min(soft.row.error, hard.row.error)),
      math.max(least, soft.row.error, hard.row.error)
    chart[#chart + 1] = { x = chart.xrange, y = { (low + high) / 2, (low + high) / 2 }, color = "gray", width = 1,
                          error = { (high - low) / 2, (high - low) / 2 }, label = "penalty / 10 to × 10" }
  end
  chart.hlines = { { result.bar, "reference" } }
  return sg.chart(chart)
end

local panels = { columns = 3, title = "Error of the force over processor time; hollow: plain Newton fails" }
for i, result in ipairs(results) do panels[i] = draw(result, i == #results) end
panels.file = files "which_model.png"
sg.sheet(panels)
if options.page ~= "none" then
  panels.file = base_name .. ".png"
  sg.sheet(panels)
end

-- ── Tables ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- "0.35 / 1.2 / 0.8": error, oscillation and time over that of the base, both the least of the rounds, which other
--- work on the machine affects least; with an asterisk if steps × 4, and a dagger if plain Newton fails.
local function text_of(case, base)
  if not case then return "–" end
  local row = case.row
  if not row then return "fails" end
  local function short(value) return value and ("%.2g"):format(value) or "–" end
  return ("%s / %s / %s%s%s"):format(short(row.error), short(row.oscillation), short(row.cpu_low / base.row.cpu_low),
    case.long and "" or " *", case.plain and "" or " †")
end

local function lever_rows()
  local list, seen, rows = {}, {}, {}
  for _, result in ipairs(results) do
    for _, case in ipairs(result.levers) do
      local name = case.lever
      if name:match "^m%d$" then name = name < result.problem.base.mesh and "coarser mesh" or "finer mesh" end
      if not seen[name] then
        seen[name] = { name = name, kind = case.kind, of = {} }
        list[#list + 1] = seen[name]
      end
      seen[name].of[result] = case
    end
  end
  for i, entry in ipairs(list) do
    entry.place = i
    if entry.name == "base" then entry.kind = 0 end
  end
  table.sort(list, function(a, b) return a.kind < b.kind or a.kind == b.kind and a.place < b.place end)
  for i, entry in ipairs(list) do
    rows[i] = { entry.name }
    for k, result in ipairs(results) do rows[i][k + 1] = text_of(entry.of[result], lever_of(result, "base")) end
  end
  return rows
end

local heads, base_rows = { "lever" }, {}
for k, result in ipairs(results) do
  heads[k + 1] = result.problem.title
  local base, reference = lever_of(result, "base"), result.problem.reference
  base_rows[k] = { result.problem.title, ("%s %s"):format(base.order, base.mesh), base.row.unknowns, base.row.work,
                   base.row.cpu_low, ("%.3g, %.3g"):format(base.row.cpu, base.row.cpu_high),
                   ("%s %s"):format(reference.order, reference.mesh), result.bar }
end
local tables = {
  { name = "levers", columns = heads, rows = lever_rows() },
  { name = "base", columns = { "problem", "base model", "unknowns", "work", "time (s)", "median, longest (s)",
    "reference", "± (%)" }, rows = base_rows },
}
for _, tabled in ipairs(tables) do print(("\n%s"):format(sg.table{ columns = tabled.columns, rows = tabled.rows })) end
if options.page ~= "none" then
  local data = { script = "scripts/studies/which_model.lua", made = page.made(results), tables = tables,
                 problems = {} }
  for i, result in ipairs(results) do data.problems[i] = page.cases(result) end
  page.write(base_name, data)
end
files:report()

return { results = results, tables = tables, files = files }
