-- Every reason for which a run may end, provoked on a small model: the reason, the place, the message. Most of them
-- with plain Newton, which ends at its first failure.

require "check"
local ironing = require "ironing"

-- ── Small models ─────────────────────────────────────────────────────────────────────────────────────────────────────

--- A unit square, or what `options` says, of neo-Hookean material with E = 1.
local function block(options)
  local o = options or {}
  return scenes.body{ size = {o.width or 1, o.height or 1}, corner = o.corner, order = o.order or "N2",
    elements = o.elements or {2, 2}, contact = o.contact or "south", thickness_degree = 1,
    material = o.material or sg.neo_hookean{ E = 1, nu = 0.3 } }
end

--- A square on a bed; its top is driven down.
local function press()
  local body = block()
  return scenes.model{ bodies = { block = body }, supports = {
    bed = { on = "south", fix = "xy" }, top = { on = "north", fix = "x", drive = "y" } } }
end

--- A square on a bed under a wind from above.
local function windy(supports)
  local body = block()
  return scenes.model{ bodies = { block = body }, supports = supports(body),
                   loads = { wind = { on = "north", traction = {0, 0} } } }
end

local function on_bed(body) return { bed = { on = body:face "south", fix = "xy" } } end

--- A soft bar above the lower end of a ramp, that the bar is pushed over as it is lowered.
local function bar_on_ramp()
  local bar = block{ width = 0.1, height = 2, corner = {-0.105, 0.1}, elements = {2, 8},
                     material = sg.linear_elastic{ E = 1, nu = 0.3 } }
  local ramp = scenes.body{
    patch = sg.shapes.rectangle{ width = 2, height = 0.5, corner = {-2, -0.5} }:rotate{ angle = -25, center = {0, 0} },
    elements = {100, 2}, contact = "north", thickness_degree = 1, material = sg.linear_elastic{ E = 100, nu = 0.3 } }
  return sg.model{
    bodies   = { bar = bar, ramp = ramp },
    supports = { top = { on = bar:face "north", fix = "x", drive = "y" },
      bed = { on = ramp:face "south", fix = "xy" } },
    contacts = { edge = { slave = bar:face "south", master = ramp:face "north", penalty = 10, points = 3 } },
  }
end

--- The run failed for this reason after so many steps; its failure holds the fragments. Returns its worst place.
local function expect(run, reason, steps, ...)
  check.equal({ run.failed, run.reason, run.cause, run.steps }, { true, reason, reason, steps })
  check.holds(run.failure, ...)
  return run.places[1]
end

-- ── Ends that somebody wants ─────────────────────────────────────────────────────────────────────────────────────────

check.case("completed", function()
  local run = press():run{ { steps = 2, top = -0.1 } }
  check.equal({ run.failed, run.reason, run.cause, run.failure }, { false, "completed" })
  check.equal(run.places, {})
end)

check.case("stopped by on_step and by on_iteration", function()
  local model = press()
  local run = model:run({ { steps = 4, top = -0.2 } },
    { on_step = function(info) return info.step == 2 and "stop" end })
  check.equal({ run.failed, run.reason, run.steps, model:target("top")[1] }, { false, "stopped", 2, -0.1 })
  model = press()
  run = model:run({ { steps = 4, top = -0.2 } },
    { on_iteration = function(info) return info.step == 3 and info.iteration == 1 and "stop" end })
  check.equal({ run.failed, run.reason, run.steps, model:target("top")[1] }, { false, "stopped", 2, -0.1 })
  check.equal(run:attempts(3)[1].reason, "stopped")
  -- The model is as it was after the last step.
  check.near(model:reaction("top"), { run:column("top.fx")[2], run:column("top.fy")[2] }, 1e-12)
end)

