-- Ironing in space with a spherical indenter of radius 7.5, pressed by 5.4: the oscillation of both forces.
--
-- Half a pipe (cylinder_ironing3d.lua) would be smoother, but on meshes that are coarse enough to be timed here its
-- drag oscillation does not fall with the mesh: for N4 it is a fifth on 9 elements of what it is on 13. The sphere's
-- does.
--
-- Without friction a state does not depend on the path: the indenter is pressed at the beginning of the window
-- and slides through it only. The window is one element of the sparse slab, in its middle; so it is two of the coarse
-- and three of the middle slab, and whole periods of the oscillation for all, so no trend is subtracted.
--
-- "N2-N2.2 local" has its layer in the part of the slab that the indenter reaches, and on the whole face of the
-- indenter; "N2-N2.2 following" where the faces touch.

local measure = require "problems.ironing2d.measure"
local problem = require "problems.ironing3d.problem"
local timed = require "studies.speed_against_accuracy.timed"
local way_of = require "studies.speed_against_accuracy.ways"

-- Length of an element of the sparse slab, and steps through it: with 36, as long as the published ones, layers need
-- cuts in half, which take more time than steps of two thirds.
local window, slide = 100 / 9, 54
local down = 0.4
local reach = 7.5 -- half-width of the part of the slab with a local layer, beyond the center of the indenter

local ways = {
  ["local"] = { layer = { slab = { { (50 - window / 2 - reach) / 100, (50 + window / 2 + reach) / 100 },
                                   { 0.5 - reach / 30, 0.5 + reach / 30 } } } },
  following = { adapt = { margin = 1 } },
}

local function oscillation(force)
  return function(row) return measure.oscillation(row[force], 1, #row[force]).raw end
end

return {
  name = "ironing3d", title = "Ironing in 3D", page = "ironing3d.md",
  about = [[
A soft block with a spherical bottom (R = 7.5) is pressed into an equally soft slab by 5.4 and dragged over the length
of one element of the sparse mesh, without friction. The exact forces are nearly constant, so the error is
their oscillation. Failed steps are halved, and their time counts. "Local": the layer of the slab is in the part that
the indenter reaches only, from 7.5 before its center at first to 7.5 beyond it at last, and from 7.5 to 22.5 across;
"following": the layers are in the elements in contact and one more on each side (`adapt = { margin = 1 }`).]],
  orders = { "N2", "N4", "N2-N4", "N2-N2.1", "N2-N2.2", "N2-N2.2 local", "N2-N2.2 following" },
  meshes = { "sparse", "coarse", "middle" }, rounds = 1,
  -- The middle mesh serves for comparison with layers on coarser ones; with layers it would take minutes.
  affordable = function(order, mesh) return mesh ~= "middle" or order == "N2" end,
  errors = {
    { name = "dPx", title = "oscillation of the drag", of = oscillation "Px" },
    { name = "dPz", title = "oscillation of the pressing force", of = oscillation "Pz" },
  },
  savings = {},

  run = function(case)
    local order, way = way_of(case.order, ways)
    local solved, spent = timed(function()
      return problem.solve{ order = order, layer = way.layer, adapt = way.adapt, mesh = case.mesh,
                            radius = 7.5, depth = 5.4, down = down,
                            from = 50 - window / 2, distance = window, along = window / slide }
    end)
    local run, model = solved.run, solved.model
    -- The window's first state is the one from which the indenter starts to slide.
    local first = run.stages[1].steps
    local function slid(column) return table.move(column, first, #column, 1, {}) end
    return { wall = spent.wall, cpu = spent.cpu, iterations = run.iterations,
             dofs = model:body("indenter"):dofs().total + model:body("slab"):dofs().total, -- at the end
             Px = slid(run:column "grip.fx"), Pz = slid(run:column "grip.fz"),
             failed = run.failed, reason = run.failed and run.failure or nil }
  end,
}
