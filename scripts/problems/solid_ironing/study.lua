-- Ironing of a slab without friction: runs orders along the path of a problem, measures their forces.
--
-- A problem is { title, die (its name), length (the slab's), start (x of the die's center), depth, distance (of
-- sliding), scene(case) }; scene returns the model with the supports `grip` (drives x and z) and `bed` and the contact
-- `interface`, the die and the slab. A case is { order, mesh, press, slide (steps), thickness_degree, points, half (the
-- scene is cut at its plane of symmetry, y = const.), formulation (a row of formulations/rows.lua), line_search,
-- tolerance (of Newton's method), linear }; see study.solve.

local sg = require "signorini"
local plane = require "problems.ironing2d.measure"

local study = {}

-- ── Measures ─────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Where a run with plain Newton would have ended: { step, reason } of the first failed attempt; nil
--- if none failed.
local function first_failure(run)
  for step = 1, run.steps + (run.failed and 1 or 0) do
    for _, attempt in ipairs(run:attempts(step)) do
      if not attempt.converged then return { step = step, reason = attempt.reason } end
    end
  end
end

--- The steps of about one element pitch of the slab in the middle of the slide.
local function window(problem, case)
  local steps = case.slide * problem.length / case.mesh.slab[1] / problem.distance
  local middle = case.press + case.slide / 2
  return math.floor(middle - steps / 2 + 0.5), math.floor(middle + steps / 2 + 0.5)
end

--- Adds results of the run to a case: see study.solve.
local function measure(problem, case)
  local run = case.run
  case.x, case.Px, case.Pz = run:column "grip.ux", run:column "grip.fx", run:column "grip.fz"
  local parts = case.half and 2 or 1
  for i = 1, run.steps do
    case.x[i], case.Px[i], case.Pz[i] = problem.start + case.x[i], parts * case.Px[i], -parts * case.Pz[i]
  end
  case.pressed, case.first_failure = case.Pz[case.press], first_failure(run)
  case.first, case.last = window(problem, case)
  case.dPx = plane.oscillation(case.Px, case.first, case.last)
  case.dPz = plane.oscillation(case.Pz, case.first, case.last)
  if run.failed then return end
  local drag = table.move(case.Pz, case.press + 1, #case.Pz, 1, {})
  local sum = 0
  for _, value in ipairs(drag) do sum = sum + value end
  case.drag = { mean = sum / #drag, low = math.min(table.unpack(drag)), high = math.max(table.unpack(drag)) }
end

--- Adds the oscillations in % of those of a case, if given: raw_percent, detrended_percent.
function study.compare(cases, reference)
  plane.percent(cases, { "dPx", "dPz" }, reference)
end

-- ── Runs ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Runs a case, also with on_step(model, info); failed steps are halved. Adds to it: run, dofs (both bodies),
--- user (seconds of processor time that the run took, all threads), x (of the die's center), Px, Pz (forces on the
--- slab, of the whole scene) after every step, pressed (Pz at the full depth), drag (mean, low and high of Pz while it
--- slides), dPx, dPz ({ raw, detrended } over the steps first to last; empty when the run ended before), first_failure
--- ({ step, reason } of the first attempt that failed).
function study.solve(problem, case)
  local model, die, slab = problem.scene(case)
  local began = os.clock()
  case.run = model:run({
    { name = "press", steps = case.press, grip = { 0, -problem.depth } },
    { name = "slide", steps = case.slide, grip = { problem.distance, -problem.depth } },
  }, sg.plain{
    linear = case.linear, step = { adaptive = true },
    newton = { line_search = case.line_search, tolerance = case.tolerance },
    on_step = case.on_step and function(info) return case.on_step(model, info) end })
  case.user = os.clock() - began
  case.dofs = { die = die:dofs().total, slab = slab:dofs().total }
  case.dofs.total = case.dofs.die + case.dofs.slab
  measure(problem, case)
  return case
end

--- Keeps the states at the ends of both stages and in the middle of the slide: a function for on_step, and the list of
--- pictures. `tool`: the body that is driven.
function study.record_states(case, tool)
  local pictures, titles = {}, {
    [case.press] = "pressed", [case.press + case.slide // 2] = "middle of the slide",
    [case.press + case.slide] = "the end",
  }
  return function(model, info)
    if titles[info.step] then
      pictures[#pictures + 1] = sg.picture{ model = model, gray = { tool }, field = "von_mises", cut = "-y",
                                            label = "von Mises stress / E", title = titles[info.step] }
    end
  end, pictures
end

return study
