-- Fits: closed forms of linear problems, what data do not determine, several sets, files, error bars, searches that
-- fail, end early or go on, and wrong input.

local check, sg, lists, core = require "check", require "signorini", require "signorini.call.lists", core
local statistics, interpolation = require "signorini.inverse.statistics", require "signorini.inverse.interpolation"

local tight = { newton = { tolerance = 1e-12 } }

--- A block of linear material without lateral strain on a penalty plane, pressed in steps to d: F = −ε k d/(k + ε),
--- k = E/H per width 1.
local function pressed(q)
  local block = sg.body { patch = sg.shapes.rectangle { width = 1, height = 0.5 },
                          elements = { 2, 4 }, order = "N2", material = sg.linear_elastic { E = q.E, nu = 0 } }
  local model = sg.model {
    bodies = { block = block },
    supports = { lid = { on = block:face "north", fix = "x", drive = "y" } },
    contacts = { c = { slave = block:face "south", master = sg.rigid.plane { point = { 0, 0 }, normal = { 0, 1 } },
                       penalty = q.eps, per = "reference" } } }
  return model, { { name = "press", steps = 4, lid = -0.02 }, { name = "release", steps = 2, lid = -0.01 } }, tight
end

--- F at a displacement.
local function force(E, eps, d) return eps * 2 * E / (2 * E + eps) * d end

local function points_of(E, eps, noise)
  return lists.map({ -0.005, -0.01, -0.015, -0.02 }, function(d, i)
    return { d, force(E, eps, d) + (noise and noise[i] or 0) }
  end)
end

local with_eps = { eps = { 10, 10 } }

local function fit(keys)
  return sg.fit(lists.merged({ scene = pressed, start = { E = 5, eps = 10 }, bounds = with_eps, check = false,
    data = { { x = "lid.uy", y = "lid.fy", stage = "press", points = points_of(2, 10) } } }, keys))
end

