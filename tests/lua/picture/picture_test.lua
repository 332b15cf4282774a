-- sg.picture and sg.sheet: what changes a picture, how large it is, and what they refuse.

require "check"

local folder = check.folder()

local file = folder .. "/picture.png"

--- Width, height and bytes of the PNG file that these arguments draw.
local function draw(arguments)
  arguments.file = file
  sg.picture(arguments)
  return check.png(file)
end

--- A sheet of these arguments; it is small, because the time of drawing grows with the number of pixels.
local function sheet_of(arguments)
  arguments.size = arguments.size or 700
  return sg.sheet(arguments)
end

--- Width, height and bytes of the file of this sheet.
local function draw_sheet(arguments)
  arguments.file = file
  sheet_of(arguments)
  return check.png(file)
end

--- A body of this shape, fixed at one face and driven at another.
local function beam(shape, fixed, driven)
  local body = scenes.body{ patch = shape, elements = { 4, 2 }, contact = "south", E = 2 }
  return scenes.model{ bodies = { strip = body }, contacts = {},
    supports = { foot = { on = body:face(fixed), fix = "xy" }, tip = { on = body:face(driven), drive = "xy" } } }
end

local function strip(width, height)
  return beam(sg.shapes.rectangle{ width = width, height = height }, "west", "east")
end

