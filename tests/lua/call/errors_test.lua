-- Messages about invalid input name the user's line, the function, the argument, its value, and a hint.

require "check"

local p = sg.shapes.rectangle { width = 3, height = 1 }
local nan = 0 / 0

check.case("wrong named arguments", function()
  local rectangle = sg.shapes.rectangle
  local wrong = {
    { { width = 3, hieght = 1 },
      "unknown argument 'hieght' (the number 1); did you mean 'height'? known: width, height, corner" },
    { { w = 3, h = 1 }, "unknown argument 'h' (the number 1); did you mean 'height'?; "
      .. "unknown argument 'w' (the number 3); did you mean 'width'? known: width, height, corner" },
    { { width = 3, height = 1, frobnicate = 2 }, "unknown argument 'frobnicate' (the number 2); known: width" },
    { { width = 3 }, "height (size along y) is missing: it must be a positive number" },
    { { width = "3", height = 1 },
      "width must be a positive number (size along x), got the string '3'. Hint: remove the quotes" },
    { { width = -3, height = 1 }, "width must be a positive number", "got the number -3", "above 0" },
    { { width = 0, height = 1 }, "got the number 0" },
    { { width = nan, height = 1 }, "width must be a finite number", "nan", "division by zero" },
    { { width = math.huge, height = 1 }, "got infinity" },
    { { width = { 3 }, height = 1 }, "got a list of 1 value", "without braces" },
    { { width = true, height = 1 }, "got true" },
    { { width = 3, height = 1, corner = 5 }, "corner must be a list of 2 numbers {x, y}", "put it into braces" },
    { { width = 3, height = 1, corner = { 0, 0, 0 } }, "corner must be a list of 2 numbers", "got a list of 3 values" },
    { { width = 3, height = 1, corner = { x = 0, y = 0 } }, "corner must be", "a table with the key", "without names" },
    { { width = 3, height = 1, corner = { 0, "0" } }, "corner[2] must be a number", "got the string '0'" },
    { { 3, 1 }, "takes named arguments, got the number", "without a name; known: width, height, corner" },
  }
  for _, case in ipairs(wrong) do
    check.fails(function() rectangle(case[1]) end, "sg.shapes.rectangle", table.unpack(case, 2))
  end
  check.fails(function() rectangle(3, 1) end,
    "takes a table of named arguments, got the number 3. Hint: write sg.shapes.rectangle{ width")
  check.fails(function() rectangle() end, "got nothing")
end)

