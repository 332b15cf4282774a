-- The fallbacks that are tried when a step fails, and sg.robust and sg.plain, which return the options of a run.

local lists = require "signorini.call.lists"
local rows = require "signorini.pages.step_rows"

local controls = {}

--- The fallbacks in the order in which they are tried after a failed attempt: the name in records, and the solver
--- arguments that differ from those of the failed attempt. `unconstrained`: only for unconstrained bodies. `early`:
--- tried before a step is cut, always or for that reason. The others are tried only where the step cannot be cut any
--- more, because on a long step they may converge to an equilibrium on another branch.
local fallbacks = {
  { name = "tangent", change = { predictor = "tangent" }, early = true },
  { name = "damping", change = { predictor = "tangent", damping = true }, unconstrained = true, early = "singular" },
  { name = "line search", change = { predictor = "tangent", line_search = "residual", pseudo_transient = false } },
  { name = "pseudo-transient",
    change = { predictor = "tangent", line_search = "none", pseudo_transient = true } },
  { name = "frozen", change = { predictor = "tangent", freeze_active_set = 1e-2 } },
}

--- True if a fallback converges to the equilibrium on the followed branch, as far as is known.
function controls.keeps_branch(name)
  return lists.any(fallbacks, function(fallback) return fallback.name == name and fallback.early ~= nil end)
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

function controls.robust(options) return lists.merged(rows.robust, options) end
function controls.plain(options) return lists.merged(rows.plain, options) end

return controls
