-- Coulomb friction in 2D: tractions of a profile against the forces, and the effect of accepting a slipping step on the
-- equilibrium.

require "check"

local function body(patch, elements, face, E)
  return scenes.body{ patch = patch, elements = elements, contact = face, E = E }
end

--- A die that has slid by 0.5 in so many steps, all of it slipping: over a soft slab, or over a rigid plane.
local function slid(steps, rigid)
  local die = body(sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = { 0.75, 1.5 } }, { 6, 2 }, "south", 1000)
  local slab = body(sg.shapes.rectangle{ width = 3, height = 1 }, { 8, 3 }, "north", 1)
  local plane = scenes.floor(1)
  local model = sg.model{
    bodies = not rigid and { die = die, slab = slab } or { die = die },
    supports = { bed = not rigid and { on = slab:face "south", fix = "xy" } or nil,
                 grip = { on = { die:face "west", die:face "east" }, drive = "xy" } },
    contacts = { touch = { slave = die:face "south", master = rigid and plane or slab:face "north", penalty = 100,
                           friction = { mu = 0.2, penalty = 100 } } },
  }
  local down = rigid and -0.001 or -0.1
  check.completed(model:run{ { steps = 12, grip = { 0, down } }, { steps = steps, grip = { 0.5, down } } })
  return model
end

check.case("at slip, |traction| is mu times the pressure, along the motion of the slave", function()
  local profile, slips = slid(10):profile "touch", 0
  for i, state in ipairs(profile.state) do
    if state == "slip" then
      slips = slips + 1
      check.within("traction", profile.traction[i] / profile.pressure[i], 0.2, 1e-14)
    end
  end
  check.equal(slips, 9)
end)

--- The largest residual of the accepted state, in parts of the force that the grip exerts.
local function unbalanced(model)
  local largest, force = 0, model:reaction "grip"
  for _, value in ipairs(model:residual()) do largest = math.max(largest, math.abs(value)) end
  return largest / math.sqrt(force[1] ^ 2 + force[2] ^ 2)
end

check.case("slip points on a curved master cause an unbalanced force of the order of the step", function()
  local last
  for _, steps in ipairs { 10, 20, 40 } do
    local now = unbalanced(slid(steps))
    if last then check.within("part that half the step leaves", now / last, 0.5, 0.03) end
    last = now
  end
end)

check.case("on a straight master an accepted step remains in equilibrium", function()
  check.at_most("residual", unbalanced(slid(10, true)), 1e-9)
end)

check.case("springs shorter than rounding errors of positions are no unfinished searches", function()
  -- Two blocks on a slab, held by contact and friction alone, are pushed together: near the ends of the faces points
  -- slip under pressures close to zero, where springs of the length mu p/penalty are below 1e-9.
  local E, y, bodies, contacts = 210000, 0, {}, {}
  local function block(width, bottom, elements)
    return scenes.body{ size = {width, 2}, corner = { -width / 2, bottom }, elements = { elements, 2 },
      contact = { "south", "north" }, E = E }
  end
  bodies[0] = block(14, -2, 10)
  for i = 1, 2 do
    y = y + 0.01
    bodies[i] = block(12 - 1.3 * i, y, 8 + i)
    contacts["c" .. i] = { slave = bodies[i]:face "south", master = bodies[i - 1]:face "north", penalty = 10 * E,
                           friction = { mu = 0.2, penalty = 10 * E } }
    y = y + 2
  end
  local model = sg.model{
    bodies = { base = bodies[0], b1 = bodies[1], b2 = bodies[2] }, contacts = contacts,
    supports = { bed = { on = bodies[0]:face "south", fix = "xy" },
                 push = { on = bodies[2]:face "north", drive = "y" } },
  }
  check.completed(model:run{ { steps = 4, push = -0.025 } })
  check.equal({ model:contact_resultant "c1".unsettled, model:contact_resultant "c2".unsettled }, { 0, 0 })
end)

check.case("energies are strict about names", function()
  check.fails(function() return slid(10):energy().frictoin end,
    "model:energy() has no 'frictoin'; did you mean 'friction'?")
end)
