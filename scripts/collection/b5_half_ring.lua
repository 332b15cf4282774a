-- B5: a half ring of two layers that is pushed into a soft block and buckles.

--- Data of Kratos' files and of Code_Aster V6.03.165. In the figures the ring's middle sinks by 6 before the ring
--- buckles, here by 2; with stiff = 3e5 the results are -5.85, -2.4 and 55.3, close to the figures. Elements of degree
--- 1, as in both programs, lock: they do not bend, and the ring is too stiff, but on Kratos' mesh, the first variant,
--- only by a part of this; the second one has half as many elements along the ring and across each layer.
--- Displacements of the middle, in mm, read from the curve "Reference" of Kratos' figures: ± 0.5 mm.
local function expected(at20, at40, at70)
  return { { name = "u_y at 20", value = at20, uncertainty = 0.5, kind = "comparison" },
           { name = "u_y at 40", value = at40, uncertainty = 0.5, kind = "comparison" },
           { name = "u_y at 69.5", value = at70, uncertainty = 0.5, kind = "comparison" } }
end

return {
  name = "B5", title = "Half ring pushed into a block", units = "mm, N",
  cites = "Poulios, Renard 2015; Kratos",
  source = "K. Poulios, Y. Renard, Comput. Struct. 153, 2015; Kratos, contact_structural_mechanics/validation/"
    .. "double_arch",
  formulations = { "gpts", "equal", "equal-multipliers" },
  variants = { { name = "μ = 0", mu = 0, expected = expected(-5.8, -3.5, 56.3) },
               { name = "μ = 0.5", mu = 0.5, expected = expected(-5.9, -4.25, 10.8) },
               { name = "μ = 0, degree 1, 30 × 2", mu = 0, order = "L1", formulations = { "gpts" },
                 elements = { ring = { 30, 2 }, base = { 25, 7 } }, expected = expected(-5.8, -3.5, 56.3) },
               { name = "μ = 0, degree 1, 15 × 1", mu = 0, order = "L1", formulations = { "gpts" },
                 elements = { ring = { 15, 1 }, base = { 15, 5 } }, expected = expected(-5.8, -3.5, 56.3) } },
  set_up = { outer = 95, middle = 90, inner = 85, soft = 1000, stiff = 1e5, base = { 250, 50, 300 }, nu = 0.3,
             down = 69.5, steps = 139, elements = { ring = { 40, 2 }, base = { 24, 6 } } },
  scene = function(s, variant, tools)
    local sg, count, e = require "signorini", tools.count, variant.elements or s.elements
    local center = { 0, s.outer }
    local function layer(inner, outer, E)
      return sg.body{ patch = sg.shapes.quarter_annulus{ inner = inner, outer = outer, center = center, start = 270 },
                      elements = { count(e.ring[1]), count(e.ring[2]) }, order = variant.order or "N2",
                      material = sg.neo_hookean{ E = E, nu = s.nu } }
    end
    local soft, stiff = layer(s.middle, s.outer, s.soft), layer(s.inner, s.middle, s.stiff)
    local base = sg.body{
      patch = sg.shapes.rectangle{ width = s.base[1] / 2, height = s.base[2], corner = { 0, -s.base[2] } },
      elements = { count(e.base[1]), count(e.base[2]) }, order = variant.order or "N2",
      material = sg.neo_hookean{ E = s.base[3], nu = s.nu } }
    local model = sg.model{
      bodies = { soft = soft, stiff = stiff, base = base },
      joins = { seam = { soft:face "north", stiff:face "south" } },
      supports = { axis = { on = { soft:face "west", stiff:face "west", base:face "west" }, fix = "x" },
                   bed = { on = base:face "south", fix = "xy" },
                   ends = { on = { soft:face "east", stiff:face "east" }, drive = "xy" } },
      contacts = { touch = tools.contact{ slave = soft:face "south", master = base:face "north",
                                          friction = variant.mu > 0 and { mu = variant.mu } or nil } } }
    local results = { ["u_y at 20"] = 0, ["u_y at 40"] = 0, ["u_y at 69.5"] = 0 }
    return model, { { name = "push", steps = s.steps, ends = { 0, -s.down } } }, {
      measure = function(now)
        local at = ("u_y at %g"):format(math.floor(-now:target("ends")[2] * 2 + 0.5) / 2)
        if results[at] then results[at] = now:sample("stiff", "uy", { 0, 1 }) end
        local copy = {}
        for name, value in pairs(results) do copy[name] = value end
        return copy
      end }
  end,
}
