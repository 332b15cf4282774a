-- local_layers.lua, coarse: peak pressures of Hertz, accuracy of the full layer with fewer degrees of freedom.

require "check"

local study, folder = check.study("studies/local_layers", "meshes=m1,m2", "solid=m1", "reference=m4", "repeats=1",
  "steps=2")

local function case(problem, name, mesh) return study.cases[("%s %s %s"):format(problem, name, mesh)] end

check.case("peak pressures of the references within 1.5 % of Hertz's", function()
  for _, problem in ipairs { "line", "sphere" } do
    local found = study.references[problem]
    check.near(math.max(table.unpack(found.profile.pressure)) / found.p0, 1, 0.015)
  end
end)

check.case("the local layer has the error of the full one, and a part of its degrees of freedom", function()
  for _, problem in ipairs { "line", "sphere", "solid" } do
    for _, mesh in ipairs(problem == "solid" and { "m1" } or { "m1", "m2" }) do
      local bulk, full = case(problem, "N2", mesh), case(problem, "N2-N2.2", mesh)
      local part = case(problem, "N2-N2.2, local", mesh)
      check.near(part.error / full.error, 1, 0.03)
      assert(part.dofs.total - bulk.dofs.total < 0.55 * (full.dofs.total - bulk.dofs.total))
      assert(part.error < 0.55 * bulk.error)
    end
  end
end)

check.case("knots at the edge of contact alone halve the error of the sphere", function()
  for _, problem in ipairs { "sphere", "solid" } do
    local bulk, knots = case(problem, "N2", "m1"), case(problem, "N2, knots", "m1")
    assert(knots.error < 0.5 * bulk.error and knots.dofs.total < 1.02 * bulk.dofs.total)
  end
end)

check.case("the solid has the errors of the axisymmetric sphere", function()
  for _, name in ipairs { "N2", "N2-N2.2, local", "N2-N2.2, edge, knots" } do
    check.near(case("solid", name, "m1").error / case("sphere", name, "m1").error, 1, 1e-3)
  end
end)

check.case("charts; wrong arguments", function()
  check.pictures(folder, { "line_dofs", "line_time", "sphere_dofs", "sphere_time", "solid_dofs", "solid_time" })
  check.refused("studies/local_layers", {
    ["problems=ring"] = "got 'ring'", ["meshes=m9"] = "got 'm9'", ["knots=0"] = "knots must be",
    ["steps=0"] = "steps must be" })
end)
