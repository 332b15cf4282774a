-- B11: a rigid flat punch on an elastic layer that is bonded to a rigid base.

local layer = require "collection.layer"

local variants = {}
for i, nu in ipairs { 0.3, 0.4999 } do
  variants[i] = { name = ("ν = %g"):format(nu), nu = nu,
                  expected = { { name = "κ", value = layer.punch(nu), tolerance = 0.01, kind = "closed form" } } }
end

return {
  name = "B11", title = "Flat punch on a bonded layer", units = "radius of the punch, shear modulus",
  cites = "Fredholm equation; Hayes et al. 1972",
  source = "closed form: Fredholm equation of the layer's compliance, collection/layer.lua; W. C. Hayes et al., "
    .. "J. Biomech. 5, 1972, 541-551, print 2.480 (ν = 0.3) and 3.609 (ν = 0.5)",
  formulations = { "gpts", "equal", "equal-multipliers" },
  set_up = { radius = 1, thickness = 1, width = 8, depth = 1e-3, elements = { 12, 12, 10 } },
  variants = variants,
  scene = function(s, variant, tools)
    local sg, knots = require "signorini", {}
    local inner, outer = tools.count(s.elements[1]), tools.count(s.elements[2])
    for i = 1, inner do knots[i] = (1 - (1 - i / inner) ^ 3) * s.radius / s.width end
    for i = 1, outer - 1 do knots[inner + i] = (s.radius + (s.width - s.radius) * (i / outer) ^ 3) / s.width end
    local patch = sg.shapes.rectangle{ width = s.width, height = s.thickness }:elevate(1):insert(1, knots)
    local slab = sg.body{ patch = patch, elements = { inner + outer, tools.count(s.elements[3]) }, order = "N2",
                           grading = { false, { elements = 0.5, length = 0.2, at = "end" } },
                           volumetric = variant.nu > 0.49 and "projected" or nil,
                           material = sg.linear_elastic{ E = 2 * (1 + variant.nu), nu = variant.nu } }
    local punch = sg.rigid.plane{ point = { 0, s.thickness }, normal = { 0, -1 } }
    local model = sg.model{
      kind = "axisymmetric", bodies = { layer = slab },
      supports = { axis = { on = slab:face "west", symmetry = true }, base = { on = slab:face "south", fix = "xy" },
                   punch = { on = punch, drive = "y" } },
      contacts = { foot = tools.contact{ slave = slab:face "north", master = punch,
                                         where = function(X) return X[1] <= s.radius end } } }
    return model, { { name = "press", steps = 1, punch = -s.depth } }, {
      measure = function(now)
        return { ["κ"] = -now:reaction "punch".fy * (1 - variant.nu) / (4 * s.radius * s.depth) }
      end }
  end,
}
