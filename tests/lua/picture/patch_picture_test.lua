-- Pictures and .vtu files of patches.

require "check"

local folder = check.folder() .. "/folder"
os.execute("mkdir " .. folder)

local function bytes_of(file)
  local stream = assert(io.open(file, "rb"))
  local bytes = stream:read "a"
  stream:close()
  return bytes
end

local function draw(arguments)
  arguments.file = folder .. "/patch.png"
  arguments.size = { 320, 240 }
  sg.picture(arguments)
  return bytes_of(arguments.file)
end

local function vtu_of(patch)
  sg.vtu{ patch = patch, file = folder .. "/patch.vtu" }
  local bytes = bytes_of(folder .. "/patch.vtu")
  return tonumber(bytes:match 'NumberOfPoints="(%d+)"'), tonumber(bytes:match 'NumberOfCells="(%d+)"')
end

local circle = sg.nurbs.circle{ radius = 1 }
local ring = sg.shapes.half_annulus{ inner = 0.3, outer = 0.5 }
local shell = sg.nurbs.revolve{ patch = sg.nurbs.line{ from = { 1, 0, 0 }, to = { 0.5, 0, 2 } }, angle = 270 }
local block = sg.shapes.block{ size = { 2, 1, 1 } }
local wire = sg.nurbs.curve{ degree = 1, knots = { 0, 0, 1, 1 }, points = { { 0, 0, 0 }, { 1, 1, 1 } } }

check.case("curves, surfaces and volumes are drawn, and every option changes the picture", function()
  for _, patch in ipairs{ circle, ring, shell, block, wire } do
    local plain = draw{ patch = patch }
    check.equal(plain == draw{ patch = { patch }, names = true, mesh = true }, true)
    check.equal(plain == draw{ patch = patch, names = false }, false)
    check.equal(plain == draw{ patch = patch, control_points = true }, false)
    check.equal(plain == draw{ patch = { patch, patch } }, false)
    check.equal(plain == draw{ patch = patch, title = "a title" }, false)
  end
  local fine = block:refine{ elements = { 4, 2, 2 } }
  check.equal(draw{ patch = fine, mesh = false } == draw{ patch = fine }, false)
  check.equal(draw{ patch = fine, camera = "top" } == draw{ patch = fine }, false)
end)

check.case("pictures of patches make a sheet", function()
  local pictures = {}
  for i = 1, 2 do
    pictures[i] = sg.picture{ patch = ring:refine{ elements = { 2 * i, i } }, title = 2 * i .. " elements" }
  end
  local function sheet(list)
    sg.sheet{ list, file = folder .. "/sheet.png", size = 400 }
    return bytes_of(folder .. "/sheet.png")
  end
  check.equal(sheet(pictures) == sheet { pictures[2], pictures[1] }, false)
end)

check.case("cells of a .vtu file are the patch's elements with control points of their own", function()
  local function same(patch, points, cells)
    local p, c = vtu_of(patch)
    check.equal(p, points)
    check.equal(c, cells)
  end
  same(circle, 4 * 3, 4)
  same(ring, 6 * 2, 2)
  same(ring:refine{ elements = { 6, 3 } }, 6 * 3 * 6, 18)
  same(block, 8, 1)
  same({ block, block:refine{ elements = { 2, 1, 1 } } }, 8 + 16, 3)
end)

check.case("invalid arguments", function()
  local file = folder .. "/no.png"
  check.fails(function() sg.picture{ patch = ring, field = "uy", file = file } end,
    "field cannot be combined with patch, it is for models. Hint: leave one of them out")
  check.fails(function() sg.picture{ patch = ring, deformed = true, file = file } end,
    "deformed cannot be combined with patch, it is for models")
  check.fails(function() sg.picture{ patch = block, cut = "y", file = file } end,
    "cut cannot be combined with patch, it is for models")
  check.fails(function() sg.picture{ patch = { ring, block }, file = file } end, "patch[2] is in 3D and patch[1] in 2D")
  check.fails(function() sg.picture{ patch = {}, file = file } end, "list of one or more patches")
  check.fails(function() sg.picture{ patch = ring, camera = "top", file = file } end, "camera is for")
  check.fails(function() sg.vtu{ patch = ring, deformed = true, file = folder .. "/n.vtu" } end,
    "deformed cannot be combined with patch, it is for models")
  check.equal(io.open(file), nil)
end)
