-- Multipliers on slave faces that close on themselves: pressures and tractions do not depend on where the seam is.

require "check"

--- A ring of four patches from `start` (degrees) on, or of one patch with its seam there; its outer and inner faces.
local function ring(o)
  if o.one then
    local body = scenes.body{ patch = sg.shapes.ring{ inner = o.inner, outer = o.outer }:rotate{ angle = o.start - 90 },
      elements = { 4 * o.n, 2 }, material = o.law }
    return body, body:face "south", body:face "north"
  end
  local patches, outer, inner = {}, {}, {}
  for j = 1, 4 do
    patches[j] = sg.shapes.quarter_annulus{ inner = o.inner, outer = o.outer, start = o.start + 90 * (j - 1) }
    outer[j], inner[j] = j .. ".south", j .. ".north"
  end
  patches.boundaries = { outer = outer, inner = inner }
  local body = scenes.body{ patch = patches, elements = { o.n, 2 }, material = o.law }
  return body, body:face "outer", body:face "inner"
end

local function largest(values, x, y)
  local best, at = 0, nil
  for i, value in ipairs(values) do
    if value > best then best, at = value, math.deg(math.atan(y[i], x[i])) % 360 end
  end
  return best, at
end

-- ── Contact ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A soft ring on springs in a hole that is moved up and to the right, so that the seam is not in a plane of symmetry:
--- force, largest pressure and its place, area.
local function in_hole(o)
  local body, outer, inner = ring{ inner = 0.6, outer = 1, start = o.start, n = 8, one = o.one,
                                   law = sg.neo_hookean{ E = 1, nu = 0.3 } }
  local hole = sg.rigid.cylinder{ center = { 0, 0.02 }, radius = 1.03, inside = true }
  local model = scenes.model{ bodies = { ring = body },
    supports = { inner = { on = inner, spring = { 0.3, 0.3 } }, hole = { on = hole, drive = "xy" } },
    contacts = { c = { slave = outer, master = hole, method = "mortar", enforcement = o.enforcement,
        friction = o.mu and { mu = o.mu }, penalty = o.enforcement ~= "multipliers" and 1e4 or nil } } }
  check.completed(model:run{ { steps = 2, hole = { 0.05, 0.12 } } })
  local now, profile = model:contact_resultant "c", model:profile "c"
  local peak, at = largest(profile.pressure, profile.X, profile.Y)
  return { now.fy, peak, at, now.area }, model
end

check.case("the pressure on a closed chain and on a ring of one patch does not depend on the seam", function()
  for _, o in ipairs{ { enforcement = "multipliers" }, { enforcement = "multipliers", mu = 0.2 }, {} } do
    local function at(start, one)
      return (in_hole{ start = start, one = one, enforcement = o.enforcement, mu = o.mu })
    end
    local away = at(90)
    for _, there in ipairs{ at(270), at(270, true) } do
      check.near({ there[1], there[2], there[4] }, { away[1], away[2], away[4] }, 1e-8)
    end
  end
end)

check.case("a closed chain has as many multipliers as control points", function()
  local _, model = in_hole{ start = 270, enforcement = "multipliers" }
  local _, single = in_hole{ start = 270, one = true, enforcement = "multipliers" }
  -- N2 on four arcs of 8 elements, C0 in between: 5 functions each besides the shared ones
  check.equal(model:tangent().size, single:tangent().size)
end)

-- ── Ties ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A ring tied into another one under a traction that has no symmetry: the largest traction of the tie and its place.
local function tied(start, one)
  local law = sg.linear_elastic{ E = 1, nu = 0.3 }
  local a, outer, inner = ring{ inner = 0.6, outer = 1, start = start, n = 8, one = one, law = law }
  local b, loaded, hole = ring{ inner = 1, outer = 1.5, start = 90, n = 6, law = law }
  local model = sg.model{
    bodies = { a = a, b = b }, supports = { inner = { on = inner, fix = "xy" } },
    ties = { t = { slave = outer, master = hole, multipliers = "equal" } },
    loads = { w = { on = loaded, factor = 0,
                    traction = function(x, y) return { 0.1 * y, 0.02 * x + 0.05 } end } },
  }
  assert(not model:run{ { steps = 1, w = 1 } }.failed)
  local profile, size = model:tie_profile "t", {}
  for i, tx in ipairs(profile.tx) do size[i] = math.sqrt(profile.pressure[i] ^ 2 + tx ^ 2 + profile.ty[i] ^ 2) end
  return { model:energy().stored, (largest(size, profile.X, profile.Y)) }
end

check.case("the traction of a closed tie does not depend on the seam", function()
  -- The borders of the arcs are those of the master's elements for each of these angles.
  local first = tied(90)
  for _, there in ipairs{ tied(180), tied(270), tied(180, true) } do check.near(there, first, 1e-7) end
end)

-- ── Space ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A soft tube on springs in a rigid pipe that is moved likewise, the seam at `start`: force, and the largest pressure.
local function tube(start, multipliers)
  local patch = sg.shapes.tube{ inner = 0.6, outer = 1, width = 1 }:rotate{ angle = start - 90, axis = { 0, -1, 0 } }
  local pipe = sg.rigid.cylinder{ center = { 0, 0, 0.02 }, axis = { 0, 1, 0 }, radius = 1.03, inside = true }
  local model = scenes.model{ bodies = { tube = { patch = patch, elements = { 12, 2, 1 }, contact = "front" } },
    supports = { inner = { on = "back", spring = { 0.3, 0.3, 0.3 } }, pipe = { on = pipe, drive = "xz" } },
    contacts = { c = { slave = "front", master = pipe, method = "mortar", enforcement = "multipliers",
        multipliers = multipliers } } }
  check.completed(model:run{ { steps = 1, pipe = { 0.05, 0.12 } } })
  local now = model:contact_resultant "c"
  return { now.fz, now.max_pressure }
end

check.case("nor does the pressure on a tube", function()
  for _, multipliers in ipairs{ "equal", "reduced" } do
    check.near(tube(270, multipliers), tube(90, multipliers), 1e-8)
  end
end)
