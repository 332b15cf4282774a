-- The deep variant: which discretizations converge, by number of contact points, with and without halving of steps.

local sg = require "signorini"
local page = require "page.tables"
local measure = require "problems.ironing2d.measure"
local output = require "problems.ironing2d.output"
local problem = require "problems.ironing2d.problem"

local deep = {}

--- Steps whose states are drawn, as in Figure 7.10: start and end of the pressing, middle and end of the sliding.
local picture_steps = { [1] = true, [46] = true, [171] = true, [296] = true }

--- Published results at m1 with the published steps, by multiples of p + 1 contact points: the thesis (3(p + 1) points,
--- section 7.1.4), and an independent program without step control.
local thesis = { [3] = { N2 = "fails" } }
local independent = { [1] = { N2 = "fails", N4 = "fails" }, [2] = { N2 = "fails at 17" }, [3] = {} }
local function finding(found, multiple, order) return found[multiple] and (found[multiple][order] or "converges") end

--- The number of iterations after which the last residuals repeat (contact states cycle), or nil.
local function cycle(residuals)
  local function again(length)
    for i = #residuals - length + 1, #residuals do
      local before = residuals[i - length]
      if not before or math.abs(residuals[i] - before) > 1e-3 * before then return false end
    end
    return true
  end
  for length = 1, #residuals // 2 do
    if again(length) then return length end
  end
end

--- "converges", or the step that failed and why.
local function outcome(run)
  if not run.failed then return "converges" end
  local step = run.steps + 1
  local attempts = run:attempts(step)
  local last = attempts[#attempts]
  local length = last.reason == "iterations" and cycle(last.residuals)
  return ("%s at %d"):format(length and ("cycle of %d"):format(length) or last.reason, step)
end

--- Runs a discretization with and without halving. Returns { order, mesh, multiple, coarser, plain, halving }, both as
--- problem.solve returns them.
local function compare(options, order, mesh, multiple, coarser, on_step)
  local case = { set_up = problem.variants.deep, order = order, mesh = mesh, coarser = coarser, linear = options.linear,
                 points = multiple * (problem.layer_degree(order) + 1) }
  local plain = problem.solve(case)
  case.step, case.on_step = { adaptive = true }, on_step
  return { order = order, mesh = mesh, multiple = multiple, coarser = coarser, plain = plain,
           halving = problem.solve(case) }
end

local function outcome_table(comparisons)
  local rows = {}
  for i, c in ipairs(comparisons) do
    local plain, halving = c.plain.run, c.halving.run
    local published = c.mesh == "m1" and c.coarser == 1
    rows[i] = { c.order, ("%d(p+1)"):format(c.multiple), outcome(plain), plain.iterations, outcome(halving),
                halving.iterations, halving.cutbacks, published and finding(thesis, c.multiple, c.order),
                published and finding(independent, c.multiple, c.order) }
    for j = 8, 9 do rows[i][j] = rows[i][j] or "–" end
  end
  return sg.table{
    columns = { "order", "points", "equal steps", "iterations", "halving", "iterations", "cut-backs", "thesis",
                "independent" }, rows = rows,
  }
end

--- Outcomes on the first mesh and its oscillations for the page: a column for each number of points and step length.
local function fill_page(options, all, best)
  local rows = {}
  for _, c in ipairs(all) do
    local plain, halving = outcome(c.plain.run), c.halving.run
    if c.plain.run.failed then
      plain = ("%s; %s"):format(plain, halving.failed and "fails with halving" or halving.cutbacks .. " halved")
    end
    local name = (c.multiple > 1 and c.multiple .. "(p + 1)" or "p + 1")
      .. (c.coarser > 1 and (", steps × %d"):format(c.coarser) or "")
    if c.mesh == options.mesh[1] then rows[#rows + 1] = { c.order, name, plain } end
  end
  page.fill(options, "ironing2d", "ironing2d_deep", {
    deep = page.across({ columns = { "", "", "" }, rows = rows }, { 1 }, 2, { 3 }, { "discretization", "%s" }),
    deep_oscillation = page.pick(output.oscillation_table(best), { 1, 3, 4, 6, 7 },
      { "discretization", "ΔPy (N/mm)", "ΔPy (% of N2)", "ΔPx (N/mm)", "ΔPx (% of N2)" }),
  })
end

--- The table of one mesh and step length; charts and CSV files for the largest number of points, states of the first
--- order.
local function study_mesh(options, mesh, coarser, files)
  local comparisons, best = {}, { mesh = mesh }
  local most = options.points[#options.points]
  local keep, draw_states = output.record_states(picture_steps)
  for _, multiple in ipairs(options.points) do
    for i, order in ipairs(options.orders) do
      local shown = coarser == 1 and multiple == most
      local c = compare(options, order, mesh, multiple, coarser, shown and i == 1 and keep or nil)
      comparisons[#comparisons + 1] = c
      if shown then
        c.halving.work = c.halving.run
        best[#best + 1], best[order] = c.halving, c.halving
        c.halving.run:csv(files(("%s_%s.csv"):format(order, mesh)))
      end
    end
  end
  local length = coarser == 1 and "with the published steps" or ("with steps %d times as long"):format(coarser)
  print(("\nDeep ironing at %s %s: failed step and reason, by contact points, without and with halving")
    :format(mesh, length))
  print(outcome_table(comparisons))
  if coarser == 1 then
    files:draw(("states_%s.png"):format(mesh), "an accepted step", function(file)
      return draw_states(file, ("Deep ironing, %s at %s"):format(options.orders[1], mesh), 2)
    end)
  end
  return comparisons, best
end

--- The whole study. Returns { comparisons, studies = the runs with most contact points by mesh }.
function deep.run(options, files)
  table.sort(options.points)
  table.sort(options.coarser)
  local all, studies = {}, {}
  for _, mesh in ipairs(options.mesh) do
    for _, coarser in ipairs(options.coarser) do
      local comparisons, best = study_mesh(options, mesh, coarser, files)
      table.move(comparisons, 1, #comparisons, #all + 1, all)
      if coarser == 1 then
        measure.compare(best, best.N2)
        studies[#studies + 1], studies[mesh] = { mesh = mesh, cases = best }, { mesh = mesh, cases = best }
        print(("\nOscillations at %s with %d(p+1) contact points, max − min over steps %d to %d, raw and detrended")
          :format(mesh, options.points[#options.points], measure.first, measure.last))
        print(sg.table(output.oscillation_table(best)))
        files:draw(("forces_%s.png"):format(mesh), "an accepted step", function(file)
          return output.draw_forces(file, best, "Deep ironing, " .. mesh)
        end)
      end
    end
  end
  for _, force in ipairs { "Py", "Px" } do
    if #studies > 1 then
      files:draw(force .. "_over_mesh.png", "runs that reach the window", function(file)
        return output.draw_over_mesh({ file = file, ylabel = ("oscillation d%s (N/mm)"):format(force),
          title = ("Deep ironing: oscillation of %s"):format(force) }, studies, options.orders,
          function(case) return case["d" .. force].raw end)
      end)
    end
  end
  if studies[1] then fill_page(options, all, studies[1].cases) end
  return { comparisons = all, studies = studies }
end

return deep
