-- Solids in 3D as a user writes them: sizes, places, reactions against closed forms and against the plane model.

require "check"

local E, nu = 10, 0.3
local linear, soft = sg.linear_elastic{ E = E, nu = nu }, sg.neo_hookean{ E = E, nu = nu }

--- The largest absolute value of a list.
local function largest(list)
  local most = 0
  for _, value in ipairs(list) do most = math.max(most, math.abs(value)) end
  return most
end

-- ── Bodies ───────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("bodies report their size, faces, edges and corners", function()
  local b = scenes.body{ size = {2, 1, 3}, elements = {4, 3, 2}, contact = "back", material = soft }
  -- N2 along x and y: 4 + 2 and 3 + 2 functions; through the body, in z, as well: 2 + 2
  check.equal({ b:dofs().interface, b:dofs().total }, { 3 * 6 * 5, 3 * 6 * 5 * 4 })
  check.equal(tostring(b), "solid body: 4 x 3 x 2 elements, degree 2 x 2 x 2, 360 degrees of freedom, E = 10, nu = 0.3")
  check.equal(tostring(b:face "back"), "face 'back' of a body, 30 control points")
  check.equal(tostring(b:face "east"), "face 'east' of a body, 20 control points")
  check.equal(tostring(b:edge "south-front"), "edge 'south-front' of a body, 6 control points")
  check.equal(tostring(b:edge "back-west"), "edge 'back-west' of a body, 5 control points")
  check.equal(tostring(b:corner "west-south-front"), "corner 'west-south-front' of a body, 1 control point")
  check.equal(tostring(b:corner "back-east-north"), "corner 'back-east-north' of a body, 1 control point")
  check.near(b:points()[1], { 0, 0, 0 })
  -- One type to users: a method is that of the object that it is called on.
  local flat = scenes.body{ material = soft }
  check.equal(b.dofs(flat).total, 2 * 4 * 4)
  check.equal(tostring(flat), "plane body: 2 x 2 elements, degree 2 x 2, 32 degrees of freedom, E = 10, nu = 0.3")
end)

check.case("an edge and a corner are intersections of their faces", function()
  local b = scenes.body{ size = {2, 1, 3}, contact = "back", material = linear }
  -- Only constrained points do not move under a pull: read off which these are.
  local model = scenes.model{ bodies = { b = b }, supports = { edge = { on = b:edge "south-back", drive = "xyz" },
      rest = { on = "front", fix = "xyz" }, tip = { on = "east-north-back", drive = "z" } } }
  model:run{ { steps = 1, edge = {0.1, 0.2, 0.3}, tip = -0.1 } }
  for _, x in ipairs{ 0, 0.4, 1 } do
    for i, field in ipairs{ "ux", "uy", "uz" } do check.near(model:sample(b, field, { x, 0, 1 }), 0.1 * i, 1e-12) end
  end
  check.near(model:sample(b, "uz", { 1, 1, 1 }), -0.1, 1e-12)
  check.near(model:sample(b, "u", { 0.3, 0.6, 0 }), 0)
  local sum = {}
  for i = 1, 3 do sum[i] = model:reaction "edge"[i] + model:reaction "rest"[i] + model:reaction "tip"[i] end
  check.near(sum, { 0, 0, 0 }, 1e-10)
end)

check.case("orders per direction along the face count as they say", function()
  local function dofs(order, contact)
    return scenes.body{ size = {1, 1, 1}, elements = {4, 3, 2}, order = order, contact = contact,
      thickness_degree = contact and 1, material = soft }:dofs()
  end
  -- N2.2 on 4 elements: 6 + 2 · 4 functions; N2 on 3 elements: 5
  check.equal({ dofs({"N2-N2.2", "N2"}, "back").interface, dofs({"N2", "N2-N2.2"}, "back").interface },
              { 3 * 14 * 5, 3 * 6 * 11 })
  check.equal(dofs({"N2-N2.2", "N2"}, "back").bulk, 3 * 6 * 5 * 2)
  check.equal(dofs({"N2-N4", "N2-N4"}, {"front", "back"}).total, dofs("N2-N4", {"front", "back"}).total)
  -- The face "west" has the directions xi2 and xi3: N4 on 3 and on 2 elements.
  check.equal(dofs({"N4", "N2"}, "west").interface, 3 * 7 * 4)
  check.equal(dofs({"N2", "N3", "N4"}).total, 3 * 6 * 6 * 6)
end)

