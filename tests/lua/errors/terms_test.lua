-- Terms of error bars from made-up results of companions, whose errors are known.

require "check"
local terms = require "signorini.errors.terms"

--- The terms of a result value(s, h, n, points, ε) at the fractions s of a path of n steps; h = 1, ε = 1 in the run.
local function column(name, steps, value)
  local function record(level, of)
    local o = lists.merged({ h = level, n = steps, points = 1, penalty = 1 }, of or {})
    local values = {}
    for i = 1, o.n do values[i] = value(i / o.n, o.h, o.n, o.points, o.penalty) end
    return { values = { [name] = values }, size = level, counts = { o.n } }
  end
  local records = { size = 1, ["2h"] = record(2), ["4h"] = record(4), points = record(4, { points = 2 }),
                    penalty = record(2, { penalty = 1 / 2 }), steps = record(2, { n = (steps + 1) // 2 }) }
  records.points.base, records.penalty.base, records.steps.base = records["4h"], records["2h"], records["2h"]
  return terms.of(name, record(1).values[name], records, { steps }, 1e-8)
end

check.case("mesh: an error c h^q, with q between the limits", function()
  local mesh = column("grip.fx", 6, function(_, h) return 1 + 0.01 * h ^ 1.5 end).mesh
  check.near(mesh.order, 1.5, 1e-6)
  check.near(mesh.bars[3], 0.01, 1e-7)
  check.near(column("grip.fx", 6, function(_, h) return 1 + 0.01 * h ^ 3 end).mesh.order, math.log(3.5, 2), 1e-6)
  check.near(column("c.area", 6, function(_, h) return 1 + 0.01 * h ^ 3 end).mesh.order, math.log(2.5, 2), 1e-6)
  local peak = column("c.max_pressure", 6, function(_, h) return 1 + 0.01 * h ^ 3 end).mesh
  check.near(peak.bars[3], 0.07 / (2 ^ 1.5 - 1), 1e-7) -- of order 3/2
end)

check.case("mesh: doubt where differences do not decrease", function()
  check.equal(column("grip.fx", 6, function(_, h) return 1 / h end).mesh.why, "not converging")
end)

check.case("mesh: of an error that oscillates along the path the root mean square of five steps", function()
  local bars = column("grip.fx", 10, function(s, h)
    return 1 + (math.floor(10 * s + 0.5) % 2 == 0 and 0.01 * h or 0)
  end).mesh.bars
  check.near(bars[5], 0.01 * math.sqrt(2 / 5), 1e-4)
  check.near(bars[6], 0.01 * math.sqrt(3 / 5), 1e-4)
end)

check.case("a difference of a larger value counts in proportion", function()
  local bars = column("grip.fx", 3, function(s, h) return s * (1 + 0.01 * h) end).mesh.bars
  check.near(bars[1], 0.01 / 3, 1e-7)
  check.near(bars[3], 0.01 * math.sqrt((1 + 4 + 9) / 27), 1e-7)
end)

check.case("penalty c/ε, points of second order on a mesh of that order", function()
  local all = column("grip.fx", 4, function(_, h, _, points, penalty)
    return 1 + 0.1 * h + 0.01 / penalty + 0.001 * h / points ^ 2
  end)
  check.near(all.penalty[2], 0.01, 1e-9)
  check.near(all.points[2], 0.001, 1e-9)
end)

check.case("steps: an error c/n, also where half of an odd number ends between two", function()
  for _, n in ipairs { 4, 5, 7 } do
    local steps = column("grip.fx", n, function(s, _, m) return s + s ^ 2 + 0.01 / m end).steps
    for i = 2, n do check.near(steps[i], 0.01 / n, 1e-9) end
  end
end)
