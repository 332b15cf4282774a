-- The O-ring of objects/o_ring.lua between two plates, compressed by a fifth of its diameter: the force.

local sg = require "signorini"
local settings = require "studies.accuracy.settings"

local d, most = 5.33, 0.2

local o_ring = { name = "o_ring", title = "O-ring", unit = "N/mm", force = "force" }

function o_ring.scene(o)
  local n = 24 << math.tointeger(o.mesh:sub(2))
  local ring = sg.body{
    patch = sg.shapes.polar_disc{ radius = d / 2, center = { 0, d / 2 } }, order = o.order, contact = "south",
    elements = { n, n // 4 }, volumetric = o.volumetric, thickness_degree = o.thickness_degree,
    layer = o.place and function(X) return math.abs(X[1]) < 0.35 * d end or nil,
    material = sg.mooney_rivlin{ c10 = 0.4, c01 = 0.1, K = 100 },
  }
  local plate, gap = sg.rigid.plane{ point = { 0, d }, normal = { 0, -1 } }, 0.175 * d
  local function touch(master) return settings.contact(o, { slave = ring:face "south", master = master }, 200) end
  local function wall(side)
    return touch(sg.rigid.plane{ point = { side * (d / 2 + gap), 0 }, normal = { -side, 0 } })
  end
  local model = sg.model{
    bodies = { ring = ring },
    supports = { plate = { on = plate, drive = "y" },
                 center = { on = ring:corner "west-north", drive = "y", fix = "x" },
                 seam = { on = ring:corner "west-south", fix = "x" } },
    contacts = { top = touch(plate), bottom = touch(sg.rigid.plane{ point = { 0, 0 }, normal = { 0, 1 } }),
                 left = o.whole and wall(-1) or nil, right = o.whole and wall(1) or nil },
  }
  return model, { { name = "close", steps = settings.steps(o, 8), plate = -most * d, center = -most * d / 2 } },
    function(run) return { force = math.abs(run:column "plate.fy"[run.steps]) } end
end

o_ring.reference = { order = "N2-N2.2", setting = "multipliers", mesh = "m2" }
o_ring.checks = { { order = "N2-N2.2", setting = "multipliers", mesh = "m1" },
                  { order = "N2", setting = "penalty × 100", mesh = "m2" } }
o_ring.base = { order = "N2-N2.2", setting = "default", mesh = "m1" }
o_ring.levers = { "whole model", "projected volume", "m0", "N2", "N3", "local layer", "thickness degree 1",
                  "mortar equal", "multipliers", "penalty / 10", "penalty × 10", "half the steps" }

return o_ring
