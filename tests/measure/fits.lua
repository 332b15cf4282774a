-- Fits of data with noise: how often the true values lie in the intervals, and optima next to scans.
--
-- Problem: (1) a half ring is pressed onto a thin layer and slides; E and nu of the layer and mu from both forces with
--          noise of 1 % of the largest. (2) A film is peeled off at 90°; strength and energy of the bonds from the
--          force with noise of 1 %. (3) A punch y = h |x/w|^n under a given force: the n of least peak pressure; a
--          cylinder: the radius of the least approach at which the peak pressure stays below a limit.
-- Source: data are runs of the same scenes with known values. Intervals of 95 % contain the true value in about 95 of
--         100 fits; scans of the same scenes give the optima.
-- Units: none; (2) mm, N, MPa.
-- Expected: (1), (2) the true values in 90 to 99 of 100 intervals; (3) the optima of the scans.
-- Run: signorini tests/measure/fits.lua [first=1] [last=100] [scan=40]

local sg = require "signorini"
local lists = require "signorini.call.lists"

local options = sg.arguments{ first = 1, last = { 100, at_least = 1 }, scan = { 40, at_least = 2 } }

-- ── Scenes ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local function iron(q)
  local layer = sg.body{ patch = sg.shapes.rectangle{ width = 4, height = 0.4 }, elements = { 16, 2 }, order = "N2",
                         material = sg.neo_hookean{ E = q.E, nu = q.nu } }
  local ring = sg.body{ patch = sg.shapes.half_annulus{ inner = 0.3, outer = 0.8, center = { 1.5, 1.2 } },
                        elements = { 8, 2 }, order = "N2", material = sg.neo_hookean{ E = 10, nu = 0.3 } }
  local model = sg.model{ bodies = { layer = layer, ring = ring },
    supports = { bed = { on = layer:face "south", fix = "xy" },
                 lid = { on = { ring:face "west", ring:face "east" }, drive = "xy" } },
    contacts = { c = { slave = ring:face "south", master = layer:face "north", penalty = 40,
                       friction = { mu = q.mu, penalty = 40 } } } }
  return model, { { name = "press", steps = 5, lid = { 0, -0.1 } }, { name = "slide", steps = 20, lid = { 1, -0.1 } } }
end

local free, thickness, lift = 2, 0.1, 4 -- mm

local function peel(q)
  local film = sg.body{ patch = sg.shapes.rectangle{ width = 7, height = thickness }, elements = { 35, 1 },
                        order = "N2", contact = "south", thickness_degree = 2,
                        material = sg.neo_hookean{ E = 2000, nu = 0.3 } }
  local model = sg.model{ bodies = { film = film },
    supports = { clamp = { on = film:face "east", fix = "xy" }, grip = { on = film:corner "south-west", drive = "y" } },
    contacts = { glue = { slave = film:face "south", master = sg.rigid.plane{ point = { 0, 0 }, normal = { 0, 1 } },
                          penalty = 2000, cohesive = { strength = q.strength, energy = q.energy,
                                                       where = function(X) return X[1] >= free end } } } }
  return model, { { name = "peel", steps = 30, grip = lift } }
end

