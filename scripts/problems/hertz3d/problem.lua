-- Hertz point contact in 3D: the eighth of a sphere and the axisymmetric model of it, Hertz's closed form.

local sg = require "signorini"

local problem = {}

local inner, outer, young, poisson = 0.2, 1, 1, 0.3
local load, penalty = math.pi * outer ^ 2 * 1e-4, 1000
local pressed = -load / (math.pi * (outer ^ 2 - inner ^ 2)) -- traction on the cut
-- Under a given force the body is unconstrained until it is in contact. The height of the plane does not affect the
-- result, so the plane is slightly higher and the first iteration finds points in contact.
local height = -outer + 1e-4

--- Elements along the meridian.
function problem.elements_of(mesh)
  return 8 << (math.tointeger(mesh:sub(2)) - 1)
end

local function crowded(at)
  return { elements = 0.75, length = 0.1, at = at }
end

--- The eighth of the sphere. `o`: order, mesh, around (elements around z, by default n/4), layer as in sg.body,
--- layer_knots along the meridian.
function problem.solid(o)
  local n = problem.elements_of(o.mesh)
  local ball = sg.body{
    patch    = sg.shapes.sphere_octant{ inner = inner, outer = outer },
    elements = { o.around or n // 4, n, n }, grading = { false, crowded "end", crowded "start" },
    order    = o.order, contact = "front", thickness_degree = 1,
    layer    = o.layer, layer_knots = o.layer_knots and { 1, o.layer_knots },
    material = sg.linear_elastic{ E = young, nu = poisson },
  }
  local model = sg.model{
    bodies   = { ball = ball },
    supports = { x0 = { on = ball:face "east", fix = "x" }, y0 = { on = ball:face "west", fix = "y" } },
    loads    = { push = { on = ball:face "south", traction = {0, 0, 0} } },
    contacts = { ground = { slave = ball:face "front", penalty = penalty,
                            master = sg.rigid.plane{ point = {0, 0, height}, normal = {0, 0, 1} } } },
  }
  return { model = model, target = { 0, 0, pressed }, dofs = ball:dofs(), force = "ground.fz", parts = 4 }
end

--- The axisymmetric model with the same meridian mesh.
function problem.revolved(o)
  local n = problem.elements_of(o.mesh)
  local ball = sg.body{
    patch    = sg.shapes.quarter_annulus{ inner = inner, outer = outer, start = 270 },
    elements = { n, n }, grading = { crowded "start", crowded "start" }, order = o.order, contact = "south",
    thickness_degree = 1,
    material = sg.linear_elastic{ E = young, nu = poisson },
  }
  local model = sg.model{
    kind     = "axisymmetric",
    bodies   = { ball = ball },
    supports = { axis = { on = ball:face "west", fix = "x" } },
    loads    = { push = { on = ball:face "east", traction = {0, 0} } },
    contacts = { ground = { slave = ball:face "south", penalty = penalty,
                            master = sg.rigid.plane{ point = {0, height}, normal = {0, 1} } } },
  }
  return { model = model, target = { 0, pressed }, dofs = ball:dofs(), force = "ground.fy", parts = 1 }
end

--- Radius of contact and peak pressure of Hertz's point contact under a load p.
function problem.hertz(p)
  local a = (3 * p * outer * (1 - poisson ^ 2) / (4 * young)) ^ (1 / 3)
  return a, 3 * p / (2 * math.pi * a ^ 2)
end

--- The profile of a solid over the radius: the values of a reference radius are means over the contact points with this
--- radius. Also the largest spread of the pressure at one radius.
function problem.ring_profile(profile)
  local order = {}
  for i = 1, #profile.x do order[i] = { i = i, radius = math.sqrt(profile.X[i] ^ 2 + profile.Y[i] ^ 2) } end
  table.sort(order, function(a, b) return a.radius < b.radius end)
  local rings, spread = { x = {}, pressure = {}, gap = {} }, 0
  local first = 1
  while first <= #order do
    local last = first
    while last < #order and order[last + 1].radius - order[first].radius < 1e-9 * outer do last = last + 1 end
    local sum, low, high = { x = 0, pressure = 0, gap = 0 }, math.huge, -math.huge
    for k = first, last do
      local i = order[k].i
      low, high = math.min(low, profile.pressure[i]), math.max(high, profile.pressure[i])
      sum.x = sum.x + math.sqrt(profile.x[i] ^ 2 + profile.y[i] ^ 2)
      sum.pressure, sum.gap = sum.pressure + profile.pressure[i], sum.gap + profile.gap[i]
    end
    for name, total in pairs(sum) do rings[name][#rings[name] + 1] = total / (last - first + 1) end
    spread, first = math.max(spread, high - low), last + 1
  end
  return rings, spread
end

problem.load, problem.outer = load, outer

return problem
