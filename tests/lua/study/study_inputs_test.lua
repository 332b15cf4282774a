-- What a study's results depend on: a case whose inputs have changed is solved again, others are taken from the folder.

require "check"

check.case("a changed parameter, function or number that run refers to makes a case run again, and is named", function()
  local script = [[
    local sg = require "signorini"
    local young, meshes = %s, { m1 = { %s, 2 } }
    function scene(mesh) return meshes[mesh][1] * young%s end
    local jobs = sg.study{ name = "n", folder = arg[1], cases = sg.grid{ mesh = { "m1" } },
                           run = function(case) return { f = scene(case.mesh) } end }:execute{}
    print(jobs.rows[1].f)]]
  local folder = check.folder()
  local function output(...) return (check.script(script:format(...), folder)) end
  check.equal(output("10", "6", ""), "n: 1 of 1: mesh=m1: 0.0 s\n60\n")
  check.equal(output("10", "6", ""), ("n: 1 of 1 taken from %s, 0 solved\n60\n"):format(folder))
  check.holds(output("11", "6", ""), ("n: 0 of 1 taken from %s, 1 to solve; again: 1 because scene changed\n")
    :format(folder), "66\n")
  check.holds(output("11", "7", ""), "scene changed", "77\n")
  check.holds(output("11", "7", " + 1"), "scene changed", "78\n")
  check.holds(output("11", "7", " + 1"), "0 solved\n78\n")
end)

check.case("globals and modules of the user count, also those that are there before the first study", function()
  local folder, modules = check.folder(), check.folder()
  local function output(number, factor)
    core.write_file(modules .. "/helper.lua", ("return { double = function(x) return %s * x end }"):format(factor))
    return (check.script(([[
      local sg = require "signorini"
      package.path = %q -- without the library's folder
      local helper = require "helper"
      start = %s
      sg.study{ name = "n", folder = arg[1], cases = { { a = 1 } }, run = function()
        return { f = helper.double(start) }
      end }:execute{}]]):format(modules .. "/?.lua", number), folder))
  end
  output("1", "2")
  check.holds(output("1", "2"), "1 of 1 taken from", "0 solved")
  check.holds(output("2", "2"), "1 because start changed")
  check.holds(output("2", "3"), "1 because helper changed")
end)

check.case("a changed object that run refers to makes a case run again", function()
  local folder = check.folder()
  local function output(young, width)
    return (check.script(([[
      local sg = require "signorini"
      local soft, patch = sg.neo_hookean{ E = %s, nu = 0.3 }, sg.shapes.rectangle{ width = %s, height = 1 }
      sg.study{ name = "n", folder = arg[1], cases = { { a = 1 } }, run = function()
        return { knows = soft ~= nil and patch ~= nil }
      end }:execute{}]]):format(young, width), folder))
  end
  output("1", "3")
  check.holds(output("1", "3"), "1 of 1 taken from", "0 solved")
  check.holds(output("2", "3"), "1 because soft changed")
  check.holds(output("2", "3.000001"), "1 because patch changed")
end)

--- What execute says of a study whose run refers to an object that is made by `text`; only the differences between two
--- calls matter.
local function object_study(folder, text)
  return (check.script(([[
    local sg = require "signorini"
    local function slab(E, height, wide)
      return sg.body{ patch = sg.shapes.rectangle{ width = 2, height = height or 1 }, elements = {2, 2}, order = "N2",
                      contact = "north", material = sg.neo_hookean{ E = E or 1, nu = 0.3 } }
    end
    local function pressed(penalty, radius, stages, side)
      local slab, disc = slab(), sg.rigid.cylinder{ center = {1, 1.5}, radius = radius or 0.5 }
      local model = sg.model{
        bodies   = { slab = slab },
        supports = { bed = { on = slab:face(side or "south"), fix = "xy" }, push = { on = disc, drive = "y" } },
        contacts = { top = { slave = slab:face "north", master = disc, penalty = penalty } } }
      if stages then model:run(stages) end
      return model
    end
    local object = %s
    sg.study{ name = "n", folder = arg[1], cases = { { a = 1 } }, run = function()
      return { known = object ~= nil }
    end }:execute{}]]):format(text), folder))
end

check.case("all data of a captured object count: of a model its laws, obstacles, supports and state", function()
  for _, texts in ipairs {
    { "pressed(10)", "pressed(1000)", "pressed(1000, 0.4)", "pressed(1000, 0.4, nil, 'west')",
      "pressed(10, 0.5, { { steps = 1, push = { -0.01 } } })", "pressed(10, 0.5, { { steps = 1, push = { -0.02 } } })",
      "pressed(10):snapshot()" },
    { "slab()", "slab(1 + 1e-14)", "slab(1, 1 + 1e-14)", "slab():face 'south'", "slab():face 'north'",
      "slab(2):face 'north'" },
    { "sg.rigid.cylinder{ center = {0, 0}, radius = 1 }", "sg.rigid.cylinder{ center = {0, 0}, radius = 2 }" },
  } do
    local folder = check.folder()
    check.holds(object_study(folder, texts[1]), "n: 1 of 1: a=1")
    for i = 2, #texts do
      check.holds(object_study(folder, texts[i]), "1 because object changed")
      check.holds(object_study(folder, texts[i]), "n: 1 of 1 taken from " .. folder .. ", 0 solved\n")
    end
  end
end)

check.case("another version of the program solves again, unless inputs are given", function()
  for given, expected in pairs { [""] = "1 because the program's version changed", ["inputs = {}, "] = "0 solved" } do
    local folder = check.folder()
    local function output()
      return (check.script(([[require "signorini".study{ name = "n", folder = arg[1], cases = { { a = 1 } }, %s
        run = function() return {} end }:execute{}]]):format(given), folder))
    end
    output()
    local version = core.versions.signorini:gsub("%.", "\\.")
    check.shell(("sed -i 's/%s/0.0.1/' %s/cases/*.json"):format(version, folder))
    check.holds(output(), expected)
    check.holds(output(), "0 solved")
  end
end)
