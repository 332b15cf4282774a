-- Comparison of contact profiles: integrals against closed forms, rules at the edges of contact, invalid arguments.

require "check"

--- A profile of n points s over [0, length] whose pressure and gap are functions of s.
local function sampled(n, length, pressure, extra)
  local p = { x = {}, y = {}, pressure = {}, traction = {}, gap = {}, state = {} }
  for i = 1, n do
    local s = length * (i - 1) / (n - 1)
    p.x[i], p.y[i], p.pressure[i], p.traction[i] = s, 0, pressure(s), 0.3 * pressure(s)
    p.gap[i], p.state[i] = extra and extra(s) or 0, pressure(s) > 0 and "slip" or "open"
  end
  return p
end

--- A Hertzian pressure of half-width a.
local function hertz(a, peak) return function(s) return s < a and peak * math.sqrt(1 - (s / a) ^ 2) or 0 end end

check.case("two straight lines: every quadrature and zone against the closed form", function()
  -- ∫₀¹ (2 + s − 1)² ds = 7/3
  local p = sampled(401, 1, function(s) return 2 + s end)
  local r = sampled(173, 1, function() return 1 end)
  local exact = math.sqrt(7 / 3)
  for _, zone in ipairs { "either", "both" } do
    for quadrature, tolerance in pairs { profile = 1e-5, reference = 1e-5, union = 1e-13 } do
      local error = sg.profile_error{ profile = p, reference = r, quadrature = quadrature, zone = zone }
      check.near(error, exact, tolerance)
    end
  end
  check.near(sg.profile_error{ profile = p, reference = function() return 1 end, quadrature = "union" }, exact, 1e-13)
  local traction = sg.profile_error{ profile = p, reference = r, quadrature = "union", value = "traction" }
  check.near(traction, 0.3 * exact, 1e-13)
end)

check.case("trapezoids converge with the square of the spacing", function()
  -- p = s², p_ref = 0: ∫ s⁴ = 1/5
  local errors = {}
  for i, n in ipairs { 11, 21, 41 } do
    local p = sampled(n, 1, function(s) return s ^ 2 end)
    errors[i] = math.abs(sg.profile_error{ profile = p, reference = function() return 0 end } - math.sqrt(1 / 5))
  end
  for i = 2, 3 do check.near(math.log(errors[i - 1] / errors[i], 2), 2, 0.05) end
end)

check.case("normalization, and the record of the integral", function()
  local p, r = sampled(101, 2, hertz(1, 3)), sampled(201, 2, hertz(1, 4))
  local plain = sg.profile_error{ profile = p, reference = r }
  local scaled, how = sg.profile_error{ profile = p, reference = r, normalize = "max" }
  check.near(scaled, plain / 4, 1e-15)
  check.near(sg.profile_error{ profile = p, reference = r, normalize = 8 }, plain / 8, 1e-15)
  check.equal({ how.from, how.to, how.points, how.scale, how.covered }, { 0, 2, 101, 4, 1 })
  -- ∫₀¹ (1 − s²) ds = 2/3
  check.near(plain, math.sqrt(2 / 3), 1e-2)
end)

check.case("zones: contact that ends earlier counts with zero pressure, or is left out", function()
  local function longer(s) return s < 1.25 and hertz(1, 1)(s) + 0.5 or 0 end
  local p, r = sampled(201, 2, hertz(1, 1)), sampled(2001, 2, longer)
  -- the difference is 0.5 over [0, 1.25] or, as far as both touch, over [0, 1)
  check.near(sg.profile_error{ profile = p, reference = r }, 0.5 * math.sqrt(1.25), 2e-3)
  local both, how = sg.profile_error{ profile = p, reference = r, zone = "both" }
  check.near(both, 0.5 * math.sqrt(0.99), 2e-3)
  check.equal(how.to, 0.99)
  check.near(how.covered, 0.99 / 1.249, 1e-12)
end)

check.case("edges of the integral: the chord to the next open point, or the zero of the gap", function()
  -- p = max(0, 1 + c − s) on points 0.1 apart: the chord from s = 1 ends at 1.1, the gap's zero is at 1 + c
  local c = 0.0303
  local function ramp(s) return math.max(0, 1 + c - s) end
  local function gap(s) return s - 1 - c end
  local p, r = sampled(21, 2, ramp, gap), sampled(2001, 2, ramp, gap)
  check.near(sg.profile_error{ profile = p, reference = r, quadrature = "union", edge = "gap" }, 0, 1e-15)
  -- With t = s − 1: ∫₀^c (c(1 − 10t) − (c − t))² dt + ∫_c^0.1 (c(1 − 10t))² dt
  local exact = math.sqrt((1 - 10 * c) ^ 2 * c ^ 3 / 3 + c ^ 2 * (1 - 10 * c) ^ 3 / 30)
  check.near(sg.profile_error{ profile = p, reference = r, quadrature = "union" }, exact, 1e-6)
  local _, how = sg.profile_error{ profile = p, reference = r, zone = "both", edge = "gap" }
  check.near(how.to, 1 + c, 1e-12)
end)

check.case("coordinates: a column, a function of the point, a face that runs backwards or curls up", function()
  local p, r = sampled(101, 2, hertz(1, 3)), sampled(201, 2, hertz(1, 4))
  local plain = sg.profile_error{ profile = p, reference = r }
  local function stretched(point) return 4 * point.x + point.y end
  check.near(sg.profile_error{ profile = p, reference = r, coordinate = stretched }, 2 * plain, 1e-14)
  local function backwards(point) return -point.x end
  check.near(sg.profile_error{ profile = p, reference = r, coordinate = backwards }, plain, 1e-14)
  p.X, r.X = p.x, r.x
  check.equal(sg.profile_error{ profile = p, reference = r, coordinate = "X" }, plain)
  -- beyond s = 1.5 the face turns back above the contact zone
  local function curled(point) return point.x <= 1.5 and point.x or 3 - point.x end
  local _, how = sg.profile_error{ profile = p, reference = r, coordinate = curled }
  check.equal({ how.to, how.covered }, { 1.5, 1 })
end)

