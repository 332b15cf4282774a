-- model:run(path, { tolerance = "1 % of grip.fx" }): the path is solved on finer meshes, with a richer row at the
-- contact, other penalties, steps and points, until the error bars of the goals are within the tolerance. Each level is
-- a companion of the next [theory 11.6].

local companions = require "signorini.errors.companions"
local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local history = require "signorini.errors.history"
local lists = require "signorini.call.lists"
local meant = require("signorini.call.text").meant
local progress = require "signorini.run.progress"
local recipes = require "signorini.scene.recipes"
local remade = require "signorini.errors.remade"
local Run = require "signorini.run.run_result"
local run_warnings = require "signorini.run.run_warnings"

local ladder = {}

local where = "model:run"

local other_share = 1 / 6 -- of the tolerance for each of penalty, steps and points
local mesh_share = 1 / 2 -- and for the mesh
local powers = { penalty = 1, steps = 1, points = 2 } -- of the factor by which their terms decrease
local most_finer = 2 -- elements per direction of a level, in units of those of the level before
local nearly = 1.6 -- a factor from which on the elements are doubled, so that the level before is a companion
local stiffest = 100 / 3 -- penalty in units of the default one: 1000 E/h
local most_levels = 8
local growth = 1.3 -- exponent of the time over the number of elements
local slack = 1.1 -- of a factor that is not worth a change

