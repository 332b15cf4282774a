-- Contacts with lists of faces: patches that are joined give the forces of the uncut body, as slave and as master, with
-- every method, in the plane and in space; pressures of pictures and samples; lists that do not form one surface.

require "check"

local soft, hard = sg.neo_hookean{ E = 1, nu = 0.3 }, sg.neo_hookean{ E = 10, nu = 0.3 }

--- A body per patch, with `elements`.
local function body(patch, elements)
  return sg.body{ patch = patch, elements = elements, order = "N2", material = soft }
end

--- A slab of 4 × 1 with a C0 line in the middle, or two joined ones, the second with reversed directions.
local function slab(cut)
  if not cut then
    local whole = body(sg.shapes.rectangle{ width = 4, height = 1 }:elevate(1, 1):insert(1, { 0.5, 0.5 }), { 8, 2 })
    return { whole = whole }, nil, whole:face "north", whole:face "south"
  end
  local a = body(sg.shapes.rectangle{ width = 2, height = 1 }, { 4, 2 })
  local b = body(sg.shapes.rectangle{ width = 2, height = 1, corner = { 2, 0 } }:reverse(1):reverse(2), { 4, 2 })
  return { a = a, b = b }, { seam = { a:face "east", b:face "east" } }, { b:face "south", a:face "north" },
    { a:face "south", b:face "north" }
end

--- A half ring is pressed into the slab and dragged across its middle.
local function drag(cut, swapped, contact)
  local bodies, joins, top, bottom = slab(cut)
  local die = sg.body{ patch = sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = { 1.4, 1.5 } },
                       elements = { 8, 1 }, order = "N2", material = hard }
  bodies.die = die
  contact.slave, contact.master = die:face "south", top
  if swapped then contact.slave, contact.master = top, die:face "south" end
  local model = sg.model{ bodies = bodies, joins = joins, contacts = { touch = contact },
    supports = { bed = { on = bottom, fix = "xy" },
                 grip = { on = { die:face "west", die:face "east" }, drive = "xy" } } }
  local run = check.completed(model:run({ { name = "press", steps = 3, grip = { 0, -0.1 } },
                          { name = "slide", steps = 12, grip = { 0.9, -0.1 } } }, sg.plain{}))
  return run, model
end

local function same_columns(what, run, other, columns)
  for _, name in ipairs(columns) do
    -- The area ends where interpolated gaps are zero, which amplifies rounding errors of the gaps.
    local expected, tolerance = other:column(name), name:find "area" and 1e-8 or 1e-11
    for i, value in ipairs(run:column(name)) do check.within(what .. " " .. name, value, expected[i], tolerance) end
  end
end

local function friction() return { mu = 0.3, penalty = 50 } end

check.case("a slide across two joined patches gives the forces of one patch, as master and as slave", function()
  for name, make in pairs {
    gpts = function() return { penalty = 50, friction = friction() } end,
    half_passes = function() return { method = "half_passes", penalty = 50, friction = friction() } end,
    multipliers = function()
      return { method = "mortar", enforcement = "multipliers", friction = { mu = 0.3 } }
    end,
  } do
    for _, swapped in ipairs { false, true } do
      same_columns(name, (drag(true, swapped, make())), (drag(false, swapped, make())),
        { "grip.fx", "grip.fy", "touch.fx", "touch.area", "touch.max_pressure" })
    end
  end
end)

