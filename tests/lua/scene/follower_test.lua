-- Pressures that follow the deformation: tangents against differences, symmetry, exact states, work, buckling of a
-- ring, balloons beyond their limit points by arc length; lists of faces, files, wrong inputs.

require "check"
local tangents = require "tangents"

local pi = math.pi
local rubber = sg.neo_hookean{ E = 10, nu = 0.3 }

--- Scenes of each kind with a follower pressure of 0 named gas, small enough for differences.
local function square(more)
  return scenes.model(lists.merged({ bodies = { body = { material = rubber } } }, more))
end

local function loaded(faces) return { gas = { on = faces, pressure = 0, follower = true } } end

local function plane(kind, corner)
  return square{ bodies = { body = { corner = corner, order = "N2-N2.1", contact = "north", material = rubber } },
    kind = kind, supports = { bed = { on = "south", fix = "xy" } }, loads = loaded{ "north", "east" } }
end

local kinds = {
  ["plane strain"] = function() return plane("plane_strain", {0, 0}) end,
  ["plane stress"] = function() return plane("plane_stress", {0, 0}) end,
  ["axisymmetric"] = function() return plane("axisymmetric", {0.5, 0}) end,
  ["on the axis"] = function()
    return square{ kind = "axisymmetric", loads = loaded "north",
      supports = { bed = { on = "south", fix = "xy" }, axis = { on = "west", symmetry = true } } }
  end,
  ["3D"] = function()
    return square{ bodies = { body = { size = {1, 1, 1}, elements = {2, 1, 1}, order = "N2-N2.1", contact = "back",
        material = rubber } }, supports = { bed = { on = "front", fix = "xyz" } },
      loads = loaded{ "back", "east", "south" } }
  end,
  ["driven"] = function()
    return square{ loads = loaded "north",
      supports = { bed = { on = "south", fix = "xy" }, grip = { on = "north-west", drive = "x" } } }
  end,
}

--- Sets the pressure and moves every unknown by up to 0.02 without pattern.
local function displace(model, pressure, seed)
  local change = {}
  model:set_target("gas", { pressure })
  for i = 1, #model:residual() do change[i] = 0.02 * math.sin(seed * i * i) end
  model:move(change)
end

for name, scene in pairs(kinds) do
  check.case("the tangent is the derivative of the residual: " .. name, function()
    local model = scene()
    for seed = 1, 3 do
      displace(model, 4, seed)
      check.at_most("error of the tangent", tangents.error(model, 1e-5), 1e-8)
    end
  end)
end

--- Whether the load's part of the tangent is symmetric in a state without pattern.
local function symmetric(model)
  displace(model, 3, 1)
  local matrix, largest, difference = tangents.dense(model:tangent()), 0, 0
  model:rollback()
  for i, row in ipairs(matrix) do
    for j, value in ipairs(row) do
      largest = math.max(largest, math.abs(value))
      difference = math.max(difference, math.abs(value - matrix[j][i]))
    end
  end
  return difference < 1e-9 * largest
end

check.case("the tangent is symmetric where no border of the loaded faces moves freely", function()
  for name, scene in pairs(kinds) do check.equal({ name, symmetric(scene()) }, { name, false }) end
  local function on(faces, supports, kind)
    return square{ kind = kind, supports = supports, loads = loaded(faces) }
  end
  check.equal(symmetric(on { "west", "east", "south", "north" }), true)
  local left, right = { on = "west", symmetry = true }, { on = "east", fix = "x" }
  check.equal(symmetric(on("north", { left = left, right = right })), true)
  check.equal(symmetric(on("north", { left = left })), false)
  check.equal(symmetric(on("north", { left = left, right = right }, "axisymmetric")), true)
  -- Which decides on the linear solver: a reused Cholesky factorization for symmetric tangents
  local bed = { on = "south", fix = "xy" }
  for _, case in ipairs { { { bed = bed, left = left, right = right }, "reuse" }, { { bed = bed }, "klu" } } do
    local model = on("north", case[1])
    model:set_target("gas", { 0.1 })
    model:solve_step{}
    check.equal(model:solver().linear, case[2])
  end
end)

check.case("the stress in a body under a pressure all around is -p, per current area", function()
  for _, kind in ipairs { "plane_strain", "axisymmetric" } do
    local model = scenes.model{ bodies = { body = { size = {1, 2}, material = rubber } }, kind = kind,
      supports = { axis = { on = "west", symmetry = true }, bed = { on = "south", symmetry = true } },
      loads = { sea = { on = { "east", "north" }, pressure = 0, follower = true } } }
    local run = model:run({ { steps = 2, sea = 3 } }, sg.plain{})
    check.equal({ run.failed, run:column "sea.pressure" }, { false, { 1.5, 3 } })
    for _, xi in ipairs { {0.1, 0.9}, {0.5, 0.3} } do
      for _, field in ipairs { "sxx", "syy" } do check.near(model:sample("body", field, xi), -3, 1e-8) end
      check.near(model:sample("body", "sxy", xi), 0, 1e-8)
    end
    -- The force is that on the current area, and the supports hold it.
    local r = 1 + model:sample("body", "ux", {1, 0.5})
    local force = kind == "axisymmetric" and -3 * pi * r ^ 2 or -3 * r
    check.within_share("force", model:reaction "sea"[2], force, 1e-9)
    check.within_share("reaction", model:reaction "bed"[2], -force, 1e-9)
    check.equal(run:column "sea.fy"[2], model:reaction "sea"[2])
  end
end)

