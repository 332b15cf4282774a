-- Modes and stability: frequencies and critical loads of closed forms, rigid motions, constraints, density, pictures.

require "check"
local core = require "signorini.core"

local pi = math.pi

--- The root of f between two places with different signs.
local function root(f, low, high)
  local sign = f(low) > 0
  for _ = 1, 80 do
    local middle = (low + high) / 2
    if (f(middle) > 0) == sign then low = middle else high = middle end
  end
  return (low + high) / 2
end

local function values(modes, first, last)
  return lists.map(table.move(modes, first or 1, last or #modes, 1, {}), function(mode) return mode.value end)
end

-- ── Rigid motions ────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("free bodies have rigid motions without stiffness, which are named", function()
  local square = scenes.model{ bodies = { a = { size = {2, 1} } } }
  local round = scenes.model{ kind = "axisymmetric", bodies = { a = {} },
    supports = { axis = { on = "west", symmetry = true } } }
  local cube = scenes.model{ bodies = { a = { size = {1, 1, 1} } } }
  for _, case in ipairs{ { square, "a along x", "a along y", "a about z" }, { round, "a along y" },
    { cube, "a along x", "a along y", "a along z", "a about x", "a about y", "a about z" } } do
    local model, names = case[1], { table.unpack(case, 2) }
    local _, raw = core.modes(model, #names + 1)
    local modes = model:modes{ count = #names + 1 }
    for k, name in ipairs(names) do
      check.at_most("stiffness over that of the first mode", raw[k].value / raw[#raw].value, 1e-10)
      check.equal({ modes[k].value, modes[k].frequency, modes[k].growth }, { 0, 0, nil })
      check.equal(modes[k].rigid, name)
    end
    local first = modes[#modes]
    check.equal({ first.rigid, first.growth, modes.stable, modes.complete }, { nil, nil, true, true })
    check.within_share("frequency", (2 * pi * first.frequency) ^ 2, first.value, 1e-12)
  end
end)

check.case("a turned body turns about its present middle", function()
  local model = scenes.model{ bodies = { a = { size = {2, 1} } } }
  local before, change, turned = values(model:modes{}), {}, { math.cos(1), math.sin(1) }
  for i, unknown in ipairs(model:unknowns()) do
    local x, y = table.unpack(model:body "a":points()[unknown.point])
    local c, s = turned[1], turned[2]
    change[i] = unknown.component == "x" and c * x - s * y - x or unknown.component == "y" and s * x + c * y - y
  end
  model:move(change)
  model:accept()
  local modes = model:modes{}
  check.equal({ modes[1].rigid, modes[2].rigid, modes[3].rigid }, { "a along x", "a along y", "a about z" })
  check.near(values(modes), before, 1e-10)
  local loose = scenes.model{ bodies = { a = { size = {2, 1} } }, supports = { bed = { on = "south", fix = "y" } } }
  check.equal({ loose:modes{}[1].rigid, loose:modes{}[2].rigid }, { "a along x" })
end)

-- ── Frequencies ──────────────────────────────────────────────────────────────────────────────────────────────────────

--- The meridian of a ball, a quarter of a disc, or its lower octant.
local function ball(order, elements, nu, space)
  local arc = sg.nurbs.arc{ center = {0, 0}, radius = 1, from = 270, to = 360 }
  local center = sg.nurbs.curve{ degree = 2, knots = {0, 0, 0, 1, 1, 1}, points = { {0, 0}, {0, 0}, {0, 0} },
                                 weights = {1, math.sqrt(0.5), 1} }
  local body = sg.body{ patch = space and sg.shapes.sphere_octant{ inner = 1e-3, outer = 1 }
      or sg.nurbs.ruled{ a = arc, b = center },
    elements = space and { elements, elements, elements } or { elements, elements }, order = order, density = 3,
    material = sg.linear_elastic{ E = 1, nu = nu } }
  return scenes.model{ kind = not space and "axisymmetric" or nil, bodies = { ball = body },
    supports = space and { low = { on = "west", fix = "xz" }, left = { on = "east", fix = "yz" },
                           equator = { on = "south", fix = "xy" } }
      or { axis = { on = "west", symmetry = true }, equator = { on = "east", symmetry = true } } }
end

-- A. E. H. Love, A Treatise on the Mathematical Theory of Elasticity, 1927, 194 to 196: the ball breathes where
-- tan x / x = 1/(1 - (c_p/(2 c_s))² x²), x = ω R/c_p, and twists where j₂'(x) = j₂(x)/x, x = ω R/c_s.
check.case("a ball breathes with the frequencies of the closed form, with errors of order 2p", function()
  for _, case in ipairs{ { 0.25, 2.56343 }, { 0.3, 2.67021 } } do
    local nu, published = table.unpack(case)
    local c = 2 * (1 - nu) / (1 - 2 * nu) -- (c_p/c_s)²
    local exact = root(function(x) return math.sin(x) * (1 - c / 4 * x ^ 2) - x * math.cos(x) end, 2.2, 3)
    check.near(exact, published, 5e-6)
    local pressure_wave = math.sqrt((1 - nu) / ((1 + nu) * (1 - 2 * nu)) / 3)
    local function error_of(order, elements)
      local modes = ball(order, elements, nu):modes{ count = 4 }
      check.holds(modes.warnings[1], "only axisymmetric motions")
      local nearest = lists.least(modes, function(mode)
        return math.abs(2 * pi * mode.frequency / pressure_wave - exact)
      end)
      return 2 * pi * nearest.frequency / pressure_wave / exact - 1
    end
    for order, power in pairs{ N2 = 4, N3 = 6 } do
      local coarse, fine = error_of(order, 2), error_of(order, 4)
      check.at_most("error", fine, 1e-5)
      check.near(math.log(coarse / fine, 2), power, 0.7)
    end
  end
end)

check.case("a ball twists with the frequency of the closed form", function()
  local exact = root(function(x)
    local j1, j2 = math.sin(x) / x ^ 2 - math.cos(x) / x, (3 / x ^ 3 - 1 / x) * math.sin(x) - 3 / x ^ 2 * math.cos(x)
    return j1 - 3 / x * j2 - j2 / x
  end, 2, 3)
  check.near(exact, 2.50113, 5e-6)
  local shear_wave = math.sqrt(1 / 2.6 / 3)
  local function error_of(elements)
    return 2 * pi * ball("N2", elements, 0.3, true):modes{ count = 1 }[1].frequency / shear_wave / exact - 1
  end
  local coarse, fine = error_of(2), error_of(4)
  check.at_most("error", fine, 1e-3)
  check.near(math.log(coarse / fine, 2), 4, 0.7)
end)

-- Thin rings: ω² = n²(n² - 1)²/(n² + 1) E'I/(ρAR⁴) (A. E. H. Love, 293), each twice.
local function ring(h, load)
  local body = sg.body{ patch = sg.shapes.ring{ inner = 1 - h / 2, outer = 1 + h / 2 }, elements = {32, 1},
    order = "N4", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  return scenes.model{ bodies = { ring = body }, loads = load and { sea = lists.merged(load, { on = "south" }) } }
end

check.case("a thin ring has the frequencies 7.2 and 57.6", function()
  local h = 0.02
  local modes = ring(h):modes{ count = 7 }
  local scale = h ^ 2 / 12 / (1 - 0.3 ^ 2)
  for k, expected in pairs{ [4] = 7.2, [5] = 7.2, [6] = 57.6, [7] = 57.6 } do
    check.within_share("squared frequency", modes[k].value / scale, expected, 3e-3)
  end
  check.within_share("pair", modes[5].value, modes[4].value, 1e-5)
end)

--- b² of a free beam with rotary inertia r² and shear s², with the classical b = (β L)² in reach (T. C. Huang, J. Appl.
--- Mech. 28, 1961): symmetric and antisymmetric modes.
local function free_beam(classical, r2, s2)
  return root(function(b)
    local part = math.sqrt((r2 - s2) ^ 2 + 4 / b ^ 2)
    local alpha, beta = math.sqrt((part - r2 - s2) / 2), math.sqrt((part + r2 + s2) / 2)
    local x, y = b * alpha, b * beta
    local cosh, sinh = (math.exp(x) + math.exp(-x)) / 2, (math.exp(x) - math.exp(-x)) / 2
    return 2 - 2 * cosh * math.cos(y) + b / math.sqrt(1 - b ^ 2 * r2 * s2)
      * (b ^ 2 * r2 * (r2 - s2) ^ 2 + 3 * r2 - s2) * sinh * math.sin(y)
  end, 0.8 * classical, 1.02 * classical)
end

check.case("a free beam has the frequencies of Timoshenko's beam", function()
  local length = 20
  local model = scenes.model{ bodies = { beam = { size = { length, 1 }, elements = { 20, 1 }, order = "N4", nu = 0 } } }
  local modes = model:modes{}
  local r2 = 1 / 12 / length ^ 2
  for k, classical in ipairs{ 4.7300, 7.8532, 10.9956 } do
    check.within_share("without shear", free_beam(classical ^ 2, 1e-9, 1e-9), classical ^ 2, 1e-4)
    local expected = free_beam(classical ^ 2, r2, 2 * r2 * 6 / 5) ^ 2 / (12 * length ^ 4)
    check.within_share("squared frequency", modes[3 + k].value, expected, 1e-3)
  end
end)

-- ── Critical loads ───────────────────────────────────────────────────────────────────────────────────────────────────

--- The load at which the first value vanishes, near two loads: values are almost linear in it.
local function critical(value, low, high)
  local first = value(low)
  for _ = 1, 2 do
    local second = value(high)
    low, high, first = high, high - second * (high - low) / (second - first), second
  end
  return high
end

--- A column that stands on a symmetry plane, as one clamped but for the strain across, which the clamped face resists.
local function column(length, load)
  return scenes.model{ bodies = { column = { size = { length, 1 }, elements = { 20, 1 }, order = "N3" } },
    supports = { plane = { on = "west", fix = "x" }, pin = { on = "south-west", fix = "y" } },
    loads = { push = lists.merged(load, { on = "east" }) } }
end

-- S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability, 1961, 2.17: P = P_E/(1 + 1.2 P_E/(G A)). What is left are
-- compressive strains, which change with the square of the slenderness as shear does.
check.case("a column under a dead load becomes unstable at Euler's load with shear", function()
  local function excess(length)
    local model = column(length, { traction = {0, 0} })
    local euler = pi ^ 2 / (1 - 0.3 ^ 2) / 12 / (4 * length ^ 2)
    local expected = euler / (1 + 1.2 * euler * 2.6)
    local load = critical(function(p)
      check.completed(model:run({ { steps = 1, push = { -p, 0 } } }, sg.plain{}))
      return model:modes{ count = 1 }[1].value
    end, 0.95 * expected, 0.98 * expected)
    if length == 20 then check.near(expected, 5.6389e-4, 5e-9) end
    check.completed(model:run({ { steps = 1, push = { -0.99 * load, 0 } } }, sg.plain{}))
    check.equal(model:modes{ count = 1 }.stable, true)
    check.completed(model:run({ { steps = 1, push = { -1.01 * load, 0 } } }, sg.plain{}))
    local modes = model:modes{ count = 1 }
    check.equal({ modes.stable, modes.complete, modes[1].frequency }, { false, true, nil })
    check.within_share("growth", modes[1].growth ^ 2, -modes[1].value, 1e-12)
    check.holds(tostring(modes), "grows", "the state is unstable")
    return load / expected - 1
  end
  local excess20 = excess(20)
  check.at_most("20 times as long as thick", excess20, 2e-3)
  check.within_share("decrease of the difference", excess20 / excess(40), 4, 0.05)
end)

-- M. Beck, Z. Angew. Math. Phys. 3 (1952) 225: flutter at P L²/(EI) = 20.05.
check.case("a column under a load that follows its end flutters at 20.05 EI/L²", function()
  local length = 40
  local scale = 1 / (1 - 0.3 ^ 2) / 12 / length ^ 2
  for load, flutters in pairs{ [19.8] = false, [20.3] = true } do
    local model = column(length, { pressure = 0, follower = true })
    check.completed(model:run({ { steps = 2, push = load * scale } }, sg.plain{}))
    local modes = model:modes{ count = 2 }
    check.equal({ modes.symmetric, modes[1].imaginary ~= nil, modes[1].growth ~= nil },
      { false, flutters, flutters })
    if flutters then check.equal(modes.stable, false) else check.equal(modes.stable, nil) end
    check.equal(#model:modes{ count = 1 }, flutters and 2 or 1) -- both of a pair
    check.holds(tostring(modes), "not symmetric", flutters and "grows, oscillating" or "mode")
  end
end)

-- The references of the ring in scene/follower_test.lua.
check.case("a ring becomes unstable in two modes under 3 E'I/R³ of a pressure that follows, 4 of a dead one", function()
  local h = 0.02
  local scale = h ^ 3 / 12 / (1 - 0.3 ^ 2) / (1 + h / 2)
  for follower, expected in pairs{ [true] = 3, [false] = 4 } do
    local model = ring(h, { pressure = 0, follower = follower })
    local free = model:modes{ count = 4 }[4].value
    local function bending(p)
      check.completed(model:run({ { steps = 1, sea = p * scale } }, { step = { adaptive = false } }))
      local modes = lists.filter(model:modes{ count = 5 }, function(mode) return not mode.rigid end)
      -- Under a dead pressure the ring turns inside out; this motion has a stiffness.
      if not follower then table.remove(modes, 1) end
      -- Equal but for the mesh, whose lines between quarter arcs are at the antinodes of one of them
      check.at_most("difference of the pair", (modes[1].value - modes[2].value) / free, 1e-5)
      return modes[1].value
    end
    check.within_share("pressure", critical(bending, expected - 0.3, expected - 0.2), expected, 0.02)
  end
end)

-- ── Constraints ──────────────────────────────────────────────────────────────────────────────────────────────────────

local function pair(more)
  return scenes.model(lists.merged({ bodies = { low = { size = {2, 1}, elements = {4, 2} },
    up = { size = {2, 1}, corner = {0, 1}, elements = {4, 2} } } }, more))
end

check.case("tied and joined bodies vibrate as one", function()
  local tied = pair{ ties = { seam = { slave = "low.north", master = "up.south" } } }:modes{}
  local low, up = scenes.body{ size = {2, 1}, elements = {4, 2} }, scenes.body{ size = {2, 1}, corner = {0, 1},
                                                                                elements = {4, 2} }
  local joined = sg.model{ bodies = { low = low, up = up },
    joins = { seam = { low:face "north", up:face "south" } } }:modes{}
  check.equal({ tied.complete, joined.complete, tied.stable }, { true, true, true })
  check.equal(tied[3].rigid, "low and up about z")
  for k = 4, 6 do check.within_share("value", tied[k].value, joined[k].value, 1e-8) end
  check.equal(#lists.filter(pair{}:modes{ count = 7 }, function(mode) return mode.rigid end), 6)
end)

check.case("closed contact points hold, open ones do not", function()
  local function block(supports, contacts, loads)
    return scenes.model{ bodies = { block = { size = {2, 1}, elements = {4, 2}, E = 100,
        material = sg.linear_elastic{ E = 100, nu = 0.3 } } },
      supports = lists.merged({ side = { on = "west", fix = "x" } }, supports), contacts = contacts, loads = loads }
  end
  local function floor(y)
    return { floor = { slave = "south", master = scenes.floor(y), method = "mortar", enforcement = "multipliers",
                       per = "reference" } }
  end
  local open = block({ grip = { on = "north", drive = "y" } }, floor(-0.1)):modes{ count = 3 }
  check.near(values(open), values(block({ grip = { on = "north", fix = "y" } }):modes{ count = 3 }), 1e-8)
  local pressed = block({ grip = { on = "north", drive = "y" } }, floor(0))
  check.completed(pressed:run{ { steps = 1, grip = -0.01 } })
  local held = block{ grip = { on = "north", fix = "y" }, bed = { on = "south", fix = "y" } }
  local modes = pressed:modes{ count = 3 }
  check.equal({ modes.symmetric, modes.complete, modes.stable }, { true, true, true })
  for k, value in ipairs(values(held:modes{ count = 3 })) do
    check.within_share("value", modes[k].value, value, 1e-4)
  end
end)

check.case("obstacles follow bodies without mass", function()
  local function tool(motion, load)
    local disc = sg.rigid.cylinder{ center = {1, 1.5}, radius = 0.5 }
    return scenes.model{ bodies = { slab = { size = {2, 1}, elements = {8, 4} } },
      supports = { bed = { on = "south", fix = "xy" }, tool = lists.merged(motion, { on = disc }) },
      contacts = { touch = { slave = "north", master = disc, penalty = 100, per = "reference" } },
      loads = load and { push = { on = disc, force = {0, 0} } } }
  end
  local free, driven = tool({ free = "y" }, true), tool{ drive = "y" }
  check.near(values(free:modes{}), values(driven:modes{}), 1e-10) -- apart
  check.completed(free:run{ { steps = 2, push = {0, -0.05} } })
  check.completed(driven:run{ { steps = 2, tool = free:displacements()[#free:displacements()] } })
  check.near(driven:reaction "tool"[2], -0.05, 1e-8)
  local modes, held = free:modes{}, driven:modes{}
  for k = 1, 6 do check.equal(modes[k].value <= held[k].value * (1 + 1e-9), true) end
  check.equal({ modes.stable, modes[2].value < 0.99 * held[2].value }, { true, true })
end)

-- ── Density, counts, files, pictures, wrong calls ────────────────────────────────────────────────────────────────────

check.case("values are in proportion to 1/density, also of saved models and of bodies of several patches", function()
  local function model(density)
    return scenes.model{ bodies = { a = { density = density } }, supports = { bed = { on = "south", fix = "xy" } } }
  end
  local light, heavy = model(nil):modes{}, model(4):modes{}
  for k = 1, 6 do check.within_share("value", light[k].value, 4 * heavy[k].value, 1e-10) end
  check.equal(values(check.reloaded(model(4)):modes{}), values(heavy))
  local unit = sg.shapes.rectangle{ width = 1, height = 1 }
  local whole = scenes.body{ patch = { unit, unit:translate{1, 0} }, density = 4 }
  local again = scenes.body{ patch = { unit, unit:translate{1, 0} } }
  check.within_share("value", sg.model{ bodies = { a = again } }:modes{}[4].value,
    4 * sg.model{ bodies = { a = whole } }:modes{}[4].value, 1e-10)
end)

check.case("all modes of a small body are complete; the model does not change", function()
  local model = scenes.model{ bodies = { a = { elements = {1, 1} } }, supports = { bed = { on = "south", fix = "xy",
    }, top = { on = "north", drive = "y" } } }
  check.completed(model:run{ { steps = 1, top = -0.1 } })
  local before, force = model:displacements(), model:reaction "top"
  local modes = model:modes{ count = 100 }
  check.equal({ #modes, modes.complete, modes.stable }, { 9, true, true })
  check.equal(#modes[1].mode, #before)
  check.equal({ model:displacements(), model:reaction "top" }, { before, force })
  model:set_target("top", { -0.2 })
  check.fails(function() model:modes{} end, "model:modes", "have changed since the accepted state")
  model:rollback()
  local held = scenes.model{ bodies = { a = { order = "N1", elements = {1, 1} } },
    supports = { all = { on = { "south", "north" }, fix = "xy" } } }
  check.fails(function() held:modes{} end, "model:modes", "nothing can move")
  check.fails(function() model:modes{ count = 0 } end, "count")
  check.fails(function() scenes.body{ density = 0 } end, "density")
  check.fails(function() return modes.value end, "modes has no 'value'")
  check.fails(function() return modes[1].values end, "did you mean 'value'")
end)

check.case("pictures show the state displaced by a mode", function()
  local model = scenes.model{ bodies = { a = { size = {4, 1}, elements = {4, 1} } },
    supports = { bed = { on = "west", fix = "xy" } } }
  local mode = model:modes{ count = 1 }[1]
  local file = check.folder() .. "/mode.png"
  sg.picture{ model = model, mode = mode, amplitude = 0.5, field = "uy", file = file }
  check.equal(lists.least(model:displacements(), function(u) return -math.abs(u) end), 0)
  check.holds(tostring(mode), "mode with value", "frequency")
  local other = scenes.model{ bodies = { a = {} } }
  check.fails(function() sg.picture{ model = other, mode = mode } end, "mode", "of this model")
  check.fails(function() sg.picture{ model = model, mode = mode, deformed = false } end, "deformed = false hides")
  check.fails(function() sg.picture{ model = model, amplitude = 1 } end, "mode")
end)
