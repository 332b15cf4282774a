-- Comparison of contact profiles: the L₂ error of one against another or against a function, and the edges of contact.
--
-- A profile is what model:profile returns: equally long lists x, y, pressure, traction, gap, … along the slave face.
-- Profiles of different meshes have different points; between its points a profile is piecewise linear.

local core = require "signorini.core"
local check = require "signorini.call.check"
local lists = require "signorini.call.lists"
local t = require "signorini.call.types"

local profile = {}

-- ── A profile as a function of the coordinate ────────────────────────────────────────────────────────────────────────

--- A column of a profile, checked; `argument` is the argument that needs it.
local function column(where, name, data, key, argument)
  local values = rawget(data, key)
  if type(values) == "table" and #values == #data.x then
    return check.value(t.numbers(), values, where, ("%s.%s"):format(name, key))
  end
  local known = lists.filter(lists.sorted_names(data), function(other)
    return type(data[other]) == "table" and type(data[other][1]) == "number"
  end)
  core.fail(("%s: %s has no list '%s' as long as %s.x, which %s needs; known: %s"):format(where, name, tostring(key),
    name, argument, table.concat(known, ", ")))
end

--- The coordinate of every point. A function receives one point at a time, as a table of its values by name.
local function coordinates(where, name, data, coordinate)
  if type(coordinate) == "string" then return column(where, name, data, coordinate, "coordinate") end
  return lists.map(data.x, function(_, i)
    local point = {}
    for key, values in pairs(data) do point[key] = type(values) == "table" and values[i] or nil end
    return check.value(t.number, coordinate(point), where, ("coordinate(%s.x[%d], …)"):format(name, i))
  end)
end

--- Adds the points of zero gap, by linear interpolation, between a point with a value and one without: the chord
--- between the two would end at the one without.
local function add_edges(part, g)
  local s, v = part.s, part.v
  for i = #s, 2, -1 do
    if (v[i - 1] == 0) ~= (v[i] == 0) and g[i - 1] * g[i] < 0 then
      local zero = s[i - 1] + (s[i] - s[i - 1]) * g[i - 1] / (g[i - 1] - g[i])
      table.insert(s, i, zero)
      table.insert(v, i, 0)
      part.from, part.to = math.min(part.from, zero), math.max(part.to, zero)
    end
  end
end

