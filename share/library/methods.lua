---@meta _
-- Generated from the help pages by scripts/reference; read by editors, not by the program.
-- Low-level methods: user-defined loops

---@class sg.model
local model = {}

---Returns the names of the bodies, sorted.
---
---Example:
---```lua
---model:body_names()  --> {"die", "slab"}
---```
---@return string[]
function model:body_names() end

---Returns the names of the supports, sorted.
---
---Example:
---```lua
---model:support_names()  --> {"bed", "grip"}
---```
---@return string[]
function model:support_names() end

---Returns the names of the loads, sorted.
---
---Example:
---```lua
---model:load_names()  --> {}
---```
---@return string[]
function model:load_names() end

---Returns the names of the contacts, sorted.
---
---Example:
---```lua
---model:contact_names()  --> {"interface"}
---```
---@return string[]
function model:contact_names() end

---Returns the names of the ties, sorted.
---
---Example:
---```lua
---model:tie_names()  --> {}
---```
---@return string[]
function model:tie_names() end

---Returns a body of the model.
---
---Example:
---```lua
---model:body "slab"
---```
---@param name string # name: name of a body (a string)
---@return sg.body
function model:body(name) end

---Returns the names of the supports and loads that stages can change: supports that drive or rotate, then loads.
---
---Example:
---```lua
---model:driven_names()  --> {"grip"}
---```
---@return string[]
function model:driven_names() end

---Returns the components that stages prescribe, in order: {"x", "y"} (in 3D also "z") of a driven support or a
---traction, {"angle"} of a support that rotates (after its driven components), {"pressure"}, {"moment"}.
---
---Example:
---```lua
---model:driven "grip"  --> {"x", "y"}
---```
---@param name string # name: a support or a load (a string)
---@return string[]
function model:driven(name) end

---Sets the components of a support or load at the end of the next step.
---
---Example:
---```lua
---model:set_target("grip", {0, -0.11})
---```
---@param name string # name: a support or a load (a string)
---@param target number[] # target: one number per driven component (a list of numbers; lengths, degrees, force per area)
function model:set_target(name, target) end

---Returns the components of a support or load in the last accepted state.
---
---Example:
---```lua
---model:target "grip"
---```
---@param name string # name: a support or a load (a string)
---@return number[]
function model:target(name) end

---@class (exact) sg.model.solve_step.arguments.mumps
---reuse: a factorization preconditions GMRES on later tangents, as with linear = "reuse" (true or false; default false)
---@field reuse? boolean
---low_rank: a number above 0 and at most 1; optional. Tolerance of block low-rank compression, relative to the tangent:
---```text
---          approximate factors, with less memory and operations in large solids, which precondition GMRES
---```
---@field low_rank? number
---precision: of the factors; single ones precondition GMRES ('double' or 'single'; default "double")
---@field precision? "double"|"single"
---out_of_core: an existing folder in which each process stores its factors; on a local disk (a string; optional)
---@field out_of_core? string
---@field [string] sg.unknown_argument

---@class (exact) sg.model.solve_step.arguments.augmentation
---penetration: largest penetration, as a fraction of the largest body's diagonal (a number above 0 and at most 1;
---```text
---             default 1e-06)
---```
---@field penetration? number
---loops: maximum number of augmentations per step (a whole number from 1 to 1000000; default 100)
---@field loops? integer
---@field [string] sg.unknown_argument

