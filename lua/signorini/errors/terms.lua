-- The terms of the error of a run's columns, estimated from its companions [theory 11.6]. A term is a list over the
-- rows of the run; it has no entry where it is unknown.

local lists = require "signorini.call.lists"

local terms = {}

local reach = 2 -- rows before and after that a value takes its bar from, too: differences may change their sign
local small = 0.1 -- of the largest value: smaller ones count as this in proportions
local slowest, fastest = 1.2, 3.5 -- factors by which the error decreases on the mesh that are trusted
local fastest_area = 2.5 -- of quantities that depend on the border of the contact
local order_peak = 1.5 -- of stresses below a contact's border with the root singularity
local most_row = 0.9 -- share of the error of the mesh that a richer row may take away
local noise = 1e-8 -- of the largest value: differences that the tolerance of Newton's method may leave

-- ── Differences ──────────────────────────────────────────────────────────────────────────────────────────────────────

--- |a - b| of two lists as far as both go.
local function differences(a, b)
  local list = {}
  for i = 1, math.min(#a, #b) do list[i] = math.abs(a[i] - b[i]) end
  return list
end

--- Differences of a result whose sign changes along the path, as the border of contact passes elements: root mean
--- squares over neighboring rows, those of larger values of the result reduced in proportion; each times `factor`.
local function smoothed(list, own, factor)
  local least, sizes = 0, {}
  for _, value in ipairs(own) do least = math.max(least, small * math.abs(value)) end
  for i, value in ipairs(own) do sizes[i] = math.max(least, math.abs(value)) end
  return lists.map(list, function(_, i)
    local first, last, sum = math.max(1, i - reach), math.min(#list, i + reach), 0
    for k = first, last do sum = sum + (list[k] * math.min(1, sizes[i] / sizes[k])) ^ 2 end
    return factor * math.sqrt(sum / (last - first + 1))
  end)
end

--- ‖list‖ over its first `count` entries.
local function norm(list, count)
  local sum = 0
  for i = 1, math.min(#list, count) do sum = sum + list[i] ^ 2 end
  return math.sqrt(sum)
end

local function largest(list)
  local most = 0
  for _, value in ipairs(list) do most = math.max(most, math.abs(value)) end
  return most
end

-- ── Mesh ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The order q of an error c h^q for which the differences of three meshes h1 < h2 < h3 have the ratio r = (h3^q -
--- h2^q) / (h2^q - h1^q), which increases with q; within limits.
local function order_of(r, h1, h2, h3, low, high)
  for _ = 1, 60 do
    local middle = (low + high) / 2
    if (h3 ^ middle - h2 ^ middle) / (h2 ^ middle - h1 ^ middle) < r then low = middle else high = middle end
  end
  return low
end

--- True for quantities that depend on the place of the contact's border.
local function depends_on_border(name) return name:find "%.area$" or name:find "%.debonded$" end

local function is_peak(name) return name:find "%.max_pressure$" end

--- The term of the mesh: { bars, order q, why it is doubtful, exact: true if the mesh has no effect }.
local function mesh_term(name, own, records, size)
  local finer, coarser = records["2h"], records["4h"]
  local d = differences(own, finer.values[name])
  local low, high = math.log(slowest, 2), math.log(depends_on_border(name) and fastest_area or fastest, 2)
  local ratio = finer.size / size
  if ratio < 1.05 then return { bars = {}, why = "elements cannot be larger" } end
  local order, count = 1, 0
  if coarser.size and coarser.size > 1.05 * finer.size then
    local more = differences(finer.values[name], coarser.values[name])
    count = math.min(#d, #more)
    local before, now = norm(more, count), norm(d, count)
    if 2 * count >= #d and now > noise * largest(own) * math.sqrt(count) then
      local expected = (coarser.size ^ low - finer.size ^ low) / (finer.size ^ low - size ^ low)
      if before < expected * now then
        local all = differences(own, coarser.values[name])
        for i, value in ipairs(d) do d[i] = math.max(value, more[i] or 0, all[i] or 0) end
        return { bars = smoothed(d, own, 1), order = low, why = "not converging" }
      end
      order = order_of(before / now, size, finer.size, coarser.size, low, high)
    end
  end
  return { bars = smoothed(d, own, 1 / (ratio ^ (is_peak(name) and order_peak or order) - 1)), order = order,
           why = records.single and "one element", exact = largest(d) <= noise * largest(own) }
end

-- ── Steps ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The value of a list at a place between its entries `first` and `first` + n, by a parabola through the nearest
--- three, or nil; entry 0 is 0. Companions with half of an odd number of steps end between those of the run.
local function between(list, first, n, at)
  local function entry(i) return first + i == 0 and 0 or list[first + i] end
  local i = math.floor(at + 0.5)
  if n < 2 or math.abs(at - i) < 1e-9 then return entry(i) end
  i = math.max(1, math.min(n - 1, i))
  local a, b, c, x = entry(i - 1), entry(i), entry(i + 1), at - i
  return a and b and c and b + x * (c - a) / 2 + x ^ 2 * (a - 2 * b + c) / 2
end

--- The term of the steps, in the rows of the reference, from a companion with other steps: its error is c/m, that of
--- the reference c/n, with m and n steps of a stage.
local function step_term(reference, other, counts, other_counts)
  local bars, first, last = {}, 0, 0
  for s, n in ipairs(counts) do
    local m, known = other_counts[s], {}
    for k = 1, m do
      local value, own = other[last + k], between(reference, first, n, k * n / m)
      if not (value and own) then break end
      known[k] = math.abs(value - own) / math.abs(n / m - 1)
    end
    for i = 1, n do -- the next of the companion's steps
      local k = math.max(1, math.ceil(i * m / n - 1e-9))
      if not known[k] or not reference[first + i] then return bars end
      bars[first + i] = known[k]
    end
    first, last = first + n, last + m
  end
  return bars
end

--- A list over the rows of one path in the rows of the same path with other steps: that of the next step.
local function in_rows(list, counts, own_counts)
  local result, first = {}, 0
  for s, n in ipairs(own_counts) do
    for i = 1, n do result[#result + 1] = list[first + math.ceil(i * counts[s] / n - 1e-9)] end
    first = first + counts[s]
  end
  return result
end

-- ── All terms ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The share of the error of the mesh that a richer row takes away; nil if it is unknown.
local function row_share(reference, richer, own)
  local count = math.min(#reference, #richer, #own)
  local whole = norm(differences(reference, own), count)
  if count == 0 then return nil end
  if whole == 0 then return 0 end
  return math.min(most_row, norm(differences(reference, richer), count) / whole)
end

local names = { "points", "penalty", "steps" }

--- The term of a companion besides the mesh, over the rows of the run. `order`: of the error on the mesh.
local function other_term(key, name, records, counts, order)
  local record, reference = records[key], records[key].base
  local own, other = reference.values[name] or {}, record.values[name] or {}
  local bars = key == "steps" and step_term(own, other, reference.counts, record.counts or {})
    or differences(own, other)
  if key == "points" then
    bars = smoothed(bars, own, 4 / 3 * (records.size / reference.size) ^ math.min(2, order or 1))
  end
  local factor = records.factors and records.factors[key] or 1
  return lists.map(in_rows(bars, reference.counts, counts), function(bar) return factor * bar end)
end

--- The terms of a column: { size (its largest value), mesh = { bars, order, why }, row (share of it), points, penalty,
--- steps, newton: lists; total: their sum, as far as all are known }. Terms that were not asked for are nil. records:
--- of companions; with `factors` of the terms points, penalty and steps, if the run has other constants than they;
--- counts: steps of the stages of the run; tolerance: that of Newton's method.
function terms.of(name, own, records, counts, tolerance)
  local column = { size = largest(own), mesh = { bars = {}, why = records.missing or records["2h"].failure } }
  if records.missing or not records["2h"].values[name] then return column end
  column.mesh = mesh_term(name, own, records, records.size)
  column.newton = lists.map(own, function() return tolerance * column.size end)
  for _, key in ipairs(names) do
    if records[key] then column[key] = other_term(key, name, records, counts, column.mesh.order) end
  end
  local row = records.row
  if row and row.values[name] then
    column.row = row_share(row.base.values[name] or {}, row.values[name], own)
  end
  column.total = {}
  for i, bar in ipairs(column.mesh.bars) do
    local sum = bar + column.newton[i]
    for _, key in ipairs(names) do
      if column[key] then sum = sum and column[key][i] and sum + column[key][i] end
    end
    column.total[i] = sum or nil
    if not sum then break end
  end
  return column
end

return terms
