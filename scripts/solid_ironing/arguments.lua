-- The arguments of block and cylinder ironing: key=value, checked against the defaults of a variant.

local arguments = {}

local function reject(name, expected, got) error(("%s must be %s, got '%s'"):format(name, expected, got), 0) end

function arguments.split(text)
  local parts = {}
  for part in text:gmatch "[^,]+" do parts[#parts + 1] = part end
  return parts
end

--- A whole number of at least 1.
function arguments.count(name, text)
  local number = math.tointeger(tonumber(text))
  if not number or number < 1 then reject(name, "a whole number of at least 1", text) end
  return number
end

--- The elements of a mesh such as "4x4x4/8x4x4": { name, die = {4, 4, 4}, slab = {8, 4, 4} }.
function arguments.mesh(text)
  local counts = {}
  for i, part in ipairs { text:match "^(%d+)x(%d+)x(%d+)/(%d+)x(%d+)x(%d+)$" } do counts[i] = math.tointeger(part) end
  if #counts ~= 6 or math.min(table.unpack(counts)) < 1 then
    reject("mesh", "elements of die and slab per direction such as 4x4x4/8x4x4", text)
  end
  return { name = text, die = { table.unpack(counts, 1, 3) }, slab = { table.unpack(counts, 4, 6) } }
end

--- Reads words such as labels=N2,N4 into texts by name. `defaults`: by variant, the first of `variants` is the default;
--- arguments that a variant does not have are errors that list those it has. Returns the texts and the variant.
function arguments.read(words, variants, defaults)
  local given = {}
  for _, word in ipairs(words) do
    local key, value = word:match "^(%w+)=(.+)$"
    if not key then error(("unknown argument '%s'; arguments look like labels=N2"):format(word), 0) end
    given[key] = value
  end
  local variant = given.variant or variants[1]
  if not defaults[variant] then reject("variant", table.concat(variants, " or "), variant) end
  given.variant = nil
  local known = {}
  for key, value in pairs(defaults[variant]) do known[#known + 1] = key .. "=" .. value end
  table.sort(known)
  for key, value in pairs(given) do
    if not defaults[variant][key] then
      error(("unknown argument '%s=%s'; known%s: %s"):format(key, value,
        #variants > 1 and (" with variant=%s"):format(variant) or "", table.concat(known, ", ")), 0)
    end
  end
  return setmetatable(given, { __index = defaults[variant] }), variant
end

return arguments
