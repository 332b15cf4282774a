-- scripts/problems/shallow_ironing2d.lua on the coarsest mesh.

require "check"

local study, folder = check.study "problems/shallow_ironing2d"
local press_end, middle = 50, 50 + 125

check.case("degrees of freedom; the nose is a circle of radius 0.75", function()
  check.equal(study.cases.N2.dofs, 2 * 5 * 3 + 2 * 32 * 9)
  local profile = study.cases.N2.model:profile "interface"
  for i, x in ipairs(profile.X) do check.near((x - 0.8) ^ 2 + (profile.Y[i] - 4.95) ^ 2, 0.75 ^ 2, 1e-13) end
end)

check.case("both discretizations complete with steps of 0.04 mm; those of 0.08 mm fail and are halved", function()
  for _, case in ipairs(study.cases) do
    check.equal({ case.run.failed, case.run.steps, case.run.cutbacks <= 3 }, { false, 300, true }) -- none or one
  end
  local long = check.study("problems/shallow_ironing2d", "mesh=m1", "steps=25", "orders=N2").cases.N2
  check.equal({ long.run.failed, long.run.steps, long.run.cutbacks > 15 }, { false, 150, true }) -- 28
  check.near(long.V[press_end // 2] / study.cases.N2.V[press_end], 1, 1e-4)
  check.near(long.V[150] / study.cases.N2.V[300], 1, 5e-3)
end)

check.case("forces on this mesh, and their balance", function()
  local N2, layer = study.cases.N2, study.cases["N2-N2.2"]
  check.near({ N2.V[press_end], N2.H[press_end] }, { 320.1, 69.2 }, 0.1)
  check.near({ layer.V[press_end], layer.H[press_end] }, { 319.0, 69.8 }, 0.1)
  check.near({ layer.V[middle], layer.H[middle] }, { 407.4, 136.7 }, 0.1)
  for _, axis in ipairs { ".fx", ".fy" } do
    local bed, grip = N2.run:column("bed" .. axis), N2.run:column("grip" .. axis)
    for step = 1, N2.run.steps do check.near(bed[step] + grip[step], 0, 1e-6) end
  end
end)

check.case("the vertical force lies among the published curves, while it slides the ratio of the forces too", function()
  local published = sg.reference "shallow_ironing2d_forces"
  local layer = study.cases["N2-N2.2"]
  local function row(time)
    for i, value in ipairs(published:column "time") do
      if value == time then return published.rows[i] end
    end
  end
  for step, time in pairs { [press_end] = 1, [middle] = 1.5 } do
    local V, ratios = {}, {}
    for i, value in ipairs(row(time)) do
      if i % 2 == 0 then V[#V + 1], ratios[#ratios + 1] = value, row(time)[i + 1] / value end
    end
    local function among(value, others)
      return value > math.min(table.unpack(others)) and value < math.max(table.unpack(others))
    end
    check.equal(#V, 5)
    check.equal({ among(layer.V[step], V), time == 1 or among(layer.H[step] / layer.V[step], ratios) }, { true, true })
  end
end)

check.case("the layer removes most of the oscillation", function()
  local N2, layer = study.cases.N2.oscillation, study.cases["N2-N2.2"].oscillation
  check.near({ N2.V, N2.H }, { 4.40, 16.40 }, 0.05)
  if N2.V < 2 * layer.V or N2.H < 6 * layer.H then
    error(("oscillations of N2 %g, %g and of the layer %g, %g"):format(N2.V, N2.H, layer.V, layer.H))
  end
end)

check.case("a sheet, a chart and two files", function()
  for _, name in ipairs { "states.png", "forces.png", "N2.csv", "N2-N2.2.csv" } do
    assert(io.open(folder .. "/" .. name)):close()
  end
  check.equal(#study.files, 4)
end)

check.case("wrong arguments", function()
  check.refused("problems/shallow_ironing2d", {
    ["msh=m1"] = "unknown argument 'msh=m1'; did you mean 'mesh'?", ["mesh=m9"] = "got 'm9'",
    ["penalty=-1"] = "penalty must be a positive number, got '-1'",
    ["thickness_degree=two"] = "thickness_degree must be a whole number",
    ["steps=0"] = "steps must be a whole number" })
end)
