-- Times of the linear solvers on models of the studies. A solver stays in the program only if it is at least 1.3 times
-- as fast as the remaining ones on some model.

local sg = require "signorini"
local hertz = require "problems.hertz2d.problem"
local ironing3d = require "problems.ironing3d.problem"
local measure = require "benchmark.measure"
local peeling = require "problems.peeling2d.problem"
local rings = require "problems.rings2d.problem"

local solvers = { kinds = { "klu", "umfpack", "reuse", "condensed", "mumps", "mumps, reuse", "auto" } }

-- ── Scenes: begin(steps) → model, stages ─────────────────────────────────────────────────────────────────────────────

local function ironing(problem, mesh)
  return function(steps)
    local model, _, press, slide = measure.problems[problem].begin("N2", mesh, steps)
    return model, { press, slide }
  end
end

local function peel(steps)
  return peeling.scene("N2", "m2", peeling.length, peeling.bonded),
    { { name = "rotate", steps = steps, edge = peeling.pitch * steps } }
end

local function two_rings(steps)
  return rings.scene("N2-N2.2", "m4"), { { name = "press", steps = steps, grip = { -0.1 * steps } } }
end

local function pressed_ring(mesh)
  return function(steps)
    local model, stage = hertz.scene{ order = "N2", mesh = mesh, load = "displacement" }
    stage.steps = steps
    return model, { stage }
  end
end

local function square(count)
  return function(steps)
    local body = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = { count, count },
                          order = "N2", contact = "north", thickness_degree = 2,
                          material = sg.neo_hookean{ E = 1, nu = 0.3 } }
    local model = sg.model{ bodies = { body = body }, supports = {
      bed = { on = body:face "south", fix = "xy" }, lid = { on = body:face "north", drive = "xy" } } }
    return model, { { name = "press", steps = steps, lid = { 0, -0.02 * steps } } }
  end
end

local function solid(fineness)
  return function(steps)
    local model = ironing3d.scene({ order = "N2", mesh = "coarse", fineness = fineness, radius = 7.5 }, 50)
    return model, { { name = "press", steps = 1, grip = { 0, 0, -0.5 } },
                    { name = "slide", steps = steps, grip = { 0.3 * steps, 0, -0.5 } } }
  end
end

--- By name: begin, steps; `linear`: all bodies are linear elastic; `without`: solvers that would take hours.
local scenes = {
  ["ironing-m1"] = { ironing("plane", "m1"), 40 }, ["ironing-m3"] = { ironing("plane", "m3"), 20 },
  ["ironing-m4"] = { ironing("plane", "m4"), 8 }, ["peeling-m2"] = { peel, 20 }, ["rings-m4"] = { two_rings, 10 },
  ["hertz-m1"] = { pressed_ring "m1", 10, linear = true }, ["hertz-m3"] = { pressed_ring "m3", 10, linear = true },
  ["solid-coarse"] = { ironing("solid", "coarse"), 3 }, ["square-64"] = { square(64), 5 },
  ["square-220"] = { square(220), 2 }, ["solid-15k"] = { solid(2), 1, without = { klu = true } },
  ["solid-60k"] = { solid(3.25), 1, without = { klu = true, umfpack = true } },
  ["solid-100k"] = { solid(4), 1, without = { klu = true, umfpack = true } },
}
solvers.usual = { "ironing-m1", "ironing-m3", "ironing-m4", "rings-m4", "peeling-m2", "square-64", "hertz-m1",
                  "hertz-m3", "solid-coarse" }
solvers.names = { "square-220", "solid-15k", "solid-60k", "solid-100k" } -- take minutes each
table.move(solvers.usual, 1, #solvers.usual, #solvers.names + 1, solvers.names)

--- Seconds of processor time in the linear solver, from its fraction of the run's wall time, and the result of
--- model:solver().
local function solve(scene, kind)
  collectgarbage() -- Lua does not count the memory of models
  local model, stages = scene[1](scene[2])
  local began = os.clock()
  local linear, reuse = kind:match "^[^,]+", kind == "mumps, reuse"
  local run = model:run(stages, sg.plain{ linear = linear, mumps = reuse and { reuse = true } or nil,
                                          step = { adaptive = true } })
  if run.failed then error(run.failure, 0) end
  return (os.clock() - began) * run.timings.linear / run.wall, model:solver()
end

--- Whether a solver is to be measured on a scene; MUMPS is an error where its library is not installed.
local function is_suitable(scene, kind, has_mumps)
  if kind == "condensed" then return scene.linear end
  return not (scene.without and scene.without[kind]) and (has_mumps or not kind:find "^mumps")
end

--- A sheet of the scenes with these names: processor seconds in the linear solver by its kind, medians of `repeats`.
function solvers.sheet(names, repeats)
  local sheet = { columns = { "model", "unknowns", "auto selects" }, formats = { "%s", "%d", "%s" }, rows = {} }
  local has_mumps, message = pcall(solve, scenes["ironing-m1"], "mumps")
  if not has_mumps and not message:find("signorini_mumps.so", 1, true) then error(message, 0) end
  for k, kind in ipairs(solvers.kinds) do sheet.columns[3 + k], sheet.formats[3 + k] = kind, "%.3g" end
  for i, name in ipairs(names) do
    local scene, times, last = scenes[name], {}, nil
    for round = 1, repeats do -- in turns, so that disturbances affect all alike
      for k, kind in ipairs(solvers.kinds) do
        if is_suitable(scene, kind, has_mumps) then
          times[k] = times[k] or {}
          times[k][round], last = solve(scene, kind)
        end
      end
    end
    sheet.rows[i] = { name, last.unknowns, last.linear }
    for k in ipairs(solvers.kinds) do sheet.rows[i][3 + k] = times[k] and sg.median(times[k]) end
  end
  return sheet
end

return solvers