check.case("suggestions: parts of names, entries without names, tables in place of objects", function()
  local body = sg.body{ patch = p, elements = {2, 2}, order = "N2", contact = "north",
                        material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  check.fails(function()
    sg.model{ bodies = { b = body }, supports = { bed = { on = body:face "south", fixed = "xy" } } }
  end, "supports.bed: unknown argument 'fixed'", "did you mean 'fix'?")
  check.fails(function() sg.model{ bodies = { b = body }, contacts = { slave = body:face "north", penalty = 1 } } end,
    "contacts contains an entry without a name", "contacts = { name = { slave = …")
  check.fails(function() sg.body{ patch = p, elements = {2, 2}, order = "N2", material = { E = 1, nu = 0.3 } } end,
    "material must be", "sg.neo_hookean{ E = 1, nu = 0.3 }")
  check.fails(function() return sg.shapes.rect end, "did you mean 'rectangle'?")
end)

check.case("wrong arguments of methods", function()
  check.fails(function() p:face "nroth" end, "patch:face", "nroth", "north")
  check.fails(function() p:face(3) end, "name must be a face name", "got the number 3")
  check.fails(function() p:elevate(1.5) end, "without a fraction")
  check.fails(function() p(0.5) end, "xi must be a list of 2 numbers", "braces")
  check.fails(function() p { 0.5 } end, "got a list of 1 value")
  check.fails(function() p { 0.5, 2 } end, "patch", "2")
  check.fails(function() p { 0.5, nan } end, "xi[2]", "nan")
  check.fails(function() p:insert(1, { 7 }) end, "patch:insert", "7")
  check.fails(function() p:insert(1, 0.5) end, "knots must be a list", "braces")
  check.fails(function() p:refine { elements = 4 } end, "elements must be a list of 2 whole numbers")
  check.fails(function() p:refine { elements = { 4, 4 }, grading = { false } } end,
    "grading must be a list of 2 entries")
  local function graded(grading)
    return function() p:refine { elements = { 4, 4 }, grading = { false, grading } } end
  end
  check.fails(graded { elements = 0.5, length = 0.1, at = "ende" },
    "grading[2].at must be 'start' or 'end'", "did you mean 'end'?")
  check.fails(function() p:refine { grading = { false, false } } end, "grading has no effect without elements")
  check.fails(function() p:rotate { angle = 90, axis = { 0, 0, 1 } } end,
    "axis is for patches in 3D", "omit axis")
  check.fails(function() p:refinne {} end, "a patch has no method 'refinne'; did you mean 'refine'?")
  check.fails(function() p.face("north") end, "patch:face must be called on a patch", "colon")
end)

check.case("more arguments than a function takes", function()
  local c = sg.nurbs.circle { radius = 1 }
  check.fails(function() c(0.5, 0.5) end, "errors_test.lua:",
    "patch: too many arguments: it is called as patch(xi), got the number 0.5 beyond that",
    "into braces")
  check.fails(function() p:degrees(1) end,
    "patch:degrees: too many arguments: it is called as patch:degrees(), got the number 1")
  check.fails(function() p:elevate(1, 2, 3) end, "called as patch:elevate(dir, times = 1), got the number 3")
  check.fails(function() sg.shapes.rectangle({ width = 1, height = 1 }, "x") end,
    "sg.shapes.rectangle: too many arguments: it is called as sg.shapes.rectangle{ width, height, corner = {0, 0} }, "
      .. "got the string 'x'")
  check.equal(#p:degrees(nil), 2)
end)

check.case("messages give the hint that helps", function()
  local c = sg.nurbs.line { from = { 0, 0 }, to = { 2, 0 } }
  check.fails(function() c("0.5") end,
    "xi must be a number (parametric coordinates), got the string '0.5'. Hint: remove the quotes")
  check.near(c(1 + 1e-13), { 2, 0 }, 1e-12)
  check.fails(function() c(1 + 1e-10) end, "xi = 1 is outside the knots, [0, 1], by 1.0000")
  check.fails(function() c:face "south" end, "patch:face: a curve has end points, but no faces")
  check.fails(function() p:face "top" end, "face must be one of ",
    "the ends of xi1 and xi2, got 'top'. Hint: did you mean 'north'?")
  local message = check.fails(function() p:face "nonsense" end, "the ends of xi1 and xi2, got 'nonsense'")
  check.equal(message:find "did you mean", nil)
  check.fails(function() sg.nurbs.circle(1) end, "write sg.nurbs.circle{ radius = … }")
  message = check.fails(function() p:write "slab.vtk" end,
    "file must be a name that ends with .xml, .txt or .mesh (name of the file)")
  check.equal(select(2, message:gsub("a name that ends", "")), 1)
  check.fails(function() sg.nurbs.line { from = { 0, 1.5 }, to = { 0, 1.5 } } end,
    "the ends of a line must differ, got (0, 1.5) twice")
  check.equal(tostring(sg.rigid.plane { point = { 0, -1 }, normal = { 0, 1 } }),
    "rigid plane through (0, -1), normal (0, 1)")
end)

check.case("wrong geometry", function()
  check.fails(function() sg.shapes.half_annulus { inner = 2, outer = 1 } end, "sg.shapes.half_annulus", "2", "1")
  check.fails(function() sg.nurbs.curve { degree = 2, knots = { 0, 0, 1, 1 }, points = { { 0, 0 }, { 1, 1 } } } end,
    "sg.nurbs.curve", "knot")
  check.fails(function() sg.nurbs.curve { degree = 1, knots = { 0, 0, 1, 1 }, points = { { 0, 0 }, { 1, 1, 1 } } } end,
    "points[2]")
  check.fails(function() sg.nurbs.surface { degrees = { 1, 1 }, knots = { { 0, 0, 1, 1 } }, points = { { 0, 0 } } } end,
    "knots must be a list of 2 lists of numbers (open knot vectors, one per direction)")
end)

check.case("the message begins with the user's line, also in functions, coroutines and tail calls", function()
  local function line() return debug.getinfo(2, "l").currentline end
  local expected
  local function f()
    expected = line() + 1
    local q = sg.shapes.block { size = 3 }
    return q
  end
  check.fails(f, ("errors_test.lua:%d: sg.shapes.block: size"):format(0 + (pcall(f) and 0 or expected)))
  local function tail() expected = line(); return sg.shapes.block { size = 3 } end
  check.fails(tail, ("errors_test.lua:%d: "):format(0 + (pcall(tail) and 0 or expected)))
  local thread = coroutine.create(f)
  local _, message = coroutine.resume(thread)
  check.holds(message, ("errors_test.lua:%d: "):format(expected))
end)

check.case("functions and methods written in Lua are found behind `return`, too, and let coroutines yield through",
  function()
  local body = sg.body { patch = p, elements = { 1, 1 }, order = "N1", material = sg.neo_hookean { E = 1, nu = 0.3 } }
  local model = sg.model { bodies = { body = body }, supports = { bed = { on = body:face "south", drive = "xy" } } }
  local first = debug.getinfo(1, "l").currentline + 1
  local function study() return sg.study { nmae = "a" } end
  local function run() return model:run { { steps = 0 } } end
  local function rows() return sg.csv.write(3, {}) end
  for i, tail in ipairs { study, run, rows } do
    check.fails(tail, ("errors_test.lua:%d: %s"):format(first + i - 1,
      ({ "sg.study", "model:run", "sg.csv.write" })[i]))
  end
  local thread = coroutine.create(function()
    return model:run({ { steps = 2, bed = { 0, 0 } } }, { on_step = function(info) coroutine.yield(info.step) end })
  end)
  for step = 1, 2 do check.equal({ coroutine.resume(thread) }, { true, step }) end
  local _, finished = coroutine.resume(thread)
  check.equal(finished.steps, 2)
end)

check.case("errors of the library written in Lua appear at the user's line too", function()
  local expected = debug.getinfo(1, "l").currentline + 1
  local _, message = pcall(function() sg.csv.write(3, {}) end)
  check.holds(message, ("errors_test.lua:%d: sg.csv.write"):format(expected))
end)

check.case("an undefined variable is an error", function()
  check.fails(function() return undefined_name end, "errors_test.lua", "undefined variable 'undefined_name'")
  local model = 1
  check.fails(function() return modle, model end, "undefined variable 'modle'; did you mean 'model'?")
  check.fails(function() return pritn end, "did you mean 'print'?")
  check.fails(function() return quit end, "alone on a line it ends the prompt")
  check.fails(function() sg.boddy {} end, "errors_test.lua", "there is no sg.boddy; did you mean 'body'?")
  check.fails(function() return sg.shapes.rectangel end, "there is no sg.shapes.rectangel; did you mean 'rectangle'?")
  check.fails(function() sg.foo = 1 end, "errors_test.lua", "sg.foo cannot be assigned", "local variables")
  check.fails(function() sg.body = nil end, "sg.body cannot be assigned")
  check.fails(function() sg.shapes.disc = 3 end, "sg.shapes.disc cannot be assigned")
  check.equal({ type(sg.body), type(sg.shapes.disc) }, { "function", "function" })
end)

check.case("a script that fails ends with status 1, the message and a traceback", function()
  local output, status = check.script [[
local sg = require "signorini"
local function die()
  return sg.shapes.half_annulus{ inner = 0.3, outer = "0.5" }
end
local patch = die()
]]
  check.equal(status, 1)
  check.holds(output, "signorini: study.lua:3: sg.shapes.half_annulus: outer must be a positive number (outer radius), "
    .. "got the string '0.5'. Hint: remove the quotes", "stack traceback", "study.lua:5: in main chunk")
end)

check.case("numbers beyond the range of an axis are rejected", function()
  local file = check.file "picture.png"
  local wide, decades = "must be within ±1e300 and span at least 1e-300", "at most"
  local huge, tiny = { 1e308, -1e308, 1 }, { 1e-320, 0, 0 }
  check.fails(function() sg.chart { file = file, x = { 1, 2, 3 }, { y = huge } } end, "sg.chart: ", wide)
  check.fails(function() sg.chart { file = file, x = huge, { y = { 1, 2, 3 } } } end, wide)
  check.fails(function() sg.chart { file = file, x = { 1, 2, 3 }, { y = tiny } } end, wide)
  check.fails(function()
    sg.chart { file = file, x = { 1, 2 }, { y = { 1, 2 } }, hlines = { { 1e308, "a" }, { -1e308, "b" } } }
  end, wide)
  check.fails(function()
    sg.heatmap { file = file, x = { 1, 2 }, y = { 1 }, values = { { 1e308, -1e308 } } }
  end,
    "sg.heatmap: ", wide)
  check.fails(function()
    sg.heatmap { file = file, x = { 1, 2 }, y = { 1 }, log = true, values = { { 1e-200, 1e200 } } }
  end, decades)
  sg.heatmap { file = file, x = { 1, 2 }, y = { 1 }, log = true, values = { { 7, 7 } } }
end)

check.case("the traceback of a script holds its own frames; those of the library only where that is at fault",
  function()
  local script = [[
local sg = require "signorini"
local function choose() local options = sg.robust{ bogus = 1 } return options end
local function study() local options = choose() return options end
study()
]]
  local output = check.script(script)
  check.holds(output, "signorini: study.lua:2: sg.robust: unknown argument 'bogus'",
    "stack traceback:\n\tstudy.lua:2: in upvalue 'choose'\n\tstudy.lua:3: in local 'study'\n"
      .. "\tstudy.lua:4: in main chunk\n")
  check.holds(check.script [[error("a case: no luck\nstack traceback:\n\nits end", 0)]],
    "signorini: a case: no luck\nstack traceback:\n\nits end\nstack traceback:\n\tstudy.lua:1: in main chunk\n")
  check.holds(check.script [[require("signorini.call.lists").sorted_names(1)]], "lua/signorini/call/lists.lua:",
    "[C]: in ")
end)

check.case("syntax errors, missing files and thrown values are reported", function()
  local output, status = check.script "local x = = 1"
  check.equal(status, 1)
  check.holds(output, "signorini: study.lua:1: unexpected symbol near '='")
  output, status = check.program { "/nowhere/study.lua" }
  check.equal(status, 1)
  check.holds(output, "/nowhere/study.lua")
  output, status = check.script "error(setmetatable({}, { __tostring = function() return 'an object' end }))"
  check.equal(status, 1)
  check.holds(output, "signorini: an object")
  check.ended({ check.script "print(sg)" }, 1,
    [[undefined variable 'sg'; write local sg = require "signorini" at the top]])
end)

check.case("shapes that a far corner makes degenerate in floating point, lists with names", function()
  check.fails(function() sg.shapes.block { size = { 1, 1, 1 }, corner = { 1e300, 0, 0 } } end,
    "sg.shapes.block: size x = 1 is lost in rounding error next to corner x = 1e+300")
  check.fails(function() sg.shapes.rectangle { width = 1, height = 1, corner = { 0, 1e20 } } end,
    "height = 1 is lost in rounding error next to corner y = 1e+20")
  check.fails(function() p:translate { 1, 2, Fix = 1 } end, "got a list of 2 values with the key 'Fix'")
end)

check.case("help in a script is an error that says where to find it", function()
  check.fails(function() return help end, "undefined variable 'help'; in a script it is sg.help")
end)
