-- The arguments of a step and of a load path, which model:solve_step, model:iterate, model:solve_arc, model:run,
-- sg.robust and sg.plain share: no default is written twice.

local core = require "signorini.core"
local describe = require "signorini.describe"
local joined = require("signorini.lists").joined
local t = require "signorini.types"

local rows = {}

local tolerance = { "tolerance", t.positive, "residual that counts as zero, relative to the forces of the run",
                    default = 1e-10 }
local iterations = { "iterations", t.integer(1, 1000000), "most iterations in one step", default = 25 }
local linear = { "linear", t.choice(core.linear_solvers), [[linear solver. "klu", "umfpack": direct; "kept": an old
factorization preconditions GMRES where a new one is expensive; "condensed": linear elastic bodies, whose unknowns away
from contact are eliminated once; "auto" chooses]], default = "auto" }

local loop = {
  tolerance, iterations,
  { "line_search", t.choice { "none", "residual", "energy" }, [[how Newton's moves are shortened; "residual" is
non-monotone]], default = "none" },
  { "freeze_active_set", t.switch(t.range(0, 1), 0.01), [[the states of contact points stay as they were until |f·Δu|
has fallen to this part of its first value; true is 0.01]], default = false },
  { "active_set_changes", t.integer(0, 1000000), [[a point that changes its state more often in a step is held, one that
slips as sticking, until the others have converged; 0: never]], default = 0 },
}

local augmented = { "augmented", t.switch(t.named {
  { "penetration", t.share, "largest penetration, as a part of the largest body's size", default = 1e-6 },
  { "loops", t.integer(1, 1000000), "most augmentations in a step", default = 100 },
}, {}), "pressures are augmented until no point in contact is farther from the master, on either side",
  default = false }

local damping = { "damping", t.flag, [[damps bodies that only contact holds; the state that it leads to is in
equilibrium]], default = false }
local pseudo_transient = { "pseudo_transient", t.flag, [[bodies move as in a viscous medium until they rest
(pseudo-transient continuation), in up to 40 times as many iterations, past a loss of stability to the equilibrium
behind it; without line_search]], default = false }

local predictors = t.choice { "tangent", "constant", "linear" }
local first_guess = [[first guess of a step; "linear" goes on as the last step went]]

local function conflict_of_moves(newton, values)
  if values.pseudo_transient and newton.line_search ~= "none" then
    return "pseudo_transient finds the length of its moves by itself: take line_search out"
  end
end

--- Of model:solve_step.
rows.step = joined(loop, { { "predictor", predictors, first_guess, default = "tangent" }, linear, augmented,
                                 damping, pseudo_transient })
rows.step.conflict = function(values) return conflict_of_moves(values, values) end

--- Of model:solve_arc.
rows.arc = {
  { "length", t.positive, "distance from the accepted state, root mean square of the displacement over all bodies",
    unit = "length" },
  tolerance, iterations, linear,
}

-- ── Load paths ───────────────────────────────────────────────────────────────────────────────────────────────────────

--- What steps are solved with unless options say otherwise: `robust`, and `plain` where arcs follow the path, since cut
--- steps and fallbacks may leave it.
rows.robust = { predictor = "linear", rescue = true, step = { adaptive = true } }
rows.plain = { predictor = "tangent", rescue = false, step = { adaptive = false } }

--- A row whose default depends on arc_length, which stands before it.
local function control(key, type, text)
  local robust, plain = rows.robust[key], rows.plain[key]
  local function written(value)
    return type.kind == "named" and ("{ adaptive = %s }"):format(value.adaptive) or describe.literal(value)
  end
  return { key, type, text, otherwise = ("%s, next to arc_length = true %s"):format(written(robust), written(plain)),
           derived = function(values) return (values.arc_length and rows.plain or rows.robust)[key] end }
end

