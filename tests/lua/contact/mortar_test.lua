-- Contacts with method = "mortar": contact patch test next to Gauss points, Hertz's line and point contact, ironing
-- with friction, and what else a run offers.

require "check"
local problem = require "problems.hertz2d.problem"
local ironing = require "ironing"
local patch_test = require "problems.patch_test.problem"

local equal, reduced = { method = "mortar", multipliers = "equal" }, { method = "mortar", multipliers = "reduced" }
local gpts = { method = "gpts" }

local function solved(model, stages, options) return check.completed(model:run(stages, sg.plain(options or {}))) end

-- ── Patch test ───────────────────────────────────────────────────────────────────────────────────────────────────────

--- The largest error of the pressure between two blocks under uniform pressure; patch_test.lua, sides guided.
local function patch_error(o)
  local model = patch_test.scene{ dimension = o.dimension, order = o.order, lower = o.lower, upper = o.upper,
    slave = o.slave, points = o.points, penalty = 100, sides = "guided", formulation = { keys = o.keys } }
  solved(model, { { name = "press", steps = 2, push = 0.1 } })
  local largest = 0
  for _, pressure in ipairs(model:profile "joint".pressure) do
    largest = math.max(largest, math.abs(pressure / 0.1 - 1))
  end
  return largest
end

check.case("patch test without kinks inside slave elements: uniform to rounding error, in 2D and 3D", function()
  for _, keys in ipairs { equal, reduced } do
    for _, order in ipairs { "N2", "N3", "N2-N2.2" } do
      for _, mesh in ipairs { { 4, 4, "lower" }, { 2, 6, "upper" } } do
        for dimension = 2, order == "N2" and 3 or 2 do
          local error = patch_error{ keys = keys, order = order, dimension = dimension, lower = mesh[1],
                                     upper = mesh[2], slave = mesh[3], points = 5 }
          check.at_most(("%dD %s %s"):format(dimension, order, keys.multipliers), error, 1e-12)
        end
      end
    end
  end
end)

check.case("patch test, 3 elements under 5: below the error of Gauss points, exponent of Gauss' rule", function()
  for _, keys in ipairs { equal, reduced } do
    for _, order in ipairs { "N2", "N2-N2.2" } do
      for _, slave in ipairs { "lower", "upper" } do
        local function error_at(with_keys, points)
          return patch_error{ keys = with_keys, order = order, dimension = 2, lower = 3, upper = 5, slave = slave,
                              points = points }
        end
        local name = ("%s %s, slave %s"):format(order, keys.multipliers, slave)
        for _, points in ipairs { 6, 15 } do check.at_most(name, error_at(keys, points), error_at(gpts, points)) end
        -- With the coarser mesh as slave Gauss points are worse by an order, since the finer master can move between.
        if slave == "lower" then check.at_most(name, error_at(keys, 15), 0.3 * error_at(gpts, 15)) end
        local coarse, fine = 0, 0
        for points = 8, 11 do coarse, fine = coarse + error_at(keys, points), fine + error_at(keys, 4 * points) end
        check.within(name .. ": exponent", math.log(fine / coarse) / math.log(4), -3, 0.7)
      end
    end
  end
  local function in_space(keys)
    return patch_error{ keys = keys, order = "N2", dimension = 3, lower = 3, upper = 5, slave = "lower", points = 3 }
  end
  for _, keys in ipairs { equal, reduced } do
    check.at_most("3D " .. keys.multipliers, in_space(keys), 0.1 * in_space(gpts))
  end
end)

