-- sg.recommend on Hertz's line contact, where the true error is known.

require "check"

local problem = require "problems.hertz2d.problem"

local steps = 5

local function scene(order, mesh)
  local model, stage = problem.scene{ order = order, mesh = mesh, load = "force" }
  stage.steps = steps
  return model, { stage }
end

local meshes = { "m1", "m2", "m3", "m4", "m5", "m6" }

local function recommend(more)
  return sg.recommend(lists.merged({ scene = scene, quantity = "ground.max_pressure", at_most = 0.02,
    meshes = meshes }, more))
end

check.case("for 2 % it finds a case that is within 2 % of Hertz", function()
  local found = recommend()
  local model, stages = scene(found.order, found.mesh)
  local run = model:run(stages)
  local _, p0 = problem.hertz(2 * run:column "ground.fy"[steps])
  local off = math.abs(run:column "ground.max_pressure"[steps] / p0 - 1)
  check.equal(off < 0.02, true)
  check.equal(off <= found.error + 0.0075, true) -- 0.7 % is the ring's finite size and its penalty, on any mesh
end)

check.case("estimates are reliable: each case is as close to the finest mesh as estimated", function()
  local found = recommend{ at_most = 1e-3 }
  local model, stages = scene("N2-N2.2", "m5")
  local exact = model:run(stages):column "ground.max_pressure"[steps]
  local estimated = 0
  for _, case in ipairs(found.tries) do
    if case.error then
      estimated = estimated + 1
      check.equal(math.abs(case.value[1] / exact - 1) <= case.error, true)
    end
  end
  check.equal(estimated >= 3 and found.error <= 1e-3, true)
  check.holds(tostring(found), "estimated error", "chosen", "estimated from the next level; allowed 0.001")
end)

check.case("local layers: fewer unknowns, within the tolerance, and where the ring has touched", function()
  local function local_scene(order, mesh, _, layers)
    local model, stage = problem.scene{ order = order, mesh = mesh, load = "force", layer = layers and layers.ground }
    stage.steps = steps
    return model, { stage }
  end
  local orders = { "N2-N2.2" }
  local whole = recommend{ at_most = 2e-3, orders = orders }
  local part = recommend{ at_most = 2e-3, orders = orders, scene = local_scene, local_layers = true }
  check.equal({ part.order, part.mesh, #part.tries }, { whole.order, whole.mesh, #whole.tries })
  assert(part.unknowns < whole.unknowns and part.error <= 2e-3)
  local a = problem.hertz(2 * problem.half_load * problem.outer)
  assert(part.layers.ground{ 0.98 * a, -1 } and not part.layers.ground{ 1.25 * a, -1 })
  check.holds(part.report, "N2-N2.2, local on mesh", "Contacts touch in ground: X from ")
  check.equal(recommend{ orders = { "N2" }, local_layers = true }.layers, nil)
end)

check.case("lists of numbers; no case within the tolerance; dominated orders; a limit", function()
  local function pressures(model)
    local profile, list = model:profile "ground", {}
    for k = 0, 4 do
      local x = k * 0.005
      for i = 2, #profile.x do
        if profile.x[i - 1] <= x and x <= profile.x[i] then
          local part = (x - profile.x[i - 1]) / (profile.x[i] - profile.x[i - 1])
          list[k + 1] = profile.pressure[i - 1] * (1 - part) + profile.pressure[i] * part
        end
      end
      list[k + 1] = list[k + 1] or profile.pressure[1]
    end
    return list
  end
  local none = recommend{ quantity = pressures, at_most = 1e-9, meshes = { "m1", "m2" } }
  check.equal({ none.order, none.error }, {})
  check.holds(none.report, "None of these is known to be within 1e-09", "comes nearest")
  check.equal(#none.tries, 3) -- both orders on m1, the richest on m2
  local short = recommend{ at_most = 1e-9, limit = 1e-6 }
  check.equal(short.tries[#short.tries].mesh, "m2")
end)

check.case("formulations are candidates, too", function()
  local seen = {}
  local keys = { { penalty = 100 }, { method = "mortar", enforcement = "multipliers" } }
  local found = recommend{ formulations = keys, at_most = 0.05, orders = { "N2-N2.2" },
    scene = function(order, mesh, own)
      seen[own] = (seen[own] or 0) + 1
      local model, stage = problem.scene{ order = order, mesh = mesh, load = "force", formulation = { keys = own } }
      stage.steps = steps
      return model, { stage }
    end }
  check.equal({ seen[keys[1]] >= 1, seen[keys[2]] >= 2, found.order }, { true, true, "N2-N2.2" })
  assert(found.formulation == keys[1] or found.formulation == keys[2])
  check.holds(tostring(found), "N2-N2.2, penalty=100", "N2-N2.2, enforcement=multipliers method=mortar", "chosen")
  check.fails(function() recommend{ formulations = {} } end, "recommend_test.lua", "formulations")
end)

check.case("failed runs are reported and skipped", function()
  local found = recommend{ orders = { "N2", "N2-N2.1", "N4" }, scene = function(order, mesh)
    local model, stages = scene(order, mesh)
    return model, stages, order == "N4" and sg.plain{ newton = { iterations = 1 } } or nil
  end }
  check.equal(found.order ~= "N4" and found.order ~= nil, true)
  local failed = 0
  for _, case in ipairs(found.tries) do failed = failed + (case.failed == "iterations" and 1 or 0) end
  check.equal(failed >= 1, true)
end)

check.case("wrong arguments are errors at the user's line", function()
  for _, wrong in ipairs {
    { { quantity = "ground.maxpressure" }, "sg.recommend: quantity must be", "'ground.maxpressure'",
      "did you mean 'ground.max_pressure'?" },
    { { quantity = function() end }, "quantity must return a number" , "nothing" },
    { { quantity = function() return 0 / 0 end }, "finite number", "nan" },
    { { quantity = function() return 0 end, meshes = { "m1", "m2" } }, "the result of quantity is zero" },
    { { at_most = 2 }, "at_most must be a number above 0 and below 1 (relative error)", "write 0.02 for 2 %" },
    { { orders = {} }, "orders must be a list of at least one string" },
    { { scene = function() return 1 end }, "scene must return a model" },
    { { meshes = { "m2", "m1" } }, "N2-N2.2 has", "unknowns on mesh m2",
      "on mesh m1. Hint: order meshes from coarse to fine" },
    { { scene = function(order) return scene(order, "m1") end }, "and use them in scene" },
  } do
    check.fails(function() recommend(wrong[1]) end, "recommend_test.lua", table.unpack(wrong, 2))
  end
end)
