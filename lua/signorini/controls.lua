-- What is tried where a step fails, and sg.robust and sg.plain, which write out the controls of a run.

local lists = require "signorini.lists"
local rows = require "signorini.pages.step_rows"

local controls = {}

--- What may be tried, in turn, where an attempt at a step has failed: names as they appear in records, and the solver's
--- arguments that differ from those of the attempt that failed. `loose`: of use only where bodies are held by contact
--- alone. `early`: tried before a step is cut, always or for that reason. The others are tried only where it cannot be
--- cut any more: what they converge to on a long step may be another equilibrium than the one that the path leads to.
local rescues = {
  { name = "tangent", change = { predictor = "tangent" }, early = true },
  { name = "damping", change = { predictor = "tangent", damping = true }, loose = true, early = "singular" },
  { name = "line search", change = { predictor = "tangent", line_search = "residual", pseudo_transient = false } },
  { name = "pseudo-transient",
    change = { predictor = "tangent", line_search = "none", pseudo_transient = true } },
  { name = "frozen", change = { predictor = "tangent", freeze_active_set = 1e-2 } },
}

--- Whether what a control converges to is the equilibrium that the path leads to, as far as that can be told.
function controls.keeps_branch(name)
  return lists.any(rescues, function(rescue) return rescue.name == name and rescue.early ~= nil end)
end

--- A solver's arguments with some of them changed, and whether that makes a difference.
function controls.changed(solver, change)
  local differs = false
  for key, value in pairs(change) do differs = differs or solver[key] ~= value end
  return lists.merged(solver, change), differs
end

--- What is tried where the solver fails, a list of { name, solver, early } that is also a table by name.
function controls.rescues(model, solver)
  local tries, loose = {}, #model:contact_names() > 0 and #model:loose_bodies() > 0
  for _, rescue in ipairs(rescues) do
    local changed, differs = controls.changed(solver, rescue.change)
    if differs and (loose or not rescue.loose) then
      tries[rescue.name] = { name = rescue.name, solver = changed, early = rescue.early }
      tries[#tries + 1] = tries[rescue.name]
    end
  end
  return tries
end

function controls.robust(options) return lists.merged(rows.robust, options) end
function controls.plain(options) return lists.merged(rows.plain, options) end

return controls
