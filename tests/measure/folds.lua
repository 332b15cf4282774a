-- Shapes that are folded from the start: where a set of faces finds contact, and whether overlaps are reported.
--
-- Problem: random strips, 1 long and t = 0.04 thick, whose center line turns by a random function of its length, so
--          that many roll up, and some through themselves; all faces may touch each other (among = "all").
-- Source: none; whether a shape overlaps is decided by winding numbers of its outline, a polygon, about points next to
--         it: 2 and more are in two layers.
-- Units: none.
-- Expected: no contact at the first state, whatever the shape; a warning for each strip whose layers overlap by t/20 or
--           more, and for none whose layers are t/50 apart or farther. Those between are not counted.
-- Run: signorini tests/measure/folds.lua [count=10000] [seed=1] 2>/dev/null, without the warnings themselves

local sg = require "signorini"
local lists = require "signorini.call.lists"

local options = sg.arguments{ count = 10000, seed = 1 }
local length, t, spans, degree = 1, 0.04, 48, 2
local sharpest = 1.4 / t -- of the center line; from 2/t on the strip folds over on its inside

--- A random function for the angle of a center line, up to some turns.
local function any_angle()
  local bend, waves = 14 * math.random(), {}
  for k = 1, 3 do waves[k] = { 3 * (math.random() - 0.5), 2 * math.pi * math.random() } end
  return function(s)
    local angle = bend * (s - 0.5)
    for k, wave in ipairs(waves) do angle = angle + wave[1] * math.sin(2 * math.pi * k * s / length + wave[2]) end
    return angle
  end
end

--- One that no strip is too thick for.
local function random_angle()
  local angle, sharp, step
  repeat
    angle, sharp, step = any_angle(), 0, length / (4 * spans)
    for s = 0, length - step, step do sharp = math.max(sharp, math.abs(angle(s + step) - angle(s)) / step) end
  until sharp < sharpest
  return angle
end

--- The control points of a strip: those of its lower and upper face.
local function strip_points(angle)
  local knots, greville = { 0, 0, 0 }, {}
  for i = 1, spans - 1 do knots[#knots + 1] = i / spans end
  for _ = 0, degree do knots[#knots + 1] = 1 end
  for i = 1, #knots - degree - 1 do greville[i] = (knots[i + 1] + knots[i + 2]) / 2 end
  local x, y, s, below, above, pieces = 0, 0, 0, {}, {}, 8
  for i, to in ipairs(greville) do
    local step = (to - s) / pieces
    for piece = 1, pieces do
      local along = angle(s + (piece - 0.5) * step)
      x, y = x + step * math.cos(along), y + step * math.sin(along)
    end
    s = to
    local normal = { -math.sin(angle(s)), math.cos(angle(s)) }
    below[i] = { x - t / 2 * normal[1], y - t / 2 * normal[2] }
    above[i] = { x + t / 2 * normal[1], y + t / 2 * normal[2] }
  end
  return lists.joined(below, above), knots
end

--- The outline of a strip as a closed polygon, counter-clockwise.
local function outline(patch)
  local polygon, count, across = {}, 6 * spans, 12
  local function add(...) polygon[#polygon + 1] = patch{ ... } end
  for i = 0, count - 1 do add(i / count, 0) end
  for i = 0, across - 1 do add(1, i / across) end
  for i = count, 1, -1 do add(i / count, 1) end
  for i = across, 1, -1 do add(0, i / across) end
  return polygon
end

--- How often a polygon winds around a point.
local function winding(polygon, x, y)
  local number, a = 0, polygon[#polygon]
  for _, b in ipairs(polygon) do
    local side = (b[1] - a[1]) * (y - a[2]) - (b[2] - a[2]) * (x - a[1])
    if a[2] <= y and b[2] > y and side > 0 then number = number + 1 end
    if a[2] > y and b[2] <= y and side < 0 then number = number - 1 end
    a = b
  end
  return number
end

--- The largest winding number about points at a depth below the outline, negative above it.
local function layers(polygon, depth)
  local most = 0
  for i = 2, #polygon - 1 do
    local a, b = polygon[i - 1], polygon[i + 1]
    local dx, dy = b[1] - a[1], b[2] - a[2]
    local scale = depth / math.sqrt(dx * dx + dy * dy)
    most = math.max(most, winding(polygon, polygon[i][1] - scale * dy, polygon[i][2] + scale * dx))
  end
  return most
end

--- "apart", "overlapping", or between them.
local function kind_of(polygon)
  if layers(polygon, t / 20) > 1 then return "overlapping" end
  return layers(polygon, -t / 50) == 0 and "apart" or "between"
end

math.randomseed(options.seed)
local wrong, found = 0, { apart = { 0, 0, 0 }, overlapping = { 0, 0, 0 }, between = { 0, 0, 0 } }
for shape = 1, options.count do
  local points, knots = strip_points(random_angle())
  local patch = sg.nurbs.surface{ degrees = { degree, 1 }, knots = { knots, { 0, 0, 1, 1 } }, points = points }
  local strip = sg.body{ patch = patch, elements = { spans, 1 }, order = "N2",
                         material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  local model = sg.model{ bodies = { strip = strip }, supports = { clamp = { on = strip:face "west", fix = "xy" } },
                          contacts = { all = { among = "all" } } }
  local kind = kind_of(outline(patch))
  local warned, closed = #model:warnings() > 0, model:contact_resultant "all".active > 0
  local counts = found[kind]
  counts[1], counts[2], counts[3] = counts[1] + 1, counts[2] + (warned and 1 or 0), counts[3] + (closed and 1 or 0)
  local right = kind == "between" or warned == (kind == "overlapping")
  if closed or not right then
    wrong = wrong + 1
    print(("shape %d: %s, %s"):format(shape, kind, model:warnings()[1] or "no warning"))
  end
end
local rows = {}
for _, kind in ipairs{ "apart", "between", "overlapping" } do rows[#rows + 1] = { kind, table.unpack(found[kind]) } end
print(sg.table{ columns = { "layers", "shapes", "warned of", "in contact" }, rows = rows })
if wrong > 0 then error(("%d shapes are judged wrongly"):format(wrong), 0) end
