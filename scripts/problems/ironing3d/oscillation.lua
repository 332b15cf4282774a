-- The standard variant: comparison with Tables 7.10 and 7.11 for several radii of the cap and initial gaps.

local sg = require "signorini"
local formulations = require "formulations.rows"
local measure = require "problems.ironing3d.measure"
local output = require "problems.ironing3d.output"
local problem = require "problems.ironing3d.problem"

local oscillation = {}

--- The rows of a published table as tables of named values.
local function records(name)
  local data, list = sg.reference(name), {}
  for i, row in ipairs(data.rows) do
    list[i] = {}
    for c, column in ipairs(data.columns) do list[i][column] = row[c] end
  end
  return list
end

-- ── Degrees of freedom ───────────────────────────────────────────────────────────────────────────────────────────────

--- Degrees of freedom of all rows of Table 7.11 and the published ones: a list of { order, mesh, indenter, slab,
--- printed }, and in how many entries the two differ.
function oscillation.degrees_of_freedom()
  local rows, differences = {}, 0
  for i, printed in ipairs(records "ironing3d_dofs_table7_11") do
    local order, mesh = printed.discretization, printed.mesh
    local indenter, slab = problem.bodies({ order = order, mesh = mesh, radius = 25.5 }, 50)
    local row = { order = order, mesh = mesh, indenter = indenter:dofs(), slab = slab:dofs(), printed = printed }
    for _, part in ipairs { "interface", "bulk", "total" } do
      for _, body in ipairs { "indenter", "slab" } do
        if row[body][part] ~= printed[body .. "_" .. part] then differences = differences + 1 end
      end
    end
    if row.indenter.total + row.slab.total ~= printed.total then differences = differences + 1 end
    rows[i] = row
    collectgarbage() -- Lua does not count the memory of bodies
  end
  return rows, differences
end

-- ── Oscillation ──────────────────────────────────────────────────────────────────────────────────────────────────────

--- Where a case is pressed and how far it slides. Without friction a state does not depend on the path, so the window
--- suffices, pressed at its beginning.
local function path_of(slide)
  if slide == "full" then return problem.start, problem.distance end
  return measure.from, measure.to - measure.from
end

--- Runs all orders of one cap and gap; returns { radius, gap, depth, cases }, cases also by order and mesh.
local function solve_set(options, radius, gap, files)
  local depth = problem.published_depth - gap
  local set = { radius = radius, gap = gap, depth = depth, cases = {} }
  local from, distance = path_of(options.slide)
  local press = math.floor(depth / options.down + 0.5)
  local along = math.floor(distance / problem.along + 0.5)
  local keep, draw_states = output.record_states{
    [1] = true, [press // 2] = true, [press] = true, [press + along] = true,
  }
  local function solve(order, mesh)
    local case = measure.oscillations(problem.solve{
      order = order, mesh = mesh, radius = radius, depth = depth, cap = options.cap, from = from, distance = distance,
      down = options.down, linear = options.linear, formulation = formulations[options.formulation],
      on_step = #set.cases == 0 and keep or nil,
    })
    case.model = nil
    print(("%s %s, R = %g, gap %g"):format(order, mesh, radius, gap))
    print(case.run)
    case.run:csv(files(("%s_%s_R%g_gap%g.csv"):format(order, mesh, radius, gap)))
    table.insert(set.cases, case)
    set.cases[order .. " " .. mesh] = case
  end
  for _, order in ipairs(options.orders) do solve(order, "coarse") end
  for _, order in ipairs(options.fine) do solve(order, "fine") end
  files:draw(("states_R%g_gap%g.png"):format(radius, gap), "an accepted step", function(file)
    return draw_states(file, ("%s, R = %g, depth %g"):format(set.cases[1].order, radius, depth))
  end)
  measure.compare(set.cases, set.cases["N2 coarse"])
  return set
end

local function published()
  local found = {}
  for _, row in ipairs(records "ironing3d_oscillation_table7_10") do
    found[row.discretization .. " " .. row.mesh] = row
  end
  return found
end

--- The study. Returns { dofs, differences, sets }.
function oscillation.run(options, files)
  local dofs, differences = oscillation.degrees_of_freedom()
  print(("Degrees of freedom compared with Table 7.11: %d of %d entries differ"):format(differences, 7 * #dofs))
  print(output.dofs_table(dofs))
  local printed, sets = published(), {}
  for _, radius in ipairs(options.radius) do
    for _, gap in ipairs(options.gap) do
      local set = solve_set(options, radius, gap, files)
      sets[#sets + 1] = set
      local name = ("_R%g_gap%g"):format(radius, gap)
      print(("\nR = %g, gap %g (depth %g): work"):format(radius, gap, set.depth))
      print(output.work_table(set.cases))
      print(("\nR = %g, gap %g (depth %g): max − min for the center from x = %g to %g, and Table 7.10")
        :format(radius, gap, set.depth, measure.from, measure.to))
      print(output.oscillation_table(set.cases, printed))
      output.oscillation_csv(files("oscillations" .. name .. ".csv"), set, printed)
      files:draw("forces" .. name .. ".png", "a state that slides", function(file)
        return output.draw_forces(file, set.cases, ("R = %g, depth %g"):format(radius, set.depth))
      end)
      files:draw("oscillations" .. name .. ".png", "N2 among the orders, runs that complete the window", function(file)
        return output.draw_oscillations(file, set, printed)
      end)
    end
  end
  return { dofs = dofs, differences = differences, sets = sets }
end

return oscillation
