-- Generated scenes that may be absurd (tests/measure/robustness.lua): reproducible from a seed, refused with a message,
-- solved or ended with a reason; equal forces in other words. And scenes in which the generator found errors.

require "check"
package.path = core.home .. "/tests/measure/?.lua;" .. package.path
local other_warnings = require "other_warnings"
local checks = require "robustness.checks"
local families = require "robustness.families"
local drawn = require "robustness.scenes"
local survey = require "robustness.survey"

core.quiet = true

check.case("a seed gives the same scene on every machine", function()
  check.equal(drawn.text(drawn.describe(25)), "25: plane_strain, joined, block; a L2 4x4 neo_hookean, b N3-N3.1 3x3 "
    .. "neo_hookean, c N2 2x3 ogden; equal-multipliers mu 0.7; odd: wild waves, points far away, extreme Poisson's "
    .. "ratio, narrow knot span, narrow knot span, extreme friction penalty, extreme offset, extreme load")
end)

check.case("generated scenes: nothing infinite, no forces that do not cancel, no internal error", function()
  -- Scene 15, with an extreme Poisson's ratio, fails; its reason is that of rounding.
  local result = survey.run(16, 60, "some")
  check.equal(result.found, {})
  check.equal(result.apart, {})
  local refused, completed = result.outcomes.refused or 0, result.outcomes.completed or 0
  assert(refused > 10 and completed > 10, ("%d refused, %d completed"):format(refused, completed))
end)

check.case("scenes that look at one thing each", function()
  for i, family in ipairs(families.names) do
    local result = survey.run(10 * i, 3, "none", nil, family)
    check.equal({ family, result.found, result.apart }, { family, {}, {} })
  end
end)

-- ── Errors that the generator has found ──────────────────────────────────────────────────────────────────────────────

local soft = sg.neo_hookean{ E = 1, nu = 0.3 }

--- A slab of the width 4 and a narrower block above it, which overlaps it by 0.001.
local function pair(contact)
  local function box(width, height, bottom)
    return sg.shapes.rectangle{ width = width, height = height, corner = { -width / 2, bottom } }
  end
  local slab = sg.body{ patch = box(4, 1, -1), elements = { 8, 1 }, order = "N2", material = soft }
  local block = sg.body{ patch = box(1, 1, -0.001), elements = { 2, 1 }, order = "N2", material = soft }
  contact.slave, contact.master, contact.penalty = slab:face "north", block:face "south", 100
  return scenes.model{ bodies = { slab = slab, block = block }, contacts = { touch = contact },
    supports = { bed = { on = "slab.south", fix = "xy" }, grip = { on = "block.north", drive = "xy" } } }
end

check.case("beyond an end of the master nothing overlaps: gaps are distances, without a sign", function()
  for _, method in ipairs{ "gpts", "mortar" } do
    local model = pair{ method = method, overlap = "interference" }
    local profile = model:profile "touch"
    for i, gap in ipairs(profile.gap) do
      local beyond = math.abs(profile.X[i]) - 0.65 -- the extension included
      if beyond > 0.2 then check.within("gap", gap, math.sqrt(beyond ^ 2 + 1e-6), 1e-9) end
    end
    check.equal(model:run{ { steps = 1, grip = { 0, -0.01 } } }.reason, "completed")
  end
end)

