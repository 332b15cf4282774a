-- sg.picture and sg.sheet of solids: what changes a picture, symmetric models, cuts, and what they refuse.

require "check"

local folder = check.folder()

local file = folder .. "/picture.png"

--- Width, height and bytes of the PNG file that these arguments draw.
local function draw(arguments)
  arguments.file = file
  arguments.size = arguments.size or { 200, 160 }
  sg.picture(arguments)
  return check.png(file)
end

local function drawn_alike(a, b) return draw(a).bytes == draw(b).bytes end

--- A block whose back is pressed by an obstacle.
local function pressed(size, corner, supports, obstacle, depth)
  local block = scenes.body{ size = size, corner = corner, elements = { 4, 2, 2 }, contact = "back" }
  local all = { bed = { on = block:face "front", fix = "xyz" }, tool = { on = obstacle, drive = "z" } }
  for name, support in pairs(supports) do all[name] = { on = block:face(support[1]), fix = support[2] } end
  local model = scenes.model{ bodies = { block = block }, supports = all,
    contacts = { touch = { slave = "back", master = obstacle, penalty = 20 } } }
  check.equal(model:run({ { name = "press", steps = 2, tool = { -depth } } }).failed, false)
  return model
end

local function ball(x, y) return sg.rigid.sphere{ center = { x, y, 1.8 }, radius = 0.8 } end

local model = pressed({ 2, 1, 1 }, { 0, 0, 0 }, {}, ball(1.2, 0.4), 0.15)

check.case("every option changes the picture", function()
  local seen = {}
  local variants = {
    {}, { field = "uz" }, { field = "syz" }, { field = "contact_pressure" }, { field = "uz", factor = 2 },
    { field = "uz", label = "lift" }, { field = "uz", range = { -1, 0 } }, { deformed = false }, { undeformed = true },
    { mesh = false }, { control_points = true }, { obstacles = false }, { title = "pressed" },
    { mirror = "x" }, { mirror = "z" }, { mirror = "xyz" },
    { camera = "front" }, { camera = "back" }, { camera = "left" }, { camera = "right" }, { camera = "top" },
    { camera = "bottom" }, { camera = { from = { 1, -1, 3 } } }, { camera = { from = { 1, -1, 3 }, up = { 1, 0, 0 } } },
    { cut = "x" }, { cut = "-x" }, { cut = { normal = "x", at = 0.3 } }, { cut = { normal = { 1, -1, 0.2 } } },
    { cut = { normal = { 1, -1, 0.2 }, point = { 0.5, 0.5, 0.5 } } }, { crop = { 0, 1, 0, 1, 0, 1 } },
    { marks = { { x = { 1, 0.5, 0.5 } } } }, { marks = { { x = { 1, 0.5, 0.7 } } } },
  }
  for i, variant in ipairs(variants) do
    variant.model = model
    local bytes = draw(variant).bytes
    if seen[bytes] then error(("variants %d and %d look alike"):format(seen[bytes], i)) end
    seen[bytes] = i
  end
end)

check.case("gray bodies have no field, also where they are cut", function()
  for _, view in ipairs { {}, { cut = "x" } } do
    for _, field in ipairs { "uz", "contact_pressure" } do
      assert(drawn_alike({ model = model, field = field, gray = { "block" }, cut = view.cut },
                         { model = model, cut = view.cut }))
    end
  end
end)

check.case("two fields of a solid are drawn side by side", function()
  local pair = draw{ model = model, fields = { "uz", "szz" }, size = 700 }
  check.equal(pair.width > 1.5 * pair.height, true)
end)

check.case("obstacles and reference shapes do not change the colors of a field", function()
  local above = { model = model, field = "szz", camera = "top", crop = { 1, 1.4, 0.3, 0.5, 0, 1.2 } }
  local function drawn_with(key, value)
    above.obstacles, above.undeformed = false, false
    if key then above[key] = value end
    return draw(above).bytes
  end
  local bare = drawn_with()
  check.equal(drawn_with("obstacles", true) == bare, true)
  check.equal(drawn_with("undeformed", true) == bare, true)
  -- The ball's outline lies over the field
  above.crop = { 0.3, 1, 0.3, 0.5, 0, 1.2 }
  check.equal(drawn_with("obstacles", true) == drawn_with("obstacles", false), false)
end)

