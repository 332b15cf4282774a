-- print shows patches, bodies, models and profiles in the same few lines as the prompt. If one of several values has a
-- text that may fill several lines, such as these, a run, a study or a case of it, each value begins a line. Otherwise
-- it is Lua's print.

local object_text = require "signorini.prompt.show.objects"

local plain = print

local function has_text(value)
  local own = type(value) == "table" and getmetatable(value)
  return type(own) == "table" and own.__tostring ~= nil
end

return function(...)
  local below, shown = false, { ... }
  for i = 1, select("#", ...) do
    local text = object_text(shown[i])
    below = below or text ~= nil or has_text(shown[i])
    shown[i] = text or shown[i]
  end
  if not below then return plain(...) end
  for i = 1, select("#", ...) do plain(shown[i]) end
end
