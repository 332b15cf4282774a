-- What sg.fit returns: values with intervals, doubts, and the curves of data and run.

local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local data = require "signorini.inverse.data"
local ends = require "signorini.inverse.ends"
local lists = require "signorini.call.lists"
local named = require "signorini.call.named"
local on_behalf_of = require "signorini.call.on_behalf_of"
local parameters = require "signorini.inverse.parameters"
local shown = require "signorini.inverse.shown"
local trial = require "signorini.inverse.trial"

local Fit = {}
Fit.__index = Fit
Fit.__name = "fit"
core.types.fit = Fit
named.strict_type(Fit, "fit", "search")

-- Standard deviations by which the scatter of χ²/n may exceed 1.
local tolerated = 4
-- Correlation above which two parameters are named.
local close = 0.95
-- Part of a change that runs at the ends of intervals may differ from the linear one.
local curved = 0.25
-- Points of the line of a run in charts.
local chart_points = 200

-- ── Doubts ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local function quoted(names)
  return table.concat(lists.map(names, function(name) return ("'%s'"):format(name) end), " and ")
end

local function about_parameters(found)
  local texts, vague = {}, found.undetermined
  if #vague > 0 then
    local others = #found.names > 0 and ("; the other intervals hold within a factor of e of %s"):format(
      #vague == 1 and "it" or "them") or ""
    texts[1] = ("%s %s not determined by these data%s. Hint: fix %s, bounds = { %s = {v, v} }, or add data that depend "
      .. "on it"):format(quoted(vague), #vague == 1 and "is" or "are", others, #vague == 1 and "it" or "one", vague[1])
  end
  if #found.at_bounds > 0 then
    texts[#texts + 1] = ("%s %s at a bound, without an interval"):format(quoted(found.at_bounds),
      #found.at_bounds == 1 and "is" or "are")
  end
  for i, a in ipairs(found.names) do
    for k = i + 1, #found.names do
      local b = found.names[k]
      local value = found.correlation[a][b]
      if math.abs(value) > close then
        texts[#texts + 1] = ("the correlation of '%s' and '%s' is %.3f: if one were known, the interval of the other "
          .. "would be %.2g times narrower"):format(a, b, value, 1 / math.sqrt(1 - value ^ 2))
      end
    end
  end
  return texts
end

--- Sentences on how data, scatter and steps fit together.
local function about_data(search, point, found)
  local texts, row = {}, 0
  local freedom = #point.residuals - #found.names
  local excess = found.scatter ^ 2 - 1
  if search.sets[1].has_sigma and excess > tolerated * math.sqrt(2 / freedom) then
    texts[1] = ("data and run differ by %.3g times what the standard deviations explain: the scene does not describe "
      .. "the data, or sigma is too small"):format(found.scatter)
  end
  for k, set in ipairs(search.sets) do
    local coarse = 0
    for _, straight in ipairs(point.predictions[k].straight) do
      row = row + 1
      if straight > found.scatter * search.weights[row] then coarse = coarse + 1 end
    end
    local outside = point.predictions[k].outside
    if outside > 0 then
      texts[#texts + 1] = ("%s: %s lie beyond the end of the run at the values found, which is continued straight "
        .. "there. Hint: drive it farther, or leave them out"):format(set.what, counted(outside, "point"))
    end
    if coarse > 0 then
      texts[#texts + 1] = ("%s: between the steps of the run %s bends by more than the data scatter, at %s. Hint: more "
        .. "steps"):format(set.what, set.y, counted(coarse, "point"))
    end
  end
  return texts
end

--- Sentences on error bars that are not known.
local function about_bars(search)
  if not search.errors then return {} end
  if not search.bars then
    return { "the run with error bars fails: intervals do not contain the error of the solution" }
  end
  return lists.map(search.bars.unknown, function(set)
    return ("%s: error bars of %s are unknown in some steps, where intervals do not contain the error of the solution. "
      .. "Hint: model:run{ errors = true } tells why"):format(set.what, set.y)
  end)
end

--- By which part the residuals at a move of one variable differ from their linear change; nil if the run fails, with
--- "interrupted" if Ctrl-C has ended it.
local function differs(search, point, j, move)
  local z = lists.merged(point.z)
  z[j] = z[j] + move
  local run, why = trial.run(search, parameters.values(search.free, search.fixed, z))
  if not run then return nil, why end
  local row, linear, error = 0, 0, 0
  for k, set in ipairs(search.sets) do
    local values = data.values(set, { run = run, start = point.found.start }, set.at)
    for i, value in ipairs(values) do
      row = row + 1
      local promised = point.columns[j][row] * move
      local change = (value - point.predictions[k].values[i]) / search.weights[row]
      linear, error = linear + promised ^ 2, error + (change - promised) ^ 2
    end
  end
  return math.sqrt(error / linear)
end

--- Runs at the ends of intervals: whether the linear model holds there.
local function about_ends(search, point, found)
  local bent, failing = {}, {}
  for j, one in ipairs(search.free) do
    local half = found.half[one.name]
    if half then
      for _, sign in ipairs { -1, 1 } do
        local move = math.max(one.low, math.min(one.high, point.z[j] + sign * half)) - point.z[j]
        local error, why = 0, nil
        if move ~= 0 then error, why = differs(search, point, j, move) end
        if why then return { "Ctrl-C has ended the check of the intervals" } end
        if not error then failing[#failing + 1] = one.name
        elseif error > curved then bent[#bent + 1] = one.name end
      end
    end
  end
  local texts = {}
  if #bent > 0 then
    texts[1] = ("runs at the ends of the intervals of %s are off the linear change by more than a fourth: take these "
      .. "intervals as estimates"):format(quoted(lists.unique(bent)))
  end
  if #failing > 0 then
    texts[#texts + 1] = ("runs at the ends of the intervals of %s fail"):format(quoted(lists.unique(failing)))
  end
  return texts
end

-- ── Result ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local function make(search, point, reason, tries, found)
  local warnings = lists.joined({ ends.text(search, reason, tries) }, about_parameters(found),
    about_data(search, point, found), about_bars(search),
    search.check and reason ~= "interrupted" and about_ends(search, point, found) or {}, point.found.warnings,
    point.found.run.warnings)
  return setmetatable({
    at = point.values, intervals = found.intervals, correlation = found.correlation, of_solution = found.of_solution,
    undetermined = found.undetermined, scatter = found.scatter, points = #point.residuals, run = point.found.run,
    gradients = point.found, tries = tries, reason = reason, warnings = warnings,
    search = { free = search.free, sets = search.sets, weights = search.weights, bars = search.bars, point = point },
  }, Fit)
end

--- Values and intervals as a table.
local function content_of(self)
  local columns = { "parameter", "value", "from", "to" }
  local with_bars = self.search.bars ~= nil
  if with_bars then columns[5] = "of the solution" end
  local rows = lists.map(self.search.free, function(one)
    local at = self.intervals[one.name] or {}
    local half = at[1] and (at[2] - at[1]) / 2
    local share = with_bars and half and self.of_solution[one.name] * parameters.rate(one, self.at) or nil
    return { one.name, self.at[one.name], at[1], at[2], share }
  end)
  return { columns = columns, rows = rows, formats = { [5] = "%.2g" } }
end

local function summary(self)
  return ("95 %% intervals from %s; scatter %.4g%s; %s"):format(counted(self.points, "point"), self.scatter,
    self.search.sets[1].has_sigma and " standard deviations" or "", counted(#self.tries, "run"))
end

function Fit:__tostring() return shown.text(content_of(self), summary(self), self.warnings) end

local function set_of(self, what, k)
  if not self.search.sets[k] then
    core.fail(("%s: there is no set %d; the fit has %s of data"):format(what, k, counted(#self.search.sets, "set")))
  end
  return self.search.sets[k]
end

--- The columns of a set: x, data, fit, sigma.
function Fit:data(k)
  local set = set_of(self, "fit:data", k)
  return { columns = { set.x, set.y, "fit", "sigma" }, rows = lists.map(set.at, function(at, i)
    return { at, set.values[i], self.search.point.predictions[k].values[i], set.sigma[i] }
  end) }
end

--- The line of the run through a set: lists x and y.
local function line_of(self, k)
  local set = self.search.sets[k]
  local first, last = table.unpack(lists.ranges(lists.map(set.at, function(at) return { at } end))[1])
  local at = {}
  for i = 0, chart_points do at[i + 1] = first + (last - first) * i / chart_points end
  return at, data.values(set, self.gradients, at)
end

function Fit:chart(options)
  local k = options.set
  local set = set_of(self, "fit:chart", k)
  local x, y = line_of(self, k)
  local chart = lists.merged({ xlabel = set.x, ylabel = set.y, title = ("Fit of %s"):format(set.y) }, options, {
    { x = x, y = y, label = "run", markers = false },
    { x = set.at, y = set.values, label = "data", line = false, markers = true } })
  chart.set = nil
  return on_behalf_of("fit:chart", "sg.chart", core.sg.chart, chart)
end

--- The page of the run, which begins with the table of the fit and its charts.
function Fit:report(options)
  local charts = lists.map(self.search.sets, function(_, k) return self:chart { set = k } end)
  options = lists.merged(options, { title = options.title or "Fit",
                                    charts = lists.joined(charts, options.charts or {}) })
  shown.report("fit:report", self.run, options, "Parameters", content_of(self), summary(self), self.warnings)
end

require("signorini.call.methods").guard("fit", "data chart report")

return make
