-- Patches in files of other programs, from Lua; the forms themselves are tested in tests/exchange/exchange_test.cpp.

require "check"

local folder = check.folder()
local samples = core.home .. "/tests/exchange/samples/"

local function same(a, b)
  check.equal(a:points(), b:points())
  check.equal(a:weights(), b:weights())
  check.equal(a:degrees(), b:degrees())
  for d = 1, #a:degrees() do check.equal(a:knots(d), b:knots(d)) end
end

check.case("files of all formats become patches of bodies", function()
  local patches = sg.nurbs.read(samples .. "gismo.xml")
  check.equal(#patches, 3)
  check.near(patches[1] { 0.5, 0.5 }, { 1.5 * math.sqrt(0.5), 1.5 * math.sqrt(0.5) })
  check.equal(#sg.nurbs.read(samples .. "geopdes_v21.txt"), 2)
  check.near(sg.nurbs.read(samples .. "mfem.mesh")[1] { 0.5, 1 }, { 0, 2 })
  local body = sg.body { patch = sg.nurbs.read(samples .. "geopdes_v07.txt")[1], elements = { 1, 2, 1 },
                         order = { "N2", "N2" }, contact = "west", material = sg.neo_hookean { E = 1, nu = 0.3 } }
  check.equal(body:dofs().total > 0, true)
end)

check.case("written patches are read back to the last bit", function()
  local disc = sg.shapes.half_annulus { inner = 0.3, outer = 0.5, center = { 0.75, 1.5 } }
    :refine { elements = { 6, 3 }, degree = { 3, 2 } }
  local cuboid = sg.shapes.block { size = { 1, 2, 3 } }:rotate { angle = 20, axis = { 1, 1, 0 } }
  local arc = sg.nurbs.arc { radius = 1, from = 10, to = 200 }
  for _, patch in ipairs { disc, cuboid, arc } do
    for _, ending in ipairs { "xml", "txt", "mesh" } do
      local file = ("%s/a.%s"):format(folder, ending)
      patch:write(file)
      same(sg.nurbs.read(file)[1], patch)
    end
    patch:write(folder .. "/a.dat", "geopdes")
    same(sg.nurbs.read(folder .. "/a.dat")[1], patch)
  end
  sg.nurbs.write(folder .. "/b.xml", { disc, cuboid, arc })
  local patches = sg.nurbs.read(folder .. "/b.xml")
  check.equal(#patches, 3)
  for i, patch in ipairs { disc, cuboid, arc } do same(patches[i], patch) end
end)

check.case("wrong calls and wrong files are errors at the user's line", function()
  local square = sg.shapes.rectangle { width = 1, height = 1 }
  local function fails(body, ...) check.fails(body, "exchange_test.lua:", ...) end
  fails(function() sg.nurbs.read(folder .. "/none.xml") end, "sg.nurbs.read: ", "cannot read", "none.xml")
  fails(function() sg.nurbs.read(core.home .. "/README.md") end, "sg.nurbs.read: ")
  fails(function() square:write(folder .. "/c.iges") end, "patch:write: file", ".xml, .txt or .mesh", "c.iges")
  fails(function() square:write(folder .. "/c.xml", "gsmo") end, "form", "gsmo", "gismo")
  fails(function() sg.nurbs.write(folder .. "/c.xml", {}) end, "sg.nurbs.write: patches",
    "a list of one or more patches")
  fails(function() sg.nurbs.write(folder .. "/c.mesh", { square, square:reverse(1):reverse(2) }) end,
    "patches[2] runs along an edge in direction 1 opposite to its neighbor", "patch:reverse")
  fails(function() square:write(folder .. "/none/c.xml") end, "cannot write", "none")
  check.equal(core.exists(folder .. "/c.xml"), false)
end)
