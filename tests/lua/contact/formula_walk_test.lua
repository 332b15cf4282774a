-- Laws that are formulas along a path: a block touches a slab, sticks, begins to slip, slips, turns back, sticks and
-- slips again and is lifted, in every formulation, in the plane, axisymmetric and in space. Newton's method needs few
-- iterations, neither cuts nor fallbacks, and ends quadratically.

require "check"

local clearance = 0.003
local laws = {
  { "mu of the pressure", mu = function(p) return 0.2 + 0.2 * sg.exp(-p) end },
  { "mu of the rate", mu = function(v) return 0.3 + 0.1 * sg.tanh(v) end },
  { "mu of the slip", mu = function(slip) return 0.3 + 2 * slip end },
  { "mu of the place", mu = function(X) return 0.3 + 0.1 * X end },
  { "static and kinetic", mu = { static = 0.4, kinetic = 0.25, over = 0.1 } },
  { "pressure of the gap", mu = 0.3, pressure = function(g) return 2e4 * sg.max(0, clearance - g) ^ 2 end },
}
local formulations = {
  { "points" }, { "half passes", { method = "half_passes" } }, { "mortar", { method = "mortar" } },
  { "multipliers", { method = "mortar", enforcement = "multipliers" } },
  { "set", {}, true }, { "set in half passes", { method = "half_passes" }, true },
}

-- ── Scenes ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local lift, deep = 0.004, 0.024

--- `set`: the faces of both bodies that may touch are in contact with each other.
local function scene(kind, law, keys, set)
  local space, axis = kind == "space", kind == "axisymmetric"
  local lower, upper = space and "front" or "south", space and "back" or "north"
  local block = scenes.body{ E = 10, size = space and { 0.6, 0.6, 0.4 } or { 0.6, 0.4 }, contact = lower,
                             corner = space and { 0.2, 0.2, lift } or { axis and 0 or 0.2, lift },
                             elements = space and { 2, 1, 1 } or { 3, 2 } }
  local slab = scenes.body{ E = 20, size = space and { 1, 1, 0.4 } or { 1, 0.4 }, contact = upper,
                            corner = space and { 0, 0, -0.4 } or { 0, -0.4 },
                            elements = space and { 2, 1, 1 } or { 3, 1 } }
  local contact = { slave = block:face(lower), master = slab:face(upper), friction = { mu = law.mu, penalty = 200 } }
  if set then contact.among, contact.slave, contact.master = { contact.slave, contact.master }, nil, nil end
  if law.pressure then contact.pressure, contact.clearance = law.pressure, clearance else contact.penalty = 200 end
  return sg.model{
    kind = axis and kind or nil, bodies = { block = block, slab = slab },
    supports = { bed = { on = slab:face(lower), fix = space and "xyz" or "xy" },
                 grip = { on = block:face(upper), drive = axis and "y" or space and "xyz" or "xy" },
                 axis = axis and { on = { block:face "west", slab:face "west" }, symmetry = true } or nil },
    contacts = { touch = lists.merged(contact, keys or {}) },
  }
end

--- Stages { x, depth, steps }. An axisymmetric block slips outward as it is pressed, and back as it is lifted.
local dragged = { { 0, lift + 0.003, 2 }, { 0, deep, 2 }, { 0.002, deep, 2 }, { 0.04, deep, 4 }, { 0.03, deep, 8 },
                  { 0, deep, 3 }, { 0, -0.01, 1 } }
local pressed = { { 0, lift + 0.003, 2 }, { 0, deep, 4 }, { 0, lift + 0.005, 4 }, { 0, deep, 4 }, { 0, -0.01, 1 } }

local function path(kind)
  return lists.map(kind == "axisymmetric" and pressed or dragged, function(stage)
    local x, depth, steps = table.unpack(stage)
    local along = kind == "axisymmetric" and {} or kind == "space" and { x, 0.4 * x } or { x }
    return { steps = steps, duration = 1, grip = lists.joined(along, { -depth }) }
  end)
end

-- ── What must hold ───────────────────────────────────────────────────────────────────────────────────────────────────

--- Notes the states of a step in `seen`, and checks that |t| = mu p at points that slip.
local function look(kind, model, seen, at_points)
  local profile, slipping, closed = model:profile "touch", 0, 0
  local along = kind == "space" and profile.tx or profile.traction
  for i, state in ipairs(profile.state) do
    closed = closed + (state == "open" and 0 or 1)
    if state == "slip" then
      slipping = slipping + 1
      seen[along[i] > 0 and "forward" or "backward"] = true
      if at_points then
        check.near(math.abs(profile.traction[i]), profile.mu[i] * profile.pressure[i], 1e-9)
      end
    end
  end
  seen.stick = seen.stick or (closed > 0 and slipping == 0)
  seen.slip = seen.slip or (closed > 0 and slipping == closed)
  seen.lifted = closed == 0
end

for _, kind in ipairs { "plane", "axisymmetric", "space" } do
  for _, formulation in ipairs(formulations) do
    for _, law in ipairs(laws) do
      local name, keys, set = table.unpack(formulation)
      if not (law.pressure and name == "multipliers") then
        check.case(("%s, %s, %s"):format(kind, name, law[1]), function()
          local model, seen = scene(kind, law, keys, set), {}
          local run = model:run(path(kind), { on_step = function() look(kind, model, seen, name ~= "mortar") end })
          check.equal({ run.reason, run.cutbacks, run.fallback_steps }, { "completed", 0, 0 })
          check.equal(seen, { stick = true, slip = true, forward = true, backward = true, lifted = true })
          local scale = 0
          for step = 1, run.steps do scale = math.max(scale, table.unpack(run:residuals(step))) end
          for step = 1, run.steps do
            local residuals = run:residuals(step)
            check.at_most(("iterations of step %d"):format(step), #residuals, 12)
            local last, before = residuals[#residuals], residuals[#residuals - 1]
            check.at_most(("last decrease in step %d"):format(step), math.max(0, last - 1e-12 * scale) / before, 1e-3)
          end
        end)
      end
    end
  end
end
