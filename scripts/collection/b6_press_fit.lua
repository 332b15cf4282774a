-- B6: a soft block that is pushed through a narrowing channel, with friction. Both faces have corners, where pressures
-- are singular, so that forces decrease with the elements. Kratos' mesh has 5 × 3 elements of degree 1 in the block,
-- which lock at its Poisson's ratio, and 18 × 3 in the channel.

--- Peak and end of a published curve.
local function expected()
  return { { name = "largest force", value = 36500, uncertainty = 400, kind = "comparison" },
           { name = "force at the end", value = 25050, uncertainty = 250, kind = "comparison" } }
end

return {
  name = "B6", title = "Press fit", units = "mm, N",
  cites = "Fischer, Wriggers 2006; Kratos",
  source = "K. A. Fischer, P. Wriggers, Comput. Methods Appl. Mech. Eng. 195, 2006; Kratos, "
    .. "contact_structural_mechanics/validation/press_fit: peak and end of its curve \"Reference\", read to 1 %",
  formulations = { "gpts", "equal", "equal-multipliers" },
  variants = { { name = "μ = 0.1", expected = expected() },
               { name = "μ = 0.1, degree 1, 5 × 3", order = "L1", formulations = { "gpts", "equal" },
                 elements = { block = { 5, 3 }, channel = { 19, 3 } }, expected = expected() } },
  set_up = { block = { 450, 200, 1000, 0.47 }, channel = { { 0, 0 }, { 800, 0 }, { 1000, 50 }, { 1900, 50 } },
             depth = 250, E = 21000, nu = 0.3, overlap = 1, way = 1000, mu = 0.1, steps = 100,
             elements = { block = { 18, 8 }, channel = { 38, 4 } } },
  scene = function(s, variant, tools)
    local sg, count, length = require "signorini", tools.count, s.channel[4][1]
    local e, order = variant.elements or s.elements, variant.order or "N2"
    local width, height, E, nu = table.unpack(s.block)
    local surface = sg.nurbs.curve{ degree = 1, points = s.channel,
                                    knots = { 0, 0, s.channel[2][1] / length, s.channel[3][1] / length, 1, 1 } }
    local bottom = sg.nurbs.line{ from = { 0, -s.depth }, to = { length, -s.depth } }
    local channel = sg.body{ patch = sg.nurbs.ruled{ a = bottom, b = surface }, order = order,
                             elements = { count(e.channel[1]), count(e.channel[2]) },
                             material = sg.neo_hookean{ E = s.E, nu = s.nu } }
    local block = sg.body{ patch = sg.shapes.rectangle{ width = width, height = height }, order = order,
                           elements = { count(e.block[1]), count(e.block[2]) },
                           material = sg.neo_hookean{ E = E, nu = nu } }
    local model = sg.model{
      bodies = { block = block, channel = channel },
      supports = { bed = { on = channel:face "south", fix = "xy" }, push = { on = block:face "west", drive = "x" },
                   axis = { on = block:face "north", drive = "y" } },
      contacts = { wall = tools.contact{ slave = block:face "south", master = channel:face "north",
                                         friction = { mu = s.mu } } } }
    local largest = 0
    return model, { { name = "fit", steps = 2, push = 0, axis = -s.overlap },
                    { name = "push", steps = s.steps, push = s.way, axis = -s.overlap } }, {
      measure = function(now)
        local force = now:reaction "push".fx
        largest = math.max(largest, force)
        return { ["largest force"] = largest, ["force at the end"] = force }
      end }
  end,
}