check.case("edges: where the gap is zero, and how far apart the points around it are", function()
  local a = 0.73
  local p = sampled(41, 2, hertz(a, 1), function(s) return s - a end)
  local edges = sg.profile_edges{ profile = p }
  check.near(edges.to, a, 1e-14)
  check.near(edges.to_spacing, 0.05, 1e-14)
  check.equal({ edges.from, edges.from_spacing == nil }, { 0, true })
  local backwards = sg.profile_edges{ profile = p, coordinate = function(point) return -2 * point.x end }
  check.near({ backwards.from, backwards.to, backwards.from_spacing }, { -2 * a, 0, 0.1 }, 1e-14)
end)

check.case("profiles of a model, against each other and on themselves", function()
  local function pressed(elements)
    local function block(corner, order, face)
      return scenes.body{ corner = corner, elements = elements, order = order, contact = face, E = 10, nu = 0 }
    end
    local top, bottom = block({ 0, 1 }, "N2", "south"), block({ 0, 0 }, "N2", "north")
    local model = scenes.model{ bodies = { top = top, bottom = bottom },
      supports = { bed = { on = "bottom.south", fix = "xy" }, grip = { on = "top.north", fix = "x", drive = "y" } },
      contacts = { joint = { slave = "top.south", master = "bottom.north", penalty = 1000 } } }
    model:run{ { steps = 2, grip = { -0.1 } } }
    return model:profile "joint"
  end
  local coarse, fine = pressed { 2, 1 }, pressed { 5, 1 }
  check.equal(sg.profile_error{ profile = fine, reference = fine, quadrature = "union" }, 0)
  -- ν = 0: the pressure is the same everywhere, on any mesh
  check.near(sg.profile_error{ profile = coarse, reference = fine, normalize = "max" }, 0, 1e-8)
end)

check.case("wrong inputs name the argument, its value, the expectation, and a hint", function()
  local p, r = sampled(11, 1, hertz(0.8, 1)), sampled(21, 1, hertz(0.8, 1))
  local function fails(options, ...)
    check.fails(function() sg.profile_error(options) end, "sg.profile_error: ", ...)
  end
  fails({ profile = p, reference = 3 }, "reference must be a contact profile", "use the result of model:profile",
    "or a function of the coordinate")
  fails({ profile = p, reference = r, coordinate = "z" }, "profile has no list 'z'",
    "which coordinate needs; known: gap, pressure")
  fails({ profile = p, reference = math.sqrt, quadrature = "reference" }, "for a function, which has no points")
  fails({ profile = p, reference = function() return 0 / 0 end }, "reference(0) must be a finite number")
  fails({ profile = sampled(11, 1, function() return 0 end), reference = r }, "profile has no pressure")
  fails({ profile = p, reference = r, coordinate = function(point) return math.abs(point.x - 0.4) end },
    "is not monotonic")
  local away = sampled(21, 1, hertz(0.8, 1))
  for i = 1, 21 do away.x[i] = away.x[i] + 5 end
  fails({ profile = p, reference = away }, "do not overlap: the profile goes from 0 to 1, the reference from 5 to 6")
end)

check.case("a profile has only its lists, and is read, written and stored as a table", function()
  local model = scenes.model{ bodies = { slab = { elements = {1, 1}, order = "N1", contact = "south" } },
    supports = { grip = { on = "north", drive = "xy" } },
    contacts = { ground = { slave = "south", master = scenes.floor(), penalty = 10 } } }
  model:run{ { steps = 1, grip = {0, -0.1} } }
  local pr = model:profile "ground"
  local known = "t has X, Y, area, gap, inside, pressure, state, traction, x, y"
  check.fails(function() return pr.presure end, "profile_test.lua:", "a contact profile has no 'presure'",
    "did you mean 'pressure'?", known)
  check.fails(function() return pr.z end, "a contact profile has no 'z'", known)
  check.fails(function() return pr[1] end, "a contact profile has no entry the number 1", "profile.pressure[1]")
  check.fails(function() sg.chart{ file = "a.png", pr } end, "profile_test.lua:",
    "sg.chart: [1] must be a curve", "got a contact profile. Hint: write { x = profile.x, y = profile.pressure }")
  check.fails(function() sg.profile_error{ profile = pr, reference = print, coordinate = "z" } end,
    "sg.profile_error: profile has no list 'z'")

  local file, names = check.file(), {}
  sg.csv.write(file, pr)
  check.equal(sg.csv.read(file):column "pressure", pr.pressure)
  for name in pairs(pr) do names[#names + 1] = name end
  check.equal({ #names, rawlen(pr), #pr.x > 1, pr.pressure[1] > 0 }, { 10, 0, true, true })
  local core = require "signorini.core"
  local saved = core.read_json(core.write_json(pr))
  check.near(saved.gap, pr.gap, 0)
  check.equal(saved.presure, nil)
  local show = require "signorini.prompt.show"
  check.equal(show.text(saved), show.text(pr))
  check.holds(show.text(pr), ("contact profile of %d points: "):format(#pr.x))
  local record = require("signorini.study.case").solve(function() return pr end, { case = {}, text = "a" })
  check.equal({ record.outcome, record.results.state }, { "done", pr.state })
end)
