-- Wear of a block that slides on a plane: under a constant force, at a fixed height, with friction, in every
-- formulation; stability of the two updates; balance of energy; checkpoints; what is refused.

require "check"

local E, nu, height, penalty = 100, 0.3, 0.5, 1e4
local M = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) -- of a block that is held at its sides
local K = 1 / (1 / penalty + height / M)

--- A block on a moving plane; `held`: the top is driven instead of loaded; `traction`: the load.
local function block(wear, held, keys, traction)
  local body = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = height }, elements = {4, 2}, order = "N2",
                        contact = "south", material = sg.linear_elastic{ E = E, nu = nu } }
  local plane = sg.rigid.plane{ point = {0, 0}, normal = {0, 1} }
  local contact = { slave = body:face "south", master = plane, penalty = penalty, wear = wear }
  for key, value in pairs(keys or {}) do contact[key] = value end
  local supports = { left = { on = body:face "west", symmetry = true },
                     right = { on = body:face "east", symmetry = true },
                     disc = { on = plane, drive = "x" } }
  if held then supports.top = { on = body:face "north", drive = "y" } end
  return sg.model{ bodies = { block = body }, supports = supports, contacts = { floor = contact },
                   loads = not held and { weight = { on = body:face "north", traction = traction or {0, -0.2} } }
                     or nil }
end

