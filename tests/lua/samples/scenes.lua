-- The scenes and the study of the samples.

local sg = require "signorini"

local scenes = {}

scenes.path = { { name = "press", steps = 2, grip = { 0, -0.05 } },
                { name = "slide", steps = 2, grip = { 0.1, -0.05 } } }

--- A block on a slab, with friction.
function scenes.plane()
  local soft = sg.neo_hookean{ E = 1, nu = 0.3 }
  local block = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 0.5, corner = { -0.5, 0 } }, order = "N2",
                         elements = { 2, 1 }, contact = "south", material = soft }
  local slab = sg.body{ patch = sg.shapes.rectangle{ width = 2, height = 0.5, corner = { -1, -0.5 } },
                        order = "N2-N2.1", elements = { 4, 1 }, contact = "north", material = soft }
  return sg.model{
    bodies = { block = block, slab = slab },
    supports = { bed = { on = slab:face "south", fix = "xy" }, grip = { on = block:face "north", drive = "xy" } },
    contacts = { c = { slave = block:face "south", master = slab:face "north", penalty = 50,
                       friction = { mu = 0.3, penalty = 50 } } },
  }
end

--- A block that slides over a disc, with friction.
function scenes.disc()
  local block = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 0.5, corner = { -0.5, 0 } }, order = "N2",
                         elements = { 4, 1 }, contact = "south", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  local disc = sg.rigid.cylinder{ center = { 0.3, -2 }, radius = 2 }
  return sg.model{
    bodies = { block = block },
    supports = { grip = { on = block:face "north", drive = "xy" } },
    contacts = { c = { slave = block:face "south", master = disc, penalty = 50,
                       friction = { mu = 0.3, penalty = 50 } } },
  }
end

--- A cube below a sphere, in mortar contact.
function scenes.space()
  local cube = sg.body{ patch = sg.shapes.block{ size = { 1, 1, 1 } }, elements = { 1, 1, 1 }, order = "N2",
                        contact = "back", material = sg.yeoh{ c10 = 0.5, c20 = -0.01, c30 = 0.001, K = 2 } }
  local ball = sg.rigid.sphere{ center = { 0.5, 0.5, 2 }, radius = 1 }
  return sg.model{
    bodies = { cube = cube },
    supports = { bed = { on = cube:face "front", fix = "xyz" }, tool = { on = ball, drive = "z" } },
    contacts = { c = { slave = cube:face "back", master = ball, method = "mortar", penalty = 100, points = 4 } },
  }
end

--- Four cases, one of which fails.
function scenes.study(folder)
  return sg.study{ name = "samples", folder = folder, inputs = "samples", units = { force = "N" },
    cases = sg.grid{ order = { "N2", "N3" }, mesh = { 1, 2 } },
    run = function(case)
      if case.order == "N3" and case.mesh == 2 then return { failed = true, reason = "a reason" } end
      return { force = case.mesh / 4, label = case.order .. "!", list = { case.mesh, 0.1 } }
    end }
end

return scenes
