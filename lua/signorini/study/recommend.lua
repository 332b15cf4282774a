-- sg.recommend: the cheapest model whose error is within a tolerance. Candidates (discretizations, with each contact
-- formulation if there are several) and meshes are tried from coarse to fine; the error of a coarse case is estimated
-- from the next level, and the search ends as soon as one estimate is within the tolerance.

local check = require "signorini.call.check"
local contact_zone = require "signorini.study.contact_zone"
local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local format_table = require("signorini.output.table").text
local lists = require "signorini.call.lists"
local progress = require "signorini.run.progress"
local types = require "signorini.call.types"
local values = require "signorini.study.values"

local where = "sg.recommend"

-- Assumed convergence factor of one level where it cannot be estimated (that needs three levels): 1/2. Estimates below
-- 1/2 are not trusted, and a ratio near 1 means that the levels do not converge.
local usual_ratio, worst_ratio = 1 / 2, 0.9

-- Work that counts as equal.
local about = 1.1

-- ── Candidates ───────────────────────────────────────────────────────────────────────────────────────────────────────

--- Every order with every formulation, cheapest first: { order, keys, name }.
local function candidates(search)
  local all = {}
  for _, keys in ipairs(search.formulations or { {} }) do
    for _, order in ipairs(search.orders) do
      all[#all + 1] = { order = order, keys = search.formulations and keys or nil,
                        name = search.formulations and ("%s, %s"):format(order, values.text(keys)) or order }
    end
  end
  return all
end

