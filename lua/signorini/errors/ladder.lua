-- model:run(path, { tolerance = "1 % of grip.fx" }): the path is solved on finer meshes, with a richer row at the
-- contact, other penalties, steps and points, until the error bars of the goals are within the tolerance. Each level is
-- a companion of the next [theory 11.6].

local bars = require "signorini.errors.bars"
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
local without_warnings = require "signorini.call.without_warnings"

local ladder = {}

local where = "model:run"

-- Terms besides the mesh: share of the tolerance, more where smaller terms cost iterations or steps, and the power of
-- the factor by which they decrease.
local others = { penalty = { share = 1 / 4, power = 1 }, points = { share = 1 / 10, power = 2 },
                 steps = { share = 1 / 5, power = 1 } }
local whole = 0.9 -- of the tolerance for all terms; the mesh takes what the others leave
local settled = 0.4 -- of the tolerance: terms of meshes that need not be finer
local near = 2 -- of the tolerance: terms of meshes from which on the other terms count
local most_finer = 2 -- elements per direction of a level, in units of those of the level before, a companion then
local least_finer = 1.5 -- elements of a level, likewise
local stiffest = 10 -- penalty in units of the default one: stiffer ones over-constrain the contact of coarse meshes
local most_levels = 8
local growth = 1.3 -- exponent of the time over the number of elements
local most_smaller = 10 -- terms besides the mesh of a level, as their laws do not hold farther
local slack = 1.1 -- of a factor that is not worth a change

