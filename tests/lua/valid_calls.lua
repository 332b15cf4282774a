-- One valid call of each public function that takes arguments, with as many of them as go together;
-- wrong_calls_test.lua makes wrong ones from them.
--
-- A row: { page, { arguments }, names = of arguments by place, needs = named arguments that must not be missing,
-- free = tables whose keys are the user's own, called = the words of messages for an argument, right = patterns of
-- changes that leave a call right, such as "1%.x%.%d: nan" }.

local sg = require "signorini"

--- The rows; files are written into this folder.
return function(folder)
  local function file(name) return folder .. "/" .. name end
  local soft = sg.neo_hookean { E = 1, nu = 0.3 }
  local patch = sg.shapes.rectangle { width = 3, height = 1 }
  local block = sg.shapes.block { size = { 1, 1, 1 } }
  local line = sg.nurbs.line { from = { 0, 0 }, to = { 1, 0 } }
  local ring = sg.shapes.half_annulus { inner = 0.3, outer = 0.5, centre = { 0.75, 1.5 } }
  local die = sg.body { patch = ring, elements = { 6, 1 }, order = "N2", contact = "south", material = soft }
  local slab = sg.body { patch = patch, elements = { 8, 2 }, order = "N2", contact = "north", material = soft }
  local cube = sg.body { patch = block, elements = { 1, 1, 1 }, order = "N2", material = soft }
  local function scene()
    return { bodies = { die = die, slab = slab },
             supports = { bed = { on = slab:face "south", fix = "xy" },
                          grip = { on = { die:face "west", die:face "east" }, drive = "xy" } },
             loads = { push = { on = slab:face "east", traction = { 0, 0 } } },
             contacts = { interface = { slave = die:face "south", master = slab:face "north", penalty = 10, points = 4,
                                        friction = { mu = 0.2, penalty = 10 }, where = function() return true end } } }
  end
  local plane = sg.rigid.plane { point = { 0, 3 }, normal = { 0, -1 } }
  local film = { bodies = { slab = slab },
                 supports = { bed = { on = slab:face "south", fix = "xy" },
                              left = { on = slab:face "west", symmetry = true } },
                 contacts = { film = { slave = slab:face "north", master = plane,
                   adhesion = { hamaker = 0.1, r0 = 0.4 } } } }
  local turned = { bodies = { cube = cube }, supports = { bed = { on = cube:face "front", fix = "xyz" },
                   top = { on = cube:face "back", fix = "xyz", rotate = "z" } } }
  local model = sg.model(scene())
  local run = model:run { { name = "press", steps = 2, grip = { 0, -0.02 } } }
  local solid = sg.model(turned)
  model:save(file "model.sgn")
  local frame = sg.frame { model = model, field = "uy" }
  local found = model:profile "interface"
  local profile = { x = found.x, pressure = found.pressure, gap = found.gap }
  local cases = sg.grid { order = { "N2", "N4" }, mesh = { 1, 2 } }
  local study = sg.study { name = "calls", folder = file "calls", cases = cases,
                           run = function(case) return { error = 1 / case.mesh, time = case.mesh, failed = false } end }
  study:execute { jobs = 1 }
  local function mapped(extra)
    local options = { name = "calls", x = { name = "a", values = { 1, 2 } }, y = { name = "b", values = { 1, 2 } },
                      jobs = 1, scene = function() return sg.model(turned) end,
                      path = function() return { { steps = 1, top = { 1 } } } end }
    for key, value in pairs(extra or {}) do options[key] = value end
    return options
  end
  local map = sg.stability_map(mapped())
  local data = { columns = { "step", "fx" }, rows = { { 1, 0.2 }, { 2, 0.3 } }, comments = { "made up" } }
  sg.csv.write(file "data.csv", data)
  local table_ = sg.csv.read(file "data.csv")
  local text_patch = file "patch.txt"
  sg.nurbs.write(text_patch, patch)
  local series = sg.pvd(file "first.pvd")
  local time = 0

  return {
    -- Shapes and patches
    { "sg.shapes.block", { { size = { 6, 4, 2 }, corner = { 0, 0, 0 } } }, needs = "size" },
    { "sg.shapes.half_annulus", { { inner = 0.3, outer = 0.5, centre = { 0.75, 1.5 } } }, needs = "inner outer" },
    { "sg.shapes.half_cylinder_shell", { { inner = 0.3, outer = 0.5, width = 2, centre = { 0, 0, 0 } } },
      needs = "inner outer width" },
    { "sg.shapes.hollow_hemisphere", { { inner = 0.5, outer = 1, centre = { 0, 0, 3 }, poles = "bottom" } },
      needs = "inner outer" },
    { "sg.shapes.quarter_annulus", { { inner = 0.5, outer = 1, start = 0, centre = { 0, 0 } } },
      needs = "inner outer" },
    { "sg.shapes.rectangle", { { width = 3, height = 1, corner = { 0, 0 } } }, needs = "width height" },
    { "sg.shapes.sphere_octant", { { inner = 0.5, outer = 1, centre = { 0, 0, 0 } } }, needs = "inner outer" },
    { "sg.shapes.spherical_indenter", { { width = 1, depth = 1, height = 0.6, radius = 2, elements = 4, corner = { 0,
      0, 0 } } },
      needs = "width depth height radius elements" },
    { "sg.nurbs.arc", { { radius = 0.5, from = 180, to = 360, centre = { 0, 0 } } }, needs = "radius from to" },
    { "sg.nurbs.circle", { { radius = 2, centre = { 0, 0 } } }, needs = "radius" },
    { "sg.nurbs.coons", { { west = patch:face "west", east = patch:face "east", south = patch:face "south",
      north = patch:face "north" } },
      needs = "west east south north" },
    { "sg.nurbs.curve", { { degree = 2, knots = { 0, 0, 0, 1, 1, 1 }, points = { { 0, 0 }, { 1, 2 }, { 2, 0 } },
      weights = { 1, 1, 1 } } },
      needs = "degree knots points" },
    { "sg.nurbs.extrude", { { patch = line, along = { 0, 2 } } }, needs = "patch along" },
    { "sg.nurbs.line", { { from = { 0, 0 }, to = { 3, 0 } } }, needs = "from to" },
    { "sg.nurbs.read", { text_patch }, names = "file" },
    { "sg.nurbs.revolve", { { patch = sg.nurbs.line { from = { 1, 0, 0 }, to = { 2, 0, 0 } }, point = { 0, 0, 0 },
      axis = { 0, 0, 1 }, angle = 90 } },
      needs = "patch" },
    { "sg.nurbs.ruled", { { a = sg.nurbs.circle { radius = 2 }, b = sg.nurbs.circle { radius = 1 } } }, needs = "a b" },
    { "sg.nurbs.surface", { { degrees = { 1, 1 }, knots = { { 0, 0, 1, 1 }, { 0, 0, 1, 1 } },
      points = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 } }, weights = { 1, 1, 1, 1 } } },
      needs = "degrees knots points" },
    { "sg.nurbs.volume", { { degrees = { 1, 1, 1 }, knots = { { 0, 0, 1, 1 }, { 0, 0, 1, 1 }, { 0, 0, 1, 1 } },
      points = block:points() } },
      needs = "degrees knots points" },
    { "sg.nurbs.write", { file "w.txt", { patch, patch }, "geopdes" }, names = "file patches form" },
    { "patch:basis", { patch, { 0.5, 0.5 } }, names = "patch:basis xi" },
    { "patch:degrees", { patch }, names = "patch:degrees" },
    { "patch:derivatives", { patch, { 0.5, 0.5 }, 2 }, names = "patch:derivatives xi n" },
    { "patch:elevate", { patch, 1, 2 }, names = "patch:elevate dir times" },
    { "patch:evaluate", { patch, { 0.5, 0.5 } }, names = "patch:evaluate xi" },
    { "patch:face", { patch, "south" }, names = "patch:face name" },
    { "patch:insert", { patch, 1, { 0.25, 0.5 } }, names = "patch:insert dir knots" },
    { "patch:knots", { patch, 1 }, names = "patch:knots dir" },
    { "patch:mirror", { block, { normal = { 1, 0, 0 }, point = { 0, 0, 0 } } }, names = "patch:mirror named",
      needs = "normal" },
    { "patch:reverse", { patch, 2 }, names = "patch:reverse dir" },
    { "patch:to_space", { patch, { z = 2 } }, names = "patch:to_space named" },
    { "patch:swap", { patch, 1, 2 }, names = "patch:swap i j" },
    { "patch:refine", { patch, { elements = { 8, 3 }, degree = { 2, 2 }, grading = { false, { elements = 0.5,
      length = 0.1, at = "end" } } } },
      names = "patch:refine named" },
    { "patch:rotate", { block, { angle = 90, axis = { 0, 0, 1 }, centre = { 0, 0, 0 } } },
      names = "patch:rotate named", needs = "angle axis" },
    { "patch:scale", { patch, { factor = 2, centre = { 0, 0 } } }, names = "patch:scale named", needs = "factor" },
    { "patch:translate", { patch, { 1, 2 } }, names = "patch:translate by" },
    { "patch:write", { patch, file "p.xml", "gismo" }, names = "patch:write file form" },
    -- Materials, bodies, obstacles
    { "sg.neo_hookean", { { E = 1, nu = 0.3 } }, needs = "E nu" },
    { "sg.linear_elastic", { { E = 1, nu = 0.3 } }, needs = "E nu" },
    { "sg.body", { { patch = patch, elements = { 8, 3 }, order = "N2-N2.2", contact = "north", material = soft,
      through = 2,
      grading = { false, { elements = 0.5, length = 0.1, at = "start" } } } },
      needs = "patch elements order material" },
    { "body:corner", { slab, "south-west" }, names = "body:corner name" },
    { "body:dofs", { slab }, names = "body:dofs" },
    { "body:edge", { cube, "south-front" }, names = "body:edge name" },
    { "body:face", { slab, "south" }, names = "body:face name" },
    { "sg.rigid.cylinder", { { centre = { 0, 0, 2 }, axis = { 0, 1, 0 }, radius = 1 } }, needs = "centre axis radius" },
    { "sg.rigid.plane", { { point = { 0, -1 }, normal = { 0, 1 } } }, needs = "point normal" },
    { "sg.rigid.sphere", { { centre = { 0, 0, 2 }, radius = 1 } }, needs = "centre radius" },
    { "sg.rigid.surface", { line }, names = "patch" },
    -- Models and load paths
    { "sg.model", { scene() }, needs = "bodies", free = "bodies supports loads contacts" },
    { "sg.model", { film }, needs = "bodies", free = "bodies supports contacts" },
    { "sg.model", { turned }, needs = "bodies", free = "bodies supports" },
    { "model:run", { model, { { name = "press", steps = 1, grip = { 0, -0.03 } } },
      { newton = { tolerance = 1e-10, iterations = 25, line_search = "none", freeze_active_set = false },
        linear = "auto",
        step = { adaptive = true, min = 1 / 64, max = 1, growth = 2 }, rescue = false, predictor = "tangent",
        threads = 1,
        penalty = { start = 0.5, steps = 2 }, arc_length = false, on_step = function() end,
        on_iteration = function() end,
        checkpoint = { file = file "run.sgn", every = 10, durable = false }, resume = false } },
        names = "model:run stages options",
      called = { stages = "stage" }, right = { "3%.checkpoint: the string" } },
    { "sg.robust", { { arc_length = true, step = { adaptive = true, min = 1 / 256 } } },
      right = { "1%.arc_length: [^a]", "1%.arc_length: a function", "1%.step: [^a]",
      "1%.step: a function", "1%.step%." } }, -- model:run looks into the values
    { "sg.plain", { { arc_length = true, newton = { iterations = 50 } } },
      right = { "1%.arc_length: [^a]", "1%.arc_length: a function", "1%.newton: [^a]",
      "1%.newton: a function", "1%.newton%." } }, -- as sg.robust
    { "model:diagnose", { solid, { "step", "damping" } }, names = "model:diagnose on",
      before = function()
        solid:set_target("top", { 60 })
        solid:solve_step { iterations = 1 }
      end },
    { "run:attempts", { run, 1 }, names = "run:attempts step" },
    { "run:column", { run, "grip.fy" }, names = "run:column column" },
    { "run:csv", { run, file "run.csv" }, names = "run:csv file" },
    { "run:residuals", { run, 1 }, names = "run:residuals step" },
    { "model:move", { solid, solid:displacements() }, names = "model:move du" },
    { "model:save", { model, file "m.sgn" }, names = "model:save path" },
    { "sg.load", { file "model.sgn" }, names = "path" },
    -- Results of a model
    { "model:profile", { model, "interface" }, names = "model:profile contact" },
    { "model:sample", { model, "slab", "uy", { 0.5, 0.5 } }, names = "model:sample body field xi" },
    { "model:reaction", { model, "bed" }, names = "model:reaction name" },
    { "model:contact_resultant", { model, "interface" }, names = "model:contact_resultant contact" },
    { "sg.profile_error", { { profile = profile, reference = profile, coordinate = "x", value = "pressure",
      normalise = 2,
      quadrature = "profile", zone = "either", edge = "gap" } }, needs = "profile reference",
      free = "profile reference" },
    { "sg.profile_edges", { { profile = profile, coordinate = "x" } }, needs = "profile", free = "profile" },
    -- Small verbs
    { "model:body", { model, "slab" }, names = "model:body name" },
    { "model:driven", { model, "grip" }, names = "model:driven name" },
    { "model:target", { model, "grip" }, names = "model:target name" },
    { "model:set_target", { model, "grip", { 0, -0.02 } }, names = "model:set_target name target" },
    { "model:set_penalty_factor", { model, 1 }, names = "model:set_penalty_factor factor" },
    { "model:restore", { model, model:snapshot() }, names = "model:restore snapshot" },
    { "model:time_search", { model, true }, names = "model:time_search wanted" },
    { "model:solve_step", { model, { tolerance = 1e-10, iterations = 25, line_search = "none", linear = "auto",
      predictor = "tangent",
      freeze_active_set = 0, active_set_changes = 0, damping = false } }, names = "model:solve_step named" },
    { "model:solve_step", { sg.model(scene()), { augmented = { penetration = 1e-3, loops = 10 } } },
      names = "model:solve_step named" },
    { "model:iterate", { model, { tolerance = 1e-10, iterations = 25 } }, names = "model:iterate named" },
    { "model:solve_arc", { model, { length = 0.01, tolerance = 1e-10, iterations = 25, linear = "auto" } },
      names = "model:solve_arc named",
      needs = "length", before = function() model:rollback() model:set_target("grip", { 0, -0.03 }) end },
    { "model:rollback", { model }, names = "model:rollback" },
    -- Pictures and charts
    { "sg.picture", { { model = model, file = file "a.png", field = "uy", factor = 2, label = "u", title = "t",
      range = { 0, 1 },
      colormap = "viridis", size = { 300, 200 }, crop = { 0, 3, 0, 2 }, bodies = { "slab" }, deformed = true,
      undeformed = false,
      mesh = true, control_points = false, obstacles = true, mirror = "x", marks = { { x = { 1, 1 },
      text = "here" } }, unit = "mm", bar = true } },
      needs = "file", called = { bodies = "body" } },
    { "sg.picture", { { model = solid, file = file "b.png", field = "uz", camera = { from = { 1, -2, 1 }, up = { 0, 0,
      1 } },
      cut = { normal = "y", at = 0.5 }, size = 200, ruler = true } }, needs = "file",
      right = { "1%.cut: the string" } },
    { "sg.picture", { { frames = { frame, frame }, columns = 2, file = file "c.png" } }, needs = "file" },
    { "sg.frame", { { model = model, title = "t", field = "uy", factor = 1, bodies = { "slab" }, deformed = true,
      undeformed = false,
      mesh = true, control_points = false, obstacles = true, mirror = "x" } }, needs = "model",
      called = { bodies = "body" } },
    { "sg.chart", { { file = file "c.svg", x = { 1, 2, 3 }, { y = { 1, 4, 9 }, label = "a", markers = true,
      arrows = true, dashed = false, line = true,
      width = 3, color = 1, marker = "circle" }, xlabel = "x", ylabel = "y", log = "y", title = "t", legend = true,
      xrange = { 1, 3 },
      yrange = { 1, 10 }, xticks = { { 1, "m1" } }, hlines = { { 2, "two" } }, vlines = { { 2, "two" } }, size = { 400,
      300 } } },
      needs = "file", right = { "1%.1%.y%.%d: nan", "1%.x%.%d: nan", "1%.1%.y%.%d: infinity",
                "1%.x%.%d: infinity", "1%.[hv]lines%.1: the number" } },
    { "sg.heatmap", { { file = file "h.svg", x = { "N2", "N4" }, y = { 10, 20 }, values = { { 0.3, 0.1 }, { 0.2,
      0.05 } }, label = "l",
      texts = { { "a", "b" }, { "c", "d" } }, xlabel = "x", ylabel = "y", title = "t", range = { 0, 1 }, log = false,
      colormap = "viridis", size = { 400, 300 } } }, needs = "file x y values",
      right = { "1%.texts%.%d.%d: the number", "1%.values%.%d.%d: nan", "1%.values%.%d.%d: infinity",
                "1%.[xy]%.%d: the" } },
    -- Studies
    { "sg.study", { { name = "a", folder = file "a", cases = { { a = 1 } }, run = function() return {} end,
      units = { a = "m" },
      alone = false, inputs = { 1 } } }, needs = "name cases run", free = "cases units inputs",
      right = { "1%.alone: a function", "1%.cases%.1%.a: the string", "1%.cases%.1%.a: true",
      "1%.cases%.1%.a: a misspelt", "1%.inputs", "1%.units%.a: the string" } },
    { "sg.grid", { { order = { "N2", "N4" } } }, names = "table", free_first = true,
      right = { "1%.order%.%d: the", "1%.order%.%d: true" } },
    { "study:by", { study, "order" }, names = "study:by argument" },
    { "study:column", { study, "error" }, names = "study:column argument" },
    { "study:csv", { study, file "s.csv", { columns = { "order", "error" }, sort = "error" } },
      names = "study:csv file named" },
    { "study:chart", { study, { x = "mesh", y = "error", series = "order", file = file "s.svg", markers = true,
      dashed = false, line = true,
      width = 3, xlabel = "x", ylabel = "y", log = "y", title = "t", legend = true, xrange = { 1, 2 }, yrange = { 0.1,
      2 },
      size = { 400, 300 } } }, names = "study:chart named", needs = "x y file", right = { "2%.[xy]: a function",
      "2%.series: a function" } },
    { "study:heatmap", { study, { x = "order", y = "mesh", value = "error", file = file "h2.svg", texts = true,
      xlabel = "x", ylabel = "y",
      title = "t", label = "l", range = { 0, 1 }, log = false, colormap = "viridis", size = { 400, 300 } } },
      names = "study:heatmap named",
      needs = "x y value file" },
    { "study:median", { study, "order" }, names = "study:median argument" },
    { "study:row", { study, { order = "N2", mesh = 1 } }, names = "study:row table", free_first = true,
      right = { "2: a function" } },
    { "study:table", { study, { columns = { "order", "error" }, sort = "error", formats = { error = "%.2f" } } },
      names = "study:table named",
      free = "formats" },
    { "study:where", { study, { order = "N2", mesh = { 1 } } }, names = "study:where table", free_first = true,
      right = { "2: a function", "2%.order: ", "2%.mesh" } },
    { "study:with", { study, "twice", function(row) return 2 * row.error end, "m" },
      names = "study:with name function unit" },
    { "study:execute", { study, { jobs = 1, limit = 100, again = false } }, names = "study:execute named",
      right = { "2%.again: a function" } },
    { "study:read", { study }, names = "study:read" },
    { "sg.work_precision", { study, { error = "error", time = "time", series = "order",
      where = function() return true end, at = { 0.5 },
      file = file "wp.svg", title = "t", xlabel = "x", ylabel = "y", size = { 400, 300 } } }, names = "study named",
      needs = "error" },
    { "sg.cheapest", { study, { error = "error", at_most = 1, cost = "time", where = function() return true end } },
      names = "study named",
      needs = "error at_most", right = { "2%.at_most: the number 0", "2%.error: a function", "2%.cost: a function" } },
    { "sg.recommend", { { scene = function(order, mesh)
        local plate = sg.body { patch = sg.shapes.rectangle { width = 1, height = 1 }, elements = { mesh, mesh },
                                order = order, material = sg.linear_elastic { E = 1, nu = 0.3 } }
        return sg.model { bodies = { plate = plate }, supports = { bed = { on = plate:face "south", fix = "xy" } } },
          { { steps = 1 } }
      end,
      error = function() return 1 end, at_most = 0.1,
      labels = { "N2" }, meshes = { 1, 2, 4 }, limit = 100 } }, needs = "scene error at_most",
      right = { "1%.labels%.1", "1%.meshes%.%d" } },
    { "sg.stability_map", { mapped { limit = 100, figures = function() return { one = 1 } end } },
      needs = "x y scene path",
      right = { "1%.[xy]%.values%.%d: the string" } },
    { "map:cell", { map, 1, 2 }, names = "map:cell x y" },
    { "map:compare", { map, map }, names = "map:compare argument" },
    { "map:csv", { map, file "map.csv" }, names = "map:csv file" },
    { "map:figure", { map, { name = "iterations", file = file "m.svg", log = false, label = "l", title = "t",
      range = { 0, 9 },
      colormap = "viridis", size = { 400, 300 } } }, names = "map:figure named", needs = "name file" },
    { "map:picture", { map, { file = file "m2.svg", title = "t", text = "reached", size = { 400, 300 } } },
      names = "map:picture named",
      needs = "file" },
    { "map:held", { map }, names = "map:held" },
    -- Tables, files, scripts
    { "sg.arguments", { { steps = { 10, at_least = 1, at_most = 20 }, label = { "a", choices = { "a", "b" } } },
      { "steps=3" } },
      names = "defaults words", free_first = true, called = { at_most = "steps" },
      right = { "1%.label: ", "1%.steps: ", "1%.steps%.1: the number 1.5" } },
    { "sg.files", { file "out" }, names = "argument", right = { "1: the string" } },
    { "files:draw", { sg.files(file "out"), "a.png", "luck", function() return false end },
      names = "files:draw name need body",
      right = { "3: the string" } },
    { "sg.mkdir", { file "made" }, names = "path" },
    { "sg.table", { { columns = { "a", "b" }, rows = { { 1, 2 } }, units = { "m", "s" }, formats = { a = "%.2f" } } },
      needs = "columns rows", free = "formats", right = { "1%.columns%.%d: the string", "1%.rows%.%d+%.%d+" } },
    { "sg.csv.read", { file "data.csv" }, names = "file" },
    { "sg.csv.write", { file "w.csv", data }, names = "file argument",
      called = { rows = "row" }, right = { "2%.columns%.%d: the string", "2%.rows%.%d%.%d: t" } },
    { "sg.reference", { "ironing2d_oscillation_table7_3" }, names = "name" },
    { "data:by", { table_, "step" }, names = "data:by column" },
    { "data:column", { table_, "step" }, names = "data:column column" },
    { "sg.vtu", { { model = model, file = file "a.vtu", deformed = true } }, needs = "model file" },
    { "sg.pvd", { file "a.pvd", { resume = false } }, names = "file named" },
    { "series:add", { series, { model = model, time = 1, deformed = true } }, names = "series:add named",
      needs = "model time",
      before = function(arguments) time = time + 1 arguments[2].time = time end },
    { "sg.median", { { 1, 2, 3 } }, names = "its" },
  }
end
