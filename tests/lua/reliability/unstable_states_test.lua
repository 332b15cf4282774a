-- Stability of the states at the ends of stages: columns below and above their buckling loads, with every solver, with
-- contacts, multipliers and ties; states that are neutral, and one that is stable again after it has snapped.

require "check"

local nu, thickness, length, E = 0.3, 0.5, 5, 1

--- Euler's load per width of a column in plane strain that is clamped at one end, as a multiple n² of the load with the
--- other end free: P = n² π² E I / (4 (1 − ν²) L²).
local function euler(n) return n ^ 2 * math.pi ^ 2 * E * thickness ^ 3 / 12 / (4 * (1 - nu ^ 2) * length ^ 2) end

local function warned(run) return check.warnings(check.completed(run), "unstable")[1] end

--- Checks that a run, made for a multiple of the buckling load, warns above it and not below.
local function decides(label, run_at, options)
  local below, above = warned(run_at(0.9, options or {})), warned(run_at(1.1, options or {}))
  if below then error(label .. ", below: " .. below) end
  if not above then error(label .. ": no warning above the buckling load") end
  return above
end

local function column(o)
  return scenes.body{ size = {thickness, o.height or length}, corner = { 0, o.at or 0 },
    elements = { 1, o.elements or 10 }, contact = o.contact, E = E, nu = nu }
end

--- Under a dead load of its free end.
local function model_of_load()
  return scenes.model{ bodies = { column = column{} }, supports = { base = { on = "south", fix = "xy" } },
                       loads = { p = { on = "north", traction = { 0, 0 } } } }
end

local function loaded(times, options)
  return model_of_load():run({ { name = "press", steps = 2, p = { 0, -times * euler(1) / thickness } } }, options)
end

check.case("a column under a dead load is unstable beyond Euler's, with every solver", function()
  for _, linear in ipairs { "auto", "klu", "umfpack", "reuse", core.mumps and "mumps" or nil } do
    local text = decides(linear, loaded, { linear = linear })
    check.holds(text, "at the end of stage 'press': 'column' is in unstable equilibrium", "along (", "Hint: ")
  end
end)

check.case("in space a square column has two such directions", function()
  decides("space", function(times)
    local body = scenes.body{ size = { thickness, thickness, length }, elements = { 1, 1, 5 }, E = E, nu = 0 }
    local model = scenes.model{ bodies = { column = body }, supports = { base = { on = "front", fix = "xyz" } },
                            loads = { p = { on = "back", traction = { 0, 0, 0 } } } }
    local traction = times * (1 - nu ^ 2) * euler(1) / thickness
    return model:run{ { steps = 2, p = { 0, 0, -traction } } }
  end)
end)

check.case("a stored state tells from which step on", function()
  local model = model_of_load()
  local run = model:run({ { name = "press", steps = 8, p = { 0, -2 * euler(1) / thickness } } }, { states = 9 })
  check.holds(warned(run), "at the end of stage 'press', from step 5 on: ")
  check.near(model:reaction("base").fy, 2 * euler(1), 1e-8) -- at the last state again
end)

