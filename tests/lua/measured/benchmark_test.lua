-- tests/measure/benchmark.lua, coarse: sums of its parts, exponents of growth, files.

require "check"

check.load "tests/measure/benchmark"
local growth = require "benchmark.growth"

local folder = check.folder()
local function benchmark(...) return (check.study("tests/measure/benchmark", "out=" .. folder, ...)) end

check.case("exponents of known costs", function()
  local sizes, square, bent = { 10, 20, 40, 80, 160 }, {}, {}
  for i, size in ipairs(sizes) do square[i], bent[i] = 3 * size ^ 2, i <= 2 and 1000 or 0.5 * size ^ 1.5 end
  check.near(growth.exponent(sizes, square), 2, 1e-12)
  check.near(growth.exponent(sizes, bent), 1.5, 1e-12) -- the smaller half does not count
  -- log2 of cost 0, 1, 1 over log2 of size 0, 1, 2: least squares give 1/2
  check.near(growth.exponent({ 1, 1, 1, 2, 4 }, { 9, 9, 1, 2, 2 }), 0.5, 1e-12)
  check.equal(growth.exponent({ 10 }, { 1 }), nil)
  check.equal(growth.exponent({ 10, 20, 40 }, { 1, 1, 0 }), nil)
end)

check.case("components in 2D and 3D", function()
  core.write_file(folder .. "/benchmark.md", "before\n<!-- measured -->\nold\n<!-- end of measured -->\nafter\n"
    .. "<!-- solvers -->\nold\n<!-- end of solvers -->\n")
  local result = benchmark("solvers=ironing-m1,hertz-m1", "plane=m1,m2,m4", "solid=sparse", "steps=1", "repeats=1",
    "linear=umfpack", -- factorizes every tangent
    "element=2", "page=" .. folder)
  check.equal(#result.cases, 4)
  check.equal({ #result.solvers.rows, result.solvers.rows[1][3], result.solvers.rows[2][3] }, { 2, "klu", "condensed" })
  for _, case in ipairs(result.cases) do
    -- Parts of the whole, none of them idle; search lies in contact, factorization and solution make up linear.
    for _, part in ipairs { "bulk", "contact", "search", "factorization", "solution", "picture", "csv",
                            "checkpoint" } do
      check.equal({ part, case[part] > 0 }, { part, true })
    end
    check.equal(case.bulk + case.contact + case.linear <= case.iteration, true)
    check.near(case.bulk + case.contact + case.linear + case.rest, case.iteration, 1e-9 * case.iteration)
    check.equal(case.search < case.contact, true)
    local both = case.factorization + case.solution
    check.equal(both <= case.linear and both > 0, true)
    check.near(case.around, case.iteration / case.linear - 1, 1e-9 * case.iteration / case.linear)
  end
  check.equal({ result.cases[1].dofs, result.cases[4].problem }, { 134, "solid" })
  for _, account in ipairs { "bulk", "factorization" } do -- of a clock, which may say anything of small meshes
    check.equal({ account, math.type(result.exponents.plane[account]) }, { account, "float" })
  end
  check.equal(result.exponents.solid.bulk, nil) -- one mesh
  check.equal(result.element > 0, true)

  local sheet = sg.csv.read(folder .. "/benchmark.csv")
  check.equal(#sheet.rows, 4)
  check.equal({ sheet.columns[1], sheet.columns[2], sheet.columns[3] }, { "problem", "mesh", "DOFs" })
  check.equal(core.exists(folder .. "/growth.csv"), true)
  check.equal(core.exists(folder .. "/benchmark_2d.png"), true)
  check.equal(core.exists(folder .. "/benchmark_3d.png"), false) -- one mesh makes no line
  check.equal(core.exists(folder .. "/state.sgn"), false)
  local page = core.read_file(folder .. "/benchmark.md")
  check.holds(page, "before\n<!-- measured -->\n| problem |", "| 2D ironing | m4 |",
    "<!-- end of measured -->\nafter\n<!-- solvers -->\n| model |", "| hertz-m1 | 980 | condensed |")
  check.equal(page:find("old", 1, true), nil)
end)

check.case("results that were not requested stay empty", function()
  local model, bodies, press = require "benchmark.measure".problems.plane.begin("N2", "m1", 1)
  model:run{ press }
  check.equal({ model:timings().search, model:timings().contact > 0 }, { 0, true })
  check.fails(function() model:time_search(1) end, "wanted")
end)

check.case("wrong arguments", function()
  check.fails(function() benchmark("plane=m2,m1", "solid=none", "solvers=none") end,
    "meshes must be in increasing order")
  check.fails(function() benchmark("plane=m9") end, "plane must be")
end)
