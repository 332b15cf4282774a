-- Generated scenes (scripts/stability/generated.lua): reproducible from a seed, equal to their mirror image, outcomes
-- of the first ones.

require "check"

core.quiet = true
package.path = core.home .. "/scripts/stability/?.lua;" .. package.path
local drawn = require "generated.scenes"

--- A scene as one line of text.
local function text(scene)
  local numbers = {}
  for i, key in ipairs { "E", "mu", "penalty", "place", "press", "drag" } do
    numbers[i] = ("%.5g"):format(scene[key])
  end
  return ("%s, slave %s, %s on %s, %s and %s; %s; %d + %d steps"):format(scene.shape, scene.slave, scene.orders.body,
    scene.orders.slab, table.concat(scene.elements.body, "x"), table.concat(scene.elements.slab, "x"),
    table.concat(numbers, " "), scene.steps.press, scene.steps.drag)
end

check.case("a seed gives the same scene on every machine", function()
  check.equal(text(drawn.describe("plane", 17)), "block, slave body, N2 on N2-N2.1, 5x2 and 12x2; "
    .. "15.388 0.67716 42.747 -0.010542 0.1027 -0.35207; 6 + 14 steps")
  check.equal(text(drawn.describe("space", 2)), "half ring, slave body, N2-N3 on L1, 2x1x1 and 6x2x2; "
    .. "40.35 0 78.165 0.098822 0.07582 -0.22859; 3 + 10 steps")
end)

check.case("the mirror image has the same forces, and the scene itself is bitwise reproducible", function()
  for _, case in ipairs { { "plane", 2 }, { "plane", 17 }, { "space", 2 } } do
    local scene = drawn.describe(table.unpack(case))
    local _, account = drawn.solve(scene, sg.robust{})
    local _, image = drawn.solve(scene, sg.robust{}, true)
    local _, again = drawn.solve(scene, sg.robust{})
    check.equal({ account.ending, image.ending }, { "completed", "completed" })
    check.at_most(text(scene), drawn.difference(account, image), 1e-9)
    check.equal(again.forces, account.forces)
  end
end)

--- Solves the scenes of some seeds; counts those that `counts` holds for and lists those of them that end early.
local function early(kind, first, last, counts)
  local scene_count, found = 0, {}
  for seed = first, last do
    local scene = drawn.describe(kind, seed)
    if counts(scene) then
      local _, account = drawn.solve(scene, sg.robust{})
      scene_count = scene_count + 1
      if account.ending ~= "completed" then found[#found + 1] = ("%d (%s)"):format(seed, account.ending) end
    end
  end
  return scene_count, found
end

--- The master's face ends in the sharp edges of a block.
local function sharp(scene) return scene.shape == "block" and scene.slave == "slab" end

check.case("masters without sharp edges: every scene completes", function()
  local count, found = early("plane", 1, 150, function(scene) return not sharp(scene) end)
  check.equal({ count, found }, { 121, {} })
end)

check.case("masters with sharp edges: at most one of 29 ends early; 11 did when traction ended with the face",
  function()
    local count, found = early("plane", 1, 150, sharp)
    check.equal({ count, #found <= 1 or table.concat(found, ", ") }, { 29, true })
  end)

check.case("pseudo-transient continuation passes a loss of stability at an edge, and the run reports it", function()
  local carried = 0
  for _, seed in ipairs { 219, 226, 259 } do
    local scene = drawn.describe("plane", seed)
    check.equal(select(2, drawn.solve(scene, sg.robust{ fallback = false })).ending ~= "completed", true)
    local run, account = drawn.solve(scene, sg.robust{})
    if account.ending == "completed" and run.fallbacks["pseudo-transient"] then
      carried = carried + 1
      check.holds(table.concat(run.warnings, "\n"), "another branch of solutions were needed")
      check.holds(table.concat(run.warnings, "\n"), "pseudo-transient in step")
    end
  end
  check.equal(carried >= 2 or carried, true)
end)

--- An eighth of a hollow sphere pressed onto a quarter of a block: at both planes of symmetry the block's face ends.
check.case("planes of symmetry in space hold the points that project beyond the master's end", function()
  local ball = sg.body{
    patch = sg.shapes.sphere_octant{ inner = 0.5, outer = 1, center = { 0, 0, 1 } }, elements = { 6, 6, 1 },
    order = "N2", contact = "front", material = sg.neo_hookean{ E = 10, nu = 0.3 },
  }
  local block = scenes.body{ size = { 1.2, 1.2, 0.6 }, corner = { 0, 0, -0.6 }, elements = { 6, 6, 2 },
    contact = "back" }
  local model = scenes.model{ bodies = { ball = ball, block = block },
    supports = { bed = { on = "block.front", fix = "xyz" }, grip = { on = "ball.south", drive = "z" },
      x0 = { on = { "block.west", "ball.east" }, fix = "x" }, y0 = { on = { "block.south", "ball.west" }, fix = "y" } },
    contacts = { interface = { slave = "ball.front", master = "block.back", penalty = 30,
      friction = { mu = 0.5, penalty = 30 } } } }
  local run = model:run({ { steps = 5, grip = -0.2 } }, sg.robust{})
  check.equal({ run.reason, run.cutbacks }, { "completed", 0 })
end)