-- ── Goals ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The goals { share, name, from (the function named in errors) } of texts such as "1 % of grip.fx".
function ladder.goals(from, texts)
  return lists.map(texts, function(text, i)
    local percent, name = text:match "^%s*([%d.eE+-]+)%s*%%%s*of%s+(%S+)%s*$"
    local share = tonumber(percent)
    if not share or not (share > 0 and share <= 100) then
      core.fail(('%s: tolerance%s must be a text such as "1 %% of grip.fx", with more than 0 and at most 100 %%, '
        .. 'got %q'):format(from, #texts > 1 and ("[%d]"):format(i) or "", text))
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

local function check_forces(goals, run)
  for _, goal in ipairs(goals) do
    if not run.failed and not bars.is_telling(run, goal.name) then
      core.fail(("%s: tolerance: '%s' is zero but for rounding errors"):format(goal.from, goal.name))
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
    for key in pairs(others) do note(key, column[key]) end
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

--- The settings with `factor` times the elements. A penalty above the given one changes likewise, as the stiffest one
--- does that elements of this size bear: a coarser mesh with the same one would be over-constrained.
local function on_mesh(settings, factor)
  local penalty = settings.penalty > 1 and math.max(1, factor * settings.penalty) or settings.penalty
  return lists.merged(settings, { elements = factor * settings.elements, penalty = penalty })
end

--- The term of the mesh that a richer row would leave, if it removes most of it.
local function mesh_of(settings, needs)
  local richer = needs.row > 1 / 2 and not settings.row
  return needs.mesh * (richer and 1 - needs.row or 1), richer
end

--- True if the mesh may be nearly within the tolerance on the next level.
local function is_near(settings, needs) return mesh_of(settings, needs) <= near * most_finer ^ needs.order end

--- True if the other terms are to be reduced on the next level. They are larger on coarse meshes, so that they wait for
--- the mesh if they seem to be far from their shares; and with other constants the level before is no companion.
local function is_time(settings, needs)
  local most = 0
  for key, other in pairs(others) do most = math.max(most, needs[key] / other.share) end
  return needs.mesh <= settled or is_near(settings, needs) and most <= most_smaller
end

--- The settings of the next level, of which the terms should be within the tolerance. `stiffness`: the largest factor
--- of the penalty on the given mesh.
local function next_settings(settings, needs, stiffness)
  local new, room = lists.merged(settings), whole
  if is_time(settings, needs) then
    for key, other in pairs(others) do
      local factor = math.min(most_smaller, needs[key] / other.share) ^ (1 / other.power)
      if factor > slack and needs[key] < math.huge then new[key] = settings[key] * factor end
      room = room - math.min(needs[key], slack * other.share)
    end
    -- the given steps, and the ends of half as many, are among those of all levels
    if new.steps > settings.steps then new.steps = 2 * math.ceil(new.steps / 2) end
  end
  local mesh, richer = mesh_of(settings, needs)
  if needs.mesh > room then new.row = settings.row or richer end
  local unchanged = key_of(new) == key_of(settings)
  if mesh > room or unchanged then
    local finer = math.min(most_finer, math.max(least_finer, (mesh / room) ^ (1 / needs.order)))
    new = unchanged and on_mesh(new, most_finer) or lists.merged(new, { elements = finer * new.elements })
  end
  new.penalty = math.max(settings.penalty, math.min(new.penalty, stiffness * new.elements))
  return key_of(new) ~= key_of(settings) and new or on_mesh(settings, most_finer)
end

local function settings_text(settings)
  local texts = { ("elements × %.3g"):format(settings.elements), settings.row and "richer row" or nil }
  for _, key in ipairs { "penalty", "steps", "points" } do
    if settings[key] ~= 1 then texts[#texts + 1] = ("%s × %.3g"):format(key, settings[key]) end
  end
  return table.concat(texts, ", ")
end

-- ── Levels ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The companions of a level, those for its mesh unless they have been solved.
local function solved_records(state, settings, with_others)
  local model, solved = state.scene.model, state.solved
  local fine, coarse = key_of(on_mesh(settings, 1 / 2)), key_of(on_mesh(settings, 1 / 4))
  local records = { size = remade.size(model) / settings.elements, single = remade.single(model, settings.elements),
                    ["2h"] = solved[fine], ["4h"] = solved[coarse] }
  companions.solve(state.scene, function(factor) return on_mesh(settings, factor) end, records, not with_others, true)
  solved[fine], solved[coarse] = records["2h"], records["4h"]
  return records
end

--- The companions of a level for its mesh, and for the rest those of the level for which they were solved last.
local function records_of(state, settings)
  local records, last = solved_records(state, settings, false), state.others
  records.row, records.factors = not settings.row and last.row or nil, {}
  for key, other in pairs(others) do
    records[key] = last[key]
    records.factors[key] = last[key] and (last[key].given / settings[key]) ^ other.power
  end
  return records
end

--- Solves a level; returns its model, its run, and its stages.
local function solve(state, settings)
  local model, list, options, before = companions.made(state.scene, settings)
  options.states, options.companions = state.scene.options.states, records_of(state, settings)
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
  local measured_on = 1 -- elements of the level for which the terms besides the mesh were measured
  state.others = solved_records(state, settings, true)
  for number = 1, most_levels do
    local last = level
    level = solve(state, settings)
    if number == 1 then check_names(goals, level.run.errors.names) end
    local needs = needs_of(level.run, goals)
    if needs.total > 1 and is_near(settings, needs) and measured_on < settings.elements then
      measured_on = settings.elements
      state.others = solved_records(state, settings, true) -- coarser meshes have larger terms of penalty and points
      level.run.companions = records_of(state, settings)
      bars.attach(level.run, level.model)
      needs = needs_of(level.run, goals)
    end
    if number == 1 then check_forces(goals, level.run) end
    -- the error of a body with one element in a direction is unknown
    level.part, level.work = level.run.companions.single and math.max(needs.total, slack) or needs.total, work_of(level)
    if level.run.failed then level.part, level.missed = math.huge, "the path ended early: " .. level.run.reason end
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
  local scene, why = companions.scene(model, list, options, history.of(model))
  if not scene then
    return nil, ("%s: tolerance: %s, so that it cannot be solved on other meshes"):format(where, why)
  end
  if not options.measure then check_names(goals, bars.result_names(Run.new(model, {}), model)) end
  local _, directions = remade.size(model)
  local state = { scene = scene, solved = {}, levels = {}, directions = directions,
                  stiffness = stiffest / remade.stiffness(model) }
  local done, level = pcall(without_warnings, climb, state, goals, refuses, display)
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
  if options.threads then core.set_threads(options.threads) end
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
