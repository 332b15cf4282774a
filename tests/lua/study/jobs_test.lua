-- Jobs in parallel processes, as the library in lua/ uses them.

require "check"

--- What jobs left behind: text or failure by number, and the order of their ends.
local function gather(count, at_once, run, limit)
  local results, order = {}, {}
  local whole = core.jobs(count, at_once, run, function(i, text, failure)
    results[i], order[#order + 1] = text or failure, i
    check.equal(text == nil, failure ~= nil)
  end, limit)
  check.equal(whole, true)
  return results, order
end

check.case("each job returns a string, with bytes of any kind and more of them than a pipe holds", function()
  local results = gather(4, 2, function(i) return ("%d\0\n"):format(i):rep(100000) end)
  for i = 1, 4 do check.equal(results[i] == ("%d\0\n"):format(i):rep(100000), true) end
  check.equal(gather(1, 1, function() return "" end), { "" })
  check.equal(gather(0, 1, function() return "" end), {})
end)

check.case("they end in any order, in parallel, and change nothing here", function()
  local touched, order, mark = false, {}, check.file "ended"
  core.jobs(2, 2, function(i)
    touched = true
    while i == 1 and not io.open(mark) do end -- until the other one has ended
    return tostring(core.quiet)
  end, function(i)
    order[#order + 1] = i
    core.write_file(mark, "")
  end)
  check.equal({ order, touched, core.quiet }, { { 2, 1 }, false, false })
end)

check.case("an error comes with its traceback, a crash with its signal, an endless job with its limit", function()
  local function broken() error "no luck" end
  local results = gather(4, 2, function(i)
    if i == 1 then broken() end
    if i == 2 then os.execute "kill -SEGV $PPID" end
    if i == 3 then return 7 end
    return "fine"
  end)
  check.holds(results[1], "failed: ", "jobs_test.lua:", "no luck", "traceback", "in upvalue 'broken'")
  check.equal({ results[2], results[4] }, { "terminated by signal 11", "fine" })
  check.holds(results[3], "failed: ", "must return a string, got the number 7")
  check.equal(gather(1, 1, function() while true do end end, 0.01), { "time" })
end)

check.case("jobs draw, and leave, where something was drawn before them", function()
  local sg, file = require "signorini", check.file "picture.png"
  local function draw() sg.chart { file = file, x = { 1, 2 }, { y = { 1, 2 } }, size = { 300, 200 } } end
  draw()
  local results = gather(3, 2, function(i)
    draw()
    if i == 2 then os.exit(7) end
    if i == 3 then os.exit(0, true) end
    return "drawn"
  end, 20)
  check.equal(results, { "drawn", "exited with status 7 before it returned a result",
                         "exited with status 0 before it returned a result" })
end)

check.case("an error where results are taken ends all, and no process is left", function()
  check.fails(function()
    core.jobs(2, 2, function(i)
      while i == 2 do end
      return ""
    end, function() error "tolerance" end)
  end, "tolerance")
  local children = io.open "/proc/thread-self/children":read "a"
  check.equal(children, "")
end)

check.case("Ctrl-C ends the jobs and keeps what was done", function()
  local output, status = check.script([[
    local core = require "signorini.core"
    local id = io.open "/proc/self/stat":read "n"
    local mark = arg[1]
    local whole = core.jobs(3, 2, function(i)
      while i > 1 and not io.open(mark) do end -- until the first one has ended
      if i == 2 then os.execute("kill -INT " .. id) end
      while i > 1 do end
      return "done"
    end, function(i, text)
      print(i, text)
      core.write_file(mark, "")
    end)
  ]], check.file "ended")
  check.holds(output, "1\tdone\n", "interrupted")
  check.equal(status, 130)
end)

check.case("models are solved in jobs of a program that has used threads", function()
  local output, status = check.program({ "--threads", "3", "-e", [[
    local core = require "signorini.core"
    local function press(depth)
      local block = sg.body{ patch = sg.shapes.block{ size = {1, 1, 1} }, elements = {4, 4, 2}, order = "N2",
                             material = sg.neo_hookean{ E = 1, nu = 0.3 } }
      local model = sg.model{ bodies = { block = block }, supports = { foot = { on = block:face "front", fix = "xyz" },
                              head = { on = block:face "back", drive = "xyz" } } }
      return ("%.12g"):format(model:run{ { steps = 2, head = {0, 0, -depth} } }:column "head.fz"[2])
    end
    local here, there = { press(0.1), press(0.2) }, {}
    core.jobs(2, 2, function(i) return press(0.1 * i) end,
      function(i, text, failure) there[i] = text or failure end, 60)
    print(here[1] == there[1] and here[2] == there[2] and "same" or table.concat(there, " "))
  ]] })
  check.holds(output, "same")
  check.equal(status, 0)
end)