-- ── Goals ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The goals { share, name, from (the function named in errors) } of texts such as "1 % of grip.fx".
function ladder.goals(from, texts)
  return lists.map(texts, function(text, i)
    local percent, name = text:match "^%s*([%d.eE+-]+)%s*%%%s*of%s+(%S+)%s*$"
    local share = tonumber(percent)
    if not share or not (share > 0 and share <= 100) then
      core.fail(('%s: tolerance%s must be a text such as "1 %% of grip.fx", with more than 0 and at most 100 %%, got %q')
        :format(from, #texts > 1 and ("[%d]"):format(i) or "", text))
    end
    return { from = from, share = share / 100, name = name }
  end)
end

local function check_names(goals, names)
  for _, goal in ipairs(goals) do
    if not lists.holds(names, goal.name) then
      core.fail(("%s: tolerance: '%s' is no result of the run%s; results are %s"):format(goal.from, goal.name,
        meant(goal.name, names), table.concat(names, ", ")))
    end
  end
end

--- The largest entry of a list, infinite if it has fewer than `rows`.
local function most_of(list, rows)
  local most = #list < rows and math.huge or 0
  for _, value in ipairs(list) do most = math.max(most, value) end
  return most
end

--- The terms of a run and their sum in units of the tolerance, each the largest of all goals; the order of the mesh.
local function needs_of(run, goals)
  local needs = { total = 0, mesh = 0, row = 0, penalty = 0, steps = 0, points = 0, order = 2 }
  for _, goal in ipairs(goals) do
    local column = run.errors.columns[goal.name]
    local unit = goal.share * column.size
    local function note(key, list)
      if list and unit > 0 then needs[key] = math.max(needs[key], most_of(list, run.rows) / unit) end
    end
    note("total", column.total or {})
    note("mesh", column.mesh.bars)
    for key in pairs(powers) do note(key, column[key]) end
    needs.row = math.max(needs.row, column.row or 0)
    needs.order = math.min(needs.order, column.mesh.order or 1)
  end
  return needs
end

-- ── Settings ─────────────────────────────────────────────────────────────────────────────────────────────────────────

local function key_of(settings)
  return ("%.12g %s %.12g %.12g %.12g"):format(settings.elements, settings.row, settings.penalty, settings.points,
    settings.steps)
end

--- The settings of the next level, of which each term should be within its share of the tolerance. `stiffness`: the
--- largest factor of the penalty on the given mesh.
local function next_settings(settings, needs, stiffness)
  local new, changed = lists.merged(settings), false
  for key, power in pairs(powers) do
    local factor = slack * (needs[key] / other_share) ^ (1 / power)
    if factor > slack ^ 2 and factor < math.huge then new[key], changed = settings[key] * factor, true end
  end
  local mesh = needs.mesh
  if mesh > mesh_share and needs.row > 1 / 2 and not settings.row then
    new.row, changed = true, true
    mesh = mesh * (1 - needs.row)
  end
  if mesh > mesh_share then
    local finer = math.min(most_finer, (mesh / mesh_share) ^ (1 / needs.order))
    new.elements, changed = settings.elements * (finer > nearly and most_finer or finer), true
  end
  if not changed then new.elements = settings.elements * most_finer end -- the sum of the terms is too large
  new.penalty = math.max(settings.penalty, math.min(new.penalty, stiffness * new.elements))
  if key_of(new) == key_of(settings) then new.elements = settings.elements * most_finer end
  return new
end

local function settings_text(settings)
  local texts = { ("elements × %.3g"):format(settings.elements), settings.row and "richer row" or nil }
  for _, key in ipairs { "penalty", "steps", "points" } do
    if settings[key] ~= 1 then texts[#texts + 1] = ("%s × %.3g"):format(key, settings[key]) end
  end
  return table.concat(texts, ", ")
end

-- ── Levels ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The companions of a level for its mesh, solved unless they have been, and those of the first level for the rest.
local function records_of(state, settings)
  local records, missing = { size = remade.size(state.scene.model) / settings.elements }, {}
  for name, factor in pairs { ["2h"] = 1 / 2, ["4h"] = 1 / 4 } do
    local other = lists.merged(settings, { elements = settings.elements * factor })
    records[name] = state.solved[key_of(other)]
    if not records[name] then missing[#missing + 1] = lists.merged(other, { name = name }) end
  end
  companions.solve_all(state.scene, missing, records, progress(#missing))
  for _, change in ipairs(missing) do state.solved[key_of(change)] = records[change.name] end
  local first = state.first
  for key in pairs(powers) do records[key] = first[key] end
  records.row = not settings.row and first.row or nil
  records.first, records.reference = first[first.reference], "first"
  records.factors = { penalty = 1 / settings.penalty, steps = 1 / settings.steps, points = 1 / settings.points ^ 2 }
  return records
end

--- Solves a level; returns its model, its run, and its stages.
local function solve(state, settings)
  local model, list, options, before = companions.made(state.scene, settings)
  local records = records_of(state, settings)
  options.states, options.companions = state.scene.options.states, records
  local run = require "signorini.run.run"(model, list, options)
  state.solved[key_of(settings)] = companions.record(model, run, list)
  return { model = model, run = run, list = list, options = options, before = before, settings = settings }
end

--- Work that does not depend on the machine: unknowns times iterations.
local function work_of(level) return #level.model:unknowns() * level.run.iterations end

--- Solves levels until the goals are reached, or until refuses(level, settings, times) says why the next level, with
--- these settings and about so many times the work, is not to be solved; returns the last one.
local function climb(state, goals, refuses, display)
  local settings, level = { elements = 1, row = false, penalty = 1, steps = 1, points = 1 }, nil
  state.first = companions.solve(state.scene, false)
  for name, factor in pairs { ["2h"] = 1 / 2, ["4h"] = 1 / 4 } do
    state.solved[key_of(lists.merged(settings, { elements = factor }))] = state.first[name]
  end
  for number = 1, most_levels do
    local last = level
    level = solve(state, settings)
    if number == 1 then check_names(goals, level.run.errors.names) end
    local needs = needs_of(level.run, goals)
    level.part, level.work = needs.total, work_of(level)
    state.levels[number] = { settings = settings_text(settings), part = level.part, wall = level.run.wall,
                             unknowns = #level.model:unknowns(), failed = level.run.failed and level.run.reason or nil }
    display:line(("level %d: %s: error %.3g of the tolerance, %.2f s"):format(number, settings_text(settings),
      level.part, level.run.wall))
    if level.run.failed then return last or level end
    if level.part <= 1 then return level end
    settings = next_settings(settings, needs, state.stiffness)
    level.missed = refuses(level, settings_text(settings), ((settings.elements / level.settings.elements)
      ^ state.directions) ^ growth * settings.steps / level.settings.steps)
    if level.missed then return level end
  end
  return level
end

--- The last level { model, run, part (error over tolerance), work, settings, missed (why there is no further one), … }
--- of a scene, and all as { settings, part, wall, unknowns, failed }; or nil, and the message of an error or of Ctrl-C.
function ladder.solve(model, list, options, goals, refuses, display)
  local scene, why = companions.scene(model, list, options)
  if not scene then
    return nil, ("%s: tolerance: %s, so that it cannot be solved on other meshes"):format(where, why)
  end
  if not options.measure then check_names(goals, Run.new(model, {}).names) end -- before anything is solved
  local _, directions = remade.size(model)
  local state = { scene = scene, solved = {}, levels = {}, directions = directions,
                  stiffness = stiffest / remade.stiffness(model) }
  core.mute_warnings(true)
  local done, level = pcall(climb, state, goals, refuses, display)
  core.mute_warnings(false)
  if not done and level == companions.interrupted then return nil, core.interruption() end
  if not done then error(level, 0) end
  return level, state.levels
end

--- What a level has chosen, for run.settings.
function ladder.settings(level, levels)
  return lists.merged(level.settings, { text = settings_text(level.settings), levels = levels,
                                        reached = level.part <= 1, missed = level.missed })
end

--- The run of the last level; `model` becomes its model.
function ladder.run(model, list, options)
  local goals, display, began, limit = ladder.goals(where, options.tolerance), progress(0), core.now(), options.limit
  local level, levels = ladder.solve(model, list, options, goals, function(last, settings, times)
    local beyond = limit and core.now() - began + times * last.run.wall - limit or 0
    return beyond > 0 and ("%s would take about %.2g s more than the limit of %g s allows"):format(settings, beyond,
      limit) or nil
  end, display)
  if not level then core.fail(levels) end
  local run = level.run
  core.replace(model, level.model)
  recipes.keep(model, recipes.of(level.model))
  history.note(model, level.before, level.list, level.options, run)
  rawset(run, "model", model)
  rawset(run, "settings", lists.merged(ladder.settings(level, levels), { goals = options.tolerance }))
  run_warnings.show(run, display)
  return run
end

--- Lines about the levels, for print(run).
function ladder.lines(run)
  local settings = run.settings
  if not settings then return {} end
  local text = ("%s: %s after %s: %s"):format(table.concat(settings.goals, ", "),
    settings.reached and "reached" or "not reached", counted(#settings.levels, "level"), settings.text)
  return { settings.missed and ("%s. %s"):format(text, settings.missed) or text }
end

return ladder
