-- B4: a plate that is pressed onto a plane with friction and pushed along it, GRECO. The points A to E are nodes of the
-- meshes there, 1.25 mm apart.

local points = { A = 28.6, B = 27.2, C = 22.8, D = 19.8, E = 15.4 }
local expected = {}
for _, name in ipairs { "A", "B", "C", "D", "E" } do
  expected[#expected + 1] = { name = name, value = points[name], kind = "comparison" }
end

return {
  name = "B4", title = "Plate on a plane with friction", units = "mm, N; u_x in µm",
  cites = "GRECO; Code_Aster SSNV128",
  source = "R. A. Feijóo, H. J. C. Barbosa, N. Zouain, J. Theor. Appl. Mech.; Code_Aster V6.04.128 (SSNV128), means of "
    .. "several programs",
  formulations = { "gpts", "equal", "equal-multipliers" },
  set_up = { width = 40, height = 40, E = 130000, nu = 0.2, mu = 1, side = 150, top = 50, elements = { 24, 24 },
             at = { A = 0, B = 1.25, C = 5, D = 7.5, E = 11.25 } },
  variants = { { name = "one step", expected = expected } },
  scene = function(s, _, tools)
    local sg = require "signorini"
    local plate = sg.body{ patch = sg.shapes.rectangle{ width = s.width, height = s.height }, order = "N2",
                           elements = { tools.count(s.elements[1]), tools.count(s.elements[2]) },
                           material = sg.linear_elastic{ E = s.E, nu = s.nu } }
    local model = sg.model{
      bodies = { plate = plate }, supports = { axis = { on = plate:face "east", fix = "x" } },
      loads = { side = { on = plate:face "west", pressure = 0 }, top = { on = plate:face "north", pressure = 0 } },
      contacts = { foot = tools.contact{ slave = plate:face "south", friction = { mu = s.mu },
                                         master = sg.rigid.plane{ point = { 0, 0 }, normal = { 0, 1 } } } } }
    return model, { { name = "press", steps = 1, side = s.side, top = s.top } }, {
      measure = function(now)
        local list = {}
        for name, x in pairs(s.at) do list[name] = 1000 * now:sample("plate", "ux", { x / s.width, 0 }) end
        return list
      end }
  end,
}
