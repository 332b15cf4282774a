-- A rigid roller under its weight, pulled over a soft slab: free rolling.
--
-- Problem: plane strain; a cylinder of the radius R = 0.5 with the weights 0.05 to 0.4 per unit depth is pulled by its
--          axis over a slab of 4 × 1, E = 10, nu = 0.3, friction mu. Its height and its angle are unknowns.
-- Source: equilibrium: no moment acts on the axis, and an elastic slab dissipates nothing where all points stick, so
--         that the drag vanishes in the mean. The advance per radian tends to R with the half-width a of the contact,
--         a² = 4 P R (1 - nu²)/(pi E) (Hertz); the difference is the compression along the contact (creep), of the
--         order of a: K. L. Johnson, Contact Mechanics, 1985, section 8.2.
-- Units: any consistent units.
-- Expected: a mean drag below 0.1 % of the weight; an advance per radian above R by 0.07 a to 0.1 a.
-- Run: signorini objects/roller.lua [elements=48] [order=N2] [mu=0.6] [travel=0.8] [steps=80] [out=out/roller]

local sg = require "signorini"

local options = sg.arguments{ elements = { 48, at_least = 8 }, order = "N2", mu = { 0.6, above = 0 },
                              travel = { 0.8, above = 0, at_most = 1.5 }, steps = { 80, at_least = 8 },
                              out = "out/roller" }
local files = sg.files(options.out)
local R, E, nu = 0.5, 10, 0.3

local function picture(model, title)
  return sg.picture{ model = model, field = "von_mises", label = "von Mises stress", title = title }
end

--- Rolls under a weight; `pictures`: a list to which pictures of start and end are added.
local function roll(weight, pictures)
  local slab = sg.body{ patch = sg.shapes.rectangle{ width = 4, height = 1 }, order = options.order, contact = "north",
                        elements = { options.elements, options.elements // 8 },
                        material = sg.neo_hookean{ E = E, nu = nu } }
  local roller = sg.rigid.cylinder{ center = { 1.5, 1 + R }, radius = R }
  local model = sg.model{
    bodies = { slab = slab },
    supports = { bed = { on = slab:face "south", fix = "xy" },
                 axis = { on = roller, drive = "x", free = "y", rotate = true, angle = "free" } },
    loads = { weight = { on = roller, force = { 0, 0 } } },
    contacts = { roll = { slave = slab:face "north", master = roller, penalty = 1000,
                          friction = { mu = options.mu, penalty = 1000 } } } }
  local function go(stage)
    local run = model:run{ stage }
    if run.failed then error(run.failure, 0) end
    return run
  end
  go{ name = "press", steps = 3, axis = 0, weight = { 0, -weight } }
  if pictures then pictures[1] = picture(model, "pressed") end
  local run = go{ name = "roll", steps = options.steps, axis = options.travel, weight = { 0, -weight } }
  if pictures then pictures[2] = picture(model, "rolled") end
  local x, angle, drag = run:column "axis.ux", run:column "axis.angle", run:column "axis.fx"
  local first, last, mean = options.steps // 2, options.steps, 0
  for step = first + 1, last do mean = mean + drag[step] / (last - first) / weight end
  for step, force in ipairs(drag) do drag[step] = force / weight end
  return { weight = weight, width = math.sqrt(4 * weight * R * (1 - nu^2) / (math.pi * E)), x = x, drag = drag,
           mean = mean, advance = -(x[last] - x[first]) / math.rad(angle[last] - angle[first]) }
end

local results, states, rows, curves = {}, {}, {}, {}
for i, weight in ipairs{ 0.05, 0.1, 0.2, 0.4 } do
  local found = roll(weight, i == 4 and states)
  results[i] = found
  rows[i] = { weight, found.width / R, found.mean, found.advance / R, (found.advance - R) / found.width }
  curves[i] = { x = found.x, y = found.drag, label = ("weight %g"):format(weight), marker = "none" }
end
print(sg.table{ columns = { "weight", "a/R", "mean drag/weight", "advance per radian/R", "(advance - R)/a" },
                rows = rows, formats = { "%g", "%.3f", "%.4f", "%.4f", "%.3f" } })
sg.sheet{ states, columns = 2, file = files "states.png", title = "Free rolling" }
curves.file, curves.title = files "drag.png", "Drag of a roller"
curves.xlabel, curves.ylabel = "travel", "drag / weight"
sg.chart(curves)
files:report()

return results
