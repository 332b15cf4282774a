-- Parts of the report of a run that has failed, in words.

local failure_texts = {}

--- Numbers in a row.
function failure_texts.joined(values, format)
  local texts = {}
  for i, value in ipairs(values) do texts[i] = format:format(value) end
  return #texts > 0 and table.concat(texts, ", ") or "none"
end

--- The attempts since the last accepted one, in words; nothing when there was only one.
function failure_texts.tried(attempts, done)
  local texts = {}
  for _, attempt in ipairs(attempts) do
    if not attempt.converged and attempt.from == done then
      local how = attempt.rescue and (" with %s"):format(attempt.rescue) or ""
      texts[#texts + 1] = ("%g%s (%s)"):format(attempt.to - done, how, attempt.reason)
    end
  end
  if #texts < 2 then return "" end
  local again = attempts[#attempts].again and " The whole step was tried from its start as well." or ""
  return (" Tried from there, in parts of a step: %s.%s"):format(table.concat(texts, ", "), again)
end

--- Where in the model, in words: "contact point (contact 'interface', element 3) at X = (1, 2): changes its state".
local function place_text(place)
  local coordinates = {}
  for i, value in ipairs(place.X) do coordinates[i] = ("%.6g"):format(value) end
  return ("%s %sof %s '%s' at X = (%s): %s"):format(place.kind,
    place.kind == "contact point" and ("in slave element %d "):format(place.element) or
    ("%d "):format(place.element or place.point),
    place.contact and "contact" or "body", place.contact or place.body, table.concat(coordinates, ", "), place.text)
end

--- The worst places, as a sentence.
function failure_texts.places(places)
  local texts = {}
  for i = 1, math.min(3, #places) do texts[i] = place_text(places[i]) end
  return #texts > 0 and " Worst places: " .. table.concat(texts, "; ") .. "." or ""
end

return failure_texts