check.case("Table 7.11 is reproduced exactly", function()
  local printed = sg.reference "ironing3d_dofs_table7_11"
  local at = {}
  for i, name in ipairs(printed.columns) do at[name] = i end
  check.equal(#printed.rows, 8)
  for _, row in ipairs(printed.rows) do
    local order, n = row[at.discretization], row[at.mesh] == "fine" and 2 or 1
    local indenter = scenes.body{ patch = sg.shapes.spherical_indenter{ width = 10, depth = 10, height = 11,
        radius = 25.5, elements = 1, corner = {0, 0, 22} }, elements = { 5 * n, 5 * n, 3 * n }, order = order,
      contact = "front", thickness_degree = 1, material = soft }
    local slab = scenes.body{ size = {100, 30, 22}, elements = { 18 * n, 6 * n, 4 * n }, order = order,
      contact = "back", thickness_degree = 1, material = soft }
    for name, body in pairs{ indenter = indenter, slab = slab } do
      for _, part in ipairs{ "interface", "bulk", "total" } do
        check.equal({ order, body:dofs()[part] }, { order, row[at[name .. "_" .. part]] })
      end
    end
    check.equal(indenter:dofs().total + slab:dofs().total, row[at.total])
  end
end)

-- ── Reactions against closed forms ───────────────────────────────────────────────────────────────────────────────────

--- The force per area that the stretch λ takes where nothing moves sideways: Hooke's (λ + 2μ)(λ₃ − 1), neo-Hooke's
--- μ(λ₃ − 1/λ₃) + λ ln λ₃/λ₃.
local mu = E / (2 * (1 + nu))
local lame = 2 * mu * nu / (1 - 2 * nu)
local uniaxial = {
  linear = function(stretch) return (lame + 2 * mu) * (stretch - 1) end,
  soft = function(stretch) return mu * (stretch - 1 / stretch) + lame * math.log(stretch) / stretch end,
}

--- The force per area on springs of stiffness `penalty` and columns of given heights, one behind the other, that are
--- shortened by `depth` together: by bisection on the pressure p in Σ h(1 − λ₃(p)) + p/ε = depth.
local function pressed(law, heights, penalty, depth)
  local function stretch(p)
    local low, high = 0.01, 1
    for _ = 1, 60 do
      local middle = (low + high) / 2
      if -law(middle) > p then low = middle else high = middle end
    end
    return low
  end
  local low, high = 0, penalty * depth
  for _ = 1, 60 do
    local p, sum = (low + high) / 2, 0
    for _, height in ipairs(heights) do sum = sum + height * (1 - stretch(p)) end
    if sum + p / penalty > depth then high = p else low = p end
  end
  return low
end

--- Supports that let a block move along z only, but for what holds its lower or upper face.
local function guides(b)
  return { x = { on = { b:face "west", b:face "east" }, fix = "x" },
           y = { on = { b:face "south", b:face "north" }, fix = "y" } }
end

check.case("a guided block under a rigid plane: uniaxial strain and the penalty's springs", function()
  for name, material in pairs{ linear = linear, soft = soft } do
    local b = scenes.body{ size = {2, 1, 3}, elements = {2, 2, 3}, order = "N2-N2.1", contact = "back",
      material = material }
    local plane = sg.rigid.plane{ point = {0, 0, 3}, normal = {0, 0, -1} }
    local supports = guides(b)
    supports.bed, supports.lid = { on = b:face "front", fix = "z" }, { on = plane, drive = "xyz" }
    local model = scenes.model{ bodies = { b = b }, supports = supports,
      contacts = { joint = { slave = "back", master = plane, penalty = 100 } } }
    local run = check.completed(model:run{ { steps = 3, lid = {0.1, 0, -0.6} } })
    for step = 1, 3 do
      local p = pressed(uniaxial[name], { 3 }, 100, 0.2 * step)
      check.near(run:column "lid.fz"[step], -2 * p, 1e-8)
      check.near(run:column "bed.fz"[step], 2 * p, 1e-8)
      check.near(run:column "joint.fz"[step], -2 * p, 1e-8)
      check.near(run:column "joint.max_pressure"[step], p, 1e-8)
      check.near(run:column "joint.max_penetration"[step], p / 100, 1e-10)
      check.near({ run:column "joint.area"[step], run:column "lid.uz"[step] }, { 2, -0.2 * step }, 1e-12)
    end
    check.near(largest(run:column "joint.fx"), 0, 1e-10)
    local p = pressed(uniaxial[name], { 3 }, 100, 0.6)
    check.near(model:sample(b, "uz", {0.3, 0.7, 1}), p / 100 - 0.6, 1e-10)
    check.near(model:sample("b", "szz", {0.3, 0.7, 0.2}), -p, 1e-8)
    -- 18 × 18 points; their areas, pressures and heights
    local profile, area = model:profile "joint", 0
    check.equal(#profile.z, (2 * 3 * 4) ^ 2)
    for i, z in ipairs(profile.z) do
      area = area + profile.area[i]
      check.near({ z, profile.Z[i], profile.pressure[i] }, { 2.4 + p / 100, 3, p }, 1e-8)
      check.near({ profile.x[i], profile.y[i] }, { profile.X[i], profile.Y[i] }, 1e-10)
      check.equal({ profile.tx[i], profile.ty[i], profile.tz[i], profile.traction[i] }, { 0, 0, 0, 0 })
    end
    check.near(area, 2, 1e-10)
  end
end)

check.case("a block on a block, one mesh twice as fine: the same pressure at every point", function()
  for name, material in pairs{ linear = linear, soft = soft } do
    local low = scenes.body{ size = {2, 1, 1}, elements = {2, 1, 2}, contact = "back", material = material }
    local high = scenes.body{ size = {2, 1, 0.5}, corner = {0, 0, 1}, elements = {4, 2, 1}, contact = "front",
      material = material }
    local supports, rest = guides(low), guides(high)
    supports.x2, supports.y2 = rest.x, rest.y
    supports.bed = { on = low:face "front", fix = "z" }
    supports.lid = { on = high:face "back", drive = "z" }
    local model = scenes.model{ bodies = { low = low, high = high }, supports = supports,
      contacts = { joint = { slave = "high.front", master = "low.back", penalty = 50 } } }
    local run = check.completed(model:run{ { steps = 4, lid = -0.3 } })
    local p = pressed(uniaxial[name], { 1, 0.5 }, 50, 0.3)
    check.near({ run:column "lid.fz"[4], run:column "bed.fz"[4] }, { -2 * p, 2 * p }, 1e-8)
    for _, pressure in ipairs(model:profile "joint".pressure) do check.near(pressure, p, 1e-8) end
  end
end)

check.case("a contact on a part of the face, with a given number of points", function()
  local b = scenes.body{ size = {2, 1, 3}, elements = {4, 3, 1}, contact = "back", material = soft }
  local seen = {}
  local model = scenes.model{ bodies = { b = b }, contacts = { joint = {
    slave = "back", master = sg.rigid.plane{ point = {0, 0, 3}, normal = {0, 0, -1} }, penalty = 1, points = 2,
    where = function(X)
      seen[#seen + 1] = X
      return X[1] < 1
    end } } }
  check.equal({ #seen, #seen[1] }, { 4 * 3 * 4, 3 })
  check.near(seen[1][3], 3)
  check.equal(#model:profile "joint".X, 2 * 3 * 4)
end)

check.case("without friction the work is stored in bodies and springs", function()
  local b = scenes.body{ size = {1, 1, 1}, elements = {1, 1, 1}, contact = "back", material = linear }
  local plane = sg.rigid.plane{ point = {0, 0, 1}, normal = {0, 0, -1} }
  local supports = guides(b)
  supports.bed, supports.lid = { on = b:face "front", fix = "z" }, { on = plane, drive = "z" }
  local model = scenes.model{ bodies = { b = b }, supports = supports,
    contacts = { joint = { slave = "back", master = plane, penalty = 20 } } }
  model:run{ { steps = 2, lid = -0.2 } }
  local p, energy = pressed(uniaxial.linear, { 1 }, 20, 0.2), model:energy()
  -- All is linear, so the trapezoidal rule is exact.
  check.near({ energy.work, energy.contact, energy.friction }, { p * 0.2 / 2, p * p / 20 / 2, 0 }, 1e-9)
  check.near(energy.stored, energy.work - energy.contact, 1e-9)
end)

check.case("loads in 3D: dead tractions and pressures, their resultants and columns", function()
  local b = scenes.body{ size = {2, 3, 4}, contact = "back", material = linear }
  local p = 0.5
  local model = scenes.model{ bodies = { b = b },
    supports = { x = { on = "west", fix = "x" }, y = { on = "south", fix = "y" }, z = { on = "front", fix = "z" } },
    loads = { gas = { on = { "east", "north", "back" }, pressure = 0 } } }
  local run = model:run{ { steps = 2, gas = p } }
  check.near(model:reaction "gas", { -12 * p, -8 * p, -6 * p }, 1e-12)
  check.near({ run:column "x.fx"[2], run:column "y.fy"[2], run:column "z.fz"[2] }, { 12 * p, 8 * p, 6 * p }, 1e-10)
  -- ε = −p(1 − 2ν)/E in all directions
  local strain = -p * (1 - 2 * nu) / E
  check.near({ model:sample(b, "ux", {1, 0.2, 0.3}), model:sample(b, "uy", {0.1, 1, 0.5}),
               model:sample(b, "uz", {0.6, 0.7, 1}) }, { 2 * strain, 3 * strain, 4 * strain }, 1e-10)
  check.near(model:sample(b, "pressure", {0.2, 0.4, 0.8}), p, 1e-10)

  local pulled = scenes.model{ bodies = { b = b }, supports = { bed = { on = "front", fix = "xyz" } },
    loads = { pull = { on = "back", traction = {0, 0, 0} } } }
  run = pulled:run{ { steps = 1, pull = {0.1, 0.2, 0.3} } }
  check.near({ run:column "pull.tx"[1], run:column "pull.ty"[1], run:column "pull.tz"[1] }, { 0.1, 0.2, 0.3 })
  check.near({ run:column "pull.fx"[1], run:column "pull.fy"[1], run:column "pull.fz"[1] }, { 0.6, 1.2, 1.8 }, 1e-12)
  check.near({ run:column "bed.fx"[1], run:column "bed.fy"[1], run:column "bed.fz"[1] }, { -0.6, -1.2, -1.8 }, 1e-10)
end)

-- ── Faces that rotate ────────────────────────────────────────────────────────────────────────────────────────────────

--- v turned by an angle in degrees about a unit vector through the origin (Rodrigues).
local function turned(v, n, angle)
  local c, s = math.cos(math.rad(angle)), math.sin(math.rad(angle))
  local cross = { n[2] * v[3] - n[3] * v[2], n[3] * v[1] - n[1] * v[3], n[1] * v[2] - n[2] * v[1] }
  local along = (n[1] * v[1] + n[2] * v[2] + n[3] * v[3]) * (1 - c)
  local result = {}
  for i = 1, 3 do result[i] = c * v[i] + s * cross[i] + along * n[i] end
  return result
end

--- A block of 1 × 1 × 2 whose upper face turns about its centroid, (0.5, 0.5, 2).
local function turning(material, rotate, hold)
  local b = scenes.body{ size = {1, 1, 2}, contact = "back", thickness_degree = 2, material = material }
  local grip = lists.merged({ on = b:face "back", rotate = rotate }, hold)
  return b, grip
end

check.case("a free body follows a face that rotates about any axis, without force and moment", function()
  local b, grip = turning(soft, {1, 2, 2}, { drive = "z", fix = "xy" })
  local model = scenes.model{ bodies = { b = b }, supports = { grip = grip },
    loads = { pull = { on = "front", traction = {0, 0, -1} } } }
  check.equal(model:driven "grip", { "z", "angle" })
  -- The pull gives the run a size of forces to converge against; let go, the body is free.
  model:run{ { steps = 1 }, { steps = 1, pull = {0, 0, 0} } }
  local run = check.completed(model:run{ { steps = 12, grip = {0.5, 120} } })
  local n, center = { 1 / 3, 2 / 3, 2 / 3 }, { 0.5, 0.5, 2 }
  for _, xi in ipairs{ {0, 0, 0}, {1, 0.3, 0.1}, {0.2, 1, 0.8} } do
    local X = { xi[1], xi[2], 2 * xi[3] }
    local arm = turned({ X[1] - center[1], X[2] - center[2], X[3] - center[3] }, n, 120)
    local u = { model:sample(b, "ux", xi), model:sample(b, "uy", xi), model:sample(b, "uz", xi) }
    for i = 1, 3 do check.near(X[i] + u[i], center[i] + arm[i] + (i == 3 and 0.5 or 0), 1e-8) end
  end
  for _, name in ipairs{ "fx", "fy", "fz", "moment" } do check.near(largest(run:column("grip." .. name)), 0, 1e-8) end
  check.near({ run:column "grip.uz"[12], run:column "grip.angle"[12] }, { 0.5, 120 })
  check.near(model:energy().stored, 0, 1e-10)
end)

check.case("pure bending: the moment of a face that turns about y is EIθ/L", function()
  -- With ν = 0 the bar's exact displacement is quadratic, u_x = κz²/2, u_z = −κxz about its axis, and the upper face
  -- stays a plane that turns by κL. A rotation differs from it by θ²/2, here 2e-12.
  for _, axis in ipairs{ "y", {0, 3, 0} } do
    local b, grip = turning(sg.linear_elastic{ E = E, nu = 0 }, axis)
    local model = scenes.model{ bodies = { b = b }, supports = { bed = { on = "front", fix = "z" },
        foot = { on = "front", fix = "x" }, side = { on = b:edge "south-front", fix = "y" }, grip = grip } }
    local angle = 1e-4
    local run = model:run{ { steps = 1, grip = angle } }
    local kappa = math.rad(angle) / 2
    local moment = E * (1 / 12) * kappa
    check.near(run:column "grip.moment"[1] / moment, 1, 1e-5)
    check.near({ run:column "grip.fx"[1], run:column "grip.fz"[1] }, { 0, 0 }, 1e-5 * moment)
    check.near(model:sample(b, "ux", {0.5, 0.3, 0.5}) / (kappa / 2), 1, 1e-5)
    check.near(model:energy().stored / (moment * math.rad(angle) / 2), 1, 1e-5)
  end
end)

check.case("a bar twisted by small angles: moment and energy agree, and the foot reacts", function()
  local b, grip = turning(linear, "z", { fix = "xy" })
  local model = scenes.model{ bodies = { b = b }, supports = { bed = { on = "front", fix = "xyz" }, grip = grip } }
  local angle = 1e-3
  local run = model:run{ { steps = 1, grip = angle } }
  local moment = run:column "grip.moment"[1]
  check.near(2 * model:energy().stored / (moment * math.rad(angle)), 1, 1e-5)
  -- Saint-Venant's torsion of a square, 0.1406 μ a⁴ θ/L, is the least: here both ends are kept from warping, and the
  -- mesh is coarse.
  local saint_venant = 0.1406 * mu * math.rad(angle) / 2
  assert(moment > saint_venant and moment < 1.4 * saint_venant, moment / saint_venant)
end)

check.case("a face that rotates about the normal of a plane of symmetry reaches this plane", function()
  local function bent(half)
    local b = scenes.body{ size = { 4, 1, half and 0.5 or 1 }, elements = { 4, 1, half and 1 or 2 }, material = soft,
                           contact = "north" }
    local model = scenes.model{ bodies = { b = b }, supports = { wall = { on = b:face "west", fix = "xyz" },
      grip = { on = b:face "east", rotate = "z", fix = "z", drive = "xy" },
      mirror = half and { on = b:face "back", symmetry = true } or nil } }
    return check.completed(model:run{ { steps = 2, grip = { -0.2, 1, 30 } } })
  end
  local whole, half = bent(false), bent(true)
  for _, name in ipairs{ "fx", "fy", "moment" } do
    check.near(2 * half:column("grip." .. name)[2] / whole:column("grip." .. name)[2], 1, 1e-3)
  end
end)

check.case("two faces that rotate as one turn about their common centroid", function()
  local b = scenes.body{ size = {3, 2, 1}, elements = {2, 2, 1}, contact = "back", material = soft }
  local model = scenes.model{ bodies = { b = b },
    supports = { grip = { on = { "west", "south" }, rotate = "z", fix = "xyz" } },
    loads = { pull = { on = "east", traction = {1, 0, 0} } } }
  model:run{ { steps = 1 }, { steps = 1, pull = {0, 0, 0} } }
  local run = check.completed(model:run{ { steps = 6, grip = 90 } })
  -- Areas 2 at (0, 1) and 3 at (1.5, 0): centroid (0.9, 0.4). The far corner (3, 2) goes to (0.9 − 1.6, 0.4 + 2.1).
  check.near({ model:sample(b, "ux", {1, 1, 0}), model:sample(b, "uy", {1, 1, 0}) }, { -0.7 - 3, 2.5 - 2 }, 1e-8)
  check.near(largest(run:column "grip.moment"), 0, 1e-8)
end)

-- ── In words ─────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("obstacles and models print their properties", function()
  check.equal(tostring(sg.rigid.plane{ point = {0, 0, 1}, normal = {0, 0, 2} }),
              "rigid plane through (0, 0, 1), normal (0, 0, 1)")
  check.equal(tostring(sg.rigid.sphere{ center = {1, 2, 3}, radius = 4 }), "rigid sphere about (1, 2, 3), radius 4")
  check.equal(tostring(sg.rigid.cylinder{ center = {1, 2, 3}, axis = {0, 5, 0}, radius = 4 }),
              "rigid cylinder about (1, 2, 3), axis (0, 1, 0), radius 4")
  check.equal(tostring(sg.rigid.surface(sg.shapes.block{ size = {1, 1, 1} }:face "back")),
              "rigid surface of degrees 1 and 1")
  local b = scenes.body{ size = {1, 1, 1}, elements = {1, 1, 1}, order = "N1", material = soft }
  local model = scenes.model{ bodies = { b = b }, supports = { bed = { on = "front", fix = "xyz" } } }
  check.equal(tostring(model), "solid model of b: 24 degrees of freedom, 12 of them free, 1 support, 0 contacts")
  check.equal(tostring(model:snapshot()), "snapshot of a model with 24 degrees of freedom")
  check.equal(require "signorini.core".kind(model), "model")
end)
