-- Layers that follow the contact: forces and energies next to the layer of the whole face, every contact method, 2D,
-- axisymmetric and 3D, resumed runs, states and pictures of runs, errors.

require "check"
local ironing = require "ironing"

local file = check.file()
local mesh = { die = { 6, 2 }, slab = { 24, 4 } }
local path = {
  { name = "press", steps = 6, grip = { 0, -0.12 } }, { name = "slide", steps = 20, grip = { 0.5, -0.12 } },
}

--- A coarse ironing problem with a layer.
local function make(o)
  o = o or {}
  return ironing{ order = o.order or "N2-N2.2", elements = mesh, points = o.points or 9, mu = o.mu,
                  enforcement = o.enforcement }
end

--- The largest difference of two columns, relative to the largest value of the second.
local function difference(run, other, name)
  local a, b, most, size = run:column(name), other:column(name), 0, 0
  for i = 1, #b do most, size = math.max(most, math.abs(a[i] - b[i])), math.max(size, math.abs(b[i])) end
  return most / size
end

local full = make()
local whole = full:run(path)

check.case("forces are those of the layer of the whole face, with fewer unknowns", function()
  local model = make()
  local run = check.completed(model:run(path, { adapt = {} }))
  assert(difference(run, whole, "grip.fx") < 2e-3, difference(run, whole, "grip.fx"))
  assert(difference(run, whole, "grip.fy") < 1e-3, difference(run, whole, "grip.fy"))
  assert(#run.adaptations >= 4, #run.adaptations)
  assert(model:solver().unknowns < 0.9 * full:solver().unknowns, model:solver().unknowns)
  local plain = make{ order = "N2" }:run(path) -- without a layer the difference is larger by far
  assert(difference(plain, whole, "grip.fx") > 20 * difference(run, whole, "grip.fx"))
  for _, change in ipairs(run.adaptations) do
    local jump = change.energy_after / change.energy_before - 1
    assert(math.abs(jump) < 1e-3, jump) -- of the order of the discretization's error
  end
end)

check.case("a resumed run ends as if it had not been interrupted", function()
  local options = { adapt = { margin = 1 }, checkpoint = file }
  local model = make()
  local run = model:run(path, options)
  for _, stop in ipairs { 3, 8, 15 } do
    os.remove(file)
    options.on_step = function(info) return info.step == stop and "stop" or nil end
    check.equal(make():run(path, options).reason, "stopped")
    options.on_step, options.resume = nil, true
    local other = make()
    local rest = other:run(path, options)
    options.resume = nil
    for _, name in ipairs(run:columns()) do
      if name ~= "wall" then check.equal(core.pack(rest:column(name)), core.pack(run:column(name))) end
    end
    check.equal(#rest.adaptations, #run.adaptations)
    check.equal(core.pack(other:profile "interface"), core.pack(model:profile "interface"))
    check.equal(core.pack(other:energy()), core.pack(model:energy()))
  end
  local loaded = sg.load(file)
  check.equal(core.pack(loaded:profile "interface"), core.pack(model:profile "interface"))
  check.equal(loaded:solver().unknowns, model:solver().unknowns)
end)

check.case("results, stored states and later runs have the new bodies", function()
  local model = make()
  local run = model:run(path, { adapt = {}, states = { 0, 10, 26 } })
  assert(tostring(model):find(("%d of them free"):format(model:solver().unknowns), 1, true), tostring(model))
  assert(model:body "slab":dofs().total < full:body "slab":dofs().total)
  for _, state in ipairs(run:states()) do assert(sg.picture{ state = state, field = "von_mises" }) end
  check.near(model:reaction "bed"[2], -model:reaction "grip"[2], 1e-8)
  check.completed(model:run({ { name = "back", steps = 4, grip = { 0.4, -0.12 } } }, { adapt = {} }))
end)

--- A stiff block whose lower face is drawn over a softer slab; `o`: contact (further keys), kind, size (3 in space).
local function blocks(o)
  local kind, space = o.kind, o.size == 3
  local function body(x, y, width, height, elements, face, E)
    local patch = space and sg.shapes.block{ size = { width, 1, height }, corner = { x, 0, y } }
      or sg.shapes.rectangle{ width = width, height = height, corner = { x, y } }
    return scenes.body{ patch = patch, elements = elements, order = o.order or "N2-N2.1", contact = face,
      thickness_degree = 1, E = E }
  end
  local die = body(kind == "axisymmetric" and 0 or 0.5, 1, 1, 0.4, space and { 3, 1, 1 } or { 3, 1 },
    space and "front" or "south", 20)
  local slab = body(0, 0, 4, 1, space and { 12, 2, 1 } or { 12, 2 }, space and "back" or "north", 1)
  local contact = { slave = die:face(space and "front" or "south"), master = slab:face(space and "back" or "north"),
                    points = 6, friction = { mu = 0.2 } }
  if not o.contact.enforcement then contact.penalty, contact.friction.penalty = 50, 50 end
  for key, value in pairs(o.contact) do contact[key] = value end
  if contact.friction == false then contact.friction = nil end
  if o.set then contact.among, contact.slave, contact.master = { contact.slave, contact.master }, nil, nil end
  return scenes.model{ bodies = { die = die, slab = slab }, kind = kind, contacts = { joint = contact },
    supports = { bed = { on = slab:face(space and "front" or "south"), fix = space and "xyz" or "xy" },
      grip = { on = die:face(space and "back" or "north"), drive = space and "xyz" or "xy" } } }
end

--- Presses and slides with the layer of the whole face and with one that follows; the difference of the forces.
local function compare(o, options)
  local space, sideways = o.size == 3, o.kind == "axisymmetric" and 0 or 1.2
  local function stage(name, steps, x, z)
    return { name = name, steps = steps, grip = space and { x, 0, z } or { x, z } }
  end
  local function solve(adapt)
    local model, all = blocks(o), { adapt = adapt }
    for key, value in pairs(options or {}) do all[key] = value end
    local run = check.completed(model:run({ stage("press", 3, 0, -0.06), stage("slide", 8, sideways, -0.06) }, all))
    return run, model
  end
  local with, model = solve { margin = 1 }
  assert(#with.adaptations > 0)
  return difference(with, solve(), space and "grip.fz" or "grip.fy"), model, with
end

check.case("every contact method; plane stress, axisymmetric bodies and solids", function()
  for _, one in ipairs {
    { contact = {} }, { contact = { method = "mortar" } },
    { contact = { method = "mortar", enforcement = "multipliers" } },
    { contact = { method = "mortar", multipliers = "reduced" } },
    { contact = { method = "half_passes" } },
    { contact = {}, kind = "plane_stress" }, { contact = { friction = false }, kind = "axisymmetric" },
    { contact = {}, set = true }, { contact = {}, set = true, size = 3 },
    { contact = {}, size = 3 }, { contact = { method = "mortar" }, size = 3 },
  } do
    local far = compare(one)
    assert(far < 0.03, far)
  end
end)

check.case("supports keep their control points where strips of both directions change", function()
  local function press(adapt)
    local slab = scenes.body{ size = { 1, 1, 0.5 }, elements = { 8, 8, 1 }, order = "N2-N3.1", contact = "back",
      thickness_degree = 2, layer = { { 0, 1 }, { 0, 0.12 } } }
    local tool = sg.rigid.cylinder{ center = { 0, 0, 0.7 }, radius = 0.2, axis = { 0, 1, 0 } }
    local model = scenes.model{ bodies = { slab = slab }, supports = {
        bed = { on = "front", fix = "xyz" }, sx = { on = "west", fix = "x" },
        sy = { on = "south", fix = "y" }, tool = { on = tool, drive = "z", fix = "xy" } },
      contacts = { c = { slave = "back", master = tool, penalty = 30, points = 4 } } }
    return model:run({ { name = "press", steps = 2, tool = { -0.03 } } }, { adapt = adapt })
  end
  local with, without = press { margin = 0 }, press()
  check.equal(#with.adaptations > 0, true)
  for _, name in ipairs { "tool.fz", "sx.fx", "sy.fy" } do
    check.within_share(name, with:column(name)[2], without:column(name)[2], 0.03)
  end
end)

check.case("a rolling disc: adaptations do no work on obstacles", function()
  local disc = sg.rigid.cylinder{ center = { 1, 1.4 }, radius = 0.4 }
  local model = scenes.model{
    bodies = { slab = { size = {3, 1}, elements = { 24, 4 }, order = "N2-N2.2", contact = "north" } },
    supports = { bed = { on = "south", fix = "xy" }, hub = { on = disc, drive = "xy", rotate = true, angle = "free" } },
    contacts = { c = { slave = "north", master = disc, penalty = 50, friction = { mu = 0.5, penalty = 50 } } } }
  local run = model:run({ { name = "press", steps = 4, hub = { 0, -0.05 } },
                          { name = "roll", steps = 20, hub = { 0.8, -0.05 } } }, { adapt = {} })
  local energy = model:energy()
  check.equal({ run.reason, #run.adaptations > 1 }, { "completed", true })
  check.equal(math.abs(energy.work - energy.stored - energy.contact - energy.friction) < 0.05 * energy.work, true)
end)

check.case("wrong options and scenes are errors", function()
  local function refused(model, options, part) check.fails(function() model:run(path, options) end, part) end
  refused(make{ order = "N2" }, { adapt = {} }, "no body has one")
  refused(make{ points = "auto" }, { adapt = {} }, "needs the same contact points in all steps")
  refused(make(), { adapt = { margin = -1 } }, "margin")
  refused(make(), { adapt = { every = 0 } }, "every")
  refused(make(), { adapt = { tolerance = 0 } }, "tolerance")
  refused(make(), { adapt = true }, "adapt")
  refused(make(), { adapt = { elements = 3 } }, "elements")
  refused(make(), { adapt = {}, hdf5 = "x.h5" }, "remove adapt or hdf5")
  local model = make()
  local run = model:run({ { steps = 2, grip = { 0, -0.04 } } })
  model:run({ { name = "on", steps = 2, grip = { 0, -0.08 } } }, { adapt = {} })
  check.fails(function() run:hdf5 "x.h5" end, "a later run with adapt has changed the control points")
  model = make()
  model:run({ { steps = 1, grip = { 0, -0.04 } } })
  model:set_contact("interface", { penalty = 50 })
  refused(model, { adapt = {} }, "Hint: change them in stages")
end)
