-- volumetric = "projected": Cook's membrane, Lamé's ring, small strains as the limit of large ones, warnings,
-- checkpoints, wrong input.

require "check"

local soft = sg.linear_elastic{ E = 240.565, nu = 0.4999 }

--- Vertical displacement of the upper right corner of Cook's membrane on n × n elements.
local function cook(order, n, volumetric)
  local patch = sg.nurbs.ruled{ a = sg.nurbs.line{ from = { 0, 0 }, to = { 48, 44 } },
                                b = sg.nurbs.line{ from = { 0, 44 }, to = { 48, 60 } } }
  local body = sg.body{ patch = patch, elements = { n, n }, order = order, material = soft, volumetric = volumetric }
  local model = scenes.model{ bodies = { membrane = body }, supports = { wall = { on = "west", fix = "xy" } },
    loads = { shear = { on = "east", traction = { 0, 0 } } } }
  model:run{ { steps = 1, shear = { 0, 6.25 } } }
  return model:sample("membrane", "uy", { 1, 1 })
end

check.case("Cook's membrane locks without the projection only", function()
  -- N4 pointwise on 32 × 32 elements gives 8.03 from below, projected 8.10 from above.
  check.at_most("N1, pointwise", cook("N1", 8), 2.5)
  check.within_share("N1, projected", cook("N1", 8, "projected"), 8.07, 0.07)
  check.at_most("N2, pointwise", cook("N2", 4), 5)
  check.within_share("N2, projected", cook("N2", 4, "projected"), 8.07, 0.01)
  check.within_share("N2, projected", cook("N2", 8, "projected"), 8.07, 0.01)
end)

--- Relative error of the radial displacement of a thick ring under inner pressure against Lamé's closed form, at the
--- points of a grid.
local function ring_error(n, volumetric)
  local nu, inner, outer = 0.4999, 1, 2
  local model = scenes.model{
    bodies = { ring = { patch = sg.shapes.quarter_annulus{ inner = inner, outer = outer }, elements = { n, n },
        material = sg.linear_elastic{ E = 1, nu = nu }, volumetric = volumetric } },
    supports = { below = { on = "west", symmetry = true }, right = { on = "east", symmetry = true } },
    loads = { inside = { on = "north", pressure = 0 } } }
  local pressure = 1e-3 -- strains far below those that invert elements
  model:run{ { steps = 1, inside = pressure } }
  local squares, exact = 0, 0
  for i = 0, 40 do
    for k = 0, 40 do
      local r = outer - (outer - inner) * k / 40
      local u = (1 + nu) * pressure * inner ^ 2 / (outer ^ 2 - inner ^ 2) * ((1 - 2 * nu) * r + outer ^ 2 / r)
      local xi = { i / 40, k / 40 }
      local found = math.sqrt(model:sample("ring", "ux", xi) ^ 2 + model:sample("ring", "uy", xi) ^ 2)
      squares, exact = squares + (found - u) ^ 2, exact + u ^ 2
    end
  end
  return math.sqrt(squares / exact)
end

check.case("Lamé's ring converges with the optimal rate", function()
  local coarse, fine = ring_error(8, "projected"), ring_error(16, "projected")
  check.within("rate", math.log(coarse / fine, 2), 3, 0.2)
  check.at_most("error, relative to that of the locking ring", coarse / ring_error(8, "pointwise"), 0.02)
end)

--- A block in uniaxial tension.
local function block(options)
  local body = scenes.body{ elements = { 3, 3 }, order = options.order or "N2", nu = 0.4999,
    volumetric = options.volumetric or "projected" }
  local supports = { left = { on = body:face "west", symmetry = true },
                     low = { on = body:face "south", symmetry = true },
                     pull = { on = body:face "east", drive = "x" } }
  return sg.model{ bodies = { block = body }, supports = supports, kind = options.kind }, body
end

--- A quarter of a thick ring under inner pressure; kind "axisymmetric": of the section of a ball, "solid": a tube
--- whose ends do not move. The volume change is far from uniform on its few elements, which lock without projection.
local function ring(kind, material, pressure, volumetric)
  local patch, space = sg.shapes.quarter_annulus{ inner = 1, outer = 2 }, kind == "solid"
  if space then patch = sg.nurbs.extrude{ patch = patch, along = { 0, 0, 0.5 } } end
  local body = scenes.body{ patch = patch, elements = space and { 2, 2, 1 } or { 4, 4 }, material = material,
    volumetric = volumetric or "projected" }
  local supports = { below = { on = body:face "west", symmetry = true },
                     right = { on = body:face "east", symmetry = true } }
  if space then supports.ends = { on = { body:face "front", body:face "back" }, fix = "z" } end
  local model = scenes.model{ bodies = { ring = body }, kind = not space and kind or nil, supports = supports,
                          loads = { gas = { on = "north", pressure = 0 } } }
  check.completed(model:run({ { steps = 1, gas = pressure } }, { newton = { tolerance = 1e-13 } }))
  return model
