-- Two bonded beams that are bent by uneven moments: how the energy of separation depends on the mode mix.
--
-- Problem: plane strain; two beams of height h = 2 mm and length 48 mm, E = 70000 MPa, nu = 0.3, bonded to each other
--          from x = 8 mm on. Their ends at x = 0 rotate: apart (mode I, double cantilever beam), together (mode II, as
--          in end-notched flexure), or by uneven angles. The other ends are fixed. The energy of separation rises with
--          the share m of shear as G(m) = G1 + (G2 − G1) m^2, G1 = 0.3, G2 = 0.9 N/mm; strength 20 MPa in opening,
--          2 (G2/G1)^½ 20 MPa = 69 MPa in shear.
-- Source: M. L. Benzeggagh, M. Kenane, Compos. Sci. Technol. 56, 1996, for G(m). B. F. Sørensen et al., Int. J. Fract.
--         141, 2006, for the energy release of moments M1, M2 on two beams, whatever the law of the bond; in their
--         halves M_I = (M1 − M2)/2, M_II = (M1 + M2)/2 it is 12 M_I²/(E' h³) + 9 M_II²/(E' h³), E' = E/(1 − nu²).
-- Units: mm, N, MPa; moments per mm of width.
-- Expected: the energy dissipated per new area, and the energy release of the moments, are G at the share of shear in
--           what the bonds dissipate, within 1 %, and work is the sum of the energies. With shear=1 bonds shear over a
--           longer zone than they open, m varies in it, and the mixed cases differ by up to 3 %.
-- Run: signorini objects/mixed_mode_bending.lua [elements=64] [ratios=-1,-0.4,0,0.4,1] [law=exponential|bilinear]
--      [strength=20] [shear=2] [penalty=1e5] [steps=60] [out=out/mixed_mode_bending]; ratios: of the rotations of the
--      two ends

local sg = require "signorini"

local options = sg.arguments{ elements = { 64, at_least = 8 },
                              ratios = { { -1, -0.4, 0, 0.4, 1 }, at_least = -1, at_most = 1 },
                              law = { "exponential", choices = { "exponential", "bilinear" } },
                              strength = { 20, above = 0 }, shear = { 2.0, above = 0 }, penalty = { 1e5, above = 0 },
                              steps = { 60, at_least = 8 }, out = "out/mixed_mode_bending" }
local files = sg.files(options.out)
local E, nu, h, length, crack, G1, G2 = 70000, 0.3, 2, 48, 8, 0.3, 0.9
local plane = E / (1 - nu^2)

local function energy(m) return G1 + (G2 - G1) * m ^ 2 end

local function beam(y, contact)
  return sg.body{ patch = sg.shapes.rectangle{ width = length, height = h, corner = {0, y} }, contact = contact,
                  elements = { options.elements, 2 }, order = "N2", thickness_degree = 2,
                  material = sg.neo_hookean{ E = E, nu = nu } }
end

--- The rotation of the upper end at which a crack of length a grows, of beams whose ends rotate in a ratio.
local function rotation(ratio, a)
  local stiffness = plane * h ^ 3 / 12
  -- Halves of the rotations over halves of the moments: the beams alone, and both together beyond the crack
  local opening, shear = a / stiffness, (0.75 * a + 0.25 * length) / stiffness
  local one, two = (1 - ratio) / 2 / opening, (1 + ratio) / 2 / shear
  local released_1, released_2 = 12 * one ^ 2 / (plane * h ^ 3), 9 * two ^ 2 / (plane * h ^ 3)
  return math.deg(math.sqrt(energy(released_2 / (released_1 + released_2)) / (released_1 + released_2)))
end

local function bent(ratio)
  local upper, lower = beam(0, "south"), beam(-h, "north")
  return sg.model{
    bodies   = { upper = upper, lower = lower },
    supports = { up = { on = upper:face "west", rotate = true }, down = { on = lower:face "west", rotate = true },
                 wall = { on = { upper:face "east", lower:face "east" }, fix = "xy" } },
    contacts = { glue = { slave = upper:face "south", master = lower:face "north", penalty = options.penalty,
                          cohesive = { strength = options.strength, energy = energy, law = options.law,
                                       shear = options.shear,
                                       stiffness = options.law == "bilinear" and options.penalty or nil,
                                       where = function(X) return X[1] >= crack end } } } }
end

--- Turns the ends of a model; returns the run, the energy dissipated and the new area at its end.
local function turn(model, ratio, angle, steps)
  local run = model:run{ { name = "bend", steps = steps, up = {-angle}, down = {-ratio * angle} } }
  if run.failed then error(run.failure, 0) end
  return run, model:energy().debonding, model:contact_resultant "glue".debonded
end

local rows, shown = {}, nil
local curve = { x = {}, y = {}, label = "G(m) of the bonds", markers = false, color = "gray" }
local dissipated = { x = {}, y = {}, label = "dissipated per new area", line = false, markers = true }
for i, ratio in ipairs(options.ratios) do
  local model, most = bent(ratio), rotation(ratio, 2.5 * crack)
  local later = options.steps // 4
  local _, lost, area = turn(model, ratio, 0.75 * most, options.steps - later)
  local run, lost_last, area_last = turn(model, ratio, most, later)
  -- The share of shear in the energy of bonds that broke in the second run, and the mean of the energy release there
  local profile, sheared, broken = model:profile "glue", 0, 0
  for point, X in ipairs(profile.X) do
    if X > crack + area and X < crack + area_last then
      broken, sheared = broken + 1, sheared + profile.mix[point]
    end
  end
  local released, part, up, down = 0, 0, run:column "up.moment", run:column "down.moment"
  for row = 1, later do
    local one, two = 12 * ((up[row] - down[row]) / 2) ^ 2, 9 * ((up[row] + down[row]) / 2) ^ 2
    released, part = released + (one + two) / (plane * h ^ 3) / later, part + two / (one + two) / later
  end
  local m, G = sheared / broken, (lost_last - lost) / (area_last - area)
  local e = model:energy()
  rows[i] = { ratio, m, part, area_last, energy(m), G / energy(m), released / energy(m),
              (e.stored + e.contact + e.debonding) / e.work }
  dissipated.x[i], dissipated.y[i] = m, G
  if not shown or math.abs(m - 0.5) < math.abs(shown.m - 0.5) then shown = { m = m, ratio = ratio, model = model } end
end
print(sg.table{ columns = { "ratio", "m of bonds", "m of moments", "new area", "G(m)", "dissipated", "released",
                            "energies" },
                units = { "", "", "", "mm", "N/mm", "G(m)", "G(m)", "work" },
                formats = { "%g", "%.4f", "%.4f", "%.2f", "%.4f", "%.4f", "%.4f", "%.5f" },
                rows = rows })

for k = 0, 50 do curve.x[k + 1], curve.y[k + 1] = k / 50, energy(k / 50) end
sg.chart{ file = files "energy.png", title = "Energy of separation of beams bent by uneven moments",
          xlabel = "share m of shear", ylabel = "energy per area (N/mm)",
          curve, dissipated }
sg.picture{ model = shown.model, field = "damage", file = files "damage.png", axes = { "x (mm)", "y (mm)" },
            title = ("Damage at a ratio of rotations of %g, m = %.2f"):format(shown.ratio, shown.m) }
files:report()

return { rows = rows }
