-- The arguments of a step and of a load path, which model:solve_step, model:iterate, model:solve_arc, model:run,
-- sg.robust and sg.plain share: each default is written once.

local core = require "signorini.core"
local describe = require "signorini.call.describe"
local lists = require "signorini.call.lists"
local t = require "signorini.call.types"

local rows = {}

local tolerance = { "tolerance", t.positive, "residual that counts as zero, relative to reactions and loads",
                    default = 1e-10 }
--- The row of the limit of iterations; `more`: what extends it.
local function iterations(more)
  return { "iterations", t.integer(1, 1000000), "maximum number of iterations per attempt" .. more, default = 25 }
end
local linear = { "linear", t.choice(core.linear_solvers), [[linear solver. "klu", "umfpack": direct; "reuse": a reused
(lagged) factorization preconditions GMRES while that is cheaper than a new one; "condensed": static condensation, for
linear elastic bodies; "mumps": MUMPS, direct, in parallel under mpirun; "auto": automatic choice]], default = "auto" }
local mumps = { "mumps", t.named {
  { "reuse", t.flag, "a factorization preconditions GMRES on later tangents, as with linear = \"reuse\"",
    default = false },
  { "low_rank", t.share, [[tolerance of block low-rank compression, relative to the tangent: approximate factors, with
less memory and operations in large solids, which precondition GMRES]], optional = true },
  { "precision", t.choice { "double", "single" }, "of the factors; single ones precondition GMRES",
    default = "double" },
  { "out_of_core", t.text, "an existing folder in which each process stores its factors; on a local disk",
    optional = true },
}, "options of linear = \"mumps\"", optional = true }

--- The arguments of Newton's method; `default`: that of the line search.
local function loop(default)
  local line_search = { "line_search", t.choice { "none", "residual", "energy" }, [[how Newton corrections are
shortened: by the norm of the residual (non-monotone) or by the energy]] }
  return {
    tolerance, iterations "; four times as many while the set of closed contact points shrinks",
    lists.merged(line_search, default),
    { "freeze_active_set", t.switch(t.range(0, 1), 0.01), [[contact states are frozen until |f·Δu| has decreased to this
fraction of its first value; true is 0.01]], default = false },
    { "active_set_changes", t.integer(0, 1000000), [[a contact point that changes its state more than this number of
times in a step is fixed in it (a slipping one as sticking) until the others have converged; 0: never]], default = 0 },
  }
end

--- Hints for keys that are not options.
local hints = {
  augmentation = 'omit it: contact without penetration has method = "mortar", enforcement = "multipliers"',
  enforcement = "write it in the contact, in sg.model",
}

local damping = { "damping", t.flag, [[damps unconstrained bodies and obstacles until contact holds them; the converged
state is in equilibrium without damping]], default = false }
local pseudo_transient = { "pseudo_transient", t.flag, [[pseudo-transient continuation: follows a damped motion, past a
limit point, to a distant equilibrium, in up to 40 times as many iterations; not with line_search]], default = false }

local predictors = t.choice { "tangent", "constant", "linear", "quadratic" }
local first_guess = [[predictor, the first guess of a step; "linear" extrapolates the last step, "quadratic" the
last two]]

local function conflict_of_solver(values)
  if values.mumps and values.linear ~= "mumps" then
    return ('mumps is for linear = "mumps", got linear = "%s": set linear, or remove mumps'):format(values.linear)
  end
end

local function conflict_of_moves(newton, values)
  if values.pseudo_transient and newton.line_search and newton.line_search ~= "none" then
    return "pseudo_transient controls its own step length: remove line_search"
  end
end

local verbose = { "verbose", t.flag, [[prints each iteration when it ends: the residual, relative to the forces so that
newton.tolerance is its goal; the energy |f·Δu| of the correction; contact points that are active, that slip and that
have changed their state; the linear solver, where it has factored, or iterations of GMRES; a factor on the correction,
the reason of the end]], default = false }

--- model:solve_step.
rows.step = lists.joined(loop { default = "none" }, {
  { "predictor", predictors, first_guess, default = "tangent" }, linear, mumps, damping, pseudo_transient, verbose,
})
rows.step.conflict = function(values) return conflict_of_moves(values, values) or conflict_of_solver(values) end
rows.step.hints = hints

--- model:solve_arc.
rows.arc = {
  { "length", t.positive, "distance from the accepted state, root mean square of the displacement over all bodies",
    unit = "length" },
  tolerance, iterations "", linear, mumps, verbose,
}
rows.arc.conflict = conflict_of_solver

-- ── Load paths ───────────────────────────────────────────────────────────────────────────────────────────────────────

--- Default controls: `robust`, or `plain` with arc length, since cut steps and fallbacks may leave the path.
rows.robust = { predictor = "quadratic", fallback = true, step = { adaptive = true } }
rows.plain = { predictor = "tangent", fallback = false, step = { adaptive = false } }

