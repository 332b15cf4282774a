-- scripts/formulations/uniform_pressure.lua, coarse: half passes are uniform to rounding error on all meshes, mortar is
-- more uniform than Gauss points, the error of one pass falls as that of Gauss' rule.

require "check"

local plane, plane_folder = check.study("formulations/uniform_pressure", "dimensions=2", "orders=N2", "points=12")
local solid, solid_folder = check.study("formulations/uniform_pressure", "dimensions=3", "orders=N2", "points_3d=4",
  "skews=0.2", "formulations=gpts,equal,reduced,half-passes")

local function series(study, formulation, slave, skew)
  for _, one in ipairs(study.series) do
    if one.formulation.name == formulation and one.slave == slave and one.skew == skew then return one end
  end
  error("no series " .. formulation)
end

--- The geometric mean of the errors for from to to points; a single value depends on where kinks lie between points.
local function mean(one, from, to)
  local sum = 0
  for points = from, to do
    local case = one[points - one.degree]
    assert(case.error, ("%s: %s"):format(one.formulation.name, tostring(case.reason)))
    sum = sum + math.log(case.error) / (to - from + 1)
  end
  return math.exp(sum)
end

check.case("two half passes: uniform to rounding error, in 2D and 3D, skewed or not, either slave", function()
  local seen = 0
  for _, study in ipairs { plane, solid } do
    for _, one in ipairs(study.series) do
      if one.formulation.two_faces then
        for _, case in ipairs(one) do
          check.at_most(("%dD, slave %s, %d points"):format(one.dimension, one.slave, case.points), case.error, 1e-12)
          seen = seen + 1
        end
      end
    end
  end
  check.equal(seen >= 2 * 2 * 10 + 2 * 2, true) -- slaves, skews, numbers of points
end)

check.case("one pass: mortar is more uniform than Gauss points, by an order with the coarser mesh as slave", function()
  for _, name in ipairs { "equal", "reduced" } do
    for _, skew in ipairs { 0, 0.2 } do
      for slave, share in pairs { lower = 0.3, upper = 1 } do
        local points, mortar = series(plane, "gpts", slave, skew), series(plane, name, slave, skew)
        check.at_most(name .. " " .. slave, mean(mortar, 3, 12), share * mean(points, 3, 12))
      end
      check.at_most(name .. " 3D", mean(series(solid, name, "lower", 0.2), 3, 4),
        0.3 * mean(series(solid, "gpts", "lower", 0.2), 3, 4))
    end
  end
end)

check.case("one pass with multipliers: more uniform than Gauss points with the coarser mesh as slave", function()
  for _, name in ipairs { "equal-multipliers", "reduced-multipliers" } do
    for _, skew in ipairs { 0, 0.2 } do
      for slave, share in pairs { lower = 0.6, upper = 1.1 } do
        local points, mortar = series(plane, "gpts", slave, skew), series(plane, name, slave, skew)
        check.at_most(name .. " " .. slave, mean(mortar, 3, 12), share * mean(points, 3, 12))
      end
    end
  end
end)

check.case("one pass: the error falls with the number of points", function()
  for _, name in ipairs { "gpts", "equal", "reduced", "equal-multipliers", "reduced-multipliers" } do
    for _, slave in ipairs { "lower", "upper" } do
      local one = series(plane, name, slave, 0)
      check.at_most(name .. " " .. slave, mean(one, 9, 12), 0.3 * mean(one, 3, 5))
    end
  end
end)

check.case("files and wrong arguments", function()
  check.pictures(plane_folder, { "2d_N2_lower", "2d_N2_upper" })
  check.pictures(solid_folder, { "3d_N2_lower", "3d_N2_upper" })
  check.refused("formulations/uniform_pressure", { ["formulations=mortar"] = "formulations must be values among 'gpts'",
                          ["skews=0.7"] = "skews must be" })
end)
