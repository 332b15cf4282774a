-- Texts of the library's objects at the prompt.

require "check"
local show = require "signorini.prompt.show"

local slab = scenes.body{ size = {3, 1}, elements = { 4, 2 }, order = "N2-N2.2", contact = "south" }
local model = scenes.model{ bodies = { slab = slab }, supports = { grip = { on = "north", drive = "xy" } },
  contacts = { ground = { slave = "south", master = scenes.floor(-0.05), penalty = 10 } } }

check.case("a patch and a body, with their positions", function()
  check.equal(show.text(sg.shapes.rectangle { width = 3, height = 1, corner = { -1, 0 } }),
    "NURBS surface in 2D: degree 1 x 1, elements 1 x 1, 4 control points\n  control points in x -1 … 2, y 0 … 1\n"
      .. "  faces: west in x = -1; east in x = 2; south in y = 0; north in y = 1")
  local dofs = slab:dofs()
  check.equal(show.text(slab),
    ("%s\n  %d degrees of freedom on contact faces, %d in the bulk\n  control points in x 0 … 3, y 0 … 1")
    :format(slab, dofs.interface, dofs.bulk))
end)

check.case("print shows bodies and models as the prompt does, with degrees per direction; tostring is one line",
  function()
  check.holds(slab, "plane body: 4 x 2 elements, degree 4 x 2, then 2 x 2, ")
  check.equal(tostring(slab):find "\n", nil)
  local output = check.script [[
    local sg = require "signorini"
    local b = sg.body{ patch = sg.shapes.rectangle{ width = 3, height = 1 }, elements = {4, 2}, order = "N3",
      contact = "south", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
    print(b)
    print(sg.model{ bodies = { b = b }, supports = { s = { on = b:face "north", fix = "xy" } } }, 7)]]
  check.equal(output, "plane body: 4 x 2 elements, degree 3 x 3, 70 degrees of freedom, E = 1, nu = 0.3\n"
    .. "  14 degrees of freedom on contact faces, 56 in the bulk\n  control points in x 0 … 3, y 0 … 1\n"
    .. "plane-strain model of b: 70 degrees of freedom, 56 of them free, 1 support, 0 contacts\n"
    .. "  b: plane body: 4 x 2 elements, degree 3 x 3, 70 degrees of freedom, E = 1, nu = 0.3\n7\n")
end)

check.case("a model before and after a step", function()
  check.holds(show.text(model), tostring(model), "\n  slab: plane body: 4 x 2 elements",
    "\n  moved by stages: grip at x = 0, y = 0\n  contact ground: open")
  model:run { { name = "press", steps = 4, grip = { 0, -0.1 } } }
  local now = model:contact_resultant "ground"
  check.equal(now.active > 0, true)
  check.holds(show.text(model), "grip at x = 0, y = -0.1\n",
    ("contact ground: %d active points, %d slipping; force {%.4g, %.4g}, largest pressure %.4g; tractions per current "
      .. "area"):format(now.active, now.slipping, now.fx, now.fy, now.max_pressure))
end)

check.case("a profile, a table, and plain tables as ever", function()
  local profile = model:profile "ground"
  local touching = 0
  for _, state in ipairs(profile.state) do touching = touching + (state == "open" and 0 or 1) end
  check.holds(show.text(profile), ("contact profile of %d points: "):format(#profile.x),
    ("%d %s"):format(touching, profile.state[30]),
    "pressure ", "lists: X, Y, area, gap, inside, pressure, state, traction, x, y")
  local data = sg.reference "ironing2d_oscillation_table7_3"
  check.holds(show.text(data), "# " .. data.comments[1], data.columns[1])
  check.equal(show.text { x = { 1 }, gap = 2 }, "{gap = 2, x = {1}}")
  check.equal(show.text { x = { 1 }, pressure = { 2 }, gap = { 0 }, state = { "stick" } },
    "{gap = {0}, pressure = {2}, state = {\"stick\"}, x = {1}}")
  local file, list = check.file(), {}
  for i = 1, 25 do list[i] = i end
  sg.csv.write(file, { step = list })
  check.holds(show.text(sg.csv.read(file)), "step\n   1\n", "\n  20\n… 5 more rows")
end)

check.case("functions by the head of their page or their place, tables of the language by their names", function()
  check.equal(show.text(sg.shapes.rectangle),
    "sg.shapes.rectangle{ width, height, corner = {0, 0} }\n  see help(sg.shapes.rectangle)")
  check.holds(show.text(sg.chart), "sg.chart{ <curves>, x, xlabel, ylabel, title,",
    "size = {1600, 1000}, file }\n  see help(sg.chart)")
  check.equal(show.text(model.save), 'model:save(path)\n  see help "model:save"')
  local function own() end
  check.equal(show.text(own),
    ("function (%s:%d)"):format(debug.getinfo(1, "S").short_src, debug.getinfo(own, "S").linedefined))
  check.equal(show.text { print, sg.body }, "{function, sg.body}")
  check.equal(show.text(sg.csv), "sg.csv: see help(sg.csv)\n  read, write")
  check.equal(tostring(sg), show.text(sg))
  check.holds(tostring(sg), "sg: see help(sg)\n  abs, arguments, atan, body,",
    "\n  csv:\n    read, write\n  json:\n    read, write\n  nurbs:\n    arc, circle,")
end)

check.case("print begins a line for each value where one has a text of its own, else it is Lua's", function()
  check.equal((check.script [[
    local sg = require "signorini"
    local files = sg.files(os.tmpname() .. ".d")
    files "a.png"
    print(files, files, nil)
    print(1, nil, "a", {} ~= nil)
    print(files)
    print()
    os.remove(files.folder)]]):gsub("/[^\n:]*/lua_%w+", "x"),
    ("1 file in x.d:\n  x.d/a.png\n"):rep(2) .. "nil\n1\tnil\ta\ttrue\n1 file in x.d:\n  x.d/a.png\n\n")
end)

check.case("long texts are cut between characters, nan has no sign", function()
  check.equal(show.text(("ab"):rep(500)), '"' .. ("ab"):rep(500) .. '"')
  check.equal(show.text(("x"):rep(999) .. "äb"), '"' .. ("x"):rep(999) .. '"… 3 more bytes')
  check.equal(show.text { "a\nb" }, '{"a\\nb"}')
end)

check.case("long lists are cut and share lines", function()
  local list = {}
  for i = 1, 10000 do list[i] = i / 8 + 1000 end
  local lines = {}
  for line in show.text(list):gmatch "[^\n]+" do
    lines[#lines + 1] = line
    check.equal(#line <= 102, true)
  end
  check.equal({ #lines, lines[1], lines[#lines] }, { 7, "{", "}" })
  check.holds(lines[2], "  1000.125, 1000.25, 1000.375,")
  check.equal(lines[6], "  … 9960 more")
end)

check.case("a contact whose points touch to rounding error shows no pressure", function()
  check.holds(show.text((sg.scenes.block{})), "contact interface: touches without a force\n")
  check.holds(show.text((sg.scenes.hertz{})), "active points, 0 slipping; force {0, ")
end)
