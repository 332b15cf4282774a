-- Error bars of runs: closed forms of single terms, what is unknown, where they appear.

require "check"

local function strip(o)
  return scenes.model{
    bodies = { block = { size = { 4, 1 }, elements = o.elements or { 16, 4 }, contact = "south" } },
    supports = { grip = { on = "north", drive = "y", fix = "x" } },
    contacts = { floor = { slave = "south", penalty = o.penalty or 200, friction = o.friction,
                           master = o.master or sg.rigid.cylinder{ center = { 2, -8 }, radius = 8 } } } }
end

local press = { { name = "press", steps = 4, grip = -0.1 } }

local function bar(run, name) return run:budget(name, run.rows) end

-- ── Closed forms ─────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("penalty: of a column on a penalty plane, F k/ε", function()
  local E, height, d, penalty = 1, 1, 0.01, 20
  local model = scenes.model{ bodies = { block = { material = sg.linear_elastic{ E = E, nu = 0 }, contact = "south" } },
    supports = { grip = { on = "north", drive = "y" }, side = { on = "west", fix = "x" } },
    contacts = { floor = { slave = "south", master = scenes.floor(), penalty = penalty } } }
  local run = model:run({ { steps = 2, grip = -d } }, { errors = true })
  local k = E / height
  local exact, force = k * d, run:column("grip.fy")[2]
  check.near(bar(run, "grip.fy").penalty, exact - math.abs(force), 0.1 * (exact - math.abs(force)))
  check.at_most("mesh", bar(run, "grip.fy").bulk / exact, 1e-9) -- one element is exact
end)

check.case("steps: the error of slip that is measured at the end of each step, c/n", function()
  local function drag(times)
    return sg.scenes.ironing{ order = "N2", mu = 0.3, refinement = 2 }:run({ { steps = 4 * times, grip = { 0, -0.1 } },
      { steps = 8 * times, grip = { 0.6, -0.1 } } }, { errors = times == 1 })
  end
  local run, fine, estimated, exact = drag(1), drag(16), 0, 0
  for row = 1, 12 do
    estimated = estimated + run:budget("grip.fx", row).steps ^ 2
    exact = exact + (run:column("grip.fx")[row] - fine:column("grip.fx")[16 * row]) ^ 2
  end
  check.within_share("term of the steps, root mean square", math.sqrt(estimated), math.sqrt(exact), 0.3)
end)

check.case("without contact only the mesh has a term, without friction the steps have none", function()
  local model = scenes.model{
    bodies = { block = { elements = { 4, 4 } } },
    supports = { bed = { on = "south", fix = "xy" }, grip = { on = "north", drive = "xy" } } }
  local budget = bar(model:run({ { steps = 2, grip = { 0.3, 0 } } }, { errors = true }), "grip.fx")
  check.equal({ budget.penalty, budget.points, budget.steps }, {})
  if not (budget.bulk > 0) then error "no term of the mesh" end
  check.equal(bar(strip{}:run(press, { errors = true }), "grip.fy").steps, nil)
  local later = { press[1], { steps = 2, grip = -0.11, contacts = { floor = { friction = { mu = 0.2 } } } } }
  if not bar(strip{ friction = { mu = 0 } }:run(later, { errors = true }), "grip.fy").steps then error "no steps" end
end)

-- ── Bars hold ────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("the forces of a finer model are inside the bars, root mean squares over the path; a run without errors has "
  .. "the same bits", function()
  local run, plain = strip{}:run(press, { errors = true }), strip{}:run(press)
  local finer = strip{ elements = { 64, 16 }, penalty = 2000 }:run{ { steps = 8, grip = -0.1 } }
  local errors, limits = 0, 0
  for row = 1, 4 do
    check.equal(run:column("grip.fy")[row], plain:column("grip.fy")[row])
    errors = errors + (run:column("grip.fy")[row] - finer:column("grip.fy")[2 * row]) ^ 2
    limits = limits + run:error("grip.fy")[row] ^ 2
  end
  check.at_most("error", math.sqrt(errors), math.sqrt(limits))
  check.at_most("bar", math.sqrt(limits), 4 * math.sqrt(errors))
  check.at_most("iterations of companions in the run", run.iterations - plain.iterations, 0)
end)

check.case("mesh only: two companions, whose term is the bar", function()
  local run = strip{}:run(press, { errors = "mesh" })
  local budget = bar(run, "grip.fy")
  check.equal(budget.steps, nil)
  check.equal(budget.row, nil)
  check.near(budget.error, budget.bulk + budget.newton, 1e-15)
end)

