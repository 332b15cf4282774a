-- One cell of a stability map: a model is built and taken along its path; what is left of it are plain values.

local check = require "signorini.check"
local core = require "signorini.core"
local types = require "signorini.types"

local where = "sg.stability_map"

--- How far a run came, 0 to 1: whole steps, and of the one that failed the part that was accepted.
local function reached(run, stages)
  local total, done = 0, run.steps
  for _, stage in ipairs(stages) do total = total + stage.steps end
  if run.failed then
    local from = 0
    for _, attempt in ipairs(run:attempts(run.steps + 1)) do from = attempt.again and from or attempt.from end
    done = done + math.max(0, math.min(1, from))
  end
  return done / total
end

--- Accepted increments, those of a step that failed in the end among them.
local function increments(run)
  local count = 0
  for step = 1, run.steps + (run.failed and 1 or 0) do
    for _, attempt in ipairs(run:attempts(step)) do count = count + (attempt.converged and 1 or 0) end
  end
  return count
end

--- The user's figures; those that are no finite numbers are left out.
local function read_figures(figures)
  local kept = {}
  check.value(types.map { kind = "number", gaps = true }, figures, where, "the result of figures")
  for name, value in next, figures do
    if value == value and math.abs(value) < math.huge then kept[name] = value end
  end
  return kept
end

--- Solves the cell at x, y with these functions: what a case of the study returns. Errors of theirs pass.
return function(functions, x, y)
  local model = functions.scene(x, y)
  if type(model) ~= "userdata" and type(model) ~= "table" then
    core.fail(("%s: scene must return a model, it returned %s"):format(where,
      model and core.describe(model) or "nothing"))
  end
  local stages, options = functions.path(model, x, y)
  local run = model:run(stages, options)
  local place, held = run.places and run.places[1], run.reason == "completed"
  local cell = { outcome = run.reason, reached = reached(run, stages), steps = run.steps, increments = increments(run),
                 iterations = run.iterations, cutbacks = run.cutbacks, rescues = run.rescues or 0, wall = run.wall,
                 report = run.report, place = place and place.text, figures = {} }
  if held and functions.figures then cell.figures = read_figures(functions.figures(model, run, x, y)) end
  return { cell = cell, failed = not held, reason = not held and ("%s: %s"):format(run.reason, run.report) or nil }
end