-- ── Hertz ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Hertz's line contact under a given force: error of the pressure, peak, weighted penetration.
local function line_contact(order, mesh, penalty, keys, options)
  local model, stage = problem.scene{ order = order, mesh = mesh, load = "force", penalty = penalty,
    formulation = { keys = keys } }
  stage.steps = 4
  local run = solved(model, { stage }, options)
  local profile, a, p0 = model:profile "ground", problem.hertz(2 * run:column "ground.fy"[4])
  local case = { iterations = run.iterations, p0 = p0, peak = run:column "ground.max_pressure"[4] / p0,
                 penetration = rawget(model:contact_resultant "ground", "weighted_penetration"), off = 0 }
  local function hertz(x) return x < a and p0 * math.sqrt(1 - (x / a) ^ 2) or 0 end
  case.error = sg.profile_error{ profile = profile, normalize = p0, reference = hertz,
                                 coordinate = function(point) return point.x end } / math.sqrt(a)
  for i, x in ipairs(profile.x) do
    if x < 0.8 * a then case.off = math.max(case.off, math.abs(profile.pressure[i] - hertz(x)) / p0) end
  end
  return case
end

check.case("Hertz 2D: the error decreases with the mesh, and hardly depends on a high penalty", function()
  for _, keys in ipairs { equal, reduced } do
    for _, order in ipairs { "N2", "N2-N2.2" } do
      local name = order .. " " .. keys.multipliers
      local first, last = line_contact(order, "m1", 1e5, keys), line_contact(order, "m4", 1e5, keys)
      -- Three halvings of the elements; the difference from Hertz's half plane is 0.015.
      check.at_most(name .. ": m4 over m1", last.error / first.error, 0.35)
      check.at_most(name .. ": m4", last.error, 0.04)
      check.within(name .. ": peak at m4", last.peak, 1, 0.002)
      for _, penalty in ipairs { 1e4, 1e6 } do
        local other = line_contact(order, "m4", penalty, keys)
        check.within(name .. ": peak", other.peak, last.peak, 1e-3)
        check.within_share(name .. ": error", other.error, last.error, 0.2)
        check.at_most(name .. ": penetration", other.penetration, 1.01 * other.p0 / penalty)
      end
    end
  end
end)

check.case("Hertz 2D: at a high penalty Gauss points over-constrain, multipliers do not", function()
  for _, mesh in ipairs { "m1", "m2", "m3" } do
    local points = line_contact("N2", mesh, 1e4, gpts)
    for _, keys in ipairs { equal, reduced } do
      local case, name = line_contact("N2", mesh, 1e4, keys), mesh .. " " .. keys.multipliers
      check.at_most(name .. ": error", case.error, 0.7 * points.error)
      check.at_most(name .. ": iterations", case.iterations, points.iterations)
      check.at_most(name .. ": peak", math.abs(case.peak - 1), 0.07)
    end
  end
  check.at_most("equal m4: oscillation inside 0.8 a", line_contact("N2", "m4", 1e5, equal).off, 0.015)
end)

--- Hertz's point contact as an axisymmetric scene; scripts/problems/hertz_sphere.lua.
local function point_contact(count, keys, penalty)
  local load, young, poisson = 3.14e-4, 1, 0.3
  local graded = { elements = 0.75, length = 0.1, at = "start" }
  local ball = sg.body{ patch = sg.shapes.quarter_annulus{ inner = 0.1, outer = 1, start = 270 },
                        elements = { count, count }, grading = { graded, graded }, order = "N2", contact = "south",
                        material = sg.linear_elastic{ E = young, nu = poisson } }
  local model = scenes.model{ kind = "axisymmetric", bodies = { ball = ball },
    supports = { axis = { on = "west", fix = "x" } }, loads = { push = { on = "east", traction = { 0, 0 } } },
    contacts = { ground = { slave = "south", penalty = penalty, master = scenes.floor(-1 + 1e-4),
        method = keys.method, multipliers = keys.multipliers } } }
  local run = solved(model, { { name = "press", steps = 2, push = { 0, -load / (math.pi * (1 - 0.1 ^ 2)) } } })
  check.within_share("force", run:column "ground.fy"[2], load, 1e-7)
  local a = (3 * load * (1 - poisson ^ 2) / (4 * young)) ^ (1 / 3)
  local p0 = 3 * load / (2 * math.pi * a ^ 2)
  return sg.profile_error{
    profile = model:profile "ground", normalize = p0, coordinate = function(point) return point.x / a end,
    reference = function(s) return s < 1 and p0 * math.sqrt(1 - s ^ 2) or 0 end,
  }, run:column "ground.max_pressure"[2] / p0
