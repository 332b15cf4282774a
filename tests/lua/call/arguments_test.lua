-- sg.arguments: accepted types, rejections and their messages, variants, help; sg.files, sg.median, sg.wall_time.

require "check"

local function refused(defaults, word, message)
  local got = tostring(select(2, pcall(sg.arguments, defaults, { word })))
  check.equal(got, message)
end

check.case("defaults are as declared", function()
  local options = sg.arguments({ mesh = { "m1" }, sizes = { 1, 2 }, loads = { 0, 0.5 }, steps = 10, penalty = 100.0,
                                 keep = false, order = "N2", limit = { 1e5, above = 0 },
                                 fine = { {}, none = true } }, {})
  check.equal({ options.mesh, options.sizes, options.loads, options.fine }, { { "m1" }, { 1, 2 }, { 0, 0.5 }, {} })
  check.equal({ options.steps, options.penalty, options.keep, options.order, options.limit },
    { 10, 100.0, false, "N2", 1e5 })
end)

check.case("values of each type; of two the later counts", function()
  local defaults = { mesh = { "m1" }, sizes = { 1, 2 }, loads = { 0, 0.5 }, steps = 10, penalty = 100.0, keep = false,
                     order = "N2", fine = { { "N2" }, none = true }, flat_2 = true }
  local options = sg.arguments(defaults, {
    "steps=7", "mesh=m2,m3", "sizes=4", "loads=1e-3,2,-3", "steps=12", "keep=yes", "penalty=5", "order=a=b c",
    "fine=none", "flat_2=no",
  })
  check.equal({ options.mesh, options.sizes, options.loads, options.fine },
    { { "m2", "m3" }, { 4 }, { 1e-3, 2, -3 }, {} })
  check.equal({ options.steps, options.penalty, options.keep, options.order, options.flat_2 },
    { 12, 5, true, "a=b c", false })
  check.equal({ math.type(options.steps), math.type(options.sizes[1]) }, { "integer", "integer" })
  -- Numbers are never integers, whose products can overflow.
  check.equal({ math.type(options.penalty), math.type(options.loads[2]) }, { "float", "float" })
  check.equal({ sg.arguments(defaults, { "steps=1e2" }).steps, sg.arguments(defaults, { "mesh=m2,,m3," }).mesh },
    { 100, { "m2", "m3" } })
end)

check.case("changing a returned list does not change the default", function()
  local defaults = { mesh = { "m1" } }
  table.insert(sg.arguments(defaults, {}).mesh, "m2")
  check.equal(defaults.mesh, { "m1" })
end)

check.case("values of the wrong type", function()
  refused({ steps = 10 }, "steps=x", "steps must be a whole number, 1 or more, got 'x'")
  refused({ steps = 10 }, "steps=2.5", "steps must be a whole number, 1 or more, got '2.5'")
  refused({ steps = 10 }, "steps=0", "steps must be a whole number, 1 or more, got '0'")
  refused({ sizes = { 1, 2 } }, "sizes=1,x,3", "sizes must be whole numbers, 1 or more, got 'x' in '1,x,3'")
  refused({ penalty = 2.5 }, "penalty=stiff", "penalty must be a number, got 'stiff'")
  refused({ penalty = 2.5 }, "penalty=nan", "penalty must be a number, got 'nan'")
  refused({ penalty = 2.5 }, "penalty=1e999", "penalty must be a number, got '1e999'")
  refused({ loads = { 0, 0.5 } }, "loads=,", "loads must be numbers, got ','")
  refused({ loads = { 0, 0.5 } }, "loads=none", "loads must be numbers, got 'none'")
  refused({ keep = false }, "keep=maybe", "keep must be yes or no, got 'maybe'")
  refused({ keep = false }, "keep=true", "keep must be yes or no, got 'true'")
  refused({ order = "N2" }, "order=", "order must be a string, got nothing")
  refused({ orders = { "N2" } }, "orders=", "orders must be strings, got nothing")
end)

