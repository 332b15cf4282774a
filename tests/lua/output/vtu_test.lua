-- Files for ParaView, opened again with VTK's own reader (tests/vtk/read_vtu.cpp): exact shapes and displacements,
-- fields exact where they are said to be, series.

require "check"
local ironing = require "ironing"
local layered_solid = require "layered_solid"
local read = require "read_vtu"

local folder = check.folder()

--- Gauss points of n points on [0, 1].
local gauss = {
  [2] = { 0.5 - math.sqrt(1 / 12), 0.5 + math.sqrt(1 / 12) },
  [3] = { 0.5 - math.sqrt(0.15), 0.5, 0.5 + math.sqrt(0.15) },
}
do
  local a, b = math.sqrt(5 - 2 * math.sqrt(10 / 7)) / 6, math.sqrt(5 + 2 * math.sqrt(10 / 7)) / 6
  gauss[5] = { 0.5 - b, 0.5 - a, 0.5, 0.5 + a, 0.5 + b }
end

--- The element of a body (numbers from 0, ξ¹ fastest) at a cell's own coordinates; its elements are equally long.
local function parameter(elements, number, at)
  local xi = {}
  for d, count in ipairs(elements) do
    xi[d] = (number % count + at[d]) / count
    number = number // count
  end
  return xi
end

local function size(a, b)
  local sum = 0
  for i = 1, #a do sum = sum + (a[i] - (b and b[i] or 0)) ^ 2 end
  return math.sqrt(sum)
end

local elements = { die = { 6, 2 }, slab = { 8, 3 } }
local places = { 0, 0.3, 1, gauss[2][1], gauss[2][2], gauss[3][1], gauss[3][2], gauss[3][3], gauss[5][1], gauss[5][2] }

local function is_gauss(place, degree)
  for _, one in ipairs(gauss[degree + 1]) do if one == place then return true end end
  return false
end

--- Runs body(name, number, cell) over the cells of bodies.
local function each_element(found, body)
  local numbers = {}
  for _, cell in ipairs(found.cells) do
    if cell.contact == 0 then
      local name = found.body_names[cell.body]
      numbers[name] = (numbers[name] or -1) + 1
      body(name, numbers[name], cell)
    end
  end
  return numbers
end

