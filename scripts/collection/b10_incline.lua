-- B10: a block that a horizontal force pushes up an incline.

local exact = {}

--- F/G = (tan α + μ)/(1 − μ tan α), equilibrium with full slip.
for i, mu in ipairs { 0, 0.1, 0.2, 0.3 } do
  exact[i] = { name = ("μ = %g"):format(mu), mu = mu, expected = {
    { name = "F/G", value = (0.1 + mu) / (1 - 0.1 * mu), tolerance = 1e-4, kind = "closed form" } } }
end

return {
  name = "B10", title = "Block on an incline",
  cites = "NAFEMS CGS-4; FrontISTR",
  source = "NAFEMS CGS-4; FrontISTR tutorial MR 599. Closed form: F/G = (tan α + μ)/(1 − μ tan α)",
  units = "any", formulations = { "gpts", "equal", "equal-multipliers" }, variants = exact,
  set_up = { width = 4, height = 1, E = 1000, nu = 0.3, slope = 0.1, weight = 1, push = 0.02, elements = { 8, 2 } },
  scene = function(s, variant, tools)
    local sg, angle = require "signorini", math.deg(math.atan(s.slope))
    local slope = math.rad(angle)
    local patch = sg.shapes.rectangle{ width = s.width, height = s.height }:rotate{ angle = angle }
    local block = sg.body{ patch = patch, elements = { tools.count(s.elements[1]), tools.count(s.elements[2]) },
                           order = "N2", material = sg.linear_elastic{ E = s.E, nu = s.nu } }
    local plane = sg.rigid.plane{ point = { 0, 0 }, normal = { -math.sin(slope), math.cos(slope) } }
    local model = sg.model{
      bodies = { block = block }, supports = { push = { on = block:face "west", drive = "x" } },
      loads = { weight = { on = block, force = { 0, 0 } } },
      contacts = { foot = tools.contact{ slave = block:face "south", master = plane,
                                         friction = variant.mu > 0 and { mu = variant.mu } or nil } } }
    local g = -s.weight / (s.width * s.height)
    return model, { { name = "weight", steps = 1, push = 0, weight = { 0, g } },
                    { name = "push", steps = 4, push = s.push, weight = { 0, g } } },
      { measure = function(now) return { ["F/G"] = -now:reaction "push".fx / now:reaction "weight".fy } end }
  end,
}
