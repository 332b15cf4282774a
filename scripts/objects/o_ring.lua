-- An O-ring of rubber is compressed in a groove by a plate.
--
-- Problem: the section of a long O-ring (plane strain), a disc of the diameter d = 5.33 mm of Mooney-Rivlin rubber with
--          c10 = 0.4, c01 = 0.1, K = 100 MPa (E = 3 MPa), lies in a groove of the width 1.35 d without friction. A
--          rigid plate compresses it by up to `most` of d.
-- Source: P. B. Lindley, Compression characteristics of laterally-unrestrained rubber O-rings, Journal of the IRI 1
--         (1967) 202-213, as quoted in the literature on seals: force per length F = E d (1.25 C^1.5 + 50 C^6) for the
--         compression C = shift/d, a fit to measurements; K. L. Johnson, Contact Mechanics, 1985, section 5.6: elastic
--         cylinder between two plates, shift = 4 F/(pi E') (ln(2 d/a) - 1/2), a^2 = 2 F d/(pi E'), greatest pressure
--         2 F/(pi a), E' = 4 E/3.
-- Units: mm, N per mm, MPa.
-- Expected: the compression for a force within 5 % of Johnson's up to C = 0.15, the pressure within 5 % of 2 F/(pi a)
--           up to 0.25: fluids of lower pressure do not leak. Lindley's force is a quarter below both at
--           C = 0.1 to 0.2.
-- Run: signorini objects/o_ring.lua [elements=96] [orders=N2,N2-N2.2,N2-N2.2x2] [most=0.25] [steps=10]
--      [out=out/o_ring]; results are those of the first order

local sg = require "signorini"

local options = sg.arguments{ elements = { 96, at_least = 16 }, orders = { "N2", "N2-N2.2", "N2-N2.2x2" },
                              most = { 0.25, above = 0, below = 0.3 }, steps = { 10, at_least = 2 },
                              out = "out/o_ring" }
local files = sg.files(options.out)
local d, E, gap = 5.33, 3, 0.175 * 5.33 -- gap: between ring and wall

local function scene(order)
  local ring = sg.body{
    patch = sg.shapes.polar_disc{ radius = d / 2, center = { 0, d / 2 } }, order = order, contact = "south",
    elements = { options.elements, options.elements // 4 },
    material = sg.mooney_rivlin{ c10 = 0.4, c01 = 0.1, K = 100 },
  }
  local plate = sg.rigid.plane{ point = { 0, d }, normal = { 0, -1 } }
  local function touch(master) return { slave = ring:face "south", master = master, penalty = 200 } end
  return sg.model{
    bodies = { ring = ring },
    supports = { plate = { on = plate, drive = "y" },
                 -- By symmetry; this holds the ring, which nothing else does before contact.
                 center = { on = ring:corner "west-north", drive = "y", fix = "x" },
                 seam = { on = ring:corner "west-south", fix = "x" } },
    contacts = { top_face = touch(plate), bottom = touch(sg.rigid.plane{ point = { 0, 0 }, normal = { 0, 1 } }),
                 left = touch(sg.rigid.plane{ point = { -d / 2 - gap, 0 }, normal = { 1, 0 } }),
                 right = touch(sg.rigid.plane{ point = { d / 2 + gap, 0 }, normal = { -1, 0 } }) },
  }
end

--- Compression and greatest pressure of an incompressible cylinder by Johnson for a force.
local function johnson(F)
  local plane = 4 * E / 3
  local a = math.sqrt(2 * F * d / (math.pi * plane))
  return 4 * F / (math.pi * plane) * (math.log(2 * d / a) - 0.5) / d, 2 * F / (math.pi * a)
end

--- Compresses a ring; returns its model and the columns of the table.
local function compressed(order)
  local model, rows = scene(order), {}
  local r = { model = model, compression = {}, force = {}, pressure = {}, lindley = {}, johnson = {},
              johnson_pressure = {} }
  local run = model:run({ { name = "close", steps = options.steps, plate = -options.most * d,
                            center = -options.most * d / 2 } }, {
    on_step = function()
      local C, F = -model:target("plate")[1] / d, -model:reaction("plate").fy
      local p, lindley = math.max(table.unpack(model:profile("top_face").pressure)), E * d * (1.25 * C^1.5 + 50 * C^6)
      local of_force, hertz = johnson(F)
      rows[#rows + 1] = { C, F, lindley, of_force, p, hertz }
      for i, key in ipairs{ "compression", "force", "lindley", "johnson", "pressure", "johnson_pressure" } do
        table.insert(r[key], rows[#rows][i])
      end
    end,
  })
  if run.failed then error(run.failure, 0) end
  print(order)
  print(sg.table{ columns = { "C", "F", "F, Lindley", "C(F), Johnson", "pressure", "2 F/(pi a)" }, rows = rows,
                  formats = { "%.3f", "%.3f", "%.3f", "%.3f", "%.3f", "%.3f" } })
  return r
end

--- The pressure below the plate from left to right, from the last open point to the next.
local function pressures(model, label)
  local profile, points = model:profile "top_face", {}
  for i, x in ipairs(profile.x) do
    if profile.y[i] > d / 2 * (1 - options.most) then points[#points + 1] = { x, profile.pressure[i] } end
  end
  table.sort(points, function(a, b) return a[1] < b[1] end)
  local curve = { x = {}, y = {}, label = label, markers = false }
  for i, point in ipairs(points) do
    if point[2] + (points[i - 1] or point)[2] + (points[i + 1] or point)[2] > 0 then
      table.insert(curve.x, point[1])
      table.insert(curve.y, point[2])
    end
  end
  return curve
end

local pressure = { file = files "pressure.png", title = "Contact pressure below the plate", xlabel = "x (mm)",
                   ylabel = "pressure (MPa)" }
local top, edges, r, last = (1 - options.most) * d, {}
for i, order in ipairs(options.orders) do
  local found = compressed(order)
  r = r or found
  pressure[i] = pressures(found.model, order)
  edges[i] = sg.picture{ model = found.model, field = "syy", label = "σ_yy (MPa)", unit = "mm", title = order,
                         range = { -1, 0.2 }, crop = { 1.25, 2.05, top - 0.6, top + 0.05 } }
  last = found.model
end
sg.chart{ file = files "force.png", title = "Force on an O-ring", xlabel = "compression / diameter",
          ylabel = "force per length (N/mm)",
          { x = r.compression, y = r.force, label = "computed", line = false, markers = true },
          { x = r.johnson, y = r.force, label = "Johnson", markers = false },
          { x = r.compression, y = r.lindley, label = "Lindley", markers = false } }
sg.chart(pressure)
sg.sheet{ edges, columns = #edges, file = files "edge.png", title = "Edge of the contact below the plate" }
sg.picture{ model = last, field = "syy", label = "σ_yy (MPa)", unit = "mm", file = files "states.png", size = 1200,
            title = "Compressed O-ring" }
files:report()

return r
