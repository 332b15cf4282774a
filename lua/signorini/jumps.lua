-- Steps that have probably jumped to another branch of equilibria although they converged, as over the snap-back of a
-- peeled strip: displacements go several times as far as in the steps next to them, and energy is released that no
-- account holds. On a smooth path what is missing falls with the third power of the step. Found from the energies and
-- the length of each step alone: no factorization, no further step.

local lists = require "signorini.lists"

local jumps = {}

local longer = 2.5   -- times the displacement of the steps next to it
local far_above = 20 -- times the energy that is missing there
local least = 0.01   -- of the step's work
local neighbors = 2 -- steps on either side that are looked at

--- What a run carries along, as plain data: `steps`, the last ones of the present stage; `found`.
function jumps.record() return { steps = {}, found = {} } end

--- Judges the entry with this index among the last steps.
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

--- The steps so far have no neighbors among those to come: a stage ends, or arcs have taken over.
function jumps.close(record)
  for index = math.max(1, #record.steps - neighbors + 1), #record.steps do judge(record, index) end
  record.steps, record.energy = {}, nil
end

--- Begins a stage.
function jumps.begin(record, model)
  jumps.close(record)
  record.energy = model:energy()
end

--- Notes a step that was reached, and the length of the way to it (see model:last_length): nothing where arcs have led.
function jumps.note(record, model, step, length)
  if not length or not record.energy then return jumps.begin(record, model) end
  local now, before, steps = model:energy(), record.energy, record.steps
  record.energy = now
  local work = now.work - before.work
  steps[#steps + 1] = {
    step = step, length = length, work = math.abs(work),
    missing = work - (now.stored - before.stored) - (now.contact - before.contact) - (now.friction - before.friction),
  }
  if #steps <= neighbors then return end
  judge(record, #steps - neighbors)
  if #steps > 2 * neighbors then table.remove(steps, 1) end
end

--- A sentence on the steps that were found. `arcs`: arc length is on, which takes over where a step fails.
function jumps.warning(record, arcs)
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
  return ("step %d has probably jumped to another branch of solutions: displacements went %.2g times as far as in the "
    .. "steps next to it, and %.2g %% of its work was released%s. Hint: %s"):format(most.step, most.times,
    100 * most.part, rest, arcs and "arcs only take over where a step fails: take shorter steps"
      or "follow the path with arc_length = true")
end

return jumps
