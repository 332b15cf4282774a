-- Outputs keep files of another kind; the files of a study are not written through links; limits of files and pipes are
-- errors.

require "check"

local folder = check.folder()
local script = folder .. "/study.lua"
local text = "-- my study\nlocal a, b = 1, 2\n"

local body = scenes.body{ size = {2, 1}, elements = {2, 1}, contact = "south" }
local function model_of()
  return scenes.model{ bodies = { block = body }, supports = { top = { on = "north", drive = "y" },
                   bed = { on = "south", fix = "xy" } } }
end
local model = model_of()
local path = { { name = "press", steps = 1, top = -0.01 } }
local run = model:run(path)
local chart = sg.chart{ x = {1, 2}, { y = {1, 2} } }

--- Each output to a file of this name, which ends as the kind requires.
local outputs = {
  { "csv", function(file) run:csv(file) end },
  { "json", function(file) sg.json.write(file, { 1 }) end },
  { "json", function(file) sg.json.write(file, "one text") end },
  { "h5", function(file) run:hdf5(file) end },
  { "h5", function(file) model_of():run(path, { hdf5 = file }) end },
  { "sgn", function(file) model:save(file) end },
  { "sgn", function(file) model_of():run(path, { checkpoint = file }) end },
  { "png", function(file) chart:write(file) end },
  { "svg", function(file) chart:write(file) end },
  { "pdf", function(file) chart:write(file) end },
  { "vtu", function(file) sg.vtu{ model = model, file = file } end },
  { "pvd", function(file) sg.pvd(file) end },
  { "xml", function(file) sg.shapes.rectangle{ width = 1, height = 1 }:write(file) end },
  { "txt", function(file) sg.shapes.rectangle{ width = 1, height = 1 }:write(file) end },
  { "mesh", function(file) sg.shapes.rectangle{ width = 1, height = 1 }:write(file) end },
  { "html", function(file) run:report(file) end },
}

