-- sg.fit: the values of parameters with which a scene describes measured data, by least squares [theory 12.3].

local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local data = require "signorini.inverse.data"
local descent = require "signorini.inverse.descent"
local intervals = require "signorini.inverse.intervals"
local lists = require "signorini.call.lists"
local parameters = require "signorini.inverse.parameters"
local progress_file = require "signorini.inverse.progress_file"
local sizes = require "signorini.gradients.sizes"
local trial = require "signorini.inverse.trial"
local vectors = require "signorini.inverse.vectors"

local where = "sg.fit"
local dot, difference, norm, sum = vectors.dot, vectors.difference, vectors.norm, vectors.sum

-- Singular values below this part of the largest are rounding errors of the derivatives.
local negligible = 1e-4
-- Moves that promise less than this part of a variance are within the noise of the data.
local noise = 0.01
-- Moves of ln q below this end a search: derivatives are not more exact.
local smallest = 1e-6
-- Distance below which another point tells rounding errors in place of curvature.
local too_near = 1e-3
-- Most passes of Gauss and Newton's method for the best move.
local passes, most_halvings = 50, 8
-- Weights that change by more than this part after the error bars are known at the values found are used once more.
local noticed = 0.1

--- Standard deviations of the points of all sets in one list: of the data, with the error bars of the results.
local function weights_of(search)
  local all = {}
  for k, set in ipairs(search.sets) do
    for i, sigma in ipairs(set.sigma) do
      local bar = search.bars and search.bars[k][i] or 0
      all[#all + 1] = math.sqrt(sigma ^ 2 + bar ^ 2)
    end
  end
  return all
end

--- Weighs what a point's run says: `residuals`, their derivatives `columns` by variable, and `merit`, the sum of their
--- squares.
local function weigh(search, point)
  local residuals, weights = {}, search.weights
  local columns = lists.map(search.free, function() return {} end)
  for k, set in ipairs(search.sets) do
    local prediction = point.predictions[k]
    for i, value in ipairs(set.values) do
      local row = #residuals + 1
      residuals[row] = (value - prediction.values[i]) / weights[row]
      for j, one in ipairs(search.free) do
        columns[j][row] = prediction.slopes[one.name][i] * parameters.rate(one, point.values) / weights[row]
      end
    end
  end
  point.residuals, point.columns, point.merit = residuals, columns, dot(residuals, residuals)
end

local function point_of(search, z, found)
  local point = { z = z, values = found.at, found = found, predictions = lists.map(search.sets, function(set)
    return data.predict(set, found)
  end) }
  weigh(search, point)
  return point
end

--- The variance of the weighed residuals: 1 if the data scatter as they should, and not below rounding errors.
local function variance(search, point)
  return math.max(point.merit / (#point.residuals - #search.free), search.rounding)
end

--- The move d within limits of least ‖r − J d‖ [theory (12.5)], in the directions that the data tell something about:
--- a direction is left out if noise, what no move explains, has the size of what it gains and it is known by no more
--- than a factor of e. Returns also by how much the square would fall without limits.
local function least_squares(search, residuals, columns, low, high)
  local found, rows, right, rest = core.singular_values(columns), {}, {}, dot(residuals, residuals)
  local gains = lists.map(found.u, function(direction) return dot(direction, residuals) end)
  local variance_left = math.max((rest - dot(gains, gains)) / (#residuals - #search.free), search.rounding)
  for k, value in ipairs(found.values) do
    local is_noise = value ^ 2 < variance_left and gains[k] ^ 2 < 4 * variance_left
    if value > negligible * found.values[1] and not is_noise then
      rows[#rows + 1] = lists.map(found.v[k], function(part) return value * part end)
      right[#right + 1] = gains[k]
    end
  end
  if #rows == 0 then return lists.map(search.free, function() return 0 end), 0 end
  return core.box_least_squares(vectors.transposed(rows), right, low, high), dot(right, right)
end

--- r − J d of a point.
local function linear(point, d)
  local residuals = lists.joined(point.residuals)
  for j, column in ipairs(point.columns) do residuals = sum(residuals, column, -d[j]) end
  return residuals
end

--- The residuals at a move d from a point, and their derivatives −J there, as a function of d, by the derivatives at
--- the point and the residuals at another one, z + b: r − J d + (b · d/b · b)² (r_b − r + J b) [theory (12.6)].
local function tensor_model(point, other)
  local b = difference(other.z, point.z)
  local bend, square = difference(other.residuals, linear(point, b)), dot(b, b)
  return function(d)
    local part = dot(b, d) / square
    return sum(linear(point, d), bend, part ^ 2),
      lists.map(point.columns, function(column, j) return sum(column, bend, -2 * part * b[j] / square) end)
  end
end

--- The best move from a point within limits. `other`: a further point of which the residuals are known, or nil.
local function move(search, point, other, low, high)
  local little = noise * variance(search, point)
  if other and norm(difference(other.z, point.z)) < too_near then other = nil end
  local model = other and tensor_model(point, other)
    or function(d) return linear(point, d), point.columns end
  local d, least, most = lists.map(search.free, function() return 0 end), point.merit, nil
  local residuals, columns = point.residuals, point.columns
  for _ = 1, other and passes or 1 do
    local by, gain = least_squares(search, residuals, columns, difference(low, d), difference(high, d))
    most = most or gain
    local before = least
    for halvings = 0, most_halvings do
      local to = sum(d, by, 0.5 ^ halvings)
      local there, slopes = model(to)
      local size = dot(there, there)
      if size < least then
        d, least, residuals, columns = to, size, there, slopes
        break
      end
    end
    if before - least < little then break end
  end
  return d, point.merit - least, most < little
end

local function descend(search, point, radius, most)
  local best, other = point, nil
  return descent({
    name = where, free = search.free, fixed = search.fixed, most = most, smallest = smallest,
    merit = function(at) return at.merit end,
    describe = function(at) return ("scatter %.4g"):format(math.sqrt(variance(search, at))) end,
    move = function(at, low, high) return move(search, at, other, low, high) end,
    accepted = function(at, now)
      best, other = at, best
      search.file:save(at.values, now)
    end,
    evaluate = function(z)
      local found, why = trial.solve(search, parameters.values(search.free, search.fixed, z))
      if not found then return nil, why end
      other = point_of(search, z, found)
      return other
    end,
  }, point, radius)
end

--- Sets the weights of the points, and the mean square of the rounding errors of the results next to them.
local function set_weights(search, found)
  search.weights = weights_of(search)
  local largest, squares, row = sizes.largest(found.run, found.results, found.run.model), 0, 0
  for _, set in ipairs(search.sets) do
    for _ in ipairs(set.at) do
      row = row + 1
      squares = squares + (sizes.uncertain * largest[sizes.kind_of(set.y)] / search.weights[row]) ^ 2
    end
  end
  search.rounding = squares / row
end

--- The error bars of the results at values, by set, with the sets in which some are unknown; nil if the run fails,
--- with "interrupted" if Ctrl-C has ended it.
local function bars_at(search, values)
  local run, why = trial.run(search, values, { errors = true })
  if not run or not run.errors then return nil, why end
  local all = { unknown = {} }
  for k, set in ipairs(search.sets) do
    local is_unknown
    all[k], is_unknown = data.bars(set, run)
    if is_unknown then all.unknown[#all.unknown + 1] = set end
  end
  return all
end

--- The largest change of a weight, in parts of it.
local function change(before, after)
  local most = 0
  for i, value in ipairs(before) do most = math.max(most, math.abs(after[i] / value - 1)) end
  return most
end

--- Searches, and once more with the error bars at the values found where these change the weights.
local function solve(search, point, radius)
  local best, reason, tries = descend(search, point, radius, search.runs)
  if not search.bars or reason == "interrupted" then return best, reason, tries end
  local bars, why = bars_at(search, best.values)
  if why then return best, why, tries end
  search.bars = bars or search.bars
  local before = search.weights
  set_weights(search, best.found)
  weigh(search, best)
  if change(before, search.weights) > noticed and #tries < search.runs then
    local more
    best, reason, more = descend(search, best, nil, search.runs - #tries)
    tries = lists.joined(tries, { table.unpack(more, 2) })
  end
  return best, reason, tries
end

return function(search)
  search.caller = where
  search.free, search.fixed = parameters.read(where, search.start, search.bounds, search.scale)
  search.sets = data.read(where, search.data)
  local count = #lists.flat(lists.map(search.sets, function(set) return set.values end))
  if count <= #search.free then
    core.fail(("%s: data has %s for %s: more points than parameters are needed"):format(where,
      counted(count, "point"), counted(#search.free, "parameter")))
  end
  if search.errors and not lists.any(search.sets, function(set) return set.has_sigma end) then
    core.fail(where .. ": errors needs the standard deviation of the data, data[1].sigma, to weigh both")
  end
  search.file = progress_file.open(search)
  local values, radius = search.file:read(search)
  local found = trial.begin(search, values)
  data.check(search.sets, found)
  search.bars = search.errors and bars_at(search, values) or nil
  set_weights(search, found)
  local point, reason, tries = solve(search, point_of(search, parameters.variables(search.free, values), found), radius)
  return require "signorini.inverse.fit_result"(search, point, reason, tries, intervals.of(search, point))
end
