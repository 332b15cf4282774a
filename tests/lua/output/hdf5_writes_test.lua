-- Files of HDF5 on the disk: complete at any moment, also after SIGKILL; resumed runs; files that cannot be written;
-- the program without the module; wrong arguments.

require "check"
local ironing = require "ironing"
local read = require "read_hdf5"

local folder = check.folder()
local python = "/usr/bin/python3 " -- Debian's, which finds python3-h5py
local program = check.shell(("realpath '%s'"):format(arg[-1])):match "[^\n]+"

local path = { { name = "press", steps = 4, grip = {0, -0.15} }, { name = "slide", steps = 3, grip = {0.1, -0.15} } }

local scene = [[
local sg = require "signorini"
local strip = sg.body{ patch = sg.shapes.rectangle{ width = 4, height = 1 }, elements = {4, 1}, order = "N2",
                       contact = "south", material = sg.linear_elastic{ E = 1, nu = 0.3 } }
local model = sg.model{
  bodies = { strip = strip }, supports = { top = { on = strip:face "north", drive = "xy" } },
  contacts = { touch = { slave = strip:face "south", penalty = 10,
                         master = sg.rigid.plane{ point = {0, 0}, normal = {0, 1} } } } }
]]

--- The scene with further lines, run in the folder by a copy of the program or the program itself; output and status.
local function script(lines, before, other)
  core.write_file(folder .. "/script.lua", scene .. lines)
  return check.shell(("cd %s; %s SIGNORINI_HOME='%s' %s -q script.lua"):format(folder, before or "", core.home,
    other or program))
end

check.case("a killed run leaves a complete file with its last step", function()
  core.write_file(folder .. "/long.lua", scene .. [[
model:run({ { name = "press", steps = 100000, top = {0, -0.1} } }, {
  hdf5 = { file = "run.h5", every = 1, states = "all" },
  on_step = function(info) require "signorini.core".write_file("accepted", tostring(info.step)) end })
]])
  for _, rows in ipairs { 1, 7, 20, 33 } do
    os.remove(folder .. "/run.h5")
    check.ended({ check.shell(("cd %s; SIGNORINI_HOME='%s' %s'%s/tests/hdf5/kill.py' %d run.h5 accepted %s "
      .. "-q long.lua"):format(folder, core.home, python, core.home, rows, program)) }, 0, "whole with")
  end
  -- What a killed write has left is removed by the next run.
  script 'model:run({ { steps = 1, top = {0, -0.1} } }, { hdf5 = "run.h5" })'
  for _, name in ipairs(core.list_folder(folder)) do check.equal(name:find "^run%.h5.*%.part$", nil) end
end)

