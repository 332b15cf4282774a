-- Derivatives with sets of faces, wear, formulas as laws, bonds and layers, next to differences of whole runs; and
-- closed forms: Hertz, peeling, press fit.

local check, sg, lists = require "check", require "signorini", require "signorini.call.lists"

local tight = { newton = { tolerance = 1e-12 } }

--- Compares with differences at a distance at which no state differs.
local function compare(name, scene, at, columns, most)
  local found = sg.check_gradients { scene = scene, at = at, of = columns, by = { 2e-5 } }
  for _, row in ipairs(found.rows) do
    check.at_most(("%s: d %s / d %s"):format(name, row.name, row.parameter), row.difference, most)
  end
  return found.gradients
end

-- ── Laws and sets ────────────────────────────────────────────────────────────────────────────────────────────────────

--- A half ring that is pressed onto a slab, slides and returns, with this contact; q: E, and constants of the contact.
local function slide(contact)
  return function(q)
    local slab = sg.body { patch = sg.shapes.rectangle { width = 4, height = 1 }, elements = { 12, 3 }, order = "N2",
                           material = sg.neo_hookean { E = q.E, nu = 0.3 } }
    local ring = sg.body { patch = sg.shapes.half_annulus { inner = 0.3, outer = 0.8, center = { 1.5, 1.8 } },
                           elements = { 8, 2 }, order = "N2", material = sg.neo_hookean { E = 10, nu = 0.3 } }
    local model = sg.model {
      bodies = { slab = slab, ring = ring }, contacts = { c = contact(q, ring, slab) },
      supports = { bed = { on = slab:face "south", fix = "xy" },
                   lid = { on = { ring:face "west", ring:face "east" }, drive = "xy" } } }
    return model, { { name = "press", steps = 2, duration = 1, lid = { 0, -0.08 } },
                    { name = "slide", steps = 4, duration = 1, lid = { 0.3, -0.08 } },
                    { name = "back", steps = 2, duration = 1, lid = { 0.2, -0.06 } } }, tight
  end
end

local function pair(keys, ring, slab)
  return lists.merged({ slave = ring:face "south", master = slab:face "north", penalty = 40 }, keys)
end

check.case("a set of faces", function()
  compare("set", slide(function(q)
    return { among = "all", penalty = 40, friction = { mu = q.mu, penalty = 40 } }
  end), { E = 1, mu = 0.3 }, { "lid.fx", "lid.fy" }, 1e-5)
end)

check.case("wear", function()
  local found = compare("wear", slide(function(q, ring, slab)
    return pair({ friction = { mu = 0.3, penalty = 40 }, wear = { rate = q.k } }, ring, slab)
  end), { E = 1, k = 0.05 }, { "lid.fx", "lid.fy", "c.worn_volume" }, 1e-5)
  check.equal(found:column("c.worn_volume", "k")[8] > 0, true)
end)

check.case("formulas of friction and pressure, and a stage that changes friction", function()
  compare("formulas", slide(function(q, ring, slab)
    return { slave = ring:face "south", master = slab:face "north",
             pressure = function(g) return q.c * sg.max(0, 0.02 - g) ^ 2 end, clearance = 0.02,
             friction = { mu = function(p, v) return q.mu * sg.exp(-p) + 0.1 * sg.exp(-v) end, penalty = 40 } }
  end), { E = 1, c = 300, mu = 0.2 }, { "lid.fx", "lid.fy" }, 1e-5)
  local function staged(q)
    local model, stages, options = slide(function(_, ring, slab)
      return pair({ friction = { mu = 0, penalty = 40 } }, ring, slab)
    end)(q)
    stages[2].contacts = { c = { friction = { mu = q.mu } } }
    return model, stages, options
  end
  compare("stage", staged, { E = 1, mu = 0.3 }, { "lid.fx", "lid.fy" }, 1e-5)
end)

