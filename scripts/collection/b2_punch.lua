-- B2: a steel punch with a rounded edge on an aluminum foundation, NAFEMS contact benchmark 2.

--- Printed values: of quadratic elements, whose difference from those of linear ones is the uncertainty. Friction makes
--- |σ_yy| smaller with the linear ones (-91.10, -88.67) and larger with the quadratic ones, as here; the stresses are
--- extrapolated to the node on the axis. The pressure is steep at the edge of the contact: u_y and σ_yy of the elements
--- here tend to -0.1339 and -87.1 without friction. Laws for large strains change them by 0.2 % or less.
local function expected(uy, syy, spread_u, spread_s)
  return { { name = "u_y", value = uy, uncertainty = spread_u, kind = "comparison" },
           { name = "σ_yy", value = syy, uncertainty = spread_s, kind = "comparison" } }
end

return {
  name = "B2", title = "Punch with a rounded edge", units = "mm, N",
  cites = "NAFEMS R0094, 2; Code_Aster SSNA122",
  source = "A. Konter, Advanced finite element contact benchmarks, NAFEMS R0094, 2006, 2; Code_Aster V6.01.122 "
    .. "(SSNA122), files ssna122a to d",
  formulations = { "gpts", "equal", "equal-multipliers" },
  set_up = { punch = { radius = 50, height = 100, fillet = 10, E = 210000 }, nu = 0.3, pressure = 100,
             foundation = { radius = 100, height = 200, E = 70000 },
             elements = { punch = { 24, 12 }, foundation = { 40, 20 } } },
  variants = { { name = "μ = 0", mu = 0, expected = expected(-0.132941, -94.12, 2.2e-3, 3.1) },
               { name = "μ = 0.1", mu = 0.1, expected = expected(-0.130794, -95.47, 2.3e-3, 6.9) } },
  scene = function(s, variant, tools)
    local sg, count = require "signorini", tools.count
    local p, f, e = s.punch, s.foundation, s.elements
    local flat = p.radius - p.fillet
    -- The bottom, a line and a quarter circle, and the top.
    local bottom = sg.nurbs.curve{
      degree = 2, knots = { 0, 0, 0, 0.75, 0.75, 1, 1, 1 }, weights = { 1, 1, 1, math.sqrt(0.5), 1 },
      points = { { 0, 0 }, { flat / 2, 0 }, { flat, 0 }, { p.radius, 0 }, { p.radius, p.fillet } } }
    local top = sg.nurbs.line{ from = { 0, p.height }, to = { p.radius, p.height } }
    local punch = sg.body{ patch = sg.nurbs.ruled{ a = bottom, b = top }, order = "N2",
                           elements = { count(e.punch[1]), count(e.punch[2]) },
                           grading = { false, { elements = 0.5, length = 0.2, at = "start" } },
                           material = sg.linear_elastic{ E = p.E, nu = s.nu } }
    -- Elements that are small around the edge of the contact, at r = flat.
    local knots, inner, outer = {}, math.max(1, count(e.foundation[1] / 2)), math.max(1, count(e.foundation[1] / 2))
    for i = 1, inner do knots[#knots + 1] = flat / f.radius * (1 - (1 - i / inner) ^ 1.5) end
    for i = 1, outer - 1 do knots[#knots + 1] = (flat + (f.radius - flat) * (i / outer) ^ 1.8) / f.radius end
    local patch = sg.shapes.rectangle{ width = f.radius, height = f.height, corner = { 0, -f.height } }
      :elevate(1):insert(1, knots)
    local foundation = sg.body{ patch = patch, elements = { inner + outer, count(e.foundation[2]) }, order = "N2",
                                grading = { false, { elements = 0.5, length = 0.15, at = "end" } },
                                material = sg.linear_elastic{ E = f.E, nu = s.nu } }
    local model = sg.model{
      kind = "axisymmetric", bodies = { punch = punch, foundation = foundation },
      supports = { axis = { on = { punch:face "west", foundation:face "west" }, symmetry = true },
                   bed = { on = foundation:face "south", fix = "xy" } },
      loads = { push = { on = punch:face "north", pressure = 0 } },
      contacts = { foot = tools.contact{ slave = foundation:face "north", master = punch:face "south",
                                         friction = variant.mu > 0 and { mu = variant.mu } or nil } } }
    return model, { { name = "press", steps = 2, push = s.pressure } }, {
      measure = function(now)
        return { u_y = now:sample("foundation", "uy", { 0, 1 }), ["σ_yy"] = now:sample("foundation", "syy", { 0, 1 }) }
      end }
  end,
}
