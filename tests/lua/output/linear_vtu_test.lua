-- sg.vtu{ cells = "linear" }: files for programs without Bézier cells, opened by VTK's own reader.

require "check"
local ironing = require "ironing"
local layered_solid = require "layered_solid"
local read = require "read_vtu"

local folder = check.folder()

--- The arguments of sg.vtu as exact and as linear cells: the corners of these have the values of the exact cells there.
--- Returns what VTK finds in the file with the linear ones.
local function compare(o, n)
  local places = {}
  for i = 0, n do places[i + 1] = i / n end
  o.file = folder .. "/exact.vtu"
  sg.vtu(o)
  local exact = read(o.file, places)
  o.file, o.cells, o.subdivisions = folder .. "/linear.vtu", "linear", n
  sg.vtu(o)
  local linear, number = read(o.file), 0
  for _, cell in ipairs(exact.cells) do
    local dimension = (cell.type - 73) // 2 -- 75, 77, 79: curve, quadrilateral, hexahedron
    for part = 0, n ^ dimension - 1 do
      number = number + 1
      local own = linear.cells[number]
      check.equal({ own.body, own.contact }, { cell.body, cell.contact })
      for _, point in ipairs(own.points) do
        local place, rest, stride = 1, part, 1 -- among the points of the exact cell
        for d = 1, dimension do
          place = place + stride * (rest % n + point.at[d])
          rest, stride = rest // n, stride * (n + 1)
        end
        local wanted = cell.points[math.tointeger(place)]
        for _, name in ipairs { "x", "displacement", "stress", "von_mises", "pressure", "F" } do
          check.near(point[name], wanted[name], 1e-12)
        end
        local mine, theirs = point.contact_pressure[1], wanted.contact_pressure[1]
        if mine == mine or theirs == theirs then check.near(mine, theirs, 1e-12) end
      end
    end
  end
  check.equal(#linear.cells, number)
  return linear
end

for n = 1, 3, 2 do
  check.case(("plane model, %d cells per element and direction"):format(n), function()
    local model = ironing { order = "N2-N2.2", points = 5, E = 20 }
    check.completed(model:run({ { name = "press", steps = 4, grip = { 0, -0.15 } } }))
    local file, found = folder .. "/linear.vtu", compare({ model = model }, n)
    check.equal(#found.cells, 36 * n ^ 2 + 6 * n)
    check.equal({ found.cells[1].type, found.cells[#found.cells].type }, { 9, 3 })
    check.equal({ found.cells[#found.cells].contact, found.contact_names[1], found.stress },
      { 1, "interface", "XX XZ" })
    local text = core.read_file(file)
    for _, word in ipairs { "RationalWeights", "HigherOrderDegrees" } do check.equal(text:find(word, 1, true), nil) end
    -- The die's arc: corners lie on the exact circle.
    sg.vtu { model = model, file = file, cells = "linear", subdivisions = n, deformed = false }
    local count = 0
    for _, cell in ipairs(read(file).cells) do
      for _, point in ipairs(cell.contact == 1 and cell.points or {}) do
        check.within("radius", math.sqrt((point.x[1] - 0.75) ^ 2 + (point.x[2] - 1.5) ^ 2), 0.5, 1e-14)
        count = count + 1
      end
    end
    check.equal(count, 12 * n)
  end)
end

check.case("solids with layers; by default the highest degree", function()
  local model = layered_solid()
  local file, found = folder .. "/solid.vtu", compare({ model = model }, 2)
  check.equal({ found.cells[1].type, found.cells[#found.cells].type }, { 12, 9 })
  check.equal(#found.cells, 8 * 8 + 4 * 4)
  sg.vtu { model = model, file = file, cells = "linear" }
  check.equal(#read(file).cells, 8 * 64 + 4 * 16)
end)

check.case("patches, and series", function()
  local file = folder .. "/circle.vtu"
  sg.vtu { patch = sg.nurbs.circle { radius = 2 }, file = file, cells = "linear", subdivisions = 5 }
  check.holds(core.read_file(file), 'NumberOfPoints="24" NumberOfCells="20"', 'Name="patch"')
  local series = sg.pvd(folder .. "/run.pvd")
  series:add { model = ironing(), time = 0, cells = "linear", subdivisions = 1 }
  check.equal(#read(folder .. "/run_0001.vtu").cells, 36 + 6)
end)

check.case("wrong arguments", function()
  local model, file = ironing(), folder .. "/a.vtu"
  local wrong = {
    { { cells = "linear", subdivisions = 1.5 }, "subdivisions" },
    { { subdivisions = 2 }, "subdivisions is for linear cells", 'cells = "linear"' },
  }
  for _, case in ipairs(wrong) do
    case[1].model, case[1].file = model, file
    check.fails(function() sg.vtu(case[1]) end, "linear_vtu_test.lua:", "sg.vtu: ", table.unpack(case, 2))
  end
  check.equal(core.exists(file), false)
end)
