-- Viscoelastic bodies: held bodies relax as their Prony series in all kinds of models, limits, balance of energies,
-- steps of equal ratio, checkpoints, and wrong input.

require "check"
local scenes = require "scenes"

local g, tau = { 0.3, 0.2 }, { 0.1, 10 }
local tight = sg.plain{ newton = { tolerance = 1e-12 } }

--- G(t)/G(0).
local function relaxed(t)
  local sum = 1
  for i, fraction in ipairs(g) do sum = sum - fraction * (1 - math.exp(-t / tau[i])) end
  return sum
end

local path = { { name = "press", steps = 2 }, { name = "hold", steps = 4, duration = 30, growth = 3 },
               { name = "rest", steps = 1, duration = "relaxed" } }

local function held(material, kind, volumetric)
  local space = kind == "space"
  local patch = space and sg.shapes.block{ size = { 1, 0.7, 0.8 } } or sg.shapes.rectangle{ width = 1, height = 1 }
  local body = sg.body{ patch = patch, elements = space and { 2, 2, 2 } or { 3, 3 }, order = "N2", material = material,
                        volumetric = volumetric }
  local down, up, all = space and "front" or "south", space and "back" or "north", space and "xyz" or "xy"
  local model = scenes.model{ bodies = { b = body }, kind = not space and kind or nil,
    supports = { bed = { on = body:face(down), fix = all }, grip = { on = body:face(up), drive = all } } }
  path[1].grip = space and { 0, 0, -0.4 * 0.8 } or { 0, -0.4 }
  local run = model:run(path, tight)
  check.equal(run.failed, false)
  return run:column(space and "grip.fz" or "grip.fy"), run:column "time", model
end

local elastic = {
  neo_hookean = sg.neo_hookean{ E = 1, nu = 0.3 }, linear = sg.linear_elastic{ E = 1, nu = 0.3 },
  yeoh = sg.yeoh{ c10 = 0.5, c20 = -0.01, c30 = 0.001, K = 5 },
}

check.case("held bodies whose stress relaxes keep their shape, and the force follows the series", function()
  for _, kind in ipairs { "plane_strain", "axisymmetric", "plane_stress", "space" } do
    for name, law in pairs(elastic) do
      for _, volumetric in ipairs { "pointwise", kind ~= "plane_stress" and "projected" or nil } do
        local what = ("%s, %s, %s"):format(kind, name, volumetric)
        local force, time = held(sg.viscoelastic{ law = law, g = g, tau = tau, relaxes = "all" }, kind, volumetric)
        check.within_share(what .. ": at once", force[2], held(law, kind, volumetric)[2], 1e-12)
        for row = 3, 6 do check.within_share(what .. ": held", force[row] / force[2], relaxed(time[row]), 1e-10) end
        check.within_share(what .. ": at last", force[7] / force[2], 0.5, 1e-10)
        check.near(time[7], 30, 1e-12)
      end
    end
  end
end)

-- Between Gauss points the stress has the error of interpolated overstresses.
check.case("stresses at points relax as well", function()
  local function stress(material, relaxes)
    local body = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = { 8, 8 }, order = "N2",
                          thickness_degree = 2, material = material }
    local model = scenes.model{ bodies = { b = body }, supports = { bed = { on = body:face "south", fix = "xy" },
                                                              grip = { on = body:face "north", drive = "xy" } } }
    model:run({ { name = "press", steps = 2, grip = { 0, -0.2 } }, relaxes and path[3] or nil }, tight)
    return model:sample("b", "syy", { 0.37, 0.41 })
  end
  local law = elastic.neo_hookean
  local after = stress(sg.viscoelastic{ law = law, g = g, tau = tau, relaxes = "all" }, true)
  check.within_share("stress", after, 0.5 * stress(law), 1e-4)
end)