-- ── One case ─────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The result of `quantity` as a list of finite numbers.
local function measure(search, model, run)
  local value
  if type(search.quantity) == "string" then
    local column = run:column(check.value(types.choice(run:columns()), search.quantity, where, "quantity"))
    value = column[#column]
  else
    value = search.quantity(model, run)
  end
  if value == nil then core.fail(where .. ": quantity must return a number or a list of numbers, got nothing") end
  local list = type(value) == "table" and value or { value }
  return check.value(types.list(types.number, nil, 1), list, where, "the result of quantity")
end

--- Raises an error if the second of two levels is not finer, because the error cannot be estimated from them.
local function check_finer(search, candidate, level, unknowns)
  local coarser = search.by_level[level - 1][candidate]
  if coarser and unknowns <= coarser.unknowns then
    core.fail(("%s: %s has %d unknowns on mesh %s and %d on mesh %s. Hint: order meshes from coarse to fine, and "
      .. "use them in scene"):format(where, candidate.name, coarser.unknowns, values.text(coarser.mesh), unknowns,
        values.text(search.meshes[level])))
  end
end

--- Solves a case with layers where contacts have touched in the cases before, if that is wanted; again with larger ones
--- if contacts have touched elsewhere. Returns the model, its run and the layers by contact.
local function solve(search, candidate, level)
  local layered = search.local_layers and candidate.order:find("-", 1, true)
  while true do
    local layers = layered and next(search.touched) and contact_zone.layers(search.touched) or nil
    local model, stages, options = search.scene(candidate.order, search.meshes[level], candidate.keys, layers)
    if type(model) ~= "userdata" then
      core.fail(("%s: scene must return a model and its stages, got %s"):format(where, core.describe(model)))
    end
    check_finer(search, candidate, level, #model:unknowns())
    if not search.local_layers then return model, model:run(stages, options) end
    local own = {}
    local run = model:run(stages, contact_zone.watched(options, model, own))
    local inside = contact_zone.contains(search.touched, own)
    search.touched = contact_zone.union(search.touched, own)
    if not layers or inside or run.failed then return model, run, layers end
  end
end

--- Solves a case; adds it to the list of tries.
local function try(search, candidate, level)
  local mesh, began = search.meshes[level], core.now()
  local model, run, layers = solve(search, candidate, level)
  local case = { candidate = candidate, order = candidate.order, formulation = candidate.keys, mesh = mesh,
                 name = candidate.name .. (layers and ", local" or ""), level = level, wall = core.now() - began,
                 unknowns = #model:unknowns(), layers = layers, touched = layers and search.touched }
  -- Unlike seconds it is the same in every search, so that the result is reproducible.
  case.work = case.unknowns * run.iterations
  if run.failed then case.failed = run.reason else case.value = measure(search, model, run) end
  search.interrupted = run.reason == "interrupted"
  search.tries[#search.tries + 1] = case
  search.by_level[level][candidate] = case
  search.spent = search.spent + case.wall
  search.display:line(("recommend: %s, mesh %s: %s, %.2f s%s"):format(case.name, values.text(mesh),
    counted(case.unknowns, "unknown"), case.wall, case.failed and ", " .. case.failed or ""))
  return case
end

-- ── Estimates ────────────────────────────────────────────────────────────────────────────────────────────────────────

local function norm(list)
  local sum = 0
  for _, value in ipairs(list) do sum = sum + value ^ 2 end
  return math.sqrt(sum)
end

--- ‖a − b‖ / ‖b‖.
local function distance(a, b)
  if #a ~= #b then
    core.fail(("%s: quantity returned lists of %d and of %d numbers. Hint: return the values at the same places "
      .. "each time"):format(where, #a, #b))
  end
  local difference, scale = lists.map(a, function(value, i) return value - b[i] end), norm(b)
  if scale == 0 then
    core.fail(where .. ": the result of quantity is zero, so it has no relative error. Hint: choose another quantity")
  end
  return norm(difference) / scale
end

local function solved(search, level, candidate)
  local case = (search.by_level[level] or {})[candidate]
  return case and case.value and case
end

--- The convergence factor of a level: the ratio of errors that the last three levels of the discretization show.
local function ratio(search, candidate, level)
  local older, old = solved(search, level - 2, candidate), solved(search, level - 1, candidate)
  local new = solved(search, level, candidate)
  if not older then return usual_ratio end
  local before, now = distance(older.value, old.value), distance(old.value, new.value)
  if before == 0 then return now == 0 and usual_ratio or worst_ratio end
  return math.max(usual_ratio, math.min(worst_ratio, now / before))
end

--- Estimates errors with `reference`, a case whose discretization was also solved on the level below. With the distance
--- d of these two and the convergence factor r of a level, the error of the reference is at most d (r + r² + …) = d
--- r/(1 − r); that of a coarser case is larger by its distance from the reference.
local function estimate(search, reference)
  local level = reference.level
  local r = ratio(search, reference.candidate, level)
  local own = distance(solved(search, level - 1, reference.candidate).value, reference.value) * r / (1 - r)
  reference.error = own
  for _, case in pairs(search.by_level[level - 1]) do
    if case.value then case.error = distance(case.value, reference.value) + own end
  end
end

local function cheapest(search)
  return lists.least(search.tries, function(case)
    return case.error and case.error <= search.at_most and case.work
  end)
end

--- True if another discretization is twice as accurate on a level for about the same work: then this one is not tried
--- again.
local function dominated(search, candidate, level)
  local case = solved(search, level, candidate)
  for _, other in pairs(search.by_level[level]) do
    if case and case.error and other.error and other.error < case.error / 2 and other.work < about * case.work then
      return true
    end
  end
  return false
end

-- ── The search ───────────────────────────────────────────────────────────────────────────────────────────────────────

--- The last discretization, with the most functions, that was solved on a level and on the one below.
local function reference_on(search, level)
  for i = #search.candidates, 1, -1 do
    local last = search.candidates[i]
    if not solved(search, level, last) then try(search, last, level) end
    if search.interrupted then return end
    if solved(search, level, last) and solved(search, level - 1, last) then return solved(search, level, last) end
  end
end

local function explore(search)
  for level = 1, #search.meshes do
    local reference = level > 1 and reference_on(search, level)
    if reference then estimate(search, reference) end
    local best = cheapest(search)
    if best or search.interrupted or (search.limit and search.spent > search.limit) then return best end
    for _, candidate in ipairs(search.candidates) do
      if not search.by_level[level][candidate] and level < #search.meshes
         and not dominated(search, candidate, level - 1) then
        try(search, candidate, level)
        if search.interrupted then return end
      end
    end
  end
end

-- ── The result ───────────────────────────────────────────────────────────────────────────────────────────────────────

local Recommendation = {}
Recommendation.__index = Recommendation
Recommendation.__name = "recommendation"

local function verdict(search, best)
  local total = ("%s, %.2f s in all"):format(counted(#search.tries, "run"), search.spent)
  if search.interrupted then return ("Stopped by Ctrl-C without a result. %s."):format(total) end
  if best then
    local extent = best.layers and (" Contacts touch in %s."):format(contact_zone.text(best.touched)) or ""
    return ("%s on mesh %s meets the tolerance: its error is about %.3g, estimated from the next level; allowed %.3g. "
      .. "%s.%s")
      :format(best.name, values.text(best.mesh), best.error, search.at_most, total, extent)
  end
  local nearest = lists.least(search.tries, function(case) return case.error end)
  return ("None of these is known to be within %.3g%s. %s. Hint: try finer meshes.")
    :format(search.at_most, nearest and ("; %s on mesh %s comes nearest with %.3g"):format(nearest.name,
      values.text(nearest.mesh), nearest.error) or "", total)
end

--- The tries, and the result.
function Recommendation:__tostring()
  local rows = lists.map(self.tries, function(case)
    local value = case.value and (#case.value == 1 and case.value[1] or ("%d numbers"):format(#case.value))
    return { case.name, values.text(case.mesh), case.unknowns, case.wall, case.failed or value, case.error,
             case == self.best and "chosen" or "" }
  end)
  return format_table{ columns = { "order", "mesh", "unknowns", "wall", "value", "estimated error", "" },
    units = { [4] = "s" }, rows = rows, formats = { [4] = "%.3f", [6] = "%.2e" } } .. "\n" .. self.report
end

return function(search)
  search.candidates = candidates(search)
  search.tries, search.by_level, search.spent, search.display = {}, { [0] = {} }, 0, progress(1)
  search.touched = {}
  for level = 1, #search.meshes do search.by_level[level] = {} end
  local best = explore(search)
  local found = best or {}
  local result = setmetatable({ order = found.order, formulation = found.formulation, mesh = found.mesh,
    error = found.error, wall = found.wall, unknowns = found.unknowns, best = best, tries = search.tries,
    layers = found.layers, spent = search.spent, report = verdict(search, best) }, Recommendation)
  print(result)
  return result
end
