-- Convergence maps: cells in separate processes, their outcomes, resumed files, pictures.

require "check"
local spring = require "spring"
local run_path = require "spring_run"

core.quiet = true

--- A spring that fails, for the reason that is its order's name, where it is pulled further than `holds`.
local function scene(order, steps)
  local model = spring(function(x, y)
    if order ~= "good" and math.abs(y) > 0.5 then return order end
  end)
  model.run = run_path
  return model
end

local function path(_, _, steps) return { { name = "press", steps = steps, grip = { 0, -1 } } }, sg.plain{} end

--- A map of two orders and two numbers of steps with some arguments changed.
local function make(changes)
  return sg.convergence_map(lists.merged({ name = "springs", x = { name = "order", values = { "good", "diverged" } },
    y = { name = "steps", values = { 4, 10 } }, scene = scene, path = path, jobs = 2 }, changes))
end

check.case("cells contain how far each run came, its cost, and why it failed", function()
  local map = make{ results = function(model, run) return { pull = -model.accepted[2] * run.steps, none = 0 / 0 } end }
  check.equal(#map.cells, 4)
  local good, bad = map:cell("good", 10), map:cell("diverged", 4)
  check.equal({ good.outcome, good.reached, good.steps, good.increments, good.iterations, good.cutbacks,
                good.fallback_steps },
    { "completed", 1, 10, 10, 30, 0, 0 })
  check.equal({ good.results.pull, good.results.none, good.report }, { 10, nil, nil })
  check.equal({ bad.outcome, bad.reached, bad.steps, bad.increments }, { "diverged", 0.5, 2, 2 })
  check.equal(bad.iterations, 2 * 3 + 25)
  check.holds(bad.report, "step 3", "no luck")
  check.equal(next(bad.results), nil)
  check.equal({ map:converged() }, { 2, 4 })
  check.equal({ map.cells[1].x, map.cells[1].y, map.cells[2].x, map.cells[3].y }, { "good", 4, "diverged", 10 })
end)

check.case("the fraction of a step that was accepted after cut-backs counts", function()
  local map = make{ path = function(_, _, steps)
    return { { steps = steps, grip = { 0, -1 } } }, { step = { adaptive = true, min = 1 / 4 } }
  end, y = { name = "steps", values = { 3 } } }
  local bad = map:cell("diverged", 3)
  check.near(bad.reached, 0.5, 1e-12)
  check.equal({ bad.steps, bad.increments, bad.cutbacks }, { 1, 2, 2 })
end)

check.case("fallbacks and the place of a failure come from the run", function()
  local map = make{ scene = function(order)
    local model = scene(order)
    function model:run(stages)
      local run = run_path(self, stages)
      run.fallback_steps = 3
      if run.failed then run.places = { { text = "J = -0.2 in element 7" } } end
      return run
    end
    return model
  end }
  check.equal({ map:cell("good", 4).fallback_steps, map:cell("good", 4).place }, { 3, nil })
  check.equal(map:cell("diverged", 4).place, "J = -0.2 in element 7")
end)

check.case("errors, crashes and endless loops are outcomes of their cells only", function()
  local map = make{ limit = 0.5, x = { name = "order", values = { "good", "wrong", "none", "crash", "endless" } },
    y = { name = "steps", values = { 4 } },
    scene = function(order)
      if order == "wrong" then error "the slab is missing" end
      if order == "crash" then os.execute "kill -SEGV $PPID" end
      while order == "endless" do end
      return order ~= "none" and scene(order) or nil
    end }
  local function outcome(order) return map:cell(order, 4).outcome end
  check.equal({ outcome "good", outcome "wrong", outcome "none", outcome "crash", outcome "endless" },
    { "completed", "error", "error", "crashed", "time" })
  check.holds(map:cell("wrong", 4).report, "the slab is missing", "convergence_map_test.lua:", "traceback")
  check.holds(map:cell("none", 4).report, "scene must return a model")
  check.equal({ map:cell("crash", 4).report, map:cell("endless", 4).wall }, { "terminated by signal 11", 0.5 })
  check.holds(tostring(map), "1 of 5 cells converged", "error at wrong, 4: ", "the slab is missing")
end)

check.case("the table and the CSV file", function()
  local map = make{ results = function() return { pull = 0.25 } end }
  local lines = {}
  for line in map:table():gmatch "[^\n]+" do lines[#lines + 1] = line:gsub("%s+", " "):gsub("^ ", "") end
  check.equal(lines[1], "order steps outcome reached increments iterations cut-backs fallback_steps wall pull")
  check.holds(lines[3], "good 4 completed 100.0 4 12 0 0", "0.25")
  check.holds(lines[4], "diverged 4 diverged 50.0 2 31 0 0", "–")
  local file = check.file()
  map:csv(file)
  local data = sg.csv.read(file)
  check.equal(data.comments[1], "convergence map: springs; x: order; y: steps")
  check.equal(data:column "outcome", { "completed", "diverged", "completed", "diverged" })
  local pull = data:column "result pull"
  check.equal({ pull[1], pull[2], pull[3], pull[4] }, { 0.25, nil, 0.25, nil })
  check.holds(data:column "report"[2], "no luck")
end)

check.case("a file keeps finished cells; a second call solves only those that are missing", function()
  local file, trace, broken = check.file(), check.file(), check.file()
  core.write_file(broken, "")
  local function noted(order, steps)
    local out = assert(io.open(trace, "a"))
    out:write(order, steps, " "):close()
    if order == "diverged" and core.exists(broken) then error "broken" end
    return scene(order)
  end
  local results = function() return { ["a b"] = 0.1, c = -1e300 } end
  local function solve(changes)
    os.remove(trace)
    local options = lists.merged({ file = file, scene = noted, jobs = 1, results = results }, changes)
    local map = make(options)
    return map, core.exists(trace) and core.read_file(trace) or ""
  end
  local first, solved = solve{ y = { name = "steps", values = { 10 } } }
  check.equal(solved, "good10 diverged10 ")
  os.remove(broken)
  local second, more = solve()
  check.equal(more, "good4 diverged4 diverged10 ") -- an error is solved again
  local before, after = first:cell("good", 10), second:cell("good", 10)
  for _, key in ipairs { "outcome", "reached", "steps", "increments", "iterations", "cutbacks", "fallback_steps",
                         "wall" } do
    check.equal(after[key], before[key])
  end
  check.equal({ after.results["a b"], after.results.c }, { 0.1, -1e300 })
  check.equal(#sg.csv.read(file).rows, 4)
  -- Other values leave the cells that are there in the folder; those of the file are the map's.
  check.equal(select(2, solve{ x = { name = "order", values = { "nan" } } }), "nan4 nan10 ")
  check.equal(sg.csv.read(file):column "outcome", { "nan", "nan" })
  check.equal({ select(2, solve()), #sg.csv.read(file).rows }, { "", 4 })
  -- What the cells depend on: the functions and all that they refer to, as in a study.
  local most = 5
  check.equal(select(2, solve{ results = function() return { most = most } end }), "good4 diverged4 good10 diverged10 ")
  check.fails(function() solve{ name = "rings" } end, "convergence_map_test.lua:", "sg.convergence_map", file,
    "springs", "rings", "choose another file")
  os.remove(file) -- all again, also under another name
  check.equal(select(2, solve{ name = "rings" }), "good4 diverged4 good10 diverged10 ")
end)

check.case("the inputs of another map that the functions refer to count, not its times", function()
  local file, trace = check.file(), check.file()
  local function solve(force)
    local reference = make{ y = { name = "steps", values = { 2 } }, results = function() return { force = force } end }
    os.remove(trace)
    local map = make{ file = file, y = { name = "steps", values = { 4 } }, results = function(_, run)
      core.write_file(trace, "solved")
      return { error = run.steps - reference:cell("good", 2).results.force }
    end }
    return { map:cell("good", 4).results.error, core.exists(trace) }
  end
  check.equal(solve(1), { 3, true })
  check.equal(solve(1), { 3, false })
  check.equal(solve(2), { 2, true })
end)

check.case("a file that is not this map's, has lost its folder or is in use is not touched", function()
  local file = check.file()
  core.write_file(file, "a,b\n1,2\n")
  check.fails(function() make{ file = file } end, "sg.convergence_map: '" .. file .. "' contains something other",
    "without a title")
  check.equal(core.read_file(file), "a,b\n1,2\n")
  os.remove(file)
  make{ file = file }
  local before = core.read_file(file)
  check.shell(("rm -r %s.cells"):format(file))
  check.fails(function() make{ file = file } end, "sg.convergence_map: the cells in '" .. file, "restore it")
  check.equal(core.read_file(file), before)
  os.remove(file)
  core.mkdir(file .. ".cells")
  local lock = core.lock(file .. ".cells/lock")
  check.fails(function() make{ file = file } end, "convergence_map_test.lua:", "sg.convergence_map: '" .. file,
    "is locked by process")
  lock:release()
end)

check.case("Ctrl-C and kill -9 leave the finished cells in the file", function()
  for _, signal in ipairs { "INT", "KILL" } do
    local file = check.file "file"
    local _, status = check.script(([[
      local sg = require "signorini"
      local id = io.open "/proc/self/stat":read "n"
      package.path = %q .. package.path
      local spring, run = require "spring", require "spring_run"
      sg.convergence_map{ x = { name = "a", values = { 1, 2 } }, y = { name = "b", values = { 1 } }, jobs = 1, file =
%q,         scene = function(a)
          if a == 2 then os.execute("kill -%s " .. id) end
          while a == 2 do end
          local model = spring()
          model.run = run
          return model
        end, path = function() return { { steps = 2, grip = { 0, -1 } } } end }
    ]]):format(core.home .. "/tests/lua/?.lua;", file, signal))
    check.equal(status, signal == "INT" and 130 or 137)
    check.equal(sg.csv.read(file):column "outcome", { "completed" })
  end
end)

check.case("maps are compared cell by cell", function()
  local plain = make{ x = { name = "order", values = { "good", "nan", "inverted", "late" } } }
  local other = make{
    x = { name = "order", values = { "good", "nan", "inverted", "late" } },
    scene = function(order, steps)
      if order == "nan" and steps == 4 then return scene "good" end
      return scene(order == "good" and "late" or order)
    end,
  }
  local result = plain:compare(other)
  check.equal(result.recovered, { { "nan", 4 } })
  check.equal(result.lost, { { "good", 4 }, { "good", 10 } })
  check.equal({ result.both, result.neither }, { 0, 5 })
  check.fails(function() plain:compare {} end, "map:compare", "convergence map")
end)

-- ── Pictures ─────────────────────────────────────────────────────────────────────────────────────────────────────────

--- What sg.heatmap was given by a body.
local function charts_of(body)
  local charts = {}
  rawset(sg, "heatmap", function(chart) charts[#charts + 1] = chart end)
  local ok, message = pcall(body)
  rawset(sg, "heatmap", nil)
  if not ok then error(message, 0) end
  return charts
end

check.case("the picture of outcomes: rows from the first y on, numbers in the cells, the legend's order", function()
  local map = make{ results = function(_, run) return { load = run.steps / 3 } end }
  local charts = charts_of(function()
    map:picture{ file = "a.png" }
    map:picture{ file = "b.png", title = "Springs", text = "reached", size = { 800, 600 } }
    map:picture{ file = "c.png", text = "load" }
  end)
  local a, b, c = table.unpack(charts)
  check.equal({ a.file, a.title, a.xlabel, a.ylabel }, { "a.png", "springs", "order", "steps" })
  check.equal({ a.x, a.y }, { { "good", "diverged" }, { 4, 10 } })
  check.equal(a.values, { { "completed", "diverged" }, { "completed", "diverged" } })
  check.equal(a.texts, { { "12", "31" }, { "30", "40" } })
  check.equal({ a.categories[1].name, a.categories[#a.categories].name, #a.categories },
    { "completed", "friction_exhausted", 21 })
  check.equal({ b.title, b.size, b.texts[1] }, { "Springs", { 800, 600 }, { "100%", "50%" } })
  check.equal({ c.texts[1][1], c.texts[1][2] }, { 1.3, nil }) -- a number: the heat map writes powers of ten
end)

check.case("a result: numbers with a color bar, blank where there is none", function()
  local map = make{ results = function(_, run) return { load = run.steps / 3 } end }
  local function draw() map:heatmap{ name = "load", file = "f.png", log = true, label = "load (N)" } end
  local chart = charts_of(draw)[1]
  check.near({ chart.values[1][1], chart.values[2][1] }, { 4 / 3, 10 / 3 }, 1e-15)
  check.equal({ chart.values[1][2], chart.log, chart.label, chart.title },
    { nil, true, "load (N)", "springs: load (N)" })
  check.equal(chart.categories, nil)
end)

check.case("two maps side by side share the axes", function()
  local plain, controls = make(), make{ name = "controls", scene = function(order)
    return scene(order == "diverged" and "strange" or order)
  end }
  local charts = charts_of(function()
    plain:picture{ file = "both.png", other = controls, titles = { "plain Newton", "with controls" } }
    plain:heatmap{ name = "iterations", file = "both.png", other = controls }
  end)
  local panels = charts[1].panels
  check.equal({ panels[1].title, panels[2].title, charts[1].values }, { "plain Newton", "with controls", nil })
  check.equal({ panels[1].values[1], panels[2].values[1] }, { { "completed", "diverged" }, { "completed", "strange" } })
  check.equal(charts[1].categories[22].name, "strange")
  check.equal({ charts[2].panels[2].title, charts[2].panels[2].values[1] }, { "controls", { 12, 31 } })
  local other = make{ x = { name = "order", values = { "good" } } }
  check.fails(function() plain:picture{ file = "x.png", other = other } end, "map:picture",
    "other must be a map of the same values of x and y")
end)

-- ── A real model ─────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("a block is pressed into a plane: long steps fail", function()
  local map = sg.convergence_map{
    name = "block on a plane",
    x = { name = "penalty", values = { 10, 1e3 } }, y = { name = "depth", values = { 0.1, 3 } },
    scene = function(penalty)
      return scenes.model{ bodies = { block = { contact = "south", thickness_degree = 1 } },
        supports = { head = { on = "north", drive = "xy" } },
        contacts = { ground = { slave = "south", penalty = penalty, master = scenes.floor(-1e-3) } } }
    end,
    path = function(_, _, depth) return { { name = "press", steps = 2, head = { 0, -depth - 1e-3 } } }, sg.plain{} end,
    results = function(model, run) return { force = run:column "ground.fy"[run.steps] } end,
    jobs = 2, limit = 60,
  }
  check.equal({ map:converged() }, { 2, 4 })
  check.equal({ map:cell(10, 0.1).outcome, map:cell(10, 3).outcome }, { "completed", "inverted" })
  check.equal({ map:cell(1e3, 3).reached, map:cell(1e3, 3).steps }, { 0, 0 })
  check.holds(map:cell(10, 3).report, "step 1 (stage 'press', 1 of 2) was not reached")
  check.near(map:cell(10, 0.1).results.force, 0.1113, 1e-3)
end)

check.case("wrong arguments are errors at the user's line that name the cure", function()
  check.fails(function() make{ x = { name = "order", values = { "a", "a" } } } end, "x.values has the string 'a' twice")
  check.fails(function() make{ x = { name = "wall", values = { 1 } } } end, "convergence_map_test.lua:",
    "sg.convergence_map: x.name cannot be 'wall'")
  check.fails(function() make{ x = { name = "steps", values = { 1 } } } end,
    "x.name and y.name must differ, both are 'steps'")
  check.fails(function() make{ x = { name = "order", values = { 1, "1" } } } end, "convergence_map_test.lua:",
    "sg.convergence_map: cases[1] and cases[2] are both called 'order=1 steps=4'")
  local solved = check.file()
  core.write_file(solved, "")
  check.fails(function()
    make{ file = "nowhere/map.csv", scene = function(order) os.remove(solved) return scene(order) end }
  end, "convergence_map_test.lua:", "sg.convergence_map: cannot write 'nowhere/map.csv'", 'sg.mkdir "nowhere"')
  check.equal(os.remove(solved), true) -- no cell was solved before
  local map = make{ x = { name = "order", values = { "good" } }, scene = function() return 3 end }
  check.holds(map.cells[1].report, "scene must return a model, got the number 3")
  check.fails(function() make{ on = "slurm" } end, "unknown argument 'on'")
  check.fails(function() sg.convergence_map() end, "sg.convergence_map")
  check.fails(function() make():cell("good", 5) end, "map:cell: y must be one of the values of steps, got the number 5")
end)

check.case("piped, each cell is a line; quiet, there is none", function()
  local code = ([[
    package.path = %q .. package.path
    local sg, spring, run = require "signorini", require "spring", require "spring_run"
    sg.convergence_map{ name = "m", x = { name = "a", values = { 1, 2 } }, y = { name = "b", values = { 5 } }, jobs = 1,
      scene = function(a)
        local model = spring(a == 2 and function(_, y) return y < -0.6 and "nan" or nil end or nil)
        model.run = run
        return model
      end, path = function() return { { steps = 2, grip = { 0, -1 } } }, sg.plain{} end }
  ]]):format(core.home .. "/tests/lua/?.lua;")
  local output = check.program { "-e", code }
  check.holds(output, "m: 1 of 2: a=1 b=5: ", "m: 2 of 2: a=2 b=5: failed: nan: step 2 ")
  check.equal(check.program { "-q", "-e", code }, "")
end)

check.case("--on another place is refused at the user's line, before anything is solved or written", function()
  local folder = check.folder()
  core.write_file(folder .. "/map.lua", [[
local sg = require "signorini"
local function solve() error "solved" end
sg.convergence_map{ x = { name = "a", values = { 1 } }, y = { name = "b", values = { 2 } }, scene = solve, path = solve,
                    file = "map.csv" }
]])
  local function run(words) return check.shell(("cd '%s' && '%s' map.lua %s"):format(folder, arg[-1], words)) end
  for _, place in ipairs { "slurm", "ssh:h1,ssh:h2" } do
    check.ended({ run("--on " .. place) }, 1, "map.lua:3: sg.convergence_map: --on " .. place .. " cannot be followed",
      "Hint: leave out --on, and pass on to study:execute")
    check.equal(core.exists(folder .. "/map.csv"), false)
  end
  check.holds(run "--on local", "a=1 b=2: map.lua:2: solved")
end)
