-- What sg.optimize returns.

local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local ends = require "signorini.inverse.ends"
local goal = require "signorini.inverse.goal"
local lists = require "signorini.call.lists"
local named = require "signorini.call.named"
local shown = require "signorini.inverse.shown"

local Optimum = {}
Optimum.__index = Optimum
Optimum.__name = "optimum"
core.types.optimum = Optimum
named.strict_type(Optimum, "optimum", "")

-- Part of its size by which a limit may be exceeded before that is reported.
local exceeded = 1e-4

--- Sentences on limits that are exceeded.
local function exceeded_limits(search, point)
  local texts = {}
  for i, limit in ipairs(search.limits) do
    if goal.excess(point.results[i], limit) > exceeded then
      texts[#texts + 1] = ("%s = %.6g is not between %g and %g: no values that were tried reach that"):format(
        limit.name, point.results[i] * limit.size, limit.from * limit.size, limit.to * limit.size)
    end
  end
  return texts
end

--- Values, the result and the limits as a table.
local function content_of(self)
  local rows = lists.map(lists.sorted_names(self.at), function(name)
    return { name, self.at[name], lists.holds(self.at_bounds, name) and "at a bound" or "" }
  end)
  rows[#rows + 1] = { self.least, self.value, "least" }
  for _, limit in ipairs(self.limits) do
    rows[#rows + 1] = { limit.name, limit.value, ("%g to %g%s"):format(limit.from, limit.to,
      not limit.multiplier and ", exceeded" or limit.multiplier ~= 0 and ", active" or "") }
  end
  return { columns = { "quantity", "value", "" }, rows = rows }
end

local function summary(self) return ("%s, from %.6g at the start"):format(counted(#self.tries, "run"), self.began) end

function Optimum:__tostring() return shown.text(content_of(self), summary(self), self.warnings) end

--- The page of the run, which begins with the table of the optimum.
function Optimum:report(options)
  shown.report("optimum:report", self.run, lists.merged(options, { title = options.title or "Optimum" }), "Optimum",
    content_of(self), summary(self), self.warnings)
end

require("signorini.call.methods").guard("optimum", "report")

return function(search, point, reason, tries)
  local at_bounds = {}
  for j, one in ipairs(search.free) do
    if point.z[j] <= one.low or point.z[j] >= one.high then at_bounds[#at_bounds + 1] = one.name end
  end
  --- The multiplier of a limit that is reached, 0 of one that is not, nil of one that is exceeded.
  local function multiplier_of(i, limit)
    local excess = goal.excess(point.results[i], limit)
    if excess > exceeded then return nil end
    return excess > -exceeded and limit.multiplier * search.size / limit.size or 0
  end
  local texts = exceeded_limits(search, point)
  if reason == "converged" and #texts > 0 then reason = "infeasible" end
  return setmetatable({
    at = point.values, least = type(search.least) == "string" and search.least or "least", value = point.raw,
    began = search.began, run = point.found.run, gradients = point.found, tries = tries, reason = reason,
    at_bounds = at_bounds,
    warnings = lists.joined({ ends.text(search, reason, tries) }, texts, point.found.warnings,
      point.found.run.warnings),
    limits = lists.map(search.limits, function(limit, i)
      return { name = limit.name, value = point.results[i] * limit.size, from = limit.from * limit.size,
               to = limit.to * limit.size, multiplier = multiplier_of(i, limit) }
    end),
  }, Optimum)
end
