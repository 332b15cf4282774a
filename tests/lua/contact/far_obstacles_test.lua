-- Obstacles with a far center, point or pivot: forces as on the same shape given by near numbers.

require "check"

local exact = { verbose = false }

--- Reaction of the tool and the run of a thin layer, fixed at its bottom. `o`: support, of the tool; mu; also: another
--- tool that nothing touches.
local function layer(tool, stages, o)
  o = o or {}
  local body = scenes.body{ size = {14, 0.25}, corner = { 0, -0.25 }, elements = { 56, 1 }, contact = "north",
    material = sg.linear_elastic{ E = 3, nu = 0.3 } }
  local support, top = o.support or { drive = "xy" }, body:face "north"
  support.on = tool
  local model = scenes.model{ bodies = { body = body },
    supports = { bed = { on = "south", fix = "xy" }, tool = support },
    contacts = { c = { slave = top, master = tool, method = "mortar", enforcement = "multipliers",
        friction = o.mu and { mu = o.mu } }, also = o.also and { slave = top, master = o.also } } }
  local run = check.completed(model:run(stages, exact))
  return model:reaction "tool", run
end

--- The circle about { x0, sign · radius } near the layer, up to x⁴/8R³, as a level set.
local function parabola(x0, radius, sign)
  return sg.rigid.level_set{ f = function(x, y) return sign * (x - x0) ^ 2 / (2 * radius) - y end,
                             box = { { -1, -0.2 }, { 15, 0.2 } } }
end

--- Equal forces but for x²/R².
local function same(a, b, radius)
  check.near(a.fy / b.fy, 1, 1e-10 + 14 / radius ^ 2)
  check.near((a.fx - b.fx) / b.fy, 0, 1e-9 + 14 / radius ^ 2)
end

check.case("a cylinder with a far center presses as the same curve given as a level set", function()
  for _, x0 in ipairs{ 0, 7 } do
    for _, radius in ipairs{ 4e4, 4e5, 4e6 } do
      local stages = { { steps = 1, tool = { 0, -100 / 6 / radius } } }
      local disc, run = layer(sg.rigid.cylinder{ center = { x0, radius }, radius = radius }, stages)
      check.equal(#run.warnings, 0)
      same(disc, (layer(parabola(x0, radius, 1), stages)), radius)
    end
  end
end)

check.case("so does a bore", function()
  for _, radius in ipairs{ 4e5, 4e6 } do -- it touches both ends of the layer first, 24.5/R below its top
    local stages = { { steps = 1, tool = { 0, (24.5 - 100 / 6) / radius } } }
    local bore = layer(sg.rigid.cylinder{ center = { 7, -radius }, radius = radius, inside = true }, stages)
    same(bore, (layer(parabola(7, radius, -1), stages)), radius)
  end
end)

check.case("with friction, too, on the way there and back", function()
  for _, radius in ipairs{ 4e4, 4e6 } do
    local down = -100 / 6 / radius
    local stages = { { steps = 2, tool = { 0, down } }, { steps = 2, tool = { -down, down } },
                     { steps = 2, tool = { down, down } } }
    local disc, run = layer(sg.rigid.cylinder{ center = { 7, radius }, radius = radius }, stages, { mu = 0.3 })
    check.equal(#run.warnings, 0)
    local curve = layer(parabola(7, radius, 1), stages, { mu = 0.3 })
    same(disc, curve, radius)
    assert(math.abs(disc.fx) > 0.2 * math.abs(disc.fy))
  end
end)

check.case("far points of planes and far obstacles that nothing touches do not count", function()
  local stages = { { steps = 1, tool = { 0, -1e-6 } }, { steps = 1, tool = { 1e-6, -1e-6 } } }
  local function plane(x) return sg.rigid.plane{ point = { x, 0 }, normal = { 0, -1 } } end
  local near = layer(plane(0), stages, { mu = 0.1 })
  local far, run = layer(plane(1e7), stages, { mu = 0.1 })
  check.equal({ far.fx, far.fy }, { near.fx, near.fy })
  check.equal(#run.warnings, 0)
  local _, other = layer(plane(0), stages, { mu = 0.1, also = sg.rigid.cylinder{ center = { 1e7, 1e7 }, radius = 1 } })
  check.equal(#other.warnings, 1)
  check.holds(other.warnings[1], "'also' never touched")
end)

check.case("a tool that turns about a far pivot presses as one that moves", function()
  local function disc() return sg.rigid.cylinder{ center = { 7, 4e3 }, radius = 4e3 } end
  local moved = layer(disc(), { { steps = 2, tool = { -1e-4, -1e-4 } } })
  for _, arm in ipairs{ 1e6, 1e8 } do
    local support = { rotate = true, center = { 7 - arm, 4e3 + arm } }
    local turned, run = layer(disc(), { { steps = 2, tool = -math.deg(1e-4 / arm) } }, { support = support })
    check.equal(#run.warnings, 0)
    check.near(turned.fy / moved.fy, 1, 1e-9)
  end
end)

check.case("in space balls and cylinders with far centers press as level sets", function()
  local radius, depth = 4e6, 4e-7
  local function force(tool)
    local model = scenes.model{
      bodies = { block = { size = { 4, 4, 0.5 }, elements = { 8, 8, 1 }, contact = "back",
          material = sg.linear_elastic{ E = 3, nu = 0.3 } } },
      supports = { bed = { on = "front", fix = "xyz" }, tool = { on = tool, drive = "xyz" } },
      contacts = { c = { slave = "back", master = tool, friction = { mu = 0.3 } } } }
    local run = model:run({ { steps = 1, tool = { 0, 0, -depth } }, { steps = 1, tool = { depth, 0, -depth } } }, exact)
    check.equal(run.failed, false)
    return model:reaction "tool"
  end
  local function level_set(f) return sg.rigid.level_set{ f = f, box = { { -1, -1, 0.4 }, { 5, 5, 0.6 } } } end
  local function same_force(a, b)
    check.near((a.fz - b.fz) / b.fz, 0, 1e-7)
    check.near((a.fx - b.fx) / b.fz, 0, 1e-7)
  end
  same_force(force(sg.rigid.sphere{ center = { 2, 2, 0.5 + radius }, radius = radius }),
    force(level_set(function(x, y, z) return ((x - 2) ^ 2 + (y - 2) ^ 2) / (2 * radius) + 0.5 - z end)))
  same_force(force(sg.rigid.cylinder{ center = { 2, 1e6, 0.5 + radius }, axis = { 0, 1, 0 }, radius = radius }),
    force(level_set(function(x, y, z) return (x - 2) ^ 2 / (2 * radius) + 0.5 - z end)))
end)
