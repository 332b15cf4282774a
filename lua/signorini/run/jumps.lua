-- Steps that have probably jumped to another branch of equilibria although they converged, as over the snap-back of a
-- peeled strip: displacements are several times as large as in the neighboring steps, and energy is missing from the
-- balance. On a smooth path the missing energy is O(Δ³) in the step length Δ. This needs only the energies and the
-- length of each step: no factorization, no further step.

local energy_balance = require "signorini.run.energy_balance"
local lists = require "signorini.call.lists"

local jumps = {}

local longer = 2.5   -- times the displacement of the neighboring steps
local far_above = 20 -- times the missing energy of these
local least = 0.01   -- of the step's work
local neighbors = 2 -- steps on either side

--- Data that a run carries along: `steps`, the last ones of the present stage; `found`.
function jumps.record() return { steps = {}, found = {} } end

--- Checks the entry with this index among the last steps.
local function judge(record, index)
  local entry, length, missing, count = record.steps[index], 0, 0, 0
  for i = math.max(1, index - neighbors), math.min(#record.steps, index + neighbors) do
    local other = record.steps[i]
    if i ~= index then
      length, missing, count = math.max(length, other.length), math.max(missing, math.abs(other.missing)), count + 1
    end
  end
  if index > 1 and count >= neighbors and entry.length > longer * length and entry.missing > far_above * missing
    and entry.missing > least * entry.work then
    record.found[#record.found + 1] = { step = entry.step, times = entry.length / length,
                                        part = entry.missing / entry.work }
  end
end

--- Ends the sequence of neighboring steps: a stage ends, or arc-length control begins.
function jumps.close(record)
  for index = math.max(1, #record.steps - neighbors + 1), #record.steps do judge(record, index) end
  record.steps, record.energy = {}, nil
end

--- Begins a stage.
function jumps.begin(record, model)
  jumps.close(record)
  record.energy = model:energy()
end

--- Adds an accepted step and the length of its displacement (see model:last_length), nil after arc-length increments.
function jumps.note(record, model, step, length)
  if not length or not record.energy then return jumps.begin(record, model) end
  local now, before, steps = model:energy(), record.energy, record.steps
  record.energy = now
  local work = now.work - before.work
  steps[#steps + 1] = {
    step = step, length = length, work = math.abs(work),
    missing = energy_balance.missing(before, now),
  }
  if #steps <= neighbors then return end
  judge(record, #steps - neighbors)
  if #steps > 2 * neighbors then table.remove(steps, 1) end
end

--- A sentence on the steps that were found. `arc_length`: it is on, but is used only where a step fails; `options`:
--- those that follow the path.
function jumps.warning(record, arc_length, options)
  local found = record.found
  if #found == 0 then return nil end
  local most = lists.least(found, function(entry) return -entry.part end)
  local others = lists.map(lists.filter(found, function(entry) return entry ~= most end), function(entry)
    return tostring(entry.step)
  end)
  local more = #others - 4
  others = { table.unpack(others, 1, 4) }
  local rest = #others == 0 and "" or ("; likewise %s %s%s"):format(#others == 1 and "step" or "steps",
    table.concat(others, ", "), more > 0 and (" and %d more"):format(more) or "")
  return ("step %d has probably jumped to another branch of solutions: its displacements are %.2g times those of "
    .. "neighboring steps, and %.2g %% of its work was released%s. Hint: %s"):format(most.step, most.times,
    100 * most.part, rest, arc_length and "arc length is used only where a step fails; take shorter steps"
      or "follow the path with " .. options)
end

return jumps
