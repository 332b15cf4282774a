-- A cylinder under internal pressure, made of two rings with nonmatching meshes that are tied along a circle.
--
-- Problem: plane strain, a quarter of the cross section between two planes of symmetry (rings = 2), or half of it in
--          quarters that are tied along their radii as well (rings = 4), with seams that meet in a point of the circle.
--          Inner rings have radii 1 to 1.5 and E = 1, outer ones 1.5 to 2 and E = `ratio`; nu = 0.3; the internal
--          pressure is 0.01. The exact solution is Lamé's in each ring, with the pressure at the seam for which
--          displacements agree.
--
--          elements on mesh m        along the arc    through the ring, 2 or 4 rings
--          inner ring                3 · 2^(m−1)      1 · 2^(m−1)    2 · 2^(m−1)
--          outer ring                5 · 2^(m−1)      1 · 2^(m−1)    2 · 2^(m−1)
--          second inner ring         5 · 2^(m−1)                     3 · 2^(m−1)
--          second outer ring         3 · 2^(m−1)                     3 · 2^(m−1)
-- Source: G. Lamé, Leçons sur la théorie mathématique de l'élasticité, 1852; rates: E. Brivadis, A. Buffa, B. Wohlmuth,
--         L. Wunderlich, Isogeometric mortar methods, Comput. Methods Appl. Mech. Engrg. 284 (2015), arXiv:1407.8313.
-- Units: any consistent units; errors are relative to the norms of the exact solution.
-- Expected: with multipliers "equal" and degree p in the bulk, rates p (energy norm) and p + 1 (L2 norms of the
--           displacement and of the seam's traction), with either slave. "reduced": the same energy, but tractions with
--           rate p − 1, and with four rings displacements with rate p.
-- Run: signorini -q tied_seam.lua [orders=N2,N3,N2-N2.2] [meshes=1,2,3,4] [slaves=inner,outer]
--      [multipliers=equal,reduced] [rings=2] [ratio=1] [out=out/tied_seam] [page=none]; page: folder of tied_seam.md,
--      whose table of this number of rings is filled from the last mesh

local sg = require "signorini"
local page = require "page.tables"

local inner, middle, outer, nu, load = 1, 1.5, 2, 0.3, 0.01

-- ── Exact solution ───────────────────────────────────────────────────────────────────────────────────────────────────

--- A ring of radii a and b under pressures p inside and q outside: sigma_r = A − B/r², sigma_theta = A + B/r²,
--- u_r = (1 + nu)/E ((1 − 2 nu) A r + B/r).
local function ring(young, a, b, p, q)
  local A, B = (p * a^2 - q * b^2) / (b^2 - a^2), (p - q) * a^2 * b^2 / (b^2 - a^2)
  return {
    young = young, from = a, to = b,
    radial = function(r) return A - B / r^2 end, hoop = function(r) return A + B / r^2 end,
    displacement = function(r) return (1 + nu) / young * ((1 - 2 * nu) * A * r + B / r) end,
  }
end

--- Both rings, with the pressure at the seam: displacements there are linear in it.
local function exact(ratio)
  local function jump(q)
    return ring(ratio, middle, outer, q, 0).displacement(middle) - ring(1, inner, middle, load, q).displacement(middle)
  end
  local q = -jump(0) / (jump(1) - jump(0))
  return { inner = ring(1, inner, middle, load, q), outer = ring(ratio, middle, outer, q, 0), seam = q }
end

-- ── Scene ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The rings of a scene: quarters from the angle `start`, with elements along the arc and through the ring on mesh 1.
--- Two rings make the quarter, four the half cylinder, in which two radial seams meet the circle.
local rings = {
  { name = "inner", ring = "inner", start = 0, along = 3, through = 1, seam = "south" },
  { name = "outer", ring = "outer", start = 0, along = 5, through = 1, seam = "north" },
}
local four_rings = {
  { name = "inner", ring = "inner", start = 0, along = 3, through = 2, seam = "south" },
  { name = "outer", ring = "outer", start = 0, along = 5, through = 2, seam = "north" },
  { name = "left inner", ring = "inner", start = 90, along = 5, through = 3, seam = "south" },
  { name = "left outer", ring = "outer", start = 90, along = 3, through = 3, seam = "north" },
}

local function make_bodies(o, solution)
  local bodies = {}
  for _, part in ipairs(o.rings) do
    local own, refined = solution[part.ring], 1 << (o.mesh - 1)
    bodies[part.name] = sg.body{
      patch    = sg.shapes.quarter_annulus{ inner = own.from, outer = own.to, start = part.start },
      elements = { part.along * refined, part.through * refined }, order = o.order, contact = part.seam,
      material = sg.linear_elastic{ E = own.young, nu = nu },
    }
  end
  return bodies
end

local function scene(o, solution)
  local b = make_bodies(o, solution)
  --- A tie along the circle or, with `face`, along a radius.
  local function tie(first, second, face)
    local slave, master = b[first]:face(face or "south"), b[second]:face(face and "west" or "north")
    if o.slave == "outer" then slave, master = master, slave end
    return { slave = slave, master = master, multipliers = o.multipliers }
  end
  local half = #o.rings == 4
  return sg.model{
    bodies   = b,
    supports = half and { level = { on = { b.inner:face "west", b.outer:face "west", b["left inner"]:face "east",
                                           b["left outer"]:face "east" }, fix = "y" },
                          pin   = { on = b.inner:corner "north-east", fix = "x" } }
               or { level   = { on = { b.inner:face "west", b.outer:face "west" }, fix = "y" },
                    upright = { on = { b.inner:face "east", b.outer:face "east" }, fix = "x" } },
    loads    = { bore = { on = half and { b.inner:face "north", b["left inner"]:face "north" }
                               or b.inner:face "north", pressure = 0 } },
    ties     = half and { seam = tie("inner", "outer"), ["left seam"] = tie("left inner", "left outer"),
                          ["inner seam"] = tie("inner", "left inner", "east"),
                          ["outer seam"] = tie("outer", "left outer", "east") }
               or { seam = tie("inner", "outer") },
  }
end

-- ── Errors ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Five Gauss points on [0, 1].
local gauss = {}
for _, pair in ipairs{ { 0, 128 / 225 }, { math.sqrt(5 - 2 * math.sqrt(10 / 7)) / 3, (322 + 13 * math.sqrt(70)) / 900 },
                       { math.sqrt(5 + 2 * math.sqrt(10 / 7)) / 3, (322 - 13 * math.sqrt(70)) / 900 } } do
  for sign = pair[1] > 0 and -1 or 1, 1, 2 do gauss[#gauss + 1] = { (1 + sign * pair[1]) / 2, pair[2] / 2 } end
end

--- The rational parameter of an angle on the quarter circle with weights 1, 1/√2, 1, and the reverse: the barycentric
--- coordinates of its points are 1 − sin θ, …, 1 − cos θ, and their ratio is (xi/(1 − xi))².
local function parameter(angle)
  local ratio = math.sqrt((1 - math.cos(angle)) / (1 - math.sin(angle)))
  return ratio / (1 + ratio)
end
local function angle_of(xi)
  local first, mixed, last = (1 - xi)^2, math.sqrt(2) * xi * (1 - xi), xi^2
  return math.atan(mixed + last, first + mixed)
end

--- Integrals over a ring of |u_h − u|², |u|², and of the energy densities of the stress error and of the exact stress,
--- with Gauss points of each element in polar coordinates.
local function integrals(model, o, ring, part, sums)
  local refined = 1 << (o.mesh - 1)
  local count, through, E = ring.along * refined, ring.through * refined, part.young
  --- s : C⁻¹ : s / 2 in plane strain
  local function energy(xx, yy, xy)
    return ((1 - nu^2) * (xx^2 + yy^2) - 2 * nu * (1 + nu) * xx * yy + 2 * (1 + nu) * xy^2) / (2 * E)
  end
  for i = 1, count do
    local low, high = angle_of((i - 1) / count), angle_of(i / count)
    for k = 1, through do
      for _, a in ipairs(gauss) do
        for _, b in ipairs(gauss) do
          local angle, depth = low + a[1] * (high - low), (k - 1 + b[1]) / through
          local r, direction = part.to - depth * (part.to - part.from), angle + math.rad(ring.start)
          local c, s = math.cos(direction), math.sin(direction)
          local weight = a[2] * b[2] * (high - low) * (part.to - part.from) / through * r
          local function at(field) return model:sample(ring.name, field, { parameter(angle), depth }) end
          local u, radial, hoop = part.displacement(r), part.radial(r), part.hoop(r)
          local xx, yy, xy = radial * c^2 + hoop * s^2, radial * s^2 + hoop * c^2, (radial - hoop) * s * c
          sums.displacement = sums.displacement + weight * ((at "ux" - u * c)^2 + (at "uy" - u * s)^2)
          sums.whole_displacement = sums.whole_displacement + weight * u^2
          sums.energy = sums.energy + weight * energy(at "sxx" - xx, at "syy" - yy, at "sxy" - xy)
          sums.whole_energy = sums.whole_energy + weight * energy(xx, yy, xy)
        end
      end
    end
  end
end

--- The L2 error of the traction at the seam.
local function traction_error(model, o, solution)
  local profile, sum = model:tie_profile "seam", 0
  local sign = o.slave == "inner" and -1 or 1
  for i, area in ipairs(profile.area) do
    local q = sign * solution.seam / middle
    sum = sum + area * ((profile.tx[i] - q * profile.X[i])^2 + (profile.ty[i] - q * profile.Y[i])^2)
  end
  return math.sqrt(sum / (middle * math.pi / 2)) / solution.seam
end

local function solve(o, solution)
  local model = scene(o, solution)
  local run = model:run({ { name = "load", steps = 1, bore = load } }, sg.plain{})
  if run.failed then error(("%s, mesh %d: %s"):format(o.order, o.mesh, run.failure), 0) end
  local sums = { displacement = 0, whole_displacement = 0, energy = 0, whole_energy = 0 }
  for _, ring in ipairs(o.rings) do integrals(model, o, ring, solution[ring.ring], sums) end
  o.energy, o.displacement = math.sqrt(sums.energy / sums.whole_energy),
    math.sqrt(sums.displacement / sums.whole_displacement)
  o.traction, o.unknowns = traction_error(model, o, solution), model:solver().unknowns
  return o
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

local options = sg.arguments{
  orders = { "N2", "N3", "N2-N2.2" }, meshes = { { 1, 2, 3, 4 }, at_least = 1 }, slaves = { "inner", "outer" },
  multipliers = { "equal", "reduced" }, rings = { 2, choices = { 2, 4 } }, ratio = { 1.0, above = 0 },
  out = "out/tied_seam", page = "none",
}
local files, cases, rows = sg.files(options.out), {}, {}
local solution, norms = exact(options.ratio), { "energy", "displacement", "traction" }

for _, order in ipairs(options.orders) do
  for _, multipliers in ipairs(options.multipliers) do
    for _, slave in ipairs(options.slaves) do
      local before
      for _, mesh in ipairs(options.meshes) do
        local case = solve({ rings = options.rings == 4 and four_rings or rings, order = order, slave = slave,
                             multipliers = multipliers, mesh = mesh }, solution)
        local row = { order, multipliers, slave, mesh, case.unknowns }
        case.rates = {}
        for k, norm in ipairs(norms) do
          if before then case.rates[norm] = math.log(before[norm] / case[norm], 2) / (mesh - before.mesh) end
          row[4 + 2 * k], row[5 + 2 * k] = case[norm], case.rates[norm]
        end
        rows[#rows + 1], cases[#cases + 1], before = row, case, case
      end
    end
  end
end
print(("\nErrors relative to the exact solution, and rates (E of the outer ring %g times that of the inner one)")
  :format(options.ratio))
local results = {
  columns = { "order", "multipliers", "slave", "mesh", "unknowns", "energy", "rate", "L2 of u", "rate", "traction",
              "rate" },
  rows = rows, formats = { "%s", "%s", "%s", "%d", "%d", "%.2e", "%.2f", "%.2e", "%.2f", "%.2e", "%.2f" },
}
print(sg.table(results))
local finest = { columns = results.columns, formats = results.formats, rows = {} }
for _, row in ipairs(rows) do
  if row[4] == options.meshes[#options.meshes] then finest.rows[#finest.rows + 1] = row end
end
local name = ("rings%d"):format(options.rings)
page.fill(options, "tied_seam", "tied_seam_" .. name, { [name] = page.pick(finest, { 1, 2, 3, 6, 7, 8, 9, 10, 11 }) })

for _, norm in ipairs(norms) do
  local chart = { file = files(norm .. ".png"), log = "y", xlabel = "mesh", xticks = {},
                  title = ("Tied rings: error of the %s"):format(norm == "energy" and "stress" or norm),
                  ylabel = norm == "energy" and "relative error, energy norm" or "relative L2 error" }
  for i, mesh in ipairs(options.meshes) do chart.xticks[i] = { mesh, ("m%d"):format(mesh) } end
  for _, order in ipairs(options.orders) do
    for _, multipliers in ipairs(options.multipliers) do
      local line = { x = {}, y = {}, label = ("%s, %s"):format(order, multipliers), markers = true,
                     dashed = multipliers == "reduced" }
      for _, case in ipairs(cases) do
        if case.order == order and case.multipliers == multipliers and case.slave == options.slaves[1] then
          line.x[#line.x + 1], line.y[#line.y + 1] = case.mesh, case[norm]
        end
      end
      chart[#chart + 1] = line
    end
  end
  sg.chart(chart)
end
files:report()

return { cases = cases, solution = solution, files = files }
