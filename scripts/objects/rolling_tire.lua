-- An elastic tire that is pressed onto a rigid road and rolled by its hub, with friction.
--
-- Problem: plane strain; a ring of microcellular polyurethane, E = 6 MPa, nu = 0.2, radii 200 and 300 mm, bonded to a
--          rigid hub that turns. The hub is lowered by 20 mm onto a rigid plane with the coefficient of friction mu,
--          then turned by `angle` degrees, free to move along the road (free rolling); then again and again with a
--          prescribed slip omega Re/v − 1, where Re is the rolling radius v/omega of free rolling.
-- Source: G. F. Carter, Proc. R. Soc. A 112 (1926): traction rises linearly with the slip, then saturates at mu times
--         the load; G. J. Parish, Brit. J. Appl. Phys. 9 (1958): rubber covers, with nu close to 1/2, travel farther
--         than 2 pi R per turn.
-- Units: mm, N, MPa.
-- Expected: the rolling radius is between the loaded radius, 280 mm, and the free one, 300 mm; nu = 0.45 has 319 mm.
--           Elastic tires have no rolling resistance: the moment of free rolling is below 0.1 % of load times radius
--           on average. The traction at large slip is mu times the load within 1 %.
-- Run: signorini objects/rolling_tire.lua [elements=72] [order=N2] [nu=0.2] [mu=0.5] [angle=90] [steps=60]
--      [out=out/rolling_tire]

local sg = require "signorini"

local options = sg.arguments{ elements = { 72, at_least = 24 }, order = "N2", nu = { 0.2, at_least = 0, below = 0.5 },
                              mu = { 0.5, above = 0 }, angle = { 90, at_least = 60 }, steps = { 60, at_least = 10 },
                              out = "out/rolling_tire" }
local files = sg.files(options.out)
local E, inner, R, deep, mu = 6, 200, 300, 20, options.mu
local angle, steps = math.rad(options.angle), options.steps

local tire = sg.body{ patch = sg.shapes.ring{ inner = inner, outer = R }, elements = { options.elements, 4 },
                      order = options.order, material = sg.neo_hookean{ E = E, nu = options.nu } }

--- A model, pressed onto the road; `drive`: "y" if the hub is free along the road.
local function pressed(drive)
  local model = sg.model{
    bodies   = { tire = tire },
    supports = { hub = { on = tire:face "north", rotate = true, drive = drive } },
    contacts = { road = { slave = tire:face "south", penalty = E, friction = { mu = mu, penalty = E },
                          master = sg.rigid.plane{ point = { 0, -R }, normal = { 0, 1 } } } },
  }
  local run = model:run{ { name = "press", steps = 4, hub = drive == "y" and { -deep, 0 } or { 0, -deep, 0 } } }
  if run.failed then error(run.failure, 0) end
  return model
end

--- Displacement of the hub along the road: the mean of two opposite points.
local function travel(model) return (model:sample(tire, "ux", { 0, 1 }) + model:sample(tire, "ux", { 0.5, 1 })) / 2 end

local function mean(list, from)
  local sum = 0
  for i = from, #list do sum = sum + list[i] end
  return sum / (#list - from + 1)
end
local settled = steps // 2 -- the first half is transient: the contact length passes once

-- ── Free rolling ─────────────────────────────────────────────────────────────────────────────────────────────────────

local model = pressed "y"
local function picture(title)
  return sg.picture{ model = model, field = "von_mises", label = "von Mises stress (MPa)", title = title,
                     axes = { "x (mm)", "y (mm)" } }
end
local states = { picture "pressed" }
local length = model:contact_resultant("road").area
local roll = model:run({ { name = "roll", steps = steps, hub = { -deep, -options.angle } } },
  { on_step = function() return { travel = travel(model) } end })
if roll.failed then error(roll.failure, 0) end
states[2] = picture "rolled"
local x, load = roll:column "travel", -mean(roll:column "hub.fy", settled)
local rolling = (x[#x] - x[settled]) / (angle * (#x - settled) / steps)
local moment = mean(roll:column "hub.moment", settled)

-- ── Braked and driven ────────────────────────────────────────────────────────────────────────────────────────────────

local slips, traction = { -0.3, -0.15, -0.08, -0.03, 0.03, 0.08, 0.15, 0.3 }, {}
local driven = pressed "xy"
local start = driven:snapshot()
for i, slip in ipairs(slips) do
  driven:restore(start)
  local run = driven:run{ { name = "roll", steps = steps,
                            hub = { rolling * angle / (1 + slip), -deep, -options.angle } } }
  if run.failed then error(run.failure, 0) end
  -- The road pushes a driven tire forward; the hub holds it back.
  traction[i] = -mean(run:column "hub.fx", settled) / -mean(run:column "hub.fy", settled)
end

print(sg.table{ columns = { "", "value" }, formats = { "%s", "%.4g" },
                rows = { { "load (N/mm)", load }, { "contact length (mm)", length },
                         { "rolling radius (mm)", rolling }, { "loaded radius (mm)", R - deep },
                         { "moment over load times radius", moment / (load * R) },
                         { "traction over load at a slip of 0.3", traction[#traction] } } })
local degrees, advance = {}, {}
for i = 2, #x do
  degrees[i - 1] = i * options.angle / steps
  advance[i - 1] = (x[i] - x[i - 1]) / (angle / steps)
end
sg.chart{ file = files "rolling_radius.png", title = "Free rolling", xlabel = "angle of the hub (degrees)",
          ylabel = "advance per angle (mm)", { x = degrees, y = advance, label = "computed", marker = "none" },
          { x = { 0, options.angle }, y = { R, R }, label = "free radius", marker = "none", dashed = true },
          { x = { 0, options.angle }, y = { R - deep, R - deep }, label = "loaded radius", marker = "none",
            dashed = true } }
sg.chart{ file = files "traction.png", title = "Traction of a rolling tire", xlabel = "slip ω Re/v − 1",
          ylabel = "traction over load", { x = slips, y = traction, label = "computed" },
          { x = { 0, slips[#slips] }, y = { mu, mu }, label = "μ", marker = "none", dashed = true },
          { x = { slips[1], 0 }, y = { -mu, -mu }, label = "−μ", marker = "none", dashed = true } }
sg.sheet{ states, columns = 2, file = files "states.png", title = "Rolling tire" }
files:report()

return { load = load, length = length, rolling = rolling, free = R, loaded = R - deep, moment = moment / (load * R),
         slips = slips, traction = traction, mu = mu }
