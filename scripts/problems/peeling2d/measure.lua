-- Figures of a moment curve in Table 7.8: oscillation, steepest rise and fall within a window of angles.
--
-- They are measured on whole steps of 0.1°, as in the thesis: oscillation max M − min M, slopes as quotients of
-- differences (M_k+1 − M_k)/0.1° of neighboring steps. At a turning point between two steps, the state at the later one
-- is the first that the path reaches there, so the quotient spans the drop, as does a step with prescribed angles that
-- jumps over it. States of arc-length increments between steps do not count; the oscillation of all states is given in
-- addition.

local measure = {}

local rounding = 1e-6 -- of an angle in degrees

--- Whether a row is a whole step, not a state between steps.
function measure.is_whole(step) return step == math.floor(step) end

--- Snap-backs of a path: { turn, back, angle at both, moment at both } in order. `turn` and `back` are the rows of the
--- two turning points; a path that ends before the second one is not counted.
function measure.snap_backs(case)
  local angle, found, turn = case.angle, {}, nil
  for row = 2, #angle - 1 do
    if angle[row] >= angle[row - 1] and angle[row + 1] < angle[row] then turn = row end
    if turn and angle[row] < angle[row - 1] and angle[row + 1] >= angle[row] then
      found[#found + 1] = { turn = turn, back = row, from = angle[turn], to = angle[row],
                            width = angle[turn] - angle[row], drop = case.moment[turn] - case.moment[row] }
      turn = nil
    end
  end
  return found
end

--- Mean of M over the path from one row to another: ∫ M dθ by the trapezoidal rule. A snap-back
--- counts with its sign, so this is the work of the moment.
local function mean(case, first, last)
  local work = 0
  for row = first + 1, last do
    work = work + (case.moment[row] + case.moment[row - 1]) / 2 * (case.angle[row] - case.angle[row - 1])
  end
  return work / (case.angle[last] - case.angle[first])
end

--- Rows of the whole steps within a window {from, to} in degrees; nil if the path ends before the window does.
local function window_rows(case, window)
  local rows = {}
  for row, angle in ipairs(case.angle) do
    if measure.is_whole(case.step[row]) and angle >= window[1] - rounding and angle <= window[2] + rounding then
      rows[#rows + 1] = row
    end
  end
  local complete = #rows > 1 and case.angle[rows[1]] < window[1] + rounding
    and case.angle[rows[#rows]] > window[2] - rounding
  return complete and rows or nil
end

--- { oscillation, rise, fall, path_oscillation, mean } in E0 L0³, slopes per degree; empty if the path ends before the
--- window.
function measure.window(case, window)
  local rows = window_rows(case, window)
  if not rows then return {} end
  local low, high, rise, fall = math.huge, -math.huge, -math.huge, math.huge
  for i, row in ipairs(rows) do
    local moment = case.moment[row]
    low, high = math.min(low, moment), math.max(high, moment)
    if i > 1 then
      local before = rows[i - 1]
      local slope = (moment - case.moment[before]) / (case.angle[row] - case.angle[before])
      rise, fall = math.max(rise, slope), math.min(fall, slope)
    end
  end
  local path_low, path_high = low, high
  for row = rows[1], rows[#rows] do
    path_low, path_high = math.min(path_low, case.moment[row]), math.max(path_high, case.moment[row])
  end
  return { oscillation = high - low, rise = rise, fall = fall, path_oscillation = path_high - path_low,
           mean = mean(case, rows[1], rows[#rows]) }
end

--- The angle of the turning point in a run's failure, or nil.
function measure.reported_turn(run)
  if run.reason ~= "turning_point" then return nil end
  return tonumber(run.failure:match "turning point at edge%.angle = ([%d.]*%d)")
end

return measure
