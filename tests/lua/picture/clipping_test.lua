-- No text of a picture, chart or heat map is cut off: its outermost pixels are white, whatever its size, words and
-- numbers. What does not fit is an error that says what to do.

require "check"

local folder = check.folder()
local rim_program = (arg[-1]:match "^(.*)/[^/]*$" or ".") .. "/tests/rim"

--- { width, height, pixels of the rim that are not white } of each file.
local function rims(files) return load((check.shell(rim_program .. " " .. table.concat(files, " "))))() end

local function plane()
  return scenes.model{ bodies = { strip = { size = {3, 1}, elements = { 4, 2 }, contact = "north" } },
    supports = { foot = { on = "south", fix = "xy" }, top = { on = "north", drive = "xy" } } }
end

local function solid()
  return scenes.model{ bodies = { block = { size = { 2, 1, 0.6 }, elements = { 2, 2, 1 }, contact = "back" } },
    supports = { foot = { on = "front", fix = "xyz" }, top = { on = "back", drive = "xyz" } } }
end

local words = "Normal pressure ΔP_max of the leading edge, with σ_xx / E = 1.5·10⁹ and many more words"
local numbers = { 1e-12, 123456789 }
local sizes = { { 300, 200 }, { 560, 200 }, { 300, 700 }, { 900, 600 }, { 560 } }
local large = { { 2000, 1400 } }

--- The smallest size at which a kind of figure has to fit: all at 900 x 600.
local function must_fit(size) return #size == 2 and math.min(size[1] / 900, size[2] / 600) >= 1 end

