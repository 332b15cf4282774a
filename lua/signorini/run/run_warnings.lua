-- Warnings about a run although it completed: those of sg.model about the scene, loads that are not ramped, functions
-- of stages that jump at their start, loose tolerances, contacts without any active point (wrong face, or a body that
-- misses the other), contacts switched on where bodies overlap, states at the ends of stages, failed projections, half
-- passes with different forces, unstable equilibria, unstable elastic laws, unstable explicit wear, idle processes of
-- mpirun, and those of the files controls.lua, jumps.lua and energy_balance.lua.

local contact_changes = require "signorini.run.contact_changes"
local controls = require "signorini.run.controls"
local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local energy_balance = require "signorini.run.energy_balance"
local jumps = require "signorini.run.jumps"
local lists = require "signorini.call.lists"
local stages = require "signorini.run.stages"

local run_warnings = {}

--- True if a contact transmitted a force at some row of the run, or does now, between two rows, where a step has
--- failed. Under adhesion this is possible at any distance of the bodies.
local function ever_acts(run, model, contact)
  local now = model:contact_resultant(contact)
  return lists.any({ "area", "fx", "fy", "fz" }, function(key)
    local values = run.values[contact .. "." .. key] or {}
    return (rawget(now, key) or 0) ~= 0 or lists.any(values, function(value) return value ~= 0 end)
  end)
end