check.case("a further run repeats the earlier ones", function()
  local model = strip{}
  model:run(press)
  local run = model:run({ { name = "lift", steps = 2, grip = -0.05 } }, { errors = "mesh" })
  check.at_most("relative", run:error("grip.fy")[2] / math.abs(run:column("grip.fy")[2]), 0.2)
end)

check.case("a scene function gives the other meshes", function()
  local meshes = {}
  local function scene(q)
    meshes[#meshes + 1] = q.mesh
    return strip{ elements = { math.ceil(16 * q.mesh), math.ceil(4 * q.mesh) } }, press
  end
  local with = strip{}:run(press, { errors = { terms = "mesh", scene = scene } })
  local without = strip{}:run(press, { errors = "mesh" })
  check.equal(with:error("grip.fy")[4], without:error("grip.fy")[4])
end)

check.case("measure: columns of the user have bars, those of on_step have none", function()
  local run = strip{}:run(press, { errors = "mesh",
    measure = function(model) return { half = model:reaction("grip").fy / 2 } end,
    on_step = function() return { other = 1 } end })
  check.near(run:error("half")[4], run:error("grip.fy")[4] / 2, 1e-3 * run:error("half")[4])
  check.fails(function() run:error "other" end, "other")
end)

-- ── What is unknown ──────────────────────────────────────────────────────────────────────────────────────────────────

local function is_nan(value) return value ~= value end

check.case("the peak under a sharp edge has no limit", function()
  local block = sg.rigid.surface(sg.nurbs.line{ from = { 2.5, 0 }, to = { 1.5, 0 } })
  local run = strip{ master = block, elements = { 32, 8 }, penalty = 1e4 }:run(press, { errors = "mesh" })
  check.equal(bar(run, "floor.max_pressure").why, "no limit")
  if not is_nan(run:error("floor.max_pressure")[4]) then error "it has a bar" end
end)

check.case("peaks at edges: ends of either face; not planes of symmetry, axes, or contacts inside faces", function()
  local function pressed(o)
    local run = o.model:run(o.path or press)
    check.completed(run)
    check.equal(core.is_peak_at_edge(o.model, o.contact or "floor"), o.edge)
  end
  pressed{ model = strip{}, edge = false }
  local line = sg.nurbs.line{ from = { 2.5, 0 }, to = { 1.5, 0 } }
  pressed{ model = strip{ master = sg.rigid.surface(line) }, edge = true }
  for _, body in ipairs { "cylinder", "ball" } do
    local model, path = sg.scenes.hertz{ body = body, order = "N2", refinement = 1 }
    pressed{ model = model, path = path, contact = "ground", edge = false }
  end
  for _, faces in ipairs { { "block.south", "slab.north" }, { "slab.north", "block.south" } } do
    pressed{ contact = "touch", edge = true, path = { { steps = 2, grip = { 0, -0.05 } } }, model = scenes.model{
      bodies = { slab = { size = { 4, 1 }, elements = { 16, 4 } },
                 block = { size = { 1, 1 }, corner = { 1.5, 1 }, elements = { 6, 4 }, E = 100 } },
      supports = { bed = { on = "slab.south", fix = "xy" }, grip = { on = "block.north", drive = "xy" } },
      contacts = { touch = { slave = faces[1], master = faces[2] } } } }
  end
end)

check.case("a model from a file has no table: unknown, with the reason", function()
  local file = check.folder() .. "/model.sgn"
  strip{}:save(file)
  local run = sg.load(file):run(press, { errors = true })
  if not is_nan(run:error("grip.fy")[4]) then error "it has a bar" end
  check.holds(tostring(run), "errors are unknown: the model was not made by sg.model")
end)

check.case("after steps of the user's own: unknown, with the reason", function()
  local model = strip{}
  model:set_target("grip", { -0.05 })
  model:solve_step()
  model:accept()
  check.holds(tostring(model:run(press, { errors = true })), "not reached by completed runs")
end)

check.case("a companion that fails: unknown from there on, never 0", function()
  local calls = 0
  local run = strip{}:run(press, { errors = { scene = function(q)
    calls = calls + 1
    if q.mesh < 1 / 2 then return strip{ elements = { 4, 1 } }, press end
    return strip{ elements = { 8, 2 } }, { { steps = 4, grip = -0.9 } }, { newton = { iterations = 3 },
      step = { adaptive = false }, fallback = false }
  end } })
  if not is_nan(run:error("grip.fy")[4]) then error "it has a bar" end
  check.holds(tostring(run), "unknown")
end)

check.case("errors of the scene function are errors; without options it has those of the run", function()
  local function wrong(scene, ...)
    check.fails(function() strip{}:run(press, { errors = { scene = scene } }) end, ...)
  end
  wrong(function() return 1 end, "errors.scene must return a model")
  wrong(function() return strip{} end, "stages")
  wrong(function() error "oops" end, "oops")
  wrong(function() return strip{}, { { steps = 2, grip = -0.1 } } end, "steps of the run")
  local run = strip{}:run(press, { measure = function(model) return { fy = model:reaction("grip").fy } end,
    errors = { terms = "mesh", scene = function(q)
      return strip{ elements = { math.ceil(16 * q.mesh), math.ceil(4 * q.mesh) } }, press
    end } })
  check.near(run:error("fy")[4], run:error("grip.fy")[4], 1e-12)
end)

check.case("changes of contacts before the run: unknown, or repeated with the run that made them", function()
  local model = strip{ friction = { mu = 0 } }
  model:set_contact("floor", { friction = { mu = 0.5 } })
  check.holds(tostring(model:run(press, { errors = "mesh" })), "errors are unknown", "or its contacts were changed")
  local other = strip{ friction = { mu = 0 } }
  other:run{ { steps = 1, grip = -0.05, contacts = { floor = { friction = { mu = 0.5 } } } } }
  local run = other:run({ { steps = 1, grip = -0.1 } }, { errors = "mesh" })
  if is_nan(run:error("grip.fy")[1]) then error "it has no bar" end
end)

check.case("a body with one element in a direction: doubtful, with the reason", function()
  local run = strip{ elements = { 16, 1 } }:run(press, { errors = "mesh" })
  check.equal(bar(run, "grip.fy").why, "one element")
  check.holds(tostring(run), "±?", "one element in a direction")
end)

-- ── Where they appear ────────────────────────────────────────────────────────────────────────────────────────────────

check.case("columns, files, table; resumed runs have the same bars", function()
  local folder = check.folder()
  local options = { errors = true, hdf5 = folder .. "/run.h5", checkpoint = folder .. "/run.sgn" }
  local run = strip{}:run(press, options)
  check.equal(run:column("grip.fy.error")[4], run:error("grip.fy")[4])
  run:csv(folder .. "/run.csv")
  check.equal(sg.csv.read(folder .. "/run.csv"):column "grip.fy.error"[4], run:error("grip.fy")[4])
  local file = core.open_result_file(folder .. "/run.h5")
  check.equal(file:numbers("/columns/grip.fy.error")[4], run:error("grip.fy")[4])
  check.holds(tostring(run), "±")
  check.holds(tostring(run), "to halve it")
  local again = strip{}:run(press, lists.merged(options, { resume = true }))
  check.equal(again:error("grip.fy")[4], run:error("grip.fy")[4])
end)

check.case("a run that is continued from the middle of its path keeps the companions of its beginning", function()
  local options = { errors = "mesh", checkpoint = check.folder() .. "/run.sgn" }
  strip{}:run(press, lists.merged(options, { on_step = function(info) return info.step == 2 and "stop" or nil end }))
  local run = strip{}:run(press, lists.merged(options, { resume = true }))
  local whole = strip{}:run(press, { errors = "mesh" })
  check.equal(run.rows, 4)
  check.near(run:error "grip.fy", whole:error "grip.fy", 1e-9)
end)

check.case("wrong input", function()
  local model = strip{}
  local function wrong(options, ...)
    check.fails(function() model:run(press, options) end, ...)
  end
  wrong({ errors = "all" }, "errors")
  wrong({ errors = 2 }, "errors")
  wrong({ errors = { term = "mesh" } }, "term")
  wrong({ errors = { terms = "steps" } }, "terms")
  wrong({ errors = { scene = 3 } }, "scene")
  wrong({ errors = true, arc_length = true }, "arc_length")
  wrong({ measure = 3 }, "measure")
  check.fails(function() strip{}:run(press, { measure = function() return 3 end }) end, "measure")
  check.fails(function() strip{}:run(press, { measure = function() return { ["grip.fx"] = 3 } end }) end, "grip.fx")
  local plain = strip{}:run(press)
  check.fails(function() plain:error "grip.fy" end, "errors = true")
  check.fails(function() plain:budget "grip.fy" end, "errors = true")
  local run = strip{}:run(press, { errors = "mesh" })
  check.fails(function() run:error "grip.fz" end, "grip.fy")
  check.fails(function() run:budget("grip.fy", 9) end, "step")
  check.fails(function() run:budget("grip.fy", 0) end, "step")
  check.fails(function() run:error() end, "name")
end)