--- A row whose default depends on arc_length, a previous row.
local function control(key, type, text)
  local robust, plain = rows.robust[key], rows.plain[key]
  local function written(value)
    return type.kind == "named" and ("{ adaptive = %s }"):format(value.adaptive) or describe.literal(value)
  end
  return { key, type, text, otherwise = ("%s, with arc_length = true %s"):format(written(robust), written(plain)),
           derived = function(values) return (values.arc_length and rows.plain or rows.robust)[key] end }
end

local shortest = 1 / 64 -- increment
local increment = t.range(1e-9, 1) -- smaller ones are lost in rounding errors of the step
local cutting = {
  { "adaptive", t.flag, "whether failed steps are cut; false: each step is solved as a whole, also by fallbacks",
    default = true },
  { "max", increment, "largest increment, a fraction of the step", default = 1 },
  { "min", increment, "smallest increment, a fraction of the step", otherwise = "1/64, at most max",
    derived = function(values) return math.min(values.max, shortest) end },
  { "growth", t.range(1), "growth factor after an increment that took at most half of newton.iterations", default = 2 },
}
cutting.conflict = function(values, given)
  for _, key in ipairs { "min", "max", "growth" } do
    if not values.adaptive and given[key] ~= nil then
      return ("%s has no effect with adaptive = false, which solves each step as a whole: remove one of the two")
        :format(key)
    end
  end
  if values.min > values.max then
    return ("min must be at most max, got %g with max = %g"):format(values.min, values.max)
  end
end

local file = { "file", t.text, "the checkpoint's file" }

--- What callbacks return, and what on_step and on_iteration are called with.
local answer = t.choice { "stop", "cut" }
local info = t.record("step", t.number, "stage", t.text, "residual?", t.number)
info.rest = t.number
local iteration = t.record("step", t.count, "stage", t.text, "from to", t.number, "iteration", t.count,
  "residual energy", t.number, "reason", t.text)
--- run:hdf5.
rows.hdf5 = {
  { "units", t.map(t.text), [[units by quantity or by the name of a column, { length = "mm", force = "N" }, for the
attribute `unit` of arrays; quantities: angle, area, count, energy, force, force_per_volume, length,
moment, stress, time]], optional = true },
}

-- The default of newton.line_search; see controls.solver.
local search = '"energy" with fallback = true; otherwise, and with damping, pseudo_transient, adhesion, bonds or '
  .. 'half passes, "none"'

