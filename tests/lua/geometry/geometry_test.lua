-- Patches from Lua: every constructor and every method against closed forms. Directions and indices count from 1.

require "check"

local function length(p) return math.sqrt(p[1] ^ 2 + p[2] ^ 2 + (p[3] or 0) ^ 2) end

check.case("a curve from knots and points is its Bernstein polynomial", function()
  local p = sg.nurbs.curve { degree = 2, knots = { 0, 0, 0, 1, 1, 1 }, points = { { 0, 0 }, { 1, 2 }, { 2, 0 } } }
  for _, t in ipairs { 0, 0.25, 0.7, 1 } do check.near(p(t), { 2 * t, 4 * t * (1 - t) }) end
  check.near(p:evaluate(0.25), p { 0.25 })
  check.equal(p:degrees(), { 2 })
  check.equal(p:knots(1), { 0, 0, 0, 1, 1, 1 })
  check.equal(p:weights(), { 1, 1, 1 })
  check.equal(tostring(p), "NURBS curve in 2D: degree 2, elements 1, 3 control points")
end)

check.case("weights make a circle", function()
  local w = math.sqrt(0.5)
  local p = sg.nurbs.curve { degree = 2, knots = { 0, 0, 0, 1, 1, 1 }, points = { { 1, 0 }, { 1, 1 }, { 0, 1 } },
    weights = { 1, w, 1 } }
  for i = 0, 10 do check.near(length(p(i / 10)), 1) end
end)

