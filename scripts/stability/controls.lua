-- The ways in which the cells of a stability map are solved.

local sg = require "signorini"

local controls = {
  names = { "robust", "cutting", "rescue", "prediction" },
  titles = { plain = "plain Newton", robust = "with controls", cutting = "with cut steps alone",
             rescue = "with rescues alone", prediction = "with prediction alone" },
}

--- A way that turns on some options, with whatever a study needs on top.
local function with(defaults)
  return function(overrides)
    local options = {}
    for _, list in ipairs { defaults, overrides or {} } do
      for key, value in pairs(list) do options[key] = value end
    end
    return options
  end
end

--- Newton's iteration alone.
controls.plain = with {}

--- All controls on, and one of them at a time.
controls.robust = sg.robust
controls.cutting = with { step = { adaptive = true } }
controls.rescue = with { rescue = true }
controls.prediction = with { predictor = "linear" }

return controls
