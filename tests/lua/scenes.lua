-- Scenes in few words: bodies with the values that most tests have, and models that call faces by their names.

local sg = require "signorini"
local lists = require "signorini.call.lists"

local scenes = {}

--- A body as sg.body makes it, by default of order "N2", two elements a direction, neo-Hookean with E = 1 and nu = 0.3.
--- Its shape is `size` ({1, 1} by default) from `corner` on, or `patch`; its material `material`, or E and nu.
function scenes.body(o)
  local size = o.size or { 1, 1 }
  local patch, space = o.patch, #size == 3
  if not patch then
    patch = space and sg.shapes.block{ size = size, corner = o.corner }
      or sg.shapes.rectangle{ width = size[1], height = size[2], corner = o.corner }
  end
  local given = lists.merged(o, { patch = patch, order = o.order or "N2",
    elements = o.elements or (space and { 2, 2, 2 } or { 2, 2 }),
    material = o.material or sg.neo_hookean{ E = o.E or 1, nu = o.nu or 0.3 } })
  given.size, given.corner, given.E, given.nu = nil, nil, nil, nil
  return sg.body(given)
end

--- A plane that faces up or down, at a height.
function scenes.floor(y) return sg.rigid.plane{ point = { 0, y or 0 }, normal = { 0, 1 } } end
function scenes.ceiling(y) return sg.rigid.plane{ point = { 0, y or 0 }, normal = { 0, -1 } } end

--- What a word names: a face or corner of the only body ("south", "1.south-west") or of one of several
--- ("lower.north"), or a body. Lists of words give lists of these; anything else is returned as it is.
local function named(bodies, word)
  if type(word) == "table" and not getmetatable(word) then
    return lists.map(word, function(one) return named(bodies, one) end)
  end
  if type(word) ~= "string" or bodies[word] then return bodies[word] or word end
  local name, face = word:match "^([^.]+)%.(.+)$"
  local body = bodies[name]
  if not body then body, face = bodies[next(bodies)], word end
  return body[word:find "-" and "corner" or "face"](body, face)
end

--- A model as sg.model makes it. Bodies may be tables of scenes.body; `on`, `slave` and `master` may be words.
function scenes.model(o)
  local given = lists.merged(o, { bodies = {} })
  for name, body in pairs(o.bodies) do
    given.bodies[name] = type(body) == "table" and not getmetatable(body) and scenes.body(body) or body
  end
  for _, kind in ipairs { "supports", "loads", "contacts", "ties" } do
    if o[kind] then
      given[kind] = {}
      for name, entry in pairs(o[kind]) do
        given[kind][name] = lists.merged(entry, { on = named(given.bodies, entry.on),
          slave = named(given.bodies, entry.slave), master = named(given.bodies, entry.master) })
      end
    end
  end
  return sg.model(given)
end

return scenes
