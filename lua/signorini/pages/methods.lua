-- Pages: the low-level methods of a model, for user-defined solution loops.

local lists = require "signorini.call.lists"
local rows = require "signorini.pages.step_rows"
local t = require "signorini.call.types"

local driven = { "name", t.name(function(model) return model:driven_names() end), "a support or a load" }

--- The fields of the result of a step.
local outcome = { "converged", t.flag, "reason", t.text, "iterations", t.integer(0), "message?", t.text,
                  "residuals energies parts", t.numbers(nil, true) }

local function names(part, parts, list)
  return { ("model:%s_names"):format(part), ("Returns the names of the %s, sorted."):format(parts),
           returns = t.list(t.text), example = ("model:%s_names()  --> %s"):format(part, list) }
end

local change = require("signorini.pages.contact_rows").change
local constants = lists.joined(change, {
  { "overlap", t.range(0, 1), 'fraction of the initial overlap that remains allowed with overlap = "interference"',
    optional = true } })
constants.hints, constants.conflict = change.hints, change.conflict

return {
  title = "Low-level methods: user-defined loops", word = "methods",
  names("body", "bodies", '{"die", "slab"}'),
  names("support", "supports", '{"bed", "grip"}'),
  names("load", "loads", "{}"),
  names("contact", "contacts", '{"interface"}'),
  names("tie", "ties", "{}"),
  { "model:body", "Returns a body of the model.",
    arguments = { { "name", t.name(function(model) return model:body_names() end), "name of a body" } },
    returns = t.object "body", example = "model:body \"slab\"" },
  { "model:driven_names", [[Returns the names of the supports and loads that stages can change: supports that drive or
rotate, then loads.]],
    returns = t.list(t.text), example = "model:driven_names()  --> {\"grip\"}" },
  { "model:driven", [[Returns the components that stages prescribe, in order: {"x", "y"} (in 3D also "z") of a driven
support or a traction, {"angle"} of a support that rotates (after its driven components), {"pressure"}, {"moment"}.]],
    arguments = { driven },
    returns = t.list(t.text), example = "model:driven \"grip\"  --> {\"x\", \"y\"}" },
  { "model:set_target", "Sets the components of a support or load at the end of the next step.",
    arguments = { driven, { "target", t.numbers(), "one number per driven component",
                            unit = "lengths, degrees, force per area" } },
    example = "model:set_target(\"grip\", {0, -0.11})" },
  { "model:target", "Returns the components of a support or load in the last accepted state.",
    arguments = { driven },
    returns = t.numbers(), example = "model:target \"grip\"" },
  { "model:solve_step", [[Runs Newton's method from the current state (after model:accept and model:rollback: the
accepted one) to the targets, without accepting the result. Returns { converged, reason, iterations, message, residuals,
energies, parts }: residuals: norms of f; energies: |f·Δu| of each iteration; parts: fractions of the corrections that a
line search took; reason: "converged", "iterations" (the limit was reached), "diverged", "cycling", "lost_projection",
"inverted", "singular", "nan", "line_search", "crossed" or "interrupted".]],
    named = rows.step, may_be_empty = true,
    more = "Source of freeze_active_set: V. Agrawal, thesis, IIT Guwahati 2020, 4.5.2.",
    returns = t.record(table.unpack(outcome)), example = [[
model:set_target("grip", {0, -0.11})
if model:solve_step{}.converged then model:accept() else model:rollback() end]] },
  { "model:iterate", [[Performs one iteration of model:solve_step: evaluates the residual and, unless that ends the
step, solves and updates the unknowns. The first iteration after model:accept, rollback, restore, set_target,
set_contact or set_penalty_factor starts a step. Returns the result of model:solve_step so far; reason is "iterating"
until the step ends.]],
    named = "model:solve_step", may_be_empty = true,
    returns = t.record(table.unpack(outcome)), example = [[
model:set_target("grip", {0, -0.12})
repeat local now = model:iterate{} until now.reason ~= "iterating"]] },
  { "model:solve_arc", [[Solves one arc-length increment: follows the path towards the targets by a given distance from
the accepted state. The fraction of the targets is an unknown, so that turning points can be passed. The distance is the
root mean square of the displacement over the volume of all bodies, independent of the mesh (a rigid obstacle counts as
much as all bodies together). The result is not accepted; the targets become those reached. Returns the result of
model:solve_step and fraction: 0 at the accepted state, 1 at the targets.]], named = rows.arc,
    returns = t.record("fraction", t.number, table.unpack(outcome)), example = [[
model:set_target("grip", {0, -0.13})
local result = model:solve_arc{ length = 0.01 }
if result.converged then model:accept() else model:rollback() end]] },
  { "model:last_length", [[Returns the root mean square over all bodies of the last accepted step's displacement, a
scale for `length` of model:solve_arc.]],
    returns = t.number, example = "model:last_length()" },
  { "model:set_contact", [[Changes constants of a contact for the next step, as stages of model:run do; constants that
are not given keep their values. Two half passes change together. model:rollback restores the constants of the accepted
state. model:contact_law returns the present ones.]],
    arguments = { { "name", t.name(function(model) return model:contact_names() end), "a contact" },
                  { "constants", t.named(constants), "those that change" } },
    rows = constants,
    example = 'model:set_contact("interface", { penalty = 200 })' },
  { "model:set_penalty_factor", [[Sets the factor by which the penalty parameters of all contacts, as given to sg.model,
are multiplied, for example to increase penalties along the path. model:rollback restores the factor of the accepted
state.]],
    arguments = { { "factor", t.positive, "of all penalty parameters" } },
    example = "model:set_penalty_factor(0.5)" },
  { "model:penalty_factor", "Returns the factor set by model:set_penalty_factor; initially 1.",
    returns = t.number, example = "finer:penalty_factor()  --> 1.0" },
  { "model:set_time", [[Sets the time at the end of the next step, from which the rates of slip of contacts with a
formula of friction follow, and the flow of viscoelastic materials. Without a call the step has no duration.
model:rollback restores the time of the accepted state.]],
    arguments = { { "time", t.either(t.non_negative, t.choice { "relaxed" }), [[not before that of the accepted state;
"relaxed": the step lasts until nothing flows any more, and the clock stays]], unit = "time" } },
    example = "model:set_time(0.5)" },
  { "model:time", "Returns the time set by model:set_time or by stages with a duration; initially 0.",
    returns = t.number, example = "finer:time()  --> 0.0" },
  { "model:accept", [[Makes the current state the accepted one and updates the slip points. It is an error if the
current step has not converged, if points have passed through the master of a contact in it, or if targets were changed
and not solved for.]],
    example = [[
model:rollback()
model:set_target("grip", {0, -0.1})
if model:solve_step{}.converged then model:accept() end]] },
  { "model:rollback", [[Returns to the accepted state: displacements, targets, penalties, contact. Call it after a
failed step.]],
    example = "model:rollback()" },
  { "model:snapshot", [[Returns a copy of the accepted state with its contact history, for model:restore. Call it
between steps.]],
    returns = t.object "snapshot", example = "before = model:snapshot()" },
  { "model:restore", "Returns to a state saved by model:snapshot().",
    arguments = { { "snapshot", t.object "snapshot", "made by model:snapshot()" } },
    example = "model:restore(model:snapshot())" },
  { "snapshot", "A saved state of a model, made by model:snapshot, for model:restore." },
  { "model:residual", [[Returns the unbalanced force f_int + f_c - f_ext at the current displacements and the current
targets' loads: one number for each unknown (see model:unknowns). Prescribed displacements that no iteration has applied
yet are not included. Of the accepted state it is that of the next step, whose slips start there; results stay those of
the step that led to the state.]],
    returns = t.numbers(), example = "#model:residual()" },
  { "model:tangent", [[Returns the consistent tangent, the derivative of model:residual, as triplets { size, rows,
columns, values }: entry k of the matrix is in row rows[k] and column columns[k], counted from 1; sorted by column, then
by row.]],
    returns = t.record("size", t.integer(0), "rows columns", t.list(t.count), "values", t.numbers()),
    example = "model:tangent().size" },
  { "model:unknowns", [[Returns the meaning of each unknown: a list of { body, point, component }; for control points
that share an unknown, the first one; { support, component } for an obstacle that a support frees. The unknown of its
"angle" is the arc at a length of the obstacle's size, share/doc/reference/theory.md.]],
    returns = t.list(t.record("body? support?", t.text, "point?", t.count, "component", t.text)),
    example = "model:unknowns()[1].body  --> \"die\"" },
  { "model:displacements", [[Returns the current displacement of each unknown, in the order of model:unknowns.]],
    returns = t.numbers(), example = "#model:displacements()" },
  { "model:move", [[Adds a given increment Δu to the unknowns. The first move after model:set_target also sets the
prescribed displacements to their targets: start a step with a move of zeros. model:accept accepts the state if its
residual is within the tolerance of model:solve_step{}; model:rollback discards it; model:iterate and model:solve_step
continue from it.]],
    arguments = { { "du", t.numbers(), "increment of each unknown, in the order of model:residual" } },
    example = [[
local zeros = {}
for i = 1, #model:residual() do zeros[i] = 0 end
model:move(zeros)
model:rollback()]] },
  { "model:unconstrained_bodies", [[Returns the names of the unconstrained bodies: those with rigid-body modes that no
support prevents; and those of the supports that free obstacles which no spring holds.]],
    returns = t.list(t.text), example = "model:unconstrained_bodies()" },
  { "model:diagnose", [[Diagnoses why the last solve_step, iterate or solve_arc failed; call it before model:rollback.
Returns { reason, message, cure, places, unbalanced }: reason is one of model:solve_step's, "indefinite" or
"friction_exhausted"; places is a list of { kind, body or contact, element or point, X, x, value, text }, the worst
first: the inverted element, contact points whose states cycle, that leave the master or have passed through it, control
points that move most in the critical direction of a singular or indefinite tangent; unbalanced: places of the largest
unbalanced forces.]],
    arguments = { { "on", t.list(t.choice { "step", "line_search", "damping", "active_set_changes", "arc_length",
      "penalty", "pseudo_transient" }), "controls that your loop uses already, so that cure does not suggest them",
      default = {} } },
    returns = t.record("reason message", t.text, "cure?", t.text, "places unbalanced", t.list(t.any)) },
  { "model:timings", [[Returns the times used so far, in seconds: { bulk, contact, linear, factorization, solution,
search }. linear is the sum of factorization and solution, except for a few vector operations (with linear = "reuse", a
solution may renew the factorization). search is part of contact, summed over threads: closest-point projection and
bounding-box tree, measured after model:time_search(true).]],
    returns = t.record("bulk contact linear factorization solution search", t.number),
    example = "model:timings().linear" },
  { "model:time_search", [[Switches the timing of contact search in model:timings on or off. It reads a clock twice per
projected contact point, about 50 ns.]],
    arguments = { { "wanted", t.flag, "whether to measure; initially false" } },
    example = "model:time_search(true)" },
  { "model:solver", [[Returns { linear, unknowns, patterns, factorizations, solutions, iterations, factor_operations,
factor_memory, memory }: the linear solver in use, the size of its systems, the number of sparse patterns analyzed;
since the model was made, the numbers of numerical factorizations, right-hand sides, and GMRES iterations with a lagged
factorization; floating-point operations and bytes of the current factors, as the solver counts them (0: it does not);
bytes of the bodies' tables, the tangent and its patterns. With linear = "mumps" also rank_memory,
bytes of the process that used most for a factorization, and, of symmetric tangents that are factored every time and
have no multipliers, negative_eigenvalues, their number in the last one.]],
    returns = t.record("linear", t.text, "unknowns patterns factorizations solutions iterations", t.integer(0),
      "factor_operations factor_memory memory", t.number, "rank_memory? negative_eigenvalues?", t.number),
    example = "model:solver().linear" },
}
