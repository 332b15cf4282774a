-- Pressing and dragging without friction over a symmetric slab: the way back mirrors the way there.

local check = require "check"

--- Pz is symmetric about the slab's middle, Px its opposite; `pressed` is the step at which the way begins.
return function(case, pressed, tolerance)
  local last = case.run.steps
  for step = pressed, last do
    local mirrored = last + pressed - step
    check.near(case.Pz[step], case.Pz[mirrored], tolerance)
    check.near(case.Px[step], -case.Px[mirrored], tolerance)
  end
end
