-- Loads as functions of the reference position, and forces on corners and edges: closed forms, resultants, factors as
-- targets, files, wrong inputs.

require "check"
local column = require "column"

local height, E = 2, 10
local soft = sg.linear_elastic{ E = E, nu = 0 }

local function standing(kind, load)
  return column.model(kind, { height = height, elements = 2, order = "N3", material = soft, load = load })
end

check.case("a force per volume that grows with height gives the closed form's cubic displacement", function()
  for _, kind in ipairs(column.kinds) do
    local space = kind == "space"
    local model = standing(kind, function(body)
      return { on = body, factor = 0, force = space and function(_, _, z) return { 0, 0, -z } end
        or function(_, y) return { 0, -y } end }
    end)
    local run, letter = check.completed(model:run({ { steps = 2, g = 1 } }, sg.plain{})), column.letter(kind)
    check.equal(run:column "g.factor", { 0.5, 1 })
    check.near(model:sample("column", "u" .. letter, column.at(kind, 1)), -height ^ 3 / (3 * E), 1e-10)
    check.near(model:reaction "g"["f" .. letter], -height ^ 2 / 2 * column.area(kind), 1e-10)
    check.near(model:reaction "bed"["f" .. letter], height ^ 2 / 2 * column.area(kind), 1e-9)
    -- ½ ∫ E u'² dV with u' = -(H² - y²)/2E
    local stored = (8 / 15) * height ^ 5 / (8 * E) * column.area(kind)
    local energy = model:energy()
    check.near({ energy.stored, energy.work }, { stored, stored }, 1e-10)
  end
end)

check.case("a constant function is the uniform load; water carries the volume of a body", function()
  local ring = scenes.body{ patch = sg.shapes.quarter_annulus{ inner = 1, outer = 2, center = { 3, -5 } },
    elements = { 3, 2 }, material = soft }
  local faces = { ring:face "west", ring:face "east", ring:face "south", ring:face "north" }
  local function model_with(load, kind)
    load.on = load.on or faces
    return sg.model{ bodies = { ring = ring }, kind = kind, loads = { sea = load } }
  end
  for _, kind in ipairs { "plane_strain", "axisymmetric" } do
    local north = ring:face "north"
    for _, pair in ipairs {
      { { on = north, traction = { 0.1, -0.2 } }, { on = north, traction = function() return { 0.1, -0.2 } end } },
      { { on = north, pressure = 0.3 }, { on = north, pressure = function() return 0.3 end } },
      { { on = north, pressure = 0.3, follower = true },
        { on = north, pressure = function() return 0.3 end, follower = true } },
    } do
      local uniform, course = model_with(pair[1], kind), model_with(pair[2], kind)
      check.near(course:residual(), uniform:residual(), 1e-13)
    end
    -- Archimedes: the water's resultant is the weight of the water that the body displaces.
    for _, follower in ipairs { false, true } do
      local model = model_with({ pressure = function(_, y) return -y end, follower = follower }, kind)
      local section = math.pi / 4 * (2 ^ 2 - 1)
      local moment = (2 ^ 3 - 1) / 3 -- of the section about its center's plane
      local volume = kind == "axisymmetric" and 2 * math.pi * (3 * section + moment) or section
      local force = model:reaction "sea"
      check.within_share("buoyancy", force.fy, volume, 1e-9)
    end
  end
end)

check.case("the factor is 1 unless given, and stays where no stage names it; a file holds values", function()
  local model = standing("plane_strain", function(body)
    return { on = body:face "north", traction = function(x) return { 0, -x } end }
  end)
  check.near(model:reaction "g", { 0, -0.5 }, 1e-14)
  check.equal(model:driven "g", { "factor" })
  local copy = check.reloaded(model)
  copy:run({ { steps = 1, g = 3 } }, sg.plain{})
  check.near(copy:reaction "g", { 0, -1.5 }, 1e-13)
end)

