-- Arguments and files that the fuzzers have found (tests/fuzz): each was a crash, an endless call, or a message that
-- did not help.

require "check"
local slurm = require "signorini.study.slurm"

local folder = check.folder()

local function body() return scenes.body{ elements = { 1, 1 }, order = "N1" } end

check.case("names of parts may contain a zero byte", function()
  local one, other = body(), body()
  local model = sg.model{
    bodies = { ["a\0b"] = one, a = other, ["\0"] = body() },
    supports = { ["bed\0"] = { on = one:face "south", fix = "xy" }, grip = { on = one:face "north", drive = "xy" },
                 rest = { on = { other:face "south" }, fix = "xy" } },
  }
  check.equal(#model:body_names(), 3)
  check.equal(model:sample("a\0b", "ux", { 0.5, 0.5 }), 0)
end)

check.case("names of files must not contain a zero byte", function()
  for _, use in ipairs{ sg.mkdir, sg.csv.read, sg.load, sg.json.read } do
    check.fails(function() use(folder .. "/a\0b") end, "odd_values_test.lua", "cannot contain a zero byte", "a\\x00b")
  end
  check.equal(#core.list_folder(folder), 0)
end)

check.case("messages show control characters and quote the beginning of long strings", function()
  check.fails(function() sg.neo_hookean{ E = "\27[2J\7", nu = 0 } end, "E must be", [[the string '\x1b[2J\x07']])
  local _, message = pcall(function() sg.neo_hookean{ E = ("é"):rep(100000), nu = 0 } end)
  check.at_most("length of the message", #message, 600)
  check.equal(utf8.len(message) ~= nil, true)
  _, message = pcall(function() sg.nurbs.read(("x"):rep(100000)) end)
  check.at_most("length of the message", #message, 4100)
  check.fails(function() sg.neo_hookean{ E = setmetatable({}, { __name = "" }), nu = 0 } end, "got a table")
end)

check.case("counts have limits where the work grows with their power", function()
  check.fails(function()
    sg.shapes.spherical_indenter{ width = 1, depth = 1, height = 1, radius = 1, elements = 1 << 53 }
  end, "elements must be a whole number from 1 to 200")
end)

check.case("large integers are numbers, whose products do not overflow", function()
  local _, _, exact = sg.scenes.hertz{ load = math.maxinteger }
  check.within_share("half-width", exact.a, math.sqrt(4 * 2.0 ^ 63 * 0.91 / math.pi), 1e-12)
  _, _, exact = sg.scenes.hertz{ load = 1e308 }
  check.within_share("pressure", exact.p0, math.sqrt(1e308 / (math.pi * 0.91)), 1e-12) -- Johnson, 4.44
end)

check.case("tables with a length of their own are described", function()
  local odd = setmetatable({}, { __len = function() return "x" end })
  check.fails(function() sg.rigid.surface(odd) end, "odd_values_test.lua", "must be a patch")
  check.fails(function() sg.neo_hookean{ E = odd, nu = 0 } end, "E must be a positive number")
end)

check.case("formats of a table are patterns", function()
  local columns = { columns = { "x" }, rows = { { 1 } } }
  for _, wrong in ipairs{ 3, print, "%.3g" } do
    columns.formats = wrong
    check.fails(function() sg.table(columns) end, "odd_values_test.lua", "formats must be a table of patterns")
  end
  columns.formats = { x = 5 }
  check.fails(function() sg.table(columns) end, "formats.x must be a pattern", "got the number 5")
  columns.formats = setmetatable({}, { __index = function() return 5 end })
  check.equal(sg.table(columns), "x\n1")
end)

check.case("objects of the library in place of tables are errors of the function", function()
  local model = sg.scenes.hertz{}
  local profile = model:profile(model:contact_names()[1])
  local study = sg.study{ name = "odd", cases = { { a = 1 } }, run = function() return {} end }
  check.fails(function() sg.table{ columns = { "x" }, rows = profile } end, "sg.table: rows must be")
  check.fails(function() sg.body(study) end, "sg.body: ")
  check.fails(function() sg.model(study) end, "sg.model: ")
end)

check.case("a bar that hardly moves shows that years remain", function()
  local display = require "signorini.run.progress"(1)
  for _, part in ipairs{ 1e-30, 5e-324 } do check.equal(display:to_go(part), "years left") end
end)

check.case("damaged lists of ParaView and times of Slurm", function()
  local file = folder .. "/a.pvd"
  for _, times in ipairs{ { "x" }, { "nan" }, { "2", "1" } } do
    local lines = '<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1" byte_order="LittleEndian">\n'
    for _, time in ipairs(times) do
      lines = ('%s    <DataSet timestep="%s" part="0" file="a.vtu"/>\n'):format(lines, time)
    end
    core.write_file(file, lines)
    check.fails(function() sg.pvd(file, { resume = true }) end, "odd_values_test.lua", "a.pvd' is damaged: state ")
  end
  check.equal({ slurm.seconds "", slurm.seconds ":", slurm.seconds "1-" }, {})
  check.equal(slurm.seconds "1:30", 90)
end)