check.case("an output replaces an older one, but no file of another kind", function()
  for i, output in ipairs(outputs) do
    local ending, write = table.unpack(output)
    local file = ("%s/%d.%s"):format(folder, i, ending)
    write(file)
    local first = core.read_file(file)
    write(file)
    check.equal(#core.read_file(file) > 0, true)
    core.write_file(file, "")
    write(file)
    local other = ending == "png" and "%PDF-1.5 …" or "\x89PNG\r\n\x1a\n…"
    core.write_file(file, other)
    check.fails(function() write(file) end, "outputs_test.lua:", "'" .. file .. "' exists and is ", "Hint: ")
    check.equal(core.read_file(file), other)
    core.write_file(file, first)
    write(file)
  end
end)

check.case("no output replaces a script, also behind a link", function()
  core.write_file(script, text)
  for i, output in ipairs(outputs) do
    local link = ("%s/link%d.%s"):format(folder, i, output[1])
    check.shell(("ln -s study.lua '%s'"):format(link))
    check.fails(function() output[2](link) end, "outputs_test.lua:", "is not replaced")
    check.equal({ core.read_file(script), core.is_link(link) }, { text, true })
  end
  check.fails(function() run:csv(script) end, "not a CSV table")
  check.fails(function() sg.json.write(script, {}) end, "not a JSON file")
  check.fails(function() run:hdf5(script) end, "not a file of HDF5")
  check.fails(function() model:save(script) end, "not a checkpoint")
  check.equal(core.read_file(script), text)
end)

check.case("an output through a link replaces what it refers to; streams and devices are written into", function()
  run:csv(folder .. "/real.csv")
  check.shell(("ln -s real.csv %s/by_link.csv"):format(folder))
  sg.csv.write(folder .. "/by_link.csv", { columns = { "a" }, rows = { { 1 } } })
  check.equal({ core.read_file(folder .. "/real.csv"), core.is_link(folder .. "/by_link.csv") }, { "a\n1\n", true })
  sg.csv.write("/dev/null", { columns = { "a" }, rows = { { 1 } } })
  core.write_file(folder .. "/stream.lua", [[
    print "first"
    require "signorini".csv.write("/dev/stdout", { columns = { "a" }, rows = { { 1 } } })
    print "last"]])
  for _, to in ipairs { (" > %s/stream && cat %s/stream"):format(folder, folder), " | cat" } do
    check.equal((check.shell(("'%s' -q %s/stream.lua%s"):format(core.program, folder, to))), "first\na\n1\nlast\n")
  end
end)

local function study(place)
  return sg.study{ name = "s", folder = folder .. "/" .. place, cases = sg.grid{ a = {1} },
                   run = function(case) return { b = 2 * case.a } end }
end

check.case("the files of a study are not written through links", function()
  core.write_file(folder .. "/precious", "my only copy")
  study "linked":execute{}
  local case = "cases/" .. core.list_folder(folder .. "/linked/cases")[1]
  for _, name in ipairs { case, "study.json", "reserve" } do
    local file = folder .. "/linked/" .. name
    os.remove(folder .. "/linked/" .. case) -- it is solved again
    os.remove(file)
    check.shell(("ln -s %s/precious '%s'"):format(folder, file))
    study "linked":execute{}
    check.equal({ core.read_file(folder .. "/precious"), core.is_link(file) }, { "my only copy", false })
  end
  os.remove(folder .. "/linked/" .. case)
  for _, how in ipairs { "ln -s", "ln", "cp" } do
    check.shell(("rm -f %s/linked/lock; %s %s/precious %s/linked/lock"):format(folder, how, folder, folder))
    check.fails(function() study "linked":execute{} end, "outputs_test.lua:", "a link or was not written as a lock")
    check.equal(core.read_file(folder .. "/precious"), "my only copy")
  end
  os.remove(folder .. "/linked/lock")
  core.write_file(folder .. "/linked/reserve", "mine")
  check.fails(function() study "linked":execute{} end, "reserve' is not a reserve of this study")
  check.equal(core.read_file(folder .. "/linked/reserve"), "mine")
end)

check.case("the checkpoint of a case is not written through a link", function()
  local function linked()
    return sg.study{ name = "c", folder = folder .. "/checkpoints", cases = sg.grid{ a = {1} },
                     run = function(_, checkpoint)
                       model_of():run(path, { checkpoint = checkpoint })
                       error "stop"
                     end }
  end
  pcall(linked().execute, linked(), {})
  local cases = folder .. "/checkpoints/cases/"
  local file
  for _, name in ipairs(core.list_folder(cases)) do file = name:find "%.sgn$" and cases .. name or file end
  check.shell(("rm '%s'; ln -s %s/new.sgn '%s'"):format(file, folder, file))
  pcall(linked().execute, linked(), {})
  check.equal({ core.exists(folder .. "/new.sgn"), core.is_link(file), core.exists(file) }, { false, false, true })
end)

check.case("a limit of the size of files and pipes without another end are errors", function()
  core.write_file(folder .. "/big.lua", [[
    local sg = require "signorini"
    local model, path = sg.scenes.ironing{}
    model:run(path, { checkpoint = "w/run.sgn" })]])
  core.mkdir(folder .. "/w")
  local output = check.shell(("cd %s; ulimit -f 8; '%s' -q big.lua 2>&1"):format(folder, core.program))
  check.holds(output, "big.lua:3: model:run: cannot write 'w/run.sgn'", "bytes that a file of this process may have",
              "ulimit -f")
  check.equal(core.list_folder(folder .. "/w"), {})
  check.shell(("mkfifo %s/pipe.sgn"):format(folder))
  local pipe = folder .. "/pipe.sgn"
  check.fails(function() model_of():run(path, { checkpoint = pipe, resume = true }) end, "it is a pipe, not a file")
  check.fails(function() sg.csv.read(pipe) end, "it is a pipe, not a file")
  check.fails(function() sg.load(pipe) end, "it is a pipe, not a file")
  check.fails(function() sg.json.write(pipe, {}) end, "no program reads this pipe")
end)

check.case("results are keyed by the program's source", function()
  check.shell(("mkdir %s/tree; cp -r %s/lua %s/tree"):format(folder, core.home, folder))
  check.shell(("cp -r %s %s/tree/share"):format(core.share, folder))
  local function version()
    return (check.shell(("SIGNORINI_HOME=%s/tree '%s' --version"):format(folder, core.program)))
  end
  local first = version()
  check.equal(first, ("signorini %s\n"):format(core.release()))
  core.write_file(folder .. "/tree/share/report/page.css", "changed")
  check.equal(version(), first)
  local file = folder .. "/tree/lua/signorini/call/lists.lua"
  core.write_file(file, core.read_file(file) .. "-- changed\n")
  check.equal(version() == first, false)
  study "keyed":execute{}
  local case = ("%s/keyed/cases/%s"):format(folder, core.list_folder(folder .. "/keyed/cases")[1])
  local record = core.read_json(core.read_file(case))
  check.equal({ record.inputs["the program's version"], record.made.versions.signorini },
    { core.release(), core.release() })
  record.inputs["the program's version"] = "0.1.0"
  core.write_file(case, core.write_json(record))
  study "keyed":execute{}
  check.equal(core.read_json(core.read_file(case)).inputs["the program's version"], core.release())
end)
