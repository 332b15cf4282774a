-- The terms of the error of a run's columns, estimated from its companions [theory 11.6]. A term is a list over the
-- rows of the run; it has no entry where it is unknown.

local lists = require "signorini.call.lists"

local terms = {}

local reach = 2 -- rows before and after that a value takes its bar from, too: differences may change their sign
local slowest, fastest = 1.2, 4 -- factors by which the error decreases on the mesh that are trusted
local fastest_area = 2 -- of quantities that depend on the border of the contact
local most_row = 0.9 -- share of the error of the mesh that a richer row may take away
local noise = 1e-8 -- of the largest value: differences that the tolerance of Newton's method may leave

-- ── Differences ──────────────────────────────────────────────────────────────────────────────────────────────────────

--- |a - b| of two lists as far as both go.
local function differences(a, b)
  local list = {}
  for i = 1, math.min(#a, #b) do list[i] = math.abs(a[i] - b[i]) end
  return list
end

--- The largest entries within a few rows, each times `factor`.
local function widened(list, factor)
  return lists.map(list, function(_, i)
    local most = 0
    for k = math.max(1, i - reach), math.min(#list, i + reach) do most = math.max(most, list[k]) end
    return factor * most
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

--- The term of the mesh: { bars, order q, and why there is none, or why it is doubtful }.
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
        return { bars = widened(d, 1), order = low, why = is_peak(name) and "no limit" or "not converging" }
      end
      order = order_of(before / now, size, finer.size, coarser.size, low, high)
    end
  end
  return { bars = widened(d, 1 / (ratio ^ order - 1)), order = order }
end

-- ── Steps ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The term of the steps from a companion with other steps: its error is c/m, that of the run c/n, with m and n steps
--- of a stage. `counts`: steps of the stages of the run.
local function step_term(reference, other, counts)
  local bars, first, last = {}, 0, 0
  for s, n in ipairs(counts) do
    local m, known = other.counts[s], {}
    for k = 1, m do
      local at = k * n / m
      local i = math.floor(at + 1e-9)
      local a, b = reference[first + i], reference[first + i + 1]
      if i == 0 then a = first > 0 and reference[first] or 0 end
      local value = other.values[last + k]
      local between = at - i > 1e-9
      if not (a and value and (b or not between)) then break end
      local difference = math.abs(value - (between and a + (b - a) * (at - i) or a))
      known[k] = difference / math.abs(n / m - 1)
    end
    for i = 1, n do -- the nearest of the companion's steps
      local k = math.max(1, math.ceil(i * m / n - 1e-9))
      if not known[k] or not reference[first + i] then return widened(bars, 1) end
      bars[first + i] = known[k]
    end
    first, last = first + n, last + m
  end
  return widened(bars, 1)
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

--- The terms of a column: { size (its largest value), mesh = { bars, order, why }, row (share of it), points, penalty,
--- steps, newton: lists; total: their sum, as far as all are known }. Terms that were not asked for are nil. counts:
--- steps of the stages of the run; tolerance: that of Newton's method.
function terms.of(name, own, records, counts, tolerance)
  local column = { size = largest(own), mesh = { bars = {}, why = records.missing or records["2h"].failure } }
  if records.missing or not records["2h"].values[name] then return column end
  column.mesh = mesh_term(name, own, records, records.size)
  column.newton = lists.map(own, function() return tolerance * column.size end)
  for _, key in ipairs(names) do
    local record = records[key]
    if record then
      local level = records[record.level == 4 and "4h" or "2h"]
      local reference, other = level.values[name], record.values[name] or {}
      if key == "steps" then
        column.steps = step_term(reference, { values = other, counts = record.steps or {} }, counts)
      else
        column[key] = widened(differences(reference, other), key == "points" and 4 / 3 or 1)
      end
    end
  end
  local row = records.row
  if row and row.values[name] then
    column.row = row_share(records[row.level == 4 and "4h" or "2h"].values[name], row.values[name], own)
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
