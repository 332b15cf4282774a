-- speed_against_accuracy.lua as a user runs it, two problems on their two coarsest meshes: comparison at
-- equal error, the page, and that what is done is not done again. Nothing here depends on how long a case takes.

require "check"

local folder = check.folder()
local words = { "problems=ironing,hertz", "meshes=m1,m2", "orders=N2,N4,N2-N2.2", "rounds=1",
                "out=" .. folder .. "/out", "page=" .. folder .. "/doc" }
local function run(...) return (check.study("studies/speed_against_accuracy", ...)) end
local results = run(table.unpack(words)).results

local function row(problem, order, mesh) return results[problem].measured.cases:row{ order = order, mesh = mesh } end
local function read(name) return core.read_file(folder .. "/" .. name) end

check.case("errors: those that ironing2d.lua and hertz2d.lua print", function()
  for case, expected in pairs { ["N2 m1"] = { 7.506, 12.63 }, ["N4 m1"] = { 2.065, 6.774 },
                                ["N2-N2.2 m1"] = { 0.6508, 0.693 }, ["N2-N2.2 m2"] = { 0.2921, 0.1089 } } do
    local found = row("ironing", case:match "(%S+) (%S+)")
    check.near({ 1e3 * found.dPx / expected[1], 1e3 * found.dPy / expected[2] }, { 1, 1 }, 1e-3)
  end
  for case, expected in pairs { ["N2 m1"] = 0.204, ["N2 m2"] = 0.100, ["N4 m1"] = 0.246, ["N2-N2.2 m1"] = 0.094,
                                ["N2-N2.2 m2"] = 0.033 } do
    check.near(row("hertz", case:match "(%S+) (%S+)").error, expected, 6e-4)
  end
end)

check.case("on every mesh the error of N2-N2.2 is below those of N2 and N4", function()
  for problem, errors in pairs { ironing = { "dPx", "dPy" }, hertz = { "error" } } do
    for _, mesh in ipairs { "m1", "m2" } do
      for _, error in ipairs(errors) do
        local layer = row(problem, "N2-N2.2", mesh)[error]
        assert(layer < 0.6 * row(problem, "N2", mesh)[error] and layer < 0.6 * row(problem, "N4", mesh)[error])
      end
    end
  end
end)

check.case("the reference is solved, but is not a case of the chart", function()
  check.equal(#results.hertz.measured.study.cases, 7)
  check.equal(#results.hertz.measured.cases.rows, 6)
end)

check.case("ratios of all pairs: within the errors that both reach, or why there is none", function()
  for _, ratio in ipairs(results.hertz.comparisons.error.ratios) do
    local worst, best = math.huge, 0
    for _, order in ipairs { ratio.a, ratio.b } do
      local one, other = row("hertz", order, "m1").error, row("hertz", order, "m2").error
      worst, best = math.min(worst, math.max(one, other)), math.max(best, math.min(one, other))
    end
    assert(ratio.why or #ratio.ratio == 3 and ratio.from == best and ratio.to >= best and ratio.to <= worst)
  end
  check.equal(#results.hertz.comparisons.error.ratios, 3)
  -- N2 at m2 is worse than N2-N2.2 at m1: what N2-N2.2 would take for that is not known.
  for _, name in ipairs { "dPx", "dPy" } do
    for _, ratio in ipairs(results.ironing.comparisons[name].ratios) do
      if ratio.a == "N2" and ratio.b == "N2-N2.2" then assert(ratio.why and #ratio.ratio == 0) end
    end
  end
  check.holds(read "doc/speed_against_accuracy.md",
    "N2-N2.2 has a smaller oscillation of the drag")
end)

check.case("the fastest case with at most the error of N2 is at least as accurate and not slower", function()
  local ratios = require "studies.speed_against_accuracy.ratios"
  local list = ratios.least(results.ironing.measured.cases, "dPx", "wall")
  check.equal(#list, 2)
  for _, pair in ipairs(list) do
    assert(pair.best.dPx <= pair.plain.dPx and pair.best.wall <= pair.plain.wall)
  end
end)

check.case("the page: numbers from the results, tables, charts; written atomically", function()
  local page = read "doc/speed_against_accuracy.md"
  check.holds(page, "# Speed against accuracy", "## Ironing", "## Hertz", "Signorini " .. core.versions.signorini,
    core.processor, "| N2-N2.2 | m1 | 1114 | ", "| 2.04·10⁻¹ |", "Ratio of times, A to B, at equal ",
    "](speed_against_accuracy/ironing_dPx.png)", "](speed_against_accuracy/hertz_error.png)")
  for name in page:gmatch "%]%((speed_against_accuracy/[^)]+)%)" do
    check.equal(read("doc/" .. name):sub(2, 4), "PNG")
  end
  check.holds(read "out/ironing_dPx.svg", "<svg")
  for _, part in ipairs { "nil", "nan", "inf", "%." } do assert(not page:find("[ (]" .. part .. "[ ,)|]")) end
end)

check.case("files: cases and ratios", function()
  check.equal(#sg.csv.read(folder .. "/out/hertz.csv").rows, 6)
  check.equal(#sg.csv.read(folder .. "/out/hertz_error_ratios.csv").rows, 3)
end)

check.case("a second call runs no case again, and writes the same page", function()
  local before, record = read "doc/speed_against_accuracy.md", results.hertz.measured.study.records[1]
  results = run(table.unpack(words)).results
  check.equal(results.hertz.measured.study.records[1].wall, record.wall)
  check.equal(results.hertz.measured.study.records[1].made.time, record.made.time)
  check.equal(read "doc/speed_against_accuracy.md", before)
end)

check.case("an invalid order fails alone, and is named", function()
  -- Its table of ratios has no row.
  local less = check.load "studies/speed_against_accuracy"("problems=hertz", "meshes=m1", "orders=N2,X2", "rounds=1",
    "out=" .. folder .. "/out", "page=" .. folder .. "/doc").results
  assert(less.hertz.measured.cases:row{ order = "X2" }.failed)
  check.holds(read "doc/speed_against_accuracy.md", "Not in the chart: X2 at m1 (sg.body: order must be ")
end)

check.case("wrong arguments", function()
  check.refused("studies/speed_against_accuracy", {
    ["problems=ring"] = "problems must be values among 'ironing', 'hertz', 'rings', 'peeling' and 'ironing3d'",
    ["rounds=-1"] = "rounds must be a whole number, 0 or more, got '-1'",
    ["meshes=m1,m9"] = "meshes must be all, or meshes that one of the problems has, got 'm9' in 'm1,m9'",
    ["clock=cpu"] = "unknown argument 'clock=cpu'",
  })
end)
