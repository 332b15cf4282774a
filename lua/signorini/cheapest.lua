-- sg.cheapest: the cheapest case of a study that meets a tolerance.

local outcomes = require "signorini.study.outcomes"
local quantity = require "signorini.study.quantity"

local where = "sg.cheapest"

--- A row that prints as its case with error and cost.
local function shown(row, error, cost, read)
  local text = ("%s: %s, %s"):format(quantity.case(read.error.study, row), quantity.stated(read.error, error),
    quantity.stated(read.cost, cost))
  local copy = {}
  for key, value in pairs(row) do copy[key] = value end
  return setmetatable(copy, { __tostring = function() return text end, __name = "case of a study" })
end

--- Cases that have error and cost, and how many have not.
local function read_cases(study, read)
  local cases, left_out = {}, 0
  for i, row in ipairs(study.rows) do
    if not read.keep or read.keep(row) then
      local size, cost
      if not row.failed then size, cost = quantity.number(read.error, row), quantity.number(read.cost, row) end
      if size and cost then
        cases[#cases + 1] = { row = row, size = math.abs(size), cost = cost, place = i }
      else
        left_out = left_out + 1
      end
    end
  end
  return cases, left_out
end

--- In the order of one of their numbers, then of the other one, then of the study.
local function sort(cases, first, second)
  table.sort(cases, function(a, b)
    if a[first] ~= b[first] then return a[first] < b[first] end
    if a[second] ~= b[second] then return a[second] < b[second] end
    return a.place < b.place
  end)
end

return function(study, options)
  local read = { error = quantity.read(where, "error", study, options.error),
                 cost = quantity.read(where, "cost", study, options.cost), keep = options.where }
  local at_most = options.at_most
  local cases, left_out = read_cases(study, read)

  local good = {}
  for _, case in ipairs(cases) do
    if case.size <= at_most then good[#good + 1] = case end
  end
  sort(good, "cost", "size")
  local function show(case) return case and shown(case.row, case.size, case.cost, read) end
  if good[1] then return show(good[1]), show(good[2]) end

  local why = outcomes.why_none(study)
  if why then return nil, ("no case has both %s and %s: %s"):format(read.error.name, read.cost.name, why) end
  sort(cases, "size", "cost")
  local without = left_out > 0 and ("; left out: %d that failed or lack %s or %s"):format(left_out, read.error.name,
    read.cost.name) or ""
  return nil, ("no case has %s of at most %g%s%s"):format(read.error.name, at_most,
    cases[1] and ("; the nearest is %s"):format(show(cases[1])) or "", without)
end