check.case("equivalent arguments give the same picture", function()
  local m = model
  check.equal(drawn_alike({ model = m }, { model = m }), true)
  check.equal(drawn_alike({ model = m }, { model = m, camera = "iso", bodies = { "block" } }), true)
  check.equal(drawn_alike({ model = m, camera = "front" }, { model = m, camera = { from = { 0, -2, 0 } } }), true)
  check.equal(drawn_alike({ model = m, camera = "top" }, { model = m, camera = { from = { 0, 0, 1 } } }), true)
  -- The cut face is seen by default
  check.equal(drawn_alike({ model = m, cut = "y" }, { model = m, cut = "y", camera = { from = { 0.75, 1.5, 1 } } }),
    true)
  check.equal(drawn_alike({ model = m, cut = "-z" }, { model = m, cut = "-z", camera = { from = { 0.75, -1.5, -1 } } }),
              true)
  check.equal(drawn_alike({ model = m, cut = "-y" }, { model = m, cut = "-y", camera = "iso" }), true)
  local half = { normal = "-y", at = 0.5 }
  check.equal(drawn_alike({ model = m, field = "szz", cut = half },
                          { model = m, field = "szz", cut = { normal = { 0, -3, 0 }, point = { 7, 0.5, -2 } } }), true)
end)

check.case("a quarter and its images are the whole model, also in a section", function()
  local symmetry = { left = { "west", "x" }, near = { "south", "y" } }
  local quarter = pressed({ 1, 0.5, 1 }, { 0, 0, 0 }, symmetry, ball(0, 0), 0.1)
  local whole
  do
    local shape = sg.shapes.block{ size = { 2, 1, 1 }, corner = { -1, -0.5, 0 } }
    local tool = ball(0, 0)
    whole = scenes.model{ bodies = { block = { patch = shape, elements = { 8, 4, 2 }, contact = "back" } },
      supports = { bed = { on = "front", fix = "xyz" }, tool = { on = tool, drive = "z" } },
      contacts = { touch = { slave = "back", master = tool, penalty = 20 } } }
    check.equal(whole:run({ { name = "press", steps = 2, tool = { -0.1 } } }).failed, false)
  end
  -- A bit of the cut face where no field vanishes; the narrow range leaves two colors, one for each sign. Drawn on the
  -- reference shape, which is the same to the last digit.
  local function picture(of, field, mirror, x, factor)
    return draw{ model = of, field = field, label = field, factor = factor, mirror = mirror, deformed = false,
                 cut = { normal = "-y", at = -0.2 }, obstacles = false, range = { -1e-6, 1e-6 }, camera = "front",
                 bar = false,
                 crop = { x - 0.02, x + 0.02, -0.21, -0.19, 0.62, 0.66 } }.bytes
  end
  for _, field in ipairs { "ux", "uz", "sxy", "sxz", "F32" } do
    local right = picture(whole, field, nil, -0.35)
    check.equal(picture(quarter, field, "xy", -0.35) == right, true)
    check.equal(picture(quarter, field, "xy", -0.35, -1) == right, false)
  end
  check.equal(drawn_alike({ model = quarter, mirror = "xy", mesh = false, obstacles = false, deformed = false },
                          { model = whole, mesh = false, obstacles = false, deformed = false }), true)
end)

check.case("pictures of solids share a sheet and keep their cut and camera", function()
  local function draw_sheet(arguments)
    arguments.file, arguments.size = file, 500
    sg.sheet(arguments)
    return check.png(file)
  end
  local first = sg.picture{ model = model, field = "uz", title = "whole" }
  local second = sg.picture{ model = model, field = "uz", title = "open", cut = "-y", undeformed = true }
  check.holds(tostring(second), "picture 'open' of 1 body", "u_z")
  local row, column = draw_sheet{ first, second, columns = 2 }, draw_sheet{ first, second, columns = 1 }
  check.equal(row.width / row.height > 1.5 * column.width / column.height, true)
  local front = sg.picture{ model = model, field = "uz", title = "open", cut = "-y", camera = "front" }
  check.equal(draw_sheet{ first, front, columns = 2 }.bytes == row.bytes, false)
end)

check.case("a film around a model has frames of one size", function()
  local turns = {}
  for i = 1, 3 do
    turns[i] = sg.picture{ model = model, field = "uz", size = { 200, 160 },
                           camera = { from = { math.cos(i), math.sin(i), 0.5 } } }
  end
  sg.film{ turns, file = folder .. "/turn-%d.png" }
  local first, last = check.png(folder .. "/turn-1.png"), check.png(folder .. "/turn-3.png")
  check.equal({ first.width, first.height }, { last.width, last.height })
  check.equal(first.bytes == last.bytes, false)
end)

