-- scripts/problems/rings2d.lua as a user runs it: the published errors, friction's law, the files it leaves.

require "check"

local study, folder = check.study("problems/rings2d", "repeats=1")

local printed = {}
for _, row in ipairs(sg.reference "rings2d_error_table7_5".rows) do
  printed[row[1] .. " " .. row[2]] = { pN = row[3], pT = row[4] }
end

check.case("Table 7.5 at m1: both tractions within 10 %", function()
  for _, order in ipairs { "N2", "N4", "N2-N4", "N2-N2.1" } do
    local case, row = study.cases[order .. " m1"], printed[order .. " m1"]
    check.within_share(order .. " p_N", case.pN_error, row.pN, 0.1)
    check.within_share(order .. " p_T", case.pT_error, row.pT, 0.1)
  end
end)

check.case("Table 7.5 at m2: within 15 %, except N2-N2.1, which depends on the rule of the integral", function()
  for _, order in ipairs { "N2", "N4", "N2-N4" } do
    local case, row = study.cases[order .. " m2"], printed[order .. " m2"]
    check.within_share(order .. " p_N", case.pN_error, row.pN, 0.15)
    check.within_share(order .. " p_T", case.pT_error, row.pT, 0.15)
  end
  -- On the points of the reference, with the edge where the gap is zero, it is the printed one.
  local case = study.cases["N2-N2.1 m2"]
  check.within_share("N2-N2.1 on its own points", case.errors[1], 1.08e-2, 0.02)
  check.within_share("N2-N2.1 on the reference's points", case.errors[5], printed["N2-N2.1 m2"].pN, 0.1)
end)

check.case("the orders rank as published", function()
  for _, order in ipairs { { "N2 m1", "N4 m1", "N2-N4 m1", "N2-N2.1 m1" },
                           { "N2 m2", "N2-N4 m2", "N4 m2", "N2-N2.1 m2" } } do
    for i = 2, #order do
      local more, less = study.cases[order[i - 1]].pN_error, study.cases[order[i]].pN_error
      if not (more > less and printed[order[i - 1]].pN > printed[order[i]].pN) then
        error(("%s: %g, %s: %g"):format(order[i - 1], more, order[i], less))
      end
    end
  end
end)

check.case("slipping points carry p_T = mu p_N, and only points at the apex stick", function()
  for _, case in ipairs(study.cases) do
    if case.coulomb.sticking > 3 or case.coulomb.deviation > 3e-3 then
      error(("%s %s: %d points stick, p_T differs by %g"):format(case.order, case.mesh, case.coulomb.sticking,
        case.coulomb.deviation))
    end
    for i, state in ipairs(case.profile.state) do
      if state == "stick" and case.profile.x[i] > 0.05 then error(case.order .. " sticks at " .. case.profile.x[i]) end
    end
  end
end)

check.case("no penetrating point is left out, at the apex or elsewhere", function()
  for _, case in ipairs(study.cases) do
    for i, gap in ipairs(case.profile.gap) do check.equal(case.profile.state[i] ~= "open", gap < 0) end
  end
end)

check.case("every run is complete, in at most 4 plain Newton iterations a step", function()
  for _, case in ipairs(study.cases) do
    check.equal(case.run.steps, 40)
    if case.run.iterations > 4 * 40 then error(case.order .. " took " .. case.run.iterations .. " iterations") end
  end
end)

check.case("a state's picture, charts, a profile per run and the errors", function()
  check.pictures(folder, { "states", "pressure_m1", "pressure_m2", "traction_m1", "traction_m2" })
  check.equal(sg.csv.read(folder .. "/N2-N4_m2.csv"):column "pressure", study.cases["N2-N4 m2"].profile.pressure)
  check.equal(#sg.csv.read(folder .. "/errors.csv").rows, 8 * 9)
  check.equal(#study.files, 1 + 8 + 1 + 1 + 4)
end)

check.case("wrong arguments", function()
  check.refused("problems/rings2d", {
    ["mesh=m1"] = "unknown argument 'mesh=m1'; did you mean 'meshes'? known: coordinate=x",
    ["meshes=m9"] = "got 'm9'",
    ["coordinate=z"] = "coordinate must be 'x' or 'X', got 'z'",
    ["repeats=0"] = "repeats must be", ["orders=Q7"] = "Q7" })
end)
