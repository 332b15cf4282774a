-- Contact states under penalties that change in ways on which Newton's method alone cycles or ends too early, and the
-- rules of active_set.hpp that prevent it, with the scenes of scripts/stability/kinds.lua.

require "check"

--- A quarter tube on a mandrel that grows.
local function tube(penalty)
  local body = sg.body{ patch = sg.shapes.quarter_annulus{ inner = 5, outer = 7, start = 0 }, elements = { 8, 4 },
                        order = "N2", contact = "north", material = sg.linear_elastic{ E = 100, nu = 0.3 } }
  local mandrel = sg.rigid.cylinder{ center = { 0, 0 }, radius = 5 }
  local model = scenes.model{ bodies = { tube = body },
    contacts = { fit = { slave = "north", master = mandrel, penalty = penalty } },
    supports = { hold = { on = mandrel, fix = "xy" }, west = { on = "west", symmetry = true },
      east = { on = "east", symmetry = true } } }
  return model, model:run{ { name = "grow", steps = 4, contacts = { fit = { offset = 0.05 } } } }
end

check.case("all points of conforming faces do not open and close in turn", function()
  for _, penalty in ipairs { 4e4, 4e6 } do
    local model, run = tube(penalty)
    check.equal({ run.reason, run.cutbacks, run.fallback_steps }, { "completed", 0, 0 })
    check.at_most("iterations", run.iterations, 20)
    -- Lamé for an internal displacement of 0.05 in plane strain
    check.near(model:contact_resultant("fit").max_pressure, 0.3129, 0.004)
  end
end)

check.case("a closed set that shrinks by one point per iteration may exceed the limit of iterations", function()
  local material = sg.linear_elastic{ E = 1000, nu = 0.3 }
  local layer = scenes.body{ size = {6, 1}, elements = { 48, 8 }, contact = "south", material = material }
  local base = scenes.body{ size = {8, 6}, corner = { 0, -6 }, elements = { 48, 12 },
                        contact = "north", material = material }
  local model = scenes.model{ bodies = { layer = layer, base = base },
    supports = { axis = { on = { "layer.west", "base.west" }, symmetry = true },
      bed = { on = "base.south", fix = "xy" } },
    loads = { top = { on = "layer.north", pressure = function(x) return x < 0.125 and 1 or 0 end, factor = 0 } },
    contacts = { seat = { slave = "layer.south", master = "base.north", penalty = 8e5 } } }
  local run = model:run{ { name = "load", steps = 1, top = 1 } }
  check.equal({ run.reason, run.cutbacks, run.fallback_steps }, { "completed", 0, 0 })
  check.at_most("iterations", run.iterations, 60)
  check.near(model:contact_resultant("seat").fy, 0.125, 1e-8)
end)

check.case("where slip reverses the line search by energy ends the alternation", function()
  local side, n, E = 0.04, 16, 1.3e11
  local penalty = 50 * E * n / side
  local plate = scenes.body{ size = {side, side}, elements = { n, n }, contact = "south",
    material = sg.linear_elastic{ E = E, nu = 0.2 } }
  local model = scenes.model{ bodies = { plate = plate }, supports = { axis = { on = "east", fix = "x" } },
    loads = { top = { on = "north", pressure = 0 }, side = { on = "west", pressure = 0 } },
    contacts = { floor = { slave = "south", master = sg.rigid.plane{ point = { 0, 0 }, normal = { 0, 1 } },
      penalty = penalty, friction = { mu = 1, penalty = penalty } } } }
  local run = model:run{ { name = "load", steps = 1, top = 5e7, side = 15e7 } }
  check.equal({ run.reason, run.cutbacks, run.fallback_steps }, { "completed", 0, 0 })
  check.at_most("iterations", run.iterations, 20)
  check.near(model:sample("plate", "ux", { 0, 0 }), 2.86e-5, 5e-7)
end)

check.case("a line search that shortens nothing changes no bit", function()
  local function forces(search)
    local tool = sg.rigid.cylinder{ center = { 2, 3 }, radius = 2 }
    local model = scenes.model{
      bodies = { block = { size = { 4, 1 }, elements = { 12, 3 }, contact = "north" } },
      supports = { base = { on = "south", fix = "xy" }, push = { on = tool, drive = "xy" } },
      contacts = { touch = { slave = "north", master = tool, penalty = 5, friction = { mu = 0.1 } } } }
    local run = model:run({ { steps = 3, push = { 0, -0.05 } } }, sg.plain{ newton = { line_search = search } })
    return { run.iterations, table.unpack(run:column "push.fy") }
  end
  check.equal(forces "energy", forces "none")
end)

check.case("nearly incompressible bodies take as many iterations as others", function()
  local counts = {}
  for _, nu in ipairs { 0.49, 0.4999 } do
    local layer = scenes.body{ size = {6, 1}, elements = { 30, 5 }, order = "N2-N2.2", contact = "north",
      volumetric = "projected", material = sg.neo_hookean{ E = 1, nu = nu } }
    local ball = sg.rigid.sphere{ center = { 0, 5 }, radius = 4 }
    local model = scenes.model{ kind = "axisymmetric", bodies = { layer = layer },
      supports = { bed = { on = "south", fix = "xy" }, axis = { on = "west", symmetry = true },
        push = { on = ball, drive = "y" } }, contacts = { touch = { slave = "north", master = ball, penalty = 1000 } },
      }
    local run = model:run{ { name = "press", steps = 4, push = { -0.12 } } }
    check.equal({ run.reason, run.cutbacks }, { "completed", 0 })
    counts[#counts + 1] = run.iterations
  end
  check.at_most("iterations", counts[2], 1.3 * counts[1])
end)