--- A layer, half of it by symmetry, and a tool that a force presses on it.
local function pressed(tool, width, by)
  local layer = sg.body{ patch = sg.shapes.rectangle{ width = width, height = 1 }, elements = { 32, 8 },
                         order = "N2-N2.2", contact = "north", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  local model = sg.model{ bodies = { layer = layer },
    supports = { bed = { on = layer:face "south", fix = "xy" }, axis = { on = layer:face "west", symmetry = true },
                 tool = { on = tool, free = "y" } },
    loads = { weight = { on = tool, force = { 0, 0 } } },
    contacts = { c = { slave = layer:face "north", master = tool, penalty = 100 } } }
  return model, { { steps = 4, weight = { 0, -by } } }
end

local function punch(q)
  local height, half = 0.05, 0.6
  return pressed(sg.rigid.level_set{ box = { { -1, 0.5 }, { 1, 1.5 } }, f = function(x, y)
    return 1 + height * ((x / half) ^ 2 + 1e-6) ^ (q.n / 2) - y
  end }, 2, 0.1)
end

local function cylinder(q) return pressed(sg.rigid.cylinder{ center = { 0, 1 + q.R }, radius = q.R }, 2, 0.05) end

-- ── Fits ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

local function gauss() return math.sqrt(-2 * math.log(1 - math.random())) * math.cos(2 * math.pi * math.random()) end

--- A column with noise of 1 % of its largest value, over x, and the standard deviation.
local function noisy(run, x, name, size)
  local values = run:column(name)
  size = 0.01 * (size or math.max(table.unpack(lists.map(values, math.abs))))
  return lists.map(run:column(x), function(at, i) return { at, values[i] + size * gauss() } end), size
end

--- Fits data of all seeds: { name of a parameter, true value, how many intervals contain it }, and the mean of runs.
local function coverage(scene, truth, start, bounds, data_of)
  local run = (function() local model, stages = scene(truth) return model:run(stages) end)()
  local inside, runs, widths = {}, 0, {}
  for seed = options.first, options.last do
    math.randomseed(seed)
    local fit = sg.fit{ scene = scene, start = start, bounds = bounds, data = data_of(run), check = false }
    runs = runs + #fit.tries
    for name, value in pairs(truth) do
      local at = fit.intervals[name]
      if at and at[1] <= value and value <= at[2] then inside[name] = (inside[name] or 0) + 1 end
      widths[name] = (widths[name] or 0) + (at and (at[2] - at[1]) / 2 or 0)
    end
  end
  local count = options.last - options.first + 1
  return lists.map(lists.sorted_names(truth), function(name)
    return { name, truth[name], widths[name] / count, ("%d of %d"):format(inside[name] or 0, count) }
  end), runs / count
end

local ironed, ironing_runs = coverage(iron, { E = 1, nu = 0.3, mu = 0.3 }, { E = 2, nu = 0.2, mu = 0.5 },
  { nu = { 0, 0.49 } }, function(run)
    local down, sigma = noisy(run, "step", "lid.fy")
    return { { y = "lid.fy", points = down, sigma = sigma },
             { y = "lid.fx", points = noisy(run, "step", "lid.fx", 100 * sigma), sigma = sigma } }
  end)
local peeled, peeling_runs = coverage(peel, { strength = 1, energy = 0.1 }, { strength = 2, energy = 0.2 }, nil,
  function(run) return { { x = "grip.uy", y = "grip.fy", points = (noisy(run, "grip.uy", "grip.fy")) } } end)
print(sg.table{ columns = { "parameter", "true", "half interval", "inside" }, rows = lists.joined(ironed, peeled),
                formats = { [3] = "%.2g" } })
print(("runs per fit: ironing %.2g, peeling %.2g"):format(ironing_runs, peeling_runs))

-- ── Optima ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Values from..to in steps of equal factors.
local function spread(from, to)
  local list = {}
  for i = 0, options.scan do list[i + 1] = from * (to / from) ^ (i / options.scan) end
  return list
end

--- Last values of columns of a scene with one parameter, at each value.
local function scan(scene, name, values, columns)
  return lists.map(values, function(value)
    local model, stages = scene{ [name] = value }
    local run = model:run(stages)
    return lists.map(columns, function(column) return run:column(column)[run.rows] end)
  end)
end

local exponents = spread(2, 4)
local pressures = scan(punch, "n", exponents, { "c.max_pressure" })
local least = 1
for i, row in ipairs(pressures) do if row[1] < pressures[least][1] then least = i end end
local found = sg.optimize{ scene = punch, start = { n = 5 }, bounds = { n = { 2, 8 } }, least = "c.max_pressure" }

local limit = 0.1
local radii = spread(1, 5)
local at = 1
local pressed_by = scan(cylinder, "R", radii, { "c.max_pressure" })
while pressed_by[at + 1][1] > limit do at = at + 1 end
local part = (pressed_by[at][1] - limit) / (pressed_by[at][1] - pressed_by[at + 1][1])
local radius = radii[at] * (radii[at + 1] / radii[at]) ^ part
local smallest = sg.optimize{ scene = cylinder, start = { R = 1 }, bounds = { R = { 0.5, 5 } },
  least = "tool.uy", where = { ["c.max_pressure"] = { 0, limit } } }
print(sg.table{ columns = { "optimum", "search", "scan", "runs" }, rows = {
  { "exponent of least peak pressure", found.at.n, exponents[least], #found.tries },
  { "its peak pressure", found.value, pressures[least][1] },
  { "radius that comes deepest, peak pressure limited", smallest.at.R, radius, #smallest.tries } } })

return { ironed = ironed, peeled = peeled, found = found, exponent = exponents[least], smallest = smallest,
         radius = radius, pressure = pressures[least][1] }
