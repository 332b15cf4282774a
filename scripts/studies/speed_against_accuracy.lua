-- Work-precision diagrams: error over time of discretizations on five problems; charts and a page.
--
-- Problem: ironing (oscillation of both forces), Hertz (L2 error of the pressure), two rings (the same), peeling
--          (oscillation of the moment), ironing in 3D (oscillation of both forces): uniform and varying-order
--          discretizations on several meshes, error over time.
--
--          error |  o
--                |   \ o          one curve per discretization, one marker per mesh; lower left is better;
--                |    o \         compared: times of two discretizations at equal error
--                |     \ o
--                |______\_________ time
--
--          The problems are those of ironing2d.lua, hertz2d.lua, rings2d.lua, peeling2d.lua and ironing3d.lua; error
--          measures and differences from these scripts are documented in the files of speed_against_accuracy/.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, sections 7.1 to 7.5; printed savings from section 7.1.3,
--         section 7.2 and Table 7.6.
-- Units: times in s; errors in N/mm (ironing), 1 (Hertz), N/m²·√m (rings), E0 L0³ (peeling); 3D: any consistent ones.
-- Expected: at equal error, in the middle of the common range, N2-N2.2 takes a seventh of the time of N2 in ironing, a
--           fifth in peeling, under a half in Hertz, three quarters in the rings; of the time of N4 a seventh to a
--           quarter, a twelfth, a quarter and a half; in 3D it is better on the sparse mesh than N2 on the middle mesh.
--           The thesis prints 56.62 and 72.78 % less time for ironing (N2-N2.2 at m1, m2 compared with N2 at m3, m4),
--           here 79 and 92; 42.48 and 43.74 % for Hertz (at m3, m4 compared with N2 at m4, m5), here 54. About half an
--           hour on one processor.
-- Run: signorini speed_against_accuracy.lua [problems=ironing,hertz,rings,peeling,ironing3d] [orders=all]
--      [meshes=all] [rounds=0] [time=wall] [out=out/speed_against_accuracy] [page=none]; orders, meshes: all of a
--      problem, or a list (any discretizations; meshes of the problem); rounds: runs per case, for medians, 0 is the
--      default of each problem (3, expensive ones 1); time: wall, or cpu on a machine under other load; page: folder of
--      the page, such as share/doc/evidence. Finished cases are saved in `out` and not run again.

local sg = require "signorini"
local page = require "studies.speed_against_accuracy.page"
local report = require "studies.speed_against_accuracy.report"
local study = require "studies.speed_against_accuracy.study"

local names = { "ironing", "hertz", "rings", "peeling", "ironing3d" }
local problems = {}
for _, name in ipairs(names) do problems[name] = require("studies.speed_against_accuracy." .. name) end

--- Whether one of the requested problems has a mesh.
local function is_mesh(mesh, options)
  for _, name in ipairs(options.problems) do
    for _, known in ipairs(problems[name].meshes) do
      if mesh == known then return true end
    end
  end
  return mesh == "all"
end

local options = sg.arguments{
  problems = { names, choices = names }, orders = { "all" },
  meshes = { { "all" }, check = is_mesh, expected = "all, or meshes that one of the problems has" },
  rounds = { 0, at_least = 0 },
  time = { "wall", choices = { "wall", "cpu" } }, out = "out/speed_against_accuracy", page = "none",
}
local files, page_name = sg.files(options.out), "speed_against_accuracy"
local paths = setmetatable({}, { __call = function(_, name) return files(name) end })

--- The path of a chart of the page.
function paths.page(name) return ("%s/%s/%s"):format(options.page, page_name, name) end

if options.page ~= "none" then sg.mkdir(("%s/%s"):format(options.page, page_name)) end
local results = {}
for _, name in ipairs(options.problems) do
  local measured = study.of(problems[name], options)
  if measured then
    local result = report.of(measured, options, paths)
    results[#results + 1], results[name] = result, result
    report.print(result)
  else
    print(("%s is skipped: it has none of the meshes %s"):format(name, table.concat(options.meshes, ", ")))
  end
end
files:report()
if options.page ~= "none" and #results > 0 then
  local file = ("%s/%s.md"):format(options.page, page_name)
  page.write(file, results, options, page_name)
  print(("The page: %s"):format(file))
end

return { results = results, files = files }
