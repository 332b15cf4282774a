-- Sliding across the border of two joined patches, next to one patch without a border, in the plane and in space.
--
-- Problem: a die is pressed into a slab and dragged across its middle with friction. plane: a half ring (radii 0.3 and
--          0.5, E = 10) on a slab of 4 × 1, plane strain; space: a spherical cap (radius 1, E = 10) on a slab of
--          3 × 1.4 × 0.7. The slab (E = 1) is
--            uncut    one patch, C¹ in the middle,
--            line     one patch with a C⁰ line in the middle,
--            joined   a body of two patches, the second one with reversed directions; their upper faces are the master,
--            fine     one patch with twice as many elements per direction, for the discretization error (plane only).
--          The slab has `elements` × `elements`/4 elements, in space half as many per direction.
--          neo-Hooke, nu = 0.3, mu = 0.3, penalties 50.
-- Source: a test of the program; the scene is the ironing problem of Fischer, Wriggers, Comput. Methods Appl. Mech.
--         Engrg. 195 (2006) 5020–5036, with a softer die.
-- Units: any consistent units; forces per depth in the plane.
-- Expected: joined and line agree to rounding error. The drag force oscillates as the die passes over elements; joined
--           oscillates no more than uncut, so the border causes no kick beyond the discretization error.
-- Run: signorini -q several_patches.lua [dimensions=2,3] [order=N2] [elements=16] [steps=60]
--      [out=out/several_patches]

local sg = require "signorini"
local measure = require "problems.ironing2d.measure"

local soft, hard = sg.neo_hookean{ E = 1, nu = 0.3 }, sg.neo_hookean{ E = 10, nu = 0.3 }