local model = strip(4, 1)
local pictures = { sg.picture{ model = model, field = "uy", title = "start" } }
model:run({ { name = "bend", steps = 2, tip = { 0, 1 } } }, { on_step = function(info)
  pictures[#pictures + 1] = sg.picture{ model = model, field = "uy", title = "step " .. info.step }
end })

check.case("every option changes the picture", function()
  local seen = {}
  local variants = {
    {}, { field = "uy" }, { field = "uy", factor = 0.5 }, { field = "uy", label = "lift" },
    { field = "uy", range = { 0, 2 } }, { field = "uy", colormap = "magma" }, { deformed = false },
    { undeformed = true }, { mesh = false },
    { control_points = true }, { mirror = "x" }, { mirror = "y" }, { mirror = "xy" }, { title = "bent" },
    { crop = { 0, 2, 0, 1 } }, { marks = { { x = { 2, 0.5 } } } }, { marks = { { x = { 2, 0.5 }, text = "here" } } },
    { marks = { { x = { 2, 0.5 } }, { x = { 3, 0.9 } } } }, { axes = { "along", "across" } },
    { field = "uy", contours = true }, { field = "uy", contours = 2 }, { field = "uy", contours = { 0.3, 0.6 } },
    { vectors = "displacement" },
  }
  for i, variant in ipairs(variants) do
    variant.model, variant.size = model, { 400, 300 }
    local drawn = draw(variant)
    check.equal({ drawn.width, drawn.height }, { 400, 300 })
    if seen[drawn.bytes] then error(("variants %d and %d look alike"):format(seen[drawn.bytes], i)) end
    seen[drawn.bytes] = i
    check.equal(draw(variant).bytes == drawn.bytes, true)
  end
end)

check.case("gray bodies have no field", function()
  local size = { 400, 300 }
  check.equal(draw{ model = model, field = "uy", gray = { "strip" }, size = size }.bytes,
              draw{ model = model, size = size }.bytes)
end)

--- A ring or strip that is pressed onto a rigid plane.
local function pressed(kind)
  local made = scenes.model{ kind = kind,
    bodies = { ring = { corner = { 1, 0 }, elements = { 4, 4 }, contact = "south", E = 10 } },
    supports = { lid = { on = "north", drive = "y", fix = "x" } },
    contacts = { ground = { slave = "south", penalty = 100, master = scenes.floor() } } }
  made:run{ { steps = 1, lid = -0.05 } }
  return made
end

check.case("contact pressure is drawn along slave faces, and sampled there", function()
  for _, kind in ipairs { "plane_strain", "axisymmetric" } do
    local made, seen = pressed(kind), {}
    for _, variant in ipairs { {}, { field = "contact_pressure" }, { field = "contact_pressure", deformed = false },
                               { field = "contact_pressure", mirror = "x" } } do
      variant.model, variant.size = made, { 400, 300 }
      local bytes = draw(variant).bytes
      check.equal(seen[bytes], nil)
      seen[bytes] = true
    end
    local profile = made:profile "ground"
    check.equal(#profile.pressure, 36)
    -- The fifth of nine Gauss points is in the middle of its element; between two of them the pressure is linear.
    for element = 1, 4 do
      local at = 9 * (element - 1) + 5
      check.within("pressure", made:sample("ring", "contact_pressure", { (element - 0.5) / 4, 0 }),
        profile.pressure[at], 1e-13)
    end
    check.equal(made:sample("ring", "contact_pressure", { 0, 0 }), profile.pressure[1])
    check.fails(function() return made:sample("ring", "contact_pressure", { 0.5, 0.5 }) end,
      "model:sample: contact_pressure is defined on slave faces only; on this body give xi[2] = 0 (contact 'ground')")
  end
end)

check.case("magnified parts are sampled again where they are curved, also in sheets", function()
  local function drawn(shape, crop)
    local of = scenes.model{ bodies = { ring = { patch = shape, elements = { 2, 1 }, contact = "south", E = 2 } },
      contacts = {}, supports = { hold = { on = "north", fix = "xy" } } }
    local size = { 400, 300 }
    local picture = sg.picture{ model = of, mesh = false, size = size, crop = crop }
    check.equal(draw_sheet{ picture, size = size }.bytes == draw{ model = of, mesh = false, size = size,
                                                                 crop = crop }.bytes, true)
    return picture
  end
  -- The arc is not a polygon: its pixels are those of many short lines
  drawn(sg.shapes.half_annulus{ inner = 0.5, outer = 1 }, { -0.75, -0.65, -0.75, -0.65 }):write(folder .. "/arc.svg")
  local corners = 0
  for path in core.read_file(folder .. "/arc.svg"):gmatch ' d="([^"]*)"' do
    corners = math.max(corners, select(2, path:gsub("L", "")))
  end
  check.equal(corners > 20, true)
  drawn(sg.shapes.rectangle{ width = 1, height = 1 }, { 0.9, 1.1, 0.9, 1.1 })
end)

check.case("components change their sign in the mirror as they do in a model that is the mirror image", function()
  local image = beam(sg.shapes.rectangle{ width = 4, height = 1 }:translate{ -4, 0 }, "east", "west")
  image:run{ { name = "bend", steps = 2, tip = { 0, 1 } } }
  -- Around a point where no field vanishes; the narrow range leaves two colors, one for each sign.
  local xi = { 0.3, 0.8 }
  local x, y = 1.2 + model:sample("strip", "ux", xi), 0.8 + model:sample("strip", "uy", xi)
  local function picture(of, field, side, factor)
    return draw{ model = of, field = field, mirror = "x", mesh = false, factor = factor, label = field,
                 range = { -1e-6, 1e-6 }, size = { 300, 200 },
                 crop = { side * x - 0.05, side * x + 0.05, y - 0.05, y + 0.05 } }.bytes
  end
  for _, field in ipairs { "ux", "uy", "sxx", "sxy", "F12", "F21", "von_mises" } do
    local right = picture(image, field, -1)
    check.equal(picture(model, field, -1) == right, true)
    check.equal(picture(model, field, -1, -1) == right, false)
  end
  check.equal(picture(model, "ux", 1) == picture(image, "ux", 1), true)
end)

check.case("a picture is no larger than its content", function()
  local long, high = strip(200, 10), strip(10, 200)
  local flat = draw{ model = long, field = "uy" }
  check.equal(flat.width, 1600)
  check.equal(flat.height < 420, true)
  local tower = draw{ model = high, field = "uy" }
  check.equal(tower.height, 1000)
  check.equal(tower.width < 440, true)
  check.equal(draw{ model = long, size = 800 }.width, 800)
  check.equal(draw{ model = high, size = 800 }.height, 1600)
  local fixed = draw{ model = long, size = { 800, 600 } }
  check.equal({ fixed.width, fixed.height }, { 800, 600 })
end)

check.case("pictures keep their state and share a sheet", function()
  check.equal(#pictures, 3)
  check.holds(tostring(pictures[2]), "picture 'step 1' of 1 body", "u_y")
  check.equal(tostring(sg.sheet{ pictures, title = "all" }), "sheet 'all' of 3 pictures")
  local sheet, column = draw_sheet{ pictures, columns = 3 }, draw_sheet{ pictures, columns = 1 }
  check.equal(sheet.width / sheet.height > 2 * column.width / column.height, true)
  local alone = draw_sheet{ pictures[1], range = { 0, 1 } }
  model:run{ { name = "back", steps = 1, tip = { 0, 0.2 } } }
  check.equal(draw_sheet{ pictures, columns = 3 }.bytes == sheet.bytes, true)
  check.equal(draw_sheet{ pictures[1], { pictures[2], pictures[3] }, columns = 3 }.bytes == sheet.bytes, true)
  check.equal(draw_sheet{ pictures[1], range = { 0, 1 } }.bytes == alone.bytes, true)
  pictures[1]:write(file)
  check.equal(check.png(file).bytes == alone.bytes, false)
end)

check.case("a sheet has one range of colors for each field, unless each picture has its own", function()
  local uy, ux = pictures[2], sg.picture{ model = model, field = "ux" }
  local large = pictures[3]
  local shared = draw_sheet{ uy, large, columns = 2 }
  check.equal(draw_sheet{ uy, large, columns = 2, range = "own" }.bytes == shared.bytes, false)
  check.equal(draw_sheet{ uy, large, columns = 2, range = { 0, 2 } }.bytes == shared.bytes, false)
  -- Several fields are drawn side by side, each with a bar
  local function bars(arguments)
    arguments.file = folder .. "/bars.svg"
    sheet_of(arguments)
    return select(2, core.read_file(arguments.file):gsub("displacement u", ""))
  end
  check.equal({ bars{ uy, large }, bars{ uy, large, range = "own" }, bars{ uy, ux } }, { 1, 2, 2 })
  check.equal(bars{ sg.sheet{ uy, large }, ux }, 2)
  local mixed = draw_sheet{ uy, sg.chart{ x = { 1, 2 }, { y = { 1, 2 } } }, columns = 2, size = 1200 }
  check.equal({ mixed.width > 1.5 * mixed.height, mixed.width <= 1200 }, { true, true })
end)

check.case("marks accept the places of a failed run, and belong to their picture", function()
  local place = { x = { 2, 0.5 }, X = { 2, 0.4 }, text = "J = -0.2", kind = "inverted", body = "strip",
                  element = { 3, 1 }, contact = "touch", value = -0.2 }
  local marked = draw{ model = model, marks = { place }, size = 400 }
  local alike = draw{ model = model, marks = { { x = { 2, 0.5 }, text = "J = -0.2" } }, size = 400 }
  check.equal(alike.bytes == marked.bytes, true)
  check.equal(draw{ model = model, marks = {}, size = 400 }.bytes == draw{ model = model, size = 400 }.bytes, true)
  local plain = sg.picture{ model = model }
  local sheet = draw_sheet{ plain, sg.picture{ model = model, marks = { place } } }
  check.equal(draw_sheet{ plain, plain }.bytes == sheet.bytes, false)
end)

--- All texts of a picture, one per line.
local function texts(picture)
  picture:write(folder .. "/texts.svg")
  local all = {}
  for line in io.lines(folder .. "/texts.svg") do
    local words = line:match "^<text.->(.*)</text>$"
    if words then all[#all + 1] = words end
  end
  return table.concat(all, "\n")
end

--- How often words stand in a text.
local function count(whole, words) return select(2, whole:gsub(words:gsub("%p", "%%%0"), "")) end

check.case("states have colors of their own, fields share theirs, where that is asked for", function()
  check.equal(count(texts(sheet_of{ pictures }), "max"), 1)
  local own = texts(sheet_of{ pictures, range = "own" })
  check.equal(count(own, "max"), #pictures)
  check.equal({ count(own, "max 0"), count(own, "step 2") }, { 2, 1 }) -- 0 and 0.5…
  local pair = texts(sheet_of{ pictures[2], pictures[3], range = "own", columns = 2 })
  check.equal(count(pair, "2.0"), 4) -- the axes of both go as far
  local function fields(label)
    local pair = {}
    for i, field in ipairs { "ux", "uy" } do pair[i] = sg.picture{ model = model, field = field, label = label } end
    return texts(sheet_of(pair))
  end
  check.equal(count(fields(), "max"), 2)
  check.equal(fields "displacement" == fields():gsub("displacement u_[xy]", "displacement"), false)
end)

check.case("arrows have a key in the unit of lengths, and one scale in a sheet", function()
  local bent = strip(4, 1)
  local arrows = { model = bent, vectors = "displacement", unit = "mm", size = 500 }
  check.holds(texts(sg.picture(arrows)), "displacement: all zero")
  local start = sg.picture(arrows)
  bent:run{ { name = "bend", steps = 2, tip = { 0, 1 } } }
  check.equal(count(texts(sg.picture(arrows)), "displacement 1 mm"), 1)
  check.equal(count(texts(sheet_of{ start, sg.picture(arrows) }), "displacement 1 mm"), 1)
end)

check.case("wrong arguments", function()
  local wrong = {
    { { model = model, field = "uu" }, "unknown field 'uu'" },
    { { model = model, factor = 2 }, "factor has no effect without field or fields" },
    { { model = model, label = "lift" }, "label has no effect without field" },
    { { model = model, size = 20 }, "size must be a whole number from 160 to 5000" },
    { { model = model, size = { 400 } }, "size must be a list of 2 whole numbers" },
    { { model = model, size = "large" }, "size must be" },
    { { model = model, columns = 2 }, "columns has no effect without states or fields" },
    { { model = model, crop = { 0, 1 } }, "crop must be a list of 4 numbers" },
    { { model = model, crop = { 10, 11, 0, 1 } },
      "crop = {10, 11, 0, 1} shows nothing: everything drawn is within x = ", "y = " },
    { { model = model, inset = { 10, 11, 0, 1 } }, "inset = {10, 11, 0, 1} shows nothing" },
    { { model = model, inset = { 1, 0, 0, 1 } }, "inset is {1, 0, 0, 1}; expected {xmin, xmax, ymin, ymax}" },
    { { model = model, crop = { 0, 1, 0, 1 }, inset = { 2, 3, 0, 1 }, size = 1200 },
      "inset is outside of what the picture shows" },
    { { model = model, marks = { { x = { 1, 2 } }, { x = { 1, 2, 3 } } } }, "marks[2].x must be a list of 2 numbers" },
    { { model = model, marks = { { x = { 1, 2 }, txt = "a" } } }, "marks[1]: unknown argument 'txt'", "'text'?" },
    { { model = model, marks = { { x = { 1, 2 } } }, deformed = false }, "marks are in the present state" },
    { { model = model, contours = true }, "contours has no effect without field or fields" },
    { { model = model, field = "uy", contours = false }, "contours must be true, a whole number from 1 to 100 or" },
    { { model = model, field = "uy", contours = 0 }, "contours must be" },
    { { model = model, field = "uy", contours = {} }, "contours must be" },
    { { model = model, field = "uy", contours = { 7 } }, "contours must contain a value of the field" },
    { { model = model, vectors = "traction" }, "needs a contact, and the model has none" },
    { { model = model, vectors = "traction", deformed = false }, "tractions act in the present state" },
    { { model = model, axes = { "x" } }, "axes must be a list of 2 names" },
  }
  for _, case in ipairs(wrong) do check.fails(function() draw(case[1]) end, "sg.picture", table.unpack(case, 2)) end
  check.fails(function() sg.sheet{ {}, title = "none" } end, "sg.sheet: at least one picture is needed")
  check.fails(function() sg.sheet{ pictures, range = "all" } end, "sg.sheet: range must be 'shared' or 'own'")
  check.fails(function() sg.sheet{ pictures, colums = 2 } end, "sg.sheet: unknown argument 'colums'", "'columns'?")
  check.fails(function() pictures[1]:write "a.gif" end, "picture:write: file 'a.gif' of a figure must end in .png")
end)

check.case("the bytes of a picture fit into a given size", function()
  local function size_of(picture, most)
    local bytes = core.picture_bytes(picture, "png", most)
    return { string.unpack(">I4I4", bytes, 17) }
  end
  local state = sg.picture{ model = model, size = { 600, 400 } }
  local chart = sg.chart{ { x = { 1, 2 }, y = { 1, 4 } }, size = { 800, 400 } }
  check.equal({ table.unpack(size_of(state), 1, 2) }, { 600, 400 })
  local width, height = table.unpack(size_of(state, { 300, 300 }))
  check.equal({ width <= 300, height <= 300, width == 300 or height == 300 }, { true, true, true })
  check.equal({ table.unpack(size_of(chart, { 400, 300 }), 1, 2) }, { 400, 200 })
  check.holds(core.picture_bytes(chart, "svg"), "<svg")
  check.fails(function() core.picture_bytes({}, "png") end, "a picture is expected")
end)
