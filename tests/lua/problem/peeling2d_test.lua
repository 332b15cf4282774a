-- peeling2d.lua as a user runs it, on a shorter strip: published degrees of freedom, the moment of steady
-- peeling against its closed forms, pinned oscillations, a coarse mesh that peels in snap-backs, the files it leaves.

require "check"
local measure = require "problems.peeling2d.measure"
local problem = require "problems.peeling2d.problem"
local steady = require "problems.peeling2d.steady"

local study, folder = check.study "problems/peeling2d"
local coarse, coarse_folder = check.study("problems/peeling2d", "length=60", "bonded=50", "mesh=m0", "orders=N2",
  "steps=400", "window=34,40", "iterations=10")

check.case("Tables 7.8 and B.2: degrees of freedom of the published strip", function()
  local rows, counted = sg.reference "peeling2d_table7_8_and_B2".rows, 0
  for _, row in ipairs(rows) do
    local order, mesh, printed = row[1], row[2], row[6]
    local _, strip = problem.scene(order, mesh, problem.length, problem.bonded)
    local dofs = strip:dofs().total
    if dofs ~= printed then error(("%s at %s: %d, printed %d"):format(order, mesh, dofs, printed)) end
    counted = counted + 1
  end
  check.equal(counted, 39)
end)

check.case("energy of a bent section: at small curvature the thin strip's; its derivative is the moment", function()
  local stiffness = problem.modulus * problem.height ^ 3 / 12 / (1 - problem.poisson ^ 2)
  local U, M = steady.bend(1e-4)
  check.within_share("moment", M, stiffness * 1e-4, 1e-6)
  check.within_share("energy", U, stiffness * 1e-8 / 2, 1e-6)
  local k, d = 0.0188, 1e-5
  local _, moment = steady.bend(k)
  check.within_share("dU/dk", (steady.bend(k + d) - steady.bend(k - d)) / (2 * d), moment, 1e-7)
  -- The thin strip's moment comes from M k = U + W with the thin strip's U.
  local curvature = steady.thin_moment() * problem.moment_unit / stiffness
  check.within_share("balance", stiffness * curvature ^ 2 / 2, steady.work_of_adhesion(), 1e-12)
end)

check.case("the plateau is the moment of the energy balance at finite strains, and not the thin strip's", function()
  local finite, thin = steady.finite_moment(), steady.thin_moment()
  for _, case in ipairs(study.cases) do
    check.within_share(case.order, case.window.mean, finite, 5e-4)
    assert(math.abs(case.window.mean / thin - 1) > 1e-3)
  end
end)

check.case("oscillations and slopes are unchanged; the layer's are a fraction", function()
  local pinned = { ["N2 m1"] = { 13.080e-3, 17.073e-3, -83.10e-3 },
                   ["N2-N2.1 m1"] = { 2.2036e-3, 1.8068e-3, -2.818e-3 } }
  for name, values in pairs(pinned) do
    local window = study.cases[name].window
    check.within_share(name .. " oscillation", window.oscillation, values[1], 2e-3)
    check.within_share(name .. " rise", window.rise, values[2], 2e-3)
    check.within_share(name .. " fall", window.fall, values[3], 2e-3)
    check.equal(study.cases[name].rotation.failed, false)
  end
end)

check.case("a coarse mesh stops at a turning point, and continues by arc length", function()
  local case = coarse.cases[1]
  check.equal({ case.rotation.failed, case.rotation.reason }, { true, "turning_point" })
  local stopped, turn = case.angle[case.rotation.rows], measure.reported_turn(case.rotation)
  assert(turn > stopped and turn < stopped + 0.1 + 1e-9, "the turning point lies within the step that failed")
  check.equal({ case.arc.failed, case.arc.controls[1].to, case.arc.controls[2].to }, { false, "arc length", "targets" })
  check.near(case.angle[#case.angle], 40, 1e-9)
  check.within_share("first turning point", case.snap_backs[1].from, turn, 1e-3)
  local widest = 0
  for _, back in ipairs(case.snap_backs) do
    assert(back.drop > 0)
    widest = math.max(widest, back.width)
  end
  assert(#case.snap_backs >= 5 and widest > 0.8 and widest < 1.2)
  check.within_share("plateau", case.window.mean, steady.finite_moment(), 0.01)
end)

check.case("measures of a path: whole steps only, snap-backs in order", function()
  local case = { step = { 1, 2, 2.6, 2.4, 2.1, 2.5, 3, 4 }, angle = { 1, 2, 2.6, 2.4, 2.1, 2.5, 3, 4 },
                 moment = { 0, 1, 1.5, 1, -1, -0.5, 0.2, 0.4 } }
  local window = measure.window(case, { 1, 4 })
  check.near({ window.oscillation, window.rise, window.fall, window.path_oscillation }, { 1, 1, -0.8, 2.5 }, 1e-14)
  -- ∫ M dθ: 0.5 + 0.75 − 0.25 + 0 − 0.3 − 0.075 + 0.3
  check.near(window.mean, (0.5 + 1.25 * 0.6 - 1.25 * 0.2 - 0 * 0.3 - 0.75 * 0.4 - 0.15 * 0.5 + 0.3) / 3, 1e-14)
  local backs = measure.snap_backs(case)
  check.equal({ #backs, backs[1].turn, backs[1].back }, { 1, 3, 5 })
  check.near({ backs[1].width, backs[1].drop }, { 0.5, 2.5 }, 1e-14)
  check.equal(measure.window(case, { 1, 5 }), {})
end)

check.case("files: curves as CSV, charts, states", function()
  local case = study.cases["N2-N2.1 m1"]
  local read = sg.csv.read(folder .. "/N2-N2.1_m1.csv")
  check.equal({ read:column "angle", read:column "moment" }, { case.angle, case.moment })
  check.pictures(folder, { "moment_m1", "plateau_standard_m1", "plateau_layer_m1", "states" })
  check.pictures(coarse_folder, { "snap_back_N2_m0" })
end)

check.case("wrong arguments", function()
  check.refused("problems/peeling2d", {
    ["msh=m1"] = "unknown argument 'msh=m1'; did you mean 'mesh'?", ["mesh=m9"] = "got 'm9'",
    ["control=force"] = "control must be 'rotation' or 'arc', got 'force'",
    ["window=140,120"] = "window must be two increasing angles", ["steps=0"] = "got '0'",
    ["bonded=200"] = "bonded must be a number of nm above 0 and below the strip's",
  })
end)
