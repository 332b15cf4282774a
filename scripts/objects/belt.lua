-- A belt around a driven pulley, and around a fixed cylinder over which its tight end is pulled.
--
-- Problem: plane strain, per mm of width; a belt of the thickness h lies around half of a rigid pulley of the radius
--          R = 20 mm, with straight ends of 10 mm, stress-free in this shape. The force T1 = 1 N/mm pulls its slack
--          end, the tight end is held. Then the pulley turns, with the friction mu; or the pulley is fixed and the
--          tight end is pulled until the belt slides.
-- Source: L. Euler (1769) and J. A. Eytelwein (1808), the capstan equation T2/T1 = exp(mu pi) of a belt without
--         thickness. The tension acts at R + h/2, friction at R: dT (R + h/2) = mu p R R dtheta with p R = T, which
--         lowers the exponent to mu pi R/(R + h/2). The pulley's moment is (T2 - T1)(R + h/2) by equilibrium.
-- Units: mm, N, MPa, degrees.
-- Expected: the ratio of the thick belt within 0.5 % on the pulley, within 1.5 % over the fixed cylinder, where the
--           belt also bends as it leaves; both differences fall with h. The moment within 0.5 %.
-- Run: signorini objects/belt.lua [elements=48] [order=N2] [h=0.5] [mu=0.3] [turn=3] [steps=12] [penalty=100]
--      [out=out/belt]

local sg = require "signorini"

local options = sg.arguments{ elements = { 48, at_least = 8 }, order = "N2", h = { 0.5, above = 0, at_most = 4 },
                              mu = { 0.3, above = 0, at_most = 0.8 }, turn = { 3, above = 0, at_most = 10 },
                              steps = { 12, at_least = 2 }, penalty = { 100, above = 0 }, out = "out/belt" }
local files = sg.files(options.out)
local R, T1, length, h, mu = 20, 1, 10, options.h, options.mu

--- The belt and its pulley, which turns if `driven`; otherwise the tight end is driven.
local function scene(driven)
  local function straight(x) return sg.shapes.rectangle{ width = h, height = length, corner = { x, 0 } } end
  local patches = { straight(-R - h), sg.shapes.half_annulus{ inner = R, outer = R + h, center = {0, 0} }, straight(R),
                    boundaries = { slack = { "1.north" }, inside = { "1.east", "2.north", "3.west" },
                                   tight = { "3.north" } } }
  local along = math.max(2, math.floor(options.elements * length / (math.pi * R) + 0.5))
  local belt = sg.body{ patch = patches, elements = { { 1, along }, { options.elements, 1 }, { 1, along } },
                        order = options.order, contact = "inside", material = sg.neo_hookean{ E = 1000, nu = 0.3 } }
  local pulley = sg.rigid.cylinder{ center = {0, 0}, radius = R }
  return sg.model{
    bodies = { belt = belt },
    supports = { slack = { on = belt:face "slack", fix = "x" },
                 tight = { on = belt:face "tight", fix = driven and "xy" or "x", drive = not driven and "y" or nil },
                 pulley = driven and { on = pulley, fix = "xy", rotate = true } or nil },
    loads = { pull = { on = belt:face "slack", traction = {0, 0} } },
    contacts = { wrap = { slave = belt:face "inside", master = pulley, penalty = options.penalty,
                          friction = { mu = mu, penalty = options.penalty } } } }
end

--- The run of a model after its slack end is loaded.
local function run(model, stage)
  stage.steps, stage.name = options.steps, "slide"
  local done = model:run{ { name = "tighten", steps = 4, pull = { 0, T1 / h } }, stage }
  if done.failed then error(done.failure, 0) end
  return done
end

local function last(done, column)
  local values = done:column(column)
  return values[#values]
end

local model, over = scene(true), scene(false)
local turned = run(model, { pulley = -options.turn })
local dragged = run(over, { tight = math.rad(options.turn) * R })
local ratio, ratio_over = last(turned, "tight.fy") / T1, last(dragged, "tight.fy") / T1
local thick, thin = math.exp(mu * math.pi * R / (R + h / 2)), math.exp(mu * math.pi)
local moment, balance = -last(turned, "pulley.moment"), (ratio - 1) * T1 * (R + h / 2)
print(sg.table{ columns = { "", "computed", "closed form" }, formats = { "%s", "%.4f", "%.4f" },
                rows = { { "T2/T1, driven pulley", ratio, thick }, { "T2/T1, fixed cylinder", ratio_over, thick },
                         { "T2/T1, Euler and Eytelwein", nil, thin },
                         { "moment of the pulley (N mm/mm)", moment, balance } } })

-- The contact pressure times R is the tension, which grows from the slack end at 180° on.
local profile, angle, tension, closed = model:profile "wrap", {}, {}, {}
for i, x in ipairs(profile.x) do
  if profile.pressure[i] > 0 then
    local turn = math.pi + math.atan(profile.y[i], x)
    angle[#angle + 1], tension[#tension + 1] = math.deg(turn), profile.pressure[i] * R
    closed[#closed + 1] = T1 * math.exp(mu * turn)
  end
end
sg.chart{ file = files "tension.png", title = "Belt around a driven pulley",
          xlabel = "angle from the slack end (degrees)", ylabel = "contact pressure × R (N/mm)",
          { x = angle, y = tension, label = "computed", marker = "none" },
          { x = angle, y = closed, label = "T₁ exp(μ θ)", marker = "none", dashed = true } }
sg.picture{ model = model, field = "von_mises", label = "von Mises stress (MPa)", axes = { "x (mm)", "y (mm)" },
            file = files "belt.png", title = "Belt around a driven pulley" }
files:report()

return { ratio = ratio, ratio_over = ratio_over, thick = thick, thin = thin, moment = moment, balance = balance }
