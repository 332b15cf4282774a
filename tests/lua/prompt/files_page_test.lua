-- The listing of share/doc/use/files.md runs as printed and writes what it says.

require "check"

check.case("the page's listing", function()
  local _, folder = check.page(core.share .. "/doc/use/files.md")
  local same = sg.nurbs.read(folder .. "/ring.mesh")[1]
  check.equal(same:points(), sg.nurbs.read(folder .. "/ring.xml")[1]:points())
  check.equal(#sg.csv.read(folder .. "/forces.csv").rows, 5)
  check.equal(core.read_file(folder .. "/pressed.vtu"), core.read_file(folder .. "/ring_0005.vtu"))
  check.equal(sg.json.read(folder .. "/ring.json").force, sg.csv.read(folder .. "/forces.csv"):column "grip.fy")
  check.holds(core.read_file(folder .. "/linear.vtu"), 'NumberOfCells="288"')
  check.holds(core.read_file(folder .. "/ring.pvd"), "ring_0001.vtu", "ring_0005.vtu")
  check.equal(core.read_file(folder .. "/pressed.vtu") ~= core.read_file(folder .. "/reference.vtu"), true)
end)