---@class (exact) sg.model.solve_step.arguments
---tolerance: residual that counts as zero, relative to reactions and loads (a positive number; default 1e-10)
---@field tolerance? number
---iterations: maximum number of iterations per attempt (a whole number from 1 to 1000000; default 25)
---@field iterations? integer
---line_search: how Newton corrections are shortened: by the norm of the residual (non-monotone) or by the energy
---```text
---             ('none', 'residual' or 'energy'; default "none")
---```
---@field line_search? "none"|"residual"|"energy"
---freeze_active_set: true, false or a number from 0 to 1; default false. Contact states are frozen until |f·Δu| has
---```text
---              decreased to this fraction of its first value; true is 0.01
---```
---@field freeze_active_set? boolean|number
---active_set_changes: a whole number from 0 to 1000000; default 0. A contact point that changes its state more than
---this
---```text
---              number of times in a step is fixed in it (a slipping one as sticking) until the others have converged;
---              0: never
---```
---@field active_set_changes? integer
---predictor: predictor, the first guess of a step; "linear" extrapolates the last step, "quadratic" the last two
---```text
---           ('tangent', 'constant', 'linear' or 'quadratic'; default "tangent")
---```
---@field predictor? "tangent"|"constant"|"linear"|"quadratic"
---linear: 'auto', 'klu', 'umfpack', 'condensed', 'reuse' or 'mumps'; default "auto". Linear solver. "klu", "umfpack":
---```text
---        direct; "reuse": a reused (lagged) factorization preconditions GMRES while that is cheaper than a new one;
---        "condensed": static condensation, for linear elastic bodies; "mumps": MUMPS, direct, in parallel under mpirun;
---        "auto": automatic choice
---```
---@field linear? "auto"|"klu"|"umfpack"|"condensed"|"reuse"|"mumps"
---mumps: options of linear = "mumps" (a table of named arguments; optional)
---```text
---  reuse:       a factorization preconditions GMRES on later tangents, as with linear = "reuse" (true or false; default
---               false)
---  low_rank:    a number above 0 and at most 1; optional. Tolerance of block low-rank compression, relative to the
---               tangent: approximate factors, with less memory and operations in large solids, which precondition GMRES
---  precision:   of the factors; single ones precondition GMRES ('double' or 'single'; default "double")
---  out_of_core: an existing folder in which each process stores its factors; on a local disk (a string; optional)
---```
---@field mumps? sg.model.solve_step.arguments.mumps
---augmentation: a table of named arguments; by default { penetration = 1e-6, loops = 100 }. Limits of contacts with
---```text
---              enforcement = "augmented": their pressures are augmented (Uzawa) until penetration and separation of
---              closed points are within the tolerance; in mortar contact those of the multipliers, whose friction is
---              augmented as well. With method = "gpts" on a deformable master, curved under the slave, the default
---              tolerance is often not reached, and the step fails (run.cause "penetration"). An error if no contact is
---              augmented
---  penetration: largest penetration, as a fraction of the largest body's diagonal (a number above 0 and at most 1;
---               default 1e-06)
---  loops:       maximum number of augmentations per step (a whole number from 1 to 1000000; default 100)
---```
---@field augmentation? sg.model.solve_step.arguments.augmentation
---damping: true or false; default false. Damps unconstrained bodies and obstacles until contact holds them; the
---```text
---         converged state is in equilibrium without damping
---```
---@field damping? boolean
---pseudo_transient: true or false; default false. pseudo-transient continuation: follows a damped motion, past a limit
---```text
---              point, to a distant equilibrium, in up to 40 times as many iterations; not with line_search
---```
---@field pseudo_transient? boolean
---verbose: true or false; default false. Prints each iteration when it ends: the residual, relative to the forces so
---```text
---         that newton.tolerance is its goal; the energy |f·Δu| of the correction; contact points that are active, that
---         slip and that have changed their state; the linear solver, where it has factored, or iterations of GMRES; a
---         factor on the correction, augmentations, the reason of the end
---```
---@field verbose? boolean
---@field [string] sg.unknown_argument

---@class (exact) sg.model.solve_step.result
---@field converged boolean
---@field reason string
---@field iterations integer
---@field message? string
---@field residuals number[]
---@field energies number[]
---@field parts number[]

---Runs Newton's method from the current state (after model:accept and model:rollback: the accepted one) to the targets,
---without accepting the result. Returns { converged, reason, iterations, message, residuals, energies, parts }:
---residuals: norms of f; energies: |f·Δu| of each iteration; parts: fractions of the corrections that a line search
---took; reason: "converged", "iterations" (the limit was reached), "diverged", "cycling", "lost_projection",
---"inverted", "singular", "nan", "line_search", "penetration", "crossed" or "interrupted".
---
---```text
---model:solve_step{ tolerance = 1e-10, iterations = 25, line_search = "none", freeze_active_set = false,
---  active_set_changes = 0, predictor = "tangent", linear = "auto", mumps, augmentation, damping = false,
---  pseudo_transient = false, verbose = false }
---```
---
---Source of freeze_active_set: V. Agrawal, thesis, IIT Guwahati 2020, 4.5.2.
---
---Example:
---```lua
---model:set_target("grip", {0, -0.11})
---if model:solve_step{}.converged then model:accept() else model:rollback() end
---```
---@param arguments? sg.model.solve_step.arguments
---@return sg.model.solve_step.result
function model:solve_step(arguments) end

---@class (exact) sg.model.iterate.result
---@field converged boolean
---@field reason string
---@field iterations integer
---@field message? string
---@field residuals number[]
---@field energies number[]
---@field parts number[]