--- True if state_warnings() reports that the bodies of a contact, or of both half passes, overlapped unseen by it.
local function unseen(run, contact)
  local name = contact:gsub("%.master$", "")
  return lists.any({ "obstacle_inside", "unseen_overlap" }, function(code)
    local subject = ("model.warning.%s %s "):format(code, name)
    return lists.any(run.state_findings, function(found) return found.subject:sub(1, #subject) == subject end)
  end)
end

-- Depth relative to the smallest body's size above which points of mortar contact are in the master.
local unseen_depth = 1e-6

--- True if a contact is a set of faces (among).
local function is_set(model, contact) return rawget(model:contact_resultant(contact), "fx") == nil end

--- A sentence for an active contact that never touched in the rows of a run, with the smallest gap at its end. A set of
--- faces and the contacts that belong to it, with obstacles and of pairs, guard what may touch: one sentence for all of
--- them, if none did.
local function untouched(run, model, contact)
  if not model:contact_law(contact).active or ever_acts(run, model, contact) then return nil end
  local owner = contact:match "^[^.]+"
  if is_set(model, owner) then
    local acts = lists.any(model:contact_names(), function(name)
      return name:match "^[^.]+" == owner and ever_acts(run, model, name)
    end)
    return contact == owner and not acts and ("contact '%s' never touched"):format(contact) or nil
  end
  if unseen(run, contact) then return nil end
  local least = math.huge
  for _, gap in ipairs(model:profile(contact).gap) do
    if gap < least then least = gap end -- false for nan, where the master is not opposite
  end
  if least < -unseen_depth * core.smallest_body(model) then
    return ("contact '%s' has transmitted no force, although points of its slave face lie up to %.3g in the master: "
      .. "the means of its gaps over functions of the slave face are open. Hint: use smaller elements of the slave "
      .. "face there"):format(contact, -least)
  end
  local text = ("contact '%s' never touched; smallest gap %s"):format(contact,
    least < math.huge and ("%.4g"):format(least) or "unknown, because no point has a foot point on the master")
  if run.cutbacks + run.fallback_steps == 0 then return text end
  return text .. ". Attempts failed before steps were reached: bodies that pass through each other in one step also "
    .. "end apart. Hint: look at model:show{}; a shorter path, or more steps"
end

-- Above this overlap, as a fraction of the size of the smallest body, contact that is switched on deforms it suddenly.
local deep = 0.02

--- Sentences on contacts that a stage switches on where their faces overlap, so that they are pushed apart at once.
function run_warnings.overlaps(model, stage)
  local texts = {}
  for _, found in ipairs(contact_changes.switched_on(model, stage)) do
    local size, body = core.smallest_body(model)
    if found.depth > deep * size then
      texts[#texts + 1] = ("contact '%s' is switched on by stage '%s' where its faces overlap by %.3g, %.2g %% of the "
        .. "size of body '%s', and pushes them apart at once. Hint: switch it on before the bodies meet; an overlap of "
        .. "the shapes that is meant needs overlap = \"interference\" in sg.model"):format(found.name, stage.name,
        found.depth, 100 * found.depth / size, body)
    end
  end
  return texts
end

-- Above this difference of the forces of two half passes, as a fraction of the largest force of the run, neither is
-- near the force of contact.
local unbalanced_share = 0.1

--- Magnitude of the sum of the forces of some contacts at a row of a run.
local function resultant(run, contacts, row)
  local squares = 0
  for _, axis in ipairs { ".fx", ".fy", ".fz" } do
    local sum = 0
    for _, contact in ipairs(contacts) do
      local column = run.values[contact .. axis] -- no fz in the plane
      sum = sum + (column and column[row] or 0)
    end
    squares = squares + sum ^ 2
  end
  return math.sqrt(squares)
end

--- A sentence for two half passes whose forces differ at some row of a run; `contact` is the first of them.
local function unbalanced(run, model, contact)
  local other = contact .. ".master"
  if not (rawget(model:contact_resultant(contact), "imbalance") and run.values[other .. ".fx"]) then return nil end
  local largest, most, at = 0, 0, nil
  for row = 1, run.rows do
    largest = math.max(largest, resultant(run, { contact }, row), resultant(run, { other }, row))
    local difference = resultant(run, { contact, other }, row)
    if difference > most then most, at = difference, row end
  end
  if most <= unbalanced_share * largest then return nil end
  return ("contact '%s': the forces of its half passes differ by %.2g %% of the largest force, in step %s. Hint: "
    .. "smaller elements on both faces; with multipliers also a lower penalty"):format(contact, 100 * most / largest,
    run.values.step[at])
end

local loose_tolerance = 1e-3 -- relative to the forces of the run

local warned = setmetatable({}, { __mode = "k" }) -- models that have been warned about

--- A sentence, once for each model, for loads that act from the first step on because no stage changes them.
local function constant_loads(model, path)
  if warned[model] then return nil end
  warned[model] = true
  local names = lists.map(stages.constant_loads(model, path), function(load) return ("'%s'"):format(load) end)
  if #names == 0 then return nil end
  return ("no stage changes the load%s %s, which act%s in full from the first step on. Hint: to apply a load in steps, "
    .. "give its value to a stage and 0 to sg.model (of a function: factor = 0)"):format(#names == 1 and "" or "s",
    table.concat(names, ", "), #names == 1 and "s" or "")
end

--- Warnings about a path before it is followed.
function run_warnings.of_path(model, path, solver)
  local texts = { constant_loads(model, path) }
  if solver.tolerance > loose_tolerance then
    texts[#texts + 1] = ("newton.tolerance = %g: steps count as converged with unbalanced forces of this fraction of "
      .. "the run's forces, expected at most %g. Hint: the default is 1e-10"):format(solver.tolerance, loose_tolerance)
  end
  if core.ranks > 1 and solver.linear ~= "mumps" then
    texts[#texts + 1] = ("linear = \"%s\" uses one of the %d processes that mpirun has started. Hint: linear = "
      .. "\"mumps\" shares factorizations among them"):format(solver.linear, core.ranks)
  end
  for _, stage in ipairs(path) do texts = lists.joined(texts, stage.jumps) end
  return lists.joined(texts, contact_changes.warnings(model, path))
end

--- "1, 2"
local function position(point)
  return table.concat(lists.map(point, function(x) return ("%.4g"):format(x) end), ", ")
end

--- A sentence for a contact with projections that ended at their limit of iterations.
local function unsettled(run, contact)
  local found = run.unsettled[contact]
  if not found then return nil end
  return ("contact '%s': the search for a closest point or slip point ended at a limit of iterations %s in accepted "
    .. "states, the last time at X = (%s): gap and friction are approximate there. Hint: refine or rebuild the master "
    .. "where its parametrization is singular or very uneven; otherwise take shorter steps"):format(contact,
      counted(found.count, "time"), position(found.at))
end

local flaws = {
  jumps = "friction jumps where a point begins to slip, since mu falls faster with the slip of a step than the "
    .. "tangential penalty can follow: results depend on the steps. Hint: raise friction.penalty, or let mu fall over "
    .. "a longer slip",
  negative = "the formula of mu is negative, which counts as 0. Hint: cut it off with sg.max(0, …)",
  undefined = "the formula of friction.mu is not a finite number. Hint: let it be finite at every pressure and slip",
  ["undefined wear"] = "the formula of wear.rate is not a finite number. Hint: let it be finite at every pressure and "
    .. "slip",
  ["negative wear"] = "the formula of wear.rate is negative, which counts as 0. Hint: cut it off with sg.max(0, …)",
}

--- A sentence for a contact whose formula of friction or wear is negative somewhere, or falls faster than its springs.
local function flawed(run, contact)
  local found = run.flawed[contact]
  if not found then return nil end
  return ("contact '%s': %s (%s in accepted states, the last time at X = (%s))"):format(contact, flaws[found.flaw],
    counted(found.count, "time"), position(found.at))
end

-- The product of rate of wear, slip of a step and stiffness of a contact above which explicit wear is unstable.
local most_explicit_wear = 2

--- Notes in run.unstable_wear, by contact, the first accepted step in which explicit wear is unstable.
function run_warnings.note_wear(run, model)
  for _, contact in ipairs(model:contact_names()) do
    local product = core.explicit_wear(model, contact) -- nil of an object that imitates a model
    if product and product > most_explicit_wear and not run.unstable_wear[contact] then
      run.unstable_wear[contact] = { step = run.steps, product = product }
    end
  end
end

--- A sentence for a contact whose explicit wear is unstable.
local function unstable_wear(run, contact)
  local found = run.unstable_wear[contact]
  if not found then return nil end
  return ("contact '%s': wear.update = \"explicit\" is unstable from step %d on, where rate × slip of the step × "
    .. "stiffness of the contact is %.3g, more than %d: pressures oscillate from step to step. Hint: take shorter "
    .. "steps, or write update = \"implicit\""):format(contact, found.step, found.product, most_explicit_wear)
end

--- Notes in run.unstable_law the first accepted step in which the law of a body, made from an energy, is unstable.
function run_warnings.note_law(run, model)
  if run.unstable_law then return end
  local found = core.unstable_law(model)
  if not found then return end
  found.step = run.steps
  run.unstable_law = found
end

--- A sentence for a law that is unstable at a strain of the run.
local function unstable_law(run)
  local found = run.unstable_law
  if not found then return nil end
  return ("body '%s': its elastic law is unstable at strains of step %d: with principal stretches %s at X = (%s) a "
    .. "further strain lowers the stress that resists it (Drucker, Hill). Hint: solutions may be not unique, fit the "
    .. "law to tests up to these stretches"):format(found.body, found.step, position(found.stretches),
    position(found.at))
end

-- Iterations of a run per examination of everything about a state, which takes about as long as two, of solids 5 to 14:
-- it is made at the end of a stage if this many belong to each of those so far, at the first stages, and where a run
-- ends. In between states are kept, and examined if something is found later.
local per_examination, first_examined = 100, 3

--- Appends to run.state_findings what is found about a state; of each subject the first. Where it is found in a state
--- after others that were not examined, it may have begun there.
local function note_findings(run, model, state, everything)
  local unexamined = run.unexamined
  for _, found in ipairs(core.state_warnings(model, everything) or {}) do
    if not lists.any(run.state_findings, function(earlier) return earlier.subject == found.subject end) then
      run.state_findings[#run.state_findings + 1] = lists.merged(found, state)
      unexamined.before[found.subject] = everything and unexamined.states
    end
  end
end

--- Notes the warnings about the state at the end of a stage, or where the run ends before; `last`: the run ends here.
function run_warnings.note_state(run, model, stage, last)
  if run.reason == "interrupted" or run.rows == 0 then return end
  local began, unexamined = core.now(), run.unexamined
  local done = run.stages[#run.stages].steps
  local place = (done < stage.steps and "in stage '%s', after step %d" or "at the end of stage '%s'"):format(stage.name,
    run.steps)
  local state = { place = place, from = run.steps - done, to = run.steps }
  local everything = last or run.examined < first_examined or run.examined * per_examination <= run.iterations
  note_findings(run, model, state, everything)
  if everything then
    run.examined, unexamined.states = run.examined + 1, {}
  else
    state.snapshot, state.adaptations = model:snapshot(), #run.adaptations
    unexamined.states[#unexamined.states + 1] = state
  end
  run:account("wall", core.now() - began)
end

local function is_unstable(finding) return finding.subject:find("model.warning.unstable", 1, true) == 1 end

--- The first of some states of a path in which something is found again, by bisection, and what is found there.
local function first_with(model, states, finding)
  local function again(found)
    return found.subject == finding.subject or is_unstable(found) and is_unstable(finding)
  end
  if #states == 0 then return nil end
  local last, without, with, first = model:snapshot(), 0, #states + 1, nil
  while with - without > 1 do
    local middle = (without + with) // 2
    model:restore(states[middle].snapshot)
    local found = lists.filter(core.state_warnings(model, true) or {}, again)[1]
    if found then with, first = middle, found else without = middle end
  end
  model:restore(last)
  return states[with], first
end

--- A sentence on something found in a state: where it is found first, of states that were kept. Of an unstable one that
--- is also a step, if states within the stage were stored.
local function sentence(run, model, finding)
  local kept = lists.filter(run.unexamined.before[finding.subject] or {}, function(state)
    return state.adaptations == #run.adaptations
  end)
  local state, first = first_with(model, kept, finding)
  if first then finding = lists.merged(state, first) end
  local between = lists.filter(#run.adaptations == 0 and is_unstable(finding) and run.stored_states or {},
    function(stored) return stored.step > finding.from and stored.step < finding.to end)
  local stored = first_with(model, between, finding)
  local from = #between > 0 and (", from step %d on"):format(stored and stored.step or finding.to) or ""
  return ("%s%s: %s"):format(finding.place, from, finding.text)
end

local function states(run, model)
  return lists.map(run.state_findings, function(finding) return sentence(run, model, finding) end)
end

local function rubs(model, contact)
  local law = model:contact_law(contact)
  return law.mu_formula ~= nil or (law.mu or law.mu1 or 0) > 0
end

local function sticks(model)
  return lists.any(model:contact_names(), function(contact)
    local now = model:contact_resultant(contact)
    return rubs(model, contact) and now.active > now.slipping
  end)
end

local function has_friction(model)
  return lists.any(model:contact_names(), function(contact) return rubs(model, contact) end)
end

--- A sentence for a last step whose equilibrium is not unique, so that damping has selected one. Where points stick,
--- the body has landed in the step, and friction determines its position. An obstacle without friction has landed if
--- the stiffness of its contacts holds it; the stiffness of bodies along a contact is an error of discretization.
local function held(run, model)
  local attempts = run.histories[#run.histories] or {}
  local last = attempts[#attempts]
  if not (last and last.converged and last.fallback == "damping") or sticks(model) then return nil end
  local moves_body = lists.any(model:unconstrained_bodies(), function(name)
    return lists.holds(model:body_names(), name)
  end)
  if not moves_body and not has_friction(model) and not core.weak_hold(model) then return nil end
  return ("damping alone determines the position in step %d: %s. Hint: add a support, unless contact is to hold it "
    .. "later"):format(run.steps, run.singular or "its tangent is singular")
end

-- Above this rounding error, as a fraction of the forces of the run, forces may be wrong in their first digits.
local coarse_rounding = 1e-3

--- A sentence for loads or contact whose forces are not far above rounding errors, up to which equilibrium is found,
--- and for reactions of deformed bodies that do not balance because of them.
local function lost_in_rounding(model)
  local rounding, forces, acts, residual = core.rounding(model)
  if not forces then return nil end -- of an object that imitates a model
  local cause = "equilibrium is not found more exactly than that. Hint: very narrow elements, very stiff bodies or "
    .. "springs and places far from the origin cause them"
  if acts and rounding > coarse_rounding * forces then
    return ("rounding errors of forces, about %.2g, are %.2g %% of the forces of supports, loads and contacts, at most "
      .. "%.2g, and %s"):format(rounding, 100 * rounding / forces, forces, cause)
  end
  if residual <= coarse_rounding * forces or not core.is_deformed(model) then return nil end
  return ("reactions balance only to %.2g, %.2g %% of the forces of supports and loads, at most %.2g: because of "
    .. "rounding errors %s"):format(residual, 100 * residual / forces, forces, cause)
end

--- The warnings of a run; those of model:warnings() and about the path come first.
function run_warnings.of_run(run, model, early)
  local texts, differing = lists.joined(model:warnings(), early), nil
  for _, contact in ipairs(run.rows > 0 and model:contact_names() or {}) do
    texts[#texts + 1] = untouched(run, model, contact)
    texts[#texts + 1] = unsettled(run, contact)
    texts[#texts + 1] = flawed(run, contact)
    texts[#texts + 1] = unstable_wear(run, contact)
    local text = unbalanced(run, model, contact)
    texts[#texts + 1] = text
    if text then differing = differing or contact end
  end
  texts = lists.joined(texts, run.overlaps)
  texts = lists.joined(texts, states(run, model))
  texts[#texts + 1] = lost_in_rounding(model)
  texts[#texts + 1] = held(run, model) or not run.failed and core.weak_hold(model) or nil
  texts[#texts + 1] = controls.warning(run)
  texts[#texts + 1] = unstable_law(run)
  texts[#texts + 1] = jumps.warning(run.jumps, run.used.arc_length, controls.arc_options(run.histories))
  texts[#texts + 1] = energy_balance.warning(run, run.energies, differing)
  return texts
end

--- Prints the warnings of a run, except those of sg.model.
function run_warnings.show(run, display)
  for _, warning in ipairs(run.warnings) do
    if not lists.holds(run.model:warnings(), warning) then display:line(warning) end
  end
end

return run_warnings