check.case("exact data give the values back, from far away", function()
  local found = fit { start = { E = 50, eps = 10 } }
  check.near(found.at.E, 2, 1e-6)
  check.equal({ found.at.eps, found.reason, found.points, found.undetermined }, { 10, "converged", 4, {} })
  check.at_most("runs", #found.tries, 8)
  check.near(check.last(found.run, "lid.fy"), force(2, 10, -0.01), 1e-9)
end)

check.case("intervals are those of linear least squares, with Student's distribution", function()
  -- F = c(E) d: c by least squares, its variance s²/Σ d², that of ln E by d ln c/d ln E.
  local noise, sum_dd, sum_df = { 3e-4, -1e-4, 2e-4, -4e-4 }, 0, 0
  local points = points_of(2, 10, noise)
  for _, point in ipairs(points) do sum_dd, sum_df = sum_dd + point[1] ^ 2, sum_df + point[1] * point[2] end
  local c, rest = sum_df / sum_dd, 0
  for _, point in ipairs(points) do rest = rest + (point[2] - c * point[1]) ^ 2 end
  local E = 10 * c / (10 - c) / 2
  local slope = 10 / (2 * E + 10) -- of ln c by ln E
  local half = 3.182446305 * math.sqrt(rest / 3 / sum_dd) / c / slope
  for _, sigma in ipairs { 1e-3, { 1e-3, 1e-3, 1e-3, 1e-3 } } do
    local found = fit { data = { { x = "lid.uy", y = "lid.fy", stage = "press", points = points, sigma = sigma } } }
    check.near(found.at.E, E, 1e-5)
    check.near(found.intervals.E, { E * math.exp(-half), E * math.exp(half) }, 1e-4)
    check.near(found.scatter, math.sqrt(rest / 3) / 1e-3, 1e-5)
  end
  check.near({ statistics.student(0.05, 1), statistics.student(0.05, 2), statistics.student(0.05, 10) },
    { 12.706204736, 4.302652730, 2.228138852 }, 1e-9) -- published tables
end)

check.case("parameters that the data do not determine are named, and moved no farther than they tell", function()
  -- Only ε k/(k + ε) matters.
  local found = fit { bounds = {}, start = { E = 4, eps = 8 },
                      data = { { x = "lid.uy", y = "lid.fy", stage = "press", points = points_of(2, 10,
                        { 3e-4, -1e-4, 2e-4, -4e-4 }) } } }
  check.equal(#found.undetermined >= 1, true)
  check.holds(found.warnings[1], "not determined by these data")
  check.holds(tostring(found), "–")
  local series = 2 * found.at.E * found.at.eps / (2 * found.at.E + found.at.eps)
  check.near(series, 40 / 14, 0.05)
  check.at_most("moves", math.abs(math.log(found.at.eps / 8)), math.log(2))
end)

check.case("a parameter at its bound has no interval", function()
  local found = fit { bounds = lists.merged(with_eps, { E = { 3, 10 } }) }
  check.equal({ found.at.E, found.intervals.E }, { 3, nil })
  check.holds(table.concat(found.warnings), "'E' is at a bound")
end)

check.case("a bound of 0 is reached, also where nothing exists beyond it; so is one next to 0", function()
  --- Two springs in parallel, E and E2 ≥ 0.
  local function parallel(q)
    if q.E2 < 0 then error("E2 must not be negative", 0) end
    return pressed { E = q.E + q.E2, eps = 10 }
  end
  for _, low in ipairs { 0, 1e-6 } do
    local found = sg.fit { scene = parallel, start = { E = 2, E2 = 1 }, bounds = { E = { 2, 2 }, E2 = { low, 5 } },
                           data = { { x = "lid.uy", y = "lid.fy", stage = "press", points = points_of(2, 10) } } }
    check.near({ found.at.E2 + 1, found.reason }, { low + 1, "converged" }, 1e-9)
  end
  local begun = sg.fit { scene = parallel, start = { E = 2, E2 = 0 }, bounds = { E = { 2, 2 }, E2 = { 0, 5 } },
                         data = { { x = "lid.uy", y = "lid.fy", stage = "press", points = points_of(3, 10) } } }
  check.near(begun.at.E2, 1, 1e-6)
end)

check.case("only the product of two parameters matters; a curve of zeros tells nothing", function()
  local found = sg.fit { scene = function(q) return pressed { E = q.a * q.b, eps = 10 } end, start = { a = 1, b = 1.5 },
                         data = { { x = "lid.uy", y = "lid.fy", stage = "press", points = points_of(2, 10) } } }
  check.equal({ found.undetermined, found.intervals }, { { "a", "b" }, {} })
  check.near(found.at.a * found.at.b, 2, 1e-6)
  local zeros = fit { data = { { x = "step", y = "lid.fx", stage = "press",
                                 points = { { 1, 0 }, { 2, 0 }, { 3, 0 } } } } }
  check.equal({ zeros.undetermined, zeros.at.E }, { { "E" }, 5.0 })
end)

check.case("data that the run does not reach at the start, or no longer", function()
  --- Pressed by a force, so that the motion follows from E.
  local function loaded(q)
    local block = sg.body { patch = sg.shapes.rectangle { width = 1, height = 0.5 }, elements = { 2, 4 }, order = "N2",
                            material = sg.linear_elastic { E = q.E, nu = 0 } }
    local plane = sg.rigid.plane { point = { 0, 0.5 }, normal = { 0, -1 } }
    local model = sg.model { bodies = { block = block },
      supports = { bed = { on = block:face "south", fix = "xy" }, tool = { on = plane, free = "y" } },
      loads = { weight = { on = plane, force = { 0, 0 } } },
      contacts = { c = { slave = block:face "north", master = plane, penalty = 10, per = "reference" } } }
    return model, { { steps = 4, weight = { 0, -0.04 } } }, tight
  end
  local function points(E, force_at_end)
    return lists.map({ 0.25, 0.5, 0.75, 1 }, function(part)
      local F = part * force_at_end
      return { -F / (20 * E / (2 * E + 10)), -F }
    end)
  end
  local function fitted(start, data)
    return sg.fit { scene = loaded, start = { E = start }, check = false,
                    data = { { x = "tool.uy", y = "c.fy", points = data } } }
  end
  local reached = fitted(3, points(2, 0.03)) -- the run at the start ends before the last points
  check.near(reached.at.E, 2, 1e-5)
  local beyond = fitted(1, points(2, 0.08))
  check.holds(table.concat(beyond.warnings, "; "), "lie beyond the end of the run")
end)

check.case("parameters that may be negative move in parts of their scale", function()
  -- A gap between block and plane: F = −c (d − gap).
  local function with_gap(q)
    local block = sg.body { patch = sg.shapes.rectangle { width = 1, height = 0.5, corner = { 0, q.gap } },
                            elements = { 1, 1 }, order = "N2", material = sg.linear_elastic { E = 2, nu = 0 } }
    local model = sg.model {
      bodies = { block = block },
      supports = { lid = { on = block:face "north", fix = "x", drive = "y" } },
      contacts = { c = { slave = block:face "south", penalty = 10, per = "reference", overlap = "interference",
                         master = sg.rigid.plane { point = { 0, 0 }, normal = { 0, 1 } } } } }
    return model, { { steps = 4, lid = -0.04 } }, tight
  end
  local points = lists.map({ -0.01, -0.02, -0.03, -0.04 }, function(d) return { d, force(2, 10, d + 0.003) } end)
  local found = sg.fit { scene = with_gap, start = { gap = 0.008 }, bounds = { gap = { -0.01, 0.01 } }, check = false,
                         data = { { x = "lid.uy", y = "lid.fy", points = points } } }
  check.within("gap", found.at.gap, 0.003, 1e-9)
end)

check.case("several sets, files, columns and stages", function()
  local file = check.file "press.csv"
  sg.csv.write(file, { columns = { "t", "lid.fy", "lid.uy", "s" }, rows = lists.map(points_of(2, 10),
    function(point, i) return { i, point[2], point[1], 0.01 } end) })
  local other = check.file "release.csv"
  sg.csv.write(other, { columns = { "u", "F" },
                        rows = { { -0.02, force(2, 10, -0.02) }, { -0.01, force(2, 10, -0.01) } } })
  local found = fit { data = {
    { x = "lid.uy", y = "lid.fy", stage = "press", file = file, sigma = "s" },
    { x = "lid.uy", y = "lid.fy", stage = "release", file = other, sigma = 0.02 },
    { y = "lid.fy", points = { { 6, force(2, 10, -0.01) }, { 0, 0 } }, sigma = 0.01 },
  } }
  check.near(found.at.E, 2, 1e-6)
  check.equal(found.points, 8)
  local data = found:data(2)
  check.equal(data.columns, { "lid.uy", "lid.fy", "fit", "sigma" })
  check.near(data.rows[2], { -0.01, force(2, 10, -0.01), force(2, 10, -0.01), 0.02 }, 1e-6)
  local named = fit { data = { { x = "lid.uy", y = "lid.fy", stage = "press", file = file,
                                 columns = { "lid.uy", "lid.fy" } } } }
  check.near(named.at.E, 2, 1e-6)
end)

check.case("error bars weigh data, and intervals contain them", function()
  local noise = { 3e-4, -1e-4, 2e-4, -4e-4 }
  local set = { x = "lid.uy", y = "lid.fy", stage = "press", points = points_of(2, 10, noise), sigma = 1e-4 }
  local alone, both = fit { data = { set } }, fit { data = { set }, errors = true }
  -- Penalty and steps: the force of a rigid plane would be larger by k/(k + ε), 40 %.
  check.equal(both.of_solution.E > 0.1, true)
  check.equal(both.intervals.E[2] / both.intervals.E[1] > 1.2 * alone.intervals.E[2] / alone.intervals.E[1], true)
  check.holds(tostring(both), "of the solution")
  check.equal(alone.of_solution.E, nil)
end)

check.case("values at which the scene fails are a reason to go less far", function()
  local function guarded(q)
    if q.E < 1.9 then error("too soft", 0) end
    return pressed(q)
  end
  local found = fit { scene = guarded, start = { E = 5, eps = 10 } }
  check.near(found.at.E, 2, 1e-6)
  local outcomes = table.concat(lists.map(found.tries, function(one) return one.outcome end), "; ")
  local bounded = fit { scene = guarded, start = { E = 5, eps = 10 },
                        data = { { x = "lid.uy", y = "lid.fy", stage = "press", points = points_of(1, 10) } } }
  check.equal(bounded.at.E >= 1.9, true)
  check.holds(table.concat(lists.map(bounded.tries, function(one) return one.outcome end), "; ") .. outcomes,
    "not taken: too soft")
  check.holds(table.concat(bounded.warnings, "; "), "runs beyond fail: at E = 1.", "too soft")
end)

check.case("a search that ends at its limit of runs goes on from its file", function()
  local file = check.file "fit.json"
  local begun = fit { start = { E = 50, eps = 10 }, runs = 3, checkpoint = file }
  check.equal({ begun.reason, #begun.tries }, { "runs", 3 })
  check.holds(begun.warnings[1], "limit of runs")
  local done = fit { start = { E = 50, eps = 10 }, checkpoint = file, resume = true }
  check.near(done.at.E, 2, 1e-6)
  check.near(done.tries[1].values.E, begun.at.E)
  check.fails(function() fit { start = { E = 50 }, bounds = {}, checkpoint = file, resume = true } end,
    "has the parameters E, eps, start has E")
  check.fails(function() fit { resume = true } end, "resume = true needs the file")
  local foreign = check.file "other.json"
  sg.json.write(foreign, { 1, 2 })
  check.fails(function() fit { checkpoint = foreign, resume = true } end, "is not that of such a search")
end)

check.case("charts, reports, and the check of the intervals' ends", function()
  local noise = { 5e-3, -16e-3, 3e-3, -6e-3 }
  local found = fit { data = { { x = "lid.uy", y = "lid.fy", stage = "press", points = points_of(20, 10, noise),
                                 sigma = 1e-4 } }, check = true }
  check.holds(table.concat(found.warnings, "; "), "times what the standard deviations explain", "off the linear change")
  local picture, report = check.file "fit.png", check.file "fit.html"
  found:chart { file = picture }
  check.equal(core.exists(picture), true)
  found:report(report)
  check.holds(core.read_file(report), "<h2>Parameters</h2>", "95 % intervals from 4 points", "lid.fy")
end)

check.case("a study of fits", function()
  local study = sg.study { name = "fits", folder = check.folder() .. "/fits", cases = sg.grid { scale = { 1, 2 } },
    run = function(case)
      local points = lists.map(points_of(2, 10), function(point) return { point[1], case.scale * point[2] } end)
      local found = fit { data = { { x = "lid.uy", y = "lid.fy", stage = "press", points = points } } }
      return { E = found.at.E, low = found.intervals.E[1], high = found.intervals.E[2] }
    end }
  study:execute { jobs = 2 }
  -- F doubles where 2 · 40/14 = 20 E/(2 E + 10).
  check.near({ study:row { scale = 1 }.E, study:row { scale = 2 }.E }, { 2, 20 / 3 }, 1e-5)
  check.equal(study:row { scale = 1 }.low < study:row { scale = 1 }.high, true)
end)

check.case("interpolation: no overshoot, third order inside, straight beyond the ends", function()
  local x, y = {}, {}
  for i = 0, 8 do x[i + 1], y[i + 1] = i / 8, math.exp(i / 8) end
  local fine = interpolation.cubic(x, y, { 0.3, 0.55 })
  check.near(fine, { math.exp(0.3), math.exp(0.55) }, 2e-4)
  check.equal(interpolation.cubic({ 0, 1, 2, 3 }, { 0, 0, 1, 1 }, { 0.5, 2.5, -1, 4 }), { 0, 1, 0, 1 })
  check.near(interpolation.cubic({ 2, 1, 0 }, { 4, 2, 0 }, { 1.5, 3, -1 }), { 3, 6, -2 }, 1e-14)
end)

check.case("wrong input", function()
  local function refused(text, keys) check.fails(function() fit(keys) end, text) end
  local function data(keys)
    return { data = { lists.merged({ x = "lid.uy", y = "lid.fy", stage = "press", points = points_of(2, 10) }, keys) } }
  end
  refused("start.E = 5 is not within its bounds 1 to 3", { bounds = { E = { 1, 3 } } })
  refused("bounds.E must be {low, high}, got {3, 1}", { bounds = { E = { 3, 1 } } })
  refused("bounds.mu: start has no parameter of this name", { bounds = { mu = { 0, 1 } } })
  refused("all parameters are fixed by their bounds", { bounds = { E = { 5, 5 }, eps = { 10, 10 } } })
  refused("bounds.E must be {low, high}", { bounds = { E = { 0 / 0, 10 } } })
  refused("its result must be a table of numbers by name", { measure = function() return 3 end })
  refused("columns are those of a file", data { columns = { "a", "b" } })
  refused("start.E is 0, which has no size of its own", { start = { E = 0, eps = 10 } })
  refused("data has 4 points for 5 parameters", { start = { E = 5, eps = 10, a = 1, b = 1, c = 1, d = 1 } })
  refused("data[1]: y must be", data { y = "lid.fz" })
  refused("data[1]: y must be", data { y = "lid.uy" })
  refused("data[1]: stage must be", data { stage = "slide" })
  refused("lid.uy = -0.015 at step 5 turns back or stays", { data = { { x = "lid.uy", y = "lid.fy",
    points = points_of(2, 10) } } })
  refused("point 1 lies at lid.uy = -0.03, but the run goes from 0 to -0.02",
    data { points = { { -0.03, 1 }, { 0, 0 } } })
  refused("neither points nor file is given", { data = { { y = "lid.fy" } } })
  refused("both points and file are given", data { file = "a.csv" })
  refused("data[1].sigma: 1 values are given for 4 points", data { sigma = { 1 } })
  refused("data[1].sigma: 's' names a column, but there is no file", data { sigma = "s" })
  refused("several sets are weighed by the standard deviations", { data = { data({}).data[1], data({}).data[1] } })
  refused("errors needs the standard deviation", { errors = true })
  refused("nowhere.csv", { data = { { y = "lid.fy", file = "nowhere.csv" } } })
  local file = check.file "three.csv"
  sg.csv.write(file, { columns = { "a", "b", "c" }, rows = { { 1, 2, 3 } } })
  refused("has the columns a, b, c. Hint: columns", { data = { { y = "lid.fy", file = file } } })
  local headless = check.file "headless.csv"
  core.write_file(headless, "1,0\n2,0\n3,1\n")
  refused("begins with numbers", { data = { { y = "lid.fy", file = headless } } })
  refused("columns[2] must be 'a', 'b' or 'c'", { data = { { y = "lid.fy", file = file, columns = { "a", "d" } } } })
  refused("sigma must be 'a', 'b' or 'c'",
    { data = { { y = "lid.fy", file = file, columns = { "a", "b" }, sigma = "s" } } })
  local semicolons = check.file "semicolons.csv"
  core.write_file(semicolons, "a;b\n1;2\n")
  refused("columns are separated by commas", { data = { { y = "lid.fy", file = semicolons } } })
  refused("at the start, the run fails", { scene = function(q)
    local model, stages = pressed(q)
    return model, stages, { on_step = function() return "cut" end }
  end })
  refused("no 'nu'", { scene = function(q) return pressed { E = q.nu, eps = q.eps } end })
  check.fails(function() fit {}:data(2) end, "there is no set 2; the fit has 1 set of data")
end)
