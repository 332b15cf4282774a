-- Layer depth: error and time of one, two, three and all rows of enriched control points.
--
-- Problem: the thesis enriches one row of control points, that of the contact face: N2-N2.1 is N2 except for this row.
--          A patch is a stack of rows, each of which can be refined separately, so a layer can be deeper: N2-N2.1x2,
--          N2-N2.1x3, up to all rows, N2.1. Four problems run with each depth of the layers N2.1, N2.2 and N4.
--
--              N2 ______________   rows of control points: all N2   (0 rows)
--                 --------------                           ...
--                 ______________   N2.1                            (2 rows: N2-N2.1x2)
--          contact ______________  N2.1                            (1 row:  N2-N2.1)
--
--          peeling (m1): oscillation dM of the moment; ironing (m1): oscillations dPy and dPx of the forces; Hertz
--          (m2): L2 error of p/p_ref; rings (m1): L2 error of p_N. Models and error measures are those of the four
--          scripts; reference of the rings: m4.
-- Source: no publication on layers of more than one row; the problems are those of V. Agrawal, An Accurate and
--         Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of Contact Problems, PhD
--         thesis, IIT Guwahati, 2020, sections 7.1 to 7.4. Plain Newton, as published.
-- Units: dM in 1e-3 E0 L0³; dPy, dPx in 1e-3 N/mm; errors of pressures as in hertz2d and rings2d; times in s.
-- Expected: peeling: with two rows of N2.2, dM is at most a fifth of that with one row (an independent program: 0.64
--           with one row, 0.052 with two; N2.1: 0.86 with one, 0.28 with two, 0.29 with all). N4, which adds no
--           functions inside elements, does not benefit from depth.
-- Run: signorini layer_depth.lua [problems=peeling,ironing,hertz,rings] [layers=N2.1,N2.2,N4] [rows=1,2,3,all]
--      [repeat=3] [linear=auto] [peeling=mesh=m1] [ironing=mesh=m1] [hertz=meshes=m2;sizes=1]
--      [rings=meshes=m1;reference=m4] [out=out/layer_depth]; repeat: number of runs, of which the time is the median
--      (peeling: always one); the value of a problem's name is passed to its script, several arguments separated by
--      ';'.

local sg = require "signorini"

--- Per problem: its script, the script's arguments unless others are given, its argument for the number of runs (none:
--- a run is too long for more than one), and what to read off one of its cases: degrees of freedom, seconds, errors as
--- by names.
local problems = {
  peeling = {
    script = "peeling2d", arguments = "mesh=m1", title = "Peeling",
    names = { "dM" }, units = { "1e-3 E0 L0³" }, factors = { 1e3 },
    read = function(case) return case.dofs, case.work.wall, { case.window.oscillation } end,
  },
  ironing = {
    script = "ironing2d", arguments = "mesh=m1", repeats = "repeat", title = "Ironing",
    names = { "dPy", "dPx" }, units = { "1e-3 N/mm", "1e-3 N/mm" }, factors = { 1e3, 1e3 },
    read = function(case)
      return case.die_dofs.total + case.slab_dofs.total, case.work.wall, { case.dPy.raw, case.dPx.raw }
    end,
  },
  hertz = {
    script = "hertz2d", arguments = "meshes=m2;sizes=1", repeats = "repeats", title = "Hertz",
    names = { "L2 error of p/p_ref" }, units = { "1e-3" }, factors = { 1e3 },
    read = function(case) return case.dofs.total, case.times.wall, { case.error } end,
  },
  rings = {
    script = "rings2d", arguments = "meshes=m1;reference=m4", repeats = "repeats", title = "Rings",
    names = { "L2 error of p_N" }, units = { "N/m²√m" }, factors = { 1 },
    read = function(case) return case.dofs, case.times.wall, { case.pN_error } end,
  },
}
local base = "N2"

-- ── Runs ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The order of a layer of a depth: "N2-N2.1", "N2-N2.1x2", "N2.1".
local function order_of(layer, depth)
  if depth == "all" then return layer end
  return ("%s-%s%s"):format(base, layer, depth == "1" and "" or "x" .. depth)
end