---Performs one iteration of model:solve_step: evaluates the residual and, unless that ends the step, solves and updates
---the unknowns. The first iteration after model:accept, rollback, restore, set_target, set_contact or
---set_penalty_factor starts a step. Returns the result of model:solve_step so far; reason is "iterating" until the step
---ends.
---
---```text
---model:iterate{ … }
---```
---
---Example:
---```lua
---model:set_target("grip", {0, -0.12})
---repeat local now = model:iterate{} until now.reason ~= "iterating"
---```
---@param arguments? sg.model.solve_step.arguments
---@return sg.model.iterate.result
function model:iterate(arguments) end

---@class (exact) sg.model.solve_arc.arguments.mumps
---reuse: a factorization preconditions GMRES on later tangents, as with linear = "reuse" (true or false; default false)
---@field reuse? boolean
---low_rank: a number above 0 and at most 1; optional. Tolerance of block low-rank compression, relative to the tangent:
---```text
---          approximate factors, with less memory and operations in large solids, which precondition GMRES
---```
---@field low_rank? number
---precision: of the factors; single ones precondition GMRES ('double' or 'single'; default "double")
---@field precision? "double"|"single"
---out_of_core: an existing folder in which each process stores its factors; on a local disk (a string; optional)
---@field out_of_core? string
---@field [string] sg.unknown_argument

