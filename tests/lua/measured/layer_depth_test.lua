-- layer_depth.lua as a user runs it, peeling and Hertz on coarser meshes: effect of a second row of the layer,
-- and no effect of more.

require "check"

local study, folder = check.study("studies/layer_depth", "rows=1,2,all", "layers=N2.2,N4", "repeat=1",
  "peeling=mesh=m0;length=60;bonded=50;steps=400;window=34,40", "hertz=meshes=m1;sizes=1;reference=m3",
  "rings=meshes=m1;reference=m3")

--- An error of an order, relative to that of another one.
local function ratio(problem, order, other, figure)
  local found = {}
  for _, case in ipairs(study.studies[problem]) do found[case.order] = case.errors[figure or 1] end
  return found[order] / found[other]
end

check.case("every problem runs each depth of each layer", function()
  for _, name in ipairs { "peeling", "ironing", "hertz", "rings" } do
    local orders, dofs = {}, {}
    for i, case in ipairs(study.studies[name]) do
      orders[i], dofs[case.order] = case.order, case.dofs
      assert(case.wall > 0 and case.errors[1] > 0)
    end
    check.equal(orders, { "N2", "N2-N2.2", "N2-N2.2x2", "N2.2", "N2-N4", "N2-N4x2", "N4" })
    -- A second row adds what the first one does; all rows at least as much again.
    check.equal(dofs["N2-N2.2x2"] - dofs["N2-N2.2"], dofs["N2-N2.2"] - dofs.N2)
    assert(dofs["N2.2"] > dofs["N2-N2.2x2"])
  end
end)

check.case("N2.2 two rows deep: two thirds less in peeling and rings, half in Hertz, nothing in ironing", function()
  check.near(ratio("peeling", "N2-N2.2x2", "N2-N2.2"), 0.367, 0.005)
  check.near(ratio("rings", "N2-N2.2x2", "N2-N2.2"), 0.287, 0.02)
  check.near(ratio("hertz", "N2-N2.2x2", "N2-N2.2"), 0.534, 0.005)
  check.near(ratio("ironing", "N2-N2.2x2", "N2-N2.2", 1), 1.074, 0.005)
  check.near(ratio("ironing", "N2-N2.2x2", "N2-N2.2", 2), 0.929, 0.005)
end)

check.case("where the mesh resolves the problem, two rows are as good as all", function()
  for _, name in ipairs { "peeling", "ironing", "rings" } do
    check.near(ratio(name, "N2.2", "N2-N2.2x2"), 1, 0.15)
  end
end)

check.case("depth of N4 layers reduces only the oscillation of the drag", function()
  for _, name in ipairs { "peeling", "hertz", "rings" } do check.near(ratio(name, "N2-N4x2", "N2-N4"), 1, 0.03) end
  check.near(ratio("ironing", "N2-N4x2", "N2-N4", 2), 0.772, 0.005)
end)

check.case("files: a table and charts per problem", function()
  for name, charts in pairs { peeling = { "dM" }, ironing = { "dPy", "dPx" }, hertz = { "L2" }, rings = { "L2" } } do
    local read = sg.csv.read(("%s/%s.csv"):format(folder, name))
    check.equal(read:column "order", { "N2", "N2-N2.2", "N2-N2.2x2", "N2.2", "N2-N4", "N2-N4x2", "N4" })
    for _, chart in ipairs(charts) do check.pictures(folder, { name .. "_" .. chart }) end
  end
end)

check.case("wrong arguments", function()
  check.refused("studies/layer_depth", {
    ["problem=rings"] = "did you mean 'problems'? known: hertz=meshes=m2;sizes=1",
    ["problems=rings,peel"] = "problems must be values among 'peeling', 'ironing', 'hertz' and 'rings'",
    ["rows=0"] = "rows must be whole numbers of at least 1, or all, got '0'",
    ["repeat=x"] = "repeat must be a whole number, 1 or more, got 'x'",
  })
end)
