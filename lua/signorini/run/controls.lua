-- The controls of a run: fallbacks that are tried when a step fails; what its attempts tell about them; sg.robust and
-- sg.plain, which return options.

local counted = require("signorini.call.text").counted
local lists = require "signorini.call.lists"
local rows = require "signorini.pages.step_rows"

local controls = {}

-- ── Fallbacks ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The fallbacks in the order in which they are tried after a failed attempt: the name in records, and the solver
--- arguments that differ from those of the failed attempt. `unconstrained`: only for unconstrained bodies. `early`:
--- tried before a step is cut, always or for that reason. The others are tried only where the step cannot be cut any
--- more, because on a long step they may converge to an equilibrium on another branch. `keeps`: they do not leave it.
local fallbacks = {
  { name = "tangent", change = { predictor = "tangent" }, early = true, keeps = true },
  { name = "damping", change = { predictor = "tangent", damping = true, line_search = "none" }, unconstrained = true,
    early = "singular", keeps = true },
  { name = "line search", change = { predictor = "tangent", line_search = "residual", pseudo_transient = false } },
  { name = "pseudo-transient", change = { predictor = "tangent", line_search = "none", pseudo_transient = true } },
  { name = "frozen", change = { predictor = "tangent", freeze_active_set = 1e-2 } },
}

--- True if a fallback converges to the equilibrium on the followed branch, as far as is known.
function controls.keeps_branch(name)
  return lists.any(fallbacks, function(fallback) return fallback.name == name and fallback.keeps end)
end

--- A solver's arguments with changes, and whether these make a difference.
function controls.changed(solver, change)
  local differs = false
  for key, value in pairs(change) do differs = differs or solver[key] ~= value end
  return lists.merged(solver, change), differs
end

--- The fallbacks for a solver, a list of { name, solver, early } that is also a table by name.
function controls.fallbacks(model, solver)
  local tries, unconstrained = {}, #model:contact_names() > 0 and #model:unconstrained_bodies() > 0
  for _, fallback in ipairs(fallbacks) do
    local changed, differs = controls.changed(solver, fallback.change)
    if differs and (unconstrained or not fallback.unconstrained) then
      tries[fallback.name] = { name = fallback.name, solver = changed, early = fallback.early }
      tries[#tries + 1] = tries[fallback.name]
    end
  end
  return tries
end

--- True if a contact pulls, by adhesion or bonds, so that its traction falls as it opens and the energy along a
--- correction has several minima, or if it has two half passes, where searches take more time than they save.
local function is_not_searched(model)
  return lists.any(model:contact_names(), function(name)
    local law = model:contact_law(name)
    return law.hamaker or law.strength or law.method == "half_passes"
  end)
end

--- The arguments of model:solve_step in a run. Where fallbacks may follow, corrections are shortened by the energy,
--- which ends the alternation of states under friction and costs nothing where a whole correction is accepted; but not
--- where damping or pseudo-time limits them.
function controls.solver(model, options)
  local limited = options.damping or options.pseudo_transient
  local search = options.fallback and not limited and not is_not_searched(model) and "energy" or "none"
  local solver = lists.merged({ line_search = search }, options.newton)
  for _, key in ipairs { "predictor", "linear", "mumps", "damping", "pseudo_transient", "verbose" } do
    solver[key] = options[key]
  end
  return solver
end

-- ── Options ──────────────────────────────────────────────────────────────────────────────────────────────────────────

function controls.robust(options) return lists.merged(rows.robust, options) end
function controls.plain(options) return lists.merged(rows.plain, options) end

-- ── After the run ────────────────────────────────────────────────────────────────────────────────────────────────────

--- The converged attempts of lists of attempts.
function controls.accepted(histories)
  return lists.filter(lists.flat(histories), function(attempt) return attempt.converged end)
end

--- How often each fallback has converged: a table by name.
function controls.counts(histories)
  local counts = {}
  for _, attempt in ipairs(controls.accepted(histories)) do
    local name = attempt.fallback
    if name then counts[name] = (counts[name] or 0) + 1 end
  end
  return counts
end

--- The options that follow the path of a run by arc length: a step that needed damping, because contact did not hold a
--- body yet, needs it there too.
function controls.arc_options(histories)
  return controls.counts(histories).damping and "arc_length = true, damping = true" or "arc_length = true"
end

--- True if a shorter attempt from the same state had failed before: then the rest of the step was solved at once, as
--- the last resort.
local function is_leap(attempts, index)
  local attempt = attempts[index]
  return lists.any(attempts, function(before, i)
    return i < index and not before.converged and not before.arc and before.from == attempt.from
      and before.to < attempt.to
  end)
end

--- Why a converged attempt may have left the branch, in words; nil if there is no reason.
local function departure(attempts, index)
  local attempt = attempts[index]
  if not attempt.converged then return nil end
  local with = attempt.fallback and " with " .. attempt.fallback or ""
  if attempt.restarted then return "the whole step again from its start" .. with end
  if is_leap(attempts, index) then return "the rest of the step in one increment" .. with end
  return attempt.fallback and not controls.keeps_branch(attempt.fallback) and attempt.fallback or nil
end

--- The steps that a fallback has solved which may leave the branch: a list of { step, how }.
function controls.departures(histories)
  return lists.flat(lists.map(histories, function(attempts, step)
    local all = lists.map(attempts, function(_, index) return { step = step, how = departure(attempts, index) } end)
    return lists.filter(all, function(one) return one.how end)
  end))
end

--- Joins texts; of long lists the first ones, and where to `see` the others.
local function in_short(texts, most, comma, see)
  local more = #texts > most and { ("and %d more, see %s"):format(#texts - most, see) } or {}
  return table.concat(lists.joined({ table.unpack(texts, 1, most) }, more), comma)
end

--- A sentence on them; nil if there are none.
function controls.warning(run)
  local found = controls.departures(run.histories)
  if #found == 0 then return nil end
  local texts = lists.map(found, function(one) return ("%s in step %d"):format(one.how, one.step) end)
  return ("fallbacks that may change to another branch of solutions were needed (%s). Hint: compare with more steps, "
    .. "or follow the path with %s"):format(in_short(texts, 4, ", ", "run:attempts(step)"),
      controls.arc_options(run.histories))
end

--- Controls that differ from the defaults, fallbacks and cuts, in one line; nil if there are none.
local function solver_text(run)
  local used, texts, counts = run.used, {}, {}
  if used.predictor ~= rows.robust.predictor then texts[1] = used.predictor .. " predictor" end
  for name, count in pairs(run.fallbacks) do counts[#counts + 1] = ("%s %d"):format(name, count) end
  table.sort(counts)
  if #counts > 0 then texts[#texts + 1] = "fallbacks " .. table.concat(counts, ", ") end
  if not used.fallback then texts[#texts + 1] = "no fallbacks" end
  if run.cutbacks > 0 then texts[#texts + 1] = counted(run.cutbacks, "cut") end
  if not used.adaptive then texts[#texts + 1] = "no cuts" end
  return #texts > 0 and "controls: " .. table.concat(texts, "; ") or nil
end

--- Where the control of the path changed, in words; long lists are shortened.
local function changes_text(changes)
  if #changes == 0 then return nil end
  return "control: " .. in_short(lists.map(changes, function(change)
    return ("%s from %s in step %d (%s)"):format(change.to, change.place, change.step, change.reason)
  end), 6, "; ", "run.controls")
end

--- The lines on controls in the table of a run.
function controls.lines(run)
  local lines = { solver_text(run) }
  lines[#lines + 1] = changes_text(run.controls)
  return lines
end

return controls
