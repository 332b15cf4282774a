-- Derivatives of generated scenes: how exact they are, next to Euler's identity and to differences of whole runs.
--
-- Problem: scenes of tests/lua/walk_scenes.lua: bodies and obstacles of all kinds of models, laws, formulations and
--          loads that are pressed together and slide, in two stages of three steps.
-- Source: Euler's theorem on homogeneous functions: forces scale with the unit of stress of moduli, penalties,
--         strengths and loads, so that dF/d(unit) = F. Differences of runs at a relative distance of 1e-5 in
--         E, mu and the penalty.
-- Units: none.
-- Expected: both to rounding errors, 1e-7 and 1e-6 of the largest force and derivative.
-- Run: signorini tests/measure/gradients.lua [first=1] [last=200] [all=yes]

local core = require "signorini.core"
package.path = ("%s;%s/tests/lua/?.lua"):format(package.path, core.home)
local sg = require "signorini"
local lists = require "signorini.call.lists"
local scenes = require "walk_scenes"

local options = sg.arguments{ first = 1, last = 200, all = false }
local noticed_force = 1e-9 -- below it nothing touches, and forces are rounding errors

--- Numbers of points by state, which change where results have a kink.
local function states_of(model)
  local now = model:contact_resultant "touch"
  return { closed = now.active, slipping = now.slipping }
end

--- The scene of a seed as a function of its parameters.
local function scene_of(seed)
  return function(q)
    local scene = scenes.describe(seed)
    scene.unit, scene.E, scene.penalty = q.unit, q.E, q.penalty
    if scene.mu > 0 then scene.mu = q.mu end
    local model, target = scenes.build(scene)
    local stages = lists.map({ 1, 2 }, function(k)
      local to = scene.walk[k]
      return { name = "part " .. k, steps = 3, grip = target(to.x, math.abs(to.depth), to.angle) }
    end)
    return model, stages, { newton = { tolerance = 1e-12 }, verbose = false, measure = states_of }
  end
end

--- The columns of forces of a run, and the largest force.
local function forces_of(found)
  local names = lists.filter(found.results, function(name) return name:find "%.f[xyz]$" end)
  local largest = 0
  for _, name in ipairs(names) do
    for _, value in ipairs(found.run:column(name)) do largest = math.max(largest, math.abs(value)) end
  end
  return names, largest
end

--- The largest difference of dF/d(unit) from F, relative to the largest force.
local function euler(found, names, largest)
  local most = 0
  for _, name in ipairs(names) do
    local slopes = found:column(name, "unit")
    for row, value in ipairs(found.run:column(name)) do most = math.max(most, math.abs(slopes[row] - value)) end
  end
  return most / largest
end

--- The largest difference of derivatives and secants over all forces and steps, relative to the largest derivative of
--- a force or, if that is larger, a thousandth of the largest force per size of the parameter; nil at kinks: if states
--- differ.
local function difference(make, at, found, names, largest, parameter)
  if lists.any(found.kinks, function(kink) return kink.parameter == parameter end) then return nil end
  local distance, ends = 1e-5 * at[parameter], {}
  for k, sign in ipairs { 1, -1 } do
    local model, stages, options = make(lists.merged(at, { [parameter] = at[parameter] + sign * distance }))
    ends[k] = model:run(stages, options)
    for _, name in ipairs { "closed", "slipping" } do
      if table.concat(ends[k]:column(name), " ") ~= table.concat(found.run:column(name), " ") then return nil end
    end
  end
  local most, size = 0, 1e-3 * largest / at[parameter]
  for _, name in ipairs(names) do
    local plus, minus = ends[1]:column(name), ends[2]:column(name)
    for row, slope in ipairs(found:column(name, parameter)) do
      most = math.max(most, math.abs((plus[row] - minus[row]) / (2 * distance) - slope))
      size = math.max(size, math.abs(slope))
    end
  end
  return most / size
end

--- The outcome of a seed: { text, why (it does not count), euler, differences (a list), other (pairs of runs with other
--- states) }.
local function measure(seed)
  local scene = scenes.describe(seed)
  local at = { unit = 1, E = scene.E, penalty = scene.penalty, mu = scene.mu > 0 and scene.mu or nil }
  local row = { text = scenes.text(scene), differences = {}, other = 0 }
  local done, found = pcall(sg.gradients, { scene = scene_of(seed), at = at })
  if not done or found.run.failed then
    row.why = done and "run ended" or "error"
    row.text = ("%s: %s"):format(row.text, done and found.run.failure or found)
    return row
  end
  local names, largest = forces_of(found)
  if largest < noticed_force then
    row.why = "no force"
    return row
  end
  row.euler = euler(found, names, largest)
  for _, parameter in ipairs { "E", "mu", "penalty" } do
    if at[parameter] then
      local value = difference(scene_of(seed), at, found, names, largest, parameter)
      if value then
        row.differences[#row.differences + 1] = value
        if value > 1e-6 then row.text = ("%s; %s: %.2g"):format(row.text, parameter, value) end
      else
        row.other = row.other + 1
      end
    end
  end
  return row
end

core.mute_warnings(true)
local counts, identity, differences, other = {}, {}, {}, 0
for seed = options.first, options.last do
  local row = measure(seed)
  local kind = row.why or "compared"
  counts[kind] = (counts[kind] or 0) + 1
  if options.all or row.why == "error" then print(row.text, row.why or row.euler) end
  identity[#identity + 1] = row.euler
  differences, other = lists.joined(differences, row.differences), other + row.other
end
core.mute_warnings(false)

--- The value below which this part of a sorted list lies.
local function quantile(list, part) return ("%.1g"):format(list[math.max(1, math.ceil(part * #list))]) end

table.sort(identity)
table.sort(differences)
print(sg.table{ columns = { "scenes", "number" }, rows = lists.map(lists.sorted_names(counts), function(kind)
  return { kind, counts[kind] }
end) })
print(sg.table{ columns = { "error", "number", "median", "95 %", "largest" }, rows = {
  { "Euler's identity", #identity, quantile(identity, 0.5), quantile(identity, 0.95), quantile(identity, 1) },
  { "differences", #differences, quantile(differences, 0.5), quantile(differences, 0.95), quantile(differences, 1) },
} })
print(("%d further pairs of runs are on two sides of a kink"):format(other))
