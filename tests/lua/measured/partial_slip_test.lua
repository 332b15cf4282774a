-- scripts/formulations/partial_slip.lua and elastic_slip.lua, coarse: stick zone and traction against Cattaneo and
-- Mindlin's solution, slip of the sticking points, convergence to Coulomb's law.

require "check"
local problem = require "formulations.partial_slip.problem"

local study, folder = check.study("formulations/partial_slip", "orders=N2-N2.2", "counts=4,8",
  "formulations=gpts,equal,reduced,half-passes")
local multipliers = check.study("formulations/partial_slip", "orders=N2-N2.2", "counts=4",
  "formulations=equal-multipliers,reduced-multipliers")

local function each_state(body)
  for _, case in ipairs(study.cases) do
    check.equal(#case.states, 3)
    for i, state in ipairs(case.states) do
      body(("%s, %d elements, load %d"):format(case.formulation.label, case.count, i), state, case)
    end
  end
end

check.case("the closed form: the traction's integral is Q", function()
  for _, ratio in ipairs { 0.3, 0.7, 0.95 } do
    local c, traction = problem.mindlin(ratio)
    local sum, count = 0, 200000
    for i = 1, count do sum = sum + traction(2 * (i - 0.5) / count - 1) * 2 / count end
    -- Q = mu p0 a ∫ q ds, P = pi p0 a/2.
    check.within("Q", sum / (math.pi / 2), ratio, 1e-6)
    check.within("c", c, math.sqrt(1 - ratio), 1e-15)
  end
end)

check.case("loads of 0.3, 0.7 and 0.95 of mu P; the stick zone is right within the length of an element", function()
  each_state(function(name, state, case)
    check.within(name, state.c, state.expected, 1 / case.count)
  end)
  for _, case in ipairs(study.cases) do
    for i, ratio in ipairs { 0.3, 0.7, 0.95 } do check.within("ratio", case.states[i].ratio, ratio, 0.01) end
  end
end)

check.case("the L2 error of the traction falls with the mesh, with a rate of about 1", function()
  for _, name in ipairs { "gpts", "equal", "reduced" } do
    local coarse, fine = study.cases["N2-N2.2 4 " .. name], study.cases["N2-N2.2 8 " .. name]
    local before, after = 0, 0
    for i = 1, 3 do before, after = before + coarse.states[i].error, after + fine.states[i].error end
    check.at_most(name, after / before, 0.75)
    for i = 1, 3 do check.at_most(name, fine.states[i].error, 0.06) end -- of mu p0
  end
end)

check.case("sticking points slip by the traction over the tangential penalty, with multipliers they do not", function()
  each_state(function(name, state, case)
    local sum, count = 0, 0
    for i, s in ipairs(state.s) do
      if math.abs(s) < 0.8 * state.expected then sum, count = sum + state.traction[i], count + 1 end
    end
    local a = 0.00984 -- half-width, to 0.2 %
    local p0 = problem.young * a / (2 * problem.radius * (1 - problem.poisson ^ 2))
    local penalty = 10 * problem.young * case.count / problem.half_width
    -- Multipliers hold on average over their supports, so the zone must contain a few elements.
    local wide = state.expected * case.count > 2
    check.within_share(name, state.mean_slip * a, sum / count * problem.mu * p0 / penalty, wide and 0.05 or 0.15)
  end)
  -- Multipliers hold the averages over their supports, which is nearly the mean of a zone of a few elements.
  for i = 1, 2 do
    for _, case in ipairs(multipliers.cases) do
      check.at_most(case.formulation.label, case.states[i].mean_slip,
        0.01 * study.cases["N2-N2.2 4 reduced"].states[i].mean_slip)
      check.within("c", case.states[i].c, case.states[i].expected, 1 / 4)
    end
  end
end)

check.case("with stiffer tangential springs slip and the error of the force fall as 1/penalty", function()
  local springs, place = check.study("formulations/elastic_slip", "count=4", "penalties=0.1,1,10,100",
    "formulations=equal", "steps=5")
  local list = springs.cases.equal
  for i = 1, 3 do check.within_share("slip", list[i].mean_slip / list[i + 1].mean_slip, 10, 0.25) end
  for i = 1, 2 do
    check.within_share("rate of Q", math.log(list[i].force_error / list[i + 1].force_error, 10), 1, 0.15)
  end
  for _, state in ipairs(list) do check.equal(state.held, 0) end -- nothing creeps
  check.within("stick zone", list[4].c, list.limit.c, 1 / 4)
  check.pictures(place, { "elastic_slip" })
  check.refused("formulations/elastic_slip", { ["penalties=0"] = "penalties must be",
                                               ["formulations=gpts"] = "formulations must be" })
end)

check.case("files and wrong arguments", function()
  check.pictures(folder, { "N2-N2.2_traction", "N2-N2.2_error" })
  check.refused("formulations/partial_slip", { ["counts=1"] = "counts must be", ["penalty=0"] = "penalty must be" })
end)