check.case("a force on a corner does work, and its support holds it", function()
  for _, kind in ipairs(column.kinds) do
    local space = kind == "space"
    local name = space and "north-east-back" or "north-east"
    local model = standing(kind, function(body)
      return { on = body:corner(name), force = column.along(kind, 0) }
    end)
    local run, letter = model:run({ { steps = 3, g = column.along(kind, -0.6) } }, sg.plain{}), column.letter(kind)
    check.near(run:column("g.p" .. letter), { -0.2, -0.4, -0.6 }, 1e-15)
    check.near(model:reaction "g"["f" .. letter], -0.6, 1e-14)
    check.near(model:reaction "bed"["f" .. letter], 0.6, 1e-9)
    -- Clapeyron: the work is half the force times the displacement of the corner.
    local u = model:sample("column", "u" .. letter, space and { 1, 1, 1 } or { 1, 1 })
    local energy = model:energy()
    check.near({ energy.work, energy.stored }, { -0.3 * u, -0.3 * u }, 1e-10)
    check.equal(u < 0, true)
  end
end)

check.case("a force on edges acts per length, also on curved ones and layers", function()
  for _, order in ipairs { "N2", "N2-N2.1" } do
    local section = sg.shapes.quarter_annulus{ inner = 1, outer = 2, center = { 0, 0 } }
    local shell = scenes.body{ patch = sg.nurbs.extrude{ patch = section, along = { 0, 0, 3 } }, elements = { 3, 1, 2 },
      order = order, contact = order ~= "N2" and "south" or nil, material = soft }
    local function resultant(on)
      return sg.model{ bodies = { shell = shell }, loads = { line = { on = on, force = { 0, 0, -0.5 } } } }
        :reaction "line"
    end
    local total = 0
    for _, name in ipairs { "south-front", "south-back", "north-front", "north-back" } do
      local force = -resultant(shell:edge(name))[3] / 0.5
      check.equal(math.abs(force - math.pi) < 1e-6 or math.abs(force - math.pi / 2) < 1e-6, true)
      total = total + force
    end
    check.within("arcs", total, 3 * math.pi, 1e-6)
    check.near(resultant { shell:edge "south-west", shell:edge "north-west" }, { 0, 0, -3 }, 1e-12)
  end
end)

check.refusals([[
local b = sg.body{ patch = sg.shapes.block{ size = {1, 1, 1} }, elements = {1, 1, 1}, order = "N2", material = soft }
local corner = a:corner "north-east"
local function model(load) return sg.model{ bodies = { a = a }, loads = { g = load } } end
local function solid(load) return sg.model{ bodies = { b = b }, loads = { g = load } } end
]], "study.lua:", {
  { "model{ on = east, traction = function(x, y) return y end }",
    "loads.g.traction must return a list of 2 numbers {tx, ty}, got the number 0", "at X = (3, 0" },
  { "model{ on = east, pressure = function(x, y) return {y} end }",
    "loads.g.pressure must return a finite number, got" },
  { "model{ on = a, force = function() end }", "loads.g.force must return a list of 2 numbers {bx, by}",
    "got nothing" },
  { "solid{ on = b, force = function(x, y) return {x, y} end }",
    "loads.g.force must return a list of 3 numbers {bx, by, bz}" },
  { "model{ on = east, traction = function() return {1, 0 / 0} end }",
    "loads.g.traction must return a list of 2 numbers {tx, ty}, got a list with nan (not a number) as entry 2" },
  { [[solid{ on = b, force = function() return {0, "1", 0} end }]], "got a list with the string '1' as entry 2" },
  { "model{ on = east, pressure = function() return 1 / 0 end }", "must return a finite number" },
  { "model{ on = east, pressure = function(x) return x.y end }",
    "study.lua:5: attempt to index a number value (local 'x'): loads.g.pressure is called as function(x, y) with num" },
  { "solid{ on = b, force = function(X) return {0, 0, X[3]} end }",
    "loads.g.force is called as function(x, y, z) with numbers" },
  { "model{ on = corner, force = function() return {0, 1} end }",
    "loads.g: force is a function, which is for faces and bodies", "give a list of 2 numbers {px, py}" },
  { "model{ on = east, pressure = 1, factor = 2 }", "loads.g: factor is for functions, but pressure is constant" },
  { "model{ on = { a, corner }, force = {0, 1} }", "loads.g: it is on the body 'a' and the corner",
    "use a load for each" },
  { "model{ on = { corner, corner }, force = {0, 1} }", "loads.g.on lists corner", "twice" },
  { [[model{ on = { corner, a:corner "east-north" }, force = {0, 1} }]],
    "loads.g.on lists corner 'east-north' of body 'a', also called 'north-east', twice" },
  { [[solid{ on = { b:edge "east-back", b:edge "back-east" }, force = {0, 0, 1} }]],
    "loads.g.on lists edge 'back-east' of body 'b', also called 'east-back', twice" },
  { [[solid{ on = { b:corner "east-north-back", b:corner "back-north-east" }, force = {0, 0, 1} }]],
    "loads.g.on lists corner 'back-north-east' of body 'b', also called 'east-north-back', twice" },
  { "model{ on = corner, traction = {0, 1} }", "loads.g.on must be a face" },
  { [[solid{ on = b:edge "south-front", pressure = 1 }]], "loads.g.on must be a face", "an edge has no surface" },
  { "model{ on = corner, force = {0, 1, 2} }", "loads.g.force must be a list of 2 numbers {px, py}" },
})

