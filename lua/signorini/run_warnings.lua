-- What a run may be wrong in although it completed: what sg.model said of the scene, contacts of which no point was
-- ever active (the wrong face, or a body that misses the other), and contacts that are penetrated too deeply.

--- Whether something was transmitted at a row of the run: under adhesion a force, wherever the bodies are.
local function acts(run, contact, row)
  for _, key in ipairs { "area", "fx", "fy", "fz" } do
    local values = run.values[contact .. "." .. key]
    if values and values[row] ~= 0 then return true end
  end
  return false
end

local function ever_acts(run, contact)
  for row = 1, run.rows do
    if acts(run, contact, row) then return true end
  end
  return false
end

--- A sentence for each contact of the model that never touched in the rows of a run, with the least gap at its end.
local function untouched(run, model, contact)
  if ever_acts(run, contact) then return nil end
  local least = math.huge
  for _, gap in ipairs(model:profile(contact).gap) do
    if gap < least then least = gap end -- not so where the master is not opposite: there it is nan
  end
  return ("contact '%s' never touched; least gap %s"):format(contact,
    least < math.huge and ("%.4g"):format(least) or "unknown: the master is opposite to no point")
end

--- The largest extent, along an axis, of the smallest body.
local function smallest_size(model)
  local smallest, name = math.huge, nil
  for _, body in ipairs(model:body_names()) do
    local low, high, size = {}, {}, 0
    for _, point in ipairs(model:body(body):points()) do
      for axis, x in ipairs(point) do
        low[axis], high[axis] = math.min(low[axis] or x, x), math.max(high[axis] or x, x)
        size = math.max(size, high[axis] - low[axis])
      end
    end
    if size < smallest then smallest, name = size, body end
  end
  return smallest, name
end

-- Where points sink in by more than this part of the smallest body the penalty is no longer a detail of the method.
local deep = 0.02

--- A sentence for a contact that was penetrated deeply at some row of a run.
local function penetrated(run, model, contact)
  local most, at = 0, nil
  for row, depth in ipairs(run.values[contact .. ".max_penetration"] or {}) do
    if depth > most then most, at = depth, row end
  end
  local size, body = smallest_size(model)
  if most <= deep * size then return nil end
  return ("contact '%s' is penetrated by %.3g in step %s, %.2g %% of the size of body '%s': a higher penalty "
    .. "lets less in"):format(contact, most, run.values.step[at], 100 * most / size, body)
end

--- What a run warns of, in sentences; those of model:warnings() come first.
return function(run, model)
  local texts = model:warnings()
  for _, contact in ipairs(run.rows > 0 and model:contact_names() or {}) do
    texts[#texts + 1] = untouched(run, model, contact) or penetrated(run, model, contact)
  end
  return texts
end
