-- sg.recommend: the cheapest discretization and contact formulation whose error bars are within a tolerance. Each
-- candidate climbs the levels of model:run(path, { tolerance = … }) as long as it may become the cheapest one.

local check = require "signorini.call.check"
local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local format_table = require("signorini.output.table").text
local ladder = require "signorini.errors.ladder"
local lists = require "signorini.call.lists"
local progress = require "signorini.run.progress"
local values = require "signorini.study.values"

local where = "sg.recommend"

--- Every combination of the lists of candidates, in their order: { order, formulation, thickness_degree, name }.
local function candidates(search)
  local all = { {} }
  for _, pair in ipairs { { "formulation", search.formulations }, { "thickness_degree", search.thickness_degrees },
                          { "order", search.orders } } do
    local key, list = table.unpack(pair)
    all = lists.flat(lists.map(all, function(begun)
      return list and lists.map(list, function(value) return lists.merged(begun, { [key] = value }) end) or { begun }
    end))
  end
  return lists.map(all, function(one)
    return lists.merged(one, { name = table.concat(lists.joined({ one.order },
      { one.formulation and values.text(one.formulation) },
      { one.thickness_degree and ("thickness_degree = %d"):format(one.thickness_degree) }), ", ") })
  end)
end

--- What scene is called with, and whether it has read the mesh: then it is also called for other meshes, otherwise they
--- are made from the tables of sg.body and sg.model.
local function arguments(candidate, mesh)
  local reads = {}
  return setmetatable({}, { __index = function(_, key)
    reads[key] = true
    if key == "mesh" then return mesh end
    return candidate[key]
  end }), reads
end

local function call_scene(search, candidate, mesh)
  local q, reads = arguments(candidate, mesh)
  local model, stages, options = search.scene(q)
  if type(model) ~= "userdata" or core.kind(model) ~= "model" then
    core.fail(("%s: scene must return a model and its stages, got %s"):format(where, core.describe(model)))
  end
  return reads.mesh, model, stages, options
end

--- Climbs with a candidate; adds its levels to the tries.
local function try(search, candidate)
  local reads_mesh, model, list, options = call_scene(search, candidate, 1)
  list, options = check.call("model:run", model, list, lists.merged(options or {}, { tolerance = search.tolerance }))
  if reads_mesh then
    options.errors = { scene = function(q) return select(2, call_scene(search, candidate, q.mesh)) end }
  end
  local level, levels = ladder.solve(model, list, options, search.goals, function(last, _, times)
    if search.best and times * last.work > search.best.work then return "another candidate is cheaper" end
    local spent = core.now() - search.began
    if search.limit and spent + times * last.run.wall > search.limit then return "limit" end
  end, search.display)
  search.interrupted = not level and levels == core.interruption()
  if search.interrupted then return end
  if not level then core.fail(levels) end
  for _, one in ipairs(levels) do
    search.tries[#search.tries + 1] = lists.merged(one, { name = candidate.name, order = candidate.order,
      formulation = candidate.formulation, thickness_degree = candidate.thickness_degree })
  end
  search.interrupted = level.run.reason == "interrupted"
  local reached = level.part <= 1 and not level.run.failed
  if reached and not (search.best and search.best.work <= level.work) then
    search.best = { work = level.work, candidate = candidate, level = level, levels = levels,
                    try = search.tries[#search.tries] }
  end
end

local Recommendation = {}
Recommendation.__index = Recommendation
Recommendation.__name = "recommendation"

local function verdict(search)
  local total = ("%s, %.2f s in all"):format(counted(#search.tries, "level"), search.spent)
  if search.interrupted then return ("Stopped by Ctrl-C without a result. %s."):format(total) end
  local wanted, best = table.concat(search.tolerance, ", "), search.best
  if best then
    return ("%s, %s: %s. %s."):format(best.candidate.name, ladder.settings(best.level, best.levels).text, wanted, total)
  end
  local nearest = lists.least(search.tries, function(one) return one.part end)
  return ("None of these reaches %s%s. %s. Hint: give more time by limit."):format(wanted,
    nearest and ("; %s, %s comes nearest with %.3g times that"):format(nearest.name, nearest.settings, nearest.part)
      or "", total)
end

--- The tries, and the result.
function Recommendation:__tostring()
  local rows = lists.map(self.tries, function(one)
    return { one.name, one.settings, one.unknowns, one.wall, one.failed or one.part,
             one == self.best and "chosen" or "" }
  end)
  return format_table{ columns = { "candidate", "settings", "unknowns", "wall", "error / tolerance", "" },
    units = { [4] = "s" }, rows = rows, formats = { [4] = "%.3f", [5] = "%.3g" } } .. "\n" .. self.report
end

return function(search)
  search.goals, search.began, search.tries = ladder.goals(where, search.tolerance), core.now(), {}
  search.display = progress(0)
  for _, candidate in ipairs(candidates(search)) do
    if not search.interrupted then try(search, candidate) end
  end
  search.spent = core.now() - search.began
  local best = not search.interrupted and search.best or nil
  local chosen = best and best.candidate or {}
  local result = setmetatable({ order = chosen.order, formulation = chosen.formulation,
    thickness_degree = chosen.thickness_degree, settings = best and ladder.settings(best.level, best.levels),
    model = best and best.level.model, run = best and best.level.run, best = best and best.try, tries = search.tries,
    spent = search.spent, report = verdict(search) }, Recommendation)
  print(result)
  return result
end