check.case("a resumed run continues the file: no step is missing, none is there twice", function()
  local whole, file, saved = folder .. "/whole.h5", folder .. "/part.h5", folder .. "/part.sgn"
  local function run(options, stop)
    options.checkpoint = { file = saved, every = 2 }
    options.on_step = function(info)
      if info.step == stop then error "ended by the test" end
      return { half = info.step / 2 }
    end
    return ironing():run(path, options)
  end
  run { hdf5 = { file = whole, states = "all" } }
  local expected = read(whole)
  for _, stop in ipairs { 1, 4, 6 } do
    os.remove(saved)
    check.fails(function() run({ hdf5 = { file = file, states = "all", every = 1 } }, stop) end, "ended by the test")
    local part = read(file)
    check.equal({ part["/"].attributes.reason, #part["/columns/step"].values }, { "running", stop - 1 })
    local resumed = run { hdf5 = { file = file, states = "all" }, resume = true }
    check.equal(resumed.reason, "completed")
    local found = read(file)
    for name, array in pairs(expected) do
      if array.values and not (name:find "/wall$") then check.equal(core.pack(found[name]), core.pack(array)) end
    end
    check.equal(found["/states/step"].values, { 0, 1, 2, 3, 4, 5, 6, 7 })
  end
  -- A finished run that is resumed leaves the file as it is; one without its file begins a new one.
  run { hdf5 = { file = file, states = "all" }, resume = true }
  check.equal(read(file)["/profiles/step"].values, { 0, 1, 2, 3, 4, 5, 6, 7 })
  os.remove(file)
  run { hdf5 = file, resume = true }
  check.equal({ #read(file)["/columns/step"].values, #read(file)["/profiles/step"].values }, { 7, 1 })

  core.write_file(file, "not HDF5")
  check.fails(function() run { hdf5 = file, resume = true } end, "hdf5_writes_test.lua:", "model:run: '" .. file,
    "cannot be read by HDF5", "Hint: name another file")
  check.fails(function() run { hdf5 = file } end, "hdf5_writes_test.lua:", "not a file of HDF5, so it is not replaced")
  os.remove(file)
  check.completed(ironing():run({ { name = "press", steps = 1, grip = {0, -0.1} } }, { hdf5 = file }))
  check.fails(function() run { hdf5 = file, resume = true } end, "holds a run on another path", "Hint: ")
  ironing { elements = { die = { 4, 2 }, slab = { 8, 3 } } }:run(path, { hdf5 = file })
  check.fails(function() run { hdf5 = file, resume = true } end, "holds a run of another model", "Hint: ")
end)

check.case("files that cannot be written are errors before the first step", function()
  local model = ironing()
  local function refused(file, ...)
    check.fails(function() model:run(path, { hdf5 = file }) end, "hdf5_writes_test.lua:", "model:run: ", ...)
    check.equal(model:target "grip", { 0, 0 })
  end
  refused(folder .. "/none/run.h5", "none", "sg.mkdir")
  refused(folder, "folder")
  core.write_file(folder .. "/text", "")
  refused(folder .. "/text/run.h5", "text")
  local run = model:run({ { name = "press", steps = 1, grip = {0, -0.1} } })
  check.fails(function() run:hdf5(folder .. "/none/run.h5") end, "hdf5_writes_test.lua:", "run:hdf5: ", "sg.mkdir")
  core.write_file(folder .. "/old.h5", "old")
  check.fails(function() run:hdf5(folder .. "/old.h5") end, "hdf5_writes_test.lua:", "'" .. folder .. "/old.h5' exists")
  check.equal(core.read_file(folder .. "/old.h5"), "old")
  os.remove(folder .. "/old.h5")
  for _ = 1, 2 do run:hdf5(folder .. "/old.h5") end -- the second one replaces the first
  check.equal(read(folder .. "/old.h5")["/"].attributes.reason, "completed")
end)

check.case("a full disk ends the run with an error and leaves the last complete file", function()
  check.ended({ script([[
print(pcall(model.run, model, { { steps = 40000, top = {0, -0.1} } }, { hdf5 = { file = "full.h5", every = 1 } }))
print(model:target "top"[2] < 0)
]], "ulimit -f 400;") }, 0,
    "false", "model:run: cannot write", "full.h5", "that a file of this process may have", "true")
  local found = read(folder .. "/full.h5")
  check.equal(#found["/profiles/step"].values, #found["/columns/step"].values + 1)
end)

check.case("a file that another run replaces is an error; runs one after the other replace it", function()
  local file = folder .. "/shared.h5"
  local options = { hdf5 = { file = file, every = 1 } }
  check.fails(function()
    ironing():run(path, { hdf5 = options.hdf5, on_step = function(info)
      if info.step == 2 then ironing():run(path, options) end
    end })
  end, "hdf5_writes_test.lua:", "model:run: ", "has been replaced by another run or program", "Hint: ")
  check.equal(ironing():run(path, options).reason, "completed")
  check.equal(read(file)["/"].attributes.reason, "completed")
  -- One that was removed is written again.
  ironing():run(path, { hdf5 = options.hdf5, on_step = function() os.remove(file) end })
  check.equal(#read(file)["/columns/step"].values, 7)
end)

check.case("Ctrl-C is the outcome", function()
  local output = script [[
local run = model:run({ { steps = 9, top = {0, -0.1} } }, { hdf5 = "stopped.h5", on_iteration = function(info)
  if info.step == 4 then io.popen("kill -INT " .. io.open "/proc/self/stat":read "n"):close() end
end })
print(run.reason) -- after the signal, Lua may also end the script here
]]
  check.holds(output, "interrupted")
  local found = read(folder .. "/stopped.h5")
  check.equal({ found["/"].attributes.reason, found["/"].attributes.steps }, { "interrupted", 3 })
  check.equal(found["/columns/step"].values, { 1, 2, 3 })
end)

check.case("runs without the option do not load HDF5; a program without the module says what to install", function()
  local output = script [[
model:run{ { steps = 1, top = {0, -0.1} } }
print(io.open "/proc/self/maps":read "a":find "hdf5", package.loaded["signorini.output.hdf5"])
]]
  check.equal(output, "nil\tnil\n")
  check.shell(("cp '%s' %s/program"):format(program, folder))
  output = script('model:run({ { steps = 1, top = {0, -0.1} } }, { hdf5 = "run.h5" })', "", "./program")
  check.holds(output, "script.lua:8: model:run: files of HDF5 need signorini_hdf5.so", "Hint: install signorini-hdf5",
    "libhdf5-dev")
  output = script('model:run{ { steps = 1, top = {0, -0.1} } }:hdf5 "run.h5"', "", "./program")
  check.holds(output, "script.lua:8: run:hdf5: files of HDF5 need signorini_hdf5.so")
  output = script("print(model:run{ { steps = 1, top = {0, -0.1} } }.reason)", "", "./program")
  check.equal(output, "completed\n")
end)

check.case("wrong arguments", function()
  local model = ironing()
  local run = model:run({ { name = "press", steps = 1, grip = {0, -0.1} } })
  local wrong = {
    { {}, "options.hdf5.file", "missing" }, { "", "name" },
    { { file = "a.h5", units = { lenght = "mm" } }, "units: 'lenght' is neither a quantity nor a column",
      "did you mean 'length'" },
    { { file = "a.h5", units = { ["grip.fz"] = "N" } }, "did you mean 'grip.fx'" },
  }
  for _, case in ipairs(wrong) do
    check.fails(function() model:run(path, { hdf5 = case[1] }) end, "hdf5_writes_test.lua:", "model:run: ",
      table.unpack(case, 2))
  end
  check.fails(function() run:hdf5("a.h5", { every = 1 }) end, "run:hdf5: ", "every")
  check.fails(function() run:hdf5("a.h5", { units = { frce = "N" } }) end, "run:hdf5: ", "did you mean 'force'")
  check.fails(function() run.hdf5 "a.h5" end, "with a colon")
  check.equal({ core.exists "a.h5", model:target "grip"[2] }, { false, -0.1 })
end)
