-- Pages: models, load paths and their runs.

local contact_change = require("signorini.pages.contact_rows").change
local rows = require "signorini.pages.step_rows"
local t = require "signorini.call.types"

--- The hint for an option among the stages.
local function cure_of_option(key)
  for _, row in ipairs(rows.run) do
    if row[1] == key then return ("options are the second argument, model:run({ … }, { %s = … })"):format(key) end
  end
end

--- The hint for a table without steps, a stage of which each key is an option.
local function cure_of_options(stage)
  local cure
  for key in next, rawget(stage, "steps") == nil and stage or {} do
    cure = cure_of_option(key)
    if not cure then return nil end
  end
  return cure
end

--- The hint if the stages are not a list: options or parts of a stage among the stages have no effect.
local function cure_of_stages(value)
  for key in next, type(value) == "table" and value or {} do
    if math.type(key) ~= "integer" or key < 1 or key > #value then
      local cure = cure_of_option(key)
      if cure then return cure end
      if type(key) ~= "string" then return "stages are counted from 1 without gaps" end
      return ("put '%s' into a stage, model:run({ { steps = 10, %s = … }, … }, { … }): a list, then the options")
        :format(key, key == "steps" and "<support>" or key)
    end
  end
  return "write model:run{ { steps = 10, grip = {0, -1} } }"
end

local stages = t.worded(t.list(t.named("stage", t.any), nil, 1), "a list of stages")
stages.cure = cure_of_stages
stages.of.cures = { table = cure_of_options }
stages.of.names = function(model) return model:driven_names() end

local a_step = { "step", t.count, "number of the step; a failed step follows the last row" }

