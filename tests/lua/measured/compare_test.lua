-- scripts/formulations/compare.lua: Hertz's pressure by formulation, mesh and penalty, times at equal error, and what
-- the page takes from other scripts. Nothing here depends on how long a case takes.

require "check"

local words = { "problems=hertz", "parts=hold", "rounds=1", "out=" .. check.folder() .. "/out" }
local run = check.study("formulations/compare", table.unpack(words))
local hertz = run.results.hertz.cases

local function pressure(order, setting, mesh)
  return hertz:row{ order = order, setting = setting, mesh = mesh }.pressure
end

check.case("a hundredfold penalty hardly changes the pressure of averages, that of Gauss points it does", function()
  local function spoiled(way)
    return pressure("N2-N2.2", way .. "penalty × 100", "m3") / pressure("N2-N2.2", way .. "published penalty", "m3")
  end
  check.at_most("mortar", spoiled "mortar equal + ", 1.5)
  check.at_most("mortar next to points", pressure("N2", "mortar equal + penalty × 10", "m3"),
    0.6 * pressure("N2", "penalty × 10", "m3"))
end)

check.case("the error of the pressure falls with the mesh for all formulations", function()
  for _, setting in ipairs { "default", "mortar equal", "multipliers" } do
    check.at_most(setting, pressure("N2-N2.2", setting, "m3"), 0.3 * pressure("N2-N2.2", setting, "m1"))
  end
end)

check.case("tables: one row per formulation with ratios of times, the rows of a script, and its words", function()
  local of = {}
  for _, tabled in ipairs(run.tables) do of[tabled.name] = tabled end
  check.equal({ #of.hertz.rows, of.hertz.rows[1][2], #of.formulations.rows }, { 5, 1, 5 })
  for _, name in ipairs { "hertz", "formulations" } do
    for _, row in ipairs(of[name].rows) do check.equal(#row, #of[name].columns) end
  end
  check.equal({ of.formulations.rows[2][2], of.formulations.rows[4][2] }, { "0 / 0", "0 / 0" }) -- mortar does not creep
end)

check.case("a second call reuses finished cases and parts", function()
  local function times(results)
    local list = {}
    for i, result in ipairs(results) do list[i] = result.study.records[1].made.time end
    return list
  end
  check.equal(times(check.study("formulations/compare", table.unpack(words)).results), times(run.results))
end)

check.case("wrong arguments", function()
  check.refused("formulations/compare", { ["problems=rings"] = "problems must be", ["parts=cost"] = "parts must be",
                                          ["rounds=0"] = "rounds must be" })
end)
