-- Random numbers that depend on a seed alone, the same on every machine.

--- A stream of numbers in [0, 1) that depends on the seed alone: SplitMix64 of G. L. Steele and others (2014).
local function stream(seed)
  local state = seed * 0x5851F42D4C957F2D
  return function()
    state = state + 0x9E3779B97F4A7C15
    local z = (state ~ (state >> 30)) * 0xBF58476D1CE4E5B9
    z = (z ~ (z >> 27)) * 0x94D049BB133111EB
    return ((z ~ (z >> 31)) >> 11) * 0x1p-53
  end
end

--- What is drawn from a stream.
return function(seed)
  local next = stream(seed)
  local roll = {}
  function roll.uniform(low, high) return low + (high - low) * next() end
  function roll.decades(low, high) return 10 ^ roll.uniform(math.log(low, 10), math.log(high, 10)) end
  function roll.integer(low, high) return low + math.floor((high - low + 1) * next()) end
  function roll.one_of(list) return list[roll.integer(1, #list)] end
  return roll
end
