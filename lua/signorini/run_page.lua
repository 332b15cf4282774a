-- The help page of model:run, which run.lua reads and does.

return [[
model:run(stages, { step, newton, linear, predictor = "linear", rescue = true, arc_length = false, damping = false,
                    pseudo_transient = false, augmented, penalty, checkpoint, resume = false, states, on_step,
                    on_iteration, threads })
Takes a model along its load path and returns a run.
stages = { { name = , steps = , <support or load> = {…} }, … }: each moves driven supports and loads in equal steps to
the values at its end, a list over the components that are driven (of one alone a number will do); those that are not
named stay where they are.
Options:
  newton = { tolerance = 1e-10, iterations = 25, line_search = "none", freeze_active_set = false,
    active_set_changes = }, linear = "auto", augmented = { penetration = 1e-6, loops = 100 }, damping = false,
    pseudo_transient = false: see help "model:solve_step"; freeze_active_set = true is 0.01.
  predictor = "tangent", "constant" or "linear": the first guess of a step; linear goes on as the last one went.
  rescue: a step that fails is tried again with fallbacks: with the tangent's predictor, and, where the tangent is
    singular because contact alone holds a body, with damping; then, where it cannot be cut any more, with damping, a
    line search, pseudo-transient continuation, a frozen active set. run.fallbacks counts what helped,
    run:attempts(step) tells; rescue = false tries nothing. run.warnings names steps carried by fallbacks that may lead
    to another branch of solutions. sg.plain{} turns predictor, rescue and step off: plain Newton.
  threads = how many work on this solve and later ones; bits are the same for any number. By default what --threads
    says.
  penalty = { start = 0.01, steps = 20 }: all penalties grow from this part of their values to the whole in so many
    steps.
  step = { adaptive = true, min = 1/64, max = 1, growth = 2 }: a step that fails is cut in half, down to the part `min`
  of it; after an easy increment (half of the iterations allowed) the next is `growth` times as long, up to `max`.
  Increments are counted (run.cutbacks, run:column "increments", run:attempts(step)); rows are the steps.
  adaptive = false takes each step as a whole.
  arc_length = true: where a step fails, arcs follow the path, also back, until the step's end is passed; rows between
  steps have a fractional step, run.controls says where control changed. predictor, rescue and step are then those of
  sg.plain{} unless given, since shorter steps and other first guesses may leave the path.
  checkpoint = "run.sgn", or checkpoint = { file = "run.sgn", every = 10, durable = false }: after every step, or every
  so many, and at the end the model is saved together with how the run stands; a process that is killed leaves the file
  of the last such step. It is on the disk after a second; durable = true waits for the disk at every step.
  resume = true: goes on from the checkpoint's file where there is one, with the same bits as a run that saves at the
  same steps and that nothing has disturbed; from one without checkpoints it differs by rounding, for after each save
  patterns and pivots are made anew. The file of a finished run gives that run at once. Scene and stages must be the
  same. See also model:save.
  on_step = function(info): sees info.step, info.stage, info["grip.fx"] … after each step; returns nothing, "stop" to
    end cleanly, "cut" to have the step done again in halves, or a table of numbers: columns of the run, else nan.
  states = 5 (so many, from the start to the end), {0, 10, 46} (steps; 0 is the start) or function(info) (true: this
    one): which states run:states() has for pictures; without it the start and the end of each stage. A run that is
    taken up has those since then.
  on_iteration = function(info): sees stage, step, from, to (parts of the step), iteration, residual, energy, reason;
    returns nothing, "stop", or "cut" to give the attempt up.
A step that is not reached ends the run, a result: run.failed, run.reason, run.cause (what was behind minimum_step),
run.report (in words, with the worst places and what may help), run.places (for sg.picture's marks); the last accepted
state is kept. Reasons: completed, stopped, interrupted, cut, iterations, diverged, cycling, lost_projection, inverted,
singular, indefinite, nan, line_search, penetration, turning_point, minimum_step, strayed.
run:column "grip.fx" is a list over the steps; print(run) is a short table; run:csv(file) writes all columns: step,
increments, iterations, wall; <support>.fx, .fy, in 3D .fz, .moment where it rotates, .ux, .uy, .uz, .angle where
driven; <load>.fx …, .tx … or .pressure; <contact>.fx …, .area, .max_pressure, .max_penetration.
Source: Newton's steps (4.33) to (4.35), freeze_active_set 4.5.2 of V. Agrawal, thesis, IIT Guwahati, 2020; augmented:
J. C. Simo, T. A. Laursen, Comput. Struct. 42 (1992); arc_length: E. Riks, J. Appl. Mech. 39 (1972), H. B. Keller, 1977.
Example: model:run{ { name = "press", steps = 46, grip = {0, -0.23} } }]]
