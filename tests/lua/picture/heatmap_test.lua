-- sg.heatmap: files, options, invalid arguments.

require "check"

local folder = check.folder()

--- The bytes of a map of numbers, with some arguments replaced.
local function draw(more, ending)
  local options = { file = folder .. "/map" .. (ending or ".svg"), x = { "N2", "N4", -0.25 }, y = { 10, -2.5e-6 },
                    values = { { 1, 2, 3 }, { 4, 5, 6 } }, size = { 640, 400 } }
  for key, value in pairs(more or {}) do options[key] = value end
  if options.panels then options.values = nil end
  sg.heatmap(options)
  return core.read_file(options.file)
end

local function count(text, part)
  local found, at = 0, 1
  while true do
    local from, to = text:find(part, at, true)
    if not from then return found end
    found, at = found + 1, to + 1
  end
end

local categories = { { name = "converged" }, { name = "cycling" }, { name = "inverted" } }
local outcomes = { { "converged", "cycling", "converged" }, { "converged", nil, "converged" } }

check.case("each file name ending selects a format; files are reproducible", function()
  local beginnings = { [".png"] = "\137PNG", [".svg"] = "<", [".pdf"] = "%PDF" }
  for ending, beginning in pairs(beginnings) do
    local first = draw({ title = "map" }, ending)
    check.equal(first:sub(1, #beginning), beginning)
    check.equal(draw({ title = "map" }, ending) == first, true)
  end
end)

check.case("every option changes the map", function()
  local seen = {}
  local variants = {
    {}, { title = "t" }, { xlabel = "x" }, { ylabel = "y" }, { label = "error" }, { log = true }, { range = { 0, 9 } },
    { colormap = "magma" }, { size = { 640, 500 } }, { x = { "a", "b", "c" } }, { y = { "a", "b" } },
    { values = { { 1, 2, 3 }, { 4, 5 } } }, { values = { { 1, 0 / 0, 3 }, { 4, 5, 6 } } }, { texts = { { "a" }, {} } },
    { values = outcomes, categories = categories },
    { values = outcomes, categories = { { name = "converged", good = false }, { name = "cycling" },
      { name = "inverted" } } },
    { values = outcomes, categories = { { name = "converged", color = "#0000ff" }, "cycling", "inverted" } },
    { values = outcomes, categories = { "converged", { name = "cycling", color = 9 }, "inverted" } },
  }
  for i, variant in ipairs(variants) do
    local bytes = draw(variant)
    if seen[bytes] then error(("variants %d and %d look alike"):format(seen[bytes], i)) end
    seen[bytes] = i
  end
end)

check.case("names, numbers, texts and the legend's rows", function()
  local svg = draw { texts = { { "ab", 12.5, "" }, { nil, nil, -1 } } }
  check.holds(svg, ">N4<", ">−0.25<", ">10<", ">−2.5×10<tspan", ">−6</tspan>", ">ab<", ">12.5<", ">−1<")
  svg = draw { values = outcomes, categories = categories }
  check.holds(svg, ">converged<", ">cycling<")
  check.equal(count(svg, ">inverted<"), 0)
  check.equal(draw { values = outcomes, categories = { "converged", "cycling", "inverted" } } == svg, true)
  svg = draw { values = outcomes, categories = { { name = "converged", color = "#12aBcd" }, "cycling" } }
  check.equal(count(svg, "fill:rgb(7.058824%,67.058824%,80.392157%)"), 4 + 1) -- cells and legend
  check.equal(draw { values = outcomes, categories = { "converged", { name = "cycling", color = 2 }, "inverted" } } ==
              draw { values = outcomes, categories = { "converged", "inverted", "cycling" } }, true)
end)

check.case("infinity is a blank like nan", function()
  local blank = draw { values = { { 1, 0 / 0, 3 }, { 4, 5, 0 / 0 } }, texts = { { 1, nil, 3 }, {} } }
  check.equal(draw { values = { { 1, 1 / 0, 3 }, { 4, 5, -1 / 0 } }, texts = { { 1, 1 / 0, 3 }, {} } } == blank, true)
end)

check.case("powers of ten do not mix with long numbers in one axis", function()
  local svg = draw { x = { 1e6, 1e5, 1e4 }, y = { 1e3, 2.5e4 } }
  check.holds(svg, ">10<tspan", ">6</tspan>", ">5</tspan>", ">4</tspan>", ">1000<", ">25000<")
  svg = draw { x = { 1e-5, -5e-4, 1e-3 }, y = { 1e3, 2.5e6 } }
  check.holds(svg, ">10<tspan", ">−5</tspan>", ">−5×10<tspan", ">−4</tspan>", ">0.001<", ">2.5×10<tspan")
  check.holds(draw { x = { 1, 1e4, 1e5 }, y = { 1e3, "a" } }, ">1<", ">10000<", ">100000<")
end)

check.case("the smallest and the largest value have distinct colors on a logarithmic bar, too", function()
  local seen = 0
  for digits = 101, 199 do
    local low, high = digits * 1e-10, digits * 1e-3
    local outside = 10 ^ math.log(low, 10) > low or 10 ^ math.log(high, 10) < high
    if outside and seen < 3 then
      seen = seen + 1
      local values = { { low, 1e-4, 1e-4 }, { 1e-4, 1e-4, high } }
      local given = draw { log = true, values = values, range = { low, high } }
      check.equal(draw { log = true, values = values } == given, true)
    end
  end
  check.equal(seen, 3)
end)

check.case("maps side by side share names and legend", function()
  local svg = draw { categories = categories, panels = {
    { title = "before", values = outcomes }, 
    { title = "after", values = { { "converged" }, { "converged", "converged" } } } } }
  check.holds(svg, ">before<", ">after<")
  check.equal(count(svg, ">N4<"), 2)
  check.equal(count(svg, ">converged<"), 1)
  local columns = { { title = "before", values = outcomes }, { title = "after", values = outcomes } }
  check.equal(draw { categories = categories, panels = columns, columns = 1 } ==
              draw { categories = categories, panels = columns, columns = 2 }, false)
end)

check.case("wrong arguments", function()
  local wrong = {
    { { x = {} }, "x must be a list of at least one name" },
    { { x = { "a", {}, "c" } }, "x[2] must be a string or a number" },
    { { values = { { 1, 2, 3 } } }, "values must be a list of 2 rows, one for each y" },
    { { values = { { 1, 2, 3, 4 }, { 1 } } }, "values[1] must be a list of 3 entries, one for each x" },
    { { values = { { 1, 2, 3 }, 7 } }, "values[2] must be a list of 3 entries" },
    { { values = { { 1, "converged", 3 }, { 4, 5, 6 } } }, "values[1][2] must be a number, nil or nan", "categories" },
    { { values = { {}, {} } }, "all cells of the map are blank" },
    { { log = true, values = { { 1, 0, 3 }, { 4, 5, 6 } } },
      "values[1][2] must be above 0 on a logarithmic scale, got 0" },
    { { range = { 2, 1 } }, "range must be increasing" },
    { { colormap = "jet" }, "colormap must be" },
    { { file = folder .. "/map.gif" }, "map.gif", ".png, .svg or .pdf" },
    { { categories = categories }, "values[1][1] must be the name of a category" },
    { { categories = categories, values = { { "converge" }, {} } }, "values[1][1] is 'converge'",
      "did you mean 'converged'?" },
    { { categories = categories, values = outcomes, log = true },
      "log cannot be combined with categories, it is for maps of numbers" },
    { { categories = {}, values = outcomes }, "categories must be a list of at least one category" },
    { { categories = { "converged", "converged" }, values = outcomes },
      "categories[2] has the name 'converged' of an earlier one" },
    { { categories = { { name = "a", color = "blue" } }, values = outcomes }, "categories[1].color", "#d55e00" },
    { { categories = { { name = "a", color = 22 } }, values = outcomes }, "categories[1].color", "from 1 to 21" },
    { { categories = { { title = "converged" } }, values = outcomes }, "categories[1]: unknown argument 'title'" },
    { { texts = { { {} }, {} } }, "texts[1][1] must be a string or a number" },
  }
  for _, case in ipairs(wrong) do
    check.fails(function() draw(case[1]) end, "heatmap_test.lua", "sg.heatmap", table.unpack(case, 2))
  end
  local map = { file = folder .. "/map.svg", x = { 1 }, y = { 1 } }
  map.panels = { { values = { { 1 }, { 2 } } } }
  check.fails(function() sg.heatmap(map) end, "panels[1].values must be a list of 1 row,")
  map.values = { { 1 } }
  check.fails(function() sg.heatmap(map) end, "values cannot be combined with panels, each of which has its own")
  map.values, map.panels = nil, {}
  check.fails(function() sg.heatmap(map) end, "panels must be a list of at least one map")
end)
