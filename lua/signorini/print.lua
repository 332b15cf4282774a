-- print for several values of which one has a text of its own that may fill lines, such as a run, a study or a case of
-- it: each begins a line. All else is as Lua has it.

local plain = print

local function has_text(value)
  local own = type(value) == "table" and getmetatable(value)
  return type(own) == "table" and own.__tostring ~= nil
end

return function(...)
  local below = false
  for i = 1, select("#", ...) do below = below or has_text((select(i, ...))) end
  if not below then return plain(...) end
  for i = 1, select("#", ...) do plain((select(i, ...))) end
end
