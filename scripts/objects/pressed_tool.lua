-- A rigid ironing tool under a constant force, compared with a deformable die.
--
-- Problem: plane strain; a slab of 3 × 1, E = 1, nu = 0.3, is pressed by a force P per unit depth and dragged along,
--          friction mu: by a rigid cylinder of the radius 0.5, whose height is an unknown, and by the half ring of
--          the ironing benchmark (V. Agrawal, thesis, IIT Guwahati, 2020, 7.1) with E = 1000, whose ends are guided:
--          they do not rotate and are free vertically.
-- Source: equilibrium; the work of the load, the drive and friction.
-- Units: those of E and the size of the slab; any consistent ones.
-- Expected: the contact carries P in every step; drag and sinking of both agree within 0.5 %; the rigid tool takes
--           0.8 of the time.
-- Run: signorini objects/pressed_tool.lua [refinement=2] [order=N2] [P=0.15] [mu=0.2] [distance=1]
--      [steps=50] [out=out/pressed_tool]

local sg = require "signorini"

local options = sg.arguments{ refinement = { 2, at_least = 1 }, order = "N2", P = { 0.15, above = 0 },
                              mu = { 0.2, at_least = 0 }, distance = { 1, above = 0, at_most = 1.5 },
                              steps = { 50, at_least = 2 }, out = "out/pressed_tool" }
local files = sg.files(options.out)
local n, P = options.refinement, options.P

--- A model with a rigid or a deformable tool, and the load at full force.
local function scene(rigid)
  local slab = sg.body{ patch = sg.shapes.rectangle{ width = 3, height = 1 }, elements = { 12 * n, 3 * n },
                        order = options.order, contact = "north", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  local contact = { slave = slab:face "north", penalty = 100, friction = { mu = options.mu, penalty = 100 } }
  local parts = { bodies = { slab = slab }, contacts = { press = contact },
                  supports = { bed = { on = slab:face "south", fix = "xy" } } }
  if rigid then
    local tool = sg.rigid.cylinder{ center = { 0.75, 1.5 }, radius = 0.5 }
    contact.master = tool
    parts.supports.tool = { on = tool, free = "y", drive = "x" }
    parts.loads = { weight = { on = tool, force = { 0, 0 } } }
    return sg.model(parts), { 0, -P }
  end
  local die = sg.body{ patch = sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = { 0.75, 1.5 } },
                       elements = { 6 * n, 2 * n }, order = options.order, contact = "south",
                       material = sg.neo_hookean{ E = 1000, nu = 0.3 } }
  contact.master, parts.bodies.die = die:face "south", die
  for name, face in pairs{ tool = "west", guide = "east" } do
    parts.supports[name] = { on = die:face(face), drive = "x", rotate = true }
  end
  parts.loads = { weight = { on = { die:face "west", die:face "east" }, traction = { 0, 0 } } }
  return sg.model(parts), { 0, -P / 0.4 }
end

local function ironed(rigid)
  local model, weight = scene(rigid)
  local function height()
    if rigid then return model:free_motion("tool").uy end
    return (model:sample("die", "uy", { 0, 0.5 }) + model:sample("die", "uy", { 1, 0.5 })) / 2 -- of the ends
  end
  local slide = { name = "slide", steps = options.steps, tool = options.distance, weight = weight }
  if not rigid then slide.tool, slide.guide = { options.distance, 0 }, { options.distance, 0 } end
  local run = model:run({ { name = "press", steps = 5, weight = weight }, slide },
                        { on_step = function()
                            return { height = height(), drag = model:contact_resultant("press").fx }
                          end })
  if run.failed then error(run.failure, 0) end
  return { model = model, run = run, drag = run:column "drag", height = run:column "height",
           x = run:column "tool.ux", normal = run:column "press.fy", wall = run.wall, unknowns = model:cost().unknowns }
end

local rigid, die = ironed(true), ironed(false)
local last = #rigid.drag
print(sg.table{ columns = { "", "rigid tool", "deformable die" }, formats = { "%s", "%.6g", "%.6g" },
                rows = { { "force on the slab", rigid.normal[last], die.normal[last] },
                         { "drag", rigid.drag[last], die.drag[last] },
                         { "sinking", -rigid.height[last], -die.height[last] },
                         { "unknowns", rigid.unknowns, die.unknowns },
                         { "iterations", rigid.run.iterations, die.run.iterations },
                         { "wall time (s)", rigid.wall, die.wall } } })
sg.chart{ file = files "drag.png", title = "Ironing under a constant force", xlabel = "travel", ylabel = "drag",
          { x = rigid.x, y = rigid.drag, label = "rigid tool", marker = "none" },
          { x = die.x, y = die.drag, label = "deformable die, E = 1000", marker = "none", dashed = true } }
sg.sheet{ { sg.picture{ model = rigid.model, field = "von_mises", label = "von Mises stress / E",
                        title = "rigid tool" },
            sg.picture{ model = die.model, field = "von_mises", label = "von Mises stress / E", gray = { "die" },
                        title = "deformable die" } },
          columns = 2, file = files "states.png", title = "Ironing under a constant force" }
files:report()

return { rigid = rigid, die = die }
