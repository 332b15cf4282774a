-- Contact with per = "reference": the energy balance with its rate, the linear solver, pressures against those per
-- current area, checkpoints, wrong calls.

require "check"
local show = require "signorini.prompt.show"

core.quiet = true

--- A block of unit size (a disc of unit radius, a cube) on a plane, pressed without friction; its sides are free.
local function block(options)
  local kind, shape, more = options.kind, sg.shapes.rectangle{ width = 1, height = 1 }, {}
  if kind == "solid" then shape = sg.nurbs.extrude{ patch = shape, along = { 0, 0, 1 } } end
  local body = scenes.body{ patch = shape, elements = kind == "solid" and { 1, 1, 1 } or { 2, 2 }, contact = "south",
    E = 10 }
  if kind == "solid" then more = { front = { on = body:face "front", fix = "z" } } end
  more.grip, more.middle = { on = body:face "north", drive = "y" }, { on = body:face "west", fix = "x" }
  return scenes.model{ kind = kind == "axisymmetric" and kind or nil, bodies = { block = body }, supports = more,
    contacts = { touch = { slave = "south", penalty = options.penalty or 20, per = options.per,
        enforcement = options.enforcement, master = sg.rigid.plane{ point = kind == "solid" and { 0, 0, 0 } or { 0, 0 },
          normal = kind == "solid" and { 0, 1, 0 } or { 0, 1 } } } } }
end

--- A disc over a slab that touches in more and more points, both deformable.
local function disc(options)
  return scenes.model{
    bodies = { die = { patch = sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = { 1.2, 1.5 } },
        elements = { 6, 2 }, order = "N2-N2.2", contact = "south", E = 10 },
      slab = { size = {3, 1}, elements = { 8, 3 }, contact = "north" } },
    supports = { bed = { on = "slab.south", fix = "xy" }, grip = { on = { "die.west", "die.east" }, drive = "xy" } },
    contacts = { touch = { slave = "slab.north", master = "die.south", penalty = options.penalty or 20,
        per = options.per or "reference",
        friction = options.mu and { mu = options.mu, penalty = options.penalty or 20 } or nil } } }
end

local function path(steps)
  return { { name = "press", steps = steps, grip = { 0, -0.23 } },
           { name = "slide", steps = 2 * steps, grip = { 0.3, -0.23 } } }
end

-- ── Energy ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- What is missing from the balance, as a fraction of the work; second without the growth of the area.
local function missing(model)
  local e = model:energy()
  local without = (e.work - e.stored - e.contact - e.friction) / e.work
  return without + e.area_growth / e.work, without, e
end

check.case("the balance is exact in the limit: its error falls with the square of the step", function()
  for _, kind in ipairs { "plane", "axisymmetric", "solid" } do
    for _, per in ipairs { "reference", "current" } do
      local last, first_without
      for _, steps in ipairs { 16, 32, 64 } do
        local model = block{ kind = kind, per = per }
        check.completed(model:run({ { steps = steps, grip = -0.3 } }))
        local now, without, energy = missing(model)
        if last then check.within(kind .. ", part that half the step leaves", now / last, 0.25, 0.01) end
        first_without = first_without or without
        if per == "reference" then
          check.equal({ energy.area_growth, energy.friction }, { 0, 0 })
        else -- what is missing without the growth remains
          check.within_share(kind .. ", per current area", without, first_without, 0.05)
          check.equal(without < -0.005, true)
        end
        last = now
      end
      check.at_most(kind, last, 1e-4)
    end
  end
end)

check.case("it is exact where points close and open along the path, and between deformable bodies", function()
  for _, per in ipairs { "reference", "current" } do
    local errors = {}
    for i, steps in ipairs { 8, 32 } do
      local model = disc{ per = per }
      check.completed(model:run(path(steps)))
      errors[i] = missing(model)
    end
    check.at_most("a quarter of the step", errors[2] / errors[1], 1 / 8)
    check.at_most("32 steps", errors[2], 2e-4)
  end
end)

