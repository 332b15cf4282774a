-- tests/measure/parallel_study.lua, coarse: executed in parallel, and killed three times, the study has the same table.

require "check"

check.case("parallel execution changes no result, and no finished case is repeated after kills", function()
  local result, folder = check.study("tests/measure/parallel_study", "mesh=m1", "orders=N2,N2-N2.2", "steps=20",
    "rounds=1")
  check.equal({ #result.study, result.same, result.repeated }, { 6, true, 0 })
  check.equal(result.counts[1] <= result.counts[2] and result.counts[2] <= result.counts[3], true)
  for _, row in ipairs(result.study.rows) do
    check.equal({ row.failed, row.press < 0 }, { nil, true })
  end
  check.holds(core.read_file(folder .. "/cases.csv"), "# study: ironing", "N2-N2.2")
end)
