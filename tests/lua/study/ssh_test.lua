-- Studies on hosts that are reached by ssh: the hosts are aliases of this machine, with an sshd that the test starts.

require "check"

local here = core.home .. "/tests"
local hosts = check.folder()
local started, status = check.shell(("'%s/ssh/hosts' start '%s'"):format(here, hosts))
if status ~= 0 then error(started, 0) end
local config = core.read_file(hosts .. "/config")

local function shell(folder, command)
  return check.shell(("cd '%s' && export PATH='%s/bin':$PATH && %s"):format(folder, hosts, command))
end

--- The script in a folder, with the words of a command line.
local function signorini(folder, words) return shell(folder, ("'%s' study.lua %s"):format(arg[-1], words)) end

-- Cases that note that they have ended. Those above 2 wait as long as the file `hold` is there, and case 6 as long as
-- `hold6` is.
local short = [[
local sg = require "signorini"
local exists = require "signorini.core".exists
local options = sg.arguments{ act = "print", on = "", cores = 1, wait = true, dry_run = false }
local study = sg.study{ name = "a 'short' study", folder = "out/a 100% b", cases = sg.grid{ n = {1, 2, 3, 4, 5, 6} },
  run = function(case)
    while case.n > 2 and exists "hold" or case.n == 6 and exists "hold6" do os.execute "sleep 0.1" end
    local log = io.open("ended", "a")
    log:write(case.n, "\n")
    log:close()
    return { square = case.n ^ 2 }
  end }
if options.act == "cancel" then
  print(study:cancel())
elseif options.act == "watch" then
  print(#study:watch().rows)
else
  study:execute{ on = options.on ~= "" and { options.on } or nil, cores = options.cores, wait = options.wait,
                 dry_run = options.dry_run }
  if #study.rows > 0 then print(study:table{ columns = { "n", "square" } }) end
end
]]

local function new_folder()
  local folder = check.folder()
  core.write_file(folder .. "/study.lua", short)
  return folder
end

local function touch(folder, name) core.write_file(("%s/%s"):format(folder, name), "") end

--- How often cases have ended, in increasing order.
local function ended(folder) return (check.shell(("sort -n '%s/ended' | tr '\n' ' '"):format(folder))) end

--- The number of the chunk that has claimed a case; nil without a claim.
local function owner(folder, n)
  local text = check.shell(("cat '%s/out/a 100%% b/cases/n=%d'-*.claim 2>/dev/null"):format(folder, n))
  return text:match "^chunk (%d+) of"
end

--- The process of a host, of the first job.
local function process(folder, number)
  local words = {}
  for word in core.read_file(folder .. "/out/a 100% b/jobs/1/id"):gmatch "%d+" do words[#words + 1] = word end
  return words[number]
end

check.case("two hosts solve each case once; hosts that cannot take part are reported", function()
  local folder = new_folder()
  local output, status = signorini(folder, "--on ssh:h1,ssh:h2,ssh:elsewhere,ssh:nowhere.invalid")
  check.equal(status, 0)
  check.holds(output, "6 cases in 4 tasks: ssh h1 sh <'out/a 100% b/jobs/1/host-1.sh'; ssh h2 sh <",
    "started on 2 of 4 hosts", "elsewhere: ", "it does not see the folder /nowhere/", -- after what its shell says
    "Hint: it must be on a disk that all hosts share", "nowhere.invalid: ssh: Could not resolve hostname",
    "6      36")
  check.equal(ended(folder), "1 2 3 4 5 6 ")
  output, status = signorini(folder, "on=ssh:h1")
  check.equal(status, 0)
  check.holds(output, "6 of 6 taken")
  check.equal(output:find("ssh h1", 1, true), nil)
end)

check.case("dry_run writes scripts that work, and starts nothing", function()
  local folder = new_folder()
  local output, status = signorini(folder, "on=ssh:h1 dry_run=yes cores=2")
  check.equal(status, 0)
  check.holds(output, "6 cases in 1 task: ssh h1 sh <'out/a 100% b/jobs/1/host-1.sh'")
  check.equal(core.exists(folder .. "/ended"), false)
  touch(folder, "hold")
  shell(folder, "ssh h1 sh <'out/a 100% b/jobs/1/host-1.sh'")
  check.await("two cases at a time", function() return owner(folder, 3) and owner(folder, 4) end)
  check.equal(owner(folder, 5), nil)
  os.remove(folder .. "/hold")
  check.await("the last case", function() return ended(folder) == "1 2 3 4 5 6 " end)
end)

check.case("wait = false returns; the job is gathered, watched, not submitted again, and cancelled", function()
  local folder = new_folder()
  touch(folder, "hold")
  local output, status = signorini(folder, "--on ssh:h1,ssh:h2 wait=no")
  check.equal(status, 0)
  check.await("two cases", function() return owner(folder, 3) and owner(folder, 4) end)
  output, status = signorini(folder, "--on ssh:h1,ssh:h2 wait=no")
  check.equal(status, 0)
  check.holds(output, "2 of 6 taken", "4 cases with h1, h2", "2       4")
  check.equal(output:find "started", nil)
  check.holds(signorini(folder, "act=cancel"), "1")
  output = signorini(folder, "act=watch")
  check.holds(output, "waiting  begun  done  failed", "6\n") -- those that were cancelled are rows, too
  os.remove(folder .. "/hold")
  output, status = signorini(folder, "--on ssh:h1,ssh:h2")
  check.equal(status, 0)
  check.holds(output, "2 of 6 taken", "4 to solve", "6      36")
  check.equal(ended(folder), "1 2 3 4 5 6 ")
end)

check.case("the cases of a host that fails are reported, and solved by the next call", function()
  local folder = new_folder()
  touch(folder, "hold")
  signorini(folder, "--on ssh:h1,ssh:h2 wait=no")
  check.await("two cases", function() return owner(folder, 3) and owner(folder, 4) end)
  local number = tonumber(owner(folder, 3))
  check.shell("kill -KILL -" .. process(folder, number))
  os.remove(folder .. "/hold")
  local output, status = signorini(folder, "--on ssh:h1")
  check.equal(status, 0)
  check.holds(output, "n=3: the process on h" .. number .. " ended before the case was done (no longer running)",
    "6      36")
  check.equal(ended(folder), "1 2 3 4 5 6 ")
end)

check.case("a host that does not answer keeps its cases until it answers or is given up", function()
  local folder = new_folder()
  touch(folder, "hold6")
  signorini(folder, "--on ssh:h1 wait=no")
  check.await("case 6", function() return owner(folder, 6) end)
  core.write_file(hosts .. "/config", (config:gsub("Port %d+", "Port 1", 1)))
  local output, status = signorini(folder, "--on ssh:h1")
  check.equal(status, 1)
  check.holds(output, "5 of 6 taken", "1 case with h1",
    "n=6: crashed: the process on h1 cannot be asked, it may still solve the case (ssh: connect to host 127.0.0.1",
    "Connection refused). Hint: the same call looks again, study:cancel() gives it up")
  check.equal(ended(folder), "1 2 3 4 5 ")
  local id = process(folder, 1)
  output = signorini(folder, "act=cancel")
  check.holds(output, "h1 does not answer, and may still solve cases", "1\n")
  check.shell("kill -KILL -" .. id)
  os.remove(folder .. "/hold6")
  output, status = signorini(folder, "--on ssh:h1")
  check.equal(status, 1)
  check.holds(output, "study:execute: no host could be used:", "h1: ssh: connect to host 127.0.0.1 port 1")
  core.write_file(hosts .. "/config", config)
  output, status = signorini(folder, "--on ssh:h1")
  check.equal(status, 0)
  check.holds(output, "6      36")
  check.equal(ended(folder), "1 2 3 4 5 6 ")
end)

check.case("wrong hosts are refused at the user's line; other versions are reported by host", function()
  local folder = new_folder()
  local output, status = signorini(folder, "on=host1")
  check.equal(status, 1)
  check.holds(output, "study:execute: on must be \"local\", \"slurm\" or hosts such as { \"ssh:host1\" }, got",
    "study.lua:17")
  signorini(folder, "on=ssh:h1 dry_run=yes")
  local file = folder .. "/out/a 100% b/jobs/1/host-1.sh"
  core.write_file(file, (core.read_file(file):gsub("signorini 0[%d.]+", "signorini 0.0.1")))
  output, status = shell(folder, ("ssh h1 sh <'%s'"):format(file))
  check.equal(status, 1)
  check.holds(output, "it does not have signorini 0.0.1 (", " as ", "Hint: install the same version on all hosts")
  output, status = shell(folder, ("PATH=. '%s' study.lua on=ssh:h1"):format(arg[-1]))
  check.equal(status, 1)
  check.holds(output, "study:execute: ssh is not on this machine")
end)

check.shell(("'%s/ssh/hosts' stop '%s'"):format(here, hosts))
