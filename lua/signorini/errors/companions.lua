-- The companions of a run: the same path on the same scene with elements two and four times as large, and there with
-- half of the steps, half of the penalties, twice the points, and a richer row at the contact. Each is a process.

local check = require "signorini.call.check"
local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local lists = require "signorini.call.lists"
local progress = require "signorini.run.progress"
local remade = require "signorini.errors.remade"

local companions = {}

local where = "model:run"

-- ── Paths ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The steps of a stage times a factor, rounded up; half of a single step is two, which can be compared as well.
local function steps_of(steps, factor)
  if factor == 1 / 2 and steps == 1 then return 2 end
  return math.max(1, math.ceil(factor * steps))
end

--- The constants of contacts that a stage changes, with other penalties.
local function scaled_contacts(contacts, factor)
  local all = {}
  for name, values in pairs(contacts) do
    local friction = values.friction
    all[name] = lists.merged(values, { penalty = values.penalty and factor * values.penalty,
      friction = friction and lists.merged(friction, { penalty = friction.penalty and factor * friction.penalty }) })
  end
  return all
end

--- The stages of a companion.
local function changed_stages(list, change)
  return lists.map(list, function(stage)
    local contacts = change.penalty and stage.contacts and scaled_contacts(stage.contacts, change.penalty)
    local count = steps_of(stage.steps, change.steps or 1)
    return lists.merged(stage, { steps = count, growth = stage.growth and stage.growth ^ (stage.steps / count),
                                 contacts = contacts })
  end)
end

--- Options of a run that companions do not have: its files, its callbacks, and what they show.
local own = { "errors", "tolerance", "limit", "checkpoint", "resume", "hdf5", "on_step", "on_iteration", "threads" }

local function changed_options(options, change)
  local all = lists.merged(options, { states = {}, verbose = false })
  for _, key in ipairs(own) do all[key] = nil end
  if all.penalty then
    all.penalty = lists.merged(all.penalty, { steps = steps_of(all.penalty.steps, change.steps or 1) })
  end
  return all
end

-- ── One version of a scene ───────────────────────────────────────────────────────────────────────────────────────────

--- What is needed to solve other versions of a scene from its start: { model, list, options, before (earlier runs),
--- make (a function of the user for other meshes, or nil) }; or nil, and why it cannot be made again. The model has not
--- begun the path.
function companions.scene(model, list, options, before)
  local wanted = type(options.errors) == "table" and options.errors or {}
  if core.ranks > 0 then
    core.fail(where .. ": errors: companions run in forked processes, which MPI does not support. Hint: run without "
      .. "mpirun, or without errors")
  end
  local missing = remade.obstacle(model) or not before
    and "the model's state was not reached by completed runs of this script alone, or its contacts were changed"
  if missing then return nil, missing end
  return { model = model, list = list, options = options, before = before, make = wanted.scene }
end

--- What the user's function returns for other elements: the model, its stages, and its options, if any.
local function scene_of_user(scene, elements)
  local done, model, list, options = pcall(scene.make, { mesh = elements })
  if not done then error({ text = tostring(model) }, 0) end
  if core.kind(model) ~= "model" then
    error({ text = ("%s: errors.scene must return a model and its stages, got %s"):format(where,
      core.describe(model)) }, 0)
  end
  local read
  done, list, read = pcall(check.call, where, model, list, options)
  if not done then error({ text = tostring(list) }, 0) end
  for i, stage in ipairs(scene.list) do
    if not list[i] or #list ~= #scene.list or list[i].steps ~= stage.steps then
      error({ text = where .. ": errors.scene must return stages with the steps of the run, which bars compare" }, 0)
    end
  end
  return model, list, options and read or scene.options
end

--- Makes a scene with changes, see remade.model; `steps`: a factor on the steps of all stages. Returns the model in the
--- state before the path, its stages, its options, and the runs before.
function companions.made(scene, change)
  local run = require "signorini.run.run"
  local model, list, options, rest = scene.model, scene.list, scene.options, change
  if scene.make and change.elements then
    model, list, options = scene_of_user(scene, change.elements)
    rest = lists.merged(change)
    rest.elements = nil
  end
  model = remade.model(model, rest)
  local before = lists.map(scene.before, function(earlier)
    return { changed_stages(earlier[1], change), changed_options(earlier[2], change) }
  end)
  local quiet = core.quiet
  core.quiet = true
  for _, earlier in ipairs(before) do run(model, earlier[1], earlier[2]) end
  core.quiet = quiet
  return model, changed_stages(list, change), changed_options(options, change), before
end

--- What companions keep of a run: values by column, rows, steps of the stages, size of the elements, failure.
function companions.record(model, run, list)
  return { rows = run.rows, values = run.values, failure = run.failure, reason = run.reason,
           size = remade.size(model), counts = lists.map(list, function(stage) return stage.steps end) }
end

