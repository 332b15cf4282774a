-- Rigid obstacles in 3D: in plane strain they act as their sections in the plane model, a sphere acts along its axis.

require "check"

--- The forces, first all horizontal, then all vertical ones, on a rigid obstacle that is pressed into a bed of width 3
--- and height 1 (and depth 0.5 in 3D) and dragged along, per unit depth. `law`: adhesion instead of penalty and
--- friction.
local function drag(obstacle, flat, law)
  local shape = flat and sg.shapes.rectangle{ width = 3, height = 1 } or
    sg.nurbs.extrude{ patch = sg.shapes.rectangle{ width = 3, height = 1 }, along = {0, 0, 0.5} }
  local b = scenes.body{ patch = shape, elements = flat and {6, 2} or {6, 2, 1}, contact = "north",
    order = flat and "N2-N2.1" or {"N2-N2.1", "N1"}, E = 10 }
  local supports = { bed = { on = b:face "south", fix = "xy" }, punch = { on = obstacle, drive = "xy" } }
  if not flat then supports.sides = { on = { b:face "front", b:face "back" }, fix = "z" } end
  local model = scenes.model{ bodies = { b = b }, supports = supports,
    contacts = { joint = { slave = "north", master = obstacle, points = 9, penalty = not law and 100 or nil,
                           friction = not law and { mu = 0.3, penalty = 100 } or nil, adhesion = law } } }
  local run = check.completed(model:run{ { steps = 2, punch = {0, -0.1} }, { steps = 3, punch = {0.3, -0.1} } })
  local forces, depth = {}, flat and 1 or 0.5
  for _, name in ipairs{ "punch.fx", "punch.fy" } do
    for step, force in ipairs(run:column(name)) do forces[#forces + 1] = force / depth end
  end
  return forces
end

check.case("in plane strain a cylinder and a surface act as the disc and the curve that they are made of", function()
  local disc = drag(sg.rigid.cylinder{ center = {1.3, 2}, radius = 1 }, true)
  assert(disc[5] > 0.05 and disc[10] < -0.5)
  check.near(drag(sg.rigid.cylinder{ center = {1.3, 2, 7}, axis = {0, 0, -2}, radius = 1 }), disc, 1e-8)
  -- The arc's outside is on its right; extruded along z its tangents' product points there, too.
  local arc = sg.nurbs.arc{ center = {1.3, 2}, radius = 1, from = 180, to = 360 }
  check.near(drag(sg.rigid.surface(arc), true), disc, 1e-7)
  check.near(drag(sg.rigid.surface(sg.nurbs.extrude{ patch = arc, along = {0, 0, 0.5} })), disc, 1e-7)
end)

check.case("in plane strain adhesion acts on a solid as on the plane body", function()
  local law = { hamaker = 0.05, r0 = 0.1 }
  local flat = drag(sg.rigid.cylinder{ center = {1.3, 2.15}, radius = 1 }, true, law)
  assert(flat[7] > 0.1) -- the bed attracts the cylinder, its support pulls
  check.near(drag(sg.rigid.cylinder{ center = {1.3, 2.15, 0}, axis = {0, 0, 1}, radius = 1 }, false, law), flat, 1e-8)
end)

check.case("a sphere pressed into a block: the force points along its axis of symmetry", function()
  local b = scenes.body{ size = {2, 2, 1}, corner = {-1, -1, 0}, elements = {4, 4, 2}, order = "N2-N2.1",
    contact = "back", E = 10 }
  local sphere = sg.rigid.sphere{ center = {0, 0, 2}, radius = 1 }
  local model = scenes.model{ bodies = { b = b },
    supports = { bed = { on = "front", fix = "xyz" }, ball = { on = sphere, drive = "xyz" } },
    contacts = { joint = { slave = "back", master = sphere, penalty = 100, points = 5 } } }
  local run = check.completed(model:run{ { steps = 2, ball = {0, 0, -0.2} } })
  local force = run:column "ball.fz"[2]
  assert(force < -0.5)
  check.near({ run:column "ball.fx"[2], run:column "ball.fy"[2], run:column "bed.fz"[2] }, { 0, 0, -force }, 1e-8)
  local before = model:snapshot()
  model:run{ { steps = 1, ball = {0, 0.1, -0.2} } }
  model:restore(before)
  check.near(model:reaction "ball", { 0, 0, force }, 1e-8)
  check.near(model:target "ball", { 0, 0, -0.2 })
end)
