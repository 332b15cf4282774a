-- What a run may be wrong in although it completed: what sg.model said of the scene, loads that are not ramped,
-- tolerances that leave no accuracy, contacts of which no point was ever active (the wrong face, or a body that misses
-- the other), contacts that are penetrated too deeply, points that have gone through the master in one step, points
-- whose projection was given up, and what path_controls.lua, jumps.lua and energy_balance.lua find.

local counted = require "signorini.counted"
local energy_balance = require "signorini.energy_balance"
local drives = require "signorini.drives"
local jumps = require "signorini.jumps"
local lists = require "signorini.lists"
local path_controls = require "signorini.path_controls"

local run_warnings = {}

--- Whether something was transmitted at some row of the run, or is now, between two rows, where a step has failed:
--- under adhesion a force, wherever the bodies are.
local function ever_acts(run, model, contact)
  local now = model:contact_resultant(contact)
  return lists.any({ "area", "fx", "fy", "fz" }, function(key)
    local values = run.values[contact .. "." .. key] or {}
    return (now[key] or 0) ~= 0 or lists.any(values, function(value) return value ~= 0 end)
  end)
end

--- A sentence for each contact of the model that never touched in the rows of a run, with the least gap at its end.
local function untouched(run, model, contact)
  if ever_acts(run, model, contact) then return nil end
  local least = math.huge
  for _, gap in ipairs(model:profile(contact).gap) do
    if gap < least then least = gap end -- not so where the master is not opposite: there it is nan
  end
  return ("contact '%s' never touched; least gap %s"):format(contact,
    least < math.huge and ("%.4g"):format(least) or "unknown: the master is opposite to no point")
end

--- The largest extent, along an axis, of the smallest body.
local function smallest_size(model)
  local function size(name)
    return math.max(table.unpack(lists.map(lists.ranges(model:body(name):points()), function(range)
      return range[2] - range[1]
    end)))
  end
  local name = lists.least(model:body_names(), size)
  return name and size(name) or math.huge, name
end

-- Where points sink in by more than this part of the smallest body the penalty is no longer a detail of the method.
local deep = 0.02

--- A sentence for a contact that was penetrated deeply at some row of a run.
local function penetrated(run, model, contact)
  local most, at = 0, nil
  for row, depth in ipairs(run.values[contact .. ".max_penetration"] or {}) do
    if depth > most then most, at = depth, row end
  end
  local size, body = smallest_size(model)
  if most <= deep * size then return nil end
  return ("contact '%s' is penetrated by %.3g in step %s, %.2g %% of the size of body '%s': a higher penalty "
    .. "lets less in"):format(contact, most, run.values.step[at], 100 * most / size, body)
end

local loose_tolerance = 1e-3 -- of the forces of the run

local told = setmetatable({}, { __mode = "k" }) -- models whose loads were spoken of

--- A sentence, once for each model, for loads that it carries from the first step on because no stage changes them.
local function constant_loads(model, path)
  if told[model] then return nil end
  told[model] = true
  local names = lists.map(drives.constant_loads(model, path), function(load) return ("'%s'"):format(load) end)
  if #names == 0 then return nil end
  return ("no stage changes the load%s %s, which act%s in full from the first step on. Hint: to apply a load in steps, "
    .. "give its value to a stage and 0 to sg.model"):format(#names == 1 and "" or "s", table.concat(names, ", "),
    #names == 1 and "s" or "")
end

--- What can be said of a path before it is taken, in sentences.
function run_warnings.of_path(model, path, solver)
  local texts = { constant_loads(model, path) }
  if solver.tolerance > loose_tolerance then
    texts[#texts + 1] = ("newton.tolerance = %g: steps count as converged with unbalanced forces of this part of the "
      .. "run's forces, expected at most %g. Hint: the default is 1e-10"):format(solver.tolerance, loose_tolerance)
  end
  return texts
end

--- "1, 2"
local function position(point)
  return table.concat(lists.map(point, function(x) return ("%.4g"):format(x) end), ", ")
end

--- A sentence for a contact some of whose points were taken where a search had to give up.
local function unsettled(run, contact)
  local found = run.unsettled[contact]
  if not found then return nil end
  return ("contact '%s': the search for a closest point or slip point ended at a limit of iterations %s in accepted "
    .. "states, the last time at X = (%s): gap and friction are approximate there. Hint: refine or rebuild the master "
    .. "where its parametrization is singular or very uneven; otherwise take shorter steps"):format(contact,
      counted(found.count, "time"), position(found.at))
end

--- A sentence for a contact whose slave points have gone through the master in one step, which no contact saw.
local function crossed(run, contact)
  local found = run.crossed[contact]
  if not found then return nil end
  return ("contact '%s': in step %s points of the slave face passed through the master, the last of %s at X = "
    .. "(%s): the bodies moved farther in one increment than they are thick, and contact saw nothing of it. Hint: take "
    .. "shorter steps, of less than half of the thinner body's thickness each"):format(contact, found.step,
      counted(found.count, "point"), position(found.at))
end

--- What a run warns of, in sentences; those of model:warnings() and about the path come first.
function run_warnings.of_run(run, model, early)
  local texts = lists.joined(model:warnings(), early)
  for _, contact in ipairs(run.rows > 0 and model:contact_names() or {}) do
    texts[#texts + 1] = crossed(run, contact) or untouched(run, model, contact) or penetrated(run, model, contact)
    texts[#texts + 1] = unsettled(run, contact)
  end
  texts[#texts + 1] = path_controls.warning(run)
  texts[#texts + 1] = jumps.warning(run.jumps, run.used.arcs)
  texts[#texts + 1] = energy_balance.warning(run, run.energies)
  return texts
end

return run_warnings
