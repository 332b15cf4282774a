-- Studies that are killed at random moments, while they write results, checkpoints, files of HDF5, pictures and
-- tables: what was finished stays, no file is incomplete, and the results are those of an undisturbed study. More:
--   signorini tests/lua/study/study_kill_test.lua 200

require "check"

local kills = tonumber(arg[1] or 3)

local script = [[
local sg = require "signorini"
require "signorini.core".quiet = true
local folder = arg[1]
local hdf5 = arg[2] == "hdf5"
local function solve(case, checkpoint)
  local model, path = sg.scenes.ironing{ order = "N2", mu = case.mu, depth = 0.1, distance = 0.1 }
  path[1].steps, path[2].steps = 10, 10
  local name = ("%s/mu %g"):format(folder, case.mu)
  local run = model:run(path, { checkpoint = checkpoint, resume = true, states = {5, 15, 20},
    hdf5 = hdf5 and { file = name .. ".h5", every = 4 } or nil })
  sg.picture{ states = run:states(), field = "uy", size = {240, 160}, file = name .. "-%d.png" }
  sg.picture{ model = model, field = "von_mises", size = {240, 160}, file = name .. ".png" }
  sg.chart{ { x = run:column "step", y = run:column "grip.fx" }, size = {240, 160}, file = name .. ".svg" }
  sg.json.write(name .. ".json", { fx = run:column "grip.fx" })
  run:csv(name .. ".csv")
  return { fx = ("%a"):format(run:column "grip.fx"[20]), fy = ("%a"):format(run:column "grip.fy"[20]) }
end
local study = sg.study{ name = "killed", folder = folder .. "/study", run = solve,
                        cases = sg.grid{ mu = {0, 0.1, 0.2} } }
study:execute{ jobs = 2 }
for _, row in ipairs(study.rows) do print(row.mu, row.fx, row.fy) end
]]

local with_hdf5 = pcall(core.make_result_file)
local top = check.folder()
core.write_file(top .. "/study.lua", script)

local function start(folder, how)
  core.mkdir(folder)
  return check.shell(("setsid '%s' '%s/study.lua' '%s' %s %s"):format(arg[-1], top, folder,
    with_hdf5 and "hdf5" or "", how))
end

-- ── Files that are whole ─────────────────────────────────────────────────────────────────────────────────────────────

local python = "/usr/bin/python3 " -- Debian's, which finds python3-h5py
local whole = {}

function whole.json(file) core.read_json(core.read_file(file)) end
function whole.csv(file) check.holds(core.read_file(file), "\n20,") end
function whole.png(file) check.holds(core.read_file(file):sub(-12), "IEND") end
function whole.svg(file) check.holds(core.read_file(file):sub(-10), "</svg>") end
function whole.h5(file)
  check.ended({ check.shell(("%s'%s/tests/hdf5/read.py' '%s'"):format(python, core.home, file)) }, 0)
end
function whole.sgn(file) core.checkpoint_text(file) end -- compares the checksum, too

--- All files of a folder: every one that has its final name is whole. Returns the contents of the finished cases.
local function look(folder)
  local finished = {}
  for _, part in ipairs { "", "/study", "/study/cases" } do
    for _, name in ipairs(core.exists(folder .. part) and core.list_folder(folder .. part) or {}) do
      local ending = name:match "%.(%w+)$"
      local file = folder .. part .. "/" .. name
      if whole[ending] then
        whole[ending](file)
        if part == "/study/cases" and ending == "json" then finished[name] = core.read_file(file) end
      end
    end
  end
  return finished
end

-- ── Kills ────────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case(("killed at %d random moments"):format(kills), function()
  math.randomseed(7)
  local began = core.now()
  local undisturbed, status = start(top .. "/undisturbed", "")
  if status ~= 0 then error(undisturbed) end
  local length = core.now() - began
  look(top .. "/undisturbed")

  local sent, studies, results = 0, 0, 0
  while sent < kills do
    studies = studies + 1
    local folder = ("%s/%d"):format(top, studies)
    local before, output = {}, nil
    repeat
      -- The cases' processes die with the study or go on until they notice; in half of the trials all are killed.
      local group = math.random(2) == 1
      -- The killer may have ended when the study has.
      local kill = "& p=$!; { sleep %.3f; kill -KILL %s$p; } >/dev/null 2>&1 & wait $p; s=$?; kill $! 2>/dev/null; "
        .. "exit $s"
      kill = kill:format(length * (0.1 + 0.9 * math.random()), group and "-" or "")
      output, status = start(folder, sent < kills and kill or "")
      if status ~= 0 then sent = sent + 1 end
      local now = look(folder)
      for name, text in pairs(before) do
        if now[name] ~= text then error(name .. " was finished, and is lost or another one") end
      end
      before = now
    until status == 0
    check.equal(output, undisturbed)
    for _ in pairs(before) do results = results + 1 end
    check.equal(#core.list_folder(folder .. "/study/cases"), 3) -- no checkpoint or unfinished file is left
  end
  print(("%d kills in %d studies, %d results: all as undisturbed"):format(sent, studies, results))
end)
