-- Hertz's line contact under a given displacement (hertz2d.lua): the force, and the L₂ error of the pressure.

local sg = require "signorini"
local force = require "studies.accuracy.force"
local problem = require "problems.hertz2d.problem"
local settings = require "studies.accuracy.settings"

local half_width = problem.hertz(2 * problem.half_load * problem.outer)

local hertz = {
  name = "hertz", title = "Hertz's line contact", unit = "N/mm",
  force = "pressing force", second = { "pressure", "L_2 error of the pressure (% of the peak)" },
}

local places = {
  contact = function(X) return math.abs(X[1]) < 1.2 * half_width end,
  edge = function(X) return math.abs(X[1]) < 1.2 * half_width and math.abs(X[1]) > 0.8 * half_width end,
}

function hertz.scene(o)
  local refined = 1 << (math.tointeger(o.mesh:sub(2)) - 1)
  local graded = { elements = 0.8, length = 0.1, at = "start" }
  local ring = sg.body{
    patch = sg.shapes.quarter_annulus{ inner = problem.inner, outer = problem.outer, start = 270 },
    elements = { 9 * refined, 48 }, grading = { graded, graded }, order = o.order, contact = "south",
    thickness_degree = o.thickness_degree, layer = places[o.place], layer_knots = o.knots,
    material = sg.linear_elastic{ E = problem.young, nu = problem.poisson },
  }
  local plane = sg.rigid.plane{ point = { 0, -problem.outer }, normal = { 0, 1 } }
  local model = sg.model{
    bodies = { ring = ring },
    supports = { symmetry = { on = ring:face "west", fix = "x" }, grip = { on = ring:face "east", drive = "y" } },
    contacts = { ground = settings.contact(o, { slave = ring:face "south", master = plane },
      problem.penalties.displacement) },
  }
  return model, { { name = "press", steps = settings.steps(o, 10), grip = -problem.push_down } }, function(run)
    return { force = 2 * math.abs(run:column "grip.fy"[run.steps]), -- of both halves
             profile = force.profile(model, "ground") }
  end
end

hertz.pressure = force.pressure_error
hertz.meshes = { "m1", "m2", "m3", "m4" }
hertz.series = {
  { "default", "L1", "L2", "N2", "N3", "N2-N2.1", "N2-N2.2" }, { "published", "L1", "N2", "N2-N2.2" },
  { "mortar equal", "N2-N2.2" }, { "multipliers", "N2", "N2-N2.2" }, { "penalty × 10", "N2" },
  { "layer at the edge", "N2-N2.2" }, { "layer knots", "N2" },
}
hertz.reference = { order = "N2-N2.2", setting = "multipliers", mesh = "m5" }
hertz.checks = { { order = "N2-N2.2", setting = "multipliers", mesh = "m4" },
                 { order = "N2-N2.2", setting = "penalty × 100", mesh = "m5" } }

return hertz