for _, order in ipairs { "N2", "N2-N2.2" } do
  local layered = order ~= "N2"
  local model = ironing { order = order, points = layered and 5 or 3, E = 20 }
  check.completed(model:run { { name = "press", steps = 12, grip = { 0, -0.15 } },
    { name = "slide", steps = 1, grip = { 0.01, -0.15 } } })
  local file, reference = folder .. "/present.vtu", folder .. "/reference.vtu"
  sg.vtu { model = model, file = file }
  sg.vtu { model = model, file = reference, deformed = false }
  local present, start = read(file, places), read(reference, places)

  check.case(order .. ": cells, degrees and names", function()
    check.equal(present.body_names, { "die", "slab" })
    check.equal(present.contact_names, { "interface" })
    check.equal(present.stress, "XX XZ")
    check.equal(#present.cells, 12 + 24 + 6)
    local numbers = each_element(present, function(name, number, cell)
      check.equal(cell.type, 77)
      local at_face = name == "die" and number < 6 or name == "slab" and number >= 16
      check.equal(cell.degrees, { layered and at_face and 4 or 2, 1, 0 })
    end)
    check.equal(numbers.die, 11)
    check.equal(numbers.slab, 23)
    for i = 37, 42 do
      check.equal(present.cells[i].type, 75)
      check.equal(present.cells[i].degrees[1], layered and 4 or 2)
      check.equal({ present.cells[i].body, present.cells[i].contact }, { 1, 1 })
    end
  end)

  check.case(order .. ": points on the die's arcs lie on the circles to 1e-12", function()
    local worst, count = 0, 0
    each_element(start, function(name, number, cell)
      if name ~= "die" then return end
      for _, point in ipairs(cell.points) do
        local radius = size({ point.x[1] - 0.75, point.x[2] - 1.5 })
        local outer, inner = number < 6 and point.at[2] == 0, number >= 6 and point.at[2] == 1
        if outer or inner then worst, count = math.max(worst, math.abs(radius - (outer and 0.5 or 0.3))), count + 1 end
      end
    end)
    for i = 37, 42 do
      for _, point in ipairs(start.cells[i].points) do
        worst = math.max(worst, math.abs(size({ point.x[1] - 0.75, point.x[2] - 1.5 }) - 0.5))
      end
    end
    check.equal(count, 12 * #places)
    if worst > 1e-12 then error(("off by %g"):format(worst)) end
  end)

  check.case(order .. ": displacement and shape are those of the model", function()
    local worst, moved = 0, 0
    each_element(present, function(name, number, cell)
      for _, point in ipairs(cell.points) do
        local xi = parameter(elements[name], number, point.at)
        local u = { model:sample(name, "ux", xi), model:sample(name, "uy", xi), 0 }
        worst = math.max(worst, size(point.displacement, u))
        moved = math.max(moved, size(u))
        check.equal(point.x[3], 0)
      end
    end)
    if worst > 1e-14 then error(("off by %g"):format(worst)) end
    if moved < 0.05 then error "nothing has moved" end
    for c, cell in ipairs(present.cells) do
      for i, point in ipairs(cell.points) do
        local from = start.cells[c].points[i]
        check.near(point.displacement, from.displacement, 0)
        check.near(point.x, { from.x[1] + point.displacement[1], from.x[2] + point.displacement[2], 0 }, 1e-14)
      end
    end
  end)

  check.case(order .. ": fields are exact at Gauss points", function()
    local fields = { { "sxx", "stress", 1 }, { "szz", "stress", 3 }, { "sxy", "stress", 4 },
                     { "von_mises", "von_mises", 1 },
                     { "pressure", "pressure", 1 }, { "F12", "F", 2 }, { "F21", "F", 4 }, { "F22", "F", 5 } }
    local count, elsewhere = 0, 0
    each_element(present, function(name, number, cell)
      for _, point in ipairs(cell.points) do
        local xi = parameter(elements[name], number, point.at)
        local exact = is_gauss(point.at[1], cell.degrees[1]) and is_gauss(point.at[2], cell.degrees[2])
        for _, field in ipairs(fields) do
          local error_ = math.abs(point[field[2]][field[3]] - model:sample(name, field[1], xi))
          if exact then
            count = count + 1
            if error_ > 1e-12 then error(("%s of %s, element %d: off by %g"):format(field[1], name, number, error_)) end
          else
            elsewhere = math.max(elsewhere, error_)
          end
        end
        check.near({ point.stress[5], point.stress[6], point.F[3], point.F[9] }, { 0, 0, 0, 1 }, 1e-13)
      end
    end)
    if count < 36 * 6 * #fields then error "too few points were compared" end
    if elsewhere < 1e-6 then error "the comparison cannot fail" end
  end)

  check.case(order .. ": contact pressure at the contact points, nan in bodies", function()
    local profile = model:profile "interface"
    local n = layered and 5 or 3
    local found = read(file, gauss[n])
    check.equal(#profile.pressure, 6 * n)
    local touching = 0
    for e = 0, 5 do
      for g, point in ipairs(found.cells[37 + e].points) do
        check.near(point.contact_pressure[1], profile.pressure[e * n + g], 1e-12)
        check.near({ point.x[1], point.x[2] }, { profile.x[e * n + g], profile.y[e * n + g] }, 1e-13)
        if profile.pressure[e * n + g] > 0 then touching = touching + 1 end
      end
    end
    if touching < 4 then error "hardly any contact" end
    each_element(found, function(_, _, cell)
      for _, point in ipairs(cell.points) do
        if point.contact_pressure[1] == point.contact_pressure[1] then error "a body has a contact pressure" end
      end
    end)
  end)
end

check.case("solids with layers: hexahedra of different degrees, faces with pressure", function()
  local model = layered_solid()
  local file = folder .. "/solid.vtu"
  sg.vtu { model = model, file = file }
  local found = read(file, { 0, gauss[5][2], gauss[2][1], 1 })
  check.equal(#found.cells, 8 + 4)
  local worst, moved = 0, 0
  each_element(found, function(name, number, cell)
    check.equal(cell.type, 79)
    check.equal(cell.degrees, number < 4 and { 2, 3, 2 } or { 4, 4, 2 })
    for _, point in ipairs(cell.points) do
      local xi = parameter({ 2, 2, 2 }, number, point.at)
      local u = { model:sample(name, "ux", xi), model:sample(name, "uy", xi), model:sample(name, "uz", xi) }
      worst = math.max(worst, size(point.displacement, u),
                       size(point.x, { 2 * xi[1] + u[1], 2 * xi[2] + u[2], xi[3] + u[3] }))
      moved = math.max(moved, size(u))
    end
  end)
  if worst > 1e-13 then error(("off by %g"):format(worst)) end
  if moved < 0.01 then error "nothing has moved" end
  local profile, most = model:profile "touch", 0
  local pressures = {}
  for i, pressure in ipairs(profile.pressure) do
    pressures[("%.9f %.9f %.9f"):format(profile.x[i], profile.y[i], profile.z[i])] = pressure
  end
  local compared = 0
  local faces = read(file, gauss[5])
  for c = 9, 12 do
    check.equal(faces.cells[c].type, 77)
    check.equal(faces.cells[c].degrees, { 4, 4, 0 })
    for _, point in ipairs(faces.cells[c].points) do
      local expected = pressures[("%.9f %.9f %.9f"):format(table.unpack(point.x))]
      if expected then
        compared, most = compared + 1, math.max(most, expected)
        check.near(point.contact_pressure[1], expected, 1e-11)
      end
    end
  end
  check.equal(compared, 100)
  if most <= 0 then error "no contact" end
end)

check.case("bodies of revolution have the hoop direction across", function()
  local model = scenes.model{ bodies = { ring = {} }, kind = "axisymmetric",
    supports = { bed = { on = "south", fix = "xy" }, top = { on = "north", drive = "y", fix = "x" } } }
  model:run { { name = "press", steps = 1, top = { -0.1 } } }
  sg.vtu { model = model, file = folder .. "/ring.vtu" }
  local found, most = read(folder .. "/ring.vtu", gauss[3]), 0
  each_element(found, function(name, number, cell)
    for _, point in ipairs(cell.points) do
      local xi = parameter({ 2, 2 }, number, point.at)
      check.near(point.stress[3], model:sample(name, "szz", xi), 1e-12)
      check.near(point.F[9], 1 + point.displacement[1] / xi[1], 1e-12)
      most = math.max(most, math.abs(point.F[9] - 1))
    end
  end)
  if most < 1e-3 then error "no hoop strain" end
end)

check.case("a series lists its states, also during the run", function()
  local model = ironing { E = 20 }
  local file = folder .. "/series & more.pvd"
  local series = sg.pvd(file)
  check.holds(core.read_file(file), 'type="Collection"')
  model:run({ { name = "press", steps = 2, grip = { 0, -0.04 } } },
    { on_step = function(info) series:add { model = model, time = info.step / 10 } end })
  local text = core.read_file(file)
  check.holds(text, 'timestep="0.10000000000000001" part="0" file="series &amp; more_0001.vtu"', 'timestep="0.2000')
  check.equal(tostring(series):match "%d states", "2 states")
  local first, second = read(folder .. "/series & more_0001.vtu", { 0 }),
    read(folder .. "/series & more_0002.vtu", { 0 })
  check.near(first.cells[7].points[1].displacement[2] * 2, second.cells[7].points[1].displacement[2], 0.01)
  check.fails(function() series:add { model = model, time = 0.2 } end, "vtu_test.lua:", "times must increase")
  check.fails(function() series.add { model = model, time = 1 } end, "with a colon")
  check.fails(function() sg.pvd "a.vtu" end, "sg.pvd: file must be a name that ends with .pvd")
  check.fails(function() sg.pvd(folder .. "/none/a.pvd") end, "vtu_test.lua:", "sg.pvd: cannot write", "none",
    "sg.mkdir")
end)

check.case("a series is continued after an interruption", function()
  local model, file = ironing { E = 20 }, folder .. "/long <1>.pvd"
  local first = sg.pvd(file, { resume = true })
  for time = 1, 4 do first:add { model = model, time = time } end
  local again = sg.pvd(file, { resume = true })
  check.equal(#again, 4)
  again:add { model = model, time = 3 }
  local times = {}
  for time, name in core.read_file(file):gmatch 'timestep="(%d)" part="0" file="long &lt;1>_000(%d).vtu"' do
    times[#times + 1] = time .. name
  end
  check.equal(times, { "11", "22", "33" })
  check.fails(function() again:add { model = model, time = 3 } end, "times must increase")
  check.fails(function() again:add { model = model, time = 2 } end, "times must increase")
  again:add { model = model, time = 5 }
  check.equal(#sg.pvd(file, { resume = true }), 4)
  check.equal(#sg.pvd(file), 0)
  core.write_file(file, "<xml/>")
  check.fails(function() sg.pvd(file, { resume = true }) end, "vtu_test.lua:", "was not written by sg.pvd")
end)

check.case("invalid calls are errors that name the argument, and leave no file", function()
  local model = ironing()
  local wrong = {
    { { model = model }, "file" }, { { file = folder .. "/a.vtu" }, "model" },
    { { model = 1, file = "a.vtu" }, "model" },
    { { model = model, file = folder .. "/a.vtk" }, "a name that ends with .vtu" },
    { { model = model, file = folder .. "/a.vtu", deformd = true }, "deformd", "deformed" },
    { { model = model, file = folder .. "/a.vtu", deformed = 1 }, "deformed", "true or false" },
    { { model = model, file = folder .. "/none/a.vtu" }, "cannot write", "none" },
  }
  for _, case in ipairs(wrong) do
    check.fails(function() sg.vtu(case[1]) end, "vtu_test.lua:", "sg.vtu: ", table.unpack(case, 2))
  end
  check.equal(core.exists(folder .. "/a.vtu"), false)
end)