check.case("cut, where no shorter steps are allowed", function()
  local run = press():run({ { steps = 1, top = -0.2 } }, sg.plain{ on_step = function() return "cut" end })
  check.equal(expect(run, "cut", 0, "on_step requested shorter steps, but these are not allowed. "
    .. "Hint: set step = { adaptive = true",
    "The model is at its last accepted step, its start."), nil)
  run = press():run({ { name = "crush", steps = 2, top = -0.2 } },
    sg.plain{ fallback = true,
              on_iteration = function(info) return info.step == 2 and info.iteration == 2 and "cut" end })
  check.equal(expect(run, "cut", 1,
    "step 2 (stage 'crush', 2 of 2) was not reached: on_iteration requested it in iteration 2",
    "last accepted step, 1"), nil)
  check.equal(#run:attempts(2), 1) -- who wants a cut wants no fallback
end)

check.case("interrupted: Ctrl-C ends the run at its last step, and the model can be used further", function()
  local output, status = check.program({}, ("file = %q\n"):format(check.file "run.sgn") .. [==[
    b = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = {16, 16}, order = "N2",
      contact = "south", thickness_degree = 1, material = sg.neo_hookean{ E = 1, nu = 0.3 } }
    m = sg.model{ bodies = { block = b },
      supports = { bed = { on = b:face "south", fix = "xy" }, top = { on = b:face "north", drive = "xy" } } }
    -- Once the file was written twice steps have been accepted.
    timer = io.popen(([=[until [ -e %s ]; do kill -0 $PPID || exit; sleep 0.02; done; first=$(stat -c %%y %s)
      while [ "$(stat -c %%y %s)" = "$first" ]; do sleep 0.02; done; kill -INT $PPID]=]):format(file, file, file))
    m:run({ { name = "shear", steps = 1000000, top = {0.3, 0} } }, { checkpoint = { file = file, every = 2 } })
    first = _
    print(first.reason, first.cause, first.failed, first.steps > 0, first.steps == first.rows, #first.places)
    print(first.failure:match "not reached: [^.]*",
          first.failure:match "last accepted step, %d+" == "last accepted step, " .. first.steps)
    print("again:", m:run{ { steps = 2, top = {0, 0} } }.reason)
  ]==])
  check.holds(output, "interrupted; _ is the run so far\n", "interrupted\tinterrupted\ttrue\ttrue\ttrue\t0\n",
    "not reached: stopped by Ctrl-C\ttrue", "again:\tcompleted")
  check.equal(status, 1) -- a line of the input failed
end)

-- ── Newton's method ──────────────────────────────────────────────────────────────────────────────────────────────────

check.case("iterations: too few, with the largest unbalanced forces", function()
  local body = block()
  local model = scenes.model{ bodies = { block = body }, supports = {
    bed = { on = "south", fix = "xy" }, top = { on = "north", drive = "xy" } } }
  local run = model:run({ { name = "shear", steps = 1, top = {0.3, 0} } }, sg.plain{ newton = { iterations = 2 } })
  local place = expect(run, "iterations", 0,
    "step 1 (stage 'shear', 1 of 1) was not reached: no convergence after 2 iterations",
    "Worst places: control point", "Hint: allow more iterations")
  check.equal({ place.kind, place.body }, { "control point", "block" })
  check.near(place.X[2], 0.5, 1e-12) -- neither supported face
  check.holds(place.text, "unbalanced force")
end)

check.case("singular: a soft body falls onto one of extreme stiffness", function()
  local soft = sg.linear_elastic{ E = 1, nu = 0.3 }
  local upper = block{ corner = {0, 1.5}, material = soft }
  local lower = block{ width = 2, corner = {-0.5, 0}, elements = {2, 4}, contact = "north", material = soft }
  local model = scenes.model{ bodies = { upper = upper, lower = lower },
    supports = { top = { on = "upper.north", fix = "xy" }, bed = { on = "lower.south", fix = "xy" } },
    loads = { pull = { on = "upper.south", traction = {0, 0} } },
    contacts = { floor = { slave = "upper.south", master = "lower.north", penalty = 1e15 } } }
  local run = model:run({ { steps = 1, pull = {0, -1} } }, sg.plain{})
  local place = expect(run, "singular", 0, "the tangent is singular", "at this ratio the body's stiffness is lost",
    "Hint: lower the penalty of contact 'floor'")
  check.equal(place.kind, "control point")
  check.near(place.X[2], place.body == "upper" and 1.5 or 1, 1e-12) -- on the faces that meet
end)

check.case("cycling: points of deep ironing alternate", function()
  -- One point goes to and fro between both sides of a state.
  local deep = ironing{ E = 1e4, mu = 0.1, order = "N4", penalty = 1000, points = 7 }
  local run = deep:run({ { name = "press", steps = 46, grip = {0, -0.5} } }, sg.plain{})
  local last = run.steps
  check.equal(last > 20, true) -- which step has such a point depends on the first guesses before it
  local place = expect(run, "cycling", last, ("step %d (stage 'press', %d of 46)"):format(last + 1, last + 1),
    "the states of contact points repeat every ", "of contact 'interface', the first in slave",
    "Worst places: contact point in slave element", "Hint: take smaller steps", "active_set_changes")
  check.equal({ place.kind, place.contact }, { "contact point", "interface" })
  check.equal(place.text == "stick / slip" or place.text == "slip / stick", true)
  check.near((place.X[1] - 0.75) ^ 2 + (place.X[2] - 1.5) ^ 2, 0.25, 1e-9) -- on the die's face
  check.near(place.x[2], place.X[2] - 0.5 * last / 46, 5e-3) -- the die is nearly rigid; the state is the accepted one
end)

check.case("lost_projection: a bar slides off the end of a ramp", function()
  local run = bar_on_ramp():run({ { name = "lower", steps = 4, top = -0.25 } }, sg.plain{})
  local place = expect(run, "lost_projection", 1, "of contact 'edge'", "touching / beyond",
    "Hint: extend the master face beyond the reach of the slave face")
  check.equal({ place.kind, place.contact, place.element }, { "contact point", "edge", 1 })
  check.near(place.X[2], 0.1, 1e-12)
end)

check.case("inverted: a block pressed flat and farther", function()
  local run = press():run({ { name = "crush", steps = 1, top = -1.2 } }, sg.plain{})
  local place = expect(run, "inverted", 0, "of body 'block' is inverted (J = -0.", "Worst places: element",
    "Hint: take smaller steps")
  check.equal({ place.kind, place.body, place.value < 0 }, { "element", "block", true })
  check.near(place.x, place.X, 1e-12) -- where the last accepted state, the first one, has it
  local i, j = place.X[1] < 0.5 and 1 or 2, place.X[2] < 0.5 and 0 or 1
  check.equal(place.element, i + 2 * j)
end)

check.case("singular: an unconstrained body, and its motion", function()
  local run = windy(function(body) return { wall = { on = body:face "west", fix = "x" } } end)
    :run({ { steps = 1, wind = {0, -0.1} } }, sg.plain{})
  local place = expect(run, "singular", 0,
    "the tangent is singular; its critical direction is a rigid-body translation of body 'block' along (0, ",
    "add a support to the body", "damping = true")
  check.equal({ place.kind, place.body }, { "control point", "block" })
  run = windy(function(body) return { pin = { on = body:corner "south-west", fix = "xy" } } end)
    :run({ { steps = 1, wind = {0.1, 0} } }, sg.plain{})
  place = expect(run, "singular", 0, "rigid-body rotation of body 'block'")
  check.near(place.X, { 1, 1 }, 1e-12) -- farthest from the pin
end)

check.case("a fine block on a plane without friction, factored in single precision", function()
  local block = scenes.body{ size = { 1, 1, 0.7 }, elements = { 10, 10, 10 }, contact = "front", thickness_degree = 2,
    E = 10 }
  local plane = sg.rigid.plane{ point = { 0, 0, 0 }, normal = { 0, 0, 1 } }
  local model = scenes.model{ bodies = { block = block }, supports = { top = { on = "back", drive = "z" } },
    contacts = { floor = { slave = "front", master = plane, penalty = 100, points = 3 } } }
  local run = model:run({ { steps = 1, top = { -0.01 } } }, sg.plain{ linear = "reuse" })
  -- The last digits, which depend on the processor, decide whether a pivot is zero or negative.
  check.equal(run.reason == "singular" or run.reason == "indefinite", true)
  check.holds(run.failure, "nothing holds body 'block' against translations along x and y")
end)

check.case("singular: all motions of a body that nothing holds", function()
  local block = scenes.body{ size = { 1, 1, 1 }, elements = { 1, 1, 1 } }
  local floor = sg.rigid.plane{ point = { 0, 0, 0 }, normal = { 0, 0, 1 } }
  local lid = sg.rigid.plane{ point = { 0, 0, 1 }, normal = { 0, 0, -1 } }
  local model = scenes.model{ bodies = { block = block }, supports = { press = { on = lid, drive = "z" } },
    contacts = { below = { slave = "front", master = floor, penalty = 50 },
                 above = { slave = "back", master = lid, penalty = 50 } } }
  local run = model:run({ { steps = 1, press = { -0.1 } } }, sg.plain{})
  check.equal(run.reason, "singular")
  check.holds(run.failure, "nothing holds body 'block' against translation along x and y and rotation about z")
end)

check.case("singular: a ring too wide for any hoop stress; a radial motion is not a rigid one", function()
  local ring = scenes.body{ corner = { 1e9, 0 }, elements = { 1, 1 },
    material = sg.linear_elastic{ E = 1000, nu = 0.3 } }
  local run = scenes.model{ kind = "axisymmetric", bodies = { ring = ring }, loads = { p = { on = "west",
                        pressure = 0 } }, supports = { ends = { on = { "south", "north" },
                        fix = "y" } } }:run({ { steps = 1, p = 1 } }, sg.plain{})
  expect(run, "singular", 0, "in its critical direction, control point", "of body 'ring'", "moves most")
  assert(not run.failure:find "rigid")
end)

check.case("friction_exhausted: a block that its weight presses on a floor is pushed by a growing force", function()
  local mu, weight = 0.3, 1e-2
  for _, space in ipairs { false, true } do
    local body = space and scenes.body{ size = {1, 1, 1}, contact = "front", thickness_degree = 1 } or block()
    local floor = space and sg.rigid.plane{ point = {0, 0, 0}, normal = {0, 0, 1} }
      or scenes.floor()
    local model = sg.model{ bodies = { block = body },
      loads = { own = { on = body, force = space and {0, 0, 0} or {0, 0} } },
      contacts = { c = { slave = body:face(space and "front" or "south"), master = floor, penalty = 100,
                         friction = { mu = mu, penalty = 100 } } } }
    local function force(x) return space and {0.6 * x, 0.8 * x, -weight} or {x, -weight} end
    check.equal(model:run{ { steps = 1, own = force(0) } }.reason, "completed")
    local run = model:run{ { steps = 10, own = force(0.35 * weight) } }
    check.equal({ run.reason, run.cause, run.steps }, { "minimum_step", "friction_exhausted", 8 })
    check.holds(run.failure, "friction of contact 'c', which alone holds body 'block', is exhausted",
      "the body slides from here on")
    local normal, demanded =
      run.failure:match "press on it with (%S+) and demand a friction of (%S+), 0%.3%d+ times as much; mu is 0%.3"
    check.near(tonumber(normal), weight, 1e-3 * weight)
    check.equal(tonumber(demanded) > mu * weight, true)
    check.equal(run.failure:find("add a support to the body", 1, true), nil)
    check.equal(run.iterations < 200, true)
    -- Cut down to the limit, up to 1/64 of a step
    local own = model:target "own"
    check.near(math.sqrt(own[1] ^ 2 + (space and own[2] ^ 2 or 0)), mu * weight, 0.035 * weight / 32)
  end
end)

check.case("friction_exhausted: a saddle that is pulled above its face slides before mu times its weight", function()
  local mu, weight, R, arm = 0.3, 1e-2, 1, 1.5
  local function arc(radius) return sg.nurbs.arc{ center = {0, 0}, radius = radius, from = 110, to = 70 } end
  local saddle = scenes.body{ patch = sg.nurbs.ruled{ a = arc(R), b = arc(arm) }, elements = {4, 2}, contact = "south",
    E = 10 }
  local model = scenes.model{ bodies = { saddle = saddle }, loads = { top = { on = "north", traction = {0, 0} } },
    contacts = { c = { slave = "south", master = sg.rigid.cylinder{ center = {0, 0}, radius = R }, penalty = 100,
      friction = { mu = mu, penalty = 100 } } } }
  local length = arm * math.rad(40)
  local function force(x) return { x / length, -weight / length } end
  check.equal(model:run{ { steps = 1, top = force(0) } }.reason, "completed")
  local run = model:run{ { steps = 10, top = force(0.3 * weight) } }
  check.equal(run.cause, "friction_exhausted")
  local normal, demanded, ratio = run.failure:match(
    "press on it with (%S+) and demand a friction of (%S+), (%S+) times as much; " ..
    "mu is 0%.3, and all touching points slip")
  normal, demanded, ratio = tonumber(normal), tonumber(demanded), tonumber(ratio)
  check.near({ normal, ratio * normal }, { weight, demanded }, 1e-3 * weight)
  -- Moments about the center: the pull, at most at the height `arm`, balances mu R times the sum of the pressures.
  check.equal({ demanded > mu * R / arm * weight, ratio < mu }, { true, true })
end)

check.case("indefinite: a column beyond Euler's load", function()
  local body = block{ width = 0.5, height = 10, elements = {1, 8}, order = "N3", contact = "west" }
  local model = scenes.model{ bodies = { column = body }, supports = {
    bed = { on = "south", fix = "xy" }, top = { on = "north", drive = "y" } } }
  local run = model:run({ { steps = 1, top = -0.1 } }, sg.plain{ newton = { iterations = 1 } })
  local place = expect(run, "indefinite", 0, "no convergence after 1 iteration:", "the tangent is indefinite there",
    "of body 'column'", "limit or turning point", "take smaller steps",
    "arc length can only start after an accepted step")
  check.equal({ place.kind, place.body, place.X[2] > 8 }, { "control point", "column", true }) -- it swerves at the top
end)

check.case("nan: forces whose squares overflow", function()
  local run = windy(on_bed):run({ { steps = 1, wind = {1e200, 0} } }, sg.plain{})
  local place = expect(run, "nan", 0, "the residual is not a finite number", "Hint: take smaller steps")
  check.equal({ place.kind, place.body, place.X[2] }, { "control point", "block", 1.0 })
end)

check.case("line_search: no part of the move helps where a point opens and closes", function()
  local run = bar_on_ramp():run({ { name = "lower", steps = 2, top = -0.15 } },
    sg.plain{ newton = { line_search = "residual" } })
  local place = expect(run, "line_search", 1, "line search failed: no step length down to 1/128",
    "Hint: take smaller steps", "do without the line search")
  check.equal({ place.kind, place.body }, { "control point", "ramp" })
  local slope = math.rad(25)
  check.near(place.X, { -0.05 * math.cos(slope), 0.05 * math.sin(slope) }, 1e-9) -- near its end
end)

-- ── Paths ────────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("turning_point: an arch under a load above its limit load", function()
  local function line(offset) return sg.nurbs.arc{ center = {0, -40}, radius = 40 + offset, from = 100, to = 80 } end
  local model = scenes.model{
    bodies = { arch = { patch = sg.nurbs.ruled{ a = line(-0.15), b = line(0.15) }, elements = {16, 1}, order = "N3",
        thickness_degree = 2, contact = "north", E = 1000, nu = 0 } },
    supports = { left = { on = "west", fix = "xy" }, right = { on = "east", fix = "xy" } },
    loads = { push = { on = "north", traction = {0, 0} } } }
  -- more: it jumps
  local run = model:run({ { name = "load", steps = 20, push = {0, -0.02} } },
    sg.plain{ newton = { iterations = 8 } })
  check.equal({ run.failed, run.reason, run.cause }, { true, "turning_point", "turning_point" })
  check.holds(run.failure, "The path has a turning point at push.ty = -0.0", "arc_length = true")
  local turn = -tonumber(run.failure:match "push%.ty = ([-%d.]+)")
  local reached = -run:column("push.ty")[run.steps]
  check.equal({ reached > 0.005, turn >= reached - 1e-9, turn < reached + 0.001 }, { true, true, true })
end)

check.case("minimum_step: shorter steps are not allowed; the cause is also given", function()
  local run = press():run({ { name = "crush", steps = 1, top = -1.2 } }, { step = { adaptive = true, min = 0.25 } })
  check.equal({ run.failed, run.reason, run.cause, run.steps, run.cutbacks },
    { true, "minimum_step", "inverted", 0, 2 })
  check.holds(run.failure, "is inverted", "The smallest increment allowed, 0.25 of the step, failed.",
    "last accepted increment, 0.75 of the way from step 0 to step 1")
  check.equal({ run.places[1].kind, run.places[1].body }, { "element", "block" })
end)
