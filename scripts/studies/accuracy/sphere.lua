-- Hertz's point contact under a given displacement: the axisymmetric model, or an eighth of the sphere.

local sg = require "signorini"
local settings = require "studies.accuracy.settings"

local sphere = { name = "sphere", title = "Hertz's point contact", unit = "N", force = "pressing force" }

local radius = 0.0638 -- of the contact, by Hertz for the force that belongs to this displacement

function sphere.scene(o)
  local n = 8 << (math.tointeger(o.mesh:sub(2)) - 1)
  local function graded(at) return { elements = 0.75, length = 0.1, at = at } end
  local near = o.place == "edge" and 0.8 * radius or -1
  local ball = sg.body{
    patch = o.solid and sg.shapes.sphere_octant{ inner = 0.2, outer = 1 }
      or sg.shapes.quarter_annulus{ inner = 0.2, outer = 1, start = 270 },
    elements = o.solid and { n // 4, n, n } or { n, n },
    grading = o.solid and { false, graded "end", graded "start" } or { graded "start", graded "start" },
    order = o.order, contact = o.solid and "front" or "south", thickness_degree = o.thickness_degree,
    layer = o.place and function(X)
      local r = X[3] and math.sqrt(X[1] ^ 2 + X[2] ^ 2) or X[1]
      return r > near and r < 1.2 * radius
    end or nil, layer_knots = o.knots and (o.solid and { 1, o.knots } or o.knots),
    material = sg.linear_elastic{ E = 1, nu = 0.3 },
  }
  local model = sg.model{
    kind = not o.solid and "axisymmetric" or nil, bodies = { ball = ball },
    supports = o.solid and { x0 = { on = ball:face "east", fix = "x" }, y0 = { on = ball:face "west", fix = "y" },
                             grip = { on = ball:face "south", drive = "z" } }
      or { axis = { on = ball:face "west", fix = "x" }, grip = { on = ball:face "east", drive = "y" } },
    contacts = { ground = settings.contact(o, {
      slave = ball:face(o.solid and "front" or "south"),
      master = sg.rigid.plane{ point = o.solid and { 0, 0, -1 } or { 0, -1 },
                               normal = o.solid and { 0, 0, 1 } or { 0, 1 } } }, 1000) },
  }
  return model, { { name = "press", steps = settings.steps(o, 8), grip = -0.004 } }, function(run)
    local parts = o.solid and 4 or 1
    return { force = parts * math.abs(run:column(o.solid and "grip.fz" or "grip.fy")[run.steps]) }
  end
end

sphere.reference = { order = "N2-N2.2", setting = "multipliers", mesh = "m4" }
sphere.checks = { { order = "N2-N2.2", setting = "multipliers", mesh = "m3" },
                  { order = "N2-N2.2", setting = "penalty × 100", mesh = "m4" } }
sphere.base = { order = "N2-N2.2", setting = "default", mesh = "m2" }
sphere.levers = { "solid model", "m1", "m3", "N2", "N3", "layer at the edge", "thickness degree 1", "mortar equal",
                  "multipliers", "penalty / 10", "penalty × 10" }

return sphere