check.case("a function that varies between the points of the load is a warning with its error", function()
  local function loaded(f, elements, kind)
    local b = scenes.body{ elements = { elements, 2 } }
    local m = scenes.model{ bodies = { b = b }, supports = { a = { on = "south", fix = "xy" } }, kind = kind,
                        loads = { p = { on = "north", pressure = f, factor = 0 } } }
    local run = m:run({ { steps = 1, p = 1 } }, sg.plain{})
    return run:column "p.fy"[1], m:warnings()
  end
  local function peak(width) return function(x) return 0.1 * math.exp(-((x - 0.4) / width) ^ 2) end end
  check.equal(#select(2, loaded(peak(0.1), 2)), 0) -- 0.3 %
  for _, width in ipairs { 0.03, 0.01 } do
    local exact = -0.1 * width * math.sqrt(math.pi)
    local coarse, warnings = loaded(peak(width), 2)
    assert(math.abs(coarse / exact - 1) > 0.01)
    check.equal(#warnings, 1)
    check.holds(warnings[1], "loads.p.pressure", "resultant of its function", "more elements where it varies")
    local fine, none = loaded(peak(width), math.ceil(1 / width))
    check.within_share("resultant", fine, exact, 0.01)
    check.equal(#none, 0)
  end
  -- A jump at the border of an element, and functions that change their sign
  for _, f in ipairs { function(x) return x > 0.5 and 1e-3 or 0 end,
                       function(x) return 1e-3 * math.cos(math.pi * x) end } do
    for _, kind in ipairs { "plane_strain", "axisymmetric" } do check.equal(#select(2, loaded(f, 4, kind)), 0) end
  end
  check.holds(select(2, loaded(function(x) return x > 0.9999 and 100 or 0 end, 2))[1],
    "loads.p has no effect: its function is zero at all points")
end)

check.case("so is a force per volume", function()
  local function warnings(width)
    local b = scenes.body{ elements = { 4, 4 } }
    return scenes.model{ bodies = { b = b }, supports = { a = { on = "south", fix = "xy" } },
      loads = { p = { on = b, force = function(x) return { 0, math.exp(-((x - 0.4) / width) ^ 2) } end } } }:warnings()
  end
  check.equal(#warnings(0.2), 0)
  check.holds(warnings(0.02)[1], "loads.p.force", "resultant of its function")
end)