---@class (exact) sg.model.solve_arc.arguments
---length: distance from the accepted state, root mean square of the displacement over all bodies (a positive number;
---```text
---        length)
---```
---@field length number
---tolerance: residual that counts as zero, relative to reactions and loads (a positive number; default 1e-10)
---@field tolerance? number
---iterations: maximum number of iterations per attempt (a whole number from 1 to 1000000; default 25)
---@field iterations? integer
---linear: 'auto', 'klu', 'umfpack', 'condensed', 'reuse' or 'mumps'; default "auto". Linear solver. "klu", "umfpack":
---```text
---        direct; "reuse": a reused (lagged) factorization preconditions GMRES while that is cheaper than a new one;
---        "condensed": static condensation, for linear elastic bodies; "mumps": MUMPS, direct, in parallel under mpirun;
---        "auto": automatic choice
---```
---@field linear? "auto"|"klu"|"umfpack"|"condensed"|"reuse"|"mumps"
---mumps: options of linear = "mumps" (a table of named arguments; optional)
---```text
---  reuse:       a factorization preconditions GMRES on later tangents, as with linear = "reuse" (true or false; default
---               false)
---  low_rank:    a number above 0 and at most 1; optional. Tolerance of block low-rank compression, relative to the
---               tangent: approximate factors, with less memory and operations in large solids, which precondition GMRES
---  precision:   of the factors; single ones precondition GMRES ('double' or 'single'; default "double")
---  out_of_core: an existing folder in which each process stores its factors; on a local disk (a string; optional)
---```
---@field mumps? sg.model.solve_arc.arguments.mumps
---verbose: true or false; default false. Prints each iteration when it ends: the residual, relative to the forces so
---```text
---         that newton.tolerance is its goal; the energy |f·Δu| of the correction; contact points that are active, that
---         slip and that have changed their state; the linear solver, where it has factored, or iterations of GMRES; a
---         factor on the correction, augmentations, the reason of the end
---```
---@field verbose? boolean
---@field [string] sg.unknown_argument

---@class (exact) sg.model.solve_arc.result
---@field fraction number
---@field converged boolean
---@field reason string
---@field iterations integer
---@field message? string
---@field residuals number[]
---@field energies number[]
---@field parts number[]

---Solves one arc-length increment: follows the path towards the targets by a given distance from the accepted state.
---The fraction of the targets is an unknown, so that turning points can be passed. The distance is the root mean square
---of the displacement over the volume of all bodies, independent of the mesh (a rigid obstacle counts as much as all
---bodies together). The result is not accepted; the targets become those reached. Returns the result of
---model:solve_step and fraction: 0 at the accepted state, 1 at the targets.
---
---```text
---model:solve_arc{ length, tolerance = 1e-10, iterations = 25, linear = "auto", mumps, verbose = false }
---```
---
---Example:
---```lua
---model:set_target("grip", {0, -0.13})
---local result = model:solve_arc{ length = 0.01 }
---if result.converged then model:accept() else model:rollback() end
---```
---@param arguments sg.model.solve_arc.arguments
---@return sg.model.solve_arc.result
function model:solve_arc(arguments) end

---Returns the root mean square over all bodies of the last accepted step's displacement, a scale for `length` of
---model:solve_arc.
---
---Example:
---```lua
---model:last_length()
---```
---@return number
function model:last_length() end

---@class (exact) sg.model.set_contact.constants.friction
---mu: Coulomb's coefficient of friction (a number, 0 or more; optional)
---@field mu? number
---penalty: tangential penalty (a positive number; pressure per length; optional)
---@field penalty? number
---@field [string] sg.unknown_argument

---@class (exact) sg.model.set_contact.constants
---active: whether the contact acts. One that does not has no pressure, friction or history (true or false; optional)
---@field active? boolean
---penalty: normal penalty (a positive number; pressure per length; optional)
---@field penalty? number
---friction: a table of named arguments; optional. Coulomb friction, of a contact that has friction in sg.model (there
---mu
---```text
---          = 0 if it is without at first). Where friction begins, points stick at their present place
---  mu:      Coulomb's coefficient of friction (a number, 0 or more; optional)
---  penalty: tangential penalty (a positive number; pressure per length; optional)
---```
---@field friction? sg.model.set_contact.constants.friction
---offset: gap at which the faces touch (a number; length; optional)
---@field offset? number
---overlap: fraction of the initial overlap that remains allowed with overlap = "interference" (a number from 0 to 1;
---```text
---         optional)
---```
---@field overlap? number
---@field [string] sg.unknown_argument

---Changes constants of a contact for the next step, as stages of model:run do; constants that are not given keep their
---values. Two half passes change together. model:rollback restores the constants of the accepted state.
---model:contact_law returns the present ones.
---
---Example:
---```lua
---model:set_contact("interface", { penalty = 200 })
---```
---@param name string # name: a contact (a string)
---@param constants sg.model.set_contact.constants # constants: those that change (a table of named arguments) active: whether the contact acts. One that does not has no pressure, friction or history (true or false; optional) penalty: normal penalty (a positive number; pressure per length; optional) friction: a table of named arguments; optional. Coulomb friction, of a contact that has friction in sg.model (there mu = 0 if it is without at first). Where friction begins, points stick at their present place mu: Coulomb's coefficient of friction (a number, 0 or more; optional) penalty: tangential penalty (a positive number; pressure per length; optional) offset: gap at which the faces touch (a number; length; optional) overlap: fraction of the initial overlap that remains allowed with overlap = "interference" (a number from 0 to 1; optional)
function model:set_contact(name, constants) end

---Sets the factor by which the penalty parameters of all contacts, as given to sg.model, are multiplied, for example to
---increase penalties along the path. model:rollback restores the factor of the accepted state.
---
---Example:
---```lua
---model:set_penalty_factor(0.5)
---```
---@param factor number # factor: of all penalty parameters (a positive number)
function model:set_penalty_factor(factor) end

---Returns the factor set by model:set_penalty_factor; initially 1.
---
---Example:
---```lua
---finer:penalty_factor()  --> 1.0
---```
---@return number
function model:penalty_factor() end

---Makes the current state the accepted one and updates the slip points. It is an error if the current step has not
---converged, if points have passed through the master of a contact in it, or if targets were changed and not solved
---for.
---
---Example:
---```lua
---model:rollback()
---model:set_target("grip", {0, -0.1})
---if model:solve_step{}.converged then model:accept() end
---```
function model:accept() end

---Returns to the accepted state: displacements, targets, penalties, contact. Call it after a failed step.
---
---Example:
---```lua
---model:rollback()
---```
function model:rollback() end

---Returns a copy of the accepted state with its contact history, for model:restore. Call it between steps.
---
---Example:
---```lua
---before = model:snapshot()
---```
---@return sg.snapshot
function model:snapshot() end

---Returns to a state saved by model:snapshot().
---
---Example:
---```lua
---model:restore(model:snapshot())
---```
---@param snapshot sg.snapshot # snapshot: made by model:snapshot() (a snapshot)
function model:restore(snapshot) end

---A saved state of a model, made by model:snapshot, for model:restore.
---@class sg.snapshot
local snapshot = {}

---Returns the unbalanced force f_int + f_c - f_ext at the current displacements and the current targets' loads: one
---number for each unknown (see model:unknowns). Prescribed displacements that no iteration has applied yet are not
---included. Of the accepted state it is that of the next step, whose slips start there; results stay those of the step
---that led to the state.
---
---Example:
---```lua
---#model:residual()
---```
---@return number[]
function model:residual() end

---@class (exact) sg.model.tangent.result
---@field size integer
---@field rows integer[]
---@field columns integer[]
---@field values number[]

---Returns the consistent tangent, the derivative of model:residual, as triplets { size, rows, columns, values }: entry
---k of the matrix is in row rows[k] and column columns[k], counted from 1; sorted by column, then by row.
---
---Example:
---```lua
---model:tangent().size
---```
---@return sg.model.tangent.result
function model:tangent() end

---@class (exact) sg.model.unknowns.result
---@field body? string
---@field support? string
---@field point? integer
---@field component string

---Returns the meaning of each unknown: a list of { body, point, component }; for control points that share an unknown,
---the first one; { support, component } for an obstacle that a support frees. The unknown of its "angle" is the arc at
---a length of the obstacle's size, share/doc/theory.md.
---
---Example:
---```lua
---model:unknowns()[1].body  --> "die"
---```
---@return sg.model.unknowns.result[]
function model:unknowns() end

---Returns the current displacement of each unknown, in the order of model:unknowns.
---
---Example:
---```lua
---#model:displacements()
---```
---@return number[]
function model:displacements() end

---Adds a given increment Δu to the unknowns. The first move after model:set_target also sets the prescribed
---displacements to their targets: start a step with a move of zeros. model:accept accepts the state if its residual is
---within the tolerance of model:solve_step{}; model:rollback discards it; model:iterate and model:solve_step continue
---from it.
---
---Example:
---```lua
---local zeros = {}
---for i = 1, #model:residual() do zeros[i] = 0 end
---model:move(zeros)
---model:rollback()
---```
---@param du number[] # du: increment of each unknown, in the order of model:residual (a list of numbers)
function model:move(du) end

---Returns the names of the unconstrained bodies: those with rigid-body modes that no support prevents; and those of the
---supports that free obstacles which no spring holds.
---
---Example:
---```lua
---model:unconstrained_bodies()
---```
---@return string[]
function model:unconstrained_bodies() end

---@alias sg.model.diagnose.on.choice "step"|"line_search"|"damping"|"active_set_changes"|"arc_length"|"penalty"|"pseudo_transient"

---@class (exact) sg.model.diagnose.result
---@field reason string
---@field message string
---@field cure? string
---@field places any[]
---@field unbalanced any[]

---Diagnoses why the last solve_step, iterate or solve_arc failed; call it before model:rollback. Returns { reason,
---message, cure, places, unbalanced }: reason is one of model:solve_step's, "indefinite" or "friction_exhausted";
---places is a list of { kind, body or contact, element or point, X, x, value, text }, the worst first: the inverted
---element, contact points whose states cycle, that leave the master or have passed through it, control points that move
---most in the critical direction of a singular or indefinite tangent; unbalanced: places of the largest unbalanced
---forces.
---@param on? sg.model.diagnose.on.choice[] # on: controls that your loop uses already, so that cure does not suggest them (a list of values among 'step', 'line_search', 'damping', 'active_set_changes', 'arc_length', 'penalty' and 'pseudo_transient'; default {})
---@return sg.model.diagnose.result
function model:diagnose(on) end

---@class (exact) sg.model.timings.result
---@field bulk number
---@field contact number
---@field linear number
---@field factorization number
---@field solution number
---@field search number

---Returns the times used so far, in seconds: { bulk, contact, linear, factorization, solution, search }. linear is the
---sum of factorization and solution, except for a few vector operations (with linear = "reuse", a solution may renew
---the factorization). search is part of contact, summed over threads: closest-point projection and bounding-box tree,
---measured after model:time_search(true).
---
---Example:
---```lua
---model:timings().linear
---```
---@return sg.model.timings.result
function model:timings() end

---Switches the timing of contact search in model:timings on or off. It reads a clock twice per projected contact point,
---about 50 ns.
---
---Example:
---```lua
---model:time_search(true)
---```
---@param wanted boolean # wanted: whether to measure; initially false (true or false)
function model:time_search(wanted) end

---@class (exact) sg.model.solver.result
---@field linear string
---@field unknowns integer
---@field patterns integer
---@field factorizations integer
---@field solutions integer
---@field iterations integer
---@field factor_operations number
---@field factor_memory number
---@field memory number
---@field rank_memory? number
---@field negative_eigenvalues? number

---Returns { linear, unknowns, patterns, factorizations, solutions, iterations, factor_operations, factor_memory, memory
---}: the linear solver in use, the size of its systems, the number of sparse patterns analyzed; since the model was
---made, the numbers of numerical factorizations, right-hand sides, and GMRES iterations with a lagged factorization;
---floating-point operations and bytes of the current factors, as the solver counts them (0: it does not); bytes of the
---bodies' tables, the tangent and its patterns. With linear = "mumps" also rank_memory, bytes of the process that used
---most for a factorization, and, of symmetric tangents that are factored every time and have no multipliers,
---negative_eigenvalues, their number in the last one.
---
---Example:
---```lua
---model:solver().linear
---```
---@return sg.model.solver.result
function model:solver() end
