-- Shape of the record of a run in a checkpoint: whether unpacked data can be one. The checksum of a file protects
-- against damage alone.

local function is(kind) return function(value) return type(value) == kind end end
local number, text, flag, data = is "number", is "string", is "boolean", is "table"
local function count(value) return math.type(value) == "integer" and value >= 0 end
local function cell(value) return value == false or type(value) == "number" end
local function maybe(of) return function(value) return value == nil or of(value) end end
local function either(one, other) return function(value) return one(value) or other(value) end end

--- A table whose entries are all of one shape.
local function each(of)
  return function(value)
    if type(value) ~= "table" then return false end
    for _, entry in next, value do
      if not of(entry) then return false end
    end
    return true
  end
end

--- A table with these fields.
local function fields(shapes)
  return function(value)
    if type(value) ~= "table" then return false end
    for key, of in next, shapes do
      if not of(value[key]) then return false end
    end
    return true
  end
end

local attempt = fields { from = number, to = number, converged = flag, reason = text, iterations = count,
                         residuals = each(number), fallback = maybe(text) }
local stage = fields { name = text, steps = count, iterations = count, cutbacks = count, wall = number }

local state = fields {
  path = each(fields { name = text, steps = count, targets = data }), place = fields { stage = count, number = count },
  starts = each(data), fits = each(data), memory = each(either(number, flag)), names = each(text), spent = each(number),
  format = maybe(count),
  record = fields {
    rows = count, steps = count, iterations = count, cutbacks = count, fallback_steps = count, wary = count,
    wall = number, stages = each(stage), energies = each(each(either(number, flag))),
    jumps = fields { energy = maybe(each(number)), found = each(data), steps = each(each(number)) },
    unstable_law = either(flag, data), used = maybe(data), warnings = each(text),
    adaptations = each(data), contact_zones = data, controls = data, fallbacks = data, overlaps = data,
    places = data, unsettled = data,
    state_findings = maybe(each(fields { subject = text, place = text, text = text, from = count, to = count })) },
}

--- True if state, rows and histories can be those of a run.
return function(saved)
  if not data(saved) or not state(saved[1]) or not each(each(cell))(saved[2]) or not each(each(attempt))(saved[3]) then
    return false
  end
  local record, place, path = saved[1].record, saved[1].place, saved[1].path
  for _, row in ipairs(saved[2]) do
    if #row ~= #saved[1].names then return false end
  end
  local begun = record.rows > 0
  return path[place.stage] ~= nil and place.number <= path[place.stage].steps and record.rows == #saved[2]
    and #saved[3] >= record.steps and (not begun or #record.stages == place.stage)
end
