-- Methods that read a study: selection, computation, output, and messages if no case has a result.

require "check"

--- A study in a folder of its own, whose cases count by their parameters alone.
local function new(cases, run, units)
  return sg.study{ name = "noted", folder = check.file(), cases = cases, inputs = {}, run = run, units = units }
end

check.case("if no case has a result, the message about a missing result gives the reason", function()
  local function study(run) return new(sg.grid{ a = { 1, 2 } }, run) end
  local failed = study(function() return { failed = true, reason = "penalty = -5" } end):execute{}
  local grid = new(sg.grid{ a = { 1 }, b = { 2 } }, function() return { failed = true } end):execute{}
  local why = ": no case has 'error': 2 of 2 failed: penalty = -5"
  for name, ask in pairs {
    ["study:chart"] = function() failed:chart{ x = "a", y = "error", file = "no.png" } end,
    ["study:heatmap"] = function() grid:heatmap{ x = "a", y = "b", value = "error", file = "no.png" } end,
    ["study:table"] = function() failed:table{ columns = { "a", "error" } } end,
    ["study:column"] = function() failed:column "error" end,
    ["study:where"] = function() failed:where{ error = 1 } end,
    ["sg.work_precision"] = function() sg.work_precision(failed, { error = "error" }) end,
    ["sg.cheapest"] = function() sg.cheapest(failed, { error = "error", at_most = 1 }) end,
  } do
    check.fails(ask, "study_methods_test.lua",
      name == "study:heatmap" and name .. ": no case has 'error': 1 of 1 failed" or name .. why)
  end
  check.fails(function() failed:chart{ x = "a", y = "wall", file = "no.png" } end,
    "study:chart: no case has both a and wall; no.png cannot be drawn: 2 of 2 failed: penalty = -5")
  check.equal(select(2, sg.cheapest(failed, { error = "a", at_most = 1 })),
    "no case has both a and wall: 2 of 2 failed: penalty = -5")
  local mixed = study(function(case) return case.a == 1 and error "no luck" or { failed = true } end):execute{}
  check.fails(function() mixed:column "error" end, "1 failed, 1 ended by an error; the first one ended by an error: ",
    "no luck")
  local fresh = study(function() return { error = 1 } end)
  check.fails(function() fresh:column "error" end,
    "no case has 'error': none of its cases is done yet; execute the study")
  check.fails(function() fresh:execute{}:column "errors" end, "did you mean 'error'?")
end)

local function sample()
  return new(sg.grid({ order = { "N2", "N4" } }, { mesh = { 1, 2 }, round = { 1, 2, 3 } }), function(case)
    local missing = case.order == "N4" and case.mesh == 2 and case.round == 1
    return { cost = case.mesh * 10 + (case.round == 2 and 100 or case.round), name = case.order,
             error = not missing and case.round / case.mesh or nil }
  end, { cost = "s" }):execute{}
end

check.case("where, row, by, with, column and median", function()
  local study = sample()
  check.equal(#study, 12)
  check.equal(#study:where{ order = "N2" }, 6)
  check.equal(#study:where{ order = { "N2", "N4" }, mesh = 2 }, 6)
  check.equal(#study:where(function(row) return row.round > 1 end), 8)
  check.equal(study:where{ mesh = 1, order = "N2" }:column "cost", { 11, 110, 13 })
  local names, sizes = {}, {}
  for order, part in study:by "order" do names[#names + 1], sizes[#sizes + 1] = order, #part end
  check.equal({ names, sizes }, { { "N2", "N4" }, { 6, 6 } })
  local calm = study:median "round"
  check.equal(calm:column "cost", { 13, 23, 13, 23 })
  check.equal(calm:column "error", { 2, 1, 2, 1.25 }) -- N4 on mesh 2: of the two rounds that have one
  check.equal(calm.parameters, { "order", "mesh" })
  check.equal(calm:where{ mesh = { 2 } }:column "name", { "N2", "N4" })
  local more = calm:with("double", function(row) return 2 * row.cost end, "s")
  check.equal(more:column "double", { 26, 46, 26, 46 })
  check.equal(more:table{ columns = { "order", "double" }, sort = "double" }, table.concat({
    "order  double", "            s", "N2         26", "N4         26", "N2         46", "N4         46" }, "\n"))
  check.fails(function() study:row{ order = "N2" } end, "6 rows have order = N2, not one", "name more parameters")
  check.fails(function() study:row{ order = "N8" } end,
    "order must be a value that a case has, N2, N4, got the string 'N8'",
    "did you mean 'N2'?")
  check.fails(function() study:where{ mesh = { 1, "2" } } end, "study_methods_test.lua:",
    "study:where: mesh must be a value that a case has, 1, 2, got the string '2'")
  local part = study:where{ order = "N2" }
  check.equal({ #part:where{ order = "N4" }, #part:where(function(row) return row.order == "N8" end) }, { 0, 0 })
  check.fails(function() part:where{ order = "N3" } end, "N2, N4, got the string 'N3'")
  check.fails(function() part:row{ order = "N4" } end, "no rows have order = N4")
  check.equal(#study:where{ failed = true, cost = 7 }, 0)
  check.fails(function() study:median "cost" end, "must be 'order', 'mesh' or 'round'")
  check.fails(function() calm:with("x", function() return 0 / 0 end) end, "x is nan in row 1")
  check.fails(function() calm:with("mesh", function() return 0 end) end, "'mesh' is a parameter")
  check.fails(function() study:table{ columns = { "costs" } } end, "columns[1]", "did you mean 'cost'?")
end)

check.case("long texts are shortened in print, and complete in rows and files", function()
  local long, file = ("ä"):rep(59) .. "bcdef", check.file "long.csv"
  local study = new({ { a = 1 } }, function() return { failed = true, reason = long } end):execute{}
  check.equal(study:table{ columns = { "reason" } }, "reason\n\n" .. ("ä"):rep(59) .. "…")
  check.equal(study.rows[1].reason, long)
  study:csv(file)
  check.equal(sg.csv.read(file):column "reason", { long })
  local two = new(sg.grid{ a = { 1, 2 } }, function(case)
    return { error = 1, failed = case.a == 1, reason = case.a == 1 and ("x"):rep(200) or nil }
  end):execute{}
  check.holds(sg.work_precision(two, { error = "error" }), "Left out:\n  a = 1: failed: " .. ("x"):rep(71) .. "…")
end)

check.case("csv writes the columns of table", function()
  local study, file = sample():median "round", check.file "study.csv"
  study:csv(file, { sort = { "mesh", "order" } })
  local data = sg.csv.read(file)
  check.equal(data.comments, { "study: noted", "cost (s)", "wall (s)" })
  check.equal(data:column "cost", { 13, 13, 23, 23 })
  check.equal(data:column "order", { "N2", "N4", "N2", "N4" })
  check.fails(function() study:csv(check.file "no/a.csv") end, "study_methods_test.lua", ": study:csv: ", "/no/a.csv")
end)