-- ── Scenes ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The slab's shape in halves and as a whole, its faces by the names of the boundary of the two patches.
local slabs = {
  [2] = {
    whole = sg.shapes.rectangle{ width = 4, height = 1 }, top = "north", bottom = "south",
    halves = { sg.shapes.rectangle{ width = 2, height = 1 },
               sg.shapes.rectangle{ width = 2, height = 1, corner = { 2, 0 } }:reverse(1):reverse(2),
               boundaries = { top = { "1.north", "2.south" }, bottom = { "1.south", "2.north" } } },
    elements = function(n) return { n, n // 4 } end, half = function(n) return { n // 2, n // 4 } end,
  },
  [3] = {
    whole = sg.shapes.block{ size = { 3, 1.4, 0.7 } }, top = "back", bottom = "front",
    halves = { sg.shapes.block{ size = { 1.5, 1.4, 0.7 } },
               sg.shapes.block{ size = { 1.5, 1.4, 0.7 }, corner = { 1.5, 0, 0 } }:reverse(1):reverse(2),
               boundaries = { top = { "1.back", "2.back" }, bottom = { "1.front", "2.front" } } },
    elements = function(n) return { n // 2, n // 4, n // 8 } end,
    half = function(n) return { n // 4, n // 4, n // 8 } end,
  },
}

local function slab(kind, dimension, order, n)
  local own = slabs[dimension]
  if kind == "joined" then
    return sg.body{ patch = own.halves, elements = own.half(n), order = order, material = soft }, "top", "bottom"
  end
  local whole = kind == "line" and own.whole:elevate(1, 1):insert(1, { 0.5, 0.5 }) or own.whole
  return sg.body{ patch = whole, elements = own.elements(kind == "fine" and 2 * n or n), order = order,
                  material = soft }, own.top, own.bottom
end

local function die(dimension, order, n)
  if dimension == 2 then
    local ring = sg.body{ patch = sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = { 1.4, 1.5 } },
                          elements = { n, 1 }, order = order, material = hard }
    return ring, ring:face "south", { ring:face "west", ring:face "east" }, { 0, -0.1 }, { 1.2, -0.1 }
  end
  -- The lowest point of the cap, one patch through a sphere, is 0.00175 below the height of its corner.
  local cap = sg.body{ order = order, material = hard, elements = { n // 4, n // 4, 1 },
    patch = sg.shapes.spherical_indenter{ width = 0.8, depth = 0.8, height = 0.5, radius = 1, elements = 2,
                                          corner = { 0.7, 0.3, 0.702 } } }
  return cap, cap:face "front", cap:face "back", { 0, 0, -0.082 }, { 0.8, 0, -0.082 }
end

local function slide(kind, dimension, options)
  local body, top, bottom = slab(kind, dimension, options.order, options.elements)
  local tool, face, grip, down, along = die(dimension, options.order, options.elements)
  local axes = dimension == 2 and "xy" or "xyz"
  local model = sg.model{ bodies = { slab = body, die = tool },
    supports = { bed = { on = body:face(bottom), fix = axes }, grip = { on = grip, drive = axes } },
    contacts = { touch = { slave = face, master = body:face(top), penalty = 50,
                           friction = { mu = 0.3, penalty = 50 } } } }
  local state
  local run = model:run({ { name = "press", steps = 4, grip = down },
                          { name = "slide", steps = options.steps, grip = along } },
    { on_step = function(info)
        if kind == "joined" and info.step == 4 + options.steps // 2 then state = model:snapshot() end
      end })
  if run.failed then error(("%s in %dD: %s"):format(kind, dimension, run.failure), 0) end
  local drag = run:column "grip.fx" -- without the first tenth of the slide, in which friction builds up
  return { model = model, state = state, drag = table.move(drag, 5 + options.steps // 10, #drag, 1, {}) }
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

local options = sg.arguments{
  dimensions = { { 2, 3 }, choices = { 2, 3 } }, order = "N2", elements = { 16, at_least = 8 },
  steps = { 60, at_least = 4 }, out = "out/several_patches",
}
local files, results = sg.files(options.out), {}

--- The largest difference of two drag forces, relative to the mean one.
local function difference(a, b)
  local largest, mean = 0, 0
  for i, force in ipairs(a.drag) do
    largest, mean = math.max(largest, math.abs(force - b.drag[i])), mean + math.abs(force) / #a.drag
  end
  return largest / mean
end

--- The oscillation (peak-to-peak) of the drag force, relative to its mean.
local function oscillation(case)
  if not case then return nil end
  local drag, sum = case.drag, 0
  for _, force in ipairs(drag) do sum = sum + force end
  return measure.oscillation(drag, 1, #drag).raw / math.abs(sum / #drag)
end

for _, dimension in ipairs(options.dimensions) do
  local own = {}
  for _, kind in ipairs(dimension == 2 and { "uncut", "line", "joined", "fine" } or { "uncut", "line", "joined" }) do
    own[kind] = slide(kind, dimension, options)
  end
  local result = { line = difference(own.joined, own.line), uncut = oscillation(own.uncut),
                   joined = oscillation(own.joined), fine = oscillation(own.fine), cases = own }
  results[dimension] = result
  print(("\n%dD: drag force, relative to its mean"):format(dimension))
  print(sg.table{ columns = { "joined less line", "oscillation of uncut", "joined", "fine" },
    rows = { { result.line, result.uncut, result.joined, result.fine } },
    formats = { "%.1e", "%.3f", "%.3f", "%.3f" } })

  local length = dimension == 2 and 1.2 or 0.8
  local chart = { file = files(("drag_%dd.png"):format(dimension)), xlabel = "displacement of the die",
                  ylabel = "drag force", title = ("Sliding across the border of two patches, %dD"):format(dimension) }
  for _, kind in ipairs { "uncut", "joined", "fine" } do
    if own[kind] then
      local x = {}
      for i in ipairs(own[kind].drag) do x[i] = length * (i + options.steps // 10) / options.steps end
      chart[#chart + 1] = { x = x, y = own[kind].drag, label = kind, dashed = kind == "joined" }
    end
  end
  sg.chart(chart)
  own.joined.model:restore(own.joined.state)
  sg.picture{ model = own.joined.model, file = files(("state_%dd.png"):format(dimension)), field = "von_mises",
              title = "The die on the border of two joined patches" }
end
files:report()

return results
