-- A jounce bumper of rubber that is compressed between two plates, so that its grooves close and its bore folds. The
-- rounded corners are those of quadratic B-splines in their control polygons. Lengths in mm, stresses in MPa.

local friction = require "signorini.scene.scenes.friction"
local sg = require("signorini.core").sg
local steps = require "signorini.scene.scenes.steps"

local height = 60

--- A quadratic curve with the symmetric control polygon whose lower half is given.
local function curve(lower)
  local points, knots = table.move(lower, 1, #lower, 1, {}), { 0, 0 }
  for i = #lower, 1, -1 do points[#points + 1] = { lower[i][1], height - lower[i][2] } end
  for i = 0, #points - 2 do knots[#knots + 1] = i / (#points - 2) end
  return sg.nurbs.curve { degree = 2, knots = table.move({ 1, 1 }, 1, 2, #knots + 1, knots), points = points }
end

return function(o)
  local n = o.refinement
  local outer = curve { { 30, 0 }, { 30, 12 }, { 22, 14 }, { 22, 22 }, { 30, 24 } }
  local bore = curve { { 10, 0 }, { 10, 6.5 }, { 10, 11.5 }, { 12, 24.5 }, { 14, 27.5 } }
  local bumper = sg.body {
    patch = sg.nurbs.ruled { a = outer, b = bore }, elements = { 24 * n, 3 * n }, order = o.order,
    volumetric = "projected", material = sg.yeoh { c10 = 0.752, K = 400 } }
  local outside, inside = bumper:face "south", bumper:face "north"
  local plate = sg.rigid.plane { point = { 0, height }, normal = { 0, -1 } }
  local bed = sg.rigid.plane { point = { 0, 0 }, normal = { 0, 1 } }
  local function pressed(end_face, master)
    return { slave = { outside, bumper:face(end_face), inside }, master = master, friction = friction(o.mu) }
  end
  local model = sg.model {
    kind = "axisymmetric", bodies = { bumper = bumper },
    supports = { plate = { on = plate, drive = "y", fix = "x" }, bed = { on = bed, fix = "xy" } },
    contacts = { top = pressed("east", plate), bottom = pressed("west", bed),
                 folds = o.self_contact and { among = { outside, inside } } or nil } }
  return model, { { name = "press", steps = steps(o.depth, 1), plate = -o.depth } }
end
