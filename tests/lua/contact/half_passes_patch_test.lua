-- Contact patch test of two half passes, at contact points and with multipliers: uniform to rounding error on either
-- face, straight, skewed and stretched.

require "check"
local patch_test = require "problems.patch_test.problem"

local function solved(model, stages, options) return check.completed(model:run(stages, options)) end

local kinds = { { name = "points" }, { name = "equal", multipliers = "equal" },
                { name = "reduced", multipliers = "reduced" } }

--- Two blocks under uniform pressure, sides guided; the largest error of the pressures of both passes.
local function press(o)
  local model = patch_test.scene{ dimension = o.dimension, order = o.order, lower = o.counts[1], upper = o.counts[2],
    slave = o.slave, skew = o.skew, sides = "guided", formulation = { keys = {
      method = "half_passes", multipliers = o.multipliers, friction = { mu = 0.3, penalty = 100 } } } }
  solved(model, { { name = "press", steps = 2, push = 0.1 } })
  local largest = 0
  for _, name in ipairs { "joint", "joint.master" } do
    for _, pressure in ipairs(model:profile(name).pressure) do
      largest = math.max(largest, math.abs(pressure / 0.1 - 1))
    end
    check.at_most("imbalance", model:contact_resultant(name).imbalance, 1e-12)
  end
  return largest
end

check.case("patch test, 3 on 5 elements, straight and skewed: uniform to rounding error on either face", function()
  local function expect_uniform(order, keys)
    for _, skew in ipairs { 0, 0.2 } do
      for _, slave in ipairs { "lower", "upper" } do
        for dimension = 2, order == "N2" and 3 or 2 do
          local error = press{ dimension = dimension, order = order, skew = skew, slave = slave, counts = { 3, 5 },
                               multipliers = keys.multipliers }
          check.at_most(("%dD %s %s, skew %g, slave %s"):format(dimension, order, keys.name, skew, slave), error,
            1e-12)
        end
      end
    end
  end
  for _, order in ipairs { "N1", "N2", "N3", "N2-N2.2" } do
    for _, keys in ipairs(kinds) do
      if order ~= "N1" or keys.multipliers ~= "reduced" then expect_uniform(order, keys) end
    end
  end
end)

--- A block that is stretched to 1.5 times its width and then pressed on another one of this width.
local function stretch_and_press(keys)
  local function block(width, height, count, face)
    return scenes.body{ size = {width, 1}, corner = { 0, height }, elements = { count, 2 }, contact = face,
      thickness_degree = 1 }
  end
  local lower, upper = block(3, -1, 5, "north"), block(2, 0, 3, "south")
  local model = scenes.model{ bodies = { lower = lower, upper = upper },
    supports = { bed = { on = "lower.south", fix = "y" },
      ends = { on = { "lower.west", "lower.east", "upper.west" }, fix = "x" },
      pull = { on = "upper.east", drive = "x" }, grip = { on = "upper.north", drive = "y" } },
    contacts = { joint = { slave = "upper.south", master = "lower.north", penalty = 100, points = 4,
        method = "half_passes", multipliers = keys.multipliers } } }
  solved(model, { { steps = 4, pull = 1, grip = 0.1 }, { steps = 4, pull = 1, grip = -0.3 } },
    { newton = { tolerance = 1e-13 } })
  return model
end

check.case("patch test with a face stretched by half: uniform to rounding error on both, action equals reaction",
  function()
    for _, keys in ipairs(kinds) do
      local model = stretch_and_press(keys)
      local mean = math.abs(model:reaction("grip").fy) / 3
      check.equal(mean > 0.05, true)
      for _, name in ipairs { "joint", "joint.master" } do
        for _, pressure in ipairs(model:profile(name).pressure) do
          check.within_share(keys.name .. " " .. name, pressure, mean, 1e-11)
        end
        check.at_most("imbalance", model:contact_resultant(name).imbalance, 1e-12)
        check.within_share("area", model:contact_resultant(name).area, 3, 1e-12)
      end
    end
  end)
