-- scripts/problems/ironing2d.lua variant=deep, two discretizations: effect of halving on failed steps and on others.

require "check"

local study, folder = check.study("problems/ironing2d", "variant=deep", "orders=N4,N2-N2.2", "points=1,3",
  "coarser=1,2")

--- The comparison of an order with some points at some step length.
local function comparison(order, multiple, coarser)
  for _, c in ipairs(study.comparisons) do
    if c.order == order and c.multiple == multiple and c.coarser == coarser then return c end
  end
end

check.case("with 3(p + 1) points and the published steps both converge without cutting any step", function()
  for _, order in ipairs { "N4", "N2-N2.2" } do
    local c = comparison(order, 3, 1)
    check.equal({ c.plain.run.failed, c.plain.run.steps, c.halving.run.cutbacks }, { false, 296, 0 })
  end
end)

check.case("with halving all converge; runs without failures are unchanged", function()
  local cured = 0
  check.equal(#study.comparisons, 8)
  for _, c in ipairs(study.comparisons) do
    local plain, halving = c.plain.run, c.halving.run
    check.equal({ halving.failed, halving.steps }, { false, c.coarser == 1 and 296 or 148 })
    check.equal(plain.failed, halving.cutbacks > 0)
    if plain.failed then
      cured = cured + 1
      check.equal(halving:attempts(plain.steps + 1)[1].converged, false)
    else
      check.equal(halving:column "grip.fy", plain:column "grip.fy")
      check.equal(halving.iterations, plain.iterations)
    end
  end
  if cured == 0 then error "no run failed, so that halving had nothing to do" end
end)

check.case("a run with halved steps ends in the state of one with twice as many steps", function()
  for _, order in ipairs { "N4", "N2-N2.2" } do
    local long, short = comparison(order, 1, 2).halving.run, comparison(order, 1, 1).halving.run
    local a, b = long:column "grip.fy", short:column "grip.fy"
    check.near(a[23] / b[46], 1, 5e-3) -- end of the pressing
    check.near(a[148] / b[296], 1, 5e-3)
  end
end)

check.case("oscillations, a sheet and a chart of the runs with most points", function()
  local cases = study.studies.m1.cases
  check.near(cases.N4.dPy.raw, 1.785e-2, 2e-5)
  check.near(cases["N2-N2.2"].dPx.raw, 5.37e-3, 2e-5)
  for _, name in ipairs { "states_m1.png", "forces_m1.png", "N4_m1.csv", "N2-N2.2_m1.csv" } do
    assert(io.open(folder .. "/" .. name)):close()
  end
end)
