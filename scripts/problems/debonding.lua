-- Double cantilever beams that are opened by moments: steady growth of a crack along a cohesive bond.
--
-- Problem: plane strain; two beams of height h = 2 mm and length 32 mm, E = 70000 MPa, nu = 0.3, bonded to each other
--          from x = 8 mm on with the energy of separation G = 0.3 N/mm. Their ends at x = 0 rotate apart, up to 2.4
--          degrees each; the other ends are fixed. `elements`: along each beam.
-- Source: J. R. Rice, J. Appl. Mech. 35, 1968: the J integral of moments M is 12 M²/(E' h³), E' = E/(1 − nu²), whatever
--         the length of the crack and the law of the bond, so that M = sqrt(G E' h³/12) once the crack grows.
-- Units: mm, N, MPa; moments per mm of width.
-- Expected: with three elements in the cohesive zone the mean of the steady moment is M, and work the sum of the
--           energies, within 0.1 %, and moments oscillate by less than 3 % of M; with nine by less than 0.2 %.
-- Run: signorini debonding.lua [elements=16,24,32,48,64] [laws=exponential,bilinear] [strength=20]
--      [penalty=1e5] [steps=150] [out=out/debonding] [page=none]; page: folder of debonding.md, whose table is filled

local sg = require "signorini"
local page = require "page.tables"

local options = sg.arguments{ elements = { { 16, 24, 32, 48, 64 }, at_least = 8 },
                              laws = { { "exponential", "bilinear" }, choices = { "exponential", "bilinear" } },
                              strength = { 20, above = 0 }, penalty = { 1e5, above = 0 },
                              steps = { 150, at_least = 10 }, out = "out/debonding", page = "none" }
local files = sg.files(options.out)
local E, nu, h, length, crack, G, turn = 70000, 0.3, 2, 32, 8, 0.3, 2.4
local plane = E / (1 - nu^2)
local exact = math.sqrt(G * plane * h^3 / 12)
-- Length of the cohesive zone in a thin layer: J. G. Williams, H. Hadavinia, J. Mech. Phys. Solids 50, 2002.
local zone = (E * G / options.strength^2) ^ 0.25 * h ^ 0.75

local function beam(y, n, contact)
  return sg.body{ patch = sg.shapes.rectangle{ width = length, height = h, corner = {0, y} }, elements = {n, 2},
                  order = "N2", contact = contact, thickness_degree = 2, material = sg.neo_hookean{ E = E, nu = nu } }
end

--- Opens the beams: moments relative to the exact one, their mean and oscillation over the last quarter of the path.
local function solve(law, n)
  local upper, lower = beam(0, n, "south"), beam(-h, n, "north")
  local model = sg.model{
    bodies   = { upper = upper, lower = lower },
    supports = { up = { on = upper:face "west", rotate = true }, down = { on = lower:face "west", rotate = true },
                 wall = { on = { upper:face "east", lower:face "east" }, fix = "xy" } },
    contacts = { glue = { slave = upper:face "south", master = lower:face "north", penalty = options.penalty,
                          cohesive = { strength = options.strength, energy = G, law = law,
                                       where = function(X) return X[1] >= crack end } } } }
  local run = model:run{ { name = "open", steps = options.steps, up = {-turn}, down = {turn} } }
  if run.failed then error(run.failure, 0) end
  local angle, moment, low, high, sum, count = { 0 }, { 0 }, math.huge, 0, 0, 0
  for i, value in ipairs(run:column "up.moment") do
    angle[i + 1], moment[i + 1] = turn * i / options.steps, math.abs(value) / exact
    if i > 0.75 * options.steps then
      low, high = math.min(low, moment[i + 1]), math.max(high, moment[i + 1])
      sum, count = sum + moment[i + 1], count + 1
    end
  end
  local e = model:energy()
  return { law = law, zone = zone * n / length, mean = sum / count, oscillation = high - low,
           balance = (e.stored + e.contact + e.debonding) / e.work, angle = angle, moment = moment,
           debonded = model:contact_resultant "glue".debonded, model = model }
end

local cases, rows, curves, convergence = {}, {}, {}, {}
for _, law in ipairs(options.laws) do
  local x, y = {}, {}
  for _, n in ipairs(options.elements) do
    local case = solve(law, n)
    cases[#cases + 1] = case
    rows[#rows + 1] = { law, n, case.zone, case.mean, 100 * case.oscillation, case.balance }
    x[#x + 1], y[#y + 1] = case.zone, 100 * case.oscillation
    if law == options.laws[1] then
      curves[#curves + 1] = { x = case.angle, y = case.moment, label = ("%.3g elements in the zone"):format(case.zone),
                              marker = "none" }
    end
  end
  convergence[#convergence + 1] = { x = x, y = y, label = law }
end
local results = { columns = { "law", "elements", "in the zone", "moment", "oscillation (%)", "energies over work" },
                  formats = { "%s", "%d", "%.2f", "%.4f", "%.2f", "%.5f" }, rows = rows }
print(sg.table(results))
page.fill(options, "debonding", "debonding", { results = results })
sg.chart{ file = files "moment.png", title = ("Double cantilever beam, %s law"):format(options.laws[1]),
          xlabel = "rotation (degrees)", ylabel = "moment over closed form", table.unpack(curves) }
if #options.elements > 1 then
  sg.chart{ file = files "oscillation.png", title = "Oscillation of the steady moment", log = "xy",
            xlabel = "elements in the cohesive zone", ylabel = "oscillation (% of the moment)",
            table.unpack(convergence) }
end
sg.picture{ model = cases[#options.elements].model, field = "damage", file = files "damage.png",
            title = ("Damage at the end of the path, %s law"):format(options.laws[1]), axes = { "x (mm)", "y (mm)" } }
files:report()

return { cases = cases }
