-- Pages: models, load paths and their runs.

local rows = require "signorini.pages.step_rows"
local t = require "signorini.types"

--- The cure where the stages are not a list of them: options or parts of a stage that stand among the stages, where
--- they would be without effect.
local function cure_of_stages(value)
  for key in next, type(value) == "table" and value or {} do
    if math.type(key) ~= "integer" or key < 1 or key > #value then
      for _, row in ipairs(rows.run) do
        if row[1] == key then return ("options are the second argument, model:run({ … }, { %s = … })"):format(key) end
      end
      if type(key) ~= "string" then return "stages are counted from 1 without gaps" end
      return ("put '%s' into a stage, model:run({ { steps = 10, %s = … }, … }, { … }): a list, then the options")
        :format(key, key == "steps" and "<support>" or key)
    end
  end
  return "write model:run{ { steps = 10, grip = {0, -1} } }"
end

local stages = t.worded(t.list(t.named("stage", t.any), nil, 1), "a list of stages")
stages.cure = cure_of_stages
stages.of.names = function(model) return model:driven_names() end

local a_step = { "step", t.count, "number of the step; a step that was not reached follows the last row" }

return {
  title = "Models and load paths",
  word = "solving",
  { "model", [[A scene with its accepted state and the present one, made by sg.model; print(model) shows its size and
its parts, their positions and the contacts that touch; tostring(model) its size. model:run takes it along a load path;
help "results" and help "methods" list the other methods.]] },
  { "model:warnings", [[Returns a list of sentences on what is probably unintended. About the scene, which sg.model
prints as well: bodies that overlap before the first step by more than 1 % of the thickness of the thinner one,
Poisson's ratios that lock, mu above 3, penalties above 1e8 times the stiffness of an element, contacts that act twice.
About the present state: linear elastic bodies that are turned inside out. run.warnings begins with them.]],
    example = "model:warnings()  --> {}" },
  { "model:run", "Takes a model along its load path and returns a run.",
    arguments = { { "stages", stages, "pieces of the load path" },
                  { "options", t.named(rows.run), "controls, records and files of the run", default = {} } },
    rows = rows.run,
    more = [[
A step that is not reached ends the run, a result: run.failed, run.reason, run.cause (what was behind minimum_step),
run.report (in words, with the worst places and what may help), run.places (for sg.picture's marks); the last accepted
state is kept. Reasons: completed, stopped, interrupted, cut, iterations, diverged, cycling, lost_projection, inverted,
singular, indefinite, nan, line_search, penetration, turning_point, minimum_step, strayed.
run:column "grip.fx" is a list over the steps; print(run) is a short table; run:csv(file) writes all columns: step,
increments, iterations, wall; <support>.fx, .fy, in 3D .fz, .moment where it rotates, .ux, .uy, .uz, .angle where
driven; <load>.fx …, .tx … or .pressure; <contact>.fx …, .area, .max_pressure, .max_penetration.
Source: Newton's steps (4.33) to (4.35), freeze_active_set 4.5.2 of V. Agrawal, thesis, IIT Guwahati, 2020; augmented:
J. C. Simo, T. A. Laursen, Comput. Struct. 42 (1992); arc_length: E. Riks, J. Appl. Mech. 39 (1972), H. B. Keller,
1977.]],
    example = "model:run{ { name = \"press\", steps = 46, grip = {0, -0.23} } }" },
  { "stage", "A piece of the load path: leads in equal steps to the values at its end.",
    head = "model:run{ { name, steps, <support or load> = {…} }, … }: stages, a list",
    named = {
      { "name", t.text, "name in reports and on_step", otherwise = '"stage 1" and so on' },
      { "steps", t.count, "number of steps" },
    },
    more = [[
Any other key is the name of a driven support or a load: the values at the stage's end, in the order of its driven
components (lengths, then the angle in degrees) or of the traction; a single one needs no braces. What a stage does not
name stays where it is. Values count from the reference state, not from the stage before. model:driven(name) lists the
components. Options are the second argument, model:run({ … }, { step = { min = 1/256 } }): help "model:run".]],
    example = [[
model:run{ { name = "press", steps = 46,  grip = {0, -0.23} },
           { name = "slide", steps = 250, grip = {1.5, -0.23} } }]] },
  { "sg.robust", [[Returns the default controls of model:run, written out: each step starts from the linear predictor
(predictor = "linear"), a step that fails is tried again with other controls (rescue = true), then cut in half (step = {
adaptive = true }). Given options replace these. Next to arc_length = true these controls act before arc length does,
and may leave the path that it would follow.]], named = "model:run", may_be_empty = true, as_given = true,
    example = "model:run(stages, sg.robust{ arc_length = true, step = { adaptive = true, min = 1/256 } })" },
  { "sg.plain", [[Returns options of model:run for plain Newton iterations: each step is solved once, as a whole, from
the last accepted state (predictor = "tangent", rescue = false, step = { adaptive = false }). Given options replace
these. Use it to compare with other programs or published iteration counts, and to see where Newton's method fails.]],
    named = "model:run", may_be_empty = true, as_given = true,
    example = "model:run(stages, sg.plain{ newton = { iterations = 50 } })" },
  { "run", "The result of model:run; print(run) shows a short table, with unusual controls, fallbacks and cuts.",
    fields = {
      { "failed", t.flag, "whether a step was not reached" },
      { "reason", t.text, "why the run ended, see help \"model:run\"" },
      { "cause", t.text, "reason behind \"minimum_step\", of a run that failed" },
      { "report", t.text, "the failure in words, of a run that failed" },
      { "places", t.list(t.any), "worst places, for sg.picture's marks" },
      { "steps", t.integer(0), "steps that were reached" },
      { "iterations", t.integer(0), "Newton iterations" },
      { "cutbacks", t.integer(0), "attempts that were cut in half" },
      { "rescues", t.integer(0), "steps that fallbacks have carried" },
      { "fallbacks", t.map(t.integer(0)), "how often each fallback helped" },
      { "wall", t.number, "wall time", unit = "s" },
      { "timings", t.map(t.number), "bulk, contact, linear, rest", unit = "s" },
      { "stages", t.list(t.any), "accounts of the stages" },
      { "controls", t.list(t.any), "where arc length took over" },
      { "warnings", t.list(t.text), [[model:warnings(); loads that act in full from the first step, a newton.tolerance
above 1e-3, contacts that never touched, were penetrated by more than 2 % of the smallest body's size, whose closest
points were not found, or whose points have gone through the master in one step; fallbacks that may have changed to
another branch of solutions, steps that probably have, as displacements and released energy show; stages in which more
than a tenth of the work is missing from the energy balance]] },
    } },
  { "run:columns", "Returns the names of all columns, in order.",
    example = "for _, name in ipairs(run:columns()) do print(name) end" },
  { "run:column", [[Returns the values of a column, one per step that was reached: "step", the "increments" it was made
of, "iterations" and "wall" (s) with those of failed attempts, "<support>.fx" (reaction), "<support>.ux" (where a driven
component stands), "<contact>.area" and so on; those that on_step returns are nan where it returned none.]],
    arguments = { { "name", t.name(function(run) return run:columns() end), "a column" } },
    example = "run:column \"grip.fy\"" },
  { "run:attempts", [[Returns the attempts at a step that was reached or missed: a list of { from, to, converged,
reason, iterations, residuals, rescue, again }, where from and to are parts of the step, and again says that it began at
the step's start although a part was accepted.]],
    arguments = { a_step },
    example = "run:attempts(1)[1].iterations" },
  { "run:residuals", "Returns the residual norms of the iterations of a step's last attempt.",
    arguments = { a_step },
    example = "run:residuals(run.steps)" },
  { "run:states", [[Returns the states that a run has kept, in order, for sg.picture{ states = run:states() }: those
that the option `states` of model:run asked for; without it the start, the end of each stage and the last one that was
reached.]],
    example = "sg.picture{ states = run:states(), field = \"uy\", file = \"states.png\" }" },
  { "run:csv", "Writes all columns to a CSV file; a figure that on_step did not return is left out.",
    arguments = { { "file", t.text, "name of the file" } },
    example = "run:csv \"run.csv\"" },
  { "state", "An entry of run:states().",
    fields = { { "step", t.integer(0), "number of the step; 0 is the start" },
               { "stage", t.text, "name of the stage" },
               { "title", t.text, "of a picture" },
               { "snapshot", t.object "snapshot", "the state, to which model:restore(state.snapshot) returns" } },
    example = "local states = run:states(); print(states[#states].title)" },
  { "model:cost", [[Returns the size of a model in numbers, before a solve or after it; print(model:cost()) shows
tables.]],
    fields = {
      { "unknowns", t.integer(0), "size of the linear system" },
      { "obstacles", t.integer(0), "rigid obstacles, which have no unknowns" },
      { "bodies", t.map(t.named {
        { "unknowns", t.integer(0), "those of the body" },
        { "contact_layer", t.integer(0), "unknowns on the faces that `contact` names" },
        { "bulk", t.integer(0), "all other unknowns" },
        { "prescribed", t.integer(0), "degrees of freedom that supports fix or drive" },
        { "elements", t.integer(0), "elements" },
        { "gauss_points", t.integer(0), "Gauss points" },
      }), "bodies by name" },
      { "contacts", t.map(t.named {
        { "points", t.integer(0), "contact points" },
        { "rigid", t.flag, "whether the master is an obstacle" },
      }), "contacts by name" },
      { "nonzeros", t.integer(0), "nonzeros of the tangent; they grow where contacts touch" },
      { "memory", t.number, "sum of memory_of", unit = "bytes" },
      { "memory_of", t.map(t.number), [[bodies (tables of Gauss points), contacts (points with their history), tangent
(with its patterns), factors]], unit = "bytes" },
      { "linear", t.text, "solver of the factors" },
      { "factors_are", t.choice { "measured", "counted" }, [["measured" after a factorization, before that "counted":
from the pattern in the order of nested dissection]] },
    },
    example = "print(model:cost())" },
  { "model:save", [[Writes the model with its accepted state to a file for sg.load, whole or not at all. From here on
the model and one that is loaded give the same bits; for that the model drops factorizations and patterns, so that the
next step takes a little longer. An error while a step, targets or penalties are not accepted.]],
    arguments = { { "path", t.text, "the checkpoint's file" } },
    example = "model:save \"pressed.sgn\"" },
  { "sg.load", [[Returns the model that model:save(path), or a run with checkpoints, has saved: bodies, supports, loads,
contacts, and the accepted state with its contact history. It needs nothing of the script that made it, and goes on with
the same bits as the model that was saved.]],
    arguments = { { "path", t.text, "the checkpoint's file" } },
    example = "model = sg.load \"pressed.sgn\"" },
}
