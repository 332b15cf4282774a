-- Energy balance of a run, stage by stage: external work against stored and dissipated energies. With steps that are
-- too long the balance is not met, because work is summed by the trapezoidal rule and slip is measured at the end of a
-- step; the error is O(Δ) in the step length Δ, or smaller.

local contact_changes = require "signorini.run.contact_changes"
local lists = require "signorini.call.lists"
local controls = require "signorini.run.controls"
local stages = require "signorini.run.stages"

local energy_balance = {}

local much = 0.1 -- of the work: missing energy that causes a warning

--- Appends the present energies and work of a model to a list, as plain numbers. `sudden`: the next step begins with a
--- sudden change, such as a load that acts in full, so that its work cannot be summed along a path.
function energy_balance.note(list, model, sudden)
  list[#list + 1] = lists.merged(model:energy(), { sudden = sudden })
end

--- True if a stage begins with a sudden change: a load that acts from the start of a path, of which this is the first
--- stage and does not drive it, an offset of sg.model, or constants of contacts.
function energy_balance.is_sudden(model, stage, is_first)
  local is_loaded = is_first and (#stages.constant_loads(model, { stage }) > 0
    or contact_changes.presses_at_once(model))
  return is_loaded or contact_changes.is_sudden(model, stage)
end

--- True if states were not reached along the path: after damped motion, or on another branch.
local function jumps(histories)
  return #controls.departures(histories) > 0 or controls.counts(histories).damping ~= nil
end

--- True if contact has acted: without it, work and stored energy can both be rounding errors, as in a rigid motion.
local function acts(list)
  return lists.any(list, function(state)
    return state.contact ~= 0 or state.friction ~= 0 or state.debonding ~= 0 or state.wear ~= 0
  end)
end

--- What is missing in the balance between two states of a path, positive if energy is lost. Tractions do not do the
--- work ∫∫ φ dA of a growing area (φ: energy of the springs per area, see theory.md): area_growth is added.
function energy_balance.missing(before, after)
  local function change(name) return (after[name] or 0) - (before[name] or 0) end -- files of old runs lack some
  return change "work" + change "area_growth" - change "stored" - change "contact" - change "friction"
    - change "debonding" - change "wear" - change "viscous"
end

--- The contact whose bonds lose most energy within one step of some steps of a run, the energy, and its law; nil
--- without bonds.
local function broken_at_once(run, first, last)
  local most, contact, law = 0, nil, nil
  for _, name in ipairs(run.model:contact_names()) do
    local debonded, before = run.values[name .. ".debonded"], 0
    local own = debonded and run.model:contact_law(name)
    for row = 1, debonded and run.rows or 0 do
      local step, lost = math.ceil(run.step_column[row]), (debonded[row] - before) * own.energy
      if step >= first and step <= last and lost > most then most, contact, law = lost, name, own end
      before = debonded[row]
    end
  end
  return contact, most, law
end

--- A hint for a stage in which bonds break within one step: further halving halves nothing before they take several.
local function bond_hint(run, worst)
  local contact, lost, law = broken_at_once(run, worst.first, worst.last)
  if not contact or lost < worst.missing / 2 then return nil end
  return ("bonds of contact '%s' break within one step; take increments in which they open by at most %.2g, a third of "
    .. "energy/strength, or follow a snap-back with arc_length = true"):format(contact, law.energy / law.strength / 3)
end

--- A sentence on the stage with the largest missing energy; nil if that is small. `list`: energies at the start of each
--- stage and at the end; `unbalanced`: a contact whose half passes differ, if any. Not counted are the energy in the
--- springs of the contacts, because with friction penetrating points travel another distance than their slip points,
--- and stages with jumps.
function energy_balance.warning(run, list, unbalanced)
  local work, worst, first = 0, nil, 1
  for i, stage in ipairs(run.stages) do
    local a, b = list[i], list[i + 1]
    if not b then return nil end -- resumed from a file without these
    local done, stored = b.work - a.work, b.stored - a.stored
    local dissipated = b.friction - a.friction + b.debonding - a.debonding + b.wear - a.wear
      + (b.viscous or 0) - (a.viscous or 0)
    local missing = math.abs(energy_balance.missing(a, b)) - math.max(math.abs(a.contact), math.abs(b.contact))
    local last = first + stage.steps - 1
    local histories = table.move(run.histories, first, last, 1, {})
    work = work + math.max(math.abs(done), math.abs(stored), dissipated)
    if not a.sudden and last >= first and missing > (worst and worst.missing or 0)
      and not jumps(histories) then
      worst = { missing = missing, stage = stage, increments = #controls.accepted(histories), first = first,
                last = last }
    end
    first = last + 1
  end
  if not worst or worst.missing <= much * work or not acts(list) then return nil end
  local hint = ("increments half as long (steps = %d) about halve the error"):format(2 * worst.increments)
  if unbalanced then
    hint = ("the half passes of contact '%s' do different work at any increments; use smaller elements on both "
      .. "faces"):format(unbalanced)
  end
  return ("the energy balance is off by %.2g %% of the work in stage '%s'. Hint: %s"):format(100 * worst.missing / work,
    worst.stage.name, bond_hint(run, worst) or hint)
end

return energy_balance
