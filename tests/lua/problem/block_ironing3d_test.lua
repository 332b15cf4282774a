-- scripts/problems/block_ironing3d.lua, coarse: symmetry and balance of the forces, effect of a layer, files.

require "check"
local dragged = require "dragged"

local function run_study(...) return check.study("problems/block_ironing3d", ...) end
local study, folder = run_study("mesh=2x2x1/4x2x1", "orders=N2,N2-N2.1", "press=3", "slide=20")

check.case("both discretizations complete; forces of this mesh are unchanged", function()
  for _, case in ipairs(study.cases) do check.equal({ case.run.failed, case.run.steps }, { false, 23 }) end
  local N2, layer = study.cases.N2, study.cases["N2-N2.1"]
  check.near({ N2.pressed, N2.drag.mean, N2.drag.high }, { 8.0775, 8.8927, 9.5242 }, 1e-4)
  check.near({ layer.pressed, layer.drag.mean, layer.drag.high }, { 7.2888, 8.1716, 8.5332 }, 1e-4)
end)

dragged(study, { places = { [3] = 3.75, [13] = 10, [23] = 16.25 }, pressed = 3, symmetry = 1e-7, balance = 1e-8,
  pitch = { 9, 17 } }) -- one pitch of 5 in steps of 0.625 about x = 10

check.case("without friction a state does not depend on the path: pressed in the middle", function()
  local model = scenes.model{
    bodies = { block = { size = {4, 4, 4}, corner = {8, 3, 10}, elements = {2, 2, 1}, contact = "front",
        thickness_degree = 1, E = 10 },
      slab = { size = {20, 10, 10}, elements = {4, 2, 1}, contact = "back", thickness_degree = 1 } },
    supports = { bed = { on = "slab.front", fix = "xyz" }, grip = { on = "block.back", drive = "z", fix = "xy" } },
    contacts = { interface = { slave = "block.front", master = "slab.back", penalty = 100 } } }
  local run = model:run{ { steps = 3, grip = -1 } }
  check.near(-run:column "grip.fz"[3], study.cases.N2.Pz[13], 1e-7)
end)

check.case("charts, states, a table and a file per order", function()
  check.pictures(folder, { "path", "Pz", "Px", "oscillations", "states" })
  local forces = sg.csv.read(folder .. "/forces.csv")
  check.equal(forces:column "order", { "N2", "N2-N2.1" })
  check.equal(forces:column "drag_mean", { study.cases.N2.drag.mean, study.cases["N2-N2.1"].drag.mean })
  check.equal(sg.csv.read(folder .. "/N2.csv"):column "grip.fz", study.cases.N2.run:column "grip.fz")
  check.equal(#study.files, 2 + 1 + 5)
end)

check.case("sixty steps: cases, half models", function()
  local both, place = run_study("variant=sixty", "mesh=2x2x1/4x2x1", "orders=N2", "thickness_degree=1,2", "part=whole",
    "line_search=none")
  check.equal(#both.cases, 2)
  for _, case in ipairs(both.cases) do
    check.equal({ case.run.failed, case.run.steps }, { false, 60 })
    check.near(case.pressed, -case.run:column "grip.fz"[10])
  end
  check.near(both.cases[1].pressed, study.cases.N2.pressed, 1e-7)
  assert(both.cases[2].drag.mean < both.cases[1].drag.mean, "more functions are softer")
  local halved = run_study("variant=sixty", "mesh=2x4x1/4x4x1", "orders=N2")
  local whole = run_study("variant=sixty", "mesh=2x4x1/4x4x1", "orders=N2", "part=whole")
  -- What is mirrored may have a crease in the plane of symmetry, which C¹ across forbids: it is softer by a little.
  local ratio = halved.cases[1].pressed / whole.cases[1].pressed
  assert(ratio > 0.99 and ratio < 1, ratio)
  check.equal(halved.cases[1].run.failed, false)
  check.pictures(place, { "sixty" })
  check.equal(sg.csv.read(place .. "/sixty.csv"):column "thickness_degree", { 1, 2 })
end)

check.case("sixty steps: a layer on the slab alone, below the block's path", function()
  local study, place = run_study("variant=sixty", "mesh=2x2x1/8x4x2", "orders=N2-N2.1", "block_order=N2", "layer=below",
    "thickness_degree=2", "points=3", "tolerance=1e-6")
  local cases = study.cases
  check.equal({ cases[1].dofs.total, cases[1].run.failed, cases[1].run.steps, cases[1].run.cutbacks },
    { 738, false, 60, 0 })
  check.within("mean pressing force", cases[1].drag.mean, 5.8, 0.05)
  local row = sg.csv.read(place .. "/sixty.csv"):by "order"["N2-N2.1"]
  check.equal({ row.block_order, row.layer, row.tolerance }, { "N2", "below", 1e-6 })
end)

check.case("wrong arguments", function()
  check.refused("problems/block_ironing3d", {
    ["mesh=4x4/8x4x4"] = "mesh must be elements of die and slab per direction such as 4x4x4/8x4x4, got '4x4/8x4x4'",
    ["mesh=0x4x4/8x4x4"] = "mesh must be elements", ["orders=Q7"] = "Q7", ["block"] = "unknown argument 'block'",
    ["press=0"] = "press must be a whole number, 1 or more, got '0'",
    ["thickness_degree=2"] =
      "'thickness_degree=2', which belongs to variant=sixty; known with variant=standard: formulation=gpts, ",
    ["variant=sixty slide=9"] = "'slide=9', which belongs to variant=standard; known with variant=sixty: block",
    ["variant=sixty layer=half"] = "layer must be values among 'whole' and 'below', got 'half'",
    ["variant=sixty orders=N2 layer=below"] = "layer=below: order 'N2' has no layer. Hint: layer=whole",
    ["variant=sixty mesh=2x2x1/8x3x2"] = "mesh=2x2x1/8x3x2: a half model has half of the elements across, so both "
      .. "numbers (2 and 3) must be even. Hint: part=whole",
    ["variant=sixty points=x"] = "points must be whole numbers of at least 1, or auto, got 'x'",
    ["variant=x"] = "variant must be 'standard' or 'sixty', got 'x'",
  })
end)
