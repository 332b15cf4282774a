-- Oscillation of the forces: max − min over about one element pitch of the slab (100/18 = 5.56 mm) in its middle, 19
-- steps of 0.3 mm of the published path, in which the indenter's center moves from x = 47.3 to 52.7. The thesis does
-- not state its window; over the whole path the trend near the slab's ends would dominate.

local plane = require "problems.ironing2d.measure"

local measure = { from = 47.3, to = 52.7, steps = 18 }

--- Adds to a case the oscillations dPx and dPz, { raw, detrended }; both are empty if the run ended before the window's
--- end. The window's first value is the state from which a case that is pressed there starts to slide.
function measure.oscillations(case)
  local first = math.floor((measure.from - case.from) / 0.3 + 0.5)
  for name, column in pairs { dPx = "grip.fx", dPz = "grip.fz" } do
    local values, press = case.run:column(column), case.run.stages[1].steps
    case[name] = plane.oscillation(values, press + first, press + first + measure.steps)
  end
  return case
end

--- Adds the oscillations in % of those of a case, if given: raw_percent, detrended_percent.
function measure.compare(cases, reference)
  plane.percent(cases, { "dPx", "dPz" }, reference)
end

return measure
