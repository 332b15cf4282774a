-- Twisting with friction: torque and force of a hollow hemisphere pressed into a cube and rotated.
--
-- Problem: a hollow hemisphere rests on a cube; its ring is pressed down without friction, then rotated about its axis
--          with friction.
--
--               ↻  ring: u_z = −1 in 10 steps, then rotated by 180° about z in 90 steps
--          ┌┐       ┌┐   hollow hemisphere, radii 2/3 and 1, neo-Hooke, E = 5
--           \ \   / /    friction mu = 0.5, normal and tangential penalty 100
--        ┌────`───'────┐
--        │             │ cube, side 2, neo-Hooke, E = 1, bottom clamped; nu = 0.3 both
--        └─────────────┘
--
--          Meshes of the hemisphere (along its arcs, in the thickness direction) and of the cube: m1 4 × 4 × 1 and
--          4 × 4 × 2, m2 6 × 6 × 2 and 6 × 6 × 3, m3 8 × 8 × 2 and 8 × 8 × 4, m4 16 × 16 × 4 and 16 × 16 × 8; degree
--          2 in the thickness direction.
--          Flat punches on a rigid plane, for which closed forms exist: a block with a square face of side 2 and a tube
--          of radii 1/2 and 1, E = 10, nu = 0, pressed by 0.01 of their height 1, rotated by 20° in 10 steps.
-- Source: after the twisting contact of R. A. Sauer, L. De Lorenzis, An unbiased computational contact formulation
--         for 3D friction, Int. J. Numer. Meth. Engng 101, 2015, 251 to 280; penalties and meshes are chosen here,
--         published values were not available. Uniform pressure in a disc clutch: R. G. Budynas, J. K. Nisbett,
--         Shigley's Mechanical Engineering Design, McGraw-Hill, section 16-5. Plain Newton; failed steps are cut.
-- Units: any consistent units; stresses relative to E of the cube, lengths to the outer radius of the hemisphere,
--        angles in degrees.
-- Expected: the torque rises while slip spreads inwards from the edge of contact, then is constant at mu ∫ p r dA of
--           the contact profile once all points slip. Punches: M = mu ∫ p r dA to 1 %, and to 1 % the torque of a
--           uniform pressure: mu N (√2 + ln(1 + √2))/3 for the square, mu N 2/3 (Ro³ − Ri³)/(Ro² − Ri²) for the tube.
--           The difference in energy, work − stored − contact − friction, decreases with the step size.
-- Run: signorini twisting3d.lua [parts=twist,punch,balance] [orders=N2,N4,N2-N4,N2-N2.2] [meshes=m1]
--      [press=10] [twist=90] [angle=180] [friction=turn] [slave=hemisphere] [poles=ends] [formulation=gpts]
--      [linear=auto] [out=out/twisting3d] [page=none]; friction: turn, or always, also while pressed; slave: hemisphere
--      or cube; page: folder of twisting3d.md, whose table of the punches is filled;
--      poles: ends or bottom, see help(sg.shapes.hollow_hemisphere); formulation: a row of formulations/rows.lua, such
--      as equal or reduced-multipliers (not of the punches).

local sg = require "signorini"
local page = require "page.tables"
local formulations = require "formulations.rows"

local mu, penalty, depth = 0.5, 100, 1
local meshes = { m1 = { {4, 4, 1}, {4, 4, 2} }, m2 = { {6, 6, 2}, {6, 6, 3} }, m3 = { {8, 8, 2}, {8, 8, 4} },
                 m4 = { {16, 16, 4}, {16, 16, 8} } }

-- ── Scenes ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The hemisphere on the cube.
local function scene(o, options)
  local cube = sg.body{
    patch    = sg.shapes.block{ size = { 2, 2, 2 }, corner = { -1, -1, -2 } }, elements = meshes[o.mesh][2],
    order    = o.order, contact = "back", thickness_degree = 2, material = sg.neo_hookean{ E = 1, nu = 0.3 },
  }
  local hemisphere = sg.body{
    patch    = sg.shapes.hollow_hemisphere{ inner = 2 / 3, outer = 1, center = { 0, 0, 1 }, poles = options.poles },
    elements = meshes[o.mesh][1], order = o.order, contact = "front", thickness_degree = 2,
    material = sg.neo_hookean{ E = 5, nu = 0.3 },
  }
  local ring = options.poles == "ends" and { hemisphere:face "west", hemisphere:face "east" } or hemisphere:face "south"
  local slave, master = hemisphere:face "front", cube:face "back"
  if options.slave == "cube" then slave, master = master, slave end
  return sg.model{
    bodies   = { cube = cube, hemisphere = hemisphere },
    supports = { bed  = { on = cube:face "front", fix = "xyz" },
                 ring = { on = ring, drive = "z", fix = "xy", rotate = "z" } },
    contacts = { joint = formulations.contact(formulations[options.formulation], {
      slave = slave, master = master, penalty = penalty, friction = { mu = mu, penalty = penalty } }) },
  }, cube:dofs().total + hemisphere:dofs().total
end

--- A punch with a flat face on a rigid plane, and the torque over mu N of a uniform pressure. Square of side 2:
---   ∫ r dA / A = (√2 + ln(1 + √2))/3;  tube: 2/3 (Ro³ − Ri³)/(Ro² − Ri²).
local function punch_scene(shape)
  local inner, body, foot, grip, arm = 0.5, nil, nil, nil, nil
  local material = sg.neo_hookean{ E = 10, nu = 0 }
  if shape == "square" then
    body = sg.body{ patch = sg.shapes.block{ size = { 2, 2, 1 }, corner = { -1, -1, 0 } }, elements = { 4, 4, 2 },
                    order = "N2", contact = "front", thickness_degree = 1, material = material }
    foot, grip, arm = body:face "front", body:face "back", (math.sqrt(2) + math.log(1 + math.sqrt(2))) / 3
  else
    local meridian = sg.nurbs.surface{ degrees = { 1, 1 }, knots = { { 0, 0, 1, 1 }, { 0, 0, 1, 1 } },
                                       points = { { inner, 0, 0 }, { inner, 0, 1 }, { 1, 0, 0 }, { 1, 0, 1 } } }
    body = sg.body{ patch = sg.nurbs.revolve{ patch = meridian }, elements = { 2, 4, 8 }, order = "N2",
                    contact = "west", thickness_degree = 1, material = material }
    foot, grip, arm = body:face "west", body:face "east", 2 / 3 * (1 - inner ^ 3) / (1 - inner ^ 2)
  end
  local plane = sg.rigid.plane{ point = { 0, 0, 0 }, normal = { 0, 0, 1 } }
  return sg.model{
    bodies   = { punch = body },
    supports = { grip = { on = grip, drive = "z", fix = "xy", rotate = "z" } },
    contacts = { joint = { slave = foot, master = plane, penalty = penalty,
                           friction = { mu = mu, penalty = penalty } } },
  }, arm
end

-- ── What is measured ─────────────────────────────────────────────────────────────────────────────────────────────────

--- Of a contact's profile: mu ∫ p r dA about the z axis, the moment ∫ (x t_y − y t_x) dA of the friction, how many
--- points stick and slip, the greatest pressure.
local function measure(profile)
  local m = { torque = 0, friction = 0, stick = 0, slip = 0, pressure = 0 }
  for i, pressure in ipairs(profile.pressure) do
    local x, y, area, state = profile.x[i], profile.y[i], profile.area[i], profile.state[i]
    m.torque = m.torque + mu * pressure * math.sqrt(x * x + y * y) * area
    m.friction = m.friction + (x * profile.ty[i] - y * profile.tx[i]) * area
    m.pressure = math.max(m.pressure, pressure)
    if m[state] then m[state] = m[state] + 1 end
  end
  return m
end

--- The error of the energy balance as a fraction of the work.
local function imbalance(energy)
  return (energy.work - energy.stored - energy.contact - energy.friction) / energy.work
end

--- Presses and twists. `o`: order, mesh, steps to press and to twist, on_step(model, row). Stores a row per
--- step; level, swing and ratio are those of the last third of the angle. A failed run keeps its rows.
local function twist(o, options)
  local model, dofs = scene(o, options)
  local case = { order = o.order, mesh = o.mesh, dofs = dofs, rows = {} }
  local sign = options.slave == "cube" and -1 or 1
  local function keep(info)
    local m, reaction, energy = measure(model:profile "joint"), model:reaction "ring", model:energy()
    case.rows[info.step] = { step = info.step, angle = model:target "ring"[2], force = -reaction[3],
                             moment = reaction[4], torque = m.torque, friction = sign * m.friction,
                             stick = m.stick, slip = m.slip, pressure = m.pressure, stored = energy.stored,
                             contact = energy.contact, dissipated = energy.friction, work = energy.work,
                             imbalance = imbalance(energy) }
    if o.on_step then o.on_step(model, case.rows[info.step]) end
  end
  local function friction(value) return { joint = { friction = { mu = value } } } end
  case.run = model:run({ { name = "press", steps = o.press, ring = { -depth, 0 },
                           contacts = friction(options.friction == "always" and mu or 0) },
                         { name = "twist", steps = o.twist, ring = { -depth, options.angle },
                           contacts = friction(mu) } },
                       sg.plain{ linear = options.linear, step = { adaptive = true }, on_step = keep })
  local least, most, sum, torque, off, count = math.huge, 0, 0, 0, 0, 0
  for _, row in ipairs(case.rows) do
    if row.angle > 0 and row.stick == 0 and not case.slips_from then case.slips_from = row.angle end
    if row.stick > 0 then case.slips_from = nil end
    if row.angle > 2 / 3 * options.angle then
      count, sum, torque = count + 1, sum + row.moment, torque + row.torque
      least, most = math.min(least, row.moment), math.max(most, row.moment)
      off = math.max(off, math.abs(row.moment / row.torque - 1))
    end
  end
  local last = case.rows[#case.rows]
  case.reached, case.imbalance = last and last.angle, last and last.imbalance
  if count > 0 then
    case.level, case.swing = sum / count, (most - least) / (sum / count)
    case.ratio, case.off = sum / torque, off
  end
  return case
end

local function press_and_turn(shape)
  local model, arm = punch_scene(shape)
  local run = model:run({ { name = "press", steps = 2, grip = { -0.01, 0 } },
                          { name = "turn", steps = 10, grip = { -0.01, 20 } } }, sg.plain{})
  if run.failed then error(("punch, %s: %s"):format(shape, run.failure), 0) end
  local m, reaction = measure(model:profile "joint"), model:reaction "grip"
  return { shape = shape, force = -reaction[3], moment = reaction[4], torque = m.torque, friction = m.friction,
           uniform = mu * -reaction[3] * arm, stick = m.stick, slip = m.slip }
end

-- ── Output ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local function twist_table(cases)
  local rows = {}
  for i, case in ipairs(cases) do
    local last = case.rows[#case.rows] or {}
    rows[i] = { case.order, case.mesh, case.dofs, case.reached, case.slips_from, last.force, case.level,
                case.swing and 100 * case.swing, case.ratio, case.off and 100 * case.off, case.imbalance,
                case.run.iterations, case.run.cutbacks, case.run.wall }
  end
  return sg.table{
    columns = { "order", "mesh", "DOFs", "reached", "slips from", "force", "torque", "swing", "M / μ∫pr dA", "most",
                "balance", "iterations", "halved", "wall" },
    units = { "", "", "", "°", "°", "", "", "%", "", "% off", "of work", "", "", "s" }, rows = rows,
    formats = { "%s", "%s", "%d", "%g", "%g", "%.4f", "%.4f", "%.2f", "%.4f", "%.2f", "%.1e", "%d", "%d", "%.0f" },
  }
end

local function punch_table(punches)
  local rows = {}
  for i, p in ipairs(punches) do
    rows[i] = { p.shape, p.force, p.moment, p.torque, 100 * (p.moment / p.torque - 1), p.uniform,
                100 * (p.moment / p.uniform - 1), p.moment / p.friction - 1, p.slip, p.stick }
  end
  return {
    columns = { "punch", "force", "torque", "μ∫pr dA", "off", "uniform p", "off", "M/∫(r×t)dA − 1", "slip", "stick" },
    units = { "", "", "", "", "%", "", "%", "", "points", "points" }, rows = rows,
    formats = { "%s", "%.5f", "%.6f", "%.6f", "%.3f", "%.6f", "%.3f", "%.0e", "%d", "%d" },
  }
end

local columns = { "step", "angle", "force", "moment", "torque", "friction", "stick", "slip", "pressure", "stored",
                  "contact", "dissipated", "work", "imbalance" }

local function write_rows(case, file)
  local data = { columns = columns, rows = {}, comments = {
    ("twisting, %s at %s; force: on the ring, downwards; moment: its torque; torque: mu times the integral of p r ")
      :format(case.order, case.mesh) .. "over the contact; friction: the moment of the tangential tractions" } }
  for i, row in ipairs(case.rows) do
    data.rows[i] = {}
    for k, name in ipairs(columns) do data.rows[i][k] = row[name] end
  end
  sg.csv.write(file, data)
end

--- A column over the angle of the twist, from the end of pressing on.
local function curve(case, key, style)
  local line = { x = {}, y = {}, marker = "none" }
  for name, value in pairs(style) do line[name] = value end
  for i, row in ipairs(case.rows) do
    local following = case.rows[i + 1]
    if row.angle > 0 or following and following.angle > 0 then
      line.x[#line.x + 1], line.y[#line.y + 1] = row.angle, row[key]
    end
  end
  return line
end

--- Torque and mu ∫ p r dA, or the force, over the angle.
local function draw(cases, key, ylabel, file)
  local chart = { file = file, title = "Twisting: " .. ylabel, xlabel = "angle (°)", ylabel = ylabel }
  for i, case in ipairs(cases) do
    local name = ("%s at %s"):format(case.order, case.mesh)
    chart[#chart + 1] = curve(case, key, { label = name, color = i })
    if key == "moment" then
      chart[#chart + 1] = curve(case, "torque", { label = i == 1 and "μ∫p r dA" or nil, dashed = true, color = i })
    end
  end
  sg.chart(chart)
end

--- Keeps the states at the end of pressing and at thirds of the angle as pictures, whole and cut through the middle.
local function keep_states(whole, cut, options)
  local following = 0
  return function(model, row)
    if row.step < options.press or row.angle < following - 1e-9 then return end
    following = following + options.angle / 3
    local title = ("%.0f°"):format(row.angle)
    whole[#whole + 1] = sg.picture{ model = model, field = "von_mises", title = title }
    cut[#cut + 1] = sg.picture{ model = model, field = "szz", title = title, cut = "-y", camera = "front" }
  end
end

local function draw_states(whole, cut, name, files)
  sg.sheet{ whole, columns = 2, range = { 0, 1.7 }, file = files "states.png", title = "Twisting, " .. name }
  sg.sheet{ cut, columns = 2, file = files "cut.png",
            title = ("Twisting, %s: the half y > 0"):format(name) }
end

--- The limit of three values on meshes whose elements are halved twice, by the rate with which they approach it:
---   f(h) = f₀ + C h^q;  2^q = (f₁ − f₂)/(f₂ − f₃),  f₀ = f₃ + (f₃ − f₂)/(2^q − 1).
--- Nil unless the differences decrease and have the same sign.
local function limit(first, second, third)
  local ratio = (first - second) / (second - third)
  if ratio > 1 then return third + (third - second) / (ratio - 1), math.log(ratio, 2) end
end

--- Torque and force at the end on m1, m3, m4, and their limits, of the orders that have run on the three.
local function limit_table(cases, orders)
  local rows = {}
  for _, order in ipairs(orders) do
    local runs = { cases[order .. " m1"], cases[order .. " m3"], cases[order .. " m4"] }
    if #runs == 3 and runs[1].level and runs[2].level and runs[3].level then
      for _, quantity in ipairs { "torque", "force" } do
        local values = {}
        for i, case in ipairs(runs) do
          values[i] = quantity == "torque" and case.level or case.rows[#case.rows].force
        end
        local at_zero, rate = limit(values[1], values[2], values[3])
        rows[#rows + 1] = { order, quantity, values[1], values[2], values[3], rate, at_zero }
      end
    end
  end
  if #rows == 0 then return end
  return sg.table{ columns = { "order", "", "m1", "m3", "m4", "rate", "limit" }, rows = rows,
                   formats = { "%s", "%s", "%.4f", "%.4f", "%.4f", "%.2f", "%.4f" } }
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

local options = sg.arguments{
  parts = { { "twist", "punch", "balance" }, choices = { "twist", "punch", "balance" } },
  orders = { "N2", "N4", "N2-N4", "N2-N2.2" }, meshes = { { "m1" }, choices = { "m1", "m2", "m3", "m4" } }, press = 10,
  twist = 90, angle = { 180.0, above = 0 }, friction = { "turn", choices = { "turn", "always" } },
  slave = { "hemisphere", choices = { "hemisphere", "cube" } },
  poles = { "ends", choices = { "ends", "bottom" } }, formulation = formulations.argument "gpts", linear = "auto",
  out = "out/twisting3d", page = "none",
}
local files, punches, cases, balance = sg.files(options.out), {}, {}, {}
local wanted = {}
for _, part in ipairs(options.parts) do wanted[part] = true end

if wanted.punch then
  for i, shape in ipairs { "square", "tube" } do punches[i] = press_and_turn(shape) end
  print "Punches with a flat face on a rigid plane: torque, μ∫pr dA of the profile and of a uniform pressure"
  local results = punch_table(punches)
  print(sg.table(results))
  page.fill(options, "twisting3d", "twisting3d_punch", { punch = page.pick(results, { 1, 2, 3, 4, 5, 6, 7, 8 },
    { "punch", "force N", "torque M", "μ∫p r dA", "M differs (%)", "uniform pressure", "M differs (%)",
      "M over moment of tractions − 1" }) })
end

if wanted.twist then
  local whole, cut = {}, {}
  for _, mesh in ipairs(options.meshes) do
    for _, order in ipairs(options.orders) do
      local case = twist({ order = order, mesh = mesh, press = options.press, twist = options.twist,
                           on_step = #cases == 0 and keep_states(whole, cut, options) or nil }, options)
      if case.run.failed then print(("%s at %s: %s"):format(order, mesh, case.run.failure)) end
      write_rows(case, files(("%s_%s.csv"):format(order, mesh)))
      cases[#cases + 1], cases[order .. " " .. mesh] = case, case
    end
  end
  print(("\nTwisting, slave: %s; torque and its swing (max − min): over the last third of the angle")
    :format(options.slave))
  print(twist_table(cases))
  local limits = limit_table(cases, options.orders)
  if limits then
    print "\nLimits of torque and force at the end; empty where the differences do not decrease with the mesh"
    print(limits)
  end
  draw(cases, "moment", "torque", files "torque.png")
  draw(cases, "force", "vertical force", files "force.png")
  draw_states(whole, cut, ("%s at %s"):format(options.orders[1], options.meshes[1]), files)
end

if wanted.balance then
  for i, factor in ipairs { 1, 2, 4 } do
    balance[i] = twist({ order = options.orders[1], mesh = options.meshes[1], press = factor * options.press,
                         twist = factor * options.twist }, options)
  end
  print "\nEnergy balance with smaller steps"
  print(twist_table(balance))
end
files:report()

return { cases = cases, punches = punches, balance = balance, files = files }
