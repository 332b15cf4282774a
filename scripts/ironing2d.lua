-- 2D frictional ironing: what varying-order layers do to the oscillation of the contact forces.
--
-- Problem: a half ring (the die) is pressed into the top of a rectangle (the slab) and dragged along it, with friction.
--          The coarser and the less smooth the two faces, the more the reactions oscillate with the element pitch.
--
--                      die: half annulus, radii 0.3 and 0.5, its two flat ends driven,
--              (   )        apex just touching the slab at x = 0.75; pressed by 0.23 in 46 steps,
--        _______\_/____________________   then dragged by 1.5 in 250 steps
--       |                              |
--       |  slab: 3 × 1, bottom clamped |
--       |______________________________|
--
--          Plane strain, neo-Hooke, E = 1000 (die) and 1 (slab), nu = 0.3, mu = 0.2, both penalties 100, slave: die.
--          Meshes: die 6 × 2 and slab 8 × 3 elements (m1); each next mesh halves every span.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, section 7.1, Tables 7.2 and 7.3, Figures 7.3 to 7.5.
-- Units: mm, N, N/mm²; forces per mm of depth.
-- Expected: the amplitudes of Table 7.3 at m1 (in % of N2, dPy and dPx): N4 49.88 and 23.31, N6 24.57 and 11.81,
--           N2-N6 23.83 and 12.09, N2-N2.1 5.98 and 30.84, N2-N2.2 4.31 and 7.51; N2-N4 and N2-N2.3 a few points higher
--           than printed. An amplitude is max − min over steps 110 to 165, about one element pitch in the slab's middle.
-- Run: signorini scripts/ironing2d.lua [mesh=m1] [labels=N2,N4,N6,N2-N4,N2-N6,N2-N2.1,N2-N2.2,N2-N2.3] [linear=auto]
--      [out=out/ironing2d]; linear is the sparse solver, auto, klu or umfpack.

local sg = require "signorini"

local press_steps, slide_steps = 46, 250
local window = { 110, 165 }
local picture_steps = { [4] = true, [23] = true, [46] = true, [80] = true, [160] = true, [250] = true }
local reference_label = "N2"

-- ── Arguments ────────────────────────────────────────────────────────────────────────────────────────────────────────

local function read_arguments(words)
  local options = { mesh = "m1", labels = "N2,N4,N6,N2-N4,N2-N6,N2-N2.1,N2-N2.2,N2-N2.3", linear = "auto",
                    out = "out/ironing2d" }
  for _, word in ipairs(words) do
    local key, value = word:match "^(%w+)=(.+)$"
    if not options[key] then
      error(("unknown argument '%s'; known: mesh=m1, labels=N2,N4, linear=auto, out=folder"):format(word), 0)
    end
    options[key] = value
  end
  local level = math.tointeger(options.mesh:match "^m([1-6])$")
  if not level then error(("mesh must be one of m1 to m6, got '%s'"):format(options.mesh), 0) end
  local labels = {}
  for label in options.labels:gmatch "[^,]+" do labels[#labels + 1] = label end
  return { mesh = options.mesh, level = level, labels = labels, linear = options.linear, out = options.out }
end

-- ── Scene and path ───────────────────────────────────────────────────────────────────────────────────────────────────

local function scene(label, level)
  local halvings = 1 << (level - 1)
  local die = sg.body{
    patch    = sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, centre = {0.75, 1.5} },
    elements = { 6 * halvings, 2 * halvings }, order = label, contact = "south",
    material = sg.neo_hookean{ E = 1000, nu = 0.3 },
  }
  local slab = sg.body{
    patch    = sg.shapes.rectangle{ width = 3, height = 1 },
    elements = { 8 * halvings, 3 * halvings }, order = label, contact = "north",
    material = sg.neo_hookean{ E = 1, nu = 0.3 },
  }
  local model = sg.model{
    bodies   = { die = die, slab = slab },
    supports = { bed  = { on = slab:face "south", fix = "xy" },
                 grip = { on = {die:face "west", die:face "east"}, drive = "xy" } },
    contacts = { interface = { slave = die:face "south", master = slab:face "north",
                               penalty = 100, friction = { mu = 0.2, penalty = 100 } } },
  }
  return model, die, slab
end

