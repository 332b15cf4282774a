-- Hertz's line contact under a given displacement: the L₂ error of the pressure against N2 at m6, as in hertz2d.lua.

local sg = require "signorini"
local problem = require "problems.hertz2d.problem"
local timed = require "studies.speed_against_accuracy.timed"

local steps = 10

return {
  name = "hertz", title = "Hertz", page = "hertz.md",
  about = [[
A linear elastic quarter ring is pressed onto a rigid plane in ten steps. The error is the L₂ norm of p/p_ref over
x/a_ref at the last of them, against N2 at m6.]],
  orders = { "N2", "N4", "N2-N4", "N2-N2.1", "N2-N2.2", "L1" },
  meshes = { "m1", "m2", "m3", "m4", "m5" }, rounds = 3,
  reference = { order = "N2", mesh = "m6" },
  errors = { {
    name = "error", title = "L₂ error of the pressure",
    of = function(row, reference)
      local width = sg.profile_edges{ profile = reference.profile }.to
      return (sg.profile_error{ profile = row.profile, reference = reference.profile, normalize = "max",
                                coordinate = function(point) return point.x / width end })
    end,
  } },
  savings = { { "N2-N2.2", "m3", "N2", "m4", 42.48 }, { "N2-N2.2", "m4", "N2", "m5", 43.74 } }, -- section 7.2
  saved_in = "section 7.2",

  run = function(case)
    local model, run, ring
    local _, spent = timed(function()
      local stage
      model, stage, ring = problem.scene{ order = case.order, mesh = case.mesh, load = "displacement" }
      stage.steps = steps
      run = model:run({ stage }, sg.plain{})
    end)
    local profile = model:profile "ground"
    return { wall = spent.wall, cpu = spent.cpu, iterations = run.iterations, dofs = ring:dofs().total,
             profile = { x = profile.x, pressure = profile.pressure, gap = profile.gap },
             failed = run.failed, reason = run.failed and run.failure or nil }
  end,
}
