-- A Newton loop with only residual and tangent of the program: user-defined solver and moves.

require "check"

--- A small block on a rigid plane, pressed and pushed sideways by its top, which may also turn.
local function scene(turning)
  local block = scenes.body{ size = {1, 0.5}, elements = { 2, 1 }, contact = "south" }
  local plane = scenes.floor()
  local grip = { on = block:face "north", drive = "xy", rotate = turning }
  return scenes.model{ bodies = { block = block }, supports = { grip = grip },
    contacts = { floor = { slave = "south", master = plane, penalty = 10, friction = { mu = 0.3, penalty = 10 } } },
    loads = turning and { weight = { on = block:face "east", traction = { 0, 0 } } } }
end

--- K x = b by elimination with pivots.
local function solve(matrix, b)
  local n, rows = matrix.size, {}
  for i = 1, n do
    rows[i] = { [n + 1] = b[i] }
    for j = 1, n do rows[i][j] = 0 end
  end
  for k, value in ipairs(matrix.values) do rows[matrix.rows[k]][matrix.columns[k]] = value end
  for k = 1, n do
    local pivot = k
    for i = k + 1, n do if math.abs(rows[i][k]) > math.abs(rows[pivot][k]) then pivot = i end end
    rows[k], rows[pivot] = rows[pivot], rows[k]
    for i = k + 1, n do
      local factor = rows[i][k] / rows[k][k]
      for j = k, n + 1 do rows[i][j] = rows[i][j] - factor * rows[k][j] end
    end
  end
  local x = {}
  for i = n, 1, -1 do
    local sum = rows[i][n + 1]
    for j = i + 1, n do sum = sum - rows[i][j] * x[j] end
    x[i] = sum / rows[i][i]
  end
  return x
end

local function largest(values)
  local most = 0
  for _, value in ipairs(values) do most = math.max(most, math.abs(value)) end
  return most
end

local function zeros(model)
  local list = {}
  for i = 1, #model:residual() do list[i] = 0 end
  return list
end

--- One step to the targets; returns how many moves it took.
local function newton(model)
  model:move(zeros(model))
  for count = 1, 20 do
    local residual = model:residual()
    if largest(residual) < 1e-14 then return count end
    for i, value in ipairs(residual) do residual[i] = -value end
    model:move(solve(model:tangent(), residual))
  end
  error "no convergence"
end

local function difference(a, b)
  local most = 0
  for i = 1, #a do most = math.max(most, math.abs(a[i] - b[i])) end
  return most
end

check.case("a user-defined loop finds the states of model:run", function()
  local own, theirs = scene(), scene()
  local targets = { { 0, -0.02 }, { 0, -0.04 }, { 0.03, -0.04 }, { 0.06, -0.04 } }
  for _, target in ipairs(targets) do
    own:set_target("grip", target)
    check.equal(newton(own) < 12, true)
    own:accept()
  end
  local run = theirs:run { { steps = 2, grip = { 0, -0.04 } }, { steps = 2, grip = { 0.06, -0.04 } } }
  check.equal(run.steps, 4)
  check.equal(own:contact_resultant("floor").slipping, theirs:contact_resultant("floor").slipping)
  check.equal(largest(own:displacements()) > 0.03, true)
  check.equal(difference(own:displacements(), theirs:displacements()) < 1e-12, true)
  check.near(own:reaction "grip", theirs:reaction "grip", 1e-12)
  check.near(own:energy().work, theirs:energy().work, 1e-12)
end)

check.case("displacements are in the order of the unknowns", function()
  local model = scene()
  model:set_target("grip", { 0, -0.02 })
  newton(model)
  local list, points = model:displacements(), model:body "block":points()
  local checked = 0
  for i, unknown in ipairs(model:unknowns()) do
    local point = points[unknown.point]
    if point[1] == 0 and point[2] == 0 then -- a corner, whose control point is on the body
      check.near(list[i], model:sample("block", "u" .. unknown.component, { 0, 0 }), 1e-15)
      checked = checked + 1
    end
  end
  check.equal(checked, 2)
end)

check.case("moves are accepted in equilibrium only, and rolled back", function()
  local model = scene()
  model:set_target("grip", { 0, -0.02 })
  newton(model)
  model:accept()
  local accepted = model:displacements()
  model:set_target("grip", { 0, -0.03 })
  model:move(zeros(model))
  check.fails(function() model:accept() end, "own_loop_test.lua:",
    "model:accept: the state is not in equilibrium yet: its residual is ",
    "Hint: continue to iterate, or call model:rollback()")
  model:rollback()
  check.equal(model:displacements(), accepted)
  local change = zeros(model)
  change[1] = 1e-3
  model:move(change)
  check.near(model:displacements()[1], accepted[1] + 1e-3, 1e-16)
  check.equal(largest(model:residual()) > 1e-6, true)
  check.equal(model:iterate {}.reason, "iterating") -- goes on from there
  check.equal(model:solve_step {}.converged, true)
  check.equal(difference(model:displacements(), accepted) < 1e-12, true)
  model:move(change) -- leaves equilibrium again
  check.fails(function() model:accept() end, "not in equilibrium yet")
  change[1] = 50
  model:move(change)
  check.fails(function() model:residual() end, "the current state has no residual", "is inverted", "model:rollback()")
  model:rollback()
  check.equal(model:displacements(), accepted)
end)