end

check.case("small pressure: neo-Hooke and linear elasticity have the same state and energy", function()
  local E, nu, pressure = 1, 0.4999, 1e-6
  for _, kind in ipairs { "plane_strain", "axisymmetric", "solid" } do
    local large = ring(kind, sg.neo_hookean{ E = E, nu = nu }, pressure)
    local small = ring(kind, sg.linear_elastic{ E = E, nu = nu }, pressure)
    local locked = ring(kind, sg.linear_elastic{ E = E, nu = nu }, pressure, "pointwise")
    for _, xi in ipairs { { 0.3, 0.4, 0.6 }, { 0.5, 0.9, 0.2 } } do
      local function at(model, field) return model:sample("ring", field, kind == "solid" and xi or { xi[1], xi[2] }) end
      for _, field in ipairs { "ux", "uy", "sxx", "pressure", "von_mises" } do
        -- Rounding of F in neo-Hooke's stress: 1e-16 over strains of 1e-6, times lambda/mu = 5000, is 5e-7 of the
        -- pressure, of which sxx is 0.07 at one point: 7e-6. The difference there is 1.2e-5 with UMFPACK.
        check.within_share(kind .. " " .. field, at(large, field), at(small, field), 3e-5)
      end
      local ratio = at(locked, "pressure") / at(small, "pressure")
      if math.abs(ratio - 1) < 0.1 then error("the projection has no effect: " .. ratio) end
    end
    -- Rounding: the energy of neo-Hooke, about 1e-12, is a difference of terms with a rounding error of 1e-16.
    check.within_share(kind .. " energy", large:energy().stored, small:energy().stored, 1e-4)
    check.at_most(kind .. " locked energy", locked:energy().stored / small:energy().stored, 0.95)
  end
end)

check.case("only bodies that lock are warned of, and print shows the projection", function()
  local locked, body = block{ order = "N1", volumetric = "pointwise" }
  local run = locked:run{ { steps = 1, pull = { 0.01 } } }
  check.holds(run.warnings[1], "lock", 'volumetric = "projected"')
  check.holds(tostring(body), "degree 1 x 1")
  local model, free = block{ order = "N1" }
  check.equal(#model:run{ { steps = 1, pull = { 0.01 } } }.warnings, 0)
  check.holds(tostring(free), "projected volume change")
end)

check.case("a loaded model continues with its projection", function()
  local material = sg.neo_hookean{ E = 1, nu = 0.4999 }
  local model = ring("plane_strain", material, 0.01)
  local again = check.reloaded(model)
  local function compare()
    for _, field in ipairs { "ux", "sxx", "pressure" } do
      check.equal(again:sample("ring", field, { 0.3, 0.4 }), model:sample("ring", field, { 0.3, 0.4 }))
    end
    check.equal(again:energy().stored, model:energy().stored)
  end
  compare()
  for _, one in ipairs { model, again } do one:run{ { steps = 1, gas = 0.02 } } end
  compare()
  local locked = ring("plane_strain", material, 0.01, "pointwise")
  check.at_most("energy of the locked ring", locked:energy().stored / model:energy().stored, 0.9)
end)

--- A rigid cylinder in the middle of a slab: the lateral part of its force, and the motion of both ends of the surface.
local function pressed(order, elements)
  local tool = sg.rigid.cylinder{ center = { 0, 0.5 }, radius = 0.5 }
  local model = scenes.model{
    bodies = { s = { size = {3, 1}, corner = { -1.5, -1 }, elements = elements, order = order, volumetric = "projected",
        nu = 0.4999 } },
    supports = { bed = { on = "south", fix = "xy" }, tool = { on = tool, drive = "y" } },
    contacts = { c = { slave = "north", master = tool, penalty = 50 } } }
  assert(not model:run{ { steps = 2, tool = -0.1 } }.failed)
  local force = model:reaction "tool"
  return force.fx / force.fy, model:sample("s", "ux", { 0, 1 }) + model:sample("s", "ux", { 1, 1 })
end

check.case("symmetric scenes have symmetric solutions where the degree does not divide the elements", function()
  for _, mesh in ipairs{ { "N2", { 9, 5 } }, { "N2", { 5, 3 } }, { "N3", { 11, 4 } }, { "N3", { 16, 4 } } } do
    check.near({ pressed(table.unpack(mesh)) }, { 0, 0 }, 1e-10)
  end
end)

check.case("wrong input", function()
  local function body(value) return function() block{ volumetric = value } end end
  check.fails(body "projekted", "volumetric", "projected")
  check.fails(body "F-bar", "volumetric", "pointwise")
  check.fails(body(true), "volumetric")
  check.fails(body(1), "volumetric")
  check.fails(body {}, "volumetric")
  check.fails(function() block{ kind = "plane_stress" } end, "bodies.block", "plane stress", "Hint")
end)