--- The options of model:run.
rows.run = {
  "Most used:",
  verbose,
  { "arc_length", t.flag, [[where a step fails, arc-length continuation follows the path, also past turning points,
until the end of the step is passed; available after the model's first accepted step. Rows between steps have fractional
step numbers, run.controls lists where control changed]], default = false },
  control("step", t.named(cutting), [[step cutting: a failed step is cut in half. A run still has one row per step;
run.cutbacks counts the cuts, run:column "increments" the increments of each step, run:attempts(step) lists all
attempts]]),
  { "errors", t.either(t.flag, t.choice { "mesh" }, t.named {
    { "terms", t.choice { "all", "mesh" }, '"mesh": the error of the mesh alone, from two companions',
      default = "all" },
    { "scene", t.callback_of({ { "q", t.record("mesh", t.number) } }, t.object "model", t.list(t.any), t.or_nil(t.any)),
      [[function(q) that returns the model, its stages and its options (those of the run if it returns none) on another
mesh, with q.mesh times as many elements per direction, 1/2 and 1/4, with tolerance other numbers, too: round the
elements. For scenes whose positions or penalties a script computes from the mesh]],
      otherwise = "the scene made again from the tables of sg.body and sg.model" },
  }), [[estimates the error of all results, by companions: the same path on the scene with elements two and four times
as large, and there with half of the steps, half of the penalties, twice the points and a richer row at the contact;
"mesh" only the first two. They are solved first, each in a process. print(run) then shows the last values with ±, and
where the errors come from; see run:error, run:budget and share/doc/use/errors.md]], default = false },
  { "tolerance", t.worded(t.one_or_more(t.text), 'a text such as "1 % of grip.fx", or a list of these'),
    [[solves the path again on finer meshes, with a richer row at the contact, other penalties, steps and points, until
the error bars of these results are in all steps at most this part of their largest value. The given mesh is the first.
The model becomes that of the last level; run.settings tells what was chosen]], optional = true },
  { "checkpoint", t.short({
    file,
    { "every", t.count, "steps between two saves; the end is always saved", default = 1 },
    { "durable", t.flag, "synchronizes the disk at every save instead of once a second", default = false },
  }, file), [[saves the model and the progress of the run, so that a killed process leaves a file of its last saved
step]], optional = true },
  { "resume", t.flag, [[continues from the checkpoint's file if it exists, with results bitwise identical to an
uninterrupted run that saves at the same steps; a run without checkpoints differs by rounding error. The file of a
finished run returns that run at once. Scene and stages must be the same]], default = false },
  { "states", t.worded(t.either(t.integer(2), t.list(t.integer(0)), t.callback_of({ { "info", info } }, t.any)),
    "a number of states from 2, a list of steps, or a function"), [[states stored for run:states(): this number, evenly
from start to end, those of the listed steps (0 is the start), or those for which function(info) returns true; a resumed
run has those since its resumption]], otherwise = "the start and the end of each stage" },
  { "on_step", t.callback_of({ { "info", info } }, t.or_nil(t.either(answer, t.map(t.number)))),
    [[function(info), called after each step with info.step, info.stage, info["grip.fx"] …;
returns nothing, "stop" to end the run, "cut" to repeat the step in halves, or a table of numbers, which become columns
of the run (nan elsewhere)]], optional = true },
  "Controls of the solution:",
  control("fallback", t.flag, [[a failed step is tried again with fallbacks, one at a time: the tangent predictor;
damping, if an unconstrained body makes the tangent singular. If these fail, the step is cut. When it cannot be cut
further, these are tried: damping, if it was not tried before; a line search; pseudo-transient continuation; a frozen
active set. run.fallbacks counts their
successes; run.warnings names steps solved by fallbacks that may lead to another branch of solutions]]),
  control("predictor", predictors, first_guess),
  { "newton", t.named(loop { otherwise = search }), "Newton's method in each attempt", default = {} },
  damping, pseudo_transient, linear, mumps,
  { "penalty", t.named {
    { "start", t.share, "initial factor of all penalties" },
    { "steps", t.count, "steps until it is 1" },
  }, "increases the penalties along the path", optional = true },
  { "adapt", t.named {
    { "every", t.count, "steps between two looks at the contact", default = 1 },
    { "margin", t.integer(0), [[elements of the face next to those in contact that have the layer, too; ahead of a
moving contact up to twice as many]], default = 1 },
    { "tolerance", t.positive, [[only elements have the layer where the traction of the contact differs by more than
this from that of the body's stress, relative to the largest traction]], optional = true },
  }, [[layers follow the contact: bodies with a layer in their order (N2-N2.2) have it only in the elements of the
contact face that touch, and a margin around them. It grows ahead of the contact and shrinks behind it; run.adaptations
lists the changes]], optional = true },
  { "limit", t.positive, "time after which no further level is begun", unit = "s", otherwise = "none" },
  { "threads", t.integer(1, core.most_threads), "threads of this and later runs; results do not depend on the number",
    otherwise = "the value of --threads" },
  "Records and files:",
  { "measure", t.callback_of({ { "model", t.object "model" } }, t.map(t.number)),
    [[function(model), called after each step; returns a table of numbers by name, which become columns of the run. With
`errors` they have error bars, unlike those of on_step]], optional = true },
  { "hdf5", t.short(lists.joined({
    { "file", t.text, "name of the file" },
    { "every", t.count, [[steps between two writes; with 1 the file has the last accepted step at any moment. It is
written before each save of a checkpoint and at the end, too]],
      otherwise = "as few as take less than 2 % of the run's time" },
    { "states", t.choice { "stored", "all" }, [[steps whose displacements the file has: "stored": those of
run:states()]], default = "stored" },
    { "profiles", t.choice { "stored", "all" }, "steps whose contact profiles and energies the file has",
      default = "all" },
  }, rows.hdf5), { "file", t.text }), [[a file of HDF5 for Python, Julia, MATLAB and others, written as the run goes and
complete at any moment, also after kill -9; with resume = true it is continued. Contents: share/doc/use/results.md]],
    optional = true },
  { "on_iteration", t.callback_of({ { "info", iteration } }, t.or_nil(answer)),
    [[function(info), called after each iteration with stage, step, from, to (parts of the
step), iteration, residual, energy, reason; returns nothing, "stop", or "cut" to abandon the attempt]],
    optional = true },
}
local alone = { "on_step", "on_iteration", "checkpoint", "hdf5", "verbose" }
rows.run.conflict = function(values)
  for _, key in ipairs(values.tolerance and alone or {}) do
    if values[key] then
      return ("%s is for one run, and tolerance solves the path several times: solve it with run.settings again, or "
        .. "remove one of the two"):format(key)
    end
  end
  local errors = values.errors
  if values.tolerance and errors and not (type(errors) == "table" and errors.scene and errors.terms == "all") then
    return "tolerance needs all error bars anyway: remove errors, unless it gives a scene"
  end
  if values.limit and not values.tolerance then return "limit is for tolerance, which is missing: remove it" end
  if (values.errors or values.tolerance) and values.arc_length then
    return "error bars compare runs row by row, and with arc_length rows depend on the path of each: remove one of "
      .. "the two"
  end
  if values.resume and not values.checkpoint then
    return "resume = true needs a checkpoint file: add checkpoint = \"run.sgn\""
  end
  if values.adapt and values.hdf5 then
    return "adapt changes the control points, which a file of HDF5 holds once for all steps: remove adapt or hdf5, and "
      .. "export run:csv or pictures instead"
  end
  return conflict_of_moves(values.newton, values) or conflict_of_solver(values)
end
rows.run.hints = hints

return rows
