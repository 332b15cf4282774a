-- Ironing in space without friction (ironing3d.lua): a block with a spherical bottom (R = 7.5) is pressed into an
-- equally soft slab by 5.4 and slides over one element of the sparse slab, in its middle. States do not depend on the
-- path, so it is pressed where the window begins.

local sg = require "signorini"
local force = require "studies.accuracy.force"
local problem = require "problems.ironing3d.problem"
local settings = require "studies.accuracy.settings"

local window, slide, press, depth, radius, reach = 100 / 9, 54, 14, 5.4, 7.5, 7.5

local ironing3d = {
  name = "ironing3d", title = "Ironing in 3D", unit = "N",
  force = "pressing force", second = { "oscillation", "oscillation of both forces (% of the mean pressing force)" },
}

function ironing3d.scene(o)
  local elements, material = problem.meshes[o.mesh], sg.neo_hookean{ E = 1, nu = 0.3 }
  local indenter = sg.body{
    patch = sg.shapes.spherical_indenter{ width = 10, depth = 10, height = 11, radius = radius, elements = 1,
                                          corner = { 45 - window / 2, 10, 22 } },
    elements = elements.indenter, order = o.order, contact = "front", thickness_degree = o.thickness_degree,
    material = material,
  }
  local slab = sg.body{
    patch = sg.shapes.block{ size = { 100, 30, 22 } }, elements = elements.slab, order = o.order, contact = "back",
    thickness_degree = o.thickness_degree, material = material,
    layer = o.place and { { 0.5 - (window / 2 + reach) / 100, 0.5 + (window / 2 + reach) / 100 },
                          { 0.5 - reach / 30, 0.5 + reach / 30 } } or nil,
  }
  local model = sg.model{
    bodies   = { indenter = indenter, slab = slab },
    supports = { bed = { on = slab:face "front", fix = "xyz" }, grip = { on = indenter:face "back", drive = "xyz" } },
    contacts = { interface = settings.contact(o, { slave = indenter:face "front", master = slab:face "back" }, 100) },
  }
  local path = {
    { name = "press", steps = settings.steps(o, press), grip = { 0, 0, -depth } },
    { name = "slide", steps = settings.steps(o, slide), grip = { window, 0, -depth } },
  }
  return model, path, function(run)
    local _, drag = force.mean_and_oscillation(force.window(run, "grip.fx", 0))
    local down, shaking = force.mean_and_oscillation(force.window(run, "grip.fz", 0))
    return { force = -down, oscillation = 100 * math.max(drag, shaking) / math.abs(down) }
  end
end

ironing3d.meshes = { "sparse", "coarse" }
ironing3d.series = {
  { "default", "N2", "N3", "N2-N2.1", "N2-N2.2" }, { "published", "N2", "N2-N2.1" }, { "mortar equal", "N2-N2.1" },
  { "multipliers", "N2", "N2-N2.1" }, { "local layer", "N2-N2.2" },
}
ironing3d.affordable = function(order, mesh, setting)
  return mesh == "sparse" or setting == "default" and (order == "N2" or order == "N2-N2.1")
end
ironing3d.once = { sparse = true, coarse = true }
-- Without friction the steps do not matter, so those of the reference are long.
ironing3d.reference = { order = "N2-N2.1", setting = "multipliers + steps × 4", mesh = "middle" }
ironing3d.checks = { { order = "N2", setting = "multipliers + steps × 4", mesh = "middle" },
                     { order = "N2-N2.1", setting = "multipliers + steps × 4", mesh = "coarse" } }

return ironing3d
