-- Bodies of several patches: single bodies, the parts, whose coincident faces sg.model joins.

local check = require "signorini.call.check"
local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local lists = require "signorini.call.lists"
local meant = require("signorini.call.text").meant
local patch_types = require "signorini.call.patch_types"
local t = require "signorini.call.types"

local compound = {}

local Compound = core.types.compound

--- The part and the face of a text such as "2.north"; nil for other texts.
local function split(text)
  local number, name = text:match "^(%d+)%.(.+)$"
  return math.tointeger(tonumber(number)), name
end

--- A face, edge or corner of a part by a text such as "2.north"; `kind`: the method of bodies that returns it.
local function place(parts, kind, text, where)
  local number, name = split(text)
  local part = parts[number]
  if not part then
    core.fail(("%s must be a %s of a part from 1 to %d, such as '1.%s', got '%s'"):format(where, kind, #parts,
      core.place_names(parts[1], kind == "face" and 1 or kind == "edge" and 2 or 0)[1] or "west", text))
  end
  return part[kind](part, name)
end

-- ── Making ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local contact_names = t.worded(t.one_or_more(t.text),
  "a face such as '1.north', the name of a boundary, or a list of these")

--- The faces that carry the layer, by part: { [2] = { "north" } }, from names of faces or of boundaries.
local function contact_faces(given, patches)
  local faces = {}
  local function add(text)
    local number, name = split(text)
    if not patches[number] then
      core.fail(("sg.body: contact must be a face such as '1.north' of the patches 1 to %d, or the name of a boundary, "
        .. "got '%s'%s"):format(#patches, text, meant(text, lists.sorted_names(patches.boundaries or {}))))
    end
    faces[number] = faces[number] or {}
    table.insert(faces[number], name)
  end
  for _, text in ipairs(given) do
    for _, one in ipairs(patches.boundaries and patches.boundaries[text] or { text }) do add(one) end
  end
  return faces
end

--- The label of bodies without the layer: "N2" of "N2-N4".
local function bulk(label) return label:match "^[^-]*" end

--- The arguments of sg.body for one part. Parts without a face in `contact` have the label's bulk.
local function part_values(values, patches, i, contact)
  local own = lists.merged(values, { patch = patches[i], contact = contact[i] })
  if type(values.elements) == "table" and type(values.elements[1]) == "table" then own.elements = values.elements[i] end
  if values.contact and not contact[i] then
    own.order = bulk(values.order)
    for _, key in ipairs { "thickness_degree", "contact", "layer", "layer_knots" } do own[key] = nil end
  end
  return own
end

-- ── Connections ──────────────────────────────────────────────────────────────────────────────────────────────────────

--- Two lists of parts, those that are connected with the first one and the others, with their numbers; nil if there are
--- no others. links: pairs { i, j } of connected parts.
local function separated(parts, links)
  local group = {}
  for i = 1, #parts do group[i] = i end
  local function root(i) return group[i] == i and i or root(group[i]) end
  for _, link in ipairs(links) do
    local i, j = root(link[1]), root(link[2])
    group[math.max(i, j)] = math.min(i, j)
  end
  local first, others = { bodies = {}, numbers = {} }, { bodies = {}, numbers = {} }
  for i, part in ipairs(parts) do
    local list = root(i) == 1 and first or others
    table.insert(list.bodies, part)
    table.insert(list.numbers, i)
  end
  if #others.bodies > 0 then return first, others end
end

--- Rejects parts that are not connected: each of them would move by itself.
local function check_connected(parts, links, place, hint)
  local first, others = separated(parts, links)
  if not first then return end
  local faces, gap = core.smallest_gap(first.bodies, others.bodies)
  core.fail(("%s must be one body, but the patches %s and %s are not connected; the smallest gap is %.6g, between the "
    .. "faces '%d.%s' and '%d.%s'. Hint: %s"):format(place, table.concat(first.numbers, ", "),
    table.concat(others.numbers, ", "), gap, first.numbers[faces[1]], faces[2], others.numbers[faces[3]], faces[4],
    hint))
end

--- The links by pairs of faces { 1, "east", 2, "west" }.
local function links_of(pairs_of_faces)
  return lists.map(pairs_of_faces, function(pair) return { pair[1], pair[3] } end)
end

--- The links by the values of an argument of sg.model: joins, ties or contacts, each with faces on two sides.
local function add_links(links, parts, values, first, second)
  local function owners(side, into)
    if side == nil or side == "all" then return into end
    local number = core.owner(side, parts)
    if number then into[#into + 1] = number end
    if lists.length(side) then for _, one in ipairs(side) do owners(one, into) end end
    return into
  end
  for _, value in pairs(type(values) == "table" and values or {}) do
    if type(value) == "table" and not getmetatable(value) then
      for _, i in ipairs(owners(value[first], {})) do
        for _, j in ipairs(owners(value[second], {})) do links[#links + 1] = { i, j } end
      end
    end
  end
end

--- Rejects a body whose listed interfaces, and the joins, ties and contacts of the model, leave a part unconnected.
local function check_listed(name, body, values)
  local links = links_of(body.pairs)
  add_links(links, body.parts, values.joins, 1, 2)
  add_links(links, body.parts, values.ties, "slave", "master")
  add_links(links, body.parts, values.contacts, "slave", "master")
  add_links(links, body.parts, values.contacts, "among", "among")
  check_connected(body.parts, links, ("sg.model: bodies.%s"):format(name),
    "add the missing pair of faces to patch.interfaces of sg.body, or make two bodies of them")
end

--- The pairs of faces of parts on each other, { { 1, "east", 2, "west" }, … }: those listed, or all that coincide.
local function pairs_of(patches, parts)
  if not patches.interfaces then
    local found = core.coincident_faces(parts)
    check_connected(parts, links_of(found), "sg.body: patch",
      "faces are joined up to 10 % of an element's length; move the patches together, or make two bodies of them")
    return found
  end
  local found = {}
  for i, faces in ipairs(patches.interfaces) do
    local pair = {}
    for k, text in ipairs(faces) do
      place(parts, "face", text, ("sg.body: patch.interfaces[%d][%d]"):format(i, k))
      pair[2 * k - 1], pair[2 * k] = split(text)
    end
    found[i] = pair
  end
  return found
end

local function boundaries_of(patches, parts)
  local result = {}
  for name, texts in pairs(patches.boundaries or {}) do
    result[name] = {}
    for i, text in ipairs(texts) do
      result[name][i] = place(parts, "face", text, ("sg.body: patch.boundaries.%s[%d]"):format(name, i))
    end
    setmetatable(result[name], { __tostring = function()
      return ("boundary '%s' of a body of %d patches: %s %s"):format(name, #parts, #texts == 1 and "face" or "faces",
        table.concat(texts, ", "))
    end })
  end
  return result
end

--- The body of several patches; make(values): sg.body for one patch.
function compound.new(make, values)
  local patches = check.value(patch_types.several, values.patch, "sg.body", "patch")
  if type(values.order) ~= "string" then
    check.reject("sg.body", "order", "one label for all directions, as patch is a list", values.order)
  end
  if type(values.elements) == "table" and type(values.elements[1]) == "table" and #values.elements ~= #patches then
    check.reject("sg.body", "elements", ("a list of %d lists, one per patch"):format(#patches), values.elements)
  end
  local named = values.contact and check.value(contact_names, values.contact, "sg.body", "contact")
  local contact = named and contact_faces(named, patches) or {}
  local first = next(contact)
  if type(values.layer) == "table" and first and next(contact, first) then
    check.reject("sg.body", "layer", "a function of the undeformed position X, as several parts have contact faces",
      values.layer)
  end
  local parts = {}
  for i = 1, #patches do parts[i] = make(part_values(values, patches, i, contact)) end
  return setmetatable({ parts = parts, pairs = pairs_of(patches, parts), boundaries = boundaries_of(patches, parts) },
    Compound)
end

-- ── Places ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The names of faces (count = 1), edges (2) and corners (0): "1.west", …; faces also by boundary.
function compound.place_names(self, count)
  local names = count == 1 and lists.sorted_names(self.boundaries) or {}
  for i, part in ipairs(self.parts) do
    for _, name in ipairs(core.place_names(part, count)) do names[#names + 1] = ("%d.%s"):format(i, name) end
  end
  return names
end

function compound.face(self, name)
  local named = self.boundaries[name]
  if named then return setmetatable(table.move(named, 1, #named, 1, {}), getmetatable(named)) end
  if not split(name) then
    local known = lists.sorted_names(self.boundaries)
    core.fail(("compound:face: name must be a boundary (%s) or a face of a part such as '1.west', got '%s'%s")
      :format(#known > 0 and table.concat(known, ", ") or "this body has none", name, meant(name, known)))
  end
  return place(self.parts, "face", name, "compound:face: name")
end

function compound.edge(self, name) return place(self.parts, "edge", name, "compound:edge: name") end
function compound.corner(self, name) return place(self.parts, "corner", name, "compound:corner: name") end

function compound.part(self, number)
  return self.parts[number] or
    check.reject("compound:part", "number", ("a whole number from 1 to %d"):format(#self.parts), number)
end

function compound.text(self)
  local dofs = 0
  for _, part in ipairs(self.parts) do dofs = dofs + part:dofs().total end
  return ("body of %d patches with %d degrees of freedom, %s of faces on each other%s"):format(#self.parts, dofs,
    counted(#self.pairs, "pair"), next(self.boundaries) and
      "; boundaries: " .. table.concat(lists.sorted_names(self.boundaries), ", ") or "")
end

-- ── Models ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A value with the parts of bodies in place of these.
local function in_parts(value)
  if compound.is(value) then return value.parts end
  return lists.length(value) and lists.map(value, in_parts) or value
end

--- A table of tables with values of these keys in parts. Other values are left to the check of sg.model.
local function expand(tables, ...)
  if type(tables) ~= "table" then return tables end
  local expanded = {}
  for name, entry in pairs(tables) do
    local plain, own = type(entry) == "table" and not getmetatable(entry), {}
    for _, key in ipairs { ... } do own[key] = plain and in_parts(entry[key]) or nil end
    expanded[name] = plain and lists.merged(entry, own) or entry
  end
  return expanded
end

--- Contacts with the pairs of sets in parts.
local function expanded_contacts(contacts)
  local expanded = expand(contacts, "except")
  for name, contact in pairs(type(expanded) == "table" and expanded or {}) do
    if type(contact) == "table" and not getmetatable(contact) and contact.pairs then
      expanded[name] = lists.merged(contact, { pairs = expand(contact.pairs, "between") })
    end
  end
  return expanded
end

--- The arguments of sg.model with parts in place of bodies of several patches, and joins of their faces.
function compound.expanded(values)
  if type(values.joins or {}) ~= "table" then return values end -- which sg.model rejects
  local bodies = {}
  local joins = lists.merged(values.joins or {})
  local function add(into, name, value, kind)
    if into[name] ~= nil then
      core.fail(("sg.model: %s.%s has the name of a part of a body of several patches: choose another name")
        :format(kind, name))
    end
    into[name] = value
  end
  for name, body in pairs(values.bodies) do
    if not compound.is(body) then add(bodies, name, body, "bodies") end
  end
  for name, body in pairs(values.bodies) do
    if compound.is(body) then check_listed(name, body, values) end
    for i, part in ipairs(compound.is(body) and body.parts or {}) do
      add(bodies, ("%s.%d"):format(name, i), part, "bodies")
    end
    for _, pair in ipairs(compound.is(body) and body.pairs or {}) do
      local i, face, j, other = table.unpack(pair)
      add(joins, ("%s.%d.%s-%d.%s"):format(name, i, face, j, other),
        { body.parts[i]:face(face), body.parts[j]:face(other) }, "joins")
    end
  end
  return lists.merged(values, { bodies = bodies, joins = joins, loads = expand(values.loads, "on"),
                                supports = expand(values.supports, "on"),
                                contacts = expanded_contacts(values.contacts) })
end

function compound.is(value) return getmetatable(value) == Compound end

return compound