--- Draws a kind of figure at all sizes; `draw(arguments, number)` gets file and size. `slow`: with one of the numbers
--- at each size.
local function each_size(kind, draw, list, slow)
  check.case(kind .. ": no text is cut off", function()
    local files, sized = {}, {}
    for i, size in ipairs(list or sizes) do
      for n, number in ipairs(slow and { numbers[i % #numbers + 1] } or numbers) do
        local file = ("%s/%s-%s-%d.png"):format(folder, kind:gsub("%W", ""), table.concat(size, "x"), n)
        local ok, message = pcall(draw, { file = file, size = #size == 2 and size or size[1] }, number)
        if ok then
          files[#files + 1], sized[#files + 1] = file, size
        elseif must_fit(size) or not (message:find "larger size" or message:find "larger picture") then
          error(("%s at %s: %s"):format(kind, table.concat(size, " x "), message), 0)
        end
      end
    end
    for i, rim in ipairs(rims(files)) do
      if rim[3] > 0 then error(("%s: %d pixels of ink at the rim"):format(files[i], rim[3]), 0) end
      if #sized[i] == 2 then check.equal({ rim[1], rim[2] }, sized[i]) else check.equal(rim[1] <= sized[i][1], true) end
    end
    check.equal(#files >= (slow and 1 or #numbers), true)
  end)
end

local function picture(of)
  return function(arguments, number)
    for key, value in pairs(of) do arguments[key] = value end
    arguments.factor = (arguments.field or arguments.fields) and number or nil
    sg.picture(arguments)
  end
end

check.case("the frame has the expected size", function()
  core.write_file(folder .. "/ink.png",
      "\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00\x00\x03\x00\x00\x00\x03\x08\x02" ..
      "\x00\x00\x00\xd9\x4a\x22\xe8\x00\x00\x00\x14\x49\x44\x41\x54\x78\xda\x63\xf8\x0f\x03\x0c\x10\x8a\x93\x93" ..
      "\x93\x01\x2e\x06\x00\x71\x00\x18\x04\xbc\x6b\x56\x3f\x00\x00\x00\x00\x49\x45\x4e\x44\xae\x42\x60\x82")
  check.equal(rims { folder .. "/ink.png" }, { { 3, 3, 1 } })
end)

local strip, block = plane(), solid()
local stage = "a stage with a long name"
local states = strip:run({ { name = stage, steps = 2, top = { 0.2, -0.1 } } }, { states = 3 }):states()
local solids = block:run({ { name = stage, steps = 2, top = { 0.2, 0, -0.1 } } }, { states = 3 }):states()

local kinds = {
  ["a picture"] = { model = strip, field = "syy", title = words, label = words },
  ["a picture with marks"] = { model = strip, field = "uy", marks = { { x = { 3.2, 0.9 }, text = words } } },
  ["a close-up"] = { model = strip, field = "syy", title = words, inset = { 1, 2, 0.5, 0.9 } },
  ["a sheet"] = { states = states, field = "von_mises", title = words },
  ["fields side by side"] = { model = strip, fields = { "F12", "I1", "pressure" }, title = words },
  ["a solid"] = { model = block, field = "szz", title = words, label = words },
  ["a solid cut open"] = { model = block, field = "szz", cut = "-y", camera = "front", label = words },
  ["a sheet of solids"] = { states = solids, field = "szz" },
  ["a row of solids"] = { states = solids, field = "szz", columns = 3, title = words },
  ["solids side by side"] = { model = block, fields = { "szz", "I1" }, columns = 2, title = words },
  ["a close-up of a solid"] = { model = block, field = "szz", inset = { 0.5, 1.5, 0, 1, 0.3, 0.6 } },
}
local names = {}
for name in pairs(kinds) do names[#names + 1] = name end
table.sort(names)
for _, name in ipairs(names) do each_size(name, picture(kinds[name]), nil, true) end

local function curves(number, scale)
  local x, list = {}, {}
  for i = 1, 20 do x[i] = i * (scale or 1) end
  for c = 1, 6 do
    list[c] = { label = c == 1 and words or "N2-N2." .. c, y = {} }
    for i = 1, 20 do list[c].y[i] = number * (1 + c * i / 20) end
  end
  list.x = x
  return list
end

local function chart(of)
  return function(arguments, number)
    for key, value in pairs(curves(number, of.scale)) do arguments[key] = value end
    for key, value in pairs(of) do if key ~= "scale" then arguments[key] = value end end
    if type(arguments.size) == "number" then arguments.size = { arguments.size, arguments.size } end
    sg.chart(arguments)
  end
end

local function heatmap(of)
  return function(arguments, number)
    if type(arguments.size) == "number" then arguments.size = { arguments.size, arguments.size } end
    if not of.categories and not of.panels then
      arguments.values = { { number, 2 * number }, { 3 * number, 4 * number } }
    end
    if not of.categories then arguments.label = words end
    arguments.x, arguments.y = { 123456789 * number, "a long name" }, { "m1", "another long name" }
    arguments.xlabel, arguments.ylabel, arguments.title = words, words, words
    for key, value in pairs(of) do arguments[key] = value end
    sg.heatmap(arguments)
  end
end

sizes[#sizes] = nil -- charts have a size of two numbers
local labels = { title = words, xlabel = words, ylabel = words }
local function with(more)
  for key, value in pairs(labels) do more[key] = more[key] or value end
  return more
end
each_size("a chart", chart(with {}))
each_size("a logarithmic chart", chart(with { log = "xy", scale = 1e5, legend_title = words }))
each_size("a chart of large abscissae", chart(with { scale = 123456789 }))
each_size("a chart with lines and an inset", chart(with { inset = { xrange = { 2, 4 } }, hlines = { { 0, words } },
                                                          vlines = { { 20, "the end" } } }))
local twenty = { legend_title = words }
for c = 1, 20 do twenty[c] = { label = ("%s, number %d"):format(words, c), x = { 1, 2, 3 }, y = { c, c + 1, c } } end
each_size("a chart of twenty long names", chart(with(twenty)))
each_size("a chart with names on its axis", chart(with { xrange = { 1, 3.1 },
  xticks = { { 1, "a first name of some words" }, { 2, "second" }, { 3, "the name of the last one" } } }))
local meshes = {}
for m = 1, 30 do meshes[m] = { m, "mesh number " .. m } end
each_size("a chart with thirty names on its axis", chart(with { xticks = meshes }))
each_size("a heat map", heatmap {})
each_size("a heat map of long names", heatmap { x = { words, "N2" }, y = { "m1", words } })
each_size("a heat map of outcomes", heatmap {
  categories = { { name = "completed" }, { name = words } },
  values = { { "completed", words }, { words, "completed" } } })
each_size("heat maps side by side", heatmap {
  panels = { { title = words, values = { { 1, 2 }, { 3, 4 } } }, { title = "b", values = { { 1, 2 }, { 3, 4 } } } } })

numbers = { 123456789 }
each_size("large picture", picture(kinds["a picture"]), large)
each_size("large sheet of close-ups",
  picture { states = states, fields = { "sxx", "syy" }, inset = { 1, 2, 0.5, 0.9 } }, large)
each_size("large sheet of solids", picture(kinds["a row of solids"]), large)
each_size("large chart", chart(with {}), large)
each_size("large chart of twenty long names", chart(with(twenty)), large)
each_size("large heat map", heatmap { x = { words, "N2" }, y = { "m1", words } }, large)

