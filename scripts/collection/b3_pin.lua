-- B3: a pin in a bore with friction, Klang. Points of the pin slide along the bore before they touch it. Here friction
-- starts where a point touches, and results do not depend on the number of steps. Code_Aster's test takes one step,
-- whose slip counts from the undeformed positions: then 28° stick here, too, and the pressure at the bottom is 18.80
-- (tests/lua/problem/collection_test.lua). Its own pressures, with elements of 3°, differ from Klang's by up to 7 %,
-- and 30° stick. Not the cause: plane strain (19.76), a rim at 3 m or twice as many elements (0.3 %).

return {
  name = "B3", title = "Pin in a bore with friction", units = "mm, N",
  cites = "Klang; Code_Aster SSNV127",
  source = "M. Klang, On interior contact under friction between cylindrical elastic bodies, Linköping, 1979, and P. "
    .. "Alart, A. Curnier, Comput. Methods Appl. Mech. Eng. 92, 1991, as printed in Code_Aster V6.04.127 (SSNV127)",
  formulations = { "gpts", "equal", "equal-multipliers" },
  set_up = { bore = 60, pin = 59.99, outer = 1000, E = 210000, nu = 0.3, mu = 0.4, force = 1875, steps = 10,
             elements = { along = 20, depth = 8, body = { 40, 12 } } },
  variants = { { name = "μ = 0.4", expected = {
    { name = "p at the bottom", value = 17.813, uncertainty = 0.03, kind = "comparison" },
    { name = "contact (°)", value = 60, uncertainty = 1, kind = "comparison" },
    { name = "stick (°)", value = 26.2, uncertainty = 1, kind = "comparison" } } } },
  scene = function(s, _, tools)
    local sg, half_disc, count = require "signorini", require "collection.half_disc", tools.count
    local material, e = sg.linear_elastic{ E = s.E, nu = s.nu }, s.elements
    local gap = s.bore - s.pin
    -- The pin starts a little too low, so that the first iteration finds points in contact.
    local patches, elements = half_disc(s.pin, { 0, -1.001 * gap }, count(e.along), count(e.depth))
    local pin = sg.body{ patch = patches, elements = elements, order = "N2", material = material }
    local quarters, inside = {}, { elements = 0.5, length = 0.1, at = "end" }
    for i, start in ipairs { 270, 0 } do
      quarters[i] = sg.shapes.quarter_annulus{ inner = s.bore, outer = s.outer, start = start }
    end
    local body = sg.body{ patch = quarters, elements = { count(e.body[1]), count(e.body[2]) }, order = "N2",
                          grading = { false, inside }, material = material }
    local axis = { body:face "1.west", body:face "2.east" }
    for _, name in ipairs { "1.west", "4.east", "5.west", "6.west" } do axis[#axis + 1] = pin:face(name) end
    local model = sg.model{
      kind = "plane_stress", bodies = { pin = pin, body = body },
      supports = { axis = { on = axis, fix = "x" },
                   rim = { on = { body:face "1.south", body:face "2.south" }, fix = "xy" } },
      loads = { push = { on = pin:corner "5.north-west", force = { 0, 0 } } },
      contacts = { joint = tools.contact{ slave = { pin:face "1.south", pin:face "2.south" },
                                          master = body:face "1.north", friction = { mu = s.mu } } } }
    return model, { { name = "press", steps = s.steps, push = { 0, -s.force / 2 } } }, {
      measure = function(now)
        local profile, bottom, nearest, contact, stick = now:profile "joint", 0, math.huge, 0, 0
        for i, X in ipairs(profile.X) do
          local angle = math.deg(math.atan(X, -(profile.Y[i] + 1.001 * gap)))
          if angle < nearest then nearest, bottom = angle, profile.pressure[i] end
          if profile.pressure[i] > 0 then
            contact = math.max(contact, angle)
            if profile.state[i] == "stick" and angle < 50 then stick = math.max(stick, angle) end
          end
        end
        return { ["p at the bottom"] = bottom, ["contact (°)"] = contact, ["stick (°)"] = stick }
      end }
  end,
}
