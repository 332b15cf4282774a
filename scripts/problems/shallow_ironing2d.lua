-- Shallow ironing: a round-nosed die is pressed into a block and dragged along it, with friction and large strains.
--
-- Problem: a test introduced by Fischer and Wriggers, which many contact methods have been compared on since. There is
--          no exact solution, and the published forces differ by more than a quarter.
--
--             ____
--            |    |     die: 1.2 wide, 0.9 high, arc of height 0.3 (radius 0.75) below, top driven;
--            |    |     starts 0.2 from the left end of the block, 0.2 above it; pressed by 1, then dragged by 10
--          ___\__/______________________________
--         |                                     |
--         |  block: 12 × 4, bottom clamped      |
--         |_____________________________________|
--
--          Plane strain, neo-Hooke, E = 68.96e8 Pa (die) and 68.96e7 Pa (block), nu = 0.32, mu = 0.3; slave: the arc.
--          Chosen here: both penalties 1e5 N/mm³ (penetration of 0.4 % of the arc's radius), 50 steps of pressing and
--          250 of sliding. The sides of the die are not contact faces: the leading one would carry less than 2.5 N/mm,
--          near its lower corner.
-- Source: K. A. Fischer and P. Wriggers, Mortar based frictional contact formulation for higher order interpolations
--         using the moving friction cone, CMAME 195 (2006) 5020; curves of five programs in share/reference. Plain
--         Newton; failed steps are cut.
-- Units: mm, N, N/mm²; forces per mm of depth. Time is 0 to 1 during pressing and 1 to 2 during sliding.
-- Expected: V = 316 and H = 67 at time 1, V = 402 and H = 134 at time 1.5 (N2 at m2; at m3 314, 66, 400 and 131). V is
--           within the range of the published curves, closest to Hartmann et al.; H/V = 0.33 is closest to 0.34 of
--           Code_Aster (0.30 to 0.52 in all).
-- Run: signorini shallow_ironing2d.lua [mesh=m2] [orders=N2,N2-N2.2] [thickness_degree=1] [penalty=1e5] [steps=50]
--      [linear=auto] [out=out/shallow_ironing2d] [page=none]; meshes: die 3 × 2 and block 30 × 8 (m1), each further
--      mesh halves the elements; thickness_degree: degree in the thickness direction; steps: number of pressing steps;
--      sliding takes five times as many; page: folder of shallow_ironing2d.md, whose tables of this mesh are filled.

local sg = require "signorini"
local page = require "page.tables"

local sources = {
  { "fischer_wriggers", "Fischer, Wriggers 2006" }, { "hartmann", "Hartmann et al. 2009" },
  { "yastrebov", "Yastrebov 2011" }, { "poulios_renard", "Poulios, Renard 2015" }, { "code_aster", "Code_Aster 2020" },
}
local table_times = { 0.5, 1, 1.5 }
local picture_times = { 1, 1.25, 1.5, 2 }
local oscillation_times = { 1.4, 1.6 } -- where the exact forces are nearly constant

-- ── Scene and path ───────────────────────────────────────────────────────────────────────────────────────────────────

--- The die: straight lines from its arc up to its top. With radius R = 0.75 and half the width 0.6 the arc spans 2θ,
--- sin θ = 0.8 and cos θ = 0.6: one rational quadratic segment whose middle weight is cos θ and whose middle point,
--- where the end tangents meet, lies R/cos θ = 1.25 below the center.
local function die_patch(left, apex)
  local middle, ends, top = left + 0.6, apex + 0.3, apex + 1.2
  local arc = sg.nurbs.curve{
    degree = 2, knots = { 0, 0, 0, 1, 1, 1 }, weights = { 1, 0.6, 1 },
    points = { { left, ends }, { middle, apex + 0.75 - 1.25 }, { left + 1.2, ends } },
  }
  return sg.nurbs.ruled{ a = arc, b = sg.nurbs.line{ from = { left, top }, to = { left + 1.2, top } } }
end

local function scene(order, options)
  local n = 1 << (math.tointeger(tonumber(options.mesh:sub(2))) - 1)
  local die = sg.body{
    patch = die_patch(0.2, 4.2), elements = { 3 * n, 2 * n }, order = order, contact = "south",
    thickness_degree = options.thickness_degree, material = sg.neo_hookean{ E = 6896, nu = 0.32 },
  }
  local block = sg.body{
    patch = sg.shapes.rectangle{ width = 12, height = 4 }, elements = { 30 * n, 8 * n }, order = order,
    contact = "north", thickness_degree = options.thickness_degree, material = sg.neo_hookean{ E = 689.6, nu = 0.32 },
  }
  return sg.model{
    bodies   = { die = die, block = block },
    supports = { bed = { on = block:face "south", fix = "xy" }, grip = { on = die:face "north", drive = "xy" } },
    contacts = { interface = { slave = die:face "south", master = block:face "north", penalty = options.penalty,
                               friction = { mu = 0.3, penalty = options.penalty } } },
  }, die, block
end

--- 0 to 1 while the die is pressed, 1 to 2 while it slides.
local function time_of(step, steps) return step <= steps and step / steps or 1 + (step - steps) / (5 * steps) end

--- Runs one discretization. Returns { order, run, model, dofs, time, V, H, pictures }: lists over the steps, and the
--- states at picture_times.
local function solve(order, options)
  local model, die, block = scene(order, options)
  local pictures, next_picture = {}, 1
  local run = model:run({
    { name = "press", steps = options.steps, grip = { 0, -1 } },
    { name = "slide", steps = 5 * options.steps, grip = { 10, -1 } },
  }, sg.plain{ linear = options.linear, step = { adaptive = true }, on_step = function(info)
    local time = picture_times[next_picture]
    if time and time_of(info.step, options.steps) >= time - 1e-9 then
      next_picture = next_picture + 1
      pictures[#pictures + 1] = sg.picture{ model = model, field = "von_mises", range = { 0, 400 }, unit = "mm",
                                            label = "von Mises stress (N/mm²)", title = ("time %g"):format(time) }
    end
  end })
  local case = { order = order, mesh = options.mesh, run = run, model = model,
                 dofs = die:dofs().total + block:dofs().total, pictures = pictures, time = {},
                 V = run:column "grip.fy", H = run:column "grip.fx" }
  for step = 1, run.steps do
    case.time[step], case.V[step] = time_of(step, options.steps), -case.V[step]
  end
  return case
end

-- ── Output ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A force at a time, linear between the steps; nil beyond the last one.
local function at(case, list, time)
  local last
  for i, now in ipairs(case.time) do
    if now >= time - 1e-9 then
      if not last then return list[i] * time / now end
      local part = (time - case.time[last]) / (now - case.time[last])
      return list[last] + part * (list[i] - list[last])
    end
    last = i
  end
end

local function force_row(name, force)
  local row = { name }
  for i, time in ipairs(table_times) do row[2 * i], row[2 * i + 1] = force(time) end
  local V, H = force(1.5)
  row[2 * #table_times + 2] = V and H / V
  return row
end

--- Our forces above the published ones, which are read off digitized curves.
local function force_table(cases, published, published_too)
  local rows, at_time = {}, {}
  for _, row in ipairs(published.rows) do at_time[row[1]] = row end
  for _, case in ipairs(cases) do
    rows[#rows + 1] = force_row(("%s, %s"):format(case.order, case.mesh), function(time)
      return at(case, case.V, time), at(case, case.H, time)
    end)
  end
  local column = {}
  for i, name in ipairs(published.columns) do column[name] = i end
  for _, source in ipairs(published_too and sources or {}) do
    rows[#rows + 1] = force_row(source[2], function(time)
      return at_time[time][column[source[1] .. "_V"]], at_time[time][column[source[1] .. "_H"]]
    end)
  end
  local columns, units, formats = { "" }, { "N/mm" }, { "%s" }
  for i, time in ipairs(table_times) do
    columns[2 * i], columns[2 * i + 1] = ("V(%g)"):format(time), ("H(%g)"):format(time)
    units[2 * i], units[2 * i + 1], formats[2 * i], formats[2 * i + 1] = "", "", "%.1f", "%.1f"
  end
  columns[#columns + 1], formats[#formats + 1] = "H/V(1.5)", "%.3f"
  return { columns = columns, units = units, rows = rows, formats = formats }
end

--- max − min of a force while the die is in the block's middle; nil if the run ended before.
local function oscillation(case, list)
  if not at(case, list, oscillation_times[2]) then return nil end
  local low, high = math.huge, -math.huge
  for i, time in ipairs(case.time) do
    if time >= oscillation_times[1] and time <= oscillation_times[2] then
      low, high = math.min(low, list[i]), math.max(high, list[i])
    end
  end
  return high - low
end

local function work_table(cases)
  local rows = {}
  for i, case in ipairs(cases) do
    local run = case.run
    rows[i] = { case.order, case.dofs, run.steps, run.iterations, run.cutbacks,
                math.max(0, table.unpack(run:column "interface.max_penetration")), case.oscillation.V,
                case.oscillation.H, run.wall }
  end
  return {
    columns = { "order", "DOFs", "steps", "iterations", "cut-backs", "overlap", "oscillation V", "oscillation H",
                "wall" },
    units = { "", "", "", "", "", "mm", "N/mm", "N/mm", "s" }, rows = rows,
    formats = { overlap = "%.4f", ["oscillation V"] = "%.2f", ["oscillation H"] = "%.2f", wall = "%.2f" },
  }
end

local function draw_forces(cases, published, file)
  local chart = { file = file, xlabel = "time (0 to 1: pressing, 1 to 2: sliding)", ylabel = "force on the die (N/mm)",
                  title = "Shallow ironing: vertical force V (above) and horizontal force H (below)" }
  for i, case in ipairs(cases) do
    for _, list in ipairs { case.V, case.H } do
      if #list > 0 then
        chart[#chart + 1] = { x = case.time, y = list, label = case.order, color = i, marker = "none" }
      end
    end
  end
  if #chart == 0 then return false end
  for i, source in ipairs(sources) do
    for _, force in ipairs { "_V", "_H" } do
      chart[#chart + 1] = { x = published:column "time", y = published:column(source[1] .. force), label = source[2],
                            line = false, markers = true, color = #cases + i }
    end
  end
  sg.chart(chart)
  return true
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

local options = sg.arguments{
  mesh = { "m2", choices = { "m1", "m2", "m3", "m4", "m5" } }, orders = { "N2", "N2-N2.2" }, thickness_degree = 1,
  penalty = { 1e5, above = 0 }, steps = 50, linear = "auto", out = "out/shallow_ironing2d",
  page = "none",
}
local files, cases = sg.files(options.out), {}

local published = sg.reference "shallow_ironing2d_forces"
for i, order in ipairs(options.orders) do
  print(("%s at %s"):format(order, options.mesh))
  local case = solve(order, options)
  print(case.run)
  case.run:csv(files(order .. ".csv"))
  case.oscillation = { V = oscillation(case, case.V), H = oscillation(case, case.H) }
  cases[i], cases[order] = case, case
end
print(("\nWork at %s; overlap: largest penetration (mm); oscillation: max − min from time %g to %g"):format(
  options.mesh, table.unpack(oscillation_times)))
local work = work_table(cases)
print(sg.table(work))
print "\nVertical force V, horizontal force H and their ratio at some times, with published ones (read off curves)"
print(sg.table(force_table(cases, published, true)))

files:draw("forces.png", "an accepted step", function(file) return draw_forces(cases, published, file) end)
if #cases[1].pictures > 0 then
  sg.sheet{ cases[1].pictures, columns = 2, file = files "states.png",
            title = ("Shallow ironing, %s at %s"):format(options.orders[1], options.mesh) }
end
page.fill(options, "shallow_ironing2d", "shallow_ironing2d_" .. options.mesh, {
  [options.mesh] = force_table(cases, published, options.mesh == "m2"),
  [options.mesh .. " work"] = page.pick(work, { 1, 2, 3, 4, 5, 6, 7, 8 }) })
files:report()

return { mesh = options.mesh, cases = cases, files = files }
