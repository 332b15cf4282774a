-- Bodies of several patches: parts, joins and ties that are found, boundaries, the patch test across them, files.

require "check"

local steel = sg.linear_elastic{ E = 1, nu = 0.3 }
local square = sg.shapes.rectangle
local function unit(x, y, width) return square{ width = width or 1, height = 1, corner = { x, y } } end
local function cube(x) return sg.shapes.block{ size = { 1, 1, 1 }, corner = { x, 0, 0 } } end

--- Three squares in the shape of an L; the last one in another order of its directions.
local function corner_piece()
  return { unit(0, 0), unit(1, 0), unit(0, 1):swap(1, 2):reverse(1),
    boundaries = { bottom = { "1.south", "2.south" }, left = { "1.west", "3.south" } } }
end

local function body(patches, more)
  return sg.body(lists.merged({ patch = patches, elements = { 2, 2 }, order = "N2", material = steel }, more))
end

local function solved(model, stages)
  check.completed(model:run(stages, sg.plain{}))
  return model
end

local function refused(fragments, f, ...)
  local ok, message = pcall(f, ...)
  check.equal(ok, false)
  check.holds(message, table.unpack(fragments))
end

check.case("parts are named after the body, and faces on each other are joined", function()
  local piece = body(corner_piece())
  check.equal(tostring(piece), "body of 3 patches with 96 degrees of freedom, 2 pairs of faces on each other; "
    .. "boundaries: bottom, left")
  local model = sg.model{ bodies = { piece = piece } }
  check.equal(model:body_names(), { "piece.1", "piece.2", "piece.3" })
  check.holds(tostring(model), "piece.1.east-2.west shares 4 control points",
    "piece.1.north-3.east shares 4 control points")
  check.equal(model:solver().unknowns, 96 - 2 * 2 * 4)
  check.equal(#piece:face "left", 2)
  check.equal(tostring(piece:face "3.south"), "face 'south' of a body, 4 control points")
  check.equal(piece:part(3):dofs().total, 32)
end)

check.case("the patch test: uniform pressure gives uniform stress across joins and ties", function()
  for joins, elements in pairs { [2] = { { 2, 2 }, { 2, 2 }, { 2, 2 } }, [0] = { { 2, 2 }, { 3, 3 }, { 4, 3 } } } do
    local piece = body(corner_piece(), { elements = elements })
    local model = scenes.model{ bodies = { piece = piece },
      supports = { pin = { on = "1.south-west", fix = "xy" }, roller = { on = "2.south-east", fix = "y" } },
      loads = { water = { on = { "left", "bottom", "2.east", "2.north", "3.west", "3.north" }, pressure = 0 } } }
    check.equal(#model:tie_names(), 2 - joins)
    solved(model, { { name = "sink", steps = 1, water = 0.1 } })
    for part = 1, 3 do
      for _, xi in ipairs { { 0.1, 0.2 }, { 0.5, 0.9 }, { 1, 0.4 } } do
        for field, value in pairs { sxx = -0.1, syy = -0.1, sxy = 0 } do
          check.within(("%s in part %d"):format(field, part), model:sample("piece." .. part, field, xi), value, 1e-9)
        end
      end
    end
  end
end)

check.case("a list of faces with lists in it is one list", function()
  local piece = body(corner_piece())
  local model = scenes.model{ bodies = { piece = piece },
    supports = { all = { on = { "bottom", "3.east" }, fix = "xy" } } }
  check.equal(model:solver().unknowns, 80 - 2 * (7 + 4)) -- the faces have 7 and 4 control points
end)

check.case("interfaces of the list replace the search: a slit stays open", function()
  local patches = { unit(0, 0), unit(1, 0), unit(0, 1), unit(1, 1) }
  check.equal(sg.model{ bodies = { a = body(patches) } }:solver().unknowns, 2 * 7 * 7)
  patches.interfaces = { { "1.east", "2.west" }, { "3.east", "4.west" }, { "1.north", "3.south" } }
  check.equal(sg.model{ bodies = { a = body(patches) } }:solver().unknowns, 2 * (7 * 7 + 3))
end)

check.case("parts without a contact face have the label's bulk, the others its layer", function()
  local patches = { unit(0, 0), unit(1, 0), unit(0, -1), unit(1, -1), boundaries = { top = { "1.north", "2.north" } } }
  local layered = body(patches, { order = "N2-N4", contact = "top" })
  assert(layered:part(1):dofs().interface > 0)
  check.equal(layered:part(3):dofs().interface, 0)
  check.holds(tostring(sg.model{ bodies = { a = layered } }), "a.1.east-2.west shares", "a.1.south-3.north shares")
end)

check.case("faces that coincide in part are tied", function()
  local wide = body({ square{ width = 2, height = 1 }, unit(0.5, 1) })
  local text = tostring(sg.model{ bodies = { t = wide } })
  check.holds(text, "t.1.north-2.south is tied, because")
end)

check.case("faces on each other are found for any meshes and sizes, others are not", function()
  local function found(patches, elements)
    local text = tostring(sg.model{ bodies = { b = body(patches, { elements = elements }) } })
    local pairs_found = {}
    for pair in text:gmatch "(b%.[%w.-]+) %l+ " do pairs_found[#pairs_found + 1] = pair end
    table.sort(pairs_found)
    return pairs_found
  end
  local both = { "b.1.east-2.west", "b.1.north-3.south" }
  for _, elements in ipairs { { { 2, 2 }, { 8, 8 }, { 2, 2 } }, { { 8, 8 }, { 2, 2 }, { 9, 8 } } } do
    check.equal(found({ unit(0, 0), unit(1, 0), unit(0, 1) }, elements), both) -- 2.north and 3.south meet at a corner
  end
  check.equal(found({ unit(0, 0), unit(1, 1), unit(0, 1) }, { { 2, 2 }, { 8, 8 }, { 2, 2 } }),
    { "b.1.north-3.south", "b.2.west-3.east" }) -- 1 and 2 meet at a corner only
  -- A small face between the middles of large elements, and parts of faces
  check.equal(found({ unit(0, 0, 10), unit(3.1, 1, 0.2) }, { { 2, 1 }, { 1, 1 } }), { "b.1.north-2.south" })
  check.equal(found({ unit(0, 0, 2), unit(1.7, 1, 2) }, { 1, 1 }), { "b.1.north-2.south" })
end)

check.case("parts that nearly touch or overlap a little are tied, which a warning says", function()
  local rubber = sg.neo_hookean{ E = 1, nu = 0.3 }
  --- A bar of two blocks at a distance, pulled by 0.05: force, reaction, warnings.
  local function pulled(solid, distance, elements)
    local function block(x) return solid and cube(x) or unit(x, 0) end
    local bar = body({ block(0), block(1 + distance) }, { material = rubber, elements = elements })
    local model = scenes.model{ bodies = { bar = bar }, supports = {
      wall = { on = "1.west", fix = solid and "xyz" or "xy" },
      pull = { on = "2.east", fix = solid and "yz" or "y", drive = "x" } } }
    local run = check.completed(model:run({ { steps = 1, pull = 0.05 } }, sg.plain{}))
    return run:column "pull.fx"[1], run:column "wall.fx"[1], run.warnings
  end
  for solid, elements in pairs { [false] = { 3, 3 }, [true] = { 2, 2, 2 } } do
    local exact = pulled(solid, 0, elements)
    for _, distance in ipairs { 1e-7, 1e-5, 1e-3, -1e-3, 0.01 } do
      local force, reaction, warnings = pulled(solid, distance, elements)
      check.within_share("force", force, exact, 1e-6 + math.abs(distance))
      check.within("balance", force + reaction, 0, 1e-9)
      check.equal(#warnings, math.abs(distance) > 1e-6 and 1 or 0)
      if warnings[1] then
        check.holds(warnings[1], "joins.bar.1.east-2.west", ("by up to %g at"):format(math.abs(distance)), "tied")
      end
    end
  end
end)

check.case("parts with layers that nearly touch are joined, which a warning says", function()
  local function pulled(distance)
    local bar = body({ cube(0), cube(1 + distance) }, { elements = { 2, 2, 2 }, order = "N2-N3",
      contact = { "1.back", "2.back" } })
    local model = scenes.model{ bodies = { bar = bar }, supports = { wall = { on = "1.west", fix = "xyz" },
      pull = { on = "2.east", fix = "yz", drive = "x" } } }
    local run = model:run({ { steps = 1, pull = 0.05 } }, sg.plain{})
    return run:column "pull.fx"[1], run.warnings
  end
  local exact = pulled(0)
  for _, distance in ipairs { 1e-5, 1e-4 } do
    local force, warnings = pulled(distance)
    check.within_share("force", force, exact, distance)
    check.equal(#warnings, 1)
    check.holds(warnings[1], "joins.bar.1.east-2.west", ("by up to %g at"):format(distance), "joined and move as one")
  end
  refused({ "the corners are up to 0.01 apart", "move the bodies together" }, pulled, 0.01)
end)

check.case("every part of a body is connected with the others; otherwise the smallest gap is an error", function()
  refused({ "sg.body: patch must be one body", "the patches 1 and 2 are not connected", "the smallest gap is 0.2",
    "the faces '1.east' and '2.west'", "10 % of an element's length" }, body, { unit(0, 0), unit(1.2, 0) })
  refused({ "the patches 1, 3 and 2 are not connected", "the smallest gap is 0.5" }, body,
    { unit(0, 0), unit(2.5, 0), unit(1, 0) })
  refused({ "the smallest gap is 0," }, body, { unit(0, 0), unit(1, 1) }) -- at a corner
  refused({ "the smallest gap is 0.5", "'1.east' and '2.west'" }, body, { cube(0), cube(1.5) },
    { elements = { 2, 2, 2 } })
  -- Interfaces that leave a part out: the model may connect it.
  local three = { unit(0, 0), unit(1, 0), unit(2, 0), interfaces = { { "1.east", "2.west" } } }
  local listed = body(three)
  refused({ "sg.model: bodies.a must be one body", "the patches 1, 2 and 3 are not connected", "patch.interfaces" },
    sg.model, { bodies = { a = listed } })
  local seam = { slave = listed:face "2.east", master = listed:face "3.west" }
  check.equal(sg.model{ bodies = { a = listed }, ties = { seam = seam } }:tie_names(), { "seam" })
  check.equal(#sg.model{ bodies = { a = listed }, joins = { seam = { seam.slave, seam.master } } }:tie_names(), 0)
end)

check.case("faces at a distance are tied to the next one only, and a slit that ends in a gap is closed", function()
  local function layer(y, height, elements) return square{ width = 2, height = height, corner = { 0, y } }, elements end
  -- A thin layer between two thick ones, with other meshes: the thick ones face each other within the tolerance.
  local text = tostring(sg.model{ bodies = { b = body({ layer(0, 1), layer(1, 0.02), layer(1.0201, 1) },
    { elements = { { 2, 2 }, { 5, 1 }, { 3, 2 } } }) } })
  check.holds(text, "b.1.north-2.south is tied", "b.2.north-3.south is tied")
  assert(not text:find "b.1.north%-3.south")
  -- Four squares, one pair of which is a little apart
  local four = sg.model{ bodies = { b = body{ unit(0, 0), unit(1, 0), unit(0, 1), unit(1.0001, 1) } } }
  check.holds(tostring(four), "b.3.east-4.west is tied")
end)

check.case("closed faces are joined in any order of their directions", function()
  local function ring(radius)
    return sg.nurbs.revolve{ patch = unit(radius, 0), angle = 360 }
  end
  local rings = body({ ring(3), ring(4):swap(2, 3):reverse(1) }, { elements = { { 1, 2, 8 }, { 1, 8, 2 } } })
  check.holds(tostring(sg.model{ bodies = { rings = rings } }), "rings.1.east-2.east shares ")
end)

check.case("lists of faces can be slave and master of a tie", function()
  local upper = body({ unit(0, 1), unit(1, 1), boundaries = { bottom = { "1.south", "2.south" } } },
    { elements = { 3, 2 } })
  local lower = body({ square{ width = 0.8, height = 1 }, square{ width = 1.2, height = 1, corner = { 0.8, 0 } },
                       boundaries = { top = { "1.north", "2.north" }, bottom = { "1.south", "2.south" } } })
  local model = solved(scenes.model{ bodies = { upper = upper, lower = lower },
      ties = { seam = { slave = "upper.bottom", master = "lower.top" } },
      supports = { bed = { on = "lower.bottom", fix = "y" }, side = { on = "lower.1.south-west", fix = "x" } },
      loads = { weight = { on = { "upper.1.north", "upper.2.north" }, pressure = 0 } } },
    { { name = "press", steps = 1, weight = 0.1 } })
  check.near(model:reaction "bed", { 0, 0.2 }, 1e-10)
  for _, name in ipairs { "upper.1", "upper.2", "lower.1", "lower.2" } do
    check.within(name, model:sample(name, "syy", { 0.3, 0.6 }), -0.1, 1e-7)
  end
end)

check.case("pictures of a body show all its parts", function()
  local folder = check.folder()
  local model = sg.model{ bodies = { piece = body(corner_piece()), other = body{ unit(3, 0) } } }
  sg.picture{ model = model, bodies = { "piece" }, file = folder .. "/parts.png" }
  check.pictures(folder, { "parts" })
end)

check.case("files keep patches, interfaces and boundaries, and sg.body takes the list", function()
  local folder = check.folder()
  local patches = { unit(0, 0), unit(1, 0), boundaries = { top = { "1.north", "2.north" } } }
  for _, ending in ipairs { "xml", "txt", "mesh" } do
    local file = ("%s/pair.%s"):format(folder, ending)
    sg.nurbs.write(file, patches)
    local read = sg.nurbs.read(file)
    check.equal(#read, 2)
    check.equal(read.interfaces, { { "1.east", "2.west" } })
    check.equal(read.boundaries[ending == "mesh" and "1" or "top"], { "1.north", "2.north" })
    local model = sg.model{ bodies = { pair = body(read) } }
    check.holds(tostring(model), "pair.1.east-2.west shares 4 control points")
  end
end)

check.case("lists of patches are moved as a whole, with the names of their faces", function()
  local lying = sg.shapes.cylinder{ radius = 1, width = 2 }
  local upright = lying:rotate{ angle = 90, axis = { 1, 0, 0 } }
  for i, patch in ipairs(upright) do
    check.equal(patch:points(), lying[i]:rotate{ angle = 90, axis = { 1, 0, 0 } }:points())
  end
  check.equal(upright.boundaries, lying.boundaries)
  check.near(lying:translate{ 1, 2, 3 }[2]{ 0, 0, 0 }, (function()
    local x = lying[2]{ 0, 0, 0 }
    return { x[1] + 1, x[2] + 2, x[3] + 3 }
  end)(), 1e-15)
  check.equal(lying:scale{ factor = 2 }[1]:points(), lying[1]:scale{ factor = 2 }:points())
  -- The image of a boundary is the same set of points: the circle, also where a direction was reversed.
  for _, normal in ipairs { { 1, 0 }, { 1, 1 }, { 0, 1 } } do
    local image = sg.shapes.disc{ radius = 1, center = { 2, 0 } }:mirror{ normal = normal, point = { 0.5, 0.5 } }
    local center = image[5]{ 0.5, 0.5 }
    for _, name in ipairs(image.boundaries.outer) do
      local number, face = name:match "^(%d)%.(.+)$"
      for _, xi in ipairs { 0, 0.3, 1 } do
        local x = image[tonumber(number)]:face(face)(xi)
        check.within("radius", (x[1] - center[1]) ^ 2 + (x[2] - center[2]) ^ 2, 1, 1e-12)
      end
    end
    check.equal(#sg.model{ bodies = { disc = body(image) } }:tie_names(), 0)
  end
  local folder = check.folder()
  sg.nurbs.write(folder .. "/disc.xml", upright)
  check.equal(sg.nurbs.read(folder .. "/disc.xml"):translate{ 0, 0, 1 }.boundaries, upright.boundaries)
  refused({ "patch_list:rotate: unknown argument 'angel'", "did you mean 'angle'" }, upright.rotate, upright,
    { angel = 1 })
  refused({ "patch_list:translate: by must be" }, upright.translate, upright, { 1, 0 })
end)

check.case("a boundary is printed by its name and faces", function()
  check.equal(tostring(body(corner_piece()):face "bottom"), "boundary 'bottom' of a body of 3 patches: faces 1.south, "
    .. "2.south")
end)

check.case("wrong lists, names and numbers are errors at the argument", function()
  local piece = corner_piece()
  refused({ "sg.body: patch[2] must be a patch" }, body, { piece[1], 3 })
  refused({ "sg.body: patch", "unknown argument 'boundary'", "boundaries" }, body, { piece[1], boundary = {} })
  refused({ "sg.body: patch.boundaries.top[1] must be a face of a part from 1 to 1", "'2.north'" }, body,
    { piece[1], boundaries = { top = { "2.north" } } })
  refused({ "sg.body: patch.interfaces[1] must be a list of two faces" }, body,
    { piece[1], piece[2], interfaces = { { "1.east" } } })
  refused({ "sg.body: order must be one label" }, body, piece, { order = { "N2", "N3" } })
  refused({ "sg.body: elements must be a list of 3 lists" }, body, piece, { elements = { { 2, 2 } } })
  refused({ "sg.body: contact must be a face such as '1.north'", "bottom" }, body, piece,
    { order = "N2-N4", contact = "botom" })
  local made = body(piece)
  refused({ "compound:face: name must be a boundary (", "got 'lift'", "did you mean 'left'" }, made.face, made, "lift")
  refused({ "compound:face: name must be a face of a part from 1 to 3", "'7.north'" }, made.face, made, "7.north")
  refused({ "body:face", "nroth" }, made.face, made, "1.nroth")
  refused({ "compound:part", "from 1 to 3" }, made.part, made, 4)
  refused({ "a compound has no method 'points'", "compound:part(1):points(…)" }, function() return made:points() end)
  refused({ "bodies.a.1 has the name of a part" }, sg.model,
    { bodies = { a = made, ["a.1"] = body{ piece[1] }:part(1) } })
  refused({ "is the same body as" }, sg.model, { bodies = { a = made, b = made } })
  refused({ "boundaries.top[1] must be a face of one of the patches 1 to 1", "'2.north'" }, sg.nurbs.write,
    check.file "a.xml", { piece[1], boundaries = { top = { "2.north" } } })
  refused({ "interfaces[1]", "do not match point by point" }, sg.nurbs.write, check.file "a.xml",
    { piece[1], piece[2], interfaces = { { "1.west", "2.west" } } })
end)