check.case("choices and limits", function()
  local load = { load = { "force", choices = { "force", "displacement" } } }
  check.equal(sg.arguments(load, { "load=displacement" }).load, "displacement")
  refused(load, "load=x", "load must be 'force' or 'displacement', got 'x'")
  refused(load, "load=forse", "load must be 'force' or 'displacement', got 'forse'; did you mean 'force'?")
  local meshes = { meshes = { { "m1" }, choices = { "m1", "m2", "m3" } } }
  check.equal(sg.arguments(meshes, { "meshes=m3,m1" }).meshes, { "m3", "m1" })
  refused(meshes, "meshes=m1,m9",
    "meshes must be values among 'm1', 'm2' and 'm3', got 'm9' in 'm1,m9'; did you mean 'm1'?")
  local dimensions = { dimensions = { { 2, 3 }, choices = { 2, 3 } } }
  check.equal(sg.arguments(dimensions, { "dimensions=3" }).dimensions, { 3 })
  refused(dimensions, "dimensions=4", "dimensions must be values among 2 and 3, got '4'")
  local limits = { every = { { 0, 10 }, at_least = 0 }, gap = { 5.0, at_least = 0, below = 10.4 },
                   share = { 0.5, above = 0, at_most = 1 }, fine = { { 1.5 }, above = 1e-6, none = true } }
  local options = sg.arguments(limits, { "every=0", "gap=0", "share=1" })
  check.equal({ options.every, options.gap, options.share }, { { 0 }, 0, 1 })
  refused(limits, "every=-1", "every must be whole numbers, 0 or more, got '-1'")
  refused(limits, "gap=10.4", "gap must be a number, 0 or more and below 10.4, got '10.4'")
  refused(limits, "share=0", "share must be a number above 0 and at most 1, got '0'")
  refused(limits, "share=1.1", "share must be a number above 0 and at most 1, got '1.1'")
  refused(limits, "fine=0", "fine must be numbers above 1e-06, or none, got '0'")
end)

check.case("checks of the script receive the value, or each entry, and all others", function()
  local function shorter(value, all) return value < all.length end
  local defaults = { length = 200.0, bonded = { 150.0, check = shorter, expected = "a length below that of the strip" },
                     rows = { { "1", "all" }, expected = "whole numbers, or all",
                              check = function(row) return row == "all" or math.tointeger(tonumber(row)) end } }
  check.equal(sg.arguments(defaults, { "bonded=250", "length=300", "rows=all,2" }).rows, { "all", "2" })
  refused(defaults, "bonded=200", "bonded must be a length below that of the strip, got '200'")
  refused(defaults, "length=100", "bonded must be a length below that of the strip, got '150'")
  refused(defaults, "rows=1,most", "rows must be whole numbers, or all, got 'most' in '1,most'")
end)

check.case("unknown names", function()
  local defaults = { meshes = { "m1", "m2" }, steps = 10, keep = true }
  local known = "known: keep=yes, meshes=m1,m2, steps=10"
  refused(defaults, "step=3", "unknown argument 'step=3'; did you mean 'steps'? " .. known)
  refused(defaults, "out=x", "unknown argument 'out=x'; " .. known)
  refused(defaults, "m1", "unknown argument 'm1': arguments look like name=value; " .. known)
  refused(defaults, "-q", "unknown argument '-q': arguments look like name=value; " .. known)
end)

local variants = {
  orders = { "N2" }, out = "out/a",
  variant = { "plain", variants = {
    plain = { ["repeat"] = 1, mesh = "m1" }, deep = { points = { 1, 2 }, out = "out/b" },
  } },
}

check.case("variants have their own arguments and defaults", function()
  local plain = sg.arguments(variants, { "repeat=2", "orders=N4" })
  check.equal({ plain.variant, plain["repeat"], plain.mesh, plain.orders, plain.out, plain.points },
    { "plain", 2, "m1", { "N4" }, "out/a" })
  local deep = sg.arguments(variants, { "points=3", "variant=deep" })
  check.equal({ deep.variant, deep.points, deep.orders, deep.out }, { "deep", { 3 }, { "N2" }, "out/b" })
  check.equal(deep["repeat"], nil)
  refused(variants, "variant=x", "variant must be 'plain' or 'deep', got 'x'")
  refused(variants, "points=3",
    "unknown argument 'points=3', which belongs to variant=deep; known with variant=plain: " ..
    "mesh=m1, orders=N2, out=out/a, repeat=1, variant=plain")
  refused(variants, "x=3",
    "unknown argument 'x=3'; known with variant=plain: mesh=m1, orders=N2, out=out/a, repeat=1, variant=plain")
end)

check.case("invalid declarations are errors at the script's line", function()
  for defaults, message in pairs {
    [{ load = { "x", choices = { "force" } } }] = "the default of load must be 'force', got the string 'x'",
    [{ offset = 0 }] = "the default of offset must be a whole number, 1 or more, got the number 0",
    [{ load = { "force", choice = { "force" } } }] = "sg.arguments: load: unknown argument 'choice'",
    [{ load = { "force", choices = { 1 } } }] = "load.choices[1] must be of the type of the default, got the number 1",
    [{ load = { choices = { "force" } } }] = "the default of load is missing",
    [{ mesh = { "m1", "m2", none = true } }] =
      "mesh has a list as default and restrictions. Hint: write { { m1, … }, … }",
    [{ mesh = { "m1", 2 } }] = "the default of mesh must be a string, a number, true, false, or a list",
    [{ scene = print }] = "the default of scene must be a string, a number",
    [{ order = { "N2", at_least = 1 } }] = "order.at_least is allowed only for numbers, and order is not a number",
    [{ a = {} }] =
      "the default of a is an empty table. Hint: write { {}, none = true } for a list of strings that may be empty",
    [{ order = { "N2", none = true } }] = "order.none is allowed only for lists",
    [{ order = { "N2", check = print } }] = "order needs both check, a function, and expected",
    [{ order = { "N2", check = 1, expected = "a" } }] = "order.check must be a function",
    [{ help = "a" }] = "the string 'help' cannot be the name of an argument",
    [{ "mesh" }] = "every entry of defaults needs a name, got the string 'mesh' without one",
    [{ variant = { "a", variants = { b = {} } } }] = "the default of variant must be 'b', got the string 'a'",
    [{ a = { "x", variants = { x = {} } }, b = { "y", variants = { y = {} } } }] = "both a and b have variants",
    [{ a = { "x", variants = { x = { a = 1 } } } }] = "the variant x has variants itself",
  } do
    local output = check.fails(function() sg.arguments(defaults, {}) end, "sg.arguments: ", message)
    check.holds(output, "arguments_test.lua:")
  end
end)

