-- Time saved by half and quarter models: a ring pressed into a slab, a punch pressed into a block.
--
-- Problem: a stiff half ring is pressed into a soft slab in 2D, and a stiff punch with a square face into a soft block
--          in 3D. In planes of symmetry, supports with symmetry = true constrain the normal displacement.
-- Source: none; the ring is that of share/doc/start/tutorial.md.
-- Units: seconds of wall time; forces in N/mm in 2D, N in 3D, multiplied by the number of parts for partial models.
-- Expected: half models take a little less than half of the time, the quarter model about a fifth. Forces differ by the
--           discretization error: a partial model can have a kink in the plane of symmetry, which the smooth functions
--           of the full model cannot.
-- Run: signorini tests/measure/half_model.lua [mesh=4] [solid=3] [repeats=5]; mesh: elements in the thickness
--      direction of the ring; solid: elements along half an edge of the punch; times are medians of repeats, with all
--      models run in turn.

local sg = require "signorini"

local options = sg.arguments{ mesh = 4, solid = 3, repeats = 5 }
local soft, stiff = sg.neo_hookean{ E = 1, nu = 0.3 }, sg.neo_hookean{ E = 1000, nu = 0.3 }

--- The ring on its slab, centered at x = 0.
local function ring(half)
  local n = options.mesh
  local shape = half and sg.shapes.quarter_annulus or sg.shapes.half_annulus
  local die = sg.body{ patch = shape{ inner = 0.3, outer = 0.5, center = { 0, 1.5 } },
                       elements = { (half and 3 or 6) * n, n }, order = "N2", contact = "south", material = stiff }
  local slab = sg.body{ patch = sg.shapes.rectangle{ width = half and 1.5 or 3, height = 1,
                                                     corner = { half and 0 or -1.5, 0 } },
                        elements = { (half and 6 or 12) * n, 3 * n }, order = "N2", contact = "north", material = soft }
  return sg.model{
    bodies   = { die = die, slab = slab },
    supports = { bed  = { on = slab:face "south", fix = "xy" },
                 grip = { on = half and die:face "east" or { die:face "west", die:face "east" }, drive = "y",
                          fix = "x" },
                 middle = half and { on = { die:face "west", slab:face "west" }, symmetry = true } or nil },
    contacts = { interface = { slave = die:face "south", master = slab:face "north", penalty = 100,
                               friction = { mu = 0.2, penalty = 100 } } },
  }
end

--- The punch on its block, centered at x = y = 0, and cut there in `halves` of the directions x and y.
local function punch(halves)
  local n, cut = options.solid, { halves >= 1, halves >= 2 }
  local function body(width, bottom, height, per_half, contact, material)
    local size, corner, elements = { 0, 0, height }, { 0, 0, bottom }, { 0, 0, math.max(1, per_half * height // 2) }
    for i = 1, 2 do
      size[i], corner[i] = cut[i] and width / 2 or width, cut[i] and 0 or -width / 2
      elements[i] = cut[i] and per_half or 2 * per_half
    end
    return sg.body{ patch = sg.shapes.block{ size = size, corner = corner }, elements = elements, order = "N2",
                    contact = contact, material = material }
  end
  local block = body(4, 0, 2, 2 * n, "back", soft)
  local top = body(2, 2, 1, n, "front", stiff)
  return sg.model{
    bodies   = { block = block, punch = top },
    supports = { bed  = { on = block:face "front", fix = "xyz" },
                 grip = { on = top:face "back", drive = "z", fix = "xy" },
                 x = cut[1] and { on = { block:face "west", top:face "west" }, symmetry = true } or nil,
                 y = cut[2] and { on = { block:face "south", top:face "south" }, symmetry = true } or nil },
    contacts = { interface = { slave = top:face "front", master = block:face "back", penalty = 100 } },
  }
end

local press = { { name = "press", steps = 5, grip = { -0.1 } } }
local scenes = {
  { name = "ring, whole", parts = 1, begin = ring },
  { name = "ring, half", parts = 2, begin = function() return ring(true) end },
  { name = "punch, whole", parts = 1, begin = function() return punch(0) end },
  { name = "punch, half", parts = 2, begin = function() return punch(1) end },
  { name = "punch, quarter", parts = 4, begin = function() return punch(2) end },
}
for _ = 1, options.repeats do
  for _, scene in ipairs(scenes) do
    local began = sg.wall_time()
    local model = scene.begin()
    local run = model:run(press)
    if run.failed then error(run.failure, 0) end
    scene.times = scene.times or {}
    scene.times[#scene.times + 1] = sg.wall_time() - began
    local reaction = model:reaction "grip"
    scene.unknowns, scene.force = model:cost().unknowns, -scene.parts * (reaction.fz or reaction.fy)
  end
end

local rows, whole = {}, nil
for i, scene in ipairs(scenes) do
  scene.wall = sg.median(scene.times)
  whole = scene.parts == 1 and scene or whole
  scene.ratio = scene.wall / whole.wall
  rows[i] = { scene.name, scene.unknowns, scene.force, scene.wall, scene.ratio }
end
print(sg.table{ columns = { "model", "unknowns", "force", "wall", "of the whole" }, units = { "", "", "", "s", "" },
                rows = rows, formats = { force = "%.5f", wall = "%.3f", ["of the whole"] = "%.2f" } })

return scenes
