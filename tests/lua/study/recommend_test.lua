-- sg.recommend on Hertz's line contact, where the true error is known.

require "check"

local problem = require "problems.hertz2d.problem"

local steps = 2

local function scene(q)
  local model, stage = problem.scene{ order = q.order, mesh = "m1", load = "force",
                                      formulation = q.formulation and { keys = q.formulation } }
  stage.steps = steps
  return model, { stage }
end

local function recommend(more)
  return sg.recommend(lists.merged({ scene = scene, tolerance = "5 % of ground.max_pressure" }, more))
end

check.case("for 5 % it finds a case that is within 5 % of Hertz, and returns its model and run", function()
  local found = recommend()
  local _, p0 = problem.hertz(2 * found.run:column "ground.fy"[steps])
  check.within_share("peak", found.run:column "ground.max_pressure"[steps], p0, 0.05)
  check.equal(#found.model:unknowns(), found.best.unknowns)
  check.equal(found.settings.reached, true)
  check.holds(tostring(found), "error / tolerance", "chosen", "5 % of ground.max_pressure")
  if found.best.part > 1 then error "the bar is larger than the tolerance" end
end)

check.case("formulations and thickness degrees are candidates, too", function()
  local seen = {}
  local keys = { { penalty = 100 }, { method = "mortar", enforcement = "multipliers" } }
  local found = recommend{ formulations = keys, thickness_degrees = { 2 }, tolerance = "20 % of ground.max_pressure",
    orders = { "N2-N2.2" }, scene = function(q)
      seen[q.formulation] = q.thickness_degree
      return scene(q)
    end }
  check.equal({ seen[keys[1]], seen[keys[2]], found.order, found.thickness_degree }, { 2, 2, "N2-N2.2", 2 })
  assert(found.formulation == keys[1] or found.formulation == keys[2])
  check.holds(tostring(found), "N2-N2.2, penalty=100", "N2-N2.2, enforcement=multipliers method=mortar", "chosen")
end)

check.case("a scene that reads the mesh gives the other meshes itself", function()
  local function strip(q)
    local elements = { math.ceil(12 * q.mesh), math.ceil(3 * q.mesh) }
    return scenes.model{ bodies = { block = { size = { 4, 1 }, elements = elements, contact = "south" } },
      supports = { grip = { on = "north", drive = "y", fix = "x" } },
      contacts = { floor = { slave = "south", penalty = 100,
                             master = sg.rigid.cylinder{ center = { 2, -8 }, radius = 8 } } } },
      { { steps = 2, grip = -0.1 } }
  end
  local own = recommend{ scene = strip, orders = { "N2" }, tolerance = "2 % of grip.fy" }
  local again = recommend{ scene = function(q) return strip{ order = q.order, mesh = 1 } end, orders = { "N2" },
                           tolerance = "2 % of grip.fy" }
  check.equal(lists.map(own.tries, function(one) return { one.settings, one.unknowns } end),
    lists.map(again.tries, function(one) return { one.settings, one.unknowns } end))
end)

check.case("a limit; no candidate within the tolerance", function()
  local none = recommend{ tolerance = "0.001 % of ground.max_pressure", limit = 1e-6 }
  check.equal({ none.order, none.run, #none.tries }, { nil, nil, 2 })
  check.holds(none.report, "None of these reaches 0.001 % of ground.max_pressure", "comes nearest")
end)

check.case("failed runs are reported and not chosen", function()
  local found = recommend{ orders = { "N4", "N2" }, tolerance = "30 % of ground.fy", scene = function(q)
    local model, stages = scene(q)
    return model, stages, q.order == "N4" and sg.plain{ newton = { iterations = 1 } } or nil
  end }
  check.equal({ found.order, found.tries[1].failed }, { "N2", "iterations" })
end)

check.case("wrong arguments are errors at the user's line", function()
  for _, wrong in ipairs {
    { { tolerance = "5 % of ground.maxpressure" }, "sg.recommend: tolerance: 'ground.maxpressure' is no result",
      "did you mean 'ground.max_pressure'?" },
    { { tolerance = 0.05 }, "tolerance", "1 % of grip.fx" },
    { { tolerance = "5 of grip.fx" }, "sg.recommend: tolerance must be a text such as" },
    { { orders = {} }, "orders must be a list of at least one string" },
    { { formulations = {} }, "formulations" },
    { { thickness_degrees = { 0 } }, "thickness_degrees[1]" },
    { { scene = function() return 1 end }, "scene must return a model" },
    { { limit = 0 }, "limit" },
  } do
    check.fails(function() recommend(wrong[1]) end, "recommend_test.lua", table.unpack(wrong, 2))
  end
end)
