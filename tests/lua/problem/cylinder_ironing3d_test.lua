-- scripts/problems/cylinder_ironing3d.lua, coarse: symmetry and balance of the forces, effect of a layer, files.

local sg = require "signorini"
local core = require "signorini.core"
local check = require "check"
local way_back = require "way_back"

local script = core.home .. "/scripts/problems/cylinder_ironing3d.lua"
local folder = check.folder()
local study = assert(loadfile(script))("out=" .. folder, "mesh=8x2x1/8x4x1", "orders=N2,N2-N2.1", "press=4", "slide=24")

check.case("both discretizations complete; forces of this mesh are unchanged", function()
  for _, case in ipairs(study.cases) do check.equal({ case.run.failed, case.run.steps }, { false, 28 }) end
  local N2, layer = study.cases.N2, study.cases["N2-N2.1"]
  check.near({ N2.pressed, N2.drag.mean, N2.drag.high }, { 0.21681, 0.22159, 0.22724 }, 1e-5)
  check.near({ layer.pressed, layer.drag.mean, layer.drag.high }, { 0.20093, 0.20762, 0.20973 }, 1e-5)
end)

check.case("Pz is symmetric about the slab's middle, Px its opposite", function()
  for _, case in ipairs(study.cases) do
    check.near({ case.x[4], case.x[16], case.x[28] }, { 0.5, 1.25, 2 }, 1e-12)
    way_back(case, 4, 1e-8)
  end
end)

check.case("the forces on the die equal those on the bed, without a lateral component", function()
  for _, case in ipairs(study.cases) do
    for _, axis in ipairs { ".fx", ".fy", ".fz" } do
      local bed, grip = case.run:column("bed" .. axis), case.run:column("grip" .. axis)
      for step = 1, case.run.steps do
        check.near(bed[step] + grip[step], 0, 1e-9)
        if axis == ".fy" then check.near(bed[step], 0, 1e-9) end
      end
    end
  end
end)

check.case("a layer reduces the oscillations to less than a third", function()
  local layer = study.cases["N2-N2.1"]
  check.equal({ layer.first, layer.last }, { 14, 19 }) -- a pitch of 0.3125 in steps of 0.0625 about x = 1.25
  for _, force in ipairs { "dPx", "dPz" } do
    for _, kind in ipairs { "raw_percent", "detrended_percent" } do
      if layer[force][kind] > 33 then error(("%s %s is %g"):format(force, kind, layer[force][kind])) end
    end
  end
end)

check.case("charts, states, a table and a file per order", function()
  check.pictures(folder, { "path", "Pz", "Px", "oscillations", "states" })
  check.equal(sg.csv.read(folder .. "/forces.csv"):column "dPz", { study.cases[1].dPz.raw, study.cases[2].dPz.raw })
  check.equal(#study.files, 2 + 1 + 5)
end)

check.case("wrong arguments", function()
  check.refused(script, {
    ["mesh=12x6x2"] = "mesh must be elements of die and slab per direction", ["orders=Q7"] = "Q7",
    ["slide=ten"] = "slide must be a whole number, 1 or more, got 'ten'",
    ["points=4"] = "unknown argument 'points=4'; known: formulation=gpts, linear=auto, ",
    ["variant=sixty"] = "unknown argument 'variant=sixty'",
  }, "out=" .. folder)
end)

check.done()