local script = [[
local sg = require "signorini"
local function read() return sg.arguments{ steps = 10, orders = { { "N2" }, choices = { "N2", "N4" } },
  variant = { "plain", variants = { plain = {}, deep = { depth = 0.5 } } } } end
print(read().steps)]]

check.case("a script reads the command line, and errors are one line without a traceback", function()
  check.equal({ check.script(script, "steps=3") }, { "3\n", 0 })
  check.equal({ check.script(script) }, { "10\n", 0 })
  check.equal({ check.script(script, "steps=x") },
    { "signorini: steps must be a whole number, 1 or more, got 'x'\n", 1 })
end)

check.case("help, or --help, prints all arguments with status 0", function()
  local page = [[
Arguments of study.lua, with their defaults:
  orders=N2      values among 'N2' and 'N4'
  steps=10       a whole number, 1 or more
  variant=plain  'plain' or 'deep'
with variant=plain also:
with variant=deep also:
  depth=0.5  a number
Separate several values by commas: a,b,c.
]]
  check.equal({ check.script(script, "help") }, { page, 0 })
  check.equal({ check.script(script, "steps=x", "--help") }, { page, 0 })
end)

check.case("a script that is called as a function, and a module that it requires, get the words of the call", function()
  local folder = check.folder()
  local function write(name, text) core.write_file(folder .. "/" .. name, text) end
  write("inner.lua", 'local options = require "reader" return options.steps')
  write("reader.lua", 'local o = require "signorini".arguments{ steps = 10 } return o')
  write("outer.lua", ('print(loadfile(%q)("steps=4"))'):format(folder .. "/inner.lua"))
  check.equal({ check.program { folder .. "/outer.lua", "steps=5" } }, { "4\n", 0 })
  check.equal({ check.program { folder .. "/inner.lua", "steps=z" } },
    { "signorini: steps must be a whole number, 1 or more, got 'z'\n", 1 })
end)

check.case("files: a folder, paths, omitted files, and the list at the end", function()
  local folder = check.folder()
  local files, lines, print_to_terminal = sg.files(folder .. "/deep"), {}, print
  print = function(line) lines[#lines + 1] = line end
  local ok, message = pcall(function()
    files:report()
    check.equal({ files "a.csv", files "b.csv", files "a.csv" },
      { folder .. "/deep/a.csv", folder .. "/deep/b.csv", folder .. "/deep/a.csv" })
    files:draw("c.png", "a step", function(path) return path == folder .. "/deep/c.png" end)
    files:draw("d.png", "a step", function() return false end)
    files:report()
  end)
  print = print_to_terminal
  if not ok then error(message, 0) end
  check.equal({ table.unpack(files) }, { folder .. "/deep/a.csv", folder .. "/deep/b.csv", folder .. "/deep/c.png" })
  check.equal(lines, { "d.png is left out: it needs a step",
    ("\nWritten: %s/deep/a.csv\n         %s/deep/b.csv\n         %s/deep/c.png"):format(folder, folder, folder) })
  check.equal(files.folder, folder .. "/deep")
  assert(io.open(folder .. "/deep/x", "w")):close() -- the folder is there
  check.fails(function() files(3) end, "sg.files: the name of a file must be a string, got the number 3")
  check.fails(function() sg.files(folder .. "/deep/x") end, "cannot create the folder")
end)

check.case("the median does not change the list", function()
  local list = { 5, 1, 3 }
  check.equal({ sg.median(list), sg.median { 4, 1, 3, 2 }, sg.median { 7 } }, { 3, 2.5, 7 })
  check.equal(list, { 5, 1, 3 })
  check.fails(function() sg.median {} end,
    "sg.median: numbers must be a list of at least one number, got an empty table")
end)

check.case("sg.wall_time counts seconds", function()
  local began = sg.wall_time()
  os.execute "sleep 0.02"
  local passed = sg.wall_time() - began
  check.equal(passed >= 0.02 and passed < 60, true)
end)