--- The record of a version of a scene; { error = text } for an error of the user's function.
local function solve(scene, change)
  core.mute_warnings(true)
  local done, model, list, options = pcall(companions.made, scene, change)
  if not done and type(model) == "table" then return { error = model.text } end
  if not done then error(model, 0) end
  return companions.record(model, require "signorini.run.run"(model, list, options), list)
end

-- ── Companions ───────────────────────────────────────────────────────────────────────────────────────────────────────

-- The error of companions that Ctrl-C has ended.
companions.interrupted = {}

--- Solves versions of a scene in processes, changes with names, and adds their records by name. After Ctrl-C the error
--- is companions.interrupted.
function companions.solve_all(scene, changes, records)
  if #changes == 0 then return end
  local wrong, bar = nil, progress(#changes)
  local whole = core.jobs(#changes, core.at_once, function(k)
    return core.pack(solve(scene, changes[k]))
  end, function(k, text, failure)
    local name = changes[k].name
    records[name] = text and core.unpack(text)
      or { rows = 0, values = {}, failure = failure:gsub("^failed: ", ""):match "^[^\n]*", reason = "error" }
    wrong = wrong or records[name].error
    if wrong then return end
    bar:step(("companion '%s'"):format(name))
    bar:line(("companion '%s': %s%s"):format(name, counted(records[name].rows, "step"),
      records[name].failure and ", ended early: " .. records[name].reason or ""))
  end)
  bar:clear()
  if not whole then error(companions.interrupted, 0) end
  if wrong then error(wrong, 0) end
end

--- True if the results of a path depend on its steps: where contact rubs or bonds break, also in some stages only.
--- Elastic bodies and contact without friction have no memory.
local function has_history(scene)
  local stages = lists.joined(scene.list, table.unpack(lists.map(scene.before, function(before) return before[1] end)))
  return lists.any(scene.model:contact_names(), function(name)
    local law = scene.model:contact_law(name)
    return law.friction_penalty or law.strength or lists.any(stages, function(stage)
      return stage.contacts and stage.contacts[name] and stage.contacts[name].friction
    end)
  end)
end

--- The changes besides the mesh, each with `on`: the name of the companion from which alone it differs, and `given`:
--- its value of what differs. In the plane `on` is "2h", but for the row, of which only a share is wanted; else
--- `coarse`, "4h" unless that has failed.
local function other_changes(scene, on_mesh, with_row, coarse)
  local _, directions = remade.size(scene.model)
  local factors = { points = 2, penalty = 1 / 2, steps = 1 / 2 }
  local needed = { penalty = remade.has_penalty(scene.model), steps = has_history(scene),
                   row = with_row and not on_mesh(1).row }
  local names = lists.filter({ "penalty", "steps", "row", "points" }, function(name)
    return #scene.model:contact_names() > 0 and needed[name] ~= false
  end)
  return lists.map(names, function(name)
    local on = directions == 2 and name ~= "row" and "2h" or coarse
    local settings = on_mesh(on == "2h" and 1 / 2 or 1 / 4)
    local given = settings[name] or 1
    return lists.merged(settings, { name = name, on = on, given = given,
                                    [name] = name == "row" or factors[name] * given })
  end)
end

--- Adds what is missing to the records of the companions of a scene by name: "2h", "4h", "penalty", …; on_mesh(factor):
--- the settings of the scene with so many times the elements. only_mesh: no others than the first two; with_row: also
--- with a richer row. Records of the others have `on` and `given` of their changes, and `base`, that of `on`.
function companions.solve(scene, on_mesh, records, only_mesh, with_row)
  local function solve_missing(coarse)
    local changes = { lists.merged(on_mesh(1 / 2), { name = "2h" }), lists.merged(on_mesh(1 / 4), { name = "4h" }) }
    local others = only_mesh and {} or other_changes(scene, on_mesh, with_row, coarse)
    local missing = lists.filter(lists.joined(changes, others), function(change) return not records[change.name] end)
    companions.solve_all(scene, missing, records)
    for _, change in ipairs(others) do
      local record = records[change.name]
      record.base, record.on, record.given = records[change.on], change.on, change.given
    end
  end
  local known = records["4h"]
  solve_missing(known and known.failure and "2h" or "4h")
  if only_mesh or known or not records["4h"].failure then return end
  for name, record in pairs(lists.merged(records)) do
    if type(record) == "table" and record.on == "4h" then records[name] = nil end
  end
  solve_missing "2h"
end

--- The records of the companions of a run, or { missing = why there are none, in words }.
function companions.of_run(model, list, options, before)
  local scene, missing = companions.scene(model, list, options, before)
  if not scene then return { missing = missing } end
  local wanted = options.errors
  local only_mesh = wanted == "mesh" or type(wanted) == "table" and wanted.terms == "mesh"
  local size, directions = remade.size(model)
  local records = { size = size, single = remade.single(model, 1) }
  -- in solids a richer row takes longer than all others together
  local done, why = pcall(companions.solve, scene, function(factor) return { elements = factor } end, records,
    only_mesh, directions == 2)
  if not done and why == companions.interrupted then core.fail(core.interruption()) end
  if not done then error(why, 0) end
  return records
end

return companions
