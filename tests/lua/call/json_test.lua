-- JSON files: what is written is read back, files are written atomically, invalid values and files are reported.

require "check"

local folder = check.folder()
local file = folder .. "/a.json"

--- What reading a text gives.
local function read(text)
  core.write_file(file, text)
  return sg.json.read(file)
end

check.case("values are read back as they were, and the text is readable", function()
  local value = { name = "ξ \"quoted\"\n", steps = 46, penalty = 100.0, tiny = 2 ^ -1074, third = 1 / 3,
                  negative = -0.0, largest = math.maxinteger, smallest = math.mininteger, done = true, failed = false,
                  meshes = { 1, 2.5, "m3" }, nested = { { a = 1 }, { b = { {} } } } }
  sg.json.write(file, value)
  local back = sg.json.read(file)
  local function compare(a, b)
    if type(a) ~= "table" then
      check.equal(a, b)
      return check.equal(math.type(a), math.type(b))
    end
    for key, entry in pairs(a) do compare(entry, b[key]) end
    for key in pairs(b) do check.equal(a[key] ~= nil, true) end
  end
  compare(value, back)
  check.equal(1 / back.negative, -math.huge)
  sg.json.write(file, { b = { 1, 2 }, a = "x" })
  check.equal(core.read_file(file), '{\n  "a": "x",\n  "b": [\n    1,\n    2\n  ]\n}\n')
  for _, single in ipairs { false, 0, "", "text", 1e300 } do
    sg.json.write(file, single)
    check.equal(sg.json.read(file), single)
  end
end)

check.case("random numbers are read back to the last bit", function()
  math.randomseed(7)
  local numbers = {}
  for i = 1, 200 do numbers[i] = (math.random() - 0.5) * 10 ^ math.random(-200, 200) end
  sg.json.write(file, numbers)
  check.equal(sg.json.read(file), numbers)
end)

check.case("null, empty objects and lists, large integers, byte-order mark, escapes", function()
  check.equal(read "null", nil)
  local gaps = read '{ "a": null, "b": [1, null, 3] }'
  check.equal({ gaps.a, gaps.b[1], gaps.b[2], gaps.b[3] }, { nil, 1, nil, 3 })
  check.equal({ next(read "{}"), next(read "[]") }, {})
  sg.json.write(file, {})
  check.equal(core.read_file(file), "[]\n")
  local integers = read "[9223372036854775807, -9223372036854775808, 9223372036854775808, 18446744073709551616, 1.0]"
  check.equal(integers, { math.maxinteger, math.mininteger, 2.0 ^ 63, 2.0 ^ 64, 1.0 })
  check.equal({ math.type(integers[1]), math.type(integers[3]), math.type(integers[5]) },
    { "integer", "float", "float" })
  check.equal(read "\xEF\xBB\xBF[1]\r\n", { 1 })
  check.equal(read [["\u03be\n\ud83d\ude00\u0000"]], "ξ\n😀\0")
  check.equal(read '{ "a": 1, "a": 2 }'.a, 2)
end)

check.case("invalid files are reported with line and column", function()
  local wrong = {
    [""] = "line 1, column 1: unexpected end of input", ['{\n  "a": [1,\n}'] = "line 3, column 1: unexpected '}'",
    ['{ "a": 1 "b": 2 }'] = "line 1, column 12: unexpected string literal; expected '}'",
    ["[NaN]"] = "line 1, column 2",
    ["{'a': 1}"] = "line 1, column 2: invalid literal", ["[1,\n 2] x"] = "line 2, column 5",
    ["[1,\n 2, 1e999]"] = "line 2, column 5: the number 1e999 is too large",
    ["[" .. ("9"):rep(400) .. "]"] = "line 1, column 2: the number 99999999999999999999… is too large",
    ['["' .. ("x"):rep(100000)] = "column 100003: invalid string: missing closing quote",
    ['"\xFF"'] = "ill-formed UTF-8 byte", ["// a comment\n1"] = "line 1, column 1",
    [("["):rep(100000) .. ("]"):rep(100000)] = "the data are nested deeper than 100 tables",
  }
  for text, message in pairs(wrong) do
    local whole = check.fails(function() read(text) end, "json_test.lua:", "sg.json.read: '" .. file .. "': ", message)
    check.at_most("the length of the message", #whole, 300)
  end
  check.fails(function() sg.json.read(folder .. "/none.json") end, "json_test.lua:", "sg.json.read: cannot read",
    "none.json")
  check.fails(function() sg.json.read(folder) end, "sg.json.read: ")
end)

check.case("invalid values are not written, and the old file remains", function()
  sg.json.write(file, { 1 })
  local cyclic = {}
  cyclic.self = cyclic
  local wrong = {
    { { a = 0 / 0 }, "it.a is nan" }, { { 1, { math.huge } }, "it[2][1] is infinity" }, { print, "got a function" },
    { { a = { b = print } }, "it.a.b is a function" }, { { 1, 2, a = 3 }, "it mixes names and a list" },
    { { [0] = 1 }, "the key the number 0" }, { { [true] = 1 }, "which is neither a name nor part of a list" },
    { { 1, nil, 3 }, "it[2] is nothing" }, { cyclic, "is nested deeper than 100 tables: does one contain itself?" },
    { sg.shapes.block { size = { 1, 1, 1 } }, "got a patch" }, { { a = "\xFF" }, "value.a is not valid UTF-8" },
    { { ["\xFF"] = 1 }, "a name in sg.json.write: value is not valid UTF-8" },
  }
  for _, case in ipairs(wrong) do
    check.fails(function() sg.json.write(file, case[1]) end, "json_test.lua:", "sg.json.write: ", case[2])
  end
  check.equal(sg.json.read(file), { 1 })
  check.fails(function() sg.json.write(file, nil) end, "sg.json.write: value is missing: it must be plain data (")
  check.fails(function() sg.json.write(folder .. "/none/a.json", 1) end, "sg.json.write: cannot write",
    'Hint: create it first, sg.mkdir "' .. folder .. '/none"')
  check.fails(function() return sg.json.dump end, "there is no sg.json.dump")
end)

check.case("results are written for other programs", function()
  local model = scenes.model{ bodies = { a = { elements = { 1, 1 } } },
    supports = { bed = { on = "south", fix = "xy" }, grip = { on = "north", drive = "xy" } } }
  local run = model:run { { steps = 2, grip = { 0, -0.1 } } }
  sg.json.write(file, { step = run:column "step", fy = run:column "grip.fy", energy = model:energy().stored })
  local back = sg.json.read(file)
  check.equal(back.step, { 1, 2 })
  check.equal(back.fy, run:column "grip.fy")
  check.fails(function() sg.json.write(file, run) end, "json_test.lua:", "sg.json.write: value must be plain data")
end)
