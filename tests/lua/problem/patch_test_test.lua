-- patch_test.lua, coarse: uniform to rounding error without kinks, expected decrease of errors with kinks.

require "check"

local plane, plane_folder = check.study("problems/patch_test", "dimensions=2")
local solid, solid_folder = check.study("problems/patch_test", "dimensions=3", "orders=N2", "points=6")
local free, free_folder = check.study("problems/patch_test", "dimensions=3", "materials=linear", "orders=N1",
  "points=3", "sides=free")

local function name(case)
  return ("%dD %s %s %s, slave %s, %d points"):format(case.dimension, case.material, case.order, case.pair, case.slave,
    case.points)
end

check.case("without kinks inside the slave's elements the stress is uniform to rounding error, in 2D and 3D", function()
  local seen = 0
  for _, study in ipairs { plane, solid, free } do
    for _, case in ipairs(study.exact) do
      check.at_most(name(case) .. ": pressure", case.pressure_error, 1e-11)
      check.at_most(name(case) .. ": stress", case.stress_error, 1e-11)
      seen = seen + 1
    end
  end
  -- dimensions, materials, orders, pairs, numbers of points
  check.equal(seen, 1 * 2 * 5 * 3 * 2 + 1 * 2 * 1 * 3 * 2 + 1 * 1 * 1 * 3 * 2)
end)

check.case("the whole force is transmitted by every contact", function()
  for _, study in ipairs { plane, solid, free } do
    for _, case in ipairs(study.exact) do check.at_most(name(case), case.force_error, 1e-11) end
    for _, case in ipairs(study.cases) do check.at_most(name(case), case.force_error, 1e-9) end
  end
end)

check.case("with kinks the error is visible, with the exponent of Gauss' rule for a kink", function()
  for _, case in ipairs(solid.cases) do assert(case.pressure_error > 1e-6, name(case)) end
  check.equal(#plane.rates, 10)
  for _, rate in ipairs(plane.rates) do
    check.at_most(("%s, slave %s: exponent off"):format(rate.order, rate.slave), rate.exponent - rate.expected, 0.2)
  end
end)

--- The error of N2 on non-matching meshes, linear elastic, by slave and number of points.
local function error_at(study, dimension, slave, points, key)
  for _, case in ipairs(study.cases) do
    if case.dimension == dimension and case.order == "N2" and case.pair == "non-matching" and case.slave == slave and
       case.points == points and case.material == "linear" then
      return case[key or "pressure_error"]
    end
  end
end

check.case("in 3D two directions add up what one has in 2D", function()
  for _, slave in ipairs { "lower", "upper" } do
    check.near(error_at(solid, 3, slave, 3) / error_at(plane, 2, slave, 3), 2, 0.1)
    check.near(error_at(solid, 3, slave, 6) / error_at(plane, 2, slave, 6), 2, 0.1)
  end
end)

check.case("the results are unchanged", function()
  check.near(error_at(plane, 2, "lower", 9), 2.3e-3, 0.1e-3)
  check.near(error_at(plane, 2, "upper", 9), 3.4e-5, 0.1e-5)
  check.near(error_at(plane, 2, "upper", 9, "stress_error"), 7.2e-6, 0.1e-6)
end)

check.case("tables and charts", function()
  check.equal(#sg.csv.read(free_folder .. "/errors.csv").rows, #free.cases)
  check.pictures(plane_folder, { "error_2d_lower", "error_2d_upper", "pressure" })
  check.pictures(solid_folder, { "error_3d_lower", "error_3d_upper" })
end)

check.case("wrong arguments", function()
  check.refused("problems/patch_test", {
    ["order=N2"] = "unknown argument 'order=N2'; did you mean 'orders'? known: dimensions=",
    ["dimensions=4"] = "dimensions must be values among 2 and 3, got '4'",
    ["materials=steel"] =
      "materials must be values among 'linear' and 'neo_hooke', got 'steel'",
    ["sides=open"] = "sides must be 'guided' or 'free', got 'open'",
    ["penalties=-1"] = "penalties must be", ["points=x"] = "points must be" })
end)
