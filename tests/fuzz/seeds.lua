-- Writes the inputs with which the fuzzers start: files and objects of all kinds, as small as possible. Argument: the
-- folder, tests/fuzz/corpus. Findings are further files there, with names that tell what was wrong.

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local sg = require "signorini"
package.path = ("%s;%s/tests/lua/?.lua"):format(package.path, core.home)
local scenes = require "walk_scenes"

local folder = arg[1]
core.quiet = true

local function write(target, name, bytes)
  sg.mkdir(("%s/%s"):format(folder, target))
  core.write_file(("%s/%s/%s"):format(folder, target, name), bytes)
end

-- ── Objects ──────────────────────────────────────────────────────────────────────────────────────────────────────────

local soft = sg.neo_hookean{ E = 1, nu = 0.3 }
local square = sg.shapes.rectangle{ width = 1, height = 1 }
local cube = sg.shapes.block{ size = { 1, 1, 1 } }

--- An object of the archive's kind `number`, in the order of archive.cpp.
local function object(name, number, value) write("archive", name, string.char(number) .. value) end
object("patch", 1, core.content(square))
object("patch_rational", 1, core.content(sg.shapes.half_annulus{ inner = 1, outer = 2, center = { 0, 0 } }))
object("material_neo_hooke", 4, core.content(soft))
object("material_formula", 4, core.content(sg.hyperelastic{ energy = function(I1, I2, J)
  return 0.3 * (I1 - 3) + 0.1 * (I2 - 3) - sg.log(J) + 0.2 * (sg.exp(sg.log(J) ^ 2) - 1)
end }))
object("material_fiber", 4, core.content(sg.hyperelastic{ energy = function(I1, _, J, I4)
  return 0.5 * (I1 - 3) - sg.log(J) + sg.log(J) ^ 2 + 0.1 * (I4 - 1) ^ 2
end, fibers = { { 1, 0, 0 } } }))
object("material_stretches", 4, core.content(sg.ogden{ mu = { 0.6 }, alpha = { 1.3 }, K = 20 }))
local layered = { patch = square, elements = { 3, 1 }, order = "N2-N2.1", contact = "north", material = soft }
local body = core.content(sg.body(layered))
object("body_layer", 5, body)
object("discretization_layer", 3, body)
layered.layer = { 0.4, 1 }
object("body_local_layer", 5, core.content(sg.body(layered)))
object("body", 5, core.content(sg.body{ patch = square, elements = { 2, 1 }, order = "N2", material = soft }))
object("body_projected", 5, core.content(sg.body{ patch = square, elements = { 2, 2 }, order = "L2", material = soft,
                                                  volumetric = "projected" }))
object("solid", 6, core.content(sg.body{ patch = cube, elements = { 1, 1, 1 }, order = "N2", material = soft }))
object("solid_layer", 6, core.content(sg.body{ patch = cube, elements = { 1, 1, 1 }, order = "N2-N3", contact = "back",
                                               material = soft }))

--- Rigid obstacles: their content begins with the name of their form, a number of 4 bytes.
local function obstacle(name, number, value) object(name, number, core.content(value):sub(5)) end
obstacle("plane", 7, sg.rigid.plane{ point = { 0, 0 }, normal = { 0, 1 } })
obstacle("disc", 7, sg.rigid.cylinder{ center = { 0, 1 }, radius = 0.5 })
obstacle("curve", 7, sg.rigid.surface(sg.nurbs.arc{ center = { 0, 1 }, radius = 1, from = 200, to = 340 }))
obstacle("level_set", 7, sg.rigid.level_set{ f = function(x, y) return x ^ 2 + sg.abs(y) - 1 end,
                                             box = { { -2, -2 }, { 2, 2 } } })
obstacle("sphere", 8, sg.rigid.sphere{ center = { 0, 0, 1 }, radius = 0.5 })
obstacle("torus", 8, sg.rigid.torus{ center = { 0, 0, 1 }, axis = { 0, 0, 1 }, radius = 0.2, ring = 1 })
obstacle("level_set_3d", 8, sg.rigid.level_set{ f = function(x, y, z) return z - 0.1 * sg.cos(x) * sg.sin(y) end,
                                                box = { { -1, -1, -1 }, { 1, 1, 1 } } })

-- ── Checkpoints ──────────────────────────────────────────────────────────────────────────────────────────────────────

--- The first scenes of walk_scenes.lua that have a law, a shape or a kind that no earlier one has.
local seen = {}
for seed = 1, 100 do
  local scene = scenes.describe(seed)
  scene.elements = scene.space and { slab = { 1, 1, 1 }, body = { 1, 1, 1 } } or
                     { slab = { 3, 1 }, body = { scene.upper == "ring" and 2 or 1, 1 } }
  scene.points = 2
  local features = { scene.law, scene.upper, scene.kind }
  local new = lists.filter(features, function(one) return not seen[one] end)
  local ok, model, target = pcall(scenes.build, scene)
  if ok and #new > 0 then
    pcall(model.run, model, { { steps = 1, grip = target(0, 0.02, 1) } })
    local file = os.tmpname()
    model:save(file)
    local bytes = core.read_file(file)
    os.remove(file)
    if #bytes < 6700 then
      for _, one in ipairs(new) do seen[one] = true end
      write("checkpoint", ("%03d_%s_%s_%s"):format(seed, scene.kind, scene.upper:gsub(" ", "_"),
        scene.law:gsub("[^%w]+", "_")), bytes)
    end
  end
end

-- ── Patches ──────────────────────────────────────────────────────────────────────────────────────────────────────────

local pair = { square, sg.shapes.rectangle{ width = 1, height = 1, corner = { 1, 0 } } }
for name, patches in pairs{ plane = pair, space = { cube }, arc = {
  sg.nurbs.arc{ center = { 0, 0 }, radius = 1, from = 0, to = 90 } },
  annulus = { sg.shapes.half_annulus{ inner = 1, outer = 2, center = { 0, 0 } } } } do
  for _, ending in ipairs{ "xml", "txt", "mesh" } do
    local file = os.tmpname() .. "." .. ending
    sg.nurbs.write(file, patches)
    write("geometry", name .. "." .. ending, core.read_file(file))
    os.remove(file)
  end
end

-- ── Words and data ───────────────────────────────────────────────────────────────────────────────────────────────────

for name, text in pairs{ label = "N2-N2.3x2", lagrange = "L2", film = "film%03d.png", host = "ssh:a,ssh:b",
                         answer = "\27_Gi=31;OK\27\\\27[6;20;10t\27[4;600;800t\27[?2;0;800;600S\27[?62;4;22c",
                         quit = " exit ( ) ; ", terminal = "tmux|kitty" } do
  write("words", name, text)
end
write("data", "json", '{"a": [1, -2.5e-3, true, null, "x\\u00e9\\n"], "b": {"c": {}}, "d": 18446744073709551615}')
write("data", "pack", core.pack{ a = { 1, -2.5, true, "x" }, b = { c = { 0 / 0, 1e308 } }, d = 1 << 40 })