check.case("surfaces and volumes take one knot vector per direction, points fastest in xi1", function()
  local U = { 0, 0, 1, 1 }
  local s = sg.nurbs.surface { degrees = { 1, 1 }, knots = { U, U },
    points = { { 0, 0 }, { 2, 0 }, { 0, 1 }, { 2, 1 } } }
  check.near(s { 0.25, 0.5 }, { 0.5, 0.5 })
  local points = {}
  for z = 0, 1 do for y = 0, 1 do for x = 0, 1 do points[#points + 1] = { x, 2 * y, 3 * z } end end end
  local v = sg.nurbs.volume { degrees = { 1, 1, 1 }, knots = { U, U, U }, points = points }
  check.near(v { 0.25, 0.5, 0.75 }, { 0.25, 1, 2.25 })
  check.equal(v:points(), points)
end)

check.case("lines, arcs and circles", function()
  check.near(sg.nurbs.line { from = { 0, 1, 2 }, to = { 2, 1, 0 } }(0.5), { 1, 1, 1 })
  local arc = sg.nurbs.arc { center = { 1, 1 }, radius = 2, from = 180, to = 360 }
  check.near(arc(0), { -1, 1 })
  check.near(arc(arc:knots(1)[#arc:knots(1)]), { 3, 1 })
  local circle = sg.nurbs.circle { radius = 0.5, center = { 0, 0, 4 } }
  check.near(circle(0), { 0.5, 0, 4 })
  check.equal(circle:elements(), { 4 })
end)

check.case("ruled, extruded, revolved and Coons patches", function()
  local ring = sg.nurbs.ruled { a = sg.nurbs.circle { radius = 2 }, b = sg.nurbs.circle { radius = 1 } }
  check.near(length(ring { 0.3, 0.5 }), 1.5)
  local box = sg.nurbs.extrude { patch = sg.shapes.rectangle { width = 2, height = 1 }, along = { 0, 0, 3 } }
  check.near(box { 0.5, 0.5, 0.5 }, { 1, 0.5, 1.5 })
  local pipe = sg.nurbs.revolve { patch = sg.nurbs.line { from = { 2, 0, 0 }, to = { 2, 0, 5 } }, angle = 90 }
  local last = pipe:knots(2)[#pipe:knots(2)]
  check.near(pipe { 0.5, last }, { 0, 2, 2.5 })
  local square = sg.nurbs.coons {
    west = sg.nurbs.line { from = { 0, 0 }, to = { 0, 1 } }, east = sg.nurbs.line { from = { 1, 0 }, to = { 1, 1 } },
    south = sg.nurbs.line { from = { 0, 0 }, to = { 1, 0 } }, north = sg.nurbs.line { from = { 0, 1 }, to = { 1, 1 } },
  }
  check.near(square { 0.25, 0.75 }, { 0.25, 0.75 })
end)

check.case("the ready-made shapes have the documented positions", function()
  local function corners(p)
    local first, last = {}, {}
    for d = 1, #p:degrees() do
      local knots = p:knots(d)
      first[d], last[d] = knots[1], knots[#knots]
    end
    return p(first), p(last)
  end
  local a, b = corners(sg.shapes.rectangle { width = 3, height = 1, corner = { 1, 2 } })
  check.near({ a, b }, { { 1, 2 }, { 4, 3 } })
  a, b = corners(sg.shapes.half_annulus { inner = 0.3, outer = 0.5, center = { 0.75, 1.5 } })
  check.near({ a, b }, { { 0.25, 1.5 }, { 1.05, 1.5 } })
  a, b = corners(sg.shapes.quarter_annulus { inner = 1, outer = 2 })
  check.near({ a, b }, { { 0, -2 }, { 1, 0 } })
  a, b = corners(sg.shapes.quarter_annulus { inner = 1, outer = 2, start = 0 })
  check.near({ a, b }, { { 2, 0 }, { 0, 1 } })
  a, b = corners(sg.shapes.block { size = { 6, 4, 2 }, corner = { 1, 1, 1 } })
  check.near({ a, b }, { { 1, 1, 1 }, { 7, 5, 3 } })
  a, b = corners(sg.shapes.half_cylinder_shell { inner = 1, outer = 2, width = 3 })
  check.near({ a, b }, { { -2, 0, 0 }, { 1, 3, 0 } })
  local octant = sg.shapes.sphere_octant { inner = 1, outer = 2 }
  check.near(length(octant { 0.3, 0.6, 0 }), 2)
  local indenter = sg.shapes.spherical_indenter { width = 1, depth = 1, height = 0.6, radius = 2, elements = 4 }
  check.near(indenter { 0.5, 0.5, 1 }[3], 0.6)
  check.near(indenter { 0.5, 0.5, 0 }[3], 0, 1e-2)
end)

check.case("derivatives name their orders and are those of the map", function()
  local p = sg.shapes.quarter_annulus { inner = 1, outer = 2 }
  local all = p:derivatives({ 0.4, 0.5 }, 2)
  check.equal(#all, 6)
  local orders = {}
  for i, d in ipairs(all) do orders[i] = d.orders end
  check.equal(orders, { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 2, 0 }, { 1, 1 }, { 0, 2 } })
  local h = 1e-5
  local ahead, behind = p { 0.4 + h, 0.5 }, p { 0.4 - h, 0.5 }
  for i = 1, 2 do check.near(all[2].value[i], (ahead[i] - behind[i]) / (2 * h), 1e-8) end
end)

check.case("the basis adds up to one and points to control points from 1", function()
  local p = sg.shapes.half_annulus { inner = 1, outer = 2 }:refine { elements = { 6, 2 }, degree = { 3, 2 } }
  local points, xi = p:points(), { 0.37, 0.81 }
  local sum, x, y = 0, 0, 0
  for _, function_ in ipairs(p:basis(xi)) do
    sum = sum + function_.value
    x, y = x + function_.value * points[function_.index][1], y + function_.value * points[function_.index][2]
  end
  check.near(sum, 1)
  check.near({ x, y }, p(xi))
  check.equal(p:basis({ 0, 0 })[1].index, 1)
end)

check.case("insert, elevate and refine keep the shape and the old patch", function()
  local p = sg.shapes.quarter_annulus { inner = 1, outer = 2 }
  local finer = p:insert(1, { 0.25, 0.5 }):elevate(2):elevate(1, 2)
  check.equal(p:degrees(), { 2, 1 })
  check.equal(finer:degrees(), { 4, 2 })
  check.equal(finer:elements(), { 3, 1 })
  check.near(finer { 0.3, 0.4 }, p { 0.3, 0.4 })
  local refined = p:refine { elements = { 8, 3 }, degree = { 4, 2 } }
  check.equal(refined:elements(), { 8, 3 })
  check.equal(refined:degrees(), { 4, 2 })
  check.near(refined { 0.3, 0.4 }, p { 0.3, 0.4 })
  check.equal(sg.nurbs.circle { radius = 1 }:refine { elements = 8, degree = 3 }:degrees(), { 3 })
end)

check.case("grading puts a fraction of the elements into a fraction of the length", function()
  local p = sg.shapes.rectangle { width = 1, height = 1 }
  local q = p:refine { elements = { 2, 10 }, grading = { false, { elements = 0.8, length = 0.1, at = "end" } } }
  local crowded = 0
  for _, knot in ipairs(q:knots(2)) do if knot > 0.9 + 1e-12 and knot < 1 then crowded = crowded + 1 end end
  check.equal(crowded, 7) -- eight elements between 0.9 and 1
  local line = sg.nurbs.line { from = { 0, 0 }, to = { 1, 0 } }
  local graded = line:refine { elements = 10, grading = { elements = 0.5, length = 0.1, at = "start" } }
  check.near(graded:knots(1)[7], 0.1)
end)

check.case("faces, motions and scaling return new patches", function()
  local p = sg.shapes.rectangle { width = 3, height = 1 }
  check.near(p:face "north" (0.5), { 1.5, 1 })
  check.near(p:face "west" (0.5), { 0, 0.5 })
  check.near(p:translate { 1, -1 } { 0, 0 }, { 1, -1 })
  check.near(p:rotate { angle = 90 } { 1, 0 }, { 0, 3 })
  check.near(p:rotate { angle = 180, center = { 1, 0 } } { 0, 0 }, { 2, 0 })
  check.near(p:scale { factor = 2 } { 1, 1 }, { 6, 2 })
  check.near(p:scale { factor = { 1, 3 }, center = { 0, 1 } } { 0, 0 }, { 0, -2 })
  check.near(p { 1, 1 }, { 3, 1 })
  local block = sg.shapes.block { size = { 1, 2, 3 } }
  check.near(block:rotate { angle = 90, axis = { 1, 0, 0 } } { 0, 1, 0 }, { 0, 0, 2 })
end)

check.case("directions run backwards, change places, and mirror images stay right-handed", function()
  local soft = sg.neo_hookean { E = 1, nu = 0.3 }
  local function body(patch, elements)
    return sg.body { patch = patch, elements = elements, order = "N2", material = soft }
  end
  local p = sg.shapes.rectangle { width = 3, height = 1 }
  check.near(p:reverse(1) { 0.25, 0 }, { 2.25, 0 })
  check.near(p:reverse(2) { 0.25, 0 }, { 0.75, 1 })
  check.near(p:swap(1, 2) { 1, 0.5 }, { 1.5, 1 })
  check.fails(function() body(p:reverse(1), { 1, 1 }) end, "not right-handed (Jacobian -3) near (", "patch:reverse(1)")
  body(p:reverse(1):reverse(2), { 1, 1 })
  body(p:swap(1, 2):reverse(1), { 1, 1 })
  check.near(p:mirror { normal = { 2, 0 }, point = { -1, 7 } } { 0, 0 }, { -5, 0 }) -- west is on the left again
  body(p:mirror { normal = { 1, 3 } }, { 1, 1 })
  local shell = sg.shapes.half_cylinder_shell { inner = 1, outer = 2, width = 3 }
  local image = shell:mirror { normal = { 0, 0, 1 } }
  check.near(image:face "front" (({ 0.5, 0.5 }))[3], 1) -- along z its wall runs most
  body(image, { 2, 1, 1 })
end)

check.case("a body says along which directions it is closed", function()
  local function text_of(patch, elements)
    return tostring(sg.body { patch = patch, elements = elements, order = "N2",
      material = sg.neo_hookean { E = 1, nu = 0.3 } })
  end
  local ring = sg.nurbs.ruled { a = sg.nurbs.circle { radius = 2 }, b = sg.nurbs.circle { radius = 1 } }
  check.holds(text_of(ring, { 8, 1 }), "degrees of freedom, closed along xi1, E = 1")
  check.holds(text_of(sg.nurbs.revolve { patch = ring:translate { 3, 0 } }, { 4, 1, 4 }), "closed along xi1 and xi3,")
  check.equal(text_of(sg.shapes.half_annulus { inner = 1, outer = 2 }, { 4, 1 }):find "closed", nil)
end)

check.case("wrong directions and mirrors", function()
  local p = sg.shapes.rectangle { width = 3, height = 1 }
  check.fails(function() sg.nurbs.circle{ radius = 1 }:swap(1, 2) end,
    "patch:swap: a curve has only one parametric direction")
  check.fails(function() p:swap(2, 2) end, "patch:swap: j must be another direction than i", "got the number 2")
  check.fails(function() p:mirror { normal = { 0, 0 } } end, "patch:mirror: normal must not be zero")
  check.fails(function() p:scale { factor = { -1, 1 } } end, "factors must be positive, got -1", "patch:mirror{ normal")
end)

check.case("patches remain valid as long as Lua references them", function()
  local kept = {}
  for i = 1, 200 do
    local p = sg.shapes.rectangle { width = i, height = 1 }
    kept[i] = i % 10 == 0 and p:face "north" or nil
  end
  collectgarbage()
  collectgarbage()
  for i = 10, 200, 10 do check.near(kept[i](1), { i, 1 }) end
  check.equal(getmetatable(kept[10]), false)
end)

check.case("patches that are folded between their Gauss points are an error with the place", function()
  local material = sg.neo_hookean{ E = 1, nu = 0.3 }
  local function body(degrees, points, elements, weights)
    local knots = {}
    for d, p in ipairs(degrees) do
      knots[d] = {}
      for i = 1, 2 * (p + 1) do knots[d][i] = i <= p + 1 and 0 or 1 end
    end
    local patch = #degrees == 2 and sg.nurbs.surface or sg.nurbs.volume
    return sg.body{ patch = patch{ degrees = degrees, knots = knots, points = points, weights = weights },
                    elements = elements, order = "N2", material = material }
  end
  --- Four sides with the corner opposite to (0, 0) at (c, c): the Jacobian there is 2 c − 1.
  local function square(c) return { { 0, 0 }, { 1, 0 }, { 0, 1 }, { c, c } } end
  for _, n in ipairs { 2, 8 } do
    check.fails(function() body({ 1, 1 }, square(0.475), { n, n }) end, "Jacobian")
    check.equal(body({ 1, 1 }, square(0.5), { n, n }):dofs().total, 2 * (n + 2) ^ 2) -- zero at the corner
  end
  check.fails(function() body({ 1, 1 }, square(0.475), { 2, 2 }) end,
    "sg.body: the patch is folded: its Jacobian is -0.05 at (0.475, 0.475), parameters (1, 1)")
  check.fails(function() body({ 1, 1 }, square(0.475), { 2, 2 }, { 1, 1, 1, 2 }) end, "the patch is folded")
  -- In space, and inside a side: a control point of the north side below the others, at 0.9 of the height and less
  local cube = {}
  for _, z in ipairs { 0, 1 } do
    for _, p in ipairs(square(0.475)) do cube[#cube + 1] = { p[1], p[2], z } end
  end
  check.fails(function() body({ 1, 1, 1 }, cube, { 1, 1, 1 }) end, "the patch is folded", "(0.475, 0.475, 0)")
  local function sag(y) return { { 0, 0 }, { 0.5, 0 }, { 1, 0 }, { 0, 0.2 }, { 0.5, y }, { 1, 0.2 } } end
  check.equal(body({ 2, 1 }, sag(-0.19), { 1, 1 }):dofs().total, 2 * 3 * 3) -- the middle is 0.005 high
  check.fails(function() body({ 2, 1 }, sag(-0.21), { 1, 1 }) end, "Jacobian")
end)

check.case("collapsed sides and corners, poles and closed shapes are not folded", function()
  local material = sg.neo_hookean{ E = 1, nu = 0.3 }
  local s = sg.shapes
  local single = { s.polar_disc{ radius = 1 }, s.polar_cylinder{ radius = 1, width = 2 }, s.polar_ball{ radius = 1 },
                   s.ring{ inner = 1, outer = 2 }, s.sphere_octant{ inner = 1, outer = 2 } }
  for _, list in ipairs { s.disc{ radius = 1 }, s.ball{ radius = 1 }, single } do
    for _, patch in ipairs(list) do
      local n = #patch:degrees()
      assert(sg.body{ patch = patch, elements = n == 2 and { 4, 4 } or { 4, 4, 4 },
                      order = ("N%d"):format(math.max(table.unpack(patch:degrees()))), material = material })
    end
  end
end)
