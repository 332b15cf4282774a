-- Two elastic rings that are pressed together (rings2d.lua): the force, and the L₂ error of the pressure.

local sg = require "signorini"
local force = require "studies.accuracy.force"
local settings = require "studies.accuracy.settings"

local rings = {
  name = "rings", title = "Two rings", unit = "N/m",
  force = "pressing force", second = { "pressure", "L_2 error of the pressure (% of the peak)" },
}

function rings.scene(o)
  local refined = 1 << (math.tointeger(o.mesh:sub(2)) - 1)
  local function ring(inner, outer, start, E, elements, center)
    return sg.body{
      patch = sg.shapes.quarter_annulus{ inner = inner, outer = outer, center = center, start = start },
      elements = { elements * refined, 3 }, order = o.order, contact = "south", thickness_degree = o.thickness_degree,
      material = sg.neo_hookean{ E = E, nu = 0.3 },
    }
  end
  local upper, lower = ring(8, 10, 270, 100, 12, { 0, 22 }), ring(10, 12, 0, 300, 20, { 0, 0 })
  local model = sg.model{
    bodies   = { upper = upper, lower = lower },
    supports = { bed      = { on = lower:face "west", fix = "xy" },
                 symmetry = { on = { upper:face "west", lower:face "east" }, fix = "x" },
                 grip     = { on = upper:face "east", fix = "x", drive = "y" } },
    contacts = { interface = settings.contact(o, { slave = upper:face "south", master = lower:face "south", mu = 0.1 },
      100) },
  }
  return model, { { name = "press", steps = settings.steps(o, 40), grip = -4 } }, function(run)
    return { force = 2 * math.abs(run:column "grip.fy"[run.steps]),
             profile = force.profile(model, "interface") }
  end
end

rings.pressure = force.pressure_error
rings.meshes = { "m1", "m2", "m3" }
rings.series = {
  { "default", "L1", "L2", "N2", "N3", "N2-N2.1", "N2-N2.2" }, { "published", "N2", "N2-N2.2" },
  { "mortar equal", "N2-N2.2" }, { "multipliers", "N2", "N2-N2.2" },
}
rings.once = { m1 = true, m2 = true, m3 = true }
rings.reference = { order = "N2-N2.2", setting = "multipliers", mesh = "m4" }
rings.checks = { { order = "N2-N2.2", setting = "multipliers", mesh = "m3" },
                 { order = "N2-N2.2", setting = "penalty × 100", mesh = "m4" } }

return rings