check.case("a collapsed face in contact is an error", function()
  local points = {}
  for j = 0, 2 do
    for i = 0, 2 do points[#points + 1] = { j == 2 and 0 or i, j - 2 } end
  end
  local cone = sg.body{
    patch = sg.nurbs.surface{ degrees = { 2, 2 }, knots = { { 0, 0, 0, 1, 1, 1 }, { 0, 0, 0, 1, 1, 1 } },
                              points = points },
    elements = { 1, 1 }, order = "N2", material = soft,
  }
  local function touch(face)
    return scenes.model{ bodies = { cone = cone }, supports = { bed = { on = "south", fix = "xy" } },
                     contacts = { tip = { slave = cone:face(face), penalty = 1,
                                          master = sg.rigid.plane{ point = { 0, 1 }, normal = { 0, -1 } } } } }
  end
  check.holds(check.fails(function() touch "north" end),
    "contacts.tip.slave: face 'north' of body 'cone' is collapsed and has no area")
  check.equal(#touch("east"):warnings(), 0)
end)

check.case("a roller deep in a slab is an error, also where multipliers are open in the mean", function()
  local slab = scenes.body{ size = {2, 1}, corner = { -1, -1 }, elements = { 1, 1 }, order = "N4", material = soft }
  for _, keys in ipairs{ { penalty = 30 }, { penalty = 30, method = "mortar" },
                          { method = "mortar", multipliers = "equal", enforcement = "multipliers" } } do
    keys.slave, keys.master = slab:face "north", sg.rigid.cylinder{ center = { 0, 0.02 }, radius = 0.1 }
    check.fails(function()
      scenes.model{ bodies = { slab = slab }, contacts = { touch = keys },
                supports = { bed = { on = "south", fix = "xy" } } }
    end, "the obstacle is inside body 'slab' at the start", "deep inside the obstacle")
  end
end)

check.case("loose bodies complete: friction has no forecast of the touch where damping closes a contact", function()
  for _, seed in ipairs{ 8, 41, 117 } do -- mortar, Gauss points
    local result = survey.run(seed, 1, "none", nil, "loose")
    check.equal({ seed, result.found, result.outcomes.completed }, { seed, {}, 1 })
  end
end)

check.case("overlaps of faces in a contact none of whose points is active", function()
  local function warnings(seed)
    local account = checks.solve(drawn.describe(seed))
    check.equal(account.outcome, "completed")
    return table.concat(account.run.warnings, "\n")
  end
  -- An arch that enters the face between its points
  check.holds(warnings(352), "face 'north' of body 'a' lies 0.023 behind face 'south' of body 'c'",
    "no point of contacts.k1 is active")
  -- A contact of the wrong face of a slab, whose other one the arch enters
  check.holds(warnings(1505), "face 'north' of body 'a' lies 0.0305 behind face 'south' of body 'c'",
    "the bodies pass through each other, because no contact is defined between these faces")
end)

check.case("loads that rounding errors exceed are a warning", function()
  local function warnings(knots)
    local patch = sg.shapes.rectangle{ width = 1, height = 1 }:insert(1, knots)
    local slab = sg.body{ patch = patch, elements = { #knots + 1, 1 }, order = "N2", material = soft }
    local model = scenes.model{ bodies = { slab = slab }, supports = { bed = { on = "south", fix = "xy" } },
      loads = { push = { on = "north", traction = { 0, 0 } } } }
    return model:run{ { steps = 1, push = { 1e-6, 0 } } }.warnings
  end
  check.equal(#warnings{ 0.5 }, 0)
  check.holds(warnings{ 1e-10 }[1], "rounding errors of forces, about",
    "% of the forces of supports, loads and contacts", "very narrow elements")
end)

check.case("reactions that do not balance by rounding error are a warning", function()
  local function warnings(width, strain)
    local bar = scenes.body{ size = {width, 1} }
    local model = scenes.model{ bodies = { bar = bar }, supports = {
      left = { on = "west", fix = "x" }, bed = { on = "south", fix = "y" },
      right = { on = "east", drive = "x" } } }
    local run = model:run{ { steps = 1, right = strain * width } }
    return run.warnings, model:reaction("left").fx / model:reaction("right").fx
  end
  local none, balance = warnings(1e4, 1e-3)
  check.equal(#none, 0)
  check.near(balance, -1, 1e-6)
  local found, wrong = warnings(1e9, 1e-3)
  check.equal(math.abs(wrong + 1) > 0.01, true)
  check.holds(found[1], "reactions balance only to", "of the forces of supports and loads", "rounding errors")
end)

check.case("an interference fit, which needs no supports and loads, has no warning of rounding errors", function()
  local steel, inner, middle, outer, interference = sg.linear_elastic{ E = 206000, nu = 0 }, 50, 100, 150, 0.02
  local function tube(from, to, count, face)
    return scenes.body{ size = {to - from, 20}, corner = { from, 0 },
                    elements = { 4, count }, contact = face, material = steel }
  end
  local shaft, hub = tube(inner, middle, 3, "east"), tube(middle, outer, 4, "west")
  local model = scenes.model{ kind = "axisymmetric", bodies = { shaft = shaft, hub = hub },
    supports = { low = { on = "shaft.south", fix = "y" }, seat = { on = "hub.south", fix = "y" } },
    contacts = { fit = { slave = "hub.west", master = "shaft.east", penalty = 1.2e6 } } }
  local run = model:run{ { steps = 2, contacts = { fit = { offset = interference } } } }
  check.equal(run.warnings, {})
  -- Lamé's pressure with nu = 0, by a penalty
  local function flexibility(r, R) return (R ^ 2 + r ^ 2) / (R ^ 2 - r ^ 2) end
  local right = interference * 206000 / middle / (flexibility(middle, outer) + flexibility(inner, middle))
  check.within_share("pressure", model:profile("fit").pressure[1], right, 1e-3)
end)

check.case("contact whose forces rounding errors exceed is a warning", function()
  local function warnings(knots)
    local slab = scenes.body{ material = soft, contact = "north" }
    local patch = sg.shapes.rectangle{ width = 0.5, height = 0.5, corner = { 0.25, 1 } }:insert(1, knots)
    local block = sg.body{ patch = patch, elements = { #knots + 1, 1 }, order = "N2",
                           material = sg.neo_hookean{ E = 1e6, nu = 0.3 }, contact = "south" }
    local model = scenes.model{ bodies = { slab = slab, block = block },
      supports = { bed = { on = "slab.south", fix = "xy" }, grip = { on = "block.north", drive = "xy" } },
      contacts = { touch = { slave = "block.south", master = "slab.north", penalty = 100 } } }
    return other_warnings(model:run{ { steps = 2, grip = { 0, -0.01 } } })
  end
  check.equal(#warnings{ 0.5 }, 0)
  check.holds(warnings{ 1e-6 }[1], "rounding errors of forces, about",
    "% of the forces of supports, loads and contacts")
end)
