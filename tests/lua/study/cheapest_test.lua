-- sg.cheapest: the cheapest case, the second one, no case within the tolerance, invalid arguments.

require "check"

local study = setmetatable({ name = "ironing", parameters = { "order", "mesh" }, results = { "dPx", "dofs" },
                units = { wall = "s", dPx = "%" }, rows = {
  { order = "N4", mesh = { 12, 4 }, wall = 3, dPx = -0.03, dofs = 400 },
  { order = "N2", mesh = { 12, 4 }, wall = 1, dPx = 0.2, dofs = 300 },
  { order = "N2-N2.2", mesh = { 12, 4 }, wall = 1.25, dPx = 0.04, dofs = 350 },
  { order = "N2", mesh = { 24, 8 }, wall = 9, dPx = 0.05, dofs = 200 },
  { order = "N6", mesh = { 12, 4 }, wall = 0.5, failed = true, reason = "diverged" },
  { order = "N6", mesh = { 24, 8 }, wall = 0.1 },
} }, core.types.study)

check.case("the cheapest case within the tolerance, and the second one", function()
  local best, second = sg.cheapest(study, { error = "dPx", at_most = 0.05 })
  check.equal({ best.order, best.wall, second.order, second.wall }, { "N2-N2.2", 1.25, "N4", 3 })
  check.equal(tostring(best), "order = N2-N2.2, mesh = 12×4: dPx = 0.04 %, wall = 1.25 s")
  check.equal(tostring(second), "order = N4, mesh = 12×4: dPx = 0.03 %, wall = 3 s")
  check.equal(sg.cheapest(study, { error = "dPx", at_most = 0.05, cost = "dofs" }).mesh, { 24, 8 })
  best, second = sg.cheapest(study, { error = "dPx", at_most = 0.03 })
  check.equal({ best.order, second }, { "N4", nil })
end)

check.case("functions, filters, and equal costs", function()
  local function none() return 0 end
  local best, second = sg.cheapest(study, { error = "dPx", at_most = 1, cost = none })
  check.equal({ best.dPx, second.dPx }, { -0.03, 0.04 }) -- the smaller error first
  check.equal(tostring(best), "order = N4, mesh = 12×4: dPx = 0.03 %, cost = 0")
  check.equal(sg.cheapest(study, { error = none, at_most = 1e-9 }).order, "N6")
  local function of_n2(row) return row.order == "N2" end
  check.equal(sg.cheapest(study, { error = "dPx", at_most = 0.1, where = of_n2 }).wall, 9)
end)

check.case("no case within the tolerance: nil, and the nearest one", function()
  local best, text = sg.cheapest(study, { error = "dPx", at_most = 0.01 })
  check.equal({ best, text }, { nil, "no case has dPx of at most 0.01; the nearest is order = N4, mesh = 12×4: "
    .. "dPx = 0.03 %, wall = 3 s; left out: 2 that failed or lack dPx or wall" })
  best, text = sg.cheapest(study, { error = "dPx", at_most = 1, where = function() return false end })
  check.equal({ best, text }, { nil, "no case has dPx of at most 1" })
end)

check.case("wrong arguments", function()
  local function fails(options, ...)
    check.fails(function() sg.cheapest(study, options) end, "cheapest_test.lua:", ...)
  end
  fails({ error = "dPx", at_most = 1, cost = "time" }, "cost must be")
  fails({ error = "dPx", at_most = 1, cost = "order" },
    "cost (of the case order = N4, mesh = 12×4) must return finite numbers, got the string 'N4'")
end)

-- ── Errors against a row ─────────────────────────────────────────────────────────────────────────────────────────────

local forces = setmetatable({ name = "press", parameters = { "order", "mesh" }, results = { "P", "P.error" },
                units = { wall = "s" }, rows = {
  { order = "N2", mesh = 1, wall = 1, P = 2.2 },
  { order = "N2", mesh = 2, wall = 3, P = 2.02 },
  { order = "N4", mesh = 4, wall = 9, P = 2, ["P.error"] = 0.04 },
} }, core.types.study)
local error_of = { of = "P", reference = { order = "N4" } }

check.case("errors against a row: a case is within the tolerance with the uncertainty of the reference", function()
  local best = sg.cheapest(forces, { error = error_of, at_most = 3.5 }) -- 1 % off, reference ± 2 %
  check.equal(best.mesh, 2)
  check.holds(tostring(best), "error of P = 1 %", "Reference: order = N4, mesh = 4, P = 2 ± 2 %",
    "within which errors are not known")
  local none, text = sg.cheapest(forces, { error = error_of, at_most = 2.5, where = function(row)
    return row.order == "N2"
  end })
  check.equal(none, nil)
  check.holds(text, "no case has error of P of at most 2.5")
end)

check.case("errors against a row: a diagram shows how uncertain it is, or that this is unknown", function()
  local compared = sg.work_precision(forces, { error = error_of, file = check.folder() .. "/speed.png" })
  check.holds(tostring(compared), "Reference: order = N4, mesh = 4, P = 2 ± 2 %", "it is the reference")
  local plain = setmetatable(lists.merged(forces, { results = { "P" }, rows = lists.map(forces.rows, function(row)
    return lists.merged(row, { ["P.error"] = false })
  end) }), core.types.study)
  check.holds(tostring(sg.work_precision(plain, { error = error_of })), "how uncertain it is itself is unknown")
end)

check.case("errors against a row: wrong input", function()
  for _, wrong in ipairs {
    { { of = "Q", reference = { order = "N4" } }, "error.of", "'Q'" },
    { { of = "P", reference = { order = "N2" } }, "error.reference: 2 rows have order = N2, not one" },
    { { of = "P", reference = { order = "N8" } }, "error.reference", "N8" },
    { { of = "P" }, "error.reference" },
    { { reference = { order = "N4" } }, "error.of" },
  } do
    check.fails(function() sg.cheapest(forces, { error = wrong[1], at_most = 1 }) end, "sg.cheapest",
      table.unpack(wrong, 2))
  end
end)
