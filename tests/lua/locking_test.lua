-- volumetric = "projected": Cook's membrane, Lamé's ring, a block in tension, warnings, checkpoints, wrong input.

local sg = require "signorini"
local check = require "check"

local soft = sg.linear_elastic{ E = 240.565, nu = 0.4999 }

--- Vertical displacement of the upper right corner of Cook's membrane on n × n elements.
local function cook(order, n, volumetric)
  local patch = sg.nurbs.ruled{ a = sg.nurbs.line{ from = { 0, 0 }, to = { 48, 44 } },
                                b = sg.nurbs.line{ from = { 0, 44 }, to = { 48, 60 } } }
  local body = sg.body{ patch = patch, elements = { n, n }, order = order, material = soft, volumetric = volumetric }
  local model = sg.model{ bodies = { membrane = body },
                          supports = { wall = { on = body:face "west", fix = "xy" } },
                          loads = { shear = { on = body:face "east", traction = { 0, 0 } } } }
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
  local body = sg.body{ patch = sg.shapes.quarter_annulus{ inner = inner, outer = outer }, elements = { n, n },
                        order = "N2", material = sg.linear_elastic{ E = 1, nu = nu }, volumetric = volumetric }
  local model = sg.model{ bodies = { ring = body },
                          supports = { below = { on = body:face "west", symmetry = true },
                                       right = { on = body:face "east", symmetry = true } },
                          loads = { inside = { on = body:face "north", pressure = 0 } } }
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

--- A block in uniaxial tension, in the plane or in 3D.
local function block(options)
  local space = options.space
  local body = sg.body{
    patch = space and sg.shapes.block{ size = { 1, 1, 1 } } or sg.shapes.rectangle{ width = 1, height = 1 },
    elements = space and { 2, 2, 2 } or { 3, 3 }, order = options.order or "N2", contact = options.contact,
    material = options.material or sg.neo_hookean{ E = 1, nu = 0.4999 }, volumetric = options.volumetric or "projected",
  }
  local supports = { left = { on = body:face "west", symmetry = true },
                     low = { on = body:face "south", symmetry = true },
                     pull = { on = body:face "east", drive = "x" } }
  if space then supports.front = { on = body:face "front", symmetry = true } end
  return sg.model{ bodies = { block = body }, supports = supports, kind = options.kind }, body
end

check.case("stress, energy and force agree in uniaxial tension", function()
  for _, space in ipairs { false, true } do
    local model = block{ space = space }
    local run = model:run({ { steps = 4, pull = { 0.2 } } }, { newton = { tolerance = 1e-12 } })
    check.equal(run.failed, false)
    local middle = space and { 0.5, 0.5, 0.5 } or { 0.5, 0.5 }
    check.within("lateral stress", model:sample("block", "syy", middle), 0, 1e-8)
    -- in tension the work of the support is the stored energy; the trapezoidal rule over four steps
    check.within_share("energy", model:energy().stored, model:energy().work, 0.02)
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
  local model = block{}
  model:run{ { steps = 1, pull = { 0.1 } } }
  local file = check.folder() .. "/locking.sgn"
  model:save(file)
  local again = sg.load(file)
  for _, field in ipairs { "ux", "sxx", "pressure" } do
    check.equal(again:sample("block", field, { 0.3, 0.4 }), model:sample("block", field, { 0.3, 0.4 }))
  end
end)

check.case("wrong input", function()
  local function body(value)
    return function() block{ volumetric = value } end
  end
  check.fails(body "projekted", "volumetric", "projected")
  check.fails(body "F-bar", "volumetric", "pointwise")
  check.fails(body(true), "volumetric")
  check.fails(body(1), "volumetric")
  check.fails(body {}, "volumetric")
  check.fails(function() block{ kind = "plane_stress" } end, "bodies.block", "plane stress", "Hint")
end)

check.done()
