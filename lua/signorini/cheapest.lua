-- sg.cheapest: the cheapest case of a study that meets a tolerance.

local core = require "signorini.core"
local arguments = require "signorini.arguments"
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

core.docs["sg.cheapest"] = [[
sg.cheapest(study, { error, at_most, cost = "wall", where })
The cheapest row of a study whose error is at most so large, and the runner-up; nil and a text about the nearest case
when there is none. error and cost: columns, or functions of a row; errors count by their size. where: a function of a
row: only rows for which it is true. Rows that failed, or lack error or cost, do not count.
Example: best, next_best = sg.cheapest(study, { error = "error", at_most = 0.1 })]]
return function(study, options)
  quantity.study(where, study)
  arguments.table(where, "its second argument", options, { "error", "at_most", "cost", "where" })
  options = options or {}
  local read = { error = quantity.read(where, "error", study, options.error),
                 cost = quantity.read(where, "cost", study, options.cost, "wall"),
                 keep = arguments.callback(where, "where", options.where) }
  if options.at_most == nil then arguments.reject(where, "at_most", "the largest error that is good enough") end
  local at_most = arguments.positive(where, "at_most", options.at_most)
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
