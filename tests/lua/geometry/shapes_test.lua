-- Shapes of share/doc/use/shapes.md: its listings, wrong arguments, bodies of closed and polar shapes of one patch.

require "check"

local shapes = sg.shapes

check.case("the page's listings", function()
  local output, folder = check.page(core.share .. "/doc/use/shapes.md")
  check.holds(output, "5\t1.south 2.south 3.south 4.south")
  local drawn, shown = check.png(folder .. "/shapes.png"), check.png(core.home .. "/share/doc/use/shapes.png")
  check.equal({ drawn.width, drawn.height }, { shown.width, shown.height })
end)

check.case("shapes of several patches name their boundaries", function()
  local cylinder = shapes.cylinder{ radius = 1, width = 2 }
  check.equal(cylinder.boundaries, {
    outer = { "1.front", "2.front", "3.front", "4.front" },
    south = { "1.south", "2.south", "3.south", "4.south", "5.south" },
    north = { "1.north", "2.north", "3.north", "4.north", "5.north" } })
  check.equal(shapes.ball{ radius = 1 }.boundaries,
    { outer = { "1.front", "2.front", "3.front", "4.front", "5.front", "6.front" } })
  check.equal(shapes.torus{ radius = 2, section = 1 }.boundaries, { outer = cylinder.boundaries.outer })
end)

--- The model of a linear elastic body of one patch after a step with the pressure p on `face`.
local function squeezed(patch, elements, face, p, supports)
  local body = sg.body{ patch = patch, elements = elements, order = "N2",
                        material = sg.linear_elastic{ E = 1, nu = 0.25 } }
  local model = sg.model{ bodies = { body = body }, supports = supports(body),
                          loads = { gas = { on = body:face(face), pressure = 0 } } }
  local run = model:run{ { steps = 1, gas = p } }
  check.equal({ run.reason, #run.fallbacks }, { "completed", 0 })
  return model
end

-- Under a pressure on all of its surface a disc or ball shrinks evenly, u = -c p x with c = (1 + nu)(1 - 2 nu)/E in
-- plane strain, (1 - 2 nu)/E for the ball. Any mesh represents these linear functions; what remains is the error of the
-- quadrature of rational functions.
local p = 1e-6

--- The largest error of -u/(c p) at points { xi, x } of a model.
local function largest_error(model, c, points)
  local fields, worst = { "ux", "uy", "uz" }, 0
  for _, at in ipairs(points) do
    for i, x in ipairs(at.x) do
      worst = math.max(worst, math.abs(-model:sample("body", fields[i], at.xi) / (c * p) - x))
    end
  end
  return worst
end

--- Whether errors fall below 1 % and with more than the third order when the mesh is refined once.
local function converges(error_of)
  local coarse, fine = error_of(1), error_of(2)
  check.at_most("error of the fine mesh", fine, 0.01)
  check.at_most("error of the fine mesh", fine, coarse / 2^3)
end

check.case("a polar disc shrinks evenly", function()
  converges(function(n)
    local model = squeezed(shapes.polar_disc{ radius = 1 }, { 4 * n, 2 * n }, "south", p, function(body)
      return { center = { on = body:corner "west-north", fix = "xy" },
               top = { on = body:corner "west-south", fix = "x" } }
    end)
    return largest_error(model, 0.625, { { xi = { 0.25, 0 }, x = { -1, 0 } }, { xi = { 0.5, 0 }, x = { 0, -1 } },
                                         { xi = { 1, 0.5 }, x = { 0, 0.5 } } })
  end)
end)

check.case("a polar ball shrinks evenly", function()
  converges(function(n)
    local model = squeezed(shapes.polar_ball{ radius = 1 }, { 4 * n, 2 * n, n }, "front", p, function(body)
      return { axis = { on = body:face "south", fix = "xy" },
               center = { on = body:corner "west-south-back", fix = "z" },
               meridian = { on = body:edge "west-front", fix = "y" } }
    end)
    return largest_error(model, 0.5, { { xi = { 0, 0.5, 0 }, x = { 1, 0, 0 } },
                                       { xi = { 0.25, 0.5, 0.5 }, x = { 0, 0.5, 0 } },
                                       { xi = { 0.5, 1, 0 }, x = { 0, 0, -1 } } })
  end)
end)

check.case("wrong arguments are errors at the call", function()
  local function refused(name, arguments, ...)
    local ok, message = pcall(shapes[name], arguments)
    check.equal({ name, ok }, { name, false })
    check.holds(message, "shapes_test.lua:", name, ...)
  end
  refused("disc", { radius = 1, center = { 0, 0, 0 } }, "center must be a list of 2 numbers")
  refused("polar_disc", { radius = 1e-30, center = { 1, 0 } }, "lost in rounding error next to center x = 1")
  refused("ring", { inner = 2, outer = 1 }, "inner must be below outer, 1, got 2")
  refused("torus", { radius = 1, section = 1 }, "section must be below radius, 1")
  refused("polar_ball", { radius = "1" }, "remove the quotes")
  refused("hook", { length = 1, thickness = 1, nose = 1, land = 1, insertion = 90 }, "insertion must be an angle")
  refused("hook", { length = 1, thickness = 1, nose = 1, land = 1, retention = 120 }, "retention must be an angle")
end)

check.case("pictures refuse lists with other names", function()
  local disc = shapes.disc{ radius = 1 }
  disc.boundaries = { outer = 3 }
  local _, message = pcall(sg.picture, { patch = disc })
  check.holds(message, "patch.boundaries.outer must be a list of at least one string")
  disc.boundaries, disc.edges = nil, {}
  _, message = pcall(sg.picture, { patch = disc })
  check.holds(message, "patch: unknown argument 'edges'")
end)
