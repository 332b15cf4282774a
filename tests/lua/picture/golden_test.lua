-- Small pictures against those in tests/golden, so that a moved legend, a lost line or a wrong color is seen.
-- The tolerance lets other versions of fonts and of Mesa pass: the last case shows what it does not.
--   signorini tests/lua/picture/golden_test.lua write    draws them again; look at each before it is committed

require "check"

local golden = core.home .. "/tests/golden/"
local writes = arg[1] == "write"
local folder = writes and golden:sub(1, -2) or check.folder()
local program = (arg[-1]:match "^(.*)/[^/]*$" or ".") .. "/tests/difference"
local most = 24 -- of 255, mean over 8 × 8 pixels

-- ── Scenes ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A slab under a rigid cylinder, pressed.
local function plane()
  local roll = sg.rigid.cylinder{ center = { 2, 1.8 }, radius = 0.8 }
  local model = scenes.model{
    bodies = {
      slab = { size = {4, 1}, elements = { 8, 2 }, order = "N2-N2.1", contact = "north", thickness_degree = 2 } },
    supports = { bed = { on = "south", fix = "xy" }, roll = { on = roll, drive = "y" } },
    contacts = { c = { slave = "north", master = roll, penalty = 50 } } }
  model:run({ { name = "press", steps = 4, roll = { -0.2 } } })
  return model
end

--- A block under a rigid ball, pressed; a quarter of it.
local function solid()
  local ball = sg.rigid.sphere{ center = { 0, 0, 2.5 }, radius = 1.5 }
  local model = scenes.model{
    bodies = { block = { size = { 2, 2, 1 }, elements = { 3, 3, 2 }, contact = "back", thickness_degree = 2 } },
    supports = { bed = { on = "front", fix = "xyz" }, left = { on = "west", symmetry = true },
      front = { on = "south", symmetry = true }, ball = { on = ball, drive = "z" } },
    contacts = { c = { slave = "back", master = ball, penalty = 50 } } }
  model:run({ { name = "press", steps = 3, ball = { -0.2 } } })
  return model
end

-- ── Pictures by name: draw(file) ─────────────────────────────────────────────────────────────────────────────────────

local small = { 480, 300 }
local x, fall, swing = {}, {}, {}
for i = 1, 40 do
  x[i] = i / 4
  fall[i], swing[i] = math.exp(-x[i]), 0.5 + 0.4 * math.sin(x[i])
end

local function chart(file, more)
  local options = { file = file, size = small, x = x, xlabel = "time, s", ylabel = "force, N", title = "Decay",
                    { y = fall, label = "N2" }, { y = swing, label = "N2-N2.2" } }
  for key, value in pairs(more or {}) do options[key] = value end
  sg.chart(options)
end

local function heatmap(file, more)
  local options = { file = file, size = small, x = { "N2", "N3", "N4" }, y = { 10, 100 }, title = "Iterations",
                    xlabel = "order", ylabel = "penalty", values = { { 1, 2, 3 }, { 4, 5, 6 } } }
  for key, value in pairs(more or {}) do options[key] = value end
  sg.heatmap(options)
end

local flat = plane()
local deep = solid()

local function picture(model, more)
  return function(file)
    local options = { file = file, size = small, model = model }
    for key, value in pairs(more) do options[key] = value end
    sg.picture(options)
  end
end

local names = { "chart", "letters", "log_chart", "chart_inset", "hysteresis", "heatmap", "outcomes", "stress", "sheet",
                "marks", "patch", "block", "cut", "mirrored", "contours", "vectors" }
