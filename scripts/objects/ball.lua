-- A solid ball of seven joined patches, pressed between two rigid plates.
--
-- Problem: the ball of radius 1 (sg.shapes.ball) consists of six outer patches around a core; none of them has a
--          singular point. Elements are small at the contacts. Each plate moves by half of `approach` towards the
--          other one. Weak friction (a ten-thousandth of the normal penalty) holds the ball sideways. The reference is
--          an axisymmetric model of a quarter of the section, with a hole of radius 0.01 in the center, so that its
--          map has no singular point either.
-- Source: K. L. Johnson, Contact Mechanics, Cambridge, 1985, section 4.2(a): with E* = E/(1 − nu²) and the approach d
--         of the center and a plate the radius of contact is a = sqrt(R d), the force 4/3 E* sqrt(R) d^(3/2), the peak
--         pressure 2 E* a/(pi R). J. E. Cobb, Tiling the sphere with rational Bézier patches, University of Utah,
--         UUCS-88-009, 1988.
-- Units: lengths in units of the radius, pressures of Young's modulus.
-- Expected: force within 1.5 %, peak pressure within 5 % of the axisymmetric model's. With a stiffer penalty the force
--           is 18 % above Hertz's at a/R = 0.28, 4 % at a/R = 0.07: the finite size acts in proportion to a/R.
-- Run: signorini objects/ball.lua [order=N4] [elements=4] [depth=2] [approach=0.16] [reference=24] [penalty=20]
--      [out=out/ball]; order: N4-N4.1 has a layer on the whole sphere; elements: along each edge of the core; depth:
--      from the core to the sphere; reference: in each direction; penalty: in E/R, of the ball and the first model of
--      the section

local sg = require "signorini"

local options = sg.arguments{
  order = "N4", elements = { 4, at_least = 2 }, depth = { 2, at_least = 1 },
  approach = { 0.16, above = 0, below = 0.5 },
  reference = { 24, at_least = 4 }, penalty = { 20.0, above = 0 }, out = "out/ball",
}
local files = sg.files(options.out)
local nu, penalty, deep = 0.3, options.penalty, options.approach / 2
local rigid_penalty = 320 -- almost rigid at this approach; for a quarter of the radius of contact 4 times as high
local material = sg.linear_elastic{ E = 1, nu = nu }
local start = 1 - 1e-5 -- height of the plates: the first iteration finds points in contact

local function hertz(d)
  local modulus, a = 1 / (1 - nu^2), math.sqrt(d)
  return { a = a, force = 4 / 3 * modulus * d^1.5, peak = 2 * modulus * a / math.pi }
end

local function plate(z, normal)
  return sg.rigid.plane{ point = normal[3] and { 0, 0, z } or { 0, z }, normal = normal }
end

-- ── Seven patches ────────────────────────────────────────────────────────────────────────────────────────────────────

--- Inner knots of [0, 1], symmetric about 1/2, where they are twice as dense as on average.
local function middle(count)
  local knots = {}
  for i = 1, count - 1 do
    local t = 2 * i / count - 1
    knots[i] = (1 + (t + t^3) / 2) / 2
  end
  return knots
end

--- Inner knots of [0, 1] that are closer to each other at its start.
local function towards_start(count)
  local knots = {}
  for i = 1, count - 1 do knots[i] = (i / count)^1.5 end
  return knots
end

local function solid()
  local patches, elements = sg.shapes.ball{ radius = 1 }, {}
  for n, patch in ipairs(patches) do
    local along = middle(options.elements)
    local through = n < 7 and towards_start(options.depth) or along
    patches[n] = patch:insert(1, along):insert(2, along):insert(3, through)
    elements[n] = patches[n]:elements()
  end
  local ball = sg.body{ patch = patches, elements = elements, order = options.order, material = material,
                        contact = options.order:find "-" and "outer" or nil }
  local lower, upper = plate(-start, { 0, 0, 1 }), plate(start, { 0, 0, -1 })
  local function touch(face, master)
    return { slave = ball:face(face), master = master, penalty = penalty,
             friction = { mu = 0.3, penalty = penalty / 1e4 } }
  end
  return sg.model{
    bodies = { ball = ball },
    supports = { lower = { on = lower, drive = "z" }, upper = { on = upper, drive = "z" } },
    contacts = { foot = touch("1.front", lower), head = touch("6.front", upper) },
  }
end

-- ── A quarter of the section ─────────────────────────────────────────────────────────────────────────────────────────

