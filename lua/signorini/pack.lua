-- Values as text and back, exactly: what jobs in processes of their own hand over (core.jobs). Numbers, strings, true,
-- false, and tables of these without cycles.

local pack = {}

local function text(value)
  if type(value) ~= "table" then return ("%q"):format(value) end
  local parts = {}
  for key, entry in pairs(value) do parts[#parts + 1] = ("[%q]=%s"):format(key, text(entry)) end
  return "{" .. table.concat(parts, ",") .. "}"
end

pack.text = text

--- The value of a text that pack.text made.
function pack.value(packed) return load("return " .. packed, "=packed", "t", {})() end

return pack
