-- Elements of sets of faces that nothing can reach are left out of evaluations: what is read of them is that of the
-- present state all the same, and what has happened to them is not forgotten.

require "check"

local soft = sg.neo_hookean { E = 100, nu = 0.3 }

check.case("profiles of points that nothing can reach show the present state", function()
  for _, points in ipairs { 4, "auto" } do
    local bar = sg.body { patch = sg.shapes.rectangle { width = 6, height = 1 }, elements = { 12, 2 }, order = "N2",
                          material = soft }
    local model = sg.model { bodies = { bar = bar }, contacts = { all = { among = "all", points = points } },
                             supports = { a = { on = bar:face "west", drive = "xy" },
                                          b = { on = bar:face "east", drive = "xy" } } }
    local function expect_moved(by)
      local now = model:profile "all"
      for i, x in ipairs(now.x) do
        check.near(x, now.X[i] + by, 1e-12)
        check.near(now.y[i], now.Y[i] - by, 1e-12)
      end
    end
    local function move_to(by)
      for _, name in ipairs { "a", "b" } do model:set_target(name, { by, -by }) end
      check.equal(model:solve_step {}.converged, true)
    end
    expect_moved(0)
    move_to(0.4)
    expect_moved(0.4) -- also before the state is accepted
    model:accept()
    expect_moved(0.4)
    move_to(0.7)
    expect_moved(0.7)
    model:rollback()
    expect_moved(0.4)
  end
end)

check.case("faces that have parted keep their wear and the work of their friction", function()
  local function block(corner, width, elements)
    return sg.body { patch = sg.shapes.rectangle { width = width, height = 1, corner = corner }, elements = elements,
                     order = "N2", material = soft }
  end
  local lower, upper = block({ 0, 0 }, 2, { 6, 2 }), block({ 0.3, 1 }, 1, { 4, 2 })
  local model = sg.model { bodies = { lower = lower, upper = upper },
                           supports = { bed = { on = lower:face "south", fix = "xy" },
                                        grip = { on = upper:face "north", drive = "xy" } },
                           contacts = { touch = { among = { upper:face "south", lower:face "north" }, penalty = 500,
                                                  friction = { mu = 0.3, penalty = 500 }, wear = { rate = 0.01 } } } }
  check.completed(model:run { { steps = 2, grip = { 0, -0.02 } }, { steps = 4, grip = { 0.3, -0.02 } } })
  local function past() return { model:profile("touch").worn, model:energy().friction } end
  check.completed(model:run { { steps = 3, grip = { 0.3, 5 } } })
  check.equal(model:contact_resultant("touch").active, 0)
  local parted = past()
  check.equal(math.max(table.unpack(parted[1])) > 0 and parted[2] > 0, true)
  check.completed(model:run { { steps = 2, grip = { 0, 5 } } })
  check.equal(past(), parted)
end)
