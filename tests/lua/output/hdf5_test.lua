-- Runs as files of HDF5, read by h5py: contents, bases evaluated from the file alone, the listings of the page.

require "check"
local ironing = require "ironing"
local read = require "read_hdf5"
local strip = require "strip"

local folder = check.folder()
local python = "/usr/bin/python3 " -- Debian's, which finds python3-h5py

local function packed(values) return core.pack(values) end

--- The entries of an array of S × … values from number `first` (from 1) on.
local function entry(array, number)
  local size = #array.values // array.shape[1]
  return { table.unpack(array.values, (number - 1) * size + 1, number * size) }
end

local page = core.read_file(core.home .. "/share/doc/use/results.md")
local path = { { name = "press", steps = 4, grip = {0, -0.15} }, { name = "slide", steps = 3, grip = {0.1, -0.15} } }

check.case("a file written as the run goes has what the run has recorded", function()
  local model, file = ironing { order = "N2-N2.2" }, folder .. "/run.h5"
  local profiles, displacements, energies = { [0] = model:profile "interface" }, {}, {}
  local run = model:run(path, {
    states = 3, hdf5 = { file = file, units = { length = "mm", ["grip.fy"] = "kN" } },
    on_step = function(info)
      profiles[info.step], energies[info.step] = model:profile "interface", model:energy()
      displacements[info.step] = core.body_displacement(model, "slab")
      return info.step > 2 and { ["P/mu, 100 %2F"] = info.step / 2 } or nil
    end,
  })
  local found = read(file)
  local root = found["/"].attributes
  check.equal({ root.format, root.schema, root.reason, root.steps, root.iterations },
    { "signorini run", 1, "completed", 7, run.iterations })
  check.equal(root.warnings, run.warnings)
  local origin = core.read_json(root.origin)
  check.equal({ origin.program, origin.version, origin.kernel, origin.script },
    { "signorini", core.release(), core.versions.kernel, arg[0] })
  check.equal(origin.text, core.read_file(arg[0]))
  check.equal(core.read_json(root.path)[2].targets.grip, path[2].grip)

  check.equal(found["/columns"].attributes.names, run:columns())
  for _, name in ipairs(run:columns()) do
    local column = found["/columns/" .. name:gsub("P/mu, 100 %%2F", "P%%2Fmu, 100 %%252F")]
    check.equal(column.shape, { 7 })
    for i, value in ipairs(run:column(name)) do
      if not (value == column.values[i] or value ~= value and column.values[i] ~= column.values[i]) then error(name) end
    end
  end
  check.equal(found["/rows/stage"].values, { "press", "press", "press", "press", "slide", "slide", "slide" })
  local function unit(name) return found[name].attributes.unit end
  check.equal({ unit "/columns/grip.fx", unit "/columns/grip.fy", unit "/columns/grip.ux", unit "/columns/wall" },
    { "consistent units", "kN", "mm", "s" })
  check.equal({ unit "/contacts/interface/gap", unit "/bodies/die/points", unit "/columns/P%2Fmu, 100 %252F" },
    { "mm", "mm", "consistent units" })
  check.equal(found["/columns/interface.fy"].attributes.description, "force on the slave, y")

  check.equal(found["/states/step"].values, { 0, 4, 7 })
  check.equal(found["/states/stage"].values, { "press", "press", "slide" })
  local moved = found["/bodies/slab/displacement"]
  check.equal(moved.shape, { 3, #displacements[4] // 2, 2 })
  for i, step in ipairs { 4, 7 } do check.equal(packed(entry(moved, i + 1)), packed(displacements[step])) end
  check.equal(found["/bodies/slab"].attributes.thickness_direction, 1)
  check.holds(found["/bodies/slab"].attributes.description, "8 x 3 elements")

  check.equal(found["/profiles/step"].values, { 0, 1, 2, 3, 4, 5, 6, 7 })
  local contact = found["/contacts/interface"].attributes
  check.equal({ contact.slave, contact.master, contact.mu, contact.method },
    { "south of die", "north of slab", 0.2, "gpts" })
  check.equal(found["/contacts/interface/X"].values, profiles[0].X)
  for step = 0, 7 do
    for _, key in ipairs { "x", "y", "pressure", "traction", "gap", "area" } do
      check.equal(packed(entry(found["/contacts/interface/" .. key], step + 1)), packed(profiles[step][key]))
    end
    local states = found["/contacts/interface/state"]
    for i, number in ipairs(entry(states, step + 1)) do
      check.equal(states.attributes.states[number + 1], profiles[step].state[i])
    end
  end
  check.equal(found["/energies/stored"].values[8], energies[7].stored)
  check.equal(found["/contacts/interface/resultant/active"].values[8], model:contact_resultant "interface".active)

  -- The same after the run, from the states that it has stored; the model does not change.
  local before = packed(core.body_displacement(model, "die"))
  run:hdf5(folder .. "/after.h5")
  check.equal(packed(core.body_displacement(model, "die")), before)
  local after = read(folder .. "/after.h5")
  for name, array in pairs(found) do
    if not after[name] then error(name .. " is missing") end
    local is_entry = array.shape and array.shape[1] == 8 and after[name].shape[1] == 3
    for i, step in ipairs(is_entry and { 1, 5, 8 } or {}) do
      check.equal(packed(entry(after[name], i)), packed(entry(array, step)))
    end
    if array.shape and not is_entry and name:find "/stage$" == nil then
      check.equal(packed(after[name].values), packed(array.values))
    end
  end
end)

check.case("the listings of the page", function()
  local listings = {}
  for language, code in page:gmatch "```(%w+)\n(.-)```" do
    listings[language] = listings[language] or {}
    table.insert(listings[language], code)
  end
  core.write_file(folder .. "/listing.lua", listings.lua[1])
  check.ended({ check.shell(("cd %s && SIGNORINI_HOME=%s %s -q listing.lua"):format(folder, core.home,
    check.shell(("realpath '%s'"):format(arg[-1])):match "[^\n]+")) }, 0)
  -- A module in place of Matplotlib, which is large.
  core.mkdir(folder .. "/matplotlib")
  core.write_file(folder .. "/matplotlib/__init__.py", "")
  core.write_file(folder .. "/matplotlib/pyplot.py", [[
def plot(x, y): print("plotted", len(x), len(y))
def ylabel(text): print(text)
def figure(): pass
def show(): print("shown")
]])
  core.write_file(folder .. "/plot.py", listings.python[1])
  check.ended({ check.shell(("cd %s && %splot.py"):format(folder, python)) }, 0, "completed 40 ['bed.fx'",
    "plotted 40 40", "grip.fy in N/mm", "plotted 90 90", "shown")
  check.equal(#read(folder .. "/states.h5")["/states/step"].values, 11)
  for _, language in ipairs { "python", "julia", "matlab" } do
    check.equal(select(2, listings[language][1]:gsub("\n", "\n")) <= 12, true)
  end
end)

--- Compares points from the file, by the page's functions, with those of the model.
local function evaluated(model, file, points)
  local code = page:match "```python\n(from math import comb.-)```"
  local lines = { code, "import h5py", ('f = h5py.File("%s", "r")'):format(file) }
  for _, point in ipairs(points) do
    local xi = table.concat(point.xi, ", ")
    lines[#lines + 1] = ('for state in (None, -1): print(*("%%.17g" %% x for x in position(f["bodies/%s"], (%s), '
      .. "state)))"):format(point.body, xi)
  end
  core.write_file(folder .. "/evaluate.py", table.concat(lines, "\n"))
  local line = check.ended({ check.shell(python .. folder .. "/evaluate.py") }, 0):gmatch "[^\n]+"
  for _, point in ipairs(points) do
    local reference, current = {}, {}
    for number in line():gmatch "%S+" do reference[#reference + 1] = tonumber(number) end
    for number in line():gmatch "%S+" do current[#current + 1] = tonumber(number) end
    check.near(reference, point.X, 1e-12)
    for d, axis in ipairs { "x", "y", #current == 3 and "z" or nil } do
      check.within(point.body .. " u" .. axis, current[d] - reference[d],
        model:sample(point.body, "u" .. axis, point.xi), 1e-12)
    end
  end
end

for _, order in ipairs { "N2", "N2-N2.2", "N3" } do
  check.case(order .. ": the shape, evaluated from the file alone", function()
    local model, file = ironing { order = order }, folder .. "/shape.h5"
    model:run(path, { hdf5 = file })
    local points = {}
    for _, xi in ipairs { { 0, 0 }, { 1, 1 }, { 0.5, 1 }, { 0.37, 0.81 }, { 0.125, 0.9 } } do
      points[#points + 1] = { body = "slab", xi = xi, X = { 3 * xi[1], xi[2] } }
    end
    points[#points + 1] = { body = "die", xi = { 0.5, 0 }, X = { 0.75, 1 } }
    points[#points + 1] = { body = "die", xi = { 0.5, 1 }, X = { 0.75, 1.2 } }
    evaluated(model, file, points)
  end)
end

check.case("solids with layers of different degrees and a tie", function()
  local ball = sg.rigid.sphere { center = { 1, 1, 3 }, radius = 2 }
  local model = scenes.model{
    bodies = { lower = { size = { 2, 2, 1 }, order = { "N2-N2.2", "N3-N4" }, thickness_degree = 2, contact = "back",
        layer = { { 0, 0.5 }, { 0.5, 1 } }, layer_knots = { 2, 1 } }, base = { size = { 2, 2, 1 },
        corner = { 0, 0, -1 }, elements = { 1, 1, 1 }, material = sg.linear_elastic { E = 1, nu = 0.3 } } },
    supports = { bed = { on = "base.front", fix = "xy", drive = "z" } },
    contacts = { touch = { slave = "lower.back", master = ball, penalty = 50, points = 5 } },
    ties = { seam = { slave = "base.back", master = "lower.front" } } }
  local file = folder .. "/solid.h5"
  check.completed(model:run({ { name = "lift", steps = 1, bed = { 0.1 } } }, { hdf5 = file }))
  local points = {}
  for _, xi in ipairs { { 0, 0, 0 }, { 0.3, 0.7, 0.9 }, { 1, 0.5, 1 } } do
    points[#points + 1] = { body = "lower", xi = xi, X = { 2 * xi[1], 2 * xi[2], xi[3] } }
  end
  evaluated(model, file, points)
  local found = read(file)
  check.equal(found["/contacts/touch"].attributes.master, "rigid obstacle")
  check.equal(found["/ties/seam"].attributes.slave, "back of base")
  check.equal(packed(entry(found["/ties/seam/pressure"], 2)), packed(model:tie_profile "seam".pressure))
  check.equal(packed(entry(found["/contacts/touch/tz"], 2)), packed(model:profile "touch".tz))
  check.equal(found["/bodies/lower"].attributes.kind, "solid")
end)

check.case("large arrays are compressed, small ones are not", function()
  local slab = scenes.body{ size = {3, 1}, elements = { 100, 24 }, material = sg.linear_elastic { E = 1, nu = 0.3 } }
  local model = scenes.model{ bodies = { slab = slab }, supports = { bed = { on = "south", fix = "xy" },
                                                                  top = { on = "north", drive = "xy" } } }
  model:run({ { name = "pull", steps = 1, top = { 0, 0.1 } } }, { hdf5 = folder .. "/large.h5" })
  local found = read(folder .. "/large.h5")
  check.equal({ found["/bodies/slab/displacement"].compression, found["/bodies/slab/points"].compression,
                found["/columns/step"].compression }, { "gzip", "gzip", "none" })
  check.equal(found["/contacts"], nil)
end)

check.case("failed runs, rows between steps, states without steps", function()
  local model, file = strip.model(), folder .. "/strip.h5"
  local run = model:run({ { name = "turn", steps = 6, edge = { 90 } } },
    { arc_length = true, hdf5 = file, on_step = function(info) return info.step == 3 and "stop" or nil end })
  local found = read(file)
  check.equal(found["/"].attributes.reason, run.reason)
  check.equal(found["/columns/step"].values, run:column "step")
  check.equal(#found["/rows/stage"].values, run.rows)
  check.equal(found["/columns/edge.angle"].attributes.unit, "degree")

  local failing = ironing()
  run = failing:run({ { name = "too far", steps = 2, grip = { 0, -2 } } }, sg.plain { hdf5 = file })
  check.equal(run.failed, true)
  local root = read(file)["/"].attributes
  check.equal({ root.reason, root.failure, root.steps }, { run.reason, run.failure, run.steps })
  run:hdf5(file)
  check.equal(read(file)["/"].attributes.failure, run.failure)

  run = ironing():run({ { name = "press", steps = 2, grip = { 0, -0.1 } } }, { states = {} })
  run:hdf5(file)
  local bare = read(file)
  check.equal({ #bare["/columns/step"].values, bare["/states"] == nil, bare["/bodies/die/points"] ~= nil },
    { 2, true, true })
end)
