-- Pages: the low-level methods of a model, for loops of a user's own.

local rows = require "signorini.pages.step_rows"
local t = require "signorini.types"

local driven = { "name", t.name(function(model) return model:driven_names() end), "a support or a load" }

local function names(part, parts, list)
  return { ("model:%s_names"):format(part), ("Returns the names of the %s, sorted."):format(parts),
           example = ("model:%s_names()  --> %s"):format(part, list) }
end

return {
  title = "Low-level methods: your own loops",
  word = "methods",
  also = "verbs",
  names("body", "bodies", '{"die", "slab"}'),
  names("support", "supports", '{"bed", "grip"}'),
  names("load", "loads", "{}"),
  names("contact", "contacts", '{"interface"}'),
  { "model:body", "Returns a body of the model.",
    arguments = { { "name", t.name(function(model) return model:body_names() end), "name of a body" } },
    example = "model:body \"slab\"" },
  { "model:driven_names", [[Returns the names of everything that stages can move: supports that drive or rotate, then
loads.]],
    example = "model:driven_names()  --> {\"grip\"}" },
  { "model:driven", [[Returns the components that stages move, in order: {"x", "y"} (in 3D also "z") of a driven support
or a traction, {"angle"} of a support that rotates (after its driven components), {"pressure"}.]],
    arguments = { driven },
    example = "model:driven \"grip\"  --> {\"x\", \"y\"}" },
  { "model:set_target", "Sets the components of a support or load at the end of the next step.",
    arguments = { driven, { "target", t.numbers(), "one number per driven component",
                            unit = "lengths, degrees, force per area" } },
    example = "model:set_target(\"grip\", {0, -0.11})" },
  { "model:target", "Returns the components of a support or load in the last accepted state.",
    arguments = { driven },
    example = "model:target \"grip\"" },
  { "model:solve_step", [[Runs Newton's method from the present state, after model:accept and model:rollback the
accepted one, to the targets; accepts nothing. Returns { converged, reason, iterations, message, residuals, energies,
parts }; reason is "converged", "iterations", "diverged", "cycling", "lost_projection", "inverted", "singular", "nan",
"line_search", "penetration" or "interrupted".]], named = rows.step, may_be_empty = true,
    more = "Source of freeze_active_set: V. Agrawal, thesis, IIT Guwahati 2020, 4.5.2.",
    example = [[
model:set_target("grip", {0, -0.11})
if model:solve_step{}.converged then model:accept() else model:rollback() end]] },
  { "model:iterate", [[Takes one iteration of model:solve_step: evaluates, and unless that ends it solves and moves. The
first one after model:accept, rollback, restore, set_target or set_penalty_factor begins a step. Returns what
model:solve_step returns, so far; reason is "iterating" while it goes on.]],
    named = "model:solve_step", may_be_empty = true,
    example = [[
model:set_target("grip", {0, -0.12})
repeat local now = model:iterate{} until now.reason ~= "iterating"]] },
  { "model:solve_arc", [[Goes a given distance from the accepted state along the path that leads to the targets
(arc-length continuation); how far along it is an unknown, so that turning points can be passed. The distance is a root
mean square over the volume of all bodies, a length that does not depend on the mesh (a rigid obstacle counts like all
bodies together). Accepts nothing; the targets become those reached. Returns what model:solve_step returns and fraction:
0 at the accepted state, 1 at the targets.]], named = rows.arc,
    example = [[
model:set_target("grip", {0, -0.13})
local result = model:solve_arc{ length = 0.01 }
if result.converged then model:accept() else model:rollback() end]] },
  { "model:last_length", [[Returns the root mean square over all bodies of the last accepted step's displacement, the
scale for arc lengths.]],
    example = "model:last_length()" },
  { "model:set_penalty_factor", [[Multiplies the penalty parameters of all contacts, as sg.model got them, from now on:
for penalties that grow along the path. model:rollback returns to that of the accepted state.]],
    arguments = { { "factor", t.positive, "of all penalty parameters" } },
    example = "model:set_penalty_factor(0.5)" },
  { "model:penalty_factor", "Returns the factor that model:set_penalty_factor set last; 1 at first.",
    example = "finer:penalty_factor()  --> 1.0" },
  { "model:accept", [[Makes the present state the accepted one; slip points advance. An error when the step under way
has not converged, or new targets wait for one.]],
    example = [[
model:rollback()
model:set_target("grip", {0, -0.1})
if model:solve_step{}.converged then model:accept() end]] },
  { "model:rollback", [[Returns to the accepted state: displacements, targets, penalties, contact. Call it after a step
that failed.]],
    example = "model:rollback()" },
  { "model:snapshot", [[Returns a copy of the accepted state with its contact history, for model:restore. Call it
between steps.]],
    example = "before = model:snapshot()" },
  { "model:restore", "Returns to a state that model:snapshot() has kept.",
    arguments = { { "snapshot", t.object "snapshot", "made by model:snapshot()" } },
    example = "model:restore(model:snapshot())" },
  { "snapshot", "A kept state of a model, made by model:snapshot, for model:restore." },
  { "model:residual", [[Returns the unbalanced force f_int + f_c - f_ext at the present displacements and the present
targets' loads: one number for each unknown (see model:unknowns). Prescribed displacements that no iteration has brought
in yet do not count.]],
    example = "#model:residual()" },
  { "model:tangent", [[Returns the consistent tangent, the derivative of model:residual, as triplets { size, rows,
columns, values }: entry k of the matrix stands in rows[k], columns[k], counted from 1; column after column, rows
rising.]],
    example = "model:tangent().size" },
  { "model:unknowns", [[Returns the meaning of each unknown: a list of { body, point, component }; of control points
that move as one the first.]],
    example = "model:unknowns()[1].body  --> \"die\"" },
  { "model:displacements", [[Returns the present displacement of each unknown, in the order of model:unknowns: of
control points that move as one that of the first.]],
    example = "#model:displacements()" },
  { "model:move", [[Adds a Δu of your own to the unknowns. The first move after model:set_target also brings the
prescribed displacements to their targets: begin a step with a move of zeros. model:accept takes the state if its
residual is as small as model:solve_step{} wants it; model:rollback drops it; model:iterate and model:solve_step go on
from it.]],
    arguments = { { "du", t.numbers(), "the change of each unknown, in the order of model:residual" } },
    example = [[
local zeros = {}
for i = 1, #model:residual() do zeros[i] = 0 end
model:move(zeros)
model:rollback()]] },
  { "model:loose_bodies", [[Returns the names of the bodies with rigid-body modes that no support stops: only contact
can hold them.]],
    example = "model:loose_bodies()" },
  { "model:diagnose", [[Finds out why the last solve_step, iterate or solve_arc failed; call it before model:rollback.
Returns { reason, message, cure, places, unbalanced }: reason is one of model:solve_step's, or "indefinite"; places is a
list of { kind, body or contact, element or point, X, x, value, text }, the worst first: the element that is inverted,
contact points whose states cycle or that leave the master, control points that move most in the direction of a singular
or indefinite tangent; unbalanced: where the largest unbalanced forces are.]],
    arguments = { { "on", t.list(t.choice { "step", "line_search", "damping", "active_set_changes", "arc_length",
      "penalty", "pseudo_transient" }), "controls that are on already, which the cure need not name", default = {} } },
  },
  { "model:timings", [[Returns seconds so far: { bulk, contact, linear, factorization, solution, search }. linear
consists of factorization and solution, except for a few vectors (with linear = "kept" a solution renews the
factorization when it pays). search is part of contact, summed over threads: closest points and the tree of boxes, while
model:time_search(true).]],
    example = "model:timings().linear" },
  { "model:time_search", [[Says whether model:timings takes account of the contacts' search from now on. A clock is read
twice for each contact point that is projected, about 50 ns.]],
    arguments = { { "wanted", t.flag, "whether to take the time; at first it is not taken" } },
    example = "model:time_search(true)" },
  { "model:solver", [[Returns { linear, unknowns, patterns, factorizations, solutions, iterations, factor_memory, memory
}: the linear solver in use, the size of its systems, how many sparse patterns were analyzed; then what was done since
the model was made: numerical factorizations, right-hand sides, iterations of GMRES with a lagged factorization; bytes
of the present factors, and of the bodies' tables with the tangent and its patterns.]],
    example = "model:solver().linear" },
}