end

check.case("Hertz's point contact, axisymmetric: the error decreases with the mesh", function()
  for _, keys in ipairs { equal, reduced } do
    local errors, peak = {}
    for i, count in ipairs { 16, 32, 64 } do errors[i], peak = point_contact(count, keys, 1e4) end
    check.at_most(keys.multipliers .. ": second", errors[2], 0.7 * errors[1])
    check.at_most(keys.multipliers .. ": third", errors[3], 0.7 * errors[2])
    check.within(keys.multipliers .. ": peak", peak, 1, 0.02)
  end
end)

-- ── Friction ─────────────────────────────────────────────────────────────────────────────────────────────────────────

local press = { name = "press", steps = 46, grip = { 0, -0.23 } }
local slide = { name = "slide", steps = 250, grip = { 1.5, -0.23 } }

check.case("ironing at m1 with friction: as many iterations as Gauss points, forces within a tenth", function()
  for _, order in ipairs { "N2", "N2-N2.2", "N4" } do
    local points = solved(ironing{ order = order, keys = gpts }, { press, slide })
    for _, keys in ipairs { equal, reduced } do
      local model = ironing{ order = order, keys = keys }
      local run, name = solved(model, { press, slide }), order .. " " .. keys.multipliers
      check.at_most(name .. ": iterations", run.iterations, 1.13 * points.iterations)
      for _, column in ipairs { "grip.fx", "grip.fy" } do
        local own, other = run:column(column), points:column(column)
        local mean, expected = 0, 0
        for i = 150, 296 do mean, expected = mean + own[i], expected + other[i] end
        check.within_share(name .. " " .. column, mean, expected, 0.1)
      end
      -- Where all slips, friction is mu times pressure.
      local energy = model:energy()
      check.at_most(name .. ": energy", math.abs(energy.stored + energy.contact + energy.friction - energy.work),
        0.02 * energy.work)
    end
  end
end)

check.case("load and hold: steps that move nothing change nothing", function()
  for _, keys in ipairs { equal, reduced } do
    local model = ironing{ order = "N2-N2.2", keys = keys }
    local hold = { name = "hold", steps = 20, grip = { 0.3, -0.23 } }
    local run = solved(model, { press, { name = "slide", steps = 50, grip = { 0.3, -0.23 } }, hold })
    local fx = run:column "grip.fx"
    check.within("creep", fx[#fx], fx[96], 1e-9)
  end
end)

check.case("samples are at most the largest pressure", function()
  local model = ironing{ order = "N2", keys = reduced }
  check.completed(model:run{ { name = "press", steps = 5, grip = { 0, -0.2 } } })
  local pressure = model:sample("die", "contact_pressure", { 0.5, 0 })
  check.at_most("sample", pressure, model:contact_resultant "interface".max_pressure)
  assert(pressure > 0)
end)

check.case("wrong combinations are errors that name the argument", function()
  local body = scenes.body{ order = "N1", contact = "south" }
  local function contact(keys)
    keys.slave, keys.master = body:face "south", sg.rigid.plane{ point = { 0, -1 }, normal = { 0, 1 } }
    return function() sg.model{ bodies = { block = body }, contacts = { floor = keys } } end
  end
  check.fails(contact{ penalty = 1, multipliers = "equal" }, 'method = "mortar"')
  check.fails(contact{ penalty = 1, method = "mortar", per = "current" }, "mortar", "per", "reference")
  check.fails(contact{ method = "mortar", adhesion = { hamaker = 1, r0 = 1 } }, "adhesion", "mortar")
  check.fails(contact{ penalty = 1, method = "mortar", multipliers = "reduced" }, "reduced", "degree p >= 2", "equal")
end)
