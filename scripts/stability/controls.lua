-- The two ways in which every cell of a stability map is solved.

local sg = require "signorini"

local controls = {}

--- Newton's iteration alone, with whatever a study needs on top.
function controls.plain(overrides) return overrides end

--- All controls on.
controls.robust = sg.robust

return controls