local function section(penalty)
  local patch = sg.shapes.quarter_annulus{ inner = 0.01, outer = 1 }
  local grading = { elements = 0.5, length = 0.2, at = "start" }
  local ball = sg.body{ patch = patch, elements = { options.reference, options.reference }, order = "N3",
                        grading = { grading, grading }, material = material }
  local lower = plate(-start, { 0, 1 })
  return sg.model{
    bodies = { ball = ball }, kind = "axisymmetric",
    supports = { axis = { on = ball:face "west", symmetry = true }, half = { on = ball:face "east", symmetry = true },
                 lower = { on = lower, drive = "y" } },
    contacts = { foot = { slave = ball:face "south", master = lower, penalty = penalty } },
  }
end

-- ── Comparison ───────────────────────────────────────────────────────────────────────────────────────────────────────

--- Presses the plates by d each; `solid`: the ball in space.
local function solve(model, d, solid)
  local moved = d - (1 - start)
  local run = model:run({ { name = "press", steps = 1, lower = moved, upper = solid and -moved or nil } }, sg.plain{})
  if run.failed then error(run.failure, 0) end
  local profile, exact, x, y = model:profile "foot", hertz(d), {}, {}
  for i, pressure in ipairs(profile.pressure) do
    local r = math.sqrt(profile.x[i]^2 + (solid and profile.y[i]^2 or 0)) / exact.a
    if r < 1.5 then x[#x + 1], y[#y + 1] = r, pressure / exact.peak end
  end
  return { model = model, wall = run.wall, unknowns = model:cost().unknowns, curve = { x = x, y = y },
           force = run:column(solid and "foot.fz" or "foot.fy")[1] / exact.force, peak = math.max(table.unpack(y)) }
end

local ball, quarter = solve(solid(), deep, true), solve(section(penalty), deep, false)
local rigid = solve(section(rigid_penalty), deep, false)
local small = solve(section(4 * rigid_penalty), deep / 16, false)
local function row(name, d, case, peak)
  return { name, hertz(d).a, case.unknowns, case.force, peak or "", case.wall }
end
print(sg.table{
  columns = { "", "a/R", "unknowns", "force", "peak pressure", "wall" },
  units = { "", "", "", "of Hertz's", "of Hertz's", "s" }, formats = { "%s", "%.3f", "%d", "%.4f", "%.4f", "%.1f" },
  rows = { row("seven patches", deep, ball, ball.peak),
           row("quarter of the section", deep, quarter, quarter.peak),
           row(("quarter, penalty %g"):format(rigid_penalty), deep, rigid),
           row(("quarter, penalty %g"):format(4 * rigid_penalty), deep / 16, small) },
})
local exact = { x = {}, y = {}, label = "Hertz", dashed = true, marker = "none" }
for i = 0, 200 do exact.x[i + 1], exact.y[i + 1] = i / 200, math.sqrt(1 - (i / 200)^2) end
quarter.curve.label, quarter.curve.marker = "quarter of the section", "none"

--- The mean around the axis, and half of the range there as its error, over intervals of the radius.
local function around(curve)
  local width, low, high, sum, count = 0.05, {}, {}, {}, {}
  for i, r in ipairs(curve.x) do
    local k, p = math.floor(r / width), curve.y[i]
    low[k], high[k] = math.min(low[k] or p, p), math.max(high[k] or p, p)
    sum[k], count[k] = (sum[k] or 0) + p, (count[k] or 0) + 1
  end
  local band = { x = {}, y = {}, error = {}, label = "seven patches: mean and range around the axis", marker = "none" }
  for k = 0, 1.2 // width do
    if count[k] then
      local n = #band.x + 1
      band.x[n], band.y[n], band.error[n] = (k + 0.5) * width, sum[k] / count[k], (high[k] - low[k]) / 2
    end
  end
  return band
end
sg.chart{ file = files "pressure.png", title = "Ball between plates: contact pressure", xlabel = "r / a (Hertz)",
          ylabel = "pressure / peak pressure (Hertz)", around(ball.curve), quarter.curve, exact,
          xrange = { 0, 1.2 } }
sg.picture{ model = ball.model, field = "szz", label = "σ_zz / E", file = files "cut.png", cut = "y", size = 1000,
            obstacles = false, title = "Ball of seven patches between plates" }
files:report()

return { ball = ball, quarter = quarter, rigid = rigid, small = small }
