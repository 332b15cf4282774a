-- scripts/formulations/hertz_pressure.lua, coarse: error over mesh and penalty of mortar and Gauss points, forces over
-- penalties.

require "check"

local study, folder = check.study("formulations/hertz_pressure", "meshes=m1,m2,m3", "reference=m4", "drift=m2",
  "formulations=gpts,equal,equal-multipliers,reduced,reduced-multipliers", "penalties=500,1e4,1e5,1e6,5e6")

local function case(problem, order, mesh, formulation, penalty)
  return study.cases[table.concat({ problem, order, mesh, formulation, penalty }, " ")]
end

check.case("mortar: the error falls with the mesh at a penalty that is not tuned", function()
  for _, problem in ipairs { "line", "sphere" } do
    local function error(formulation, mesh) return case(problem, "N2-N2.2", mesh, formulation, 1e5).l2 end
    for _, name in ipairs { "equal", "reduced" } do
      -- Two halvings of the elements; the pressure is as smooth as an ellipse inside 0.8 a.
      check.at_most(problem .. " " .. name, error(name, "m3") / error(name, "m1"), 0.12)
    end
  end
end)

check.case("line contact, N2-N2.2 at m3: no worse than the best-tuned Gauss points, at any high penalty", function()
  for _, name in ipairs { "equal", "reduced" } do
    local high = case("line", "N2-N2.2", "m3", name, 1e6)
    check.at_most(name, high.l2, 1.1 * study.best["line N2-N2.2 m3 gpts"].l2)
    check.within_share(name .. ": penalty", case("line", "N2-N2.2", "m3", name, 1e5).l2, high.l2, 0.35)
    -- The weighted penetration is z/penalty, z about Hertz's peak pressure.
    check.within_share(name .. ": penetration", high.penetration * 1e6, study.references.line.p0, 0.03)
  end
  local function n2(name, penalty) return case("line", "N2", "m3", name, penalty).l2 end
  check.equal({ n2("gpts", 1e5) > 3 * n2("gpts", 500.0), n2("gpts", 1e5) > 2 * n2("equal", 1e5) }, { true, true })
end)

check.case("the reference agrees with Hertz's solution up to the finite size", function()
  for _, problem in ipairs { "line", "sphere" } do
    local reference = study.references[problem]
    check.within(problem, reference.pressure(0), 1, 0.025) -- 1.2 % and 1.9 % with infinite penalty: hertz.md
  end
end)

check.case("multipliers: no parameter, and hardly more than the error of high penalties", function()
  for _, problem in ipairs { "line", "sphere" } do
    for _, name in ipairs { "equal", "reduced" } do
      for _, mesh in ipairs { "m1", "m2", "m3" } do
        local one, limit = case(problem, "N2-N2.2", mesh, name .. "-multipliers", "none"),
          case(problem, "N2-N2.2", mesh, name, 5e6)
        local what = ("%s %s %s"):format(problem, mesh, name)
        check.at_most(what .. ": error", one.l2, 1.15 * limit.l2)
      end
    end
  end
end)

check.case("forces under a given displacement: hardly an effect of c over four decades, 1/penalty otherwise", function()
  for _, row in ipairs(study.drift) do
    local what = row[1] .. " " .. row[2]
    if row[2]:find "multipliers" then
      for i = 3, 7 do check.at_most(what, row[i], 2e-3) end
    elseif row[2]:find "mortar" then
      check.at_most(what, row[5], 0.2 * row[4])
      check.at_most(what, row[5], 1e-4)
    end
  end
end)

check.case("files and wrong arguments", function()
  check.pictures(folder, { "line_N2_mesh", "line_N2_penalty", "sphere_N2-N2.2_mesh", "sphere_N2-N2.2_penalty" })
  check.refused("formulations/hertz_pressure", { ["formulations=half-passes"] = "formulations must be values among",
                          ["penalties=0"] = "penalties must be" })
end)
