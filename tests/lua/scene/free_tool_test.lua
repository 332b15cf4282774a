-- Rigid obstacles that loads move and turn: equilibrium, rolling, and moments, against closed forms.

require "check"

local completed, last = check.completed, check.last

local soft = sg.neo_hookean{ E = 10, nu = 0.3 }

--- A slab of width 4 and height 1 under a cylinder of radius 0.5, with these keys of contact, support and loads.
local function rolled(contact, support, loads, height)
  local slab = scenes.body{ size = {4, 1}, elements = {24, 3}, contact = "north", E = 10 }
  local tool = sg.rigid.cylinder{ center = {1.5, 1.5 + (height or 0)}, radius = 0.5 }
  local model = { bodies = { slab = slab }, supports = { bed = { on = slab:face "south", fix = "xy" }, tool = support },
                  contacts = { press = { slave = slab:face "north", master = tool, penalty = 200 } }, loads = loads }
  for key, value in pairs(contact) do model.contacts.press[key] = value end
  support.on = tool
  for _, load in pairs(loads or {}) do load.on = tool end
  return sg.model(model)
end

local methods = { penalty = {}, mortar = { method = "mortar" },
                  multipliers = { method = "mortar", enforcement = "multipliers" } }

check.case("a free tool under a force is where a prescribed one needs that force", function()
  for name, method in pairs(methods) do
    local free = rolled(method, { free = "y" }, { weight = { force = {0, 0} } })
    local pressed = completed(free:run{ { steps = 4, weight = {0, -0.8} } })
    local depth = last(pressed, "tool.uy")
    assert(depth < -0.03)
    check.within(name .. ": contact", last(pressed, "press.fy"), -0.8, 1e-8)
    check.within(name .. ": bed", last(pressed, "bed.fy"), 0.8, 1e-8)
    local driven = rolled(method, { drive = "y" })
    local run = completed(driven:run{ { steps = 4, tool = {depth} } })
    check.within(name, last(run, "tool.fy"), -0.8, 1e-8)
  end
end)

check.case("reactions are in equilibrium if supports share the tool, also of components that none names", function()
  local friction = { friction = { mu = 0.3, penalty = 200 } }
  local function balanced(extra, support, stage)
    local tool = sg.rigid.cylinder{ center = {3.8, 1.5}, radius = 0.5 } -- over the end: forces have both components
    support.on, extra.on = tool, tool
    local model = scenes.model{ bodies = { slab = { size = {4, 1}, elements = {24, 3}, contact = "north", E = 10 } },
      supports = { bed = { on = "south", fix = "xy" }, a = support, b = extra },
      contacts = { press = { slave = "north", master = tool, penalty = 200, friction = friction.friction } } }
    completed(model:run{ stage })
    local bed, a, b = model:reaction "bed", model:reaction "a", model:reaction "b"
    local force = model:contact_resultant "press"
    for c, f in ipairs { force.fx, force.fy } do
      assert(math.abs(f) > 1e-3)
      check.within("bed", bed[c], -f, 1e-9)
      check.within("tool", a[c] + b[c], f, 1e-9)
    end
    return a, b
  end
  local a, b = balanced({ rotate = true }, { drive = "y", fix = "x" }, { steps = 4, a = {-0.05}, b = {20} })
  check.near({ b[1], b[2] }, { 0, 0 }, 1e-12)
  a, b = balanced({ rotate = true }, { drive = "y" }, { steps = 4, a = {-0.05}, b = {20} })
  assert(a[1] ~= 0 and b[2] == 0) -- the first support holds what none names
end)

--- A cube under a free or driven sphere in 3D, or a quarter of its section, a cylinder of the same height.
local function below_sphere(kind, support, loads)
  local solid = kind == "solid"
  local body = sg.body{ patch = solid and sg.shapes.block{ size = {2, 2, 1}, corner = {-1, -1, 0} } or
                          sg.shapes.rectangle{ width = 1.5, height = 1 }, elements = solid and {4, 4, 1} or {6, 3},
                        order = solid and {"N2", "N2"} or "N2", contact = solid and "back" or "north",
                        material = soft }
  local sphere = sg.rigid.sphere{ center = solid and {0, 0, 2} or {0, 2}, radius = 1 }
  support.on = sphere
  for _, load in pairs(loads or {}) do load.on = sphere end
  local supports = { bed = { on = body:face(solid and "front" or "south"), fix = solid and "xyz" or "xy" },
                     tool = support }
  if not solid then supports.axis = { on = body:face "west", fix = "x" } end
  return scenes.model{ bodies = { body = body }, supports = supports, loads = loads, kind = not solid and kind or nil,
    contacts = { press = { slave = body:face(solid and "back" or "north"), master = sphere, penalty = 100 } } }
end

