-- Solves one variant of a benchmark with one formulation, and compares its results with the reference.
--
-- A benchmark is a table in a file of its own: name, title, source, units, set_up (geometry, materials, loads as plain
-- data), variants { name, …, expected } and scene. `expected` lists quantities { name, value, uncertainty, tolerance,
-- kind }: value and uncertainty of the reference, by default exact; tolerance, relative to the value; kind "closed
-- form", "published" or "comparison", which is shown but not judged. scene(set_up, variant, tools) returns model, path
-- and options of model:run, whose `measure` returns the quantities by name, or a table `columns` with their columns.

local rows = require "formulations.rows"

local solve = {}

--- What a scene needs besides its data: numbers of elements on another mesh, and contacts of the formulation.
local function tools(formulation, mesh)
  return {
    count = function(elements) return math.max(1, math.floor(elements * mesh + 0.5)) end,
    contact = function(contact) return rows.contact(rows[formulation], contact) end,
  }
end

--- Value and bar of each expected quantity at the end of the path, in their order, and the cost.
function solve.case(benchmark, variant, formulation, mesh, errors)
  local model, path, options = benchmark.scene(benchmark.set_up, variant, tools(formulation, mesh))
  options = options or {}
  local columns = options.columns or {}
  options.columns = nil
  if errors then
    options.errors = { scene = function(q)
      local own, stages, others = benchmark.scene(benchmark.set_up, variant, tools(formulation, mesh * q.mesh))
      others = others or {}
      others.columns = nil
      return own, stages, others
    end }
  end
  local run = model:run(path, options)
  if run.failed then return { failed = true, reason = run.failure } end
  local result = { unknowns = model:cost().unknowns, iterations = run.iterations, steps = run.steps,
                   warnings = #run.warnings > 0 and table.concat(run.warnings, "\n") or nil }
  for i, quantity in ipairs(variant.expected) do
    local name = columns[quantity.name] or quantity.name
    local values = run:column(name)
    result["value" .. i] = values[#values]
    if options.errors then
      local bars, budget = run:error(name), run:budget(name)
      local bar = bars[#bars]
      result["bar" .. i], result["why" .. i] = bar == bar and bar or nil, budget.why
    end
  end
  return result
end

--- The deviation of a value from its reference, and whether it is at most the sum of tolerance and uncertainty; nil for
--- a comparison.
function solve.judge(expected, value)
  local deviation = value - expected.value
  if expected.kind == "comparison" then return deviation end
  return deviation, math.abs(deviation) <= expected.tolerance * math.abs(expected.value) + (expected.uncertainty or 0)
end

return solve
