-- Files that Lua reads, damaged: CSV, JSON, the records of studies and of runs, lists of .pvd, and the answers of
-- Slurm. A reader returns plain data or raises an error that says what is wrong. Arguments: the first and the last
-- seed.

local first, last = tonumber(arg[1]), tonumber(arg[2])

io.stdout:setvbuf "line"
local core = require "signorini.core"
package.path = ("%s;%s/tests/lua/samples/?.lua"):format(package.path, core.home)
local sg = require "signorini"
local scenes = require "scenes"
local slurm = require "signorini.study.slurm"
core.quiet = true

local samples = core.home .. "/tests/lua/samples/format13/"
local folder = os.tmpname()
os.remove(folder)
sg.mkdir(folder .. "/study/cases")
local function scratch(name) return ("%s/%s"):format(folder, name) end

local function pick(list) return list[math.random(#list)] end

-- ── Damage ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local pieces = { "", "\0", "\xff", "\"", ",", "\n", "\r", "#", "{", "}", "[", "]", "null", "nan", "inf", "1e999",
                 "-", "0x", "<", ">", "|", "_", "99999999999999999999", ":", " ", "\\u0000", "\\ud800", "true" }

--- A text with a few parts removed, repeated or replaced.
local function damaged(text)
  for _ = 1, math.random(3) do
    local from = math.random(0, #text)
    local to = from + math.random(0, math.random(2) == 1 and 3 or 40)
    local part = math.random(3) == 1 and text:sub(to, to + math.random(0, 30)) or pick(pieces)
    text = text:sub(1, from) .. part .. text:sub(to)
  end
  return text
end

local plain = { 0, -1, 1, 1.5, 1e308, 1 << 53, "", "text", "done", true, false }

--- Plain data with one entry replaced or removed.
local function changed(value, deep)
  if type(value) ~= "table" or not deep and math.random(4) == 1 then
    local roll = math.random(5)
    if roll == 1 then return nil end
    if roll == 2 then return {} end
    if roll == 3 then return { pick(plain), pick(plain) } end
    if roll == 4 then return { name = pick(plain) } end
    return pick(plain)
  end
  local copy, keys = {}, {}
  for key, entry in next, value do
    copy[key], keys[#keys + 1] = entry, key
  end
  table.sort(keys, function(a, b) return tostring(a) < tostring(b) end)
  if #keys > 0 then
    local key = pick(keys)
    copy[key] = changed(copy[key])
  end
  return copy
end

-- ── Readers ──────────────────────────────────────────────────────────────────────────────────────────────────────────

local readers = {}

local function file_reader(name, text, read)
  readers[#readers + 1] = { name = name, run = function()
    local file = scratch(name)
    core.write_file(file, damaged(text))
    return read(file)
  end }
end

file_reader("a.csv", '# a comment\nx,"y ""z""",label\n1,2.5,"two\nlines"\n3,,é\n-1e-3,nan,true\n', function(file)
  local data = sg.csv.read(file)
  for _, name in ipairs(data.columns) do data:column(name) end
  data:by(data.columns[1])
  return tostring(data)
end)
file_reader("a.json", '{"a": [1, -2.5e-3, true, "x\\u00e9\\n"], "b": {"c": {}}, "d": 18446744073709551615}',
  function(file)
    local value = sg.json.read(file)
    if value ~= nil then sg.json.write(file, value) end
  end)
file_reader("a.pvd", '<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1" byte_order="LittleEndian">\n'
  .. '  <Collection>\n    <DataSet timestep="1" part="0" file="a_0001.vtu"/>\n'
  .. '    <DataSet timestep="2.5" part="0" file="a_0002.vtu"/>\n  </Collection>\n</VTKFile>\n',
  function(file) sg.pvd(file, { resume = true }) end)
for _, name in ipairs{ "space.sgn", "run.sgn" } do
  file_reader(name, core.read_file(samples .. name), function(file) sg.load(file) end)
end

--- A study whose files are damaged: cases that cannot be read are solved again, others are read.
local study_files = {}
for _, name in ipairs(core.list_folder(samples .. "study/cases")) do
  study_files["cases/" .. name] = core.read_file(samples .. "study/cases/" .. name)
end
study_files["study.json"] = core.read_file(samples .. "study/study.json")
local study_names = {}
for name in pairs(study_files) do study_names[#study_names + 1] = name end
table.sort(study_names)

local function read_study()
  local study = scenes.study(scratch "study"):read()
  for _, name in ipairs(study.results) do study:column(name) end
  study:table{}
  return tostring(study)
end

readers[#readers + 1] = { name = "study", run = function()
  for name, text in pairs(study_files) do core.write_file(scratch("study/" .. name), text) end
  local name = pick(study_names)
  local text = study_files[name]
  if math.random(2) == 1 then
    local value = core.read_json(text)
    core.write_file(scratch("study/" .. name), core.write_json(changed(value, true)))
  else
    core.write_file(scratch("study/" .. name), damaged(text))
  end
  return read_study()
end }

--- The record of a run in a checkpoint that is otherwise whole.
local record = core.unpack(core.checkpoint_text(samples .. "run.sgn"))
local model = scenes.plane()
core.restore(model, samples .. "run.sgn")
readers[#readers + 1] = { name = "record of a run", run = function()
  local file = scratch "record.sgn"
  core.save(model, file, core.pack(changed(record, true)), false)
  scenes.plane():run(scenes.path, { checkpoint = file, resume = true })
end }

readers[#readers + 1] = { name = "Slurm", run = function()
  slurm.seconds(damaged(pick{ "10", "1:30", "1-2:3:4", "2-0" }))
end }

-- ── All of them ──────────────────────────────────────────────────────────────────────────────────────────────────────

local here = debug.getinfo(1, "S").short_src
local counts = {}
for seed = first, last do
  math.randomseed(seed)
  local reader = readers[(seed - 1) % #readers + 1]
  local ok, message = pcall(reader.run)
  counts[reader.name] = counts[reader.name] or { 0, 0 }
  local count = counts[reader.name]
  count[ok and 1 or 2] = count[ok and 1 or 2] + 1
  if not ok and (type(message) ~= "string" or not message:find(here, 1, true) or #message > 5000
    or message:find "attempt to" or message:find "bad argument") then
    print(("FINDING %d %s: %s"):format(seed, reader.name, tostring(message)))
  end
end
for _, reader in ipairs(readers) do
  local count = counts[reader.name] or { 0, 0 }
  print(("%-16s %6d read, %6d refused"):format(reader.name, count[1], count[2]))
end
os.execute(("rm -r '%s'"):format(folder))
