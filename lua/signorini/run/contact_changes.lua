-- What a stage changes in the contacts: constants from its first step on, offsets linearly over its steps, and the
-- overlap that interference fits still allow, which the first stage in which they are active closes.

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local rows = require("signorini.pages.contact_rows").change
local t = require "signorini.call.types"

local contact_changes = {}

--- The row of a stage of this model: constants by contact. Two half passes change together, by the name of the first.
function contact_changes.row(model)
  local names = lists.filter(model:contact_names(), function(name)
    return not (name:find "%.master$" and model:contact_law(name).method == "half_passes")
  end)
  local changed = t.named(rows)
  local contacts = lists.map(names, function(name) return { name, changed, optional = true } end)
  contacts.conflict = rows.conflict
  return { "contacts", t.named(contacts), optional = true }
end

--- Raises an error if a contact cannot have its constants.
function contact_changes.check(model, where, label, contacts, options)
  for _, name in ipairs(lists.sorted_names(contacts)) do
    local problem = core.contact_problem(model, name, contacts[name])
    if problem then core.fail(("%s: %s: %s"):format(where, label, problem)) end
    if options.arc_length and contacts[name].offset then
      core.fail(("%s: %s: contacts.%s.offset changes over the stage, which arc_length cannot follow. Hint: remove "
        .. "arc_length, or the offset"):format(where, label, name))
    end
  end
end

--- Sentences on coefficients of friction that look like angles, and on large offsets.
function contact_changes.warnings(model, path)
  local texts = {}
  for _, stage in ipairs(path) do
    for _, name in ipairs(lists.sorted_names(stage.contacts)) do
      local goal = stage.contacts[name]
      local mu = goal.friction and goal.friction.mu
      for _, text in ipairs(core.contact_warnings(model, name, mu or 0, goal.offset or 0)) do
        texts[#texts + 1] = ("stage '%s': %s"):format(stage.name, text)
      end
    end
  end
  return texts
end

--- The table by which a stage changes a contact; two half passes have that of the first.
local function goal_of(model, stage, name)
  local goal = stage.contacts[name]
  if not goal and model:contact_law(name).method == "half_passes" then
    goal = stage.contacts[name:gsub("%.master$", "")]
  end
  return goal or {}
end

--- The interference fits that a stage closes: { name, what is left of the overlap }.
local function open_fits(model, stage)
  local fits = {}
  for _, name in ipairs(model:contact_names()) do
    local law, active = model:contact_law(name), goal_of(model, stage, name).active
    if active == nil then active = law.active end
    if active and (law.overlap or 0) > 0 then fits[#fits + 1] = { name, law.overlap } end
  end
  return fits
end

--- Raises an error if a stage of the path closes an interference fit, which arc length cannot do.
function contact_changes.check_fits(model, where, path, options)
  for _, stage in ipairs(options.arc_length and path or {}) do
    for _, fit in ipairs(open_fits(model, stage)) do
      core.fail(('%s: contacts.%s has overlap = "interference", which the first stage closes in which it is active, '
        .. "and arc_length cannot follow that. Hint: close it by a run without arc_length, then continue with a "
        .. "further run"):format(where, fit[1]))
    end
  end
end

--- Where a stage begins: { offset, overlap } of the contacts in which it changes them.
function contact_changes.starts(model, stage)
  local starts = {}
  for name, values in pairs(stage.contacts) do
    starts[name] = { offset = values.offset and model:contact_law(name).offset }
  end
  for _, fit in ipairs(open_fits(model, stage)) do
    local name, overlap = table.unpack(fit)
    starts[name] = starts[name] or {}
    starts[name].overlap = overlap
  end
  return starts
end

--- The contacts that a stage switches on, and how deep their faces overlap before it moves anything.
function contact_changes.switched_on(model, stage)
  local names = lists.filter(lists.sorted_names(stage.contacts), function(name)
    return stage.contacts[name].active and not model:contact_law(name).active
  end)
  if #names == 0 then return {} end
  for _, name in ipairs(names) do model:set_contact(name, { active = true }) end
  local still = lists.map(model:residual(), function() return 0 end)
  model:move(still) -- evaluates the contacts where the bodies are
  local found = lists.map(names, function(name)
    local depth = 0
    for _, gap in ipairs(model:profile(name).gap) do
      if gap and gap < -depth then depth = -gap end
    end
    return { name = name, depth = depth }
  end)
  model:rollback()
  return found
end

--- True if a stage begins with a change that releases or adds energy: of the contact's springs, or of bodies that
--- friction no longer holds.
function contact_changes.is_sudden(model, stage)
  return lists.any(lists.sorted_names(stage.contacts), function(name)
    local goal, now = stage.contacts[name], model:contact_law(name)
    local friction = goal.friction or {}
    local function differs(value, present) return value ~= nil and value ~= present end
    return differs(goal.active, now.active) or differs(goal.penalty, now.penalty)
      or differs(friction.penalty, now.friction_penalty) or friction.mu ~= nil and friction.mu < now.mu
  end)
end

--- True if an offset of sg.model presses bodies that no step has moved yet: the path does no work for it.
function contact_changes.presses_at_once(model)
  return model:energy().work == 0 and lists.any(model:contact_names(), function(name)
    local law = model:contact_law(name)
    return law.active and (law.offset or 0) > 0
  end)
end

local function between(start, goal, part) return part == 1 and goal or start + (goal - start) * part end

--- Sets the constants at the fraction `part` of a stage.
function contact_changes.set(model, stage, part)
  for name, start in pairs(stage.fits) do
    local goal = stage.contacts[name] or {}
    model:set_contact(name, {
      active = goal.active, penalty = goal.penalty, friction = goal.friction,
      offset = start.offset and between(start.offset, goal.offset, part),
      overlap = start.overlap and between(start.overlap, 0, part),
    })
  end
end

--- The contacts whose offset or overlap changes over a stage, sorted.
local function ramps(stage)
  return lists.filter(lists.sorted_names(stage.fits), function(name)
    local start = stage.fits[name]
    return start.overlap or start.offset and start.offset ~= stage.contacts[name].offset
  end)
end

--- True if a stage changes an offset or an overlap.
function contact_changes.ramps(stage) return #ramps(stage) > 0 end

--- The offsets at a fraction of the stage, in words: "seat.offset = 0.01".
function contact_changes.places(stage, part)
  return lists.map(ramps(stage), function(name)
    local start = stage.fits[name]
    if start.overlap then return ("%s.overlap = %.6g"):format(name, between(start.overlap, 0, part)) end
    return ("%s.offset = %.6g"):format(name, between(start.offset, stage.contacts[name].offset, part))
  end)
end

return contact_changes