local function last(run, column) return run:column(column)[#run:column(column)] end

local formulations = { points = {}, mortar = { method = "mortar" },
                       multipliers = { method = "mortar", enforcement = "multipliers" } }

check.case("under a constant force the depth is k p s, at any steps", function()
  for _, keys in pairs(formulations) do
    local model = block({ rate = 0.05 }, false, keys)
    local run = model:run{ { name = "press", steps = 1 }, { name = "slide", steps = 3, disc = 2 } }
    check.equal(run.reason, "completed")
    for _, depth in ipairs(model:profile "floor".worn) do check.near(depth, 0.05 * 0.2 * 2, 1e-11) end
    check.near(last(run, "floor.worn_volume"), 0.05 * 0.2 * 2, 1e-11)
    check.near(model:energy().wear, 0.2 * 0.05 * 0.2 * 2, 1e-11)
  end
end)

check.case("a block at a fixed height loses its pressure, p0 exp(-k K s), to first order in the step", function()
  local k, way, down = 0.002, 1, -0.001
  for name, keys in pairs(formulations) do
    local own = name == "multipliers" and M / height or K
    local errors = {}
    for i, steps in ipairs{ 5, 10, 20 } do
      local model = block({ rate = k }, true, keys)
      local run = model:run{ { name = "press", steps = 1, top = down }, { name = "slide", steps = steps, disc = way } }
      local fy, exact = last(run, "floor.fy"), -own * down * math.exp(-k * own * way)
      check.within("backward Euler", fy / (-own * down * (1 + k * own * way / steps) ^ -steps), 1, 1e-9)
      errors[i] = fy / exact - 1
    end
    for i = 1, 2 do check.within("order", errors[i] / errors[i + 1], 2, 0.1) end
  end
end)

check.case("above k K s = 2 per step the explicit update oscillates, the implicit one does not", function()
  local function pressures(update, factor)
    local way = factor / (0.02 * K)
    local run = block({ rate = 0.02, update = update }, true):run{ { name = "press", steps = 1, top = -0.001 },
                                                                   { name = "slide", steps = 5, disc = 5 * way } }
    return table.move(run:column "floor.fy", 2, 6, 1, {})
  end
  for row, p in ipairs(pressures("implicit", 2.5)) do check.within("implicit", p / (K * 0.001) * 3.5 ^ row, 1, 1e-6) end
  local smooth = pressures("explicit", 0.5)
  for row, p in ipairs(smooth) do check.within("explicit", p / (K * 0.001) * 2 ^ (row - 1), 1, 1e-6) end
  check.equal(pressures("explicit", 2.5)[2], 0) -- worn beyond the contact
end)

check.case("a warning where pressures of the explicit update oscillate, none where they decay", function()
  local bodies = 0.25 * (1 - nu ^ 2) / E / math.pi * (2 / math.pi) ^ 4 -- 2 h/(α π E*)
  local mortar = 1 / (1 / penalty + bodies)
  local cases = { { 1.5 / penalty }, { 4 / penalty, warned = true }, { 4 / penalty, update = "implicit" },
                  { 1.5 / penalty, "multipliers" }, { 4 / penalty, "multipliers", warned = true },
                  { 1.5 / mortar, "mortar" }, { 4 / mortar, "mortar", warned = true } }
  for _, case in ipairs(cases) do
    local model = block({ rate = case[1] / 0.1, update = case.update or "explicit" }, false,
      formulations[case[2] or "points"], function(x) return { 0, -0.01 * (1 + x) } end)
    local pressures = {}
    local run = model:run({ { name = "press", steps = 1 }, { name = "slide", steps = 14, disc = 1.4 } }, {
      on_step = function() pressures[#pressures + 1] = model:profile "floor".pressure end })
    local function bend(step) -- second difference over steps
      local largest = 0
      for i, p in ipairs(pressures[step]) do
        largest = math.max(largest, math.abs(pressures[step - 1][i] - 2 * p + pressures[step + 1][i]))
      end
      return largest
    end
    check.equal(bend(14) > 10 * bend(3), case.warned == true)
    local warnings = lists.filter(run.warnings, function(text) return text:find("wear.update", 1, true) ~= nil end)
    check.equal(#warnings, case.warned and 1 or 0)
    if case.warned then check.holds(warnings[1], "contact 'floor'", "unstable from step 2 on", "shorter steps") end
  end
end)

check.case("with friction: formulas, balance of energy, the work of friction in addition", function()
  for _, keys in pairs(formulations) do
    local own = { friction = { mu = function(p) return 0.3 - 0.05 * p end, penalty = penalty } }
    for key, value in pairs(keys) do own[key] = value end
    local model = block({ rate = function(p, v) return 0.01 + 0.01 * p + 0.001 * v end }, true, own)
    local run = model:run{ { name = "press", steps = 4, top = -0.002, duration = 1 },
                           { name = "slide", steps = 240, disc = 0.2, duration = 1 } }
    check.equal(run.reason, "completed")
    local energy = model:energy()
    check.equal(energy.wear > 0 and energy.friction > energy.wear, true)
    local rest = energy.work + energy.area_growth - energy.stored - energy.contact - energy.friction - energy.wear
    check.at_most("the balance", math.abs(rest / energy.work), 1e-3)
    check.equal(#run.warnings, 0)
  end
end)

check.case("a face that has worn touches later, and keeps its depth where it is open", function()
  local model = block({ rate = 0.02 }, true)
  model:run{ { name = "press", steps = 1, top = -0.001 }, { name = "slide", steps = 4, disc = 1 },
             { name = "lift", steps = 1, top = 0.01 } }
  local profile = model:profile "floor"
  check.equal(profile.state[1], "open")
  local depth = profile.worn[1]
  check.equal(depth > 1e-4, true)
  check.near(profile.gap[1], 0.01 + depth, 1e-9)
  local run = model:run{ { name = "again", steps = 1, top = -0.001 } }
  check.within("force", last(run, "floor.fy") / (K * (0.001 - depth)), 1, 1e-9)
end)

check.case("a saved model goes on with its wear", function()
  for _, keys in pairs(formulations) do
    local model = block({ rate = function(slip, p) return 0.02 + 0.01 * p + 0.1 * slip end }, true, keys)
    model:run{ { name = "press", steps = 1, top = -0.001 }, { name = "slide", steps = 4, disc = 1 } }
    local loaded = check.reloaded(model)
    check.equal(loaded:profile "floor".worn, model:profile "floor".worn)
    check.equal(loaded:contact_law "floor".wear_rate, model:contact_law "floor".wear_rate)
    check.equal(loaded:contact_law "floor".wear_update, "implicit")
    local on = { { name = "on", steps = 2, disc = 2 } }
    check.equal(last(loaded:run(on), "floor.worn_volume"), last(model:run(on), "floor.worn_volume"))
  end
end)

check.case("a warning of wear that is deep in the body, and none otherwise", function()
  for depth, warned in pairs{ [0.02] = false, [0.3] = true } do
    local run = block({ rate = depth / 0.2 }):run{ { name = "slide", steps = 1, disc = 1 } }
    check.equal(lists.any(run.warnings, function(text) return text:find("the wear of", 1, true) ~= nil end), warned)
  end
end)

check.case("what is refused, and a warning of a negative rate", function()
  local function refused(wear, keys, ...) check.fails(function() block(wear, true, keys) end, ...) end
  refused({ rate = -1 }, nil, "contacts.floor.wear.rate")
  refused({ rate = "fast" }, nil, "contacts.floor.wear.rate must be", "as in function(p) return")
  refused({ rate = {1, 2} }, nil, "contacts.floor.wear.rate must be", "as in function(p) return")
  refused({}, nil, "contacts.floor.wear.rate")
  refused({ rate = 1, update = "late" }, nil, 'contacts.floor.wear.update must be')
  refused({ rate = function() return 1 end }, nil, "contacts.floor.wear.rate must return a formula of its arguments, "
    .. "got the number 1. Hint: write rate = 1")
  refused({ rate = 1 }, { adhesion = { hamaker = 1, r0 = 1 } }, "it has both adhesion and")
  refused({ rate = 1 }, { cohesive = { strength = 1, energy = 1 } }, "it has both cohesive and wear")
  local model = block({ rate = function(v) return 0.1 * v end }, true)
  check.fails(function() model:run{ { name = "press", steps = 1, top = -0.001 } } end,
    "model:run: contacts.floor.wear.rate depends on v, but stage 'press' has no duration")
  local failed = block({ rate = function(slip) return 0.01 * sg.sqrt(0.3 - slip) end }, true):run({
    { name = "press", steps = 1, top = -0.001 }, { name = "slide", steps = 4, disc = 1 } }, sg.plain{})
  check.holds(failed.failure, "the formula of contacts.floor.wear.rate is not a finite number at X = (")
  local run = block({ rate = function(p) return 0.01 - p end }, true):run{
    { name = "press", steps = 1, top = -0.001 }, { name = "slide", steps = 2, disc = 1 } }
  check.equal(lists.any(run.warnings, function(text)
    return text:find("the formula of wear.rate is negative", 1, true) ~= nil
  end), true)
end)
