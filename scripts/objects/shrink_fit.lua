-- A hub that is shrunk onto a shaft, then pulled off with friction.
--
-- Problem: axisymmetric; hub and shaft of steel, E = 210000 MPa, nu = 0.3, of the same length L = 30 mm. The shaft has
--          the radius R = 20 mm, the hub is a ring of the radii R − interference and 40 mm. It is shrunk without
--          friction (hot, then cooled), its bore is fixed along the axis at the far end; then the end of the shaft is
--          pulled along the axis, with the coefficient of friction mu.
-- Source: Lamé's thick rings of one material, S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, McGraw-Hill 1970,
--         section 28: the pressure is p = E interference (Ro² − R²)/(2 R Ro²). When all points slip, the tension of the
--         shaft and the compression of the hub lower it by half of nu times the tension, so that the force is
--         2 pi R L mu p (1 − exp(−c))/c with c = nu mu L/R.
-- Units: mm, N, MPa.
-- Expected: the pressure after shrinking is Lamé's within 0.5 %, the largest force the closed form within 1 %. Later
--           the force falls with the overlap l, more slowly than 2 pi R l mu p, because the free parts of shaft and hub
--           stiffen the ends of the contact.
-- Run: signorini objects/shrink_fit.lua [elements=12] [order=N2] [interference=0.02] [mu=0.15] [steps=30]
--      [penalty=2e6] [out=out/shrink_fit]

local sg = require "signorini"

local options = sg.arguments{ elements = { 12, at_least = 4 }, order = "N2",
                              interference = { 0.02, above = 0, below = 0.1 }, mu = { 0.15, at_least = 0 },
                              steps = { 30, at_least = 5 }, penalty = { 2e6, above = 0 }, out = "out/shrink_fit" }
local files = sg.files(options.out)
local R, Ro, L, E, nu = 20, 40, 30, 210000, 0.3
local interference, mu = options.interference, options.mu

local steel = sg.neo_hookean{ E = E, nu = nu }
local function ring(inner, outer, contact)
  return sg.body{ patch = sg.shapes.rectangle{ width = outer - inner, height = L, corner = { inner, 0 } },
                  elements = { options.elements // 2, options.elements }, order = options.order, contact = contact,
                  material = steel }
end
local shaft, hub = ring(0, R, "east"), ring(R - interference, Ro, "west")
local model = sg.model{
  kind     = "axisymmetric", bodies = { shaft = shaft, hub = hub },
  supports = { axis = { on = shaft:face "west", symmetry = true }, stop = { on = hub:face "north", fix = "y" },
               grip = { on = shaft:face "north", drive = "y" } },
  contacts = { seat = { slave = hub:face "west", master = shaft:face "east", penalty = options.penalty,
                        overlap = "interference", friction = { mu = 0, penalty = options.penalty } } },
}
local shrink = model:run{ { name = "shrink", steps = 2, contacts = { seat = { friction = { mu = 0 } } } } }
if shrink.failed then error(shrink.failure, 0) end

--- The mean contact pressure of the bore, over the part that touches.
local function mean_pressure()
  local profile, force, area = model:profile "seat", 0, 0
  for i, pressure in ipairs(profile.pressure) do
    if pressure > 0 then force, area = force + pressure * profile.area[i], area + profile.area[i] end
  end
  return force / area
end

local lame = E * interference * (Ro^2 - R^2) / (2 * R * Ro^2)
local pressure = mean_pressure()
local function picture(title)
  return sg.picture{ model = model, field = "von_mises", label = "von Mises stress (MPa)", title = title,
                     axes = { "r (mm)", "z (mm)" } }
end
local states = { picture "shrunk" }
local slide = { seat = { friction = { mu = mu } } }
local pull = model:run{ { name = "break loose", steps = 10, grip = 0.03, contacts = slide },
                        { name = "pull", steps = options.steps, grip = 0.9 * L } }
if pull.failed then error(pull.failure, 0) end
states[2] = picture "pulled by 27 mm"

local c = nu * mu * L / R
local most, share = 0, c > 0 and (1 - math.exp(-c)) / c or 1
local closed_force = 2 * math.pi * R * L * mu * lame * share / 1000
local travel, force, linear = pull:column "grip.uy", pull:column "grip.fy", {}
table.insert(travel, 1, 0)
table.insert(force, 1, 0)
for i, u in ipairs(travel) do
  force[i], linear[i] = force[i] / 1000, 2 * math.pi * R * (L - u) * mu * lame / 1000
  most = math.max(most, force[i])
end
print(sg.table{ columns = { "", "computed", "closed form" }, formats = { "%s", "%.2f", "%.2f" },
                rows = { { "pressure after shrinking (MPa)", pressure, lame },
                         { "largest force (kN)", most, closed_force } } })
sg.chart{ file = files "force.png", title = "Pulling a hub off a shaft", xlabel = "travel (mm)", ylabel = "force (kN)",
          { x = travel, y = force, label = "computed", marker = "none" },
          { x = travel, y = linear, label = "2π R l μ p", marker = "none", dashed = true },
          { x = { 0, travel[#travel] }, y = { closed_force, closed_force }, label = "largest, closed form",
            marker = "none", dashed = true } }
-- Pulled, the edge of the bore has the greatest stress, which grows with smaller elements: beyond the range.
sg.sheet{ states, columns = 2, range = { 0, 200 }, file = files "states.png", title = "Shrink fit" }
files:report()

return { pressure = pressure, lame = lame, most = most, closed_force = closed_force, travel = travel, force = force }
