-- The two ways in which every cell of a stability map is solved.

local sg = require "signorini"

local controls = {}

--- Newton's iteration alone, with whatever a study needs on top.
function controls.plain(overrides) return overrides end

--- All controls on.
function controls.robust(overrides)
  if sg.robust then return sg.robust(overrides) end
  local options = { step = { adaptive = true } }
  for key, value in pairs(overrides or {}) do options[key] = value end
  return options
end

return controls