--- Runs a problem's script with all orders. Returns its cases: { layer, depth, order, dofs, wall, errors }, the first
--- one that of no layer.
local function study(name, options)
  local problem = problems[name]
  local cases, orders = { { layer = base, depth = "0", order = base } }, { base }
  for _, layer in ipairs(options.layers) do
    for _, depth in ipairs(options.rows) do
      local order = order_of(layer, depth)
      cases[#cases + 1], orders[#orders + 1] = { layer = layer, depth = depth, order = order }, order
    end
  end
  local words = {}
  for word in options[name]:gmatch "[^;]+" do words[#words + 1] = word end
  words[#words + 1] = "orders=" .. table.concat(orders, ",")
  words[#words + 1] = "linear=" .. options.linear
  if problem.repeats then words[#words + 1] = ("%s=%d"):format(problem.repeats, options["repeat"]) end
  words[#words + 1] = ("out=%s/%s"):format(options.out, name)
  local script = assert(loadfile(assert(package.searchpath("problems." .. problem.script, package.path))))
  local found = {}
  for _, case in ipairs(script(table.unpack(words)).cases) do found[case.order] = case end
  for _, case in ipairs(cases) do
    case.dofs, case.wall, case.errors = problem.read(found[case.order])
    for i, factor in ipairs(problem.factors) do case.errors[i] = case.errors[i] and factor * case.errors[i] end
  end
  return cases
end

-- ── Output ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The case of a layer's first row.
local function one_row(cases, layer)
  for _, case in ipairs(cases) do
    if case.layer == layer and case.depth == "1" then return case end
  end
end

local function depth_table(cases, problem)
  local sheet = { columns = {}, units = {}, formats = {}, rows = {} }
  local function add(column, unit, format)
    local i = #sheet.columns + 1
    sheet.columns[i], sheet.units[i], sheet.formats[i] = column, unit, format
  end
  for _, column in ipairs { "layer", "rows", "order" } do add(column, "", "%s") end
  add("DOFs", "", "%d")
  for i, name in ipairs(problem.names) do
    add(name, problem.units[i], "%.4f")
    add("of one row", "", "%.3f")
  end
  add("time", "s", "%.2f")
  add("of one row", "", "%.2f")
  for i, case in ipairs(cases) do
    local one, row = one_row(cases, case.layer), { case.layer, case.depth, case.order, case.dofs }
    for j in ipairs(problem.names) do
      local whole = one and one.errors[j]
      row[3 + 2 * j] = case.errors[j]
      row[4 + 2 * j] = whole and case.errors[j] and case.errors[j] / whole
    end
    row[#sheet.columns - 1], row[#sheet.columns] = case.wall, one and case.wall / one.wall
    sheet.rows[i] = row
  end
  return sg.table(sheet)
end

--- Error over time: a line per layer from no row to all, a marker per depth. Returns whether there was anything to
--- draw.
local function draw(file, cases, problem, figure, options)
  local name = problem.names[figure]
  local chart = { file = file, log = "xy", xlabel = "time (s)",
                  ylabel = ("%s (%s)"):format(name, problem.units[figure]),
                  title = ("%s: %s over time, by rows of the layer"):format(problem.title, name) }
  local function curve(label, wanted, look)
    look.x, look.y, look.label = {}, {}, label
    for _, case in ipairs(cases) do
      if case.errors[figure] and wanted(case) then
        look.x[#look.x + 1], look.y[#look.y + 1] = case.wall, case.errors[figure]
      end
    end
    if #look.x > 0 then chart[#chart + 1] = look end
  end
  for i, layer in ipairs(options.layers) do
    curve(layer, function(case) return case.layer == layer or case.depth == "0" end,
      { color = i, marker = "none" })
  end
  local markers = { "circle", "square", "triangle", "diamond", "pentagon", "cross" }
  for i, depth in ipairs { "0", table.unpack(options.rows) } do
    curve(depth == "0" and "N2 alone" or depth == "1" and "1 row" or depth .. " rows",
      function(case) return case.depth == depth end,
      { color = #options.layers + 1, line = false, markers = true, marker = markers[(i - 1) % #markers + 1] })
  end
  if #chart > 0 then sg.chart(chart) end
  return #chart > 0
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

local function is_depth(depth) return depth == "all" or (math.tointeger(tonumber(depth)) or 0) >= 1 end
local names = { "peeling", "ironing", "hertz", "rings" }
local arguments = {
  problems = { names, choices = names }, layers = { "N2.1", "N2.2", "N4" },
  rows = { { "1", "2", "3", "all" }, check = is_depth, expected = "whole numbers of at least 1, or all" },
  ["repeat"] = 3, linear = "auto", out = "out/layer_depth",
}
for _, name in ipairs(names) do arguments[name] = problems[name].arguments end
local options = sg.arguments(arguments)
local studies, files = {}, sg.files(options.out)
for _, name in ipairs(options.problems) do
  print(("\n=== %s ==="):format(problems[name].title))
  studies[name] = study(name, options)
end
for _, name in ipairs(options.problems) do
  local problem, cases = problems[name], studies[name]
  print(("\n%s: error and time by the depth of the layer (of one row: compared with the same layer one row deep)")
    :format(problem.title))
  print(depth_table(cases, problem))
  local data = { columns = { "layer", "rows", "order", "dofs", "wall_s", table.unpack(problem.names) }, rows = {} }
  for i, case in ipairs(cases) do
    data.rows[i] = { case.layer, case.depth, case.order, case.dofs, case.wall,
                     table.unpack(case.errors, 1, #problem.names) }
  end
  sg.csv.write(files(name .. ".csv"), data)
  for i, figure in ipairs(problem.names) do
    local file = ("%s_%s.png"):format(name, figure:match "^%w+")
    files:draw(file, "a case that reaches what is measured", function(path)
      return draw(path, cases, problem, i, options)
    end)
  end
end
files:report()

return { studies = studies, files = files }
