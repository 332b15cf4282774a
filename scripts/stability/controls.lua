-- Solver controls used for the cells of a convergence map.

local sg = require "signorini"

local controls = {
  names = { "robust", "cutting", "fallback", "prediction" },
  titles = { plain = "plain Newton", robust = "with controls", cutting = "with step cutting only",
             fallback = "with fallbacks only", prediction = "with prediction only" },
}

--- A way that turns on one control of plain Newton, with the further options that a study needs.
local function with(key, value)
  return function(overrides)
    local options = sg.plain(overrides)
    if overrides == nil or overrides[key] == nil then options[key] = value end
    return options
  end
end

--- Newton's iteration alone; all controls on, which is the default of model:run; one of them at a time.
controls.plain = sg.plain
controls.robust = sg.robust
controls.cutting = with("step", { adaptive = true })
controls.fallback = with("fallback", true)
controls.prediction = with("predictor", "quadratic")

return controls
