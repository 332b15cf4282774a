-- scripts/hertz3d.lua, coarse: Hertz's point contact in 3D beside its axisymmetric twin, the files it leaves.

local sg = require "signorini"
local core = require "signorini.core"
local check = require "check"

local script = core.home .. "/scripts/hertz3d.lua"
local folder = os.tmpname()
os.remove(folder)
local study = assert(loadfile(script))("out=" .. folder, "meshes=m1,m2", "around=1,3", "steps=3")

local function at_most(what, value, bound)
  if not value or math.abs(value) > bound then
    error(("%s: expected at most %g in size, got %s"):format(what, bound, tostring(value)), 2)
  end
end

check.case("Hertz's values as printed in the thesis, and a quarter of the load on the ground", function()
  check.near({ study.cases[1].a, study.cases[1].p0 }, { 0.05985, 0.04187 }, 5e-6)
  for _, case in ipairs(study.cases) do at_most("force in %", case.force_percent, 1e-6) end
end)

check.case("peak and radius converge to Hertz's; the layer is ahead of N2", function()
  for _, label in ipairs { "N2", "N2-N2.2" } do
    local coarse, fine = study.cases[label .. " m1"], study.cases[label .. " m2"]
    at_most(label .. " peak in %", fine.peak_percent, 3.5)
    at_most(label .. " radius in %", fine.width_percent, 3)
    at_most(label .. " peak in %", fine.peak_percent, 0.3 * coarse.peak_percent)
    at_most(label .. " error", fine.error, 0.5 * coarse.error)
  end
  for _, mesh in ipairs { "m1", "m2" } do
    at_most("error of the layer at " .. mesh, study.cases["N2-N2.2 " .. mesh].error, study.cases["N2 " .. mesh].error)
  end
end)

check.case("3D is the axisymmetric scene but for quadrature, at any number of elements around the axis", function()
  for _, case in ipairs(study.cases) do
    at_most("peak apart in %", case.peak_apart, 0.05)
    at_most("radius apart in %", case.width_apart, 0.05)
    at_most("spread on a ring in % of p0", case.spread_percent, 0.05)
  end
  -- One element for a quarter turn has the fewest Gauss points.
  local twin = study.cases["N2 m1"].twin
  for i, bound in ipairs { 0.5, 0.01 } do
    at_most("peak beside the twin's in %", study.turns[i].peak_percent - twin.peak_percent, bound)
    at_most("radius beside the twin's in %", study.turns[i].width_percent - twin.width_percent, bound)
  end
end)

check.case("charts, pictures and a profile per run", function()
  for _, name in ipairs { "pressure_N2", "pressure_N2-N2.2", "szz", "szz_near", "pressure_below" } do
    local stream = assert(io.open(("%s/%s.png"):format(folder, name), "rb"))
    check.equal(stream:read(8), "\137PNG\r\n\26\n")
    stream:close()
  end
  check.equal(sg.csv.read(folder .. "/N2_m2.csv"):column "pressure", study.cases["N2 m2"].profile.pressure)
  check.equal(#study.files, 4 + 2 + 3)
end)

check.case("wrong arguments", function()
  for word, message in pairs { ["mesh=m1"] = "unknown argument 'mesh=m1'; known: around=", ["meshes=m9"] = "got 'm9'",
                               ["around=0"] = "around must be whole numbers of at least 1, got '0'",
                               ["steps=0"] = "steps must be", ["labels=Q7"] = "Q7" } do
    local output, status = check.program { "-q", script, "out=" .. folder, word }
    check.equal(status, 1)
    check.holds(output, message)
  end
end)

check.shell("rm -r " .. folder)
check.done()
