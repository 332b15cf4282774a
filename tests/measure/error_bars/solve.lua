-- Solves a scene with error bars, and again much more accurately.

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local remade = require "signorini.errors.remade"
local scenes = require "error_bars.scenes"

local function is_compared(name)
  return name:find "^grip%.[fm][xyz]?$" or name == "c.max_pressure" or name == "c.area"
end

local function compared(values)
  local chosen = {}
  for name, column in pairs(values) do
    if is_compared(name) then chosen[name] = { table.unpack(column) } end
  end
  return chosen
end

--- The results of a scene with `factor` times the elements per direction at the end of each of `list`'s steps, with ten
--- times the penalties, in the plane a richer row and twice the points, and with friction, whose history depends on
--- them, more steps.
local function accurate(model, list, what, factor)
  local plane, friction = what.kind ~= "solid", what.friction
  local finer = remade.model(model, { elements = factor, row = plane, penalty = 10, points = plane and 2 or 1 })
  local times = friction and factor or 1
  local path = lists.map(list, function(stage) return lists.merged(stage, { steps = times * stage.steps }) end)
  local run = finer:run(path, { states = {} })
  local values = {}
  for name, column in pairs(compared(run.values)) do
    values[name] = {}
    for i = 1, run.rows // times do values[name][i] = column[times * i] end
  end
  return values, run.failure
end

--- Solves the scene of a seed; returns plain data for compare.lua. `levels`: of refinement of the accurate solution in
--- the plane, solids have one less.
return function(seed, levels)
  local model, list, what = scenes.make(seed)
  local factor = 2 ^ (what.kind == "solid" and levels - 1 or levels) // 1 | 0
  local began = core.now()
  local run = model:run(list, { errors = true, states = {} })
  local records = {}
  for key, record in pairs(run.companions) do
    records[key] = type(record) == "table" and lists.merged(record, { values = compared(record.values) }) or record
  end
  local row = lists.merged(what, { values = compared(run.values), records = records, failure = run.failure,
    counts = lists.map(list, function(stage) return stage.steps end), tolerance = run.used.tolerance,
    edge = core.is_peak_at_edge(model, "c"), wall = core.now() - began })
  row.truth, row.truth_failure = accurate(scenes.make(seed), list, what, factor)
  row.truth_wall = core.now() - began - row.wall
  return row
end
