-- B13: a clamped column between two walls that is shortened: it buckles and touches a wall.

--- Beam theory of small slopes, gap A, P = k²EI, l = L/2. Each half is clamped at its end and touches without a slope:
--- w = c₁ (1 - cos kx) + c₂ (kx - sin kx), w(l) = A, w'(l) = 0, and shortens by ∫ w'²/2 dx. From P = 4 P_E on, where
--- the curvature at the wall vanishes, P remains constant: 1 - cos kx alone is then a solution for each half.
local set_up = { length = 100, thickness = 1, gap = 2, E = 1, side = 1e-3, beyond = 0.03, elements = { 60, 2 } }
local inertia, half = set_up.thickness ^ 3 / 12, set_up.length / 2
local euler = 4 * math.pi ^ 2 * set_up.E * inertia / set_up.length ^ 2

--- Shortening of the column under `part` P_E.
local function shortening(part)
  local k = math.sqrt(part * euler / (set_up.E * inertia))
  local s, c = math.sin(k * half), math.cos(k * half)
  local ratio = part < 4 and -(1 - c) / s or 0 -- c₁/c₂
  local c2 = set_up.gap / (ratio * (1 - c) + k * half - s)
  local sum, n = 0, 400
  for i = 0, n do -- Simpson's rule
    local x = k * half * i / n
    local slope = c2 * k * (ratio * math.sin(x) + 1 - math.cos(x))
    sum = sum + slope ^ 2 / 2 * (i % n == 0 and 1 or i % 2 == 1 and 4 or 2) * half / (3 * n)
  end
  return 2 * sum + part * euler * set_up.length / (set_up.E * set_up.thickness)
end

local variants = {}
for i, part in ipairs { 2, 3, 4 } do
  variants[i] = { name = ("P = %g P_E"):format(part),
                  shortening = shortening(part) + (part == 4 and set_up.beyond or 0),
                  expected = { { name = "P/P_E", value = part, tolerance = 0.02, kind = "closed form" } } }
end

return {
  name = "B13", title = "Column between walls", units = "thickness, Young's modulus",
  cites = "Chai 1998, beam theory",
  source = "H. Chai, Int. J. Solids Struct. 35, 1998; closed form: beam theory, in the file; a side load of a "
    .. "thousandth of P_E starts the buckling",
  formulations = { "gpts", "equal", "equal-multipliers" }, set_up = set_up, variants = variants,
  scene = function(s, variant, tools)
    local sg = require "signorini"
    -- Half of the column, with the plane of symmetry at its end x = L/2; ν = 0, as in beam theory.
    local column = sg.body{
      patch = sg.shapes.rectangle{ width = s.length / 2, height = s.thickness }, order = "N3",
      elements = { tools.count(s.elements[1]), tools.count(s.elements[2]) },
      material = sg.saint_venant_kirchhoff{ E = s.E, nu = 0 } }
    local function wall(y, up)
      return tools.contact{ slave = column:face(up and "south" or "north"),
                            master = sg.rigid.plane{ point = { 0, y }, normal = { 0, up and 1 or -1 } } }
    end
    local model = sg.model{
      bodies = { column = column },
      supports = { clamp = { on = column:face "west", drive = "x", fix = "y" },
                   middle = { on = column:face "east", fix = "x" } },
      loads = { side = { on = column:corner "north-east", force = { 0, s.side * euler / 2 } } },
      contacts = { upper = wall(s.thickness + s.gap), lower = wall(-s.gap, true) } }
    return model, { { name = "shorten", steps = 25, clamp = variant.shortening / 2 } }, {
      measure = function(now) return { ["P/P_E"] = now:reaction "clamp".fx / euler } end }
  end,
}
