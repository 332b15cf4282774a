-- The listing of share/doc/files.md runs as printed and writes what it says.

require "check"

check.case("the page's listing", function()
  local code = core.read_file(core.home .. "/share/doc/files.md"):match "```lua\n(.-)```"
  local folder = check.folder()
  local file = assert(io.open(folder .. "/listing.lua", "wb"))
  file:write(code):close()
  local output, status = check.shell(("cd %s && SIGNORINI_HOME=%s %s -q listing.lua"):format(folder, core.home,
    arg[-1]))
  if status ~= 0 then error(output) end
  local same = sg.nurbs.read(folder .. "/ring.mesh")[1]
  check.equal(same:points(), sg.nurbs.read(folder .. "/ring.xml")[1]:points())
  check.equal(#sg.csv.read(folder .. "/forces.csv").rows, 5)
  check.equal(core.read_file(folder .. "/pressed.vtu"), core.read_file(folder .. "/ring_0005.vtu"))
  check.equal(sg.json.read(folder .. "/ring.json").force, sg.csv.read(folder .. "/forces.csv"):column "grip.fy")
  check.holds(core.read_file(folder .. "/linear.vtu"), 'NumberOfCells="288"')
  check.holds(core.read_file(folder .. "/ring.pvd"), "ring_0001.vtu", "ring_0005.vtu")
  check.equal(core.read_file(folder .. "/pressed.vtu") ~= core.read_file(folder .. "/reference.vtu"), true)
end)
