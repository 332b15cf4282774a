-- The study of discretizations: the whole path on one mesh; forces, oscillations, work, pictures.

local sg = require "signorini"
local formulations = require "formulations.rows"
local meshes = require "problems.solid_ironing.mesh"
local output = require "problems.solid_ironing.output"
local study = require "problems.solid_ironing.study"

local orders = {}

local reference_order = "N2"

--- `options`: orders, mesh and formulation (their names), press, slide, linear. Returns { mesh, cases }; cases also by
--- order.
function orders.run(problem, options, files)
  local mesh, press, slide = meshes.read(options.mesh), options.press, options.slide
  local cases, states = {}, {}
  for i, order in ipairs(options.orders) do
    local case = { order = order, mesh = mesh, press = press, slide = slide, linear = options.linear,
                   formulation = formulations[options.formulation] }
    if i == 1 then case.on_step, states = study.record_states(case, problem.tool) end
    study.solve(problem, case)
    print(("%s at %s, %.1f s of processor time"):format(order, mesh.name, case.user))
    print(case.run)
    case.run:csv(files(order .. ".csv"))
    cases[i], cases[order] = case, case
  end
  study.compare(cases, cases[reference_order])
  local first, last = cases[1].first, cases[1].last
  print(("\nWork, %d + %d steps, failed ones halved; without halving the path would have ended at the first failure")
    :format(press, slide))
  print(output.work_table(cases))
  local window = ("max - min over the steps %d to %d, raw and detrended by a parabola"):format(first, last)
  print(("\nForces; oscillations: %s"):format(window))
  print(output.force_table(cases))
  output.force_csv(files "forces.csv", cases,
    ("%s at %s; oscillations: %s"):format(problem.title, mesh.name, window))
  local title = ("%s at %s"):format(problem.title, mesh.name)
  files:draw("path.png", "an accepted step", function(file)
    return output.draw_path(file, cases, title .. ": pressing force")
  end)
  files:draw("Pz.png", "a step of the sliding", function(file)
    return output.draw_force(file, cases, "Pz", { title = title .. ": pressing force", ylabel = "Pz" })
  end)
  files:draw("Px.png", "a step of the sliding", function(file)
    return output.draw_force(file, cases, "Px", { title = title .. ": drag, without friction", ylabel = "Px" })
  end)
  files:draw("oscillations.png", "N2 among the orders, and runs that complete the window", function(file)
    return output.draw_oscillations(file, cases, title .. ": oscillation of the forces")
  end)
  files:draw("states.png", "a completed stage", function(file)
    if #states == 0 then return false end
    sg.sheet{ states, file = file, columns = 1, title = ("%s, %s"):format(title, cases[1].order) }
    return true
  end)
  return { mesh = mesh, cases = cases }
end

return orders
