-- Whether the work of a run is found again in its energies, stage by stage. With steps that are too long it is not:
-- work is summed by the trapezoidal rule, and slip is measured at the end of a step. What is missing falls linearly
-- with the length of the steps, or faster.

local drives = require "signorini.drives"
local lists = require "signorini.lists"
local path_controls = require "signorini.path_controls"

local energy_balance = {}

local much = 0.1 -- of the work: missing energy that is worth a warning

--- Adds what a model holds and has been given so far to a list, as plain numbers. `sudden`: a load acts in full from
--- the next step on, so that no path exists along which its work could be summed.
function energy_balance.note(list, model, sudden)
  list[#list + 1] = lists.merged(model:energy(), { sudden = sudden })
end

--- Whether a load acts at the start of a path that its first stage does not drive.
function energy_balance.is_sudden(model, stage)
  return #drives.constant_loads(model, { stage }) > 0
end

--- Whether a state was reached otherwise than along the path: by a fall that damping has caught, or on another branch.
local function jumps(histories)
  return #path_controls.departures(histories) > 0 or path_controls.counts(histories).damping ~= nil
end

--- Whether contact has acted: without it work and stored energy may both be rounding errors, as of a motion without
--- stress.
local function acts(list)
  return lists.any(list, function(state) return state.contact ~= 0 or state.friction ~= 0 end)
end

--- A sentence on the stage in which most energy is missing; nothing where that is little. `list`: what was noted at the
--- start of each stage, and at the end. Not counted are the energy in the springs of the contacts, since tractions per
--- current area do work ½ ε g² ȧ that no spring stores, and stages with jumps.
function energy_balance.warning(run, list)
  local work, worst, first = 0, nil, 1
  for i, stage in ipairs(run.stages) do
    local a, b = list[i], list[i + 1]
    if not b then return nil end -- the run was taken up from a file without these
    local done, stored, friction = b.work - a.work, b.stored - a.stored, b.friction - a.friction
    local missing = math.abs(done - stored - friction - (b.contact - a.contact))
                    - math.max(math.abs(a.contact), math.abs(b.contact))
    local last = first + stage.steps - 1
    local histories = table.move(run.histories, first, last, 1, {})
    work = work + math.max(math.abs(done), math.abs(stored), friction)
    if not a.sudden and last >= first and missing > (worst and worst.missing or 0)
      and not jumps(histories) then
      worst = { missing = missing, stage = stage, increments = #path_controls.accepted(histories) }
    end
    first = last + 1
  end
  if not worst or worst.missing <= much * work or not acts(list) then return nil end
  return ("the energy balance is off by %.2g %% of the work in stage '%s': increments half as long (steps = %d) would "
    .. "about halve that"):format(100 * worst.missing / work, worst.stage.name, 2 * worst.increments)
end

return energy_balance
