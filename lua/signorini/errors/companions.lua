-- The companions of a run: the same path on the same scene with elements two and four times as large, and there with
-- half of the steps, half of the penalties, twice the points, and a richer row at the contact. Each is a process.

local check = require "signorini.call.check"
local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local history = require "signorini.errors.history"
local lists = require "signorini.call.lists"
local progress = require "signorini.run.progress"
local remade = require "signorini.errors.remade"

local companions = {}

local where = "model:run"

-- ── Paths ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The steps of a stage in the companion with other steps: half as many, of a single step two.
function companions.other_steps(steps) return steps > 1 and (steps + 1) // 2 or 2 end

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
    local steps = change.steps and companions.other_steps(stage.steps) or stage.steps
    local contacts = change.penalty and stage.contacts and scaled_contacts(stage.contacts, change.penalty)
    return lists.merged(stage, { steps = steps, contacts = contacts })
  end)
end

--- Options of a run that companions do not have: its files, its callbacks, and what they show.
local own = { "errors", "checkpoint", "resume", "hdf5", "on_step", "on_iteration", "threads" }

local function changed_options(options, change)
  local all = lists.merged(options, { states = {}, verbose = false })
  for _, key in ipairs(own) do all[key] = nil end
  if all.penalty and change.steps then
    all.penalty = lists.merged(all.penalty, { steps = companions.other_steps(all.penalty.steps) })
  end
  return all
end

-- ── One companion ────────────────────────────────────────────────────────────────────────────────────────────────────

--- Solves the path of a run for a changed scene; returns its record. `scene`: { model, list, options, before (earlier
--- runs), make (a function of the user for other meshes, or nil) }.
local function solve(scene, change)
  local run = require "signorini.run.run"
  local began, again = core.now(), { model = scene.model, list = scene.list, options = scene.options }
  local elements = 1 / change.level
  if scene.make then
    local model, list, options = scene.make { mesh = elements }
    if core.kind(model) ~= "model" then
      core.fail(("%s: errors.scene must return a model and its stages, got %s"):format(where, core.describe(model)))
    end
    again.model, elements = model, nil
    again.list, again.options = check.call(where, model, list, options)
  end
  local model = remade.model(again.model, lists.merged(change, { elements = elements }))
  for _, before in ipairs(scene.before) do
    run(model, changed_stages(before[1], change), changed_options(before[2], change))
  end
  local result = run(model, changed_stages(again.list, change), changed_options(again.options, change))
  return { rows = result.rows, values = result.values, failure = result.failure, size = remade.size(model),
           wall = core.now() - began,
           steps = lists.map(changed_stages(again.list, change), function(stage) return stage.steps end) }
end

-- ── All companions ───────────────────────────────────────────────────────────────────────────────────────────────────

--- The changes on the level of the companions that are not for the mesh alone.
local function changes_of(scene, level)
  local list = { { name = "points", level = level, points = 2 }, { name = "row", level = level, row = true },
                 { name = "penalty", level = level, penalty = 1 / 2 }, { name = "steps", level = level, steps = true } }
  local has_contact, has_penalty = #scene.model:contact_names() > 0, remade.has_penalty(scene.model)
  return lists.filter(list, function(change)
    return has_contact and (change.name ~= "penalty" or has_penalty) or change.name == "steps"
  end)
end

--- Solves companions in processes; adds their records by name.
local function solve_all(scene, changes, records, bar)
  local whole = core.jobs(#changes, core.at_once, function(k)
    return core.pack(solve(scene, changes[k]))
  end, function(k, text, failure)
    local change = changes[k]
    local record = text and core.unpack(text)
      or { rows = 0, values = {}, failure = failure:gsub("^failed: ", ""):match "^[^\n]*" }
    records[change.name] = lists.merged(record, { level = change.level })
    bar:step(("companion '%s'"):format(change.name))
    bar:line(("companion '%s': %s%s"):format(change.name, counted(record.rows, "step"),
      record.failure and ", failed: " .. record.failure or ""))
  end)
  if not whole then core.fail(core.interruption()) end
end

--- The records of the companions of a run by name, "2h", "4h", "points", …, or { missing = why there are none, in
--- words }. wanted: true, "mesh", or { terms, scene } as model:run has read it.
function companions.solve(model, list, options)
  local wanted = type(options.errors) == "table" and options.errors or {}
  local only_mesh = options.errors == "mesh" or wanted.terms == "mesh"
  local before = history.of(model)
  if core.ranks > 0 then
    core.fail(where .. ": errors: companions run in forked processes, which MPI does not support. Hint: run without "
      .. "mpirun, or without errors")
  end
  local missing = remade.obstacle(model) or not before
    and "the model's state was not reached by completed runs of this script alone"
  if missing then return { missing = missing } end
  local scene = { model = model, list = list, options = options, before = before, make = wanted.scene }
  local size, directions = remade.size(model)
  local records = { size = size }
  local bar = progress(only_mesh and 2 or 6)
  solve_all(scene, { { name = "2h", level = 2 }, { name = "4h", level = 4 } }, records, bar)
  if not only_mesh and records["2h"].rows > 0 then
    local level = directions == 3 and not records["4h"].failure and 4 or 2
    solve_all(scene, changes_of(scene, level), records, bar)
  end
  bar:clear()
  return records
end

return companions