--- Whether a symmetric matrix is positive definite, by Cholesky's factorization.
local function positive(matrix)
  for j = 1, #matrix do
    local row = matrix[j]
    for k = 1, j do
      local sum = row[k]
      for i = 1, k - 1 do sum = sum - row[i] * matrix[k][i] end
      if k < j then
        row[k] = sum / matrix[k][k]
      elseif sum <= 0 then
        return false
      else
        row[k] = math.sqrt(sum)
      end
    end
  end
  return true
end

-- A ring under external pressure buckles into an ellipse at p R³/(E' I) = 3 if the pressure follows and at 4 if its
-- direction is fixed (S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability, 1961, section 7.4; J. Singer,
-- C. D. Babcock, J. Appl. Mech. 37, 1970). The pressure acts on the outer face, so its force per length is p R_outer.
check.case("a ring buckles under 3 E'I/R³ of a pressure that follows, and 4 E'I/R³ of a dead one", function()
  local radius, h, E, nu = 1, 0.02, 1, 0.3
  local body = sg.body{
    patch = sg.shapes.quarter_annulus{ inner = radius - h / 2, outer = radius + h / 2, center = {0, 0} },
    elements = {6, 1}, order = "N4", material = sg.neo_hookean{ E = E, nu = nu } }
  local scale = E / (1 - nu ^ 2) * h ^ 3 / 12 / (radius ^ 2 * (radius + h / 2))
  for follower, expected in pairs { [true] = 3, [false] = 4 } do
    local model = scenes.model{ bodies = { ring = body },
      supports = { left = { on = "west", symmetry = true }, low = { on = "east", symmetry = true } },
      loads = { sea = { on = "south", pressure = 0, follower = follower } } }
    local stable, unstable = 0, 6
    for _ = 1, 9 do
      local middle = (stable + unstable) / 2
      model:set_target("sea", { middle * scale })
      check.equal(model:solve_step{}.converged, true)
      if positive(tangents.dense(model:tangent())) then stable = middle else unstable = middle end
      model:rollback()
    end
    -- Of order h/R: thick rings are a little stiffer or softer than the beam.
    check.within_share("critical pressure", stable, expected, 0.02)
  end
end)

--- The pressure in a hole of radius a of the incompressible ball (see balloon.lua) or, in plane strain, of the
--- incompressible neo-Hookean tube, by the radial equilibrium of r² = R² + a² - 1.
local outer = 1.5
local function ball_pressure(c01, a)
  local function integral(s) return (2 - 4 * c01) * (-1 / s - 1 / (4 * s^4)) + 4 * c01 * (s - 1 / (2 * s^2)) end
  return integral(a) - integral((1 + (a^3 - 1) / outer^3) ^ (1 / 3))
end
local function tube_pressure(a)
  local c = a^2 - 1
  local b = math.sqrt(outer^2 + c)
  return math.log(outer / b) + math.log(a) - c / (2 * b^2) + c / (2 * a^2)
end

local function vessel(kind, c01)
  return scenes.model{ kind = kind, loads = loaded "north",
    bodies = { vessel = { patch = sg.shapes.quarter_annulus{ inner = 1, outer = outer }, elements = {6, 2},
        order = "N3", volumetric = "projected",
        material = sg.mooney_rivlin{ c10 = 0.5 - c01, c01 = c01, K = 20000 } } },
    supports = { axis = { on = "west", symmetry = true }, cut = { on = "east", symmetry = true } } }
end

--- The radius of the hole at each row of a run: the force of the gas on the section is p times its projected area.
local function radii(run, kind)
  local p, radius = run:column "gas.pressure", {}
  for i, force in ipairs(run:column "cut.fy") do
    local area = math.abs(force) / p[i]
    radius[i] = kind == "axisymmetric" and math.sqrt(area / pi) or area
  end
  return radius, p
end

check.case("a thick tube is inflated by the pressure of the closed form", function()
  local model = vessel("plane_strain", 0)
  local run = check.completed(model:run({ { steps = 6, gas = 0.36 } }, sg.plain{}))
  local radius, p = radii(run, "plane_strain")
  check.equal(radius[#radius] > 1.7, true)
  for i, a in ipairs(radius) do check.within_share("pressure at a = " .. a, p[i], tube_pressure(a), 1e-3) end
  -- The load has an energy, so its work is the stored energy, up to the trapezoidal rule.
  local energy = model:energy()
  check.within_share("work", energy.work, energy.stored, 0.02)
end)

check.case("balloons are inflated past the limit point by arc length", function()
  -- The Mooney–Rivlin ball hardens again and reaches the target.
  local model = vessel("axisymmetric", 0.05)
  local run = check.completed(model:run({ { steps = 6, gas = 0.56 } }, { arc_length = true }))
  check.equal(model:target "gas"[1], 0.56)
  local radius, p = radii(run, "axisymmetric")
  local peak = 1
  while p[peak + 1] > p[peak] do peak = peak + 1 end
  local valley = peak
  while p[valley + 1] < p[valley] do valley = valley + 1 end
  check.equal(valley > peak and valley < #p, true)
  -- Up to where a tenth of the incompressible ball's pressure changes the volume by 0.1 %
  check.equal(radius[valley] > 3, true)
  for i = 1, valley do check.within_share("pressure", p[i], ball_pressure(0.05, radius[i]), 1e-3) end

  -- The neo-Hookean ball never holds more than at its limit point: increments as long as the user wants.
  model = vessel("axisymmetric", 0)
  check.completed(model:run({ { steps = 8, gas = 0.4 } }, sg.plain{}))
  local greatest, last = 0, nil
  for _ = 1, 12 do
    model:set_target("gas", { 1 })
    check.equal(model:solve_arc{ length = 0.1 }.converged, true)
    model:accept()
    last = model:target "gas"[1]
    greatest = math.max(greatest, last)
    local a = math.sqrt(model:reaction "cut"[2] / last / pi)
    check.within_share("pressure", last, ball_pressure(0, a), 1e-3)
  end
  check.within_share("limit point", greatest, ball_pressure(0, 1.603), 2e-3)
  check.equal(last < 0.95 * greatest, true)
end)

check.case("all linear solvers solve with an unsymmetric load", function()
  local reference
  for _, linear in ipairs { "umfpack", "klu", "reuse", "auto" } do
    local model = kinds["3D"]()
    local run = model:run({ { steps = 2, gas = 0.5 } }, sg.plain{ linear = linear })
    check.equal({ linear, run.failed }, { linear, false })
    reference = reference or model:displacements()
    check.near(model:displacements(), reference, 1e-8)
  end
  local model = scenes.model{ bodies = { body = { material = sg.linear_elastic{ E = 10, nu = 0.3 } } },
    supports = { bed = { on = "south", fix = "xy" } },
    contacts = { roof = { slave = "north", penalty = 10, master = scenes.ceiling(1.05) } },
    loads = { gas = { on = "east", pressure = -1, follower = true } } }
  -- Not by static condensation, although the bodies are linear
  check.completed(model:run({ { steps = 1 } }, sg.plain{}))
  check.fails(function() model:run({ { steps = 1, gas = 1 } }, { linear = "condensed" }) end,
    "model:run: linear = \"condensed\"")
end)

check.case("lists of faces, parts, files and the text of a model keep a load that follows", function()
  local unit = sg.shapes.rectangle{ width = 1, height = 1 }
  local halves = scenes.body{ patch = { unit, unit:translate{1, 0}, boundaries = { top = { "1.north", "2.north" },
      ends = { "1.west", "2.east" } } }, material = rubber }
  local function model_of(body, low, ends, top)
    return scenes.model{ bodies = { body = body }, loads = loaded(top),
      supports = { bed = { on = low, fix = "xy" }, ends = { on = ends, fix = "x" } } }
  end
  local joined = model_of(halves, { "1.south", "2.south" }, "ends", "top")
  local whole = model_of({ size = {2, 1}, elements = {4, 2}, material = rubber }, "south", { "west", "east" }, "north")
  for _, model in ipairs { joined, whole } do
    check.completed(model:run({ { steps = 2, gas = 2 } }, sg.plain{}))
  end
  -- C0 at the seam, so that the meshes differ a little
  check.within_share("force", joined:reaction "gas"[2], whole:reaction "gas"[2], 1e-3)
  check.within_share("energy", joined:energy().stored, whole:energy().stored, 1e-2)

  local copy = check.reloaded(joined)
  check.holds(tostring(copy), "; follows the deformation: gas")
  check.equal(copy:reaction "gas", joined:reaction "gas")
  for _, model in ipairs { copy, joined } do
    check.completed(model:run({ { steps = 1, gas = 3 } }, sg.plain{}))
  end
  check.equal(copy:displacements(), joined:displacements())
end)

check.refusals([[
local function model(load) return sg.model{ bodies = { a = a }, loads = { gas = load } } end
]], "study.lua:", {
  { "model{ on = north, traction = {0, 1}, follower = true }", "loads.gas: follower = true is for a pressure",
    "but it has traction" },
  { "model{ on = north, follower = true }", "loads.gas: it must have one of traction" },
  { "model{ on = a, pressure = 1, follower = true }", "loads.gas: it is on the body 'a'", "name a face" },
  { "model{ on = { north, north }, pressure = 1, follower = true }", "loads.gas.on lists", "twice" },
  { [[model{ on = a:corner "north-east", pressure = 1, follower = true }]], "a corner has no surface" },
})