check.case("points = \"auto\"", function()
  compare("auto", slide(function(q, ring, slab)
    return pair({ points = "auto", friction = { mu = q.mu, penalty = 40 } }, ring, slab)
  end), { E = 1, mu = 0.3 }, { "lid.fx", "lid.fy" }, 1e-5)
end)

check.case("layers that follow the contact", function()
  local function followed(q)
    local slab = sg.body { patch = sg.shapes.rectangle { width = 4, height = 1 }, elements = { 24, 3 },
                           order = "N2-N2.2", contact = "north", material = sg.neo_hookean { E = q.E, nu = 0.3 },
                           layer = function(X) return math.abs(X[1] - 1.5) < 0.4 end }
    local tool = sg.rigid.cylinder { center = { 1.5, 1 + q.R }, radius = q.R }
    local model = sg.model { bodies = { slab = slab },
      supports = { bed = { on = slab:face "south", fix = "xy" }, tool = { on = tool, drive = "xy" } },
      contacts = { c = { slave = slab:face "north", master = tool, penalty = 40,
                         friction = { mu = q.mu, penalty = 40 } } } }
    return model,
      { { name = "press", steps = 2, tool = { 0, -0.05 } }, { name = "slide", steps = 6, tool = { 0.9, -0.05 } } },
      { newton = { tolerance = 1e-12 }, adapt = { margin = 1 } }
  end
  local found = compare("adapt", followed, { E = 1, mu = 0.3, R = 0.8 }, { "tool.fx", "tool.fy" }, 1e-5)
  check.equal(#found.run.adaptations > 0, true)
end)

-- ── Closed forms ─────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("a sphere on a half space: Hertz", function()
  -- F = 4/3 E/(1 − ν²) √R δ^(3/2): a block of 30 radii of contact, linear; 2 % of its finite size and of the mesh.
  local a, R = 0.1, 10
  local function indent(q)
    local size = 6
    local slab = sg.body { patch = sg.shapes.rectangle { width = size, height = size }, elements = { 28, 28 },
                           order = "N2",
                           grading = { { elements = 0.7, length = 0.05, at = "start" },
                                       { elements = 0.7, length = 0.05, at = "end" } },
                           material = sg.linear_elastic { E = q.E, nu = q.nu } }
    local tool = sg.rigid.sphere { center = { 0, size + q.R }, radius = q.R }
    local model = sg.model { kind = "axisymmetric", bodies = { slab = slab },
      supports = { axis = { on = slab:face "west", symmetry = true }, bed = { on = slab:face "south", fix = "xy" },
                   tool = { on = tool, drive = "y" } },
      contacts = { c = { slave = slab:face "north", master = tool, penalty = 1e5 } } }
    return model, { { steps = 2, tool = -q.depth } }, tight
  end
  local at = { E = 100, nu = 0.3, R = R, depth = a ^ 2 / R }
  local found = sg.gradients { scene = indent, at = at }
  local force = check.last(found.run, "tool.fy")
  local function exponent(name) return found:column("tool.fy", name)[2] * at[name] / force end
  check.within("E", exponent "E", 1, 0.01)
  check.within("R", exponent "R", 1 / 2, 0.02)
  check.within("depth", exponent "depth", 3 / 2, 0.02)
  check.within("nu", exponent "nu", 2 * at.nu ^ 2 / (1 - at.nu ^ 2), 0.02)
end)

check.case("a film that is peeled off upright: the force is the energy of separation", function()
  local function peel(q)
    local film = sg.body { patch = sg.shapes.rectangle { width = 7, height = 0.1 }, elements = { 35, 1 },
                           order = "N2", contact = "south", thickness_degree = 2,
                           material = sg.neo_hookean { E = 2000, nu = 0.3 } }
    local model = sg.model { bodies = { film = film },
      supports = { clamp = { on = film:face "east", fix = "xy" },
                   grip = { on = film:corner "south-west", drive = "y" } },
      contacts = { glue = { slave = film:face "south", penalty = 2000,
                            master = sg.rigid.plane { point = { 0, 0 }, normal = { 0, 1 } },
                            cohesive = { strength = q.strength, energy = q.G,
                                         where = function(X) return X[1] >= 2 end } } } }
    return model, { { steps = 30, grip = 4 } }, tight
  end
  local found = sg.gradients { scene = peel, at = { strength = 1, G = 0.1 } }
  -- The mean of the last five steps, over which bonds break one by one.
  local function mean(list)
    local sum = 0
    for i = #list - 4, #list do sum = sum + list[i] / 5 end
    return sum
  end
  check.within("dF/dG", mean(found:column("grip.fy", "G")), 1, 0.02)
  check.within("dF/dstrength", mean(found:column("grip.fy", "strength")), 0, 0.005)
end)

check.case("a belt that slides around half of a pulley: T2/T1 = exp(mu pi R/(R + h/2))", function()
  local R, h, length, T1 = 20, 0.5, 10, 1
  local function belt(q)
    local function straight(x) return sg.shapes.rectangle { width = h, height = length, corner = { x, 0 } } end
    local patches = { straight(-R - h), sg.shapes.half_annulus { inner = R, outer = R + h, center = { 0, 0 } },
                      straight(R), boundaries = { slack = { "1.north" }, inside = { "1.east", "2.north", "3.west" },
                                                  tight = { "3.north" } } }
    local body = sg.body { patch = patches, elements = { { 1, 4 }, { 24, 1 }, { 1, 4 } }, order = "N2",
                           contact = "inside", material = sg.neo_hookean { E = 1000, nu = 0.3 } }
    local pulley = sg.rigid.cylinder { center = { 0, 0 }, radius = R }
    local model = sg.model { bodies = { belt = body },
      supports = { slack = { on = body:face "slack", fix = "x" }, tight = { on = body:face "tight", fix = "xy" },
                   pulley = { on = pulley, fix = "xy", rotate = true } },
      loads = { pull = { on = body:face "slack", traction = { 0, 0 } } },
      contacts = { wrap = { slave = body:face "inside", master = pulley, penalty = 100,
                            friction = { mu = q.mu, penalty = 100 } } } }
    return model, { { steps = 4, pull = { 0, T1 / h } }, { steps = 8, pulley = -3 } }, tight
  end
  local found = sg.gradients { scene = belt, at = { mu = 0.3 } }
  local pulled = check.last(found.run, "tight.fy")
  check.within("d ln T2/d mu", found:column("tight.fy", "mu")[12] / pulled, math.pi * R / (R + h / 2), 0.03)
end)

check.case("a press fit: the pressure is proportional to the interference", function()
  local function fit(q)
    local function tube(inner, outer)
      return sg.body { patch = sg.shapes.rectangle { width = outer - inner, height = 0.2, corner = { inner, 0 } },
                       elements = { 4, 1 }, order = "N2", material = sg.linear_elastic { E = q.E, nu = 0.3 } }
    end
    local inner, outer = tube(0.5, 1), tube(1, 1.5)
    local model = sg.model { kind = "axisymmetric", bodies = { inner = inner, outer = outer },
      supports = { low = { on = { inner:face "south", outer:face "south" }, fix = "y" },
                   high = { on = { inner:face "north", outer:face "north" }, fix = "y" } },
      contacts = { c = { slave = inner:face "east", master = outer:face "west", offset = q.o, penalty = 1e5,
                         per = "reference", overlap = "interference" } } }
    return model, { { steps = 1 } }, tight
  end
  local at = { E = 100, o = 0.001 }
  local found = sg.gradients { scene = fit, at = at }
  local pressure = check.last(found.run, "c.max_pressure")
  for name, value in pairs(at) do
    check.within(name, found:column("c.max_pressure", name)[1] * value / pressure, 1, 0.01)
  end
end)
