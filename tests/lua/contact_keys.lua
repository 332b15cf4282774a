-- The keys of a contact for each method and enforcement, for tests that run all of them.

local lists = require "signorini.call.lists"

local contact_keys = {}

local all = {
  ["points"] = { penalty = 1 }, ["points per reference area"] = { penalty = 1, per = "reference" },
  ["mortar"] = { method = "mortar", penalty = 1 },
  ["reduced mortar"] = { method = "mortar", multipliers = "reduced", penalty = 1 },
  ["multipliers"] = { method = "mortar", enforcement = "multipliers", penalty = 1 },
  ["half passes"] = { method = "half_passes", penalty = 1 },
  ["mortar half passes"] = { method = "half_passes", multipliers = "equal", penalty = 1 },
}

--- The names, sorted; without half passes where an obstacle is the master.
function contact_keys.names(on_obstacle)
  return lists.filter(lists.sorted_names(all), function(name) return not (on_obstacle and name:find "half") end)
end

--- Whether penetrations remain.
function contact_keys.penetrates(name) return all[name].enforcement == nil end

--- Further keys with those of a name, whose penalties are `penalty`; with the coefficient of friction mu, if given.
function contact_keys.of(name, penalty, mu, further)
  return lists.merged(further or {}, all[name], { penalty = penalty, friction = mu and { mu = mu, penalty = penalty } })
end

return contact_keys
