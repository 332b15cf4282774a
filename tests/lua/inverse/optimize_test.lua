-- Optima: closed forms, limits with their multipliers, bounds, kinks, searches that end early, and wrong input.

local check, sg, lists, core = require "check", require "signorini", require "signorini.call.lists", core

local tight = { newton = { tolerance = 1e-12 } }

--- A block without lateral strain on a penalty plane, pressed by d: F = ε k d/(k + ε), k = E/H per width 1.
local function pressed(q)
  local block = sg.body { patch = sg.shapes.rectangle { width = 1, height = q.H },
                          elements = { 1, 1 }, order = "N2", material = sg.linear_elastic { E = q.E, nu = 0 } }
  local model = sg.model {
    bodies = { block = block },
    supports = { lid = { on = block:face "north", fix = "x", drive = "y" } },
    contacts = { c = { slave = block:face "south", master = sg.rigid.plane { point = { 0, 0 }, normal = { 0, 1 } },
                       penalty = 10, per = "reference" } } }
  return model, { { steps = 1, lid = -0.01 } }, tight
end

local function force(k) return 10 * k * 0.01 / (k + 10) end

local function optimum(keys)
  return sg.optimize(lists.merged({ scene = pressed, start = { E = 2, H = 0.5 }, bounds = { H = { 0.5, 0.5 } },
                                    least = function(run) return (check.last(run, "lid.fy") + 0.04) ^ 2 end }, keys))
end

check.case("the stiffness at which a force is reached", function()
  local found = optimum {}
  check.near(found.at.E, 0.5 * 0.4 / (0.1 - 0.04), 1e-5) -- F = 0.04
  check.equal({ found.least, found.reason, found.limits }, { "least", "converged", {} })
  check.at_most("runs", #found.tries, 8)
  check.holds(tostring(found), "least", "from 0.000130612 at the start")
end)

check.case("a limit is reached, with its multiplier", function()
  -- The least lid.fy = −F with F ≤ 0.05: at k = 10, and the result falls by dF/dF = 1 per unit of the limit.
  local found = optimum { least = "lid.fy", where = { ["c.fy"] = { 0, 0.05 } } }
  check.near(found.at.E, 5, 1e-5)
  check.near(found.value, -0.05, 1e-6)
  local limit = found.limits[1]
  check.equal({ limit.name, limit.from, limit.to }, { "c.fy", 0.0, 0.05 })
  check.near({ limit.value, limit.multiplier }, { 0.05, 1 }, 1e-4)
  check.holds(tostring(found), "c.fy", "0 to 0.05, active")
  -- Not reached: 0.09 would need E = 45.
  local free = optimum { least = "lid.fy", bounds = { H = { 0.5, 0.5 }, E = { 1, 20 } },
                         where = { ["c.fy"] = { 0, 0.09 } } }
  check.equal({ free.at.E, free.at_bounds, free.limits[1].multiplier }, { 20, { "E" }, 0 })
  check.near(free.value, -force(40), 1e-8)
end)

check.case("two parameters on a limit", function()
  -- The least k + 25/k, which is at k = 5, with k = E/H ≥ 8.
  local found = optimum { start = { E = 2, H = 0.5 }, bounds = { H = { 0.1, 1 }, E = { 0.1, 10 } },
    measure = function(model)
      local k = -model:reaction "lid"[2] / 0.01
      return { stiffness = 10 * k / (10 - k) }
    end,
    least = function(run)
      local k = check.last(run, "stiffness")
      return k + 25 / k
    end, where = { stiffness = { 8, math.huge } } }
  check.near(found.at.E / found.at.H, 8, 1e-4)
  check.near(found.value, 8 + 25 / 8, 1e-4)
  -- d(k + 25/k)/dk at 8
  check.near(-found.limits[1].multiplier, 1 - 25 / 64, 1e-3)
end)

check.case("a least value at a kink", function()
  local found = optimum { least = function(run) return math.abs(check.last(run, "lid.fy") + 0.04) + 0.1 end }
  check.near(found.at.E, 10 / 3, 1e-3)
  check.equal(found.reason, "stalled")
  check.holds(found.warnings[1], "have a kink")
end)

check.case("limits that cannot be kept are exceeded as little as possible", function()
  local found = optimum { least = "lid.fy", bounds = { H = { 0.5, 0.5 }, E = { 1, 5 } },
                          where = { ["c.fy"] = { 0.06, 1 } } }
  check.near(found.at.E, 5, 1e-9)
  check.equal({ found.reason, found.limits[1].multiplier }, { "infeasible", nil })
  check.holds(tostring(found), "exceeded")
  check.holds(found.warnings[1], "c.fy = 0.05 is not between 0.06 and 1")
end)

check.case("early ends, files and reports", function()
  local file = check.file "optimum.json"
  local begun = optimum { runs = 2, checkpoint = file }
  check.equal({ begun.reason, #begun.tries }, { "runs", 2 })
  local done = optimum { checkpoint = file, resume = true }
  check.near(done.at.E, 10 / 3, 1e-5)
  local page = check.file "optimum.html"
  done:report(page)
  check.holds(core.read_file(page), "<h2>Optimum</h2>", "<td>E</td>")
  check.fails(function() sg.fit { scene = pressed, start = { E = 2, H = 0.5 }, checkpoint = file, resume = true,
    data = { { y = "lid.fy", points = { { 1, 0 }, { 1, 0 }, { 1, 0 } } } } } end, "is not that of such a search")
end)

check.case("limits that limit nothing, and results that do not change", function()
  local found = optimum { least = "lid.fy", bounds = { H = { 0.5, 0.5 }, E = { 1, 20 } },
                          where = { ["c.fy"] = { -math.huge, math.huge } } }
  check.equal({ found.at.E, found.limits }, { 20, {} })
  local constant = optimum { least = function() return 1 end, where = { ["c.fy"] = { 0, 0.05 } } }
  check.equal({ constant.reason, constant.at.E, constant.limits[1].multiplier }, { "converged", 2.0, 0 })
end)

check.case("wrong input", function()
  local function refused(text, keys) check.fails(function() optimum(keys) end, text) end
  refused("least must be", { least = "lid.uy" })
  refused("the result of least is missing: it must be a finite number", { least = function() end })
  refused("where[\"c.fz\"] must be", { where = { ["c.fz"] = { 0, 1 } } })
  refused('where["c.fy"] must be {from, to}, got {1, 0}', { where = { ["c.fy"] = { 1, 0 } } })
  refused('where["c.fy"] must be {from, to}', { where = { ["c.fy"] = { 0 / 0, 1 } } })
  refused("start.E = 2 is not within its bounds", { bounds = { E = { 3, 4 } } })
  refused("must return a model", { scene = function(q) return q.E + q.H end })
end)