-- A nearly incompressible body has hardly a stress of volume change that does not relax.
check.case("the change of shape relaxes, at constant bulk modulus", function()
  local law = sg.neo_hookean{ E = 1, nu = 0.4999 }
  local model = function(material)
    local body = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = { 4, 4 }, order = "N2",
                          material = material, volumetric = "projected" }
    local m = scenes.model{ bodies = { b = body }, supports = { bed = { on = body:face "south", fix = "xy" },
                                                          grip = { on = body:face "north", drive = "xy" } } }
    return m:run({ { name = "press", steps = 4, grip = { 0, -0.2 } }, path[2], path[3] }, tight)
  end
  local run = model(sg.viscoelastic{ law = law, g = g, tau = tau })
  local force, time = run:column "grip.fy", run:column "time"
  for row = 5, 8 do check.within_share("held", force[row] / force[4], relaxed(time[row]), 1e-3) end
  check.within_share("at last", force[9] / force[4], 0.5, 1e-3)
end)

check.case("work is stored energy and viscous work, to second order in the step", function()
  local rest = {}
  for _, steps in ipairs { 8, 16 } do
    local body = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = { 2, 2 }, order = "N2",
                          material = sg.viscoelastic{ law = elastic.yeoh, g = g, tau = { 0.5, 2 } } }
    local model = scenes.model{ bodies = { b = body }, supports = { bed = { on = body:face "south", fix = "xy" },
                                                              grip = { on = body:face "north", drive = "xy" } } }
    model:run({ { name = "press", steps = steps, duration = 1, grip = { 0.1, -0.2 } } }, tight)
    local energy = model:energy()
    check.equal(energy.viscous > 0.05 * energy.work, true)
    rest[#rest + 1] = (energy.work - energy.stored - energy.viscous) / energy.work
  end
  check.at_most("balance", math.abs(rest[2]), 1e-3)
  check.within("order", rest[1] / rest[2], 4, 0.3)
end)

check.case("each step of a stage is longer than the one before, in time and in what it changes", function()
  local body = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = { 1, 1 }, order = "N2",
                        material = elastic.linear }
  local model = scenes.model{ bodies = { b = body }, supports = { bed = { on = body:face "south", fix = "xy" },
                                                            grip = { on = body:face "north", drive = "xy" } } }
  local run = model:run{ { name = "press", steps = 3, duration = 7, growth = 2, grip = { 0, -0.07 } },
                         { name = "lift", steps = 2, growth = 3, grip = { 0, 0 } } }
  check.near(run:column "time", { 1, 3, 7, 7, 7 }, 1e-12)
  check.near(run:column "grip.uy", { -0.01, -0.03, -0.07, -0.0525, 0 }, 1e-12)
end)

check.case("a run goes on from a file with its overstresses", function()
  local material = sg.viscoelastic{ law = elastic.yeoh, g = g, tau = tau }
  check.equal(tostring(material):find("of its stress of the change of shape relax 0.3 within tau = 0.1, 0.2", 1, true)
    ~= nil, true)
  local force, _, model = held(material, "plane_strain")
  local file = os.tmpname()
  model:save(file)
  local other = sg.load(file)
  os.remove(file)
  check.equal(other:energy(), model:energy())
  local more = { { name = "up", steps = 2, duration = 1, grip = { 0, -0.3 } } }
  check.equal(other:run(more, tight):column "grip.fy", model:run(more, tight):column "grip.fy")
  check.equal(#force, 7)
end)

check.case("wrong input", function()
  local law = elastic.linear
  check.fails(function() sg.viscoelastic{ law = law, g = { 0.5, 0.5 }, tau = { 1, 2 } } end,
    "the sum of g must be below 1")
  check.fails(function() sg.viscoelastic{ law = law, g = { 0.5 }, tau = { 1, 2 } } end,
    "g and tau must have one value per term, got 1 and 2")
  check.fails(function() sg.viscoelastic{ law = law, g = {}, tau = {} } end, "g")
  check.fails(function() sg.viscoelastic{ law = law, g = { 0.5 }, tau = { 0 } } end, "tau")
  check.fails(function()
    sg.viscoelastic{ law = sg.viscoelastic{ law = law, g = { 0.5 }, tau = { 1 } }, g = { 0.1 }, tau = { 1 } }
  end, "law must be an elastic material")
end)