return {
  title = "Models and load paths", word = "solving",
  { "model", [[A scene with its accepted and its current state, made by sg.model; print(model) shows its size and its
parts, their positions and the contacts that touch; tostring(model) shows its size. model:run solves it along a load
path; help "results" and help "methods" list the other methods.]] },
  { "model:warnings", [[Returns a list of sentences on what is probably unintended. About the scene (sg.model prints
these, too): overlaps before the first step whose closing strains a body by more than 0.1 %, and those of bodies that
are in contact with themselves (among), parts of a body at a distance that are tied, functions of loads whose resultant
Gauss points miss by 1 %, Poisson's ratios that lock, mu above 3, penalties above 1e8 times the stiffness of an element,
fewer contact points per element than the degree of the face, weights so different that Gauss points miss a body's
volume by 1 %, loads on faces whose area they miss by as much, contacts that act twice. run.warnings starts with
these.]],
    returns = t.list(t.text), example = "model:warnings()  --> {}" },
  { "model:run", [[Solves a model along its load path and returns a run. A further run continues from the
model's state; its steps are counted from 1 again.]],
    arguments = { { "stages", stages, "parts of the load path" },
                  { "options", t.named(rows.run), "controls, records and files of the run", default = {} } },
    rows = rows.run,
    more = [[
A failed step ends the run; this is a result, not an error: run.failed, run.reason, run.cause (the reason behind
minimum_step), run.failure (in words, with the worst places and what may help), run.places (for sg.picture's marks). The
model keeps the last accepted state. Reasons:
  completed        all steps converged
  stopped          on_step or on_iteration returned "stop"
  interrupted      Ctrl-C
  cut              on_step returned "cut", and increments cannot be shorter
  minimum_step     an increment of the smallest size failed; run.cause is the reason
  iterations       no convergence within newton.iterations
  diverged         the residual grew beyond 1e12 times the forces of the run
  cycling          no convergence within newton.iterations, and contact points still change their states
  lost_projection  contact points alternately find and lose their closest point at an edge of the master
  crossed          points passed through the master without contact: bodies moved too far in one increment, or jumped
  inverted         an element is turned inside out (J ≤ 0)
  singular         the tangent is singular: an unconstrained body, or a turning point
  indefinite       no convergence, and the tangent has negative eigenvalues: beyond a turning point
  friction_exhausted  the loads on a body that one contact alone holds exceed its friction
  nan              the residual is not a finite number
  line_search      no step length reduces the residual
  turning_point    the prescribed quantity cannot increase further on this path: see arc_length
  left_path        an arc-length increment converged on another part of the path
run:column "grip.fx" is a list over the steps; print(run) is a short table; run:csv(file) writes all columns: step,
increments, iterations, wall; <support>.fx, .fy, in 3D .fz, .moment if it rotates, .ux, .uy, .uz, .angle if driven, or
free of an obstacle; <load>.fx …, .tx …, .pressure, .bx …, .px …, .moment or .factor; <contact>.fx … (force on the
slave), .area, .max_pressure, .max_penetration, with friction .slip (mean over the area of points that touch), of
cohesive contacts .debonded.
Source: Newton's steps (4.33) to (4.35), freeze_active_set 4.5.2 of V. Agrawal, thesis, IIT Guwahati, 2020;
arc_length: E. Riks, J. Appl. Mech. 39 (1972), H. B.
Keller, in Applications of Bifurcation Theory, Academic Press, 1977.]],
    returns = t.object "run", example = "model:run{ { name = \"press\", steps = 46, grip = {0, -0.23} } }" },
  { "stage", "A part of the load path: leads in equal steps to the values at its end.",
    head = "model:run{ { name, steps, <support or load> = {…} }, … }: stages, a list",
    named = {
      { "name", t.text, "name in reports and on_step", otherwise = '"stage 1" and so on' },
      { "steps", t.count, "number of steps" },
      { "duration", t.either(t.positive, t.choice { "relaxed" }), [[length of the stage in time. Viscoelastic
materials flow only in stages with a duration, others are infinitely fast; friction that depends on the slip rate needs
it; nothing else depends on time. "relaxed": as long as it takes until nothing flows any more; the clock stays]],
        unit = "time", optional = true },
      { "growth", t.positive, [[how much longer each step is than the one before, in time and in what
it changes: 1.5 for relaxation over decades of time]], default = 1 },
      { "contacts", t.map(t.named(contact_change)), [[constants of contacts that change, by
name: { active, penalty, friction, offset }. They act in full from the first step of the stage, except for offset, which
changes linearly over the stage; all hold until another stage changes them, also in further runs]], optional = true },
    },
    rest = t.any,
    more = [[
Any other key is the name of a driven support or a load: the values at the stage's end, in the order of its driven
components (lengths, then the angle in degrees) or of the load; a single value needs no braces. A function of the
fraction s of the stage, from 0 to 1, returns these values; all functions are called when the run starts, for the end of
each step, within which the path is linear, and for s = 0, where a value other than that before the stage is a warning.
Supports and loads that a stage does not name keep their values. Values are measured from the reference state, not from
the previous stage.
The first stage in which a contact with overlap = "interference" is active also closes this overlap, linearly.
A contact that is pressed without friction and turned with it, with friction = { mu = 0, penalty = 100 } in sg.model:
  model:run{ { name = "press", steps = 10, grip = {-1, 0} },
             { name = "turn", steps = 90, grip = {-1, 180}, contacts = { joint = { friction = { mu = 0.5 } } } } }
model:driven(name) lists the components. Options are the second argument, model:run({ … }, { step = { min = 1/256 } }):
help "model:run".]],
    example = [[
model:run{ { name = "press", steps = 46,  grip = {0, -0.23} },
           { name = "slide", steps = 250, grip = {1.5, -0.23} } }
model:run{ { name = "rub", steps = 8,
             grip = function(s) return {1.5 + 0.1 * math.sin(2 * math.pi * s), -0.23} end } }]] },
  { "sg.robust", [[Returns the default controls of model:run explicitly: each step starts from the state that the
last two steps extrapolate to (predictor = "quadratic"), a failed step is tried again with the first fallbacks
(fallback = true), then cut in half (step = { adaptive = true }), and at the smallest increment tried with the other
fallbacks. Given options replace these.
Use it to keep these controls with arc_length = true, which otherwise switches them off: they are then tried before arc
length, and may leave the path that arc length would follow.]], named = "model:run", may_be_empty = true, as_given =
true,
    returns = t.named "model:run",
    example = "model:run(stages, sg.robust{ arc_length = true, step = { adaptive = true, min = 1/256 } })" },
  { "sg.plain", [[Returns options of model:run for plain Newton iterations: each step is solved once, as a whole, from
the last accepted state (predictor = "tangent", fallback = false, step = { adaptive = false }). Given options replace
these. Use it to compare with other programs or published iteration counts, and to find where Newton's method fails.]],
    named = "model:run", may_be_empty = true, as_given = true,
    returns = t.named "model:run", example = "model:run(stages, sg.plain{ newton = { iterations = 50 } })" },
  { "run", [[The result of model:run; print(run) shows a short table, with fallbacks, cuts and other controls. Methods:
run:column, run:columns, run:error, run:budget, run:csv, run:hdf5, run:states, run:attempts, run:residuals.]],
    fields = {
      { "failed", t.flag, "whether a step failed" },
      { "reason", t.text, "reason why the run ended, see help \"model:run\"" },
      { "cause", t.text, "reason behind \"minimum_step\", of a run that failed" },
      { "failure", t.text, "the failure in words, of a run that failed" },
      { "places", t.list(t.any), "worst places of a failure, { x, X, text, … }, for sg.picture's marks" },
      { "steps", t.integer(0), "converged steps; with arc_length = true columns may have further rows between them" },
      { "iterations", t.integer(0), "Newton iterations, also of failed attempts" },
      { "cutbacks", t.integer(0), "increments cut in half" },
      { "fallback_steps", t.integer(0), "steps solved by fallbacks" },
      { "adaptations", t.list(t.any), [[where layers have followed the contact (adapt): { step (the last one before it),
unknowns, elements (by line "slab.north.1": body, face, direction), energy_before, energy_after (of bodies and
contacts), wall } each]] },
      { "fallbacks", t.map(t.integer(0)), "successes of each fallback" },
      { "wall", t.number, "wall time", unit = "s" },
      { "timings", t.map(t.number), "bulk, contact, linear, rest", unit = "s" },
      { "stages", t.list(t.any), "{ name, steps, iterations, cutbacks, wall } of each stage" },
      { "controls", t.list(t.any), "where arc length began or ended: { step, to, place, reason } each" },
      { "settings", t.map(t.any), [[with tolerance what was chosen, as factors of what was given: elements (per
direction), row (true: one level richer at the contact), penalty, steps, points; reached, missed (why not), text, and
levels, the settings that were solved: { settings, part (error over tolerance), unknowns, wall } each]] },
      { "warnings", t.list(t.text), [[those of model:warnings(), and about: loads that act in full from the first step;
newton.tolerance above 1e-3; contacts that never touched; a last step whose position damping alone determines; bodies
that contacts without friction do not hold; loads or contact whose forces are not far above rounding errors; closest
points that were not found; at the end of a stage states in unstable equilibrium (of the states between that were stored
the first one), contacts too narrow for the mesh, more than 1 % of a contact's force beyond an end of the master,
penetration or elastic slip above 5 % of the approach of the faces, mortar contact at whose points gaps are above 10 %
of it where their means are closed, faces that overlap although adhesion holds them apart, linear elastic bodies that
are turned by 10 degrees or strained by 5 % in the mean over an element, bodies that bend with elements of degree 1,
bodies that pass through each other, through themselves or through obstacles where no contact is defined, or pass
between contact points; steps that may have jumped to another branch of solutions (solved by certain fallbacks) or
probably have (judged by displacements and released energy); stages whose energy balance lacks more than a tenth of the
work]] },
    } },
  { "run:columns", "Returns the names of all columns, in order.",
    returns = t.list(t.text), example = "for _, name in ipairs(run:columns()) do print(name) end" },
  { "run:column", [[Returns the values of a column, one per converged step, with arc_length = true also for
increments between steps, so that the last value is column[#column]: "step", its "increments", "iterations" and
"wall" (s) including failed attempts, "<support>.fx" (reaction), "<support>.ux" (value of a driven component),
"<contact>.area" and so on; columns that on_step returns are nan where it returned none.]],
    arguments = { { "name", t.name(function(run) return run:columns() end), "a column" } },
    returns = t.numbers(nil, true), example = "run:column \"grip.fy\"" },
  { "run:error", [[Returns the error bars of a result of a run with the option errors, one per converged step: half of
the range in which the solution of the model is expected; laws, data and idealization are not included. nan where a
companion has failed, or where there is no limit, as of the peak pressure at a sharp edge. They are also the column
"grip.fy.error" of "grip.fy", in files, too.]],
    arguments = { { "name", t.name(function(run) return run:columns() end), "a column of results" } },
    returns = t.numbers(nil, true),
    example = { "run = model:run(stages, { errors = true })\nrun:error \"grip.fy\"", [[
run = model:run(stages, { errors = "mesh" })
sg.chart{ { x = run:column "step", y = run:column "grip.fy", error = run:error "grip.fy" } }]] } },
  { "run:budget", [[Returns where the error of a result comes from: value, error, and its terms in the same unit: bulk
and row (the mesh, without and at the contact; without a richer row all of it is in bulk), points, penalty, steps,
newton; terms that are unknown or were not asked for are nil. why: in words, why a bar is missing or doubtful.
to_halve_it: the cheapest known change that halves the error.]],
    arguments = { { "name", t.name(function(run) return run:columns() end), "a column of results" },
                  { "step", t.count, "row of the run", otherwise = "the last one" } },
    returns = t.record("value error", { kind = "number", gaps = true },
      "bulk? row? points? penalty? steps? newton?", t.number, "why? to_halve_it?", t.text),
    example = "run = model:run(stages, { errors = true })\nprint(run:budget(\"grip.fy\").penalty)" },
  { "run:attempts", [[Returns the attempts at a converged or failed step: a list of { from, to, converged, reason,
iterations, residuals, fallback, restarted }, where from and to are fractions of the step, and restarted tells whether
the attempt started at the step's start although a part was accepted.]],
    arguments = { a_step },
    returns = t.list(t.record("from to", t.number, "converged", t.flag, "reason", t.text, "iterations", t.integer(0),
      "residuals", t.numbers(nil, true), "fallback?", t.text, "restarted?", t.flag)),
    example = "run:attempts(1)[1].iterations" },
  { "run:residuals", "Returns the residual norms of the iterations of a step's last attempt.",
    arguments = { a_step },
    returns = t.numbers(nil, true), example = "run:residuals(run.steps)" },
  { "run:states", [[Returns the states that a run has stored, in order, for sg.picture{ states = run:states() }: those
selected by the option `states` of model:run; by default the start, the end of each stage and the last accepted one.]],
    returns = t.list(t.object "state"),
    example = "sg.picture{ states = run:states(), field = \"uy\", file = \"states.png\" }" },
  { "run:csv", "Writes all columns to a CSV file; a value that on_step did not return is an empty field.",
    arguments = { { "file", t.text, "name of the file" } },
    example = "run:csv \"run.csv\"" },
  { "run:hdf5", [[Writes a run to a file of HDF5 for Python (h5py), Julia, MATLAB and other programs: all columns;
displacements, contact profiles and energies of the states that the run has stored; geometry and basis of the bodies;
outcome, warnings, script and versions. The option hdf5 of model:run writes the same as the run goes, with the profiles
and energies of all steps. Contents: share/doc/use/results.md.]],
    arguments = { { "file", t.text, "name of the file; an existing one is replaced" },
                  { "options", t.options(rows.hdf5), "" } },
    example = { "run:hdf5 \"run.h5\"", "run:hdf5(\"run.h5\", { units = { length = \"mm\", force = \"N\" } })" } },
  { "state", "An entry of run:states().",
    fields = { { "step", t.integer(0), "number of the step; 0 is the start" },
               { "stage", t.text, "name of the stage" },
               { "title", t.text, "of a picture" },
               { "snapshot", t.object "snapshot", "the state, for model:restore(state.snapshot)" } },
    example = "local states = run:states(); print(states[#states].title)" },
  { "model:cost", [[Returns the size of a model in numbers, before a solve or after it; print(model:cost()) shows
tables.]],
    fields = {
      { "unknowns", t.integer(0), "size of the linear system" },
      { "obstacles", t.integer(0), "rigid obstacles (without unknowns)" },
      { "bodies", t.map(t.named {
        { "unknowns", t.integer(0), "those of the body" },
        { "interface", t.integer(0), "unknowns of the control points on contact faces" },
        { "bulk", t.integer(0), "all other unknowns" },
        { "prescribed", t.integer(0), "degrees of freedom that supports fix or drive" },
        { "elements", t.integer(0), "elements" },
        { "gauss_points", t.integer(0), "Gauss points" },
      }), "bodies by name" },
      { "contacts", t.map(t.named {
        { "points", t.integer(0), "contact points" },
        { "rigid", t.flag, "whether the master is an obstacle" },
      }), "contacts by name" },
      { "nonzeros", t.integer(0), "nonzeros of the tangent, which increase when contacts touch" },
      { "memory", t.number, "sum of memory_of", unit = "bytes" },
      { "memory_of", t.map(t.number), [[bodies (tables of Gauss points), contacts (points with their history), tangent
(with its patterns), factors]], unit = "bytes" },
      { "linear", t.text, "linear solver" },
      { "factors_are", t.choice { "measured", "counted" }, [["measured" after a factorization; before that "counted"
from the pattern in nested-dissection order]] },
    },
    example = "print(model:cost())" },
  { "model:save", [[Writes the model with its accepted state to a file for sg.load, atomically. From here on the model
and a loaded copy give bitwise identical results; for this the model discards factorizations and patterns, so that the
next step takes slightly longer. It is an error if a step, targets or penalties are not accepted yet.]],
    arguments = { { "path", t.text, "the checkpoint's file" } },
    example = "model:save \"pressed.sgn\"" },
  { "sg.load", [[Returns the model that model:save(path), or a run with checkpoints, has saved: bodies, supports, loads,
contacts, and the accepted state with its contact history. It does not need the script that made it, and its results are
bitwise identical to those of the saved model.]],
    arguments = { { "path", t.text, "the checkpoint's file" } },
    returns = t.object "model", example = "model = sg.load \"pressed.sgn\"" },
}
