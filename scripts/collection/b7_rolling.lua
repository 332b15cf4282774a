-- B7: tractive rolling of a cylinder, Carter.

--- A rigid cylinder on an incompressible half-plane: normal and tangential tractions do not couple, as of two equal
--- elastic cylinders. With P per depth, 1/E* = (1 - ν²)/E: a² = 4 P R/(π E*). The creep ξ = (μ a/R)(1 - √(1 - Q/(μ P)))
--- follows from Carter's traction, an ellipse over the contact less one over the stick strip at its leading edge,
--- whose half-width is a √(1 - Q/(μ P)): strains in the strip are uniform and add up to ξ. It leaves out that arcs are
--- longer than their chords, (a/R)²/6 in the mean: the uncertainty of ξ.
local set_up = { radius = 1, half_width = 0.02, width = 0.8, height = 0.4, E = 1, nu = 0.4999, mu = 0.3,
                 rolled = 4, steps = 80, elements = { 76, 18 } }

local variants = {}
for i, part in ipairs { 0.5, 0.7 } do
  local strip = math.sqrt(1 - part)
  variants[i] = { name = ("Q/μP = %g"):format(part), part = part, expected = {
    { name = "ξ R/μa", value = 1 - strip, uncertainty = set_up.half_width / (6 * set_up.mu * set_up.radius),
      tolerance = 0.03, kind = "closed form" },
    { name = "stick", value = strip, tolerance = 0.05, kind = "closed form" } } }
end

return {
  name = "B7", title = "Tractive rolling", units = "radius of the cylinder, Young's modulus",
  cites = "Carter 1926, derived",
  source = "F. W. Carter, Proc. R. Soc. A 112, 1926; K. L. Johnson, Contact Mechanics, 1985, 8.3; derived in the file",
  formulations = { "gpts", "equal" }, variants = variants, set_up = set_up,
  scene = function(s, variant, tools)
    local sg, a, R, count = require "signorini", s.half_width, s.radius, tools.count
    local P = math.pi * s.E / (1 - s.nu ^ 2) * a ^ 2 / (4 * R)
    -- Equal elements along the path of the contact, of a third of them outside.
    local path, knots, inner, outer = (s.rolled + 4) * a, {}, count(s.elements[1]), count(8)
    local from, to = (s.width - path) / 2, (s.width + path) / 2
    for i = 1, outer - 1 do knots[#knots + 1] = from * (1 - (1 - i / outer) ^ 2) / s.width end
    for i = 0, inner do knots[#knots + 1] = (from + path * i / inner) / s.width end
    for i = 1, outer - 1 do knots[#knots + 1] = (to + (s.width - to) * (i / outer) ^ 2) / s.width end
    local patch = sg.shapes.rectangle{ width = s.width, height = s.height, corner = { 0, -s.height } }
    local slab = sg.body{ patch = patch:elevate(1):insert(1, knots), order = "N2",
                          elements = { inner + 2 * outer, count(s.elements[2]) },
                          grading = { false, { elements = 0.6, length = 0.1, at = "end" } },
                          volumetric = "projected", material = sg.linear_elastic{ E = s.E, nu = s.nu } }
    local x0 = from + 2 * a
    -- The wheel starts a little too low, so that the first iteration finds points in contact.
    local wheel = sg.rigid.cylinder{ center = { x0, R - 0.05 * a ^ 2 / R }, radius = R }
    local model = sg.model{
      bodies = { slab = slab },
      supports = { bed = { on = slab:face "south", fix = "xy" },
                   axis = { on = wheel, drive = "x", free = "y", rotate = true, angle = "free" } },
      loads = { weight = { on = wheel, force = { 0, 0 } }, torque = { on = wheel, moment = 0 } },
      contacts = { roll = tools.contact{ slave = slab:face "north", master = wheel, friction = { mu = s.mu } } } }
    -- The torque turns the wheel clockwise, so that it pulls; what it advances less than its circumference is creep.
    -- Means over the second half of the way, since both oscillate with the elements.
    local torque, way, first, strips = -variant.part * s.mu * P * R, s.rolled * a, nil, {}
    return model, { { name = "press", steps = 2, axis = 0, weight = { 0, -P }, torque = 0 },
                    { name = "pull", steps = 4, axis = 0, weight = { 0, -P }, torque = torque },
                    { name = "roll", steps = s.steps, axis = way, weight = { 0, -P }, torque = torque } }, {
      measure = function(now)
        local x, angle = now:target("axis")[1], now:free_motion "axis".angle
        if x < way / 2 then return { ["ξ R/μa"] = 0, stick = 0 } end
        local profile, all, stick, mean = now:profile "roll", 0, 0, 0
        for i, state in ipairs(profile.state) do
          if state ~= "open" then all = all + profile.area[i] end
          if state == "stick" then stick = stick + profile.area[i] end
        end
        strips[#strips + 1] = stick / all
        for _, strip in ipairs(strips) do mean = mean + strip / #strips end
        first = first or { x = x, angle = angle }
        local creep = x > first.x and math.rad(first.angle - angle) * R / (x - first.x) - 1 or 0
        return { ["ξ R/μa"] = creep * R / (s.mu * a), stick = mean }
      end }
  end,
}
