-- Motions that leave the axis of an axisymmetric model are errors, before anything is solved.

require "check"

local material = sg.neo_hookean{ E = 1, nu = 0.3 }

local function block(x)
  return scenes.body{ size = {2, 1}, corner = { x or 0, 0 }, elements = {4, 2}, material = material }
end

local function held(body, supports, more)
  local values = { kind = "axisymmetric", bodies = { b = body },
                   supports = { s = { on = body:face "south", fix = "y" } } }
  for name, support in pairs(supports) do values.supports[name] = support end
  for key, value in pairs(more or {}) do values[key] = value end
  return sg.model(values)
end

check.case("obstacles move along the axis only", function()
  local obstacles = { sg.rigid.sphere{ center = {0, 2}, radius = 1 },
                      sg.rigid.torus{ center = {1, 1.5}, radius = 0.4 },
                      sg.rigid.plane{ point = {0, 1.5}, normal = {0, -1} } }
  for _, obstacle in ipairs(obstacles) do
    local body = block()
    local model = held(body, { t = { on = obstacle, drive = "xy" } },
      { contacts = { k = { slave = body:face "north", master = obstacle, penalty = 10 } } })
    check.fails(function() model:run{ { steps = 2, t = { 0.3, -0.1 } } } end,
      "stages[1].t: the support 't' moves an obstacle by 0.3 along x", "along the axis only")
    check.fails(function()
      model:run{ { steps = 1, t = { 0, -0.01 } }, { steps = 2, t = function(s) return { s, 0 } end } }
    end, "stages[2].t", "by 0.5 along x")
    model:set_target("t", { 1e-16, 0 }) -- the sine of half a turn
    check.fails(function() model:set_target("t", { 0.3, 0 }) end, "'t' moves an obstacle by 0.3 along x")
    check.equal(model:run({ { steps = 1, t = { 0, 0.01 } } }, sg.plain{}).reason, "completed")
  end
end)

check.case("points on the axis stay there", function()
  local body = block()
  check.fails(function() held(body, { t = { on = body:face "west", drive = "x" } }):run{ { steps = 1, t = 0.1 } } end,
    "moves points of body 'b' on the axis", "by 0.1 along x", "drive a face off the axis")
  check.fails(function()
    held(body, { t = { on = body:face "north", fix = "xy", rotate = true } }):run{ { steps = 2, t = 10 } }
  end, "moves points of body 'b' on the axis, such as (0, 1), by 0.0151922 along x",
    "rotate a face that does not reach")
  -- A shape that vanishes on the axis, a face off the axis, a ring, and no motion are right.
  for _, one in ipairs {
    { block(), "north", { drive = "x", shape = function(x) return { 0.1 * x, 0 } end } },
    { block(), "east", { drive = "x" } }, { block(1), "north", { fix = "xy", rotate = true } },
    { block(1), "west", { drive = "x" } } } do
    local own, face, support = table.unpack(one)
    support.on = own:face(face)
    check.equal(held(own, { t = support }):run({ { steps = 1, t = 0.01 } }, sg.plain{}).reason, "completed")
  end
  local still = held(body, { t = { on = body:face "north", drive = "xy" } })
  check.equal(still:run({ { steps = 1, t = { 0, 0.01 } } }, sg.plain{}).reason, "completed")
end)

check.case("forces along the radius, as of rotation, are loads like others", function()
  local body = block()
  local model = held(body, {}, { loads = { spin = { on = body, force = function(x) return { 0.1 * x, 0 } end } } })
  check.equal(#model:warnings(), 0)
  check.equal(model:run({ { steps = 1, spin = 1 } }, sg.plain{}).reason, "completed")
end)
