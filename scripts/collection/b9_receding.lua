-- B9: receding contact of a layer that a line load presses onto a half-plane of the same material.

local width = require "collection.layer".receding()
local expected = { { name = "a/h", value = width, tolerance = 0.01, kind = "closed form" } }

return {
  name = "B9", title = "Receding contact of a layer", units = "thickness of the layer, Young's modulus",
  cites = "integral equation; Keer et al. 1972",
  source = "closed form: integral equation of the layer's and the half-plane's compliance, collection/layer.lua; "
    .. "L. M. Keer, J. Dundurs, K. C. Tsai, J. Appl. Mech. 39, 1972, 1115-1120: about 1.35",
  formulations = { "gpts", "equal", "equal-multipliers" },
  set_up = { thickness = 1, width = 24, base = 24, E = 1, nu = 0.3, elements = { 120, 8, 28 } },
  variants = { { name = "P = 1e-6 E h", load = 1e-6, expected = expected },
               { name = "P = 1e-4 E h", load = 1e-4, expected = expected } },
  scene = function(s, variant, tools)
    local sg, count, e = require "signorini", tools.count, s.elements
    local material, towards = sg.linear_elastic{ E = s.E, nu = s.nu }, { elements = 0.75, length = 0.08, at = "start" }
    local layer = sg.body{ patch = sg.shapes.rectangle{ width = s.width, height = s.thickness }, order = "N2",
                           elements = { count(e[1]), count(e[2]) }, grading = { towards, false }, material = material }
    local base = sg.body{ patch = sg.shapes.rectangle{ width = s.width, height = s.base, corner = { 0, -s.base } },
                          elements = { count(e[1]), count(e[3]) }, order = "N2", material = material,
                          grading = { towards, { elements = 0.6, length = 0.1, at = "end" } } }
    local model = sg.model{
      bodies = { layer = layer, base = base },
      supports = { axis = { on = { layer:face "west", base:face "west" }, fix = "x" },
                   bed = { on = base:face "south", fix = "xy" } },
      loads = { push = { on = layer:corner "north-west", force = { 0, 0 } } },
      contacts = { seam = tools.contact{ slave = layer:face "south", master = base:face "north" } } }
    -- The contact recedes at once to its final width, which a first step with a small load leads to.
    local load = -variant.load * s.E * s.thickness / 2
    return model, { { name = "touch", steps = 1, push = { 0, load / 100 } },
                    { name = "press", steps = 1, push = { 0, load } } }, { columns = { ["a/h"] = "seam.area" } }
  end,
}
