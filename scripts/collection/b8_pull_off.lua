-- B8: a sphere that adheres to a rigid plane by van der Waals forces: pull-off force from DMT to JKR.

--- The law has the work of adhesion W = 15^(1/3) H/(16 π r0²) and the distance z0 = 15^(-1/6) r0 without traction; the
--- Tabor parameter is (R W²/(E*² z0³))^(1/3). Between the limits 2 (rigid, exact for z0 ≪ R) and 1.5 (JKR) the value is
--- Carpick's fit to Maugis' theory, whose law of traction is another one.
local function variant(tabor)
  local x = 4.04 * (1.157 * tabor) ^ 1.4
  local fit = { name = "F/πWR", value = 7 / 4 - (x - 1) / (x + 1) / 4, kind = "comparison" }
  local rigid = { name = "F/πWR", value = 2, tolerance = 0.03, kind = "closed form" }
  return { name = ("Tabor %g"):format(tabor), tabor = tabor, expected = { tabor < 0.1 and rigid or fit } }
end

return {
  name = "B8", title = "Pull-off of a sphere", units = "radius, Young's modulus",
  cites = "Bradley 1932; Carpick et al. 1999",
  source = "R. S. Bradley, Phil. Mag. 13, 1932; D. Maugis, J. Colloid Interface Sci. 150, 1992; R. W. Carpick, D. F. "
    .. "Ogletree, M. Salmeron, J. Colloid Interface Sci. 211, 1999",
  formulations = { "gpts" }, variants = { variant(0.05), variant(0.5), variant(1.5) },
  set_up = { inner = 0.2, z0 = 0.004, E = 1, nu = 0.3, push = 0.5, pull = 6, steps = 40, elements = { 48, 12 } },
  scene = function(s, one, tools)
    local sg = require "signorini"
    local r0, modulus = 15 ^ (1 / 6) * s.z0, s.E / (1 - s.nu ^ 2)
    local work = math.sqrt(one.tabor ^ 3 * modulus ^ 2 * s.z0 ^ 3)
    local hamaker = 16 * math.pi * r0 ^ 2 * work / 15 ^ (1 / 3)
    local ball = sg.body{
      patch = sg.shapes.quarter_annulus{ inner = s.inner, outer = 1, start = 270 }, order = "N2",
      elements = { tools.count(s.elements[1]), tools.count(s.elements[2]) },
      grading = { { elements = 0.75, length = 0.25, at = "start" }, { elements = 0.6, length = 0.2, at = "start" } },
      material = sg.linear_elastic{ E = s.E, nu = s.nu } }
    local model = sg.model{
      kind = "axisymmetric", bodies = { ball = ball },
      supports = { axis = { on = ball:face "west", symmetry = true }, grip = { on = ball:face "east", drive = "y" } },
      contacts = { film = { slave = ball:face "south", adhesion = { hamaker = hamaker, r0 = r0 },
                            master = sg.rigid.plane{ point = { 0, -1 - s.z0 }, normal = { 0, 1 } } } } }
    local largest = 0
    return model, { { name = "push", steps = 2, grip = -s.push * s.z0 },
                    { name = "pull", steps = s.steps, grip = s.pull * s.z0 } }, {
      measure = function(now)
        largest = math.max(largest, now:reaction "grip".fy)
        return { ["F/πWR"] = largest / (math.pi * work) }
      end }
  end,
}
