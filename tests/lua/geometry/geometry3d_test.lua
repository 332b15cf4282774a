-- Volumes from Lua: shapes, constructions and refinement in 3D against closed forms, and bodies made of them.

require "check"

local function length(p) return math.sqrt(p[1] ^ 2 + p[2] ^ 2 + p[3] ^ 2) end

--- Volume of a patch by Gauss quadrature with 6 points per element and direction; the least Jacobian.
local function volume(patch)
  local nodes = {}
  for t, weight in pairs { [0.2386191860831969] = 0.4679139345726910, [0.6612093864662645] = 0.3607615730481386,
                           [0.9324695142031521] = 0.1713244923791704 } do
    for _, sign in ipairs { -1, 1 } do nodes[#nodes + 1] = { (1 + sign * t) / 2, weight / 2 } end
  end
  local points = {}
  for d = 1, 3 do
    points[d] = {}
    local breaks = {}
    for _, knot in ipairs(patch:knots(d)) do
      if knot ~= breaks[#breaks] then breaks[#breaks + 1] = knot end
    end
    for e = 2, #breaks do
      local from, size = breaks[e - 1], breaks[e] - breaks[e - 1]
      for _, node in ipairs(nodes) do points[d][#points[d] + 1] = { from + size * node[1], size * node[2] } end
    end
  end
  local sum, least = 0, math.huge
  for _, u in ipairs(points[1]) do
    for _, v in ipairs(points[2]) do
      for _, w in ipairs(points[3]) do
        local all = patch:derivatives({ u[1], v[1], w[1] }, 1)
        local a, b, c = all[2].value, all[3].value, all[4].value
        local jacobian = a[1] * (b[2] * c[3] - b[3] * c[2]) - a[2] * (b[1] * c[3] - b[3] * c[1])
          + a[3] * (b[1] * c[2] - b[2] * c[1])
        sum, least = sum + u[2] * v[2] * w[2] * jacobian, math.min(least, jacobian)
      end
    end
  end
  return sum, least
end

check.case("hollow hemispheres: exact radii, the ring on top, full volume, poles where they were asked for", function()
  for _, poles in ipairs { "ends", "bottom" } do
    local p = sg.shapes.hollow_hemisphere { inner = 1, outer = 1.5, center = { 1, 2, 3 }, poles = poles }
    local function from_center(xi)
      local x = p(xi)
      return { x[1] - 1, x[2] - 2, x[3] - 3 }
    end
    for _, at in ipairs { { 0.1, 0.7 }, { 0.55, 0.25 }, { 0.9, 0.4 } } do
      check.near(length(from_center { at[1], at[2], 0 }), 1.5)
      check.near(length(from_center { at[1], at[2], 1 }), 1)
    end
    local content, least = volume(p)
    check.near(content, 2 * math.pi / 3 * (1.5 ^ 3 - 1), 1e-6)
    assert(least > 0)
    check.near(volume(p:refine { elements = poles == "ends" and { 4, 4, 2 } or { 8, 4, 2 } }),
      2 * math.pi / 3 * (1.5 ^ 3 - 1), 1e-9)
    check.near(from_center(poles == "ends" and { 0.5, 0.5, 0 } or { 0.3, 1, 0 }), { 0, 0, -1.5 })
    for _, face in ipairs(poles == "ends" and { "west", "east" } or { "south" }) do
      check.near(p:face(face) { 0.3, 0.4 }[3], 3)
    end
  end
  check.near(sg.shapes.hollow_hemisphere { inner = 1, outer = 2 } { 0, 0.5, 0 }, { -2, 0, 0 })
  check.fails(function() sg.shapes.hollow_hemisphere { inner = 2, outer = 1 } end,
    "inner must be below outer, 1, got 2")
end)

check.case("swept, revolved, ruled and Coons solids have the expected volume", function()
  local quarter = sg.shapes.quarter_annulus { inner = 1, outer = 2, start = 0 }
  check.near(volume(sg.nurbs.extrude { patch = quarter, along = { 0.5, 0, 3 } }), 9 * math.pi / 4, 1e-7)
  -- A square at x = 2 … 3, turned a quarter about z: Pappus
  local square = sg.nurbs.ruled { a = sg.nurbs.line { from = { 2, 0, 0 }, to = { 2, 0, 1 } },
                                  b = sg.nurbs.line { from = { 3, 0, 0 }, to = { 3, 0, 1 } } }
  local ring, least = volume(sg.nurbs.revolve { patch = square, angle = 90 })
  check.near(ring, 2.5 * math.pi / 2, 1e-7)
  assert(least > 0)
  local low = sg.nurbs.surface { degrees = { 1, 1 }, knots = { { 0, 0, 1, 1 }, { 0, 0, 1, 1 } },
                                 points = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 2, 2, 0 } } }
  local high = low:scale { factor = 0.5, center = { 1, 1, 0 } }:translate { 0, 0, 3 }
  check.near(volume(sg.nurbs.ruled { a = low, b = high }), 7, 1e-12) -- frustum: 3/3 (4 + 1 + 2)
  local octant = sg.shapes.sphere_octant { inner = 1, outer = 2 }
  local faces = {}
  for _, name in ipairs { "west", "east", "south", "north", "front", "back" } do faces[name] = octant:face(name) end
  check.near(sg.nurbs.coons(faces) { 0.3, 0.6, 0 }, octant { 0.3, 0.6, 0 })
end)

check.case("refinement of volumes keeps the shape; grading acts direction by direction", function()
  local p = sg.shapes.sphere_octant { inner = 0.2, outer = 1 }
  local crowd = function(at) return { elements = 0.75, length = 0.1, at = at } end
  local q = p:refine { elements = { 4, 16, 8 }, degree = { 3, 2, 2 }, grading = { false, crowd "end", crowd "start" } }
  check.equal(q:elements(), { 4, 16, 8 })
  check.equal(q:degrees(), { 3, 2, 2 })
  for _, xi in ipairs { { 0.2, 0.95, 0.05 }, { 0.8, 0.3, 0.6 } } do check.near(q(xi), p(xi)) end
  local function inside(d, from, to)
    local count = 0
    for _, knot in ipairs(q:knots(d)) do
      if knot > from + 1e-9 and knot < to - 1e-9 then count = count + 1 end
    end
    return count
  end
  check.equal(inside(2, 0.9, 1), 11) -- 12 of 16 elements
  check.equal(inside(3, 0, 0.1), 5)  -- 6 of 8
  check.near(q:knots(1)[5], 0.25)
  check.equal(p:insert(3, { 0.5 }):elevate(3):degrees(), { 2, 2, 2 })
end)

check.case("invalid volumes are errors", function()
  local line = sg.nurbs.line { from = { 0, 0, 0 }, to = { 1, 0, 0 } }
  local square = sg.nurbs.extrude { patch = line, along = { 0, 1, 0 } }
  local cube = sg.nurbs.extrude { patch = square, along = { 0, 0, 1 } }
  check.fails(function() sg.nurbs.extrude { patch = cube, along = { 1, 0, 0 } } end, "got a volume")
  check.fails(function() sg.nurbs.extrude { patch = square, along = { 0, 0, 0 } } end, "along must not be zero")
  check.fails(function() sg.nurbs.revolve { patch = square, angle = 0 } end,
    "angle must be in -360 … 360 degrees and not zero, got 0")
  check.fails(function()
    sg.shapes.spherical_indenter { width = 10, depth = 10, height = 11, radius = 7, elements = 1 }
  end, "so that the sphere reaches the corners, got 7")
  check.fails(function() cube:face "top" end, "west, east, south, north, front, back")
end)

local function solid(patch, elements, order, contact)
  return scenes.body{ patch = patch, elements = elements, order = order, contact = contact }
end

check.case("left-handed and self-intersecting volumes are rejected as bodies", function()
  local square = sg.nurbs.ruled { a = sg.nurbs.line { from = { 2, 0, 0 }, to = { 2, 0, 1 } },
                                  b = sg.nurbs.line { from = { 3, 0, 0 }, to = { 3, 0, 1 } } }
  local cure = "reverse one parametric direction with patch:reverse(1), or untangle the control points"
  local function turned(patch, angle)
    return solid(sg.nurbs.revolve { patch = patch, angle = angle }, { 2, 2, 4 }, "N2")
  end
  assert(turned(square, 90))
  assert(turned(square:translate { -2, 0, 0 }, 360)) -- touches its axis
  check.fails(function() turned(square, -90) end, "sg.body: the patch's map is not right-handed (Jacobian -", cure)
  check.fails(function() turned(square:translate { -2.5, 0, 0 }, 90) end, "the patch's map is not right-handed", cure)
  local flat = sg.nurbs.ruled { a = square, b = square:translate { 1, 0, 0.5 } }
  check.fails(function() solid(flat, { 1, 1, 1 }, "N1") end, "the patch's map is degenerate (Jacobian 0) near (2.42",
    "collapsed to a surface")
  local points = sg.shapes.block { size = { 1, 1, 1 } }:points()
  points[1], points[2] = points[2], points[1]
  local U = { 0, 0, 1, 1 }
  local crossed = sg.nurbs.volume { degrees = { 1, 1, 1 }, knots = { U, U, U }, points = points }
  check.fails(function() solid(crossed, { 1, 1, 1 }, "N1") end, "the patch's map is not right-handed", cure)
  check.fails(function() solid(square, { 1, 1 }, "N1") end, "a volume in 3D")
end)

check.case("conversion between 2D and 3D", function()
  local ring = sg.shapes.quarter_annulus { inner = 1, outer = 2 }
  local raised = ring:to_space { z = 3 }
  check.near(raised { 0.3, 0.5 }[3], 3)
  check.equal(raised:to_plane():points(), ring:points())
  check.equal(ring:to_plane():points(), ring:points())
  check.near(ring:to_space() { 0, 0 }, { 0, -2, 0 })
  check.fails(function() raised:to_space { z = 1 } end, "patch:to_space: the patch is in 3D already",
    "patch:translate")
  check.fails(function() raised:rotate { angle = 30, axis = { 1, 0, 0 } }:to_plane() end,
    "patch:to_plane: all control points must have the same z, but z ranges from 1.59", "to 2.59", "patch:rotate")
  check.fails(function() sg.shapes.block { size = { 1, 1, 1 } }:to_plane() end,
    "patch:to_plane: a volume cannot be converted")
  check.fails(function() solid(raised, { 1, 1 }, "N2") end, "this one is a surface in 3D", "patch:to_plane()")
  local file = check.file()
  raised:write(file, "gismo") -- with geoDim 3
  assert(solid(sg.nurbs.read(file)[1]:to_plane(), { 1, 1 }, "N2"))
  check.fails(function() sg.nurbs.ruled { a = ring, b = raised } end, "dimension 2 and 3", "patch:to_space{ z = 0 }")
end)

check.case("plane patches are swept out of their plane", function()
  local section = sg.shapes.rectangle { width = 1, height = 2, corner = { 3, 0 } }
  local turned = sg.nurbs.revolve { patch = section, angle = 90 }
  check.near(turned { 0, 1, 0 }, { 3, 2, 0 })
  check.near(turned { 0, 1, 1 }, { 0, 2, 3 })
  assert(solid(turned, { 1, 1, 2 }, "N2"))
  check.near(sg.nurbs.revolve { patch = section, point = { 3, 0 }, axis = { 0, -1 }, angle = 90 } { 1, 0, 1 },
    { 3, 0, 1 })
  check.fails(function() sg.nurbs.revolve { patch = section, axis = { 0, 0, 1 } } end,
    "axis must not be normal to the plane of the patch")
  local disc = sg.nurbs.revolve { patch = sg.nurbs.line { from = { 1, 0 }, to = { 2, 0 } }, axis = { 0, 0, 1 },
    angle = 90 }
  check.near(disc { 1, 1 }, { 0, 2, 0 })
  check.fails(function() sg.nurbs.extrude { patch = section, along = { 0, 1 } } end,
    "sg.nurbs.extrude: along must be a list of 3 numbers {x, y, z}", "lies in z = 0", "{0, 0, 1}")
  check.near(sg.nurbs.extrude { patch = section, along = { 0, 0, 5 } } { 1, 1, 1 }, { 4, 2, 5 })
end)

check.case("orders per direction, layers on any face, none across a pole", function()
  local cube = sg.shapes.block { size = { 1, 2, 3 } }
  -- 5, 6 functions of N2 on 3, 4 elements, N2.1 on 3 has 8; 2 + 2 rows of 2 elements through it
  local dofs = solid(cube, { 3, 4, 2 }, { "N2-N2.1", "N2" }, "back"):dofs()
  check.equal({ dofs.interface, dofs.total }, { 3 * 8 * 6, 3 * (8 * 6 + 3 * 5 * 6) })
  dofs = solid(cube, { 2, 3, 4 }, { "N2", "N2-N2.1" }, "west"):dofs()
  check.equal({ dofs.interface, dofs.total }, { 3 * 5 * 10, 3 * (5 * 10 + 3 * 5 * 6) })
  dofs = solid(cube, { 3, 2, 4 }, "N2-N2.1x2", { "south", "north" }):dofs()
  check.equal(dofs.total, 3 * 4 * 8 * 10)
  local half = sg.shapes.hollow_hemisphere { inner = 1, outer = 2 }
  local function alone(body)
    return scenes.model{ bodies = { body = body }, supports = { bed = { on = "front", fix = "xyz" } } }
  end
  assert(alone(solid(half, { 2, 2, 1 }, "N2-N2.2", "front")))
  check.fails(function() alone(solid(half, { 2, 2, 1 }, "N2-N2.2", "west")) end,
    "face 'south' of this body collapses across the layer on contact face 'west'", "or another contact face")
end)

--- The force on a rigid plane that presses a hemisphere supported at its ring.
local function pressed(poles, elements, ring)
  local half = scenes.body{ patch = sg.shapes.hollow_hemisphere { inner = 0.5, outer = 1, poles = poles },
    elements = elements, contact = "front", thickness_degree = 1 }
  local faces = {}
  for i, name in ipairs(ring) do faces[i] = half:face(name) end
  local plane = sg.rigid.plane { point = { 0, 0, -1 }, normal = { 0, 0, 1 } }
  local model = scenes.model{ bodies = { half = half },
    supports = { ring = { on = faces, fix = "xyz" }, tool = { on = plane, fix = "xy", drive = "z" } },
    contacts = { touch = { slave = "front", master = plane, penalty = 100 } } }
  local run = check.completed(model:run { { name = "press", steps = 4, tool = { 0.1 } } })
  return run:column "tool.fz"[4]
end

check.case("hemispheres with either poles converge to one load, whole at their poles and seam", function()
  local function apart(n)
    local ends = pressed("ends", { 4 * n, 4 * n, n }, { "west", "east" })
    return math.abs(pressed("bottom", { 4 * n, 3 * n, n }, { "south" }) / ends - 1)
  end
  local coarse, fine = apart(2), apart(4)
  check.near({ coarse, fine }, { 0, 0 }, 0.03)
  assert(fine < 0.3 * coarse, ("apart by %g, then by %g"):format(coarse, fine))
end)