--- The part of a profile on which its coordinate increases (the lists are reversed where it decreases): all points with
--- a nonzero value and, to both sides, as far as it continues. Outside, the value is zero. Returns { s = {…}, v = {…},
--- from, to }; from … to is the zone of nonzero values. `edge`: see the help page.
local function stretch(where, name, data, coordinate, value, edge)
  check.value(t.list(t.number, nil, 2), rawget(data, "x"), where, name .. ".x")
  local s, v = coordinates(where, name, data, coordinate), column(where, name, data, value, "value")
  local first, last
  for i = 1, #v do
    if v[i] ~= 0 then first, last = first or i, i end
  end
  if not first then core.fail(("%s: %s has no %s: no point is in contact"):format(where, name, value)) end
  local sign = s[math.min(last + 1, #s)] > s[math.max(first - 1, 1)] and 1 or -1
  for i = first + 1, last do
    if sign * (s[i] - s[i - 1]) <= 0 then
      core.fail(("%s: the coordinate of %s is not monotonic in the contact zone, from %g to %g. "
        .. "Hint: choose one that increases there"):format(where, name, s[i - 1], s[i]))
    end
  end
  local low, high = first, last
  while low > 1 and sign * (s[low] - s[low - 1]) > 0 do low = low - 1 end
  while high < #s and sign * (s[high + 1] - s[high]) > 0 do high = high + 1 end
  local part = { s = {}, v = {}, from = math.min(s[first], s[last]), to = math.max(s[first], s[last]) }
  local gap, gaps = edge == "gap" and column(where, name, data, "gap", "edge"), {}
  for i = sign > 0 and low or high, sign > 0 and high or low, sign do
    part.s[#part.s + 1], part.v[#part.v + 1], gaps[#gaps + 1] = s[i], v[i], gap and gap[i]
  end
  if gap then add_edges(part, gaps) end
  return part
end

--- The piecewise linear value of a stretch at a coordinate within it.
local function evaluate(part, at)
  local s, v = part.s, part.v
  local low, high = 1, #s
  while high - low > 1 do
    local middle = (low + high) // 2
    if s[middle] <= at then low = middle else high = middle end
  end
  return v[low] + (v[high] - v[low]) * (at - s[low]) / (s[high] - s[low])
end

-- ── The error ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A function as reference: it has no points and is known on the whole range of the profile.
local function known_everywhere(where, reference, mine)
  return {
    s = { mine.s[1], mine.s[#mine.s] }, from = mine.from, to = mine.to,
    value = function(at) return check.value(t.number, reference(at), where, ("reference(%g)"):format(at)) end,
  }
end

--- The range of integration: where both are known, or only where both are nonzero.
local function common_range(where, mine, theirs, zone)
  local function range(side)
    if zone == "both" then return side.from, side.to end
    return side.s[1], side.s[#side.s]
  end
  local a, b = range(mine)
  local c, d = range(theirs)
  local from, to = math.max(a, c), math.min(b, d)
  if to > from then return from, to end
  core.fail(("%s: the coordinates do not overlap: the profile %s from %g to %g, the reference from %g to %g")
    :format(where, zone == "both" and "touches" or "goes", a, b, c, d))
end

--- The points of the quadrature, in order: those of one or both sides within the range, and its ends.
local function nodes(sides, from, to)
  local own = lists.joined(sides[1].s, sides[2] and sides[2].s or {})
  local list = lists.joined({ from, to }, lists.filter(own, function(at) return at > from and at < to end))
  table.sort(list)
  return list
end

--- The fraction of the zone in which at least one side is nonzero that lies in the range.
local function share(mine, theirs, from, to)
  local low, high = math.min(mine.from, theirs.from), math.max(mine.to, theirs.to)
  return high > low and math.max(0, math.min(to, high) - math.max(from, low)) / (high - low) or 1
end

function profile.error(o)
  local where, quadrature, zone = "sg.profile_error", o.quadrature, o.zone
  local function side(name) return stretch(where, name, o[name], o.coordinate, o.value, o.edge) end
  local mine, is_function = side "profile", type(o.reference) == "function"
  local theirs = is_function and known_everywhere(where, o.reference, mine) or side "reference"

  local from, to = common_range(where, mine, theirs, zone)
  local sides = quadrature == "union" and { mine, theirs } or { quadrature == "profile" and mine or theirs }
  local at, largest, difference = nodes(sides, from, to), 0, {}
  for i, s in ipairs(at) do
    local wanted = is_function and theirs.value(s) or evaluate(theirs, s)
    difference[i], largest = evaluate(mine, s) - wanted, math.max(largest, math.abs(wanted))
  end
  for _, wanted in ipairs(theirs.v or {}) do largest = math.max(largest, math.abs(wanted)) end
  local scale = o.normalize == "max" and largest or o.normalize
  if scale == 0 then core.fail(where .. ": normalize must not be \"max\" where the reference is zero everywhere") end

  -- Trapezoids on the squares, or on the union of the points, where the difference is linear in between, exactly:
  -- ∫ d² = h (d₁² + d₁d₂ + d₂²)/3
  local sum = 0
  for i = 2, #at do
    local length, a, b = at[i] - at[i - 1], difference[i - 1], difference[i]
    sum = sum + length * (quadrature == "union" and (a * a + a * b + b * b) / 3 or (a * a + b * b) / 2)
  end
  return math.sqrt(sum) / scale,
    { from = from, to = to, points = #at, scale = scale, covered = share(mine, theirs, from, to) }
end

-- ── The edges ────────────────────────────────────────────────────────────────────────────────────────────────────────

function profile.edges(o)
  local value = rawget(o.profile, "inside") and "inside" or "pressure" -- profiles of other programs have no `inside`
  local part = stretch("sg.profile_edges", "profile", o.profile, o.coordinate, value, "gap")
  local edges, s = { from = part.from, to = part.to }, part.s
  for i = 2, #s - 1 do
    if s[i] == part.from and part.v[i] == 0 then edges.from_spacing = s[i + 1] - s[i - 1] end
    if s[i] == part.to and part.v[i] == 0 then edges.to_spacing = s[i + 1] - s[i - 1] end
  end
  return edges
end

return profile