check.case("pressures on the faces of a slave list are those of the uncut face, also after loading a file", function()
  local _, uncut = drag(false, true, { penalty = 50 })
  local _, model = drag(true, true, { penalty = 50 })
  local file = check.file "list.sgn"
  model:save(file)
  for _, one in ipairs { model, sg.load(file) } do
    local largest = 0
    for i = 0, 40 do
      local t = i / 40
      local name, xi = "a", { 2 * t, 1 }
      if t > 0.5 then name, xi = "b", { 2 - 2 * t, 0 } end
      local pressure = one:sample(name, "contact_pressure", xi)
      check.within("at " .. t, pressure, uncut:sample("whole", "contact_pressure", { t, 1 }), 1e-11)
      largest = math.max(largest, pressure)
    end
    assert(largest > 0.1, "the pressure is " .. largest)
  end
  local profile, expected = model:profile "touch", uncut:profile "touch"
  check.equal(#profile.x, #expected.x)
  local folder = check.folder()
  sg.picture{ model = model, field = "contact_pressure", file = folder .. "/band.png" }
  check.pictures(folder, { "band" })
  sg.vtu{ model = model, file = folder .. "/list.vtu" }
end)

--- Four blocks around a point, in different orientations, or one block with C0 planes; a cap slides across the point.
local function blocks(cut, swapped)
  local bodies, joins, top, bottom
  local function block(x, y, turned)
    local patch = sg.shapes.block{ size = { 1, 1, 1 }, corner = { x, y, 0 } }
    return body(turned and patch:reverse(1):reverse(2) or patch, { 2, 2, 1 })
  end
  if cut then
    local a, b, c, d = block(0, 0), block(1, 0, true), block(0, 1), block(1, 1)
    bodies = { a = a, b = b, c = c, d = d }
    joins = { ab = { a:face "east", b:face "east" }, ac = { a:face "north", c:face "south" },
              bd = { b:face "south", d:face "south" }, cd = { c:face "east", d:face "west" } }
    top, bottom = {}, {}
    for i, one in ipairs { d, a, b, c } do top[i], bottom[i] = one:face "back", one:face "front" end
  else
    local patch = sg.shapes.block{ size = { 2, 2, 1 } }:elevate(1, 1):elevate(2, 1)
    bodies = { whole = body(patch:insert(1, { 0.5, 0.5 }):insert(2, { 0.5, 0.5 }), { 4, 4, 1 }) }
    top, bottom = bodies.whole:face "back", bodies.whole:face "front"
  end
  local cap = sg.body{ order = "N2", material = hard, elements = { 3, 3, 1 },
    patch = sg.shapes.spherical_indenter{ width = 0.8, depth = 0.8, height = 0.5, radius = 1, elements = 2,
                                          corner = { 0.4, 0.5, 1 } } }
  bodies.cap = cap
  local slave, master = cap:face "front", top
  if swapped then slave, master = master, slave end
  local model = sg.model{ bodies = bodies, joins = joins,
    supports = { bed = { on = bottom, fix = "xyz" }, grip = { on = cap:face "back", drive = "xyz" } },
    contacts = { touch = { slave = slave, master = master, penalty = 30, friction = { mu = 0.3, penalty = 30 } } } }
  local run = check.completed(model:run({ { name = "press", steps = 2, grip = { 0, 0, -0.1 } },
                          { name = "slide", steps = 6, grip = { 0.5, 0.2, -0.1 } } }, sg.plain{}))
  return run, model
end

--- The block that contains a point of the uncut block's upper face, and the point's place on it.
local function piece(x, y)
  local u, v = 2 * x % 1, 2 * y % 1
  if y < 0.5 then return x < 0.5 and "a" or "b", x < 0.5 and { u, v, 1 } or { 1 - u, 1 - v, 1 } end
  return x < 0.5 and "c" or "d", { u, v, 1 }
end

check.case("a slide across the corner of four joined blocks gives the forces of one block", function()
  for _, swapped in ipairs { false, true } do
    local run, joined = blocks(true, swapped)
    local other, uncut = blocks(false, swapped)
    same_columns("blocks", run, other, { "grip.fx", "grip.fy", "grip.fz" })
    local largest = 0
    for i = 0, swapped and 360 or -1 do
      local x, y = 0.32 + 0.02 * (i % 19), 0.22 + 0.02 * (i // 19) -- around the cap, not on the borders
      local name, xi = piece(x, y)
      local pressure = joined:sample(name, "contact_pressure", xi)
      check.within(("at %g, %g"):format(x, y), pressure, uncut:sample("whole", "contact_pressure", { x, y, 1 }), 1e-11)
      largest = math.max(largest, pressure)
    end
    check.equal(largest > 0.1, swapped)
  end
end)

check.case("lists that do not form one surface are errors that name the face", function()
  local function square(x, elements)
    return body(sg.shapes.rectangle{ width = 1, height = 1, corner = { x, 0 } }, elements or { 2, 2 })
  end
  local a, b, c = square(0), square(1), square(2, { 2, 3 })
  local die = square(5)
  local joins = { ab = { a:face "east", b:face "west" }, bc = { b:face "east", c:face "west" } }
  local function refused(list, fragment, other)
    local ok, message = pcall(sg.model, { bodies = { a = a, b = b, c = c, die = die }, joins = other or joins,
      contacts = { touch = { slave = die:face "west", master = list, penalty = 1 } } })
    check.equal(ok, false)
    check.holds(message, fragment)
  end
  local apart = "contacts.touch.master: face 'north' of body '%s' has no border in common with the others"
  refused({ a:face "north", c:face "north" }, apart:format "c")
  refused({ a:face "north", b:face "north" }, apart:format "b", {})
  refused({ b:face "north", c:face "north" }, apart:format "c") -- tied, not joined
  refused({ a:face "north", a:face "north" }, "contacts.touch.master has face 'north' of body 'a' twice")
  refused({ a:face "north", a:face "east" }, "joins.ab joins")
  refused({ a:face "north", die:face "west" }, "is the same face as")
  refused({}, "must be")
  refused({ a:face "north", 3 }, "contacts.touch.master[2] must be a face")
  refused({ a:face "north", a:corner "south-west" }, "must be a face, got the corner 'south-west'")
end)
