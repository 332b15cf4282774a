-- Two elastic rings: the L₂ error of the contact pressure at the last step.
--
-- The published reference, N2 at m3, has an error of 4e-3, more than layers at m3. Here the reference is N2 at m6:
-- N2-N2.1 at m5 differs from it by 2e-5, a fifth of the least error on m1 to m4. Both profiles end where the gap is
-- zero: where they end at the next open point, as in Table 7.5, the distance of points at the edge sets errors below
-- 1e-3.

local sg = require "signorini"
local problem = require "problems.rings2d.problem"
local timed = require "studies.speed_against_accuracy.timed"

--- Time saved by a case against another one according to Table 7.6, in %.
local function printed_savings(list)
  local times = {}
  for _, row in ipairs(sg.reference "rings2d_time_table7_6".rows) do times[row[1] .. " " .. row[2]] = row[3] end
  for _, pair in ipairs(list) do
    pair[5] = 100 * (1 - times[pair[1] .. " " .. pair[2]] / times[pair[3] .. " " .. pair[4]])
  end
  return list
end

return {
  name = "rings", title = "Rings", page = "rings2d.md",
  about = [[
Two elastic half rings are pushed into each other in 40 steps, with friction. The error is the L₂ norm of p_N − p_ref
at the last of them, against N2 at m6.]],
  orders = { "N2", "N4", "N2-N4", "N2-N2.1", "N2-N2.2", "N2-N2.2x2" },
  meshes = { "m1", "m2", "m3", "m4" }, rounds = 3,
  reference = { order = "N2", mesh = "m6" },
  errors = { {
    name = "error", title = "L₂ error of the pressure", unit = "N/m²·√m",
    of = function(row, reference)
      return (sg.profile_error{ profile = row.profile, reference = reference.profile, edge = "gap" })
    end,
  } },
  savings = printed_savings{
    { "N2-N2.1", "m1", "N2", "m2" }, { "N2-N2.1", "m1", "N4", "m1" }, { "N2-N2.1", "m2", "N4", "m2" },
    { "N2-N4", "m1", "N4", "m1" }, { "N2-N4", "m2", "N4", "m2" },
  },
  saved_in = "Table 7.6",

  run = function(case)
    local solved, spent = timed(function() return problem.solve(case.order, case.mesh) end)
    local profile = solved.profile
    return { wall = spent.wall, cpu = spent.cpu, iterations = solved.run.iterations, dofs = solved.dofs,
             profile = { x = profile.x, pressure = profile.pressure, gap = profile.gap } }
  end,
}
