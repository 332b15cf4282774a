-- One problem as a study: its cases executed, medians of the rounds taken, errors measured.
--
-- A problem is a module with name, title, page (of its description), about; orders, meshes, rounds (how often every
-- case is run), once (meshes that are run in the first round only), affordable(order, mesh); run(case) → dofs,
-- iterations, wall, cpu (s) and plain data; errors, a list of { name, title, unit, of(row, reference) → error };
-- reference { order, mesh }, if an error needs one; savings, a list of { order, mesh, order, mesh, saved in % }, as
-- printed in saved_in.

local sg = require "signorini"

local study = {}

local function holds(list, value)
  for _, known in ipairs(list) do
    if known == value then return true end
  end
  return false
end

--- The requested ones of a problem's values, in its order; if `open`, followed by all other requested ones.
local function chosen(own, asked, open)
  if asked[1] == "all" then return own end
  local list = {}
  for _, value in ipairs(own) do
    if holds(asked, value) then list[#list + 1] = value end
  end
  for _, value in ipairs(open and asked or {}) do
    if not holds(list, value) then list[#list + 1] = value end
  end
  return list
end

--- Rounds vary slowest, so that a disturbance does not affect one order alone. The reference is solved first, once.
--- `everything`: whether all orders are run; explicitly requested ones are run on all meshes, affordable or not.
local function make_cases(problem, orders, meshes, rounds, everything)
  local list, reference = {}, problem.reference
  local affordable = everything and problem.affordable or function() return true end
  if reference and not (holds(orders, reference.order) and holds(meshes, reference.mesh)) then
    list[1] = sg.grid({ round = { 1 } }, { mesh = { reference.mesh } }, { order = { reference.order } })
  end
  for round = 1, rounds do
    for _, mesh in ipairs(meshes) do
      local chosen_orders = {}
      for _, order in ipairs(orders) do
        if affordable(order, mesh) then chosen_orders[#chosen_orders + 1] = order end
      end
      if #chosen_orders > 0 and (round == 1 or not (problem.once and problem.once[mesh])) then
        list[#list + 1] = sg.grid({ round = { round } }, { mesh = { mesh } }, { order = chosen_orders })
      end
    end
  end
  return list
end

local function is_case(row, case) return row.order == case.order and row.mesh == case.mesh end

--- The errors of a problem as results of a study of medians; none for failed cases and the reference itself.
local function measure(problem, medians)
  local wanted, reference = problem.reference, nil
  for _, row in ipairs(medians.rows) do
    if wanted and not row.failed and is_case(row, wanted) then reference = row end
  end
  for _, error in ipairs(problem.errors) do
    medians = medians:with(error.name, function(row)
      if row.failed or wanted and (not reference or is_case(row, wanted)) then return nil end
      return error.of(row, reference)
    end, error.unit)
  end
  return medians
end

--- Executes the missing cases of a problem. Returns { problem, study (as executed), cases (a study of medians with
--- errors, without a reference that was not requested), orders, meshes, rounds }; nil if no mesh is one of the
--- problem's.
function study.of(problem, options)
  local orders, meshes = chosen(problem.orders, options.orders, true), chosen(problem.meshes, options.meshes)
  if #meshes == 0 then return nil end
  local rounds = options.rounds > 0 and options.rounds or problem.rounds
  local executed = sg.study{
    name = "speed against accuracy: " .. problem.name, run = problem.run, sequential = true,
    folder = ("%s/%s"):format(options.out, problem.name), units = { cpu = "s" },
    cases = make_cases(problem, orders, meshes, rounds, options.orders[1] == "all"),
  }
  executed:execute()
  local cases = measure(problem, executed:median "round"):where(function(row)
    return holds(orders, row.order) and holds(meshes, row.mesh)
  end)
  return { problem = problem, study = executed, cases = cases, orders = orders, meshes = meshes, rounds = rounds }
end

return study
