-- Contacts of which no point was ever active in a run: the wrong face, or a body beside the other.

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
return function(run, model)
  local texts = {}
  for _, contact in ipairs(run.rows > 0 and model:contact_names() or {}) do
    if not ever_acts(run, contact) then
      local least = math.huge
      for _, gap in ipairs(model:profile(contact).gap) do
        if gap < least then least = gap end -- not so where the master is not opposite: there it is nan
      end
      texts[#texts + 1] = ("contact '%s' never touched; least gap %s"):format(contact,
        least < math.huge and ("%.4g"):format(least) or "unknown: the master is opposite to no point")
    end
  end
  return texts
end
