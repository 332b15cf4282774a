-- Saved models of every kind continue in another process with bitwise identical results.

require "check"
local ironing = require "ironing"

local file = check.file()

--- Everything that a state and a run show, bit by bit; defined by its text, for the other process has to have it, too.
local digest_code = [[
return function(model, run)
  local parts = {}
  local function add(value)
    if type(value) == "table" then
      local keys = {}
      for key in pairs(value) do keys[#keys + 1] = key end
      table.sort(keys)
      for _, key in ipairs(keys) do parts[#parts + 1] = tostring(key) add(value[key]) end
    else
      parts[#parts + 1] = math.type(value) == "float" and ("%a"):format(value) or tostring(value)
    end
  end
  for _, name in ipairs(run:columns()) do
    if name ~= "wall" then add(run:column(name)) end
  end
  for step = 1, run.steps do add(run:residuals(step)) end
  for _, name in ipairs(model:contact_names()) do add(model:profile(name)) end
  for _, name in ipairs(model:body_names()) do
    for _, xi in ipairs { 0.1, 0.5, 0.8 } do
      for _, field in ipairs { "ux", "uy", "von_mises" } do
        local ok, value = pcall(model.sample, model, name, field, { xi, 0.3 })
        add(ok and value or model:sample(name, field, { xi, 0.3, 0.4 }))
      end
    end
  end
  add(model:energy())
  return table.concat(parts, " ")
end
]]
local digest = load(digest_code)()

--- Takes the model along the first stages, saves it, and goes on here and in another process.
local function continues(model, before, after, options)
  check.completed(model:run(before, options))
  model:save(file)
  local code = ("local digest = (function() %s end)()\nlocal model = sg.load(arg[1])\n"
    .. "local run = model:run(%s, %s)\nio.write(digest(model, run))"):format(digest_code, after,
      options and "{ linear = '" .. options.linear .. "' }" or "nil")
  local output, status = check.script("local sg = require 'signorini'\nrequire('signorini.core').quiet = true\n"
    .. code, file)
  local run = check.completed(model:run(load("return " .. after)(), options))
  check.equal(status, 0)
  if output ~= digest(model, run) then
    local here, there = digest(model, run), output
    local at = 1
    while here:byte(at) == there:byte(at) do at = at + 1 end
    error(("they differ at character %d of %d: '%s', '%s'"):format(at, #here, here:sub(at - 20, at + 60),
      there:sub(at - 20, at + 60)))
  end
  return run
end

check.case("frictional ironing in the plane, KLU", function()
  local model = ironing{ order = "N2-N2.2" }
  continues(model, { { steps = 10, grip = {0, -0.15} } }, "{ { steps = 15, grip = {0.3, -0.15} } }")
  check.equal(model:solver().linear, "klu")
end)

check.case("contact points that follow the border of the contact", function()
  local model = ironing{ elements = { die = {24, 2}, slab = {24, 4} }, points = "auto" }
  continues(model, { { steps = 8, grip = {0, -0.15} } }, "{ { steps = 10, grip = {0.2, -0.15} } }")
  check.at_most("points that act", #model:profile("interface").pressure, 24 * 9 - 1)
end)

check.case("a larger one: UMFPACK, and a reused factorization", function()
  for linear, kind in pairs { umfpack = "umfpack", auto = "reuse" } do
    local model = ironing{ elements = { die = {24, 4}, slab = {72, 18} } }
    continues(model, { { steps = 4, grip = {0, -0.08} } }, "{ { steps = 3, grip = {0.06, -0.08} } }",
      { linear = linear })
    check.equal(model:solver().linear, kind)
  end
end)

check.case("peeling, adhesion on a part of the face, rotating support: reused factorization and KLU", function()
  for _, linear in ipairs { "auto", "klu" } do
    local strip = scenes.body{ size = {60, 10}, elements = {48, 4}, order = "N2-N2.1", contact = "south", E = 2,
      nu = 0.2 }
    local model = scenes.model{ bodies = { strip = strip },
      supports = { edge = { on = "east", rotate = true }, pin = { on = "south-west", fix = "x" } },
      contacts = { film = { slave = "south", master = scenes.floor(-0.25), adhesion = { hamaker = 0.1, r0 = 0.4 },
        where = function(X) return X[1] <= 45 end } } }
    continues(model, { { steps = 12, edge = 6 } }, "{ { steps = 8, edge = 10 } }", { linear = linear })
    check.equal(model:solver().linear, linear == "auto" and "reuse" or linear)
  end
end)

check.case("linear elastic bodies, condensed onto the contact", function()
  local rigid = sg.rigid.cylinder{ center = {0, 1.4}, radius = 0.4 }
  local model = scenes.model{
    bodies = { slab = { size = {4, 1}, corner = {-2, 0}, elements = {32, 8}, order = "N2-N2.1", contact = "north",
        thickness_degree = 1, material = sg.linear_elastic{ E = 10, nu = 0.3 } } },
    supports = { bed = { on = "south", fix = "xy" }, roll = { on = rigid, drive = "xy" } },
    contacts = { rub = { slave = "north", master = rigid, penalty = 500, friction = { mu = 0.3, penalty = 500 } } } }
  continues(model, { { steps = 6, roll = {0, -0.1} } }, "{ { steps = 8, roll = {0.8, -0.1} } }")
  check.equal(model:solver().linear, "condensed")
end)

check.case("a driven rigid NURBS obstacle, loads, a deep layer", function()
  local rigid = sg.rigid.surface(sg.nurbs.arc{ center = {0, 1.5}, radius = 0.5, from = -180, to = 0 })
  local model = scenes.model{
    bodies = {
      slab = { size = {4, 1}, corner = {-2, 0}, elements = {20, 4}, order = "N2-N2.2x2", contact = "north", E = 10 } },
    supports = { bed = { on = "south", fix = "xy" }, roll = { on = rigid, drive = "xy" } },
    loads = { wind = { on = "west", traction = {0.1, 0} }, gas = { on = "east", pressure = 0.2 } },
    contacts = { rub = { slave = "north", master = rigid, penalty = 500, friction = { mu = 0.3, penalty = 500 } } } }
  continues(model, { { steps = 6, roll = {0, -0.1}, wind = {0.2, 0.1} } },
    "{ { steps = 8, roll = {0.3, -0.1}, gas = 0.5 }, { steps = 2, wind = {0, 0} } }")
end)

check.case("a body of revolution", function()
  local ball = sg.rigid.sphere{ center = {0, 2}, radius = 1 }
  local model = scenes.model{ kind = "axisymmetric",
    bodies = { disc = { size = {2, 1}, elements = {16, 4}, order = "N2-N2.1", contact = "north" } },
    supports = { axis = { on = "west", fix = "x" }, bed = { on = "south", fix = "xy" },
      ball = { on = ball, drive = "y" } },
    contacts = { touch = { slave = "north", master = ball, penalty = 100, friction = { mu = 0.2, penalty = 100 } } } }
  continues(model, { { steps = 5, ball = -0.1 } }, "{ { steps = 5, ball = -0.2 } }")
end)

check.case("classical elements", function()
  continues(ironing{ order = "L2" }, { { steps = 10, grip = {0, -0.1} } }, "{ { steps = 6, grip = {0.1, -0.1} } }")
end)

--- An indenter on a slab in space, to be pressed, dragged, turned.
local function solids(slab_elements, rotate)
  local cap = sg.shapes.spherical_indenter{ width = 1, depth = 1, height = 0.8, radius = 1.2, elements = 1,
                                            corner = {0.6, 0.5, 1} }
  return scenes.model{ bodies = { block = { patch = cap, elements = {3, 3, 2}, contact = "front", E = 5 },
      slab = { size = {3, 2, 1}, elements = slab_elements, contact = "back" } },
    supports = { bed = { on = "slab.front", fix = "xyz" },
      grip = { on = "block.back", drive = "xyz", rotate = rotate } },
    contacts = { touch = { slave = "block.front", master = "slab.back", penalty = 50, points = 4,
        friction = { mu = 0.3, penalty = 50 } } } }
end

check.case("solids, after the solver has changed to a reused factorization", function()
  local model = solids({15, 10, 4})
  continues(model, { { steps = 2, grip = {0, 0, -0.08} } }, "{ { steps = 2, grip = {0.1, 0, -0.08} } }")
  check.equal(model:solver().linear, "reuse")
end)

check.case("small rotating solids: KLU and a reused factorization", function()
  for _, linear in ipairs { "auto", "reuse" } do
    continues(solids({6, 4, 2}, "z"), { { steps = 3, grip = {0, 0, -0.1, 0} } },
      "{ { steps = 4, grip = {0, 0, -0.1, 20} } }", { linear = linear })
  end
end)

check.case("a loaded model names its parts, and can be saved again", function()
  local model = ironing()
  model:run{ { steps = 3, grip = {0, -0.06} } }
  model:save(file)
  local again = sg.load(file)
  check.equal(tostring(again), tostring(model))
  check.equal(again:target "grip", { 0, -0.06 })
  again:save(file)
  check.equal(sg.load(file):reaction "grip", model:reaction "grip")
  check.equal(again:body("die"):dofs(), model:body("die"):dofs())
end)

check.case("invalid files are errors at the user's line, with a hint", function()
  local model = ironing()
  model:run{ { steps = 1, grip = {0, -0.06} } }
  model:save(file)
  local good = core.read_file(file)
  local function write(bytes) core.write_file(file, bytes) end
  local function refused(...)
    check.fails(function() sg.load(file) end, "checkpoint_test.lua:", "sg.load: ", file, ...)
  end
  write "{ \"a\": 1 }"
  refused "is not a checkpoint written by signorini"
  write(good:sub(1, -100))
  refused("is damaged: it is truncated after", "use an older copy")
  for _, at in ipairs { 60, #good // 2, #good } do
    write(good:sub(1, at - 1) .. string.char(good:byte(at) ~ 16) .. good:sub(at + 1))
    refused "is damaged: its checksum is wrong"
  end
  write(good:gsub("^(SIGNORINI checkpoint\n)\13", "%1\14"))
  refused "was written by a newer version of the program, in format 14; this one reads formats up to 13"
  os.remove(file)
  refused("cannot read", "No such file")
  check.fails(function() model:save "nowhere/at/all.sgn" end, "checkpoint_test.lua:",
    "model:save: cannot write 'nowhere/at/all.sgn'", "create it first")
  check.fails(function() model:save "/proc/a.sgn" end, "model:save: cannot write '/proc/a.sgn'",
    "choose a folder with write permission")
end)

check.case("a snapshot keeps its worth when the model is saved: points that were open touch again", function()
  for _, method in ipairs { "gpts", "mortar" } do
    local function lowered()
      local model = scenes.model{ bodies = { block = { size = {1, 0.5}, corner = {0, 0.1}, elements = {3, 1} } },
        supports = { grip = { on = "north", drive = "xy" } },
        contacts = { floor = { slave = "south", method = method, penalty = 20, master = scenes.floor() } } }
      check.completed(model:run({ { steps = 1, grip = {0.2, -0.05} } }))
      return model
    end
    local function pressed(model)
      check.completed(model:run({ { steps = 1, grip = {0.2, -0.2} } }))
      return model:reaction "grip".fy
    end
    local model = lowered()
    local snapshot = model:snapshot()
    model:save(file)
    model:restore(snapshot)
    local force = pressed(lowered())
    assert(force < -0.05, force)
    check.within(method, pressed(model), force, 1e-10)
  end
end)
