-- The variant with local layers: oscillation, unknowns and time of layers on the whole faces and along the path only.

local sg = require "signorini"
local measure = require "problems.ironing3d.measure"
local problem = require "problems.ironing3d.problem"

local layers = {}

--- Where the slab has its layer, by name.
local function places(options)
  local reach = options.reach
  return {
    { "whole faces" },
    { "strip along the slab", { slab = { { 0, 1 }, { 0.5 - reach / 30, 0.5 + reach / 30 } } } },
    { "path", { slab = { { (options.from - reach) / 100, (measure.to + reach) / 100 },
                         { 0.5 - reach / 30, 0.5 + reach / 30 } } } },
  }
end

local function solve(order, place, options)
  return measure.oscillations(problem.solve{
    order = order, mesh = options.mesh, radius = options.radius, mu = options.mu, layer = place[2],
    depth = problem.published_depth - options.gap, from = options.from, distance = measure.to - options.from,
    down = options.down, linear = options.linear,
  })
end

--- Returns { cases }.
function layers.run(options)
  local cases, rows = {}, {}
  for _, order in ipairs(options.orders) do
    local whole
    for i, place in ipairs(places(options)) do
      local case = solve(order, place, options)
      whole = i == 1 and case or whole
      if case.run.failed then error(("%s, %s: %s"):format(order, place[1], case.run.failure), 0) end
      case.place, case.unknowns = place[1], #case.model:unknowns()
      cases[#cases + 1] = case
      local t = case.run.timings
      rows[#rows + 1] = { order, place[1], case.unknowns, case.run.iterations, case.run.wall, t.linear, t.contact,
                          t.bulk, 100 * case.run.wall / whole.run.wall, case.dPx.raw, case.dPz.raw,
                          100 * (case.dPx.raw / whole.dPx.raw - 1), 100 * (case.dPz.raw / whole.dPz.raw - 1) }
      case.dPx_percent, case.dPz_percent = rows[#rows][12], rows[#rows][13]
      print(("%s, %s: %.1f s"):format(order, place[1], case.run.wall))
      if i > 1 then case.model = nil end
    end
  end
  print(sg.table{
    columns = { "order", "layer on", "unknowns", "iterations", "wall", "linear", "contact", "bulk", "of whole", "dPx",
                "dPz", "dPx", "dPz" },
    units = { "", "", "", "", "s", "s", "s", "s", "%", "", "", "% off", "% off" }, rows = rows,
    formats = { "%s", "%s", "%d", "%d", "%.2f", "%.2f", "%.2f", "%.2f", "%.0f", "%.4f", "%.4f", "%.2f", "%.2f" },
  })
  return { cases = cases }
end

return layers
