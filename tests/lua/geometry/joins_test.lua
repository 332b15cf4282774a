-- Joined faces: a body cut in two and joined is the uncut one, in 2D, axisymmetric and 3D, in all orientations; corners
-- where several joins meet; faces that do not match are tied.

require "check"

local function solved(model, stages) return check.completed(model:run(stages, sg.plain{})) end

--- The largest difference between a body of the first model and bodies of the second one at points that both contain.
--- pieces: lists { name, map from the uncut body's coordinates }, by halves of xi1.
local function difference(uncut, joined, pieces, dimension)
  local largest = 0
  for i = 1, 8 do
    for j = 1, 4 do
      local xi = { (i - 0.5) / 8, j / 5, dimension == 3 and 0.3 or nil }
      local piece = pieces[i <= 4 and 1 or 2]
      local own = { 2 * xi[1] - (i <= 4 and 0 or 1), xi[2], xi[3] }
      local there = piece.map and piece.map(own) or own
      for _, field in ipairs { "ux", "uy", "sxx", "sxy" } do
        largest = math.max(largest, math.abs(uncut:sample("whole", field, xi)
          - joined:sample(piece.name, field, there)))
      end
    end
  end
  return largest
end

--- A beam of two squares with a C0 line in the middle, or the two squares joined. `turn` changes the second patch and
--- returns it with the face at the seam and the opposite one.
local function beam(kind, cut, turn)
  local flat = kind ~= "solid"
  local function block(x, width)
    return flat and sg.shapes.rectangle{ width = width, height = 1, corner = { 1 + x, 0 } }
      or sg.shapes.block{ size = { width, 1, 1 }, corner = { x, 0, 0 } }
  end
  local function make(patch, along)
    return scenes.body{ patch = patch, elements = flat and { along, 2 } or { along, 2, 2 } }
  end
  local bodies, joins, left, right
  if cut then
    local patch, seam, opposite = block(1, 1), "west", "east"
    if turn then patch, seam, opposite = turn(patch) end
    local a, b = make(block(0, 1), 2), make(patch, 2)
    bodies, joins = { a = a, b = b }, { seam = { a:face "east", b:face(seam) } }
    left, right = a:face "west", b:face(opposite)
  else
    local whole = make(block(0, 2):elevate(1, 1):insert(1, { 0.5, 0.5 }), 4)
    bodies, left, right = { whole = whole }, whole:face "west", whole:face "east"
  end
  local model = sg.model{ bodies = bodies, joins = joins, kind = kind == "axisymmetric" and kind or nil,
    supports = { bed = { on = left, fix = flat and "xy" or "xyz" },
                 grip = { on = right, drive = flat and "xy" or "xyz" } } }
  solved(model, { { name = "pull", steps = 2, grip = flat and { 0.2, 0.3 } or { 0.2, 0.3, 0.1 } } })
  return model
end

--- Patches with other parametric directions than block(1, 1), right-handed; `map` of its coordinates.
local turns = {
  plane = {
    { map = function(x) return x end },
    { turn = function(p) return p:reverse(1):reverse(2), "east", "west" end,
      map = function(x) return { 1 - x[1], 1 - x[2] } end },
    { turn = function(p) return p:swap(1, 2):reverse(1), "south", "north" end,
      map = function(x) return { 1 - x[2], x[1] } end },
  },
  solid = {
    { map = function(x) return x end },
    { turn = function(p) return p:reverse(1):reverse(2), "east", "west" end,
      map = function(x) return { 1 - x[1], 1 - x[2], x[3] } end },
    { turn = function(p) return p:reverse(1):reverse(3), "east", "west" end,
      map = function(x) return { 1 - x[1], x[2], 1 - x[3] } end },
    { turn = function(p) return p:reverse(2):reverse(3), "west", "east" end,
      map = function(x) return { x[1], 1 - x[2], 1 - x[3] } end },
    { turn = function(p) return p:swap(2, 3):reverse(2), "west", "east" end,
      map = function(x) return { x[1], 1 - x[3], x[2] } end },
    { turn = function(p) return p:swap(2, 3):reverse(3), "west", "east" end,
      map = function(x) return { x[1], x[3], 1 - x[2] } end },
    { turn = function(p) return p:swap(2, 3):reverse(1), "east", "west" end,
      map = function(x) return { 1 - x[1], x[3], x[2] } end },
    { turn = function(p) return p:swap(2, 3):reverse(1):reverse(2):reverse(3), "east", "west" end,
      map = function(x) return { 1 - x[1], 1 - x[3], 1 - x[2] } end },
  },
}

check.case("a body cut in two and joined deforms like the uncut one, in every orientation", function()
  for kind, list in pairs { plane = turns.plane, axisymmetric = turns.plane, solid = turns.solid } do
    local uncut = beam(kind, false)
    for i, way in ipairs(list) do
      local joined = beam(kind, true, way.turn)
      local pieces = { { name = "a" }, { name = "b", map = way.map } }
      check.at_most(kind .. " " .. i, difference(uncut, joined, pieces, kind == "solid" and 3 or 2), 1e-10)
      for _, support in ipairs { "bed", "grip" } do
        check.near(joined:reaction(support), uncut:reaction(support), 1e-12)
      end
      check.near(joined:energy().stored, uncut:energy().stored, 1e-12)
      check.equal(joined:solver().unknowns, uncut:solver().unknowns)
      assert(tostring(joined):find("seam shares " .. (kind == "solid" and 16 or 4) .. " control points", 1, true),
        tostring(joined))
    end
  end
end)

-- ── Lamé's ring ──────────────────────────────────────────────────────────────────────────────────────────────────────

local inner, outer, young, nu, pressure = 1, 2, 1, 0.3, 0.1

--- Radial displacement of a ring under internal pressure, plane strain.
local function lame(r)
  return (1 + nu) / young * pressure * inner ^ 2 / (outer ^ 2 - inner ^ 2) * ((1 - 2 * nu) * r + outer ^ 2 / r)
end

--- The ring of four patches. The corners on the axes hold it without force. `odd`: elements of the last patch, 0 for
--- those of the others.
local function ring(order, mesh, odd)
  local bodies, joins, names = {}, {}, { "a", "b", "c", "d" }
  for i, name in ipairs(names) do
    bodies[name] = scenes.body{
      patch = sg.shapes.quarter_annulus{ inner = inner, outer = outer }:rotate{ angle = 90 * (i - 1) },
      elements = { 2 * mesh, i == 4 and odd or mesh }, order = order,
      material = sg.linear_elastic{ E = young, nu = nu } }
  end
  for i, name in ipairs(names) do
    joins["seam" .. i] = { bodies[name]:face "east", bodies[names[i % 4 + 1]]:face "west" }
  end
  local function corner(name) return bodies[name]:corner "south-west" end
  local faces = {}
  for i, name in ipairs(names) do faces[i] = bodies[name]:face "north" end
  local model = sg.model{ bodies = bodies, joins = joins,
    supports = { plumb = { on = { corner "a", corner "c" }, fix = "x" },
                 level = { on = { corner "b", corner "d" }, fix = "y" } },
    loads = { gas = { on = faces, pressure = 0 } } }
  solved(model, { { name = "fill", steps = 1, gas = pressure } })
  return model
end

local function lame_error(model)
  local largest = 0
  for k = 1, 4 do
    local name = ("abcd"):sub(k, k)
    for i = 0, 6 do
      for j = 0, 6 do
        local xi = { i / 6, j / 6 }
        local X = sg.shapes.quarter_annulus{ inner = inner, outer = outer }
          :rotate{ angle = 90 * (k - 1) }(xi)
        local r = math.sqrt(X[1] ^ 2 + X[2] ^ 2)
        largest = math.max(largest, math.abs(model:sample(name, "ux", xi) - lame(r) * X[1] / r),
          math.abs(model:sample(name, "uy", xi) - lame(r) * X[2] / r))
      end
    end
  end
  return largest
end

check.case("Lamé's ring of four joined patches converges with the optimal rate", function()
  for order, rate in pairs { N2 = 3, N3 = 4 } do
    local coarse, fine = lame_error(ring(order, 4, 4)), lame_error(ring(order, 8, 8))
    local found = math.log(coarse / fine, 2)
    assert(found > rate - 0.3, ("%s: rate %g of %g to %g"):format(order, found, coarse, fine))
  end
end)

check.case("faces of the ring that do not match are tied, the finer one as slave", function()
  local model = ring("N2", 2, 3)
  local text = tostring(model)
  for _, part in ipairs { "seam1 shares 4 control points", "seam2 shares 4 control points",
                          "seam3 is tied, because the numbers of elements differ",
                          "seam4 is tied, because the numbers of elements differ" } do
    assert(text:find(part, 1, true), text)
  end
  check.equal(model:tie_names(), { "seam3", "seam4" })
  check.at_most("error", lame_error(model), 2e-3)
end)

-- ── Corners and checkpoints ──────────────────────────────────────────────────────────────────────────────────────────

--- Four squares around a point, all joined; the lower ones are held, the upper ones driven.
local function window(moved)
  local bodies = {}
  for i, name in ipairs { "a", "b", "c", "d" } do
    bodies[name] = scenes.body{ corner = { (i - 1) % 2, (i - 1) // 2 } }
  end
  local a, b, c, d = bodies.a, bodies.b, bodies.c, bodies.d
  return sg.model{ bodies = bodies,
    joins = { ab = { a:face "east", b:face "west" }, cd = { c:face "east", d:face "west" },
              ac = { a:face "north", c:face "south" }, bd = { b:face "north", d:face "south" } },
    supports = { bed = { on = { a:face "south", b:face "south" }, fix = "xy" },
                 grip = { on = { c:face "north", d:face "north" }, drive = moved or "xy" } } }
end

check.case("a corner of four bodies is one point; reactions count it once", function()
  local model = window()
  check.equal(model:solver().unknowns, 2 * (7 * 5))
  solved(model, { { name = "shear", steps = 2, grip = { 0.2, 0.1 } } })
  local top, bottom = model:reaction "grip", model:reaction "bed"
  check.near({ top[1] + bottom[1], top[2] + bottom[2] }, { 0, 0 }, 1e-12)
  for _, name in ipairs { "ux", "uy" } do
    local u = model:sample("a", name, { 1, 1 })
    for other, xi in pairs { b = { 0, 1 }, c = { 1, 0 }, d = { 0, 0 } } do
      check.near(model:sample(other, name, xi), u, 1e-15)
    end
  end
end)

check.case("joined models are saved and continued bit by bit", function()
  local file = check.file "joined.sgn"
  local model = window()
  solved(model, { { name = "shear", steps = 1, grip = { 0.1, 0.05 } } })
  model:save(file)
  local again = sg.load(file)
  check.equal(tostring(again), tostring(model))
  for _, one in ipairs { model, again } do solved(one, { { name = "on", steps = 1, grip = { 0.2, 0.1 } } }) end
  check.equal(again:reaction "grip", model:reaction "grip")
end)

check.case("a body joined to a supported one is not unconstrained", function()
  local function pair(supports)
    local function square(x) return scenes.body{ corner = { x, 0 } } end
    local a, b = square(0), square(1)
    return scenes.model{ bodies = { a = a, b = b }, joins = { seam = { a:face "east", b:face "west" } },
                     supports = not supports and {} or { wall = { on = "a.west", fix = "xy" } },
                     loads = { pull = { on = "b.east", traction = { 0.01, 0 } } } }
  end
  check.equal(pair(false):unconstrained_bodies(), { "a", "b" })
  local held = pair(true)
  check.equal(held:unconstrained_bodies(), {})
  solved(held, { { name = "pull", steps = 1, pull = { 0.01, 0 } } })
  check.near(held:reaction "wall", { -0.01, 0 }, 1e-12)
end)

-- ── Layers ───────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("faces that cross the same layer match, others are tied or refused", function()
  local function square(x, order, contact) return scenes.body{ corner = { x, 0 }, order = order, contact = contact } end
  local function joined(a, b)
    return tostring(sg.model{ bodies = { a = a, b = b }, joins = { seam = { a:face "east", b:face "west" } } })
  end
  local layered = square(0, "N2-N4", "north")
  assert(joined(layered, square(1, "N2-N4", "north")):find("seam shares", 1, true))
  -- In the plane a face across the layer has one control point per row, whatever their degrees.
  assert(joined(layered, square(1, "N2", "north")):find("seam shares", 1, true))
  local tied = joined(square(0, "N2"), square(1, "N3"))
  assert(tied:find("seam is tied, because degrees, continuity or weights differ", 1, true), tied)

  local function cube(x, order)
    return scenes.body{ size = { 1, 1, 1 }, corner = { x, 0, 0 }, order = order, contact = "back" }
  end
  assert(joined(cube(0, "N2-N3"), cube(1, "N2-N3")):find("seam shares", 1, true))
  local ok, message = pcall(joined, cube(0, "N2-N3"), cube(1, "N2"))
  check.equal(ok, false)
  check.holds(message, "joins.seam", "do not match, because degrees, continuity or weights differ",
    "face 'east' of body 'a' crosses a layer")
end)

-- ── Errors ───────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("joins that contradict each other are errors that name the faces", function()
  local function square(x) return scenes.body{ corner = { x, 0 } } end
  local a, b, c = square(0), square(1), square(1)
  local function refused(joins, ties, ...)
    local ok, message = pcall(sg.model, { bodies = { a = a, b = b, c = c }, joins = joins, ties = ties })
    check.equal(ok, false)
    check.holds(message, ...)
  end
  local east, west = a:face "east", b:face "west"
  refused({ one = { east, east } }, nil, "joins.one joins face 'east' of body 'a' with itself")
  refused({ one = { east, west }, two = { east, c:face "west" } }, nil, "face 'east' of body 'a'", "joins already")
  local tied = { two = { slave = east, master = c:face "west" } }
  refused({ one = { east, west } }, tied, "joins.one joins face", "ties.two")
  refused({ one = { b:face "west", c:face "west" } }, nil, "joins.one: ", "must face each other")
end)

check.case("loads and springs inside a joined body are errors, on its surface they are not", function()
  local function square(x) return scenes.body{ corner = { x, 0 } } end
  local a, b = square(0), square(1)
  local function model(face, load, spring)
    local supports = { wall = { on = a:face "west", fix = "xy" }, k = spring and { on = face, spring = { 1, 1 } } }
    if load then load.on = face end
    return sg.model{ bodies = { a = a, b = b }, joins = { seam = { a:face "east", b:face "west" } },
                     supports = supports, loads = { p = load } }
  end
  for _, load in ipairs { { pressure = 1 }, { pressure = 1, follower = true }, { traction = { 0, 1 } } } do
    check.fails(function() model(b:face "west", load) end, "loads.p acts on face 'west' of body 'b', which joins.seam "
      .. "joins, so that it lies inside the joined body. Hint: ")
    model({ a:face "north", b:face "north" }, load)
  end
  check.fails(function() model({ a:face "north", a:face "east" }, nil, true) end,
    "the spring of supports.k acts on face 'east' of body 'a', which joins.seam joins")
  model({ a:face "north", b:face "north" }, nil, true)
end)