check.case("wrong moves", function()
  local model = scene()
  local count = #model:residual()
  check.fails(function() model:move { 1, 2 } end,
    ("model:move: du must be a list of %d numbers, as many as model:residual() has"):format(count),
    "got a list of 2 values")
  local change = zeros(model)
  change[3] = 0 / 0
  check.equal(largest(model:displacements()), 0)
  model:accept() -- nothing has begun
end)

check.case("rows and columns of the tangent are whole numbers", function()
  local tangent = scene():tangent()
  for _, key in ipairs { "rows", "columns" } do
    for _, index in ipairs(tangent[key]) do check.equal(math.type(index), "integer") end
  end
end)

check.case("a converged step that is not accepted is not thrown away by model:save", function()
  local model, file = scene(), check.file()
  model:set_target("grip", { 0, -0.02 })
  check.fails(function() model:save(file) end, "own_loop_test.lua:", "model:save: ", "targets", "not accepted",
    "model:rollback()")
  check.equal(model:solve_step {}.converged, true)
  check.fails(function() model:save(file) end, "model:save: ", "not accepted", "model:accept()")
  model:accept()
  model:save(file)
  check.equal(sg.load(file):displacements(), model:displacements())
  check.equal(largest(model:displacements()) > 1e-3, true)
  model:move(zeros(model))
  check.fails(function() model:save(file) end, "not accepted")
end)

check.case("reactions are also accessible by name", function()
  local model = scene(true)
  check.equal(model:run { { steps = 1, grip = { 0.01, -0.02, 2 } } }.steps, 1)
  local force = model:reaction "grip"
  check.equal(#force, 3)
  check.equal({ force.fx, force.fy, force.moment }, { force[1], force[2], force[3] })
  check.equal(math.abs(force.moment) > 1e-5, true)
  local weight = model:reaction "weight"
  check.equal({ weight.fx, weight.fy }, { 0, 0 })
end)

check.case("a roller whose height and angle are unknowns", function()
  local function roller()
    local disc = sg.rigid.cylinder { center = { 0.5, 1 }, radius = 0.5 }
    local model = scenes.model{ bodies = { block = { size = {1, 0.5}, elements = { 4, 1 }, contact = "north" } },
      loads = { weight = { on = disc, force = { 0, 0 } } }, supports = { bed = { on = "south", fix = "xy" },
        tool = { on = disc, drive = "x", free = "y", rotate = true, angle = "free", center = { 0.5, 0.9 } } },
      contacts = { roll = { slave = "north", master = disc, penalty = 10, friction = { mu = 0.5, penalty = 10 } } } }
    model:set_target("weight", { 0, -0.02 })
    check.equal(model:solve_step { damping = true }.converged, true)
    model:accept()
    model:set_target("tool", { 0.03 })
    return model
  end
  local own, its = roller(), roller()
  local unknowns = own:unknowns()
  check.equal({ unknowns[#unknowns - 1].support, unknowns[#unknowns - 1].component }, { "tool", "y" })
  check.equal({ unknowns[#unknowns].support, unknowns[#unknowns].component }, { "tool", "angle" })
  newton(own)
  own:accept()
  check.equal(its:solve_step {}.converged, true)
  its:accept()
  -- The points that close as it rolls slip from their touch, in a user's own loop from the start of the step.
  check.near(own:free_motion("tool").angle, its:free_motion("tool").angle, 5e-3)
  check.near(own:free_motion("tool").uy, its:free_motion("tool").uy, 1e-5)
  assert(own:free_motion("tool").angle < -0.5)
end)

check.case("an evaluation of the accepted state does not change its results", function()
  -- Slips of the evaluation start in the accepted state, so that on a round master friction has another direction.
  local disc = sg.rigid.cylinder { center = { 0.7, 0.8 }, radius = 0.3 }
  local model = scenes.model{ bodies = { block = { size = {2, 0.5}, elements = { 8, 1 }, contact = "north" } },
    supports = { bed = { on = "south", fix = "xy" }, tool = { on = disc, drive = "xy" } },
    contacts = { iron = { slave = "north", master = disc, penalty = 10, friction = { mu = 0.4, penalty = 10 } } } }
  model:run { { steps = 1, tool = { 0, -0.05 } }, { steps = 1, tool = { 0.1, -0.05 } } }
  assert(model:contact_resultant("iron").slipping > 0)
  local function results()
    return { model:reaction "tool", model:reaction "bed", model:contact_resultant "iron",
             model:profile("iron").pressure, model:energy() }
  end
  local before = results()
  local residual = model:residual()
  check.equal(results(), before)
  check.equal(model:tangent().size, #residual)
  check.equal(results(), before)
  model:set_target("tool", { 0.15, -0.05 })
  model:residual()
  model:set_target("tool", { 0.1, -0.05 })
  model:tangent() -- the targets are those of the accepted state again
  check.equal(results(), before)
end)
