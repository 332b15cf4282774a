-- B12: a rigid wavy surface on an elastic half-plane, Westergaard.

--- p̄/p* = sin²(π a/λ) with p* = π E* Δ/λ, and the peak pressure 2 p̄/sin(π a/λ); the surface is Δ (1 - cos 2πx/λ).
local variants = {}
for i, part in ipairs { 0.1, 0.25, 0.5, 0.75 } do
  local psi = math.asin(math.sqrt(part)) -- π a/λ
  variants[i] = { name = ("p̄/p* = %g"):format(part), part = part, expected = {
    { name = "a/λ", value = psi / math.pi, tolerance = 0.02, kind = "closed form" },
    { name = "p0/p*", value = 2 * part / math.sin(psi), tolerance = 0.02, kind = "closed form" } } }
end

return {
  name = "B12", title = "Wavy surface", units = "wavelength, Young's modulus",
  cites = "Westergaard 1939",
  source = "H. M. Westergaard, J. Appl. Mech. 6, 1939; K. L. Johnson, Contact Mechanics, 1985, 13.2",
  formulations = { "gpts", "equal", "equal-multipliers" }, variants = variants,
  set_up = { wavelength = 1, height = 2, amplitude = 1e-4, E = 1, nu = 0.3, elements = { 40, 30 } },
  scene = function(s, variant, tools)
    local sg, wave = require "signorini", s.wavelength
    local limit = math.pi * s.E / (1 - s.nu ^ 2) * s.amplitude / wave
    local slab = sg.body{ patch = sg.shapes.rectangle{ width = wave / 2, height = s.height, corner = { 0, -s.height } },
                          elements = { tools.count(s.elements[1]), tools.count(s.elements[2]) }, order = "N2",
                          grading = { false, { elements = 0.6, length = 0.15, at = "end" } },
                          material = sg.linear_elastic{ E = s.E, nu = s.nu } }
    local surface = sg.rigid.level_set{
      f = function(x, y) return s.amplitude * (1 - sg.cos(2 * math.pi / wave * x)) - y end,
      box = { { -0.1 * wave, -0.2 * wave }, { 0.6 * wave, 0.2 * wave } } }
    local model = sg.model{
      bodies = { slab = slab },
      supports = { sides = { on = { slab:face "west", slab:face "east" }, fix = "x" } },
      loads = { push = { on = slab:face "south", traction = { 0, 0 } } },
      contacts = { foot = tools.contact{ slave = slab:face "north", master = surface } } }
    return model, { { name = "press", steps = 4, push = { 0, variant.part * limit } } }, {
      columns = { ["a/λ"] = "foot.area" },
      measure = function(now)
        local highest = 0
        for _, pressure in ipairs(now:profile "foot".pressure) do highest = math.max(highest, pressure) end
        return { ["p0/p*"] = highest / limit }
      end }
  end,
}
