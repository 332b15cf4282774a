-- sg.work_precision: ratios of known curves, the front, omitted cases, pictures, invalid arguments.

require "check"

local meshes = { "m1", "m2", "m3", "m4" }

--- A study with rows { order, mesh, wall, dPx, failed, reason }.
local function study(rows)
  return setmetatable({ name = "ironing", parameters = { "order", "mesh" }, results = { "dPx", "dofs" },
                        units = { wall = "s" }, rows = rows }, core.types.study)
end

--- Cases of one order with these walls and errors.
local function cases(order, walls, errors)
  local rows = {}
  for i, wall in ipairs(walls) do
    rows[i] = { order = order, mesh = meshes[i], wall = wall, dPx = errors[i], dofs = 100 * i }
  end
  return rows
end

local function joined(...)
  local all = {}
  for _, rows in ipairs { ... } do table.move(rows, 1, #rows, #all + 1, all) end
  return study(all)
end

--- error = factor time^-rate at these times.
local function power(order, walls, factor, rate)
  local errors = {}
  for i, wall in ipairs(walls) do errors[i] = factor * wall ^ -rate end
  return cases(order, walls, errors)
end

local function compare(rows, more)
  return sg.work_precision(rows, lists.merged({ error = "dPx" }, more))
end

check.case("power laws: the cost ratio at equal error is that of their formulas", function()
  -- N2: e = t^-1 from 1 to 1/8; N4: e = 3 t^-2 from 3/4 to 3/64: t2/t4 = (1/e) / sqrt(3/e) = 1 / sqrt(3 e).
  local both = joined(power("N2", { 1, 2, 4, 8 }, 1, 1), power("N4", { 2, 4, 8 }, 3, 2))
  local ratio = compare(both).ratios[1]
  check.equal({ ratio.a, ratio.b }, { "N2", "N4" })
  check.near({ ratio.from, ratio.to }, { 1 / 8, 3 / 4 })
  check.near(ratio.at, { 1 / 8, math.sqrt(3 / 32), 3 / 4 })
  for i, size in ipairs(ratio.at) do check.near(ratio.ratio[i], 1 / math.sqrt(3 * size), 1e-12) end
  local chosen = compare(both, { at = { 0.9, 0.5, 0.2, 0.1 } }).ratios[1]
  check.equal({ chosen.ratio[1], chosen.ratio[4] }, { nil, nil }) -- beyond what both reach
  check.near({ chosen.ratio[2], chosen.ratio[3] }, { 1 / math.sqrt(1.5), 1 / math.sqrt(0.6) }, 1e-12)
end)

check.case("all pairs once, in the order of the study; signs of errors do not count", function()
  local result = compare(joined(power("N2", { 1, 2, 4 }, 1, 1), power("N3", { 1, 2, 4 }, -0.5, 1),
    power("N4", { 1, 2, 4 }, 0.25, 1)))
  local pairs_of = {}
  for i, ratio in ipairs(result.ratios) do pairs_of[i] = ratio.a .. "/" .. ratio.b end
  check.equal(pairs_of, { "N2/N3", "N2/N4", "N3/N4" })
  check.near(result.ratios[1].ratio, { 2, 2, 2 }, 1e-12)
  check.near(result.ratios[2].ratio, { 4, 4, 4 }, 1e-12)
end)

check.case("nothing is extrapolated: pairs without common errors have no ratio, and say why", function()
  local result = compare(joined(power("N2", { 1, 2 }, 1, 1), power("N4", { 1, 2 }, 0.1, 1)))
  local ratio = result.ratios[1]
  check.equal({ ratio.from, ratio.to, #ratio.ratio }, { nil, nil, 0 })
  check.holds(ratio.why, "0.5 to 1", "0.05 to 0.1")
  check.holds(tostring(result), "N2, N4: no dPx that both reach: one reaches 0.5 to 1, the other 0.05 to 0.1")
  check.holds(result:table(), "N2  N4  –     –   –        –       –")
end)

check.case("curves that rise again: the least time counts, and errors above the cheapest case's are unknown", function()
  local bumpy = cases("N2", { 1, 2, 4, 8 }, { 0.4, 0.1, 0.2, 0.05 })
  local steady = power("N4", { 0.5, 1, 16 }, 0.4, 1)
  local ratio = compare(joined(bumpy, steady), { at = { 0.5, 0.4, 0.2, 0.1, 0.08, 0.04 } }).ratios[1]
  check.near({ ratio.from, ratio.to }, { 0.05, 0.4 })
  check.equal({ ratio.ratio[1], ratio.ratio[6] }, { nil, nil })
  -- 0.4 to 0.1 from 1 to 2 s: t = (0.4/e)^(1/2); then 0.2 to 0.05 from 4 to 8 s: t = 4 (0.2/e)^(1/2); N4: t = 0.4/e.
  check.near({ ratio.ratio[2], ratio.ratio[3], ratio.ratio[4], ratio.ratio[5] },
    { 1, 2 ^ 0.5 / 2, 2 / 4, 4 * 2.5 ^ 0.5 / 5 }, 1e-12)
end)

check.case("equal times and single cases divide by nothing", function()
  local same = joined(cases("N2", { 1, 1, 1 }, { 0.4, 0.2, 0.1 }), cases("N4", { 1, 2 }, { 0.2, 0.05 }),
    cases("N6", { 3 }, { 0.1 }))
  local ratios = compare(same).ratios
  check.near({ ratios[1].from, ratios[1].to }, { 0.1, 0.1 })      -- N2 at 1 s reaches 0.1: more it does not tell
  check.near(ratios[1].ratio, { 1 / 2 ^ 0.5, 1 / 2 ^ 0.5, 1 / 2 ^ 0.5 }, 1e-12)
  check.near(ratios[2].ratio, { 1 / 3, 1 / 3, 1 / 3 }, 1e-12)
  check.near(ratios[3].ratio[2], 2 ^ 0.5 / 3, 1e-12)
  check.equal(#compare(joined(cases("N2", { 1 }, { 0.1 }))).ratios, 0)
end)

check.case("the Pareto front: all cases that no other case beats in error and time", function()
  local result = compare(joined(cases("N2", { 1, 2, 4, 9 }, { 0.4, 0.3, 0.1, 0.1 }), cases("N4", { 2, 3, 5, 8 },
    { 0.2, 0.25, 0.1, 0.01 })))
  local front = {}
  for i, row in ipairs(result.pareto) do front[i] = row.order .. row.mesh end
  check.equal(front, { "N2m1", "N4m1", "N2m3", "N4m4" })
  check.holds(result:front(), "order  mesh  wall   dPx", "N2     m3       4   0.1")
end)

check.case("cases that failed, or cannot be shown on the axes, are left out and listed", function()
  local rows = cases("N2", { 1, 2, 4, 8 }, { 0.4, 0.2, 0.1, 0.05 })
  rows[5] = { order = "N2", mesh = "m5", wall = 3, failed = true, reason = "diverged\nat step 3" }
  rows[6] = { order = "N2", mesh = "m6", wall = 3 }
  rows[7] = { order = "N2", mesh = "m7", dPx = 3 }
  rows[8] = { order = "N2", mesh = "m8", wall = 3, dPx = 0 }
  rows[9] = { order = "N2", mesh = "m9", wall = 0, dPx = 1 }
  local result = compare(study(rows))
  check.equal({ #result.left_out, #result.curves[1].points }, { 5, 4 })
  check.equal(result.left_out[1].row == rows[5], true)
  check.holds(tostring(result), "order = N2, mesh = m5: failed: diverged\n", "mesh = m6: no dPx", "mesh = m7: no wall",
    "mesh = m8: dPx is 0", "mesh = m9: wall is 0")
  check.equal(#compare(study(rows), { where = function(row) return row.mesh < "m5" end }).left_out, 0)
end)

check.case("columns and functions for time, series and markers", function()
  local both = joined(power("N2", { 1, 2, 4 }, 1, 1), power("N4", { 1, 2, 4 }, 0.5, 1))
  local result = compare(both, { time = "dofs" })
  check.near(result.ratios[1].ratio, { 300 / 200, 3 ^ 0.5, 200 / 100 }, 1e-12)
  result = compare(both, { series = function(row) return "all" end })
  check.equal({ #result.curves, result.curves[1].name, #result.curves[1].points }, { 1, "all", 6 })
  result = compare(both, { error = function(row) return row.dPx * 2 end, series = "mesh" })
  check.equal({ #result.curves, result.curves[3].points[1].error }, { 3, 0.25 })
end)

check.case("the chart: a color per order, a marker per mesh, both in the legend, the front behind them", function()
  local charts = {}
  rawset(core.sg, "chart", function(options) charts[#charts + 1] = options end)
  local both = joined(power("N2", { 1, 2, 4 }, 1, 1), power("N4", { 2, 4, 8 }, 3, 2))
  local ok, message = pcall(function()
    compare(both, { files = { "a.png", "b.svg" } })
    compare(both, { file = "c.png", marker = false, title = "Ironing", xlabel = "seconds" })
    compare(both, { file = "d.png", marker = function(row) return "mesh " .. row.mesh end })
  end)
  rawset(core.sg, "chart", nil)
  check.equal({ ok, message }, { true })
  local first, plain, own = charts[1], charts[3], charts[4]
  check.equal({ #charts, first.file, charts[2].file, first.log }, { 4, "a.png", "b.svg", "xy" })
  check.equal({ first.xlabel, first.ylabel, first.title }, { "wall (s)", "dPx", "ironing" })
  check.equal({ first.legend_title, first.marks_title, first.marks }, { "order", "mesh", { "m1", "m2", "m3" } })
  check.equal({ first[2].label, first[2].x, first[2].marks }, { "N4", { 2, 4, 8 }, { "m1", "m2", "m3" } })
  check.equal({ first[3].label, first[3].color }, { "Pareto front", "gray" })
  check.near(first[3].x, { 1, 1, 2, 2, 4, 4, 8, 8, 8 })
  check.near(first[3].y, { 1, 1, 1, 0.5, 0.5, 3 / 16, 3 / 16, 3 / 64, 3 / 64 })
  check.equal({ plain.marks, plain[1].marks, plain.title, plain.xlabel }, { nil, nil, "Ironing", "seconds" })
  check.equal({ own.marks[1], own.marks_title }, { "mesh m1", "" })
end)

check.case("files by their endings", function()
  local folder = check.folder()
  local files = {}
  for i, ending in ipairs { "png", "svg", "pdf" } do files[i] = ("%s/speed.%s"):format(folder, ending) end
  compare(joined(power("N2", { 1, 2, 4 }, 1, 1), power("N2-N2.2", { 1, 2, 4 }, 0.5, 1)), { files = files })
  check.holds(core.read_file(files[2]), ">order<", ">N2-N2.2<", ">Pareto front<", ">mesh<", ">m3<", ">wall (s)<")
  for _, file in ipairs(files) do check.equal(core.exists(file), true) end
end)

check.case("wrong arguments", function()
  local good = joined(power("N2", { 1, 2 }, 1, 1))
  local function fails(options, ...)
    check.fails(function() sg.work_precision(good, options) end, "work_precision_test.lua:", ...)
  end
  fails({ error = "dPy" }, "error must be", "did you mean 'dPx'?")
  fails({ error = "mesh" }, "error (of the case order = N2, mesh = m1) must return finite numbers, got the string 'm1'")
  fails({ error = function() return 0 / 0 end }, "must return finite numbers, got nan")
  fails({ error = "dPx", file = "a.png", files = { "b.png" } }, "leave one of them out")
  fails({ error = "dPx", file = "a.gif" }, "a.gif", ".png, .svg or .pdf")
  fails({ error = "dPx", where = function() return false end }, "no case has both wall and dPx")
  local many = {}
  for i = 1, 17 do many[i] = { order = "N2", mesh = "m" .. i, wall = i, dPx = 1 / i } end
  check.fails(function() compare(study(many), { marker = "mesh" }) end, "marker has 17 values", "16 markers")
  check.equal(#compare(study(many)).curves[1].points, 17) -- not asked for, they are left out
end)
