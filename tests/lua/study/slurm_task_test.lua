-- What tasks of Slurm do, without Slurm: its signals, its command scontrol and a full disk are imitated.

require "check"
local chunks = require "signorini.study.chunks"

-- Cases that save checkpoints, but do not resume where the file `again` is there; or cases with large results.
local script = [[
local sg = require "signorini"
local exists = require "signorini.core".exists
local function press(checkpoint)
  local slab = sg.body{ patch = sg.shapes.rectangle{ width = 3, height = 1 }, elements = {2, 2}, order = "N2",
                        material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  local model = sg.model{ bodies = { slab = slab }, supports = { bed = { on = slab:face "south", fix = "xy" },
                                                                 grip = { on = slab:face "north", drive = "xy" } } }
  local function on_step(info)
    local file = io.open("step", "w")
    file:write(info.step, "\n")
    file:close()
    os.execute "sleep 0.02"
  end
  local run = model:run({ { name = "press", steps = 10000, grip = {0, -0.1} } },
    { checkpoint = checkpoint, resume = not exists "again", on_step = on_step })
  return { force = run:column "grip.fy"[run.steps] }
end
local study = sg.study{ name = "short", cases = sg.grid{ n = {1, 2, 3} }, run = function(case, checkpoint)
  if exists "slow" then return press(checkpoint) end
  return { text = ("x"):rep(1500000), square = case.n ^ 2 }
end }
study:execute{ chunk = 3, notice = 20, dry_run = true }
if #study.rows > 0 then print(study:table{ columns = { "n", "square" } }) end
]]

local function shell(folder, command)
  return check.shell(("cd '%s' && PATH=\"$PWD/bin:$PATH\" %s"):format(folder, command))
end

--- A folder with the script, files of these names, and Slurm's scontrol, which does not return tasks to the queue.
local function new_folder(...)
  local folder = check.folder()
  core.mkdir(folder .. "/bin")
  core.mkdir(folder .. "/out")
  core.write_file(folder .. "/study.lua", script)
  core.write_file(folder .. "/bin/scontrol", "#!/bin/sh\necho MaxArraySize = 1001\ntest \"$1\" = show\n")
  check.shell(("chmod +x '%s/bin/scontrol'"):format(folder))
  for _, name in ipairs { ... } do core.write_file(("%s/%s"):format(folder, name), "") end
  return folder
end

local submit = ("'%s' study.lua --on slurm"):format(arg[-1])
local task = ("'%s' --chunk out/short/jobs/1/job.json:1 study.lua"):format(arg[-1])

--- Starts the task, gives it the notice when its first case has got to a step, and returns what it has written.
local function start_task(folder, step)
  os.remove(folder .. "/step")
  local id = shell(folder, task .. " >log 2>&1 & echo $!"):match "%d+"
  check.await("step " .. step, function()
    local ok, text = pcall(core.read_file, folder .. "/step")
    return ok and (tonumber(text) or 0) >= step
  end)
  check.shell("kill -USR1 " .. id)
  check.await("the end of the task", function() return check.shell("ps -o state= -p " .. id):find "^[^Z]" == nil end)
  return core.read_file(folder .. "/log")
end

check.case("a case that does not resume at its checkpoint ends with an error, not in the queue forever", function()
  local folder = new_folder("slow", "again")
  shell(folder, submit)
  check.holds(start_task(folder, 30), "3 cases left: this task returns to the queue", "Slurm did not requeue the task")
  check.holds(start_task(folder, 2), "n=1: not done within the time of a task, and its checkpoint is not further than "
    .. "before. Hint: raise time, or save checkpoints and pass resume = true", "2 cases left")
end)

check.case("a case that resumes stays in the queue as long as its checkpoint advances", function()
  local folder = new_folder "slow"
  shell(folder, submit)
  check.holds(start_task(folder, 2), "3 cases left")
  check.holds(start_task(folder, 30), "3 cases left")
end)

check.case("on a full disk a task keeps what is finished and ends with an error", function()
  local folder = new_folder()
  local function in_namespace(words) return shell(folder, ("unshare -rm sh -c \"%s\""):format(words)) end
  -- Results of 1.5 MB each, the task's reserve of 1 MiB: the second one fits only where the reserve was.
  local small = "mount -t tmpfs -o size=3500k none out"
  local _, status = in_namespace(small)
  if status ~= 0 then return print "left out: a small disk cannot be mounted here" end
  local output
  output, status = in_namespace(table.concat({ small, submit, task .. " || echo status $?",
    "mount -o remount,size=9m out && " .. task, "'" .. arg[-1] .. "' study.lua --on local" }, " && "):gsub("%$", "\\$"))
  check.equal(status, 0)
  check.holds(output, "no space is left for 'out/short'", "status 1", "3 of 3 taken")
  local first, second = output:match "^(.-)status 1(.*)$"
  check.holds(first, "n=1: done", "n=2: done")
  check.equal(first:find "n=3: done", nil)
  check.equal(second:find "n=1: done" or second:find "n=2: done", nil) -- nothing is solved twice
  check.holds(second, "n=3: done", "3       9")
end)

-- ── Packing ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A generator of numbers from 0 to 1 (Park and Miller's), so that costs are the same on every machine.
local function generator(seed)
  return function()
    seed = seed * 48271 % 2147483647
    return seed / 2147483647
  end
end

--- The largest sum of costs in a chunk. Raises an error unless the chunks hold each of 1 … count once.
local function makespan(packed, costs)
  local largest, all = 0, {}
  for _, chunk in ipairs(packed) do
    local sum = 0
    for _, case in ipairs(chunk) do all[#all + 1], sum = case, sum + costs[case] end
    largest = math.max(largest, sum)
  end
  table.sort(all)
  check.equal(#all, #costs)
  for i, case in ipairs(all) do check.equal(case, i) end
  return largest
end

local function numbers(count)
  local list = {}
  for i = 1, count do list[i] = i end
  return list
end

check.case("each case is in one chunk, and the longest chunk is at most 4/3 of the shortest possible", function()
  local random = generator(1)
  for trial = 1, 200 do
    -- Pieces of `count` equal lengths: the shortest longest chunk is that length.
    local count, costs, length = 1 + trial % 12, {}, 3600
    for _ = 1, count do
      local left = length
      for _ = 1, math.floor(6 * random()) do
        costs[#costs + 1] = left * random()
        left = left - costs[#costs]
      end
      costs[#costs + 1] = left
    end
    local packed = chunks.pack(numbers(#costs), function(i) return costs[i] end,
      { size = "auto", slots = 1, limit = 2 * length, most = count })
    check.equal(#packed, count)
    local bound = (4 / 3 - 1 / (3 * count)) * length -- R. L. Graham, SIAM J. Appl. Math. 17, 1969, theorem 2
    check.equal(makespan(packed, costs) <= bound * (1 + 1e-12), true)
  end
end)

check.case("chunks respect the number of tasks, the time limit and the slots; unknown costs are the median", function()
  local function pack(count, cost, options)
    local costs = lists.map(numbers(count), function(i) return cost(i) or 100 end)
    local packed = chunks.pack(numbers(count), cost, options)
    return #packed, makespan(packed, costs)
  end
  local function hundred() return 100 end
  local function some(i) return i % 10 == 0 and 100 or nil end
  local function none() return nil end
  check.equal({ pack(1000, hundred, { size = "auto", slots = 5, most = 1000 }) }, { 20, 5000 }) -- four for each slot
  check.equal({ pack(1000, some, { size = "auto", slots = 5, most = 1000 }) }, { 20, 5000 })
  check.equal({ pack(1000, hundred, { size = "auto", slots = 5, most = 1000, limit = 2000 }) }, { 100, 1000 })
  check.equal({ pack(1000, hundred, { size = "auto", slots = 5, most = 7 }) }, { 7, 14300 })
  check.equal({ pack(8, function() return 1 end, { size = "auto", slots = 64, most = 1000 }) }, { 1, 8 }) -- a minute
  check.equal({ pack(1000, none, { size = "auto", slots = 5, most = 1000 }) }, { 20, 5000 })
  check.equal({ pack(25, hundred, { size = 10, slots = 5, most = 1000 }) }, { 3, 1000 })
end)
