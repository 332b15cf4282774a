-- Several meshes of the standard variant: oscillation and time over the mesh (Figures 7.8, 7.9), accuracy over time,
-- and costs at equal accuracy (section 7.1.3).

local sg = require "signorini"
local output = require "problems.ironing2d.output"

local convergence = {}

--- Pairs that the thesis calls equally accurate: order and mesh of both, and by how many percent the first
--- analysis is cheaper as published.
local pairs_of_equals = {
  { "N2-N2.2", "m1", "N2", "m3", 56.62 }, { "N2-N2.2", "m2", "N2", "m4", 72.78 },
  { "N2-N4", "m1", "N4", "m1", 33.74 }, { "N2-N4", "m2", "N4", "m2" }, { "N2-N4", "m3", "N4", "m3" },
  { "N2-N4", "m4", "N4", "m4", 52.44 },
  { "N2-N6", "m1", "N6", "m1" }, { "N2-N6", "m2", "N6", "m2" }, { "N2-N6", "m3", "N6", "m3" },
  { "N2-N6", "m4", "N6", "m4", 59.58 },
}

local function case_of(studies, order, mesh) return studies[mesh] and studies[mesh].cases[order] end

--- The pairs of which both were run, with the fraction of time that the first one saves.
function convergence.savings(studies)
  local found = {}
  for _, pair in ipairs(pairs_of_equals) do
    local ours, plain = case_of(studies, pair[1], pair[2]), case_of(studies, pair[3], pair[4])
    if ours and plain then
      found[#found + 1] = { ours = ours, plain = plain, published = pair[5],
                            saved = 100 * (1 - ours.work.wall / plain.work.wall) }
    end
  end
  return found
end

local function name_of(case) return case.order .. " " .. case.mesh end

--- The cheapest case whose two detrended oscillations are at most those of a given case.
local function cheapest_as_good(studies, reference)
  local best
  for _, study in ipairs(studies) do
    for _, case in ipairs(study.cases) do
      if case.dPy.detrended and case.dPy.detrended <= reference.dPy.detrended
        and case.dPx.detrended <= reference.dPx.detrended and not (best and best.work.wall <= case.work.wall) then
        best = case
      end
    end
  end
  return best
end

