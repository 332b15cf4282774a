-- The contact area against Hertz, and what follows from it: edges of profiles.

require "check"

local E, nu, R = 1, 0.3, 4
local formulations = {
  gpts = function(h) return { penalty = 50 * E / h } end,
  mortar = function(h) return { method = "mortar", penalty = 50 * E / h } end,
  multipliers = function() return { method = "mortar", enforcement = "multipliers" } end,
  reduced = function() return { method = "mortar", enforcement = "multipliers", multipliers = "reduced" } end,
}

--- Half of a block under a rigid cylinder that is moved down in small steps: the run and the model.
local function pressed(name, n)
  local block = scenes.body{ size = {2, 2}, corner = { 0, -2 }, elements = { n, 12 }, contact = "north",
    grading = { false, { elements = 0.7, length = 0.3, at = "end" } }, material = sg.linear_elastic{ E = E, nu = nu } }
  local tool, contact = sg.rigid.cylinder{ center = { 0, R }, radius = R }, formulations[name](2 / n)
  contact.slave, contact.master = block:face "north", tool
  local model = scenes.model{ bodies = { block = block }, contacts = { c = contact },
    supports = { bed = { on = "south", fix = "xy" }, symmetry = { on = "west", fix = "x" },
      tool = { on = tool, drive = "y" } } }
  local run = check.completed(model:run{ { steps = 1, tool = -0.006 }, { steps = 12, tool = -0.012 } })
  return run, model
end

--- Root mean square of area/a − 1 over the steps, a = sqrt(4 F R (1 − ν²)/(π E)) with the force F of the whole.
local function error_of(run)
  local sum, force, area = 0, run:column "c.fy", run:column "c.area"
  for i = 1, #area do
    sum = sum + (area[i] / math.sqrt(8 * math.abs(force[i]) * R * (1 - nu ^ 2) / (math.pi * E)) - 1) ^ 2
  end
  return math.sqrt(sum / #area)
end

check.case("half the width of a line contact is Hertz's", function()
  -- Root mean square errors with 64 and 128 elements, and those of the sum over all points with a pressure:
  --   gpts         0.069  0.043    0.065  0.041
  --   mortar       0.023  0.019    0.202  0.090
  --   multipliers  0.041  0.027
  --   reduced      0.044  0.032    0.063  0.033
  local most = { gpts = { 0.072, 0.046 }, mortar = { 0.026, 0.021 }, multipliers = { 0.044, 0.029 },
                 reduced = { 0.048, 0.0325 } }
  for name, limits in pairs(most) do
    for k, limit in ipairs(limits) do check.at_most(name, error_of((pressed(name, 32 * 2 ^ k))), limit) end
  end
end)

check.case("the area grows with the load in every step", function()
  -- The sum over points of mortar contact stays the same in 11 of these 12 steps.
  for _, name in ipairs{ "gpts", "mortar", "multipliers" } do
    local area = pressed(name, 64):column "c.area"
    for i = 2, #area do assert(area[i] > area[i - 1], ("%s: step %d"):format(name, i)) end
  end
end)

check.case("the edge of a profile is the border of the area", function()
  for _, name in ipairs{ "mortar", "multipliers", "reduced" } do
    local _, model = pressed(name, 64)
    local edges = sg.profile_edges{ profile = model:profile "c", coordinate = "X" }
    -- The reference area per depth is a length; linear in X here as well.
    check.within_share(name, edges.to, model:contact_resultant "c".area, 2e-3)
  end
end)

check.case("the area under a sphere has no holes and no steps", function()
  local n = 12
  local areas = {}
  for _, name in ipairs{ "mortar", "multipliers" } do
    local block = scenes.body{ size = { 1, 1, 1 }, corner = { 0, 0, -1 }, elements = { n, n, 3 }, contact = "back",
      material = sg.linear_elastic{ E = E, nu = nu } }
    local tool, contact = sg.rigid.sphere{ center = { 0, 0, R }, radius = R }, formulations[name](1 / n)
    contact.slave, contact.master = block:face "back", tool
    local model = scenes.model{ bodies = { block = block }, contacts = { c = contact },
      supports = { bed = { on = "front", fix = "xyz" }, west = { on = "west", fix = "x" },
        south = { on = "south", fix = "y" }, tool = { on = tool, drive = "z" } } }
    local run = check.completed(model:run{ { steps = 1, tool = -0.015 }, { steps = 3, tool = -0.03 } })
    for i, force in ipairs(run:column "c.fz") do
      -- Of the quarter, F/4; the block of finite depth is up to 7 % stiffer than a half space.
      local a = (3 * math.abs(force) * R * (1 - nu ^ 2) / E) ^ (1 / 3)
      check.within_share(name, run:column "c.area"[i], math.pi * a ^ 2 / 4 * 0.94,
        name == "multipliers" and 0.1 or 0.05)
    end
  end
end)