check.case("the same in 3D and in axisymmetric models, where the force is that of the full circle", function()
  for kind, up in pairs{ solid = "z", axisymmetric = "y" } do
    local force = kind == "solid" and {0, 0, -0.5} or {0, -0.5}
    local zero = kind == "solid" and {0, 0, 0} or {0, 0}
    local free = below_sphere(kind, { free = up }, { weight = { force = zero } })
    local run = completed(free:run{ { steps = 3, weight = force } })
    local depth = last(run, "tool.u" .. up)
    check.within("contact", last(run, "press.f" .. up), -0.5, 1e-8)
    local driven = completed(below_sphere(kind, { drive = up }):run{ { steps = 3, tool = {depth} } })
    check.within("force", last(driven, "tool.f" .. up), -0.5, 1e-8)
  end
end)

check.case("a free lid compresses a block uniformly, also with a free angle", function()
  local lid = sg.rigid.plane{ point = {0.5, 1}, normal = {0, -1} }
  local model = scenes.model{ bodies = { block = { contact = "north", material = sg.linear_elastic{ E = 2, nu = 0 } } },
    supports = { bed = { on = "south", fix = "y" }, corner = { on = "south-west", fix = "x" },
      lid = { on = lid, free = "y", rotate = true, angle = "free", center = {0.5, 1} } },
    loads = { weight = { on = lid, force = {0, 0} }, turn = { on = lid, moment = 0 } },
    contacts = { press = { slave = "north", master = lid, penalty = 100, per = "reference" } } }
  local run = completed(model:run{ { steps = 1, weight = {0, -0.1}, turn = {0} } })
  -- u = F/E, and the penetration F/ε
  check.within("depth", last(run, "lid.uy"), -0.1 * (1 / 2 + 1 / 100), 1e-9)
  check.at_most("angle", last(run, "lid.angle"), 1e-8)
  -- A moment from x to y lifts the right side: the pressures on the lid have the opposite moment.
  run = completed(model:run{ { steps = 1, weight = {0, -0.1}, turn = {0.005} } })
  local profile, moment = model:profile "press", 0
  for i, x in ipairs(profile.x) do moment = moment + (x - 0.5) * profile.pressure[i] * profile.area[i] end
  check.within("moment", moment, -0.005, 1e-5)
  assert(last(run, "lid.angle") > 0)
end)

check.case("a tool that falls from a distance lands", function()
  for name, method in pairs(methods) do
    local falls = rolled(method, { free = "y" }, { weight = { force = {0, -0.8} } }, 0.3)
    local run = completed(falls:run{ { steps = 1 } })
    local touches = completed(rolled(method, { free = "y" }, { weight = { force = {0, 0} } })
      :run{ { steps = 4, weight = {0, -0.8} } })
    check.within(name, last(run, "tool.uy") + 0.3, last(touches, "tool.uy"), 1e-8)
  end
end)

local mu, R = 0.3, 0.5
local rough = { friction = { mu = mu, penalty = 200 } }

check.case("a driven cylinder that spins in place: its moment is the radius times the friction", function()
  for name, method in pairs(methods) do
    local contact = { friction = { mu = mu } }
    if method.enforcement ~= "multipliers" then contact.friction.penalty = 200 end
    for key, value in pairs(method) do contact[key] = value end
    local model = rolled(contact, { drive = "y", fix = "x", rotate = true })
    local run = completed(model:run{ { steps = 4, tool = {-0.1, 0} }, { steps = 16, tool = {-0.1, 16} } })
    local law = model:contact_resultant "press"
    check.equal(law.slipping, law.active)
    local profile, friction = model:profile "press", 0
    for i, traction in ipairs(profile.traction) do friction = friction + traction * profile.area[i] end
    -- Friction of mortar contact lies in the slave's planes, which differ a little from the cylinder's tangents.
    -- At points it has the direction of the chord of a step's slip, 1° here.
    local share = method.method == "mortar" and 0.015 or 1e-4
    check.within_share(name, math.abs(last(run, "tool.moment")), math.abs(R * friction), share)
  end
end)

check.case("a moment on a cylinder that is held in place is that of friction", function()
  local model = rolled(rough, { drive = "y", fix = "x", rotate = true, angle = "free" }, { turn = { moment = 0 } })
  local run = completed(model:run{ { steps = 4, tool = {-0.1}, turn = {0} },
                                   { steps = 3, tool = {-0.1}, turn = {0.04} } })
  local profile, moment = model:profile "press", 0
  for i, traction in ipairs(profile.traction) do moment = moment + R * traction * profile.area[i] end
  -- Elastic slip is a chord of the circle, not quite tangential.
  check.within_share("friction", math.abs(moment), 0.04, 1e-5)
  assert(last(run, "tool.angle") > 0)
  -- More than Coulomb's limit has no equilibrium.
  check.equal(model:run{ { steps = 1, tool = {-0.1}, turn = {0.4} } }.failed, true)
end)