--- Runs one label; `on_step` draws the pictures of the label that is asked for them.
local function solve(label, level, linear, on_step)
  local model, die, slab = scene(label, level)
  local run = model:run({
    { name = "press", steps = press_steps, grip = {0, -0.23} },
    { name = "slide", steps = slide_steps, grip = {1.5, -0.23} },
  }, { linear = linear, on_step = on_step and function(info) on_step(model, info.step) end })
  return { label = label, run = run, die_dofs = die:dofs(), slab_dofs = slab:dofs() }
end

-- ── Amplitudes ───────────────────────────────────────────────────────────────────────────────────────────────────────

--- The values of the window, or nothing when the run ended before it.
local function cut(values)
  if #values < window[2] then return nil end
  return table.move(values, window[1], window[2], 1, {})
end

--- The values without their best parabola. On points x that lie symmetrically about 0 the polynomials 1, x and x² − mean x²
--- are orthogonal, so each coefficient is a quotient of two sums.
local function without_parabola(values)
  local count, square = #values, 0
  local function x(i) return i - (count + 1) / 2 end
  for i = 1, count do square = square + x(i) ^ 2 / count end
  local rest = table.move(values, 1, count, 1, {})
  for _, polynomial in ipairs {
    function() return 1 end, x, function(i) return x(i) ^ 2 - square end,
  } do
    local projection, norm = 0, 0
    for i = 1, count do
      projection, norm = projection + rest[i] * polynomial(i), norm + polynomial(i) ^ 2
    end
    for i = 1, count do rest[i] = rest[i] - projection / norm * polynomial(i) end
  end
  return rest
end

--- max − min over the window of a force, as it is and without a parabola.
local function amplitudes(values)
  local part = cut(values)
  if not part then return {} end
  local rest = without_parabola(part)
  return { raw = math.max(table.unpack(part)) - math.min(table.unpack(part)),
           detrended = math.max(table.unpack(rest)) - math.min(table.unpack(rest)) }
end

--- Adds amplitudes of Px and Py to each case, and what they are in % of those of the reference label.
local function compare(cases)
  for _, case in ipairs(cases) do
    case.dPx, case.dPy = amplitudes(case.run:column "grip.fx"), amplitudes(case.run:column "grip.fy")
  end
  local reference = cases[reference_label]
  for _, case in ipairs(cases) do
    for _, force in ipairs { "dPx", "dPy" } do
      for _, kind in ipairs { "raw", "detrended" } do
        local part, whole = case[force][kind], reference and reference[force][kind]
        case[force][kind .. "_percent"] = part and whole and 100 * part / whole or nil
      end
    end
  end
end

-- ── Output ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local function work_table(cases)
  local rows = {}
  for i, case in ipairs(cases) do
    local run, spent = case.run, case.run.timings
    rows[i] = { case.label, case.die_dofs.total, case.slab_dofs.total, case.die_dofs.total + case.slab_dofs.total,
                case.die_dofs.interface + case.slab_dofs.interface, run.iterations / math.max(1, run.steps), run.wall,
                spent.bulk, spent.contact, spent.linear, spent.rest }
  end
  return sg.table{
    columns = { "label", "die", "slab", "total", "interface", "iterations", "wall", "bulk", "contact", "linear", "rest" },
    units = { "", "DOFs", "DOFs", "DOFs", "DOFs", "per step", "s", "s", "s", "s", "s" }, rows = rows,
    formats = { iterations = "%.2f", wall = "%.3f", bulk = "%.3f", contact = "%.3f", linear = "%.3f", rest = "%.3f" },
  }
end

--- At m1 beside the published values; on finer meshes, for which none are printed, beside those without the trend.
local function amplitude_table(cases, published)
  local rows, formats = {}, { "%s", "%.3e", "%.2f", "%.2f", "%.3e", "%.2f", "%.2f" }
  for i, case in ipairs(cases) do
    local dPy, dPx, printed = case.dPy, case.dPx, published and (published[case.label] or {})
    rows[i] = { case.label,
                dPy.raw, dPy.raw_percent, printed and printed.dPy_percent_of_N2 or dPy.detrended_percent,
                dPx.raw, dPx.raw_percent, printed and printed.dPx_percent_of_N2 or dPx.detrended_percent }
  end
  local beside = published and "published" or "detrended"
  return sg.table{
    columns = { "label", "dPy", "dPy", beside, "dPx", "dPx", beside },
    units = { "", "N/mm", "% of N2", "% of N2", "N/mm", "% of N2", "% of N2" }, rows = rows, formats = formats,
  }
