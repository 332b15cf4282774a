-- sg.cheapest: the cheapest case of a study that meets a tolerance.

local lists = require "signorini.call.lists"
local outcomes = require "signorini.study.outcomes"
local quantity = require "signorini.study.quantity"

local where = "sg.cheapest"

local function sort(cases, first, second)
  table.sort(cases, function(a, b)
    if a[first] ~= b[first] then return a[first] < b[first] end
    if a[second] ~= b[second] then return a[second] < b[second] end
    return a.place < b.place
  end)
end

return function(study, options)
  local error = quantity.read(where, "error", study, options.error)
  local cost = quantity.read(where, "cost", study, options.cost)
  local cases, left_out = quantity.points(study, { error, cost }, options.where)
  for _, case in ipairs(cases) do case.error = math.abs(case.error) end

  --- The row of a case; it prints with its error and cost, and how uncertain the reference of the error is.
  local function show(case)
    local text = case and table.concat(lists.joined({ ("%s: %s, %s"):format(quantity.case(study, case.row),
      quantity.stated(error, case.error), quantity.stated(cost, case.cost)) }, { quantity.doubt(error) }), ". ")
    return case and setmetatable(lists.merged(case.row),
      { __tostring = function() return text end, __name = "case of a study" })
  end

  -- The error itself is known up to the uncertainty of its reference.
  local good = lists.filter(cases, function(case)
    return case.error + (error.uncertain or 0) <= options.at_most
  end)
  sort(good, "cost", "error")
  if good[1] then return show(good[1]), show(good[2]) end

  local why = outcomes.why_none(study)
  if why then return nil, ("no case has both %s and %s: %s"):format(error.name, cost.name, why) end
  sort(cases, "error", "cost")
  local without = #left_out > 0 and ("; left out: %d that failed or lack %s or %s"):format(#left_out, error.name,
    cost.name) or ""
  return nil, ("no case has %s of at most %g%s%s"):format(error.name, options.at_most,
    cases[1] and ("; the nearest is %s"):format(show(cases[1])) or "", without)
end