check.case("with friction it is exact up to the penetration", function()
  local function leak(penalty)
    local model = disc{ mu = 0.3, penalty = penalty }
    check.completed(model:run(path(32)))
    local error, _, energy = missing(model)
    check.equal({ energy.area_growth, energy.friction > 0.1 * energy.work }, { 0, true })
    return error
  end
  check.at_most("stiffer penalty", leak(200) / leak(20), 0.4)
end)

-- ── The linear solver ────────────────────────────────────────────────────────────────────────────────────────────────

check.case("symmetric tangents take the symmetric solver, others do not", function()
  for _, case in ipairs { { { per = "reference" }, "reuse" }, { { per = "current" }, "klu" },
                          { { per = "reference", mu = 0.3 }, "klu" } } do
    local model = disc(case[1])
    check.equal(model:cost().linear, case[2])
    check.completed(model:run(path(4)))
    check.equal(model:solver().linear, case[2])
  end
end)

check.case("Newton's method converges quadratically while no point changes its state", function()
  for _, kind in ipairs { "plane", "axisymmetric", "solid" } do
    local run = block{ kind = kind, per = "reference" }:run({ { steps = 4, grip = -0.3 } },
      { linear = "klu", newton = { tolerance = 1e-10 } })
    local above, r = {}, run:residuals(1)
    for _, value in ipairs(r) do
      if value > 1e-13 * r[1] then above[#above + 1] = math.log(value) end -- above rounding error
    end
    local n = #above
    check.within(kind .. ", order", (above[n] - above[n - 1]) / (above[n - 1] - above[n - 2]), 2, 0.2)
  end
end)

check.case("solvers and controls lead to the same state", function()
  local expected
  for _, options in ipairs { { linear = "klu" }, { linear = "umfpack" }, { linear = "reuse" }, sg.robust {},
                             { arc_length = true }, { newton = { line_search = "residual", tolerance = 1e-12 } } } do
    local model = disc {}
    options.newton = options.newton or { tolerance = 1e-12 }
    check.completed(model:run(path(4), options))
    local force = model:reaction "grip"
    expected = expected or force
    check.near({ force[1], force[2] }, { expected[1], expected[2] }, 1e-9)
  end
end)

-- ── Pressures ────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("profiles, pictures and resultants show pressures per current area", function()
  local model = block{ per = "reference", kind = "plane" }
  model:run{ { steps = 4, grip = -0.3 } }
  local profile, now, sum, area = model:profile "touch", model:contact_resultant "touch", 0, 0
  for i, p in ipairs(profile.pressure) do sum, area = sum + p * profile.area[i], area + profile.area[i] end
  check.near({ sum, area }, { now.fy, now.area }, 1e-12)
  local x = { math.huge, -math.huge }
  for xi = 0, 1 do
    local at = xi + model:sample("block", "ux", { xi, 0 })
    x = { math.min(x[1], at), math.max(x[2], at) }
  end
  check.near(area, x[2] - x[1], 1e-12)
  check.equal(area > 1.05, true)
  -- Gaps are uniform, and ε |g| is the pressure per reference area.
  check.near(profile.pressure[1] * area, 20 * -profile.gap[1], 1e-9)
  check.near(model:sample("block", "contact_pressure", { 0.5, 0 }), profile.pressure[1], 1e-9)
  check.near(-model:sample("block", "syy", { 0.5, 0 }), profile.pressure[1], 1e-9)
  check.equal(now.per, "reference")
  check.holds(show.text(model), "; tractions per reference area")
end)

check.case("a load path with friction slips at mu times the pressure", function()
  local model = disc{ mu = 0.2 }
  check.completed(model:run(path(12)))
  local profile, slips = model:profile "touch", 0
  for i, state in ipairs(profile.state) do
    if state == "slip" then
      slips = slips + 1
      check.within("traction", math.abs(profile.traction[i]) / profile.pressure[i], 0.2, 1e-12)
    end
  end
  check.equal(slips > 5, true)
end)