local draw = {
  chart = chart,
  letters = function(file) -- of three scripts, with indices
    sg.chart{ file = file, size = small, x = x, title = "Łódź, μ = 0.2: 摩擦系数", xlabel = "ξ¹ along Γ_c",
              ylabel = "∫_Γ t·δu dΓ", { y = fall, label = "½ ε_N g_N²" }, { y = swing, label = "接触压力" } }
  end,
  log_chart = function(file)
    chart(file, { log = "y", hlines = { { 0.01, "1 %" } }, legend_title = "order" })
  end,
  hysteresis = function(file)
    local a, b = {}, {}
    for i = 1, 60 do a[i], b[i] = math.cos(i / 10), math.sin(i / 10) + 0.5 * math.cos(i / 10) end
    sg.chart{ file = file, size = small, x = a, xlabel = "displacement", ylabel = "force", { y = b, arrows = true } }
  end,
  chart_inset = function(file) chart(file, { inset = { xrange = { 4, 6 } } }) end,
  heatmap = heatmap,
  outcomes = function(file)
    heatmap(file, { values = { { "converged", "failed", "converged" }, { "converged", "converged", "failed" } },
                    categories = { { name = "converged" }, { name = "failed" } } })
  end,
  stress = picture(flat, { field = "syy", title = "Pressed, σ_yy", unit = "mm" }),
  sheet = function(file) sg.picture{ file = file, size = small, model = flat, fields = { "ux", "uy" } } end,
  marks = picture(flat, { field = "von_mises", control_points = true,
                          marks = { { x = { 2, 0.8 }, text = "deepest point" } } }),
  patch = function(file)
    sg.picture{ file = file, size = small, patch = sg.shapes.half_annulus{ inner = 0.5, outer = 1, center = { 0, 0 } },
                control_points = true }
  end,
  block = picture(deep, { field = "szz", title = "A quarter" }),
  cut = picture(deep, { field = "von_mises", cut = "-y", camera = { from = { 1, -2, 1 } } }),
  contours = picture(flat, { field = "syy", contours = true, mesh = false, axes = { "x / mm", "depth / mm" } }),
  vectors = picture(deep, { vectors = "displacement", undeformed = true, mirror = "x", unit = "mm" }),
  mirrored = picture(deep, { field = "uz", mirror = "xy", unit = "mm" }),
}

-- ── Cases ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- How far files look apart from others, pair by pair.
local function differences(files)
  local output, status = check.shell(("'%s' '%s'"):format(program, table.concat(files, "' '")))
  check.equal(status, 0)
  return load(output)()
end

if writes then
  for _, name in ipairs(names) do draw[name](("%s/%s.png"):format(folder, name)) end
  return
end

check.case("every picture agrees with its reference", function()
  local files = {}
  for _, name in ipairs(names) do
    files[#files + 1], files[#files + 2] = ("%s/%s.png"):format(folder, name), golden .. name .. ".png"
    draw[name](files[#files - 1])
  end
  for i, difference in ipairs(differences(files)) do
    if difference > most then
      error(("%s: differs by %.0f from %s, at most %d is allowed"):format(names[i], difference, files[2 * i], most), 0)
    end
  end
end)

check.case("the tolerance detects a moved legend, a missing line, another range of colors", function()
  local changes = {
    chart = function(file) chart(file, { legend_title = "order" }) end,
    log_chart = function(file) chart(file, { log = "y", legend_title = "order" }) end,
    heatmap = function(file) heatmap(file, { range = { 0, 8 } }) end,
    stress = picture(flat, { field = "syy", title = "Pressed, σ_yy", unit = "mm", mesh = false }),
    cut = picture(deep, { field = "von_mises", cut = "-y", camera = { from = { 1, -2, 1.2 } } }),
  }
  local files, changed = {}, {}
  for name, change in pairs(changes) do
    changed[#changed + 1] = name
    files[#files + 1], files[#files + 2] = ("%s/%s-changed.png"):format(folder, name), golden .. name .. ".png"
    change(files[#files - 1])
  end
  for i, difference in ipairs(differences(files)) do
    if difference <= most then error(("a change of '%s' goes unnoticed: %.1f"):format(changed[i], difference), 0) end
  end
end)
