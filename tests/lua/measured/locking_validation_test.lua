-- volumetric = "projected" against closed forms and published figures: Cook's membrane, a cantilever, Lamé's ring and
-- ball, Hertz's contact; energy of all laws.

require "check"

local nu = 0.4999

--- A body of small strains with projected volume change, unless given otherwise.
local function body_of(patch, options)
  return sg.body{ patch = patch, elements = options.elements, order = options.order or "N2",
                  contact = options.contact, thickness_degree = options.thickness_degree,
                  volumetric = options.volumetric or "projected",
                  material = options.material or sg.linear_elastic{ E = 1, nu = nu } }
end

local function solved(model, stage, controls)
  check.completed(model:run({ stage }, controls))
  return model
end

check.case("Cook's membrane: the middle of its side moves as published, with all orders, and locks without", function()
  local results = check.study("problems/cook", "laws=linear", "orders=L1,L2,N2,N3", "elements=16").results.linear
  local published = 16.4326
  for order, share in pairs{ L1 = 0.03, L2 = 0.01, N2 = 0.01, N3 = 0.01 } do
    check.within_share(order, results.projected[order][16], published, share)
  end
  check.at_most("L1 locks", results.pointwise.L1[16], 0.5 * published)
  check.refused("problems/cook", {
    ["laws=steel"] = "laws", ["elements=0"] = "elements", ["volumetric=mixed"] = "volumetric" })
end)

check.case("a cantilever bends as a beam of Timoshenko, also with degree 1 across it", function()
  local length, load, G = 10, 1e-4, 1 / (2 * (1 + nu))
  local exact = -4 * load * length^3 * (1 - nu^2) - load * length / (5 / 6 * G)
  --- Between the ends of the axis; sections at the wall may become thinner, as those of the beam.
  local function deflection(options)
    local beam = body_of(sg.shapes.rectangle{ width = length, height = 1 }, options)
    local model = solved(scenes.model{ bodies = { beam = beam },
        supports = { wall = { on = "west", fix = "x" }, corner = { on = "south-west", fix = "y" } },
        loads = { back = { on = "west", traction = { 0, 0 } }, tip = { on = "east", traction = { 0, 0 } } } },
      { steps = 1, back = { 0, load }, tip = { 0, -load } })
    return model:sample("beam", "uy", { 1, 0.5 }) - model:sample("beam", "uy", { 0, 0.5 })
  end
  for _, order in ipairs { "N2", "N3" } do
    check.within_share(order, deflection{ elements = { 20, 2 }, order = order }, exact, 0.01)
  end
  check.within_share("degree 1 across", deflection{ elements = { 40, 8 }, order = "N2", contact = "south",
    thickness_degree = 1 }, exact, 0.03)
  check.at_most("locked", math.abs(deflection{ elements = { 40, 8 }, order = "N2", contact = "south",
    thickness_degree = 1, volumetric = "pointwise" } / exact), 0.5)
end)

check.case("Lame: displacements and stresses converge at optimal rates", function()
  local results = check.study("problems/locking_ring", "orders=N2,N3", "elements=6,24")
  for _, shape in ipairs { "ring", "ball" } do
    for order, p in pairs { N2 = 2, N3 = 3 } do
      local errors = results[shape].projected[order]
      for quantity, least in pairs { displacement = p + 0.5, stress = p - 0.5 } do -- asymptotically p + 1 and p
        local rate = math.log(errors[quantity][1] / errors[quantity][2], 4)
        if not (rate > least) then error(("%s, %s, %s: rate %g"):format(order, shape, quantity, rate)) end
      end
      check.at_most("stress", errors.stress[2], 1e-3)
    end
  end
  local locked = results.ring.pointwise.N2.stress[2]
  if not (locked > 1) then error("stresses without projection are not useless, as expected: " .. locked) end
  check.refused("problems/locking_ring", { ["shapes=cube"] = "shapes", ["nu=0.5"] = "nu", ["elements=1"] = "elements",
                          ["volumetric=mixed"] = "volumetric" })
end)

check.case("a cylinder of incompressible material touches as Hertz says", function()
  local problem = require "problems.hertz2d.problem"
  local half_width, peak = problem.hertz(2 * problem.half_load, nu)
  local model, stage = problem.scene{ order = "N2-N2.2", mesh = "m3", load = "force", thickness_degree = 2,
                                      poisson = nu, volumetric = "projected" }
  stage.steps = 5
  local profile = solved(model, stage):profile "ground"
  local pressure, width = 0, 0
  for i, value in ipairs(profile.pressure) do
    pressure = math.max(pressure, value)
    if value > 0 then width = math.max(width, profile.x[i]) end
  end
  check.within_share("greatest pressure", pressure, peak, 0.03)
  check.within_share("half-width", width, half_width, 0.05)
end)

local laws = {
  sg.neo_hookean{ E = 1, nu = nu }, sg.mooney_rivlin{ c10 = 0.13, c01 = 0.03, K = 1000 },
  sg.ogden{ mu = { 0.3 }, alpha = { 2.2 }, K = 1000 },
}

--- A strip of rubber that is sheared and stretched. `kind` as in sg.model.
local function pulled(material, kind)
  local body = body_of(sg.shapes.rectangle{ width = 2, height = 1, corner = { 1, 0 } },
    { elements = { 6, 4 }, material = material })
  local model = scenes.model{ bodies = { strip = body }, kind = kind, supports = {
    bed = { on = "south", fix = "xy" }, grip = { on = "north", drive = "xy" } } }
  return solved(model, { steps = 24, grip = { kind == "axisymmetric" and 0.05 or 0.3, 0.1 } },
    { newton = { tolerance = 1e-12 } })
end

check.case("energy is the work of the forces, for all laws", function()
  for _, kind in ipairs { "plane_strain", "axisymmetric" } do
    for _, law in ipairs(laws) do
      local energy = pulled(law, kind):energy()
      check.within_share(tostring(law), energy.work, energy.stored, 2e-3)
    end
  end
end)
