-- scripts/problems/cylinder_ironing3d.lua, coarse: symmetry and balance of the forces, effect of a layer, files.

require "check"
local dragged = require "dragged"

local study, folder = check.study("problems/cylinder_ironing3d", "mesh=8x2x1/8x4x1", "orders=N2,N2-N2.1", "press=4",
  "slide=24")

check.case("both discretizations complete; forces of this mesh are unchanged", function()
  for _, case in ipairs(study.cases) do check.equal({ case.run.failed, case.run.steps }, { false, 28 }) end
  local N2, layer = study.cases.N2, study.cases["N2-N2.1"]
  check.near({ N2.pressed, N2.drag.mean, N2.drag.high }, { 0.21681, 0.22159, 0.22724 }, 1e-5)
  check.near({ layer.pressed, layer.drag.mean, layer.drag.high }, { 0.20093, 0.20762, 0.20973 }, 1e-5)
end)

dragged(study, { places = { [4] = 0.5, [16] = 1.25, [28] = 2 }, pressed = 4, symmetry = 1e-8, balance = 1e-9,
  lateral = false, pitch = { 14, 19 } }) -- a pitch of 0.3125 in steps of 0.0625 about x = 1.25

check.case("charts, states, a table and a file per order", function()
  check.pictures(folder, { "path", "Pz", "Px", "oscillations", "states" })
  check.equal(sg.csv.read(folder .. "/forces.csv"):column "dPz", { study.cases[1].dPz.raw, study.cases[2].dPz.raw })
  check.equal(#study.files, 2 + 1 + 5)
end)

check.case("wrong arguments", function()
  check.refused("problems/cylinder_ironing3d", {
    ["mesh=12x6x2"] = "mesh must be elements of die and slab per direction", ["orders=Q7"] = "Q7",
    ["slide=ten"] = "slide must be a whole number, 1 or more, got 'ten'",
    ["points=4"] = "unknown argument 'points=4'; known: formulation=gpts, linear=auto, ",
    ["variant=sixty"] = "unknown argument 'variant=sixty'",
  })
end)
