-- Odd environments: a full disk, folders that cannot be written, a wrong clock, many files in a study's folder, names
-- with spaces, quotes and newlines, a locale with commas, no HOME, no standard input. With a million files:
--   signorini tests/lua/reliability/environment_test.lua 1000000

require "check"

local top = check.folder()

--- Writes every kind of file into a folder and prints the kinds that were refused, then a force and what a study found.
core.write_file(top .. "/writes.lua", [[
local sg = require "signorini"
require "signorini.core".quiet = true
local folder = arg[1]
local block = sg.body{ patch = sg.shapes.rectangle{ width = 2, height = 1 }, elements = {4, 2}, order = "N2",
                       contact = "south", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
local function make()
  return sg.model{
    bodies = { block = block }, supports = { top = { on = block:face "north", drive = "xy" } },
    contacts = { bottom = { slave = block:face "south", master = sg.rigid.plane{ point = {0, 0}, normal = {0, 1} },
                            penalty = 100 } } }
end
local model, down = make(), { { name = "down", steps = 3, top = {0, -0.05} } }
local run = model:run(down, { states = {2, 3} })
local small = { 200, 150 }
local writes = {
  csv = function(file) run:csv(file) end,
  sgn = function(file) model:save(file) end,
  run = function(file) make():run(down, { checkpoint = file }) end,
  png = function(file) sg.chart{ { x = {0, 1}, y = {0, 1.5} }, size = small, file = file } end,
  svg = function(file) sg.chart{ { x = {0, 1}, y = {0, 1.5} }, size = small, file = file } end,
  pdf = function(file) sg.picture{ model = model, field = "uy", size = small, file = file } end,
  json = function(file) sg.json.write(file, { half = 0.5 }) end,
}
if pcall(require "signorini.core".make_result_file) then writes.h5 = function(file) run:hdf5(file) end end
local kinds = {}
for kind in pairs(writes) do kinds[#kinds + 1] = kind end
table.sort(kinds)
for _, kind in ipairs(kinds) do
  local ok, message = pcall(writes[kind], folder .. "/x." .. kind)
  if not ok then print(kind, message) end
end
local study = sg.study{ name = "s", folder = folder .. "/study", cases = sg.grid{ a = {1, 2} },
                        run = function(case) return { b = case.a * 1.5 } end }
local ok, message = pcall(study.execute, study, {})
print(("%.12g"):format(run:column "top.fy"[3]), ok and study.rows[1].b + study.rows[2].b or message)
if ok and folder == arg[2] then print(sg.csv.read(folder .. "/x.csv"):column "top.fy"[3]) end
]])

local function quoted(word) return "'" .. word:gsub("'", [['\'']]) .. "'" end

--- The script in a folder, with a command in front of the program and something behind it.
local function writes(folder, before, after)
  return check.shell(("%s %s -q %s %s %s"):format(before or "", quoted(arg[-1]), quoted(top .. "/writes.lua"),
    quoted(folder), after or ""))
end

core.mkdir(top .. "/usual")
local usual, status = writes(top .. "/usual")
check.equal(status, 0)

check.case("the usual environment: nothing is refused", function()
  check.equal(select(2, usual:gsub("\n", "")), 1)
  check.holds(usual, "\t4.5\n")
end)

-- Mounting a small disk needs a namespace, which containers may not allow.
local mounts = select(2, check.shell "unshare --map-root-user --mount mount -t tmpfs tmpfs /mnt") == 0

--- The script on a disk of its own with these options.
local function on_disk(options, prepare)
  local folder = top .. "/disk"
  core.mkdir(folder)
  local line = ("mount -t tmpfs -o %s tmpfs %s && %s %s -q %s %s; ls -A %s"):format(options, quoted(folder),
    prepare or "true &&", quoted(arg[-1]), quoted(top .. "/writes.lua"), quoted(folder), quoted(folder))
  return check.shell("unshare --map-root-user --mount sh -c " .. quoted(line))
end

check.case("a full disk: every kind of file is refused, and none is left half written", function()
  if not mounts then return end
  local output = on_disk("size=16k", ("dd if=/dev/zero of=%s bs=1k count=16 2>%s;"):format(quoted(top .. "/disk/rest"),
    quoted(top .. "/dd")))
  for _, kind in ipairs { "csv", "sgn", "run", "png", "svg", "pdf", "json" } do
    check.holds(output, kind .. "\t")
  end
  local _, refused = output:gsub("cannot write ", "")
  assert(refused >= 8, output)
  check.equal(output:find "\nx%.", nil)
  check.equal(output:find("%.part", 1), nil)
end)

check.case("a folder that cannot be written", function()
  if not mounts then return end
  local output = on_disk "ro"
  for _, kind in ipairs { "csv", "sgn", "run", "png", "svg", "pdf", "json" } do
    check.holds(output, kind .. "\t")
  end
  check.holds(output, "Read-only file system", "study:execute: cannot create the folder")
end)

check.case("names with spaces, quotes, newlines and bytes that are not UTF-8", function()
  for _, name in ipairs { "two words", "it's \"quoted\"", "two\nlines", "-q", "100 %d", "\xff\xfe", "$HOME `x` *" } do
    core.mkdir(top .. "/" .. name)
    check.equal((writes(top .. "/" .. name)), usual)
    check.equal(#core.list_folder(top .. "/" .. name), #core.list_folder(top .. "/usual"))
  end
end)

check.case("a locale with commas, no HOME, no environment, no standard input", function()
  local folder = top .. "/other"
  core.mkdir(folder)
  -- A locale of the test's own, since a machine may have none with commas.
  local made = select(2, check.shell("localedef -i de_DE -f UTF-8 " .. quoted(top .. "/de_DE.UTF-8"))) == 0
  if made then check.equal((writes(folder, "env LC_ALL=de_DE.UTF-8 LOCPATH=" .. quoted(top))), usual) end
  check.equal((writes(folder, "env -u HOME")), usual)
  check.equal((writes(folder, "env HOME=/nowhere")), usual)
  check.equal((writes(folder, "env -i SIGNORINI_HOME=" .. quoted(core.home))), usual)
  check.equal((writes(folder, "", "<&-")), usual)
  local output = check.shell(("echo 'print(1)' | env -u HOME %s -q"):format(quoted(arg[-1])))
  check.holds(output, "1")
end)

check.case("many other files in a study's folder", function()
  local folder = top .. "/many"
  core.mkdir(folder .. "/study/cases")
  check.shell(("cd %s && seq -f 'f%%.0f.json' %d | xargs touch"):format(quoted(folder .. "/study/cases"),
    tonumber(arg[1] or 2000)))
  check.equal((writes(folder)), usual)
end)

check.case("a clock that was set back: results of a later date are valid", function()
  local file
  for _, name in ipairs(core.list_folder(top .. "/usual/study/cases")) do
    if name:find "^a=1" then file = top .. "/usual/study/cases/" .. name end
  end
  local record = core.read_json(core.read_file(file))
  record.made.time, record.results.b = "2099-01-01T00:00:00Z", 100
  core.write_file(file, core.write_json(record))
  check.shell(("touch -d 2099-01-01 %s"):format(quoted(file)))
  check.holds(writes(top .. "/usual"), "\t103.0\n")
end)
