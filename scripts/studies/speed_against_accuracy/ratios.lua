-- Ratios of time at equal error between orders, and the fastest cases that reach an error.

local sg = require "signorini"

local ratios = {}

--- The pairs of orders that are compared: layers against N2 and N4, and two rows of a layer against one.
ratios.pairs = { { "N2-N2.1", "N2" }, { "N2-N2.2", "N2" }, { "N2-N2.2", "N4" }, { "N2-N2.2x2", "N2-N2.2" } }

--- { at = errors, ratio = time ratios at these errors }, or { why } if there is no common error, from a comparison
--- by sg.work_precision. nil if one of the two was not run.
function ratios.of(comparison, order, other)
  for _, entry in ipairs(comparison.ratios) do
    local turned = entry.a == other and entry.b == order
    if turned or entry.a == order and entry.b == other then
      if entry.why then return { why = entry.why } end
      local found = { at = entry.at, ratio = {} }
      for i, value in ipairs(entry.ratio) do found.ratio[i] = turned and 1 / value or value end
      return found
    end
  end
end

--- The ratios of a pair of orders in the middle of the common errors, over all problems' results, in increasing order:
--- a list of { ratio, problem (its title), error (its title) }.
function ratios.over_all(results, order, other)
  local list = {}
  for _, result in ipairs(results) do
    local problem = result.measured.problem
    for _, error in ipairs(problem.errors) do
      local comparison = result.comparisons[error.name]
      local found = comparison and ratios.of(comparison, order, other)
      if found and found.ratio then
        list[#list + 1] = { ratio = found.ratio[(#found.ratio + 1) // 2], problem = problem.title, error = error.title }
      end
    end
  end
  table.sort(list, function(a, b) return a.ratio < b.ratio end)
  return list
end

--- Whether a row has this order and, if given, this mesh.
local function is_case(row, order, mesh) return row.order == order and (mesh == nil or row.mesh == mesh) end

--- For N2 on every mesh, the fastest case with at most its error: a list of { plain, best }, rows of the study.
function ratios.least(cases, error, time)
  local list = {}
  for _, row in ipairs(cases.rows) do
    if is_case(row, "N2") and row[error] and row[error] ~= 0 then
      local best = sg.cheapest(cases, { error = error, at_most = math.abs(row[error]), cost = time })
      list[#list + 1] = { plain = row, best = best }
    end
  end
  return list
end

--- The pairs with a published saving of which both were run: { row, other, saved, printed (both in %) }.
function ratios.published(cases, savings, time)
  local function row_of(order, mesh)
    local row = cases:where(function(row) return is_case(row, order, mesh) end).rows[1]
    return row and not row.failed and row[time] and row or nil
  end
  local list = {}
  for _, pair in ipairs(savings) do
    local row, other = row_of(pair[1], pair[2]), row_of(pair[3], pair[4])
    if row and other then
      list[#list + 1] = { row = row, other = other, saved = 100 * (1 - row[time] / other[time]), printed = pair[5] }
    end
  end
  return list
end

return ratios
