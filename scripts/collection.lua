-- Benchmarks of contact with references: published values, closed forms, and comparisons, with each formulation.
--
-- Problem: the files of collection/, one per benchmark, each with its set-up, materials, loads, source and reference as
--          plain data. Each variant is solved with Gauss points, mortar contact with a penalty, and mortar contact with
--          multipliers, as far as the benchmark lists them, and each result has an error bar.
-- Source: named in each file.
-- Units: named in each file.
-- Expected: all results but those of comparisons within tolerance and uncertainty of their references.
-- Run: signorini collection.lua [benchmarks=B1,…,B13] [formulations=gpts,equal,equal-multipliers] [mesh=1]
--      [errors=yes] [out=out/collection] [page=none]; mesh: factor of all numbers of elements; errors: error bars;
--      page: folder of collection.md, whose table is filled, and of its file collection.json

local sg = require "signorini"
local page_table = require "collection.page_table"
local rows = require "formulations.rows"
local solve = require "collection.solve"

local files_of = {
  B1 = "b1_roller", B2 = "b2_punch", B3 = "b3_pin", B4 = "b4_plate", B5 = "b5_half_ring", B6 = "b6_press_fit",
  B7 = "b7_rolling", B8 = "b8_pull_off", B9 = "b9_receding", B10 = "b10_incline", B11 = "b11_layer", B12 = "b12_wavy",
  B13 = "b13_column",
}
local names = {}
for i = 1, 13 do
  if files_of["B" .. i] then names[#names + 1] = "B" .. i end
end

local options = sg.arguments{
  benchmarks = { names, choices = names }, formulations = rows.argument{ "gpts", "equal", "equal-multipliers" },
  mesh = { 1.0, above = 0 }, errors = true, out = "out/collection", page = "none",
}
if options.page ~= "none" and not (#options.benchmarks == #names and #options.formulations == 3 and options.errors) then
  error("page: its table has all benchmarks with all formulations and error bars; leave these arguments out", 0)
end
local files, tables = sg.files(options.out), require "page.tables"

-- ── Cases ────────────────────────────────────────────────────────────────────────────────────────────────────────────

local benchmarks, cases = {}, {}
for _, name in ipairs(options.benchmarks) do
  local benchmark = require("collection." .. files_of[name])
  benchmarks[name] = benchmark
  for _, variant in ipairs(benchmark.variants) do
    for _, formulation in ipairs(variant.formulations or benchmark.formulations) do
      for _, wanted in ipairs(options.formulations) do
        if wanted == formulation then
          cases[#cases + 1] = { benchmark = name, variant = variant.name, formulation = formulation }
        end
      end
    end
  end
end

local function variant_of(case)
  for _, variant in ipairs(benchmarks[case.benchmark].variants) do
    if variant.name == case.variant then return variant end
  end
end

local mesh, errors = options.mesh, options.errors -- alone, so that other options do not make cases new
local solved = sg.study{
  name = "cases", folder = options.out .. "/cases", cases = cases,
  run = function(case)
    return solve.case(benchmarks[case.benchmark], variant_of(case), case.formulation, mesh, errors)
  end,
}:execute{}

-- ── One row per quantity ─────────────────────────────────────────────────────────────────────────────────────────────

local long, found, failed = {}, {}, 0
for i, case in ipairs(cases) do
  local row = solved.rows[i]
  if row.failed then failed = failed + 1 end
  for k, expected in ipairs(variant_of(case).expected) do
    local value, key = row["value" .. k], #long + 1
    local result = { reference = expected.value, uncertainty = expected.uncertainty or 0, kind = expected.kind,
                     unknowns = row.unknowns, iterations = row.iterations, time = row.wall }
    if value then
      local deviation, within = solve.judge(expected, value)
      result.value, result.bar, result.deviation = value, row["bar" .. k], 100 * deviation / math.abs(expected.value)
      result.within = within == nil and "–" or within and "yes" or "no"
    else
      result.within = "failed"
    end
    long[key] = { benchmark = case.benchmark, variant = case.variant, formulation = case.formulation,
                  quantity = expected.name }
    found[key] = result
  end
end

local function row_of(case)
  for key, one in ipairs(long) do
    if one.benchmark == case.benchmark and one.variant == case.variant and one.formulation == case.formulation
      and one.quantity == case.quantity then return found[key] end
  end
end

local table_rows, entries = {}, {}
for key, case in ipairs(long) do
  local one = found[key]
  table_rows[key] = { case.benchmark, case.variant, case.formulation, case.quantity, one.reference, one.uncertainty,
                      one.value, one.bar, one.deviation, one.within, one.kind, one.unknowns, one.iterations, one.time }
  entries[key] = {}
  for _, part in ipairs { case, one } do
    for name, value in pairs(part) do entries[key][name] = value end
  end
end
local columns = { "benchmark", "variant", "formulation", "quantity", "reference", "±", "value", "bar", "deviation",
                  "within", "kind", "unknowns", "iterations", "time" }
print(sg.table{ columns = columns, rows = table_rows,
                units = { "", "", "", "", "", "", "", "±", "%", "tolerance", "", "", "", "s" },
                formats = { reference = "%.6g", ["±"] = "%.2g", value = "%.6g", bar = "%.2g", deviation = "%+.3f",
                            time = "%.1f" } })

-- ── Files ────────────────────────────────────────────────────────────────────────────────────────────────────────────

local data = { script = "scripts/collection.lua", made = tables.made{ { study = solved } }, mesh = options.mesh,
               tables = { page_table.of(entries, benchmarks) }, results = entries }
sg.csv.write(files "collection.csv", { columns = columns, rows = table_rows })
sg.json.write(files "collection.json", data)
if options.page ~= "none" then tables.write(options.page .. "/collection", data) end

local text = {}
for _, name in ipairs(options.benchmarks) do
  local one = benchmarks[name]
  text[#text + 1] = ("%s, %s. Source: %s. Units: %s."):format(name, one.title, one.source, one.units)
end
local page = sg.study{ name = "collection", folder = options.out .. "/page", cases = long,
                       units = { deviation = "%", time = "s" }, run = row_of }:execute{}
page:report{ file = files "collection.html", title = "Benchmarks of contact", text = table.concat(text, "\n\n"),
             charts = { { x = "benchmark", y = function(row) return row.value and math.abs(row.deviation) end,
                          series = "formulation", line = false, log = "y", yrange = { 1e-3, 1e3 },
                          ylabel = "deviation (%)", title = "Deviation from the reference" } } }
files:report()

return { rows = entries, failed = failed }