local shortest = 1 / 64 -- increment
local cutting = {
  { "adaptive", t.flag, "false takes each step as a whole", default = true },
  { "max", t.share, "largest increment, a part of the step", default = 1 },
  { "min", t.share, "smallest increment, a part of the step", otherwise = "1/64, at most max",
    derived = function(values) return math.min(values.max, shortest) end },
  { "growth", t.range(1), "factor after an easy increment, which took half of the iterations allowed", default = 2 },
}
cutting.conflict = function(values, given)
  for _, key in ipairs { "min", "max", "growth" } do
    if not values.adaptive and given[key] ~= nil then
      return ("%s has no effect with adaptive = false, which takes each step at once: take one of the two out")
        :format(key)
    end
  end
  if values.min > values.max then
    return ("min must be at most max, got %g with max = %g"):format(values.min, values.max)
  end
end

local file = { "file", t.text, "the checkpoint's file" }

--- The options of model:run.
rows.run = {
  { "arc_length", t.flag, [[where a step fails, arc-length continuation follows the path, also back, until the step's
end is passed; rows between steps have a fractional step, run.controls says where control changed]], default = false },
  control("step", t.named(cutting), [[a step that fails is cut in half; increments are counted (run.cutbacks, run:column
"increments", run:attempts(step)), rows of a run are the steps]]),
  control("rescue", t.flag, [[a step that fails is tried again with fallbacks: with the tangent's predictor and, where
the tangent is singular because contact alone holds a body, with damping; then, where it cannot be cut any more, with
damping, a line search, pseudo-transient continuation, a frozen active set. run.fallbacks counts those that helped;
run.warnings names steps carried by fallbacks that may lead to another branch of solutions]]),
  control("predictor", predictors, first_guess),
  { "newton", t.named(loop), "Newton's method in each attempt", default = {} },
  linear, augmented, damping, pseudo_transient,
  { "penalty", t.named {
    { "start", t.share, "factor of all penalties at the beginning" },
    { "steps", t.count, "steps until it is 1" },
  }, "penalties that grow along the path", optional = true },
  { "threads", t.integer(1, core.most_threads), "threads of this run and later ones; bits are the same for any number",
    otherwise = "what --threads says" },
  { "checkpoint", t.short({
    file,
    { "every", t.count, "steps between two saves; the end is always saved", default = 1 },
    { "durable", t.flag, "waits for the disk at every save, not once a second", default = false },
  }, file), [[saves the model together with how the run stands, so that a process that is killed leaves the file of the
last such step]], optional = true },
  { "resume", t.flag, [[goes on from the checkpoint's file where there is one, with the same bits as a run that saves at
the same steps and that nothing has disturbed; from one without checkpoints it differs by rounding. The file of a
finished run gives that run at once. Scene and stages must be the same]], default = false },
  { "states", t.worded(t.either(t.integer(2), t.list(t.integer(0)), t.callback),
    "a number of states from 2, a list of steps, or a function"), [[which states run:states() keeps: so many from the
start to the end, those of these steps (0 is the start), or those for which function(info) returns true; a run that is
resumed has those since then]], otherwise = "the start and the end of each stage" },
  { "on_step", t.callback, [[function(info), called after each step with info.step, info.stage, info["grip.fx"] …;
returns nothing, "stop" to end cleanly, "cut" to have the step done again in halves, or a table of numbers: columns of
the run, elsewhere nan]], optional = true },
  { "on_iteration", t.callback, [[function(info), called after each iteration with stage, step, from, to (parts of the
step), iteration, residual, energy, reason; returns nothing, "stop", or "cut" to give the attempt up]],
    optional = true },
}
rows.run.conflict = function(values)
  if values.augmented and values.arc_length then
    return "augmented and arc_length cannot be used together: take one of the two out"
  end
  if values.resume and not values.checkpoint then
    return "resume = true needs the file to take up from: add checkpoint = \"run.sgn\""
  end
  return conflict_of_moves(values.newton, values)
end

return rows