check.case("poles and layers of all kinds can be drawn", function()
  local trough = sg.shapes.half_cylinder_shell{ inner = 0.6, outer = 0.9, width = 1, center = { 3, 0, 0 } }
  local bowl = sg.rigid.surface(sg.shapes.sphere_octant{ inner = 1.05, outer = 2 }:face "back")
  local scene = scenes.model{
    bodies = { octant = { patch = sg.shapes.sphere_octant{ inner = 0.3, outer = 1 }, elements = { 3, 3, 2 },
        order = "N2-N2.1", contact = "front" },
      shell = { patch = trough, elements = { 4, 2, 1 }, order = { "N2-N4", "N2" }, contact = "front" } },
    supports = { hold = { on = { "octant.back", "shell.back" }, fix = "xyz" } },
    contacts = { bowl = { slave = "octant.front", master = bowl, penalty = 10 } } }
  -- Stresses at a pole are those close by: the state is at rest and all of it has one color.
  local function picture(more)
    return draw{ model = scene, field = "von_mises", cut = more.cut, bodies = more.bodies, obstacles = more.obstacles,
                 ruler = more.ruler, unit = more.unit }
  end
  local all = picture{}
  check.equal(picture{ cut = "x" }.bytes == all.bytes, false)
  check.equal(picture{ bodies = { "shell" } }.bytes == all.bytes, false)
  check.equal(picture{ obstacles = false }.bytes == all.bytes, false)
  check.equal(picture{ ruler = false }.bytes == all.bytes, false)
  check.equal(picture{ unit = "mm" }.bytes == all.bytes, false)
  check.equal(picture{ unit = "mm", ruler = false }.bytes == picture{ ruler = false }.bytes, true)
  check.equal(picture{ bodies = { "octant", "shell" } }.bytes == all.bytes, true)
end)

check.case("wrong arguments", function()
  local plane = scenes.model{ bodies = { strip = { contact = "north" } }, contacts = {},
    supports = { foot = { on = "south", fix = "xy" } } }
  local wrong = {
    { { model = model, field = "w" }, "unknown field 'w'", "uz", "contact_pressure" },
    { { model = plane, field = "contact_pressures" }, "unknown field" },
    { { model = model, mirror = "zz" }, "mirror must be 'x', 'y', 'z'" },
    { { model = model, camera = "above" }, "camera must be 'iso'", "'above'" },
    { { model = model, camera = { eye = { 1, 0, 0 } } }, "camera: unknown argument 'eye'", "from, up" },
    { { model = model, camera = { from = { 0, 0, 0 } } }, "camera.from must be a vector that is not zero" },
    { { model = model, camera = { from = { 0, 0, 1 }, up = { 0, 0, 2 } } },
      "up of the camera must not be parallel to from" },
    { { model = model, cut = "w" }, "cut must be 'x'" },
    { { model = model, cut = { normal = { 0, 0, 0 } } }, "cut.normal must be a vector that is not zero" },
    { { model = model, cut = { normal = { 0, 1, 0 }, at = 2 } }, "cut: at needs an axis" },
    { { model = model, cut = { normal = "y", at = 2, point = { 0, 0, 0 } } }, "both at and point" },
    { { model = model, cut = { normal = "y", at = -1 } }, "removes all bodies" },
    { { model = model, crop = { 0, 1, 0, 1 } }, "crop must be a list of 6 numbers" },
    { { model = model, crop = { 0, 1, 0, 1, 1, 0 } }, "expected {xmin, xmax, ymin, ymax, zmin, zmax}" },
    { { model = model, crop = { 5, 6, 5, 6, 5, 6 } }, "crop = {5, 6, 5, 6, 5, 6} shows nothing", "x = ", "y = ",
      "z = 0 … 1" },
    { { model = model, inset = { 5, 6, 5, 6, 5, 6 } }, "inset = {5, 6, 5, 6, 5, 6} shows nothing" },
    { { model = model, inset = { 1, 0, 0, 1, 0, 1 } }, "inset is {1, 0, 0, 1, 0, 1}; expected {xmin, xmax" },
    { { model = model, cut = { normal = "x", at = 5 } }, "cut removes nothing: the bodies are within x = ",
      "z = 0 … 1" },
    { { model = model, cut = { normal = { 0, 0, -1 }, point = { 0, 0, -1 } } }, "cut removes nothing" },
    { { model = model, marks = { { x = { 1, 2 } } } }, "marks[1].x must be a list of 3 numbers {x, y, z}" },
    { { model = model, bodies = { "slab" } }, "no body 'slab'", "'block'" },
    { { model = model, bodies = {} }, "bodies must be a list of at least one name" },
    { { model = plane, camera = "iso" }, "camera is for models of solids" },
    { { model = plane, ruler = true }, "ruler is for models of solids" },
    { { model = plane, cut = "y" }, "cut is for models of solids" },
  }
  for _, case in ipairs(wrong) do check.fails(function() draw(case[1]) end, "sg.picture", table.unpack(case, 2)) end
  local flat, solid = sg.picture{ model = plane }, sg.picture{ model = model }
  sg.sheet{ solid, flat, file = file, size = 500 }
  check.equal(check.png(file).width > check.png(file).height, true)
  check.fails(function() sg.film{ solid, flat, file = folder .. "/x-%d.png" } end,
    "sg.film: the pictures of a film must have the same contents and arrangement")
end)