--- For N2 on every mesh but the first, the fastest case with at most its detrended oscillations.
function convergence.cheapest(studies)
  local found = {}
  for i = 2, #studies do
    local plain = studies[i].cases.N2
    if plain and plain.dPy.detrended then
      local ours = cheapest_as_good(studies, plain)
      found[#found + 1] = { ours = ours, plain = plain, saved = 100 * (1 - ours.work.wall / plain.work.wall) }
    end
  end
  return found
end

--- Pairs for sg.table.
function convergence.saving_table(found)
  local rows = {}
  for i, pair in ipairs(found) do
    local a, b = pair.ours, pair.plain
    rows[i] = { name_of(a), name_of(b), a.dPy.raw, b.dPy.raw, a.dPx.raw, b.dPx.raw, a.dPy.detrended, b.dPy.detrended,
                a.dPx.detrended, b.dPx.detrended, a.work.wall, b.work.wall, pair.saved, pair.published }
  end
  return {
    columns = { "case", "against", "dPy", "against", "dPx", "against", "dPy", "against", "dPx", "against", "time",
                "against", "saved", "published" },
    units = { "", "", "N/mm", "N/mm", "N/mm", "N/mm", "detrended", "", "detrended", "", "s", "s", "%", "%" },
    rows = rows,
    formats = { "%s", "%s", "%.2e", "%.2e", "%.2e", "%.2e", "%.2e", "%.2e", "%.2e", "%.2e", "%.3f", "%.3f", "%.1f",
                "%.1f" },
  }
end

--- Iterations, and the parts of both times in ms per iteration.
local function split_table(found)
  local rows, seen = {}, {}
  for _, pair in ipairs(found) do
    for _, case in ipairs { pair.ours, pair.plain } do
      local run = case.work
      local row = { name_of(case), case.die_dofs.total + case.slab_dofs.total, run.iterations }
      for _, part in ipairs { "bulk", "contact", "linear", "rest" } do
        row[#row + 1] = 1e3 * run.timings[part] / math.max(1, run.iterations)
      end
      row[#row + 1] = 1e3 * run.wall / math.max(1, run.iterations)
      if not seen[case] then rows[#rows + 1] = row end
      seen[case] = true
    end
  end
  return sg.table{
    columns = { "case", "DOFs", "iterations", "bulk", "contact", "linear", "rest", "all" },
    units = { "", "", "", "ms/it.", "ms/it.", "ms/it.", "ms/it.", "ms/it." }, rows = rows,
    formats = { "%s", "%d", "%d", "%.3f", "%.3f", "%.3f", "%.3f", "%.3f" },
  }
end

--- The time that counts as 100 %: N6 on the finest mesh, as in the thesis, otherwise the longest.
local function longest(studies)
  local case = studies[#studies].cases.N6
  if case then return case.work.wall, case end
  for _, study in ipairs(studies) do
    for _, other in ipairs(study.cases) do
      if not case or other.work.wall > case.work.wall then case = other end
    end
  end
  return case.work.wall, case
end

local function draw_work_precision(file, studies, orders)
  local chart = { file = file, xlabel = "time (s)", ylabel = "oscillation dPx, detrended (N/mm)", log = "xy",
                  title = ("Ironing: oscillation of the drag over time, meshes %s to %s"):format(studies[1].mesh,
                    studies[#studies].mesh) }
  for l, order in ipairs(orders) do
    local line = { x = {}, y = {}, label = order, markers = true, color = l }
    for _, study in ipairs(studies) do
      local case = study.cases[order]
      if case and case.dPx.detrended then
        line.x[#line.x + 1], line.y[#line.y + 1] = case.work.wall, case.dPx.detrended
      end
    end
    if #line.x > 0 then chart[#chart + 1] = line end
  end
  if #chart > 0 then sg.chart(chart) end
  return #chart > 0
end

--- Charts over the mesh and the tables of equal accuracy.
function convergence.report(studies, orders, files)
  local names = { raw = "raw", detrended = "detrended" }
  for _, force in ipairs { "Py", "Px" } do
    for _, kind in ipairs { "raw", "detrended" } do
      files:draw(("%s_over_mesh_%s.png"):format(force, kind), "runs that reach the window", function(file)
        return output.draw_over_mesh({ file = file, ylabel = ("oscillation d%s (N/mm)"):format(force),
          title = ("Ironing: oscillation of %s, %s"):format(force, names[kind]) },
          studies, orders, function(case) return case["d" .. force][kind] end)
      end)
    end
  end
  local whole, case = longest(studies)
  files:draw("time_over_mesh.png", "an accepted step", function(file)
    return output.draw_over_mesh({ file = file, ylabel = "analysis time (%)",
      title = ("Ironing: time of an analysis; 100 %% is %s at %s, %.2f s"):format(case.order, case.mesh, whole) },
      studies, orders, function(each) return 100 * each.work.wall / whole end)
  end)
  files:draw("accuracy_over_time.png", "runs that reach the window", function(file)
    return draw_work_precision(file, studies, orders)
  end)

  local found, cheapest = convergence.savings(studies), convergence.cheapest(studies)
  if #found > 0 then
    print "\nEqually accurate cases according to the thesis (section 7.1.3): time saved, here and as published"
    print(sg.table(convergence.saving_table(found)))
    print "\nTime of these cases by part (linear: factorization and solve)"
    print(split_table(found))
  else
    print "\nNo pair of cases that the thesis calls equally accurate was run. Hint: mesh=m1,m2,m3,m4"
  end
  if #cheapest > 0 then
    print "\nThe cheapest case with detrended oscillations at most those of N2 on a mesh"
    print(sg.table(convergence.saving_table(cheapest)))
  end
  return found, cheapest
end

return convergence
