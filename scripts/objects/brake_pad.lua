-- A brake pad on a moving disc: static and kinetic friction, and friction that depends on the speed.
--
-- Problem: plane strain; a pad of rubber-like lining, 40 × 10 mm, E = 100 MPa, nu = 0.4, is pressed by 0.1 mm onto a
--          rigid disc, here a plane, that then moves along it. mu falls from 0.4 to 0.25 as a point slips by `over`
--          (mu = { static, kinetic, over }), or with the slip rate, mu = 0.25 + 0.15 exp(−v/v0) (R. Stribeck,
--          Z. VDI 46, 1902, for journal bearings; the exponential is usual since A. Tustin, J. IEE 94, 1947).
-- Source: Coulomb's law: once all points slip alike, drag/pressing force = mu.
-- Units: mm, N, MPa, s.
-- Expected: the drag of steady sliding is mu times the pressing force within 1e-9, at each speed. The first peak is
--           below static friction, since the ends of the pad slip first, and the lower the shorter `over`.
-- Run: signorini objects/brake_pad.lua [elements=16] [order=N2-N2.2] [over=0.5,0.05,0.01] [speeds=0.01,0.1,0.3,1,3]
--      [steps=80] [out=out/brake_pad]

local sg = require "signorini"

local options = sg.arguments{ elements = { 16, at_least = 4 }, order = "N2-N2.2",
                              over = { { 0.5, 0.05, 0.01 }, above = 0 },
                              speeds = { { 0.01, 0.1, 0.3, 1, 3 }, above = 0 }, steps = { 80, at_least = 10 },
                              out = "out/brake_pad" }
local files = sg.files(options.out)
local static, kinetic, v0, travel = 0.4, 0.25, 0.3, 2

local function scene(mu)
  local pad = sg.body{ patch = sg.shapes.rectangle{ width = 40, height = 10 }, contact = "south", order = options.order,
                       elements = { options.elements, options.elements // 4 },
                       material = sg.neo_hookean{ E = 100, nu = 0.4 } }
  local disc = sg.rigid.plane{ point = {0, 0}, normal = {0, 1} }
  return sg.model{
    bodies = { pad = pad },
    supports = { holder = { on = pad:face "north", fix = "x", drive = "y" }, disc = { on = disc, drive = "x" } },
    contacts = { lining = { slave = pad:face "south", master = disc, friction = { mu = mu } } },
  }
end

local function slid(mu, steps, distance, duration, watch)
  local model = scene(mu)
  local run = model:run({ { name = "press", steps = 4, holder = -0.1, duration = duration and 1 },
                         { name = "slide", steps = steps, disc = distance, duration = duration } },
                       { on_step = watch and function(info) watch(model, info) end })
  if run.failed then error(run.failure, 0) end
  return model, run
end

-- ── Static and kinetic friction ──────────────────────────────────────────────────────────────────────────────────────

local curves, rows = {}, {}
local peak_state, last_state

local function picture(model, field, label, title, range)
  return sg.picture{ model = model, field = field, label = label, title = title, range = range,
                     axes = { "x (mm)", "y (mm)" } }
end

--- Draws mu at the first step in which the drag falls.
local last_drag = 0
local function watch(model, info)
  local drag = math.abs(info["lining.fx"])
  if not peak_state and info.stage == "slide" and drag < last_drag then
    peak_state = picture(model, "mu", "coefficient of friction", "At the peak of the drag", { kinetic, static })
  end
  last_drag = drag
end

for i, over in ipairs(options.over) do
  local model, run = slid({ static = static, kinetic = kinetic, over = over }, options.steps, travel, nil, watch)
  local x, fx, fy, ratio, peak = run:column "disc.ux", run:column "lining.fx", run:column "lining.fy", {}, 0
  for row = 1, #x do
    ratio[row] = math.abs(fx[row]) / fy[row]
    peak = math.max(peak, ratio[row])
  end
  local steady = kinetic + (static - kinetic) * math.exp(-travel / over)
  rows[i] = { over, peak, ratio[#ratio], steady }
  curves[i] = { x = x, y = ratio, label = ("over %g mm"):format(over), markers = false }
  last_state = last_state or picture(model, "von_mises", "von Mises stress (MPa)", "After 2 mm")
end
print(sg.table{ columns = { "over", "largest drag / force", "at the end", "mu there" }, units = { "mm", "", "", "" },
                formats = { "%g", "%.4f", "%.4f", "%.4f" }, rows = rows })
curves.file, curves.title = files "drag.png", "Static and kinetic friction of a pad"
curves.xlabel, curves.ylabel = "travel of the disc (mm)", "drag / pressing force"
sg.chart(curves)

-- ── Friction by speed ────────────────────────────────────────────────────────────────────────────────────────────────

-- In long steps: where friction falls faster with the rate than the pad can spring back, p |dmu/dv| > K duration with
-- the stiffness K of the pad per area, it sticks and slips, of which a quasi-static run knows nothing but the warning.
local long_steps, long_travel = 8, 8
local function by_speed(v) return kinetic + (static - kinetic) * sg.exp(-v / v0) end
local measured, exact, worst = {}, { x = {}, y = {} }, 0
for i, speed in ipairs(options.speeds) do
  local force = slid(by_speed, long_steps, long_travel, long_travel / speed):contact_resultant "lining"
  measured[i] = math.abs(force.fx) / force.fy
  worst = math.max(worst, math.abs(measured[i] / by_speed(speed) - 1))
end
for i = 0, 60 do
  exact.x[i + 1] = 10 ^ (-2.3 + 3 * i / 60)
  exact.y[i + 1] = by_speed(exact.x[i + 1])
end
print(("Drag over pressing force differs from mu(v) by at most %.1e"):format(worst))
sg.chart{ file = files "speed.png", title = "Friction by speed", xlabel = "speed (mm/s)",
          ylabel = "drag / pressing force", log = "x",
          { x = exact.x, y = exact.y, label = "μ(v)", markers = false },
          { x = options.speeds, y = measured, label = "pad", line = false, markers = true } }
sg.sheet{ { peak_state or last_state }, { last_state }, file = files "states.png" }
files:report()

return { rows = rows, speeds = measured, worst = worst }
