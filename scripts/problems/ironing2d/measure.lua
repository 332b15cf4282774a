-- Oscillation of a force while the die slides: max − min over steps 110 to 165, in which the die's center moves from
-- x = 1.13 to 1.46, about one element pitch of m1 in the middle of the slab. Over the whole slide the trend near the
-- slab's ends would dominate; on m2 and finer it matters even within the window, so the oscillation is also measured
-- after subtraction of the best-fit parabola ("detrended").

local measure = { first = 110, last = 165 }

--- The values minus their best-fit parabola. On points x that lie symmetrically about 0 the polynomials 1, x and x² −
--- mean x² are orthogonal, so each coefficient is a quotient of two sums.
local function without_parabola(values)
  local count, square = #values, 0
  local function x(i) return i - (count + 1) / 2 end
  for i = 1, count do square = square + x(i) ^ 2 / count end
  local rest = table.move(values, 1, count, 1, {})
  for _, polynomial in ipairs {
    function() return 1 end, x, function(i) return x(i) ^ 2 - square end,
  } do
    local projection, norm = 0, 0
    for i = 1, count do
      projection, norm = projection + rest[i] * polynomial(i), norm + polynomial(i) ^ 2
    end
    for i = 1, count do rest[i] = rest[i] - projection / norm * polynomial(i) end
  end
  return rest
end

local function spread(values) return math.max(table.unpack(values)) - math.min(table.unpack(values)) end

--- { raw, detrended } of a list over the steps first to last, by default the window; empty if the run ended
--- before it. Three values lie on a parabola: nothing is left to detrend.
function measure.oscillation(values, first, last)
  first, last = first or measure.first, last or measure.last
  if #values < last then return {} end
  local part = table.move(values, first, last, 1, {})
  return { raw = spread(part), detrended = #part > 3 and spread(without_parabola(part)) or nil }
end

--- The mean over the window, or nothing if the run ended before it.
function measure.mean(values)
  local sum = 0
  for i = measure.first, measure.last do sum = sum + (values[i] or 0 / 0) end
  return sum == sum and sum / (measure.last - measure.first + 1) or nil
end

--- Adds the named oscillations in % of those of a case, if given: raw_percent, detrended_percent. No percentage of an
--- oscillation of zero.
function measure.percent(cases, forces, reference)
  for _, case in ipairs(cases) do
    for _, force in ipairs(forces) do
      for _, kind in ipairs { "raw", "detrended" } do
        local part, whole = case[force][kind], reference and reference[force][kind]
        case[force][kind .. "_percent"] = part and whole and whole > 0 and 100 * part / whole or nil
      end
    end
  end
end

--- Adds to each case the oscillations of its reactions, dPx and dPy, also in % of those of `reference`, a
--- case or nothing.
function measure.compare(cases, reference)
  for _, case in ipairs(cases) do
    case.dPx, case.dPy = measure.oscillation(case.run:column "grip.fx"), measure.oscillation(case.run:column "grip.fy")
  end
  measure.percent(cases, { "dPx", "dPy" }, reference)
end

return measure