check.case("a stage that was not examined is found when a later one is", function()
  local model = model_of_load()
  local path = {}
  for i = 1, 12 do path[i] = { name = "s" .. i, steps = 1, p = { 0, -i / 8 * euler(1) / thickness } } end
  local examine, count = core.state_warnings, 0
  core.state_warnings = function(of, everything)
    if everything then count = count + 1 end
    return examine(of, everything)
  end
  local ok, run = pcall(model.run, model, path)
  core.state_warnings = examine
  assert(ok, run)
  check.holds(warned(run), "at the end of stage 's9': ") -- 9/8 of the buckling load
  assert(count < #path, count) -- the first stages, the last one, and those of a bisection
  check.near(model:reaction("base").fy, 1.5 * euler(1), 1e-8) -- at the last state again
  local spent = run.timings -- with those of the checks
  check.near(spent.bulk + spent.contact + spent.linear + spent.rest, run.wall, 1e-9)
end)

--- Pressed by a frictionless plane: its upper end moves sideways but does not turn, so that it carries 4 times as much.
local function pressed(contact)
  return function(times, options)
    local body = column{ contact = "north" }
    local plane = scenes.ceiling(length)
    contact.slave, contact.master = body:face "north", plane
    local model = scenes.model{ bodies = { column = body }, contacts = { top = contact },
      supports = { base = { on = "south", fix = "xy" }, press = { on = plane, drive = "y" } } }
    local shortening = times * euler(2) * length * (1 - nu ^ 2) / (E * thickness)
    return model:run({ { name = "press", steps = 2, press = { -shortening } } }, options)
  end
end

check.case("contact holds the end of a column by penalties and by multipliers", function()
  decides("penalty", pressed{ penalty = 1e3 })
  decides("penalty with a potential", pressed{ penalty = 1e3, per = "reference" })
  decides("multipliers", pressed{ method = "mortar", enforcement = "multipliers" })
end)

check.case("a tie is no hinge", function()
  decides("tie", function(times, options)
    local lower = column{ height = length / 2, elements = 5, contact = "north" }
    local upper = column{ height = length / 2, elements = 7, at = length / 2, contact = "south" }
    local model = scenes.model{ bodies = { lower = lower, upper = upper },
      ties = { seam = { slave = "upper.south", master = "lower.north" } },
      supports = { base = { on = "lower.south", fix = "xy" } },
      loads = { p = { on = "upper.north", traction = { 0, 0 } } } }
    return model:run({ { steps = 2, p = { 0, -times * euler(1) / thickness } } }, options)
  end)
end)

check.case("motions without stiffness are neutral", function()
  -- A disc in a frictionless groove turns freely.
  local R, groove = 5, 10 * 1000 / 0.5
  local disc = scenes.body{ patch = sg.shapes.polar_disc{ radius = R, center = { 0, R * math.sqrt(2) } },
    elements = { 64, 8 }, contact = "south", E = 1000 }
  local function side(x) return sg.rigid.plane{ point = { 0, 0 }, normal = { x, 1 } } end
  local model = scenes.model{ bodies = { disc = disc }, loads = { g = { on = disc, force = { 0, 0 } } },
    contacts = { left = { slave = "south", master = side(1), penalty = groove },
                 right = { slave = "south", master = side(-1), penalty = groove } } }
  check.equal(warned(model:run{ { steps = 2, g = { 0, -10 / (math.pi * R ^ 2) } } }), nil)
  -- Of one patch or several ones it rolls on a plane, and on a slab as slave or as master; it falls off a cylinder.
  local rubber, slab = sg.neo_hookean{ E = 1000, nu = 0.3 }, nil
  slab = scenes.body{ size = {20, 4}, corner = { -10, -4 }, elements = { 40, 4 }, contact = "north", material = rubber }
  local function lies(patch, elements, face, master, swap)
    local body = scenes.body{ patch = patch, elements = elements, material = rubber }
    local on_slab = master == slab
    local slave, other = body:face(face), on_slab and slab:face "north" or master
    if swap then slave, other = other, slave end
    local rolling = sg.model{ bodies = { body = body, slab = on_slab and slab or nil },
      loads = { g = { on = body, force = { 0, 0 } } }, contacts = { k = { slave = slave, master = other } },
      supports = { bed = on_slab and { on = slab:face "south", fix = "xy" } or nil } }
    local run = check.completed(rolling:run({ { steps = 1, g = { 0, -10 / (math.pi * R ^ 2) } } }, sg.robust{}))
    return warned(run) ~= nil
  end
  local plane = scenes.floor()
  local top = sg.rigid.cylinder{ center = { 0, -20 }, radius = 20 }
  for _, one in ipairs{ { sg.shapes.polar_disc{ radius = R, center = { 0, R } }, { 16, 4 }, "south" },
                        { sg.shapes.disc{ radius = R, center = { 0, R } }, { 12, 4 }, "outer" } } do
    local function falls(master, swap) return lies(one[1], one[2], one[3], master, swap) end
    check.equal({ falls(plane), falls(slab), falls(slab, true), falls(top) }, { false, false, false, true })
  end
end)