end

local function draw_forces(cases, mesh, file)
  local chart = { file = file, xlabel = "load step", ylabel = "force on the die per unit depth (N/mm)",
                  title = ("Ironing, mesh %s: pressing force Py (full) and drag Px (dashed)"):format(mesh) }
  local function curves(name, column, sign, dashed)
    for _, case in ipairs(cases) do
      local values = case.run:column(column)
      for i, value in ipairs(values) do values[i] = sign * value end
      if #values > 0 then
        chart[#chart + 1] = { x = case.run:column "step", y = values, label = name .. " " .. case.label, dashed = dashed }
      end
    end
  end
  curves("Py", "grip.fy", -1, false)
  curves("Px", "grip.fx", 1, true)
  if #chart > 0 then sg.chart(chart) end
  return #chart > 0
end

local function draw_amplitudes(cases, mesh, file, published)
  local names, curves = {}, {}
  local function curve(label, shift, percent)
    local line = { x = {}, y = {}, label = label, line = false, markers = true }
    for i, case in ipairs(cases) do
      local value = percent(case)
      if value then line.x[#line.x + 1], line.y[#line.y + 1] = i + shift, value end
    end
    if #line.x > 0 then curves[#curves + 1] = line end
  end
  for i, case in ipairs(cases) do names[i] = ("%d: %s"):format(i, case.label) end
  curve("dPy", -0.1, function(case) return case.dPy.raw_percent end)
  curve("dPx", -0.1, function(case) return case.dPx.raw_percent end)
  if published then
    curve("dPy published", 0.1, function(case) return (published[case.label] or {}).dPy_percent_of_N2 end)
    curve("dPx published", 0.1, function(case) return (published[case.label] or {}).dPx_percent_of_N2 end)
  else
    curve("dPy detrended", 0.1, function(case) return case.dPy.detrended_percent end)
    curve("dPx detrended", 0.1, function(case) return case.dPx.detrended_percent end)
  end
  if #curves == 0 then return false end
  curves.file, curves.title = file, ("Ironing, mesh %s: amplitude of the contact forces"):format(mesh)
  curves.xlabel, curves.ylabel, curves.log = table.concat(names, "   "), "% of N2", "y"
  curves.xrange = { 0.5, #cases + 0.5 }
  sg.chart(curves)
  return true
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

local options = read_arguments(select("#", ...) > 0 and { ... } or arg)
sg.mkdir(options.out)

local files, cases = {}, {}
local function path(name)
  files[#files + 1] = options.out .. "/" .. name
  return files[#files]
end

--- Pictures as in Figure 7.3, of the first label.
local function draw_state(model, step)
  if not picture_steps[step] then return end
  sg.picture{ model = model, field = "uy", file = path(("uy_%03d.png"):format(step)), size = { 1600, 760 }, mesh = true,
              title = ("Ironing, %s at %s, load step %d"):format(options.labels[1], options.mesh, step) }
end

for i, label in ipairs(options.labels) do
  print(("%s at %s"):format(label, options.mesh))
  local case = solve(label, options.level, options.linear, i == 1 and draw_state or nil)
  print(case.run)
  case.run:csv(path(label .. ".csv"))
  cases[i], cases[label] = case, case
end
compare(cases)

local published = options.level == 1 and sg.reference "ironing2d_oscillation_table7_3":by "discretisation" or nil
print(("\nDegrees of freedom and work at %s, %d steps (linear: factorisation and solve)")
  :format(options.mesh, press_steps + slide_steps))
print(work_table(cases))
print(("\nAmplitude of the contact forces, max − min over steps %d to %d%s"):format(window[1], window[2],
  published and ", beside Table 7.3" or ", as it is and without a parabola"))
print(amplitude_table(cases, published))

--- Draws a chart, or says why there is none.
local function chart(name, draw, need)
  if draw(cases, options.mesh, options.out .. "/" .. name, published) then
    path(name)
  else
    print(name .. " is left out: it needs " .. need)
  end
end
chart("forces.png", draw_forces, "an accepted step")
chart("amplitudes.png", draw_amplitudes, "N2 among the labels, and runs that reach the window")
print("\nWritten: " .. table.concat(files, "\n         "))

return { mesh = options.mesh, cases = cases, files = files }
